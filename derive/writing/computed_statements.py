"""What a function computes, in order: the same for every language that it is written in."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from radartrack.derive import symbolic as sp
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.stable_form import StableForm
from radartrack.derive.symbolic import Expr, Symbol
from radartrack.derive.writing.common_subexpressions import with_common_parts


@dataclass(frozen=True)
class Statements:
    """Intermediates, then entries in row-major order.

    Attributes:
        definitions: name and value of each intermediate, in an order in which they can be computed.
        results: the entries over them.
    """

    definitions: tuple[tuple[str, Expr], ...]
    results: tuple[Expr, ...]


def statements_of(quantity: Quantity, form: StableForm) -> Statements:
    """The statements that compute a quantity as it is rewritten."""
    form = beside(form, quantity)
    return joined(*with_common_parts(form.definitions, form.entries))


def joined(definitions: dict[Symbol, Expr], results: Iterable[Expr]) -> Statements:
    """Definitions by name, and results."""
    return Statements(tuple((symbol.name, value) for symbol, value in definitions.items()), tuple(results))


def beside(form: StableForm, quantity: Quantity) -> StableForm:
    """The form with an underscore behind every intermediate that is called like one of the arguments."""
    taken = {symbol.name for symbol in quantity.symbols}
    renamed: dict[Symbol, Symbol] = {}
    for symbol in form.definitions:
        if symbol.name in taken:
            renamed[symbol] = sp.Symbol(f"{symbol.name}_", real=True)
    return form.renamed(renamed) if renamed else form


def first_or_known(pairs: Iterable[tuple[str, Expr]]) -> Iterator[tuple[str, Expr | str]]:
    """Each target with its value, or with the target that has this value already: what was computed is copied."""
    first: dict[Expr, str] = {}
    for target, expression in pairs:
        known = first.setdefault(expression, target)
        yield (target, expression if known == target or expression.is_Atom else known)
