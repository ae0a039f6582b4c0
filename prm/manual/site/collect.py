"""Gathers the pages of the manual:  collect.py TOP FOLDER

FOLDER becomes a copy of the project's documents, as far as links lead from README.md and the chapters, with README.md as index.md. Pictures and
other files that they link to lie beside them. The bar at the side lists the chapters in the order of prm/manual/README.md, then the
pages of entries, which are in FOLDER/entries.
"""
import os
import re
import shutil
import sys

FIRST, CHAPTERS, ENTRIES = "README.md", "prm/manual/README.md", "entries/README.md"
LINK = re.compile(r"(\]\()([^)\s]+)(\))")


def without_code(text):
    return re.sub(r"```.*?```|`[^`\n]*`", "", text, flags=re.S)


def links(path, text):
    """Files that a document links to, relative to the top."""
    for _, target, _ in LINK.findall(without_code(text)):
        name = target.partition("#")[0]
        if name and not re.match(r"\w+:", target):
            yield os.path.normpath(os.path.join(os.path.dirname(path), name))


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def rename_first(path, text):
    """Links to README.md lead to index.md."""
    def renamed(match):
        name, mark, heading = match[2].partition("#")
        is_first = name and os.path.normpath(os.path.join(os.path.dirname(path), name)) == FIRST
        return match[1] + (os.path.join(os.path.dirname(name), "index.md") if is_first else name) + mark + heading + match[3]
    return LINK.sub(renamed, text)


def gather(top):
    """All documents that links lead to, in the order in which they are met, and the other files."""
    documents, files, waiting = {}, set(), [FIRST, CHAPTERS] + sorted(
        f"prm/manual/{name}" for name in os.listdir(os.path.join(top, "prm/manual")) if name.endswith(".md"))
    while waiting:
        path = waiting.pop(0)
        if path in documents or path in files or not os.path.isfile(os.path.join(top, path)):
            continue  # Sphinx tells of links that lead nowhere
        if not path.endswith(".md"):
            files.add(path)
            continue
        documents[path] = read(os.path.join(top, path))
        waiting += links(path, documents[path])
    return documents, files


def bar(caption, paths):
    return "\n".join(["", "```{toctree}", ":hidden:", f":caption: {caption}", "", *(p.removesuffix(".md") for p in paths), "```", ""])


def write(path, text):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def main(top, folder):
    documents, files = gather(top)
    chapters = [p for p in dict.fromkeys(links(CHAPTERS, documents[CHAPTERS])) if p.endswith(".md") and p != FIRST]
    others = [p for p in documents if p not in (FIRST, CHAPTERS, *chapters) and not p.startswith("prm/manual/")]
    for path, text in documents.items():
        write(os.path.join(folder, "index.md" if path == FIRST else path), rename_first(path, text))
    with open(os.path.join(folder, "index.md"), "a", encoding="utf-8") as first:
        first.write(bar("Manual", [CHAPTERS, *chapters]) + bar("Entries", [ENTRIES]) + bar("Project", others))
    for path in files:
        os.makedirs(os.path.dirname(os.path.join(folder, path)) or folder, exist_ok=True)
        shutil.copyfile(os.path.join(top, path), os.path.join(folder, path))


if __name__ == "__main__":
    main(*sys.argv[1:])
