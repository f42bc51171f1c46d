"""Figures of data/studies/README.md and data/stability/README.md."""

import math

from scenes import PLAIN, SOLID
from sentences import Fresh, Sentence

# How far ends of optimisations may lie apart with other kernels of OpenBLAS: masses, dimensions of designs,
# cycles. Residuals need only be those of an optimum that meets its limits.
MASS, SIZE, CYCLES = 2e-3, 0.03, 2
OPTIMAL, MET = 0.01, 1e-3

MM, GRAMS = 1e3, 1e3


def sizes(*names):
    """In mm; ("slot.b", 2) is twice the half-axis."""
    pairs = [name if isinstance(name, tuple) else (name, 1) for name in names]
    return lambda s: [Fresh(MM * factor * s["design"][name], relative=SIZE) for name, factor in pairs]


def numbered(name, count, first=0):
    return [f"{name}[{i}]" for i in range(first, first + count)]


def terms(*names):
    """Final values of terms of a weighted sum: (name, factor)."""
    return lambda s: [Fresh(factor * s["terms"][name]["final"], relative=MASS) for name, factor in names]


def after(first, then):
    return lambda s: [*first(s), *then(s)]


def objective(s):
    return [Fresh(s["objective"][key], relative=MASS) for key in ("initial", "final")]


# Study -> how its masses are written, and the last cells of its row: words and figures.
MASSES = "{:.6g} → {:.6g}"
ROWS = {
    "slider_crank_rod": (MASSES, "{:.2f}, {:.2f}, {:.2f}, {:.2f} mm", sizes(*numbered("rod_diameters", 4))),
    "slider_crank_both": (MASSES, "rod {:.2f}, {:.2f}, {:.2f}, {:.2f} mm; crank {:.2f}, {:.2f} mm",
                          sizes(*numbered("rod_diameters", 4), *numbered("crank_diameters", 2))),
    "rod_stiffest": (MASSES, "largest deflection {:.5f} mm; {:.2f}, {:.2f}, {:.2f}, {:.2f} mm",
                     after(terms(("bend", MM)), sizes(*numbered("rod_diameters", 4)))),
    "rod_frequency": (MASSES, "{:.2f} Hz; {:.2f}, {:.2f}, {:.2f}, {:.2f} mm",
                      after(terms(("lowest frequency", 1)), sizes(*numbered("rod_diameters", 4)))),
    "rod_goals": (MASSES, "{:.4f} mm, {:.2f} Hz; {:.2f}, {:.2f}, {:.2f}, {:.2f} mm",
                  after(terms(("bend", MM), ("lowest frequency", 1)), sizes(*numbered("rod_diameters", 4)))),
    "rod_three_speeds": (MASSES, "{:.2f}, {:.2f}, {:.2f}, {:.2f} mm", sizes(*numbered("rod_diameters", 4))),
    "robot_arms": (MASSES, "walls {:.2f}, {:.2f}, {:.2f} mm; {:.2f}, {:.2f}, {:.3f} mm",
                   sizes(*numbered("arm1_walls", 3), *numbered("arm2_walls", 3))),
    "robot_codesign": (MASSES, "{:.3f} s instead of 0.6 s", lambda s: [Fresh(s["design"]["duration"], relative=MASS)]),
    "robot_speed": (MASSES, "{:.4f} s instead of 0.6 s", lambda s: [Fresh(s["design"]["duration"], relative=MASS)]),
    "svanberg_cantilever": (MASSES, "", lambda s: []),
    "truss_10": (MASSES, "{:.2f} lb", lambda s: [Fresh(s["mass_final"] / POUND, relative=MASS)]),
    "truss_25": (MASSES, "{:.2f} lb", lambda s: [Fresh(s["mass_final"] / POUND, relative=MASS)]),
    "truss_72": (MASSES, "{:.2f} lb", lambda s: [Fresh(s["mass_final"] / POUND, relative=MASS)]),
    "connecting_rod": (MASSES, "height {:.1f} mm; holes {:.0f} mm high", sizes("height", ("b3", 2))),
    "four_bar_mixed": (MASSES, "crank {:.1f} × {:.1f} mm; coupler {:.1f} mm high, slots {:.1f} mm; rocker {:.1f} mm, slots {:.1f} mm",
                       sizes("crank_width", "crank_height", "coupler_height", ("coupler_b", 2), "rocker_height", ("rocker_b", 2))),
    "plate_with_hole": (MASSES, "f^T u {:.1f} → {:.1f} J; half-axes {:.1f} and {:.1f} mm",
                        lambda s: [*objective(s), *sizes("a", "b")(s)]),
    "cantilever": (MASSES, "height {:.1f} mm", sizes("height")),
    "cantilever_holes": ("{:.3f} → {:.3f}", "f^T u {:.3e} J", lambda s: objective(s)[1:]),
    "connecting_rod_3d": (MASSES, "height {:.1f} mm; holes {:.0f} mm high, pockets {:.0f} mm high and {:.0f} mm deep",
                          sizes("height", ("b3", 2), "pocket_height", ("pocket_depth", 0.5))),
    "robot_arm_lattice": (MASSES, "sizes {:.1f}, {:.1f}, {:.1f}, {:.1f}, {:.1f}, {:.1f}, {:.1f} mm, n1 = {:.0f}",
                          after(sizes(*(f"size{i}" for i in range(1, 8))), lambda s: [s["design"]["roundness"]])),
}
POUND = 0.45359237  # kg


