"""Which quantities a formula is, for the page."""

from __future__ import annotations

import json
from collections.abc import Iterator
from functools import cache
from importlib.resources import files
from typing import Any

from radartrack.derive.checking.papers import audit
from radartrack.derive.checking.papers.claim import Claim, UnreadableClaim
from radartrack.derive.checking.papers.mathml import mathml
from radartrack.derive.finding.formula_search import Candidate, FormulaSearch
from radartrack.derive.formula.tree import Tree

PROVED = 6  # candidates that are proved, of those that are worth the same


def found(tree: Tree) -> Iterator[dict[str, Any]]:
    """What is found so far, each time with one more: what the formula is proved to be, else what it is near."""
    quantities: list[dict[str, Any]] = []
    for candidate in _search().candidates(tree)[:PROVED]:
        if (words := _proved(candidate)) is not None:
            quantities.append(_told(candidate, words))
            yield {"quantities": quantities, "near": []}
    if not quantities:
        near = [
            _told(one, f"near: at most {one.difference * 100:.2g} % apart at three points")
            for one in _search().near(tree)
        ]
        yield {"quantities": [], "near": near}


@cache
def _search() -> FormulaSearch:
    text = files("radartrack.generated").joinpath("screening.json").read_text(encoding="utf-8")
    return FormulaSearch(json.loads(text))


def _proved(candidate: Candidate) -> str | None:
    """How a formula is known to be a quantity; None where it is not."""
    claim = Claim("formula", candidate.quantity, candidate.formula, given=candidate.given, let=candidate.let)
    try:
        verdict = audit.decide(claim)
    except UnreadableClaim:  # an entry that the quantity of today does not have
        return None
    if not verdict.is_equal:
        return None
    return "proved" if verdict.verdict == "equal" else verdict.reason


def _told(candidate: Candidate, words: str) -> dict[str, Any]:
    return {
        "quantity": candidate.quantity,
        "meaning": candidate.meaning,
        "given": dict(candidate.given),
        "convention": candidate.convention,
        "read": dict(candidate.read),
        "formula": candidate.formula,
        "mathml": mathml(candidate.formula),
        "words": words,
    }
