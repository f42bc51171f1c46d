"""Studies: evaluation, the nonlinear program, optimisation by four ways, bad functions."""

import os
import pickle
import subprocess

import numpy as np
import pytest

import liesl
from conftest import DATA


def test_what_it_varies(rod):
    assert [v.name for v in rod.variables] == [f"rod_diameters[{i}]" for i in range(4)]
    assert rod.bounds.shape == (4, 2) and rod.limits == [("bending", 1e-3)]
    assert rod.scenarios == [""]


def test_evaluations_are_kept(rod):
    at = rod.evaluate()
    assert rod.evaluate(rod.x0.copy()) is at and rod.evaluate(rod.x0 * 1.01) is not at
    assert at.objective == pytest.approx(7850 * 0.3 * np.pi / 4 * rod.x0[0] ** 2, rel=1e-12)
    assert at.limits["bending"] == abs(at["responses/bending"]).max()
    assert at.worst == pytest.approx(at.limits["bending"] / 1e-3 - 1)


def test_mass_gradient_is_that_of_a_circle(rod):
    expected = 7850 * 0.075 * np.pi / 2 * rod.x0
    assert rod.mass_gradient(rod.x0) == pytest.approx(expected, rel=1e-10)


def test_jacobian_of_a_design(rod):
    at = rod.evaluate()
    jacobian, h = at.jacobian("bending"), 1e-7
    assert jacobian.shape == (len(at.time), 1, 4)
    for i in range(4):
        e = h * np.eye(4)[i]
        moved = [rod.evaluate(rod.x0 + s * e)["responses/bending"] for s in (1, -1)]
        difference = (moved[0] - moved[1])[:, 0] / (2 * h)
        assert abs(jacobian[:, 0, i] - difference).max() <= 1e-4 * abs(difference).max()
    with pytest.raises(liesl.InputError, match="variables"):
        at.jacobian("bending", by="materials.steel.E")


def test_rows_of_the_program(rod):
    nlp = rod.nlp(windows=3)
    assert nlp.rows == ["bending[0]", "bending[1]", "bending[2]"]
    g = nlp.constraints(nlp.x0)
    assert g.max() == pytest.approx(rod.evaluate().worst, rel=1e-12)
    jacobian, h = nlp.jacobian(nlp.x0), 1e-8  # the peaks stay at their records
    for i in range(4):
        e = h * np.eye(4)[i]
        difference = (nlp.constraints(nlp.x0 + e) - nlp.constraints(nlp.x0 - e)) / (2 * h)
        assert jacobian[:, i] == pytest.approx(difference, rel=1e-2)
    for windows in (0, -1, 1.5, True, "2", 10**9):
        with pytest.raises(liesl.InputError, match="windows"):
            rod.nlp(windows=windows)


def test_four_ways_to_one_optimum(rod):
    scipy = pytest.importorskip("scipy.optimize")
    seen = []
    best = rod.optimize(on_cycle=lambda so_far: seen.append(len(so_far["history"]))).check()
    assert best.status == "optimal" and seen == list(range(1, len(best.history) + 1))
    mass = best.summary["mass_final"]
    assert best.x.shape == (4,) and rod.evaluate(best.x).objective == pytest.approx(mass)
    by_ipopt = liesl.minimize(rod.nlp()).check()
    by_scipy = scipy.minimize(method="SLSQP", **rod.nlp().scipy())
    full = rod.optimize(method="full").check()
    assert by_ipopt.f == pytest.approx(mass, rel=2e-3)
    assert by_scipy.success and by_scipy.fun == pytest.approx(by_ipopt.f, rel=1e-4)
    assert full.summary["mass_final"] == pytest.approx(mass, rel=2e-3)


def test_scipy_shortens_steps_to_designs_without_a_motion(rod):
    """With four windows a step of SLSQP is to a rod so thin that an element of order 2 of it turns by pi."""
    scipy = pytest.importorskip("scipy.optimize")
    nlp = rod.change({"scene.simulation.duration": 0.08, "scene.bodies.rod.beam.order": 2}).nlp(windows=4)
    tried = []
    arguments = nlp.scipy()
    rows, = arguments["constraints"]
    values = rows["fun"]
    rows["fun"] = lambda x: tried.append(values(x)) or tried[-1]
    found = scipy.minimize(method="SLSQP", **arguments)
    assert any(np.isneginf(row).all() for row in tried)
    assert found.success and found.fun == pytest.approx(liesl.minimize(nlp).check().f, rel=1e-4)


