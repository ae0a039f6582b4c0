"""Pages of all entries of parameter files, for the manual:  entries.py PROGRAM FOLDER

Reads `PROGRAM parameters --json` and writes into FOLDER a README.md and a page for each section. A section that repeats (Bird 2 to 4, further
metals and plies) stands once, with its other names.
"""
import json
import os
import re
import subprocess
import sys

MOST_ON_A_PAGE = 60  # entries; a section of more has a page for each of its parts


def is_entry(node):
    return isinstance(node.get("default"), str)


def describe(allowed):
    """What an entry may be, shorter than the program says it."""
    if allowed.startswith("one of "):
        return ", ".join(f"`{choice}`" for choice in allowed.removeprefix("one of ").split(", "))
    allowed = re.sub(r"items separated by ',', each a number", "numbers", allowed)
    allowed = re.sub(r"^a number (?=above|from)|^a number, ", "", allowed)
    return cell(allowed.replace("an integer", "integer").replace("true or false", "true, false"))


def cell(text):
    """As it stands, in a table of Markdown."""
    return re.sub(r"\s+", " ", re.sub(r"([\\|*_<\[\]$])", r"\\\1", text)).strip()


def code(text):
    return f"`{text}`".replace("|", r"\|") if text else "empty"


def row(name, node):
    return f"| {code(name)} | {code(node['default'])} | {cell(node['unit'])} | {describe(node['range'])} | {cell(node['text'])} |"


def names(node):
    """The shape of a section: names of entries and sections in it."""
    return {name: None if is_entry(child) else names(child) for name, child in node.items()}


def children(node):
    """Entries, and sections with the names under which the same section stands again."""
    entries = {name: child for name, child in node.items() if is_entry(child)}
    sections = {}
    for name, child in node.items():
        if not is_entry(child):
            stem = re.sub(r" \d+$", "", name)
            first = next((n for n in sections if re.sub(r" \d+$", "", n) == stem and names(node[n]).keys() <= names(child).keys()), None)
            if first and stem != name:
                sections[first].append(name)
            else:
                sections[name] = []
    return entries, sections


def count(node):
    entries, sections = children(node)
    return len(entries) + sum(count(node[name]) for name in sections)


def tables(node, path, level):
    """A heading and a table for each section."""
    entries, sections = children(node)
    lines = [f"{'#' * level} {'/'.join(path)}", ""]
    if entries:
        lines += ["```{rst-class} entries", "```", "", "| entry | default | unit | range | meaning |", "|---|---|---|---|---|",
                  *(row(*each) for each in entries.items()), ""]
    for name, again in sections.items():
        inner = tables(node[name], path + [name], min(level + 1, 4))
        lines += inner[:2] + note(node, name, again) + inner[2:]
    return lines


def note(node, name, again):
    """Of a section that stands again under other names."""
    if not again:
        return []
    listed = ", ".join(f"`{other}`" for other in again)
    own = sorted(set.union(*(set(node[other]) for other in again)) - set(node[name]))
    more = "; " + ", ".join(f"`{entry}`" for entry in own) + " are theirs alone" if own else ""
    return [f"The same entries stand in {listed}{more}.", ""]


def write(folder, name, lines):
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, name + ".md"), "w", encoding="utf-8") as file:
        file.write("\n".join(lines).rstrip("\n") + "\n")


def page_name(path):
    return "-".join(path).lower().replace(" ", "-")


def pages(tree):
    """Path of a section, its node, and the lines of its page."""
    entries, sections = children(tree)
    for name, again in sections.items():
        node = tree[name]
        if count(node) <= MOST_ON_A_PAGE:
            lines = tables(node, [name], 1)
            yield [name], count(node), lines[:2] + note(tree, name, again) + lines[2:]
            continue
        own, parts = children(node)
        if own:
            lines = tables({key: child for key, child in node.items() if key in own}, [name], 1)
            yield [name], len(own), lines[:2] + note(tree, name, again) + lines[2:]
        for part, others in parts.items():
            lines = tables(node[part], [name, part], 1)
            yield [name, part], count(node[part]), lines[:2] + note(node, part, others) + lines[2:]


def main(program, folder):
    tree = json.loads(subprocess.run([program, "parameters", "--json"], check=True, capture_output=True, text=True).stdout)
    made = list(pages(tree))
    total = sum(n for _, n, _ in made)
    assert total > 100, "the entries are not read as expected"
    lines = ["# Entries", "",
             f"All {total} entries of a parameter file, by section; sections that repeat count once. `birdstrike parameters` prints the same.",
             "The search of this manual finds an entry by its name or by words of its meaning.", "",
             "Numbers take units and formulas: see [Case files](../prm/manual/case-files.md).", "",
             "| section | entries |", "|---|---|", *(f"| [{'/'.join(path)}]({page_name(path)}.md) | {n} |" for path, n, _ in made), "",
             "```{toctree}", ":hidden:", "", *(page_name(path) for path, _, _ in made), "```"]
    write(folder, "README", lines)
    for path, _, text in made:
        write(folder, page_name(path), text)


if __name__ == "__main__":
    main(*sys.argv[1:])
