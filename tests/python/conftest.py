"""What the tests of the Python package share: shipped scenes and studies, small ones."""

import os
from pathlib import Path

import pytest

import liesl

DATA = Path(os.environ["LIESL_DATA"])


@pytest.fixture
def data():
    return DATA


@pytest.fixture
def pendulum():
    """A beam on a hinge, 20 steps: a run takes some milliseconds."""
    return {
        "name": "pendulum",
        "gravity": [0, -9.81, 0],
        "materials": {"steel": {"E": 210e9, "nu": 0.3, "rho": 7850}},
        "sections": {"round": {"type": "circle", "diameter": 0.01}},
        "bodies": {"rod": {"beam": {"from": [0, 0, 0], "to": [1, 0, 0], "section": "round",
                                    "material": "steel", "elements": 4}}},
        "joints": {"pin": {"revolute": ["ground", "rod.start"], "axis": [0, 0, 1]}},
        "responses": {"bend": {"response": "deflection", "of": "rod", "at": "mid"},
                      "tip": {"response": "position", "at": "rod.end"}},
        "simulation": {"duration": 0.02, "step": 1e-3},
    }


@pytest.fixture
def rod():
    """The shipped study of a rod over a third of its motion."""
    return liesl.Study.load(DATA / "studies/slider_crank_rod.toml",
                            {"scene.simulation.duration": 0.04})
