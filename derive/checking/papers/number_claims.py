"""Decides claims about numbers: a value at its printed precision, a maximum, a trend, a crossing, a bound."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import pairwise

from radartrack.derive.checking.comparing.printed_number import PrintedNumber
from radartrack.derive.checking.comparing.rounding_to_print import rounded, shown, shown_apart
from radartrack.derive.checking.papers.claim import Along, Claim
from radartrack.derive.checking.papers.claim_setting import HERE, Place, Setting
from radartrack.derive.checking.question.formula_units import WrongDimensions
from radartrack.derive.checking.question.world import CATALOGUE, World
from radartrack.derive.checking.reporting.verdict import Counterexample, Outcome, Verdict
from radartrack.derive.evaluation.exact_numbers import Exact, NoRealValue, Undecidable, compared, order, sign_of
from radartrack.derive.evaluation.many_digits import Number
from radartrack.derive.formula.error import FormulaError

BENT = ("convex", "concave")
UPWARDS = ("increasing", "convex")
SHOWN_VALUES = (4, 3)  # the first and the last of many


@dataclass(frozen=True)
class Answer:
    """Whether the claim holds, what was derived, and why."""

    derived: str
    reason: str
    printed_value: float | None = None
    derived_value: float | None = None
    holds: bool = field(kw_only=True)


def check_number(claim: Claim, world: World = CATALOGUE) -> Verdict:
    """Decide a claim about a number.

    Raises:
        UnknownQuantity, UnknownEntry, FormulaError: when the claim names what there is not, cannot be read, or sets
            a symbol to what it cannot be.
    """
    setting = Setting(claim, world)
    try:
        setting.check_unit()
        answer = _answer(claim, setting)
    except WrongDimensions as error:
        return _verdict(claim, Outcome.WRONG_DIMENSIONS, Answer("", str(error), holds=False), setting)
    except NoRealValue:
        raise FormulaError(f"{claim.quantity} is not defined there") from None
    except Undecidable as error:
        return _verdict(claim, Outcome.UNDECIDED, Answer("", f"cannot decide: {error}", holds=False), setting)
    return _verdict(claim, Outcome.EQUAL if answer.holds else Outcome.DIFFERS, answer, setting)


def _answer(claim: Claim, setting: Setting) -> Answer:
    if claim.maximum_over and (claim.value or claim.attained_at):
        return _maximum(claim, setting, claim.maximum_over)
    if claim.value:
        return _value(claim, setting, setting.value(HERE))
    if claim.trend:
        return _trend(claim, setting)
    if claim.crosses:
        return _crossing(claim, setting)
    return _bound(claim, setting)


def _maximum(claim: Claim, setting: Setting, over: Along) -> Answer:
    if len(over[1]) < 2:
        raise FormulaError(f"maximum_over: {over[0]} has one value; a maximum is taken over two or more")
    largest_at, largest = setting.maximum(HERE, over)
    value = _value(claim, setting, largest) if claim.value else None
    holds = value is None or value.holds
    if claim.attained_at:
        attained = setting.attained(over, claim.attained_at)
        holds = any(order(attained, place.position) == 0 for place in largest_at) and holds
    where = " and at ".join(place.where for place in largest_at[:3])
    found = f"{value.derived if value else _shown(claim, setting, largest)} at {where}"
    said = "the maximum is" if holds else "the maximum is instead"
    printed = value.printed_value if value else None
    return Answer(found, f"{said} {found}", printed, float(setting.shown(largest)[0]), holds=holds)


def _value(claim: Claim, setting: Setting, value: Exact) -> Answer:
    printed = PrintedNumber(claim.value, claim.significant)
    found = rounded(printed, value, setting.unit)
    derived = found.shown + _unit(claim)
    if found.is_tie:
        rounds = "rounds to" if found.holds else "does not round to"
        reason = f"{derived} is midway, and {rounds} {claim.value}, be it half up or half to the even digit"
    elif not found.holds:
        reason = f"derived is {derived}, printed {claim.value}{_unit(claim)}"
    elif found.shown == claim.value:
        reason = f"derived is {derived}, as printed"
    else:
        reason = f"{derived} rounds to {claim.value}{_unit(claim)}"
    return Answer(derived, reason, float(printed.value), float(setting.shown(value)[0]), holds=found.holds)


def _trend(claim: Claim, setting: Setting) -> Answer:
    places = setting.places(claim.along)
    if len(places) < (3 if claim.trend in BENT else 2):
        raise FormulaError(f"along: {claim.trend} needs {'three' if claim.trend in BENT else 'two'} values or more")
    values = [setting.value(place) for place in places]
    turns = _bends(places, values) if claim.trend in BENT else [compared(one, other) for other, one in pairwise(values)]
    wanted = 1 if claim.trend in UPWARDS else -1
    against = next((place for place, turn in zip(places[1:], turns, strict=False) if turn != wanted), None)
    texts = _few(shown_apart(*setting.shown(*values)))
    derived = ", ".join(texts) + _unit(claim)
    ends = f"from {places[0].where} to {places[-1].where}"
    if against is None:
        return Answer(derived, f"{claim.trend} {ends}", holds=True)
    return Answer(derived, f"not {claim.trend} at {against.where}: the values {ends} are {derived}", holds=False)


def _bends(places: Sequence[Place], values: Sequence[Exact]) -> list[int]:
    """At each inner point 1 where the slope grows, -1 where it falls, 0 where it stays."""
    positions = [Exact.of(place.position) for place in places]
    return [sign_of(_bend, *positions[at : at + 3], *values[at : at + 3]) for at in range(len(places) - 2)]


def _bend(x_0: Number, x_1: Number, x_2: Number, y_0: Number, y_1: Number, y_2: Number) -> Number:
    """The change of slope, times the two distances, which are positive."""
    return (y_2 - y_1) * (x_1 - x_0) - (y_1 - y_0) * (x_2 - x_1)


def _crossing(claim: Claim, setting: Setting) -> Answer:
    places = setting.places(claim.along)
    if len(places) != 2:
        raise FormulaError("along: a crossing needs two values, one before it and one after it")
    level_at = setting.level(claim.crosses)
    values, levels = [setting.value(place) for place in places], [level_at(place) for place in places]
    sides = [compared(value, level) for value, level in zip(values, levels, strict=True)]
    texts = shown_apart(*setting.shown(values[0], levels[0], levels[1], values[1]))
    derived = " and ".join(
        f"{text}{_unit(claim)} at {place.where}" for text, place in zip((texts[0], texts[3]), places, strict=True)
    )
    level = " and ".join(dict.fromkeys(texts[1:3])) + _unit(claim)
    holds = sides[0] * sides[1] <= 0 and sides != [0, 0]
    return Answer(
        derived, f"{derived}: the level {level} is {'' if holds else 'not '}crossed between them", holds=holds
    )


def _bound(claim: Claim, setting: Setting) -> Answer:
    side, word = (1, "above") if claim.at_most else (-1, "below")
    level_at = setting.level(claim.at_most or claim.at_least)
    found = [(place, setting.value(place), level_at(place)) for place in setting.places(claim.along)]
    extreme = found[0]
    for one in found[1:]:
        extreme = one if compared(one[1], extreme[1]) == side else extreme
    broken = next((one for one in found if compared(one[1], one[2]) == side), None)
    derived = _shown(claim, setting, extreme[1]) + _at(extreme[0])
    if broken is None:
        which = "" if len(found) == 1 else "largest " if claim.at_most else "smallest "
        return Answer(derived, f"the {which}value is {derived}", holds=True)
    place, value, level = broken
    texts = shown_apart(*setting.shown(value, level))
    reason = f"{texts[0]}{_unit(claim)}{_at(place)} is {word} {texts[1]}{_unit(claim)}"
    return Answer(derived, reason, holds=False)


def _verdict(claim: Claim, outcome: Outcome, answer: Answer, setting: Setting) -> Verdict:
    return Verdict(
        verdict=outcome,
        quantity=claim.quantity,
        printed=claim.printed,
        derived=answer.derived,
        reason=answer.reason,
        counterexample=_counterexample(answer, setting) if outcome is Outcome.DIFFERS else None,
    )


def _counterexample(answer: Answer, setting: Setting) -> Counterexample | None:
    """Both numbers; none where one is beyond the numbers of a machine, which the reason shows."""
    printed, derived = answer.printed_value, answer.derived_value
    if printed is None or derived is None or not math.isfinite(derived):
        return None
    relative = abs(printed - derived) / abs(derived or printed or 1)
    return Counterexample(setting.point, (), printed, derived, relative, setting.units)


def _shown(claim: Claim, setting: Setting, value: Exact) -> str:
    return shown(setting.shown(value)[0]) + _unit(claim)


def _at(place: Place) -> str:
    return f" at {place.where}" if place.where else ""


def _unit(claim: Claim) -> str:
    return f" {claim.unit}" if claim.unit not in {"", "1"} else ""


def _few(texts: Sequence[str]) -> list[str]:
    """All, or the first and last of many."""
    first, last = SHOWN_VALUES
    return list(texts) if len(texts) <= first + last + 1 else [*texts[:first], "...", *texts[-last:]]
