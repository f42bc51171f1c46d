"""Figures of data/studies/README.md about the batch of rods."""

import statistics

from sentences import Fresh, Sentence
from studies import MASS, OPTIMAL

# rad/s, kg, mm of the cases that end infeasible from the start of the study
HARD = [(140, 0.5, 0.5), (140, 0.5, 0.75), (145, 0.5, 0.5), (150, 0.4, 0.5), (150, 0.5, 0.5), (150, 0.5, 0.75)]


def keys_of(speed, mass, limit):
    return f"joints.motor.drive.rate={speed}", f"bodies.slider.rigid.mass={mass}", f"constraints.bending.limit={limit * 1e-3!r}"


def hard(run, speed, mass, limit):
    """A row of the table: how the first start ends, and what the second one finds."""
    def figures():
        keys = keys_of(speed, mass, limit)
        first, again = (run("optimize", "studies/slider_crank_rod", *keys, *more, words=("--no-verify",)).summary
                        for more in ((), ("cycle.restarts=3",)))
        return [Fresh(first["status"]), Fresh(again["mass_final"], relative=5 * MASS),
                Fresh(again["cycles"], relative=0.3), Fresh(again["kkt_residual"], most=OPTIMAL)]

    return Sentence(f"| {speed}, {mass}, {limit} | {{}} | {{:.4f}} kg | {{}} | {{:.2g}} |", figures)


def lighter(run):
    """The first row from another start."""
    def figures():
        found = run("optimize", "studies/slider_crank_rod", *keys_of(*HARD[0]), "design.rod_diameters.start=0.015", words=("--no-verify",))
        return [Fresh(found.summary["mass_final"], relative=5 * MASS)]

    return Sentence("(`--set design.rod_diameters.start=0.015`) the first row ends at {:.4f} kg", figures)


def sentences(run):
    return [*(hard(run, *case) for case in HARD), lighter(run)]


def whole(run):
    """All 200 rods."""
    def figures():
        batch = run("batch", "studies/batch_rod")
        cases = [case.summary for case in batch.cases()]
        optimal = [s for s in cases if s["status"] == "optimal" and s["refinement"]["holds"]]
        residuals = [s["kkt_residual"] for s in optimal]
        return [len(optimal), Fresh(statistics.median(residuals), most=OPTIMAL), Fresh(max(residuals), most=OPTIMAL)]

    return [Sentence("With the axis `restarts` {} of the 200 end optimal and their limits hold on the converged model (`refinement.holds`), "
                     "median KKT residual {:.4f}, largest {:.5f}", figures)]
