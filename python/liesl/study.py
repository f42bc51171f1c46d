"""Studies: a scene and what to vary, to limit and to minimise."""

from __future__ import annotations

import json
import os
import threading
import time
from collections import OrderedDict
from dataclasses import dataclass
from typing import Any, Callable, Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike

from . import _liesl, texts, toml_text
from .arrays import real
from .errors import InputError, NotConverged, Problem
from .nlp import (Nlp, OwnFunction, PeakNlp, ProgramNlp, StudyNlp, minimize, own_limits,
                  row_name)
from .result import Result

_KEPT = 8  # evaluations
_MOST_WINDOWS = 10_000  # rows of a limit


@dataclass(frozen=True)
class Variable:
    """A number that the study varies, in its unit."""

    name: str
    unit: str
    lower: float
    upper: float
    start: float

    @property
    def slack(self) -> float:
        """What rounding may bring a value beyond its bounds."""
        return 1e-9 * max(abs(self.lower), abs(self.upper))


class DesignMotion(Result):
    """A design in one scenario of its study; `jacobian` and `vjp` are by the variables."""

    def __init__(self, motion: Any):
        super().__init__(motion)
        self._by[()] = (motion, {})

    def _differentiable(self, by):
        if by is not None:
            raise InputError("a design is differentiated by the variables of its study; leave `by` "
                             "out, or run the scene")
        return self._by[()]


class Evaluation(DesignMotion):
    """A design of a study: its motion, converged as sensitivities need it, with a record at every
    step, and what the study asks of it. Data sets are those of the first scenario; `motions` has
    all of them. `jacobian` and `vjp` are by the variables of the study.
    """

    def __init__(self, study: Study, x: np.ndarray, motions: Sequence[Any]):
        super().__init__(motions[0])
        self.study = study
        self.x = x  #: (variables,), the design
        self.objective: float = study._study.mass(x)  #: kg: the mass, also of a study
        #: that minimises a weighted sum
        #: one for each scenario
        self.motions: list[DesignMotion] = [self, *map(DesignMotion, motions[1:])]
        #: largest |value| of each limited response over all motions
        self.limits = {name: max((_largest(m, name) for m in self.motions), default=np.nan)
                       for name, _ in study.limits}
        #: largest |value|/limit - 1
        self.worst = max((self.limits[name] / limit - 1 for name, limit in study.limits),
                         default=np.nan)

    def check(self) -> Evaluation:
        for motion in self.motions:
            if motion.status != "done":
                raise NotConverged(motion.status, motion.reason)
        return self


def magnitude(values: np.ndarray) -> np.ndarray:
    """|y| of a response, (records, components) -> (records,)."""
    return np.linalg.norm(values, axis=1)


def _largest(motion: Result, name: str) -> float:
    values = motion._records.array("responses/" + name.replace("/", "_"))
    return float(magnitude(values).max()) if values is not None and len(values) else np.nan


