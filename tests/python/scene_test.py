"""Scenes from dicts and files: one reader, one validator, errors with key paths."""

import pickle
import tomllib
from pathlib import Path

import numpy as np
import pytest

import liesl


def same(a, b):
    return list(a) == list(b) and all(np.array_equal(a[name], b[name]) for name in a)


def test_dict_and_file_give_the_same_numbers(data):
    path = data / "scenes/slider_crank.toml"
    changes = {"simulation.duration": 0.01}
    from_file = liesl.Scene.load(path, changes).run()
    from_dict = liesl.Scene(tomllib.loads(path.read_text())).change(changes).run()
    assert from_file.check() and same(from_file, from_dict)


def test_change_gives_another_scene(pendulum):
    scene = liesl.Scene(pendulum)
    shorter = scene.change({"simulation.duration": 0.01, "joints.pin.axis": np.array([0, 0, -1])})
    assert shorter.to_dict()["simulation"]["duration"] == 0.01
    assert shorter.to_dict()["joints"]["pin"]["axis"] == [0, 0, -1]
    assert scene.to_dict()["simulation"]["duration"] == 0.02
    assert shorter.run().time[-1] == pytest.approx(0.01)


def test_arrays_of_any_layout_and_numpy_numbers(pendulum):
    plain = liesl.Scene(pendulum).run()
    pendulum["bodies"]["rod"]["beam"]["to"] = np.array([[1.0, 9], [0, 9], [0, 9]])[:, 0]
    pendulum["bodies"]["rod"]["beam"]["elements"] = np.int64(4)
    pendulum["simulation"]["step"] = np.float64(1e-3)
    assert same(liesl.Scene(pendulum).run(), plain)


def test_texts_survive(pendulum):
    name = 'a "quoted" \\ name\n of two lines, with é'
    pendulum["name"] = name
    scene = liesl.Scene(pendulum)
    assert scene.to_dict()["name"] == name and scene.run().summary["name"] == name


def test_all_problems_at_once_with_key_paths(pendulum):
    pendulum["sections"]["round"]["diametr"] = 1
    pendulum["simulation"]["step"] = "fast"
    pendulum["bodies"]["rod"]["beam"]["to"] = [1, 0, float("nan")]
    with pytest.raises(liesl.InputError) as error:
        liesl.Scene(pendulum)
    what = [p.what for p in error.value.problems]
    for key in ("sections.round.diametr", "simulation.step", "bodies.rod.beam.to"):
        assert any(key in w for w in what), key
    assert all(p.line == 0 for p in error.value.problems)
    assert isinstance(error.value, ValueError)
    assert any("diameter" in p.hint for p in error.value.problems)


@pytest.mark.parametrize("value", [None, object(), 1j, b"bytes", {1, 2}])
def test_values_that_toml_has_not(pendulum, value):
    pendulum["bodies"]["rod"]["beam"]["to"] = [1, value, 0]
    pendulum["name"] = value
    with pytest.raises(liesl.InputError) as error:
        liesl.Scene(pendulum)
    assert len(error.value.problems) == 2
    assert "'bodies.rod.beam.to.1'" in str(error.value) and "'name'" in str(error.value)


@pytest.mark.parametrize("data", [None, [], "name = 1", 3, {}, {1: 2}, {"bodies": {2: {}}}])
def test_what_is_no_scene(data):
    with pytest.raises(liesl.InputError):
        liesl.Scene(data)


def test_changes_that_are_none(pendulum):
    scene = liesl.Scene(pendulum)
    for changes in ({"simulation.stp": 1}, {"bodies.arm.beam.elements": 3}, {3: 1}, [1],
                    {"simulation.step": None}):
        with pytest.raises(liesl.InputError):
            scene.change(changes)


def test_file_problems_have_lines(tmp_path):
    path = tmp_path / "scene.toml"
    path.write_text("name = 'x'\n[bodies]\nrod = { beem = 1 }\n")
    with pytest.raises(liesl.InputError) as error:
        liesl.Scene.load(path)
    assert any(p.line == 3 and p.file == str(path) for p in error.value.problems)


def test_write_keeps_comments_and_numbers(data, tmp_path):
    scene = liesl.Scene.load(data / "scenes/slider_crank.toml", {"simulation.duration": 0.005})
    scene.write(tmp_path / "copy.toml")
    comment = next(line for line in (data / "scenes/slider_crank.toml").read_text().splitlines()
                   if line.startswith("# ") )
    assert comment in (tmp_path / "copy.toml").read_text()
    assert same(liesl.Scene.load(tmp_path / "copy.toml").run(), scene.run())


def test_write_names_the_schema_of_scenes(data, pendulum, tmp_path):
    for scene in (liesl.Scene.load(data / "scenes/slider_crank.toml"), liesl.Scene(pendulum)):
        scene.write(tmp_path / "copy.toml")
        first, rest = (tmp_path / "copy.toml").read_text().split("\n", 1)
        word, schema = first.split(" ", 1)
        assert word == "#:schema" and word not in rest
        assert Path(schema).read_text() == (data / "schema/scene.json").read_text()


def test_write_elsewhere_finds_its_mesh(data, tmp_path):
    scene = liesl.Scene.load(data / "scenes/meshed_slider_crank.toml",
                             {"simulation.duration": 0.001})
    scene.write(tmp_path / "copy.toml")
    assert same(liesl.Scene.load(tmp_path / "copy.toml").run(), scene.run())


def test_pickle(pendulum):
    scene = liesl.Scene(pendulum).change({"simulation.step": 5e-4})
    assert same(pickle.loads(pickle.dumps(scene)).run(), scene.run())


def test_errors_pickle(pendulum):
    with pytest.raises(liesl.InputError) as error:
        liesl.Scene({**pendulum, "gravty": [0, 0, 0]})
    copy = pickle.loads(pickle.dumps(error.value))
    assert copy.problems == error.value.problems
    assert str(pickle.loads(pickle.dumps(liesl.IoError("no", "x")))) == "no"


def test_a_scene_without_a_name(pendulum, tmp_path):
    """It is called as its file is; of a dict as the key is by default."""
    nameless = {key: value for key, value in pendulum.items() if key != "name"}
    scene = liesl.Scene(nameless)
    assert scene.run().summary["name"] == "scene"
    scene.write(tmp_path / "my pendulum.toml")
    read = liesl.Scene.load(tmp_path / "my pendulum.toml")
    assert read.run().summary["name"] == "my pendulum"
    assert read.change({"name": "other"}).run().summary["name"] == "other"
    assert "name" not in read.to_dict()
