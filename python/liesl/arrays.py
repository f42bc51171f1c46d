"""Arrays that scripts hand over."""

from __future__ import annotations

from typing import Any

import numpy as np


def real(values: Any) -> np.ndarray:
    """A copy as numbers of double precision. Raises TypeError or ValueError for what holds other
    things, complex numbers among them, whose imaginary part would be dropped."""
    given = np.asarray(values)
    if np.iscomplexobj(given):
        raise TypeError("complex numbers")
    return np.array(given, dtype=float)
