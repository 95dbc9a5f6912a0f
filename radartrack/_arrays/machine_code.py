"""Conversions as machine code, where Numba is installed: the extra `radartrack[fast]`.

The loops are written by the same generator as the NumPy code, from the same formulas. They are compiled when they are
first needed, which takes seconds, and kept on disk.
"""

import importlib
import importlib.util
from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np

from radartrack._arrays.validation import RealArray

COMPILED_FROM = 256  # plots; for fewer NumPy is fast enough, and the compiler need not be loaded
BLOCK = 16384  # plots; the arguments are still in the cache when they have been checked


@cache
def is_available() -> bool:
    """Whether Numba is installed."""
    return importlib.util.find_spec("numba") is not None


@cache
def conversion(name: str) -> Callable[..., None]:
    """The compiled conversion of this name, for float64 arrays: inputs of shape (plots,) or (), then outputs."""
    numba: Any = importlib.import_module("numba")
    loop = getattr(importlib.import_module("radartrack.generated.loops"), name)
    count = loop.__code__.co_argcount - 2
    outputs = (numba.float64[:, ::1], numba.float64[:, :, ::1])
    readable = numba.types.Array(numba.float64, 1, "A", readonly=True)
    signature = numba.void(*[readable] * count, *outputs)
    compiled: Any = numba.njit(signature, cache=True, nogil=True, error_model="numpy")(loop)

    def fill(*arrays: RealArray) -> None:
        *inputs, mean, covariance = arrays
        spread = (array if array.ndim else np.ndarray(len(mean), array.dtype, array, strides=(0,)) for array in inputs)
        compiled(*spread, mean, covariance)

    return fill
