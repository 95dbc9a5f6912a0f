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
from radartrack.verification.simulation.statistics import POWERS
from radartrack.verification.simulation.tracing import SUMMED, Tape, with_products_summed

Array = npt.NDArray[np.float64]
Whole = npt.NDArray[np.int64]
Loop = TypeVar("Loop", bound=Callable[..., Any])
ADD, SUBTRACT, MULTIPLY, SINES, ADD_PRODUCTS, SUBTRACT_PRODUCTS = range(6)
WAVES = ("sin", "cos")
OPERATIONS = {
    "add": ADD,
    "subtract": SUBTRACT,
    "multiply": MULTIPLY,
    "sin": SINES,
    "cos": SINES,
    SUMMED["add"]: ADD_PRODUCTS,
    SUMMED["subtract"]: SUBTRACT_PRODUCTS,
}
OPERANDS = 4
_DIGEST = sha256(getsource(elementary).encode()).hexdigest()[:16]
LANES = 256  # draws at a time: with the rows that are needed at once, they stay in the nearest caches
CHAINS = 4  # vectors of angles at once: the sines of one wait for each other


def is_possible(tape: Tape) -> bool:
    """Whether the loop knows all operations, and runs."""
    return all(step.operation in OPERATIONS for step in tape.steps) and _runs()


@cache
def _runs() -> bool:
    """Whether Numba compiles the loop, or reads what it kept of it: both happen when it is first called."""
    nothing, totals = np.empty((0, LANES)), np.empty((0, POWERS, LANES))
    steps, results = np.empty((0, 2 + OPERANDS), np.int64), np.empty(0, np.int64)

    def attempt() -> bool:
        with _side_by_side().interleaved(CHAINS):
            _run(steps, results, nothing, nothing, totals)
        return True

    return machine_code.attempted(attempt, "Numba cannot compile the loop over draws") is not None


def summation(tape: Tape) -> Callable[[Iterable[Array]], Array]:
    """What takes blocks [input, draw], whose lengths LANES divides, and sums the first powers of each result up."""
    steps, results, constants, count = rows_of(with_products_summed(tape))
    table, kept = np.array(steps, dtype=np.int64), np.array(results, dtype=np.int64)
    rows, totals = np.empty((count, LANES)), np.empty((len(kept), POWERS, LANES))
    for number, row in constants.items():
        rows[row] = number

    def summed(blocks: Iterable[Array]) -> Array:
        totals[:] = 0.0
        for block in blocks:
            _run(table, kept, block, rows, totals)
        return np.asarray(totals.sum(axis=-1)).reshape(-1)

    return summed


def rows_of(tape: Tape) -> tuple[list[tuple[int, ...]], list[int], dict[float, int], int]:
    """A tape with rows in place of places: what is needed no more makes room, and sine and cosine come together.

    Returns:
        Operation, row of the result and rows of the operands of each step (of `SINES`: the row of the sines, of the
        angles, of the cosines); the rows of the results; those of constants by number; and how many there are. The
        inputs have the first rows.
    """
    kept = {*range(tape.inputs), *tape.constants.values(), *tape.results}
    last = {place: n for n, step in enumerate(tape.steps) for place in step.operands}
    row = {place: n for n, place in enumerate([*range(tape.inputs), *tape.constants.values()])}
    waves = {(step.operation, step.operands): step.place for step in tape.steps if step.operation in WAVES}
    free: list[int] = []
    steps: list[tuple[int, ...]] = []
    count = len(row)

    def room(place: int | None) -> int:
        nonlocal count
        count += not free
        found = free.pop() if free else count - 1
        if place is not None:
            row[place] = found
        return found

    for n, step in enumerate(tape.steps):
        if step.place not in row:
            operands = [row[place] for place in step.operands]
            if step.operation in WAVES:
                both = [waves.get((wave, step.operands)) for wave in WAVES]
                sines, cosines = map(room, both)
                steps.append((SINES, sines, operands[0], cosines, 0, 0))
                free += [found for place, found in zip(both, (sines, cosines), strict=True) if place is None]
            else:
                more = [0] * (OPERANDS - len(operands))
                steps.append((OPERATIONS[step.operation], room(step.place), *operands, *more))
        free += [row[place] for place in {*step.operands} - kept if last[place] == n]
    return steps, [row[place] for place in tape.results], {c: row[place] for c, place in tape.constants.items()}, count


