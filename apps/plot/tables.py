"""CSV tables of a results folder, by columns."""

import csv
import io
import math
import re


class NothingToDraw(Exception):
    """The folder does not hold what a picture needs; the text says what."""


class HalfResult(NothingToDraw):
    """A file of the folder is not whole; the text says which and where."""

    def __init__(self, path, what):
        super().__init__(f"{path} is not whole: {what}; run it again")


class Table:
    """A CSV file by columns: `names` and `units` from headings like `bend [m]`."""

    def __init__(self, path):
        with open(path, newline="", encoding="utf-8", errors="replace") as file:
            text = file.read()
        rows = [row for row in csv.reader(io.StringIO(text, newline="")) if row]
        if not rows:
            raise NothingToDraw(f"{path} is empty")
        if not text.endswith("\n"):
            raise HalfResult(path, f"it ends within line {len(rows)}")
        for n, row in enumerate(rows):
            if len(row) != len(rows[0]):
                raise HalfResult(path, f"row {n} has {len(row)} cells, the heading {len(rows[0])}")
        parts = [re.fullmatch(r"(.*?)(?: \[(.*)\])?", heading) for heading in rows[0]]
        self.names = [part.group(1) for part in parts]
        self.units = [part.group(2) or "" for part in parts]
        self.rows, self.path = rows[1:], path

    def text(self, name):
        i = self.names.index(name)
        return [row[i] for row in self.rows]

    def numbers(self, name, gaps=False):
        """Raises NothingToDraw for what is none, with its place. @param gaps NaN where a cell is empty"""
        found = []
        for line, text in enumerate(self.text(name), 2):
            try:
                found.append(math.nan if gaps and not text else float(text))
            except ValueError:
                raise NothingToDraw(f"{self.path}: '{text}' of column '{name}' in line {line} is no number; run it again") from None
        return found

    def check_numbers(self, names, gaps=False):
        """Raises NothingToDraw if any of the columns has a cell that is no number."""
        for name in names:
            self.numbers(name, gaps)

    def unit(self, name):
        return self.units[self.names.index(name)]


def table(folder, name):
    """The table, or None if there is no such file or no row in it."""
    path = folder / name
    if not path.exists():
        return None
    found = Table(path)
    return found if found.rows else None


def is_number(text):
    try:
        return math.isfinite(float(text))
    except ValueError:
        return False
