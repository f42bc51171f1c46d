"""Runs of the program that figures are taken of, each once."""

import csv
import json
import math
import os
import subprocess
import xml.etree.ElementTree
from pathlib import Path


class Result:
    """A results folder of `liesl run`, `optimize` or `batch`."""

    def __init__(self, folder):
        self.folder = Path(folder)
        self.summary = json.loads((self.folder / "summary.json").read_text())

    def cases(self):
        """Of a batch: the result of each case."""
        return [Result(path.parent) for path in sorted((self.folder / "cases").glob("*/summary.json"))]

    def largest(self, response):
        return self.summary["responses"][response]["max_abs"]

    def final(self, response):
        return self.summary["responses"][response]["final"]

    def column(self, name):
        """(abscissa, values) of a response in responses.csv, "tip.x" of a vector."""
        with open(self.folder / "responses.csv", newline="") as file:
            rows = list(csv.reader(file))
        names = [cell.partition(" [")[0] for cell in rows[0]]
        at = names.index(name)
        return [float(row[0]) for row in rows[1:]], [float(row[at]) for row in rows[1:]]

    def at(self, response, time, axes="xyz"):
        """Components of a vector at a recorded time. @throws LookupError if there is no such record"""
        out = []
        for axis in axes:
            times, values = self.column(f"{response}.{axis}")
            nearest = min(range(len(times)), key=lambda i: abs(times[i] - time))
            if not math.isclose(times[nearest], time, rel_tol=1e-9):
                raise LookupError(f"{self.folder.name}: nothing is recorded at {time} s")
            out.append(values[nearest])
        return out


class Runner:
    """Runs scenes and studies of `data` into `work`, the same changes once; `solved` may hold folders of studies
    as shipped, which are taken instead of solving them again."""

    def __init__(self, program, data, work, solved=None):
        self.program, self.data, self.work, self.solved = program, Path(data), Path(work), solved
        self.known = {}

    def __call__(self, command, file, *changes, words=(), kernel=None):
        """@param file "scenes/pendulum"  @param changes keys, "simulation.step=1e-4"  @param words further options
        @param kernel of OpenBLAS, for figures of a path that rounding decides; else that of the processor"""
        key = (command, file, changes, tuple(words), kernel)
        if key not in self.known:
            self.known[key] = Result(self.folder(command, file, changes, words, kernel))
        return self.known[key]

    def properties(self, test):
        """What a test of test_apps, which lies beside the program, records: name -> number. It reads the studies that are solved."""
        if test in self.known:
            return self.known[test]
        tests, report = Path(self.program).parent / "test_apps", self.work / "properties.xml"
        if not tests.exists():
            raise LookupError(f"{test}: there is no {tests}")
        done = subprocess.run([tests, f"--gtest_filter={test}", f"--gtest_output=xml:{report}"], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise LookupError(f"{test}: {done.stdout.strip()[-300:]}")
        self.known[test] = {p.get("name"): float(p.get("value")) for p in xml.etree.ElementTree.parse(report).iter("property")}
        return self.known[test]

    def folder(self, command, file, changes, words, kernel):
        shipped = self.solved and Path(self.solved) / Path(file).name
        if command == "optimize" and not changes and not words and shipped and (shipped / "summary.json").exists():
            return shipped
        folder = self.work / f"{len(self.known)}_{Path(file).name}"
        line = [self.program, command, f"{self.data / file}.toml", "-o", folder, "--quiet", "--force", "--no-report", *words]
        for change in changes:
            line += ["--set", change]
        environment = {**os.environ, "OPENBLAS_CORETYPE": kernel} if kernel else None
        done = subprocess.run(line, capture_output=True, text=True, check=False, env=environment)
        if not (folder / "summary.json").exists():
            raise LookupError(f"liesl {command} {file} {' '.join(changes)}: {done.stderr.strip()[-300:]}")
        return folder
