#!/usr/bin/env python3
"""The least mean square of bending instead of the least mass, at the mass of the uniform rod: one's own
objective and limit, minimised by SciPy and by Ipopt. Usage: own_objective.py [PICTURE]
"""
import sys
from pathlib import Path

import matplotlib
from scipy.optimize import minimize

import liesl

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

study = liesl.Study.load(Path(__file__).parent.parent / "studies/slider_crank_rod.toml",
                         {"scene.simulation.duration": 0.06, "constraints.bending.limit": 2e-3})
mass = study.evaluate().objective


def bending(at):
    y = 1e3 * at["responses/bending"]  # mm
    return (y ** 2).mean(), {"bending": 2e3 * y / y.size}


def heavier(at):
    return at.objective / mass - 1, {"x": study.mass_gradient(at.x) / mass}


nlp = study.nlp(objective=bending, limits={"mass": heavier})
by_scipy = minimize(method="SLSQP", **nlp.scipy())
by_ipopt = liesl.minimize(nlp, tolerance=1e-5).check()
print(f"start {nlp.objective(nlp.x0):.5f} mm^2, SciPy {by_scipy.fun:.5f}, Ipopt {by_ipopt.f:.5f}")
for name, x in (("uniform", nlp.x0), ("least bending", by_ipopt.x)):
    at = study.evaluate(x)
    plt.plot(1e3 * at.time, 1e3 * at["responses/bending"][:, 0], label=f"{name}, {at.objective:.3f} kg")
plt.xlabel("time [ms]"), plt.ylabel("deflection at midspan [mm]"), plt.legend()
plt.savefig(sys.argv[1] if len(sys.argv) > 1 else "own_objective.png", dpi=150)
