"""Draws docs/images/sensitivities_over_time.png, p dy/dp over time of the shipped sensitivities as beams on the
group, chains of segments and meshes in full motion, and prints how far these are apart:
/usr/bin/python3 docs/pictures/sensitivities_over_time.py build/release/bin/liesl [PICTURE]"""
import json
import math
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "apps" / "plot"))

import matplotlib.pyplot as plt  # noqa: E402

from style import BLUE, GREEN, ORANGE, STYLE, scale_of, scaled  # noqa: E402
from tables import Table  # noqa: E402

ROUND = math.sqrt(3) / 2  # height of the rectangle with the area and second moment of a circle, of its diameter


def mesh(body, length, height, thickness, material, at=(0, 0), turn=0.0, cells=80):
    """A mesh in full motion, two cells over its height, in the place of a straight beam."""
    middle = cells // 2 + 1  # number of the node at the middle of the lower side
    nodes = [middle + row * (cells + 1) for row in range(3)]
    return (f'bodies.{body}={{solid={{as="continuum",material="{material}",thickness={thickness!r},'
            f'at=[{at[0]!r},{at[1]!r},0],orientation=[0,0,{turn!r}],'
            f'mesh={{from=[0,{-height / 2!r}],to=[{length!r},{height / 2!r}],cells=[{cells},2]}},'
            f'interfaces={{start={{set="x_min"}},mid={{nodes={nodes}}},end={{set="x_max"}}}}}}}}')


class Example:
    """A shipped sensitivity: p by name, of which (nominal value, key of the beam, key of the mesh)."""

    def __init__(self, name, title, beams, mesh_change, parameters):
        self.name, self.title, self.beams, self.mesh, self.parameters = name, title, beams, mesh_change, parameters

    def changes(self, kind):
        """The flexible beams have 32 elements, or are a mesh; what else there is, is as shipped."""
        at = 2 if kind == "continuum" else 1
        out = ["by=" + json.dumps([p[at] for p in self.parameters.values()]), 'method="direct"']
        out += [f"bodies.{beam}.beam.elements=32" for beam in self.beams]
        if kind == "segments":
            out.append("simulation.formalism=segments")
        return out + ([self.mesh] if kind == "continuum" else [])


def same(value, key):
    return (value, key, key)


EXAMPLES = [
    Example("pendulum", "pendulum", ["beam"], mesh("beam", 1.0, 0.01, 0.01, "rubber"), {
        "E": same(5e8, "materials.rubber.E"),
        "rho": same(7800, "materials.rubber.rho"),
        "length": (1.0, "bodies.beam.beam.to.0", "bodies.beam.solid.mesh.to.0"),
        "side in the plane": (0.01, "sections.square.width", "bodies.beam.solid.mesh.to.1")}),
    Example("slider_crank", "slider-crank", ["rod"],
            mesh("rod", 0.3, 0.01 * ROUND, math.pi / 4 * 0.01 / ROUND, "steel", at=(0.15, 0)), {
                "E": same(210e9, "materials.steel.E"),
                "rho": same(7850, "materials.steel.rho"),
                "length of the rod": (0.3, "bodies.rod.beam.to.0+bodies.slider.rigid.at.0",
                                      "bodies.rod.solid.mesh.to.0+bodies.slider.rigid.at.0"),
                "mass of the slider": same(0.2, "bodies.slider.rigid.mass")}),
    Example("four_bar", "four-bar", ["coupler", "rocker"],
            mesh("coupler", 0.28, 0.006, 0.01, "steel", at=(0.0, 0.1), turn=math.atan2(0.0965173497253684,
                                                                                      0.2628391165751228)), {
                "E": same(210e9, "materials.steel.E"),
                "rho": same(7850, "materials.steel.rho"),
                "rate of the drive": same(60, "joints.A.drive.rate")}),
]
KINDS = {"se3": ("SE(3) beam", BLUE, "-"), "segments": ("segments", ORANGE, (0, (5, 2))),
         "continuum": ("continuum", GREEN, (0, (1.5, 1.5)))}


def derivatives(program, example, kind, folder):
    """Time and p dy/dp of the bending, a list a parameter: of its components that which is in the plane."""
    out = Path(folder) / f"{example.name}_{kind}"
    words = [program, "sensitivity", ROOT / "data" / "studies" / f"sensitivity_{example.name}.toml", "-o", out,
             "--quiet"]
    for change in example.changes(kind):
        words += ["--set", change]
    subprocess.run([str(word) for word in words], check=True)
    table = Table(out / "sensitivities.csv")
    found = {}
    for name, p in example.parameters.items():
        key = p[2 if kind == "continuum" else 1]
        columns = [table.numbers(n) for n in table.names
                   if re.fullmatch(r"bend(\.\w)? by " + re.escape(key), n)]
        largest = max(columns, key=lambda values: max(map(abs, values)))
        found[name] = scaled(largest, p[0])
    return table.numbers(table.names[0]), found


def distance(a, b):
    """Root mean square of a - b, of that of b."""
    return math.sqrt(sum((x - y) ** 2 for x, y in zip(a, b)) / sum(y * y for y in b))


def main():
    program = sys.argv[1]
    picture = sys.argv[2] if len(sys.argv) > 2 else ROOT / "docs" / "images" / "sensitivities_over_time.png"
    plt.rcParams.update(STYLE)
    figure, axes = plt.subplots(3, 4, figsize=(12.5, 7.4), layout="constrained")
    for ax in axes.flat:
        ax.set_visible(False)
    with tempfile.TemporaryDirectory() as folder:
        for row, example in zip(axes, EXAMPLES):
            runs = {kind: derivatives(program, example, kind, folder) for kind in KINDS}
            for ax, name in zip(row, example.parameters):
                ax.set_visible(True)
                factor, unit = scale_of(runs["se3"][1][name], "m")
                for kind, (text, colour, dashes) in KINDS.items():
                    time, values = runs[kind]
                    ax.plot(time, scaled(values[name], factor), color=colour, linestyle=dashes, label=text)
                ax.set_title(f"{example.title}: {name}")
                ax.set_ylabel(f"p ∂bend/∂p [{unit}]")
                ax.set_xlabel("time [s]")
                ax.margins(x=0.01)
                beam = runs["se3"][1][name]
                print(f"| {example.title}, {name} | " + " | ".join(
                    f"{distance(runs[kind][1][name], beam):.1e}" for kind in ("segments", "continuum")) + " |")
    handles, labels = axes[0][0].get_legend_handles_labels()
    axes[2][3].set_visible(True)
    axes[2][3].axis("off")
    axes[2][3].legend(handles, labels, loc="center", fontsize=12)
    figure.savefig(picture, metadata={"Software": "liesl"})


if __name__ == "__main__":
    main()
