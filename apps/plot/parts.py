"""Pictures of meshed parts: outlines over the steps, fractions and stresses of the cells."""

import math

import matplotlib.pyplot as plt
from matplotlib.collections import PolyCollection

from style import height_of, label, legend, scale_of, scaled
from tables import table


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


def part_axes(points):
    """A figure for a part with these points, one scale for both directions."""
    wide, high = (max(p[k] for p in points) - min(p[k] for p in points) for k in range(2))
    figure, ax = plt.subplots(layout="constrained", figsize=(8.2, height_of(wide, high)))
    ax.set_aspect("equal")
    ax.grid(False)
    ax.set_xlabel(label("x", "m"))
    ax.set_ylabel(label("y", "m"))
    return figure, ax


def draw_outlines(folder, pictures, _summary):
    """The outline of a planar part over the steps, the last one dark."""
    for path in sorted(folder.glob("*_outlines.csv")):
        found = table(folder, path.name)
        if not found:
            continue
        steps = closed_lines(found)
        points = [point for lines in steps.values() for xs, ys in lines for point in zip(xs, ys)]
        figure, ax = part_axes(points)
        shades = plt.get_cmap("viridis_r")
        last = max(steps)
        for step, lines in sorted(steps.items()):
            for i, (xs, ys) in enumerate(lines):
                share = (step - 1) / max(1, last - 1)
                ax.plot(xs, ys, color="black" if step == last else shades(0.15 + 0.6 * share),
                        linewidth=1.6 if step == last else 0.8,
                        label=f"step {step}" if i == 0 and step in (1, last) else None)
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
        fractions = found.numbers("fraction")
        for name, heading, colours in (("fraction", "fraction of the cells", "Greys"),
                                       ("stress", "von Mises stress, worst load case", "viridis")):
            values = found.numbers(name)
            if name == "stress":  # where there is material
                values = [v if f > 0 else math.nan for v, f in zip(values, fractions)]
            factor, unit = scale_of(values, found.unit(name))
            figure, ax = part_axes([corner for cell in cells for corner in cell])
            drawn = PolyCollection(cells, array=scaled(values, factor), cmap=colours,
                                   edgecolors="face", linewidths=0.1)
            ax.add_collection(drawn)
            ax.autoscale_view()
            figure.colorbar(drawn, ax=ax, shrink=0.8, label=label(name, unit))
            pictures.save(figure, f"{part}_{name}", f"{heading} of '{part}'")
