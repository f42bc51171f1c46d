"""Pictures of sensitivities: derivatives over time, and what a per cent of each parameter does."""

import matplotlib.pyplot as plt

from style import COLOURS, ORANGE, BLUE, label, legend, scaled, stacked
from tables import table

MOST_LINES = 6
MOST_BARS = 20


def draw_sensitivities(folder, pictures, summary):
    """p dy/dp over time, a panel a response, of the parameters that count most."""
    series = table(folder, "sensitivities.csv")
    parameters = summary.get("parameters", {})
    if series is None or not parameters:
        return
    time = series.numbers(series.names[0])
    units = {name: figure["unit"] for name, figure in summary.get("responses", {}).items()}
    panels = {}
    for name in series.names[1:]:
        response, parameter = name.rsplit(" by ", 1)
        change = scaled(series.numbers(name), 0.01 * parameters[parameter]["value"])
        panels.setdefault(response, []).append((parameter, change))
    figure, axes = stacked(len(panels), 2.6)
    colours = {}  # of a parameter, the same in all panels
    for ax, (response, lines) in zip(axes, panels.items()):
        lines.sort(key=lambda line: -max(map(abs, line[1]), default=0))
        for parameter, change in lines[:MOST_LINES]:
            colour = colours.setdefault(parameter, COLOURS[len(colours) % len(COLOURS)])
            ax.plot(time, change, color=colour, label=parameter)
        unit = units.get(response, units.get(response[:-2], ""))
        ax.set_ylabel(label(f"{response}\nby 1 %", unit))
        if len(lines) > MOST_LINES:
            ax.plot([], [], " ", label=f"and {len(lines) - MOST_LINES} more")
        legend(ax)
    axes[-1].set_xlabel(label(series.names[0], series.units[0]))
    axes[-1].margins(x=0.01)
    figure.align_ylabels()
    pictures.save(figure, "sensitivities", "change of the responses by 1 % of a parameter")


def draw_gradients(folder, pictures, _summary):
    """(p/J) dJ/dp of the first functional of each response, as bars."""
    rows = table(folder, "gradients.csv")
    if rows is None:
        return
    panels, first = {}, {}
    for response, functional, parameter, relative in zip(
            *map(rows.text, ("response", "functional", "parameter")), rows.numbers("relative")):
        if first.setdefault(response, functional) == functional:
            panels.setdefault(f"{response}, {functional}", []).append((parameter, relative))
    shown = {name: sorted(bars, key=lambda bar: -abs(bar[1]))[:MOST_BARS]
             for name, bars in panels.items()}
    heights = [len(bars) * (1 + 0.3 * max(parameter.count("+") for parameter, _ in bars))
               for bars in shown.values()]
    figure, axes = plt.subplots(len(shown), 1, squeeze=False, layout="constrained",
                                height_ratios=heights,
                                figsize=(8.2, 1.2 + 0.7 * len(shown) + 0.24 * sum(heights)))
    for (ax,), (name, bars) in zip(axes, shown.items()):
        values = [value for _, value in bars]
        ax.barh(range(len(bars)), values, color=[BLUE if v < 0 else ORANGE for v in values])
        ax.set_yticks(range(len(bars)), [parameter.replace("+", "\n+ ") for parameter, _ in bars],
                      fontsize="small")
        ax.invert_yaxis()
        ax.axvline(0, color="black", linewidth=0.8)
        more = len(panels[name]) - len(bars)
        ax.set_title(name.replace("_", " ") + (f" ({more} more parameters)" if more else ""),
                     loc="left")
    figure.supxlabel("per cent, by 1 % of the parameter", fontsize="medium")
    pictures.save(figure, "gradients", "relative gradients")
