#!/usr/bin/env python3
"""Pictures of a results folder of liesl: plot.py DIR [--to DIR] [--x COLUMN --y COLUMN]

Reads summary.json and the CSV tables (docs/outputs.md), draws what they hold, as PNG and SVG, into
DIR/plots, and prints the path of every picture. Needs Python 3 and matplotlib, nothing else.
"""

import argparse
import csv
import difflib
import json
import math
import os
import re
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.collections import PolyCollection  # noqa: E402
from matplotlib.ticker import MaxNLocator  # noqa: E402

# Okabe & Ito: told apart with every kind of colour vision.
BLUE, ORANGE, GREEN, RED, PURPLE, SKY = (
    "#0072B2", "#E69F00", "#009E73", "#D55E00", "#CC79A7", "#56B4E9")
COLOURS = [BLUE, ORANGE, GREEN, PURPLE, SKY, RED]
GREY = "#6e6e6e"
LIMIT = dict(color="black", linestyle=(0, (5, 3)), linewidth=1.1)

STYLE = {
    "figure.dpi": 100, "savefig.dpi": 150, "font.size": 10, "axes.titlesize": 11,
    "axes.grid": True, "grid.color": "#dddddd", "grid.linewidth": 0.6, "axes.axisbelow": True,
    "axes.spines.top": False, "axes.spines.right": False, "axes.edgecolor": GREY,
    "lines.linewidth": 1.6, "legend.frameon": False, "legend.fontsize": 9,
    "axes.prop_cycle": matplotlib.cycler(color=COLOURS), "svg.hashsalt": "liesl",
    "axes.formatter.limits": (-3, 4), "axes.formatter.useoffset": False,
}


class NothingToDraw(Exception):
    """The folder does not hold what a picture needs; the text says what."""


# --- tables --------------------------------------------------------------------------------------


class Table:
    """A CSV file by columns: `names` and `units` from headings like `bend [m]`."""

    def __init__(self, path):
        with open(path, newline="", encoding="utf-8", errors="replace") as file:
            rows = [row for row in csv.reader(file) if row]
        if not rows:
            raise NothingToDraw(f"{path} is empty")
        parts = [re.fullmatch(r"(.*?)(?: \[(.*)\])?", heading) for heading in rows[0]]
        self.names = [part.group(1) for part in parts]
        self.units = [part.group(2) or "" for part in parts]
        self.rows = rows[1:]

    def text(self, name):
        i = self.names.index(name)
        return [row[i] for row in self.rows]

    def numbers(self, name):
        return [float(value) for value in self.text(name)]

    def unit(self, name):
        return self.units[self.names.index(name)]


def table(folder, name):
    """The table, or None if there is no such file or no row in it."""
    path = folder / name
    if not path.exists():
        return None
    found = Table(path)
    return found if found.rows else None


# --- numbers and labels --------------------------------------------------------------------------

PREFIXED = {"m": True, "Pa": True, "N": True, "J": True, "N m": True, "m/s": True, "kg": False}


def scale_of(values, unit):
    """(factor, unit) in which the largest value reads well: 1.2e-3 m becomes 1.2 mm."""
    finite = [abs(v) for v in values if math.isfinite(v)]
    largest = max(finite, default=0)
    if unit == "kg":
        return (1e3, "g") if 0 < largest < 1 else (1, "kg")
    if not PREFIXED.get(unit) or largest == 0:
        return 1, unit
    for limit, factor, prefix in ((1e7, 1e-6, "M"), (1e4, 1e-3, "k"), (0.1, 1, ""),
                                  (1e-4, 1e3, "m"), (1e-7, 1e6, "µ")):
        if largest >= limit:
            return factor, prefix + unit
    return 1e9, "n" + unit


def label(name, unit):
    unit = unit.replace("N m", "N·m")
    name = name.replace("_", " ")
    return name if unit in ("", "-") else f"{name} [{unit}]"


def scaled(values, factor):
    return [factor * value for value in values]


def legend(ax, **options):
    """Right of the axes, where it covers nothing."""
    ax.legend(loc="upper left", bbox_to_anchor=(1.005, 1.02), borderaxespad=0, **options)


def stacked(count, height=2.3, width=8.2):
    """`count` panels over one abscissa, and the figure."""
    figure, axes = plt.subplots(count, 1, sharex=True, squeeze=False, layout="constrained",
                                figsize=(width, 0.9 + height * count))
    return figure, [row[0] for row in axes]


