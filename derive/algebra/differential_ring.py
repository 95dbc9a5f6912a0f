"""Polynomial rings that are closed under differentiation, for maps with roots, quotients and functions.

Every subexpression that is no polynomial becomes a generator whose derivative lies in the ring: a root √P enters as
P^(−1/2), with derivative −½ P′ (P^(−1/2))³, a quotient 1/Q with −Q′ (1/Q)², a sine with its cosine, an arctangent
with the quotient in its derivative, any other root with that quotient and itself. Derivatives of any order are then
sums of products of polynomials.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cached_property, reduce
from operator import mul

from radartrack.derive import symbolic as sp
from radartrack.derive.language.model_outputs import SMOOTH
from radartrack.derive.symbolic import Expr, PolyElement, PolyRing, Symbol

FUNCTIONS = tuple(function for function in SMOOTH if function not in (sp.hypot, sp.tan))  # those are rewritten


class NotDifferentiable(ValueError):
    """An expression holds something whose derivatives are not known here."""


class DifferentialRing:
    """The smallest such ring over the given symbols in which the given expressions lie.

    Attributes:
        symbols: the plain symbols.
        generators: the placeholder of each further generator → what it stands for.
        ring: the polynomials in both, with rational coefficients.
    """

    def __init__(self, expressions: Iterable[Expr], symbols: Iterable[Symbol]) -> None:
        self.symbols = sorted(set(symbols), key=lambda symbol: symbol.name)
        self._placeholders: dict[Expr, Symbol] = {}
        expressions = list(expressions)
        for root in _roots(expressions):
            self._placeholder(1 / root)
        for expression in expressions:
            self._flatten(expression)
        self._slopes = self._close()
        self.generators: Mapping[Symbol, Expr] = {name: key for key, name in self._placeholders.items()}
        self.ring = PolyRing([*self.symbols, *self.generators], sp.QQ)

    def read(self, expression: Expr) -> PolyElement:
        """An expression over the same functions as an element."""
        known = len(self._placeholders)
        polynomial = self._flatten(expression)
        if len(self._placeholders) > known:
            raise NotDifferentiable(f"{expression} does not lie in this ring")
        return self._element(polynomial)

    def expression(self, element: PolyElement) -> Expr:
        """An element as an expression in the plain symbols."""
        return element.as_expr().xreplace(self.generators)

    def differentiate(self, element: PolyElement, symbol: Symbol) -> PolyElement:
        """The partial derivative of an element."""
        total = element.diff(self.ring(symbol))
        for placeholder, slope in self._derivations[symbol].items():
            partial = element.diff(self.ring(placeholder))
            if partial:
                total = total + partial * slope
        return total

    @cached_property
    def _derivations(self) -> dict[Symbol, dict[Symbol, PolyElement]]:
        return {
            symbol: {
                placeholder: self._element(self._slopes[placeholder, symbol])
                for placeholder, key in self.generators.items()
                if symbol in key.free_symbols
            }
            for symbol in self.symbols
        }

    def _element(self, polynomial: Expr) -> PolyElement:
        """A polynomial in symbols and placeholders, multiplied out in the ring."""
        if isinstance(polynomial, sp.Add):
            return sum(map(self._element, polynomial.args), self.ring.zero)
        if isinstance(polynomial, sp.Mul):
            return reduce(mul, map(self._element, polynomial.args))
        if isinstance(polynomial, sp.Pow):
            return self._element(polynomial.base) ** int(polynomial.exp)
        return self.ring.from_expr(polynomial)

    def _close(self) -> dict[tuple[Symbol, Symbol], Expr]:
        """The derivative of every generator by every symbol; taking them may need further generators."""
        slopes: dict[tuple[Symbol, Symbol], Expr] = {}
        closed: set[Symbol] = set()
        while waiting := [one for one in self._placeholders.items() if one[1] not in closed]:
            for key, placeholder in waiting:
                closed.add(placeholder)
                for symbol in self.symbols:
                    slopes[placeholder, symbol] = self._flatten(sp.diff(key, symbol))
        return slopes

    def _flatten(self, expression: Expr) -> Expr:
        """The expression as a polynomial in symbols and placeholders."""
        if isinstance(expression, sp.Rational) or expression in self.symbols:
            return expression
        if isinstance(expression, sp.Add | sp.Mul):
            return expression.func(*map(self._flatten, expression.args))
        if isinstance(expression, sp.Pow):
            return self._flatten_power(*expression.as_base_exp())
        if isinstance(expression, sp.hypot):
            return self._flatten(sp.sqrt(expression.args[0] ** 2 + expression.args[1] ** 2))
        if isinstance(expression, sp.tan):
            return self._flatten(sp.sin(*expression.args) / sp.cos(*expression.args))
        if isinstance(expression, FUNCTIONS) or expression in (sp.pi, sp.E):
            return self._placeholder(expression)
        raise NotDifferentiable(f"{expression} is no polynomial, root, quotient or elementary function")

    def _flatten_power(self, base: Expr, exponent: Expr) -> Expr:
        if isinstance(exponent, sp.Integer):
            whole = int(exponent)
            if whole >= 0:
                return self._flatten(base) ** whole
            inverse_root = self._placeholders.get(1 / sp.sqrt(base))
            return self._placeholder(1 / base) ** -whole if inverse_root is None else inverse_root ** (-2 * whole)
        if isinstance(exponent, sp.Rational) and exponent.q == 2:
            inverse_root, halves = self._placeholder(1 / sp.sqrt(base)), int(exponent.p)
            return inverse_root**-halves if halves < 0 else self._flatten(base) ** ((halves + 1) // 2) * inverse_root
        if isinstance(exponent, sp.Rational):
            whole, rest = divmod(int(exponent.p), int(exponent.q))
            root = self._placeholder(base ** sp.Rational(1, int(exponent.q)))
            return self._flatten_power(base, sp.Integer(whole)) * root**rest
        raise NotDifferentiable(f"{base}**{exponent} has an exponent that is no number")

    def _placeholder(self, key: Expr) -> Symbol:
        return self._placeholders.setdefault(key, sp.Symbol(f"generator_{len(self._placeholders)}", real=True))


def _roots(expressions: Iterable[Expr]) -> list[Expr]:
    """Every square root that occurs; a quotient by what stands under one is a power of it, no generator of its own."""
    powers = {node for expression in expressions for node in expression.atoms(sp.Pow)}
    halves = (node.base for node in powers if isinstance(node.exp, sp.Rational) and node.exp.q == 2)
    return sorted({sp.sqrt(base) for base in halves if base.free_symbols}, key=str)
