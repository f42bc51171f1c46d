#!/usr/bin/env python3
"""plot.py draws synthetic results of every kind, and refuses what it cannot draw.

plot_test.py [DIR]  keeps the pictures in DIR, to be looked at.
"""

import csv
import json
import math
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PLOT = Path(__file__).parents[2] / "apps" / "plot" / "plot.py"
sys.path.insert(0, str(PLOT.parent))
KEEP = None


def write_csv(path, header, rows):
    with open(path, "w", newline="", encoding="utf-8") as file:
        csv.writer(file, lineterminator="\n").writerows([header, *rows])


PLACE = ["x [m]", "y [m]", "z [m]", "bending x [m]", "bending y [m]", "bending z [m]"]


def write_frames(folder, abscissa, rows):
    """@param rows with or without bending"""
    write_csv(folder / "frames.csv", [abscissa, "body", "kind", "node", *PLACE], [row + [0] * (10 - len(row)) for row in rows])


def times(n=400, end=0.12):
    return [end * i / (n - 1) for i in range(n)]


def write_slider_crank_frames(folder, crank=0.15, rod=0.3):
    rows = []
    for t in times(13, 0.042):
        a = 150 * t
        pin = (crank * math.cos(a), crank * math.sin(a))
        slider = pin[0] + math.sqrt(rod**2 - pin[1] ** 2)
        for k in range(9):
            s = k / 8
            rows.append([t, "crank", "beam", k, s * pin[0], s * pin[1], 0])
        for k in range(9):
            s = k / 8
            bow = 0.004 * math.sin(math.pi * s) * math.sin(a)
            rows.append([t, "rod", "beam", k, pin[0] + s * (slider - pin[0]),
                         (1 - s) * pin[1] + bow, 0, 0, bow, 0])
        rows.append([t, "slider", "rigid", 0, slider, 0, 0])
        rows.append([t, "plate", "solid", 0, 0.4, 0, 0])
    write_frames(folder, "time [s]", rows)


def write_shapes(folder):
    """A crank thick enough to be seen, a rod that is not; a plate with a hole fixed to the ground; a slider with a pin, and its
    path."""
    write_csv(folder / "sections.csv", ["body", "element", "along x [m]", "along y [m]", "along z [m]"],
              [["crank", e, 0.02, 0.02, 0.02] for e in range(8)] + [["rod", e, 1e-4, 1e-4, 1e-4] for e in range(8)])
    square = lambda h: [(-h, -h), (h, -h), (h, h), (-h, h), (-h, -h)]  # noqa: E731
    write_csv(folder / "part_lines.csv", ["time [s]", "body", "line", *PLACE],
              [[t, "plate", line, 0.4 + x, y, 0, 0, 1e-3 * x, 0] for t in times(13, 0.042)[::3]
               for line, points in ((0, square(0.03)), (1, square(0.01)[::-1])) for x, y in points] +
              [[t, "slider", 0, 0.3, y, 0, 0, 0, 0] for t in times(13, 0.042)[::3] for y in (0, 0.02)])
    write_csv(folder / "rigid_paths.csv", ["time [s]", "body", "x [m]", "y [m]", "z [m]"],
              [[t, "slider", 0.3 + 0.15 * math.cos(150 * t), 0, 0] for t in times(200, 0.042)])


def write_run(folder):
    write_csv(folder / "responses.csv",
              ["time [s]", "bend [m]", "slider_x [m]", "tip.x [m]", "tip.y [m]", "tip.z [m]",
               "sigma [Pa]"],
              [[t, 1.8e-3 * math.sin(300 * t) * math.cos(40 * t), 0.3 + 0.15 * math.cos(150 * t),
                0.3 * math.cos(150 * t), 0.3 * math.sin(150 * t), 0.001 * t, 2.4e8 * t]
               for t in times()])
    write_csv(folder / "energies.csv",
              ["time [s]", "kinetic [J]", "elastic [J]", "potential [J]", "dissipated [J]",
               "total [J]", "constraint_residual [m or rad]"],
              [[t, 30 * math.sin(150 * t) ** 2, 0.2 * math.sin(300 * t) ** 2, math.sin(150 * t),
                1e-3 * t, 30 * math.sin(150 * t) ** 2 + math.sin(150 * t), 1e-14] for t in times()])
    write_slider_crank_frames(folder)
    (folder / "summary.json").write_text(json.dumps({"name": "slider-crank", "status": "done"}))