class Pictures:
    """Writes each figure as PNG and SVG, whole or not at all."""

    def __init__(self, folder, title):
        self.folder, self.title, self.paths = folder, title, []

    def save(self, figure, name, heading):
        figure.suptitle(f"{self.title}: {heading}" if self.title else heading, fontsize=12)
        self.folder.mkdir(parents=True, exist_ok=True)
        # The layout once, for both files.
        figure.draw_without_rendering()
        figure.set_layout_engine("none")
        box = figure.get_tightbbox().padded(0.12)
        for kind in ("png", "svg"):
            path = self.folder / f"{name}.{kind}"
            part = self.folder / f".{name}.{kind}.part"
            figure.savefig(part, format=kind, bbox_inches=box,
                           metadata={"Date": None} if kind == "svg" else {"Software": "liesl"})
            os.replace(part, path)
            self.paths.append(path)
        plt.close(figure)


# --- series over time ----------------------------------------------------------------------------


def grouped_columns(series):
    """{response: [columns]}: `tip.x`, `tip.y`, `tip.z` are one response."""
    groups = {}
    for name in series.names[1:]:
        stem = name[:-2] if re.search(r"\.[xyz]$", name) else name
        groups.setdefault(stem, []).append(name)
    return groups


def moving(series, names):
    """Those that are not zero throughout; all of them if none is."""
    return [n for n in names if any(series.numbers(n))] or names


def draw_responses(folder, pictures, _summary):
    series = table(folder, "responses.csv")
    if series is None or len(series.names) < 2:
        return
    time = series.numbers(series.names[0])
    groups = grouped_columns(series)
    figure, axes = stacked(len(groups))
    for ax, (stem, columns) in zip(axes, groups.items()):
        columns = moving(series, columns)
        values = [series.numbers(column) for column in columns]
        factor, unit = scale_of(sum(values, []), series.unit(columns[0]))
        for column, line in zip(columns, values):
            ax.plot(time, scaled(line, factor), label=column[len(stem) + 1:],
                    marker="o" if len(time) < 30 else None, markersize=3)
        ax.set_ylabel(label(stem, unit))
        if len(columns) > 1:
            legend(ax)
    axes[-1].set_xlabel(label(series.names[0], series.units[0]))
    axes[-1].margins(x=0.01)
    pictures.save(figure, "responses", "responses")


def draw_energies(folder, pictures, _summary):
    series = table(folder, "energies.csv")
    if series is None:
        return
    time = series.numbers(series.names[0])
    panels = [[n for n in names if n in series.names] for names in
              (("kinetic", "potential", "total"), ("elastic", "dissipated"))]
    panels = [moving(series, names) for names in panels if names]
    if panels[0] == ["total"] and len(panels) > 1:  # statics without gravity: total = elastic
        del panels[0]
    colours = dict(kinetic=BLUE, potential=ORANGE, total="black", elastic=GREEN, dissipated=RED)
    figure, axes = stacked(len(panels), 2.6)
    for ax, names in zip(axes, panels):
        factor, unit = scale_of(sum((series.numbers(n) for n in names), []), "J")
        for name in names:
            ax.plot(time, scaled(series.numbers(name), factor), color=colours[name],
                    linestyle="--" if name == "total" else "-",
                    label="dissipated\n(numerical)" if name == "dissipated" else name)
        ax.set_ylabel(label("energy", unit))
        legend(ax)
    axes[-1].set_xlabel(label(series.names[0], series.units[0]))
    axes[-1].margins(x=0.01)
    pictures.save(figure, "energies", "energies")


def draw_before_after(folder, pictures, summary):
    before, after = table(folder, "responses_initial.csv"), table(folder, "responses_final.csv")
    if before is None or after is None:
        return
    constraints = summary.get("constraints", {})
    groups = grouped_columns(after)
    chosen = [stem for stem in groups if stem in constraints] or list(groups)
    figure, axes = stacked(len(chosen), 2.9)
    for ax, stem in zip(axes, chosen):
        before_after(ax, before, after, stem, groups[stem], constraints.get(stem, {}).get("limit"))
        legend(ax)
    axes[-1].set_xlabel(label(after.names[0], after.units[0]))
    axes[-1].margins(x=0.01)
    pictures.save(figure, "response_before_after", "responses against their limits")


