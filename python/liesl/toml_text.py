"""Python values as TOML, in which the program reads them: one reader, one validator."""

from __future__ import annotations

from typing import Any, Mapping

import numpy as np

from .errors import InputError, Problem
from .texts import UNICODE, shown

_EXPECTED = "a number, text, True or False, list, array or dict"
_DEEPEST = 50  # levels of lists and dicts; the keys of a scene need six


def _text(value: str) -> str:
    escaped = value.replace("\\", "\\\\").replace('"', '\\"')
    return '"' + "".join(c if c >= " " and c != "\x7f" else f"\\u{ord(c):04x}"
                         for c in escaped) + '"'


def _number(value: int | float) -> str:
    if isinstance(value, int):
        return str(value)
    if value != value:
        return "nan"
    return repr(value) if abs(value) != float("inf") else ("inf" if value > 0 else "-inf")


def _value(value: Any, path: str, problems: list[Problem], above: tuple[int, ...] = ()) -> str:
    """@param above: ids of the lists and dicts that hold it"""
    if isinstance(value, (np.ndarray, np.generic)):
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (int, float)):
        return _number(value)
    if isinstance(value, str):
        if shown(value) != value:
            problems.append(Problem(f"'{path}' is '{shown(value)}'", UNICODE))
        return _text(value)
    if isinstance(value, (list, tuple, Mapping)):
        if id(value) in above:
            problems.append(Problem(f"'{path}' holds itself", _EXPECTED))
            return "0"
        if len(above) >= _DEEPEST:
            problems.append(Problem(f"'{path[:60]}...' lies in more than {_DEEPEST} lists and dicts", _EXPECTED))
            return "0"
        above += (id(value),)
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join([_value(v, f"{path}.{i}", problems, above)
                                for i, v in enumerate(value)]) + "]"
    if isinstance(value, Mapping):
        return "{" + ", ".join([f"{_key(k, path, problems)} = {_value(v, _join(path, k), problems, above)}"
                                for k, v in value.items()]) + "}"
    problems.append(Problem(f"'{path}' is of type {type(value).__name__}", _EXPECTED))
    return "0"


def _join(path: str, key: Any) -> str:
    return f"{path}.{shown(str(key))}" if path else shown(str(key))


def _key(key: Any, path: str, problems: list[Problem]) -> str:
    if isinstance(key, str):
        if shown(key) != key:
            problems.append(Problem(f"the key '{_join(path, key)}' is no text of UTF-8", UNICODE))
        return _text(key)
    problems.append(Problem(f"'{_join(path, key)}': a key is of type {type(key).__name__}",
                            "a text"))
    return '"0"'


def document(data: Mapping[str, Any]) -> str:
    """A whole file, a top-level key or entry a line.

    Raises InputError with the key path of everything that TOML cannot hold.
    """
    if not isinstance(data, Mapping):
        raise InputError(f"a {type(data).__name__} is given; expected a dict with the keys of a "
                         "scene")
    if not data:
        raise InputError("the dict is empty; expected the keys of a scene")
    problems: list[Problem] = []
    lines = []
    above = (id(data),)
    for key, value in data.items():
        if not isinstance(value, Mapping) or value is data:
            lines.insert(0, f"{_key(key, '', problems)} = {_value(value, _join('', key), problems, above)}")
            continue
        lines.append(f"\n[{_key(key, '', problems)}]")
        inside = (*above, id(value))
        name = _join("", key)
        lines += [f"{_key(k, name, problems)} = {_value(v, _join(name, k), problems, inside)}"
                  for k, v in value.items()]
    if problems:
        raise InputError(problems)
    return "\n".join(lines) + "\n"


def changes(values: Mapping[str, Any]) -> list[str]:
    """Changes by key path, as `--set` takes them."""
    if not isinstance(values, Mapping):
        raise InputError(f"a {type(values).__name__} is given; expected a dict of key paths, as "
                         '{"simulation.step": 1e-4}')
    problems: list[Problem] = []
    for path in values:
        if not isinstance(path, str):
            problems.append(Problem(f"the key path {path!r} is no text", '"simulation.step"'))
        elif shown(path) != path:
            problems.append(Problem(f"the key path '{shown(path)}' is no text of UTF-8", UNICODE))
    out = [f"{path}={_value(value, _join('', path), problems)}" for path, value in values.items()]
    if problems:
        raise InputError(problems)
    return out
