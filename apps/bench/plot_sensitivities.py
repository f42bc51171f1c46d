#!/usr/bin/env python3
"""Ways to gradients of a motion, time and error over the number of variables:
plot_sensitivities.py FILE.csv PICTURE.png, FILE.csv from bench_sensitivities. Prints the tables of
docs/sensitivities.md. Needs matplotlib."""

import csv
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "plot"))

import matplotlib.pyplot as plt  # noqa: E402

from style import COLOURS, STYLE  # noqa: E402

# Name in the picture, method of the table, functionals.
METHODS = [("direct", "direct", 1), ("adjoint, 1 functional", "adjoint", 1),
           ("adjoint, 10 functionals", "adjoint", 10),
           ("semi-analytic, S factored", "semi-analytic, exact factor", 1),
           ("semi-analytic, frozen, 8 solves", "semi-analytic, frozen, 8 solves", 1),
           ("central differences", "central differences", 1)]


def series(rows, space, method, functionals, column):
    """Variables and the column's values, where there are any; errors of 0 belong to the reference."""
    found = [(int(row["variables"]), float(row[column])) for row in rows
             if (row["space"], row["method"], row["functionals"]) == (space, method, str(functionals))
             and row[column] and float(row[column]) > 0]
    return zip(*sorted(found)) if found else ([], [])


def draw(rows, picture):
    plt.rcParams.update(STYLE)
    figure, grid = plt.subplots(2, 2, figsize=(9.6, 6.6), layout="constrained")
    axes = grid.flat
    for ax, space, column, title in (
            (axes[0], "planar", "forward_runs", "time, SE(2) [forward runs]"),
            (axes[1], "segments", "forward_runs", "time, segments [forward runs]"),
            (axes[2], "spatial", "forward_runs", "time, SE(3) [forward runs]"),
            (axes[3], "spatial", "relative_error", "error against the direct form, SE(3)")):
        for colour, (name, method, functionals) in zip(COLOURS, METHODS):
            x, y = series(rows, space, method, functionals, column)
            ax.loglog(x, y, "o-", color=colour, label=name, markersize=4)
        ax.set_title(title)
        ax.set_xlim(3, 530)
        if column == "forward_runs":
            ax.set_ylim(1, 1000)
        ax.set_xlabel("variables")
        ax.set_xticks([4, 40, 400], ["4", "40", "400"])
        ax.minorticks_off()
    handles, labels = axes[0].get_legend_handles_labels()
    axes[1].legend(handles, labels, loc="upper left", bbox_to_anchor=(1.005, 1.02), borderaxespad=0)
    figure.savefig(picture, metadata={"Software": "liesl"})


def print_table(rows, column, form, methods):
    """A line for each space and number of variables."""
    places = dict.fromkeys((row["space"], row["variables"]) for row in rows)
    for space, variables in places:
        found = {(row["method"], row["functionals"]): float(row[column]) for row in rows
                 if (row["space"], row["variables"]) == (space, variables)}
        cells = [format(found[m, str(f)], form) if (m, str(f)) in found else "" for m, f in methods]
        print(f"| {space} {variables} | " + " | ".join(cells) + " |")


def print_tables(rows):
    for column in ("forward_runs", "clock_runs"):
        print_table(rows, column, ".1f", [(method, f) for _, method, f in METHODS])
    frozen = [(f"semi-analytic, frozen, {n} solves", 1) for n in (1, 2, 4, 8)]
    print_table(rows, "relative_error", ".0e", [("adjoint", 1), ("semi-analytic, exact factor", 1), *frozen,
                                                ("central differences", 1)])


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    with open(sys.argv[1], newline="", encoding="utf-8") as file:
        table = list(csv.DictReader(file))
    draw(table, sys.argv[2])
    print_tables(table)