# Studies whose plain cycle and optimum of the motion have a row of their own -> how far the end of the plain cycle may lie
# elsewhere: of four_bar_mixed rounding decides between two.
BEFORE_AFTER = {"slider_crank_rod": MASS, "robot_arms": MASS, "slider_crank_both": MASS, "four_bar_mixed": 8e-3, "connecting_rod": MASS,
                "robot_arm_lattice": MASS}


def uniform_mass(d):
    """Of the rod of slider_crank with one diameter, kg."""
    return 7850 * 0.3 * math.pi / 4 * d ** 2


def expectations(study):
    """What the first table says of ends."""
    def catalogue():
        s = study("rod_catalogue").summary["catalogue"]
        return [100 * s["above_continuous"], Fresh(s["continuous"], relative=MASS)]

    def frequencies():
        limit = 0.21515  # kg, of rod_frequency
        uniform = math.sqrt(limit / uniform_mass(1))
        start = study("rod_frequency", f"design.rod_diameters.start={uniform!r}", "cycle.max=1", words=("--no-verify",)).summary
        return [Fresh(study("rod_frequency").summary["terms"]["lowest frequency"]["final"], relative=MASS),
                start["terms"]["lowest frequency"]["initial"]]

    def speeds():
        return [100 * (study("rod_three_speeds").summary["mass_final"] / study("slider_crank_rod").summary["mass_final"] - 1)]

    def other_truss():
        wide = [f"design.b{i}.start={math.sqrt(4 / math.pi * 20) * 0.0254!r}" for i in range(1, 11)]  # of 20 in^2
        return [Fresh(study("truss_10", *wide).summary["mass_final"] / POUND, relative=MASS)]

    return [
        Sentence("{:.0f} % heavier than the continuous optimum on the mesh of the scene ({:.5f} kg)", catalogue),
        Sentence("{:.1f} Hz; the uniform rod of that mass has {:.1f} Hz", frequencies),
        Sentence("the fastest motion decides; {:.0f} % heavier than for the rated speed alone", speeds),
        Sentence("from 20 in² {:.2f} lb, another local optimum", other_truss),
        Sentence("finds a height of {:.1f} mm and {:.5f} kg for a sag of 0.4 mm",
                 lambda: [*sizes("height")(study("cantilever").summary), Fresh(study("cantilever").summary["mass_final"], relative=MASS)]),
    ]


def without_openings(run, study):
    """Parts as wide as the mesh allows, against the designs of their studies."""
    def lighter(name, mass):
        return Fresh(100 * (1 - study(name).summary["mass_final"] / mass), within=2)

    def solid(name, part, change):
        s = run("run", f"scenes/{name}", change)
        return s, s.summary["parts"][part]["mass"]

    def rod():
        mass = solid("connecting_rod", "rod", SOLID)[1]
        return [mass, lighter("connecting_rod", mass)]

    def holes_alone():
        mass = solid("connecting_rod", "rod", SOLID)[1]
        end = study("connecting_rod", "design.height.bounds=[0.0439,0.044]").summary["mass_final"]
        return [Fresh(end, relative=MASS), Fresh(100 * (1 - end / mass), within=2)]

    def rod_in_space():
        s, mass = solid("connecting_rod_3d", "rod", SOLID)
        return [1e6 * s.largest("elongation"), mass, lighter("connecting_rod_3d", mass)]

    def arm():
        s, mass = solid("robot_arm_lattice", "arm", PLAIN)
        return [mass, MM * s.largest("arm_tip"), lighter("robot_arm_lattice", mass)]

    return [
        Sentence("The connecting rod without holes has {:.5f} kg (`ctest --test-dir build/release -R 'apps.ConnectingRod$'` "
                 "compares): the optimum is {:.1f} % lighter", rod),
        Sentence("it ends at {:.5f} kg, {:.1f} % lighter", holes_alone),
        Sentence("stretches by {:.2f} um on the 60 × 16 × 8 cells (1.5 times is the limit) and has {:.5f} kg: the design is {:.1f} % "
                 "lighter", rod_in_space),
        Sentence("The arm without openings has {:.5f} kg and moves by {:.3f} mm: with 1 mm allowed it is {:.1f} % lighter", arm),
    ]


