#!/usr/bin/env python3
"""Checks what the documentation points to: check_links.py [ROOT]

- every relative link of a page (`[text](path#heading)`) leads to a file and a heading that exist;
- every path in backticks that begins with a folder of the tree exists (`mbs/solvers/statics.*` and
  `mbs/{rigid,modal}.hpp` stand for files; NAME, DIR and FILE for a name of the reader);
- every page or test that a comment of the sources names exists;
- nothing names a page outside of the repository (OUTSIDE).

Ends with 1 if anything is wrong. Needs nothing but Python 3.
"""

import itertools
import re
import sys
from pathlib import Path

FOLDERS = ["liegroup", "mbs", "esl", "optim", "apps", "python", "tests", "data", "docs", "cmake", ".ci"]
SKIPPED = {"build", ".git", "install"}
OUTSIDE = re.compile(r"\b(DESIGN|BENCHMARKS|SENSITIVITIES|PLAN)\b|design page")
PLACEHOLDER = re.compile(r"(NAME|DIR|FILE|SCENE)|<|\.\.\.|…")


def files(root, *kinds):
    return [p for p in sorted(root.rglob("*"))
            if p.suffix in kinds and not SKIPPED & set(p.relative_to(root).parts)]


def slug(heading):
    """Anchor of a heading, as GitHub makes it."""
    text = re.sub(r"[`*]|\[|\]\([^)]*\)", "", heading).strip().lower()
    return re.sub(r"[^\w\- ]", "", text).replace(" ", "-")


def headings(text):
    text = re.sub(r"^```.*?^```", "", text, flags=re.M | re.S)
    return {slug(h) for h in re.findall(r"^#+ (.*)$", text, re.M)}


def expanded(path):
    """a/{b,c}.hpp as a/b.hpp, a/c.hpp."""
    parts = re.split(r"\{([^}]*)\}", path)
    choices = [part.split(",") if i % 2 else [part] for i, part in enumerate(parts)]
    return ["".join(choice) for choice in itertools.product(*choices)]


def exists(root, path):
    return any(root.glob(path)) if "*" in path else (root / path).exists()


def check_page(root, page):
    text, errors = page.read_text(encoding="utf-8"), []
    name = page.relative_to(root)
    prose = re.sub(r"^```.*?^```", "", text, flags=re.M | re.S)
    for target in re.findall(r"\]\(([^)\s]+)\)", prose):
        if re.match(r"[a-z]+:", target):
            continue
        path, _, anchor = target.partition("#")
        there = (page.parent / path).resolve() if path else page
        if not there.exists():
            errors.append(f"{name}: link to '{target}', which does not exist")
        elif anchor and there.suffix == ".md" and anchor not in headings(
                there.read_text(encoding="utf-8")):
            errors.append(f"{name}: link to '{target}': no such heading")
    for code in re.findall(r"`([^`\n]+)`", prose):
        for path in re.findall(rf"(?:^|\s)((?:{'|'.join(map(re.escape, FOLDERS))})/[^\s:;]*)", code):
            if PLACEHOLDER.search(path) or path.startswith("data/") and "=" in path:
                continue
            for each in expanded(path):
                if not exists(root, each.rstrip(".,)")):
                    errors.append(f"{name}: `{path}` does not exist")
    return errors


def check_source(root, source):
    """Pages, tests and headers that comments name by their path."""
    errors, name = [], source.relative_to(root)
    for line in source.read_text(encoding="utf-8").splitlines():
        comment = re.search(r"(//|#).*", line)
        if not comment or line.lstrip().startswith("#include"):
            continue
        for path in re.findall(r"\b((?:docs|tests|data)/[\w/{},*.-]*\.(?:md|cpp|hpp|toml|py))\b",
                               comment.group()):
            if not all(exists(root, each) for each in expanded(path)):
                errors.append(f"{name}: a comment names '{path}', which does not exist")
    return errors


def check(root):
    """Everything that is wrong in the tree at `root`, as texts."""
    root, errors = root.resolve(), []
    pages = files(root, ".md")
    sources = [p for p in files(root, ".hpp", ".cpp", ".toml", ".py")
               if p.parent.name != "architecture"]
    for page in pages:
        errors += check_page(root, page)
    for source in sources:
        errors += check_source(root, source)
    for path in pages + sources:
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            if found := OUTSIDE.search(line):
                errors.append(f"{path.relative_to(root)}:{number}: '{found.group()}' is not a page of "
                              "this repository")
    if not pages:
        errors.append(f"no pages under {root}")
    return errors


def main():
    root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parents[2])
    errors = check(root)
    for error in errors:
        print(error)
    print(f"links: {len(errors)} errors" if errors else "links: fine")
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main())
