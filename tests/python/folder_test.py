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


def test_loads_of_every_cycle_are_those_of_esl(data, command, tmp_path):
    """The cycle of the final design has the loads that `liesl esl` finds for it."""
    folder = command("optimize", data / "studies/slider_crank_rod.toml", "--no-verify", "--no-report",
                     "--set", "scene.simulation.duration=0.04")
    table = {name.split(" [")[0]: column for name, column in folder.tables["cycle_loads"].items()}
    history, final = folder.summary["history"], list(folder.summary["design"].values())
    assert set(table["cycle"]) == {h["cycle"] for h in history}
    assert set(table["body"]) == {"rod"}
    cycle = next(h["cycle"] for h in history if h["design"] == final)
    subprocess.run([os.environ["LIESL_PROGRAM"], "esl", tmp_path / "out/design.toml", "-o", tmp_path / "esl", "--quiet"], check=True)
    esl = liesl.open(tmp_path / "esl")
    rows = table["cycle"] == cycle
    kept = np.array([table[c][rows] for c in ("Fx", "Fy", "Fz", "Mx", "My", "Mz")]).T.reshape(-1, 9, 6)
    times = table["time"][rows].reshape(-1, 9)[:, 0]
    assert 1 <= len(times) <= 3
    records = [int(np.argmin(np.abs(esl.time - t))) for t in times]
    assert esl.time[records] == pytest.approx(times, abs=1e-9)
    assert kept == pytest.approx(esl["loads/rod"][records], abs=1e-4 * np.abs(kept).max())
    worst = next(h["worst_at"] for h in history if h["cycle"] == cycle)
    assert any(worst == f"t = {t:.6g} s" for t in times)
