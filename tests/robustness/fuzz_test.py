#!/usr/bin/env python3
"""Mutations of every shipped file: fuzz_test.py PROGRAM DATA COUNT [--first N] [--seconds S] [--keep DIR]

Each mutation goes through check and, if that accepts it, through run, esl or optimize; after S
seconds the command is asked to stop. Asserted: no signal, no hang (an end within 20 s of the request),
exit codes 0 to 3, a place in each refusal, no internal error, and no NaN in what is called done.
Mutation n is the same on every machine. Seconds are those of the processor (program.wait).
"""

import argparse
import json
import math
import random
import re
import shutil
import sys
import tempfile
from pathlib import Path

from mutate import mutated
from program import run, verdict

HANG = 20  # s
MEMORY = 3000  # MB
PLACE = re.compile(r":\d+:\d+: |^--\w+|: 'simulation\.|\.toml: |\.csv|\.msh", re.M)
NULLS = {  # numbers that docs/outputs.md allows to be missing; any other null is one that is not finite
    "at_time", "gain", "kkt_residual", "largest_deformation", "limit", "linear", "load_change", "modes", "modes_needed",
    "next", "nonlinear",
}  # fmt: skip
NOT_A_NUMBER = re.compile(r"(?<![\w])[-+]?(nan|inf)(?![\w])", re.I)


def commands(path):
    """What a shipped file is for."""
    if path.parent.name != "studies" or "/stability/" in path.as_posix():
        return ["run", "esl"] if path.parent.name != "studies" else ["optimize"]
    if path.name.startswith("sensitivity_"):
        return ["sensitivity"]
    return [] if path.name.startswith(("compare_", "batch_")) else ["optimize"]


def not_finite(value, path="", key=""):
    """Places in a summary of what is no number where one should stand, and of words that say so."""
    if isinstance(value, dict):
        return [p for k, v in value.items() for p in not_finite(v, f"{path}.{k}", k)]
    if isinstance(value, list):
        return [p for i, v in enumerate(value) for p in not_finite(v, f"{path}[{i}]", key)]
    if isinstance(value, str):  # names of files and texts of the input may hold anything
        told = key in ("reason", "warnings") and NOT_A_NUMBER.search(value)
        return [f"{path}: {value}"] if told else []
    bad = (value is None and key not in NULLS) or (isinstance(value, float) and not math.isfinite(value))
    return [f"{path}: {value}"] if bad else []


def check_not_finite():
    """It finds what it looks for."""
    fine = {"load_change": None, "mass": 1.5, "name": "nan", "history": [{"mass": 2, "modes": None}]}
    assert not_finite(fine) == []
    for worse in ({"mass": None}, {"mass": math.nan}, {"reason": "the worst is -nan"}):
        assert len(not_finite(fine | worse)) == 1, worse
    assert not_finite(fine | {"history": [{"mass": math.inf}]}) == [".history[0].mass: inf"]


def problems_of_results(out):
    """What is wrong with a result that says that all is well."""
    path = out / "summary.json"
    if not path.is_file():
        return ["it left no summary.json"]
    try:
        summary = json.loads(path.read_text())
    except ValueError as error:
        return [f"summary.json is no JSON: {error}"]
    if summary.get("status") not in ("done", "converged", "optimal"):
        return []
    problems = [f"status {summary['status']} with {place} in summary.json" for place in not_finite(summary)]
    for table in out.glob("*.csv"):
        if found := NOT_A_NUMBER.search(table.read_text()):
            problems.append(f"status {summary['status']} with {found.group()} in {table.name}")
    return problems


def problems_of_end(outcome):
    if outcome.hung:
        return [f"does not stop within {HANG} s"]
    if outcome.code not in (0, 1, 2, 3):
        return [f"exit code {outcome.code}: {outcome.last()}"]
    if outcome.code == 2 and not PLACE.search(outcome.text):
        return [f"refused without a place: {outcome.last()}"]
    if "internal error" in outcome.text:
        return [outcome.last()]
    return []


def try_mutation(program, data, number, seconds, place):
    """Defects of one mutation, and how far it went."""
    dice = random.Random(number)
    files = sorted(p for p in data.rglob("*.toml"))
    path = files[number % len(files)]
    original = path.read_text()
    path.write_text(mutated(dice, original), errors="surrogateescape")
    out = place / "out"
    try:
        outcome = run([program, "check", path], HANG, MEMORY)
        problems, stage = problems_of_end(outcome), "check"
        choice = commands(path.relative_to(data.parent))
        if not problems and outcome.code == 0 and choice:
            stage = dice.choice(choice)
            shutil.rmtree(out, ignore_errors=True)
            words = [program, stage, path, "-o", out, "--quiet", "--threads", "1"]
            outcome = run(words, HANG, MEMORY, ask_after=seconds)
            problems = problems_of_end(outcome)
            if not problems and outcome.code in (0, 1):
                problems = problems_of_results(out)
        text = path.read_text(errors="surrogateescape")
        return [f"{number} ({path.relative_to(data)}, {stage}): {f}" for f in problems], text, stage
    finally:
        path.write_text(original)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program", type=Path)
    parser.add_argument("data", type=Path)
    parser.add_argument("count", type=int)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--seconds", type=float, default=5)
    parser.add_argument("--keep", type=Path)
    options = parser.parse_args()
    check_not_finite()
    failures, stages = [], {}
    with tempfile.TemporaryDirectory(prefix="liesl_fuzz_") as folder:
        data = Path(folder) / "data"
        shutil.copytree(options.data.resolve(), data)
        program = options.program.resolve()
        for number in range(options.first, options.first + options.count):
            problems, text, stage = try_mutation(program, data, number, options.seconds, Path(folder))
            stages[stage] = stages.get(stage, 0) + 1
            failures += problems
            for problem in problems:
                print(problem, flush=True)
            if problems and options.keep:
                options.keep.mkdir(parents=True, exist_ok=True)
                (options.keep / f"{number}.toml").write_text(text, errors="surrogateescape")
    print("ended in", ", ".join(f"{name} {count}" for name, count in sorted(stages.items())))
    return verdict("fuzz", failures, options.count)


if __name__ == "__main__":
    sys.exit(main())
