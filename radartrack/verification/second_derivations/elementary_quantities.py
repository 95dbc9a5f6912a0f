"""Second derivations of the quantities that belong to no measurement model and no filter, by name."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from radartrack.derive.language.tensor import Tensor
from radartrack.verification.second_derivations import (
    arcs,
    best_weights,
    doubling,
    straight_lines,
    taylor_terms,
    track_starts,
    van_loan_motion,
)
from radartrack.verification.second_derivations.sites import between_sites, on_the_earth

Number = Any


@dataclass(frozen=True)
class Second:
    """Another way to a quantity: in words, and from the numbers of its symbols."""

    method: str
    values: Callable[[Mapping[str, Number]], Tensor[Number]]


ELEMENTARY = {
    name: Second(module.METHOD, values)
    for module in (
        straight_lines,
        best_weights,
        van_loan_motion,
        taylor_terms,
        arcs,
        doubling,
        between_sites,
        on_the_earth,
        track_starts,
    )
    for name, values in module.DERIVATIONS.items()
}
