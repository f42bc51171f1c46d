"""Stiffness of finite elements, from textbooks and by themselves: isoparametric solids and membranes (shape functions
by inverting the monomials at the nodes), straight beams with the stiffness of their axial force."""

import itertools

import numpy as np

# Monomials (powers of the reference coordinates) and nodes at which they are one or zero.
SQUARE = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
CUBE = [(*p, z) for z in (-1, 1) for p in SQUARE]
T3, T4 = [(0, 0), (1, 0), (0, 1)], [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]


def middles(corners, edges):
    return [tuple((a + b) / 2 for a, b in zip(corners[i], corners[j])) for i, j in edges]


RING3, RING4 = [(0, 1), (1, 2), (2, 0)], [(0, 1), (1, 2), (2, 3), (3, 0)]
UP4, TOP4 = [(i, i + 4) for i in range(4)], [(4 + i, 4 + (i + 1) % 4) for i in range(4)]


def powers(dim, keep):
    return [p for p in itertools.product(range(3), repeat=dim) if keep(p)]


def serendipity(p):
    """Of order 2, plus those that are linear in all but one: superlinear degree 2 at most."""
    return sum(q for q in p if q > 1) <= 2


KINDS = {  # name, nodes -> reference nodes in the order of Nastran, monomials
    ("CTRIA3", 3): (T3, powers(2, lambda p: sum(p) <= 1)),
    ("CTRIA6", 6): (T3 + middles(T3, RING3), powers(2, lambda p: sum(p) <= 2)),
    ("CQUAD4", 4): (SQUARE, powers(2, lambda p: max(p) <= 1)),
    ("CQUAD8", 8): (SQUARE + middles(SQUARE, RING4), powers(2, serendipity)),
    ("CTETRA", 4): (T4, powers(3, lambda p: sum(p) <= 1)),
    ("CTETRA", 10): (T4 + middles(T4, RING3 + [(0, 3), (1, 3), (2, 3)]), powers(3, lambda p: sum(p) <= 2)),
    ("CHEXA", 8): (CUBE, powers(3, lambda p: max(p) <= 1)),
    ("CHEXA", 20): (CUBE + middles(CUBE, RING4 + UP4 + TOP4), powers(3, serendipity)),
}


def gauss(simplex, dim, nodes, order):
    """Points and weights: of cubes Gauss's, of simplices one point, or those of degree 2 (Hammer & Stroud 1956)."""
    if simplex and nodes == dim + 1:
        yield np.full(dim, 1 / (dim + 1)), 1 / (2 if dim == 2 else 6)
    elif simplex:
        a = 1 / 6 if dim == 2 else (5 - np.sqrt(5)) / 20
        weight = (1 / 2 if dim == 2 else 1 / 6) / (dim + 1)
        yield np.full(dim, a), weight
        for c in range(dim):
            p = np.full(dim, a)
            p[c] = 1 - dim * a
            yield p, weight
    else:
        x, w = np.polynomial.legendre.leggauss(order)
        for index in itertools.product(range(order), repeat=dim):
            yield np.array([x[i] for i in index]), np.prod([w[i] for i in index])


def slopes(p, monomials):
    """Derivatives of the monomials at a point, (dim, monomials)."""
    out = np.zeros((len(p), len(monomials)))
    for c in range(len(p)):
        for m, power in enumerate(monomials):
            out[c, m] = power[c] * np.prod([x ** (q - (k == c)) if q - (k == c) >= 0 else 0 for k, (x, q) in enumerate(zip(p, power))])
    return out


def strain_matrix(dN):
    """(strains, dim * functions) of gradients dN (dim, functions); engineering shear."""
    dim, n = dN.shape
    rows = [(0, 0), (1, 1), (0, 1)] if dim == 2 else [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0)]
    B = np.zeros((len(rows), dim * n))
    for r, (a, b) in enumerate(rows):
        B[r, a::dim] += dN[b]
        if a != b:
            B[r, b::dim] += dN[a]
    return B


def law(E, nu, dim):
    """Plane stress, or space."""
    if dim == 2:
        return E / (1 - nu * nu) * np.array([[1, nu, 0], [nu, 1, 0], [0, 0, (1 - nu) / 2]])
    G, lame = E / (2 + 2 * nu), E * nu / ((1 + nu) * (1 - 2 * nu))
    D = np.zeros((6, 6))
    D[:3, :3] = lame
    return D + np.diag([2 * G] * 3 + [G] * 3)


