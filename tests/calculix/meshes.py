"""A bar as a scene, and its meshes of every kind of cell as `.inp` files."""

import math

BAR = """name = "bar"
[materials]
steel = { E = 210e9, nu = 0.3, rho = 7850 }
[bodies.bar.solid]
mesh = { from = [0, 0, 0], to = [0.2, 0.04, 0.04], cells = [20, 4, 4] }
material = "steel"
modes = 0
interfaces = { root = { set = "x_min" }, tip = { set = "x_max" } }
[joints]
clamp = { fixed = ["ground", "bar.root"] }
[loads]
pull = { at = "bar.tip", force = [1e3, 1e3, 0] }
[simulation]
duration = 1e-5
step = 1e-5
"""

# Corners of a quadrilateral or hexahedron -> its triangles or tetrahedra; edges in the order of Abaqus.
TRIANGLES = [(0, 1, 2), (0, 2, 3)]
TETRAHEDRA = [(0, 1, 2, 6), (0, 2, 3, 6), (0, 3, 7, 6), (0, 7, 4, 6), (0, 4, 5, 6), (0, 5, 1, 6)]
EDGES = {3: [(0, 1), (1, 2), (2, 0)], 4: [(0, 1), (1, 2), (2, 3), (3, 0)],
         8: [(i, (i + 1) % 4) for i in range(4)] + [(4 + i, 4 + (i + 1) % 4) for i in range(4)]
         + [(i, i + 4) for i in range(4)]}
TETRAHEDRON_EDGES = [(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)]
ELEMENTS = ("C3D4", "C3D10", "C3D20", "CPS3", "CPS6", "CPS8")


def bar_mesh(element):
    """Text of a bar of 0.2 x 0.04 (x 0.04) m, some of its inner nodes moved, edges of order 2 bent, with the node sets
    of its ends."""
    space, order = element.startswith("C3D"), 2 if element[3:] in ("10", "20", "6", "8") else 1
    counts = (8, 2, 2) if space else (10, 3, 0)
    number, nodes = {}, {}
    for i in range(counts[0] + 1):
        for j in range(counts[1] + 1):
            for k in range(counts[2] + 1):
                at = number[i, j, k] = len(nodes) + 1
                shift = 1e-3 * math.sin(7 * at) if 0 < i < counts[0] else 0
                nodes[at] = (0.2 * i / counts[0] + shift, 0.04 * j / counts[1], 0.02 * k)
    bottom = [(0, 0), (1, 0), (1, 1), (0, 1)]
    cells = []
    for i in range(counts[0]):
        for j in range(counts[1]):
            for k in range(max(counts[2], 1)):
                corners = [number[i + a, j + b, k + c] for c in ((0, 1) if space else (0,)) for a, b in bottom]
                pieces = {"C3D4": TETRAHEDRA, "C3D10": TETRAHEDRA, "CPS3": TRIANGLES, "CPS6": TRIANGLES}.get(element)
                cells += [[corners[n] for n in piece] for piece in pieces] if pieces else [corners]
    ends = {"left": [n for n, x in nodes.items() if x[0] == 0], "right": [n for n, x in nodes.items() if x[0] == 0.2]}
    middle = {}
    for cell in cells if order == 2 else []:
        edges = TETRAHEDRON_EDGES if element == "C3D10" else EDGES[len(cell)]
        for a, b in [(cell[a], cell[b]) for a, b in edges]:
            key = min(a, b), max(a, b)
            if key not in middle:
                at = middle[key] = len(nodes) + 1
                x = [(p + q) / 2 for p, q in zip(nodes[a], nodes[b])]
                inside = 0.001 < x[0] < 0.199 and 0.001 < x[1] < 0.039
                nodes[at] = (x[0], x[1] + (2e-4 * math.sin(5 * at) if inside else 0), x[2])
                for end in ends.values():
                    if a in end and b in end:
                        end.append(at)
            cell.append(middle[key])
    lines = ["*NODE"] + [f"{n}, {x:.12e}, {y:.12e}, {z:.12e}" for n, (x, y, z) in nodes.items()]
    lines.append(f"*ELEMENT, TYPE={element}")
    for e, cell in enumerate(cells):
        fields = [str(n) for n in [e + 1, *cell]]
        lines += [", ".join(fields)] if len(fields) <= 16 else [", ".join(fields[:15]) + ",", ", ".join(fields[15:])]
    for name, members in ends.items():
        lines += [f"*NSET, NSET={name}"] + [f"{n}," for n in members]
    return "\n".join(lines) + "\n"
