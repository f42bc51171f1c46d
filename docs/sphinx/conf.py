"""The documentation as pages with a search: `cmake --build build/release --target docs`.

The sources are the Markdown files of the repository as they are; this file only says which, and in
which order. Links that lead nowhere are errors (-W).
"""

import shutil
from pathlib import Path

project = "liesl"
author = "the liesl authors"
extensions = ["myst_parser"]
html_theme = "furo"
html_title = "liesl"
html_show_copyright = False
html_extra_path = ["index.html"]  # servers open it: leads to README.html
highlight_language = "none"  # what a terminal shows is no Python

root_doc = "README"
source_suffix = {".md": "markdown"}
include_patterns = ["README.md", "CONTRIBUTING.md", "CHANGELOG.md", "docs/*.md", "data/*/README.md",
                    "tests/README.md", "tests/*/README.md", "liegroup/README.md",
                    "apps/report/page/README.md"]
exclude_patterns = ["build", "install", "**/node_modules"]

myst_heading_anchors = 6
suppress_warnings = ["myst.header"]  # pages begin where they begin

PAGES = {
    "Use": ["data/scenes/README", "data/studies/README", "data/parts/README", "docs/scene_reference",
            "docs/responses", "docs/outputs", "docs/python", "data/python/README", "docs/cluster"],
    "Method": ["docs/theory", "docs/methods", "docs/sensitivities", "liegroup/README"],
    "What was measured": ["docs/accuracy_and_speed", "docs/performance", "docs/stability",
                          "data/stability/README", "docs/traps"],
    "Development": ["docs/README", "CONTRIBUTING", "docs/architecture", "docs/extending", "tests/README",
                    "tests/frozen/README", "apps/report/page/README", "docs/licences", "CHANGELOG"],
}


def add_contents(app, name, source):
    """The contents, below the first page."""
    if name != root_doc:
        return
    for caption, pages in PAGES.items():
        source[0] += f"\n\n```{{toctree}}\n:caption: {caption}\n:hidden:\n\n" + "\n".join(pages) + "\n```\n"


MODULE = 'import Gumshoe from "./gumshoe-patched.js";'
SERVED, NORMALIZE = "/javascript/normalize.css/normalize.css", Path("/usr/share/javascript/normalize.css/normalize.css")


def stand_alone(app, error):
    """Debian's furo loads a module as a plain script, and a style from a folder of the web server: without
    both, pages have margins about the page and no switch between light and dark."""
    static = Path(app.outdir) / "_static"
    script, style = static / "scripts/furo.js", static / "styles/furo.css"
    if error or not script.exists():
        return
    if MODULE in (text := script.read_text()):
        script.write_text((script.parent / "gumshoe-patched.js").read_text() + "\n" + text.replace(MODULE, ""))
    if SERVED in (text := style.read_text()) and NORMALIZE.exists():
        shutil.copy(NORMALIZE, style.parent)
        style.write_text(text.replace(SERVED, NORMALIZE.name))


def setup(app):
    app.connect("source-read", add_contents)
    app.connect("build-finished", stand_alone)
