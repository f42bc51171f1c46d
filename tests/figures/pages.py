"""Figures of docs/outputs.md: sizes of pages."""

import subprocess

from sentences import Fresh, Sentence

CELLS = "scene.bodies.plate.solid.mesh.cells=[40,40]"
CASES = tuple(f'loads.{load}.case="{load}"' for load in ("along_x", "along_y"))


def sentences(run):
    def size(result):
        """Megabytes of its page."""
        subprocess.run([run.program, "report", result.folder], check=True, capture_output=True)
        return Fresh((result.folder / "report.html").stat().st_size / 1e6, within=2)

    def sizes():
        return [size(run("optimize", "studies/slider_crank_rod")), size(run("run", "scenes/robot_arm_lattice")),
                size(run("optimize", "studies/plate_with_hole", CELLS, *CASES))]

    return [Sentence("**Sizes:** slider_crank_rod {:.2f} MB, robot_arm_lattice (its motion) {:.2f} MB, "
                     "an outline under two fixed loads on 1600 cells {:.2f} MB", sizes)]
