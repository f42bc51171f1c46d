"""Draws docs/images/responses.svg: what each response measures. /usr/bin/python3 docs/pictures/responses.py"""
from pathlib import Path

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams["svg.hashsalt"] = "liesl"
import matplotlib.pyplot as plt
import numpy as np

NOW, REST, MARK, FORCE, TEXT = "#1d4f91", "#9aa7b5", "#c2410c", "#15803d", "#222222"


def bent(n=41):
    """A beam that has turned and bent: points, and the angle of its axis at each."""
    s = np.linspace(0, 1, n)
    angle = 0.95 - 1.1 * s
    step = np.diff(s)[:, None] * np.column_stack((np.cos(angle), np.sin(angle)))[:-1]
    return np.vstack(([0, 0], np.cumsum(step, axis=0))), angle


def arrow(ax, a, b, colour, both=False, width=1.6):
    ax.annotate("", b, a, arrowprops={"arrowstyle": "<|-|>" if both else "-|>", "color": colour,
                                      "lw": width, "shrinkA": 0, "shrinkB": 0})


def text(ax, x, y, words, colour=TEXT, **how):
    ax.text(x, y, words, color=colour, fontsize=9, **{"ha": "center", "va": "center", **how})


def turn(ax, centre, radius, start, end, colour):
    """An arc with a head, angles in degrees."""
    t = np.radians(np.linspace(start, end, 40))
    x, y = centre[0] + radius * np.cos(t), centre[1] + radius * np.sin(t)
    ax.plot(x[:-2], y[:-2], color=colour, lw=1.6)
    arrow(ax, (x[-3], y[-3]), (x[-1], y[-1]), colour)


def frame(ax, at, angle, names=("x", "y"), size=0.2, colour=TEXT):
    for k, name in enumerate(names):
        d = np.array([np.cos(angle + k * np.pi / 2), np.sin(angle + k * np.pi / 2)])
        arrow(ax, at, at + size * d, colour, width=1.0)
        text(ax, *(at + 1.3 * size * d), name, colour)


def panel(ax, title, of, x=(-0.25, 1.25), y=(-0.3, 0.85)):
    ax.set(xlim=x, ylim=y, aspect="equal")
    ax.axis("off")
    ax.set_title(title, fontsize=10, family="monospace", pad=2)
    text(ax, np.mean(x), y[0] + 0.02, of, "#555555", style="italic")


def beam(ax, rest=True):
    points, angle = bent()
    if rest:
        ax.plot([0, 1], [0, 0], color=REST, lw=2, ls=(0, (4, 2)))
    ax.plot(*points.T, color=NOW, lw=3)
    ax.plot(*points[[0, -1]].T, "o", color=NOW, ms=5)
    return points, angle


def position(ax):
    panel(ax, "position, velocity, acceleration", "of a port: inertial axes (or its own)")
    points, _ = beam(ax)
    origin, tip = np.array([-0.2, -0.18]), points[-1]
    frame(ax, origin, 0)
    arrow(ax, origin, tip, MARK)
    text(ax, 0.42, 0.12, "x", MARK)
    arrow(ax, tip, tip + [0.28, 0.2], FORCE)
    text(ax, *(tip + [0.33, 0.24]), "v", FORCE)


def rotation(ax):
    panel(ax, "rotation, angular_velocity, angular_acceleration", "of a port, since the scene as given; right-hand rule")
    points, angle = beam(ax)
    tip = points[-1]
    arrow(ax, tip, tip + 0.35 * np.array([1, 0]), REST)
    arrow(ax, tip, tip + 0.35 * np.array([np.cos(0.6), np.sin(0.6)]), NOW)
    turn(ax, tip, 0.27, 0, np.degrees(0.6), MARK)
    text(ax, *(tip + [0.36, 0.1]), "φ", MARK)


def displacement(ax):
    panel(ax, "displacement", "of a port, seen from node 0 of its body, in its axes", y=(-0.3, 1.05))
    points, angle = beam(ax, rest=False)
    along = np.array([np.cos(angle[0]), np.sin(angle[0])])
    ax.plot(*np.array([[0, 0], along]).T, color=REST, lw=2, ls=(0, (4, 2)))
    text(ax, *(along + [0.0, 0.07]), "undeformed, turned with node 0", REST, ha="center")
    arrow(ax, along, points[-1], MARK)
    text(ax, *(0.5 * (along + points[-1]) + [0.06, 0.03]), "p", MARK)
    frame(ax, np.array([0, 0]), angle[0], ("x₀", "y₀"))


def deflection(ax):
    panel(ax, "deflection", "of a node from the chord; 0 at the ends")
    points, _ = beam(ax, rest=False)
    ax.plot(*points[[0, -1]].T, color=REST, lw=1.2, ls="--")
    chord = points[-1] / np.linalg.norm(points[-1])
    mid = points[20]
    foot = chord * (mid @ chord)
    arrow(ax, foot, mid, MARK)
    ax.plot(*mid, "o", color=NOW, ms=5)
    text(ax, *(mid + [-0.03, 0.1]), "d", MARK)
    text(ax, *(0.75 * points[-1] + [0.08, -0.1]), "chord", REST)


def elongation(ax):
    panel(ax, "elongation", "of a beam's ends, or of two ports: longer is positive")
    points, _ = beam(ax, rest=False)
    off = np.array([0.07, -0.12])
    arrow(ax, points[0] + off, points[-1] + off, MARK, both=True)
    text(ax, *(0.5 * points[-1] + off + [0.1, -0.06]), "l − l*", MARK)


