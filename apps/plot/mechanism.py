"""The mechanism at a few instants, its bending made visible."""

import math

import matplotlib.pyplot as plt
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.lines import Line2D
from matplotlib.patches import Patch, PathPatch
from matplotlib.path import Path as Lines
from matplotlib.ticker import MaxNLocator
from mpl_toolkits.mplot3d.art3d import Line3DCollection, Poly3DCollection

from space import space_panels, whole_box
from style import BLUE, GREEN, ORANGE, PURPLE, label, scale_of
from tables import HalfResult, NothingToDraw, Table, table

MODE_COLUMNS = 3  # panels beside each other
INSTANTS = 5  # more hide each other
COLOURS = ("#9a9a9a", GREEN, ORANGE, PURPLE, BLUE)  # the last one on top
VISIBLE = 0.06  # largest bending that is shown, of the size of the mechanism
FILL = 0.35  # opacity of what bodies cover
THIN = 0.004  # thickness, of the size of the mechanism, below which a beam is drawn as a line
SIDES, TUBES = 8, 60  # of a beam in space: sides of its tube, pieces of it at most
SPACE_SIDE, MODE_SIDE = 7.5, 3.6  # inches: squares of axes in space
REST = "#8c8c8c"
LINK = (0, (6, 1.5))
IN_PLANE = 0.1  # bending out of a plane, of that in it, that a picture of the plane may leave out
FRAME_COLUMNS, PART_COLUMNS = 10, 9  # of frames.csv, part_lines.csv
ROUND = 1e-4  # difference of thicknesses, of the largest, of what is round


def read_frames(path):
    """[(time, {body: (kind, [(x, y, z, bending along x, y, z), ...])})] in order of time, and the abscissa's label."""
    frames = Table(path)
    check_version(path, frames, FRAME_COLUMNS)
    frames.check_numbers([frames.names[0], *frames.names[3:]])
    instants = {}
    for time, body, kind, node, *x in frames.rows:
        bodies = instants.setdefault(float(time), {})
        bodies.setdefault(body, (kind, {}))[1][int(node)] = tuple(map(float, x))
    check_whole(path, instants)
    ordered = [(t, {b: (kind, [nodes[k] for k in sorted(nodes)])
                    for b, (kind, nodes) in bodies.items()})
               for t, bodies in instants.items()]
    return ordered, label(frames.names[0], frames.units[0])


def check_version(path, found, columns):
    if len(found.names) != columns:
        raise NothingToDraw(f"{path} is of another version; run it again")


def check_whole(path, instants):
    """Every instant has the nodes of the first one, and no number is left out."""
    first = {body: set(nodes) for body, (_, nodes) in next(iter(instants.values()), {}).items()}
    for time, bodies in instants.items():
        if {body: set(nodes) for body, (_, nodes) in bodies.items()} != first:
            raise HalfResult(path, f"nodes are missing at {time:g}")
    for body, nodes in first.items():
        if nodes != set(range(len(nodes))):
            raise HalfResult(path, f"nodes of '{body}' are missing")


def read_sections(folder):
    """{body: [thickness seen along x, y, z of each element]}."""
    found = table(folder, "sections.csv")
    bodies = {}
    if found:
        found.check_numbers(found.names[2:])
    for body, _, *seen in found.rows if found else []:
        bodies.setdefault(body, []).append([float(x) for x in seen])
    return bodies


def read_part_lines(folder):
    """{(time, body): [line, ...]}, each a list of points (x, y, z, bending along x, y, z)."""
    path = folder / "part_lines.csv"
    found = table(folder, path.name)
    if found:
        check_version(path, found, PART_COLUMNS)
        found.check_numbers([found.names[0], *found.names[3:]])
    parts = {}
    for time, body, line, *x in found.rows if found else []:
        lines = parts.setdefault((float(time), body), {})
        lines.setdefault(line, []).append(tuple(map(float, x)))
    return {key: list(lines.values()) for key, lines in parts.items()}