def solid(name, x, E, nu, thickness=1.0):
    """Stiffness of a cell with its nodes x (nodes, dim). Bricks and quadrilaterals of order 1 have the incompatible
    modes 1 - xi^2 of Taylor, Beresford & Wilson (1976)."""
    reference, monomials = KINDS[name, len(x)]
    dim, simplex = x.shape[1], name in ("CTRIA3", "CTRIA6", "CTETRA")
    at_nodes = np.array([[np.prod([c ** q for c, q in zip(p, power)]) for power in monomials] for p in reference], float)
    shape = np.linalg.inv(at_nodes)  # (monomials, nodes)
    modes = (name, len(x)) in (("CQUAD4", 4), ("CHEXA", 8))
    J0 = slopes(np.zeros(dim), monomials) @ shape @ x
    D, n = law(E, nu, dim), dim * len(x)
    K = np.zeros((n + dim * dim * modes,) * 2)
    for p, weight in gauss(simplex, dim, len(x), 2 if modes else 3):
        dN = slopes(p, monomials) @ shape
        J = dN @ x
        det = np.linalg.det(J)
        if det <= 0:
            raise ValueError(f"{name}: an inverted cell")
        B = strain_matrix(np.linalg.solve(J, dN))
        if modes:
            dM = np.linalg.solve(J0, np.diag(-2 * p)) * (np.linalg.det(J0) / det)
            B = np.hstack([B, strain_matrix(dM)])
        K += weight * det * B.T @ D @ B
    if modes:
        K = K[:n, :n] - K[:n, n:] @ np.linalg.solve(K[n:, n:], K[n:, :n])
    return K * (thickness if dim == 2 else 1)


def section(kind, d):
    """Area, second moments of plane 1 (bending along y) and 2, torsion constant of PBARL. Its first dimension is along z."""
    if kind in ("ROD", "TUBE"):
        r, inner = d[0], d[1] if kind == "TUBE" else 0
        inertia = np.pi / 4 * (r ** 4 - inner ** 4)
        return np.pi * (r ** 2 - inner ** 2), inertia, inertia, 2 * inertia
    if kind == "BAR":
        z, y = d
        a, b = max(z, y), min(z, y)
        return z * y, z * y ** 3 / 12, y * z ** 3 / 12, a * b ** 3 * (1 / 3 - 0.21 * b / a * (1 - b ** 4 / (12 * a ** 4)))
    if kind == "BOX":
        z, y, across, along = d  # walls across y, then across z
        zi, yi = z - 2 * along, y - 2 * across
        mid = 2 * ((z - along) * (y - across)) ** 2 / ((z - along) / across + (y - across) / along)
        return z * y - zi * yi, (z * y ** 3 - zi * yi ** 3) / 12, (y * z ** 3 - yi * zi ** 3) / 12, mid
    if kind == "I":  # along y: height; widths of the flanges below and above, the web, their thicknesses
        height, below, above, web, t_below, t_above = d
        plates = [(below, t_below, t_below / 2), (above, t_above, height - t_above / 2),  # along z, along y, y of its middle
                  (web, height - t_below - t_above, (height + t_below - t_above) / 2)]
        area = sum(z * y for z, y, _ in plates)
        middle = sum(z * y * at for z, y, at in plates) / area
        return (area, sum(z * y ** 3 / 12 + z * y * (at - middle) ** 2 for z, y, at in plates),
                sum(y * z ** 3 / 12 for z, y, _ in plates), sum(max(z, y) * min(z, y) ** 3 / 3 for z, y, _ in plates))
    raise ValueError(f"PBARL {kind}")


def beam(length, E, nu, A, I1, I2, J, axial=0.0):
    """Bernoulli beam in its own axes, freedoms (u, rotation) of both ends, with the stiffness of its axial force N
    (Przemieniecki 1968)."""
    K = np.zeros((12, 12))
    L, G = length, E / (2 + 2 * nu)

    def add(freedoms, block):
        K[np.ix_(freedoms, freedoms)] += block

    pull = np.array([[1, -1], [-1, 1]])
    add([0, 6], E * A / L * pull)
    add([3, 9], G * J / L * pull)
    for (u, r), sign, inertia in (((1, 5), 1, I1), ((2, 4), -1, I2)):
        s = np.array([1, sign, 1, sign])
        bend = E * inertia / L ** 3 * np.array([[12, 6 * L, -12, 6 * L], [6 * L, 4 * L * L, -6 * L, 2 * L * L],
                                                [-12, -6 * L, 12, -6 * L], [6 * L, 2 * L * L, -6 * L, 4 * L * L]])
        string = axial / (30 * L) * np.array([[36, 3 * L, -36, 3 * L], [3 * L, 4 * L * L, -3 * L, -L * L],
                                              [-36, -3 * L, 36, -3 * L], [3 * L, -L * L, -3 * L, 4 * L * L]])
        add([u, r, u + 6, r + 6], (bend + string) * np.outer(s, s))
    return K
