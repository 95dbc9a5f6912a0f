"""The way of a diagnosis: how a function is called, in which convention it is right, its slip, how exact it is."""

from __future__ import annotations

import inspect
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from difflib import SequenceMatcher
from functools import cached_property
from itertools import combinations
from typing import Any

import numpy as np
import numpy.typing as npt

from radartrack.derive.catalogue import family
from radartrack.derive.language.quantity import Quantity
from radartrack.testing.calling.argument_bindings import ANY_NAMES, CUSTOMARY, bindings, correlated_pairs, declared
from radartrack.testing.calling.argument_names import is_degrees, is_same_name, is_variance, meanings
from radartrack.testing.calling.called_function import RETURNS, Array, Binding, Calls, Parameter, Precision, called
from radartrack.testing.calling.compiled_function import NotCallable, as_called
from radartrack.testing.diagnosis import CHANGING, Diagnosis, Slip
from radartrack.testing.function_conventions import (
    AS_ASKED,
    LONGEST,
    ArgumentChange,
    Arrangements,
    against_names,
    angles_of,
    argument_changes,
    as_variances,
    deviations_of,
    exchanged_order,
    in_degrees,
    is_direction,
    passed_as,
    steps,
)
from radartrack.testing.lost_digits import DOUBLE, SINGLE, is_erratic, is_rounding, lost_digits
from radartrack.testing.reading import CannotDiagnose, Reading
from radartrack.testing.returned_forms import remembered, returned_forms
from radartrack.testing.returned_values import (
    SHOWN,
    beyond_single,
    excused,
    unwrapped,
    where_beyond_single,
    where_indefinite,
    where_undefined,
    worst_point,
)
from radartrack.testing.slips.added_constants import added_constants
from radartrack.testing.slips.argument_slips import argument_slip
from radartrack.testing.slips.function_slips import SlipSearch, merged
from radartrack.testing.slips.half_planes import half_planes
from radartrack.testing.slips.product_slips import product_slips
from radartrack.testing.slips.rounded_parts import rounded_part
from radartrack.testing.unexplained_difference import described, region
from radartrack.testing.wanted import Expected, Wanted
from radartrack.verification.domain_points import Points

FEW = 4  # points that tell one reading from another
SCREENING = 24
CONFIRMING = 16
DOMAIN = 120
CLOSE, CLOSE_SINGLE = 1e-9, 2e-5  # of the scale of an entry, at points where nothing is lost
WRITTEN = 1.05  # halves of the last digit by which a value that is written is off
CLOSE_IN_TABLES = 1e-6  # what a form that cancels may lose in a table, whose points have no neighbours
FAILING = 240  # ways to call it after which a function that raises at all of them is given up
BESIDE = 100  # other ways that are tried where the names of the parameters say how it is called
PLAIN = 2.0  # the cost of a slip in one of several entries that is likelier than any other quantity
RIVALS = 6  # quantities of the same model in other symbols that the function may be
WAYS = 3  # to call it that are tried with other conventions: names such as theta and phi leave a choice
READINGS = 2  # beside the best in which slips are looked for
MANY = 40  # wrong entries beyond which no two are taken for exchanged
MOST_LOST = 1000.0  # ulp that any way to write a formula may lose


MORE = ", and give the others their values: functools.partial, or a lambda"


def examined(
    function: Callable[..., Any],
    wanted: Wanted,
    arguments: Mapping[str, str | Sequence[str]],
    stated: ArgumentChange,
) -> Diagnosis:
    """What a function is.

    Args:
        function: as for `diagnose`.
        wanted: what it is compared with.
        arguments: parameter → the symbol, or the symbols of a vector, that the user says it takes.
        stated: the convention that the user says it has.

    Raises:
        CannotDiagnose: as `diagnose`.
    """
    try:
        forms = as_called(function, len(wanted.places))
    except NotCallable as error:
        raise CannotDiagnose(str(error)) from None
    every = [Examination(one, wanted, arguments, stated) for one in forms]
    fitting = [one for one in every if one.is_callable]
    plain = min(fitting, key=lambda one: one.readings[0].cost, default=every[0])
    if fitting and plain.readings[0].wrong == 0:
        return plain.diagnosis()
    known = list(map(remembered, forms))
    others = [
        (Examination(form.of(once), form.wanted, arguments, stated, form.words), form.of(one))
        for form in returned_forms(wanted)
        for one, once in zip(forms, known, strict=True)
    ]
    right = next((one for one in others if one[0].is_callable and one[0].readings[0].wrong == 0), None)
    if right is not None and right[0].readings[0].words == right[0].readings[0].form:
        return right[0].of(right[1]).diagnosis()
    found = plain.diagnosis() if fitting else None
    if right is not None and not (found and _cost(found.slips) <= PLAIN and found.slips):
        return right[0].of(right[1]).diagnosis()
    if found is not None and found.verdict != "differs":
        return found
    slipped = (one.of(again).diagnosis() for one, again in others if len(wanted.shape) > 1 and one.is_callable)
    found = next((one for one in slipped if len(one.slips) == 1), found)
    return found or plain.diagnosis()


