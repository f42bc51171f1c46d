"""Studies: evaluation, the nonlinear program, optimisation by four ways, bad functions."""

import pickle

import numpy as np
import pytest

import liesl


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
    for windows in (0, -1, 1.5, True, "2"):
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
    for call in (study.evaluate, study.nlp):
        with pytest.raises(liesl.InputError, match="motion"):
            call()
    with pytest.raises(liesl.InputError):
        liesl.Study.load(data / "scenes/slider_crank.toml")


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


def test_pickle(rod):
    copy = pickle.loads(pickle.dumps(rod))
    assert np.array_equal(copy.evaluate()["responses/bending"],
                          rod.evaluate()["responses/bending"])
