#!/usr/bin/env python3
"""docs_test.py FOLDER: the pages that the target docs makes, opened from the disk in a real browser.

Nothing on the console, no margin about the page, a switch between light and dark, a search that finds.
Ends with 77 (skipped) without a browser.
"""

import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
from driver import BrowserTest, programs  # noqa: E402

DOCS = Path(sys.argv[1]).resolve()


class Docs(BrowserTest):
    def open(self, page):
        self.browser.log("browser")
        self.browser.call("POST", "/url", {"url": DOCS.as_uri() + "/" + page})

    def test_pages_are_whole(self):
        for page in ("README.html", "docs/python.html", "data/studies/README.html"):
            self.open(page)
            self.assertEqual([entry["message"] for entry in self.browser.log("browser")], [], page)
            self.assertEqual(self.browser.run("return getComputedStyle(document.body).marginTop"), "0px", page)

    def test_light_and_dark(self):
        self.open("docs/python.html")
        seen = {self.browser.run("return document.body.dataset.theme")}
        for _ in range(3):
            self.browser.run("document.querySelector('.theme-toggle').click()")
            seen.add(self.browser.run("return document.body.dataset.theme"))
        self.assertEqual(seen, {"auto", "light", "dark"})

    def test_search_finds(self):
        self.open("search.html?q=torsion")
        found = "return [...document.querySelectorAll('#search-results li a')].map((a) => a.textContent)"
        self.browser.wait(lambda: any("Theory" in text for text in self.browser.run(found)), "theory among what is found", 10)


if __name__ == "__main__":
    if programs() is None:
        print("skipped: no chromium with its driver; apt-get install chromium chromium-driver", file=sys.stderr)
        sys.exit(77)
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]], verbosity=1)
