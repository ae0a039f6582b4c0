"""The manual's chapter of messages quotes what the program says:  faq.py TOP

Each heading of prm/manual/faq.md quotes a part of a message; "..." stands for what is filled in. All pieces must stand in this order,
and near to one another, in the string literals of one file of source/ or include/. So must each code of a warning that the chapter names.
"""
import pathlib
import re
import sys

from entries_in_messages import texts_of

NEAR = 600  # characters from one piece of a quote to the next


def literals(source):
    """What the file can say; the parts of a message that is put together follow one another."""
    return re.sub(r"\s+", " ", " ".join(texts_of(source)).replace(" ; ", " "))


def stands_in(quote, text):
    pieces = [re.escape(piece.strip()) for piece in quote.split("...")]
    return re.search(f".{{0,{NEAR}}}?".join(pieces), text) is not None


def main(top):
    sources = [path.read_text(encoding="utf-8") for folder in ("source", "include") for path in sorted((top / folder).rglob("*"))
               if path.suffix in (".cc", ".h")]
    said = [literals(source) for source in sources]
    chapter = (top / "prm/manual/faq.md").read_text(encoding="utf-8")
    quotes = re.findall(r"^### `(.*)`$", chapter, re.M)
    codes = sorted(set(re.findall(r"`([a-z]+/[a-z_]+)`", chapter)))
    # the reader itself, so that this test can fail
    assert stands_in("one ... three", literals('f("one " "two" + x + " three")')) and not stands_in("one ... four", "one two three")
    bad = [f"faq.md: no message says '{quote}'" for quote in quotes if not any(stands_in(quote, text) for text in said)]
    bad += [f"faq.md: no warning has the code '{code}'" for code in codes if not any(f'"{code}"' in source for source in sources)]
    bad += [f"faq.md: this heading quotes no message: {line}" for line in re.findall(r"^### [^`].*$", chapter, re.M)]
    print("\n".join(bad) or f"{len(quotes)} messages and {len(codes)} codes, all of them the program's")
    assert len(quotes) >= 25 and len(codes) >= 10, "the chapter is not read as expected"
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
