"""Every line of bad input is a clear error: of which kind, with which place, and nothing is written."""

import json

import numpy as np
import pytest

import liesl

TETRAHEDRON = """*NODE
1, 0, 0, 0
2, 1, 0, 0
3, 0, 1, 0
4, 0, 0, 1
*ELEMENT, TYPE=C3D4
1, {cell}
*NSET, NSET=foot
1, 2, 3
*NSET, NSET=head
4
"""


def with_mesh(folder, cell="1, 2, 3, 4", interface="foot"):
    """A scene of one tetrahedron from a file."""
    (folder / "part.inp").write_text(TETRAHEDRON.format(cell=cell))
    return {
        "name": "part",
        "materials": {"steel": {"E": 210e9, "nu": 0.3, "rho": 7850}},
        "bodies": {"part": {"solid": {"material": "steel", "mesh": {"file": str(folder / "part.inp")},
                                      "interfaces": {"foot": {"set": interface}}}}},
        "simulation": {"duration": 0.01, "step": 1e-3},
    }


def test_files_that_are_not_there(tmp_path):
    for load in (liesl.Scene.load, liesl.Study.load):
        with pytest.raises(liesl.IoError, match="missing.toml") as error:
            load(tmp_path / "missing.toml")
        assert isinstance(error.value, OSError) and error.value.path.endswith("missing.toml")
        with pytest.raises(liesl.IoError):
            load(tmp_path)  # a folder


LONE = "rod \ud800"  # half of a pair of UTF-16
SHOWN = r"rod \ud800"


@pytest.mark.parametrize("keys, place", [
    ({"name": LONE}, f"'name' is '{SHOWN}'"),
    ({LONE: 1}, f"the key '{SHOWN}' is no text"),
    ({LONE: {"a": 1}}, f"the key '{SHOWN}' is no text"),
    ({"bodies": {LONE: {}}}, f"the key 'bodies.{SHOWN}' is no text"),
    ({"responses": {"tip": {"of": [0, LONE]}}}, f"'responses.tip.of.1' is '{SHOWN}'"),
])
def test_texts_that_utf8_has_not(pendulum, keys, place):
    with pytest.raises(liesl.InputError) as error:
        liesl.Scene({**pendulum, **keys})
    problem, = error.value.problems
    assert problem.what.startswith(place) and problem.expected == "Unicode without lone surrogates"
    str(error.value).encode()  # can be printed


def test_changes_that_utf8_has_not(pendulum, data):
    study = liesl.Study.load(data / "studies/slider_crank_rod.toml")
    for change in (liesl.Scene(pendulum).change, study.change):
        for values, place in (({LONE: 1}, f"the key path '{SHOWN}'"), ({"name": LONE}, f"'name' is '{SHOWN}'")):
            with pytest.raises(liesl.InputError) as error:
                change(values)
            assert error.value.problems[0].what.startswith(place)
    with pytest.raises(liesl.InputError, match="method"):
        study.optimize(method=LONE)
    with pytest.raises(liesl.InputError, match="limit"):
        study.optimize(limits={LONE: lambda at: (0.0, {})})


def test_names_that_utf8_has_not(pendulum):
    result = liesl.Scene(pendulum).run()
    with pytest.raises(KeyError, match="there is no 'rod"):
        result[LONE]
    with pytest.raises(liesl.InputError, match="by is"):
        result.jacobian("tip", by=LONE)


def test_paths_that_utf8_has_not(pendulum, tmp_path):
    scene = liesl.Scene(pendulum)
    result = scene.run()
    result.save(tmp_path / "out")
    kept = liesl.open(tmp_path / "out")
    before = sorted(tmp_path.rglob("*"))
    for call in (liesl.Scene.load, liesl.Study.load, liesl.open, scene.write, result.save, result.report, kept.report):
        for name, place in ((LONE, f"no file can have the path '{tmp_path}/{SHOWN}'"), ("a\0b", r"a\x00b' has a NUL")):
            with pytest.raises(liesl.InputError) as error:
                call(str(tmp_path / name))
            assert place in str(error.value)
    for load in (liesl.Scene.load, liesl.Study.load):
        with pytest.raises(liesl.InputError, match=r"udcff.toml' is no text of UTF-8"):
            load(tmp_path / "\udcff.toml")
    assert sorted(tmp_path.rglob("*")) == before