def test_methods_are_those_that_cyipopt_calls(rod):
    """cyipopt is no package of Debian 12. Its Problem(n, m, problem_obj) calls four methods with an array of its own and
    flattens what they return, a Jacobian without structure row by row: so read, SciPy finds the optimum of our Ipopt."""
    scipy = pytest.importorskip("scipy.optimize")
    nlp = rod.nlp(windows=2)
    n, m = len(nlp.variables), len(nlp.rows)
    assert n != m, "a Jacobian by columns would be seen"
    assert not any(hasattr(nlp, name) for name in ("jacobianstructure", "hessian", "hessianstructure", "intermediate"))

    def flat(method, size):
        def call(x):
            own = np.array(x)
            values = np.array(method(own), dtype=float).flatten()
            assert values.size == size and np.array_equal(own, x)
            return values
        return call

    rows = {"type": "ineq", "fun": lambda x: -flat(nlp.constraints, m)(x),
            "jac": lambda x: -flat(nlp.jacobian, m * n)(x).reshape(m, n)}
    best = scipy.minimize(lambda x: flat(nlp.objective, 1)(x)[0], nlp.x0, jac=flat(nlp.gradient, n), bounds=nlp.bounds,
                          constraints=rows, method="SLSQP")
    assert best.success and best.fun == pytest.approx(liesl.minimize(nlp).check().f, rel=1e-4)


def test_save_and_open_an_optimum(rod, tmp_path):
    best = rod.change({"cycle.max": 2}).optimize()
    best.save(tmp_path / "out")
    folder = liesl.open(tmp_path / "out")
    assert folder.summary["design"] == best.design
    assert list(folder.tables["design"]["variable"]) and "responses_final" in folder.tables
    liesl.Scene.load(tmp_path / "out/design.toml")
    if best.status == "cycle limit":
        with pytest.raises(liesl.NotConverged):
            best.check()


def test_own_objective_and_limit(rod):
    """The mean square of the bending instead of the mass, at a mass of at most 0.25 kg."""

    def bending(at):
        y = at["responses/bending"]
        return 1e6 * (y ** 2).mean(), {"bending": 2e6 * y / y.size}

    def heavy(at):
        return at.objective / 0.25 - 1, {"x": rod.mass_gradient(at.x) / 0.25}

    nlp = rod.nlp(objective=bending, limits={"heavy": heavy})
    assert nlp.rows == ["bending", "heavy"]
    x, h = nlp.x0, 1e-7
    difference = [(nlp.objective(x + e) - nlp.objective(x - e)) / (2 * h) for e in h * np.eye(4)]
    assert nlp.gradient(x) == pytest.approx(difference, rel=1e-4)
    best = liesl.minimize(nlp, tolerance=1e-5).check()
    assert best.f < nlp.objective(x) and rod.evaluate(best.x).objective <= 0.25 * (1 + 1e-5)


def test_own_functions_inside_optimize(rod):
    """The same as a nonlinear program by itself, here as a study that ends with a status."""

    def bending(at):
        y = 1e3 * at["responses/bending"]
        return (y ** 2).mean(), {"bending": 2e3 * y / y.size}

    def heavy(at):
        return at.objective / 0.25 - 1, {"x": rod.mass_gradient(at.x) / 0.25}

    seen = []
    best = rod.optimize(objective=bending, limits={"heavy": heavy},
                        on_cycle=lambda so_far: seen.append(len(so_far["history"]))).check()
    by_hand = liesl.minimize(rod.nlp(objective=bending, limits={"heavy": heavy}), tolerance=1e-5).check()
    assert best.status in ("optimal", "converged") and seen == list(range(1, len(best.history) + 1))
    assert best.x == pytest.approx(by_hand.x, rel=1e-6)
    assert bending(rod.evaluate(best.x))[0] == pytest.approx(best.summary["objective"]["final"])
    assert best.summary["objective"]["final"] < best.summary["objective"]["initial"]
    assert best.summary["mass_final"] <= 0.25 * (1 + 1e-5)
    assert best.summary["multipliers"]["heavy"] > 0, "the mass holds it"
    assert np.array_equal(best["responses/bending"], rod.evaluate(best.x)["responses/bending"])


