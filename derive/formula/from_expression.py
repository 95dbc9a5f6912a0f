"""Turns an expression into the tree of the formula that is printed for it: the way back from algebra."""

from __future__ import annotations

from collections.abc import Sequence

from radartrack.derive import symbolic as sp
from radartrack.derive.formula.tree import Call, Constant, Name, Negation, Number, Power, Product, Quotient, Sum, Tree
from radartrack.derive.symbolic import Expr

HALF = sp.Rational(1, 2)
ONE = Number("1")
# What conditions make of formulas outside of where they hold; the readers do not take it back.
_NO_NUMBERS = {sp.I: "i", sp.nan: "undefined", sp.oo: "infinity", -sp.oo: "infinity", sp.zoo: "infinity"}


def to_tree(expression: Expr) -> Tree:
    """The formula as people write it: terms and factors in order, divisors below a line, roots as roots.

    A function that the readers do not know stands there by its own name.
    """
    return _Printer().tree(expression)


class _Printer:
    """Makes one object of equal parts."""

    def __init__(self) -> None:
        self._known: dict[Expr, Tree] = {}

    def tree(self, expression: Expr) -> Tree:
        if expression not in self._known:
            self._known[expression] = self._made(expression)
        return self._known[expression]

    def _made(self, expression: Expr) -> Tree:
        if isinstance(expression, sp.Symbol):
            return Name(expression.name)
        if expression in (sp.pi, sp.E):
            return Constant("pi" if expression == sp.pi else "e")
        if expression in _NO_NUMBERS:
            return Name(_NO_NUMBERS[expression])
        if isinstance(expression, sp.Rational):
            return _signed(_over([_number(abs(expression.p))], _unless_one(expression.q)), expression)
        if isinstance(expression, sp.Add):
            return Sum(tuple(map(self.tree, expression.as_ordered_terms())))
        if isinstance(expression, sp.Mul):
            return self._product(expression)
        if isinstance(expression, sp.Pow):
            return self._power(expression)
        if isinstance(expression, sp.Abbreviation):
            return self.tree(expression.expanded())
        return Call(expression.func.__name__.lower(), tuple(map(self.tree, expression.args)))

    def _product(self, expression: Expr) -> Tree:
        coefficient, rest = expression.as_coeff_Mul(rational=True)
        above, below = _unless_one(abs(coefficient.p)), _unless_one(coefficient.q)
        for factor in rest.as_ordered_factors():
            if isinstance(factor, sp.Pow) and _is_negative(factor.exp):
                below.append(self._raised(factor.base, -factor.exp))
            else:
                above.append(self.tree(factor))
        return _signed(_over(above or [ONE], below), coefficient)

    def _power(self, expression: Expr) -> Tree:
        if -expression.exp in (1, HALF):
            return Quotient(ONE, self._raised(expression.base, -expression.exp))
        return self._raised(expression.base, expression.exp)

    def _raised(self, base: Expr, exponent: Expr) -> Tree:
        if exponent == HALF:
            return Call("sqrt", (self.tree(base),))
        return self.tree(base) if exponent == 1 else Power(self.tree(base), self.tree(exponent))


def _is_negative(exponent: Expr) -> bool:
    return bool(exponent.as_coeff_Mul()[0] < 0)


def _number(value: int) -> Number:
    return Number(str(value))


def _unless_one(value: int) -> list[Tree]:
    return [] if value == 1 else [_number(value)]


def _signed(tree: Tree, number: Expr) -> Tree:
    return Negation(tree) if number < 0 else tree


def _over(above: Sequence[Tree], below: Sequence[Tree]) -> Tree:
    return Quotient(_times(above), _times(below)) if below else _times(above)


def _times(factors: Sequence[Tree]) -> Tree:
    return factors[0] if len(factors) == 1 else Product(tuple(factors))
