"""Integrals of responses by parameters against polynomials fitted to many differences, of the shipped
sensitivities, as a table: what differences tell at best where a motion has round-off.
PYTHONPATH=build/release/python /usr/bin/python3 docs/pictures/fitted_differences.py [NAME ...]

F(p (1 + x)) - F(p (1 - x)) is odd in x: c1 x + c3 x^3 + ... by least squares at 24 Chebyshev points of (0, H). Of all
windows H and numbers of terms the one is taken whose own standard error of c1, from the residuals of its fit, is
smallest; the gradient that is compared has no part in the choice."""
import sys
import tomllib
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np

import liesl

STUDIES = Path(__file__).resolve().parent.parent.parent / "data" / "studies"
TIGHT = {"simulation.tolerance": 1e-10, "simulation.tangent": "exact", "simulation.max_iterations": 60}
POINTS = 24
WINDOWS = (1e-2, 3e-3, 1e-3, 3e-4, 1e-4)
TERMS = range(1, 9)


def integral(values, time):
    return np.trapz(np.linalg.norm(values.reshape(len(time), -1), axis=1), time)


def gradient(result, name, by):
    """Of the integral, by the direct form."""
    y = result["responses/" + name].reshape(len(result.time), -1)
    size = np.maximum(np.linalg.norm(y, axis=1), 1e-300)
    return np.trapz(np.einsum("ij,ijk->ik", y, result.jacobian(name, by=by)) / size[:, None], result.time, axis=0)


def entry(scene, key):
    for part in key.split("."):
        scene = scene[int(part)] if part.isdigit() else scene[part]
    return scene


def changed(scene, data, keys, shift):
    """The scene with the keys of one parameter, which change by the same amount, shifted."""
    changes = {}
    for key in keys.split("+"):
        stem, _, last = key.rpartition(".")
        if not last.isdigit():
            changes[key] = entry(data, key) + shift
            continue
        changes.setdefault(stem, list(entry(data, stem)))[int(last)] += shift
    return scene.change(changes)


def best_fit(x, odd, window):
    """(standard error of c1, c1, terms) of the best number of terms."""
    fits = []
    for terms in TERMS:
        A = np.stack([(x / window) ** (2 * m + 1) for m in range(terms)], axis=1)
        c, *_ = np.linalg.lstsq(A, odd, rcond=None)
        noise = np.sum((odd - A @ c) ** 2) / (len(x) - terms)
        fits.append((np.sqrt(noise * np.linalg.inv(A.T @ A)[0, 0]) / window, c[0] / window, terms))
    return min(fits)


def study(name):
    text = tomllib.loads((STUDIES / f"sensitivity_{name}.toml").read_text())
    scene = liesl.Scene.load(str(STUDIES / text["scene"]), changes={**text["set"], **TIGHT})
    data, by = scene.to_dict(), text["by"]
    first = scene.run().check()
    responses = list(first.responses)
    values = np.array([entry(data, keys.split("+")[0]) for keys in by])
    exact = {r: gradient(first, r, by) * values for r in responses}
    for i, keys in enumerate(by):
        fits = {r: [] for r in responses}
        for window in WINDOWS:
            x = window * np.cos(np.pi * (np.arange(POINTS) + 0.5) / (2 * POINTS))

            def at(shift):
                result = changed(scene, data, keys, shift * values[i]).run().check()
                return [integral(result["responses/" + r], result.time) for r in responses]

            with ThreadPoolExecutor(2) as pool:
                F = np.array(list(pool.map(at, np.concatenate([x, -x]))))
            for j, r in enumerate(responses):
                fits[r].append((*best_fit(x, (F[:POINTS, j] - F[POINTS:, j]) / 2, window), window))
        for r in responses:
            error, slope, terms, window = min(fits[r])
            size = np.linalg.norm(exact[r])
            print(f"| {name} | {r} | {keys} | {exact[r][i]:+.6g} | {abs(slope - exact[r][i]) / size:.1e} | {error / size:.1e} "
                  f"| {window:g}, {terms} |", flush=True)


print("| motion | integral of | p | p dF/dp | fit off by | its standard error | window, terms |")
print("|---|---|---|---|---|---|---|")
for chosen in sys.argv[1:] or ["pendulum", "slider_crank", "four_bar"]:
    study(chosen)
