"""What goes wrong: input that is refused, files, motions that have no end."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Sequence


@dataclass(frozen=True)
class Problem:
    """One thing to mend in a scene, study or argument; `what` names the key path."""

    what: str
    expected: str = ""
    hint: str = ""
    file: str = ""
    line: int = 0  #: from 1; 0: no place in a file
    column: int = 0

    def __str__(self) -> str:
        place = f"{self.file}:{self.line}:{self.column}: " if self.line else f"{self.file}: "
        text = (place if self.file else "") + self.what
        text += f"; expected {self.expected}" if self.expected else ""
        return text + (f"; hint: {self.hint}" if self.hint else "")


class InputError(ValueError):
    """Input is refused. `problems` holds everything that is wrong with it."""

    def __init__(self, problems: Sequence[Problem] | str):
        if isinstance(problems, str):
            problems = [Problem(problems)]
        self.problems = list(problems)
        super().__init__("\n".join(map(str, self.problems)))

    def __reduce__(self):
        return InputError, (self.problems,)


class IoError(OSError):
    """A file or folder cannot be read or written, or is no result. `path` names it."""

    def __init__(self, what: str, path: str = ""):
        super().__init__(what)
        self.path = path

    def __reduce__(self):
        return IoError, (str(self), self.path)


class NotConverged(RuntimeError):
    """Raised by `check()`: the task ended without what it was to find. `status` is that of the
    summary."""

    def __init__(self, status: str, reason: str):
        super().__init__(f"{status}: {reason}")
        self.status, self.reason = status, reason

    def __reduce__(self):
        return NotConverged, (self.status, self.reason)
