#!/usr/bin/env python3
"""The table of traps: traps_test.py PROGRAM ROOT [--all] [--write] [--show]

Runs every trap of traps.toml under se3, with --all under every formalism, and compares exit code,
status and words. Without a program to run (PROGRAM "-") and always besides: docs/traps.md is the page
of the table; --write makes it. --show prints every ending as it is.
"""

import argparse
import json
import sys
import tempfile
import tomllib
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "robustness"))
from program import run, verdict  # noqa: E402

FORMALISMS = ["se3", "r3so3", "classical", "floating", "rigid", "segments"]
SECONDS = 300
HEAD = """# Traps

<!-- Made by tests/traps/traps_test.py --write of tests/traps/traps.toml; do not edit. -->

What would be wrong without a word, and what liesl says instead: the status of `summary.json` (or "refused", exit
code 2) and words of a warning, the reason or the refusal. Each trap runs under every formalism (`simulation.formalism`);
"the same" means status and words of the third and fourth column. Scenes are in [tests/traps](../tests/traps/traps.toml)
and [data/stability](../data/stability/README.md), with the keys named changed. The whole table is a test,
`python3 tests/traps/traps_test.py build/release/bin/liesl . --all`.

Traps that are no scene with a status, but a figure, a file, a study or a process, are tests of their own:

| traps | tests |
|---|---|
| modes and critical loads out of the plane, peaks between records, axes of a displacement, steps under damping, edges on grid lines | `TrapFigures` (`tests/apps/cli/traps_test.cpp`) |
| motions that leave their plane | `PlaneStability` (`tests/mbs/solvers/plane_stability_test.cpp`) |
| section forces and stress at nodes, not in the middle | `NodeForce`, `NodeForces` (`tests/mbs/system/node_force_test.cpp`) |
| weight that strikes at the start | `StruckStart` (`tests/apps/tasks/motion_notes_test.cpp`) |
| parts beyond what is linear | `PartRange` (`tests/apps/tasks/part_range_test.cpp`) |
| statuses that speak of another design | `Optimality` (`tests/optim/cycle/cycle_test.cpp`) |
| gradients at kinks | `CheckDerivatives` (`tests/optim/nlp/check_derivatives_test.cpp`) |
| what is refused or told, with its words | `Refusals` (`tests/apps/cli/refusals_test.cpp`) |
| foreign files, two runs into one folder, killed drawings | `OwnFiles`, `AtomicFolder` (`tests/apps/output`) |
| batches on a full disk, resumed runs | `BatchProgram` (`tests/apps/batch/batch_test.cpp`), `Resume` (`tests/optim/cycle/resume_test.cpp`) |
| short memory, kills, mutated input | `memory_test.py`, `kill_test.py`, `fuzz_test.py` (`tests/robustness`) |

"""


def read_traps():
    with open(HERE / "traps.toml", "rb") as file:
        return tomllib.load(file)["trap"]


def expected(trap, formalism):
    """Status and words."""
    status, words = trap["status"], trap.get("words", "")
    other = trap.get("under", {}).get(formalism)
    if other is None:
        return status, words
    return other[0], other[1] if len(other) > 1 else ""


def cell(text):
    return text.replace("|", "\\|")


def page(traps):
    lines = [HEAD + "| trap | scene | status | words | elsewhere |\n|---|---|---|---|---|"]
    for trap in traps:
        scene = Path(trap["scene"])
        change = "".join(f"<br>`{cell(s)}`" for s in trap.get("set", []))
        other = [
            f"{formalism}: {end[0]}" + (f', "{cell(end[1])}"' if len(end) > 1 else "")
            for formalism, end in trap.get("under", {}).items()
        ]
        words = f'"{cell(trap["words"])}"' if trap.get("words") else "—"
        lines.append(
            f"| {trap['what']} | {scene.stem}{change} | {trap['status']} | {words} "
            f"| {'; '.join(other) or 'the same'} |"
        )
    return "\n".join(lines) + "\n"


def ending(program, root, trap, formalism, out):
    """Exit code, status and all that is said."""
    scene = root / trap["scene"] if "/" in trap["scene"] else HERE / trap["scene"]
    words = [program, "run", scene, "-o", out, "--force"]
    for change in [*trap.get("set", []), f"simulation.formalism={formalism}"]:
        words += ["--set", change]
    outcome = run(words, SECONDS)
    said = outcome.text
    status = "refused" if outcome.code == 2 else f"exit code {outcome.code}"
    path = out / "summary.json"
    if outcome.code in (0, 1) and path.is_file():
        summary = json.loads(path.read_text())
        status = summary["status"]
        parts = [summary.get("reason", ""), summary.get("space_reason", "")]
        said += " ".join(parts + summary.get("warnings", []))
    return outcome.code, status, said


def problem(code, status, said, wanted, words):
    if status != wanted:
        return f"is {status}, expected {wanted}: {said.strip()[-300:]}"
    right = {"done": 0, "refused": 2}.get(status, 1)
    if code != right:
        return f"exit code {code}, expected {right}"
    if words not in said:
        return f'does not say "{words}": {said.strip()[-600:]}'
    return None


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("root", type=Path)
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--show", action="store_true")
    parser.add_argument("--only", default="")
    options = parser.parse_args()
    traps, place = read_traps(), options.root / "docs" / "traps.md"
    if options.write:
        place.write_text(page(traps))
    failures, count = [], 1
    if not place.is_file() or place.read_text() != page(traps):
        failures.append("docs/traps.md is not the page of traps.toml: traps_test.py - . --write")
    chosen = [t for t in traps if options.only in t["name"]] if options.program != "-" else []
    with tempfile.TemporaryDirectory(prefix="liesl_traps_") as folder:
        for trap in chosen:
            for formalism in FORMALISMS if options.all else FORMALISMS[:1]:
                out = Path(folder) / f"{trap['name']}_{formalism}"
                end = ending(options.program, options.root.resolve(), trap, formalism, out)
                count += 1
                wrong = problem(*end, *expected(trap, formalism))
                if wrong:
                    failures.append(f"{trap['name']} under {formalism} {wrong}")
                if options.show:
                    print(f"{trap['name']:32s} {formalism:10s}", *end[:2], wrong or "", flush=True)
    return verdict("traps", failures, count)


if __name__ == "__main__":
    sys.exit(main())
