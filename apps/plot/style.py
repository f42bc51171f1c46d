"""Colours, labels and files of the pictures."""

import math
import os

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402


# Okabe & Ito: told apart with every kind of colour vision.
BLUE, ORANGE, GREEN, RED, PURPLE, SKY = (
    "#0072B2", "#E69F00", "#009E73", "#D55E00", "#CC79A7", "#56B4E9")
BLACK, OLIVE = "#000000", "#8A8D00"
COLOURS = [BLUE, ORANGE, GREEN, PURPLE, SKY, RED, BLACK, OLIVE]
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


def height_of(wide, high):
    """Height of a figure, 8.2 inches wide, whose axes have one scale; `wide` times `high` is shown."""
    return min(max(6.2 * high / max(wide, 1e-300), 0.8), 5.5) + 1.3


class Pictures:
    """Writes each figure as PNG and SVG, whole or not at all."""

    def __init__(self, folder, title):
        self.folder, self.title, self.paths = folder, title, []

    def save(self, figure, name, heading, box=None):
        """@param box what is kept of the figure, inches; None: what is drawn"""
        figure.suptitle(f"{self.title}: {heading}" if self.title else heading, fontsize=12)
        self.folder.mkdir(parents=True, exist_ok=True)
        # The layout once, for both files.
        figure.draw_without_rendering()
        figure.set_layout_engine("none")
        box = (box or figure.get_tightbbox()).padded(0.12)
        for kind in ("png", "svg"):
            path = self.folder / f"{name}.{kind}"
            part = self.folder / f".{name}.{kind}.part"
            figure.savefig(part, format=kind, bbox_inches=box,
                           metadata={"Date": None} if kind == "svg" else {"Software": "liesl"})
            os.replace(part, path)
            self.paths.append(path)
        plt.close(figure)
