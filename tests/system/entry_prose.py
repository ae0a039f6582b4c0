"""The texts of entries are in plain English: entry_prose.py PROGRAM, or a file with what `PROGRAM parameters --json` prints

Of all entries: at most 18 words a sentence on the mean and at most 40 in any sentence, no word of WORDS and of prose.py, a capital letter
first and a full stop last. Values in quotes count as one word.
"""
import json
import re
import subprocess
import sys

from prose import MOST_IN_ONE, MOST_ON_THE_MEAN, WORDS as WORDS_OF_PROSE

WORDS = WORDS_OF_PROSE | {
    r"\btouch(?:es|ed|ing)?\b": "contact", r"\blook(?:s|ed|ing)?\b": "search, or point", r"\bsheets?\b": "shell branch",
    r"\bprices?\b": "cost", r"\bheld\b": "constrained", r"\bgiven\b": "set, or prescribed", r"\bforetold\b": "predict",
    r"\bgo on\b": "continue", r"\bbooked\b": "counted", r"\b(?:retired|gone|dropped|taken away)\b": "removed",
    r"\bwhat\b": "a noun"}


def entries(tree, path=""):
    for name, node in tree.items():
        if isinstance(node.get("text"), str):
            yield path + name, node["text"]
        else:
            yield from entries(node, path + name + "/")


def plain(text):
    return re.sub(r"(?<![\w])'[^']*'(?!\w)", "code", text).replace("e.g. ", "for example ")


def sentences(text):
    return [s for s in re.split(r"(?<=[.!?])\s+", plain(text)) if s.strip()]


def faults(found):
    lengths = []
    for name, text in found:
        lengths += [len(s.split()) for s in sentences(text)]
        yield from (f"{name}: a sentence of {len(s.split())} words: {s}" for s in sentences(text) if len(s.split()) > MOST_IN_ONE)
        for word, instead in WORDS.items():
            yield from (f"{name}: '{each}': write '{instead}'" for each in re.findall(word, plain(text), re.I))
        if not re.match(r"[A-Z]", text) or not text.endswith("."):
            yield f"{name}: not a sentence with a capital letter and a full stop: {text}"
    mean = sum(lengths) / max(1, len(lengths))
    if mean > MOST_ON_THE_MEAN:
        yield f"{mean:.1f} words a sentence, at most {MOST_ON_THE_MEAN} on the mean"


def main(program):
    if program.endswith(".json"):
        text = open(program, encoding="utf-8").read()
    else:
        text = subprocess.run([program, "parameters", "--json"], check=True, capture_output=True, text=True).stdout
    found = list(entries(json.loads(text)))
    # the reader itself, so that this test can fail
    assert len(found) > 300 and "Time/End time" in dict(found), "the tree of parameters is not read as expected"
    assert len(list(faults([("A", "What touches the blade, of which 'a: b c' is held.")]))) == 4
    assert list(faults([("A", "One " + 41 * "word " + "more.")])) and list(faults([("A", "no capital.")]))
    assert not list(faults([("A", "Nodes with a name, e.g. 'what: x y z'. Empty: all nodes.")]))
    wrong = list(dict.fromkeys(faults(found)))
    counted = [len(s.split()) for _, each in found for s in sentences(each)]
    print("\n".join(wrong) or f"plain: {len(counted)} sentences of {sum(counted) / len(counted):.1f} words on the mean, "
                              f"{max(counted)} in the longest")
    return bool(wrong)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