def test_folders_whose_names_are_bytes(pendulum, tmp_path):
    folder = tmp_path / "\udcff"
    with pytest.raises(liesl.IoError) as error:
        liesl.open(folder)
    assert error.value.path == str(folder)
    liesl.Scene(pendulum).run().save(folder)
    assert liesl.open(folder).status == "done"


def test_a_file_in_another_encoding(tmp_path):
    file = tmp_path / "latin.toml"
    file.write_bytes("# first\n# Länge ".encode() + "Länge".encode("latin-1") + b"\n")
    for load in (liesl.Scene.load, liesl.Study.load):
        with pytest.raises(liesl.InputError) as error:
            load(file)
        problem, = error.value.problems
        assert (problem.file, problem.line, problem.column) == (str(file), 2, 10)
        assert problem.what == "the byte 0xe4 is no UTF-8"


@pytest.mark.parametrize("make", [
    lambda p: None,
    lambda p: p.mkdir(),
    lambda p: (p.mkdir(), (p / "summary.json").write_text('{"of": "another program"}')),
])
def test_a_folder_that_is_no_result(tmp_path, make):
    make(tmp_path / "x")
    before = sorted(tmp_path.rglob("*"))
    with pytest.raises(liesl.IoError, match="x"):
        liesl.open(tmp_path / "x")
    assert sorted(tmp_path.rglob("*")) == before


