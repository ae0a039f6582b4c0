"""Every link of a folder of HTML leads to a file and a place in it, and no page asks another machine for anything:  site_links.py FOLDER"""
import html.parser
import pathlib
import re
import sys
import tempfile
import urllib.parse


class Page(html.parser.HTMLParser):
    """Links, what the page loads, and names of its places."""

    def __init__(self, path):
        super().__init__()
        self.links, self.loaded, self.places = [], [], {"", "top"}
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        self.places |= {given[key] for key in ("id", "name") if given.get(key)}
        if tag == "a" and given.get("href"):
            self.links.append(given["href"])
        elif tag in ("img", "script", "source", "iframe") and given.get("src"):
            self.loaded.append(given["src"])
        elif tag == "link" and given.get("href") and given.get("rel") != "canonical":
            self.loaded.append(given["href"])


def faults(folder):
    pages = {path.resolve(): Page(path) for path in sorted(folder.rglob("*.html"))}
    for path, page in pages.items():
        name = path.relative_to(folder.resolve())
        yield from (f"{name}: loads {link}" for link in page.loaded if re.match(r"(\w+:)?//", link))
        for link in page.links + page.loaded:
            if re.match(r"\w+:|//", link):
                continue
            target, _, place = urllib.parse.unquote(link).partition("#")
            file = (path.parent / target.partition("?")[0]).resolve() if target else path
            if not file.exists():
                yield f"{name}: {link} leads to no file"
            elif file in pages and place not in pages[file].places:
                yield f"{name}: {link} leads to no place"
    for sheet in sorted(folder.rglob("*.css")):
        for link in re.findall(r"(?:@import\s+|url\()\s*[\"']?([^\"')\s]+)", sheet.read_text(encoding="utf-8")):
            if not link.startswith("data:") and not (sheet.parent / link).exists():
                yield f"{sheet.relative_to(folder)}: asks for {link}"


def check_itself():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "a.html").write_text('<a href="b.html#x"></a><a href="#y"></a><script src="https://a.b/c.js"></script>')
        (folder / "a.css").write_text("@import url(/there.css);")
        assert len(list(faults(folder))) == 4, list(faults(folder))


def main(folder):
    check_itself()
    found = list(faults(folder))
    print("\n".join(found[:40]) or "all links lead somewhere")
    return bool(found)


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
