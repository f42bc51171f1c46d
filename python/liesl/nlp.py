"""Nonlinear programs: of a study, or of one's own functions; minimised by Ipopt or by SciPy."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Callable, Mapping, Sequence

import numpy as np

from . import _liesl, texts
from .arrays import real
from .errors import InputError, NotConverged, Problem

if TYPE_CHECKING:
    from .study import Evaluation, Study

#: Value, and derivatives by the responses that were read and by the design, "x".
OwnFunction = Callable[["Evaluation"], tuple[float, Mapping[str, Any]]]


class Nlp:
    """minimise objective(x) subject to constraints(x) <= 0 and lower <= x <= upper; n variables, m
    rows. The methods are those that cyipopt asks for; a value that cannot be had is NaN.

    `variables`: (name, lower, upper, start) of each; bounds may be infinite.
    """

    def __init__(self, variables: Sequence[tuple[str, float, float, float]],
                 objective: Callable[[np.ndarray], float],
                 gradient: Callable[[np.ndarray], np.ndarray],
                 constraints: Callable[[np.ndarray], np.ndarray] | None = None,
                 jacobian: Callable[[np.ndarray], np.ndarray] | None = None,
                 rows: Sequence[str] = ()):
        self.variables = [_variable(v) for v in variables]
        self.rows = list(rows)  #: names of the constraints
        self._objective, self._gradient = objective, gradient
        self._constraints, self._jacobian = constraints, jacobian

    @property
    def x0(self) -> np.ndarray:
        """(n,), the start."""
        return np.array([v[3] for v in self.variables], dtype=float)

    @property
    def bounds(self) -> list[tuple[float, float]]:
        """n pairs (lower, upper)."""
        return [(v[1], v[2]) for v in self.variables]

    def objective(self, x: np.ndarray) -> float:
        return self._objective(x)

    def gradient(self, x: np.ndarray) -> np.ndarray:
        """(n,)"""
        return self._gradient(x)

    def constraints(self, x: np.ndarray) -> np.ndarray:
        """(m,), <= 0 where they hold."""
        return np.zeros(0) if self._constraints is None else self._constraints(x)

    def jacobian(self, x: np.ndarray) -> np.ndarray:
        """(m, n)"""
        return np.zeros((0, len(self.variables))) if self._jacobian is None else self._jacobian(x)

    def scipy(self) -> dict[str, Any]:
        """Arguments of scipy.optimize.minimize: `minimize(method="SLSQP", **nlp.scipy())`.

        A value that cannot be had is infinite there, so that its methods shorten the step: NaN they
        take for a value that is good enough."""
        rows = {"type": "ineq", "fun": lambda x: -_infinite(self.constraints(x)),
                "jac": lambda x: -np.asarray(self.jacobian(x))}
        return {"fun": lambda x: float(_infinite(self.objective(x))), "jac": self.gradient, "x0": self.x0, "bounds": self.bounds,
                "constraints": [rows] if self.rows else []}


def _infinite(values: Any) -> np.ndarray:
    """With infinity in place of NaN."""
    values = np.asarray(values, dtype=float)
    return np.where(np.isnan(values), np.inf, values)


def _variable(given: Any) -> tuple[str, float, float, float]:
    """Raises InputError for what is no (name, lower, upper, start)."""
    try:
        name, *numbers = given
        lower, upper, start = map(float, numbers)
    except (TypeError, ValueError):
        expected = "(name, lower, upper, start), a text and three numbers"
        raise InputError([Problem(f"a variable is {given!r}", expected)]) from None
    if not isinstance(name, str):
        raise InputError([Problem(f"the name of a variable is {name!r}", "a text")])
    return name, lower, upper, start


def own_limits(given: Any) -> dict[str, OwnFunction]:
    """Limits of one's own, by name. Raises InputError for what is no mapping."""
    if given is None:
        return {}
    if not isinstance(given, Mapping):
        raise InputError([Problem(f"limits is {given!r}", "a function of an Evaluation by name",
                                  "limits={'name': function}")])
    problems = [Problem(f"the limit {name!r} has no name", texts.UNICODE)
                for name in given if not isinstance(name, str) or texts.shown(name) != name]
    if problems:
        raise InputError(problems)
    return dict(given)


