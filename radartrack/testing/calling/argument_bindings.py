"""Which symbols a function takes in which places: by name where its parameters have telling ones, else by trial."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import combinations, islice, pairwise, permutations, product, zip_longest
from types import MappingProxyType
from typing import Any

from radartrack.derive.checking.comparing.order_of_difference import is_deviation
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.variable import Variable
from radartrack.testing.calling.argument_names import meanings
from radartrack.testing.calling.called_function import Binding, Form, Parameter
from radartrack.testing.calling.structured_arguments import structured

MOST = 800  # ways to call a function that are tried
TELLING = 2  # parameters with telling names that leave one other no choice
FIRST = 60  # bindings of vectors in the usual orders, which are tried in all forms
USUAL = 12  # bindings of vectors, cut in all places as they are listed, before other orders are tried
ORDERS = 120  # of the symbols in one vector

# Constants that code has built in: of WGS 84 (NIMA TR8350.2, table 3.1).
CUSTOMARY: Mapping[str, float] = {"semi_major_axis": 6378137.0, "flattening": 1 / 298.257223563}

Declared = Sequence[tuple[str, bool, bool]]  # name, whether it may be left out, whether it goes by name
ANY_NAMES = ("**", True, True)  # of a function that takes whatever goes by name


def declared(function: Callable[..., Any]) -> Declared | None:
    """The parameters of a function; None where nothing says what they are."""
    for name in ("argtypes", "nin"):  # of a function in a shared library, of a ufunc
        given = getattr(function, name, None)
        if given is not None:
            count = given if isinstance(given, int) else len(given)
            return [(f"argument {place + 1}", False, False) for place in range(count)]
    try:
        parameters = inspect.signature(function).parameters.values()
    except (TypeError, ValueError):
        return None
    kinds = inspect.Parameter
    if any(one.kind is kinds.VAR_POSITIONAL for one in parameters):
        return None
    return [
        ANY_NAMES
        if one.kind is kinds.VAR_KEYWORD
        else (one.name, one.default is not kinds.empty, one.kind is kinds.KEYWORD_ONLY)
        for one in parameters
    ]


def bindings(
    function: Callable[..., Any],
    symbols: Sequence[Variable],
    stated: Mapping[str, str | Sequence[str]],
    needed: Collection[str],
    pairs: Mapping[str, tuple[str, str]] = MappingProxyType({}),
) -> Iterator[Binding]:
    """The ways to call a function, the likeliest first.

    Args:
        function: the user's.
        symbols: that a call has values for; correlations may stay without a place.
        stated: parameter → the symbol, or the symbols of a vector, that the user says it takes.
        needed: the symbols on which the quantity depends where all correlations are zero.
        pairs: correlation → the two deviations that it joins.
    """
    given, keys = declared(function), _keys(function, symbols, stated)
    fewer = [symbol for symbol in symbols if symbol.name in needed]
    independent = [symbol for symbol in symbols if not symbol.is_correlation]
    unusual = [symbol for symbol in symbols if symbol.name not in CUSTOMARY]
    sets = list(dict.fromkeys(map(tuple, (symbols, independent, fewer, unusual))))
    pairs_of = [(places, known) for known in sets for places in _places(given, known, keys)]
    for taken, known in pairs_of:
        yield from islice(_distinct(_numbers(taken, known, stated)), MOST)
    usual = [one for taken, known in pairs_of for one in islice(_arrays(taken, known, stated, pairs), FIRST)]
    usual.sort(key=lambda one: -sum(parameter.correlated is not None for parameter in one.parameters))
    yield from _distinct(iter(usual))
    yield from (other for one in dict.fromkeys(usual) for other in _in_other_forms(one, function, symbols))
    for taken, known in pairs_of:
        yield from islice(_distinct(_arrays(taken, known, stated, pairs)), MOST)


def _places(given: Declared | None, symbols: Sequence[Variable], keys: Mapping[str, str]) -> list[Declared]:
    """The parameters; where they have no names, one for each symbol, and where any name is allowed, those left too."""
    if given is None:
        return [[(f"argument {n + 1}", False, False) for n, _ in enumerate(symbols)]]
    if ANY_NAMES not in given:
        return [given]
    named = [place for place in given if place != ANY_NAMES]
    taken = {name for place in named for name in meanings(place[0], symbols)[:1]}
    rest = [symbol.name for symbol in symbols if symbol.name not in taken]
    both = [*named, *((keys.get(name, name), False, True) for name in rest)]
    if not named:
        return [both]
    return [both, named] if keys.keys() & set(rest) else [named, both]


def _keys(
    function: Callable[..., Any], symbols: Sequence[Variable], stated: Mapping[str, str | Sequence[str]]
) -> dict[str, str]:
    """Symbol → the name by which a function that takes any asks for it: one that is stated, or stands in its code."""
    found = {symbol: key for key, symbol in stated.items() if isinstance(symbol, str)}
    for word in _texts(getattr(inspect.unwrap(function), "__code__", None)):
        free = [name for name in meanings(word, symbols) if name not in found and word not in found.values()]
        if free:
            found[free[0]] = word
    return found


def _texts(code: Any) -> Iterator[str]:
    """The names among the constants of a function's code, and of the functions inside."""
    for constant in getattr(code, "co_consts", ()):
        if isinstance(constant, str) and constant.isidentifier():
            yield constant
        else:
            yield from _texts(constant)