def read_paths(folder):
    """{body: [(x, y, z), ...]} of bodies of one node."""
    found = table(folder, "rigid_paths.csv")
    if found:
        found.check_numbers(found.names[2:])
    paths = {}
    for _, body, *x in found.rows if found else []:
        paths.setdefault(body, []).append(tuple(map(float, x)))
    return paths


def enlarged(points, scale):
    """Points (x, y, z, bending along x, y, z) with the bending drawn larger."""
    return [tuple(x + (scale - 1) * b for x, b in zip(point[:3], point[3:])) + tuple(scale * b for b in point[3:]) for point in points]


def enlarge(instants, shapes, abscissa):
    """Instants and shapes with the bending drawn larger, and what a heading says of it; "" where all is as it is."""
    scale = bending_scale(instants, shapes.parts)
    if scale == 1:
        return instants, shapes, ""
    motion = abscissa.startswith("time")  # else bending is all of the displacement, and paths are of places without it
    drawn = [(t, {b: (kind, enlarged(nodes, scale)) for b, (kind, nodes) in bodies.items()}) for t, bodies in instants]
    parts = {key: [enlarged(line, scale) for line in lines] for key, lines in shapes.parts.items()}
    return drawn, Shapes(shapes.sections, parts, shapes.paths if motion else {}), f"{'bending' if motion else 'displacement'} × {scale:g}"


def read_shapes(folder, instants):
    """@param instants as of read_frames"""
    sections = read_sections(folder)
    nodes = {body: len(at) for _, bodies in instants[:1] for body, (_, at) in bodies.items()}
    for body, seen in sections.items():
        if len(seen) != nodes.get(body, 0) - 1:
            raise HalfResult(folder / "sections.csv", f"'{body}' has {len(seen)} elements and {nodes.get(body, 0)} nodes")
    return Shapes(sections, read_part_lines(folder), read_paths(folder))


def draw_mechanism(folder, pictures, summary):
    if not (folder / "frames.csv").exists():
        return
    instants, abscissa = read_frames(folder / "frames.csv")
    if not instants:
        return
    shapes = read_shapes(folder, instants)
    if abscissa.startswith("frequency"):
        draw_modes(pictures, instants, shapes, summary.get("frequencies_hz", []))
        return
    instants, shapes, larger = enlarge(instants, shapes, abscissa)
    axes = shown_axes(instants, shapes)
    shown = few(instants, peak_of(summary))
    heading = "mechanism" if len(shown) == 1 else f"mechanism: {len(shown)} instants"
    heading += larger and f", {larger}"
    if len(axes) == 3:
        drawn = everything(instants, shapes)
        figure, (ax,) = space_panels(1, 1, SPACE_SIDE, lambda ax: frame_axes(ax, axes, drawn))
        marks = mechanism(ax, instants, shown, axes, abscissa, shapes)
        frame_axes(ax, axes, drawn)
        beside = figure.legend(handles=marks, loc="upper left", bbox_to_anchor=(1.0, 0.94), borderaxespad=0)
        pictures.save(figure, "mechanism", heading, whole_box(figure, beside))
        return
    figure = plt.figure(figsize=(8.2, 5.6), layout="constrained")
    ax = figure.add_subplot()
    ax.set_anchor("N")  # below the heading; what stays free is cut off
    marks = mechanism(ax, instants, shown, axes, abscissa, shapes)
    ax.legend(handles=marks, loc="upper left", bbox_to_anchor=(1.02, 1.0), borderaxespad=0)
    pictures.save(figure, "mechanism", heading)


def everything(instants, shapes):
    """All points of bodies and of their lines."""
    points = [x for _, bodies in instants for _, nodes in bodies.values() for x in nodes]
    return points + [x[:3] for lines in shapes.parts.values() for line in lines for x in line]


