"""Figures of data/scenes/README.md."""

import math

from sentences import Fresh, Sentence

STILL = "gravity=[0,0,0]"
FINE = "simulation.step=2.5e-5"
SIXTEEN = ("bodies.crank.beam.elements=16", "bodies.rod.beam.elements=16")
# Meshed parts without their openings.
SOLID = ('bodies.rod.solid.outline={plate={type="rectangle",x=0.0975,width=0.243,height=0.044,fillet=0.02},'
         'big_bore={type="circle",radius=0.012},small_bore={type="circle",x=0.2,radius=0.008},'
         'rod={type="difference",of=["plate","big_bore","small_bore"]}}')
PLAIN = 'bodies.arm.solid.outline={plate={type="rectangle",x=0.3,width=0.68,height=0.088,fillet=0.03}}'
# Wilson's top of Brules, Cardona and Arnold, exact at 1 s.
CENTRE, OMEGA = (0.17334, 0.64009, -0.74849), (-0.8221, 150, -5.9233)
# Of bend45: where the tip is before the load.
TIP = (100 * math.sin(math.pi / 4), 100 * (1 - math.cos(math.pi / 4)), 0)


def error(found, exact):
    return max(abs(a - b) for a, b in zip(found, exact))


def sentences(run):
    def scene(name, *changes):
        return run("run", f"scenes/{name}", *changes)

    def bend(*changes):
        return 1e3 * scene("slider_crank", *changes).largest("bend")

    def top():
        return scene("heavy_top", "simulation.step=0.001")

    def screws():
        steps = (1e-3, 5e-4, 2.5e-4)
        return [scene("heavy_top", f"simulation.step={h}", 'simulation.update="se3"') for h in steps]

    def moved(*changes):
        return [a - b for a, b in zip(scene("bend45", *changes).final("tip"), TIP)]

    def elongation(*changes):
        return 1e6 * scene("meshed_slider_crank", *changes).largest("elongation")

    def counts(*names):
        return lambda: [scene(*names).summary[key] for key in ("steps", "newton_iterations")]

    def many(count):
        """Corrections that rounding may change by a few."""
        return Fresh(count, relative=0.01)

    def corrections(name):
        def figures():
            s = scene(name).summary
            return [s["steps"], many(s["newton_iterations"]), s["newton_iterations"] / s["steps"]]

        return Sentence(f"| {name} | {{}} | {{}} | {{:.1f}} |", figures)

    def both_cranks():
        s = [scene("slider_crank").summary, scene("slider_crank", STILL).summary]
        n = [one["newton_iterations"] for one in s]
        return [s[0]["steps"], *map(many, n), *(count / s[0]["steps"] for count in n)]

    far = ("bodies.beam.beam.elements=40", "simulation.step=2.5e-3")
    return [
        Sentence("| slider_crank, `--set gravity=[0,0,0]` | largest `bend` [mm] | {:.5f} |", lambda: [bend(STILL)]),
        Sentence("| | `slider_x` at 0.12 s [m] | {:.6f} |", lambda: [scene("slider_crank", STILL).final("slider_x")]),
        Sentence("| ..., `--set simulation.step=2.5e-5` | largest `bend` [mm] | {:.5f} |", lambda: [bend(STILL, FINE)]),
        Sentence("| ..., and 16 elements in crank and rod | largest `bend` [mm] | {:.5f} |", lambda: [bend(STILL, FINE, *SIXTEEN)]),
        Sentence("0.006, 0.008, 0.012, 0.016 | largest `bend` [mm] | {:.3f}, {:.3f}, {:.3f}, {:.3f} |",
                 lambda: [bend(STILL, f"sections.rod.diameter={d}") for d in (0.006, 0.008, 0.012, 0.016)]),
        Sentence("| slider_crank as shipped (with gravity) | largest `bend` [mm] | {:.5f} |", lambda: [bend()]),
        Sentence("| `tip` at 0.5 s [m] | ({:.6f}, {:.6f}) |", lambda: scene("pendulum").at("tip", 0.5, "xy")),
        Sentence("| | `tip` at 1 s [m] | ({:.6f}, {:.6f}) | (-0.99760", lambda: scene("pendulum").final("tip")[:2]),
        Sentence("| `tip` at 1 s [m] | ({:.6f}, {:.6f}) | (-0.99752",
                 lambda: scene("pendulum", "simulation.step=1e-4").final("tip")[:2]),
        Sentence("| heavy_top (h = 1e-3) | `centre` at 1 s [m] | ({:.5f}, {:.5f}, {:.5f}) |", lambda: top().final("centre")),
        Sentence("| | `omega` at 1 s [rad/s] | ({:.4f}, {:.0f}, {:.4f}) |", lambda: top().final("omega")),
        Sentence("largest component [m] | {:.4f}, {:.4f}, {:.4f} |", lambda: [error(t.final("centre"), CENTRE) for t in screws()]),
        Sentence("| | error of `omega` [rad/s] | {:.2f}, {:.3f}, {:.4f} |", lambda: [error(t.final("omega"), OMEGA) for t in screws()]),
        Sentence("| roll_up | `tip` [m] | ({:.0e}, {:.0e}) | (0, 0); {} load step, {} corrections |",
                 lambda: [*(Fresh(x, most=1e-12) for x in scene("roll_up").final("tip")[:2]), *counts("roll_up")()]),
        Sentence("| bend45 (8 elements) | `tip` moves by [m] | ({:.4f}, {:.4f}, {:.4f}) |", moved),
        Sentence("53.3332); {} load step, {} corrections |", counts("bend45")),
        Sentence("| ..., `--set bodies.beam.beam.elements=16` | `tip` moves by [m] | ({:.4f}, {:.4f}, {:.4f}) |",
                 lambda: moved("bodies.beam.beam.elements=16")),
        Sentence("| flying_beam (10 elements, h = 0.01) | `A` at 2.5 s | ({:.4f}, {:.4f}, {:.4f}) | converged (3.413, 0.197, 0.017) | "
                 "| | `B` at 2.5 s | ({:.4f}, {:.4f}, {:.4f}) | converged (4.024, 8.496, -0.733) | "
                 "| | `A` at 5 s | ({:.4f}, {:.4f}, {:.4f}) | converged (19.560, 1.520, -1.507) | "
                 "| | `B` at 5 s | ({:.4f}, {:.4f}, {:.4f}) |",
                 lambda: [x for time in (2.5, 5) for end in "AB" for x in scene("flying_beam").at(end, time)]),
        Sentence("| ..., 40 elements, h = 2.5e-3 | `A` at 5 s | ({:.4f}, {:.4f}, {:.4f}) | converged (19.560, 1.520, -1.507) | "
                 "| | `B` at 5 s | ({:.4f}, {:.4f}, {:.4f}) |",
                 lambda: [x for end in "AB" for x in scene("flying_beam", *far).at(end, 5)]),
        Sentence("largest `lag` [m] | {:.4f}, {:.4f}, {:.4f} |",
                 lambda: [scene("spin_up", f"bodies.beam.beam.elements={n}").largest("lag") for n in (5, 10, 40)]),
        Sentence("| | `extension` at 20 s [m] | {:.3e} (10 elements) |", lambda: [scene("spin_up").final("extension")]),
        Sentence("least and largest `elongation` [µm] | {:.2f}, {:.2f} |",
                 lambda: [1e6 * end(scene("meshed_slider_crank").column("elongation")[1]) for end in (min, max)]),
        Sentence("0, 2, 4, 16, 32 | largest size of `elongation` [µm] | {:.3f}, {:.3f}, {:.3f}, {:.3f}, {:.3f} |",
                 lambda: [elongation(f"bodies.rod.solid.modes={n}") for n in (0, 2, 4, 16, 32)]),
        Sentence("| ..., `--set simulation.step=` 2.5e-5, 1.25e-5 | the same | {:.3f}, {:.3f} |",
                 lambda: [elongation(f"simulation.step={h}") for h in (2.5e-5, 1.25e-5)]),
        Sentence("half the cells (`cells=[75, 15]`) | the same | {:.2f} |", lambda: [elongation("bodies.rod.solid.mesh.cells=[75,15]")]),
        Sentence("cells) | largest `elongation` [µm] | {:.2f} |", lambda: [1e6 * scene("connecting_rod_3d").largest("elongation")]),
        Sentence("without holes and pockets | the same | {:.2f} |",
                 lambda: [1e6 * scene("connecting_rod_3d", SOLID).largest("elongation")]),
        Sentence("largest `arm_tip` [mm], without openings | {:.3f} |",
                 lambda: [1e3 * scene("robot_arm_lattice", PLAIN).largest("arm_tip")]),
        Sentence("| gear_hoist | `lift` at the end [m] | {:.6f} |", lambda: [scene("gear_hoist").final("lift")]),
        Sentence("| crane_boom | `angle` at the end [rad] | {:.6f} |", lambda: [scene("crane_boom").final("angle")]),
        Sentence("| slider_crank, with / without gravity | {} | {} / {} | {:.1f} / {:.1f} |", both_cranks),
        *map(corrections, ("pendulum", "two_link_robot", "four_bar", "spin_up", "flying_beam", "heavy_top")),
    ]
