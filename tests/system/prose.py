"""Documents for users are in plain English, and their links lead somewhere: prose.py SOURCE_FOLDER

Of README.md, prm/README.md and prm/manual: at most 18 words a sentence on the mean of each file and at most 40 in any sentence, no word
of WORDS, at most 150 lines of README.md and 300 of a chapter, no link to a file or heading that is not there,
no name of a file of this project that is not there. source/how-to-add.md may name no others either.
"""
import glob
import os
import re
import sys

MOST_ON_THE_MEAN, MOST_IN_ONE = 18, 40
WORDS = {  # not the field's: what to write instead
    r"\bforetell": "predict", r"\bclimb": "refine", r"\bof which\b": "a sentence of its own", r"\bway on\b": "checkpoint",
    r"\brims?\b": "free edge", r"\bridges?\b": "feature edge", r"\bgoes on\b": "continues"}


def prose(text):
    """Without code, tables, headings and markup; a list item or paragraph a piece."""
    text = re.sub(r"```.*?```|^    .*$", "\n\n", text, flags=re.S | re.M)
    lines = [("" if re.match(r"\s*(\||#)", line) else line) for line in text.splitlines()]
    text = re.sub(r"\n\s*([-*]|\d+\.) ", "\n\n", "\n" + "\n".join(lines))
    text = re.sub(r"`[^`]*`", "code", text)
    text = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", text)
    return [" ".join(piece.split()) for piece in re.split(r"\n\s*\n", text) if piece.strip()]


def sentences(text):
    for piece in prose(text):
        yield from (s for s in re.split(r"(?<=[.!?:])\s+(?=[A-Z0-9*(])", piece.replace("et al. ", "et al ")) if s.strip())


def anchors(text):
    for heading in re.findall(r"^#+ (.*)$", text, re.M):
        yield re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")


def broken_links(path, text):
    for target in re.findall(r"\]\(([^)\s]+)\)", re.sub(r"```.*?```|`[^`]*`", "", text, flags=re.S)):
        if re.match(r"https?:", target):
            continue
        name, _, heading = target.partition("#")
        file = os.path.normpath(os.path.join(os.path.dirname(path), name)) if name else path
        if not os.path.exists(file):
            yield f"{path}: the link {target} leads to no file"
        elif heading and heading not in anchors(open(file, encoding="utf-8").read()):
            yield f"{path}: the link {target} leads to no heading"


def missing_files(path, text):
    for name in re.findall(r"`((?:source|include|tests|prm|meshes)/[\w./-]+)`", re.sub(r"```.*?```", "", text, flags=re.S)):
        if not os.path.exists(name):
            yield f"{path}: there is no {name}"


def faults(path, most_lines):
    text = open(path, encoding="utf-8").read()
    if text.count("\n") > most_lines:
        yield f"{path}: {text.count(chr(10))} lines, at most {most_lines}"
    lengths = [(len(s.split()), s) for s in sentences(text)]
    mean = sum(n for n, _ in lengths) / max(1, len(lengths))
    if mean > MOST_ON_THE_MEAN:
        yield f"{path}: {mean:.1f} words a sentence, at most {MOST_ON_THE_MEAN} on the mean"
    yield from (f"{path}: a sentence of {n} words: {s}" for n, s in lengths if n > MOST_IN_ONE)
    for word, instead in WORDS.items():
        yield from (f"{path}: '{found}': write '{instead}'" for found in re.findall(word, "\n".join(prose(text)), re.I))


def main(top):
    os.chdir(top)
    documents = [("README.md", 150), ("prm/README.md", 300)] + [(f, 300) for f in sorted(glob.glob("prm/manual/*.md"))]
    found = [fault for path, most in documents for fault in faults(path, most)]
    for path in [f for f, _ in documents] + ["source/how-to-add.md"] + glob.glob("*/README.md") + glob.glob("tests/*/*.md"):
        found += broken_links(path, open(path, encoding="utf-8").read())
    for path in [f for f, _ in documents] + ["source/how-to-add.md"]:
        found += missing_files(path, open(path, encoding="utf-8").read())
    print("\n".join(dict.fromkeys(found)) or "plain")
    return bool(found)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