def before_after(ax, before, after, stem, columns, limit):
    """One response of the first and of the final design."""
    runs = [(run, name, colour) for run, name, colour in
            ((before, "initial", ORANGE), (after, "final", BLUE))
            if all(column in run.names for column in columns)]
    lines = [(name, colour, run.numbers(run.names[0]), magnitude(run, columns))
             for run, name, colour in runs]
    everything = sum((values for *_, values in lines), [limit] if limit else [])
    factor, unit = scale_of(everything, after.unit(columns[0]))
    for name, colour, time, values in lines:
        ax.plot(time, scaled(values, factor), color=colour, label=name,
                linewidth=2.4 if name == "initial" else 1.6, alpha=0.85 if name == "initial" else 1)
    if limit:
        ax.axhline(limit * factor, label="limit", **LIMIT)
        if any(v < 0 for v in everything):
            ax.axhline(-limit * factor, **LIMIT)
        ax.margins(y=0.08)
    size = " (norm)" if len(columns) > 1 else ""
    ax.set_ylabel(label(stem + size, unit))


def magnitude(series, columns):
    """The column, or the norm of several: what the limit is for."""
    if len(columns) == 1:
        return series.numbers(columns[0])
    return [math.hypot(*row) for row in zip(*(series.numbers(column) for column in columns))]


# --- optimisation --------------------------------------------------------------------------------


def draw_history(_folder, pictures, summary):
    history = summary.get("history") or []
    if not history:
        return
    cycles = [h["cycle"] for h in history]
    column = lambda key: [math.nan if h.get(key) is None else h[key] for h in history]
    figure, (mass, worst, change) = stacked(3, 2.0)

    factor, unit = scale_of(column("mass"), "kg")
    mass.plot(cycles, scaled(column("mass"), factor), "o-", color=BLUE)
    mass.set_ylabel(label("mass", unit))

    values = scaled(column("worst_constraint"), 100)
    worst.axhline(0, label="limit", **LIMIT)
    worst.plot(cycles, values, "o-", color=RED)
    finite = [v for v in values if math.isfinite(v)]
    if finite and max(map(abs, finite)) > 20:
        worst.set_yscale("symlog", linthresh=1)
        worst.yaxis.set_major_formatter(lambda v, _: f"{v:g}".replace("-", "−"))
    worst.set_ylabel("worst constraint\nabove its limit [%]")
    legend(worst)

    values = column("load_change")
    if any(v > 0 for v in values):
        change.set_yscale("log")
        values = [v if v > 0 else math.nan for v in values]
    change.plot(cycles, values, "o-", color=GREEN)
    change.set_ylabel("relative change\nof the loads")
    change.set_xlabel("cycle")
    change.xaxis.set_major_locator(MaxNLocator(integer=True, min_n_ticks=1))
    change.set_xlim(min(cycles) - 0.3, max(cycles) + 0.3)
    figure.align_ylabels()
    status = summary.get("status", "")
    pictures.save(figure, "cycle_history", f"cycle history ({status})" if status else
                  "cycle history")


def draw_design(folder, pictures, _summary):
    design = table(folder, "design.csv")
    if design is None:
        return
    panels = design_panels(design)
    figure, axes = plt.subplots(len(panels), 1, squeeze=False, layout="constrained",
                                figsize=(8.2, 0.9 + 2.7 * len(panels)))
    for (ax,), ((variable, body), rows) in zip(axes, panels.items()):
        draw_steps(ax, sorted(rows), variable, body)
        legend(ax)
    pictures.save(figure, "design", "design along the beam")


def design_panels(design):
    """{(variable without its number, body): rows along the beam}."""
    panels = {}
    for row in design.rows:
        cell = dict(zip(design.names, row))
        key = (re.sub(r"\[\d+\]$", "", cell["variable"]), cell["body"])
        panels.setdefault(key, []).append(
            [float(cell[k]) for k in ("s0", "s1", "initial", "final", "lower", "upper")]
            + [cell["unit"]])
    return panels


