"""Other conventions in which a function may be right: of what it takes, and of the order and units of its results."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import combinations, permutations, product

import numpy as np
import numpy.typing as npt

from radartrack.derive.checking.comparing.order_of_difference import is_deviation
from radartrack.derive.language.tensor import Index, indices
from radartrack.derive.language.variable import Variable
from radartrack.derive.units import METRE, METRE_PER_SECOND, RADIAN, SECOND
from radartrack.testing.calling.called_function import Array, Change
from radartrack.testing.wanted import Wanted

LONGEST = 4  # rows whose orders are all tried
HALF_TURN = 180 / math.pi
ORDER = 1.25  # the cost of another order, which an azimuth from the other axis explains as well
UNLIKELY = 3  # of a convention that one wrong sign explains as well
OTHER_UNITS = (
    (METRE, "kilometres", 1e3), (METRE, "feet", 0.3048), (METRE, "nautical miles", 1852.0),
    (RADIAN, "milliradians", 1e-3), (SECOND, "milliseconds", 1e-3),
    (METRE_PER_SECOND, "km/h", 1 / 3.6), (METRE_PER_SECOND, "knots", 1852 / 3600),
)  # fmt: skip
AZIMUTH, ELEVATION, RANGE_RATE, PREDICTED = "beta", "epsilon", "rdot", "predicted_"


@dataclass(frozen=True)
class ArgumentChange:
    """What is passed in place of some symbols.

    Attributes:
        words: the convention; empty for what was asked for.
        changes: symbol → what is passed for its value.
        cost: how many conventions that are.
    """

    words: str = ""
    changes: Mapping[str, Change] = field(default_factory=dict, hash=False)
    cost: int = 0

    def beside(self, other: ArgumentChange) -> ArgumentChange:
        """Both."""
        both = dict(self.changes)
        for name, change in other.changes.items():
            both[name] = _together(both[name], change) if name in both else change
        words = " and ".join(filter(None, (self.words, other.words)))
        return ArgumentChange(words, both, self.cost + other.cost)


AS_ASKED = ArgumentChange()


def in_degrees(names: Sequence[str]) -> ArgumentChange:
    """Some angles, or deviations of angles, in degrees."""
    return ArgumentChange(f"{_listed(names)} in degrees", dict.fromkeys(names, math.degrees), 1)


def as_variances(names: Sequence[str]) -> ArgumentChange:
    """Variances in place of some deviations."""
    return ArgumentChange(f"variances in place of {_listed(names)}", dict.fromkeys(names, _squared), 1)


def against_names(taken: Sequence[tuple[str, str]], words: str) -> ArgumentChange:
    """Symbols that are taken as they are by parameters whose names say another convention: `az_deg`."""
    said = [f"{symbol} itself for {parameter}, which says {words}" for symbol, parameter in taken]
    return ArgumentChange(" and ".join(said), {}, 1) if said else AS_ASKED


def angles_of(symbols: Sequence[Variable]) -> list[str]:
    """What may be in degrees: angles, their rates, and deviations of both."""
    return [symbol.name for symbol in symbols if symbol.unit.radian == 1]


def deviations_of(symbols: Sequence[Variable]) -> list[str]:
    """Standard deviations."""
    return [symbol.name for symbol in symbols if is_deviation(symbol)]


def argument_changes(symbols: Sequence[Variable]) -> list[ArgumentChange]:
    """Single conventions of the arguments that are taken, then two of different kinds together."""
    kinds = [list(_degrees(symbols)), list(_variances(symbols)), list(_other_axes(symbols))]
    units = list(_other_units(symbols))
    singles = [change for kind in (*kinds, units, _reciprocals(symbols), _opposite(symbols)) for change in kind]
    doubles = [a.beside(b) for first, second in combinations(kinds, 2) for a, b in product(first, second)]
    doubles += [a.beside(b) for a, b in product(kinds[0], units) if not a.changes.keys() & b.changes.keys()]
    return [*singles, *doubles]


def _opposite(symbols: Sequence[Variable]) -> Iterator[ArgumentChange]:
    """Correlations, or a range rate that is positive for what comes closer, with the opposite sign."""
    correlations = [symbol.name for symbol in symbols if symbol.is_correlation]
    if correlations:
        yield ArgumentChange(f"the opposite sign of {_listed(correlations)}", dict.fromkeys(correlations, _negative), 1)
    if any(symbol.name == RANGE_RATE for symbol in symbols):
        words = f"{RANGE_RATE} positive for what comes closer (-{RANGE_RATE})"
        yield (closing := ArgumentChange(words, {RANGE_RATE: _negative}, 1))
        if correlations:
            opposite = dict.fromkeys(correlations, _negative)
            yield closing.beside(ArgumentChange(f"the opposite sign of {_listed(correlations)}", opposite))


def exchanged_order(words: str, order: Sequence[str], symbols: Sequence[Variable]) -> ArgumentChange:
    """A vector in which two of one kind, such as x and y, stand in another order than usual, if it is one."""
    places = {symbol.name: place for place, symbol in enumerate(symbols)}
    kinds = {symbol.name: (symbol.unit, is_deviation(symbol), symbol.is_correlation) for symbol in symbols}
    pairs = ((one, other) for one, other in combinations(order, 2) if kinds[one] == kinds[other])
    is_usual = all(places[one] < places[other] for one, other in pairs)
    return AS_ASKED if is_usual else ArgumentChange(f"{words} in the order {', '.join(order)}", {}, 1)


def _reciprocals(symbols: Sequence[Variable]) -> Iterator[ArgumentChange]:
    """A time constant for a rate, a rate of scans for their period."""
    for symbol in symbols:
        if symbol.unit in {SECOND, SECOND**-1} and not is_deviation(symbol):
            yield ArgumentChange(f"1/{symbol.name} in place of {symbol.name}", {symbol.name: _reciprocal}, 1)


def _degrees(symbols: Sequence[Variable]) -> Iterator[ArgumentChange]:
    """Everything, without rates, and directions, deviations or rates alone."""
    every, errors = angles_of(symbols), deviations_of(symbols)
    rates = [symbol.name for symbol in symbols if symbol.name in every and symbol.unit != RADIAN]
    plain = [name for name in every if name not in rates]
    directions, spread = ([name for name in plain if (name in errors) is chosen] for chosen in (False, True))
    for names in dict.fromkeys(map(tuple, (every, plain, directions, spread, rates))):
        if names:
            yield in_degrees(names)


def _other_units(symbols: Sequence[Variable]) -> Iterator[ArgumentChange]:
    """All that have a unit in another one; of angles the deviations alone."""
    spread = deviations_of(symbols)
    for unit, words, size in OTHER_UNITS:
        names = [s.name for s in symbols if s.unit == unit and (unit != RADIAN or s.name in spread)]
        if names:
            yield ArgumentChange(f"{_listed(names)} in {words}", dict.fromkeys(names, _Divided(size)), 1)


@dataclass(frozen=True)
class _Divided:
    """A value in another unit."""

    size: float

    def __call__(self, value: float) -> float:
        return value / self.size


def _variances(symbols: Sequence[Variable]) -> Iterator[ArgumentChange]:
    every = deviations_of(symbols)
    measured = [name for name in every if not name.startswith(PREDICTED)]
    predicted = [name for name in every if name.startswith(PREDICTED)]
    for names in dict.fromkeys(map(tuple, (every, measured, predicted, *([name] for name in every)))):
        if names:
            yield as_variances(names)


def _other_axes(symbols: Sequence[Variable]) -> Iterator[ArgumentChange]:
    """An azimuth from the other axis, in the other sense, so that a correlation with it may change its sign."""
    names = [symbol.name for symbol in symbols]
    correlations = [symbol.name for symbol in symbols if symbol.is_correlation]
    for angle, words in ((AZIMUTH, "from the other axis"), (ELEVATION, "from the zenith")):
        if angle in names:
            turned = ArgumentChange(f"{angle} counted {words} (pi/2 - {angle})", {angle: _complement}, 1)
            yield turned
            if correlations:
                opposite = dict.fromkeys(correlations, _negative)
                yield turned.beside(ArgumentChange(f"the opposite sign of {_listed(correlations)}", opposite))
            if angle == ELEVATION and AZIMUTH in names:
                yield ArgumentChange(f"{AZIMUTH} counted from the other axis", {AZIMUTH: _complement}, 1).beside(turned)
            if angle == AZIMUTH:
                yield ArgumentChange(f"{angle} counted in the other sense (-{angle})", {angle: _negative}, UNLIKELY)


@dataclass(frozen=True, eq=False)
class Arrangement:
    """In which order and units the entries come back.

    Attributes:
        words: the convention; empty for what was asked for.
        sources: for each entry that is wanted, where it stands among those that come back.
        factors: what comes back is so many times the entry,
        offsets: and so much more, up to whole turns.
        cost: how many conventions that are.
    """

    words: str
    sources: tuple[int, ...]
    factors: Array
    offsets: Array
    cost: float

    def undone(self, found: Array) -> Array:
        """The entries that are wanted, from what came back."""
        with np.errstate(all="ignore"):
            values = (found[:, list(self.sources)] - self.offsets) / self.factors
            turned = self.offsets != 0
            values[:, turned] = np.angle(np.exp(1j * values[:, turned]))
        return values


class Arrangements:
    """Those that a quantity allows.

    Args:
        wanted: the quantity.
        stated: the order of the state, where the user says it: the columns of a derivative follow it.
        passed: what is passed, in its order: results may have the order of a state as well.
    """

    def __init__(self, wanted: Wanted, stated: Sequence[str] = (), passed: Sequence[str] = ()) -> None:
        self._wanted, self._stated, self._passed = wanted, stated, passed
        self._size = len(wanted.places)

    @cached_property
    def units(self) -> list[tuple[str, Array, Array, float]]:
        """Words, factors, offsets, cost; degrees of an azimuth from the other axis are both."""
        ones, zeros = np.ones(self._size), np.zeros(self._size)
        senses = [("", ones, zeros, 0.0), *self._senses(ones, zeros)]
        powers, lengths = (
            np.array([float(getattr(self._wanted.quantity.unit(place), base)) for place in self._wanted.places])
            for base in ("radian", "metre")
        )
        if lengths.any():
            senses.append(("the result in kilometres", 1e-3**lengths, zeros, 1.0))
        if not powers.any():
            return senses
        degrees = HALF_TURN**powers
        inner = [(f"{words} and " if words else "", *rest) for words, *rest in senses]
        return senses + [
            (f"{words}the result in degrees", factors * degrees, offsets * degrees, cost + 1)  # type: ignore[operator]
            for words, factors, offsets, cost in inner
        ]

    def _senses(self, ones: Array, zeros: Array) -> Iterator[tuple[str, Array, Array, float]]:
        """In which sense angles are counted, and what is subtracted from what."""
        yield "the opposite sign", -ones, zeros, 1.0
        if (turned := self._azimuth) is not None:
            offset = np.where(turned, np.pi / 2, 0.0) if self._is_map else zeros
            yield "the azimuth counted from the other axis (pi/2 - beta)", np.where(turned, -1.0, 1.0), offset, 1.0
        if AZIMUTH in self._names:
            column = self._names.index(AZIMUTH)
            often = np.array([place[1:].count(column) for place in self._wanted.places])
            yield f"the derivative by {AZIMUTH} likewise", (-1.0) ** often, zeros, 0.0

    @cached_property
    def _azimuth(self) -> npt.NDArray[np.bool_] | None:
        """The entries that belong to an azimuth that comes back."""
        quantity = self._wanted.quantity
        if not quantity.axes or RADIAN not in quantity.axes[0]:
            return None
        row = quantity.axes[0].index(RADIAN)
        turned = np.array([place[0] == row for place in self._wanted.places])
        return turned if turned.any() else None

    @property
    def _is_map(self) -> bool:
        return len(self._wanted.quantity.shape) == 1

    @cached_property
    def _angles(self) -> npt.NDArray[np.bool_]:
        """The entries that are directions, which whole turns do not change."""
        return np.array([is_direction(self._wanted, place) for place in self._wanted.places])

    @cached_property
    def orders(self) -> list[tuple[str, tuple[int, ...], float]]:
        """Words, sources, cost."""
        shape = self._wanted.shape
        flat = {index: place for place, index in enumerate(indices(shape))}
        own = tuple(range(self._size))
        found: dict[tuple[int, ...], tuple[str, float]] = {own: ("", 0)}
        state = [symbol.name for symbol in self._wanted.quantity.symbols]
        passed = [state.index(name) for name in self._passed]
        orders = [tuple(place for place in passed if place < size) for size in dict.fromkeys(shape)]
        as_asked = {f"the {axis} in the order {', '.join(self._stated)}" for axis in ("columns", "entries")}
        for words, moved, cost in _moves(shape, self._names, orders):
            if self._stated and words in as_asked:
                words, cost = "", 0  # noqa: PLW2901 - as it was asked for
            found.setdefault(tuple(flat[moved(index)] for index in indices(shape)), (words, cost))
        return [(words, sources, cost) for sources, (words, cost) in found.items()]

    @property
    def _names(self) -> Sequence[str]:
        """What the last axis belongs to, where it belongs to the arguments of a map."""
        state = [s.name for s in self._wanted.quantity.symbols if not is_deviation(s) and not s.is_correlation]
        is_derivative = self._wanted.quantity.name.endswith((".jacobian", ".hessian"))
        fits = bool(self._wanted.shape) and self._wanted.shape[-1] == len(state)
        return state if is_derivative and fits else ()

    def best(self, found: Array, expected: Array, tolerance: Array) -> Iterator[tuple[int, Arrangement]]:
        """How many different entries each arrangement leaves wrong; one for each of the units, the best order."""
        for words, factors, offsets, cost in self.units:
            with np.errstate(all="ignore"):
                back = (found[:, np.newaxis, :] - offsets[:, np.newaxis]) / factors[:, np.newaxis]
                if offsets.any():
                    back = np.where(offsets[:, np.newaxis] != 0, np.angle(np.exp(1j * back)), back)
                away = back - expected[:, :, np.newaxis]
                away[:, self._angles] = np.angle(np.exp(1j * away[:, self._angles]))
                near = np.abs(away) <= tolerance[:, :, np.newaxis]
            same = np.all(near, axis=0)
            counted = [
                (int(wrong), own, said, sources)
                for wrong, (said, sources, own) in zip(self._wrong(same), self.orders, strict=True)
                if len(set(sources)) == self._size or self._is_symmetric(found)
            ]
            for wrong, own, said, sources in sorted(counted, key=lambda one: (one[0] + one[1], one[1]))[:2]:
                both = " and ".join(filter(None, (said, words)))
                yield wrong, Arrangement(both, sources, factors, offsets, cost + own)

    def _is_symmetric(self, found: Array) -> bool:
        """Whether what came back may have been a list of one half of a matrix, which is all that is read then."""
        matrices = found.reshape(-1, *self._wanted.shape)
        return bool(np.array_equal(matrices, matrices.mT, equal_nan=True))

    @cached_property
    def _sources(self) -> npt.NDArray[np.int_]:
        """For each order, where each entry stands."""
        return np.array([sources for _, sources, _ in self.orders], dtype=int).reshape(-1, self._size)

    @cached_property
    def _groups(self) -> npt.NDArray[np.int_]:
        """For each entry and each different formula, whether it has that."""
        entries = list(dict.fromkeys(self._wanted.entries))
        return np.array([[int(one == entry) for entry in entries] for one in self._wanted.entries])

    def _wrong(self, same: npt.NDArray[np.bool_]) -> npt.NDArray[np.int_]:
        """How many different entries each order leaves wrong."""
        wrong = ~same[np.arange(self._size), self._sources]
        return np.asarray(((wrong @ self._groups) > 0).sum(axis=1))


def is_direction(wanted: Wanted, place: Index) -> bool:
    """Whether an entry of a map is an angle that has a value modulo a turn, and is no error."""
    quantity = wanted.quantity
    is_angle = len(quantity.shape) <= 1 and quantity.unit(place) == RADIAN
    return is_angle and not any(is_deviation(symbol) for symbol in wanted.symbols)


def _moves(
    shape: Index, names: Sequence[str], more: Sequence[tuple[int, ...]] = ()
) -> Iterator[tuple[str, Callable[[Index], Index], float]]:
    """Where an entry stands in another order, what that is called, and what it costs."""
    if len(shape) == 1:
        for order in _orders(shape[0], more):
            yield f"the entries in the order {_spoken(order)}", _Move((order,)), ORDER
    if len(shape) < 2:
        return
    if len(set(shape)) == 1:
        yield from _of_a_cube(shape, more)
    rest = len(shape) - 1
    for rows in _orders(shape[0], more):
        yield f"the rows in the order {_spoken(rows)}", _Move((rows, *(_own(shape[1]),) * rest)), ORDER
    for columns in _orders(shape[1], more):
        yield f"the columns in the order {_spoken(columns, names)}", _Move((_own(shape[0]), *(columns,) * rest)), ORDER
    if min(shape) < max(shape) <= LONGEST or max(shape) < LONGEST:
        for rows, columns in product(_orders(shape[0]), _orders(shape[1])):
            words = f"the rows in the order {_spoken(rows)} and the columns in the order {_spoken(columns, names)}"
            yield words, _Move((rows, *(columns,) * rest)), 2 * ORDER


def _of_a_cube(shape: Index, more: Sequence[tuple[int, ...]]) -> Iterator[tuple[str, Callable[[Index], Index], float]]:
    """The same of as many rows as columns."""
    if len(shape) == 3:
        yield "the first axis last", _Move(last=True), 1
        return
    yield "the result transposed", _Move(transposed=True), 1
    for words, triangle in _triangles(shape[0]):
        yield f"the entries in the order {words}", _Triangle(shape[0], triangle), ORDER
    for order in _orders(shape[0], more):
        yield f"rows and columns in the order {_spoken(order)}", _Move((order, order)), ORDER


@dataclass(frozen=True)
class _Move:
    """Where an entry that is wanted stands among those that come back."""

    orders: tuple[tuple[int, ...], ...] = ()
    transposed: bool = False
    last: bool = False

    def __call__(self, index: Index) -> Index:
        if self.transposed:
            return index[::-1]
        if self.last:
            return (*index[1:], index[0])
        return tuple(order.index(i) for order, i in zip(self.orders, index, strict=True))


def _triangles(size: int) -> Iterator[tuple[str, tuple[Index, ...]]]:
    """Other orders in which the entries of a symmetric matrix come than the upper triangle row by row."""
    diagonal = tuple((i, i) for i in range(size))
    off = tuple((i, j) for i in range(size) for j in range(i + 1, size))
    if size > 1:
        yield "of the diagonal, then the others", diagonal + off
    if size > 2:
        yield "of the lower triangle, row by row", tuple((j, i) for i in range(size) for j in range(i + 1))


@dataclass(frozen=True)
class _Triangle:
    """Where an entry of a symmetric matrix stands that was filled row by row from a list in another order."""

    size: int
    order: tuple[Index, ...]

    def __call__(self, index: Index) -> Index:
        i, j = sorted(index)
        return tuple(np.triu_indices(self.size)[axis][self.order.index((i, j))] for axis in range(2))


def _orders(size: int, more: Sequence[tuple[int, ...]] = ()) -> Iterator[tuple[int, ...]]:
    """All orders of few things; of many, what stands by turns: positions and velocities, or axis by axis."""
    yield from (order for order in more if len(order) == size)  # of all of them, as no place is there twice
    if size <= LONGEST:
        yield from permutations(range(size))
        return
    for groups in (2, 3):
        if size % groups == 0:
            step = size // groups
            yield tuple(part * step + place for place in range(step) for part in range(groups))
            yield tuple(place * groups + part for part in range(groups) for place in range(step))


def _own(size: int) -> tuple[int, ...]:
    return tuple(range(size))


def _spoken(order: Sequence[int], names: Sequence[str] = ()) -> str:
    """By the names of what is put in order, or by numbers."""
    return ", ".join(names[place] if names else str(place) for place in order)


def _listed(names: Sequence[str]) -> str:
    return names[0] if len(names) == 1 else f"{', '.join(names[:-1])} and {names[-1]}"


@dataclass(frozen=True)
class _Steps:
    """Several changes of one value, one after the other."""

    changes: tuple[Change, ...]

    def __call__(self, value: float) -> float:
        for change in self.changes:
            value = change(value)
        return value


def steps(change: Change) -> tuple[Change, ...]:
    """The single changes of which it is made."""
    return change.changes if isinstance(change, _Steps) else (change,)


def _together(one: Change, other: Change) -> Change:
    """An angle is counted from another axis first, then told in its unit, and a deviation in its unit is squared."""
    return _Steps(tuple(sorted((*steps(one), *steps(other)), key=_turn)))


def _turn(change: Change) -> int:
    return 0 if change in {_complement, _negative} else 2 if change is _squared else 1


def _squared(value: float) -> float:
    return value * value


def _complement(value: float) -> float:
    return math.pi / 2 - value


def _reciprocal(value: float) -> float:
    return 1 / value if value else math.inf


def _negative(value: float) -> float:
    return -value


PASSED_AS: Mapping[Change, str] = {
    math.degrees: "{} in degrees",
    _squared: "{}**2",
    _complement: "pi/2 - {}",
    _negative: "-{}",
    _reciprocal: "1/{}",
}


def passed_as(changes: Mapping[str, Change]) -> dict[str, str]:
    """Symbol → what is passed for it, in words, where a word says it."""
    return {
        name: _spoken_change(name, change) for name, change in changes.items() if set(steps(change)) <= set(PASSED_AS)
    }


def _spoken_change(name: str, change: Change) -> str:
    words = name
    for step in steps(change):
        words = PASSED_AS[step].format(words if words.isidentifier() else f"({words})")
    return words