class StudyNlp(Nlp):
    """See `Study.nlp`: rows of the study, then one's own."""

    def __init__(self, study: Study, objective: OwnFunction | None,
                 limits: Mapping[str, OwnFunction]):
        own = {"the objective": objective} if objective is not None else {}
        own.update({f"'{name}'": f for name, f in limits.items()})
        known = [name for name, _ in study.limits]
        problems = [Problem(f"{what} is no function: {f!r}", "a function of an Evaluation")
                    for what, f in own.items() if not callable(f)]
        problems += [Problem(f"'{name}' is a limit of the study already", "another name")
                     for name in limits if name in known]
        if problems:
            raise InputError(problems)
        self._study, self._own_objective, self.own_limits = study, objective, limits
        super().__init__([(v.name, v.lower, v.upper, v.start) for v in study.variables],
                         self._mass, self._mass_gradient, self._limits, self._limits_jacobian,
                         rows=self._names() + list(limits))

    # What the study has of itself; other sources of it replace these.
    def _names(self) -> list[str]:
        raise NotImplementedError

    def _mass(self, x: np.ndarray) -> float:
        return self._at(x).objective

    def _mass_gradient(self, x: np.ndarray) -> np.ndarray:
        return self._study.mass_gradient(self._at(x).x)

    def _limits(self, x: np.ndarray) -> np.ndarray:
        raise NotImplementedError

    def _limits_jacobian(self, x: np.ndarray) -> np.ndarray:
        raise NotImplementedError

    def objective(self, x: np.ndarray) -> float:
        if self._own_objective is None:
            return self._objective(x)
        at = self._at(x)
        return _own(self._own_objective, at, "the objective")[0] if _good(at) else np.nan

    def gradient(self, x: np.ndarray) -> np.ndarray:
        if self._own_objective is None:
            return self._gradient(x)
        return _own(self._own_objective, self._at(x).check(), "the objective", derivative=True)[1]

    def constraints(self, x: np.ndarray) -> np.ndarray:
        values = self._constraints(x)
        if not self.own_limits:
            return values
        at = self._at(x)
        own = [_own(f, at, f"'{name}'")[0] if _good(at) else np.nan
               for name, f in self.own_limits.items()]
        return np.concatenate([values, own])

    def jacobian(self, x: np.ndarray) -> np.ndarray:
        rows = self._jacobian(x)
        if not self.own_limits:
            return rows
        at = self._at(x).check()
        return np.vstack([rows, *(_own(f, at, f"'{name}'", derivative=True)[1]
                                  for name, f in self.own_limits.items())])

    def check_start(self) -> None:
        """Raises InputError if one's own functions have no value at the start, NotConverged if its
        motion has no end."""
        at = self._at(self.x0).check()
        own = {f"'{name}'": f for name, f in self.own_limits.items()}
        if self._own_objective is not None:
            own["the objective"] = self._own_objective
        problems = [Problem(f"{what} is {value} at the start", "a finite number")
                    for what, f in own.items() if not np.isfinite(value := _own(f, at, what)[0])]
        if problems:
            raise InputError(problems)

    def _at(self, x: np.ndarray) -> Evaluation:
        """SciPy steps over bounds by differences of round-off."""
        return self._study.evaluate(np.clip(self._study._array(x), *self._study.bounds.T))


