#!/usr/bin/env python3
"""Commands under limits of the address space: memory_test.py PROGRAM DATA [MB ...]

Each command must end by itself within 60 s, with a result or with "out of memory" (exit code 3).
Default: 64, 80, 90, 104, 128, 160, 256, 512 MB.
"""

import sys
import tempfile
from pathlib import Path

from program import run, verdict

SECONDS = 60


def result_to_draw(program, data, place):
    """A results folder for `plot`, made without a limit."""
    drawn = place / "drawn"
    short = ["--quiet", "--no-report", "--set", "simulation.duration=0.01"]
    outcome = run([program, "run", data / "scenes/slider_crank.toml", "-o", drawn, *short], SECONDS)
    assert outcome.code == 0, outcome.text
    return drawn


def commands(data, out, limit):
    """Name, command, and whether the limit is the process's or the batch's."""
    scene, study = data / "scenes", data / "studies"
    force = ["-o", out, "--force", "--quiet"]
    batch = out.parent / "batch.toml"
    batch.write_text(
        f'study = "{study}/slider_crank_rod.toml"\n'
        '[grid]\nlimit = { key = "constraints.bending.limit", values = [1e-3] }\n'
        f"[limits]\nmemory = {limit}\n"
    )
    return [
        (
            "run",
            ["run", scene / "slider_crank.toml", *force, "--set", "simulation.duration=0.01"],
            limit,
        ),
        ("static", ["run", data / "stability/buckling_links.toml", *force], limit),
        (
            "meshed run",
            ["run", scene / "meshed_slider_crank.toml", *force]
            + ["--set", "simulation.duration=0.002"],
            limit,
        ),
        (
            "optimize",
            ["optimize", study / "slider_crank_rod.toml", *force]
            + ["--set", "simulation.duration=0.01", "--set", "cycle.max=2"],
            limit,
        ),
        ("meshed optimize", ["optimize", study / "cantilever.toml", *force], limit),
        (
            "sensitivity",
            ["sensitivity", scene / "slider_crank.toml", *force, "--by", "sections.rod.diameter"]
            + ["--set", "simulation.duration=0.01"],
            limit,
        ),
        ("plot", ["plot", out.parent / "drawn"], limit),
        ("batch", ["batch", batch, "-o", out.parent / f"batch_{limit}", "-j", "1"], None),
    ]


def wrong(name, limit, outcome, out):
    """What is wrong with an end; None if nothing is."""
    if outcome.hung:
        return f"has not ended after {SECONDS} s"
    if name == "batch":  # its case is a row
        table = out.parent / f"batch_{limit}" / "results.csv"
        row = table.read_text().splitlines()[1] if table.is_file() else outcome.last()
        fine = outcome.code == 0 or (outcome.code == 1 and "out of memory" in row)
        return None if fine else f"exit code {outcome.code}: {row}"
    if outcome.code in (0, 1):
        return None
    if outcome.code == 3 and "out of memory" in outcome.text:
        return None
    return f"exit code {outcome.code}: {outcome.last()}"


def main():
    program, data = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
    limits = [int(w) for w in sys.argv[3:]] or [64, 80, 90, 104, 128, 160, 256, 512]
    failures, count = [], 0
    with tempfile.TemporaryDirectory(prefix="liesl_memory_") as folder:
        out = Path(folder) / "out"
        result_to_draw(program, data, out.parent)
        for limit in limits:
            for name, words, own in commands(data, out, limit):
                outcome = run([program, *words], SECONDS, own)
                count += 1
                problem = wrong(name, limit, outcome, out)
                print(f"{limit:5d} MB  {name:16s} exit {outcome.code:4d}  {outcome.last()[:70]}")
                if problem:
                    failures.append(f"{name} under {limit} MB {problem}")
    return verdict("memory", failures, count)


if __name__ == "__main__":
    sys.exit(main())
