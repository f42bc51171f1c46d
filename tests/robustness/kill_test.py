#!/usr/bin/env python3
"""Kills at random: kill_test.py PROGRAM DATA COUNT [--seed S] [--only optimize|batch]

COUNT optimisations and COUNT batches are killed (SIGKILL) at a random moment, once or twice, and then
gone on with. Asserted: what a kill leaves can be read, the command that goes on ends as an
undisturbed one with the same design to the last bit and the same counters, and nothing is left beside
the results.
"""

import argparse
import csv
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from program import run, verdict

SECONDS = 300
TIMES = {"wall_s", "cpu_s", "stepping_s", "peak_memory_mb"}


def start(words):
    return subprocess.Popen(
        [str(w) for w in words],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        start_new_session=True,
    )


def killed(words, after):
    """Kills a command's group after so many seconds; False if it has ended before."""
    process = start(words)
    try:
        process.wait(after)
        return False
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()
        return True


def left_over(out):
    """Half-written folders and files, beside the result and in it."""
    return [p.name for p in out.parent.rglob(".*") if ".part" in p.name]


def optimised(out):
    """What two optimisations must agree on."""
    summary = json.loads((out / "summary.json").read_text())
    keys = ["status", "design", "mass_final", "cycles", "steps", "newton_iterations"]
    return [{key: summary[key] for key in [*keys, "factorizations"]}]


def table(out):
    """Rows of a batch without what is a time or a memory."""
    with open(out / "results.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    return [{k: v for k, v in row.items() if k.split(" ")[0] not in TIMES} for row in rows]


class Optimisation:
    name = "optimize"

    def __init__(self, program, data, place):
        study = data / "studies/slider_crank_rod.toml"
        self.words = [program, "optimize", study, "--quiet", "--threads", "1"]
        self.words += ["--set", "simulation.duration=0.02", "-o"]

    def first(self, out):
        return self.words + [out]

    def next(self, out):
        going = (out / "checkpoint.json").is_file()
        return self.words + [out, "--resume" if going else "--force"]

    result = staticmethod(optimised)


class Batch:
    name = "batch"

    def __init__(self, program, data, place):
        batch = place / "batch.toml"
        batch.write_text(
            f'study = "{data}/studies/slider_crank_rod.toml"\n'
            '[grid]\nlimit = { key = "constraints.bending.limit", values = [7e-4, 8e-4, 1e-3] }\n'
        )
        self.words = [program, "batch", batch, "--quiet", "-j", "2"]
        self.words += ["--set", "simulation.duration=0.02", "-o"]

    def first(self, out):
        return self.words + [out]

    next = first
    result = staticmethod(table)


def try_kill(job, dice, duration, reference, out):
    """What is wrong after one or two kills; and how many there were."""
    kills = int(killed(job.first(out), dice.uniform(0, duration)))
    if dice.random() < 0.5:
        kills += killed(job.next(out), dice.uniform(0, duration))
    for path in out.rglob("*.json"):
        if any(".partial-" in part for part in path.relative_to(out).parts):
            continue  # no result yet
        try:
            json.loads(path.read_text())
        except ValueError as error:
            return f"{path.name} cannot be read after a kill: {error}", kills
    outcome = run(job.next(out), SECONDS)
    if outcome.hung or outcome.code != 0:
        return f"does not go on: exit code {outcome.code}, {outcome.last()}", kills
    found = job.result(out)
    if found != reference:
        other = [
            (key, row[key], wanted.get(key))
            for row, wanted in zip(found, reference)
            for key in row
            if row[key] != wanted.get(key)
        ]
        return f"ends elsewhere than without a kill: {other[:3]}", kills
    if left_over(out):
        return f"leaves {left_over(out)}", kills
    return None, kills


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program", type=Path)
    parser.add_argument("data", type=Path)
    parser.add_argument("count", type=int)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", default="")
    options = parser.parse_args()
    failures, count, kills = [], 0, 0
    with tempfile.TemporaryDirectory(prefix="liesl_kill_") as folder:
        for kind in (Optimisation, Batch):
            if options.only not in kind.name:
                continue
            place = Path(folder) / kind.name
            place.mkdir()
            job = kind(options.program.resolve(), options.data.resolve(), place)
            begin = time.monotonic()
            outcome = run(job.first(place / "undisturbed"), SECONDS)
            duration = time.monotonic() - begin
            if outcome.code != 0:
                failures.append(f"{kind.name} itself: exit code {outcome.code}: {outcome.last()}")
                continue
            reference = job.result(place / "undisturbed")
            dice = random.Random(options.seed)
            for number in range(options.count):
                out = place / str(number) / "out"
                out.parent.mkdir()
                problem, done = try_kill(job, dice, duration, reference, out)
                count, kills = count + 1, kills + done
                if problem:
                    failures.append(f"{kind.name} {number}: {problem}")
                shutil.rmtree(out.parent)
    print(f"{kills} kills")
    return verdict("kill", failures, count)


if __name__ == "__main__":
    sys.exit(main())
