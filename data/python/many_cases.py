#!/usr/bin/env python3
"""The lightest rod for six speeds of the crank, each case in a process. Usage: many_cases.py [PICTURE]"""
import multiprocessing
import sys
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import liesl

STUDY = Path(__file__).parent.parent / "studies/slider_crank_rod.toml"
SPEEDS = [100, 110, 120, 130, 140, 150]


def lightest(speed):
    study = liesl.Study.load(STUDY, {"scene.joints.motor.drive.rate": speed,
                                     "scene.simulation.duration": 0.08})
    best = study.optimize()
    return best.status, 1e3 * best.summary["mass_final"]


if __name__ == "__main__":
    with ProcessPoolExecutor(2, mp_context=multiprocessing.get_context("spawn")) as pool:
        cases = list(pool.map(lightest, SPEEDS))
    for speed, (status, mass) in zip(SPEEDS, cases):
        print(f"{speed} rad/s: {mass:.1f} g, {status}")

    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    plt.plot(SPEEDS, [mass for _, mass in cases], "o-")
    plt.xlabel("speed of the crank [rad/s]"), plt.ylabel("lightest rod [g]")
    plt.savefig(sys.argv[1] if len(sys.argv) > 1 else "many_cases.png", dpi=150)
