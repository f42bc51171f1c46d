"""Pictures of an optimisation: history of the cycle, the design, and all in one."""

import math
import re

import matplotlib.pyplot as plt
from matplotlib.ticker import MaxNLocator

from mechanism import enlarge, few, mechanism, peak_of, read_frames, read_shapes, shown_axes
from motion import before_after, grouped_columns, limit_tables
from style import BLUE, GREEN, GREY, LIMIT, ORANGE, RED, label, legend, scale_of, scaled, stacked
from tables import table

DESIGNS = 3  # of an overview, more are in the picture of the design


def draw_history(_folder, pictures, summary):
    history = summary.get("history") or []
    if not history:
        return
    cycles = [h["cycle"] for h in history]
    column = lambda key: [math.nan if h.get(key) is None else h[key] for h in history]
    changes = column("load_change")
    loads_change = any(map(math.isfinite, changes))
    figure, panels = stacked(3 if loads_change else 2, 2.0)
    upper, worst = panels[:2]

    objective = summary.get("objective") if "objective" in history[0] else None
    name, unit = (objective["quantity"], objective["unit"]) if objective else ("mass", "kg")
    values = column("objective" if objective else "mass")
    factor, unit = scale_of(values, unit)
    upper.plot(cycles, scaled(values, factor), "o-", color=BLUE)
    upper.set_ylabel(label(name, unit))

    values = scaled(column("worst_constraint"), 100)
    worst.axhline(0, label="limit", **LIMIT)
    worst.plot(cycles, values, "o-", color=RED)
    finite = [v for v in values if math.isfinite(v)]
    if finite and max(map(abs, finite)) > 20:
        worst.set_yscale("symlog", linthresh=1)
        worst.yaxis.set_major_formatter(lambda v, _: f"{v:g}".replace("-", "−"))
    worst.set_ylabel("worst constraint\nabove its limit [%]")
    mark_models(panels, summary)
    legend(worst)

    if loads_change:
        draw_load_change(panels[2], cycles, changes)
    panels[-1].set_xlabel("step" if "objective" in summary else "cycle")
    panels[-1].xaxis.set_major_locator(MaxNLocator(integer=True, min_n_ticks=1))
    panels[-1].set_xlim(min(cycles) - 0.3, max(cycles) + 0.3)
    figure.align_ylabels()
    status = summary.get("status", "")
    pictures.save(figure, "cycle_history", f"cycle history ({status})" if status else
                  "cycle history")


def mark_models(panels, summary):
    """Where the study went on with a finer model."""
    for model, step in enumerate((summary.get("refinement") or {}).get("steps", [])):
        for ax in panels:
            ax.axvline(step["cycles"] + 0.5, color=GREY, linestyle=":", label=None if model else "finer model")


def draw_load_change(ax, cycles, changes):
    if any(v > 0 for v in changes):
        ax.set_yscale("log")
        changes = [v if v > 0 else math.nan for v in changes]
    ax.plot(cycles, changes, "o-", color=GREEN)
    ax.set_ylabel("relative change\nof the loads")


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
    panels, numbers = {}, ("s0", "s1", "initial", "final", "lower", "upper")
    design.check_numbers(numbers)
    for row in design.rows:
        cell = dict(zip(design.names, row))
        key = (re.sub(r"\[\d+\]$", "", cell["variable"]), cell["body"])
        panels.setdefault(key, []).append(
            [float(cell[k]) for k in numbers] + [cell["unit"]])
    return panels


def draw_steps(ax, rows, variable, body):
    """Initial and final value over the length, as steps, with the bounds."""
    edges = [row[0] for row in rows] + [rows[-1][1]]
    factor, unit = scale_of([row[k] for row in rows for k in (2, 3)], rows[0][6])
    column = lambda k: scaled([row[k] for row in rows], factor)
    lower, upper = column(4), column(5)
    ax.stairs(column(3), edges, baseline=0, fill=True, color=GREY, alpha=0.12)  # blue ones are errors
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


def governing(motions, constraints):
    """The limit that is violated most or has least to spare, of those with a response to draw: its name, its response, and tables
    of its motion; None: there is none."""
    found = [(f"{stem} ({scenario})" if scenario else stem, stem, before, after)
             for scenario, before, after in motions for stem in grouped_columns(after)]
    spent = lambda entry: constraints[entry[0]].get("violation") or 0  # noqa: E731
    return max((entry for entry in found if entry[0] in constraints), key=spent, default=None)


def draw_overview(folder, pictures, summary):
    """Of an optimisation, in one picture: the mechanism, the governing limit, the design."""
    constraints, design = summary.get("constraints", {}), table(folder, "design.csv")
    limit = governing(limit_tables(folder), constraints)
    if limit is None or design is None or not (folder / "frames.csv").exists():
        return
    instants, time_label = read_frames(folder / "frames.csv")
    if not instants:
        return
    instants, shapes, larger = enlarge(instants, read_shapes(folder, instants), time_label)
    if len(shown_axes(instants, shapes)) == 3:
        return
    panels = design_panels(design)
    shown = list(panels.items())[:DESIGNS]
    figure = plt.figure(figsize=(11, 2.6 + 2 * len(shown)), layout="constrained")
    grid = figure.add_gridspec(1 + len(shown), 2, width_ratios=(1.15, 1))
    ax = figure.add_subplot(grid[:, 0])
    ax.set_anchor("N")
    marks = mechanism(ax, instants, few(instants, peak_of(summary)), shown_axes(instants, shapes), time_label, shapes)
    ax.legend(handles=marks, loc="upper center", bbox_to_anchor=(0.5, -0.16), ncols=3)
    ax.set_title(larger)
    draw_limit(figure.add_subplot(grid[0, 1]), limit, constraints)
    for row, ((variable, body), rows) in enumerate(shown, 1):
        draw_steps(figure.add_subplot(grid[row, 1]), sorted(rows), variable, body)
    pictures.save(figure, "overview", heading_of(summary) + (f"; {DESIGNS} of {len(panels)} designs" if len(panels) > DESIGNS else ""))


def draw_limit(ax, limit, constraints):
    """@param limit as of governing"""
    name, stem, before, after = limit
    before_after(ax, before, after, name, grouped_columns(after)[stem], constraints[name])
    ax.set_xlabel(label(after.names[0], after.units[0]))
    ax.margins(x=0.01)
    ax.legend(loc="lower center", bbox_to_anchor=(0.5, 0.98), ncols=3)


def heading_of(summary):
    masses = [summary.get(key) for key in ("mass_initial", "mass_final")]
    heading = f"{summary.get('status', '')} after {summary.get('cycles', '?')} cycles"
    if None not in masses:
        factor, unit = scale_of(masses, "kg")
        heading += f", {masses[0] * factor:.4g} {unit} → {masses[1] * factor:.4g} {unit}"
    return heading
