"""Texts and paths that the program can take: those that UTF-8 has."""

from __future__ import annotations

import os

from . import _liesl
from .errors import InputError, Problem

UNICODE = "Unicode without lone surrogates"


def shown(text: str) -> str:
    r"""Lone surrogates escaped, "\ud800": what differs from its text is none that UTF-8 has."""
    return text.encode("utf-8", "backslashreplace").decode()


def absolute(path: str | os.PathLike) -> str:
    """The path from the root. Raises InputError for one that no file can have."""
    text = os.fsdecode(os.path.abspath(path))
    if "\0" in text:
        raise InputError([Problem(f"the path {text!r} has a NUL", "a path without")])
    try:
        os.fsencode(text)
    except UnicodeEncodeError:
        raise InputError([Problem(f"no file can have the path '{shown(text)}'",
                                  "a path in " + UNICODE)]) from None
    return text


def absolute_input(path: str | os.PathLike) -> str:
    """The same of a file that results name. Raises InputError for one that UTF-8 has not, too."""
    text = absolute(path)
    if shown(text) != text:
        raise InputError([Problem(f"the path '{shown(text)}' is no text of UTF-8", "a path in UTF-8",
                                  "rename the file or folder")])
    return text


def read(file: str) -> str:
    """The text of a file. Raises InputError for bytes that are no UTF-8, with their place, IoError."""
    try:
        return _liesl.read_file(file)
    except UnicodeDecodeError as error:
        before = error.object[:error.start]
        line = before[before.rfind(b"\n") + 1:].decode()
        raise InputError([Problem(f"the byte 0x{error.object[error.start]:02x} is no UTF-8",
                                  "a text in UTF-8", "save the file in UTF-8", file,
                                  before.count(b"\n") + 1, len(line) + 1)]) from None
