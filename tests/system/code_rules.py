"""What architecture.sh checks of the text of functions:  python3 code_rules.py TOP

    a function has at most 75 lines between its braces
    a choice is compared as a value: no text is compared with a literal but in the files of `TEXTS`
"""
import pathlib
import re
import sys

MOST_LINES = 75

# Where texts are compared with literals, and why.
TEXTS = {
    "source/core/text_lists.cc": "reads lists",
    "source/io/parameter_scan.cc": "reads parameter files",
    "source/io/parameter_tree.cc": "reads deal.II's patterns",
    "source/io/typed_numbers.cc": "reads entries that are numbers or 'table'",
    "source/material/metal_parameters.cc": "reads entries that are numbers or 'table'",
    "source/material/used_values.cc": "reads entries that are numbers or 'table'",
    "source/material/table_entry.h": "reads entries that are numbers or 'table'",
    "source/structure/histories/axes.cc": "reads entries that are numbers or names",
    "source/structure/histories/gauge_table.cc": "reads entries that are numbers or names",
    "source/report/comparison/run_reuse.cc": "reads a folder's mark",
    "source/report/study/study_table.cc": "reads a table's state",
    "source/report/target_error/asked_quantity.cc": "units",
    "source/core/numerical_failure.cc": "units",
    "source/report/text.cc": "units",
    "source/report/study/study_figures.cc": "units",
    "source/report/closing.cc": "units",
    "source/report/comparison/comparison_print.cc": "units",
    "source/mesh/mesh_file.cc": "endings of files",
    "source/mesh/files/abaqus/file.cc": "keywords of files",
    "source/mesh/files/ucd.cc": "keywords of files",
    "source/mesh/files/abaqus/keywords.cc": "keywords of files",
    "source/mesh/files/abaqus/parts.cc": "keywords of files",
    "source/mesh/files/ls_dyna/cards.cc": "keywords of files",
    "source/mesh/files/ls_dyna/elements.cc": "keywords of files",
    "source/mesh/files/ls_dyna/file.cc": "keywords of files",
    "source/mesh/files/ls_dyna/groups.cc": "keywords of files",
    "source/mesh/files/ls_dyna/parts.cc": "keywords of files",
    "source/mesh/files/ls_dyna/sets.cc": "keywords of files",
    "source/mesh/files/gmsh/gmsh.cc": "keywords of files",
    "source/mesh/files/vtk/attributes.cc": "keywords of files",
    "source/mesh/files/vtk/vtk.cc": "keywords of files",
}

# Comments, raw strings, literals; directives with their continuations.
TOKENS = re.compile(
    r"//[^\n]*|/\*.*?\*/|R\"(?P<mark>[^(\s]*)\(.*?\)(?P=mark)\"|\"(?:[^\"\\\n]|\\.)*\"|(?<![0-9A-Za-z_])'(?:[^'\\\n]|\\.)+'", re.S)
DIRECTIVE = re.compile(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", re.M)
SCOPE = re.compile(r"(?:inline\s+)?(?:namespace|class|struct|union|enum|extern)\b")


def blank(match):
    """As many lines of nothing; literals stay to be seen as such."""
    return ('""' if match.group()[0] in "\"R" else "") + "\n" * match.group().count("\n")


def without_template_head(head):
    """A declaration without `template <...>`, which may name classes, and without labels of access."""
    head = re.sub(r"\b(?:public|private|protected)\s*:", "", head).strip()
    while head.startswith("template"):
        depth = 0
        for place, letter in enumerate(head):
            depth += (letter == "<") - (letter == ">")
            if letter == ">" and depth == 0:
                break
        head = head[place + 1:].strip()
    return head


def function_lengths(text):
    """(line of the opening brace, lines between the braces) of every function outside another."""
    code = DIRECTIVE.sub(blank, TOKENS.sub(blank, text))
    scopes, head, line = [], "", 1  # of each open brace: the line if it opens a function's body, else 0
    for letter in code:
        line += letter == "\n"
        if letter == "{":
            is_inside = any(scopes)
            scopes.append(0 if is_inside or SCOPE.match(without_template_head(head)) else line)
            head = ""
        elif letter == "}":
            begin = scopes.pop()
            if begin:
                yield begin, max(0, line - begin - 1)
            head = ""
        elif letter == ";":
            head = ""
        else:
            head += letter
    assert not scopes, "braces do not close"


def compared_texts(text):
    """Lines that compare with a literal."""
    code = TOKENS.sub(blank, text)
    for number, line in enumerate(code.split("\n"), 1):
        if re.search(r'[!=]=\s*""|""\s*[!=]=', line):
            yield number


def main():
    top, complaints, used = pathlib.Path(sys.argv[1]), [], set()
    for path in sorted(p for room in ("source", "include") for p in (top / room).rglob("*") if p.suffix in (".h", ".cc")):
        name, text = str(path.relative_to(top)), path.read_text()
        for line, length in function_lengths(text):
            if length > MOST_LINES:
                complaints.append(f"{name}:{line}: a function of {length} lines; at most {MOST_LINES}")
        for line in compared_texts(text):
            used.add(name)
            if name not in TEXTS:
                complaints.append(f"{name}:{line}: compares a text with a literal; make the choice an enumeration")
    complaints += [f"{name}: compares no text; take it off the list of code_rules.py" for name in TEXTS if name not in used]
    print("\n".join(complaints), end="\n" if complaints else "")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
