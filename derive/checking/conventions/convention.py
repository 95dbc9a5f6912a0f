"""Conventions in which a formula may be printed: what they change in the print, and in what is expected of it."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import chain, combinations
from math import factorial, prod
from typing import TypeVar

from radartrack.derive import symbolic as sp
from radartrack.derive.catalogue import catalogue
from radartrack.derive.checking.conventions.altered_question import Asked
from radartrack.derive.checking.question.compared_quantity import understood_by
from radartrack.derive.checking.question.conditions import joined, under, when, zero
from radartrack.derive.language.shared_symbols import T
from radartrack.derive.language.tensor import Index
from radartrack.derive.language.variable import Variable
from radartrack.derive.symbolic import Expr, Symbol
from radartrack.derive.units import METRE, RADIAN, SECOND, Unit

_IN_SPACE = re.compile(r"(?:observe\.|initiation\.one_plot\.)?spherical(?!\w*\.(?:std|validity))|frames\.enu_from_ecef")
LENGTHS = {METRE, METRE**-1}
POLYNOMIAL = {"fading_memory", "finite_sample", "steady_state"}
IN_DEGREES = sp.Integer(180) / sp.pi
SEVERAL = 2
PER_RADIAN = RADIAN**-1
PER_SECOND = RADIAN / SECOND
_OF_VARIANCE = re.compile(r"(?:covariance|variance|process_noise)(?!.*(?:correlation|factor))")
_NUMBER = re.compile(r"_?\d+$|^(?:first|second|third)_")
Name = TypeVar("Name")
ONE, NOTHING = sp.Integer(1), sp.Integer(0)


@dataclass(frozen=True)
class Convention:
    """How a print may differ from ours without being wrong.

    Attributes:
        replaced: what is put for what, in words.
        notes: what that means, in words.
        changes: what stands in the print for symbols.
        inverse: what stands in ours for the symbols of the print.
        vanishing: the correlations that are zero.
        factors: by which an entry of what is derived is multiplied first.
        offsets: and what is added to it then.
        cost: how unlikely it is that the print follows it, on the scale of edits.
        is_slip: whether a slip may have done the same to a formula in which it changes one place.
        alike: symbols that are the same as others: the deviations of two equal sensors.
    """

    replaced: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()
    changes: Mapping[Symbol, Expr] = field(default_factory=dict)
    inverse: Mapping[Symbol, Expr] = field(default_factory=dict)
    vanishing: tuple[Symbol, ...] = ()
    factors: Mapping[Index, Expr] = field(default_factory=dict)
    offsets: Mapping[Index, Expr] = field(default_factory=dict)
    cost: float = 0.0
    is_slip: bool = False
    alike: Mapping[Symbol, Expr] = field(default_factory=dict)

    @property
    def words(self) -> str:
        """The convention in words after "equal"; nothing for ours."""
        replaced = f" with {' and '.join(self.replaced)}" if self.replaced else ""
        notes = f": {'; '.join(dict.fromkeys(self.notes))}" if self.notes else ""
        return f"{replaced}{when(self._conditions)}{notes}"

    def conditions(self, others: Mapping[Symbol, Expr]) -> dict[Symbol, Expr]:
        """Conditions and those of the convention; as they are where they have no value then."""
        both = joined(others, self._conditions)
        return dict(others) if both is None else both

    @property
    def _conditions(self) -> dict[Symbol, Expr]:
        return {**zero(self.vanishing), **self.alike}

    @property
    def is_ours(self) -> bool:
        """Whether it changes nothing."""
        return not (self.changes or self.vanishing or self.alike or self.factors or self.offsets)

    def expected(self, place: Index, entry: Expr) -> Expr:
        """What is printed for an entry of what was derived."""
        return self.factors.get(place, ONE) * entry + self.offsets.get(place, NOTHING)

    def __and__(self, other: Convention) -> Convention:
        """Both together; what the other changes is changed by this one too."""
        changes = {symbol: under(self.changes, value) for symbol, value in other.changes.items()}
        inverse = {symbol: under(other.inverse, value) for symbol, value in self.inverse.items()}
        places = {*self.factors, *other.factors, *self.offsets, *other.offsets}
        factors = {p: self.factors.get(p, ONE) * other.factors.get(p, ONE) for p in places}
        offsets = {p: self.offsets.get(p, NOTHING) * other.factors.get(p, ONE) for p in self.offsets}
        return Convention(
            (*self.replaced, *other.replaced),
            (*self.notes, *other.notes),
            {**self.changes, **changes},
            {**other.inverse, **inverse},
            (*self.vanishing, *other.vanishing),
            factors,
            {**other.offsets, **offsets},
            self.cost + other.cost,
            self.is_slip and other.is_slip,
            {**self.alike, **other.alike},
        )


OURS = Convention()


def conventions(asked: Asked) -> Iterator[Convention]:
    """Ours, each other one alone, and every two that go together; each with and without correlation."""
    angles, returned = [*_other_axes(asked), *_other_senses(asked)], [*_returned_angles(asked)]
    degrees, variances = [*_degrees(asked)], [*_variances(asked)]
    kinds = (angles, returned, degrees, variances, [*_downwards(asked)])
    scaled, divided = [*_scaled_derivatives(asked)], [*_divided_gains(asked)]
    alone = [*_equal_sensors(asked), *_compass_headings(asked), *_roots(asked)]
    singles = [OURS, *chain.from_iterable(kinds), *scaled, *divided, *alone]
    pairs = (a & b for first, second in combinations((*kinds, scaled, divided), 2) for a in first for b in second)
    free = asked.correlations
    vanish = bool(free) and _are_hardly_used(free, asked)
    for one in (*singles, *pairs):
        yield one
        if vanish:
            yield one & Convention(vanishing=tuple(free), cost=0.6, is_slip=True)


def _are_hardly_used(correlations: Sequence[Symbol], asked: Asked) -> bool:
    """Whether a print has none of these; one entry of several that has one may be the slip."""
    having = sum(bool(entry.free_symbols & set(correlations)) for entry in asked.printed)
    return not having or (having == 1 and len(asked.printed.entries) > SEVERAL)


def _equal_sensors(asked: Asked) -> Iterator[Convention]:
    """One letter for what is numbered: the deviations of sensors of one kind, the covariances of plots of one radar.

    D_1 in each place where D_1 or D_2 should stand is a slip.
    """
    used = _used(asked)
    unnumbered = {symbol for name, symbol in asked.letters.items() if not _NUMBER.search(name)}
    groups: dict[tuple[str, Unit], list[Variable]] = {}
    for symbol in asked.reference.symbols:
        if (stem := _NUMBER.sub("", symbol.name)) != symbol.name:
            groups.setdefault((stem, symbol.unit), []).append(symbol)
    alike: dict[Symbol, Expr] = {}
    for group in groups.values():
        kept = [symbol for symbol in group if symbol in used]
        one = kept[0] if kept else group[0]
        free = not any(symbol in asked.conditions for symbol in group)
        if len(kept) <= 1 < len(group) and free and (one in unnumbered or not _is_in_place_of(one, group, asked)):
            alike |= {symbol: one for symbol in group if symbol != one}
    if alike:
        yield Convention(alike=alike, cost=0.6)


def _is_in_place_of(one: Symbol, group: Sequence[Symbol], asked: Asked) -> bool:
    """Whether a symbol stands as often as all of a group should."""
    derived = asked.reference.entries
    return sum(entry.count(one) for entry in asked.printed) == sum(
        entry.count(symbol) for entry in derived for symbol in group
    )


def _used(asked: Asked) -> set[Symbol]:
    return set[Symbol]().union(*(entry.free_symbols for entry in asked.printed)) - set(asked.conditions)


def _other_axes(asked: Asked) -> Iterator[Convention]:
    """Any of the printed angles counted from the other axis: derivatives by them change their sign.

    A correlation with one may change its sign then; where the print has none although what was derived has, there is
    none.
    """
    measured = _angles(asked)
    names = list(dict.fromkeys(_name(one) for one in measured))
    for turned in _subsets(names):
        angles = [one for one in measured if _name(one) in turned]
        if not _used(asked) & set(angles) and not _derived_by(asked, turned):
            continue
        replaced = tuple(f"pi/2 - {one} for {one}" for one in angles)
        notes = ("counted from the other axis",)
        changes: dict[Symbol, Expr] = {one: sp.pi / 2 - one for one in angles}
        factors = _signs(asked, turned)
        cost = 0.9 + 0.1 * len(turned)
        yield Convention(replaced, notes, changes, changes, (), factors, {}, cost, is_slip=True)
        if free := [one for one in asked.correlations if one in _used(asked)]:
            opposite: dict[Symbol, Expr] = {one: -one for one in free}
            words = tuple(f"-{one} for {one}" for one in free)
            both: dict[Symbol, Expr] = {**changes, **opposite}
            yield Convention((*replaced, *words), notes, both, both, (), factors, {}, cost + 0.1, is_slip=True)


def _other_senses(asked: Asked) -> Iterator[Convention]:
    """A rate of turn counted the other way: clockwise."""
    for one in asked.reference.symbols:
        if one.unit == PER_SECOND and one.low < 0 < one.high and one in _used(asked):
            opposite: dict[Symbol, Expr] = {one: -one}
            words, notes = (f"-{one} for {one}",), ("counted the other way",)
            yield Convention(words, notes, opposite, opposite, cost=0.9, is_slip=True)


def _compass_headings(asked: Asked) -> Iterator[Convention]:
    """A heading of the state from the y axis, clockwise, before and after a period, and its rate counted so too."""
    part, used = asked.reference.part, _used(asked)
    headings = [one for one in _angles(asked) if one.low < 0]
    rates = [one for one in asked.reference.symbols if one.unit == PER_SECOND and one.low < 0 < one.high]
    if part is None or not (headings and rates and used & {*headings, *rates}) or part.quantity.module != "motion":
        return
    turned = {RADIAN, RADIAN**-1, PER_SECOND, PER_SECOND**-1}
    axes = part.quantity.axes
    along = {p: [axis[i] for axis, i in zip(axes, place, strict=True)] for p, place in part.places.items()}
    signs = {p: sp.Integer((-1) ** sum(unit in turned for unit in units)) for p, units in along.items()}
    factors: dict[Index, Expr] = {p: sign for p, sign in signs.items() if sign != 1}
    offsets: dict[Index, Expr] = {p: sp.pi / 2 for p, units in along.items() if units == [RADIAN]}
    changes: dict[Symbol, Expr] = {one: sp.pi / 2 - one for one in headings}
    changes.update((one, -one) for one in rates)
    words = tuple(f"pi/2 - {one} for {one}" for one in headings) + tuple(f"-{one} for {one}" for one in rates)
    notes = ("headings counted from the y axis, clockwise",)
    yield Convention(words, notes, changes, changes, (), factors, offsets, 1.0, is_slip=True)


def _roots(asked: Asked) -> Iterator[Convention]:
    """The root or the inverse of a variance where it is meant, and the square of a deviation."""
    part = asked.reference.part
    if part is None or len(asked.printed.entries) > 1:
        return
    ((index, place),) = part.places.items()
    entry = asked.reference.entries[index]
    if re.search(r"\bstd\b|_std$", part.quantity.name):
        forms = [("its square", "the variance of what is a deviation here", entry)]
    elif len(set(place)) < 2 and len(set(part.quantity.axes)) < 2 and _OF_VARIANCE.search(part.quantity.name):
        forms = [("its root", "the deviation of what is a variance here", 1 / sp.sqrt(entry))]
        forms.append(("its inverse", "the information of what is a variance here", entry**-2))
    else:
        return
    for words, note, factor in forms:
        yield Convention((words,), (note,), factors={index: factor}, cost=0.9)


def _downwards(asked: Asked) -> Iterator[Convention]:
    """The third axis of space counted downwards, as in north, east, down: along it positions and rates change sign.

    An entry alone says nothing of axes: a wrong sign in it is a slip.
    """
    part = asked.reference.part
    if part is None or len(asked.printed.entries) == 1 or not _IN_SPACE.match(part.quantity.name):
        return
    is_frame = part.quantity.module == "frames"
    upwards = [
        range(2, len(axis), 3) if len(set(axis[:3])) == 1 and (axis[0] in LENGTHS or (is_frame and not at)) else ()
        for at, axis in enumerate(part.quantity.axes)
    ]
    signs = {
        index: sp.Integer((-1) ** sum(i in third for third, i in zip(upwards, place, strict=True)))
        for index, place in part.places.items()
    }
    factors: dict[Index, Expr] = {index: sign for index, sign in signs.items() if sign != 1}
    opposite: dict[Symbol, Expr] = {
        one: -one for one in asked.reference.symbols if one.name in {"z", "vz"} and one in _used(asked) and not is_frame
    }
    if factors or opposite:
        yield Convention(("z downwards",), (), opposite, opposite, (), factors, {}, 0.9, is_slip=True)


def _derived_by(asked: Asked, names: Sequence[str]) -> bool:
    return any(sign != 1 for sign in _signs(asked, names).values())


def _signs(asked: Asked, turned: Sequence[str]) -> dict[Index, Expr]:
    """The sign of each entry, by the derivatives by turned angles in it."""
    names = list(dict.fromkeys(_name(one) for one in _angles(asked)))
    found = {}
    for place, along in _along_axes(asked, PER_RADIAN):
        count = sum(1 for ordinal in along if ordinal < len(names) and names[ordinal] in turned)
        found[place] = sp.Integer((-1) ** count)
    return {place: sign for place, sign in found.items() if sign != 1}


def _returned_angles(asked: Asked) -> Iterator[Convention]:
    """Any of the angles that are returned counted from the other axis: the derivatives of one change their sign."""
    places = dict(_along_axes(asked, RADIAN))
    ordinals = sorted({ordinal for along in places.values() for ordinal in along})
    for turned in _subsets(ordinals):
        signs = {p: sp.Integer((-1) ** sum(o in turned for o in along)) for p, along in places.items()}
        factors = {place: sign for place, sign in signs.items() if sign != 1}
        is_map = asked.reference.part is not None and len(asked.reference.part.quantity.shape) == 1
        offsets = dict.fromkeys(factors, sp.pi / 2) if is_map else {}
        replaced = tuple(f"the {_spoken(asked, ordinal)}" for ordinal in turned)
        yield Convention(replaced, factors=factors, offsets=offsets, cost=0.9 + 0.1 * len(turned), is_slip=True)


def _degrees(asked: Asked) -> Iterator[Convention]:
    """Angles in degrees, with or without their deviations; those that are returned; all of them."""
    used = _used(asked)
    angles = [one for one in asked.reference.symbols if one.unit == RADIAN]
    directions = [one for one in angles if one.is_angle and one in used]
    deviations = [one for one in angles if not one.is_angle and one in used]
    by_angle = {p: IN_DEGREES ** -len(along) for p, along in _along_axes(asked, PER_RADIAN) if along}
    returned = {p: IN_DEGREES ** len(along) for p, along in _along_axes(asked, RADIAN) if along}
    for chosen in (directions + deviations, directions, deviations):
        if chosen and (chosen is not directions or deviations) and (chosen is not deviations or directions):
            words = f"{' and '.join(map(str, chosen))} in degrees"
            changes: dict[Symbol, Expr] = {one: IN_DEGREES * one for one in chosen}
            inverse: dict[Symbol, Expr] = {one: one / IN_DEGREES for one in chosen}
            if by_angle and any(one.is_angle for one in chosen):
                yield Convention((f"{words}, derivatives by them too",), (), changes, inverse, (), by_angle, {}, 1.3)
            yield Convention((words,), (), changes, inverse, cost=1.2)
    if returned:
        yield Convention(("what is returned in degrees",), factors=returned, cost=1.2)


def _scaled_derivatives(asked: Asked) -> Iterator[Convention]:
    """Coefficients of a polynomial for derivatives, as filters by hand have them: half the acceleration."""
    part = asked.reference.part
    if part is None or part.quantity.module not in POLYNOMIAL:
        return
    shape = part.quantity.shape
    scales = {
        index: prod(factorial(i) for size, i in zip(shape, place, strict=True) if size == max(shape))
        for index, place in part.places.items()
    }
    if factors := {index: sp.Rational(1, scale) for index, scale in scales.items() if scale != 1}:
        words = ("coefficients of T, T**2, ... for derivatives",)
        yield Convention(words, ("half the acceleration",), factors=factors, cost=0.8)


def _divided_gains(asked: Asked) -> Iterator[Convention]:
    """Gains as a filter applies them to a residual: of the rate divided by the period, of what follows by its square.

    Their covariance then is that of the estimates, with the variance of a measurement or for one of 1.
    """
    part, used = asked.reference.part, _used(asked)
    understood = [] if part is None else [one for one in understood_by(part.quantity) if one in used]
    if part is None or not understood:
        return
    variance = next((one**2 for one in understood if one != T), ONE)
    factors = {
        index: variance * (T ** -sum(place) if T in understood else 1)
        for index, place in part.places.items()
        if any(place) or variance != ONE
    }
    divided = ("gains divided by 1, T, T**2, ...",) if T in understood else ()
    multiplied = (f"{variance} as a factor",) if variance != ONE else ()
    yield Convention((*divided, *multiplied), factors=factors, cost=0.6)


def _variances(asked: Asked) -> Iterator[Convention]:
    """Variances where deviations are meant: of all errors, or of one."""
    found = [one for one in asked.reference.symbols if one.deviation_of and one in _used(asked)]
    for chosen in (found, *([one] for one in found if len(found) > 1)):
        if chosen:
            words = tuple(f"{one}**2 for {one}" for one in chosen)
            note = f"{'variances' if len(chosen) > 1 else 'the variance'} of what is a deviation here"
            squares: dict[Symbol, Expr] = {one: one**2 for one in chosen}
            roots: dict[Symbol, Expr] = {one: sp.sqrt(one) for one in chosen}
            cost = 0.9 if len(chosen) == len(found) else 1.1
            yield Convention(words, (note,), squares, roots, cost=cost, is_slip=True)


def _angles(asked: Asked) -> list[Variable]:
    return [one for one in asked.reference.symbols if one.is_angle and one not in asked.conditions]


def _name(angle: Variable) -> str:
    """A predicted angle is counted as the measured one is."""
    return angle.name.removeprefix("predicted_")


def _along_axes(asked: Asked, unit: Unit) -> Iterator[tuple[Index, tuple[int, ...]]]:
    """For each entry, which of the parts of this unit its place along each axis is, where it is one of them."""
    part = asked.reference.part
    if part is None:
        return
    axes = part.quantity.axes
    for index, place in part.places.items():
        along = tuple(axis[:i].count(unit) for axis, i in zip(axes, place, strict=True) if axis[i] == unit)
        if along:
            yield index, along


def _spoken(asked: Asked, ordinal: int) -> str:
    """Which returned angle is counted otherwise, and how: what the conversion of the same radar says of its angles."""
    part = asked.reference.part
    model = catalogue().get(f"{part.quantity.name.split('.')[1]}.map") if part else None
    angles = [one for one in model.symbols if one.is_angle] if model else []
    if ordinal >= len(angles):
        return "angle from the other axis"
    words = angles[ordinal].meaning.partition(",")
    other = {"x": "y", "y": "x"}.get(words[2].removesuffix(" axis")[-1:])
    return f"{words[0]} from the {other} axis" if other else f"{words[0]} from the vertical"


def _subsets(names: Sequence[Name]) -> Iterator[tuple[Name, ...]]:
    for count in range(len(names)):
        yield from combinations(names, count + 1)
