"""Runs the program for the tests of this folder."""

import os
import resource
import signal
import subprocess
import tempfile
import time
from pathlib import Path


class Outcome:
    """How a process ended: exit code (minus the signal), what it printed, whether it was stopped."""

    def __init__(self, code, text, hung):
        self.code, self.text, self.hung = code, text, hung

    def last(self):
        lines = self.text.strip().splitlines()
        return lines[-1][:200] if lines else ""


def cpu_seconds(pid):
    """Processor time of a process, also of one that has ended but was not waited for."""
    try:
        fields = Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
    except OSError:
        return 0.0
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def wait(process, seconds):
    """Waits for so many seconds of processor time, on a busy machine up to ten times as long."""
    begin, spent = time.monotonic(), cpu_seconds(process.pid)
    while True:
        try:
            process.wait(0.02)
            return True
        except subprocess.TimeoutExpired:
            over = cpu_seconds(process.pid) - spent > seconds
            if over or time.monotonic() - begin > 10 * seconds:
                return False


def run(words, seconds, memory_mb=None, ask_after=None):
    """Runs a command in a group of its own; ends the whole group after `seconds` (see `wait`).

    With `ask_after` it is asked to stop (SIGINT) after so many seconds, and has `seconds` from then.
    """

    def limit():
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        if memory_mb:
            resource.setrlimit(resource.RLIMIT_AS, (memory_mb * 1000000,) * 2)

    with tempfile.TemporaryFile() as printed:
        process = subprocess.Popen(
            [str(w) for w in words],
            stdin=subprocess.DEVNULL,
            stdout=printed,
            stderr=subprocess.STDOUT,
            start_new_session=True,
            preexec_fn=limit,
        )
        if ask_after is not None and not wait(process, ask_after):
            process.send_signal(signal.SIGINT)
        hung = not wait(process, seconds)
        if hung:
            os.killpg(process.pid, signal.SIGKILL)
        process.wait()
        printed.seek(0)
        return Outcome(process.returncode, printed.read().decode("utf-8", "replace"), hung)


def verdict(name, failures, count):
    """Prints what failed and returns the exit code of the test."""
    for line in failures:
        print("FAILED", line)
    print(f"{name}: {count} runs, {len(failures)} failed")
    return 1 if failures or not count else 0
