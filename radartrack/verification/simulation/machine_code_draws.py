"""Draws in machine code, where Numba is installed: the extra `radartrack[fast]`.

One loop does what any tape says, on so few draws at a time that they stay in the cache. It is compiled once, which
takes seconds, and kept on disk. Sines of several draws are computed at once, which takes a quarter of NumPy's time.
"""

from __future__ import annotations

import importlib
import math
from collections.abc import Callable, Iterable
from functools import cache
from hashlib import sha256
from inspect import getsource
from typing import Any, TypeVar

import numpy as np
import numpy.typing as npt

from radartrack._arrays import machine_code
from radartrack.generated import elementary
from radartrack.verification.simulation.tracing import Tape

Array = npt.NDArray[np.float64]
Whole = npt.NDArray[np.int64]
Loop = TypeVar("Loop", bound=Callable[..., Any])
ADD, SUBTRACT, MULTIPLY, SIN, COS = range(5)
_DIGEST = sha256(getsource(elementary).encode()).hexdigest()[:16]
OPERATIONS = {"add": ADD, "subtract": SUBTRACT, "multiply": MULTIPLY, "sin": SIN, "cos": COS}
LANES = 512  # draws at a time


def is_possible(tape: Tape) -> bool:
    """Whether the loop knows all operations, and runs."""
    return all(step.operation in OPERATIONS for step in tape.steps) and _runs()


@cache
def _runs() -> bool:
    """Whether Numba compiles the loop, or reads what it kept of it: both happen when it is first called."""
    nothing, steps, results = np.empty((0, LANES)), np.empty((0, 4), np.int64), np.empty(0, np.int64)

    def attempt() -> bool:
        _run(steps, results, nothing, nothing, nothing)
        return True

    return machine_code.attempted(attempt, "Numba cannot compile the loop over draws") is not None


def summation(tape: Tape) -> Callable[[Iterable[Array]], Array]:
    """What takes blocks [input, draw], whose lengths LANES divides, and gives each result's sum over all draws."""
    steps = [(OPERATIONS[step.operation], step.place, step.operands[0], step.operands[-1]) for step in tape.steps]
    table, results = np.array(steps, dtype=np.int64), np.array(tape.results, dtype=np.int64)
    rows, totals = np.empty((tape.places, LANES)), np.empty((len(results), LANES))
    for number, place in tape.constants.items():
        rows[place] = number

    def summed(blocks: Iterable[Array]) -> Array:
        totals[:] = 0.0
        for block in blocks:
            _run(table, results, block, rows, totals)
        return np.asarray(totals.sum(axis=-1))

    return summed


def _machine_code(loop: Loop) -> Loop:
    if not machine_code.is_available():
        return loop
    numba: Any = importlib.import_module("numba")
    loop.__qualname__ += f"_{_DIGEST}"  # by which Numba finds what it kept; it looks at this file alone
    fast: Loop | None = machine_code.machine_code(lambda **options: numba.njit(**options)(loop))
    return loop if fast is None else fast


def _sine_and_cosine() -> tuple[Callable[[float], float], Callable[[float], float]]:
    """The generated functions, which a compiler computes several of at once."""
    if not machine_code.is_available():
        return elementary.sin, elementary.cos
    side_by_side = importlib.import_module("radartrack._arrays.plots_side_by_side")
    compiled = side_by_side.elementary_functions()
    return compiled["sin"], compiled["cos"]


sine, cosine = _sine_and_cosine()


@_machine_code
def _sines(angles: Array, quarters: int, result: Array) -> None:
    outside = 0
    for i in range(LANES):
        outside += not abs(angles[i]) <= elementary.LARGEST_ANGLE
    if outside:
        for i in range(LANES):
            result[i] = math.cos(angles[i]) if quarters else math.sin(angles[i])
    elif quarters:
        for i in range(LANES):
            result[i] = cosine(angles[i])
    else:
        for i in range(LANES):
            result[i] = sine(angles[i])


@_machine_code
def _step(operation: int, left: Array, right: Array, result: Array) -> None:
    if operation == ADD:
        for i in range(LANES):
            result[i] = left[i] + right[i]
    elif operation == SUBTRACT:
        for i in range(LANES):
            result[i] = left[i] - right[i]
    elif operation == MULTIPLY:
        for i in range(LANES):
            result[i] = left[i] * right[i]
    else:
        _sines(left, operation - SIN, result)


@_machine_code
def _accumulate(totals: Array, values: Array) -> None:
    for i in range(LANES):
        totals[i] += values[i]


@_machine_code
def _run(table: Whole, results: Whole, inputs: Array, rows: Array, totals: Array) -> None:
    for start in range(0, inputs.shape[1], LANES):
        for i in range(len(inputs)):
            rows[i] = inputs[i, start : start + LANES]
        for operation, place, left, right in table:
            _step(operation, rows[left], rows[right], rows[place])
        for i in range(len(results)):
            _accumulate(totals[i], rows[results[i]])
