"""Derived formulas with one slip: what verification must notice."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from random import Random
from typing import TypeVar

import mpmath

from radartrack.derive import symbolic as sp
from radartrack.derive.evaluation.many_digits import Evaluator
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.tensor import Index, Tensor, indices
from radartrack.derive.language.variable import Variable
from radartrack.derive.symbolic import Expr
from radartrack.verification.domain_points import coarse

SWAPS: dict[type[Expr], Callable[..., Expr]] = {sp.sin: sp.cos, sp.cos: sp.sin, sp.sinh: sp.cosh, sp.cosh: sp.sinh}
POINTS = 3
SAME = 1e-30
Built = TypeVar("Built")
Build = Callable[[], Built]


@dataclass(frozen=True)
class Mutant:
    """A quantity's entries with one slip.

    Attributes:
        kind: of slip, in one or two words.
        entries: of the mutant.
    """

    kind: str
    entries: Tensor[Expr]


def mutants(quantity: Quantity, count: int, seed: int) -> list[Mutant]:
    """Up to `count` mutants that are other functions, as even a mix of kinds as there is."""
    generator = Random(f"{seed}/{quantity.name}")  # noqa: S311 - no secret
    by_kind: dict[str, list[Build[Tensor[Expr]]]] = {}
    for kind, build in _all(quantity):
        by_kind.setdefault(kind, []).append(build)
    for group in by_kind.values():
        generator.shuffle(group)
    chosen: dict[Tensor[Expr], Mutant] = {}
    known = _values(quantity, quantity.expression)
    while len(chosen) < count and any(by_kind.values()):
        for kind, group in by_kind.items():
            entries = group.pop()() if group and len(chosen) < count else quantity.expression
            if entries not in chosen and _differs(known, _values(quantity, entries)):
                chosen[entries] = Mutant(kind, entries)
    return list(chosen.values())


def _all(quantity: Quantity) -> Iterator[tuple[str, Build[Tensor[Expr]]]]:
    entries = quantity.expression
    for index, entry in entries.items():
        for kind, build in _changes(entry, quantity.symbols):
            yield kind, partial(_rebuilt, entries, index, build)
    yield from _transposed(entries)


def _rebuilt(entries: Tensor[Expr], index: Index, build: Build[Expr]) -> Tensor[Expr]:
    changed = build()
    return Tensor(
        entries.shape,
        tuple(changed if place == index else entry for place, entry in entries.items()),
    )


def _transposed(entries: Tensor[Expr]) -> Iterator[tuple[str, Build[Tensor[Expr]]]]:
    """Two entries exchanged that are neighbours along an axis."""
    table = dict(entries.items())
    for first in indices(entries.shape):
        for axis in range(len(first)):
            second = (*first[:axis], first[axis] + 1, *first[axis + 1 :])
            if second in table and table[first] != table[second]:
                exchanged = table | {first: table[second], second: table[first]}
                yield "transposed index", partial(Tensor, entries.shape, tuple(exchanged.values()))


def _changes(expression: Expr, symbols: Sequence[Variable]) -> Iterator[tuple[str, Build[Expr]]]:
    """Every formula that differs from this one in one place, with what was done; built when it is called."""
    for kind, changed in _here(expression, symbols):
        yield kind, partial(_itself, changed)
    arguments = expression.args[:1] if isinstance(expression, sp.Pow) else expression.args
    for place, argument in enumerate(arguments):
        for kind, build in _changes(argument, symbols):
            yield kind, partial(_with, expression, place, build)


def _itself(expression: Expr) -> Expr:
    return expression


def _with(expression: Expr, place: int, build: Build[Expr]) -> Expr:
    arguments = list(expression.args)
    arguments[place] = build()
    return expression.func(*arguments)


def _here(expression: Expr, symbols: Sequence[Variable]) -> Iterator[tuple[str, Expr]]:
    arguments = expression.args
    if isinstance(expression, sp.Rational) and expression != sp.Integer(0):
        yield "coefficient", expression * 2
        yield "coefficient", expression + 1
        yield "sign", -expression
    elif isinstance(expression, sp.Add):
        yield from _in_sum(arguments)
    elif isinstance(expression, sp.Mul):
        for place in range(len(arguments)):
            yield "dropped factor", sp.Mul(*arguments[:place], *arguments[place + 1 :])
    elif isinstance(expression, sp.Pow):
        yield "exponent", expression.base ** (expression.exp + 1)
        yield "exponent", expression.base ** (expression.exp - 1)
    elif isinstance(expression, Variable):
        yield "exponent", expression**2
        alike = (other for other in symbols if other != expression and other.unit == expression.unit)
        yield from (("symbol swap", other) for other in alike)
    elif expression.func in SWAPS:
        yield "sine and cosine", SWAPS[expression.func](*arguments)


def _in_sum(terms: tuple[Expr, ...]) -> Iterator[tuple[str, Expr]]:
    for place, term in enumerate(terms):
        rest = (*terms[:place], *terms[place + 1 :])
        yield "dropped term", sp.Add(*rest)
        yield "sign", sp.Add(*rest, -term)
        yield "coefficient", sp.Add(*rest, 2 * term)


def _values(quantity: Quantity, entries: Tensor[Expr]) -> list[list[mpmath.mpf]] | None:
    """The entries at a few points; None where the mutant is not defined."""
    columns = coarse(quantity, POINTS, seed=11)
    rows = [[float(values[n]) for values in columns.values()] for n in range(POINTS)]
    try:
        evaluator = Evaluator(entries, quantity.symbols)
        return [list(evaluator(row)) for row in rows]
    except (ArithmeticError, AttributeError, KeyError, ValueError, TypeError):
        return None


def _differs(known: list[list[mpmath.mpf]] | None, found: list[list[mpmath.mpf]] | None) -> bool:
    """Whether some entry differs at some point; a mutant that is no function is no mutant."""
    if known is None or found is None:
        return False
    pairs = [(a, b) for row, other in zip(known, found, strict=True) for a, b in zip(row, other, strict=True)]
    if not all(mpmath.isfinite(b) and mpmath.im(b) == 0 for _, b in pairs):
        return False
    return any(abs(a - b) > SAME * (abs(a) + abs(b)) for a, b in pairs)
