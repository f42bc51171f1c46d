#!/usr/bin/env python3
"""report_test.py PROGRAM DATA SOLVED: pages of `liesl report` in a real browser.

Every page: ready in time, nothing on the console, one request. Then what each kind is for: the picture
follows its sliders and is coloured, charts follow the instant, light and dark, phone width, tables and
scatter of a batch, rows of a comparison, shapes of vibration. Ends with 77 (skipped) without a browser.
With LIESL_PICTURES=DIR a screenshot of every page goes there.
"""

import base64
import csv
import json
import os
import re
import shutil
import subprocess
import sys
import time
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
from driver import programs  # noqa: E402
from inputs import BATCH, BRANCHES, CANTILEVER, CANTILEVER_STUDY, COMPARE  # noqa: E402
from pages import DATA, FOLDER, HASH, MARGIN, PROGRAM, PageTest, folder_of, liesl, rod  # noqa: E402

SUPERSCRIPTS = str.maketrans("\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079\u207b", "0123456789-")

METHODS = ["--set", 'grid.method=["esl","esl1"]', "--set", 'grid.optimizer=["ipopt"]', "--set", 'grid.treatment=["auto"]']

MAP = ["--over", "rod_diameters[0]=0.007:0.014,rod_diameters[1]=0.007:0.014", "--points", "5"]

# Of the tables on paper: the highest row, and how far they go to the right.
PAPER = """const tables = [...document.querySelectorAll('.paper table')], rows = tables.flatMap((t) => [...t.rows]);
return { rows: rows.length, highest: Math.max(...rows.map((r) => r.offsetHeight)), right: Math.max(...tables.map((t) => t.getBoundingClientRect().right)),
  screen: getComputedStyle(document.querySelector('.scroll.tall')).display };"""
SHEET = 703  # pixels between the margins of A4
# Of the cards below the columns: in how many places of the window their middle is seen, and where it is covered.
COVERED = """scrollTo(0, 0);
const end = Math.max(...[...document.querySelectorAll('.column')].map((c) => c.offsetTop + c.offsetHeight));
return [...document.querySelectorAll('.card')].filter((c) => c.offsetTop > end).map((card) => {
  const title = card.querySelector('h2').textContent; let seen = 0, covered = 0;
  for (let y = 0; y <= document.documentElement.scrollHeight - innerHeight; y += 20) {
    scrollTo(0, y);
    const r = card.getBoundingClientRect(), x = 0.5 * (r.left + r.right), middle = 0.5 * (r.top + r.bottom);
    if (middle <= 0 || middle >= innerHeight) continue;
    ++seen; covered += !card.contains(document.elementFromPoint(x, middle));
  }
  return { title, seen, covered: covered || !seen };
});"""
# Keeps what is written on canvases from now on, in `written`.
WRITTEN = """window.written = []; const write = CanvasRenderingContext2D.prototype.fillText;
CanvasRenderingContext2D.prototype.fillText = function (text, ...at) { written.push(text); return write.call(this, text, ...at); };"""
SATURATED = """const c = document.querySelector('.stage canvas'), n = document.createElement('canvas');
n.width = c.width; n.height = c.height; const x = n.getContext('2d'); x.drawImage(c, 0, 0);
const d = x.getImageData(0, 0, n.width, n.height).data; let coloured = 0;
for (let i = 0; i < d.length; i += 4)
  if (Math.max(d[i], d[i + 1], d[i + 2]) - Math.min(d[i], d[i + 1], d[i + 2]) > 60) ++coloured;
return coloured;"""

# Mean height of what is coloured in ten strips from left to right, pixels downwards.
HEIGHTS = SATURATED.replace("let coloured = 0", "const all = []").replace("++coloured", "all.push([(i / 4) % n.width, Math.floor(i / 4 / n.width)])").replace(
    "return coloured", """const xs = all.map((p) => p[0]), low = Math.min(...xs), wide = Math.max(...xs) - low;
return [...Array(10).keys()].map((s) => all.filter((p) => Math.min(9, Math.floor(10 * (p[0] - low) / wide)) === s).map((p) => p[1]))
  .map((ys) => ys.reduce((a, b) => a + b, 0) / ys.length)""")


