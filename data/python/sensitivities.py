#!/usr/bin/env python3
"""What the bending of the rod depends on, over time: derivatives by keys of the scene, relative, and the
gradient of a number of the whole motion by one adjoint run. Usage: sensitivities.py [PICTURE]
"""
import sys
from pathlib import Path

import matplotlib

import liesl

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

keys = ["sections.rod.diameter", "materials.steel.E", "materials.steel.rho", "bodies.slider.rigid.mass"]
scene = liesl.Scene.load(Path(__file__).parent.parent / "scenes/slider_crank.toml")
result = scene.run().check()
values = [0.010, 210e9, 7850, 0.2]
jacobian = result.jacobian("bend", by=keys)  # (records, 1, parameters)
for i, (key, value) in enumerate(zip(keys, values)):
    plt.plot(1e3 * result.time, 10 * value * jacobian[:, 0, i], label=key)  # mm for 1 %
bend = result["responses/bend"]
gradient = result.vjp({"bend": 2 * bend / bend.size}, by=keys)  # of the mean square
for key, value, slope in zip(keys, values, gradient):
    print(f"1 % more of {key:<26} changes the mean square by {value * slope / (bend ** 2).mean():+.2f} %")
plt.xlabel("time [ms]"), plt.ylabel("change of the deflection by 1 % [mm]"), plt.legend()
plt.savefig(sys.argv[1] if len(sys.argv) > 1 else "sensitivities.png", dpi=150)
