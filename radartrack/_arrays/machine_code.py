"""Conversions as machine code, where Numba is installed: the extra `radartrack[fast]`.

The loops are written by the same generator as the NumPy code, from the same formulas. They are compiled when they are
first needed, which takes seconds, and kept on disk. Whatever is wrong with Numba or what it kept, NumPy computes
instead; why is logged at the level INFO.
"""

import importlib
import os
from collections.abc import Callable
from functools import cache
from threading import RLock
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from radartrack._arrays.validation import RealArray

COMPILED_FROM = 256  # plots; for fewer NumPy is fast enough, and the compiler need not be loaded
BLOCK = 16384  # plots

Compiled = TypeVar("Compiled")
Limits = NDArray[np.float64]  # least and largest value of each input

_at_numba = RLock()
"""Held while Numba is loaded or compiles, and waited for before a fork: in the child nobody would go on with it."""
if hasattr(os, "register_at_fork"):
    os.register_at_fork(before=_at_numba.acquire, after_in_parent=_at_numba.release, after_in_child=_at_numba.release)


@cache
def is_available() -> bool:
    """Whether Numba is installed and can be loaded."""
    return attempted(lambda: importlib.import_module("numba"), "Numba cannot be loaded") is not None


@cache
def conversion(name: str, coordinates: int) -> Callable[..., bool] | None:
    """The compiled conversion of this name, for float64 arrays: inputs of shape (plots,) or (), then outputs.

    It says whether all inputs are between `limits`, shape (inputs, 2), which costs no pass over them. Where an angle is
    beyond the reach of the compiled sines, NumPy's function computes all plots of the call.

    Args:
        name: of model and method.
        coordinates: that a mean has.

    Returns:
        None where Numba cannot compile it.

    """
    loop = getattr(importlib.import_module("radartrack.generated.loops"), name)
    over_arrays = getattr(importlib.import_module("radartrack.generated.conversions"), name)
    count = over_arrays.__code__.co_argcount - 2

    def compiling(**options: Any) -> Callable[..., tuple[bool, bool]]:
        side_by_side = importlib.import_module("radartrack._arrays.plots_side_by_side")  # loads Numba
        compiled: Callable[..., tuple[bool, bool]] = side_by_side.compiled(loop, count, coordinates, **options)
        return compiled

    compiled = machine_code(compiling)
    if compiled is None:
        return None

    anything = np.array([[-np.inf, np.inf]] * count)

    def fill(*arrays: RealArray, limits: Limits = anything) -> bool:
        *inputs, mean, covariance = arrays
        columns = (np.ascontiguousarray(array).reshape(-1) for array in inputs)  # one entry where all plots share it
        is_near, is_within = compiled(tuple(columns), limits, mean, covariance)
        if not is_near:
            over_arrays(*inputs, mean, covariance)
        return is_within

    return fill


def machine_code(compiling: Callable[..., Compiled]) -> Compiled | None:
    """What a function that takes Numba's options compiles, with a cache on disk or else without.

    Numba's cache may have no place where the package and the home directory are not writable, and may be damaged.

    Returns:
        None where it cannot be compiled at all.

    """
    options = {"nogil": True, "error_model": "numpy"}
    kept = attempted(lambda: compiling(cache=True, **options), "Numba cannot keep machine code on disk")
    return kept if kept is not None else attempted(lambda: compiling(**options), "Numba cannot compile")


def attempted(attempt: Callable[[], Compiled], failure: str) -> Compiled | None:
    """What something that Numba does results in; None, and why is logged, where that fails."""
    try:
        with _at_numba:
            return attempt()
    except (Exception, SystemExit) as error:  # noqa: BLE001 - another package, or its files, may be broken in any way
        import logging  # noqa: PLC0415 - seldom needed

        logging.getLogger(__name__).info("%s: %s: %s", failure, type(error).__name__, error)
        return None
