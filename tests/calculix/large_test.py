#!/usr/bin/env python3
"""large_test.py PROGRAM: a part in large deformation, all of whose nodes move, as CalculiX has it.

Cook's membrane in space, held at its high side and pulled up at its low one, in tetrahedra of 10 nodes, whose
quadrature both have; St. Venant-Kirchhoff's law is *ELASTIC with NLGEOM there. The force is spread evenly over the nodes
of the low side; the mean displacement of the nodes half way to it is compared.

Ends with 77 (skipped) without ccx (calculix-ccx).
"""

import csv
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from deck import displacements, need_calculix
from meshes import cooks_membrane

PROGRAM = sys.argv[1]
need_calculix()

WITHIN = 1e-6  # of the displacement, which CalculiX prints with seven digits
LARGE = 12  # m, of its width of 48 m
E, NU, THICKNESS, FORCE = 1e6, 0.3, 8, 8e6

SCENE = f"""[materials]
panel = {{ E = {E}, nu = {NU}, rho = 1000 }}
[bodies.panel.solid]
as = "continuum"
law = "st_venant_kirchhoff"
mesh = {{ file = "cook.inp" }}
material = "panel"
[bodies.panel.solid.interfaces]
wall = {{ set = "left" }}
tip = {{ set = "right", tie = "averaged" }}
seen = {{ set = "middle", tie = "averaged" }}
[joints]
clamp = {{ fixed = ["ground", "panel.wall"] }}
[loads]
pull = {{ at = "panel.tip", force = [0, {FORCE}, 0] }}
[simulation]
type = "static"
load_steps = 8
tolerance = 1e-11
[responses]
seen = {{ response = "translation", at = "panel.seen" }}
tip = {{ response = "translation", at = "panel.tip" }}
"""


def deck(mesh, count):
    """The mesh with its material, its wall, and the force shared by `count` nodes."""
    return mesh + f"""*MATERIAL, NAME=PANEL
*ELASTIC
{E}, {NU}
*SOLID SECTION, ELSET=ALL, MATERIAL=PANEL
*BOUNDARY
LEFT, 1, 3
*STEP, NLGEOM, INC=1000
*STATIC
0.125, 1., , 0.125
*CONTROLS, PARAMETERS=FIELD
1e-9, 1e-9
*CLOAD
RIGHT, 2, {FORCE / count!r}
*NODE PRINT, NSET=MIDDLE
U
*END STEP
"""


def by_liesl(folder):
    (folder / "cook.toml").write_text(SCENE)
    subprocess.run([PROGRAM, "run", folder / "cook.toml", "-o", folder / "out", "--quiet"], check=True)
    rows = list(csv.reader((folder / "out" / "responses.csv").read_text().splitlines()))
    return [float(x) for x in rows[-1][1:4]], float(rows[-1][5])


def by_calculix(folder, mesh):
    pulled = len(re.search(r"NSET=right\n((?:\d+,\n)+)", mesh)[1].split())
    (folder / "panel.inp").write_text(deck(mesh.replace("TYPE=C3D10", "TYPE=C3D10, ELSET=ALL"), pulled))
    subprocess.run(["ccx", "panel"], cwd=folder, capture_output=True, check=True, timeout=500)
    nodes = displacements(folder, "panel", "MIDDLE")[1.0].values()
    return [sum(u) / len(u) for u in zip(*nodes)]


with tempfile.TemporaryDirectory() as temporary:
    folder = Path(temporary)
    mesh = cooks_membrane("C3D10", (6, 4, 1), THICKNESS)
    (folder / "cook.inp").write_text(mesh)
    (liesl, rise), calculix = by_liesl(folder), by_calculix(folder, mesh)
    size = max(abs(x) for x in calculix)
    error = max(abs(a - b) for a, b in zip(liesl, calculix)) / size
    print(f"Cook's membrane, pulled up by {rise:.2f} m: its middle moves by ({calculix[0]:.5f}, {calculix[1]:.5f}) m, "
          f"liesl differs by {error:.1e} of it")
    sys.exit(0 if error < WITHIN and rise > LARGE else 1)
