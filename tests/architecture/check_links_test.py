#!/usr/bin/env python3
"""Shows that check_links.py can fail: one bad page for each thing it checks."""

import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
import check_links  # noqa: E402


def errors_of(page, source="// docs/theory.md\n"):
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        for path, text in {"README.md": page, "docs/theory.md": "# Theory\n## The `se3` element\n",
                           "mbs/model/a.cpp": source}.items():
            (root / path).parent.mkdir(parents=True, exist_ok=True)
            (root / path).write_text(text, encoding="utf-8")
        return check_links.check(root)


class CheckLinks(unittest.TestCase):
    def test_good_page(self):
        page = "[t](docs/theory.md#the-se3-element) `mbs/model/{a,*}.cpp` `mbs/NAME.cpp` [w](https://a.b)"
        self.assertEqual(errors_of(page), [])

    def test_link_to_no_file(self):
        self.assertIn("does not exist", errors_of("[t](docs/nothing.md)")[0])

    def test_link_to_no_heading(self):
        self.assertIn("no such heading", errors_of("[t](docs/theory.md#nothing)")[0])

    def test_path_of_no_file(self):
        self.assertIn("`mbs/model/b.hpp`", errors_of("see `mbs/model/b.hpp`")[0])

    def test_comment_that_names_no_file(self):
        self.assertIn("a comment names", errors_of("", "// see docs/nothing.md\n")[0])

    def test_page_outside_of_the_repository(self):
        self.assertIn("not a page", errors_of("", "// DESIGN section 6\n")[0])


if __name__ == "__main__":
    unittest.main()
