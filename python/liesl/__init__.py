"""liesl: flexible mechanisms on SE(3), sized under the loads of their motion.

>>> import liesl
>>> scene = liesl.Scene.load("slider_crank.toml")
>>> result = scene.change({"simulation.step": 5e-5}).run().check()
>>> result["responses/bend"].max()

Keys are those of docs/scene_reference.md, names of data sets those of results.h5. SI units.
"""

from ._liesl import __version__
from .errors import InputError, IoError, NotConverged, Problem
from .nlp import MinimizeResult, Nlp, minimize
from .result import FolderResult, Group, Result, open
from .scene import Scene
from .study import Evaluation, Optimum, Study, Variable

__all__ = ["Evaluation", "FolderResult", "Group", "InputError", "IoError", "MinimizeResult", "Nlp",
           "NotConverged", "Optimum", "Problem", "Result", "Scene", "Study", "Variable",
           "__version__", "minimize", "open"]
