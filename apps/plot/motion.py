"""Pictures of a motion: responses and energies over time."""

import math
import re

from style import BLUE, GREEN, LIMIT, ORANGE, RED, label, legend, scale_of, scaled, stacked
from tables import table


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


def error_of(figure):
    """Of its largest value (`--verify`), in all, or that by mesh and that by step; 0 where it is not known."""
    error = figure.get("error", {})
    return error.get("total") or sum(error.get(by) or 0 for by in ("mesh", "step"))


def band(ax, time, values, error, factor, colour, label=None):
    """The error of the largest value on either side of a line; nothing without one."""
    if error > 0:
        lower, upper = ([(v + sign * error) * factor for v in values] for sign in (-1, 1))
        ax.fill_between(time, lower, upper, color=colour, alpha=0.25, linewidth=0, label=label)


def draw_responses(folder, pictures, summary):
    series = table(folder, "responses.csv")
    if series is None or len(series.names) < 2:
        return
    time = series.numbers(series.names[0])
    groups = grouped_columns(series)
    modes = series.names[0] == "frequency"  # nothing lies between two of them
    figure, axes = stacked(len(groups))
    for ax, (stem, columns) in zip(axes, groups.items()):
        columns = moving(series, columns)
        values = [series.numbers(column) for column in columns]
        factor, unit = scale_of(sum(values, []), series.unit(columns[0]))
        error = error_of(summary.get("responses", {}).get(stem, {}))
        for column, line in zip(columns, values):
            drawn, = ax.plot(time, scaled(line, factor), label=column[len(stem) + 1:],
                             linestyle="" if modes else "-",
                             marker="o" if modes or len(time) < 30 else None, markersize=3)
            band(ax, time, line, error, factor, drawn.get_color())
        ax.set_ylabel(label(stem, unit))
        if len(columns) > 1:
            legend(ax)
    axes[-1].set_xlabel(label(series.names[0], series.units[0]))
    axes[-1].margins(x=0.01)
    pictures.save(figure, "responses", "responses")


def draw_energies(folder, pictures, _summary):
    series = table(folder, "energies.csv")
    if series is None or series.names[0] == "frequency":  # shapes of vibration have no size
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
        before_after(ax, before, after, name, columns, constraints.get(name, {}))
        legend(ax)
        ax.margins(x=0.01)
    axes[-1].set_xlabel(label(after.names[0], after.units[0]))
    pictures.save(figure, "response_before_after", "responses against their limits")


def before_after(ax, before, after, stem, columns, figure):
    """One response of the first and of the final design; `figure` is its limit in the summary."""
    limit, error = figure.get("limit"), error_of(figure)
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
        if name == "final":
            band(ax, time, values, error, factor, colour, "its error by mesh and step")
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
