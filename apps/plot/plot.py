#!/usr/bin/env python3
"""Pictures of a results folder of liesl: plot.py DIR [--to DIR] [--x COLUMN --y COLUMN]

Reads summary.json and the CSV tables (docs/outputs.md), draws what they hold, as PNG and SVG, into
DIR/plots, and prints the path of every picture. Needs Python 3 and matplotlib, nothing else.
"""

import argparse
import json
import sys
from pathlib import Path

sys.dont_write_bytecode = True  # it may be installed where its user may not write

import memory  # noqa: E402, F401  before numpy
import matplotlib.pyplot as plt  # noqa: E402

from batches import draw_batch, draw_pair  # noqa: E402
from comparisons import draw_comparison  # noqa: E402
from maps import draw_map  # noqa: E402
from mechanism import draw_mechanism  # noqa: E402
from motion import draw_before_after, draw_energies, draw_responses  # noqa: E402
from parts import draw_cells, draw_outlines  # noqa: E402
from sensitivities import draw_gradients, draw_sensitivities  # noqa: E402
from sizing import draw_design, draw_history, draw_overview  # noqa: E402
from style import STYLE, Pictures  # noqa: E402
from tables import NothingToDraw, table  # noqa: E402


def check_ended(folder, command):
    """Batches and comparisons have their table from the beginning, a row for each that has ended."""
    name, rows = {"batch": ("results.csv", "case"), "compare": ("rows.csv", "row")}.get(command, ("", ""))
    if name and (folder / name).exists() and table(folder, name) is None:
        raise NothingToDraw(f"no {rows} has ended yet; the same liesl {command} command goes on")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path, metavar="DIR")
    parser.add_argument("--to", type=Path, metavar="DIR", help="default: DIR/plots")
    parser.add_argument("--x", metavar="COLUMN", help="of a batch: one column over another; of a comparison: a "
                        "stability map")
    parser.add_argument("--y", metavar="COLUMN")
    arguments = parser.parse_args()
    plt.rcParams.update(STYLE)
    try:
        if not (arguments.folder / "summary.json").exists():
            raise NothingToDraw(f"{arguments.folder} holds no result of liesl (no summary.json)")
        summary = json.loads((arguments.folder / "summary.json").read_text(encoding="utf-8"))
        pictures = Pictures(arguments.to or arguments.folder / "plots", summary.get("name", ""))
        check_ended(arguments.folder, summary.get("command"))
        cases = table(arguments.folder, "results.csv")
        rows = table(arguments.folder, "rows.csv")
        for found in filter(None, (cases, rows)):  # behind the status there are numbers and the reason
            found.check_numbers([n for n in found.names[found.names.index("status") + 1:] if n != "reason"], gaps=True)
        if arguments.x and not cases and not rows:
            raise NothingToDraw(f"{arguments.folder} has no table of cases (results.csv, rows.csv)")
        if rows:
            draw_comparison(rows, pictures, summary, arguments)
        elif arguments.x:
            draw_pair(cases, pictures, arguments.x, arguments.y)
        elif cases:
            draw_batch(cases, pictures)
        for draw in (draw_overview, draw_history, draw_before_after, draw_design, draw_responses,
                     draw_energies, draw_mechanism, draw_outlines, draw_cells, draw_sensitivities,
                     draw_gradients, draw_map):
            draw(arguments.folder, pictures, summary)
        if not pictures.paths:
            raise NothingToDraw(f"{arguments.folder} has no table to draw")
    except (NothingToDraw, OSError, ValueError, KeyError) as error:
        print(f"plot: {type(error).__name__ + ': ' if isinstance(error, KeyError) else ''}{error}",
              file=sys.stderr)
        return 1
    for path in pictures.paths:
        print(path)
    return 0


if __name__ == "__main__":
    sys.exit(main())
