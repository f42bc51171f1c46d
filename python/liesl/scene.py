"""Scenes: a mechanism and its simulation, by the keys of docs/scene_reference.md."""

from __future__ import annotations

import os
import tomllib
from pathlib import Path
from typing import Any, Mapping, Sequence

from . import _liesl, texts, toml_text
from .result import Result

PathLike = str | os.PathLike


class Scene:
    """A scene, checked when it is made. It stays as it is: `change` gives another one.

    >>> scene = Scene.load("slider_crank.toml").change({"simulation.step": 5e-5})
    >>> bend = scene.run().check()["responses/bend"]       # m, (records, components)

    Scenes pickle, and several threads may run one.
    """

    def __init__(self, data: Mapping[str, Any]):
        """From a dict with the keys of the scene reference: numbers (SI units), texts, lists, NumPy
        arrays of any layout, dicts. Paths of meshes are relative to the working directory.

        Raises InputError with all `problems`, each with its key path.
        """
        self._set(toml_text.document(data), "", ())

    @classmethod
    def load(cls, path: PathLike, changes: Mapping[str, Any] | None = None) -> Scene:
        """Reads a TOML file. Raises InputError with file, line and column of all problems, IoError
        if there is no such file."""
        file = texts.absolute_input(path)
        text = texts.read(file)
        return cls._made(text, file, tuple(toml_text.changes(changes or {})))

    def change(self, values: Mapping[str, Any]) -> Scene:
        """The scene with other values, `{"sections.rod.diameter": 0.012}`; entries of lists by their
        number, `"loads.push.force.1"`. Raises InputError."""
        return self._made(self._text, self._file,
                          self._changes + tuple(toml_text.changes(values)))

    def run(self) -> Result:
        """Simulates: motion, equilibria or modes, as `simulation.type` says. A simulation that does
        not converge is a `status`; `Result.check()` raises. Ctrl-C stops it within a step."""
        return Result(self._scene.run(), source=self)

    def to_dict(self) -> dict[str, Any]:
        """All keys as they are written, changes included."""
        return tomllib.loads(self._scene.rewritten())

    def write(self, path: PathLike) -> None:
        """Writes a TOML file with the changes in it; comments stay. Paths of meshes become
        absolute if the file goes to another folder. Its first line names the schema of scenes, for
        editors. Raises IoError."""
        file = texts.absolute(path)
        text = self._moved(Path(file))._scene.rewritten()
        schema = Path(__file__).with_name("scene.json").resolve()
        line = f"#:schema {schema}\n" if schema.is_file() else ""
        _liesl.write_file(file, line + text)

    @property
    def warnings(self) -> list[str]:
        """What is accepted but looks like a mistake."""
        return self._scene.warnings()

    def _moved(self, path: Path) -> Scene:
        folder = Path(self._file).parent if self._file else Path.cwd()
        if folder.resolve() == path.absolute().parent.resolve():
            return self
        meshes = {}
        for name, body in self.to_dict().get("bodies", {}).items():
            for table, key in (("mesh", "file"), *(("matrices", k) for k in ("stiffness", "mass", "nodes", "file"))):
                file = body.get("solid", {}).get(table, {}).get(key)
                if file is not None and not os.path.isabs(file):
                    meshes[f"bodies.{name}.solid.{table}.{key}"] = str((folder / file).resolve())
        return self.change(meshes) if meshes else self

    def _differentiable(self, by: Sequence[str]) -> Any:
        return self._scene.differentiable(list(by))

    def _set(self, text: str, file: str, changes: tuple[str, ...]) -> None:
        self._text, self._file, self._changes = text, file, changes
        self._scene = _liesl.Scene(text, file, list(changes))

    @classmethod
    def _made(cls, text: str, file: str, changes: tuple[str, ...]) -> Scene:
        scene = cls.__new__(cls)
        scene._set(text, file, changes)
        return scene

    def __reduce__(self):
        return Scene._made, (self._text, self._file, self._changes)

    def __repr__(self) -> str:
        return f"Scene({self._file or '...'}{''.join(', ' + c for c in self._changes)})"
