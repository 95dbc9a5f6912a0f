"""Checks certificates of rounding errors: in every box the claimed bound is derived again, in ball arithmetic.

It shares no code with the search by enclosures. So what it confirms is proved, given the assumptions: the standard
model of floating point, and the `ulps` of the elementary functions.
"""

from __future__ import annotations

import ast
import math
from collections.abc import Mapping
from contextlib import AbstractContextManager
from typing import Any

from radartrack.verification.rounding.checker.domain_cases import Claim, boxes_of, cases_of, chosen_in
from radartrack.verification.rounding.checker.followed_statements import Open, parsed
from radartrack.verification.rounding.checker.given_arguments import Way, with_arguments
from radartrack.verification.rounding.checker.known_numbers import Refused, Undefined
from radartrack.verification.rounding.checker.scaled_errors import largest_error

BITS = 53  # of balls
GOOD = 16.0  # a bound that no second way of telling errors is tried for
WAYS = (
    Way(in_parts=True),
    Way(in_parts=False),
    Way(in_parts=True, rounded_whole=True),
    Way(in_parts=True, signed_whole=True),
    Way(in_parts=True, factors_whole=True),
    Way(in_parts=True, factors_whole=True, by_argument=True),
)


def confirmed(source: str, claim: Claim) -> float:
    """The bound that a certificate proves, in ulp of the scale.

    Args:
        source: the text of the generated module.
        claim: with `function`, `arguments` (name, low, high, kind, and of whole numbers `whole` and `at_most`),
            `shape`, `scale`, `groups`, `correlated`, `precision`, and `trees`, of every case how its box is split.
            Where the scale is a formula of its own, `stated` is a function that computes it, written like the module's,
            and `paired` whether that of every entry is the geometric mean of its row's and its column's. With `sides`
            the signs of an angle's cosine are cases of their own, as they are with correlations. `ways` may name those
            of `WAYS` that suffice, by number.

    Raises:
        Refused: the boxes do not cover the domain, or a statement cannot be followed in one of them.
    """
    if set(claim["trees"]) != set(cases_of(claim)):
        raise Refused("the cases are not those of the domain")
    worst = 0.0
    for case, tree in claim["trees"].items():
        for box in boxes_of(claim, case, tree):
            worst = max(worst, figure(source, claim, case, box))
    return worst


def figure(source: str, claim: Claim, case: str, box: Mapping[str, tuple[float, float]]) -> float:
    """The largest error of an entry in one box."""
    functions = {node.name: node for node in parsed(source).body if isinstance(node, ast.FunctionDef)}
    if claim["function"] not in functions:
        raise Refused(f"there is no function {claim['function']}")
    waiting: list[dict[str, bool]] = [{}]
    worst = 0.0
    with _precision():
        while waiting:
            outcomes = waiting.pop()
            try:
                worst = max(worst, _best(functions, claim, case, box, outcomes))
            except Undefined:
                if tuple(claim["shape"]):
                    raise
            except Open as question:
                waiting += [{**outcomes, str(question): answer} for answer in (False, True)]
    return worst


def _precision() -> AbstractContextManager[Any]:
    """Of balls; what else runs in this process sets another, and a bound depends on it."""
    import flint  # noqa: PLC0415

    found: AbstractContextManager[Any] = flint.ctx.workprec(BITS)
    return found


def _best(
    functions: Mapping[str, ast.FunctionDef],
    claim: Claim,
    case: str,
    ends: Mapping[str, tuple[float, float]],
    outcomes: Mapping[str, bool],
) -> float:
    """The smallest of the bounds that the ways of telling errors give."""
    chosen, found = chosen_in(case), math.inf
    reason = Refused("no bound")
    for way in (WAYS[number] for number in claim.get("ways", range(len(WAYS)))):
        run = with_arguments(claim, chosen, ends, way)
        run.helpers, run.outcomes = functions, outcomes
        try:
            found = min(found, largest_error(functions[claim["function"]], claim, run))
        except Refused as error:
            reason = error
        if found < GOOD:
            break
    if not math.isfinite(found):
        raise reason
    return found
