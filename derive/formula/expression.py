"""Turns a tree into SymPy expressions: the first place where a formula becomes algebra."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from types import MappingProxyType
from typing import TypeAlias

from radartrack.derive import symbolic as sp
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.names import unknown_name
from radartrack.derive.formula.tree import (
    Array,
    Call,
    Constant,
    Name,
    Negation,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Tree,
)
from radartrack.derive.symbolic import Expr

Expression: TypeAlias = "Expr | tuple[Expression, ...]"

_FUNCTIONS: Mapping[str, Callable[..., Expr]] = MappingProxyType(
    {
        "abs": sp.Abs,
        "acos": sp.acos,
        "asin": sp.asin,
        "atan": sp.atan,
        "atan2": sp.atan2,
        "cos": sp.cos,
        "cosh": sp.cosh,
        "cot": lambda x: sp.cos(x) / sp.sin(x),
        "coth": lambda x: sp.cosh(x) / sp.sinh(x),
        "csc": lambda x: 1 / sp.sin(x),
        "exp": sp.exp,
        "expm1": lambda x: sp.exp(x) - 1,
        "hypot": lambda x, y: sp.sqrt(x**2 + y**2),
        "log": sp.log,
        "sec": lambda x: 1 / sp.cos(x),
        "sin": sp.sin,
        "sinh": sp.sinh,
        "sqrt": sp.sqrt,
        "tan": sp.tan,
        "tanh": sp.tanh,
    }
)


def to_expression(tree: Tree, symbols: Mapping[str, Expr]) -> Expression:
    """The formula in these symbols, exact: 0.5 is one half. An array becomes nested tuples.

    Args:
        tree: a tree within the limits of the readers.
        symbols: what each name in the tree stands for.

    Raises:
        FormulaError: for a name without a symbol, and for a formula that is infinite or imaginary: 1/(r - r).
    """
    return Reader(symbols)(tree)


class Reader:
    """Makes expressions of trees; a subtree that several of them share is read once.

    Args:
        symbols: what each name in a tree stands for.
    """

    def __init__(self, symbols: Mapping[str, Expr]) -> None:
        self._symbols = symbols
        self._known: dict[int, tuple[Tree, Expression]] = {}  # by identity; the tree is kept for as long

    def __call__(self, tree: Tree) -> Expression:
        """As `to_expression`."""
        expression = self._expression(tree)
        if not _is_real(expression):
            raise FormulaError("this is not a real number, whatever the symbols are", span=tree.span)
        return expression

    def _expression(self, tree: Tree) -> Expression:
        known = self._known.get(id(tree))
        if known is None:
            known = self._known[id(tree)] = tree, self._read(tree)
        return known[1]

    def _read(self, tree: Tree) -> Expression:
        match tree:
            case Array(entries):
                return tuple(map(self._expression, entries))
            case Sum(terms):
                return _added(list(map(self._expression, terms)))
            case Product(factors):
                return _multiplied(list(map(self._expression, factors)))
            case Quotient(numerator, denominator):
                return _multiplied([self._expression(numerator), 1 / self._scalar(denominator)])
            case Negation(operand):
                return _multiplied([sp.Integer(-1), self._expression(operand)])
            case _:
                return self._read_scalar(tree)

    def _read_scalar(self, tree: Number | Constant | Name | Power | Call) -> Expr:
        match tree:
            case Number():
                return sp.Rational(tree.value)
            case Constant(name):
                return sp.pi if name == "pi" else sp.exp(1)
            case Name(name) if name not in self._symbols:
                raise FormulaError(unknown_name(name, self._symbols), span=tree.span)
            case Name(name):
                return self._symbols[name]
            case Power(Constant("e"), exponent):
                return sp.exp(self._scalar(exponent))
            case Power(base, exponent):
                return self._scalar(base) ** self._scalar(exponent)
            case Call(function, arguments):
                return _FUNCTIONS[function](*map(self._scalar, arguments))

    def _scalar(self, tree: Tree) -> Expr:
        expression = self._expression(tree)
        if isinstance(expression, tuple):
            raise FormulaError("a vector or matrix cannot stand here", span=tree.span)
        return expression


def _added(terms: Sequence[Expression]) -> Expression:
    """Scalars, or arrays of one shape entry by entry."""
    arrays = [term for term in terms if isinstance(term, tuple)]
    if arrays:
        return tuple(_added(entries) for entries in zip(*arrays, strict=True))
    return sp.Add(*(term for term in terms if not isinstance(term, tuple)))


def _multiplied(factors: Sequence[Expression]) -> Expression:
    """Scalars, or scalars and one array."""
    scalar = sp.Mul(*(factor for factor in factors if not isinstance(factor, tuple)))
    arrays = [factor for factor in factors if isinstance(factor, tuple)]
    return _scaled(scalar, arrays[0]) if arrays else scalar


def _scaled(scalar: Expr, expression: Expression) -> Expression:
    if isinstance(expression, tuple):
        return tuple(_scaled(scalar, entry) for entry in expression)
    return scalar * expression


def _is_real(expression: Expression) -> bool:
    """Whether no infinity, undefined value or imaginary unit arose."""
    if isinstance(expression, tuple):
        return all(map(_is_real, expression))
    return all(atom.is_Symbol or atom.is_real for atom in expression.atoms())