def test_an_own_optimum_is_saved_as_liesl_optimize_does(rod, tmp_path):
    """Design, history and files; what the program draws and reads again."""

    def bending(at):
        y = 1e3 * at["responses/bending"]
        return (y ** 2).mean(), {"bending": 2e3 * y / y.size}

    def heavy(at):
        return at.objective / 0.25 - 1, {"x": rod.mass_gradient(at.x) / 0.25}

    few = rod.change({"cycle.max": 3})
    best = few.optimize(objective=bending, limits={"heavy": heavy})
    few.optimize().save(tmp_path / "plain")
    best.save(tmp_path / "own")
    assert best.status == "cycle limit" and len(best.history) >= 3
    files = [{p.name for p in (tmp_path / name).iterdir()} for name in ("plain", "own")]
    assert files[1] == files[0] and {"design.toml", "design.csv", "cycle_loads.csv"} < files[0]
    plain, own = liesl.open(tmp_path / "plain"), liesl.open(tmp_path / "own")
    assert set(plain.summary) - {"violation"} <= set(own.summary)
    assert set(plain.summary["history"][-1]) <= set(own.summary["history"][-1])
    assert own.summary["history"] == best.history and own.summary["design"] == best.design
    assert own.summary["steps"] == sum(len(rod.evaluate(h["design"]).time) - 1 for h in best.history)
    assert all(np.array_equal(own[name], best[name]) for name in best)
    for cycle in best.history:  # limits of the study are shares, one's own numbers; each cycle has both
        there = rod.evaluate(cycle["design"])
        assert set(cycle["limits"]) == {"bending", "heavy"}
        assert cycle["limits"]["heavy"] == {"violation": pytest.approx(heavy(there)[0]), "at": ""}
        assert cycle["limits"]["bending"]["violation"] == pytest.approx(there.worst, rel=1e-6)
        assert cycle["limits"]["bending"]["at"].startswith("t = ")
        assert cycle["worst_constraint"] == pytest.approx(max(v["violation"] for v in cycle["limits"].values()), rel=1e-6)
    at = rod.evaluate(best.x)
    limits = own.summary["constraints"]
    assert limits["bending"]["max_abs_final"] == pytest.approx(at.limits["bending"], rel=1e-9)
    assert limits["bending"]["max_abs_initial"] == pytest.approx(rod.evaluate().limits["bending"])
    assert limits["heavy"]["violation"] == pytest.approx(heavy(at)[0])
    assert own.tables["responses_final"]["bending [m]"].max() == limits["bending"]["max_abs_final"]
    again = liesl.Scene.load(tmp_path / "own/design.toml").run()
    assert abs(again["responses/bend"]).max() == pytest.approx(at.limits["bending"], rel=1e-4)
    last = own.summary["history"][-1]
    assert last["design"] == list(best.design.values()), "Ipopt's last derivatives are of its answer"
    loads = {name.split(" [")[0]: column for name, column in own.tables["cycle_loads"].items()}
    assert {1, last["cycle"]} >= set(loads["cycle"]) >= {last["cycle"]}
    subprocess.run([os.environ["LIESL_PROGRAM"], "report", tmp_path / "own", "--quiet"], check=True)


def test_own_functions_of_arrays_that_are_not_contiguous(rod):
    """Views with strides, Fortran order, other types of numbers: the same gradient."""

    def gradient(weights):
        nlp = rod.nlp(objective=lambda at: (0.0, {"bending": weights(at["responses/bending"]),
                                                  "x": np.zeros((4, 2))[:, 1]}))
        return nlp.gradient(nlp.x0)

    plain = gradient(lambda y: 1e3 * y)
    assert abs(plain).max() > 0
    for change in (lambda y: np.repeat(1e3 * y, 2, axis=0)[::2], lambda y: np.asfortranarray(1e3 * y),
                   lambda y: (1e3 * y[::-1])[::-1], lambda y: (1e3 * y)[:, 0].tolist(),
                   lambda y: (1e3 * y).astype(">f8")):
        assert np.array_equal(gradient(change), plain)


