"""Pictures of a comparison: error against time, orders, effort, stability maps."""

import math
import re

import matplotlib.pyplot as plt

from style import BLUE, COLOURS, GREEN, LIMIT, ORANGE, PURPLE, RED, label, legend, stacked
from tables import is_number, NothingToDraw


CLASSES = {"converged": (GREEN, "s"), "recovered": (ORANGE, "D"), "stopped": (RED, "X")}


class Comparison:
    """rows.csv: rows as dictionaries of texts, and the columns that were varied."""

    def __init__(self, series, summary):
        self.rows = [dict(zip(series.names, row)) for row in series.rows]
        inputs = series.names[1:series.names.index("status")]
        self.varied = [n for n in inputs if len({row[n] for row in self.rows}) > 1]
        self.unit = series.unit("error")
        self.label = {name: label(name, series.unit(name)) for name in inputs}
        self.quantity = f"{summary.get('norm', '')} error of {summary.get('response', '')}"
        words = [n for n in self.varied if not all(is_number(row[n]) for row in self.rows)]
        self.numbers = [n for n in self.varied if n not in words]
        # A colour for each combination of words: formalism, tangent, ...
        for row in self.rows:
            row["kind"] = " ".join(row[n] for n in words) or row.get("formalism", "") or "rows"
        self.kinds = list(dict.fromkeys(row["kind"] for row in self.rows))
        # Lines that lie on each other are told apart by their markers.
        self.looks = {kind: dict(color=COLOURS[i % len(COLOURS)], marker="osD^vPX*"[i % 8],
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
        ax.set_xlabel(comparison.label[axis])
        ax.set_ylabel(label(comparison.quantity, comparison.unit))
        ax.legend(loc="upper center", bbox_to_anchor=(0.5, -0.14), ncols=3, title="fitted slope")
    pictures.save(figure, "orders", "order, at the finest mesh or step otherwise")


def draw_effort(comparison, pictures, _arguments):
    """Error, time, iterations and factorisations over what was varied of the mechanism."""
    columns = {"newton_iterations": "iterations a step", "factorizations": "factorisations\nin the run"}
    if comparison.kinds_with("cpu_s"):
        columns = {"cpu_s": "CPU time of\nthe stepping [s]", **columns}
    if comparison.kinds_with("error"):
        columns = {"error": label(comparison.quantity, comparison.unit), **columns}
    for axis in comparison.physical:
        figure, axes = stacked(len(columns), 2.6)
        panels = dict(zip(columns, axes))
        for kind in comparison.kinds:
            rows = finest(comparison.of(kind, axis, "steps"), comparison, axis)
            for column, ax in panels.items():
                good = [row for row in rows if row["status"] != "stopped" and is_number(row[column])]
                if not good:
                    continue
                per = max(float(good[0]["steps"]), 1) if column == "newton_iterations" else 1
                ax.plot([float(row[axis]) for row in good], [float(row[column]) / per for row in good],
                        label=kind, **comparison.looks[kind])
        for column, ax in panels.items():
            ax.set_ylabel(columns[column])
            scale_axis(ax, "x", [float(row[axis]) for row in comparison.rows])
            shown = [y for line in ax.get_lines() for y in line.get_ydata()]
            alike = column == "cpu_s" and max(shown, default=0) < 10 * min(shown, default=0)
            if column == "newton_iterations" or alike:
                ax.set_ylim(bottom=0)
            else:
                log_axes(ax, "y")
            if column == "error":
                show_floor(ax, comparison)
            legend(ax)
        axes[-1].set_xlabel(comparison.label[axis])
        pictures.save(figure, f"effort_over_{axis}", f"error and effort over {label(axis, '')}")


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
    figure.supxlabel(comparison.label[pair[0]], fontsize=10)
    figure.supylabel(comparison.label[pair[1]], fontsize=10)
    legend(axes[0][columns - 1], handles=axes[0][0].get_legend_handles_labels()[0])
    name = re.sub(r"[^\w.+-]+", "_", f"stability_{pair[0]}_{pair[1]}")
    pictures.save(figure, name, "how runs end (the worst over what else is varied)")


METHODS = {"esl": BLUE, "esl1": ORANGE, "full": GREEN, "direct": PURPLE}


def masses_about_optimum(rows, share=0.03):
    """Range of masses about the lightest optimal one that shows its neighbours apart; None: all fit. Where optima
    differ by more, as those of another limit do, about the lightest of those that most rows end at."""
    masses = [float(row["mass"]) for row in rows if is_number(row["mass"])]
    optimal = [float(row["mass"]) for row in rows
               if row["status"] == "optimal" and is_number(row["mass"])]
    middle = sorted(optimal)[len(optimal) // 2] if optimal else 0
    lightest = min((m for m in optimal if abs(m / middle - 1) <= share), default=0)
    close = [m for m in masses if lightest and abs(m / lightest - 1) <= share]
    if len(close) in (0, len(masses)):
        return None
    room = max(0.15 * (max(close) - min(close)), 1e-3 * min(close))
    return min(close) - room, max(close) + room


def mark_outside(ax, rows, limits):
    """What is outside lies on the edge of the panel, with its mass."""
    ax.set_ylim(*limits)
    written = set()
    for row in rows:
        if not (is_number(row["mass"]) and is_number(row["cpu_s"])):
            continue
        mass, time = float(row["mass"]), float(row["cpu_s"])
        text = f"{mass:.3g}"
        if limits[0] <= mass <= limits[1] or (text, round(math.log10(time), 1)) in written:
            continue
        written.add((text, round(math.log10(time), 1)))
        up = mass > limits[1]
        ax.annotate(text, (time, limits[1 if up else 0]), xytext=(0, -8 if up else 8),
                    textcoords="offset points", ha="center", va="top" if up else "bottom", fontsize=7)


def draw_methods(series, pictures):
    """Mass against processor time, a point an optimisation; below it how far from optimal it ended."""
    rows = [dict(zip(series.names, row)) for row in series.rows]
    inputs = series.names[1:series.names.index("status")]
    markers = next((n for n in ("treatment", "optimizer", *inputs) if n != "method" and n in inputs
                    and len({row[n] for row in rows}) > 1), None)
    kinds = list(dict.fromkeys(row[markers] for row in rows)) if markers else [""]
    looks = dict(zip(kinds, "osD^vPX*<>" * len(kinds)))
    figure, panels = stacked(2, 3.2)
    limits = masses_about_optimum(rows)
    for ax, column, unit in ((panels[0], "mass", "kg"), (panels[1], "kkt", "")):
        for row in rows:
            if not (is_number(row[column]) and is_number(row["cpu_s"])):
                continue
            colour = METHODS.get(row.get("method"), RED)
            good = row["status"] in ("optimal", "converged")
            y = float(row[column])
            if column == "mass" and limits:
                y = min(max(y, limits[0]), limits[1])
            ax.plot(float(row["cpu_s"]), y, clip_on=False,
                    marker=looks[row[markers] if markers else ""], color=colour, markersize=7,
                    markerfacecolor=colour if row["status"] == "optimal" else "white",
                    alpha=0.85 if good else 0.35, linestyle="none")
        ax.set_ylabel(label("KKT residual" if column == "kkt" else column, unit))
    if limits:
        mark_outside(panels[0], rows, limits)
    panels[1].axhline(0.01, label="optimal below", **LIMIT)
    log_axes(panels[0], "x")
    log_axes(panels[1], "x", "y")
    for method in dict.fromkeys(row.get("method", "") for row in rows):
        panels[0].plot([], [], "o", color=METHODS.get(method, RED), label=method)
    for kind in kinds if markers else []:
        panels[0].plot([], [], looks[kind], color="black", markerfacecolor="none", label=kind)
    panels[0].plot([], [], "o", color="black", label="optimal")
    panels[0].plot([], [], "o", color="black", markerfacecolor="white", label="not optimal")
    for ax in panels:
        legend(ax)
    panels[1].set_xlabel("processor time [s]")
    figure.align_ylabels()
    pictures.save(figure, "methods", "mass against time")


def draw_comparison(series, pictures, summary, arguments):
    if "simulations" in series.names:
        draw_methods(series, pictures)
        return
    comparison = Comparison(series, summary)
    if arguments.x:
        draw_stability(comparison, pictures, arguments)
        return
    for draw in (draw_work_precision, draw_orders, draw_effort, draw_stability):
        draw(comparison, pictures, arguments)
    if not pictures.paths:
        raise NothingToDraw("rows.csv has no errors and varies no number of the mechanism; it varies "
                            + (", ".join(comparison.varied) or "nothing"))
