"""Panels with axes in space. Matplotlib draws these in a square, however little of it they fill: cells as large as what is
drawn, their squares overlapping where they are empty."""

from itertools import product

import matplotlib.pyplot as plt
from matplotlib.transforms import Bbox
from mpl_toolkits.mplot3d import proj3d

GAP = 0.15  # inches between cells
HEAD = 0.45  # inches for the heading of the figure
TITLE = 0.3  # inches for the title of a panel


def drawn_box(frame, side):
    """What axes in space of a square fill, ticks and labels included; inches from its lower left corner.
    @param frame labels and limits axes"""
    figure = plt.figure(figsize=(side, side))
    ax = figure.add_axes((0, 0, 1, 1), projection="3d")
    frame(ax)
    figure.draw_without_rendering()
    renderer = figure.canvas.get_renderer()
    corners = product(ax.get_xlim3d(), ax.get_ylim3d(), ax.get_zlim3d())
    panes = ax.transData.transform([proj3d.proj_transform(*corner, ax.get_proj())[:2] for corner in corners])
    boxes = [Bbox([panes.min(axis=0), panes.max(axis=0)])]
    boxes += [box for axis in (ax.xaxis, ax.yaxis, ax.zaxis) if (box := axis.get_tightbbox(renderer))]
    plt.close(figure)
    return Bbox.union(boxes).transformed(figure.dpi_scale_trans.inverted())


def space_panels(count, columns, side, frame, titles=()):
    """A figure with panels of the same axes, row by row. @param side of the square of each, inches"""
    box = drawn_box(frame, side)
    columns = min(columns, count)
    wide, high = box.width + GAP, box.height + GAP + (TITLE if titles else 0)
    width, height = columns * wide, -(-count // columns) * high + HEAD
    figure, panels = plt.figure(figsize=(width, height)), []
    for n in range(count):
        left, top = (n % columns) * wide + GAP / 2, height - HEAD - (n // columns) * high
        if titles:
            figure.text((left + box.width / 2) / width, (top - TITLE / 2) / height, titles[n], ha="center", va="center", fontsize=10)
            top -= TITLE
        ax = figure.add_axes(((left - box.x0) / width, (top - box.y1) / height, side / width, side / height), projection="3d")
        ax.patch.set_visible(False)
        ax.set_in_layout(False)  # its square is not what it fills
        panels.append(ax)
    return figure, panels


def whole_box(figure, legend):
    """The figure and its legend, inches."""
    figure.draw_without_rendering()
    outside = legend.get_window_extent().transformed(figure.dpi_scale_trans.inverted())
    return Bbox.union([Bbox.from_bounds(0, 0, *figure.get_size_inches()), outside])