def draw_steps(ax, rows, variable, body):
    """Initial and final value over the length, as steps, with the bounds."""
    edges = [row[0] for row in rows] + [rows[-1][1]]
    factor, unit = scale_of([row[k] for row in rows for k in (2, 3)], rows[0][6])
    column = lambda k: scaled([row[k] for row in rows], factor)
    lower, upper = column(4), column(5)
    ax.stairs(column(3), edges, baseline=0, fill=True, color=BLUE, alpha=0.15)
    ax.stairs(column(2), edges, baseline=None, color=ORANGE, linewidth=1.8, label="initial")
    ax.stairs(column(3), edges, baseline=None, color=BLUE, linewidth=2.2, label="final")
    ax.stairs(lower, edges, baseline=None, label="bounds", **LIMIT)
    top = max(column(2) + column(3))
    if max(upper) < 2 * top:  # else it would squeeze the rest
        ax.stairs(upper, edges, baseline=None, **LIMIT)
        top = max(top, max(upper))
    else:
        ax.text(0.995, 0.985, f"upper bound {max(upper):g} {unit}", transform=ax.transAxes,
                ha="right", va="top", fontsize=8, color=GREY)
    ax.set_ylim(0, 1.12 * top)
    ax.set_ylabel(label(variable, unit))
    ax.set_xlabel(f"along {body} [m]")


# --- the mechanism -------------------------------------------------------------------------------


def read_frames(path):
    """[(time, {body: (kind, [(x, y, z), ...])})] in order of time, and the abscissa's label."""
    frames = Table(path)
    instants = {}
    for time, body, kind, node, *x in frames.rows:
        bodies = instants.setdefault(float(time), {})
        bodies.setdefault(body, (kind, {}))[1][int(node)] = tuple(map(float, x[:3]))
    ordered = [(t, {b: (kind, [nodes[k] for k in sorted(nodes)])
                    for b, (kind, nodes) in bodies.items()})
               for t, bodies in instants.items()]
    return ordered, label(frames.names[0], frames.units[0])


def draw_mechanism(folder, pictures, _summary):
    if not (folder / "frames.csv").exists():
        return
    instants, time_label = read_frames(folder / "frames.csv")
    if not instants:
        return
    axes = shown_axes(instants)
    figure = plt.figure(figsize=(8.2, 5.6), layout="constrained")
    ax = figure.add_subplot(projection="3d" if len(axes) == 3 else None)
    mechanism(ax, instants, axes, time_label)
    times = len(instants)
    pictures.save(figure, "mechanism", f"mechanism at {times} instants" if times > 1 else
                  "mechanism")


def shown_axes(instants):
    """Two axes for what lies in a coordinate plane, else all three."""
    points = [x for _, bodies in instants for _, nodes in bodies.values() for x in nodes]
    spans = [max(p[k] for p in points) - min(p[k] for p in points) for k in range(3)]
    flat = [k for k in range(3) if spans[k] <= 1e-6 * max(spans)]
    return [k for k in range(3) if k not in flat[-1:]] if flat else [0, 1, 2]


def mechanism(ax, instants, axes, time_label):
    """Bodies at all instants, coloured by time; rigid bodies with their paths."""
    points = [x for _, bodies in instants for _, nodes in bodies.values() for x in nodes]
    for body, (_, nodes) in instants[0][1].items():
        if len(nodes) == 1 and len(instants) > 2:
            path = [bodies[body][1][0] for _, bodies in instants if body in bodies]
            ax.plot(*[[x[k] for x in path] for k in axes], color="#b8b8b8", linewidth=0.8, zorder=1)
    times = [t for t, _ in instants]
    norm = matplotlib.colors.Normalize(min(times), max(times) if len(times) > 1 else times[0] + 1)
    # The light end of the map would vanish on white.
    colours = matplotlib.colors.LinearSegmentedColormap.from_list(
        "time", plt.get_cmap("viridis_r")([0.12 + 0.88 * i / 20 for i in range(21)]))
    for number, (time, bodies) in enumerate(instants):
        last = number == len(instants) - 1
        for kind, nodes in bodies.values():
            columns = [[x[k] for x in nodes] for k in axes]
            ax.plot(*columns, color=colours(norm(time)), linewidth=2.4 if last else 1.3,
                    marker="s" if len(nodes) == 1 else None, markersize=7 if last else 4,
                    solid_capstyle="round", zorder=3 if last else 2)
    frame_axes(ax, axes, points)
    if len(times) > 1:
        ax.figure.colorbar(matplotlib.cm.ScalarMappable(norm, colours), ax=ax, label=time_label,
                           shrink=0.8, pad=0.1 if len(axes) == 3 else 0.02)


