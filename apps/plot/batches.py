"""Pictures of a batch: one column of its table over another."""

import difflib
import math
import re

import matplotlib.pyplot as plt

from style import COLOURS, GREY, label, legend, scale_of, scaled
from tables import NothingToDraw


def values_of(series, name):
    """Numbers of a column, NaN where a case has none; its words if they are no numbers."""
    cells = series.text(name)
    try:
        return [float(cell) if cell else math.nan for cell in cells]
    except ValueError:
        return cells


def inputs_of(series):
    """Columns that the batch has set: between `case` and `status`."""
    return series.names[1:series.names.index("status")]


def check_column(series, name):
    if name in series.names:
        return
    matches = difflib.get_close_matches(name, series.names, 1)
    hint = f"did you mean '{matches[0]}'?" if matches else "there are " + ", ".join(series.names)
    raise NothingToDraw(f"results.csv has no column '{name}'; {hint}")


def draw_pair(series, pictures, x_name, y_name):
    """One column over another, a point a case, coloured by another input."""
    for name in (x_name, y_name):
        check_column(series, name)
    x, y = values_of(series, x_name), values_of(series, y_name)
    ranges = []
    for name, values in ((x_name, x), (y_name, y)):
        words = isinstance(values[0], str)
        ranges.append((1, series.unit(name)) if words else scale_of(values, series.unit(name)))
    (fx, ux), (fy, uy) = ranges
    x = x if isinstance(x[0], str) else scaled(x, fx)
    y = y if isinstance(y[0], str) else scaled(y, fy)
    others = [n for n in inputs_of(series) if n not in (x_name, y_name)
              and 1 < len(set(series.text(n))) <= len(COLOURS)]
    groups = series.text(others[0]) if others else [""] * len(x)
    figure, ax = plt.subplots(layout="constrained", figsize=(8.2, 4.6))
    good = [status in ("done", "converged", "optimal") for status in series.text("status")]
    for colour, group in zip(COLOURS, dict.fromkeys(groups)):
        for marker, wanted in (("o", True), ("x", False)):
            chosen = [k for k in range(len(x)) if groups[k] == group and good[k] == wanted]
            ax.plot([x[k] for k in chosen], [y[k] for k in chosen], marker, color=colour,
                    markersize=5, alpha=0.8, label=group if wanted else None)
    if not all(good):
        ax.plot([], [], "x", color=GREY, markersize=5, label="failed")
    ax.set_xlabel(label(x_name, ux))
    ax.set_ylabel(label(y_name, uy))
    if others or not all(good):
        legend(ax, title=others[0].replace("_", " ") if others else None)
    none = sum(isinstance(v, float) and math.isnan(v) for v in y)
    note = f" ({none} of {len(y)} cases have none)" if none else ""
    name = re.sub(r"[^\w.+-]+", "_", f"{y_name}_over_{x_name}")
    pictures.save(figure, name, f"{y_name} over {x_name}{note}".replace("_", " "))


def draw_batch(series, pictures):
    """What the cases ended with, over each input."""
    figures = series.names[series.names.index("reason") + 1:]
    wanted = [n for n in figures if n == "mass_final"] or [
        n for n in figures if n.endswith(".max_abs")] or figures
    varied = [name for name in inputs_of(series) if len(set(series.text(name))) > 1]
    if not varied:
        raise NothingToDraw(f"what the batch sets is the same in all cases that have ended ({len(series.rows)}); "
                            "--x and --y draw any two columns")
    for name in varied:
        draw_pair(series, pictures, name, wanted[0])
