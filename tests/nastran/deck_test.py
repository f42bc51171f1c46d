#!/usr/bin/env python3
"""deck_test.py PROGRAM DATA: decks of `liesl export --to nastran`, read by a reader and solved by finite elements that
share nothing with liesl (bulk.py, elements.py), give back the deformation of the motion.

Fields, columns, continuations, numbers and references are those of the bulk data; beams by second-order theory, meshed
parts of every kind of cell linearly. Ends with 77 (skipped) without NumPy.
"""

import csv
import hashlib
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

try:
    import numpy as np
except ModuleNotFoundError:
    print("skipped: needs python3-numpy")
    sys.exit(77)

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).parents[1] / "calculix"))
from bulk import Deck, DeckError, by_number  # noqa: E402
from elements import KINDS, beam, section, solid  # noqa: E402
from meshes import BAR, bar_mesh  # noqa: E402

PROGRAM, DATA = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
WITHIN_BEAM = 0.02  # of the deflection: second-order theory with the elements of the scene
LEAST = 1e-7  # of the length: deflections below are not compared
WITHIN_SOLID = 1e-6  # of the largest displacement
NASTRAN = {"C3D4": "CTETRA", "C3D10": "CTETRA", "C3D20": "CHEXA", "CPS3": "CTRIA3", "CPS6": "CTRIA6", "CPS8": "CQUAD8"}


def exported(folder, scene, part, *options):
    subprocess.run([PROGRAM, "export", scene, "--to", "nastran", "--part", part, "-o", folder, "--quiet", *options],
                   check=True)
    return Deck((folder / f"{part}.bdf").read_text())


def rows(path):
    return [[float(x) for x in row] for row in csv.reader(path.read_text().splitlines()[1:])]


def grids(deck):
    return {number: np.array(card[2:5], float) for number, card in by_number(deck.of("GRID")).items()}


def forces(deck, names=("FORCE",)):
    """Set -> [(grid, first freedom, vector)]."""
    out, known = {}, grids(deck)
    for name in names:
        for number, grid, _, factor, *vector in deck.of(name):
            if grid not in known or not any(vector):
                raise DeckError(f"{name} of set {number} at {grid} has no grid, or no component that is not 0")
            out.setdefault(number, []).append((grid, 0 if name == "FORCE" else 3, factor * np.array(vector)))
    return out


def beam_elements(deck):
    """[(grids, turn of 12 freedoms, length, E, nu, A, I1, I2, J)]"""
    places, materials, out = grids(deck), by_number(deck.of("MAT1")), []
    sections = by_number(deck.of("PBARL"))
    for _, group, a, b, *v in by_number(deck.of("CBAR")).values():
        _, material, _, kind, *_, = sections[group]
        dimensions = [d for d in sections[group][8:] if d is not None]
        x = places[b] - places[a]
        length = np.linalg.norm(x)
        x = x / length
        z = np.cross(x, v)
        z /= np.linalg.norm(z)
        turn = np.kron(np.eye(4), np.array([x, np.cross(z, x), z]))
        _, E, _, nu, *_ = materials[material]
        out.append(((a, b), turn, length, E, nu, *section(kind, dimensions)))
    return out


