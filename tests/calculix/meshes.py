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
    """Text of a bar of 0.2 x 0.04 (x 0.04) m, some of its inner nodes moved, edges of order 2 bent."""
    space = element.startswith("C3D")

    def place(at, x, y, z):
        return 0.2 * x + (1e-3 * math.sin(7 * at) if 0 < x < 1 else 0), 0.04 * y, 0.04 * z

    def bent(at, x):
        inside = 0.001 < x[0] < 0.199 and 0.001 < x[1] < 0.039
        return x[0], x[1] + (2e-4 * math.sin(5 * at) if inside else 0), x[2]

    return mesh(element, (8, 2, 2) if space else (10, 3, 0), place, bent)


def cooks_membrane(element, counts, thickness):
    """Text of Cook's membrane (J. Struct. Div. ASCE 100 (1974)), 48 wide, 44 high where it is held, 16 where it is
    pulled."""
    return mesh(element, counts, lambda _, x, y, z: (48 * x, 44 * x + y * (44 - 28 * x), thickness * z))


def mesh(element, counts, place, bent=lambda _, x: x):
    """Text of a block in cells of a kind, with the node sets "left", "middle" and "right" across its length.

    @param place  of corners by their number and their coordinates in [0, 1]
    @param bent   of nodes at edges by their number and the middle of the edge
    """
    space, order = element.startswith("C3D"), 2 if element[3:] in ("10", "20", "6", "8") else 1
    planes = {"left": 0, "middle": counts[0] // 2, "right": counts[0]}
    number, nodes, sets = {}, {}, {name: [] for name in planes}
    for i in range(counts[0] + 1):
        for j in range(counts[1] + 1):
            for k in range(counts[2] + 1):
                at = number[i, j, k] = len(nodes) + 1
                nodes[at] = place(at, i / counts[0], j / counts[1], k / max(counts[2], 1))
                for name, plane in planes.items():
                    if i == plane:
                        sets[name].append(at)
    bottom = [(0, 0), (1, 0), (1, 1), (0, 1)]
    cells = []
    for i in range(counts[0]):
        for j in range(counts[1]):
            for k in range(max(counts[2], 1)):
                corners = [number[i + a, j + b, k + c] for c in ((0, 1) if space else (0,)) for a, b in bottom]
                pieces = {"C3D4": TETRAHEDRA, "C3D10": TETRAHEDRA, "CPS3": TRIANGLES, "CPS6": TRIANGLES}.get(element)
                cells += [[corners[n] for n in piece] for piece in pieces] if pieces else [corners]
    middle = {}
    for cell in cells if order == 2 else []:
        edges = TETRAHEDRON_EDGES if element == "C3D10" else EDGES[len(cell)]
        for a, b in [(cell[a], cell[b]) for a, b in edges]:
            key = min(a, b), max(a, b)
            if key not in middle:
                at = middle[key] = len(nodes) + 1
                nodes[at] = bent(at, [(p + q) / 2 for p, q in zip(nodes[a], nodes[b])])
                for members in sets.values():
                    if a in members and b in members:
                        members.append(at)
            cell.append(middle[key])
    lines = ["*NODE"] + [f"{n}, {x:.12e}, {y:.12e}, {z:.12e}" for n, (x, y, z) in nodes.items()]
    lines.append(f"*ELEMENT, TYPE={element}")
    for e, cell in enumerate(cells):
        fields = [str(n) for n in [e + 1, *cell]]
        lines += [", ".join(fields)] if len(fields) <= 16 else [", ".join(fields[:15]) + ",", ", ".join(fields[15:])]
    for name, members in sets.items():
        lines += [f"*NSET, NSET={name}"] + [f"{n}," for n in members]
    return "\n".join(lines) + "\n"
