"""Results: of a task that has run, or of a folder that it left."""

from __future__ import annotations

import csv
import io
import json
import os
import tempfile
import warnings
from pathlib import Path
from typing import Any, Iterable, Iterator, Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike

from . import _liesl, texts
from .arrays import real
from .errors import InputError, IoError, NotConverged, Problem

_GOOD = {"done", "converged", "optimal", "finished"}


class Group(Mapping[str, Any]):
    """A group of data sets, `result["bodies"]["rod"]["position"]`. Attributes in `attributes`."""

    def __init__(self, result: Result, name: str):
        self._result, self._name = result, name

    def __getitem__(self, key: str) -> Any:
        return self._result[f"{self._name}/{key}"]

    def __iter__(self) -> Iterator[str]:
        return iter(self._result._below(self._name))

    def __len__(self) -> int:
        return len(self._result._below(self._name))

    def __repr__(self) -> str:
        return f"{self._name}: {', '.join(self)}"

    @property
    def attributes(self) -> dict[str, str]:
        """Texts: "kind" of a body, "type" of a joint."""
        return self._result._records.attributes(self._name)


class Result(Mapping[str, Any]):
    """Data sets by the names of results.h5 (docs/outputs.md), SI units.

    >>> result["bodies/rod/position"]          # (records, nodes, 3), m
    >>> result.responses["bend"]               # (records, components)
    >>> result.time                            # (records,), s

    Arrays are read-only views of the numbers of the simulation, without a copy, and keep them
    alive.
    """

    def __init__(self, records: Any, source: Any = None):
        self._records, self._source = records, source
        self._names: list[str] = records.names()
        self.summary: dict[str, Any] = json.loads(records.summary())  #: summary.json
        self._by: dict[tuple[str, ...], Any] = {}

    # --- data sets

    def __getitem__(self, name: str) -> Any:
        known = not isinstance(name, str) or texts.shown(name) == name
        array = self._records.array(name) if known else None
        if array is not None:
            return array
        if self._below(name):
            return Group(self, name)
        above = name
        while above and not self._below(above):
            above = above.rpartition("/")[0]
        where = f"in '{above}' " if above else ""
        raise KeyError(f"there is no '{texts.shown(name)}'; {where}known: {', '.join(self._below(above))}")

    def __iter__(self) -> Iterator[str]:
        return iter(self._names)

    def __len__(self) -> int:
        return len(self._names)

    def unit(self, name: str) -> str:
        """Unit of a data set, "m"; of several kinds of columns "m/s, rad/s"; empty if it has none, or
        there is no such data set."""
        return self._records.unit(name) if name in self._names else ""

    def _below(self, name: str) -> list[str]:
        start = name + "/" if name else ""
        return list(dict.fromkeys(n[len(start):].split("/")[0] for n in self._names
                                  if n.startswith(start)))

    @property
    def time(self) -> np.ndarray:
        """(records,), s; of statics the load factor, of modes the frequency, Hz."""
        return self["time"]

    @property
    def bodies(self) -> Group:
        return Group(self, "bodies")

    @property
    def joints(self) -> Group:
        return Group(self, "joints")

    @property
    def meshes(self) -> Group:
        return Group(self, "meshes")

    @property
    def responses(self) -> Group:
        return Group(self, "responses")

    @property
    def energies(self) -> Group:
        return Group(self, "energies")

    # --- termination status

    @property
    def status(self) -> str:
        """One word: "done", "not_converged", "optimal", ... (docs/outputs.md)."""
        return self.summary.get("status", "")

    @property
    def reason(self) -> str:
        """One sentence: why it ended."""
        return self.summary.get("reason", "")

    @property
    def warnings(self) -> list[str]:
        return self.summary.get("warnings", [])

    def check(self):
        """The result itself. Raises NotConverged unless the task has found what it was to find."""
        if self.status not in _GOOD:
            raise NotConverged(self.status, self.reason)
        return self

    # --- derivatives

    def jacobian(self, response: str, by: str | Sequence[str] | None = None) -> np.ndarray:
        """dy/dp at every record, (records, components, parameters).

        `by`: keys of the scene, "sections.rod.diameter"; a design that was evaluated is
        differentiated by the variables of its study. Direct form: one factorisation and a solution
        for each parameter a step.
        """
        motion, made = self._differentiable(by)
        if "derivatives" not in made:
            made["derivatives"] = dict(zip(motion.responses(), motion.derivatives()))
        if response not in made["derivatives"]:
            raise InputError([Problem(f"there is no response '{texts.shown(response)}'",
                                      ", ".join(made["derivatives"]))])
        return made["derivatives"][response]

    def vjp(self, weights: Mapping[str, ArrayLike],
            by: str | Sequence[str] | None = None) -> np.ndarray:
        """sum w dy/dp over all records and components, (parameters,): the gradient of a function of
        the responses from its derivatives by them. `weights`: of each response its shape,
        (records, components), or (records,) of scalars. Adjoint form: its cost hardly depends on
        the number of parameters.
        """
        motion, _ = self._differentiable(by)
        return motion.pull_back(_weights(weights, motion))

    def _differentiable(self, by: str | Sequence[str] | None) -> tuple[Any, dict[str, Any]]:
        keys = () if by is None else (by,) if isinstance(by, str) else by
        keys = tuple(keys) if isinstance(keys, Iterable) else (keys,)
        if not all(isinstance(key, str) and texts.shown(key) == key for key in keys):
            raise InputError([Problem(f"by is {by!r}", "a key of the scene, or a list of keys",
                                      'by="sections.rod.diameter"')])
        if not keys:
            raise InputError([Problem("by which parameters?", "a key of the scene, or a list of keys",
                                      'by="sections.rod.diameter"')])
        if not hasattr(self._source, "_differentiable"):
            raise InputError("a folder holds no motion to differentiate; run its scene")
        if keys not in self._by:
            self._by[keys] = (self._source._differentiable(keys), {})
        return self._by[keys]

    # --- files

    def save(self, folder: str | os.PathLike, overwrite: bool = False, report: bool = True) -> None:
        """Writes a results folder, as the program does. `overwrite` replaces an earlier result of
        liesl and nothing else. Raises IoError; then nothing is written."""
        self._records.save(texts.absolute(folder), overwrite, report)

    def report(self, path: str | os.PathLike) -> None:
        """Writes the page of the result: one HTML file. Raises IoError."""
        file = texts.absolute(path)
        with tempfile.TemporaryDirectory() as folder:
            self._records.save(os.path.join(folder, "result"), False, False)
            _liesl.write_file(file, _liesl.page_of(os.path.join(folder, "result"), Path(file).stem))

    def __reduce__(self):
        raise TypeError("a result does not pickle: save() it and liesl.open() the folder, or hand on "
                        "its arrays and summary")

    def __repr__(self) -> str:
        return f"{type(self).__name__}({self.summary.get('name', '')}: {self.status})"


