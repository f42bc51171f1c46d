#!/usr/bin/env python3
"""Shows that check_bundle.py can fail: one change for each thing it checks."""

import hashlib
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
import check_bundle  # noqa: E402

FILES = {"pins.txt": "three 1\n", "src/main.js": "a();\n", "src/style.css": "b {}\n", "dist/report.js": "a()\n"}


def errors_after(changes):
    """Of a page that was right before; a text of None takes a file away."""
    with tempfile.TemporaryDirectory() as folder:
        page = Path(folder) / check_bundle.PAGE
        for name in ("src", "dist"):
            (page / name).mkdir(parents=True)
        sums = "".join(f"{hashlib.sha256(text.encode()).hexdigest()}  {name}\n" for name, text in FILES.items())
        for name, text in {**FILES, check_bundle.LIST: sums, **changes}.items():
            if text is not None:
                (page / name).write_text(text, encoding="utf-8")
        return check_bundle.check(folder)


class CheckBundle(unittest.TestCase):
    def test_nothing_changed(self):
        self.assertEqual(errors_after({}), [])

    def assert_says(self, changes, what):
        errors = errors_after(changes)
        self.assertEqual(len(errors), 1, errors)
        self.assertIn(what, errors[0])
        self.assertIn("run apps/report/page/bundle.sh", errors[0])

    def test_a_source_has_changed(self):
        self.assert_says({"src/main.js": "a(); \n"}, "src/main.js has changed")

    def test_a_source_is_new(self):
        self.assert_says({"src/more.js": ""}, "src/more.js is new")

    def test_a_source_is_gone(self):
        self.assert_says({"src/style.css": None}, "src/style.css is gone")

    def test_another_version_of_a_package(self):
        self.assert_says({"pins.txt": "three 2\n"}, "pins.txt has changed")

    def test_the_bundle_was_edited(self):
        self.assert_says({"dist/report.js": "b()\n"}, "dist/report.js has changed")

    def test_without_the_list(self):
        self.assert_says({check_bundle.LIST: None}, "sources.sha256 is missing")


if __name__ == "__main__":
    unittest.main()