def write_optimize(folder):
    write_run(folder)
    for name, size in (("initial", 0.6e-3), ("final", 1e-3)):
        write_csv(folder / f"responses_{name}.csv",
                  ["time [s]", "bending [m]", "other [m]", "stress [Pa]"],
                  [[t, size * math.sin(300 * t) * math.cos(40 * t), 0,
                    5e4 * size * 1e6 * (1 + math.sin(150 * t))] for t in times()])
    rows = []
    for body, groups, unit_length in (("rod", 4, 0.3 / 8), ("crank", 8, 0.15 / 8)):
        for e in range(8):
            g = e * groups // 8
            final = 0.0062 + 0.0022 * math.sin(math.pi * (g + 0.5) / groups)
            rows.append([f"{body}_diameters[{g}]", body, e, e * unit_length, (e + 1) * unit_length,
                         0.01, final, 0.004, 0.012 if body == "rod" else 0.05, "m"])
    write_csv(folder / "design.csv", ["variable", "body", "element", "s0 [m]", "s1 [m]", "initial",
                                      "final", "lower", "upper", "unit"], rows)
    history = [dict(cycle=c + 1, mass=0.19 * (0.62 + 0.38 * 0.3**c),
                    worst_constraint=[-0.45, 0.31, 0.04, 0.003, 2e-4, -1e-6][c],
                    load_change=None if c == 0 else 0.4 * 0.2**c) for c in range(6)]
    constraints = {"bending": dict(limit=1e-3, unit="m"), "stress": dict(limit=1.2e8, unit="Pa")}
    (folder / "summary.json").write_text(json.dumps(
        {"name": "slider-crank rod", "status": "converged", "history": history,
         "constraints": constraints, "refinement": {"holds": True, "steps": [{"cycles": 3}]}}))


def write_spatial(folder):
    """A beam that bends out of its plane, load by load."""
    rows = []
    for load in times(6, 1.0):
        for k in range(9):
            a = math.pi / 4 * k / 8
            rows.append([load, "arc", "beam", k, 100 * math.sin(a) * (1 - 0.3 * load * (k / 8) ** 2),
                         100 * (1 - math.cos(a)), 55 * load * (k / 8) ** 2])
    write_frames(folder, "load_factor [-]", rows)
    write_csv(folder / "responses.csv", ["load_factor [-]", "tip.x [m]", "tip.y [m]", "tip.z [m]"],
              [[load, -20 * load, -10 * load, 55 * load] for load in times(6, 1.0)])
    (folder / "summary.json").write_text(json.dumps({"name": "bend45", "status": "done"}))


def write_batch(folder):
    rows = []
    for speed in (100, 150):
        for limit in (1e-3, 2e-3, "wide"):
            rows.append([len(rows) + 1, speed, limit, "converged", "a, reason", 0.2, 1e-3])
    rows[3][3:] = ["crashed", "signal 11", "", ""]
    write_csv(folder / "results.csv", ["case", "speed", "limit", "status", "reason",
                                       "mass_final [kg]", "bend.max_abs [m]"], rows)
    (folder / "summary.json").write_text(json.dumps({"name": "rods", "status": "done"}))


def write_comparison(folder):
    """Errors of second order in the step and the mesh, over a floor; the stiffest one stops."""
    rows = []
    for kind, factor in (("se3", 1), ("r3so3", 0.3), ("classical", 0.31)):
        for n in (4, 8, 16):
            for h in (4e-3, 2e-3, 1e-3):
                for stiffness in (1e2, 1e4, 1e6):
                    stopped = stiffness * h > 2e3 and kind == "classical"
                    status = "stopped" if stopped else "recovered" if h > 3e-3 else "converged"
                    steps = round(1 / h)
                    rows.append([len(rows) + 1, kind, n, h, stiffness, status,
                                 "" if stopped else factor * 1e3 * h * h + 0.1 / n**2,
                                 "" if stopped else 1e-5 * n / h * (3 if kind == "classical" else 1),
                                 "" if stopped else 0.1, steps, 3 * steps, 0, 0,
                                 3 * steps if kind == "classical" else 1, "", "", "", 1e-12,
                                 1e-5, "did not converge, at 0.1 s" if stopped else ""])
    write_csv(folder / "rows.csv",
              ["run", "formalism", "elements", "step [s]", "stiffness [N/m]", "status", "error [m]",
               "cpu_s [s]", "cpu_spread [-]", "steps", "newton_iterations", "tangent_refreshes",
               "rejected_steps", "factorizations", "energy_drift [J]", "momentum_drift [N s]",
               "angular_momentum_drift [N m s]", "constraint_residual [m or rad]", "floor [m]",
               "reason"], rows)
    (folder / "summary.json").write_text(json.dumps(
        {"command": "compare", "name": "three formalisms", "response": "tip", "norm": "rms"}))