class PeakNlp(StudyNlp):
    """A row for each limit, scenario and window of time: the largest value in the window."""

    def __init__(self, study: Study, windows: int, objective: OwnFunction | None,
                 limits: Mapping[str, OwnFunction]):
        self._windows, self._scenarios = windows, study.scenarios
        self._limited = [name for name, _ in study.limits]
        super().__init__(study, objective, limits)

    def _names(self) -> list[str]:
        return [row_name(name, scenario, w if self._windows > 1 else None)
                for scenario in self._scenarios for name in self._limited
                for w in range(self._windows)]

    def _limits(self, x: np.ndarray) -> np.ndarray:
        at = self._at(x)
        if not _good(at):
            return np.full(len(self._names()), np.nan)
        return np.array([magnitude[record] / limit - 1
                         for _, _, magnitude, record, limit in self._peaks(at)])

    def _limits_jacobian(self, x: np.ndarray) -> np.ndarray:
        rows = []
        for motion, name, magnitude, record, limit in self._peaks(self._at(x).check()):
            y = motion["responses/" + name.replace("/", "_")][record]
            dy = motion.jacobian(name)[record]
            rows.append(y @ dy / (magnitude[record] or 1.0) / limit)
        return np.array(rows).reshape(-1, len(self.variables))

    def _peaks(self, at: Evaluation):
        """Of each row the motion, its response, |y| at all records, the record of its peak in the
        window, the limit."""
        for motion in at.motions:
            time = motion.time
            edges = np.linspace(time[0], time[-1], self._windows + 1)
            window = np.clip(np.searchsorted(edges, time, side="right") - 1, 0, self._windows - 1)
            for name, limit in self._study.limits:
                values = np.linalg.norm(motion["responses/" + name.replace("/", "_")], axis=1)
                for w in range(self._windows):
                    records = np.flatnonzero(window == w)
                    if not len(records):
                        raise InputError(f"window {w} of {self._windows} has no record; fewer "
                                         "windows, or a smaller simulation.step")
                    yield motion, name, values, records[values[records].argmax()], limit


class ProgramNlp(StudyNlp):
    """Rows as the program itself has them, of studies of outlines and of fixed loads: each limit in
    each load case or at each record, masses, frequencies, walls."""

    def __init__(self, study: Study, objective: OwnFunction | None,
                 limits: Mapping[str, OwnFunction]):
        self._program = study._study.program()
        self._latest: tuple[bytes, tuple[float, np.ndarray, np.ndarray, np.ndarray]] | None = None
        super().__init__(study, objective, limits)

    def _names(self) -> list[str]:
        return self._program.rows()

    def _point(self, x: np.ndarray) -> tuple[float, np.ndarray, np.ndarray, np.ndarray]:
        """Value, rows and their gradients, of the latest design without another evaluation."""
        x = np.clip(self._study._array(x), *self._study.bounds.T)
        if self._latest is None or self._latest[0] != x.tobytes():
            self._latest = (x.tobytes(), self._program.evaluate(x))
        return self._latest[1]

    def _mass(self, x: np.ndarray) -> float:
        return self._point(x)[0]

    def _mass_gradient(self, x: np.ndarray) -> np.ndarray:
        return self._point(x)[2].copy()

    def _limits(self, x: np.ndarray) -> np.ndarray:
        return self._point(x)[1].copy()

    def _limits_jacobian(self, x: np.ndarray) -> np.ndarray:
        return self._point(x)[3].copy()


def row_name(name: str, scenario: str, window: int | None = None) -> str:
    """Of a limit in a scenario ("" is the only one) and a window."""
    name += f" ({scenario})" if scenario else ""
    return name if window is None else f"{name}[{window}]"


def _good(at: Evaluation) -> bool:
    return all(motion.status == "done" for motion in at.motions)


def _own(function: OwnFunction, at: Evaluation, what: str,
         derivative: bool = False) -> tuple[float, np.ndarray]:
    """Value and, if asked for, gradient of a function of an evaluation."""
    try:
        value, by = function(at)
        value, by = float(value), dict(by)
    except (TypeError, ValueError) as error:
        if isinstance(error, InputError):
            raise
        raise InputError(f"{what} returns no (value, {{response: derivative}}): {error}") from error
    if not derivative:
        return value, np.zeros(0)
    given = by.pop("x", np.zeros(len(at.x)))
    try:
        by_x = real(given)
    except (TypeError, ValueError):
        by_x = np.array(np.nan)
    if by_x.shape != at.x.shape or not np.isfinite(by_x).all():
        raise InputError([Problem(f"{what}: the derivative by 'x' is {given}",
                                  f"finite numbers of shape {at.x.shape}")])
    try:
        return value, by_x + (at.vjp(by) if by else 0)
    except InputError as error:
        raise InputError([Problem(f"{what}: {p.what}", p.expected, p.hint)
                          for p in error.problems]) from None