def row(run, study):
    """A row of the table of ends."""
    masses, design, figures_of = ROWS[study]
    words = f"| {study} | {{}} | {{}} | {masses} | {{:+.1e}} | {{:.2g}} | {design}"

    def figures():
        s = run("optimize", f"studies/{study}").summary
        end = [Fresh(s["status"]), Fresh(s["cycles"], within=CYCLES), Fresh(s["mass_initial"], relative=1e-4),
               Fresh(s["mass_final"], relative=MASS), Fresh(s["worst_constraint"], most=MET), Fresh(s["kkt_residual"], most=OPTIMAL)]
        return [*end, *figures_of(s)]

    return Sentence(words, figures)


def before_after(run, name):
    """A row of the plain cycle and of the one that ends at the optimum of the motion, on the model of the scene."""
    apart = BEFORE_AFTER[name]

    def figures():
        plain, motion = (run("optimize", f"studies/{name}", words=("--method", method, "--no-verify")).summary for method in ("esl", "esl1"))
        kkt = Fresh(plain["kkt_residual"], relative=0.1) if apart == MASS else Fresh(plain["kkt_residual"], most=0.05)
        return [Fresh(plain["mass_initial"], relative=1e-5), Fresh(plain["cycles"], within=CYCLES), Fresh(plain["mass_final"], relative=apart), kkt,
                Fresh(motion["cycles"], within=CYCLES), Fresh(motion["mass_final"], relative=MASS), Fresh(motion["kkt_residual"], most=OPTIMAL)]

    note = "" if apart == MASS else " (rounding decides, see below)"
    return Sentence(f"| {name} | {{:.6f}} | {{}}, {{:.6f}}, {{:.2g}}{note} | {{}}, {{:.6f}}, {{:.2g}} |", figures)


def methods(run):
    return [before_after(run, name) for name in BEFORE_AFTER]


def other_meshes(study):
    """The connecting rod where its edge ends on a line of the mesh; in space on coarser cells."""
    def figures():
        s = study("connecting_rod", 'set={"bodies.rod.solid.mesh.cells"=[150,30]}', words=("--no-verify",)).summary
        return [Fresh(s["mass_final"], relative=2e-4)]

    def in_space():
        s = study("connecting_rod_3d", 'set={"bodies.rod.solid.mesh.cells"=[30,8,4]}').summary
        return [Fresh(s["cycles"], within=CYCLES), Fresh(s["mass_final"], relative=MASS)]

    return [Sentence("where the limit has a kink: {:.3f} kg,", figures),
            Sentence("it takes {} cycles and ends at {:.5f} kg", in_space),
            Sentence("Its end is optimal by the residual ({:.2g})", lambda: [Fresh(study("connecting_rod_3d").summary["kkt_residual"], most=OPTIMAL)])]


def openlsto(run, study):
    """The cantilever with holes against the published design, by an element that shares nothing with the program."""
    def measured(*names):
        return lambda: [Fresh(run.properties("CantileverHolesSlow.*")[name], relative=MASS) for name in names]

    def theirs():
        found = run.properties("CantileverHolesSlow.*")
        return [Fresh(found["compliance"], relative=MASS), Fresh(100 * (1 - found["compliance"] / found["published"]), within=2)]

    def end():
        s = study("cantilever_holes").summary
        return [Fresh(s["cycles"], within=CYCLES), Fresh(s["objective"]["final"], relative=MASS)]

    return [
        Sentence("| OpenLSTO | {:.3f} |", measured("published")),
        Sentence("plain bilinear cells, force on one node | {:.3f}, {:.1f} % less |", theirs),
        Sentence("cells with incompatible modes, force on three nodes | {:.3f} |", measured("own")),
        Sentence("(convex bound of sheets of variable thickness) | {:.3f} |", measured("least_compliance")),
        Sentence("The study takes {} cycles; its compliance is {:.3e} J for 1 kN", end),
    ]