def write_methods(folder):
    """Optimisations by three methods, one that was stopped."""
    rows = [[k + 1, method, treatment, "optimal" if method != "esl" else "converged", 6 + k, k,
             0.3 + 0.2 * k, 0.21 + 0.002 * (method == "esl"), -1e-5, 0.37 if method == "esl" else
             0.003, ""] for k, (method, treatment) in enumerate(
                 (m, t) for m in ("esl", "esl1", "full") for t in ("auto", "maxima"))]
    rows.append([7, "full", "worst", "stopped", 9, 8, 60, "", "", "", "more than 60 s"])
    write_csv(folder / "rows.csv",
              ["run", "method", "treatment", "status", "simulations", "sensitivities", "cpu_s [s]",
               "mass [kg]", "violation [-]", "kkt [-]", "reason"], rows)
    (folder / "summary.json").write_text(json.dumps({"command": "compare", "name": "methods"}))


def write_part(folder, gain=True):
    """A plate of 20 x 10 cells with a slot in it, over two steps."""
    rows = []
    for i in range(20):
        for j in range(10):
            corners = [c for x, y in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1))
                       for c in (0.01 * x, 0.01 * y)]
            full = not (5 <= i < 9 and 4 <= j < 6)
            rows.append([*corners, float(full), 1e6 * i * full,
                         *([(7850 - 200 * i * j) * full] if gain else [])])
    write_csv(folder / "plate_cells.csv",
              [f"{axis}{c} [m]" for c in range(4) for axis in "xy"]
              + ["fraction", "stress [Pa]"] + ["hole_gain [kg/m^3]"] * gain, rows)
    write_csv(folder / "plate_outlines.csv", ["step", "line", "x [m]", "y [m]"],
              [[step, 0, x, y] for step in (1, 2)
               for x, y in ((0, 0), (0.2, 0), (0.2, 0.09 + 0.005 * step), (0, 0.1))])
    nucleus = {"place": [0.15, 0.03, 0], "radius": 0.02, "gain": 6000}
    (folder / "summary.json").write_text(json.dumps(
        {"name": "plate", "status": "converged", "nucleation": {"next": nucleus if gain else None}}))


def write_map(folder):
    """A bowl and a limit over two variables, a local model beside them, one design that failed."""
    rows = []
    for j in range(9):
        for i in range(9):
            a, b = 0.005 + 0.001 * i, 0.005 + 0.001 * j
            mass, bend = 1e3 * (a * a + b * b), 1e-7 / (a * b)
            cells = [mass, mass, bend, 1.1 * bend, ""]
            rows.append([a, b, *(["", "", "", "", "did not converge"] if i == j == 0 else cells)])
    write_csv(folder / "map.csv", ["a [m]", "b [m]", "mass [kg]", "mass local [kg]", "bend [m]",
                                   "bend local [m]", "reason"], rows)
    write_csv(folder / "path.csv", ["cycle", "a [m]", "b [m]"],
              [[1, 0.012, 0.012], [2, 0.01, 0.009], [3, 0.0101, 0.0099]])
    (folder / "summary.json").write_text(json.dumps(
        {"command": "map", "name": "rod", "status": "done", "centre": {"a": 0.01, "b": 0.01},
         "of": {"mass": {"unit": "kg", "limit": None}, "bend": {"unit": "m", "limit": 1e-3}}}))


def plot(folder, *more):
    return subprocess.run([sys.executable, PLOT, folder, *more], capture_output=True, text=True,
                          check=False)


