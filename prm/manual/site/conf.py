"""How Sphinx makes pages of the manual: prm/manual/build.sh."""

import re

from pygments.lexer import RegexLexer, bygroups
from pygments.token import Comment, Keyword, Name, Operator, String, Text

project = "birdstrike"
html_title = "birdstrike"
author = "the birdstrike developers"

extensions = ["myst_parser"]
source_suffix = {".md": "markdown"}
root_doc = "index"
myst_heading_anchors = 4
suppress_warnings = ["myst.header"]  # a level of headings that a document skips
smartquotes = False
highlight_language = "none"
pygments_style = "friendly"
pygments_dark_style = "monokai"

html_theme = "furo"
html_theme_options = {
    "light_css_variables": {"font-stack--monospace": "DejaVu Sans Mono, Menlo, Consolas, monospace"},
    "dark_css_variables": {"font-stack--monospace": "DejaVu Sans Mono, Menlo, Consolas, monospace"},
}
html_static_path = ["manual.css"]
html_css_files = ["manual.css"]
html_copy_source = False
html_show_sphinx = False
html_show_copyright = False


class ParameterFile(RegexLexer):
    """Parameter files: sections, entries, remarks."""

    name = "prm"
    flags = re.M
    tokens = {"root": [
        (r"#[^\n]*", Comment),
        (r"^(\s*)(subsection)([^\n#]*)", bygroups(Text, Keyword, Name.Namespace)),
        (r"^(\s*)(end)\b", bygroups(Text, Keyword)),
        (r"^(\s*)(include)([^\n#]*)", bygroups(Text, Keyword, String)),
        (r"^(\s*)(set)([^=\n]*)(=)([^#\n]*)", bygroups(Text, Keyword, Name.Attribute, Operator, String)),
        (r".|\n", Text)]}


def setup(app):
    app.add_lexer("prm", ParameterFile)