def solve_beams(deck, loads, held):
    """Displacements (grids, 3) by second-order theory: (K + K_g(N)) u = f, N the axial forces that follow from u."""
    order = {number: k for k, number in enumerate(sorted(grids(deck)))}
    elements, n = beam_elements(deck), 6 * len(order)
    f, axial, u = np.zeros(n), np.zeros(len(elements)), np.zeros(n)
    for grid, first, vector in loads:
        f[6 * order[grid] + first:][:3] += vector
    free = [i for i in range(n) if i // 6 not in {order[g] for g in held}]
    for _ in range(20):
        K = np.zeros((n, n))
        for e, ((a, b), turn, *properties) in enumerate(elements):
            at = [6 * order[g] + c for g in (a, b) for c in range(6)]
            K[np.ix_(at, at)] += turn.T @ beam(*properties, axial=axial[e]) @ turn
        u[free] = np.linalg.solve(K[np.ix_(free, free)], f[free])
        for e, ((a, b), turn, length, E, _, A, *_) in enumerate(elements):
            local = turn @ u[[6 * order[g] + c for g in (a, b) for c in range(6)]]
            axial[e] = E * A / length * (local[6] - local[0])
    return u.reshape(-1, 6)[:, :3]


def offset(places, u):
    """Of the middle node from the chord between the ends."""
    at = places + u
    chord, way = at[-1] - at[0], at[len(at) // 2] - at[0]
    return way - chord * (chord @ way) / (chord @ chord)


def solve_solid(deck):
    """Subcase -> displacements (grids, 3): each a combination of FORCE sets by LOAD, its supports by SPC."""
    places, materials = grids(deck), by_number(deck.of("MAT1"))
    order = {number: k for k, number in enumerate(sorted(places))}
    properties = {**by_number(deck.of("PSHELL")), **by_number(deck.of("PSOLID"))}
    dim, n = (2 if deck.of("PSHELL") else 3), 3 * len(order)
    K, seen = np.zeros((n, n)), set()
    for name in {name for name, _ in KINDS}:
        for number, group, *nodes in deck.of(name):
            nodes = [g for g in nodes if g is not None]
            if number in seen:
                raise DeckError(f"element {number} is there twice")
            seen.add(number)
            _, E, _, nu, *_ = materials[properties[group][1]]
            x = np.array([places[g][:dim] for g in nodes])
            at = [3 * order[g] + c for g in nodes for c in range(dim)]
            K[np.ix_(at, at)] += solid(name, x, E, nu, *properties[group][2:3])
    taken = {3 * order[card[0]] + int(c) - 1 for card in deck.of("GRID") for c in str(card[6]) if c in "123"}
    sets, combined, out = forces(deck), by_number(deck.of("LOAD")), {}
    for case, of in deck.subcases.items():
        _, factor, *pairs = [x for x in combined[of["LOAD"]] if x is not None]
        f, u = np.zeros(n), np.zeros(n)
        for scale, number in zip(pairs[::2], pairs[1::2]):
            for grid, _, vector in sets[number]:
                f[3 * order[grid]:][:3] += factor * scale * vector
        fixed = set(taken)
        for number, grid, component, value in deck.of("SPC"):
            if number == of["SPC"]:
                at = 3 * order[grid] + component - 1
                u[at] = value
                fixed.add(at)
        free = [i for i in range(n) if i not in fixed]
        u[free] = np.linalg.solve(K[np.ix_(free, free)], f[free] - K[np.ix_(free, sorted(fixed))] @ u[sorted(fixed)])
        out[case] = u.reshape(-1, 3)
    return out


class Nastran(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = Path(self.temporary.name)
        self.addCleanup(self.temporary.cleanup)

    def check_beam(self, scene, part, within, *options):
        deck = exported(self.folder / "deck", DATA / scene, part, "--force", *options)
        self.assertEqual(deck.solution, 106)
        self.assertEqual(deck.of("PARAM"), [["LGDISP", 1]])
        sets = forces(deck, ("FORCE", "MOMENT"))
        supports = {number: grid for number, components, grid in deck.of("SPC1") if components == 123456}
        motion = {}
        for case, _, _, x, y, z, *u in rows(self.folder / "deck/displacements.csv"):
            motion.setdefault(int(case), []).append([x, y, z, *u])
        self.assertEqual(sorted(motion), sorted(deck.subcases))
        compared = 0
        for case, of in deck.subcases.items():
            table = np.array(motion[case])
            places = np.array([x for _, x in sorted(grids(deck).items())])
            self.assertLess(np.abs(places - table[:, :3]).max(), 1e-9)
            right = offset(places, table[:, 3:])
            if np.linalg.norm(right) < LEAST * np.linalg.norm(places[-1] - places[0]):
                continue  # nothing to compare; without loads no LOAD either
            here = offset(places, solve_beams(deck, sets[of["LOAD"]], [supports[of["SPC"]]]))
            compared += 1
            error = np.linalg.norm(here - right) / np.linalg.norm(right)
            print(f"{scene} {part} case {case}: {1e3 * np.linalg.norm(right):.4f} mm, differs by {100 * error:.2f} %")
            self.assertLess(error, within)
        self.assertGreater(compared, 0)
        return deck

    def test_beams(self):
        self.check_beam("scenes/slider_crank.toml", "rod", WITHIN_BEAM)
        self.check_beam("scenes/slider_crank.toml", "rod", WITHIN_BEAM, "--set", "bodies.rod.beam.elements=16")
        whole = self.check_beam("scenes/slider_crank.toml", "rod", WITHIN_BEAM, "--cases", "all", "--set", "simulation.duration=0.01")
        self.assertNotIn("LOAD", whole.subcases[1])  # at rest, without weight
        self.check_beam("scenes/four_bar.toml", "coupler", WITHIN_BEAM, "--set", "bodies.coupler.beam.elements=16")

    def test_sections(self):
        for shape in ('{ type = "tube", diameter = 0.012, thickness = 0.002 }', '{ type = "rectangle", width = 0.008, height = 0.012 }',
                      '{ type = "box", width = 0.010, height = 0.012, thickness = 0.0015 }',
                      '{ type = "i", width = 0.014, height = 0.012, flange_thickness = 0.002, web_thickness = 0.0015 }'):
            self.check_beam("scenes/slider_crank.toml", "rod", WITHIN_BEAM, "--set", f"sections.rod={shape}")

    def check_solid(self, scene, part, *options):
        target = self.folder / "deck"
        deck = exported(target, scene, part, "--force", *options)
        self.assertEqual(deck.solution, 101)
        units = {}
        for unit, _, *_, x, y, z in rows(target / "displacements.csv"):
            units.setdefault(int(unit), []).append([x, y, z])
        factors = {int(case): f for case, _, *f in rows(target / "factors.csv")}
        self.assertEqual(sorted(factors), sorted(deck.subcases))
        right = {case: sum(f * np.array(units[k + 1]) for k, f in enumerate(fs)) for case, fs in factors.items()}
        largest = max(np.abs(u).max() for u in right.values())
        self.assertGreater(largest, 0)
        error = max(np.abs(u - right[case]).max() for case, u in solve_solid(deck).items()) / largest
        print(f"{scene.name} {part}, {len(right)} cases: differs by {error:.1e} of the largest displacement")
        self.assertLess(error, WITHIN_SOLID)
        return deck

    def bar_of(self, element):
        """A scene whose mesh is a file."""
        (self.folder / f"{element}.inp").write_text(bar_mesh(element))
        grid = "{ from = [0, 0, 0], to = [0.2, 0.04, 0.04], cells = [20, 4, 4] }"
        text = BAR.replace(grid, f'{{ file = "{element}.inp" }}').replace('"x_min"', '"left"').replace('"x_max"', '"right"')
        if not element.startswith("C3D"):
            text = text.replace("modes = 0", "modes = 0\nthickness = 0.01")
        (self.folder / f"{element}.toml").write_text(text)
        return self.folder / f"{element}.toml"

    def test_every_kind_of_cell(self):
        for element, name in NASTRAN.items():
            self.assertTrue(self.check_solid(self.bar_of(element), "bar", "--cases", "all").of(name))

    def test_a_mesh_that_has_changed_is_no_longer_that_of_the_result(self):
        scene, result = self.bar_of("CPS3"), self.folder / "result"
        subprocess.run([PROGRAM, "run", scene, "-o", result, "--quiet", "--no-report"], check=True)
        mesh = self.folder / "CPS3.inp"
        files = json.loads((result / "summary.json").read_text())["files"]
        self.assertEqual(list(files.values()), [hashlib.sha256(mesh.read_bytes()).hexdigest()])
        export = [PROGRAM, "export", result, "--to", "nastran", "--part", "bar", "-o", self.folder / "deck", "--quiet", "--force"]
        design = result / "design.toml"
        design.write_text(scene.read_text().replace('"CPS3.inp"', f'"{mesh}"'))
        subprocess.run(export, check=True)
        mesh.write_text(mesh.read_text() + "** another\n")
        for _ in range(2):  # as the final design of an optimisation, then as the scene of a run
            done = subprocess.run(export, capture_output=True, text=True, check=False)
            self.assertNotEqual(done.returncode, 0)
            self.assertIn("has changed", done.stderr)
            design.unlink(missing_ok=True)

    def test_parts_of_motions(self):
        (self.folder / "bar.toml").write_text(BAR.replace("[20, 4, 4]", "[8, 2, 2]"))
        self.check_solid(self.folder / "bar.toml", "bar", "--cases", "all")  # bricks
        self.check_solid(DATA / "scenes/meshed_slider_crank.toml", "rod", "--set", "simulation.duration=1e-3",
                         "--set", "bodies.rod.solid.mesh.cells=[40,8]")  # cut by its outline

    def test_long_names_and_tiny_numbers(self):
        text = (DATA / "scenes/slider_crank.toml").read_text()
        lines = [line for line in text.splitlines() if not line.startswith("name")]
        (self.folder / "long.toml").write_text("\n".join([f'name = "{"long name " * 12}"', *lines]) + "\n")
        deck = exported(self.folder / "deck", self.folder / "long.toml", "rod", "--set", "simulation.duration=0.01")
        self.assertTrue(any("long name" in line for line in deck.control))

    def test_a_reader_that_reads(self):
        """What is wrong in a deck is found."""
        good = "SOL 101\nCEND\nTITLE = x\nBEGIN BULK\nGRID*                  1\n" + "*\nENDDATA\n"
        Deck(good)
        for bad in (good.replace("*\nEND", "END"), good.replace("       1\n", "     1.5\n"), good.replace("TITLE = x", "TITLE = " + 70 * "x"),
                    good.replace("ENDDATA\n", ""), good.replace("*\nEND", "*       " + 5 * "             0.0" + "\nEND"),
                    good.replace("GRID*", "GRIT*"), good.replace("GRID*                  1", "GRID*               1  2"),
                    good.replace("BEGIN", "SUBCASE 1\n  LOAD = 1\nBEGIN")):
            with self.assertRaises(DeckError):
                Deck(bad)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]], verbosity=1)
