#!/usr/bin/env python3
"""default_tolerance.py LIESL DATA: what simulation.tolerance adds to the error of a motion, as a table.

Runs pendulum, slider_crank and heavy_top as shipped with tolerances of 1e-4, 1e-5, 1e-6 and 1e-10, and once with four
times the elements and a sixteenth of the step at 1e-10. Errors are root mean squares over the records, relative to the
largest value of the response: of the model (mesh and step) that of 1e-10 against the fine run, of a tolerance that
against 1e-10. Of the energy, which the top keeps, the error is its largest change. Needs nothing but Python 3.
"""

import csv
import json
import math
import subprocess
import sys
import tempfile
from pathlib import Path

TOLERANCES = ["1e-4", "1e-5", "1e-6"]
TIGHT = "1e-10"
FINER = 16  # steps
# Scene, columns of the response, its name, elements of the fine run.
CASES = [
    ("pendulum", ["tip.x [m]", "tip.y [m]"], "tip", {"beam": 64}),
    ("slider_crank", ["bend.y [m]"], "bend", {"crank": 32, "rod": 32}),
    ("heavy_top", ["centre.x [m]", "centre.y [m]", "centre.z [m]"], "centre", {}),
    ("heavy_top", ["energy [J]"], "energy", {}),
]


class Runs:
    def __init__(self, program, data, work):
        self.program, self.data, self.work, self.known = program, data, work, {}

    def __call__(self, scene, *changes):
        """(columns of responses.csv, corrections a step)"""
        key = (scene, *changes)
        if key not in self.known:
            command = [self.program, "run", self.data / "scenes" / f"{scene}.toml", "-o", self.work, "--force", "--quiet"]
            subprocess.run([*command, *(word for c in changes for word in ("--set", c))], check=True)
            with open(self.work / "responses.csv", encoding="utf-8") as file:
                rows = list(csv.DictReader(file))
            summary = json.loads((self.work / "summary.json").read_text(encoding="utf-8"))
            columns = {name: [float(row[name]) for row in rows] for name in rows[0]}
            self.known[key] = columns, summary["newton_iterations"] / summary["steps"]
        return self.known[key]


def step_of(data, scene):
    for line in (data / "scenes" / f"{scene}.toml").read_text(encoding="utf-8").splitlines():
        if line.startswith("step"):
            return float(line.split("=")[1])
    raise LookupError(f"{scene} has no step")


def distance(a, b, columns):
    """Root mean square over the records, relative to the largest value of b."""
    count = len(b[columns[0]])
    squares = [sum((a[c][i] - b[c][i]) ** 2 for c in columns) for i in range(count)]
    size = max(math.sqrt(sum(b[c][i] ** 2 for c in columns)) for i in range(count))
    return math.sqrt(sum(squares) / count) / size


def drift(a):
    energy = a["energy [J]"]
    return max(abs(e - energy[0]) for e in energy) / abs(energy[0])


def main():
    program, data = sys.argv[1], Path(sys.argv[2])
    print("| scene, response | error of the model |", " | ".join(f"by {t}" for t in TOLERANCES), "| corrections a step |")
    print("|---" * (3 + len(TOLERANCES)) + "|")
    with tempfile.TemporaryDirectory(prefix="liesl-tolerance-") as work:
        run = Runs(program, data, Path(work))
        for scene, columns, name, elements in CASES:
            at = {t: run(scene, f"simulation.tolerance={t}") for t in [*TOLERANCES, TIGHT]}
            tight = at[TIGHT][0]
            if name == "energy":
                model = drift(tight)
            else:
                fine, _ = run(scene, f"simulation.tolerance={TIGHT}", f"simulation.step={step_of(data, scene) / FINER:.12g}",
                              f"simulation.output_every={FINER}",
                              *(f"bodies.{b}.beam.elements={n}" for b, n in elements.items()))  # fmt: skip
                model = distance(tight, fine, columns)
            errors = [distance(at[t][0], tight, columns) for t in TOLERANCES]
            corrections = ", ".join(f"{at[t][1]:.1f}" for t in TOLERANCES)
            print(f"| {scene}, `{name}` | {model:.1e} |", " | ".join(f"{e:.1e}" for e in errors), f"| {corrections} |")


if __name__ == "__main__":
    main()