class Plot(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = Path(self.temporary.name)
        if KEEP:
            self.folder = KEEP / self.id().split(".")[-1]
            self.folder.mkdir(parents=True, exist_ok=True)

    def tearDown(self):
        self.temporary.cleanup()

    def draws(self, write, names, *more):
        write(self.folder)
        done = plot(self.folder, *more)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stderr, "")
        expected = {f"{name}.{kind}" for name in names for kind in ("png", "svg")}
        self.assertEqual({Path(line).name for line in done.stdout.split()}, expected)
        self.assertEqual({p.name for p in (self.folder / "plots").iterdir()}, expected)
        for path in (self.folder / "plots").glob("*.png"):
            self.assertEqual(path.read_bytes()[:4], b"\x89PNG")
            self.assertGreater(path.stat().st_size, 10_000)

    def refuses(self, *words, options=()):
        done = plot(self.folder, *options)
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stdout, "")
        for word in words:
            self.assertIn(word, done.stderr)
        self.assertNotIn("Traceback", done.stderr)

    def test_methods(self):
        self.draws(write_methods, ["methods"])

    def test_masses_are_shown_about_the_optimum_that_most_rows_end_at(self):
        """Of another limit, as p_norm, there is a lighter one."""
        from comparisons import masses_about_optimum
        rows = [{"mass": mass, "status": status} for mass, status in
                (("0.90464", "optimal"), ("0.90466", "optimal"), ("0.90781", "converged"), ("0.4277", "optimal"),
                 ("", "stopped"))]
        low, high = masses_about_optimum(rows)
        self.assertTrue(0.9 < low < 0.90464 and 0.90781 < high < 0.91, f"{low}, {high}")

    def test_map(self):
        self.draws(write_map, ["map"])

    def test_run(self):
        self.draws(write_run, ["responses", "energies", "mechanism"])

    def test_mechanism_shows_thickness_and_outlines(self):
        self.draws(lambda folder: (write_run(folder), write_shapes(folder)), ["responses", "energies", "mechanism"])
        svg = (self.folder / "plots/mechanism.svg").read_text(encoding="utf-8")
        for mark in ("beam, true thickness", "beam, its axis", "meshed part, its outline", "rigid body",
                     "paths of rigid bodies", "ends of a body", "t = 0 s"):
            self.assertIn(f"<!-- {mark} -->", svg)
        write_run(self.folder)
        (self.folder / "sections.csv").unlink(), (self.folder / "part_lines.csv").unlink()
        self.assertEqual(plot(self.folder).returncode, 0)
        self.assertNotIn("true thickness", (self.folder / "plots/mechanism.svg").read_text(encoding="utf-8"))

    def test_instants_have_the_peak_among_them(self):
        import mechanism as drawn  # noqa: PLC0415
        instants = [(0.1 * n, {}) for n in range(13)]
        at = lambda peak: [round(t, 9) for t, _ in drawn.few(instants, peak)]  # noqa: E731
        self.assertEqual(at(None), [0, 0.3, 0.6, 0.9, 1.2])
        self.assertEqual(at(0.41), [0, 0.4, 0.6, 0.9, 1.2])
        self.assertEqual(at(0.09), [0, 0.1, 0.6, 0.9, 1.2])
        self.assertEqual(at(9), at(None))
        worst = {"a": {"violation": -0.1, "at_time": 1}, "b": {"violation": 0, "at_time": 2}}
        self.assertEqual(drawn.peak_of({"constraints": worst, "responses": {"r": {"at_time": 3}}}), 2)
        self.assertEqual(drawn.peak_of({"constraints": {}, "responses": {"r": {"at_time": 3}}}), 3)
        self.assertIsNone(drawn.peak_of({}))

    def test_a_rigid_body_reaches_to_its_joints(self):
        write_run(self.folder)
        self.assertEqual(plot(self.folder).returncode, 0)
        before = (self.folder / "plots/mechanism.svg").read_text(encoding="utf-8")
        write_shapes(self.folder)
        self.assertEqual(plot(self.folder).returncode, 0)
        after = (self.folder / "plots/mechanism.svg").read_text(encoding="utf-8")
        self.assertGreater(len(after), len(before) + 2000)  # a path of 200 points in place of 13
        self.assertIn("<!-- rigid body -->", after)

    def test_optimize(self):
        self.draws(write_optimize, ["overview", "cycle_history", "response_before_after", "design",
                                    "responses", "energies", "mechanism"])

    def test_overview_shows_the_governing_limit_and_the_designs(self):
        def written():
            self.assertEqual(plot(self.folder).returncode, 0)
            return re.findall(r"<!-- (.+?) -->", (self.folder / "plots/overview.svg").read_text(encoding="utf-8"))
        write_optimize(self.folder)
        summary = json.loads((self.folder / "summary.json").read_text())
        for worst, other in (("stress", "bending"), ("bending", "stress")):
            summary["constraints"][worst]["violation"], summary["constraints"][other]["violation"] = 1e-4, -0.4
            (self.folder / "summary.json").write_text(json.dumps(summary))
            labels = written()
            self.assertTrue(any(text.startswith(f"{worst} [") for text in labels), labels)
            self.assertFalse(any(text.startswith(f"{other} [") for text in labels), labels)
        self.assertTrue({"along rod [m]", "along crank [m]"} <= set(labels), labels)

    def test_band_of_an_error(self):
        """As wide as the error by mesh and step, around the line; as that in all, where it is known."""
        def picture(error):
            write_run(self.folder)
            (self.folder / "summary.json").write_text(json.dumps(
                {"name": "slider-crank", "status": "done", "responses": {"bend": error}}))
            plot(self.folder)
            return (self.folder / "plots" / "responses.svg").read_text()
        error = {"error": {"mesh": 1e-4, "step": 2e-5}}
        bands = [picture(e).count("PolyCollection_") for e in ({}, error)]
        self.assertEqual(bands, [0, 1])
        whole = {"error": {**error["error"], "total": 8e-5, "end": {"mesh": 1e-5, "step": 1e-6}}}  # of run --verify
        shape = re.compile(r'<g id="PolyCollection_1">.*?</g>', re.S)
        self.assertEqual(*(shape.search(picture(e)).group() for e in ({"error": {"mesh": 8e-5}}, whole)))
        self.assertNotEqual(*(shape.search(picture(e)).group() for e in (error, whole)))

    def test_part(self):
        self.draws(write_part, ["plate_outlines", "plate_fraction", "plate_stress",
                                "plate_hole_gain"])

    def test_part_without_gains(self):
        self.draws(lambda folder: write_part(folder, gain=False),
                   ["plate_outlines", "plate_fraction", "plate_stress"])

    def test_spatial_statics(self):
        self.draws(write_spatial, ["responses", "mechanism"])

    def test_beams_in_space_are_as_thick_as_they_are(self):
        """Round ones truly, others by the mean of their two thicknesses; those too thin to be seen are lines."""
        def marks(seen):
            write_spatial(self.folder)
            write_csv(self.folder / "sections.csv", ["body", "element", "along x [m]", "along y [m]", "along z [m]"],
                      [["arc", e, *seen] for e in range(8)])
            self.assertEqual(plot(self.folder).returncode, 0)
            svg = (self.folder / "plots/mechanism.svg").read_text(encoding="utf-8")
            return [mark for mark in ("true thickness", "mean thickness", "its axis") if f"<!-- beam, {mark} -->" in svg]
        self.assertEqual(marks((4, 4, 4)), ["true thickness"])
        self.assertEqual(marks((4, 4, 2)), ["mean thickness"])
        self.assertEqual(marks((0.1, 0.1, 0.1)), ["its axis"])
        import mechanism as drawn  # noqa: PLC0415
        sides = drawn.tube((1, 2, 3), (4, 6, 3), 0.5)
        self.assertEqual(len(sides), drawn.SIDES)
        for side in sides:
            for corner, end in zip(side, ((1, 2, 3), (1, 2, 3), (4, 6, 3), (4, 6, 3))):
                out = [p - q for p, q in zip(corner, end)]
                self.assertAlmostEqual(math.hypot(*out), 0.25)
                self.assertAlmostEqual(3 * out[0] + 4 * out[1], 0)
        self.assertEqual(drawn.tube((1, 2, 3), (1, 2, 3), 0.5), [])

    def test_one_cycle_only(self):
        def write(folder):
            (folder / "summary.json").write_text(json.dumps({"name": "x", "history": [
                dict(cycle=1, mass=0.1, worst_constraint=None, load_change=None)]}))
        self.draws(write, ["cycle_history"])

    def test_batch(self):
        self.draws(write_batch, ["mass_final_over_speed", "mass_final_over_limit"])

    def test_batch_of_which_nothing_has_ended(self):
        """Killed before its first case had ended, or after it."""
        def keep(rows):
            write_batch(self.folder)
            path = self.folder / "results.csv"
            path.write_text("".join(path.read_text().splitlines(keepends=True)[:rows + 1]))
            summary = {"command": "batch", "name": "rods", "status": "running"}
            (self.folder / "summary.json").write_text(json.dumps(summary))
        keep(0)
        self.refuses("no case has ended yet; the same liesl batch command goes on")
        self.refuses("no case has ended yet", options=["--x=speed", "--y=mass_final"])
        keep(1)
        self.refuses("what the batch sets is the same in all cases that have ended (1)")
        self.draws(lambda _: keep(3), ["mass_final_over_limit"])

    def test_pairs_of_columns(self):
        self.draws(write_batch, ["bend.max_abs_over_mass_final"],
                   "--x=mass_final", "--y=bend.max_abs")
        self.refuses("no column 'sped'", "'speed'", options=["--x=sped", "--y=mass_final"])

    def test_pair_without_a_table(self):
        write_run(self.folder)
        self.refuses("no table of cases", options=["--x=a", "--y=b"])

    def test_comparison(self):
        self.draws(write_comparison, ["work_precision", "orders", "effort_over_stiffness",
                                      "stability_step_stiffness"])

    def test_error_over_what_was_varied(self):
        """Above time, iterations and factorisations."""
        self.test_comparison()
        picture = (self.folder / "plots" / "effort_over_stiffness.svg").read_text()
        self.assertIn('id="axes_4"', picture)
        self.assertIn("CPU time", picture)

    def test_stability_map_of_two_axes(self):
        self.draws(write_comparison, ["stability_elements_step"], "--x=elements", "--y=step")
        self.refuses("varies no number 'formalism'", options=["--x=formalism", "--y=step"])

    def test_comparison_of_what_is_no_number(self):
        write_comparison(self.folder)
        path = self.folder / "rows.csv"
        lines = [line.split(",") for line in path.read_text().splitlines()]
        for line in lines[1:]:
            line[3], line[4], line[6] = "0.001", f"[1; {line[4]}]", ""
        path.write_text("\n".join(",".join(line) for line in lines) + "\n")
        self.refuses("varies no number", "stiffness")

    def test_no_result(self):
        self.refuses("no summary.json")

    def test_nothing_to_draw(self):
        (self.folder / "summary.json").write_text("{}")
        self.refuses("no table")

    def test_each_mode_has_a_panel(self):
        """Ten of them, with number and frequency, each alone in its axes."""
        rows = [[100.0 * n, "rod", "beam", k, k / 8, 0.1 * math.sin(math.pi * n * k / 8), 0]
                for n in range(1, 11) for k in range(9)]
        write_frames(self.folder, "frequency [Hz]", rows)
        (self.folder / "summary.json").write_text(json.dumps(
            {"name": "rod", "frequencies_hz": [100.0 * n for n in range(1, 11)]}))
        self.assertEqual(plot(self.folder).returncode, 0)
        svg = (self.folder / "plots/mechanism.svg").read_text(encoding="utf-8")
        titles = [text for n in range(1, 11) for text in re.findall(rf"<!-- {n}: {100 * n:g} Hz -->", svg)]
        self.assertEqual(len(titles), 10)
        self.assertIn("10 shapes of vibration", svg)
        write_frames(self.folder, "frequency [Hz]", [row for row in rows if row[0] != 200])
        self.assertEqual(plot(self.folder).returncode, 0)
        self.assertIn("<!-- 3: 300 Hz -->", (self.folder / "plots/mechanism.svg").read_text(encoding="utf-8"))

    def test_modes_are_beside_the_mechanism_at_rest(self):
        """Which is the first instant, of frequency 0, and no mode. In space panels are no higher than what they show."""
        rows = [[100.0 * n, "rod", "beam", k, k / 8, 0.02 * n * math.sin(math.pi * k / 8), 0.01 * n] for n in range(4) for k in range(9)]
        (self.folder / "summary.json").write_text(json.dumps({"name": "rod", "frequencies_hz": [100.0, 200.0, 300.0]}))
        for kept, rest in ((rows, True), (rows[9:], False)):
            write_frames(self.folder, "frequency [Hz]", kept)
            self.assertEqual(plot(self.folder).returncode, 0)
            svg = (self.folder / "plots/mechanism.svg").read_text(encoding="utf-8")
            self.assertEqual("<!-- at rest -->" in svg, rest)
            self.assertIn("3 shapes of vibration", svg)
            self.assertEqual(re.findall(r"<!-- (\d): \d+ Hz -->", svg), ["1", "2", "3"])
            width, height = map(float, re.search(r'viewBox="0 0 (\S+) (\S+)"', svg).groups())
            self.assertLess(height, 0.4 * width)  # three squares beside each other were as high as wide a third, and headings

    def test_axes_in_space_have_a_unit_and_labels_beside_their_ticks(self):
        """Nothing is multiplied by a power of ten, however small; the label of a long axis is clear of its ticks."""
        import matplotlib.pyplot as plt  # noqa: PLC0415
        import mechanism as drawn  # noqa: PLC0415
        from space import drawn_box  # noqa: PLC0415

        def frame(ax):
            drawn.frame_axes(ax, [0, 1, 2], [(0, -3e-5, -3e-5), (2e-4, 3e-5, 3e-5)])
            axes.append(ax)
        axes = []
        drawn_box(frame, 7.5)
        figure, ax = axes[0].figure, axes[0]
        for axis in (ax.xaxis, ax.yaxis, ax.zaxis):
            self.assertEqual(axis.get_offset_text().get_text(), "")
            self.assertIn("[mm]", axis.label.get_text())
            label = axis.label.get_window_extent(figure.canvas.get_renderer())
            for tick in filter(lambda t: t.get_text(), axis.get_ticklabels()):
                self.assertFalse(label.overlaps(tick.get_window_extent(figure.canvas.get_renderer())), tick.get_text())
        plt.close(figure)

    def test_rods_and_cylinders_are_drawn(self):
        write_run(self.folder), write_shapes(self.folder)
        self.assertEqual(plot(self.folder).returncode, 0)
        mark = "<!-- rod or cylinder, without mass -->"
        self.assertNotIn(mark, (self.folder / "plots/mechanism.svg").read_text(encoding="utf-8"))
        path = self.folder / "part_lines.csv"
        path.write_text(path.read_text() + "".join(f"{t},lift,0,{x},0.1,0,0,0,0\n" for t in times(13, 0.042)[::3] for x in (0, 0.2)))
        self.assertEqual(plot(self.folder).returncode, 0)
        self.assertIn(mark, (self.folder / "plots/mechanism.svg").read_text(encoding="utf-8"))

    def test_a_part_in_space_that_moves_in_a_plane_is_drawn_there(self):
        import mechanism as drawn  # noqa: PLC0415
        instants = [(t, {"rod": ("solid", [(t, 0, 0, 0, 0, 0), (t + 1, t, 0, 0, 0, 0)])}) for t in (0.0, 1.0)]
        edges = lambda b: {(t, "rod"): [[(t, 0, -0.1, 0, 0.01, b), (t + 1, t, 0.1, 0, 0.01, b)]] for t in (0.0, 1.0)}  # noqa: E731
        shapes = lambda b: drawn.Shapes({}, edges(b))  # noqa: E731
        self.assertEqual(drawn.shown_axes(instants, shapes(1e-4)), [0, 1])
        self.assertEqual(drawn.shown_axes(instants, shapes(5e-3)), [0, 1, 2])  # it bends out of its plane
        self.assertEqual(drawn.shown_axes(instants, shapes(1e-4), modes=True), [0, 1, 2])

    def test_bending_of_parts_and_beams_has_one_scale(self):
        import mechanism as drawn  # noqa: PLC0415
        write_run(self.folder), write_shapes(self.folder)
        instants, _ = drawn.read_frames(self.folder / "frames.csv")
        shapes = drawn.read_shapes(self.folder, instants)
        beams = drawn.bending_scale(instants)
        self.assertEqual(drawn.bending_scale(instants, shapes.parts), beams)  # those bend less
        moved, larger, _ = drawn.enlarge(instants, shapes, "time [s]")
        points = lambda instants, shapes: [x for _, bodies in instants for _, nodes in bodies.values() for x in nodes] + [  # noqa: E731
            x for lines in shapes.parts.values() for line in lines for x in line]
        for (x, y, z, bx, by, bz), at in zip(points(instants, shapes), points(moved, larger), strict=True):
            self.assertAlmostEqual(math.dist(at[:3], (x + (beams - 1) * bx, y + (beams - 1) * by, z)), 0, places=12)
        bent = {key: [[(*x[:3], 0, 1000 * x[4], 0) for x in line] for line in lines] for key, lines in shapes.parts.items()}
        self.assertLess(drawn.bending_scale(instants, bent), beams)  # now the part sets it
        self.assertEqual(plot(self.folder).returncode, 0)
        self.assertIn(f"bending × {beams:g}", (self.folder / "plots/mechanism.svg").read_text(encoding="utf-8"))

    def test_statics_are_drawn_from_rest(self):
        """A cantilever keeps its clamp and sinks, and it is its displacement that the heading names; its plane is that of the load
        however little it bends."""
        import mechanism as drawn  # noqa: PLC0415
        for tip, scale in ((-3e-3, "20"), (-3e-8, "500000")):
            deflection = [tip * (k / 8) ** 2 * (3 - k / 8) / 2 for k in range(9)]
            write_frames(self.folder, "load_factor [-]",
                         [[1.0, "bar", "beam", k, k / 8, 0, w, 0, 0, w] for k, w in enumerate(deflection)])
            (self.folder / "summary.json").write_text("{}")
            self.assertEqual(plot(self.folder).returncode, 0)
            self.assertIn(f"mechanism, displacement × {scale}", (self.folder / "plots/mechanism.svg").read_text(encoding="utf-8"))
            instants, abscissa = drawn.read_frames(self.folder / "frames.csv")
            self.assertEqual(drawn.shown_axes(instants, drawn.Shapes({}, {})), [0, 2])
            instants, _, _ = drawn.enlarge(instants, drawn.Shapes({}, {}), abscissa)
            sunk = [x[2] for x in instants[0][1]["bar"][1]]
            self.assertEqual(sunk, sorted(sunk, reverse=True))
            self.assertAlmostEqual(sunk[8], float(scale) * tip)

    def test_half_a_result(self):
        """A file that was cut off, within a line, after a line, or in the middle."""
        def cut(name, keep):
            write_run(self.folder), write_shapes(self.folder)
            path = self.folder / name
            path.write_text(keep(path.read_text()))
        lines = lambda text, n: "".join(text.splitlines(keepends=True)[:n])  # noqa: E731
        for name in ("frames.csv", "sections.csv"):
            cut(name, lambda text: text[:-3])
            self.refuses(name, "not whole", "within line")
            cut(name, lambda text: lines(text, -4))
            self.refuses(name, "not whole")
            cut(name, lambda text: lines(text, 5) + lines(text, 9)[len(lines(text, 7)):] + text[len(lines(text, 9)):])
            self.refuses(name, "not whole")
        cut("part_lines.csv", lambda text: lines(text, -1) + "0.1,slider,0,0.3\n")
        self.refuses("part_lines.csv", "has 4 cells")

    def test_broken_files(self):
        (self.folder / "summary.json").write_text("{")
        self.refuses("plot:")
        (self.folder / "summary.json").write_text("{}")
        (self.folder / "responses.csv").write_text("time [s],bend [m]\n0,nonsense\n")
        self.refuses("responses.csv: 'nonsense' of column 'bend' in line 2 is no number")

    def test_cells_that_are_no_numbers(self):
        """They are named with their file, line and column, whatever reads them."""
        for write, name, line, column, heading in (
                (write_batch, "results.csv", 3, 6, "bend.max_abs"), (write_comparison, "rows.csv", 4, 6, "error"),
                (write_methods, "rows.csv", 2, 7, "mass"), (write_map, "map.csv", 3, 2, None), (write_run, "frames.csv", 4, 4, "x"),
                (write_optimize, "design.csv", 2, 5, None)):
            write(self.folder)
            path = self.folder / name
            rows = list(csv.reader(path.read_text().splitlines()))
            heading = heading or rows[0][column].split(" [")[0]
            rows[line - 1][column] = "abc"
            write_csv(path, rows[0], rows[1:])
            self.refuses(f"{path}: 'abc' of column '{heading}' in line {line} is no number")
            shutil.rmtree(self.folder)
            self.folder.mkdir()


if __name__ == "__main__":
    if len(sys.argv) > 1 and not sys.argv[1].startswith("-"):
        KEEP = Path(sys.argv.pop(1))
    unittest.main()
