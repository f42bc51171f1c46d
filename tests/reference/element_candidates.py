#!/usr/bin/env python3
"""Candidates of a geometrically exact beam element of fourth order, compared on static cases.

Frames H in SE(3), body strain eps = (H^-1 H')^vee, translation first. The energy of a candidate depends on
the relative motions of its nodes, y_i = log(H_base^-1 H_i) (d of two nodes), perhaps on internal 6-vectors z:

  0    constant strain d/L, two nodes (Sonneville, Cardona, Bruls, CMAME 268, 2014)
  a    strain linear in s, condensed in mixed form, section force n: V = n.(d - d0) - (L/2) n.F(d) n,
       F = K^-1 + ad(d) K^-1 ad(d)^T/12, where a_0 = d/L in terms of higher order; for axes that are
       helices (arcs, straight lines) at rest
  a'   the same strain, slope z/L^2 as internal unknown: d = L a_0 + ad(L a_0) z/12, the expansion of Magnus
       to fourth order (Iserles, Norsett 1999); a' 6 to sixth order
  b    three nodes, H = H_M exp(sum N_i log(H_M^-1 H_i)), Gauss quadrature with 2 or 3 points
       (Sonneville, Bruls, Bauchau, IJNME 112, 2017)
  b*   three nodes, implicit interpolation sum N_i log(H^-1 H_i) = 0, 2 points
  c    two nodes, H = H_A exp(s d + s(s - 1) z), s in [0, 1], 2 or 3 points

Derivatives of strains are by complex step, the geometric stiffness n.d2eps by central differences of it.
References: shooting on Cosserat's equations, which knows nothing of elements.
"""
import math
from collections import Counter, namedtuple

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq, root
from scipy.special import ellipe, ellipeinc, ellipk, ellipkinc

calls = Counter()
MESHES = (1, 2, 4, 8, 16, 32)
GAUSS = {1: [(0.5, 1.0)],
         2: [(0.5 - 0.5 / math.sqrt(3), 0.5), (0.5 + 0.5 / math.sqrt(3), 0.5)],
         3: [(0.5 - math.sqrt(0.15), 5 / 18), (0.5, 8 / 18), (0.5 + math.sqrt(0.15), 5 / 18)]}


# ---- SE(3), over leading axes, analytic so that complex steps pass through ----

def mv(A, v):
    """Matrix times vector."""
    return (A @ v[..., None])[..., 0]


def tr(A):
    """Transpose without conjugation."""
    return np.swapaxes(A, -1, -2)


def solve(A, v):
    """A^-1 v."""
    calls["solve"] += 1
    return np.linalg.solve(A, v[..., None])[..., 0]


def hat(w):
    """Matrix of the cross product by w."""
    x, y, z = w[..., 0], w[..., 1], w[..., 2]
    o = np.zeros_like(x)
    return np.stack([o, -z, y, z, o, -x, -y, x, o], -1).reshape(w.shape[:-1] + (3, 3))


def ad(x):
    """ad(x) y = [x, y], x = (u, w)."""
    calls["ad"] += 1
    a = np.zeros(x.shape + (6,), x.dtype)
    a[..., :3, :3] = a[..., 3:, 3:] = hat(x[..., 3:])
    a[..., :3, 3:] = hat(x[..., :3])
    return a


def stumpff(w):
    """x = w.w and c_k(x) = sum_j (-x)^j/(2j + k)!, k = 0..6, by c_k = 1/k! - x c_{k+2}."""
    x = (w * w).sum(-1)[..., None, None]
    c = [0, 0, 0, 0, 0] + [sum((-x) ** j / float(math.factorial(2 * j + k)) for j in range(18)) for k in (5, 6)]
    for k in range(4, -1, -1):
        c[k] = 1 / math.factorial(k) - x * c[k + 2]
    return x, c, lambda k: (k * c[k + 2] - c[k + 1]) / 2  # the last: dc_k/dx