def _side_by_side() -> Any:
    return importlib.import_module("radartrack._arrays.plots_side_by_side")  # loads Numba


def _machine_code(loop: Loop) -> Loop:
    if not machine_code.is_available():
        return loop
    numba: Any = importlib.import_module("numba")
    loop.__qualname__ += f"_{_DIGEST}"  # by which Numba finds what it kept; it looks at this file alone
    fast: Loop | None = machine_code.machine_code(lambda **options: numba.njit(**options)(loop))
    return loop if fast is None else fast


def _sine_and_cosine() -> Callable[[float], tuple[float, float]]:
    """The generated function, which a compiler computes several of at once."""
    if not machine_code.is_available():
        return elementary.sin_and_cos
    compiled: Callable[[float], tuple[float, float]] = _side_by_side().elementary_functions()["sin_and_cos"]
    return compiled


sine_and_cosine = _sine_and_cosine()


@_machine_code
def _sines(rows: Array, sines: int, angles: int, cosines: int) -> None:
    outside = 0
    for i in range(LANES):
        outside += not abs(rows[angles, i]) <= elementary.LARGEST_ANGLE
    if outside:
        for i in range(LANES):
            angle = rows[angles, i]
            rows[sines, i], rows[cosines, i] = math.sin(angle), math.cos(angle)
    else:
        for i in range(LANES):
            rows[sines, i], rows[cosines, i] = sine_and_cosine(rows[angles, i])


@_machine_code
def _products(operation: int, rows: Array, result: int, a: int, b: int, c: int, d: int) -> None:
    if operation == ADD_PRODUCTS:
        for i in range(LANES):
            rows[result, i] = rows[a, i] * rows[b, i] + rows[c, i] * rows[d, i]
    else:
        for i in range(LANES):
            rows[result, i] = rows[a, i] * rows[b, i] - rows[c, i] * rows[d, i]


@_machine_code
def _step(operation: int, rows: Array, result: int, a: int, b: int, c: int, d: int) -> None:
    """Of rows by their numbers: each view of a row would be counted as a reference, which takes longer than a step."""
    if operation == ADD:
        for i in range(LANES):
            rows[result, i] = rows[a, i] + rows[b, i]
    elif operation == SUBTRACT:
        for i in range(LANES):
            rows[result, i] = rows[a, i] - rows[b, i]
    elif operation == MULTIPLY:
        for i in range(LANES):
            rows[result, i] = rows[a, i] * rows[b, i]
    elif operation == SINES:
        _sines(rows, result, a, b)
    else:
        _products(operation, rows, result, a, b, c, d)


@_machine_code
def _accumulate(totals: Array, result: int, rows: Array, row: int) -> None:
    for i in range(LANES):
        value = rows[row, i]
        square = value * value
        totals[result, 0, i] += value
        totals[result, 1, i] += square
        totals[result, 2, i] += value * square
        totals[result, 3, i] += square * square


@_machine_code
def _run(table: Whole, results: Whole, inputs: Array, rows: Array, totals: Array) -> None:
    for start in range(0, inputs.shape[1], LANES):
        for n in range(len(inputs)):
            for i in range(LANES):
                rows[n, i] = inputs[n, start + i]
        for n in range(len(table)):
            _step(table[n, 0], rows, table[n, 1], table[n, 2], table[n, 3], table[n, 4], table[n, 5])
        for n in range(len(results)):
            _accumulate(totals, n, rows, results[n])
