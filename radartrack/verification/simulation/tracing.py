"""What NumPy is asked to do with arrays, as a list: a function is called once with traces in their place."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import chain
from typing import Any

import numpy as np
from numpy.lib.mixins import NDArrayOperatorsMixin

SUMMED = {"add": "sum of products", "subtract": "difference of products"}


@dataclass(frozen=True)
class Step:
    """One operation, by its name in NumPy or `SUMMED`; inputs, constants and steps each have a place of their own."""

    operation: str
    place: int
    operands: tuple[int, ...]


@dataclass(frozen=True)
class Tape:
    """Operations on arrays.

    Attributes:
        inputs: how many there are; theirs are the first places.
        constants: place by number.
        steps: in order.
        results: their places.
        places: how many there are.
    """

    inputs: int
    constants: dict[float, int]
    steps: tuple[Step, ...]
    results: tuple[int, ...]
    places: int


def traced(function: Callable[[list[Any]], Sequence[Any]], inputs: int) -> Tape:
    """What the function does with that many arrays; what it asks for twice is in the list once.

    Raises:
        TypeError: when it wants more than operations on arrays and numbers.

    """
    recorder = _Recorder(inputs)
    results = function([_Trace(recorder, place) for place in range(inputs)])
    places = tuple(map(recorder.place, results))
    steps = tuple(Step(operation, place, operands) for (operation, operands), place in recorder.steps.items())
    return Tape(inputs, recorder.constants, steps, places, recorder.places)


def with_products_summed(tape: Tape) -> Tape:
    """The tape with one step for a b + c d, and for a + c d with 1 for b: the same bits, as neither is fused.

    Each product that is needed nowhere else need not be kept then.
    """
    uses = Counter(place for step in tape.steps for place in step.operands) + Counter(tape.results)
    products = {step.place: step for step in tape.steps if step.operation == "multiply" and uses[step.place] == 1}
    one = tape.constants.get(1.0, tape.places)
    put_in: set[int] = set()
    steps = []
    for step in tape.steps:
        needed = products.keys() & {*step.operands} if step.operation in SUMMED else set()
        factors = (products[place].operands if place in needed else (place, one) for place in step.operands)
        put_in |= needed
        summed = replace(step, operation=SUMMED[step.operation], operands=(*chain(*factors),)) if needed else step
        steps.append(summed)
    kept = tuple(step for step in steps if step.place not in put_in)
    return Tape(tape.inputs, {**tape.constants, 1.0: one}, kept, tape.results, max(tape.places, one + 1))


class _Recorder:
    def __init__(self, inputs: int) -> None:
        self.places = inputs
        self.constants: dict[float, int] = {}
        self.steps: dict[tuple[str, tuple[int, ...]], int] = {}

    def place(self, operand: Any) -> int:
        return operand.place if isinstance(operand, _Trace) else self._of(self.constants, float(operand))

    def step(self, operation: str, operands: Sequence[Any]) -> _Trace:
        return _Trace(self, self._of(self.steps, (operation, tuple(map(self.place, operands)))))

    def _of(self, known: dict[Any, int], key: Any) -> int:
        if key not in known:
            known[key] = self.places
            self.places += 1
        return known[key]


@dataclass(frozen=True, eq=False)
class _Trace(NDArrayOperatorsMixin):
    recorder: _Recorder
    place: int

    def __array_ufunc__(self, operation: np.ufunc, method: str, *operands: Any, **options: Any) -> Any:
        return NotImplemented if options or method != "__call__" else self.recorder.step(operation.__name__, operands)