def exp(x):
    """exp of (u, w): rotation I + c1 W + c2 W^2, translation (I + c2 W + c3 W^2) u, W = hat(w)."""
    calls["exp"] += 1
    W, (_, c, _) = hat(x[..., 3:]), stumpff(x[..., 3:])
    H = np.zeros(x.shape[:-1] + (4, 4), x.dtype)
    H[..., :3, :3] = np.eye(3) + c[1] * W + c[2] * W @ W
    H[..., :3, 3] = mv(np.eye(3) + c[2] * W + c[3] * W @ W, x[..., :3])
    H[..., 3, 3] = 1
    return H


def log(H):
    """Inverse of exp, angle < pi: w = arctan(t)/t vee/q^2, t = tan(angle/2), 4 q^2 = 1 + tr R."""
    calls["log"] += 1
    S = H[..., :3, :3] - tr(H[..., :3, :3])
    vee = 0.5 * np.stack([S[..., 2, 1], S[..., 0, 2], S[..., 1, 0]], -1)
    q2 = (1 + np.trace(H[..., :3, :3], axis1=-2, axis2=-1))[..., None] / 4
    t2 = (vee * vee).sum(-1)[..., None] / (4 * q2 * q2)
    small = abs(t2) < 1e-3
    t = np.sqrt(np.where(small, 1, t2))
    w = np.where(small, 1 - t2 * (1 / 3 - t2 * (1 / 5 - t2 * (1 / 7 - t2 / 9))), np.arctan(t) / t) * vee / q2
    W, (_, c, _) = hat(w), stumpff(w)
    h = (c[3] - 2 * c[4]) / (2 * c[2])
    return np.concatenate([mv(np.eye(3) - W / 2 + h * W @ W, H[..., :3, 3]), w], -1)


def T(x, v):
    """T(x) v, exp(x)^-1 d exp(x) = T(x) dx: sum_k (-ad)^k/(k + 1)!, by ad^5 = -2 w.w ad^3 - (w.w)^2 ad."""
    calls["T"] += 1
    a, (z, c, slope) = ad(x), stumpff(x[..., 3:])
    out, power = v, v
    for factor in (-c[2] + z * slope(2), c[3] - z * slope(3), slope(2), -slope(3)):
        power = mv(a, power)
        out = out + factor[..., 0] * power
    return out


def Tinv(x):
    """T(x)^-1 = I + ad/2 + (h - z h') ad^2 - h' ad^4, h(z) = (1 - sqrt(z)/2 cot(sqrt(z)/2))/z, z = w.w."""
    calls["Tinv"] += 1
    a, (z, c, slope) = ad(x), stumpff(x[..., 3:])
    h = (c[3] - 2 * c[4]) / (2 * c[2])
    dh = ((slope(3) - 2 * slope(4)) / 2 - h * slope(2)) / c[2]
    a2 = a @ a
    return np.eye(6) + a / 2 + (h - z * dh) * a2 - dh * a2 @ a2


def check_group(x=np.array([0.3, -0.8, 0.5, 0.9, 0.4, -1.1]), v=np.array([0.2, 0.7, -0.4, 0.3, -0.6, 0.1])):
    """log exp = 1, T^-1 T = 1, and T v against a complex step of exp."""
    D = (np.linalg.inv(exp(x)) @ exp(x + 1e-30j * v)).imag * 1e30
    differences = log(exp(x)) - x, Tinv(x) @ T(x, v) - v, T(x, v) - [*D[:3, 3], D[2, 1], D[0, 2], D[1, 0]]
    assert np.abs(differences).max() < 1e-13


# ---- candidates: L times the strain at s in [0, 1], of q = [y_1, .., z] ----

def constant_strain(q, s):
    """d."""
    return q[..., 0, :]


def linear_strain(q, s):
    """L a_0 + (s - 1/2) z with d = (I - ad(z)/12) L a_0."""
    d, z = q[..., 0, :], q[..., 1, :]
    return solve(np.eye(6) - ad(z) / 12, d) + (s - 0.5) * z


