"""Ipopt on one's own functions."""

import numpy as np
import pytest

import liesl

ROWS = ["circle"]


def program(**other):
    """minimise x + y in the circle of radius 1: at -(1, 1)/sqrt 2, multiplier 1/sqrt 2."""
    functions = {"objective": lambda x: x[0] + x[1], "gradient": lambda x: np.ones(2),
                 "constraints": lambda x: np.array([x @ x - 1]),
                 "jacobian": lambda x: 2 * x[None, :], "rows": ROWS}
    return liesl.Nlp([("x", -2, 2, 0.3), ("y", -2, 2, 0.1)], **{**functions, **other})


def test_closed_form():
    best = liesl.minimize(program(), tolerance=1e-8).check()
    assert best.x == pytest.approx(np.full(2, -np.sqrt(0.5)), abs=1e-6)
    assert best.multipliers == pytest.approx([np.sqrt(0.5)], rel=1e-5)


def test_bounds_alone():
    best = liesl.minimize(liesl.Nlp([("x", 1, 3, 2)], lambda x: x[0] ** 2, lambda x: 2 * x))
    assert best.x == pytest.approx([1], abs=1e-5) and len(best.g) == 0


def test_arrays_of_any_layout():
    strided = lambda x: np.repeat(2 * x[None, :], 2, axis=1)[:, ::2]  # noqa: E731
    best = liesl.minimize(program(jacobian=strided, gradient=lambda x: [1, 1]))
    assert best.solved


@pytest.mark.parametrize("other, says", [
    ({"gradient": lambda x: np.array([1, np.nan])}, "objective by 'y' is nan"),
    ({"jacobian": lambda x: np.array([[np.inf, 1]])}, "row 'circle' by 'x' is inf"),
    ({"gradient": lambda x: np.ones(3)}, r"gradient returns shape \(3,\); expected \(2,\)"),
    ({"jacobian": lambda x: np.ones(2)}, "jacobian returns shape"),
    ({"constraints": lambda x: np.ones(2)}, "constraints returns shape"),
    ({"constraints": lambda x: ["a"]}, "no numbers"),
    ({"gradient": lambda x: np.ones(2) + 1e-8j}, "gradient returns no numbers: complex"),
])
def test_functions_that_are_wrong(other, says):
    with pytest.raises(liesl.InputError, match=says):
        liesl.minimize(program(**other))


def test_infeasible_is_a_status():
    nlp = program(constraints=lambda x: x[:1] + 3, jacobian=lambda x: np.array([[1, 0]]))
    result = liesl.minimize(nlp)
    assert not result.solved and "circle" in result.reason
    with pytest.raises(liesl.NotConverged):
        result.check()


def test_points_without_a_value_shorten_the_step():
    nlp = liesl.Nlp([("x", -10, 10, 3)], lambda x: -np.sqrt(5 - x[0]) + x[0] if x[0] < 5 else np.nan,
                    lambda x: np.array([0.5 / np.sqrt(5 - x[0]) + 1]))
    assert liesl.minimize(nlp).x == pytest.approx([-10], abs=1e-4)


@pytest.mark.parametrize("options", [{"tolerance": 0}, {"feasibility": 2}, {"max_iterations": 0}])
def test_options_out_of_range(options):
    with pytest.raises(liesl.InputError):
        liesl.minimize(program(), **options)