def _in_other_forms(binding: Binding, function: Callable[..., Any], symbols: Sequence[Variable]) -> Iterator[Binding]:
    """The same with vectors as columns, as rows, as objects or complex numbers."""
    known = {symbol.name: symbol for symbol in symbols}
    vectors = [one for one in binding.parameters if one.is_vector and one.correlated is None]
    if not vectors or binding.form is not Form.SCALARS:
        return
    yield from (replace(binding, form=form) for form in (Form.COLUMNS, Form.ROWS))
    options = [
        list(structured(one, function, known)) if one in vectors and len(one.symbols) > 1 else [one]
        for one in binding.parameters
    ]
    for choice in islice(zip_longest(*options), max(map(len, options))):
        parameters = tuple(one or own for one, own in zip(choice, binding.parameters, strict=True))
        if parameters != binding.parameters:
            yield replace(binding, parameters=parameters)


def _distinct(found: Iterator[Binding]) -> Iterator[Binding]:
    seen: set[tuple[tuple[Parameter, ...], Form]] = set()
    for one in found:
        if (key := (one.parameters, one.form)) not in seen:
            seen.add(key)
            yield one


def _numbers(
    places: Declared, symbols: Sequence[Variable], stated: Mapping[str, str | Sequence[str]]
) -> Iterator[Binding]:
    """A symbol for each parameter."""
    needed = {symbol.name for symbol in symbols if not symbol.is_correlation}
    required = [place for place in places if not place[1]]
    for chosen in _selections(places, required, symbols):
        first = list(islice((one for one in _scalars(chosen, symbols, stated) if needed <= set(one.symbols)), 1))
        yield from first
        yield from (replace(one, form=form) for form in (Form.ARRAYS, Form.WHOLE) for one in first)
        yield from islice((one for one in _scalars(chosen, symbols, stated) if needed <= set(one.symbols)), 1, None)


def _arrays(
    places: Declared,
    symbols: Sequence[Variable],
    stated: Mapping[str, str | Sequence[str]],
    pairs: Mapping[str, tuple[str, str]],
) -> Iterator[Binding]:
    """Parameters that are vectors or covariance matrices."""
    required = [place for place in places if not place[1]]
    for chosen in (required, list(places)):
        for one in _vectors(chosen, symbols, stated):
            yield one
            yield from _with_covariance(one, symbols, pairs)