def draw_overview(folder, pictures, summary):
    """Of an optimisation, in one picture: the mechanism, the first limit, the first design."""
    before, after = table(folder, "responses_initial.csv"), table(folder, "responses_final.csv")
    design = table(folder, "design.csv")
    if before is None or after is None or design is None or not (folder / "frames.csv").exists():
        return
    instants, time_label = read_frames(folder / "frames.csv")
    groups, constraints = grouped_columns(after), summary.get("constraints", {})
    stems = [stem for stem in groups if stem in constraints]
    if not instants or not stems or len(shown_axes(instants)) == 3:
        return
    figure = plt.figure(figsize=(11, 4.6), layout="constrained")
    grid = figure.add_gridspec(2, 2, width_ratios=(1.15, 1))
    ax = figure.add_subplot(grid[:, 0])
    mechanism(ax, instants, shown_axes(instants), time_label)
    ax = figure.add_subplot(grid[0, 1])
    before_after(ax, before, after, stems[0], groups[stems[0]], constraints[stems[0]].get("limit"))
    ax.set_xlabel(label(after.names[0], after.units[0]))
    ax.margins(x=0.01)
    ax.legend(loc="lower center", bbox_to_anchor=(0.5, 0.98), ncols=3)
    (variable, body), rows = next(iter(design_panels(design).items()))
    draw_steps(figure.add_subplot(grid[1, 1]), sorted(rows), variable, body)
    masses = [summary.get(key) for key in ("mass_initial", "mass_final")]
    heading = f"{summary.get('status', '')} after {summary.get('cycles', '?')} cycles"
    if None not in masses:
        factor, unit = scale_of(masses, "kg")
        heading += f", {masses[0] * factor:.4g} {unit} → {masses[1] * factor:.4g} {unit}"
    pictures.save(figure, "overview", heading)


def frame_axes(ax, axes, points):
    """Labels, and the same scale in all directions."""
    for k, name in zip(axes, "xyz"):
        getattr(ax, f"set_{name}label")(f"{'xyz'[k]} [m]", labelpad=9 if len(axes) == 3 else 4)
    if len(axes) == 2:
        low = [min(p[k] for p in points) for k in axes]
        high = [max(p[k] for p in points) for k in axes]
        size = [max(b - a, 0.4 * max(h - l for l, h in zip(low, high)), 1e-9)
                for a, b in zip(low, high)]
        for set_limits, a, b, span in zip((ax.set_xlim, ax.set_ylim), low, high, size):
            set_limits((a + b - 1.12 * span) / 2, (a + b + 1.12 * span) / 2)
        ax.set_aspect("equal", adjustable="box")
        return
    spans = [max(max(p[k] for p in points) - min(p[k] for p in points), 1e-9) for k in range(3)]
    box = [max(span, 0.2 * max(spans)) for span in spans]
    for k, name in enumerate("xyz"):
        middle = (max(p[k] for p in points) + min(p[k] for p in points)) / 2
        getattr(ax, f"set_{name}lim")(middle - 0.52 * box[k], middle + 0.52 * box[k])
        getattr(ax, f"{name}axis").set_major_locator(MaxNLocator(5 if box[k] > 0.4 * max(box) else 3))
    ax.set_box_aspect(box, zoom=0.9)


# --- batches -------------------------------------------------------------------------------------


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
    near = difflib.get_close_matches(name, series.names, 1)
    hint = f"did you mean '{near[0]}'?" if near else "there are " + ", ".join(series.names)
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
    good = [status in ("done", "converged") for status in series.text("status")]
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
    for name in inputs_of(series):
        if len(set(series.text(name))) > 1:
            draw_pair(series, pictures, name, wanted[0])


# --- comparisons ---------------------------------------------------------------------------------

CLASSES = {"converged": (GREEN, "s"), "recovered": (ORANGE, "D"), "stopped": (RED, "X")}