@pytest.mark.parametrize("arguments, says", [
    ({"objective": lambda at: (np.nan, {})}, "the objective is nan at the start"),
    ({"limits": {"mine": lambda at: (np.inf, {})}}, "'mine' is inf at the start"),
    ({"limits": {"mine": lambda at: ("a", {})}}, "'mine' returns no"),
    ({"objective": lambda at: (1.0, {"x": [0, 0, np.nan, 0]})}, "derivative by 'x'"),
    ({"objective": lambda at: (1.0, {"x": ["a"] * 4})}, "derivative by 'x'"),
    ({"objective": lambda at: (1.0, 3)}, "the objective returns no"),
    ({"objective": lambda at: (1.0, {}), "method": "esl1"}, "method='esl1' with functions"),
    ({"objective": lambda at: (1.0, {}), "nucleate": 1}, "nucleate=1 with functions"),
    ({"objective": 3.0}, "no function"), ({"limits": {"mine": None}}, "no function"),
    ({"limits": {"bending": lambda at: (0.0, {})}}, "'bending' is a limit of the study"),
])
def test_own_functions_that_are_wrong(rod, arguments, says):
    with pytest.raises(liesl.InputError, match=says):
        rod.optimize(**arguments)


@pytest.mark.parametrize("function, says", [
    (lambda at: at.objective, "returns no"),
    (lambda at: (1.0, {"bending": np.full_like(at["responses/bending"], np.nan)}), "nan"),
    (lambda at: (1.0, {"bnding": [0]}), "bnding"),
    (lambda at: (1.0, {"x": [0, 0, 0, np.nan]}), "'x'"),
    (lambda at: (1.0, {"x": [0, 0]}), "'x'"),
    (lambda at: (1.0, {"bending": at["responses/bending"][:, 0][::2]}), "shape"),
])
def test_functions_that_are_wrong(rod, function, says):
    with pytest.raises(liesl.InputError, match=says) as error:
        liesl.minimize(rod.nlp(objective=function))
    assert "the objective" in str(error.value)


def test_what_a_function_raises_is_raised(rod):
    def broken(at):
        raise ZeroDivisionError("mine")

    with pytest.raises(ZeroDivisionError, match="mine"):
        liesl.minimize(rod.nlp(objective=broken))


@pytest.mark.parametrize("x, says", [
    ([0.01], "shape"), (np.full(4, np.nan), "nan"), (np.full(4, 1.0), r"in \[0.004"),
    (["a"] * 4, "numbers"), (np.ones((4, 1)), "shape"),
])
def test_designs_that_do_not_fit(rod, x, says):
    with pytest.raises(liesl.InputError, match=says):
        rod.evaluate(x)


def test_studies_without_a_motion(data):
    study = liesl.Study.load(data / "studies/cantilever.toml")
    own = {"objective": lambda at: (1.0, {})}
    for call in (study.evaluate, lambda: study.nlp(**own), lambda: study.optimize(**own),
                 liesl.Study.load(data / "studies/svanberg_cantilever.toml").nlp):
        with pytest.raises(liesl.InputError, match="motion"):
            call()
    with pytest.raises(liesl.InputError, match="windows is 2"):
        study.nlp(windows=2)
    with pytest.raises(liesl.InputError):
        liesl.Study.load(data / "scenes/slider_crank.toml")


@pytest.mark.parametrize("name, says", [
    ("rod_stiffest", "limits on masses, largest values in the objective are no rows"),
    ("rod_catalogue", "sizes of a catalogue are no rows"),
])
def test_what_has_no_rows_is_not_left_out(data, name, says):
    study = liesl.Study.load(data / f"studies/{name}.toml")
    with pytest.raises(liesl.InputError, match=says):
        study.optimize(objective=lambda at: (1.0, {}))