def linear_strain_6(q, s, iterations=9):
    """The same with d = m + [m, z]/12 - [z, [m, z]]/240 - [m, [m, [m, z]]]/720, m = L a_0, by fixed point."""
    d, z = q[..., 0, :], q[..., 1, :]
    m = d
    for _ in range(iterations):
        a, b = ad(m), mv(ad(m), z)
        m = d - b / 12 + mv(ad(z), b) / 240 + mv(a, mv(a, b)) / 720
    return m + (s - 0.5) * z


def quadratic_motion(q, s):
    """T(psi) psi', psi = s d + s(s - 1) z."""
    d, z = q[..., 0, :], q[..., 1, :]
    return T(s * d + s * (s - 1) * z, d + (2 * s - 1) * z)


def shape(s):
    """N_A, N_M, N_B of Lagrange and their derivatives by s."""
    x = 2 * s - 1
    return (x * (x - 1) / 2, 1 - x * x, x * (x + 1) / 2), (2 * x - 1, -4 * x, 2 * x + 1)


def about_middle(q, s):
    """T(psi) psi', psi = N_A y_A + N_B y_B."""
    N, dN = shape(s)
    return T(N[0] * q[..., 0, :] + N[2] * q[..., 1, :], dN[0] * q[..., 0, :] + dN[2] * q[..., 1, :])


def implicit_motion(q, s, iterations=4):
    """J^-1 sum N_i' l_i, J = sum N_i T^-1(-l_i), l_i = log(X^-1 exp(y_i)), sum N_i l_i = 0 by Newton's method."""
    N, dN = shape(s)
    X = exp(N[0] * q[..., 0, :] + N[2] * q[..., 1, :])
    nodes = [exp(q[..., 0, :]), np.broadcast_to(np.eye(4), X.shape), exp(q[..., 1, :])]
    for i in range(iterations + 1):
        l = [log(np.linalg.inv(X) @ E) for E in nodes]
        J = sum(n * Tinv(-x) for n, x in zip(N, l))
        r = solve(J, sum(n * x for n, x in zip(dN if i == iterations else N, l)))
        X = X @ exp(r) if i < iterations else X
    return r


Candidate = namedtuple("Candidate", "name nodes internal points strain")  # nodes: base first
CANDIDATES = [Candidate("0", (0, 1), 0, 1, constant_strain),
              Candidate("a", (0, 1), 1, 0, None),
              Candidate("a'", (0, 1), 1, 2, linear_strain),
              Candidate("a' 6", (0, 1), 1, 2, linear_strain_6),
              Candidate("b, 2 points", (1, 0, 2), 0, 2, about_middle),
              Candidate("b, 3 points", (1, 0, 2), 0, 3, about_middle),
              Candidate("b*, 2 points", (1, 0, 2), 0, 2, implicit_motion),
              Candidate("c, 2 points", (0, 1), 1, 2, quadratic_motion),
              Candidate("c, 3 points", (0, 1), 1, 3, quadratic_motion)]


def mixed_gradient(q, d0, L, K):
    """dV/dd = n + (L/12) ad(K^-1 ad(d)^T n)^T n and dV/dn = d - d0 - L F(d) n of candidate a, q = [d, n]."""
    a, n = ad(q[..., 0, :]), q[..., 1, :]
    slope = mv(tr(a), n) / K
    strain = n / K + mv(a, slope) / 12
    return np.concatenate([n + L / 12 * mv(tr(ad(slope)), n), q[..., 0, :] - d0 - L * strain], -1)


def directions(q, size):
    """q shifted by `size` along each of its components: an axis more, before the last two."""
    k = q.shape[-2] * 6
    return q[..., None, :, :] + size * np.eye(k).reshape(k, -1, 6)


def gradient(c, q, s):
    """d(L eps)/dq [.., 6, k], by complex step."""
    return tr(c.strain(directions(q, 1e-30j), s).imag * 1e30)


def energy(c, q, q0, L, K):
    """Elastic energy of each element, at stationary z."""
    if c.strain is None:
        return 0.5 * ((q - q0)[..., 0, :] * q[..., 1, :]).sum(-1)
    return sum(w * 0.5 / L * (K * (c.strain(q, s) - c.strain(q0, s)) ** 2).sum(-1) for s, w in GAUSS[c.points])


