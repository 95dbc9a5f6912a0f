"""Decides the claims of a file, one after the other."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from radartrack.derive.catalogue import UnknownQuantity
from radartrack.derive.checking.papers.claim import Claim, UnreadableClaim, problems
from radartrack.derive.checking.papers.formula_claims import formula_verdicts
from radartrack.derive.checking.papers.number_claims import check_number
from radartrack.derive.checking.question.compared_quantity import UnknownEntry
from radartrack.derive.checking.question.world import CATALOGUE, World
from radartrack.derive.checking.reporting.verdict import Outcome, Verdict
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.reading.symbol_table import TableError


def decide(claim: Claim, world: World = CATALOGUE) -> Verdict:
    """The verdict on one claim, in the world of its paper.

    Raises:
        UnreadableClaim: naming the claim.
    """
    *_, verdict = decisions(claim, world)
    return verdict


def decisions(claim: Claim, world: World = CATALOGUE) -> Iterator[Verdict]:
    """The verdict on one claim, then the same with more and more said beside it.

    Raises:
        UnreadableClaim: naming the claim.
    """
    if claim.unreadable:
        raise UnreadableClaim(claim.unreadable)
    for problem in problems(claim):
        raise UnreadableClaim(f"claim {claim.id!r}: {problem}")
    if claim.undecided:
        yield Verdict(Outcome.UNDECIDED, claim.quantity, claim.printed, "", claim.undecided)
        return
    try:
        if claim.is_formula:
            yield from formula_verdicts(claim, world)
        else:
            yield check_number(claim, world)
    except (FormulaError, TableError, UnknownQuantity, UnknownEntry) as error:
        raise UnreadableClaim(f"claim {claim.id!r}: {error}") from None


def record(claim: Claim, verdict: Verdict) -> dict[str, Any]:
    """A claim with its verdict as plain data."""
    return claim.told | verdict.record()
