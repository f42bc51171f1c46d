"""`liesl.open` reads what the commands of the program leave."""

import os
import subprocess

import numpy as np
import pytest

import liesl

SHORT = ["--set", "simulation.duration=0.005"]


@pytest.fixture
def command(data, tmp_path):
    def run(*words):
        subprocess.run([os.environ["LIESL_PROGRAM"], *map(str, words), "-o", tmp_path / "out",
                        "--quiet"], check=True, cwd=tmp_path)
        return liesl.open(tmp_path / "out")
    return run


def test_run_is_what_python_runs(data, command):
    path = data / "scenes/slider_crank.toml"
    folder = command("run", path, *SHORT)
    result = liesl.Scene.load(path, {"simulation.duration": 0.005}).run()
    assert sorted(folder) == sorted(result)
    assert all(np.array_equal(folder[name], result[name]) for name in result)


def test_esl(data, command):
    folder = command("esl", data / "scenes/slider_crank.toml", *SHORT)
    assert folder["loads/rod"].shape == (len(folder.time), 9, 6)
    assert folder.unit("loads/rod").startswith("N")


def test_sensitivity(data, command):
    folder = command("sensitivity", data / "scenes/slider_crank.toml", "--by",
                     "sections.rod.diameter", "--method", "direct", *SHORT)
    result = liesl.Scene.load(data / "scenes/slider_crank.toml",
                              {"simulation.duration": 0.005}).run()
    assert folder["sensitivities/bend"] == pytest.approx(
        result.jacobian("bend", by="sections.rod.diameter"), rel=1e-12)


def test_batch(data, command, tmp_path):
    (tmp_path / "two.toml").write_text(
        f'name = "two"\nscene = "{data}/scenes/pendulum.toml"\n'
        '[grid]\nduration = { key = "simulation.duration", values = [0.01, 0.02] }\n')
    half = command("batch", "two.toml", "--shard", "1/2")
    assert half.status == "incomplete"
    folder = command("batch", "two.toml")
    assert list(folder.tables["results"]["duration"]) == [0.01, 0.02]
    assert list(folder.tables["results"]["status"]) == ["done", "done"]
    assert folder["cases/2/time"][-1] == pytest.approx(0.02)