def draw_modes(pictures, instants, shapes, frequencies):
    """Shapes of vibration, each in a panel of its own; all panels show the same box.
    @param instants the first one, of frequency 0, is the mechanism at rest
    @param frequencies of all modes, of which frames.csv has some"""
    axes, drawn = shown_axes(instants, shapes, modes=True), everything(instants, shapes)
    rest = instants[0] if instants[0][0] == 0 and 0 not in frequencies else None
    instants = instants[rest is not None:]
    if not instants:
        return
    titles = []
    for number, (frequency, _) in enumerate(instants, 1):
        number = frequencies.index(frequency) + 1 if frequency in frequencies else number
        titles.append(f"{number}: {frequency:.5g} Hz")

    def frame(ax):
        frame_axes(ax, axes, drawn)
        ax.tick_params(labelsize=7)
        for axis in (ax.xaxis, ax.yaxis, ax.zaxis) if len(axes) == 3 else ():
            axis.labelpad -= 6
            axis.label.set_fontsize(8)

    figure, panels = mode_panels(axes, titles, frame)
    for ax, instant in zip(panels, instants):
        marks = mechanism(ax, [instant], [instant], axes, "", shapes)[1:]  # it is named by its heading
        if rest:
            marks = draw_rest(ax, axes, rest, shapes) + marks
        frame(ax)
    below = figure.legend(handles=marks, loc="upper center", bbox_to_anchor=(0.5, 0), ncols=3)
    heading = "shape of vibration" if len(instants) == 1 else f"{len(instants)} shapes of vibration"
    pictures.save(figure, "mechanism", heading, whole_box(figure, below) if len(axes) == 3 else None)