def joint(ax):
    panel(ax, "coordinate, joint_force, drive_force", "q of the second port; f on the second port")
    ax.plot([-0.2, 0.35], [0.05, 0.05], color=REST, lw=3)
    end = np.array([0.35, 0.05]) + 0.75 * np.array([np.cos(0.75), np.sin(0.75)])
    ax.plot([0.35, end[0]], [0.05, end[1]], color=NOW, lw=3)
    ax.plot([0.35, 1.1], [0.05, 0.05], color=REST, lw=1, ls="--")
    ax.plot(0.35, 0.05, "o", color="white", mec=NOW, ms=9, mew=2)
    turn(ax, (0.35, 0.05), 0.42, 0, np.degrees(0.75), MARK)
    text(ax, 0.95, 0.2, "q, drive > 0", MARK)
    arrow(ax, (0.35, 0.05), (0.12, 0.42), FORCE)
    text(ax, 0.07, 0.45, "f", FORCE)
    text(ax, -0.05, -0.03, "first port", REST)
    text(ax, *(end + [0.0, 0.06]), "second port", NOW)


def section_force(ax):
    panel(ax, "section_force", "on the side that looks along +x; M by the right hand", y=(-0.35, 0.8))
    ax.add_patch(plt.Rectangle((0, 0.1), 0.5, 0.24, fc="#dbe7f5", ec=NOW, lw=2))
    arrow(ax, (0.5, 0.22), (0.85, 0.22), FORCE)
    text(ax, 0.97, 0.22, "N > 0", FORCE)
    arrow(ax, (0.5, 0.22), (0.5, 0.6), FORCE)
    text(ax, 0.5, 0.67, "V_y > 0", FORCE)
    turn(ax, (0.5, 0.22), 0.22, -60, 60, MARK)
    text(ax, 0.82, 0.47, "M_z > 0", MARK)
    frame(ax, np.array([-0.2, -0.18]), 0)


def stress(ax):
    panel(ax, "stress, local_buckling", "largest of the points, at both ends of each element",
          y=(-0.35, 0.8))
    t = np.linspace(0, 2 * np.pi, 17)
    shapes = [
        ((0.0, 0.25), 0.2 * np.column_stack((np.cos(t), np.sin(t)))),
        ((0.5, 0.25), np.array([[-0.15, -0.22], [0.15, -0.22], [0.15, 0.22], [-0.15, 0.22], [-0.15, -0.22]])),
        ((1.0, 0.25), np.array([[-0.16, -0.22], [0.16, -0.22], [0.16, -0.16], [0.03, -0.16], [0.03, 0.16], [0.16, 0.16],
                                [0.16, 0.22], [-0.16, 0.22], [-0.16, 0.16], [-0.03, 0.16], [-0.03, -0.16],
                                [-0.16, -0.16], [-0.16, -0.22]])),
    ]
    for centre, points in shapes:
        ax.fill(*(points + centre).T, fc="#dbe7f5", ec=NOW, lw=1.5)
        ax.plot(*(points + centre).T, ".", color=MARK, ms=6)
    ax.add_patch(plt.Circle((0.0, 0.25), 0.15, fc="white", ec=NOW, lw=1))
    ax.add_patch(plt.Rectangle((0.39, 0.07), 0.22, 0.36, fc="white", ec=NOW, lw=1))
    for centre, name in zip((0, 0.5, 1), ("tube", "box", "I")):
        text(ax, centre, -0.08, name)


def member(ax):
    panel(ax, "translation, axial_stress, buckling", "nodes and bars of a truss", y=(-0.35, 0.8))
    rest = np.array([[0, 0], [0.9, 0], [0.45, 0.5]])
    now = rest + [[0, 0], [0, 0], [0.12, -0.1]]
    for corners, colour, style in ((rest, REST, "--"), (now, NOW, "-")):
        ax.plot(*corners[[0, 2, 1]].T, color=colour, lw=2, ls=style)
    ax.plot(*now.T, "o", color=NOW, ms=5)
    ax.annotate("", now[2], rest[2], arrowprops={"arrowstyle": "-|>", "color": MARK, "lw": 1.6, "shrinkA": 0, "shrinkB": 0})
    text(ax, 0.5, 0.6, "x − x*", MARK)
    middle = 0.5 * (now[1] + now[2])
    d = (now[1] - now[2]) / np.linalg.norm(now[1] - now[2])
    arrow(ax, middle + 0.28 * d, middle + 0.05 * d, FORCE)
    arrow(ax, middle - 0.28 * d, middle - 0.05 * d, FORCE)
    text(ax, *(middle + [0.3, 0.1]), "N < 0:\ncompression", FORCE)
    pulled, along = 0.5 * (now[0] + now[2]), (now[2] - now[0]) / np.linalg.norm(now[2] - now[0])
    arrow(ax, pulled + 0.05 * along, pulled + 0.28 * along, FORCE)
    arrow(ax, pulled - 0.05 * along, pulled - 0.28 * along, FORCE)
    text(ax, 0.08, 0.4, "N > 0:\ntension", FORCE)


def main():
    figure, axes = plt.subplots(3, 3, figsize=(12, 8.2))
    parts = (position, rotation, displacement, deflection, elongation, joint, section_force, stress, member)
    for ax, draw in zip(axes.flat, parts):
        draw(ax)
    figure.subplots_adjust(left=0.01, right=0.99, top=0.96, bottom=0.01, wspace=0.02, hspace=0.12)
    folder = Path(__file__).resolve().parents[1] / "images"
    figure.savefig(folder / "responses.svg", metadata={"Date": None}, facecolor="white")


if __name__ == "__main__":
    main()
