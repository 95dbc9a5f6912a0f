"""What a layer of verification says of one function, and what it says it about."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from typing import Any, Protocol

import numpy as np

from radartrack.derive.language.quantity import Quantity

Function = Callable[..., Any]
FUNCTION = "function"  # the path to a quantity that is its own

BROKEN = (
    ArithmeticError,
    AttributeError,
    ImportError,
    LookupError,
    NameError,
    RuntimeError,
    TypeError,
    ValueError,
)
"""What code that breaks down may raise, the compiler of machine code among it."""


class Verdict(StrEnum):
    """Whether a layer found nothing wrong, found something, or has nothing to say."""

    PASSED = "passed"
    FAILED = "failed"
    NOT_APPLICABLE = "not applicable"


@dataclass(frozen=True)
class Outcome:
    """One layer's answer.

    Attributes:
        layer: its name.
        figure: what was measured; None where the layer does not apply.
        bound: what it may not exceed.
        verdict: whether it does.
        detail: what was compared, or why the layer does not apply.
        figures: of each path that users take to the quantity, where there are several.
    """

    layer: str
    figure: float | None
    bound: float | None
    verdict: Verdict
    detail: str
    figures: Mapping[str, float | None] = field(default_factory=dict)

    @classmethod
    def measured(
        cls, layer: str, figure: float, bound: float, detail: str, figures: Mapping[str, float | None] | None = None
    ) -> Outcome:
        """Passed when the figure is within the bound; a figure that is no number fails."""
        verdict = Verdict.PASSED if figure <= bound else Verdict.FAILED
        return cls(layer, figure, bound, verdict, detail, figures or {})

    @classmethod
    def failed(cls, layer: str, reason: str) -> Outcome:
        """Nothing could be measured, and that is a fault of the function."""
        return cls(layer, None, None, Verdict.FAILED, reason)

    @classmethod
    def not_applicable(cls, layer: str, reason: str) -> Outcome:
        """The layer has nothing to say of this quantity."""
        return cls(layer, None, None, Verdict.NOT_APPLICABLE, reason)

    @classmethod
    def read(cls, record: Mapping[str, Any]) -> Outcome:
        """From what JSON has of it."""
        return cls(**{**record, "verdict": Verdict(record["verdict"])})

    @property
    def severity(self) -> tuple[int, float]:
        """How much it says against the function; what does not apply says least."""
        ranks = (Verdict.NOT_APPLICABLE, Verdict.PASSED, Verdict.FAILED)
        return ranks.index(self.verdict), self.badness

    @property
    def badness(self) -> float:
        """The figure in units of its bound; infinite for a failure without a figure."""
        if self.verdict is Verdict.NOT_APPLICABLE:
            return 0.0
        if self.figure is None or not self.bound:
            return float("inf") if self.verdict is Verdict.FAILED else 0.0
        return self.figure / self.bound


class Layer(Protocol):
    """A way to find out that a generated function is wrong."""

    @property
    def name(self) -> str:
        """What tables and records call it."""
        ...

    def __call__(self, quantity: Quantity, function: Function) -> Outcome:
        """Measure one function against what it should be."""
        ...


def examined(layer: Layer, quantity: Quantity, function: Function) -> Outcome:
    """The layer's answer; a function that makes it break down has failed it."""
    try:
        with np.errstate(all="ignore"):  # what is no number is a figure that fails, and no warning
            return layer(quantity, function)
    except BROKEN as error:
        return Outcome.failed(layer.name, f"{type(error).__name__}: {error}")