def sentences(run):
    def study(name, *changes, words=(), kernel=None):
        return run("optimize", f"studies/{name}", *changes, words=words, kernel=kernel)

    def plain():
        return [study(name, "cycle.method=esl").summary for name in ("slider_crank_rod", "slider_crank_both", "robot_arms", "four_bar_mixed")]

    def plain_ends():
        s = plain()
        mass, kkt = ([Fresh(one[key], relative=r) for one in s] for key, r in (("mass_final", MASS), ("kkt_residual", 0.1)))
        # of four_bar_mixed rounding decides: 0.3100 or 0.3116 kg (data/studies/README.md)
        return [*mass[:3], *kkt[:3], Fresh(s[3]["mass_final"], relative=6e-3)]

    def best_uniform():
        """Diameter and mass of the lightest that bends by 1 mm; the start; the optimum and what it saves."""
        below, above = 0.0112, 0.0118  # m
        for _ in range(16):
            d = 0.5 * (below + above)
            bend = run("run", "scenes/slider_crank", f"sections.rod.diameter={d!r}").largest("bend")
            below, above = (d, above) if MM * bend > 1 else (below, d)
        mass, s = uniform_mass(above), study("slider_crank_rod").summary
        return [MM * above, mass, s["mass_initial"], MM * s["constraints"]["bending"]["max_abs_initial"],
                Fresh(s["mass_final"], relative=MASS), Fresh(100 * (1 - s["mass_final"] / mass), within=2)]

    def of_order_2():
        order = [f"bodies.{link}.beam.order=2" for link in ("rod", "crank")]
        coarse = study("slider_crank_rod", *order, "cycle.refine=never").summary["mass_final"]
        hidden = study("slider_crank_rod", *order).summary["refinement"]["steps"][0]["worst_constraint_error"]
        return [Fresh(coarse, relative=MASS), 100 * hidden]

    def holes():
        tried = study("cantilever", words=("--nucleate",), kernel="Haswell").summary["nucleation"]["tried"]
        return [t for t in tried if t["kept"]]

    def hole(i):
        def figures():
            t = holes()[i]
            loose = i > 0  # where the next hole goes depends on how the last round ended
            x, y = (Fresh(MM * t["place"][c], within=80 if loose else 2) for c in (0, 1))
            gain = Fresh(t["gain"], relative=0.5 if loose else 0.02)
            masses = [Fresh(t[key], relative=5e-3 if loose else MASS) for key in (("objective_before", "objective") if i == 0 else ("objective",))]
            return [x, y, gain, *masses]

        return Sentence(f"| {i + 1} | {{:.0f}}, {{:.0f}} | {{:.0f}} | " + ("{:.5f} → {:.5f} |" if i == 0 else "→ {:.5f} |"), figures)

    def catalogue():
        s = study("rod_catalogue").summary
        return [Fresh(s["status"]), Fresh(s["catalogue"]["designs"], within=10), s["mass_initial"], Fresh(s["mass_final"], relative=MASS),
                Fresh(s["worst_constraint"], relative=SIZE), Fresh(s["catalogue"]["continuous_kkt_residual"], most=OPTIMAL),
                *(MM * x for x in s["design"].values())]

    def svanberg():
        x = study("svanberg_cantilever").summary["design"]
        return [Fresh((width - 2e-5) / 0.01, within=2) for width in x.values()]

    return [
        *(row(run, name) for name in ROWS),
        Sentence("| rod_catalogue | {} | {} | {:.6g} → {:.6g} | {:.2g} | – ({:.2g} of the continuous optimum) | {:.0f}, {:.0f}, {:.0f}, {:.0f} mm |",
                 catalogue),
        Sentence("by local bounds, with {} designs simulated", lambda: catalogue()[1:2]),
        Sentence("x = ({:.5f}, {:.5f}, {:.5f}, {:.5f}, {:.5f}) |", svanberg),
        Sentence("ends at {:.6f}, {:.6f} and {:.6f} kg on the first three, with residuals of {:.2f}, {:.2f} and {:.2f}, "
                 "and at {:.4f} kg, give or take 0.6 %, on four_bar_mixed", plain_ends),
        *other_meshes(study),
        *openlsto(run, study),
        *expectations(study),
        *without_openings(run, study),
        Sentence("1 % more bending allowed saves {:.1f} g of slider_crank_rod",
                 lambda: [GRAMS / 100 * study("slider_crank_rod").summary["prices"]["bending"]]),
        Sentence("{:.2f} mm, {:.5f} kg; the start, rounded up, has {:.5f} kg (bend {:.5f} mm). Four diameters need {:.5f} kg, {:.1f} % less",
                 best_uniform),
        Sentence("they seem to need {:.5f} kg (`--set cycle.refine=never`); that mesh hides {:.1f} % of the bending", of_order_2),
        Sentence("The plain ESL cycle ends at {:.5f} kg", lambda: plain_ends()[:1]),
        *map(hole, range(6)),
        Sentence("enough from all edges: {:.5f} kg, {:.0f} % lighter", lambda: [
            Fresh(holes()[-1]["objective"], relative=5e-3), 100 * (1 - holes()[-1]["objective"] / holes()[0]["objective_before"])]),
    ]


def stability(run):
    def end(name):
        return run("optimize", f"stability/studies/{name}").summary

    return [
        Sentence("do not hold: residual {:.1g}, 'x1' should shrink", lambda: [end("esl_non_optimal")["kkt_residual"]]),
        Sentence("the best design is returned ({:.3f} mm;", lambda: [1e3 * end("esl_oscillates")["design"]["x"]]),
    ]
