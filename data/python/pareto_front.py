#!/usr/bin/env python3
"""Mass against deflection: the lightest rod for each limit, and what the price of the limit says about
its neighbours. Usage: pareto_front.py [PICTURE]
"""
import sys
from pathlib import Path

import matplotlib

import liesl

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

study = liesl.Study.load(Path(__file__).parent.parent / "studies/slider_crank_rod.toml",
                         {"scene.simulation.duration": 0.08})
limits = [0.0007, 0.0008, 0.0010, 0.0012, 0.0015]
masses = []
for limit in limits:
    best = study.change({"constraints.bending.limit": limit}).optimize().check()
    masses.append(best.summary["mass_final"])
    price = best.summary["prices"]["bending"]  # -d mass / d ln limit
    plt.plot([0.95e3 * limit, 1.05e3 * limit],
             [1e3 * (masses[-1] + 0.05 * price), 1e3 * (masses[-1] - 0.05 * price)], "C1", lw=3,
             label="slope by the price" if limit == limits[0] else None)
    print(f"{1e3 * limit:.1f} mm: {1e3 * masses[-1]:.1f} g, 1 % more allowed saves {10 * price:.2f} g")
plt.plot([1e3 * limit for limit in limits], [1e3 * mass for mass in masses], "o-", label="optima")
plt.xlabel("allowed deflection [mm]"), plt.ylabel("mass of the rod [g]"), plt.legend()
plt.savefig(sys.argv[1] if len(sys.argv) > 1 else "pareto_front.png", dpi=150)