class Comparison:
    """rows.csv: rows as dictionaries of texts, and the columns that were varied."""

    def __init__(self, series, summary):
        self.rows = [dict(zip(series.names, row)) for row in series.rows]
        inputs = series.names[1:series.names.index("status")]
        self.varied = [n for n in inputs if len({row[n] for row in self.rows}) > 1]
        self.unit = series.unit("error")
        self.quantity = f"{summary.get('norm', '')} error of {summary.get('response', '')}"
        words = [n for n in self.varied if not all(is_number(row[n]) for row in self.rows)]
        self.numbers = [n for n in self.varied if n not in words]
        # A colour for each combination of words: formalism, tangent, ...
        for row in self.rows:
            row["kind"] = " ".join(row[n] for n in words) or row.get("formalism", "") or "rows"
        self.kinds = list(dict.fromkeys(row["kind"] for row in self.rows))
        # Lines that lie on each other are told apart by their markers.
        self.looks = {kind: dict(color=COLOURS[i % len(COLOURS)], marker="osD^vP"[i % 6],
                                 markersize=9 - min(i, 4) * 1.5, markeredgecolor="white",
                                 markeredgewidth=0.6, linewidth=2.6 - min(i, 4) * 0.4)
                      for i, kind in enumerate(self.kinds)}
        # What belongs to the mechanism, not to how it is computed.
        self.physical = [n for n in self.numbers
                         if n not in ("elements", "step", "tolerance", "rho_inf")]

    def of(self, kind, *columns):
        """Rows of a kind that have numbers in these columns, errors above zero."""
        chosen = [row for row in self.rows if row["kind"] == kind
                  and all(is_number(row[c]) for c in columns)]
        return [row for row in chosen if "error" not in columns or float(row["error"]) > 0]

    def floors(self):
        return sorted({float(row["floor"]) for row in self.rows if is_number(row["floor"])})

    def kinds_with(self, *columns):
        return [kind for kind in self.kinds if self.of(kind, *columns)]


def is_number(text):
    try:
        return math.isfinite(float(text))
    except ValueError:
        return False


def front(points):
    """Points that no other one beats in both coordinates, from left to right."""
    best, kept = math.inf, []
    for point in sorted(points):
        if point[1] < best:
            best = point[1]
            kept.append(point)
    return kept


def log_axes(ax, *which):
    for axis in which:
        getattr(ax, f"set_{axis}scale")("log")
    ax.grid(True, which="minor", color="#eeeeee", linewidth=0.4)


def show_floor(ax, comparison):
    floors = [f for f in comparison.floors() if f > 0]
    if floors:
        ax.axhline(max(floors), label="floor: the two\nreferences differ", **LIMIT)


def draw_work_precision(comparison, pictures, _arguments):
    kinds = comparison.kinds_with("error", "cpu_s")
    if not kinds:
        return
    figure, ax = plt.subplots(layout="constrained", figsize=(8.2, 4.8))
    points = {kind: [(float(r["cpu_s"]), float(r["error"])) for r in
                     comparison.of(kind, "error", "cpu_s")] for kind in kinds}
    for kind in kinds:
        look = comparison.looks[kind]
        ax.plot(*zip(*points[kind]), ".", color=look["color"], alpha=0.35, markersize=6)
        ax.plot(*zip(*front(points[kind])), label=kind, **look)
    best = front(sum(points.values(), []))
    ax.plot(*zip(*best), "o", markerfacecolor="none", markeredgecolor="black", markersize=13,
            linestyle="none", label="best for its time")
    show_floor(ax, comparison)
    log_axes(ax, "x", "y")
    ax.set_xlabel("CPU time of the stepping [s]")
    ax.set_ylabel(label(comparison.quantity, comparison.unit))
    legend(ax)
    pictures.save(figure, "work_precision", "error against time")


def finest(rows, comparison, axis):
    """Of the rows, those with the finest mesh and smallest step otherwise, and one mechanism."""
    for other, pick in (("elements", max), ("step", min), ("tolerance", min)):
        if other in comparison.numbers and other != axis and rows:
            wanted = pick(float(row[other]) for row in rows)
            rows = [row for row in rows if float(row[other]) == wanted]
    for other in comparison.physical + ["rho_inf"]:
        if other in comparison.numbers and other != axis and rows:
            rows = [row for row in rows if row[other] == rows[0][other]]
    return sorted(rows, key=lambda row: float(row[axis]))


def slope(points):
    """Least-squares slope of log y over log x."""
    x, y = ([math.log(p[k]) for p in points] for k in (0, 1))
    mx, my = sum(x) / len(x), sum(y) / len(y)
    return (sum((a - mx) * (b - my) for a, b in zip(x, y)) / sum((a - mx) ** 2 for a in x))


