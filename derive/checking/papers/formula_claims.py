"""Decides claims about formulas: that one is a quantity, that two are the same, that each step of a chain is right."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise

from radartrack.derive.checking.answers import Question
from radartrack.derive.checking.asking import ask, ask_identity
from radartrack.derive.checking.check import too_much
from radartrack.derive.checking.papers.claim import Claim
from radartrack.derive.checking.papers.error_claims import bounded
from radartrack.derive.checking.papers.implicit_claims import asked_of_equations, solution_verdicts
from radartrack.derive.checking.question.sense import Sense
from radartrack.derive.checking.question.world import World
from radartrack.derive.checking.reporting.verdict import GRAVITY, Outcome, Verdict
from radartrack.derive.verbs.no_closed_form import NoClosedForm


def formula_verdicts(claim: Claim, world: World) -> Iterator[Verdict]:
    """The verdict on a claim, then the same with more beside it.

    Raises:
        FormulaError, UnknownQuantity, UnknownEntry: when it cannot be read.
    """
    if claim.error_at_most:
        yield from bound_verdicts(claim, world)
        return
    steps = list(pairwise(claim.chain)) or [(claim.left, claim.right)]
    try:
        if (implicit := asked_of_equations(claim, world)) is not None:
            yield from solution_verdicts(claim, *implicit, world)
        elif not claim.is_identity:
            yield from _question(claim, world).answers()
        elif len(steps) == 1:
            yield from _step(claim, *steps[0], world)
        else:
            yield from _chain(claim, steps, world)
    except NoClosedForm as error:
        yield too_much(claim.quantity or claim.left, claim.printed, error)


def sense_of(claim: Claim) -> Sense:
    """In which sense the formula of a claim is meant."""
    return Sense(claim.to_order, claim.limit, claim.within)


def _step(claim: Claim, left: str, right: str, world: World) -> Iterator[Verdict]:
    sense = sense_of(claim)
    question = ask_identity(left, right, given=claim.given, let=claim.let, world=world, sense=sense, alike=claim.chain)
    yield from question.answers()


def bound_verdicts(claim: Claim, world: World) -> Iterator[Verdict]:
    """Whether the error of an approximation stays within what is said of it: as it is found, then as it is proved."""
    if not claim.is_identity:
        return bounded(_question(claim, world), claim.error_at_most)
    sense = sense_of(claim)
    question = ask_identity(claim.left, claim.right, given=claim.given, let=claim.let, world=world, sense=sense)
    return bounded(question, claim.error_at_most)


def _question(claim: Claim, world: World) -> Question:
    """Whether the formula of a claim is its quantity."""
    return ask(
        claim.quantity,
        claim.formula or claim.latex or claim.code,
        latex=bool(claim.latex),
        code=claim.language,
        function=claim.function,
        given=claim.given,
        let=claim.let,
        world=world,
        sense=sense_of(claim),
    )


def _chain(claim: Claim, steps: list[tuple[str, str]], world: World) -> Iterator[Verdict]:
    """What is found of the first step that is wrong; else of the one of which least is known."""
    whole = " = ".join(claim.chain)
    doubtful: Verdict | None = None
    for number, (left, right) in enumerate(steps, start=1):
        words = f"step {number} of {len(steps)}"
        try:
            for verdict in _step(claim, left, right, world):
                if not (verdict.is_equal or verdict.verdict is Outcome.UNDECIDED):
                    yield replace(verdict, reason=f"{words}: {verdict.reason}")
            if not (verdict.is_equal or verdict.verdict is Outcome.UNDECIDED):
                return
        except NoClosedForm as error:
            verdict = too_much(left, right, error)
        if doubtful is None or GRAVITY.index(verdict.verdict) > GRAVITY.index(doubtful.verdict):
            doubtful = (
                verdict if verdict.verdict is Outcome.EQUAL else replace(verdict, reason=f"{words}: {verdict.reason}")
            )
    if doubtful is not None:
        same = doubtful.verdict is Outcome.EQUAL
        yield replace(
            doubtful, quantity=claim.chain[0], printed=whole, reason="every step is proved" if same else doubtful.reason
        )