def derivatives(c, q, q0, L, K, stress=None, h=1e-5):
    """Gradient g of the energy by q; its part by y and its Hessian, both about the stress at the Gauss points
    if given; and the points' [K eps, B]. With stress = K eps the Hessian is exact."""
    k = 6 * (len(c.nodes) - 1)
    if c.strain is None:
        g = mixed_gradient(q, q0[:, 0], L, K)
        return g, g[:, :k], tr(mixed_gradient(directions(q, 1e-30j), q0[:, :1], L, K).imag * 1e30), []
    points = [(K * (c.strain(q, s) - c.strain(q0, s)) / L, gradient(c, q, s)) for s, _ in GAUSS[c.points]]
    g, about, H = 0, 0, 0
    for i, ((s, w), (n, B)) in enumerate(zip(GAUSS[c.points], points)):
        n_about = n if stress is None else stress[i]
        dB = (gradient(c, directions(q, h), s) - gradient(c, directions(q, -h), s)) / (2 * h)
        g = g + w * mv(tr(B), n)
        about = about + w * mv(tr(B), n_about)
        H = H + w * (tr(B) @ (K[:, None] * B) / L + np.einsum("ejak,ea->ekj", dB, n_about))
    return g, about[:, :k], H, points


def transfer(y):
    """P of dy = P [dh_base; dh_1; ..]: dy_i = T^-1(y_i) dh_i - T^-1(-y_i) dh_base."""
    m = y.shape[-2]
    P, Ti, a = np.zeros(y.shape[:-2] + (6 * m, 6 * m + 6), y.dtype), Tinv(y), ad(y)
    for i in range(m):
        rows = slice(6 * i, 6 * i + 6)
        P[..., rows, 6 * i + 6:6 * i + 12] = Ti[..., i, :, :]
        P[..., rows, :6] = (a - Ti)[..., i, :, :]
    return P


def relative(c, H, z=None):
    """Nodes of the elements and q = [y_i = log(H_base^-1 H_i), z], z = 0 by default."""
    per = len(c.nodes) - 1
    nodes = np.arange(0, len(H) - 1, per)[:, None] + np.array(c.nodes)
    y = log(np.linalg.inv(H[nodes[:, :1]]) @ H[nodes[:, 1:]])
    return nodes, np.concatenate([y, np.zeros((len(y), c.internal, 6)) if z is None else z], 1)


