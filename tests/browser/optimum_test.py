#!/usr/bin/env python3
"""optimum_test.py PROGRAM DATA SOLVED CLASS: pages of optimised studies in a real browser.

`Optimum`: prices of limits, certificate, status, reason and origin are those of summary.json. `Lattice`: the page of
the largest shipped study, in time and size. Ends with 77 (skipped) without a browser.
"""

import json
import shutil
import sys
import unittest

sys.dont_write_bytecode = True
from driver import programs  # noqa: E402
from pages import DATA, FOLDER, SOLVED, PageTest, liesl, rod  # noqa: E402


class Optimum(PageTest):
    def origin(self):
        """What "Where it comes from" tells: name -> value."""
        return dict(self.browser.run("""const c = [...document.querySelectorAll('.card')].find((c) => c.textContent.startsWith('Where it comes from'));
            return [...c.querySelectorAll('dt')].map((d) => [d.textContent, d.nextSibling.textContent]);"""))

    def tiles(self):
        """Tiles of the head: label -> [value, note]."""
        return dict(self.browser.run("""return [...document.querySelectorAll('header .tile')].map((t) =>
            [t.querySelector('span').textContent, [t.querySelector('b').textContent, t.querySelector('small')?.textContent ?? '']]);"""))

    def savings(self):
        """kg that a hundredth more of each limit saves: limit -> number, of those that carry a price."""
        units = {"kg": 1, "g": 1e-3, "mg": 1e-6}
        rows = self.browser.run("""const t = [...document.querySelectorAll('table')].find((t) => t.textContent.includes('1 % more saves'));
            const i = [...t.querySelectorAll('th')].findIndex((h) => h.textContent === '1 % more saves');
            return [...t.querySelectorAll('tbody tr')].map((r) => [r.children[0].textContent, r.children[i].textContent]);""")
        shown = {name: text.replace("\u2212", "-").split("\xa0") for name, text in rows if text != "\u2013"}
        return {name: float(value) * units[unit] for name, (value, unit) in shown.items()}

    def check_prices(self, summary):
        """To the three digits that are shown."""
        saved, prices = self.savings(), summary["prices"]
        self.assertGreater(len(prices), 0)
        self.assertEqual(set(saved), set(prices))
        for name, price in prices.items():
            self.assertAlmostEqual(saved[name] / (price / 100), 1, delta=5e-3, msg=name)

    def test_an_optimum_tells_its_prices_its_certificate_and_where_it_comes_from(self):
        folder, override = FOLDER / "certified", "constraints.bending.limit=1.1e-3"
        words = ["optimize", str(DATA / "studies/slider_crank_rod.toml"), "--set", override, "--no-verify", "-o", str(folder), "--quiet"]
        self.assertEqual(liesl(*words).returncode, 0)
        summary = json.loads((folder / "summary.json").read_text())
        self.show(folder)
        self.check_prices(summary)
        status, reason = self.browser.run("return ['.badge', '.reason'].map((c) => document.querySelector('header ' + c).textContent)")
        self.assertEqual(status, summary["status"])
        self.assertIn(summary["reason"].split("; worst limit")[0], reason)
        value, note = self.tiles()["KKT residual"]
        self.assertAlmostEqual(float(value) / summary["kkt_residual"], 1, delta=0.05, msg="two digits")
        self.assertEqual(note, "optimal for the motion")
        self.assertIn(summary["kkt"], self.browser.run("return document.querySelector('main').textContent"))
        origin = self.origin()
        self.assertEqual(origin["command"], "liesl " + " ".join(summary["arguments"]))
        self.assertIn(f"--set {override} ", origin["command"])
        self.assertEqual(origin["overrides"], override)
        self.assertEqual(origin["input (SHA-256)"], summary["input_sha256"])
        self.assertEqual(origin["versions"].split(" \xb7 "), [f"{name} {version}" for name, version in summary["versions"].items()])
        self.assertIn(f"liesl {summary['versions']['liesl']} ", self.browser.run("return document.querySelector('footer').textContent"))

    def test_an_end_that_is_no_optimum_says_so(self):
        """The same of other figures: each shown one follows its own in summary.json."""
        folder = FOLDER / "uncertified"
        shutil.copytree(rod(), folder)
        file = folder / "summary.json"
        summary = json.loads(file.read_text())
        summary.update(status="cycle limit", reason="three cycles were allowed", kkt_residual=0.34, kkt="residual 0.34, it should grow",
                       prices={"bending": -0.0456, "part wall": 12.5}, overrides=["a.b=1", "c=[2, 3]"])
        del summary["arguments"]
        for residual, worst, shown in ((0.34, 0, ["0.34", "not optimal for the motion"]), (0, 0.3, ["0", "but limits are exceeded"]),
                                       (None, 0, ["\u2013", "not checked"])):
            summary.update(kkt_residual=residual, worst_constraint=worst)
            file.write_text(json.dumps(summary))
            self.assertEqual(liesl("report", str(folder)).returncode, 0)
            self.show(folder)
            self.assertEqual(self.tiles()["KKT residual"], shown)
        self.check_prices(summary)
        self.assertEqual(self.browser.run("return document.querySelector('header .badge').textContent"), "cycle limit")
        self.assertTrue(self.browser.run("return document.querySelector('.reason').textContent").startswith("Three cycles were allowed."))
        origin = self.origin()
        self.assertEqual(origin["command"], f"liesl optimize {summary['input']} --set 'a.b=1' --set 'c=[2, 3]'")
        self.assertEqual(origin["overrides"].split("\u2003"), summary["overrides"])


class Lattice(PageTest):
    def test_its_page_is_ready_in_time_and_small(self):
        """The shipped study, solved by the ctest study.robot_arm_lattice: 4 MB, 4 s, as the page of its scene."""
        folder = SOLVED / "robot_arm_lattice"
        self.show(folder, 4)
        self.assertLessEqual((folder / "report.html").stat().st_size, 4e6)
        self.assertIn("lattice", json.loads((folder / "summary.json").read_text())["input"])
        self.assertTrue(self.browser.run("return document.querySelector('.stage canvas') && document.querySelector('#cycle') && true"))
        seen = [self.picture()]
        self.slide("time", 0.3)
        seen.append(self.picture())
        self.assertNotEqual(*seen, "the arm moves")


if __name__ == "__main__":
    if programs() is None:
        print("skipped: no chromium with its driver; apt-get install chromium chromium-driver", file=sys.stderr)
        sys.exit(77)
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]], verbosity=1)
