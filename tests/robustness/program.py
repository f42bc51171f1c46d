"""Runs the program for the tests of this folder."""

import os
import resource
import signal
import subprocess
from pathlib import Path


class Outcome:
    """How a process ended: exit code (minus the signal), what it printed, whether it was stopped."""

    def __init__(self, code, text, hung):
        self.code, self.text, self.hung = code, text, hung

    def last(self):
        lines = self.text.strip().splitlines()
        return lines[-1][:200] if lines else ""


def run(words, seconds, memory_mb=None, cwd=None, ask_after=None):
    """Runs a command in a group of its own; ends the whole group after `seconds`.

    With `ask_after` it is asked to stop (SIGINT) after so many seconds, and has `seconds` from then on.
    """

    def limit():
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        if memory_mb:
            resource.setrlimit(resource.RLIMIT_AS, (memory_mb * 1000000,) * 2)

    process = subprocess.Popen(
        [str(w) for w in words],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        cwd=cwd,
        start_new_session=True,
        preexec_fn=limit,
    )
    hung = False
    if ask_after is not None:
        try:
            process.communicate(timeout=ask_after)
        except subprocess.TimeoutExpired:
            process.send_signal(signal.SIGINT)
    try:
        out, _ = process.communicate(timeout=seconds)
    except subprocess.TimeoutExpired:
        hung = True
        os.killpg(process.pid, signal.SIGKILL)
        out, _ = process.communicate()
    return Outcome(process.returncode, out.decode("utf-8", "replace"), hung)


def verdict(name, failures, count):
    """Prints what failed and returns the exit code of the test."""
    for line in failures:
        print("FAILED", line)
    print(f"{name}: {count} runs, {len(failures)} failed")
    return 1 if failures or not count else 0
