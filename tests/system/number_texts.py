"""No object of the libraries makes a text of a real number by std::to_string, whose six decimals say "0.000000" of 100 ns.

number_texts.py NM LIBRARY...   (a library that does not name an instance of it has none; of whole numbers it is another function)
"""
import subprocess
import sys

# What the C++ library calls for them: itself, or, where it is inlined, the function that prints by "%f".
NAMES = (*(f"std::__cxx11::to_string({real})" for real in ("float", "double", "long double")), "__gnu_cxx::__to_xstring")


def main():
    complaints = []
    for library in sys.argv[2:]:
        told = subprocess.run([sys.argv[1], "-A", "-C", library], stdout=subprocess.PIPE, text=True, check=True).stdout
        complaints += sorted({f"{line.split(':')[1]}: std::to_string of a real number; take number_text (core/text/number_text.h)"
                              for line in told.splitlines() if any(name in line for name in NAMES)})
    print("\n".join(complaints), end="\n" if complaints else "")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
