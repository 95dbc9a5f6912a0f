"""Turns a tree into SymPy expressions: the first place where a formula becomes algebra."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from types import MappingProxyType
from typing import TypeAlias

from radartrack.derive import symbolic as sp
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.fold import Fold
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
    children,
    parts,
)
from radartrack.derive.formula.unknown_names import unknown_name
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
        self._expression = Fold(self._step)

    def __call__(self, tree: Tree) -> Expression:
        """As `to_expression`."""
        expression = self._expression(tree)
        if not _is_real(expression):
            raise FormulaError("this is not a real number, whatever the symbols are", span=self._unreal(tree).span)
        return expression

    def _unreal(self, tree: Tree) -> Tree:
        """The first part that is not real although all that it is made of is."""
        unreal = (node for node in parts(tree) if not _is_real(self._expression(node)))
        return next(node for node in unreal if all(_is_real(self._expression(child)) for child in children(node)))

    def _step(self, tree: Tree, below: Sequence[Expression]) -> Expression:
        match tree:
            case Array():
                return tuple(below)
            case Sum():
                return _added(below)
            case Product():
                return _multiplied(below)
            case Quotient(_, denominator):
                return _multiplied([below[0], 1 / _scalar(denominator, below[1])])
            case Negation():
                return _multiplied([sp.Integer(-1), *below])
            case Number() | Constant() | Name():
                return self._leaf(tree)
            case Power() | Call():
                return _applied(tree, [_scalar(*pair) for pair in zip(children(tree), below, strict=True)])

    def _leaf(self, tree: Number | Constant | Name) -> Expr:
        match tree:
            case Number():
                return sp.Rational(tree.value)
            case Constant(name):
                return sp.pi if name == "pi" else sp.exp(1)
            case Name(name) if name not in self._symbols:
                raise FormulaError(unknown_name(name, self._symbols), span=tree.span)
            case Name(name):
                return self._symbols[name]


def _applied(tree: Power | Call, operands: Sequence[Expr]) -> Expr:
    match tree:
        case Power(Constant("e")):
            return sp.exp(operands[1])
        case Power():
            return operands[0] ** operands[1]
        case Call(function):
            return _FUNCTIONS[function](*operands)


def _scalar(tree: Tree, expression: Expression) -> Expr:
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
    return all(part.args or part.is_Symbol or part.is_real for part in _parts(expression))


def _parts(expression: Expr) -> Iterator[Expr]:
    """The expression and all within it, each once: SymPy's own walk takes a part as often as it stands there."""
    seen = {expression}
    waiting = [expression]
    while waiting:
        part = waiting.pop()
        yield part
        new = [below for below in part.args if below not in seen]
        seen.update(new)
        waiting.extend(new)
