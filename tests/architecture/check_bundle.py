#!/usr/bin/env python3
"""check_bundle.py ROOT: apps/report/page/dist is what bundle.sh made of apps/report/page/src.

Reads dist/sources.sha256, which bundle.sh writes: the SHA-256 of each source, of pins.txt (versions of
the packages) and of each file of dist.
"""

import hashlib
import sys
from pathlib import Path

PAGE = "apps/report/page"
LIST = "dist/sources.sha256"
HINT = f"run {PAGE}/bundle.sh"


def listed(text):
    """Name -> SHA-256, as sha256sum writes them."""
    return {name.lstrip(" *"): sha for sha, name in (line.split(" ", 1) for line in text.splitlines())}


def check(root):
    """Errors, each with what to do."""
    page = Path(root) / PAGE
    if not (page / LIST).exists():
        return [f"{PAGE}/{LIST} is missing: {HINT}"]
    known = listed((page / LIST).read_text(encoding="utf-8"))
    there = [page / "pins.txt", *(page / "src").iterdir(), *(page / "dist").iterdir()]
    found = {str(file.relative_to(page)): hashlib.sha256(file.read_bytes()).hexdigest()
             for file in there if file.is_file() and file != page / LIST}
    errors = []
    for name in sorted({*known, *found}):
        if name not in found:
            errors.append(f"{PAGE}/{name} is gone: {HINT}")
        elif name not in known:
            errors.append(f"{PAGE}/{name} is new: {HINT}")
        elif known[name] != found[name]:
            errors.append(f"{PAGE}/{name} has changed: {HINT}")
    return errors


def main():
    errors = check(sys.argv[1])
    for error in errors:
        print(error, file=sys.stderr)
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main())