class Study:
    """A study, checked when it is read. It stays as it is: `change` gives another one.

    >>> study = Study.load("slider_crank_rod.toml")
    >>> best = study.optimize().check()
    >>> best.design, best.summary["mass_final"]            # {"rod_diameters[0]": ...}, kg

    Studies pickle. Simulations may run in several threads; the linear solver of Ipopt is not safe
    among threads, so that optimisations of one process wait for each other: use processes.
    """

    def __init__(self, text: str, file: str, folder: str, changes: tuple[str, ...] = ()):
        self._arguments = (text, file, folder, changes)
        self._study = _liesl.Study(text, file, folder, list(changes))
        self.variables = [Variable(n, u, lo, up, at)
                          for n, u, lo, up, at in self._study.variables()]
        self.limits: list[tuple[str, float]] = self._study.limits()  #: (response, limit)
        self.scenarios: list[str] = self._study.scenarios() or [""]  #: names; "" of the only one
        self._evaluations: OrderedDict[bytes, Evaluation] = OrderedDict()
        self._lock = threading.Lock()

    @classmethod
    def load(cls, path: str | os.PathLike, changes: Mapping[str, Any] | None = None) -> Study:
        """Reads a TOML file and its scene. Raises InputError with all problems of both, IoError if
        there is no such file."""
        file = texts.absolute_input(path)
        text = texts.read(file)
        return cls(text, file, os.path.dirname(file), tuple(toml_text.changes(changes or {})))

    def change(self, values: Mapping[str, Any]) -> Study:
        """The study with other values of its own keys, {"constraints.bending.limit": 1e-3}, or of
        keys of its scene. Raises InputError."""
        text, file, folder, changes = self._arguments
        return Study(text, file, folder, changes + tuple(toml_text.changes(values)))

    @property
    def x0(self) -> np.ndarray:
        """(variables,), the start."""
        return np.array([v.start for v in self.variables])

    @property
    def bounds(self) -> np.ndarray:
        """(variables, 2), lower and upper."""
        return np.array([(v.lower, v.upper) for v in self.variables])

    @property
    def warnings(self) -> list[str]:
        """What is accepted but looks like a mistake."""
        return self._study.warnings()

    def evaluate(self, x: ArrayLike | None = None) -> Evaluation:
        """Simulates a design, (variables,); None: the start. The last designs are kept, so that
        values and derivatives at one x cost one simulation. A motion that does not converge is a
        `status`. Raises InputError for a study without a motion."""
        self._require_motion()
        x = self._design(x)
        with self._lock:
            if x.tobytes() in self._evaluations:
                self._evaluations.move_to_end(x.tobytes())
                return self._evaluations[x.tobytes()]
        motions = [self._study.evaluate(x, s) for s in range(len(self.scenarios))]
        made = Evaluation(self, x, motions)
        with self._lock:
            self._evaluations[x.tobytes()] = made
            while len(self._evaluations) > _KEPT:
                self._evaluations.popitem(last=False)
        return made

    def mass_gradient(self, x: ArrayLike) -> np.ndarray:
        """d(mass of the objective)/dx, (variables,), kg by the units of x."""
        return self._study.mass_gradient(self._design(x))

    def optimize(self, method: str | None = None, nucleate: int = 0,
                 on_cycle: Callable[[dict[str, Any]], None] | None = None,
                 objective: OwnFunction | None = None,
                 limits: Mapping[str, OwnFunction] | None = None,
                 verify: bool = False) -> Optimum:
        """Sizes, as `liesl optimize --no-verify` does; with `verify` as `liesl optimize`: the final
        limits have errors, and `cycle.refine` says whether finer models follow, which `design` is then
        of, not the model of this study.

        `method`: the key `cycle.method`; `nucleate`: new holes at most; `on_cycle` is called after
        each cycle with the summary so far. Ctrl-C stops. How it ended is `status`.

        `objective` and `limits` are functions of one's own, as `nlp` takes them; the limits of
        the study hold, too. No static problem has them: Ipopt is given the motion itself (the method
        "direct", the only one for them), a cycle is a design that it asks derivatives of, `cycle.max`
        of them at most. Raises InputError for functions that return no numbers, another method, and
        as `nlp` does.
        """
        if objective is not None or limits:
            if method not in (None, "direct") or nucleate or verify:
                asked = (f"nucleate={nucleate}" if nucleate else "verify=True" if verify
                         else f"method={method!r}")
                raise InputError([Problem(f"{asked} with functions of one's own",
                                          "method=None or 'direct', no new holes, verify=False",
                                          "static problems do not know these functions")])
            return optimize_own(self, objective, own_limits(limits), on_cycle)
        study = self if method is None else self.change({"cycle.method": method})
        call = None if on_cycle is None else (lambda text: on_cycle(json.loads(text)))
        return Optimum(study._study.optimize(nucleate, verify, call))

    def nlp(self, windows: int = 1, objective: OwnFunction | None = None,
            limits: Mapping[str, OwnFunction] | None = None) -> Nlp:
        """The study as a nonlinear program for SciPy, cyipopt or `liesl.minimize`: minimise the mass
        subject to one row for each limit, scenario and window of time,

            max over the records in the window of |response|/limit - 1 <= 0.

        A study that changes outlines has a row for each limit at each record, and for each mass,
        frequency and wall; one under fixed loads for each limit in each load case; neither has
        windows, and what is minimised is the objective of the study. Rows stay the same whatever the
        design. `objective` replaces what is minimised and `limits` adds rows f <= 0 by name, each a
        function of an Evaluation that returns its value and its derivatives by what it has read,
        {"bend": (records, components), "x": (variables,)}.
        Raises InputError for statics of a mechanism, for functions of one's own without a motion, and
        for what rows in windows do not have: limits on frequencies, masses, integrals and p-norms,
        sizes of a catalogue, a weighted sum.
        """
        if isinstance(windows, bool) or not isinstance(windows, int) or not 1 <= windows <= _MOST_WINDOWS:
            raise InputError(f"windows is {windows!r}; expected a whole number, 1 to {_MOST_WINDOWS}")
        loaded = self._study.fixed_loads()
        if objective is not None or limits or not loaded:
            self._require_motion()
        if loaded or self._study.changes_outlines():
            return self._program(windows, objective, own_limits(limits))
        if left_out := self._study.without_rows():
            raise InputError(f"{', '.join(left_out)} are no rows of nlp(); use optimize() without "
                             "functions of one's own")
        if objective is None and not self._study.only_mass():
            raise InputError("the study minimises a weighted sum, nlp() the mass; give objective=, "
                             "or use optimize()")
        return PeakNlp(self, windows, objective, own_limits(limits))

    def _program(self, windows: int, objective: OwnFunction | None,
                 limits: Mapping[str, OwnFunction]) -> Nlp:
        """Of outlines and of fixed loads."""
        if windows != 1:
            raise InputError([Problem(f"windows is {windows} of a study that changes outlines, or of fixed "
                                      "loads, whose rows are load cases or records", "1")])
        try:
            return ProgramNlp(self, objective, limits)
        except (ValueError, RuntimeError) as error:
            if isinstance(error, InputError):
                raise
            raise InputError(f"the study is no nonlinear program: {error}") from None

    def _require_motion(self) -> None:
        if not self._study.moves():
            raise InputError("the study has no motion (fixed loads, or statics); use optimize()")

    def _design(self, x: ArrayLike | None) -> np.ndarray:
        """Within the bounds, or InputError; None: the start."""
        if x is None:
            return self.x0
        given = self._array(x)
        problems = [Problem(f"'{v.name}' is {at}", f"in [{v.lower}, {v.upper}] {v.unit}")
                    for v, at in zip(self.variables, given)
                    if not v.lower - v.slack <= at <= v.upper + v.slack]
        if problems:
            raise InputError(problems)
        return given

    def _array(self, x: ArrayLike) -> np.ndarray:
        """(variables,), or InputError."""
        try:
            given = real(x)
        except (TypeError, ValueError):
            raise InputError([Problem("x is no array of numbers",
                                      f"shape ({len(self.variables)},)")]) from None
        if given.shape != (len(self.variables),):
            raise InputError([Problem(f"x has shape {given.shape}",
                                      f"({len(self.variables)},), a number for each variable")])
        return given

    def __reduce__(self):
        return Study, self._arguments

    def __repr__(self) -> str:
        return f"Study({', '.join((self._arguments[1], *self._arguments[3]))})"


