"""Layer: a bound of the rounding errors over the whole domain, proved from the statements as they are written."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from importlib.util import find_spec

from radartrack.derive.language.quantity import Quantity
from radartrack.verification.outcome import Function, Outcome
from radartrack.verification.rounding.certificates import Row, confirmed_bound, kept, proved_bounds, source_of
from radartrack.verification.rounding.checker.known_numbers import Refused
from radartrack.verification.subject import NotGenerated, generated

NAME = "rounding"
DOUBLE = "double"
SAID = {"correlated": "correlations up to 0.99", "single": "single precision"}


@dataclass(frozen=True)
class Rounding:
    """The certificate that comes with the package, checked again against the code that is there."""

    name: str = NAME

    def __call__(self, quantity: Quantity, function: Function) -> Outcome:
        """The proved bound in ulp; a certificate that does not hold of the code as it stands is a failure."""
        row = _certificates().get(quantity.name)
        if row is None or not _is_generated(quantity, function):
            return Outcome.not_applicable(NAME, "certificates are of the catalogue's generated functions")
        bounds = proved_bounds(row)
        if DOUBLE not in bounds:
            return Outcome.not_applicable(NAME, f"measured, not proved: {row[DOUBLE]['reason']}")
        if find_spec("flint") is None:
            return Outcome.not_applicable(NAME, "the checker needs python-flint")
        try:
            found = {kind: confirmed_bound(quantity, row, source_of(quantity), kind) for kind in bounds}
        except Refused as error:
            return Outcome.failed(NAME, str(error))
        others = "".join(f", {SAID[kind]} {bound:.3g} ulp" for kind, bound in found.items() if kind != DOUBLE)
        detail = f"proved over the whole domain, independent errors{others}"
        return Outcome.measured(NAME, found[DOUBLE], bounds[DOUBLE], detail)


def _is_generated(quantity: Quantity, function: Function) -> bool:
    try:
        return function is generated(quantity)
    except NotGenerated:
        return False


@cache
def _certificates() -> dict[str, Row]:
    return kept()
