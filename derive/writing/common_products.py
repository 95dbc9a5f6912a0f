"""Products that are parts of several products, computed once.

Terms of a covariance are products of the same few lengths, deviations and attenuations: a third of their
multiplications are repeated. Neither SymPy's equality nor a compiler sees that, as a b c and a b d share no part until
they are written (a b) c and (a b) d. The pair that most products have is taken out first (Breuer 1969, "Generation of
optimal code for expressions via factorization"); only the order of multiplications changes.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import combinations

from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.term_order import by_name
from radartrack.derive.symbolic import Expr, Symbol


def with_common_products(
    definitions: Mapping[Symbol, Expr], results: Sequence[Expr]
) -> tuple[dict[Symbol, Expr], list[Expr]]:
    """The same with a name for each product of two factors that several products share.

    Returns:
        The definitions, old and new, in an order in which they can be computed, and the rewritten results.
    """
    expressions = [*definitions.values(), *results]
    factors = {product: _factors(product) for one in expressions for product in _products(one)}
    taken = {symbol.name for one in [*definitions, *expressions] for symbol in one.free_symbols}
    pairs = _take_out(factors, _free_names(taken))
    done: dict[Symbol, Expr] = {}

    def rewritten(expression: Expr) -> Expr:
        if expression.is_Atom:
            return expression
        if expression in factors:
            return sp.Mul(_number(expression), *map(named, factors[expression]))
        return expression.func(*map(rewritten, expression.args))

    def named(factor: Expr) -> Expr:
        """A factor over names, of which those of products are defined where they are first used."""
        if not isinstance(factor, Symbol) or factor not in pairs:
            return rewritten(factor)
        if factor not in done:
            done[factor] = sp.Mul(*map(named, pairs[factor]))
        return factor

    for symbol, value in definitions.items():
        done[symbol] = rewritten(value)
    results = [rewritten(result) for result in results]
    return done, results


def _products(expression: Expr) -> Iterator[Expr]:
    if isinstance(expression, sp.Mul):
        yield expression
    for argument in expression.args:
        yield from _products(argument)


def _number(product: Expr) -> Expr:
    return product.as_coeff_Mul(rational=True)[0]


def _factors(product: Expr) -> list[Expr]:
    return list(sp.Mul.make_args(product.as_coeff_Mul(rational=True)[1]))


def _take_out(factors: dict[Expr, list[Expr]], names: Iterator[Symbol]) -> dict[Symbol, tuple[Expr, Expr]]:
    """Put a name in place of the commonest pair of factors, as long as one is common; ties go by name."""
    known = by_name({factor for some in factors.values() for factor in some})
    place = {factor: n for n, factor in enumerate(known)}
    places = {product: sorted(place[factor] for factor in some) for product, some in factors.items()}
    divisors = {n for n, factor in enumerate(known) if _is_divisor(factor)}
    found: dict[Symbol, tuple[Expr, Expr]] = {}

    def pairs(some: Iterable[int]) -> Iterator[tuple[int, int]]:
        return combinations((n for n in some if n not in divisors), 2)

    uses = Counter(pair for some in places.values() for pair in pairs(some))
    while (most := max(uses.values(), default=0)) > 1:
        first, second = min(pair for pair, count in uses.items() if count == most)
        symbol = next(names)
        found[symbol] = known[first], known[second]
        known.append(symbol)
        for product, some in places.items():
            if first in some and second in some:
                uses.subtract(pairs(some))
                places[product] = [*(n for n in some if n not in {first, second}), len(known) - 1]
                uses.update(pairs(places[product]))
    factors.update((product, [known[n] for n in some]) for product, some in places.items())
    return found


def _is_divisor(factor: Expr) -> bool:
    """Whether it is written as what a product is divided by."""
    return isinstance(factor, sp.Pow) and isinstance(factor.exp, sp.Rational) and bool(factor.exp < 0)


def _free_names(taken: set[str]) -> Iterator[Symbol]:
    n = 0
    while True:
        n += 1
        if f"product_{n}" not in taken:
            yield sp.Symbol(f"product_{n}", real=True)