class Optimum(Result):
    """What `Study.optimize` has found: data sets of the motion of the final design."""

    @property
    def design(self) -> dict[str, float]:
        """The final design by the names of its variables."""
        return dict(self.summary.get("design", {}))

    @property
    def x(self) -> np.ndarray:
        """(variables,), the same as an array."""
        return np.array(list(self.design.values()), dtype=float)

    @property
    def history(self) -> list[dict[str, Any]]:
        """Figures of each cycle: docs/outputs.md, `history`."""
        return self.summary.get("history", [])


class _Recorded(Nlp):
    """The program of a study that notes the designs whose derivatives are asked for."""

    def __init__(self, nlp: StudyNlp, study: Study,
                 on_cycle: Callable[[dict[str, Any]], None] | None):
        super().__init__(nlp.variables, nlp.objective, self._note, nlp.constraints, nlp.jacobian,
                         nlp.rows)
        self._nlp, self._study, self._on_cycle = nlp, study, on_cycle
        self._begin = time.perf_counter()
        self.history: list[dict[str, Any]] = []
        self.effort: dict[str, Any] = {"steps": 0, "newton_iterations": 0, "stepping_s": 0.0,
                                       "factorizations": {}}  #: of the motions of these designs

    def _note(self, x: np.ndarray) -> np.ndarray:
        out = self._nlp.gradient(x)
        self.note(x)
        return out

    def note(self, x: np.ndarray) -> None:
        """A design that counts as a cycle."""
        x, now = _same(np.clip(x, *self._study.bounds.T), self.x0), time.perf_counter()
        g = self.constraints(x)
        at = self._study.evaluate(x)
        worst = int(np.argmax(g)) if len(g) else None
        self.history.append({"cycle": len(self.history) + 1, "objective": _figure(self.objective(x)),
                             "mass": at.objective, "design": [float(v) for v in x],
                             "worst_constraint": -1.0 if worst is None else _figure(g[worst]),
                             "worst_limit": "" if worst is None else self.rows[worst],
                             "limits": {**_excesses(at), **self._own_excesses(g)},
                             "wall_s": now - self._begin})
        self._begin = now
        for motion in at.motions:
            for key in ("steps", "newton_iterations", "stepping_s"):
                self.effort[key] += motion.summary[key]
            for body, count in motion.summary["factorizations"].items():
                self.effort["factorizations"][body] = self.effort["factorizations"].get(body, 0) + count
        if self._on_cycle:
            self._on_cycle({"status": "running", "history": list(self.history)})


    def _own_excesses(self, g: np.ndarray) -> dict[str, dict[str, Any]]:
        """As `history[].limits`: functions of one's own, which hold at no instant."""
        own = list(self._nlp.own_limits)
        return {name: {"violation": _figure(value), "at": ""}
                for name, value in zip(own, g[len(g) - len(own):])}


