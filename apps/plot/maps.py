"""Pictures of a map over two design variables (thesis Fig. 3.8)."""

import math

import matplotlib.pyplot as plt
from matplotlib.lines import Line2D

from style import BLUE, ORANGE, RED, label, scale_of, scaled
from tables import table

LEVELS = 10


def grid_of(points, name, nx):
    values = points.numbers(name, gaps=True)
    return [values[k:k + nx] for k in range(0, len(values), nx)]


def has_contour(rows, level):
    values = [v for row in rows for v in row if math.isfinite(v)]
    return values and min(values) < level < max(values)


def draw_quantity(ax, x, y, points, name, figure):
    """Filled: the study itself; orange and dashed: the local model; red: the limit of both."""
    nx = len(x)
    factor, unit = scale_of([v for v in points.numbers(name, gaps=True) if not math.isnan(v)], figure["unit"])
    rows = [scaled(row, factor) for row in grid_of(points, name, nx)]
    finite = [v for row in rows for v in row if math.isfinite(v)]
    if not finite or min(finite) == max(finite):
        ax.set_title(label(name, unit), loc="left")
        return None
    filled = ax.contourf(x, y, rows, LEVELS, cmap="Blues")
    lines = ax.contour(x, y, rows, levels=filled.levels, colors=BLUE, linewidths=0.6)
    bar = ax.figure.colorbar(filled, ax=ax)
    bar.set_label(label(name, unit))
    limit = figure["limit"] * factor if figure["limit"] is not None else None
    local = f"{name} local"
    modelled = local in points.names
    model = [scaled(row, factor) for row in grid_of(points, local, nx)] if modelled else None
    if modelled:
        ax.contour(x, y, model, levels=lines.levels, colors=ORANGE, linewidths=0.9,
                   linestyles="dashed")
    if limit is not None and has_contour(rows, limit):
        ax.contour(x, y, rows, levels=[limit], colors=RED, linewidths=2.2)
    if limit is not None and modelled and has_contour(model, limit):
        ax.contour(x, y, model, levels=[limit], colors=RED, linewidths=2.2, linestyles="dashed")
    return modelled


def draw_path(ax, stops, names, factors, summary):
    """Designs of an optimisation, numbered, and where the local model is made."""
    places = [scaled(stops.numbers(name), f) for name, f in zip(names, factors)] if stops else None
    if places:
        ax.plot(*places, "o-", color="black", markersize=4, linewidth=1.1)
        for cycle, x, y in zip(stops.text("cycle"), *places):
            if cycle in (stops.text("cycle")[0], stops.text("cycle")[-1]):
                right, above = x > sum(ax.get_xlim()) / 2, y > sum(ax.get_ylim()) / 2
                ax.annotate(cycle, (x, y), textcoords="offset points", fontsize=8,
                            xytext=(-5 if right else 5, -5 if above else 5),
                            ha="right" if right else "left", va="top" if above else "bottom")
    centre = [summary["centre"][name] * f for name, f in zip(names, factors)]
    ax.plot(*centre, "*", color=ORANGE, markeredgecolor="black", markersize=13)


def draw_map(folder, pictures, summary):
    points = table(folder, "map.csv")
    if points is None:
        return
    names = points.names[:2]
    axes_values = [sorted(set(points.numbers(name))) for name in names]
    scales = [scale_of(values, points.unit(name)) for values, name in zip(axes_values, names)]
    x, y = (scaled(values, factor) for values, (factor, _) in zip(axes_values, scales))
    wanted = list(summary["of"].items())
    columns = min(2, len(wanted))
    lines = -(-len(wanted) // columns)
    figure, axes = plt.subplots(lines, columns, squeeze=False, layout="constrained",
                                figsize=(1.2 + 5.0 * columns, 1.1 + 3.9 * lines))
    stops = table(folder, "path.csv")
    local = False
    for ax, (name, entry) in zip(axes.flat, wanted):
        local = draw_quantity(ax, x, y, points, name, entry) or local
        if entry["limit"] is None:  # the objective, with the limits that it meets
            for other, limited in wanted:
                rows = grid_of(points, other, len(x))
                if limited["limit"] is not None and has_contour(rows, limited["limit"]):
                    ax.contour(x, y, rows, levels=[limited["limit"]], colors=RED, linewidths=2.2)
        draw_path(ax, stops, names, [factor for factor, _ in scales], summary)
        ax.set_xlabel(label(names[0], scales[0][1]))
        ax.set_ylabel(label(names[1], scales[1][1]))
        ax.set_xlim(min(x), max(x))
        ax.set_ylim(min(y), max(y))
        ax.grid(False)
    for ax in list(axes.flat)[len(wanted):]:
        ax.set_axis_off()
    marks = [Line2D([], [], color=BLUE, label="of the study"),
             Line2D([], [], color=RED, linewidth=2.2, label="limit")]
    if local:
        marks[1:1] = [Line2D([], [], color=ORANGE, linestyle="dashed", label="of the local model"),
                      Line2D([], [], color=ORANGE, marker="*", markeredgecolor="black",
                             markersize=11, linestyle="none", label="where it is made")]
        if any(entry["limit"] is not None for _, entry in wanted):
            marks.append(Line2D([], [], color=RED, linewidth=2.2, linestyle="dashed",
                                label="limit by the local model"))
    else:
        marks.append(Line2D([], [], color=ORANGE, marker="*", markeredgecolor="black",
                            markersize=11, linestyle="none", label="centre"))
    if stops:
        marks.append(Line2D([], [], color="black", marker="o", markersize=4,
                            label="cycles of the optimisation"))
    figure.legend(handles=marks, loc="upper center", bbox_to_anchor=(0.5, 0), ncols=3)
    pictures.save(figure, "map", "over " + " and ".join(n.replace("_", " ") for n in names))
