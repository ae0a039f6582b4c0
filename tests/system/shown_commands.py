"""Commands that documents show: in READMEs, in heads of parameter files, in help texts and in the program's messages."""

import glob
import os
import re
import subprocess

VERBS = ("run", "resume", "explain", "validate", "static", "modes", "compare", "study", "converge", "columns", "parameters",
         "new", "materials", "liquids")
VERB = "|".join(VERBS)

# What a span of code begins with that is a command; `run` alone is a word, `run FILE.prm` a command.
BEGINS = re.compile(rf"(birdstrike|build/bin/\S+|bash \S|python3 \S|pvpython|xvfb-run|cmake|ctest|parallel|sbatch|gmsh |({VERB}) \S|--[a-z])")


def is_command(text):
    return bool(BEGINS.match(text)) and not re.match(r"(birdstrike|gmsh)[^\s]", text)


def lines_of_block(block):
    """Commands of a block of shell, without remarks."""
    for line in block.splitlines():
        text = re.sub(r"\s{2,}#.*$", "", line).strip()
        if text and not text.startswith("#"):
            yield text


def commands_of_documents(path):
    """Lists of commands; those of a block of shell are one list."""
    with open(path) as file:
        text = file.read()
    for block in re.findall(r"```(?:sh|bash|console)\n(.*?)```", text, re.S):
        yield list(lines_of_block(block))
    text = re.sub(r"```.*?```", "", text, flags=re.S)
    for span in re.findall(r"`([^`]+)`", text):
        if is_command(span):
            yield [re.sub(r"\s+", " ", span)]


def files_of_heads(top):
    return sorted(os.path.relpath(path, top) for path in glob.glob(top + "/prm/**/*.prm", recursive=True))


def commands_of_heads(path):
    """Of the remark that a parameter file begins with."""
    with open(path) as file:
        lines = file.read().splitlines()
    head = []
    for line in lines:
        if line and not line.startswith("#"):
            break
        head.append(line.lstrip("#"))
    text = "\n".join(head)
    for match in re.findall(rf"\bbirdstrike (?:{VERB})\b[^\n]*", text):
        yield re.split(r"\s{2,}|: |:$|[.,;)]+$|[.,;]\s| \(", match)[0].strip()
    for match in re.findall(r"(?:--set (?:\"[^\"]*\"|[^\s\"]+)(?:\s+(?=--set))?)+", text):
        yield re.sub(r"[.,;)]+$", "", re.sub(r"\s+", " ", match))


def examples_of_help(program, verb):
    """What the help of a command puts between quotes."""
    text = subprocess.run([program, verb, "--help"], capture_output=True, text=True).stdout
    return sorted(set(re.findall(r"\"([^\"]+)\"", re.sub(r"\s*\n\s+", " ", text))))


def commands_of_messages(top):
    """What messages advise, between single quotes and without parts that are filled in: 'birdstrike converge FILE.prm --vary step'."""
    found = set()
    for path in glob.glob(top + "/source/**/*.cc", recursive=True):
        with open(path) as file:
            text = re.sub(r"\"\s*\n\s*\"", "", file.read())
        for command in re.findall(rf"'(birdstrike (?:{VERB})[^'\n]*)'", text):
            if not re.search(r"[{\"]", command):
                found.add(command.replace('\\"', '"'))
    return sorted(found)
