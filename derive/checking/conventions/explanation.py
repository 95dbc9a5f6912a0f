"""In which convention the fewest entries of a print are wrong: found by values, then proved entry by entry."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, lru_cache
from itertools import product

from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.equality import proved_equal
from radartrack.derive.algebra.principal_angles import (
    equal_angles,
    equal_function,
    equal_modulo_half_turn,
    equal_modulo_turn,
)
from radartrack.derive.checking.conventions.altered_question import Asked
from radartrack.derive.checking.conventions.convention import Convention, conventions
from radartrack.derive.checking.conventions.entry_order import Arrangement, arrangements_that_fit
from radartrack.derive.checking.question.conditions import under
from radartrack.derive.evaluation.floating_point import RoughEvaluator
from radartrack.derive.evaluation.points import Point, generic_points
from radartrack.derive.language.tensor import Index, indices
from radartrack.derive.symbolic import Expr, Symbol
from radartrack.derive.units import RADIAN

ALIKE = 1e-9
KEPT = 4  # explanations that are looked at closely
MOST_MAGNITUDES = 3  # the signs of which are tried
STEPS = 300_000  # terms that are evaluated: of long formulas only the likelier conventions are tried


@dataclass(frozen=True)
class Explanation:
    """A convention and an order of entries, and what is wrong in them.

    Attributes:
        asked: what is printed.
        convention: in which it is printed.
        arrangement: and in which order.
        wrong: the entries that are wrong even so.
    """

    asked: Asked
    convention: Convention
    arrangement: Arrangement
    wrong: tuple[Index, ...]

    @property
    def cost(self) -> float:
        """How unlikely the convention is, on the scale of edits."""
        return self.convention.cost + self.arrangement.cost

    @property
    def words(self) -> str:
        """The same in words, after "equal"."""
        order = f" {self.arrangement.words}" if self.arrangement.words else ""
        return f"{order}{self.convention.words}{self._where}"

    @cached_property
    def conditions(self) -> dict[Symbol, Expr]:
        """Those of the question and of the convention."""
        return self.convention.conditions(self.asked.conditions)

    def printed(self, index: Index) -> Expr:
        """What is printed in ours."""
        return under(self.conditions, under(self.convention.changes, self.asked.printed[index]))

    def expected(self, index: Index) -> Expr:
        """What should be printed there."""
        place = self._place(index)
        return under(self.conditions, self.convention.expected(place, self.asked.reference.entries[place]))

    def in_print(self, index: Index) -> Expr:
        """What should be printed there, in the symbols of the print."""
        return under(self.convention.inverse, self.expected(index))

    def proves(self, index: Index) -> bool:
        """Whether an entry is proved to be what should be printed, up to a turn of an angle."""
        printed, expected = self.printed(index), self.expected(index)
        if printed == expected or proved_equal(printed, expected):
            return True
        return (self._is_angle(index) and equal_angles(*self._in_radians(index))) or bool(self._turn(index))

    @cached_property
    def _where(self) -> str:
        """In words, whether angles are only the same up to a turn, or a half turn, and functions of one."""
        right = (index for index in indices(self.asked.printed.shape) if index not in self.wrong)
        turns = {self._turn(index) for index in right} - {""}
        return f" {' and '.join(sorted(turns))}" if turns else ""

    def _turn(self, index: Index) -> str:
        printed, expected = self.printed(index), self.expected(index)
        if not self._is_angle(index):
            return "" if printed == expected else _branch(printed, expected)
        angles = self._in_radians(index)
        if printed == expected or proved_equal(printed, expected) or equal_angles(*angles):
            return ""
        return _turn(*angles)

    def _in_radians(self, index: Index) -> tuple[Expr, Expr]:
        """The printed and the expected angle; in degrees they are the same up to another turn."""
        size = sp.Abs(self.convention.factors.get(self._place(index), sp.Integer(1)))
        printed, expected = self.printed(index), self.expected(index)
        return (printed, expected) if size == 1 else (sp.expand(printed / size), sp.expand(expected / size))

    def _is_angle(self, index: Index) -> bool:
        return _is_angle(self.asked, self._place(index))

    def _place(self, index: Index) -> Index:
        place = list(indices(self.asked.printed.shape)).index(index)
        return self.arrangement.places[place]


@lru_cache(maxsize=256)
def _turn(printed: Expr, expected: Expr) -> str:
    """How far two angles agree: up to a turn, or where what an inverse tangent divides by is positive."""
    if equal_modulo_turn(printed, expected):
        return "up to whole turns"
    if equal_modulo_half_turn(printed, expected):
        return f"where {half_plane(printed, expected)}"
    for inverse in expected.atoms(sp.atan2) if expected.is_Function else ():
        above, beside = inverse.args
        if printed.func is sp.acos and equal_function(printed, expected, sp.cos):
            return f"where {above} > 0"
        if printed.func is sp.asin and equal_function(printed, expected, sp.sin):
            return f"where {beside} > 0"
    return ""


@lru_cache(maxsize=256)
def _branch(printed: Expr, expected: Expr) -> str:
    """Where a formula is right in which a magnitude stands: |y - x| for y - x, cos(atan(y/x)) for x/r."""
    magnitudes = {one: _magnitude(one) for one in printed.atoms(sp.Abs, sp.Pow)}
    inside = list(dict.fromkeys(size for size, _ in magnitudes.values() if size is not None))
    if not inside or len(inside) > MOST_MAGNITUDES or proved_equal(printed, expected):
        return ""
    for signs in product((1, -1), repeat=len(inside)):
        sign_of = dict(zip(inside, signs, strict=True))
        signed = {one: rest * sign_of[size] for one, (size, rest) in magnitudes.items() if size is not None}
        if proved_equal(printed.xreplace(signed), expected):
            sides = (f"{size} {'>' if sign > 0 else '<'} 0" for size, sign in sign_of.items())
            return f"where {' and '.join(sides)}"
    return ""


def _magnitude(part: Expr) -> tuple[Expr | None, Expr]:
    """What a part has the magnitude of, if of anything, and the part where that is positive."""
    if isinstance(part, sp.Abs):
        return part.args[0], part.args[0]
    base, exponent = part.as_base_exp()
    if isinstance(exponent, sp.Rational) and exponent.q == 2:
        quotients = {one: sp.sin(one.args[0]) / sp.cos(one.args[0]) for one in base.atoms(sp.tan)}
        above, below = sp.fraction(sp.together(base.xreplace(quotients)))
        root = sp.sqrt(below)
        sizes = root.atoms(sp.Abs)
        if len(sizes) == 1:
            (size,) = sizes
            return size.args[0], above**exponent * root.xreplace({size: size.args[0]}) ** (-2 * exponent)
    return None, part


def half_plane(printed: Expr, expected: Expr) -> str:
    """Where the tangents being equal the angles are."""
    for inverse in expected.atoms(sp.atan2):
        above, beside = inverse.args
        for one in printed.atoms(sp.atan):
            tangent = one.args[0]
            if proved_equal(tangent, above / beside):
                return f"{beside} > 0"
            if proved_equal(tangent, beside / above):
                return f"{above} > 0"
    return "both lie in one half plane"


def _is_angle(asked: Asked, place: Index) -> bool:
    part = asked.reference.part
    return part is not None and part.quantity.unit(part.places[place]) == RADIAN and not part.quantity.is_covariance


def explanations(asked: Asked) -> list[Explanation]:
    """The conventions in which the least is wrong, ours among them, the likeliest first."""
    found = sorted(_by_values(asked), key=lambda one: len(one.wrong) + one.cost)
    complete, partial = ([one for one in found if bool(one.wrong) is kind] for kind in (False, True))
    fewest = sorted(partial, key=lambda one: (len(one.wrong), one.cost))[:1]
    closely = (*complete[:KEPT], *partial[:KEPT], *(one for one in fewest if one not in partial[:KEPT]))
    proved = [_proved(one) for one in closely]
    return [one for one in proved if one.words]


def _proved(one: Explanation) -> Explanation:
    """With the entries that are equal by value only counted as wrong."""
    every = list(indices(one.asked.printed.shape))
    wrong = tuple(index for index in every if index in one.wrong or not one.proves(index))
    return Explanation(one.asked, one.convention, one.arrangement, wrong)


def _by_values(asked: Asked) -> Iterator[Explanation]:
    values = _Values(asked)
    every = list(indices(asked.printed.shape))
    for convention in conventions(asked):
        if values.steps > STEPS:
            return
        same = values.same(convention)
        for arrangement, wrong in arrangements_that_fit(asked.printed.shape, same)[:2]:
            yield Explanation(asked, convention, arrangement, tuple(every[place] for place in wrong))


class _Values:
    """What is printed and what was derived at a point, each computed once for what is changed in it."""

    def __init__(self, asked: Asked) -> None:
        self._asked = asked
        self._symbols = asked.reference.symbols
        (self._point,) = generic_points(self._symbols, 1)
        self._printed = [RoughEvaluator([entry], self._symbols) for entry in asked.printed]
        self._derived = [RoughEvaluator([entry], self._symbols) for entry in asked.reference.entries]
        self._length = sum(map(_length, (*asked.printed, *asked.reference.entries)))
        self._known: dict[tuple[object, ...], list[float | None]] = {}
        self.steps = 0

    def same(self, convention: Convention) -> _Same:
        """Which entries of the print and of what was derived have one value."""
        point = self._moved(self._point, convention.conditions(self._asked.conditions))
        changed = self._moved(point, convention.changes)
        printed = self._at("printed", self._printed, changed)
        derived = self._at("derived", self._derived, point)
        places = list(indices(self._asked.printed.shape))
        expected = {
            place: None if value is None else self._expected(convention, place, value, point)
            for place, value in zip(places, derived, strict=True)
        }
        turns = {
            place: math.pi * abs(float(convention.factors.get(place, 1)))
            for place in places
            if _is_angle(self._asked, place)
        }
        return _Same(printed, expected, turns, [entry.has(sp.Abs) for entry in self._asked.printed])

    def _expected(self, convention: Convention, place: Index, value: float, point: Point) -> float:
        """What an entry is worth in a convention."""
        factor, offset = convention.factors.get(place), convention.offsets.get(place)
        known = {
            symbol: sp.Rational(Fraction(point[symbol.name])) for symbol in (factor.free_symbols if factor else ())
        }
        scale = 1.0 if factor is None else float(under(known, factor))
        return scale * value + (0.0 if offset is None else float(offset))

    def _at(self, kind: str, evaluators: Sequence[RoughEvaluator], point: Point) -> list[float | None]:
        key = (kind, *point.values())
        if key not in self._known:
            self.steps += self._length
            values = [point[symbol.name] for symbol in self._symbols]
            found = [one(values) for one in evaluators]
            self._known[key] = [one[0][0] if one else None for one in found]
        return self._known[key]

    def _moved(self, point: Point, changes: Mapping[Symbol, Expr]) -> Point:
        """The point with other values of some symbols."""
        if not changes:
            return point
        found = RoughEvaluator(list(changes.values()), self._symbols)([point[one.name] for one in self._symbols])
        return point | {symbol.name: value for symbol, (value, _) in zip(changes, found or (), strict=False)}


@dataclass(frozen=True)
class _Same:
    """Compares an entry of the print with one of what is expected, by their values.

    Attributes:
        printed: the values of the print.
        expected: those of what is expected.
        turns: of angles half a turn, by which they may differ; what of that is proved is told.
        magnitudes: whether the sign of an entry of the print is that of a magnitude in it; likewise.
    """

    printed: Sequence[float | None]
    expected: Mapping[Index, float | None]
    turns: Mapping[Index, float]
    magnitudes: Sequence[bool]

    def __call__(self, place: int, index: Index) -> bool:
        first, second = self.printed[place], self.expected[index]
        if first is None or second is None:
            return False
        if self.magnitudes[place]:
            first, second = abs(first), abs(second)
        apart = first - second if index not in self.turns else math.remainder(first - second, self.turns[index])
        return abs(apart) <= ALIKE * max(abs(first), abs(second))


def _length(expression: Expr) -> int:
    return 1 + len(str(expression)) // 4
