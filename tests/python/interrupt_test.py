"""Ctrl-C ends what runs within 0.1 s (medians), and leaves Python as it was."""

import os
import signal
import statistics
import threading
import time

import numpy as np
import pytest

import liesl


def delay(work, after=0.3):
    """Seconds from the signal to its exception."""
    sent = []

    def interrupt():
        sent.append(time.perf_counter())
        os.kill(os.getpid(), signal.SIGINT)

    timer = threading.Timer(after, interrupt)
    timer.start()
    try:
        with pytest.raises(KeyboardInterrupt):
            work()
        return time.perf_counter() - sent[0]
    finally:
        timer.cancel()


def soon(work):
    """The median of five: another process may hold the processor once or twice."""
    delays = [delay(work) for _ in range(5)]
    print("seconds to the exception:", ", ".join(f"{d:.3f}" for d in sorted(delays)))
    return statistics.median(delays) <= 0.1


def test_a_simulation(pendulum):
    pendulum["simulation"]["duration"] = 100
    scene = liesl.Scene(pendulum)
    assert soon(scene.run)
    assert scene.change({"simulation.duration": 0.01}).run().check()


def test_derivatives(pendulum):
    pendulum["simulation"]["duration"] = 40
    result = liesl.Scene(pendulum).run()
    motion, _ = result._differentiable("materials.steel.E")
    assert soon(motion.derivatives)
    assert soon(lambda: motion.pull_back([np.ones((40001, 1)), None]))


def test_an_optimisation(data):
    study = liesl.Study.load(data / "studies/slider_crank_rod.toml", {"simulation.step": 1e-5})
    assert soon(study.optimize)


def test_one_s_own_functions(rod):
    def slow(at):
        time.sleep(0.02)
        return at.objective, {"x": rod.mass_gradient(at.x)}

    assert soon(lambda: liesl.minimize(rod.nlp(objective=slow), tolerance=1e-12))