def test_half_a_result(pendulum, tmp_path):
    liesl.Scene(pendulum).run().save(tmp_path / "out")
    results = tmp_path / "out/results.h5"
    whole = results.read_bytes()
    for spoilt in (whole[: len(whole) // 2], b"no numbers", b""):
        results.write_bytes(spoilt)
        with pytest.raises(liesl.IoError, match="results.h5': it is no HDF5 file, or not a whole one; copy the whole folder"):
            liesl.open(tmp_path / "out")
    results.write_bytes(whole.replace(b"time\0", b"tine\0"))  # the name of its link
    with pytest.raises(liesl.IoError, match="results.h5': it has no 'time'; copy the whole folder"):
        liesl.open(tmp_path / "out")
    results.unlink()
    with pytest.raises(liesl.IoError, match="results.h5 is not there"):
        liesl.open(tmp_path / "out")
    (tmp_path / "out/.liesl").unlink()
    with pytest.raises(liesl.IoError, match=".liesl is not there; copy the whole folder"):
        liesl.open(tmp_path / "out")


def test_a_table_that_was_cut_off(pendulum, tmp_path):
    liesl.Scene(pendulum).run().save(tmp_path / "out")
    table = tmp_path / "out/responses.csv"
    table.write_text(table.read_text()[:-5])
    with pytest.raises(liesl.IoError, match="responses.csv"):
        liesl.open(tmp_path / "out").tables
    with pytest.raises(liesl.IoError, match="ends within a line"):
        liesl.open(tmp_path / "out").report(tmp_path / "page.html")
    assert not (tmp_path / "page.html").exists()


def test_a_cell_that_is_no_number(pendulum, tmp_path):
    liesl.Scene(pendulum).run().save(tmp_path / "out")
    table = tmp_path / "out/responses.csv"
    lines = table.read_text().splitlines()
    lines[2] = "x" + lines[2]
    table.write_text("\n".join(lines) + "\n")
    with pytest.raises(liesl.IoError, match=r"responses.csv': line 3, column 1 \('time \[s\]'\) is no number: 'x"):
        liesl.open(tmp_path / "out").tables


def test_a_summary_that_is_no_text(pendulum, tmp_path):
    liesl.Scene(pendulum).run().save(tmp_path / "out")
    summary = tmp_path / "out/summary.json"
    summary.write_bytes(b"\xff" + summary.read_bytes())
    with pytest.raises(liesl.IoError, match="summary.json': it is no summary of liesl"):
        liesl.open(tmp_path / "out")


def test_a_foreign_or_old_version(pendulum, tmp_path):
    liesl.Scene(pendulum).run().save(tmp_path / "out")
    summary = tmp_path / "out/summary.json"
    data = json.loads(summary.read_text())
    for version in ("0.0.9", "99.0.0", None):
        data["versions"]["liesl"] = version
        summary.write_text(json.dumps(data))
        with pytest.raises(liesl.IoError, match=f"of liesl {version}"):
            liesl.open(tmp_path / "out")


def test_nan_in_a_gradient(rod):
    def objective(at):
        y = at["responses/bending"]
        return float((y ** 2).mean()), {"bending": np.full_like(y, np.nan)}
    with pytest.raises(liesl.InputError, match="objective"):
        rod.nlp(objective=objective).gradient(rod.x0)
    nlp = liesl.Nlp([("x", -1, 1, 0.5)], lambda x: x[0] ** 2, lambda x: [np.nan])
    with pytest.raises(liesl.InputError, match="by 'x' is nan"):
        liesl.minimize(nlp)


@pytest.mark.parametrize("key, value, place", [
    ("gravity", "down", "gravity"),
    ("gravity", [0, "one", 0], "gravity"),
    ("simulation", 3, "simulation"),
    ("simulation", {"duration": "long", "step": 1e-3}, "simulation.duration"),
    ("bodies", [], "bodies"),
    ("name", None, "name"),
])
def test_a_scene_dict_of_wrong_types(pendulum, key, value, place):
    pendulum[key] = value
    with pytest.raises(liesl.InputError, match=place):
        liesl.Scene(pendulum)


def test_an_empty_scene():
    with pytest.raises(liesl.InputError, match="the dict is empty; expected the keys of a scene"):
        liesl.Scene({})


def test_an_objective_of_nan_at_the_start(rod):
    nan = lambda at: (np.nan, {})  # noqa: E731
    with pytest.raises(liesl.InputError, match="the objective is nan at the start"):
        rod.optimize(objective=nan)
    found = liesl.minimize(rod.nlp(objective=nan))
    assert found.status == "stopped"
    with pytest.raises(liesl.NotConverged):
        found.check()


def test_what_holds_itself(pendulum):
    whole = dict(pendulum)
    whole["bodies"] = whole
    with pytest.raises(liesl.InputError, match="'bodies' holds itself"):
        liesl.Scene(whole)
    beam = pendulum["bodies"]["rod"]["beam"]
    beam["beam"] = beam
    with pytest.raises(liesl.InputError, match="'bodies.rod.beam.beam' holds itself"):
        liesl.Scene(pendulum)
    del beam["beam"]
    ring = [1, 0]
    ring.append(ring)
    pendulum["bodies"]["rod"]["beam"]["to"] = ring
    with pytest.raises(liesl.InputError, match="'bodies.rod.beam.to.2' holds itself"):
        liesl.Scene(pendulum)
    beam["to"] = [1, 0, 0]
    with pytest.raises(liesl.InputError, match="holds itself"):
        liesl.Scene(pendulum).change({"gravity": ring})
    deep = []
    for _ in range(5000):
        deep = [deep]
    with pytest.raises(liesl.InputError, match="50 lists"):
        liesl.Scene({**pendulum, "gravity": deep})


def test_one_list_in_two_places_is_fine(pendulum):
    point = [1, 0, 0]
    pendulum["bodies"]["rod"]["beam"]["to"] = point
    pendulum["loads"] = {"push": {"at": "rod.end", "force": point}}
    assert liesl.Scene(pendulum).run().status == "done"


def test_arrays_of_any_layout(pendulum, rod):
    pendulum["bodies"]["rod"]["beam"]["to"] = np.asfortranarray(np.eye(3))[::-1, :][2]
    result = liesl.Scene(pendulum).run()
    weights = np.zeros((len(result.time), 6))[:, ::2]
    assert not weights.flags["C_CONTIGUOUS"]
    weights[-1, 1] = 1
    same = np.ascontiguousarray(weights)
    keys = ["sections.round.diameter"]
    assert np.array_equal(result.vjp({"tip": weights}, by=keys), result.vjp({"tip": same}, by=keys))
    x = np.repeat(rod.x0, 2)[::2]
    assert rod.evaluate(x).objective == rod.evaluate(rod.x0).objective


@pytest.mark.parametrize("what", [3, None, "study", [], lambda x: x])
def test_what_is_no_program(what):
    with pytest.raises(TypeError, match="minimize takes an Nlp"):
        liesl.minimize(what)


def test_a_mesh_with_an_inverted_tetrahedron(tmp_path):
    with pytest.raises(liesl.InputError, match="inverted or flat") as error:
        liesl.Scene(with_mesh(tmp_path, cell="1, 3, 2, 4"))
    assert any(p.file.endswith("part.inp") and p.line == 7 for p in error.value.problems)
    assert sorted(f.name for f in tmp_path.iterdir()) == ["part.inp"]


def test_a_node_set_that_is_not_there(tmp_path):
    with pytest.raises(liesl.InputError, match="fot") as error:
        liesl.Scene(with_mesh(tmp_path, interface="fot"))
    assert "foot" in str(error.value)


def test_arguments_are_refused_by_what_was_expected(pendulum, rod):
    for variables in (["x"], [3], [("x", 0, 1)], [("x", "low", 1, 0)]):
        with pytest.raises(liesl.InputError, match="a variable is .*; expected .name, lower, upper, start"):
            liesl.Nlp(variables, lambda x: 0.0, lambda x: x)
    with pytest.raises(liesl.InputError, match="limits is .1.; expected a function of an Evaluation by name"):
        rod.nlp(limits=[1])
    result = liesl.Scene(pendulum).run()
    for by in (3, [3]):
        with pytest.raises(liesl.InputError, match="by is .*; expected a key of the scene"):
            result.jacobian("tip", by=by)
    with pytest.raises(liesl.InputError, match="^change simulation.step=0: 'simulation.step' is out of range"):
        liesl.Scene(pendulum).change({"simulation.step": 0})


def test_errors_speak_of_arguments_not_of_options(pendulum, rod, tmp_path):
    """Of `by`, `overwrite` and keys; the command line has --by, --force and --set there."""
    scene = liesl.Scene(pendulum)
    result = scene.run()
    for by in (None, [], ()):
        with pytest.raises(liesl.InputError, match="^by which parameters.; expected a key of the scene"):
            result.jacobian("tip", by=by)
    with pytest.raises(liesl.InputError, match="^by bodiess.x: .*bodiess"):
        result.jacobian("tip", by="bodiess.x")
    result.save(tmp_path / "out")
    with pytest.raises(liesl.IoError, match="an earlier result; overwrite=True replaces it"):
        result.save(tmp_path / "out")
    with pytest.raises(liesl.InputError, match="^change cycle.method=.*expected one of"):
        rod.optimize(method="simplex")


def test_designs_of_a_program_have_a_number_for_each_variable(rod):
    """Also those that its methods are handed, which are clipped to the bounds."""
    nlp = rod.nlp()
    for x in ([1.0, 2.0], np.zeros((2, 4)), "0.01", None):
        for method in (nlp.objective, nlp.gradient, nlp.constraints, nlp.jacobian):
            with pytest.raises(liesl.InputError, match="x has shape|x is no array of numbers"):
                method(x)
