"""What NumPy is asked to do with arrays, as a list: a function is called once with traces in their place."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.lib.mixins import NDArrayOperatorsMixin


@dataclass(frozen=True)
class Step:
    """One operation, by its name in NumPy; inputs, constants and steps each have a place of their own."""

    operation: str
    place: int
    operands: tuple[int, ...]


@dataclass(frozen=True)
class Tape:
    """Operations on arrays.

    Attributes:
        constants: number by place; the inputs have the first places.
        steps: in order.
        results: their places.
        places: how many there are.
    """

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
    return Tape(recorder.constants, steps, places, recorder.places)


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
