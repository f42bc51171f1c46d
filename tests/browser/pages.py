"""What tests of pages share: results with their pages, and a browser that opens and checks one."""

import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from driver import BrowserTest

PROGRAM, DATA, SOLVED = (Path(word).resolve() for word in sys.argv[1:4])
WORK = tempfile.TemporaryDirectory(prefix="liesl-browser-")
FOLDER = Path(WORK.name)
MARGIN = 10  # times what a quiet machine takes: times are printed, only a wrong order fails

HASH = """const c = document.querySelector('.stage canvas');
const d = c.toDataURL(); let h = 0;
for (let i = 0; i < d.length; ++i) h = (31 * h + d.charCodeAt(i)) | 0; return h;"""
SLIDE = """const s = document.getElementById(arguments[0]);
s.value = arguments[1]; s.dispatchEvent(new Event(s.tagName === 'SELECT' ? 'change' : 'input', { bubbles: true }));"""


def liesl(*words):
    return subprocess.run([PROGRAM, *words], capture_output=True, text=True)


def folder_of(name, *words):
    """A results folder with its page, made once."""
    folder = FOLDER / name
    if not folder.exists():
        done = liesl(*words, "-o", str(folder), "--quiet")
        assert (folder / "report.html").exists(), done.stderr
    return folder


def rod():
    """The shipped study, solved by the ctest study.slider_crank_rod."""
    return SOLVED / "slider_crank_rod"


class PageTest(BrowserTest):
    def show(self, folder, seconds=2.0, name=None):
        """Opens a page and checks what holds for every page."""
        browser = self.browser
        browser.call("POST", "/window/rect", {"width": 1280, "height": 1000})
        took = browser.open(folder / "report.html")
        self.assertLess(took / 1000, MARGIN * seconds, "ready in time")
        size = (folder / "report.html").stat().st_size / 1e6
        print(f"{folder.name}: {size:.2f} MB, ready after {took} ms")
        self.assertEqual([entry["message"] for entry in browser.log("browser")], [])
        requests = browser.requests()
        self.assertEqual(len(requests), 1, requests)
        if os.environ.get("LIESL_PICTURES"):
            browser.frames()
            browser.picture(Path(os.environ["LIESL_PICTURES"]) / f"{name or folder.name}.png")

    def slide(self, name, value):
        self.browser.run(SLIDE, name, value)
        self.browser.frames()

    def picture(self):
        self.browser.frames()
        return self.browser.run(HASH)

    def playing(self, name):
        """Pictures a second while it plays."""
        press = "document.body.dispatchEvent(new KeyboardEvent('keydown', {key: ' ', bubbles: true}))"
        self.browser.run(press)
        time.sleep(2.5)
        rate = float(self.browser.wait(lambda: self.browser.run("return document.querySelector('.stage canvas').dataset.fps"),
                                       "eleven pictures", 30))
        self.browser.run(press)
        print(f"{name}: {rate:.0f} frames a second while playing")
        return rate
