"""The stable formulas of a conversion as one loop that Numba compiles for one thread: what a specialist would write."""

from collections.abc import Callable
from functools import cache
from typing import Any

import numba
import numpy as np
from numpy.typing import NDArray

from radartrack.generated import loops

Floats = NDArray[np.float64]


@cache
def _compiled(name: str) -> Any:
    return numba.njit(getattr(loops, name), error_model="numpy")


def fused_loop(name: str, size: int) -> Callable[..., tuple[Floats, Floats]]:
    """A conversion of contiguous arrays, with outputs that are allocated by each call."""
    loop = _compiled(name)

    def convert(*arrays: Floats) -> tuple[Floats, Floats]:
        count = len(arrays[0])
        mean, covariance = np.empty((count, size)), np.empty((count, size, size))
        loop(arrays, mean, covariance)
        return mean, covariance

    return convert