def _weights(weights: Mapping[str, ArrayLike], motion: Any) -> list[np.ndarray | None]:
    """In the order of the responses, of their shapes, finite."""
    problems, out = [], []
    for name in weights:
        if name not in motion.responses():
            problems.append(Problem(f"there is no response '{name}'",
                                    ", ".join(motion.responses())))
    for name in motion.responses():
        if name not in weights:
            out.append(None)
            continue
        shape = motion.array(f"responses/{name.replace('/', '_')}").shape
        try:
            w = real(weights[name])
        except (TypeError, ValueError):
            problems.append(Problem(f"'{name}': the weights are no numbers", f"shape {shape}"))
            continue
        if w.shape != shape and not (shape[1:] == (1,) and w.shape == shape[:1]):
            problems.append(Problem(f"'{name}': the weights have shape {w.shape}", f"{shape}"))
        elif not np.isfinite(w).all():
            at = tuple(int(i) for i in np.argwhere(~np.isfinite(w))[0])
            problems.append(Problem(f"'{name}': the weight at {list(at)} is {w[at]}",
                                    "finite numbers"))
        out.append(np.ascontiguousarray(w))
    if problems:
        raise InputError(problems)
    return out


class _Folder:
    """Data sets and tables of a results folder."""

    def __init__(self, folder: Path):
        _liesl.require_result(folder)
        self.folder = folder
        self._require_whole()
        _liesl.check_hdf5_files(folder)
        self._sets: dict[str, Any] = {}
        files = sorted(folder.glob("*.h5"), key=lambda f: (f.name != "results.h5", f.name))
        self._files = [_liesl.Hdf5Sets(file) for file in files]
        for file in self._files:
            for name in file.names():
                self._sets.setdefault(name, file)

    def _require_whole(self) -> None:
        """Neither of another version, nor without its HDF5 file, which `.liesl` lists."""
        summary = json.loads(self.summary())
        version = summary.get("versions", {}).get("liesl")
        if version != _liesl.__version__:
            raise IoError(f"cannot read '{self.folder}': it is of liesl {version}; run it again", str(self.folder))
        mark = self.folder / ".liesl"
        if not mark.exists():
            raise IoError(f"cannot read '{self.folder}': its .liesl is not there; copy the whole folder, or run it again", str(self.folder))
        listed = _liesl.read_file(mark).splitlines()
        if summary.get("command") == "batch":  # which writes it when all cases have ended
            return
        if "results.h5" in listed and not (self.folder / "results.h5").exists():
            raise IoError(f"cannot read '{self.folder}': its results.h5 is not there; run it again", str(self.folder))

    def names(self) -> list[str]:
        return list(self._sets)

    def array(self, name: str) -> Any:
        return self._sets[name].array(name) if name in self._sets else None

    def unit(self, name: str) -> str:
        return self._sets[name].unit(name) if name in self._sets else ""

    def attributes(self, group: str) -> dict[str, str]:
        known = ["kind"] if group.startswith("bodies") else ["type", "a", "b"]
        if not group:
            known = ["program", "scene", "space", "abscissa"]
        return {key: text for key in known
                if self._files and (text := self._files[0].attribute(group, key))}

    def summary(self) -> str:
        path = self.folder / "summary.json"
        try:
            text = _liesl.read_file(path)
            if isinstance(json.loads(text), dict):
                return text
        except ValueError:  # of bytes that are no text, too
            pass
        raise IoError(f"cannot read '{path}': it is no summary of liesl", str(path))

    def save(self, folder: str, overwrite: bool, report: bool) -> None:
        raise IoError(f"cannot save '{folder}': the result is in {self.folder} already; copy it",
                      folder)