def check_gradients(nlp, columns, h, tolerance):
    """Objective and rows against central differences, beside the start, where outlines lie along cells."""
    lower, upper = np.array(nlp.bounds).T
    x = nlp.x0 + 0.0137 * np.where(nlp.x0 < 0.5 * (lower + upper), 1, -1) * (upper - lower)
    gradient, jacobian = nlp.gradient(x), nlp.jacobian(x)
    assert jacobian.shape == (len(nlp.rows), len(x)) and nlp.constraints(x).shape == (len(nlp.rows),)
    for j in columns:
        e = h * np.eye(len(x))[j]
        df = (nlp.objective(x + e) - nlp.objective(x - e)) / (2 * h)
        dg = (nlp.constraints(x + e) - nlp.constraints(x - e)) / (2 * h)
        assert gradient[j] == pytest.approx(df, rel=tolerance)
        assert abs(jacobian[:, j] - dg).max() <= tolerance * abs(dg).max()


@pytest.fixture(scope="module")
def cantilever():
    """The study and its optimum, found by the package."""
    study = liesl.Study.load(DATA / "studies/cantilever.toml")
    return study, study.optimize().check()


def test_program_of_an_outline_under_fixed_loads(cantilever):
    study, optimum = cantilever
    nlp = study.nlp()
    assert len(nlp.rows) == 1 and "sag" in nlp.rows[0]
    check_gradients(nlp, [0], 1e-6, 1e-4)
    best = liesl.minimize(nlp, tolerance=1e-5).check()
    assert best.f == pytest.approx(optimum.summary["mass_final"], rel=1e-4)


def test_load_cases_of_an_outline_are_records(cantilever):
    best = cantilever[1]
    part = best.meshes["plate"]
    assert best.time.tolist() == [1] and part["amplitude"].tolist() == [[1]]
    x, u = part["position"][0], part["displacement"][0]
    assert np.allclose(part["basis"][0], u) and part["stress_basis"].shape[2] == 3
    at_tip = np.abs(x - u - [0.2, 0, 0]).sum(axis=1).argmin()
    assert u[at_tip, 1] == pytest.approx(-4e-4, rel=2e-2), "the sag that is allowed"
    assert abs(u[x[:, 0] < 1e-9]).max() < 1e-9, "the wall"


def test_program_has_every_load_case_and_what_the_study_minimises(data):
    study = liesl.Study.load(data / "studies/plate_with_hole.toml")
    nlp = study.nlp()
    assert any("mass" in row for row in nlp.rows)
    check_gradients(nlp, [0, 1], 1e-6, 1e-3)
    assert nlp.objective(nlp.x0) == pytest.approx(463.0, rel=1e-3), "f^T u, J"


def test_program_of_an_outline_in_motion(data):
    """Records and walls are rows; one's own are added to them."""
    study = liesl.Study.load(data / "studies/connecting_rod.toml",
                             {"scene.simulation.duration": 2e-3, "scene.bodies.rod.solid.mesh.cells": [60, 12]})
    nlp = study.nlp(limits={"light": lambda at: (at.objective - 1, {"x": study.mass_gradient(at.x)})})
    assert nlp.rows[-1] == "light" and any("hole1" in row for row in nlp.rows)
    assert sum("elongation" in row for row in nlp.rows) == len(study.evaluate().time)
    check_gradients(nlp, [0, 2], 1e-6, 1e-3)


def test_scenarios_have_rows_of_their_own(data):
    study = liesl.Study.load(data / "studies/slider_crank_rod.toml",
                             {"scene.simulation.duration": 0.02})
    text, file, folder, changes = study._arguments
    study = liesl.Study(text + "\n[scenarios]\nslow = { set = { joints.motor.drive.rate = 100 } }\n"
                        "fast = { set = { joints.motor.drive.rate = 150 } }\n", file, folder,
                        changes)
    nlp = study.nlp()
    assert nlp.rows == ["bending (fast)", "bending (slow)"]  # by name
    g = nlp.constraints(nlp.x0)
    assert g[0] != g[1] and max(g) == pytest.approx(study.evaluate().worst)
    check_gradients(nlp, [0, 2], 1e-6, 1e-4)
    best = study.change({"cycle.max": 2}).optimize(limits={"light": lambda at: (at.objective - 1, {"x": study.mass_gradient(at.x)})})
    assert all(set(cycle["limits"]) == {"bending (fast)", "bending (slow)", "light"} for cycle in best.history)


def test_pickle(rod):
    copy = pickle.loads(pickle.dumps(rod))
    assert np.array_equal(copy.evaluate()["responses/bending"],
                          rod.evaluate()["responses/bending"])