def draw_orders(comparison, pictures, _arguments):
    axes_of = [n for n in ("step", "elements") if n in comparison.numbers]
    panels = []
    for axis in axes_of:
        lines = {kind: finest(comparison.of(kind, "error"), comparison, axis)
                 for kind in comparison.kinds}
        if any(len(rows) > 1 for rows in lines.values()):
            panels.append((axis, lines))
    if not panels:
        return
    figure, axes = plt.subplots(1, len(panels), squeeze=False, layout="constrained",
                                figsize=(8.2 if len(panels) == 1 else 11, 4.6))
    floor = max(comparison.floors(), default=0)
    for ax, (axis, lines) in zip(axes[0], panels):
        for kind, rows in lines.items():
            points = [(float(row[axis]), float(row["error"])) for row in rows]
            if not points:
                continue
            # Halved steps are not the steps of the axis.
            sound = [p for p, row in zip(points, rows)
                     if p[1] > 3 * floor and float(row["rejected_steps"]) == 0]
            order = f"{kind}: {slope(sound):.2f}" if len(sound) > 1 else kind
            ax.plot(*zip(*points), label=order.replace("-", "\u2212"), **comparison.looks[kind])
        show_floor(ax, comparison)
        log_axes(ax, "x", "y")
        ticks = sorted({float(row[axis]) for row in comparison.rows})
        ax.set_xticks(ticks, [f"{n:g}" for n in ticks])
        ax.set_xticks([], minor=True)
        ax.set_xlabel(label(axis, "s" if axis == "step" else ""))
        ax.set_ylabel(label(comparison.quantity, comparison.unit))
        ax.legend(loc="upper center", bbox_to_anchor=(0.5, -0.14), ncols=3, title="fitted slope")
    pictures.save(figure, "orders", "order, at the finest mesh or step otherwise")


def draw_effort(comparison, pictures, _arguments):
    """Iterations and factorisations over what was varied of the mechanism."""
    for axis in comparison.physical:
        figure, panels = stacked(2, 2.6)
        for kind in comparison.kinds:
            rows = finest(comparison.of(kind, axis, "steps"), comparison, axis)
            rows = [row for row in rows if row["status"] != "stopped"]
            if not rows:
                continue
            x = [float(row[axis]) for row in rows]
            for ax, column in zip(panels, ("newton_iterations", "factorizations")):
                per = max(float(rows[0]["steps"]), 1) if column == "newton_iterations" else 1
                ax.plot(x, [float(row[column]) / per for row in rows], label=kind,
                        **comparison.looks[kind])
        for ax, name in zip(panels, ("iterations a step", "factorisations\nin the run")):
            ax.set_ylabel(name)
            legend(ax)
            scale_axis(ax, "x", [float(row[axis]) for row in comparison.rows])
        panels[0].set_ylim(bottom=0)
        log_axes(panels[1], "y")
        panels[-1].set_xlabel(label(axis, ""))
        pictures.save(figure, f"effort_over_{axis}", f"effort over {label(axis, '')}")


def scale_axis(ax, axis, values):
    """Logarithmic where values spread over a decade."""
    if min(values) > 0 and max(values) >= 10 * min(values):
        log_axes(ax, axis)