def _selections(places: Declared, required: Declared, symbols: Sequence[Variable]) -> Iterator[Declared]:
    """All parameters, or without those that may be left out and mean nothing."""
    meaningful = [place for place in places if not place[1] or meanings(place[0], symbols)]
    for chosen in (meaningful, list(places), required):
        if len(chosen) <= len(symbols):
            yield chosen


def _scalars(
    places: Declared, symbols: Sequence[Variable], stated: Mapping[str, str | Sequence[str]]
) -> Iterator[Binding]:
    """One symbol a parameter."""
    if any(not isinstance(one, str) for one in stated.values()):
        return
    names = [symbol.name for symbol in symbols]
    taken_by_name = {name for name, _, _ in places} & set(names)
    options = [
        [str(stated[name])]
        if name in stated
        else _unless(meanings(name, symbols), {*stated.values(), *taken_by_name} - {name})
        for name, _, _ in places
    ]
    is_told = False
    for by_name in islice(product(*(one or [""] for one in options)), MOST):
        taken = [name for name in by_name if name]
        if len(set(taken)) < len(taken):
            continue
        free = [name for name in names if name not in taken]
        for rest in islice(permutations(free, by_name.count("")), MOST):
            left = iter(rest)
            bound = [name or next(left) for name in by_name]
            told = len(taken) in {len(places), max(len(places) - 1, TELLING)}
            is_told = is_told or told
            yield Binding(tuple(map(_parameter, places, bound)), told=told)
    if not stated and not is_told:
        for order in islice(permutations(names, len(places)), MOST):
            yield Binding(tuple(map(_parameter, places, order)))


def _vectors(
    places: Declared, symbols: Sequence[Variable], stated: Mapping[str, str | Sequence[str]]
) -> Iterator[Binding]:
    """Several symbols in a parameter, which takes a vector."""
    names = [symbol.name for symbol in symbols]
    if not 0 < len(places) <= len(names):
        return
    known: dict[str, tuple[str, ...]] = {}
    taken_by_name = {name for name, _, _ in places} & set(names)  # which no other parameter means: tau beside T
    for name, _, _ in places:
        if name in stated:
            known[name] = (stated[name],) if isinstance(stated[name], str) else tuple(stated[name])  # type: ignore[assignment]
        elif len(places) > 1 and len(found := _unless(meanings(name, symbols), taken_by_name - {name})) == 1:
            known[name] = (found[0],)
    fewer = list(_fewer(known, stated))
    for part in (slice(0, USUAL), slice(USUAL, None)):
        for named in fewer:
            yield from islice(_filled(places, names, named, stated), part.start, part.stop)
    free = set(names) - {name for one in known.values() for name in one}
    correlations = {symbol.name for symbol in symbols if symbol.is_correlation}
    if correlations & free:
        yield from _vectors(places, [symbol for symbol in symbols if symbol.name not in correlations], stated)


def _with_covariance(
    binding: Binding, symbols: Sequence[Variable], pairs: Mapping[str, tuple[str, str]]
) -> Iterator[Binding]:
    """The same with deviations that are passed together as the covariance matrix of the errors."""
    deviations = {symbol.name for symbol in symbols if is_deviation(symbol)}
    matrices = [_matrix(parameter, deviations, pairs) for parameter in binding.parameters]
    several = sum(matrix is not None for matrix in matrices) > 1
    alone = [[one if n == place else None for n, one in enumerate(matrices)] for place in range(len(matrices))]
    for chosen in (matrices, *(alone if several else ())):
        if any(chosen):
            both = tuple(matrix or own for matrix, own in zip(chosen, binding.parameters, strict=True))
            yield replace(binding, parameters=both)