@dataclass(frozen=True)
class MinimizeResult:
    """`status`: "converged", "acceptable", "iteration limit", "infeasible", "stopped"."""

    status: str
    reason: str
    solved: bool
    x: np.ndarray  #: (n,)
    f: float
    g: np.ndarray  #: (m,)
    violation: float  #: largest scaled g, 0 if feasible
    multipliers: np.ndarray  #: (m,), >= 0
    lower_multipliers: np.ndarray
    upper_multipliers: np.ndarray
    iterations: int
    evaluations: int
    wall_s: float

    def check(self) -> MinimizeResult:
        """Itself. Raises NotConverged unless it is solved."""
        if not self.solved:
            raise NotConverged(self.status, self.reason)
        return self


class _Checked:
    """What the solver is handed: arrays of the right shape, gradients without NaN."""

    def __init__(self, nlp: Nlp):
        self.nlp, self.variables = nlp, [tuple(v) for v in nlp.variables]
        self.rows = list(nlp.rows)

    def objective(self, x: np.ndarray) -> float:
        return float(self.nlp.objective(x))

    def constraints(self, x: np.ndarray) -> np.ndarray:
        return self._array(self.nlp.constraints(x), "constraints", (len(self.rows),))

    def gradient(self, x: np.ndarray) -> np.ndarray:
        out = self._array(self.nlp.gradient(x), "gradient", (len(self.variables),))
        return self._finite(out[None, :], ["the objective"])[0]

    def jacobian(self, x: np.ndarray) -> np.ndarray:
        shape = (len(self.rows), len(self.variables))
        return self._finite(self._array(self.nlp.jacobian(x), "jacobian", shape),
                            [f"row '{r}'" for r in self.rows])

    @staticmethod
    def _array(value: Any, what: str, shape: tuple[int, ...]) -> np.ndarray:
        try:
            out = np.ascontiguousarray(real(value)).reshape(np.shape(value))
        except (TypeError, ValueError) as error:
            raise InputError([Problem(f"{what} returns no numbers: {error}",
                                      f"shape {shape}")]) from None
        if out.shape != shape:
            raise InputError([Problem(f"{what} returns shape {out.shape}", f"{shape}")])
        return out

    def _finite(self, out: np.ndarray, rows: list[str]) -> np.ndarray:
        problems = [Problem(f"the derivative of {rows[i]} by '{self.variables[j][0]}' is "
                            f"{out[i, j]}", "a finite number")
                    for i, j in np.argwhere(~np.isfinite(out))]
        if problems:
            raise InputError(problems)
        return out


def minimize(nlp: Nlp, tolerance: float = 1e-6, feasibility: float = 1e-6,
             max_iterations: int = 300) -> MinimizeResult:
    """Minimises with Ipopt, with limited-memory BFGS updates for the Hessian.

    `tolerance`: of the scaled optimality conditions; `feasibility`: allowed scaled violation. Points
    without a value (NaN) shorten the step. Calls of one process wait for each other.
    Raises InputError for shapes that do not fit and derivatives that are no numbers, and whatever
    the functions raise; TypeError for what is no program.
    """
    if not isinstance(nlp, Nlp):
        raise TypeError(f"minimize takes an Nlp, not {nlp!r} of type {type(nlp).__name__}: "
                        "liesl.Nlp(...) of functions, or study.nlp()")
    for name, value in (("tolerance", tolerance), ("feasibility", feasibility)):
        if not 0 < value < 1:
            raise InputError(f"{name} is {value}; expected a number in (0, 1)")
    result = _liesl.minimize(_Checked(nlp), float(tolerance), float(feasibility),
                             int(max_iterations))
    return MinimizeResult(**result)
