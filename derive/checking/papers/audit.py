"""Decides the claims of a file, one after the other."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from radartrack.derive.catalogue import UnknownQuantity
from radartrack.derive.checking.check import ask
from radartrack.derive.checking.papers.claims_file import Claim, UnreadableClaim, problems
from radartrack.derive.checking.papers.number_claims import check_number
from radartrack.derive.checking.question.compared_quantity import UnknownEntry
from radartrack.derive.checking.reporting.verdict import Outcome, Verdict
from radartrack.derive.formula.error import FormulaError


def decide(claim: Claim) -> Verdict:
    """The verdict on one claim.

    Raises:
        UnreadableClaim: naming the claim.
    """
    *_, verdict = decisions(claim)
    return verdict


def decisions(claim: Claim) -> Iterator[Verdict]:
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
        if not claim.is_formula:
            yield check_number(claim)
            return
        yield from ask(
            claim.quantity,
            claim.formula or claim.latex or claim.code,
            latex=bool(claim.latex),
            code=claim.language,
            function=claim.function,
            given=claim.given,
            let=claim.let,
        ).answers()
    except (FormulaError, UnknownQuantity, UnknownEntry) as error:
        raise UnreadableClaim(f"claim {claim.id!r}: {error}") from None


def record(claim: Claim, verdict: Verdict) -> dict[str, Any]:
    """A claim with its verdict as plain data."""
    told = {
        "id": claim.id,
        "equation": claim.equation,
        "page": claim.page,
        "note": claim.note,
        "at": dict(claim.at),
    }
    return told | verdict.record()
