"""Common subexpressions, named after what they are where that has a name."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping

from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.term_order import by_name
from radartrack.derive.symbolic import Expr, Symbol
from radartrack.derive.writing.numpy_expression import code

POWERS = {2: "squared", 3: "cubed"}
LONGEST = 30  # characters of a sum inside a product; longer ones get a name, so that a line can be read


def with_common_parts(
    definitions: Mapping[Symbol, Expr], results: Iterable[Expr]
) -> tuple[dict[Symbol, Expr], list[Expr]]:
    """Pull out what is computed twice, and sums too long to read inside a product.

    Returns:
        The definitions, old and new, in the order in which they can be computed, and the rewritten results.
    """
    return _Extraction(definitions).run(list(results))


class _Extraction:
    def __init__(self, definitions: Mapping[Symbol, Expr]) -> None:
        self.given = definitions
        self.done: dict[Symbol, Expr] = {}
        self.names: dict[Expr, Symbol] = {}
        self.uses: Counter[Expr] = Counter()
        self.numbered: Counter[str] = Counter()
        self.taken: set[str] = set()

    def run(self, results: list[Expr]) -> tuple[dict[Symbol, Expr], list[Expr]]:
        distinct = list(dict.fromkeys(results))
        for expression in [*self.given, *self.given.values(), *distinct]:
            self.taken |= {symbol.name for symbol in expression.free_symbols}
        for expression in [*self.given.values(), *distinct]:
            self._count(expression)
        for symbol in self.given:
            self._rewrite(symbol)
        rewritten = {expression: self._rewrite(expression) for expression in distinct}
        return self.done, [rewritten[expression] for expression in results]

    def _count(self, expression: Expr) -> None:
        if expression.is_Atom:
            return
        self.uses[expression] += 1
        if self.uses[expression] == 1:
            for argument in _parts(expression):
                self._count(argument)

    def _rewrite(self, expression: Expr) -> Expr:
        """The expression over names; whatever it needs is defined first."""
        if isinstance(expression, sp.Symbol) and expression in self.given and expression not in self.done:
            self.done[expression] = self._rewrite_arguments(self.given[expression])
        if expression.is_Atom:
            return expression
        if expression in self.names:
            return self.names[expression]
        rewritten = self._rewrite_arguments(expression)
        return self._named(expression, rewritten) if self._deserves_name(expression) else rewritten

    def _rewrite_arguments(self, expression: Expr) -> Expr:
        if expression.is_Atom:
            return expression
        if _is_high_power(expression):
            base, exponent = expression.as_base_exp()
            square = self._rewrite(base**2)
            odd = self._rewrite(base) if exponent % 2 else sp.Integer(1)
            return odd * square ** (exponent // 2)
        arguments = [self._rewrite(argument) for argument in _arguments(expression)]
        if isinstance(expression, sp.Mul):
            arguments = [self._short(argument) for argument in arguments]
        return expression.func(*arguments)

    def _short(self, factor: Expr) -> Expr:
        is_long = isinstance(factor, sp.Add) and len(code(factor)) > LONGEST
        return self._named(factor, factor) if is_long else factor

    def _deserves_name(self, expression: Expr) -> bool:
        trivial = isinstance(expression, sp.Mul) and len(expression.args) == 2 and expression.args[0].is_Number
        return self.uses[expression] > 1 and not trivial

    def _named(self, expression: Expr, rewritten: Expr) -> Symbol:
        if rewritten in self.names:
            return self.names[rewritten]
        name = sp.Symbol(self._free(self._name(rewritten)), real=True)
        self.names[expression] = self.names[rewritten] = name
        self.done[name] = rewritten
        return name

    def _free(self, wanted: str) -> str:
        """The name, with underscores behind it where a symbol of that name is there already."""
        while wanted in self.taken:
            wanted += "_"
        self.taken.add(wanted)
        return wanted

    def _name(self, expression: Expr) -> str:
        base, exponent = expression.as_base_exp()
        if isinstance(base, sp.Symbol) and isinstance(exponent, sp.Integer) and int(exponent) in POWERS:
            return f"{base.name}_{POWERS[int(exponent)]}"
        if len(expression.args) == 1 and isinstance(expression.args[0], sp.Symbol):
            return f"{expression.func.__name__}_{expression.args[0].name}"
        kind = {sp.Add: "sum", sp.Mul: "product"}.get(expression.func, "term")
        self.numbered[kind] += 1
        return f"{kind}_{self.numbered[kind]}"


def _is_high_power(expression: Expr) -> bool:
    """Whether it is an integer power that is computed through the square."""
    return isinstance(expression, sp.Pow) and isinstance(expression.exp, sp.Integer) and expression.exp > 2


def _parts(expression: Expr) -> tuple[Expr, ...]:
    if _is_high_power(expression):
        return (expression.base, expression.base**2)
    return expression.args


def _arguments(expression: Expr) -> Iterable[Expr]:
    """In an order that depends on names alone; functions keep theirs."""
    return by_name(expression.args) if isinstance(expression, sp.Add | sp.Mul) else expression.args