def element(c, q, q0, L, K, stress=None):
    """Forces and tangent in local frames with z condensed, and dq(dh) = u + U dh; points as above."""
    k = 6 * (len(c.nodes) - 1)
    g, about, H, points = derivatives(c, q, q0, L, K, stress)
    P = transfer(q[:, :k // 6])
    r = np.linalg.solve(H[:, k:, k:], np.concatenate([g[:, k:, None], H[:, k:, :k] @ P], 2))
    u = np.concatenate([np.zeros((len(q), k)), -r[..., 0]], 1)
    U = np.concatenate([P, -r[..., 1:]], 1)
    turned = tr(mv(tr(transfer(directions(q[:, :k // 6], 1e-30j))), about[:, None, :]).imag * 1e30)
    return mv(tr(P), g[:, :k] + mv(H[:, :k], u)), tr(P) @ H[:, :k] @ U + turned @ P, u, U, points


# ---- cases and their reference solutions ----

class Case:
    """Cantilever of length L, section stiffness K, curvature k0 at rest; dead tip force P, moment M about z."""

    def __init__(self, name, L, K, k0, P, M=0.0):
        self.name, self.L, self.K, self.P, self.M = name, L, np.array(K, float), np.array(P, float), M
        self.e0 = np.array([1, 0, 0, *k0], float)
        self.rest = {n: exp(np.linspace(0, L, n + 1)[:, None] * self.e0) for n in MESHES}
        self.angle = L * (abs(M) / self.K[5] + np.linalg.norm(k0))  # by M and at rest
        self.refer()

    def shoot(self, tip, factor, tolerance, at=None):
        """x' = R gamma, R' = R hat(kappa) from the clamp, moment (x_tip - x) x P + M, for a guess of x_tip."""
        P, M = factor * self.P, np.array([0, 0, factor * self.M])

        def rate(s, state):
            R = state[3:].reshape(3, 3)
            n = np.concatenate([R.T @ P, R.T @ (np.cross(tip - state[:3], P) + M)])
            strain = self.e0 + n / self.K
            return np.concatenate([R @ strain[:3], (R @ hat(strain[3:])).ravel()])
        return solve_ivp(rate, (0, self.L), np.concatenate([np.zeros(3), np.eye(3).ravel()]), "DOP853", at,
                         rtol=tolerance, atol=tolerance / 10).y

    def refer(self):
        """Tip by shooting with the load in steps, its error from two tolerances, frames for first guesses."""
        tip = start = self.rest[1][1, :3, 3]
        for factor, tolerance in [(f, 1e-7) for f in np.linspace(0.1, 1, 10)] + [(1, 1e-12), (1, 1e-13)]:
            previous = tip
            tip = root(lambda x: self.shoot(x, factor, tolerance)[:3, -1] - x, tip, tol=tolerance).x
        self.tip, self.size = tip, np.linalg.norm(tip - start)
        self.uncertainty, self.guess = np.linalg.norm(tip - previous) / self.size, {}
        for n in MESHES:
            y = self.shoot(tip, 1, 1e-9, np.linspace(0, self.L, n + 1)).T
            U, _, V = np.linalg.svd(y[:, 3:].reshape(-1, 3, 3))
            self.guess[n] = H = np.tile(np.eye(4), (n + 1, 1, 1))
            H[:, :3, :3], H[:, :3, 3] = U @ V, y[:, :3]

    def error(self, H):
        """Of the tip's position, by the tip's displacement."""
        return np.linalg.norm(H[-1, :3, 3] - self.tip) / self.size


def rectangle(E, b, h, k, J):
    """[EA, k GA, k GA, GJ, EI_y, EI_z] of a section b (along z) by h (along y), nu = 0."""
    return E * b * h, k * E / 2 * b * h, k * E / 2 * b * h, E / 2 * J, E * b ** 3 * h / 12, E * b * h ** 3 / 12


def cantilever(slender):
    """L = 1, square section, shear factor 5/6, P L^2/EI = 5."""
    h = 1 / slender
    return Case(f"cantilever {slender}", 1, rectangle(12 / h ** 4, h, h, 5 / 6, h ** 4 / 6), [0, 0, 0], [0, 5, 0])


def make_cases():
    """Cantilevers; bend of Bathe and Bolourchi, IJNME 14, 1979; a turn of a helix in space; roll-up."""
    radius, rise, b, h = 1.0, 1 / np.pi, 0.2, 0.1
    q = radius ** 2 + rise ** 2
    strip = rectangle(12 / (b * h ** 3), b, h, 5 / 6, 0.229 * b * h ** 3)
    return [cantilever(1000), cantilever(100), cantilever(10),
            Case("bend", 25 * np.pi, rectangle(1e7, 1, 1, 1, 1 / 6), [0, 0, 0.01], [0, 0, 600]),
            Case("helix", 2 * np.pi * np.sqrt(q), strip, [rise / q, 0, radius / q], [0.1, -0.1, 0.15]),
            Case("roll-up", 1, rectangle(12e8, 0.01, 0.01, 5 / 6, 1e-8 / 6), [0, 0, 0], [0, 0, 0], 2 * np.pi)]


def elastica(load):
    """Shortening and deflection by L of the inextensible cantilever, load = P L^2/EI (Mattiasson 1981)."""
    def angle(k):
        return np.arcsin(1 / (k * np.sqrt(2)))
    k = brentq(lambda k: ellipk(k * k) - ellipkinc(angle(k), k * k) - np.sqrt(load), np.sqrt(0.5) + 1e-12, 1 - 1e-12)
    E = ellipe(k * k) - ellipeinc(angle(k), k * k)
    return 1 - np.sqrt(2 * (2 * k * k - 1) / load), 1 - 2 * E / np.sqrt(load)


# ---- statics ----

def newton(c, case, n, state, factor=1.0, mixed=True, most=40):
    """Equilibrium of n free frames: state (H, z, stress) and iterations, None if it fails. Full tangent, or
    about a stress extrapolated from iterate to iterate (mixed; Magisano, Leonetti, Garcea, CMAME 313, 2017)."""
    H, z, stress = state
    L = case.L * (len(c.nodes) - 1) / n
    q0 = relative(c, case.rest[n])[1]
    stress = np.zeros((c.points, len(q0), 6)) if mixed and stress is None else stress
    scale = np.array([case.L] * 3 + [1] * 3)
    for iteration in range(1, most + 1):
        nodes, q = relative(c, H, z)
        q = q if mixed or c.strain else settled(c, q, q0, L, case.K)
        f, A, u, U, points = element(c, q, q0, L, case.K, stress if mixed else None)
        index = (6 * nodes[..., None] + np.arange(6)).reshape(len(nodes), -1)
        residual, K = np.zeros(6 * n + 6), np.zeros((6 * n + 6, 6 * n + 6))
        np.add.at(residual, index, f)
        np.add.at(K, (index[:, :, None], index[:, None, :]), A)
        local = H[-1, :3, :3].T @ case.P * factor
        residual[-6:] -= np.append(local, [0, 0, factor * case.M])
        K[-6:-3, -3:] -= hat(local)
        step = np.append(np.zeros(6), np.linalg.solve(K[6:, 6:], -residual[6:]))
        dq = u + mv(U, step[index])
        z = (q + dq.reshape(q.shape))[:, len(c.nodes) - 1:]
        stress = [n_s + case.K * mv(B, dq) / L for n_s, B in points]
        step = step.reshape(-1, 6)
        size = abs(step / scale).max()
        if not size < 10:
            break
        H = H @ exp(step)
        if size < 1e-10:
            return (H, z, stress), iteration
    return (H, z, stress), None


def settled(c, q, q0, L, K):
    """q with z stationary at given y."""
    k = 6 * (len(c.nodes) - 1)
    for _ in range(8 * c.internal):
        g, _, H, _ = derivatives(c, q, q0, L, K)
        step = np.linalg.solve(H[:, k:, k:], g[:, k:, None])
        q = np.concatenate([q[:, :-1], q[:, -1:] - tr(step)], 1)
    return q


def errors(c, case):
    """Error for each number of frames, nan where Newton's method fails; None where a relative motion turns by pi."""
    out = []
    for n in MESHES:
        if n % (len(c.nodes) - 1) or case.angle / n > 0.99 * np.pi:
            out.append(None)
            continue
        (H, _, _), done = newton(c, case, n, (case.guess[n], None, None))
        out.append(case.error(H) if done else math.nan)
    return out


# ---- properties ----

def steps_needed(c, case, n, mixed):
    """Least number of equal load steps from rest that converges to the solution, and the iterations of all."""
    for steps in (1, 2, 5, 10, 20, 50):
        state, count = (case.rest[n], None, None), 0
        for i in range(steps):
            state, done = newton(c, case, n, state, (i + 1) / steps, mixed)
            count += done or 0
            if not done:
                break
        if done and case.error(state[0]) < 0.2:
            return f"{steps} ({count})"
    return "-"


def invariance(c, case, n=4):
    """Change of energy and tangent by a rigid motion, and of energy by reversal of s, relative, at a solution."""
    (H, z, _), _ = newton(c, case, n, (case.guess[n], None, None))
    L, flip, by = case.L * (len(c.nodes) - 1) / n, np.diag([-1.0, -1, 1, 1]), np.array([-1, -1, 1, -1, -1, 1])

    def evaluate(H, rest, z):
        q, q0 = relative(c, H, z)[1], relative(c, rest)[1]
        q = settled(c, q, q0, L, case.K)
        return energy(c, q, q0, L, case.K), element(c, q, q0, L, case.K)[1]
    V, A = evaluate(H, case.rest[n], z)
    V1, A1 = evaluate(exp(np.array([30.0, -70, 20, 1.1, -0.7, 2.0])) @ H, case.rest[n], z)
    V2 = evaluate(H[::-1] @ flip, case.rest[n][::-1] @ flip, z[::-1] * (by if c.strain else -by))[0][::-1]
    return abs(V1 / V - 1).max(), abs(A1 - A).max() / abs(A).max(), abs(V2 / V - 1).max()


def cost(c):
    """Calls of log, exp, T, T^-1, ad, solutions of 6 x 6 systems for strains (a: the mixed gradient) and P."""
    q = relative(c, exp(np.linspace(0, 1, len(c.nodes))[:, None] * np.array([1, 0, 0, 0.1, 0.2, 0.3])))[1]
    calls.clear()
    for s, _ in GAUSS.get(c.points, []):
        c.strain(q, s)
    if c.strain is None:
        mixed_gradient(q, q[:, 0], 1, np.ones(6))
    for i in range(len(c.nodes) - 1):
        transfer(q[:, i:i + 1])
        calls["log"] += 1
    return " / ".join(str(calls[k]) for k in ("log", "exp", "T", "Tinv", "ad", "solve"))


def show(e):
    """An error for the table."""
    return "-" if e is None else "fails" if math.isnan(e) else f"{e:.1e}"


def order(e):
    """log2 of the last ratio of errors above what rounding leaves."""
    pairs = [(p, q) for p, q in zip(e, e[1:]) if p and q and q > 1e-11]
    return f"{math.log2(pairs[-1][0] / pairs[-1][1]):.1f}" if pairs else "exact"


def main():
    """Print references, errors and properties."""
    check_group()
    cases = make_cases()
    shortening, deflection = elastica(5)
    print(f"Elastica, P L^2/EI = 5: u/L = {shortening:.8f}, w/L = {deflection:.8f}; shooting, L/h = 1000: "
          f"{1 - cases[0].tip[0]:.8f}, {cases[0].tip[1]:.8f}\n"
          f"Bend: tip at {np.array2string(cases[3].tip, precision=6)}\nEstimated errors of the references: "
          + ", ".join(f"{k.name} {k.uncertainty:.0e}" for k in cases))
    print("\nError of the tip by its displacement; N: free frames (N/2 elements where they have three nodes)\n")
    print("| case | candidate | " + " | ".join(f"N = {n}" for n in MESHES) + " | order |\n" + "|---" * 9 + "|")
    table = {}
    for case in cases:
        for c in CANDIDATES:
            e = table[c.name, case.name] = errors(c, case)
            print(f"| {case.name} | {c.name} | " + " | ".join(map(show, e)) + f" | {order(e)} |", flush=True)
    print("\nProperties. Unknowns: added to a chain by an element; internal: condensed in it. Locking: error at L/h = 1000\n"
          "by that at 100, N = 4 and 32. Rigid motion: change of energy, of tangent. Reversal of s: of energy. Newton:\n"
          "least equal load steps of cantilever 100, N = 8, from rest (iterations in all), full tangent and mixed. Cost\n"
          "of strains and P of an element: log / exp / T / T^-1 / ad (those in T and T^-1 too) / 6 x 6 solutions.\n")
    print("| candidate | unknowns | internal | frames inside | locking | rigid motion | reversal | full | mixed "
          "| cost |\n" + "|---" * 10 + "|")
    for c in CANDIDATES:
        lock = [table[c.name, cases[0].name][i] / table[c.name, cases[1].name][i] for i in (2, 5)]
        V, A, reversed_ = invariance(c, cases[3])
        full, mixed = (steps_needed(c, cases[1], 8, m) for m in (False, True))
        print(f"| {c.name} | {6 * len(c.nodes) - 6} | {6 * c.internal} | {len(c.nodes) - 2} | "
              f"{lock[0]:.2f}, {lock[1]:.2f} | {V:.0e}, {A:.0e} | {reversed_:.0e} | {full} | {mixed} | {cost(c)} |", flush=True)


if __name__ == "__main__":
    main()
