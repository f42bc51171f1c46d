#!/usr/bin/env python3
"""deck_test.py PROGRAM DATA: CalculiX gives back the deformation of a motion under the loads of
`liesl export --to calculix`.

Ends with 77 (skipped) without ccx (calculix-ccx).
"""

import csv
import subprocess
import sys
import tempfile
from pathlib import Path

from deck import displacements, need_calculix, run_deck

PROGRAM, DATA = sys.argv[1], Path(sys.argv[2])
need_calculix()

WITHIN = 0.01  # of the deflection, at every instant
WITHIN_BOX = 0.025  # the same: thin walls of B32R
WITHIN_TUBES = 0.015  # the same: tubes of several diameters


def expected(folder):
    """Case -> node -> (place, displacement)."""
    out = {}
    for row in csv.reader((folder / "displacements.csv").read_text().splitlines()[1:]):
        numbers = [float(x) for x in row[3:]]
        out.setdefault(int(row[0]), {})[int(row[2])] = numbers[:3], numbers[3:]
    return out


def computed(folder, part):
    """Step -> node -> displacement, at the end of each step: node k is 2k + 1."""
    return {round(time): {(node - 1) // 2: u for node, u in nodes.items()}
            for time, nodes in displacements(folder, part).items() if abs(time - round(time)) < 1e-9}


def deflection(places, displacements):
    """Offset of the middle node from the chord between the ends, in space."""
    at = [[x + u for x, u in zip(places[k], displacements[k])] for k in sorted(places)]
    first, last, middle = at[0], at[-1], at[len(at) // 2]
    chord = [b - a for a, b in zip(first, last)]
    length = sum(c * c for c in chord) ** 0.5
    offset = [m - a for a, m in zip(first, middle)]
    along = sum(c * o for c, o in zip(chord, offset)) / length
    return [o - along * c / length for c, o in zip(chord, offset)]


def norm(vector):
    return sum(v * v for v in vector) ** 0.5


def check(scene, part, *options, within=WITHIN):
    """Prints each instant. Number of instants that are wrong."""
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary) / "deck"
        if not run_deck(PROGRAM, DATA / scene, part, folder, options):
            return 1
        motion, deck, wrong = expected(folder), computed(folder, part), 0
        if sorted(motion) != sorted(deck) or not motion:
            print(f"{part}: {len(motion)} cases, {len(deck)} steps of CalculiX")
            return 1
        for case, nodes in motion.items():
            places = {k: x for k, (x, _) in nodes.items()}
            of_motion = deflection(places, {k: u for k, (_, u) in nodes.items()})
            of_deck = deflection(places, deck[case])
            error = norm([a - b for a, b in zip(of_deck, of_motion)]) / norm(of_motion)
            wrong += error > within
            bent = 100 * (norm(of_deck) / norm(of_motion) - 1)
            print(f"{scene} {part} {' '.join(options)}: case {case}: {1e3 * norm(of_motion):.4f} mm, "
                  f"CalculiX differs by {100 * error:.2f} %, bends by {bent:+.2f} %")
        return wrong


def optimised():
    """The design of a study whose rod has four diameters: outlines jump at three nodes."""
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary) / "design"
        subprocess.run([PROGRAM, "optimize", DATA / "studies/slider_crank_rod.toml", "-o", folder, "--no-verify",
                        "--no-report", "--quiet"], check=True)
        return sum(check(folder, "rod", *options) for options in ((), ("--set", "bodies.rod.beam.elements=16")))


def jumps(shapes, within=WITHIN):
    """A rod of several sections, one after another."""
    options = [f"sections.rod{i}={shape}" for i, shape in enumerate(shapes)]
    options.append("bodies.rod.beam.section=" + str([f"rod{i}" for i in range(len(shapes))]).replace("'", '"'))
    return check("scenes/slider_crank.toml", "rod", *(word for o in options for word in ("--set", o)), within=within)


wrong = optimised()
wrong += jumps(['{ type = "circle", diameter = %g }' % (0.009 + 0.002 * s) for s in
                (0, 0.2, 0.5, 0.8, 1, 0.7, 0.4, 0.1)])
wrong += jumps(['{ type = "rectangle", width = 0.009, height = 0.008 }', '{ type = "circle", diameter = 0.012 }',
                '{ type = "rectangle", width = 0.0093, height = 0.0110 }'])
wrong += jumps(['{ type = "tube", diameter = %g, thickness = 0.0018 }' % d for d in (0.010, 0.0125, 0.0105)],
               within=WITHIN_TUBES)
wrong += jumps(['{ type = "box", width = 0.010, height = %g, thickness = 0.0015 }' % h for h in (0.010, 0.013, 0.010)],
               within=WITHIN_BOX)
for elements in ("8", "16", "32"):
    wrong += check("scenes/slider_crank.toml", "rod", "--set", f"bodies.rod.beam.elements={elements}")
for shape, within in (('{ type = "tube", diameter = 0.012, thickness = 0.002 }', WITHIN),
                      ('{ type = "rectangle", width = 0.010, height = 0.010 }', WITHIN),
                      ('{ type = "box", width = 0.010, height = 0.012, thickness = 0.0015 }', WITHIN_BOX)):
    wrong += check("scenes/slider_crank.toml", "rod", "--set", f"sections.rod={shape}", within=within)
wrong += check("scenes/four_bar.toml", "coupler", "--set", "bodies.coupler.beam.elements=16")
sys.exit(1 if wrong else 0)
