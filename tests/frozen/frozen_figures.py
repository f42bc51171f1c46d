#!/usr/bin/env python3
"""Holds the figures of the shipped scenes, studies and comparisons: frozen_figures.py LIESL DATA

Runs every scene, study and comparison of DATA (the folder data/) that is listed in figures.json and
compares the numbers of its summary.json with those written there: figures of a simulation to 1e-9,
those of an optimised design to 1e-6, relative to the larger of the value and the size of its
response. Times, memory, versions and counts of iterations are not compared.

  --write        writes figures.json: those of the cases that are run and take less than --limit seconds
  --only NAME    only the cases whose name contains NAME (repeatable)

Ends with 1 and a line a figure if anything differs. Needs nothing but Python 3.
"""

import argparse
import json
import math
import subprocess
import sys
import tempfile
import time
from pathlib import Path

FIGURES = Path(__file__).with_name("figures.json")
SIMULATED, OPTIMISED = 1e-9, 1e-6
LEFT_OUT = {
    "command", "reason", "space_reason", "stepping_s", "sensitivity_s", "wall_s", "cpu_s", "peak_memory_mb", "versions",
    "input_sha256", "warnings", "overrides", "newton_iterations", "factorizations", "tangent_refreshes",
    "history", "identity", "kkt", "load_change", "max_constraint_residual", "ratios", "cycles", "steps",
    "worst_constraint", "violation", "kkt_residual", "load_cases", "load_cases_kept", "at_time",
    "velocity_change", "moved", "optimizer_iterations", "nucleation",
}  # fmt: skip


def cases(data):
    """Yields (name, command, file) of everything that is shipped."""
    for folder in ("scenes", "stability"):
        for file in sorted((data / folder).glob("*.toml")):
            yield f"{folder}/{file.stem}", "run", file
    for file in sorted((data / "studies").glob("*.toml")):
        if file.stem.startswith("compare_"):
            yield f"studies/{file.stem}", "compare", file
        elif file.stem.startswith("sensitivity_"):
            yield f"studies/{file.stem}", "sensitivity", file
        elif not file.stem.startswith("batch_"):
            yield f"studies/{file.stem}", "optimize", file


def figures_of(value, path="", size=0.0):
    """Yields (path, number, size): the numeric leaves that are held, and what they are relative to."""
    if isinstance(value, dict):
        own = value.get("max_abs", value.get("max_abs_final", 0.0))
        own = own if isinstance(own, (int, float)) else 0.0
        for key, inside in value.items():
            if key not in LEFT_OUT:
                yield from figures_of(inside, f"{path}/{key}", own)
    elif isinstance(value, list):
        for i, inside in enumerate(value):
            yield from figures_of(inside, f"{path}/{i}", size)
    elif isinstance(value, (int, float)) and not isinstance(value, bool):
        yield path, float(value), abs(size)
    elif isinstance(value, str) and path.endswith("/status"):
        yield path, value, 0.0


def run(liesl, command, file, folder):
    """Summary of one case and the seconds that it took; None if it wrote none."""
    begin = time.monotonic()
    subprocess.run(
        [liesl, command, str(file), "-o", str(folder), "--quiet"],
        stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False,
    )  # fmt: skip
    summary = folder / "summary.json"
    seconds = time.monotonic() - begin
    return (json.loads(summary.read_text()) if summary.exists() else None), seconds


def differences(name, frozen, now, tolerance):
    """Yields a line for each figure that is not what it was."""
    for path, (value, size) in frozen.items():
        if path not in now:
            yield f"{name}{path}: {value} is not written any more"
            continue
        new = now[path][0]
        if isinstance(value, str) or isinstance(new, str):
            same = value == new
        else:
            same = math.isclose(new, value, rel_tol=tolerance, abs_tol=tolerance * max(size, 1e-9))
        if not same:
            yield f"{name}{path}: {new} instead of {value}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("liesl")
    parser.add_argument("data", type=Path)
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--limit", type=float, default=60.0)
    parser.add_argument("--only", action="append", default=[])
    o = parser.parse_args()
    frozen = json.loads(FIGURES.read_text()) if FIGURES.exists() else {}
    written, wrong, held = dict(frozen), [], 0
    for name, command, file in cases(o.data):
        if o.only and not any(part in name for part in o.only):
            continue
        if not o.write and name not in frozen:
            continue
        with tempfile.TemporaryDirectory() as folder:
            summary, seconds = run(o.liesl, command, file, Path(folder) / "out")
        if summary is None:
            wrong.append(f"{name}: no summary.json")
            continue
        now = {path: (value, size) for path, value, size in figures_of(summary)}
        if o.write and seconds < o.limit:
            written[name] = now
        tolerance = OPTIMISED if command == "optimize" else SIMULATED
        lines = [] if o.write else list(differences(name, frozen[name], now, tolerance))
        wrong += lines
        held += len(now)
        print(f"{name:45} {seconds:7.1f} s  {len(now):5} figures  {len(lines)} differ", flush=True)
    if o.write:
        FIGURES.write_text(json.dumps(written, indent=0, sort_keys=True) + "\n")
    for line in wrong:
        print(line)
    print(f"{held} figures, {len(wrong)} of them differ")
    return 1 if wrong or held == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
