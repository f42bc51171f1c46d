#!/usr/bin/env python3
"""The rod of the slider-crank in three thicknesses: change a key, run, plot.

Usage: change_and_run.py [PICTURE]
"""
import sys
from pathlib import Path

import matplotlib

import liesl

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

scene = liesl.Scene.load(Path(__file__).parent.parent / "scenes/slider_crank.toml")
for diameter in (0.010, 0.012, 0.014):
    result = scene.change({"sections.rod.diameter": diameter}).run().check()
    bend = 1e3 * result["responses/bend"][:, 0]
    plt.plot(1e3 * result.time, bend, label=f"{1e3 * diameter:.0f} mm")
    print(f"{1e3 * diameter:.0f} mm: bends up to {abs(bend).max():.3f} mm")
plt.xlabel("time [ms]")
plt.ylabel("deflection at midspan [mm]")
plt.legend(title="rod")
plt.savefig(sys.argv[1] if len(sys.argv) > 1 else "change_and_run.png", dpi=150)
