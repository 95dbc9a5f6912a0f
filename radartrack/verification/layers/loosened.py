"""A layer that looks at code, with the bound that single precision allows."""

from __future__ import annotations

from dataclasses import dataclass, replace

from radartrack.derive.language.quantity import Quantity
from radartrack.verification.layers.ulp_search import Accuracy
from radartrack.verification.outcome import Function, Layer, Outcome

RELATIVE = 1e-4  # a thousand roundings of 2^-24; slips of a formula are far larger


@dataclass(frozen=True)
class Loosened:
    """What differs by no more than roundings of single precision passes.

    Attributes:
        layer: whose figure is a relative difference.
    """

    layer: Layer

    @property
    def name(self) -> str:
        """That of the layer."""
        return self.layer.name

    def __call__(self, quantity: Quantity, function: Function) -> Outcome:
        """The same figure against another bound."""
        found = self.layer(quantity, function)
        if found.figure is None or found.bound is None:
            return found
        return Outcome.measured(found.layer, found.figure, max(found.bound, RELATIVE), found.detail)


def in_single(layer: Layer) -> Layer:
    """The layer for functions in single precision."""
    return replace(layer, single=True) if isinstance(layer, Accuracy) else Loosened(layer)