def _renamed(name: str, known: Iterable[str]) -> str | None:
    """The column that is now what `name` was: of version 0.1, where a deflection in a plane had no
    letter, "bend [m]" is "bend.y [m]" or "bend.z [m]"; and the other way round in its tables. None
    if there is none, or more than one."""
    base, _, unit = name.partition(" [")
    unit = f" [{unit}" if unit else ""
    if base.endswith((".y", ".z")):
        wanted = [base[:-2] + unit]
    else:
        wanted = [f"{base}.y{unit}", f"{base}.z{unit}"]
    found = [n for n in wanted if n in known]
    return found[0] if len(found) == 1 else None


class Table(dict[str, np.ndarray]):
    """Columns by name. A name of version 0.1 is accepted with a warning (FutureWarning)."""

    def __missing__(self, name: str) -> np.ndarray:
        now = _renamed(name, self) if isinstance(name, str) else None
        if now is None:
            raise KeyError(f"there is no column '{name}'; known: {', '.join(self)}")
        warnings.warn(f"the column '{name}' is called '{now}' here", FutureWarning, stacklevel=2)
        return self[now]


class FolderResult(Result):
    """What `liesl.open` gives: data sets of all HDF5 files of the folder, and its tables."""

    def __init__(self, folder: Path):
        super().__init__(_Folder(folder))
        self.folder = folder  #: where it is

    @property
    def tables(self) -> dict[str, Table]:
        """CSV tables by name, each with its columns: "design", "responses_final", of a batch
        "results". Columns have the names of their headings, which keep the unit ("mass_final [kg]");
        they are numbers where all their entries are, else texts."""
        return {f.stem: _table(f) for f in sorted(self.folder.glob("*.csv"))}

    def report(self, path: str | os.PathLike) -> None:
        file = texts.absolute(path)
        _liesl.write_file(file, _liesl.page_of(self.folder, self.folder.resolve().name))

    def __reduce__(self):
        return FolderResult, (self.folder.resolve(),)


def _table(path: Path) -> Table:
    try:
        text = path.read_text(encoding="utf-8")
        rows = list(csv.reader(io.StringIO(text, newline="")))
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise IoError(f"cannot read '{path}': {error}", str(path)) from None
    if not text.endswith("\n"):
        raise IoError(f"cannot read '{path}': it ends within a line; run it again", str(path))
    names, rows = (rows[0], rows[1:]) if rows else ([], [])
    if any(len(row) != len(names) for row in rows):
        raise IoError(f"cannot read '{path}': its rows have different lengths", str(path))
    return Table((name, _column(path, i + 1, name, [row[i] for row in rows])) for i, name in enumerate(names))


def _column(path: Path, number: int, name: str, texts: list[str]) -> np.ndarray:
    try:
        return np.array([_number(t) for t in texts])
    except ValueError:
        if not name.endswith("]"):
            return np.array(texts, dtype=object)
    line = next(i for i, t in enumerate(texts) if not _is_number(t)) + 2
    raise IoError(f"cannot read '{path}': line {line}, column {number} ('{name}') is no number: '{texts[line - 2]}'; run it again",
                  str(path))


def _number(text: str) -> float:
    return float(text) if text else np.nan


def _is_number(text: str) -> bool:
    try:
        _number(text)
        return True
    except ValueError:
        return False


def open(folder: str | os.PathLike) -> FolderResult:  # noqa: A001
    """Reads a results folder of any command: run, esl, sensitivity, optimize, batch, compare.

    Raises IoError for a folder that is no result, or whose files are not what liesl writes.
    """
    texts.absolute(folder)
    return FolderResult(Path(folder))
