"""Layer: a bound of the rounding errors over the whole domain, proved from the statements as they are written."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from importlib.util import find_spec

from radartrack.derive.language.quantity import Quantity
from radartrack.verification.outcome import Function, Outcome
from radartrack.verification.rounding.certificate_checker import Refused
from radartrack.verification.rounding.certificates import Row, confirmed_bound, kept, source_of
from radartrack.verification.subject import NotGenerated, generated

NAME = "rounding"


@dataclass(frozen=True)
class Rounding:
    """The certificate that comes with the package, checked again against the code that is there."""

    name: str = NAME

    def __call__(self, quantity: Quantity, function: Function) -> Outcome:
        """The proved bound in ulp; a certificate that does not hold of the code as it stands is a failure."""
        row = _certificates().get(quantity.name)
        if row is None or not _is_generated(quantity, function):
            return Outcome.not_applicable(NAME, "certificates are of the catalogue's generated functions")
        if "bound" not in row:
            return Outcome.not_applicable(NAME, f"measured, not proved: {row['reason']}")
        if find_spec("flint") is None:
            return Outcome.not_applicable(NAME, "the checker needs python-flint")
        try:
            found = confirmed_bound(quantity, row, source_of(quantity))
        except Refused as error:
            return Outcome.failed(NAME, str(error))
        boxes = sum(tree.count(".") for tree in row["trees"].values())
        return Outcome.measured(NAME, found, row["bound"], f"proved in {boxes} boxes of the domain, independent errors")


def _is_generated(quantity: Quantity, function: Function) -> bool:
    try:
        return function is generated(quantity)
    except NotGenerated:
        return False


@cache
def _certificates() -> dict[str, Row]:
    return kept()
