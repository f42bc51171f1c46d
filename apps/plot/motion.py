"""Pictures of a motion: responses and energies over time, the mechanism at instants."""

import math
import re

import matplotlib
import matplotlib.pyplot as plt
from matplotlib.ticker import MaxNLocator

from style import BLUE, GREEN, LIMIT, ORANGE, RED, label, legend, scale_of, scaled, stacked
from tables import table, Table


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


def limit_tables(folder):
    """(scenario, initial, final) of each motion of an optimisation; "" where there is one."""
    found = []
    for path in sorted(folder.glob("responses_final*.csv")):
        scenario = path.stem[len("responses_final"):]
        before, after = table(folder, f"responses_initial{scenario}.csv"), table(folder, path.name)
        if before is not None and after is not None:
            found.append((scenario[1:], before, after))
    return found


def draw_before_after(folder, pictures, summary):
    constraints = summary.get("constraints", {})
    panels = []
    for scenario, before, after in limit_tables(folder):
        groups = grouped_columns(after)
        names = {stem: f"{stem} ({scenario})" if scenario else stem for stem in groups}
        chosen = [stem for stem in groups if names[stem] in constraints] or list(groups)
        panels += [(before, after, stem, groups[stem], names[stem]) for stem in chosen]
    if not panels:
        return
    figure, axes = stacked(len(panels), 2.9)
    for ax, (before, after, stem, columns, name) in zip(axes, panels):
        before_after(ax, before, after, name, columns, constraints.get(name, {}).get("limit"))
        legend(ax)
        ax.margins(x=0.01)
    axes[-1].set_xlabel(label(after.names[0], after.units[0]))
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
