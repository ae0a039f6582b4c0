"""Every entry that a message names exists:  python3 entries_in_messages.py PROGRAM TOP

Reads the string literals of source/ and include/, takes from them what looks like the path of an entry
("Time/Step scale", "Blade/Material/Smallest step", "Material/Smallest step"), and looks each up in what
`PROGRAM parameters --json` lists. Where words go on after the entry's name, the longest entry that fits is taken.
"""
import json
import pathlib
import re
import subprocess
import sys

# Literals, comments and raw strings, in the order of the text, so that none is found inside another.
TOKENS = re.compile(r'//[^\n]*|R"\((?:.|\n)*?\)"|"(?:[^"\\\n]|\\.)*"|\'(?:[^\'\\]|\\.)\'')
PATHS = re.compile(r"\b[A-Z][A-Za-z]+(?: [a-z-]+)*(?:/[A-Z][A-Za-z0-9-]*(?: (?:[a-z0-9-]+|[A-Z][0-9]*\b))*)+")


def entries_of(tree, path=()):
    """All paths of entries and of sections in the tree of parameters."""
    found = set()
    for name, node in tree.items():
        if not isinstance(node, dict):
            continue
        here = path + (name,)
        found.add("/".join(here))
        if "value" not in node:
            found |= entries_of(node, here)
    return found


def texts_of(source):
    """The texts that the compiler sees: neighbouring literals are one."""
    text, end = "", None
    for match in TOKENS.finditer(source):
        if match.group()[0] != '"':
            continue
        if end is not None and source[end:match.start()].strip():
            yield text
            text = ""
        text += match.group()[1:-1].replace("\\n", " ; ").replace('\\"', '"')
        end = match.end()
    yield text


def unknown_in(text, known):
    """What looks like a path of an entry, from the section or from one of its parts on, and is none."""
    tails = {"/".join(path.split("/")[k:]) for path in known for k in range(path.count("/") + 1)}
    heads = {tail.split("/")[0] for tail in tails if "/" in tail}
    for match in PATHS.finditer(text):
        words = match.group().split(" ")
        if words[0].split("/")[0] in heads or match.group().split("/")[0] in heads:
            if not any(" ".join(words[:n]) in tails for n in range(len(words), 0, -1)):
                yield match.group()


def main():
    program, top = sys.argv[1], pathlib.Path(sys.argv[2])
    listed = subprocess.run([program, "parameters", "--json"], check=True, capture_output=True, text=True).stdout
    known = entries_of(json.loads(listed))
    assert "Time/End time" in known and "Blade/Mesh/File" in known, "the tree of parameters is not read as expected"
    # the reader itself, so that this test can fail
    assert list(unknown_in("Reduce Time/Blade step scale and look.", known)) == ["Time/Blade step scale and look"]
    assert list(unknown_in("Set Time/Step scale and Time/Nothing; Mesh/Film is not there.", known)) == ["Time/Nothing", "Mesh/Film is not there"]
    assert not list(unknown_in("Set Time/Step scale, or Blade/Mesh/File to another one.", known))
    n_seen, bad = 0, []
    for folder in ("source", "include"):
        for file in sorted((top / folder).rglob("*")):
            if file.suffix in (".cc", ".h"):
                for text in texts_of(file.read_text()):
                    n_seen += len(PATHS.findall(text))
                    bad += [f"{file.relative_to(top)}: no entry is called '{path}'" for path in unknown_in(text, known)]
    print("\n".join(bad) or f"{n_seen} paths in messages, all of them known")
    assert n_seen > 50, "hardly any path was found"
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