class Examination:
    """One function and one quantity."""

    def __init__(
        self,
        function: Callable[..., Any],
        wanted: Wanted,
        arguments: Mapping[str, str | Sequence[str]],
        stated: ArgumentChange,
        form: str = "",
    ) -> None:
        self._function, self._wanted, self._arguments, self._stated = function, wanted, arguments, stated
        self._form = form
        self._tried: dict[tuple[str, ...], tuple[Wanted, Expected]] = {}
        self._table: Precision | None = getattr(function, "table", None)
        self._arranged: dict[tuple[Wanted, tuple[str, ...]], Arrangements] = {}
        self._troubles: dict[str, None] = {}

    def of(self, function: Callable[..., Any]) -> Examination:
        """The same with a function that is called every time, as far as that has come."""
        self._function = function
        return self

    def diagnosis(self) -> Diagnosis:
        """What it is.

        Raises:
            CannotDiagnose: as `diagnose`.
        """
        best = self.readings
        first = best[0]
        if first.wrong == 0:
            return self._right_or_with_slips(first)
        first = self._as_asked_with_one_slip() or first
        explained, product = self._explained(first)
        is_in_one_place = explained and (first.wrong == 1 or not explained[0].entries)
        if explained and is_in_one_place and explained[0].cost <= PLAIN and len(set(first.wanted.entries)) > 1:
            return self._with_slips(first, explained, product)
        other = None if self._form else self._other_quantity(first)  # a form of another one is too far to seek
        if other is not None and other.wrong == 0:
            return self._right(other)
        if other is not None and (explained is None or len(explained) > 1):
            found = self._slips(other)
            if found and (explained is None or _cost(found) + 1 < _cost(explained)):
                return self._with_slips(other, found)
        if explained:
            reading, slips = self._least_of_alike(first, explained)
            return self._with_slips(reading, slips, product if reading is first else ())
        for reading in [one for one in best[1:] if one.wrong <= first.wrong][:READINGS]:
            if (found := self._slips(reading)) is not None:
                return self._with_slips(reading, found)
        return self._unexplained(first)

    def _as_asked_with_one_slip(self) -> Reading | None:
        """The reading in no convention, where one slip in a product of matrices explains it: more than any other."""
        as_asked = next((one for one in self.readings if not one.words), None)
        if as_asked is None or not self.readings[0].words:
            return None
        return as_asked if len(self._product_slips(as_asked)) == 1 else None

    def _least_of_alike(self, first: Reading, explained: tuple[Slip, ...]) -> tuple[Reading, tuple[Slip, ...]]:
        """Of several slips, those that are fewest in a reading that leaves as much to explain, or a convention more."""
        spare = _cost(explained) - len(explained)  # beyond the likeliest slips
        known = {one.words: one for one in reversed(self.readings) if one.cost <= first.cost + spare}
        alike = [one for one in reversed(known.values()) if one.words != first.words and one.wrong <= first.wrong]
        others = ((one, self._slips(one)) for one in alike[: RIVALS if len(explained) > 1 else 0])
        ways = [(first, explained), *((one, found) for one, found in others if found)]
        return min(ways, key=lambda way: way[0].cost - way[0].wrong + _cost(way[1]))

    def _right_or_with_slips(self, reading: Reading) -> Diagnosis:
        """Of a function that is right at ordinary points: what it has beyond them may have a slip too small there."""
        found = self._right(reading)
        if found.verdict != "differs":
            return found
        slips = next(filter(None, self._hidden(reading)), None)
        if slips is None:
            return found
        return replace(self._with_slips(reading, slips), worst=found.worst, undefined=found.undefined)

    def _hidden(self, reading: Reading) -> Iterator[tuple[Slip, ...] | None]:
        """Slips that do not show at ordinary points."""
        spread = reading.wanted.domain(SCREENING)
        there = self._values(reading, spread)[1]
        yield added_constants(spread, there)
        yield half_planes(spread, there)
        for screening in (reading.wanted.coarse(SCREENING), reading.wanted.small(SCREENING)):
            yield self._slips(reading, screening)

    # How it is called, and in which convention

    @property
    def is_callable(self) -> bool:
        """Whether there is a way to call it."""
        try:
            return bool(self.readings)
        except CannotDiagnose:
            return False

    @cached_property
    def readings(self) -> list[Reading]:
        """Those that leave least to explain, the best first.

        Raises:
            CannotDiagnose: as `diagnose`.
        """
        found: list[Reading] = []
        callable_as: set[tuple[Parameter, ...]] = set()
        failed = beside = 0
        wanted, pairs = self._wanted, correlated_pairs(self._wanted.quantity)
        for binding in bindings(self._function, wanted.symbols, self._arguments, wanted.needed, pairs):
            if binding.parameters in callable_as:  # in another form
                continue
            here = list(self._of_binding(binding))
            failed += not here
            beside += bool(found) and found[0].binding.told and not binding.told
            callable_as |= {reading.binding.parameters for reading in here}
            found += here
            if any(reading.cost == 0 for reading in here):
                return sorted(here, key=lambda one: one.cost)
            if (failed >= FAILING and not found) or beside >= BESIDE:
                break
        if not found:
            raise CannotDiagnose(self._why())
        found.sort(key=lambda one: one.cost)
        ways = {one.binding.parameters: one for one in reversed(found) if not one.plain.changes}
        bare = [found[0], *(one for one in reversed(ways.values()) if one is not found[0])][:WAYS]
        for one in bare:
            for change in argument_changes(one.taken):
                found += self._read(one.wanted, one.plain, change)
        return sorted(found, key=lambda one: one.cost)

    def _not_taken(self) -> list[str]:
        """The symbols that no parameter takes, where the names of all parameters say what they take."""
        names = [place[0] for place in declared(self._function) or () if place != ANY_NAMES]
        meant = [meanings(name, self._wanted.symbols) for name in names]
        taken = {one[0] for one in meant if len(one) == 1}
        if not names or len(taken) < len(names) or self._arguments:
            return []
        needed = [symbol.name for symbol in self._wanted.symbols if not symbol.is_correlation]
        return [name for name in needed if name not in taken and name in self._wanted.needed]

    def _why(self) -> str:
        if absent := self._not_taken():
            own = ", ".join(f'"{name}": ...' for name in absent)
            return f"the function takes no {' and no '.join(absent)}; say the value it has: given={{{own}}}"
        if not self._troubles:
            names = ", ".join(symbol.name for symbol in self._wanted.symbols)
            taken = ", ".join(place[0] for place in declared(self._function) or () if place != ANY_NAMES)
            own_class = inspect.unwrap(self._function)
            if isinstance(own_class, type):
                return f"{own_class.__name__} is a class: hand over an object of it that is called, or a method"
            if taken.partition(", ")[0] in {"self", "cls"}:
                return f"the function takes {taken}: it is the method of a class; hand over that of an object"
            own = f", for it takes {taken}" if taken else ""
            more = "" if len(taken.split(", ")) <= len(self._wanted.symbols) else MORE
            return (
                f"the function cannot be called with {names}{own}; "
                f"say what its parameters take: arguments={{...}}{more}"
            )
        returned = [one for one in self._troubles if one.startswith(RETURNS)]
        return (returned or list(self._troubles))[0]

    def _of_binding(self, binding: Binding) -> Iterator[Reading]:
        """Readings of one way to call it, with what its parameters' names say."""
        absent = [
            symbol.name
            for symbol in self._wanted.symbols
            if (symbol.is_correlation or symbol.name in CUSTOMARY) and symbol.name not in binding.symbols
        ]
        wanted = self._without(absent)
        said, unmeant = self._implied(binding)
        yield from self._read(wanted, replace(binding, changes=said.changes), AS_ASKED)
        if said.changes:
            yield from self._read(wanted, binding, unmeant)

    def _without(self, absent: Sequence[str]) -> Wanted:
        key = tuple(absent)
        if key not in self._tried:
            values = {name: CUSTOMARY.get(name, 0.0) for name in absent}
            wanted = self._wanted.having(values) if absent else self._wanted
            self._tried[key] = wanted, wanted.ordinary(FEW)
        return self._tried[key][0]

    def _implied(self, binding: Binding) -> tuple[ArgumentChange, ArgumentChange]:
        """What names of parameters say, `az_deg` and `var_r`, and what it is when they do not mean it."""
        singles = [(one.name, one.symbols[0]) for one in binding.parameters if len(one.symbols) == 1]
        singles = [one for one in singles if not is_same_name(*one)]
        angles, deviations = angles_of(self._wanted.symbols), deviations_of(self._wanted.symbols)
        degrees = {symbol: name for name, symbol in singles if is_degrees(name) and symbol in angles}
        variances = {symbol: name for name, symbol in singles if is_variance(name) and symbol in deviations}
        said = unmeant = AS_ASKED
        for names, words, change in ((degrees, "degrees", in_degrees), (variances, "a variance", as_variances)):
            if names and not names.keys() & self._stated.changes.keys():
                said = said.beside(change(list(names)))
                own = [(symbol, name) for symbol, name in names.items() if name not in self._arguments]
                unmeant = unmeant.beside(against_names(own, words))
        return said, unmeant

    def _read(self, wanted: Wanted, binding: Binding, change: ArgumentChange) -> Iterator[Reading]:
        """Readings in one convention of arguments; none where the function cannot be called so."""
        for parameter in binding.parameters:
            if parameter.is_vector and parameter.is_ordered and parameter.name not in self._arguments:
                change = exchanged_order(parameter.name, parameter.symbols, wanted.symbols).beside(change)
        inner = ArgumentChange("", binding.changes).beside(self._stated)
        bound = replace(binding, changes=change.beside(inner).changes)
        expected = self._expected(wanted)
        calls = called(self._function, bound, expected.points, wanted.shape)
        if calls.trouble and not np.isfinite(calls.values).any():
            self._troubles[calls.trouble] = None
            return
        arrangements = self._arrangements(wanted, bound)

        known = [place for place in range(expected.count) if place not in calls.unknown]

        def readings(close: float, *, single: bool) -> list[Reading]:
            tolerance = self._tolerance(close, expected)[known]
            found = arrangements.best(calls.values[known], expected.values[known], tolerance)
            read = [Reading(wanted, bound, change, one, wrong, binding, single=single) for wrong, one in found]
            return [replace(one, form=self._form, first=calls.values) for one in read]

        found = readings(CLOSE_SINGLE if calls.single else CLOSE, single=calls.single)
        yield from found
        if not calls.single and all(one.wrong for one in found):
            rough = [one for one in readings(CLOSE_SINGLE, single=True) if one.wrong == 0]
            yield from (one for one in rough if self._is_single(one, calls, expected))

    def _tolerance(self, close: float, expected: Expected) -> Array:
        """By how much a right value may be off; in a table no digits are seen beyond those that are written."""
        if self._table is None:
            return close * expected.scales
        return max(close, WRITTEN * self._table.share) * expected.scales + self._table.least

    def _epsilon(self, reading: Reading) -> float:
        """The unit of the precision in which errors are told."""
        return max(SINGLE if reading.single else DOUBLE, 0.0 if self._table is None else self._table.share)

    def _is_single(self, reading: Reading, calls: Calls, expected: Expected) -> bool:
        """Whether what it is off by jumps, as where it computes in single precision; other errors are smooth."""
        found = reading.arrangement.undone(calls.values)
        with np.errstate(all="ignore"):
            places = np.argwhere(~(np.abs(found - expected.values) <= CLOSE * expected.scales))
        return all(
            is_erratic(
                lambda points: self._error(reading, points),
                reading.wanted.symbols,
                expected.point(int(point)),
                int(entry),
            )
            for point, entry in places[:SHOWN]
        )

    def _arrangements(self, wanted: Wanted, binding: Binding) -> Arrangements:
        passed = binding.symbols if max(wanted.shape, default=0) > LONGEST else ()  # of few, all orders are tried
        if (wanted, passed) not in self._arranged:
            self._arranged[wanted, passed] = Arrangements(wanted, self._stated_order, passed)
        return self._arranged[wanted, passed]

    @property
    def _stated_order(self) -> Sequence[str]:
        """Of the parts of a state that is said to be one vector."""
        vectors = [order for order in self._arguments.values() if not isinstance(order, str)]
        return vectors[0] if len(vectors) == 1 else ()

    def _expected(self, wanted: Wanted) -> Expected:
        for known, expected in self._tried.values():
            if known is wanted:
                return expected
        return wanted.ordinary(FEW)

    def _other_quantity(self, first: Reading) -> Reading | None:
        """The quantity of the same model that the function is exactly, or of other symbols, with less to explain."""
        own = self._wanted.quantity
        known = {symbol.name for symbol in first.wanted.symbols}
        kin = [one for one in family(own) if one.shape == own.shape and one is not own]
        kin.sort(key=lambda one: -SequenceMatcher(None, one.name, own.name).ratio())
        alike = [
            one for one in kin if known <= {symbol.name for symbol in one.symbols} <= known | set(first.wanted.given)
        ]
        found: list[Reading] = []
        for quantity in alike:
            if (one := self._as_kin(quantity, first)) is not None:
                if one.wrong == 0:
                    return one
                found.append(one)
        others = [one for one in kin if one not in alike and self._wanted.given.keys() <= _names(one)]
        found += [one for other in others[:RIVALS] if (one := self._as_another(other, first)) is not None]
        best = min(found, key=lambda one: (one.wrong, one.cost), default=None)
        return best if best is not None and (best.wrong == 0 or best.wrong + 1 < first.wrong) else None

    def _as_kin(self, quantity: Quantity, first: Reading) -> Reading | None:
        """The function as a quantity of the same symbols, which is called alike: exactly, or else as asked for."""
        given = {s.name: first.wanted.given[s.name] for s in quantity.symbols if s.name in first.wanted.given}
        wanted = Wanted(quantity, first.wanted.places, first.wanted.shape, given)
        self._tried[quantity.name,] = wanted, wanted.ordinary(FEW)
        bare = replace(first.binding, changes={})
        as_asked = list(self._read(wanted, bare, AS_ASKED))
        changed = (one for change in argument_changes(first.taken) for one in self._read(wanted, bare, change))
        exact = next((one for one in (*as_asked, *changed) if one.wrong == 0 and one.change.cost <= 1), None)
        best = exact or min(as_asked, key=lambda one: one.cost, default=None)
        return None if best is None else replace(best, other=True)

    def _as_another(self, quantity: Quantity, first: Reading) -> Reading | None:
        """The function as a quantity of other symbols, such as another noise; what both have is passed alike."""
        stated = {parameter: symbols for parameter, symbols in self._arguments.items() if symbols in _names(quantity)}
        wanted = Wanted(quantity, self._wanted.places, self._wanted.shape, self._wanted.given)
        other = Examination(self._function, wanted, stated, self._stated)
        try:
            best = other.readings[0]
        except CannotDiagnose:
            return None
        self._tried |= {(quantity.name, *key): found for key, found in other._tried.items()}

        def taken(reading: Reading) -> list[tuple[str, ...]]:
            return [parameter.symbols for parameter in reading.binding.parameters]

        is_alike = all(
            known == symbols or not {*known} <= _names(quantity)
            for known, symbols in zip(taken(first), taken(best), strict=False)
        )
        return replace(best, other=True) if is_alike and best.change.cost + best.arrangement.cost <= 1 else None

    # What it has at points

    def _values(self, reading: Reading, expected: Expected) -> tuple[Calls, Array]:
        """What came back at some points, and that as the entries that are wanted."""
        calls = called(self._function, reading.binding, expected.points, reading.wanted.shape)
        found = unwrapped(reading.arrangement.undone(calls.values), expected, reading.arrangement.offsets)
        if self._table is not None and self._table.least:  # of what is less than half of the last decimal 0 is left
            found = np.where(np.abs(found - expected.values) <= WRITTEN * self._table.least, expected.values, found)
        if reading.single or calls.single:
            found = np.where(beyond_single(found, expected.values), expected.values, found)
        return calls, found

    # What slip it has

    def _explained(self, reading: Reading) -> tuple[tuple[Slip, ...] | None, tuple[Slip, ...]]:
        """The slips, and beside one in an entry and its mirror image what it is in a product of matrices."""
        product = self._product_slips(reading)
        if product and reading.wrong > 1:
            return product, ()
        slips = self._slips(reading)
        return (slips, product) if slips or not product else (product, ())

    def _product_slips(self, reading: Reading) -> tuple[Slip, ...]:
        """The slips in the matrices of which it is the product."""
        screening, calls, found = self._screened(reading, reading.wanted.wide(SCREENING))
        confirming = reading.wanted.coarse(CONFIRMING)
        _, found_there = self._values(reading, confirming)
        return product_slips(screening, found, confirming, found_there, self._share(calls, reading))

    def _slips(self, reading: Reading, screening: Expected | None = None) -> tuple[Slip, ...] | None:
        """For every entry that is wrong the slip that explains it; None where one is left."""
        screening, calls, found = self._screened(reading, screening or reading.wanted.wide(SCREENING))
        confirming = reading.wanted.coarse(CONFIRMING)
        _, found_there = self._values(reading, confirming)
        share = self._share(calls, reading)
        search = SlipSearch(screening, found, confirming, found_there, share)
        in_degrees = frozenset(name for name, one in reading.binding.changes.items() if math.degrees in steps(one))
        of_argument = argument_slip(screening, found, confirming, found_there, in_degrees)
        slips = self._of_entries(search, self._wrong(calls, found, screening), found, reading)
        if of_argument is not None and (slips is None or len(slips) > 1 or of_argument.cost < _cost(slips)):
            return (of_argument,)
        return slips

    def _screened(self, reading: Reading, screening: Expected) -> tuple[Expected, Calls, Array]:
        """Points, and what it has there; ordinary ones where it refuses large errors, or is a table without them."""
        calls, found = self._values(reading, screening)
        if not (calls.raised or calls.wrong or calls.unknown):
            return screening, calls, found
        ordinary = reading.wanted.ordinary(SCREENING)
        return ordinary, *self._values(reading, ordinary)

    def _share(self, calls: Calls, reading: Reading) -> float:
        """Of a value, by which one that is right in its few digits is off; 0 in double precision."""
        written = 0.0 if self._table is None or self._table.share <= CLOSE else 4 * self._table.share
        return max(CLOSE_SINGLE if calls.single or reading.single else 0.0, written)

    def _of_entries(
        self, search: SlipSearch, wrong: Sequence[int], found: Array, reading: Reading
    ) -> tuple[Slip, ...] | None:
        slips = list(self._exchanged(search, wrong, reading.wanted))
        explained = {entry for slip in slips for entry in slip.entries}
        known: dict[Any, Slip | None] = {}
        for place in wrong:
            index = reading.wanted.places[place] if reading.wanted.shape else ()
            if index in explained:
                continue
            key = reading.wanted.entries[place], tuple(found[:, place])
            if key not in known:
                known[key] = search.slip(place) or self._rounded(reading, search, place)
            slip = known[key]
            if slip is None:
                return None
            slips.append(replace(slip, entries=(index,)))
        return merged(slips)

    def _rounded(self, reading: Reading, search: SlipSearch, place: int) -> Slip | None:
        """A part that is a whole number, which only values beyond those of ordinary size show."""
        expected = reading.wanted.domain(SCREENING)
        calls, found = self._values(reading, expected)
        return None if calls.unknown else rounded_part(search.trees(place), expected, found, place)

    def _wrong(self, calls: Calls, found: Array, expected: Expected) -> list[int]:
        tolerance = self._tolerance(CLOSE_SINGLE if calls.single else CLOSE, expected)
        with np.errstate(all="ignore"):
            near = np.abs(found - expected.values) <= tolerance
        near[calls.unknown] = True
        right = near.all(axis=0)
        return [int(place) for place in np.flatnonzero(~right)]

    @staticmethod
    def _exchanged(search: SlipSearch, wrong: Sequence[int], wanted: Wanted) -> Iterator[Slip]:
        """Entries that stand in each other's places."""
        for place, other in combinations(wrong, 2) if len(wrong) <= MANY else ():
            if search.is_entry(place, other) and search.is_entry(other, place):
                yield Slip((wanted.places[place], wanted.places[other]), "exchanged", "", "", 1.2)

    # What is said of it

    def _right(self, reading: Reading) -> Diagnosis:
        """Of a function that is right at ordinary points: how exact it is elsewhere, and whether it is right there."""
        # Of what another form has lost nothing is known beyond ordinary points.
        expected = reading.wanted.ordinary(SCREENING) if reading.form else reading.wanted.domain(DOMAIN)
        calls, found = self._values(reading, expected)
        found = self._excused(reading, expected, found)
        epsilon = self._epsilon(reading)
        undefined = list(where_undefined(calls, found, expected))
        computed = np.all(np.isfinite(found), axis=1)
        wrong = self._wrong_there(reading, expected, found, epsilon, allowed=MOST_LOST)
        coarse = None if reading.form else self._right_when_coarse(reading)
        plain = not reading.words
        if wrong.any() or coarse is not None:
            return self._elsewhere(reading, expected, found, wrong, coarse, undefined)
        errors = np.where(computed[:, np.newaxis], expected.errors(np.where(np.isfinite(found), found, 0.0)), 0.0)
        errors *= DOUBLE / epsilon
        changing = list(self._changing(reading))
        undefined += changing
        worst = worst_point(expected, found, errors) if computed.any() else None
        indefinite = where_indefinite(reading.wanted, expected, found)
        return Diagnosis(
            quantity=self._wanted.name,
            agrees=plain and not undefined,
            ulp=float(errors.max()) if computed.any() else None,  # a table may have no point in the convention
            worst=worst,
            lost_digits=None if changing else lost_digits(expected, errors, epsilon),
            convention=reading.words,
            undefined=tuple(undefined),
            remarks=(*indefinite, *self._remarks(reading, calls), *where_beyond_single(reading, calls, expected)),
            arguments=_said(reading.binding),
        )

    def _right_when_coarse(self, reading: Reading) -> tuple[Expected, Array, npt.NDArray[np.bool_]] | None:
        """Points with large errors at which the function is wrong, if any."""
        expected = reading.wanted.coarse(CONFIRMING)
        found = self._excused(reading, expected, self._values(reading, expected)[1])
        wrong = self._wrong_there(reading, expected, found, self._epsilon(reading))
        return (expected, found, wrong) if wrong.any() else None

    def _excused(self, reading: Reading, expected: Expected, found: Array) -> Array:
        """Without what rounding of arguments makes; of a table it cannot be seen whether an error is erratic."""
        unit = self._epsilon(reading) / DOUBLE
        return excused(reading, expected, found, unit, arguments_in_single=self._table is not None and reading.single)

    def _at(self, reading: Reading, points: Points) -> Array:
        calls = called(self._function, reading.binding, points, reading.wanted.shape)
        return reading.arrangement.undone(calls.values)

    def _wrong_there(
        self, reading: Reading, expected: Expected, found: Array, epsilon: float, allowed: float = 0.0
    ) -> npt.NDArray[np.bool_]:
        """The points at which it differs by more than rounding makes: in the derived formula, or in its own form."""
        rounding = is_rounding(expected, found, epsilon) | (expected.errors(found) * (DOUBLE / epsilon) <= allowed)
        wrong: npt.NDArray[np.bool_] = np.all(np.isfinite(found), axis=1) & ~np.all(rounding, axis=1)
        if self._table is not None:  # of which nothing is known beside the points
            with np.errstate(all="ignore"):
                near = np.abs(found - expected.values) <= self._tolerance(CLOSE_IN_TABLES, expected)
            return np.asarray(wrong & ~np.all(near, axis=1))
        for place in np.flatnonzero(wrong):
            point, entry = expected.point(int(place)), int(np.flatnonzero(~rounding[place])[0])
            wrong[place] = not is_erratic(
                lambda points: self._error(reading, points), reading.wanted.symbols, point, entry
            )
        return wrong

    def _error(self, reading: Reading, points: Points) -> Array:
        """What the function has, less what is exact; no rows where one of the points is outside the domain."""
        there = reading.wanted.at(points)
        if there.count < len(next(iter(points.values()))):
            return np.empty((0, len(reading.wanted.places)))
        error = self._values(reading, there)[1] - there.values
        turns = [is_direction(reading.wanted, place) for place in reading.wanted.places]
        return np.where(turns, np.abs(error), error)  # half a turn more is half a turn less

    def _changing(self, reading: Reading) -> Iterator[str]:
        """Whether two calls give the same, and whether calls between them matter."""
        points = self._expected(reading.wanted).points
        first, second = (called(self._function, reading.binding, points, reading.wanted.shape).values for _ in range(2))
        if not np.array_equal(first, second, equal_nan=True):
            yield f"{CHANGING}: two calls with the same arguments give different values"
        elif reading.first is not None and not np.array_equal(first, reading.first, equal_nan=True):
            yield f"{CHANGING}: it gives other values than when it was called before, with the same arguments"

    def _elsewhere(
        self,
        reading: Reading,
        expected: Expected,
        found: Array,
        wrong: npt.NDArray[np.bool_],
        coarse: tuple[Expected, Array, npt.NDArray[np.bool_]] | None,
        undefined: Sequence[str],
    ) -> Diagnosis:
        """Of a function that is right at some points and wrong at others."""
        if not wrong.any() and coarse is not None:
            expected, found, wrong = coarse
        where = region(expected, wrong)
        errors = np.where(wrong[:, np.newaxis], expected.errors(np.where(np.isfinite(found), found, 0.0)), 0.0)
        return Diagnosis(
            quantity=self._wanted.name,
            agrees=False,
            worst=worst_point(expected, found, errors),
            convention=reading.words,
            differences=(*self._changing(reading), f"it is right at ordinary points, and wrong {where}"),
            undefined=tuple(undefined),
            remarks=self._remarks(reading, None),
            arguments=_said(reading.binding),
        )

    def _with_slips(self, reading: Reading, slips: tuple[Slip, ...], product: Sequence[Slip] = ()) -> Diagnosis:
        """Of a function that is no function nothing is explained by an edit."""
        if any(self._changing(reading)):
            return self._unexplained(reading)
        expected = reading.wanted.ordinary(SCREENING)
        calls, found = self._values(reading, expected)
        errors = expected.errors(np.where(np.isfinite(found), found, 0.0))
        return Diagnosis(
            quantity=self._wanted.name,
            agrees=False,
            worst=worst_point(expected, found, errors),
            convention=reading.words,
            slip="; ".join(map(str, slips)),
            slips=slips,
            remarks=(*(f"as if {one}" for one in product), *self._remarks(reading, calls)),
            arguments=_said(reading.binding),
        )

    def _unexplained(self, reading: Reading) -> Diagnosis:
        model = self._wanted.quantity.model
        absent = self._not_taken()
        if model is not None and absent and set(absent) <= {symbol.name for symbol in model.parameters}:
            raise CannotDiagnose(self._why())  # a state in which one of them stands is none
        expected = reading.wanted.ordinary(SCREENING)
        calls, found = self._values(reading, expected)
        wrong = self._wrong(calls, found, expected)
        errors = expected.errors(np.where(np.isfinite(found), found, 0.0))

        def difference(points: Points) -> Array:
            there = reading.wanted.at(points)
            return (
                self._at(reading, points) - there.values
                if there.count == len(next(iter(points.values())))
                else np.full((len(next(iter(points.values()))), len(reading.wanted.places)), np.nan)
            )

        changing = tuple(self._changing(reading))
        words = [] if changing else list(described(reading.wanted, wrong, difference, expected.point(0)))
        return Diagnosis(
            quantity=self._wanted.name,
            agrees=False,
            worst=worst_point(expected, found, errors),
            convention=reading.words,
            differences=changing or tuple(words) or ("it differs",),
            undefined=tuple(where_undefined(calls, found, expected)),
            remarks=self._remarks(reading, calls),
            arguments=_said(reading.binding),
        )

    def _remarks(self, reading: Reading, calls: Calls | None) -> tuple[str, ...]:
        absent = sorted(set(reading.wanted.given) - set(self._wanted.given))
        values = ", ".join(f"{name} = {reading.wanted.given[name]:.9g}" for name in absent)
        said = [f"for {values}, as it takes no {' and no '.join(absent)}"] if absent else []
        if calls is not None and calls.single:
            said.append("it returns single precision, in whose units errors are told")
        elif self._table is not None and self._table.share > CLOSE:
            digits = math.ceil(-math.log10(self._table.share))
            said.append(f"the values are written with {digits} digits, in units of whose last one errors are told")
        elif reading.single:
            said.append("it computes in single precision, in whose units errors are told")
        return tuple(said)


def _cost(slips: Sequence[Slip]) -> float:
    return sum(slip.cost for slip in slips)


def _names(quantity: Quantity) -> set[str]:
    return {symbol.name for symbol in quantity.symbols}


def _said(binding: Binding) -> tuple[str, ...]:
    changed = passed_as(binding.changes)
    return tuple(parameter.words(changed) for parameter in binding.parameters)