def mode_panels(axes, titles, frame):
    """A figure with a panel a mode."""
    count, columns = len(titles), min(MODE_COLUMNS, len(titles))
    if len(axes) == 3:
        return space_panels(count, columns, MODE_SIDE, frame, titles)
    rows = -(-count // columns)
    figure, panels = plt.subplots(rows, columns, squeeze=False, layout="constrained", figsize=(3.4 * columns, 0.9 + 3 * rows))
    for ax in list(panels.flat)[count:]:
        ax.set_axis_off()
    for ax, title in zip(panels.flat, titles):
        ax.set_title(title, fontsize=10)
    return figure, list(panels.flat)


def draw_rest(ax, axes, rest, shapes):
    """Below a shape of vibration the mechanism at rest: axes of beams, lines of meshed parts. Marks for a legend."""
    time, bodies = rest
    for body, (_, nodes) in bodies.items():
        lines = shapes.parts.get((time, body)) or [nodes]
        for line in lines:
            ax.plot(*[[x[k] for x in line] for k in axes], color=REST, linewidth=0.7, zorder=1)
    return [Line2D([], [], color=REST, linewidth=0.7, label="at rest")]


def peak_of(summary):
    """Where the limit is reached that is violated most or has least to spare; without limits, where the first response is
    largest. None: it is not known."""
    limits = summary.get("constraints") or {}
    worst = max(limits.values(), key=lambda limit: limit.get("violation") or 0, default={})
    first = next(iter((summary.get("responses") or {}).values()), {})
    return (worst if limits else first).get("at_time")


def few(instants, peak=None):
    """Spread evenly, first and last among them, and the one nearest to the peak in place of its neighbour; as part_lines.csv
    has them (apps/output/picture_writer.cpp)."""
    times, last, gaps = [time for time, _ in instants], len(instants) - 1, INSTANTS - 1
    nearest = lambda at: min(range(last + 1), key=lambda n: abs(times[n] - at))  # noqa: E731
    if times == sorted(times):
        chosen = sorted({nearest(times[0] + (times[-1] - times[0]) * i / gaps) for i in range(INSTANTS)})
    else:
        chosen = sorted({(last * i + gaps // 2) // gaps for i in range(INSTANTS)})
    if peak is not None and len(chosen) > 2:
        at = nearest(peak)
        if at not in chosen:
            chosen[min(range(1, len(chosen) - 1), key=lambda i: abs(times[chosen[i]] - times[at]))] = at
    return [instants[n] for n in sorted(chosen)]


def shown_axes(instants, shapes, modes=False):
    """Two axes for what lies in a coordinate plane, or moves and bends in one; else all three."""
    spans = spans_of(everything(instants, shapes))
    if not modes and any(len(nodes) > 1 for _, bodies in instants for _, nodes in bodies.values()):
        nodes = [x for _, bodies in instants for _, nodes in bodies.values() for x in nodes]
        of_nodes = spans_of(nodes)
        bent = nodes + [x for lines in shapes.parts.values() for line in lines for x in line]
        bending = [max(abs(x[3 + k]) for x in bent) for k in range(3)]
        spans = [0 if of_nodes[k] <= 1e-6 * max(of_nodes) and bending[k] <= IN_PLANE * max(bending) else spans[k] for k in range(3)]
    least = min((2, 1, 0), key=lambda k: spans[k])  # of what hardly bends, two are small
    return [k for k in range(3) if k != least] if spans[least] <= 1e-6 * max(spans) else [0, 1, 2]


def spans_of(points):
    return [max(p[k] for p in points) - min(p[k] for p in points) for k in range(3)]


def bending_scale(instants, parts=None):
    """1, 2, 5, 10, ...: the largest that leaves all bending below VISIBLE of the mechanism."""
    points = [x for _, bodies in instants for _, nodes in bodies.values() for x in nodes]
    size = math.dist(*extremes(points))
    bent = points + [x for lines in (parts or {}).values() for line in lines for x in line]
    largest = max(math.hypot(*x[3:]) for x in bent)
    if largest <= 1e-9 * size:
        return 1
    room = VISIBLE * size / largest
    return max([1] + [m * 10 ** e for e in range(6) for m in (1, 2, 5) if m * 10 ** e <= room])


class Shapes:
    """What bodies look like: thickness of beams, lines of meshed parts; which of them were drawn."""

    def __init__(self, sections, parts, paths=None):
        self.sections, self.parts, self.paths, self.drawn = sections, parts, paths or {}, set()

    def draw(self, ax, axes, time, body, kind, nodes, colour, size, last):
        """A body at its displayed nodes. False: it has no shape, or one too thin to be seen.
        @param size of the mechanism  @param last of the instants: in space the others only shine through"""
        lines = self.parts.get((time, body))
        if lines and kind == "rigid":  # from its centre of mass to its joints
            for line in lines:
                ax.plot(*[[x[k] for x in line] for k in axes], color=colour, linewidth=2.6, solid_capstyle="round")
            ax.plot(*[[lines[0][0][k]] for k in axes], color=colour, marker="s", markersize=6)
            return True
        if lines and lines[0][0] != lines[0][-1]:  # no outline: edges of a part in space
            self.drawn.add("edges")
            options = dict(colors=colour, linewidths=0.9, alpha=1 if last else FILL)
            if len(axes) == 3:
                ax.add_collection3d(Line3DCollection([[x[:3] for x in line] for line in lines], **options))
            else:
                ax.add_collection(LineCollection([[[x[k] for k in axes] for x in line] for line in lines], **options))
            return True
        if lines:
            self.drawn.add("part")
            fill_lines(ax, axes, lines, colour)
            return True
        seen = self.sections.get(body, [])
        if not seen:
            return False
        if len(axes) == 3:
            return self.draw_tubes(ax, seen, nodes, colour, size, last)
        hidden = ({0, 1, 2} - set(axes)).pop()
        thickness = [element[hidden] for element in seen]
        if max(thickness) < THIN * size:
            return False
        self.drawn.add("beam")
        strips = [strip([nodes[e][k] for k in axes], [nodes[e + 1][k] for k in axes], t)
                  for e, t in enumerate(thickness)]
        ax.add_collection(PolyCollection([p for p in strips if p], facecolors=colour, alpha=FILL, linewidths=0))
        for side in (0, 1):  # its two faces, element by element: sections may change between them
            for p in filter(None, strips):
                ax.plot(*zip(*(p[:2] if side else p[2:])), color=colour, linewidth=0.9)
        return True

    def draw_tubes(self, ax, seen, nodes, colour, size, last):
        """A beam in space as round tubes of the mean of its two thicknesses: how it is turned about its axis is not in the
        tables. @param seen thickness along x, y, z of each element, of which the largest may stand for its own axis"""
        thickness = [(sum(t) - max(t)) / 2 for t in seen]
        if max(thickness) < THIN * size:
            return False
        self.drawn.add("beam" if all(max(t) - min(t) <= ROUND * max(t) for t in seen) else "tube")
        step = -(-len(seen) // TUBES)
        cuts = [*range(0, len(seen), step), len(seen)]
        sides = [side for a, b in zip(cuts, cuts[1:]) for side in tube(nodes[a], nodes[b], sum(thickness[a:b]) / (b - a))]
        ax.add_collection3d(Poly3DCollection(sides, facecolors=colour, edgecolors="none", alpha=1 if last else FILL))
        return True

    def marks(self):
        """For the legend."""
        kinds = {"beam": "beam, true thickness", "tube": "beam, mean thickness", "part": "meshed part, its outline"}
        if {"beam", "tube"} <= self.drawn:  # one mark: of what is round the mean is the true one
            del kinds["beam"]
        edges = [Line2D([], [], color="black", linewidth=0.9, label="meshed part, its edges")]
        links = [Line2D([], [], color="black", linewidth=1.2, linestyle=LINK, label="rod or cylinder, without mass")]
        return [Patch(facecolor="#00000059", edgecolor="black", linewidth=0.9, label=text)
                for kind, text in kinds.items() if kind in self.drawn] + edges * ("edges" in self.drawn) + links * ("links" in self.drawn)

    def draw_links(self, ax, axes, time, bodies, colour):
        """Joints that are bodies without mass: lines that belong to no body. @param bodies of the mechanism"""
        for (at, name), lines in self.parts.items():
            if at == time and name not in bodies:
                self.drawn.add("links")
                for line in lines:
                    ax.plot(*[[x[k] for x in line] for k in axes], color=colour, linewidth=1.2, linestyle=LINK)


def strip(a, b, thickness):
    """Four corners about the line from a to b; None if it has no length."""
    length = math.dist(a, b)
    if length == 0:
        return None
    n = [-(b[1] - a[1]) * thickness / 2 / length, (b[0] - a[0]) * thickness / 2 / length]
    return [(a[0] + n[0], a[1] + n[1]), (b[0] + n[0], b[1] + n[1]), (b[0] - n[0], b[1] - n[1]), (a[0] - n[0], a[1] - n[1])]


def tube(a, b, thickness):
    """Sides of a prism about the line from a to b, four corners each; none if it has no length."""
    way = [q - p for p, q in zip(a, b)]
    length = math.hypot(*way)
    if length == 0:
        return []
    least = min(range(3), key=lambda k: abs(way[k]))
    u = cross(way, [float(k == least) for k in range(3)])
    u = [x / math.hypot(*u) for x in u]
    v = [x / length for x in cross(way, u)]
    around = [(math.cos(2 * math.pi * i / SIDES), math.sin(2 * math.pi * i / SIDES)) for i in range(SIDES + 1)]
    ring = [[thickness / 2 * (c * p + s * q) for p, q in zip(u, v)] for c, s in around]
    at = lambda x, r: tuple(p + q for p, q in zip(x, r))  # noqa: E731
    return [[at(a, r), at(a, t), at(b, t), at(b, r)] for r, t in zip(ring, ring[1:])]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def fill_lines(ax, axes, lines, colour):
    """A planar part; holes run the other way round."""
    points, codes = [], []
    for line in lines:
        points += [[x[k] for k in axes] for x in line]
        codes += [Lines.MOVETO] + [Lines.LINETO] * (len(line) - 1)
    ax.add_patch(PathPatch(Lines(points, codes), facecolor=colour, alpha=FILL, linewidth=0))
    for line in lines:
        ax.plot(*[[x[k] for x in line] for k in axes], color=colour, linewidth=0.9)


def mechanism(ax, instants, shown, axes, abscissa, shapes):
    """Bodies at the instants that are shown; rigid bodies with their paths. Marks for a legend."""
    columns = lambda nodes: [[x[k] for x in nodes] for k in axes]  # noqa: E731
    marks, drawn = [], []
    for body, (_, nodes) in instants[0][1].items():
        if len(nodes) == 1 and len(instants) > 2:
            path = shapes.paths.get(body) or [bodies[body][1][0] for _, bodies in instants if body in bodies]
            ax.plot(*columns(path), color="#b8b8b8", linewidth=0.8, zorder=1)
            drawn += path
            marks = [Line2D([], [], color="#b8b8b8", linewidth=0.8, label="paths of rigid bodies")]
    size = math.dist(*extremes([x for _, bodies in instants for _, nodes in bodies.values() for x in nodes]))
    drawn += [x for (time, _), lines in shapes.parts.items() for line in lines for x in line]
    lines_of_beams = False
    for (time, bodies), colour in zip(shown, COLOURS[-len(shown):]):
        for body, (kind, nodes) in bodies.items():
            at = [x[:3] for x in nodes]
            drawn += at
            shaped = shapes.draw(ax, axes, time, body, kind, at, colour, size, last=time == shown[-1][0])
            lines_of_beams = lines_of_beams or not shaped and len(nodes) > 1
            if not shaped:
                ax.plot(*columns(at), color=colour, linewidth=2.6, solid_capstyle="round",
                        marker="s" if len(nodes) == 1 else None, markersize=6)
            if len(nodes) > 1:  # where joints are
                ax.plot(*columns([at[0], at[-1]]), color=colour, linestyle="none",
                        marker="o", markersize=4, markerfacecolor="white")
        shapes.draw_links(ax, axes, time, bodies, colour)
        name, unit = abscissa.rstrip("]").partition(" [")[::2]
        marks.append(Line2D([], [], color=colour, linewidth=2.6,
                            label=f"{'t' if name == 'time' else name} = {time:.4g} "
                                  f"{'' if unit == '-' else unit}".strip()))
    marks += shapes.marks()
    if lines_of_beams:
        marks.append(Line2D([], [], color="black", linewidth=2.6, label="beam, its axis"))
    if any(len(nodes) > 1 for _, nodes in shown[-1][1].values()):
        marks.append(Line2D([], [], color="black", linestyle="none", marker="o", markersize=4,
                            markerfacecolor="white", label="ends of a body"))
    if any(kind == "rigid" for kind, _ in shown[-1][1].values()):
        marks.append(Line2D([], [], color="black", linestyle="none", marker="s", markersize=6,
                            label="rigid body"))
    frame_axes(ax, axes, drawn)
    return marks


def extremes(points):
    """Corners of the box about points."""
    return [[pick(p[k] for p in points) for k in range(3)] for pick in (min, max)]


def frame_axes(ax, axes, points):
    """Labels in a unit that needs no power of ten beside the axes, and the same scale in all directions."""
    low, high = extremes(points)
    factor, unit = scale_of([x for corner in (low, high) for x in (corner[k] for k in axes)], "m")
    for k, name in zip(axes, "xyz"):
        getattr(ax, f"set_{name}label")(f"{'xyz'[k]} [{unit}]")
        getattr(ax, f"{name}axis").set_major_formatter(lambda v, _: f"{v * factor:g}".replace("-", "−"))
    if len(axes) == 2:
        frame_plane(ax, [low[k] for k in axes], [high[k] for k in axes])
        return
    spans = [max(b - a, 1e-9) for a, b in zip(low, high)]
    box = [max(span, 0.2 * max(spans)) for span in spans]
    for k, name in enumerate("xyz"):
        middle, axis = (low[k] + high[k]) / 2, getattr(ax, f"{name}axis")
        getattr(ax, f"set_{name}lim")(middle - 0.52 * box[k], middle + 0.52 * box[k])
        axis.set_major_locator(MaxNLocator(5 if box[k] > 0.4 * max(box) else 3))
        axis.labelpad = 12 + 10 * (max(box) / max(box[:k] + box[k + 1:]) - 1)  # away along the others, which may be short
    ax.set_box_aspect(box, zoom=0.9)


def frame_plane(ax, low, high):
    size = [max(b - a, 0.4 * max(h - l for l, h in zip(low, high)), 1e-9) for a, b in zip(low, high)]
    for set_limits, a, b, span in zip((ax.set_xlim, ax.set_ylim), low, high, size):
        set_limits((a + b - 1.12 * span) / 2, (a + b + 1.12 * span) / 2)
    ax.set_aspect("equal", adjustable="box")