class Pages(PageTest):
    def cursor(self):
        """Share of the width of the first chart at which its cursor stands."""
        return self.browser.run("""const c = document.querySelector('.now'), o = c.parentElement;
            return new DOMMatrix(getComputedStyle(c).transform).e / o.clientWidth;""")

    def test_rod_follows_its_sliders(self):
        self.show(rod())
        self.assertLess((rod() / "report.html").stat().st_size, 1e6)
        self.assertGreater(self.browser.run(SATURATED), 1500, "beams have the colours of stress")
        seen = [self.picture()]
        for name, value in (("time", 0.2), ("time", 0.45), ("scale", 0), ("scale", 2), ("colour", "M"),
                            ("cycle", 0), ("colour", "")):
            self.slide(name, value)
            seen.append(self.picture())
        self.assertEqual(len(set(seen)), len(seen), "each change shows")

    def test_loads_of_each_cycle_are_arrows(self):
        self.show(rod(), name="rod_loads")
        arrows = lambda: int(self.browser.run("return document.querySelector('.stage canvas').dataset.arrows ?? 0"))  # noqa: E731
        largest = "return document.querySelector('#loads tbody tr').children[2].textContent"
        press = "document.querySelectorAll('.loads button')[0].click()"
        self.assertEqual(arrows(), 0)
        last, plain = self.browser.run(largest), self.picture()
        self.browser.run(press)
        drawn = self.picture()
        self.assertGreater(arrows(), 2)
        self.assertNotEqual(drawn, plain)
        self.assertEqual(self.browser.run("return document.querySelectorAll('.loads button[aria-pressed=true]').length"), 1)
        if os.environ.get("LIESL_PICTURES"):
            self.browser.picture(Path(os.environ["LIESL_PICTURES"]) / "rod_arrows.png")
            self.browser.run("document.querySelector('.loads').scrollIntoView()")
            self.browser.frames()
            self.browser.picture(Path(os.environ["LIESL_PICTURES"]) / "rod_cycles.png")
        self.slide("cycle", 0)
        self.assertNotEqual(self.browser.run(largest), last, "the first cycle has other loads")
        self.assertGreater(arrows(), 2, "and its arrows are shown")
        self.assertNotEqual(self.picture(), drawn)
        self.slide("time", 0.01)
        self.assertEqual(arrows(), 0, "arrows belong to their instant")

    def test_map_has_contours_and_tells_its_values(self):
        folder = FOLDER / "map"
        done = liesl("map", str(DATA / "studies/slider_crank_rod.toml"), *MAP, "--path", str(rod()), "-o", str(folder), "--quiet")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(liesl("report", str(folder)).returncode, 0)
        self.show(folder)
        colours = """const c = document.querySelector('canvas.map'), d = c.getContext('2d').getImageData(0, 0, c.width, c.height).data, seen = new Set();
            for (let i = 0; i < d.length; i += 4) seen.add((d[i] << 16) | (d[i + 1] << 8) | d[i + 2]); return seen.size;"""
        self.assertGreater(self.browser.run(colours), 12, "bands of colour")
        picture = "return document.querySelector('canvas.map').toDataURL()"
        seen = [self.browser.run(picture)]
        names = self.browser.run("return [...document.getElementById('map-of').options].map((o) => o.value)")
        self.assertGreater(len(names), 1)
        self.slide("map-of", names[1])
        seen.append(self.browser.run(picture))
        self.browser.run("document.getElementById('map-local').click()")
        seen.append(self.browser.run(picture))
        self.assertEqual(len(set(seen)), 3, "quantity and local model")
        tell = """const c = document.querySelector('canvas.map'), r = c.getBoundingClientRect();
            c.dispatchEvent(new MouseEvent('mousemove', { clientX: r.x + arguments[0] * r.width, clientY: r.y + 0.5 * r.height, bubbles: true }));
            const t = document.querySelector('.tip'); return t.hidden ? '' : t.textContent;"""
        told = self.browser.run(tell, 0.5)
        for name in names:
            self.assertIn(name, told)
        self.assertNotEqual(self.browser.run(tell, 0.7), told)
        self.assertEqual(self.browser.run(tell, 0.005), "", "nothing beside the map")
        self.focus("canvas.map")
        told = "const t = document.querySelector('.tip'); return t.hidden ? '' : t.textContent"
        self.browser.press("ArrowRight")
        right = self.browser.run(told)
        self.browser.press("ArrowUp")
        self.assertTrue(right and self.browser.run(told) not in ("", right), "arrows move the pointer")
        self.assertIn("--over 'rod_diameters[0]=0.007:0.014,rod_diameters[1]=0.007:0.014' --points 5 ", self.command())

    def test_cursor_follows_the_instant_and_the_click(self):
        self.show(rod())
        for share in (0.25, 0.75):
            self.slide("time", share)
            self.assertAlmostEqual(self.cursor(), share, delta=0.01)
        box = self.browser.run("""const r = document.querySelector('.u-over').getBoundingClientRect();
            return [r.x, r.y, r.width, r.height];""")
        self.browser.click(box[0] + 0.5 * box[2], box[1] + 0.5 * box[3])
        self.browser.frames()
        self.assertAlmostEqual(self.cursor(), 0.5, delta=0.01)
        at = self.browser.run("return Number(document.getElementById('time').value)")
        self.assertAlmostEqual(at, 0.5, delta=0.01)

    def test_keys_play_and_step(self):
        self.show(rod())
        self.slide("time", 0.1)
        key = "document.body.dispatchEvent(new KeyboardEvent('keydown', {key: arguments[0], bubbles: true}))"
        before = self.cursor()
        self.browser.run(key, "ArrowRight")
        self.assertGreater(self.cursor(), before)
        self.assertGreater(self.playing("rod"), 30 / MARGIN)
        self.assertGreater(self.cursor(), before + 0.05)

    def focus(self, selector):
        self.browser.run("document.querySelector(arguments[0]).focus()", selector)

    def test_charts_have_keys(self):
        """Of a chart with the focus: ends, a record, a tenth, the peak; one step, not another of the picture."""
        self.show(rod())
        time = lambda: float(self.browser.run("return document.getElementById('time').value"))  # noqa: E731
        said = "return document.activeElement.getAttribute('aria-valuetext')"
        self.focus(".chart[data-chart=bending] .u-over")
        self.browser.press("End")
        self.assertEqual(time(), 1)
        self.browser.press("Home")
        self.assertEqual(time(), 0)
        first = self.browser.run(said)
        self.assertIn("final", first)
        self.browser.press("ArrowRight")
        step = time()
        self.assertGreater(step, 0)
        self.browser.press("ArrowRight")
        self.assertAlmostEqual(time(), 2 * step, delta=1e-3 * step)
        self.assertLess(step, 1 / 100)
        self.browser.press("Home", "PageUp")
        self.assertAlmostEqual(time(), 0.1, delta=step)
        self.browser.press("p")
        self.assertNotEqual(self.browser.run(said), first)
        value = float(re.search(r"final \W?([\d.]+)", self.browser.run(said)).group(1))
        self.assertAlmostEqual(value, 1, delta=2e-3)  # mm, the limit
        self.focus(".split .u-over")
        self.browser.press("Home")
        self.assertEqual(self.browser.run("return document.getElementById('cycle').value"), "0")
        self.browser.press("ArrowRight")
        self.assertEqual(self.browser.run("return document.getElementById('cycle').value"), "1")

    def test_the_worst_limit_is_told_once(self):
        self.show(rod())
        self.assertEqual(self.browser.run("return document.querySelector('header').textContent.split('worst limit').length - 1"), 1)

    def test_a_limit_of_ones_own_is_a_number(self):
        """A function f <= 0 has no limit to be a share of: no per cent beside it, in the head and in the cycles neither."""
        folder = FOLDER / "own_limit"
        shutil.copytree(rod(), folder)
        file = folder / "summary.json"
        summary = json.loads(file.read_text())
        summary["constraints"]["margin"] = {"response": "own function", "limit": 0, "unit": "-", "max_abs_initial": -12.5,
                                            "max_abs_final": 2.75, "at_time": 0, "violation": 2.75}
        summary["worst_constraint"] = 2.75
        for cycle in summary["history"]:
            cycle["limits"]["margin"] = {"violation": 2.75, "at": ""}
            cycle.update(worst_limit="margin", worst_at="", worst_constraint=2.75)
        file.write_text(json.dumps(summary))
        subprocess.run([PROGRAM, "report", folder, "--quiet"], check=True)
        self.show(folder)
        for place in ("header .tiles", ".figures"):
            text = self.browser.run(f"return document.querySelector('{place}').textContent")
            self.assertIn("+2.75", text, place)
            self.assertNotIn("+275", text, place)
        rows = self.browser.run("return [...document.querySelectorAll('main tr')].map(r => r.textContent)")
        row = next(r for r in rows if r.startswith("margin"))
        self.assertIn("+2.75", row)
        self.assertNotIn("%", row)
        row = next(r for r in rows if r.startswith("bending"))
        self.assertIn("%", row, "a limit of a response is a share")

    def test_joints_stay_closed_between_the_ends_of_bodies(self):
        file = FOLDER / "branches.toml"
        file.write_text(BRANCHES)
        self.show(folder_of("branches", "run", str(file)))
        openings = "return document.querySelector('.stage canvas').openings()"
        self.slide("time", 1)
        self.slide("scale", 0)
        closed, picture = self.browser.run(openings), self.picture()
        self.assertEqual(len(closed), 12)
        self.slide("scale", 2)  # a hundred times
        self.assertNotEqual(self.picture(), picture)
        for name, opening in self.browser.run(openings).items():
            self.assertLess(opening, closed[name] + 2e-4, name)  # m; the span bends by millimetres
        if os.environ.get("LIESL_PICTURES"):
            self.slide("scale", 1.3)
            self.browser.picture(Path(os.environ["LIESL_PICTURES"]) / "branches_bent.png")

    def test_statics_sink_from_rest(self):
        file = FOLDER / "cantilever.toml"
        file.write_text(CANTILEVER)
        self.show(folder_of("cantilever_bar", "run", str(file)))
        self.slide("colour", "displacement")
        self.picture()
        heights = self.browser.run(HEIGHTS)[2:]  # without wall and foot
        self.assertEqual(heights, sorted(heights))
        self.assertGreater(heights[-1], heights[0] + 5)
        self.assertIn("displacement", self.browser.run("return document.querySelector('label[for=scale]').textContent"))
        opening = self.browser.run("return document.querySelector('.stage canvas').openings().tip")
        self.assertLess(opening, 1e-5)

    def test_limits_fit_and_ticks_differ(self):
        """The last column of a table of limits is in sight on a laptop; what changes by rounding alone is a level line."""
        (FOLDER / "cantilever.toml").write_text(CANTILEVER)
        (FOLDER / "bar.toml").write_text(CANTILEVER_STUDY)
        self.show(folder_of("bar", "optimize", str(FOLDER / "bar.toml")))
        hidden = "return [...document.querySelectorAll('.scroll')].map((s) => s.scrollWidth - s.clientWidth).filter((w) => w > 0)"
        self.assertEqual(self.browser.run(hidden), [])
        self.browser.run(WRITTEN)
        self.browser.call("POST", "/window/rect", {"width": 1240, "height": 1000})  # they are drawn again
        self.browser.frames()
        written = self.browser.run("return written")
        self.assertIn("1", written)
        self.assertLessEqual(written.count("1"), 3 + 1, written)  # first cycle of three charts, one load

    def test_cycles_show_design_and_figures(self):
        self.show(rod())
        figure = "return document.querySelector('.figures').textContent + document.querySelector('.bars').textContent"
        last = self.browser.run(figure)
        self.slide("cycle", 0)
        first = self.browser.run(figure)
        self.assertNotEqual(first, last)
        self.assertIn("11.46", first, "every group starts at 11.46 mm")

    def test_dark_and_narrow(self):
        self.show(rod())
        light = self.picture()
        paper = "return getComputedStyle(document.body).backgroundColor"
        before = self.browser.run(paper)
        self.browser.run("document.getElementById('theme').click()")
        self.assertNotEqual(self.browser.run(paper), before)
        self.assertNotEqual(self.picture(), light)
        self.browser.devtools("Emulation.setEmulatedMedia",
                              features=[{"name": "prefers-color-scheme", "value": "dark"}])
        self.show(rod(), name="rod_dark")
        self.assertNotEqual(self.browser.run(paper), before, "as the system asks")
        self.browser.devtools("Emulation.setEmulatedMedia", features=[])
        self.browser.devtools("Emulation.setDeviceMetricsOverride", width=390, height=844,
                              deviceScaleFactor=1, mobile=True)
        self.show(rod(), name="rod_phone")
        wide = self.browser.run("return [document.documentElement.scrollWidth, innerWidth]")
        self.browser.devtools("Emulation.clearDeviceMetricsOverride")
        self.assertLessEqual(wide[0], 390)

    def on_paper(self):
        """The tables of cases as a sheet shows them."""
        browser = self.browser
        browser.devtools("Emulation.setDeviceMetricsOverride", width=SHEET, height=1030, deviceScaleFactor=1, mobile=False)
        browser.devtools("Emulation.setEmulatedMedia", media="print")
        browser.run("dispatchEvent(new Event('beforeprint'))")
        browser.frames()
        try:
            return browser.run(PAPER)
        finally:
            browser.devtools("Emulation.setEmulatedMedia", media="")
            browser.devtools("Emulation.clearDeviceMetricsOverride")
            browser.run("dispatchEvent(new Event('afterprint'))")

    def check_paper(self):
        paper = self.on_paper()
        self.assertGreater(paper["rows"], 2)
        self.assertLessEqual(paper["highest"], 60, paper)
        self.assertLessEqual(paper["right"], SHEET, paper)
        self.assertEqual(paper["screen"], "none")
        self.assertEqual(self.browser.run("return document.querySelectorAll('.paper table').length"), 0)

    def command(self):
        return self.browser.run("return [...document.querySelectorAll('dd')].map((d) => d.textContent).find((t) => t.startsWith('liesl '))")

    def test_columns_are_of_like_height(self):
        """No card would have been better placed in the other column."""
        self.show(rod(), name="rod_columns")
        columns = self.browser.run("return [...document.querySelectorAll('.columns > .column')].map((c) => [c.offsetHeight, c.lastChild.offsetHeight])")
        (left, last_left), (right, last_right) = columns
        self.assertLessEqual(left - last_left, right, columns)
        self.assertLessEqual(right - last_right, left, columns)
        room = self.browser.run("return [innerHeight - 28, document.querySelector('.stage').offsetHeight]")
        self.assertTrue(left >= min(right, room[0]) - 1 or room[1] >= 760, [columns, room])  # no gap below the picture
        sticky = self.browser.run("return [...document.querySelectorAll('.columns > .column')].map((c) => getComputedStyle(c).position)")
        self.assertEqual(sticky, ["sticky", "sticky"])

    def test_nothing_covers_the_cards_below_the_columns(self):
        """Whatever stays in sight beside the charts: each card can be brought to the middle of the window, and is on top there."""
        self.show(rod(), name="rod_cards")
        for width, height in ((1280, 1000), (1920, 1080)):
            self.browser.call("POST", "/window/rect", {"width": width, "height": height})
            self.browser.frames()
            cards = self.browser.run(COVERED)
            self.assertGreaterEqual(len(cards), 2, cards)
            self.assertFalse(any(card["covered"] for card in cards), [width, height, cards])

    def test_many_charts_are_folded_and_two_records_have_none(self):
        scene = (DATA / "scenes/pendulum.toml").read_text()
        more = "".join(f'tip{i} = {{ response = "position", at = "beam.end" }}\n' for i in range(12))
        file = FOLDER / "many.toml"
        file.write_text(scene.replace("[responses]\n", "[responses]\n" + more))
        self.show(folder_of("many", "run", str(file), "--set", "simulation.duration=0.05"))
        charts = "return document.querySelectorAll('.chart[data-chart]').length"
        self.assertEqual(self.browser.run(charts), 8)
        self.browser.run("document.querySelector('details.folded summary').click()")
        self.browser.frames()
        self.assertEqual(self.browser.run(charts), 15)
        self.assertGreater(self.browser.run("return Math.min(...[...document.querySelectorAll('details .uplot')].map((p) => p.clientWidth))"), 200)
        self.show(folder_of("truss", "optimize", str(DATA / "studies/truss_25.toml"), "--no-verify"))
        self.assertEqual(self.browser.run(charts), 0)
        header = "return [...document.querySelectorAll('th')].map((h) => h.textContent)"
        self.assertIn("at load factor", self.browser.run(header))
        self.assertNotIn("of the motion", self.browser.run("return document.body.innerText"))
        self.assertIn("--no-verify", self.command())

    def test_derivatives_of_long_keys_are_in_sight(self):
        """Keys that change together make a name as wide as half a page; it breaks behind its dots."""
        folder = FOLDER / "derivatives"
        done = liesl("sensitivity", str(DATA / "studies/sensitivity_four_bar.toml"), "-o", str(folder), "--quiet")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(liesl("report", str(folder)).returncode, 0)
        for width in (1280, 390):
            self.show(folder)
            self.browser.call("POST", "/window/rect", {"width": width, "height": 1000})
            self.browser.frames()
            last, card = self.browser.run("""const c = [...document.querySelectorAll('.card')].find((c) => c.textContent.startsWith('Derivatives'));
                const key = [...c.querySelectorAll('td.wrap')].find((d) => d.textContent.includes('+'));
                return [key.getBoundingClientRect().right, c.getBoundingClientRect().right];""")
            self.assertLess(last, card, f"{width} pixels")
        self.assertEqual(self.browser.run("return document.querySelector('[data-chart=rocker_angle] .legend b').textContent"), "0\xa0rad",
                         "no round-off of its peak")

    def test_keys_stay_as_they_are_at_the_beginning_of_a_reason(self):
        folder = FOLDER / "limited"
        shutil.copytree(rod(), folder)
        file = folder / "summary.json"
        summary = json.loads(file.read_text())
        summary["reason"] = "cycle.max = 3 is used up"
        file.write_text(json.dumps(summary))
        self.assertEqual(liesl("report", str(folder)).returncode, 0)
        self.show(folder)
        self.assertTrue(self.browser.run("return document.querySelector('.reason').textContent").startswith("cycle.max = 3 is used up."))

    def test_lean_model_is_told(self):
        folder = FOLDER / "lean"
        done = liesl("lean", str(DATA / "scenes/slider_crank.toml"), "--response", "bend", "-o", str(folder), "--quiet", "--set", "simulation.duration=0.01")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(liesl("report", str(folder)).returncode, 0)
        self.show(folder)
        titles = self.browser.run("return [...document.querySelectorAll('h2')].map((h) => h.textContent)")
        self.assertIn("Lean model", titles)
        self.assertIn("Decisions", titles)
        self.assertIn("--response bend", self.command())

    def test_methods_are_mass_against_time(self):
        self.show(folder_of("methods", "compare", str(DATA / "studies/compare_methods_rod.toml"), *METHODS))
        self.assertIn("Mass against time", self.browser.run("return [...document.querySelectorAll('h2')].map((h) => h.textContent)"))
        self.assertEqual(self.browser.run("return [...document.querySelectorAll('.legend > span')].map((s) => s.textContent)"), ["esl", "esl1"])
        tip = self.tip()
        for word in ("mass", "worst limit, above it", "KKT residual", "method"):
            self.assertIn(word, tip)
        self.check_paper()

    def tip(self):
        """What the first point says that the mouse meets."""
        return self.browser.run("""const c = document.querySelector('canvas.scatter'), r = c.getBoundingClientRect();
            for (let y = 0; y < r.height; y += 4) for (let x = 0; x < r.width; x += 4) {
              c.dispatchEvent(new MouseEvent('mousemove', { clientX: r.x + x, clientY: r.y + y, bubbles: true }));
              const t = document.querySelector('.tip'); if (!t.hidden) return t.textContent; }
            return '';""")

    def test_paper_is_light_and_whole(self):
        """Printed from a dark screen: light, two charts beside each other, no slider, every row."""
        browser = self.browser
        self.show(rod())
        browser.run("document.getElementById('theme').click()")
        browser.frames()
        dark = browser.run(HASH)
        browser.run("dispatchEvent(new Event('beforeprint'))")
        widths = browser.run("return [...document.querySelectorAll('.uplot')].map((p) => p.clientWidth)")
        self.assertTrue(widths and max(widths) < 350, widths)
        browser.devtools("Emulation.setEmulatedMedia", media="print")
        browser.frames()
        try:
            self.assertEqual(browser.run("return getComputedStyle(document.body).backgroundColor"), "rgb(255, 255, 255)")
            self.assertNotEqual(browser.run(HASH), dark, "the picture is light, too")
            hidden = browser.run("return [...document.querySelectorAll('.controls')].map((c) => getComputedStyle(c).display)")
            self.assertEqual(set(hidden), {"none"})
            self.assertRegex(browser.run("return document.querySelector('.printed').textContent"), r"time .* deformation")
            pages = base64.b64decode(browser.devtools("Page.printToPDF", printBackground=True)["data"])
            self.assertEqual(pages[:4], b"%PDF")
            self.assertLessEqual(len(re.findall(rb"/Type\s*/Page\b", pages)), 3, "sheets")
        finally:
            browser.devtools("Emulation.setEmulatedMedia", media="")
            browser.run("dispatchEvent(new Event('afterprint'))")
        browser.frames()
        self.assertEqual(browser.run("return document.documentElement.dataset.theme"), "dark", "as it was before")

    def written(self, folder):
        """Seconds that `liesl report` takes."""
        begin = time.monotonic()
        self.assertEqual(liesl("report", str(folder)).returncode, 0)
        took = time.monotonic() - begin
        print(f"{folder.name}: written in {took:.2f} s")
        return took

    def test_the_page_of_the_rod_is_written_in_time(self):
        self.assertLess(self.written(Path(shutil.copytree(rod(), FOLDER / "rod"))), MARGIN * 0.3)

    def test_lattice_in_time_and_size(self):
        """A meshed arm with openings: 4 MB, 4 s, and how many pictures a second while it plays."""
        folder = folder_of("lattice", "run", str(DATA / "scenes/robot_arm_lattice.toml"))
        self.assertLess(self.written(folder), MARGIN * 1)
        self.show(folder, 4)
        self.assertLess((folder / "report.html").stat().st_size, 4e6)
        self.assertGreater(self.playing("lattice"), 12 / MARGIN)

    def test_an_outline_under_fixed_loads_is_seen_in_space(self):
        text = (DATA / "studies/plate_with_hole.toml").read_text()
        for load in ("along_x", "along_y"):
            text = text.replace(f"{load} = {{", f'{load} = {{ case = "{load}",')
        file = FOLDER / "plate.toml"
        file.write_text(text.replace("../parts", str(DATA / "parts")))
        folder = folder_of("plate", "optimize", str(file), "--set", "scene.bodies.plate.solid.mesh.cells=[40,40]")
        self.show(folder)
        self.assertGreater(self.browser.run(SATURATED), 3000, "the stress has colours")
        name = lambda: self.browser.run("return document.getElementById('instant').textContent")  # noqa: E731
        self.assertIn(name(), ("along_x", "along_y"))
        self.slide("time", 0)
        first, along_x = name(), self.picture()
        legend = lambda: self.browser.run("return [...document.querySelectorAll('.viewer .legend > span')].map((s) => s.textContent)")  # noqa: E731
        held = ["\u25b2 held: x_min (x)", "\u25b2 held: y_min (y)"]
        acts = {"along_x": "\u2192 along_x: 1000\u00a0kN on x_max", "along_y": "\u2192 along_y: 500\u00a0kN on y_max"}
        self.assertEqual(legend(), [*held, acts[first]])
        self.assertEqual(self.browser.run("return document.querySelector('.viewer canvas').dataset.arrows"), "9")
        self.slide("time", 1)
        self.assertEqual({first, name()}, {"along_x", "along_y"})
        self.assertEqual(legend(), [*held, acts[name()]])
        seen = [along_x, self.picture()]
        for what, value in (("scale", 0), ("colour", "displacement"), ("colour", "")):
            self.slide(what, value)
            seen.append(self.picture())
        self.assertEqual(len(set(seen)), len(seen))
        self.slide("scale", 3)
        still = self.picture()
        self.browser.run("document.getElementById('play').click()")
        time.sleep(0.6)
        self.assertNotEqual(self.picture(), still, "the load comes and goes")
        self.browser.run("document.getElementById('play').click()")
        self.assertEqual(self.picture(), still, "and is whole when it stands")

    def test_meshed_part_moves_and_is_coloured(self):
        folder = folder_of("meshed", "run", str(DATA / "scenes/meshed_slider_crank.toml"),
                           "--set", "simulation.duration=0.03")
        self.show(folder, 4)
        self.assertGreater(self.browser.run(SATURATED), 3000)
        seen = [self.picture()]
        for name, value in (("time", 0.3), ("scale", 0), ("colour", "")):
            self.slide(name, value)
            seen.append(self.picture())
        self.assertEqual(len(set(seen)), len(seen))

    def test_modes_swing(self):
        folder = folder_of("modes", "run", str(DATA / "scenes/four_bar.toml"), "--set",
                           'simulation.type="modes"')
        self.show(folder)
        first = self.picture()
        time.sleep(0.5)
        self.assertNotEqual(self.picture(), first)
        name = self.browser.run("return document.getElementById('instant').textContent")
        self.assertEqual(self.browser.run("const s = document.getElementById('scale'); return [s.min, s.max]"), ["-1", "1"])
        self.assertIn("displacement", self.browser.run("return document.querySelector('.colours').textContent"))
        self.slide("time", 1)
        self.assertNotEqual(self.browser.run("return document.getElementById('instant').textContent"), name)
        self.assertTrue(name.startswith("1: "), name)
        self.browser.run("document.querySelectorAll('tr.opens')[2].click()")
        self.browser.frames()
        self.assertTrue(self.browser.run("return document.getElementById('instant').textContent").startswith("3: "))
        self.assertEqual(self.browser.run("return document.querySelector('tr[aria-current=true] td').textContent"), "3")
        self.assertRegex(self.browser.run("return document.querySelector('.reason').textContent"), r"^\d+ modes found")

    def test_charts_tell_units_and_what_stays_zero(self):
        self.show(rod(), name="rod_charts")
        legend = "return document.querySelector(`[data-chart=\"${arguments[0]}\"] .legend`).textContent"
        bending = self.browser.run(legend, "bending")
        self.assertRegex(bending, r"limit 1\smm")
        self.assertRegex(bending, r"error of the peak by mesh and step ± [\d.]+\sµm")
        self.assertNotRegex(self.browser.run("return document.querySelector('header').textContent"), r"\s-\d|\+-|\de-")
        self.assertEqual(self.browser.run("return document.querySelectorAll('[data-chart=energies] .swatch.dashed').length"), 1,
                         "the total lets the kinetic energy show")
        self.show(folder_of("swing", "run", str(DATA / "scenes/pendulum.toml"), "--set", "simulation.duration=0.05"))
        tip = self.browser.run(legend, "tip")
        self.assertIn("tip.z: 0 throughout", tip)
        self.assertEqual(self.browser.run("return document.querySelectorAll('[data-chart=tip] .swatch').length"), 2)

    def test_tables_of_a_phone_show_where_they_go_on(self):
        self.browser.devtools("Emulation.setDeviceMetricsOverride", width=390, height=844, deviceScaleFactor=1, mobile=True)
        self.show(rod(), name="rod_phone_tables")
        bar = self.browser.run("""const b = document.querySelector('.bounds').getBoundingClientRect();
            return [b.right, document.querySelector('.bounds').closest('.scroll').getBoundingClientRect().right];""")
        shade = self.browser.run("return getComputedStyle(document.querySelector('.scroll')).backgroundAttachment")
        self.browser.devtools("Emulation.clearDeviceMetricsOverride")
        self.assertLessEqual(bar[0], bar[1], "the bounds are in sight")
        self.assertEqual(shade, "local, local, scroll, scroll")

    def test_batch_filters_sorts_and_opens(self):
        file = FOLDER / "batch.toml"
        file.write_text(BATCH.format(study=DATA / "studies/slider_crank_rod.toml"))
        self.show(folder_of("batch", "batch", str(file)))
        rows = "return document.querySelectorAll('#cases tbody tr').length"
        self.assertEqual(self.browser.run(rows), 4)
        self.check_paper()
        self.slide("filter", "speed > 130")
        self.assertEqual(self.browser.run(rows), 2)
        heads = self.browser.run("return [...document.querySelectorAll('#cases th')].map((h) => h.textContent)")
        self.assertTrue({"mass before [g]", "mass after [g]", "bending, above its limit [%]", "KKT residual"} <= set(heads), heads)
        over = heads.index("worst limit, above it [%]")
        case, cell = (self.browser.run(f"return document.querySelector('#cases tbody tr').children[{i}].textContent") for i in (0, over))
        shown = float(cell.replace("\u2212", "-").replace("\u00d710", "e").translate(SUPERSCRIPTS))
        with (FOLDER / "batch/results.csv").open(encoding="utf-8") as table:
            share = next(float(row["worst_constraint [-]"]) for row in csv.DictReader(table) if row["case"] == case)
        self.assertAlmostEqual(shown / (100 * share), 1, delta=1e-3)
        self.slide("filter", "mass after > 10")  # in the unit of the heading: g, not kg
        self.assertEqual(self.browser.run(rows), 4)
        self.slide("filter", "mass_final > 10")
        self.assertEqual(self.browser.run(rows), 0)
        note = "return document.querySelector('.controls.two .note').textContent"
        self.assertEqual(self.browser.run(note), "0 of 4")
        self.slide("filter", "speed > 130 and xyz > 3")
        self.assertEqual(self.browser.run(note), "0 of 4; there is no column 'xyz'")
        self.slide("filter", "speed > 130, cycles > 3")
        self.assertIn("'130, cycles > 3' is no number", self.browser.run(note))
        self.slide("filter", "")
        masses = """const h = [...document.querySelectorAll('#cases th')], i = h.findIndex((x) => x.textContent.startsWith('mass after'));
            h[i].click(); return [...document.querySelectorAll('#cases tbody tr')].map((r) => parseFloat(r.children[i].textContent));"""
        sorted_up = self.browser.run(masses)
        self.assertEqual(sorted_up, sorted(sorted_up))
        self.assertEqual(self.browser.run(masses), sorted(sorted_up, reverse=True))
        before = self.browser.run("return document.querySelector('canvas.scatter').toDataURL()")
        self.slide("scatter-c", "mass_final")
        self.assertRegex(self.browser.run("return document.querySelector('.controls .colours').textContent"), r"\d g$")
        self.browser.run(WRITTEN)
        self.slide("scatter-y", "mass_final")
        self.assertIn("mass after [g]", self.browser.run("return written"))  # as in the table
        self.slide("scatter-y", "cycles")
        self.assertNotEqual(self.browser.run("return document.querySelector('canvas.scatter').toDataURL()"), before)
        self.focus("canvas.scatter")
        told = []
        for key in ("Home", "ArrowRight", "ArrowUp", "End", "Escape"):
            self.browser.press(key)
            told.append(self.browser.run("const t = document.querySelector('.tip'); return t.hidden ? '' : t.textContent"))
        self.assertTrue(all("case " in tip for tip in told[:4]) and told[4] == "", told)
        self.assertNotEqual(told[0], told[1])
        self.browser.press("Home", "Enter")
        self.browser.wait(lambda: "/cases/" in self.browser.run("return location.href"), "the case of a point")
        self.show(FOLDER / "batch")
        self.browser.run("document.querySelector('#cases tbody tr').click()")
        self.browser.wait(lambda: "/cases/" in self.browser.run("return location.href"), "the case")
        self.browser.wait(lambda: self.browser.run("return document.documentElement.dataset.ready"), "its page")
        self.assertRegex(self.browser.run("return document.title"), r"^slider-crank, rod: case \S+ – liesl optimize$")
        self.browser.run("document.querySelector('header nav a').click()")
        self.browser.wait(lambda: "/cases/" not in self.browser.run("return location.href"), "back to the batch")

    def test_a_case_without_a_page_says_how_to_get_it(self):
        file = FOLDER / "unpaged.toml"
        file.write_text(f'name = "two"\nscene = "{DATA}/scenes/pendulum.toml"\n'
                        '[grid]\nduration = { key = "simulation.duration", values = [0.01, 0.02] }\n')
        folder = FOLDER / "unpaged"
        self.assertEqual(liesl("batch", str(file), "-o", str(folder), "--quiet", "--no-report").returncode, 0)
        self.assertEqual(liesl("report", str(folder)).returncode, 0)
        self.show(folder)
        self.browser.run("document.querySelector('#cases tbody tr').click()")
        said = "return document.getElementById('said').textContent"
        self.assertIn("liesl report unpaged/cases/1", self.browser.run(said))
        # A point, whose table is further down: its figures come into sight.
        self.focus("canvas.scatter")
        self.browser.press("End", "Enter")
        text = self.browser.run(said)
        for figure in ("Case 2", "duration", "20 ms", "liesl report unpaged/cases/2"):
            self.assertIn(figure, text)
        self.assertTrue(self.browser.run("const r = document.getElementById('said').getBoundingClientRect(); return r.top >= 0 && r.top < innerHeight"))
        self.assertNotIn("/cases/", self.browser.run("return location.href"))
        self.assertEqual(liesl("report", str(folder / "cases/1")).returncode, 0)
        self.assertEqual(liesl("report", str(folder)).returncode, 0)
        self.show(folder)
        self.browser.run("document.querySelector('#cases tbody tr').click()")
        self.browser.wait(lambda: "/cases/1/" in self.browser.run("return location.href"), "the case")

    def test_a_batch_of_which_no_case_has_ended_says_so(self):
        """Here because its cases belong to another shard."""
        file = FOLDER / "one.toml"
        file.write_text(f'name = "one"\nscene = "{DATA}/scenes/pendulum.toml"\n'
                        '[grid]\nduration = { key = "simulation.duration", values = [0.01] }\n')
        self.show(folder_of("other_shard", "batch", str(file), "--shard", "2/2"))
        text = self.browser.run("return document.querySelector('main').textContent")
        self.assertIn("no case has ended yet", text)
        self.assertNotIn("two columns", text.lower())

    def test_comparison_tells_its_points(self):
        file = FOLDER / "compare.toml"
        file.write_text(COMPARE.format(scene=DATA / "scenes/slider_crank.toml"))
        self.show(folder_of("compare", "compare", str(file)))
        tip = self.tip()
        self.assertIn("error", tip)
        self.assertIn("formalism", tip)
        self.assertNotIn("m or rad", self.browser.run("return document.getElementById('cases').textContent"), "a number of several units has none")

    def test_text_of_a_scene_stays_text(self):
        evil = "</script><img src=x onerror=document.title='run'>"
        scene = (DATA / "scenes/pendulum.toml").read_text()
        file = FOLDER / "evil.toml"
        lines = [line for line in scene.splitlines() if not line.startswith("name")]
        file.write_text("\n".join([f'name = "{evil}"', *lines]) + "\n")
        self.show(folder_of("evil", "run", str(file), "--set", "simulation.duration=0.01"))
        self.assertEqual(self.browser.run("return document.querySelectorAll('img').length"), 0)
        self.assertIn(evil, self.browser.run("return document.querySelector('h1').textContent"))

    def test_nothing_may_be_loaded(self):
        self.show(rod())
        blocked = self.browser.call("POST", "/execute/async", {"script": """
            const done = arguments[0];
            document.addEventListener('securitypolicyviolation', (e) => done(e.effectiveDirective));
            fetch('data:text/plain,x').catch(() => {}); setTimeout(() => done(''), 2000);""", "args": []})
        self.assertEqual(blocked, "connect-src")


if __name__ == "__main__":
    if programs() is None:
        print("skipped: no chromium with its driver; apt-get install chromium chromium-driver", file=sys.stderr)
        sys.exit(77)
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]], verbosity=1)
