"""Pictures of meshed parts: outlines over the steps; fractions, stresses, gains of the cells."""

import math

import matplotlib.pyplot as plt
from matplotlib.collections import PolyCollection
from matplotlib.patches import Circle

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


def cell_picture(cells, values, colours, text, limit=None):
    """A field over the cells; with a limit from -limit to limit."""
    figure, ax = part_axes([corner for cell in cells for corner in cell])
    drawn = PolyCollection(cells, array=values, cmap=colours, edgecolors="face", linewidths=0.1)
    if limit:
        drawn.set_clim(-limit, limit)
    ax.add_collection(drawn)
    ax.autoscale_view()
    figure.colorbar(drawn, ax=ax, shrink=0.8, label=text, extend="min" if limit else "neither")
    return figure, ax


def draw_cells(folder, pictures, summary):
    """Fraction of the cells, stress in the load case of the largest, what new holes would gain."""
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
            figure, _ = cell_picture(cells, scaled(values, factor), colours, label(name, unit))
            pictures.save(figure, f"{part}_{name}", f"{heading} of '{part}'")
        if "hole_gain" in found.names:
            draw_gain(found, cells, part, pictures, summary)


def draw_gain(found, cells, part, pictures, summary):
    """What the objective would fall by in full cells, and the hole that is proposed."""
    values = [v if f >= 1 else math.nan
              for v, f in zip(found.numbers("hole_gain"), found.numbers("fraction"))]
    finite = [v for v in values if math.isfinite(v)]
    best = max(finite, default=0) or max(map(abs, finite), default=0)
    if best == 0:
        return
    figure, ax = cell_picture(cells, values, "RdBu", label("gain", found.unit("hole_gain")),
                              limit=abs(best))
    hole = (summary.get("nucleation") or {}).get("next")
    if hole:
        ax.add_patch(Circle(hole["place"][:2], hole["radius"], fill=False, color="black",
                            linewidth=1.6))
    pictures.save(figure, f"{part}_hole_gain", f"gain of a new hole in '{part}'")
