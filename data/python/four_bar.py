#!/usr/bin/env python3
"""A four-bar linkage written as a dict: the path of its coupler's middle. Usage: four_bar.py [PICTURE]"""
import sys

import matplotlib
import numpy as np

import liesl

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

A, B, D = np.array([0, 0, 0]), np.array([0, 0.1, 0]), np.array([0.3, 0, 0])
# C is 0.28 m from B and 0.20 m from D.
d = np.linalg.norm(D - B)
along, ahead = (D - B) / d, (0.28 ** 2 - 0.20 ** 2 + d ** 2) / (2 * d)
C = B + ahead * along + np.sqrt(0.28 ** 2 - ahead ** 2) * np.array([-along[1], along[0], 0])

bar = {"section": "bar", "material": "steel", "elements": 6}
scene = liesl.Scene({
    "name": "four-bar linkage",
    "materials": {"steel": {"E": 210e9, "nu": 0.3, "rho": 7850}},
    "sections": {"bar": {"type": "rectangle", "width": 0.006, "height": 0.010}},
    "bodies": {name: {"beam": {"from": a, "to": b, **bar}}
               for name, a, b in (("crank", A, B), ("coupler", B, C), ("rocker", D, C))},
    "joints": {name: {"revolute": ports, "axis": [0, 0, 1], **more} for name, ports, more in (
        ("A", ["ground", "crank.start"], {"drive": {"rate": 60, "ramp": 0.05}}),
        ("B", ["crank.end", "coupler.start"], {}), ("C", ["coupler.end", "rocker.end"], {}),
        ("D", ["ground", "rocker.start"], {}))},
    "simulation": {"duration": 0.25, "step": 2e-4}})
path = scene.run().check()["bodies/coupler/position"][:, 3]
plt.plot(*np.array([A, B, C, D])[:, :2].T, "ko-", label="start")
plt.plot(path[:, 0], path[:, 1], label="middle of the coupler")
plt.axis("equal"), plt.legend(), plt.xlabel("x [m]"), plt.ylabel("y [m]")
plt.savefig(sys.argv[1] if len(sys.argv) > 1 else "four_bar.png", dpi=150)