def _matrix(
    parameter: Parameter, deviations: Collection[str], pairs: Mapping[str, tuple[str, str]]
) -> Parameter | None:
    """A vector of deviations and their correlations as their covariance matrix; None of anything else."""
    own = [name for name in parameter.symbols if name in deviations]
    joined = [name for name in parameter.symbols if name in pairs]
    if len(own) < 2 or {*own, *joined} != set(parameter.symbols) or not parameter.is_vector:
        return None
    if any(not set(pairs[name]) <= set(own) for name in joined):  # a correlation with what is passed elsewhere
        return None
    correlated = tuple((own.index(pairs[name][0]), own.index(pairs[name][1])) for name in joined)
    return replace(parameter, symbols=(*own, *joined), correlated=correlated)


def _fewer(
    known: Mapping[str, tuple[str, ...]], stated: Mapping[str, str | Sequence[str]]
) -> Iterator[Mapping[str, tuple[str, ...]]]:
    """What parameters take by their names; then one of them as a vector all the same: `x` may be a whole state."""
    yield known
    for name in known:
        if name not in stated:
            yield {other: symbols for other, symbols in known.items() if other != name}


def _filled(
    places: Declared,
    names: Sequence[str],
    known: Mapping[str, tuple[str, ...]],
    stated: Mapping[str, str | Sequence[str]],
) -> Iterator[Binding]:
    """Vectors of the symbols that no parameter takes by its name; one alone is rather a number."""
    count = sum(place[0] not in known for place in places)
    taken = {name for one in known.values() for name in one}
    for orders in _orders([name for name in names if name not in taken]):
        for groups in _groups(orders, count):
            left = iter(groups)
            filled = [(place, known.get(place[0]) or next(left)) for place in places]
            single = {name for (name, _, _), group in filled if len(group) == 1 and name not in known}
            for numbers in dict.fromkeys((frozenset(single if len(places) > 1 else ()), frozenset[str]())):
                yield Binding(
                    tuple(
                        Parameter(
                            name,
                            tuple(group),
                            is_vector=name not in numbers
                            and (name not in known or not isinstance(stated.get(name, ""), str)),
                            is_keyword=by_name,
                        )
                        for (name, _, by_name), group in filled
                    )
                )


def _orders(free: Sequence[str]) -> Iterator[tuple[str, ...]]:
    yield tuple(free)
    half = len(free) // 2
    if len(free) % 2 == 0 and half > 1:  # position and velocity by turns
        yield tuple(name for pair in zip(free[:half], free[half:], strict=True) for name in pair)
    yield from islice(permutations(free), ORDERS)


def _groups(order: Sequence[str], count: int) -> Iterator[list[tuple[str, ...]]]:
    """The order cut into so many parts."""
    if count == 0:
        if not order:
            yield []
        return
    for cuts in combinations(range(1, len(order)), count - 1):
        ends = [0, *cuts, len(order)]
        yield [tuple(order[a:b]) for a, b in pairwise(ends)]


def _parameter(place: tuple[str, bool, bool], symbol: str) -> Parameter:
    name, _, by_name = place
    return Parameter(name, (symbol,), is_keyword=by_name)


def _unless(found: list[str], taken: set[Any]) -> list[str]:
    return [name for name in found if name not in taken]


def correlated_pairs(quantity: Quantity) -> dict[str, tuple[str, str]]:
    """The correlations of its errors, each with the deviations that it joins: those of the same plot or track."""
    if quantity.model is None:
        deviations = [symbol.name for symbol in quantity.symbols if is_deviation(symbol)]
        alike = {
            symbol.name: [name for name in deviations if name.endswith(symbol.name.removeprefix("rho_"))]
            for symbol in quantity.symbols
            if symbol.is_correlation
        }
        return {name: (pair[0], pair[1]) for name, pair in alike.items() if len(pair) == 2}
    sigma = dict(zip(quantity.model.measured, quantity.model.deviations, strict=False))
    return {rho.name: (sigma[a].name, sigma[b].name) for (a, b), rho in quantity.model.correlations.items()}