def draw_stability(comparison, pictures, arguments):
    """A map of how runs end over two of the varied keys, a panel for each kind of run."""
    if arguments.x:
        pair = (arguments.x, arguments.y)
        for name in pair:
            if name not in comparison.numbers:
                raise NothingToDraw(f"rows.csv varies no number '{name}'; it varies "
                                    + (", ".join(comparison.numbers) or "none"))
    else:
        second = (comparison.physical + [n for n in ("rho_inf", "tolerance", "elements")
                                         if n in comparison.numbers])
        if "step" not in comparison.numbers or not second:
            return
        if not comparison.physical and all(r["status"] == "converged" for r in comparison.rows):
            return
        pair = ("step", second[0])
    columns = min(3, len(comparison.kinds))
    lines = -(-len(comparison.kinds) // columns)
    figure, axes = plt.subplots(lines, columns, squeeze=False, sharex=True, sharey=True,
                                layout="constrained", figsize=(1.6 + 3 * columns, 1 + 2.7 * lines))
    for ax, kind in zip(axes.flat, comparison.kinds):
        worst = {}
        for row in comparison.of(kind, *pair):
            place = tuple(float(row[name]) for name in pair)
            worst[place] = max(worst.get(place, "converged"), row["status"],
                               key=list(CLASSES).index)
        for name, (colour, marker) in CLASSES.items():
            places = [place for place, status in worst.items() if status == name]
            ax.plot(*(zip(*places) if places else ([], [])), marker, color=colour, markersize=9,
                    linestyle="none", label=name)
        ax.set_title(kind)
        for axis, name in zip("xy", pair):
            scale_axis(ax, axis, [float(row[name]) for row in comparison.rows])
        ax.margins(0.12)
    for ax in axes.flat[len(comparison.kinds):]:
        ax.set_axis_off()
    figure.supxlabel(label(pair[0], "s" if pair[0] == "step" else ""), fontsize=10)
    figure.supylabel(label(pair[1], ""), fontsize=10)
    legend(axes[0][columns - 1], handles=axes[0][0].get_legend_handles_labels()[0])
    name = re.sub(r"[^\w.+-]+", "_", f"stability_{pair[0]}_{pair[1]}")
    pictures.save(figure, name, "how runs end (the worst over what else is varied)")


def draw_comparison(series, pictures, summary, arguments):
    comparison = Comparison(series, summary)
    if arguments.x:
        draw_stability(comparison, pictures, arguments)
        return
    for draw in (draw_work_precision, draw_orders, draw_effort, draw_stability):
        draw(comparison, pictures, arguments)


# --- meshed parts --------------------------------------------------------------------------------


def closed_lines(outlines):
    """{step: [([x ...], [y ...]), ...]}, each line back at its first point."""
    lines = {}
    for step, line, x, y in zip(outlines.numbers("step"), outlines.text("line"),
                                outlines.numbers("x"), outlines.numbers("y")):
        xs, ys = lines.setdefault(int(step), {}).setdefault(line, ([], []))
        xs.append(x)
        ys.append(y)
    return {step: [(xs + xs[:1], ys + ys[:1]) for xs, ys in found.values()]
            for step, found in lines.items()}


def part_axes(ax):
    ax.set_aspect("equal")
    ax.grid(False)
    ax.set_xlabel(label("x", "m"))
    ax.set_ylabel(label("y", "m"))


def draw_outlines(folder, pictures, _summary):
    """The outline of a planar part over the steps, the last one dark."""
    for path in sorted(folder.glob("*_outlines.csv")):
        found = table(folder, path.name)
        if not found:
            continue
        steps = closed_lines(found)
        figure, ax = plt.subplots(layout="constrained", figsize=(8.2, 4.2))
        shades = plt.get_cmap("viridis_r")
        last = max(steps)
        for step, lines in sorted(steps.items()):
            for i, (xs, ys) in enumerate(lines):
                share = (step - 1) / max(1, last - 1)
                ax.plot(xs, ys, color="black" if step == last else shades(0.15 + 0.6 * share),
                        linewidth=1.6 if step == last else 0.8,
                        label=f"step {step}" if i == 0 and step in (1, last) else None)
        part_axes(ax)
        legend(ax)
        part = path.name[:-len("_outlines.csv")]
        pictures.save(figure, f"{part}_outlines", f"outline of '{part}'")


def draw_cells(folder, pictures, _summary):
    """Fraction of the cells, and stress in the load case of the largest."""
    for path in sorted(folder.glob("*_cells.csv")):
        found = table(folder, path.name)
        if not found:
            continue
        corners = [list(zip(found.numbers(f"x{c}"), found.numbers(f"y{c}"))) for c in range(4)]
        cells = list(zip(*corners))
        part = path.name[:-len("_cells.csv")]
        for name, heading, colours in (("fraction", "fraction of the cells", "Greys"),
                                       ("stress", "von Mises stress, worst load case", "viridis")):
            values = found.numbers(name)
            factor, unit = scale_of(values, found.unit(name))
            figure, ax = plt.subplots(layout="constrained", figsize=(8.2, 4.2))
            drawn = PolyCollection(cells, array=scaled(values, factor), cmap=colours,
                                   edgecolors="face", linewidths=0.1)
            ax.add_collection(drawn)
            ax.autoscale_view()
            part_axes(ax)
            figure.colorbar(drawn, ax=ax, shrink=0.8, label=label(name, unit))
            pictures.save(figure, f"{part}_{name}", f"{heading} of '{part}'")


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
        cases = table(arguments.folder, "results.csv")
        rows = table(arguments.folder, "rows.csv")
        if arguments.x and not cases and not rows:
            raise NothingToDraw(f"{arguments.folder} has no table of cases (results.csv, rows.csv)")
        if rows:
            draw_comparison(rows, pictures, summary, arguments)
        elif arguments.x:
            draw_pair(cases, pictures, arguments.x, arguments.y)
        elif cases:
            draw_batch(cases, pictures)
        for draw in (draw_overview, draw_history, draw_before_after, draw_design, draw_responses,
                     draw_energies, draw_mechanism, draw_outlines, draw_cells):
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
