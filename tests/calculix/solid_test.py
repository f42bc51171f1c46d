#!/usr/bin/env python3
"""solid_test.py PROGRAM DATA: elements of CalculiX give back the unit cases of `liesl export --to calculix` of meshed
parts: a bar of 20 x 4 x 4 hexahedra in tension, shear, torsion and bending, and bars of every other kind of cell, read
from `.inp` files; a connecting rod whose outline cuts cells, under its motion; a plate, one layer of cells.

Ends with 77 (skipped) without ccx (calculix-ccx).
"""

import csv
import sys
import tempfile
from pathlib import Path

from deck import displacements, need_calculix, run_deck
from meshes import BAR, ELEMENTS, bar_mesh

PROGRAM, DATA = sys.argv[1], Path(sys.argv[2])
need_calculix()

WITHIN = 1e-6  # of the largest displacement of a unit case
# Of the tip, in the order of its coordinates.
CASES = ("tension", "shear along y", "shear along z", "torsion", "bending about y", "bending about z")


def expected(folder):
    """Unit case -> node -> displacement."""
    out = {}
    for row in csv.reader((folder / "displacements.csv").read_text().splitlines()[1:]):
        out.setdefault(int(row[0]), {})[int(row[1])] = [float(x) for x in row[5:]]
    return out


def computed(folder, part):
    """Step -> node -> displacement."""
    return {round(time): nodes for time, nodes in displacements(folder, part).items()}


def check(scene, part, *options, names=()):
    """Prints each unit case. Number of those that are wrong."""
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary) / "deck"
        if not run_deck(PROGRAM, scene, part, folder, options):
            return 1
        units, steps, wrong = expected(folder), computed(folder, part), 0
        if sorted(units) != sorted(steps) or not units:
            print(f"{part}: {len(units)} unit cases, {len(steps)} steps of CalculiX")
            return 1
        for k, nodes in units.items():
            largest = max(abs(x) for u in nodes.values() for x in u)
            error = max(abs(a - b) for node, u in nodes.items() for a, b in zip(u, steps[k][node])) / largest
            wrong += not error <= WITHIN
            print(f"{scene.name} {part} {names[k - 1] if names else f'unit case {k}'}: CalculiX differs by {error:.1e} "
                  "of the largest displacement")
        return wrong


def check_element(folder, element):
    (folder / f"{element}.INP").write_text(bar_mesh(element))
    scene = folder / f"{element}.toml"
    grid = "{ from = [0, 0, 0], to = [0.2, 0.04, 0.04], cells = [20, 4, 4] }"
    text = BAR.replace(grid, f'{{ file = "{element}.INP" }}').replace('"x_min"', '"left"').replace('"x_max"', '"right"')
    scene.write_text(text if element.startswith("C3D") else text.replace("modes = 0", "modes = 0\nthickness = 0.01"))
    return check(scene, "bar", names=CASES if element.startswith("C3D") else ("tension", "shear", "bending"))


with tempfile.TemporaryDirectory() as temporary:
    bar = Path(temporary) / "bar.toml"
    bar.write_text(BAR)
    wrong = check(bar, "bar", names=CASES)
    wrong += sum(check_element(Path(temporary), element) for element in ELEMENTS)
wrong += check(DATA / "scenes/meshed_slider_crank.toml", "rod", "--set", "simulation.duration=1e-3",
               "--set", "bodies.rod.solid.mesh.cells=[60,12]")
wrong += check(DATA / "scenes/connecting_rod_3d.toml", "rod", "--set", "simulation.duration=1e-3",
               "--set", "bodies.rod.solid.mesh.cells=[30,8,4]")
sys.exit(1 if wrong else 0)