def _excesses(at: Evaluation) -> dict[str, dict[str, Any]]:
    """As `history[].limits`: the limited responses of each motion, relative."""
    out = {}
    for scenario, motion in zip(at.study.scenarios, at.motions):
        for name, limit in at.study.limits:
            values = magnitude(motion["responses/" + name.replace("/", "_")])
            record = values.argmax()
            out[row_name(name, scenario)] = {"violation": _figure(values[record] / limit - 1),
                                             "at": f"t = {motion.time[record]:.6g} s"}
    return out


def _same(x: np.ndarray, known: np.ndarray) -> np.ndarray:
    """A known design where x is that up to the round-off of the optimiser's scaling; else x."""
    return known if np.allclose(x, known, rtol=1e-12, atol=0) else x


def _figure(value: Any) -> float | None:
    """As a summary has it: None is no finite number."""
    return float(value) if np.isfinite(value) else None


_ENDS = {"converged": "optimal", "acceptable": "converged", "iteration limit": "cycle limit",
         "stopped": "interrupted"}


def optimize_own(study: Study, objective: OwnFunction | None, limits: Mapping[str, OwnFunction],
                 on_cycle: Callable[[dict[str, Any]], None] | None) -> Optimum:
    """See `Study.optimize`."""
    begin = time.perf_counter()
    program = study.nlp(objective=objective, limits=limits)
    program.check_start()
    nlp = _Recorded(program, study, on_cycle)
    found = minimize(nlp, tolerance=1e-5, feasibility=1e-5,
                     max_iterations=study._study.most_cycles())
    x = np.clip(found.x, *study.bounds.T)
    if not nlp.history:  # the optimiser has asked for no derivative
        nlp.note(x)
    x = _same(x, np.array(nlp.history[-1]["design"]))
    before, after = nlp.constraints(nlp.x0), nlp.constraints(x)
    own = range(len(nlp.rows) - len(limits), len(nlp.rows))
    quantity = ("own function" if objective is not None else
                "mass" if study._study.only_mass() else "weighted sum")
    text = json.dumps({
        "status": _ENDS.get(found.status, found.status), "reason": found.reason,
        "x": x.tolist(), "history": nlp.history, "wall_s": time.perf_counter() - begin,
        "limits": [{"name": nlp.rows[i], "initial": _figure(before[i]), "final": _figure(after[i])}
                   for i in own],
        "more": {**nlp.effort,
                 "objective": {"quantity": quantity, "unit": "kg" if quantity == "mass" else "-",
                               "initial": _figure(nlp.objective(nlp.x0)),
                               "final": _figure(nlp.objective(x))},
                 "row_values": dict(zip(nlp.rows, map(_figure, after))),
                 "multipliers": dict(zip(nlp.rows, map(_figure, found.multipliers)))},
    })
    return Optimum(study._study.found(text))
