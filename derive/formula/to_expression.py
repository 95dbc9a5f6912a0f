"""Turns a tree into SymPy expressions: the first place where a formula becomes algebra."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import reduce
from types import MappingProxyType
from typing import TypeAlias, cast

from radartrack.derive import symbolic as sp
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.fold import Fold
from radartrack.derive.formula.functions import VERBS
from radartrack.derive.formula.tree import (
    Array,
    Call,
    Constant,
    Entries,
    Name,
    Negation,
    Number,
    Place,
    Power,
    Product,
    Quotient,
    Sum,
    Tree,
    bound_names,
    children,
    parts,
)
from radartrack.derive.formula.unknown_names import unknown_name
from radartrack.derive.language.matrix import Matrix, Vector, identity, product, transposed
from radartrack.derive.symbolic import Expr

Expression: TypeAlias = "Expr | tuple[Expression, ...]"
LARGEST_MATRIX_POWER = 12
NO_NUMBER = "this is not a real number, whatever the symbols are"
_CONSTANTS: Mapping[str, Expr] = MappingProxyType({"pi": sp.pi, "e": sp.exp(1), "inf": sp.oo})

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


Verb: TypeAlias = "Callable[[Sequence[Expression]], Expression]"
NO_VERBS: Mapping[str, Verb] = MappingProxyType({})


def to_expression(tree: Tree, symbols: Mapping[str, Expression]) -> Expression:
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
        verbs: what works out sums, integrals and the like, by the name of the verb.
    """

    def __init__(self, symbols: Mapping[str, Expression], verbs: Mapping[str, Verb] = NO_VERBS) -> None:
        self._symbols = symbols
        self._verbs = verbs
        self._expression = Fold(self._step)
        self._bound: Mapping[str, Expr] = {}

    def __call__(self, tree: Tree) -> Expression:
        """As `to_expression`."""
        self._bound = {name: sp.Symbol(name, real=True) for name in bound_names(tree) - self._symbols.keys()}
        expression = self._expression(tree)
        if not is_real(expression):
            raise FormulaError(NO_NUMBER, span=self._unreal(tree).span)
        return expression

    def _unreal(self, tree: Tree) -> Tree:
        """The first part that is not real although all that it is made of is."""
        unreal = (node for node in parts(tree) if not is_real(self._expression(node)))
        return next(node for node in unreal if all(is_real(self._expression(child)) for child in children(node)))

    def _step(self, tree: Tree, below: Sequence[Expression]) -> Expression:
        match tree:
            case Array():
                return tuple(below)
            case Sum():
                return _added(below)
            case Product():
                return _multiplied(below)
            case Quotient(_, denominator):
                return _multiplied([below[0], _valued(tree, 1 / _scalar(denominator, below[1]))])
            case Negation():
                return _multiplied([sp.Integer(-1), *below])
            case Number() | Constant() | Name():
                return self._leaf(tree)
            case Entries(_, places):
                return _picked(below[0], places)
            case Call(function) if function in VERBS:
                return self._verb(tree, below)
            case Power() | Call():
                return self._power_or_call(tree, below)

    def _power_or_call(self, tree: Power | Call, below: Sequence[Expression]) -> Expression:
        if isinstance(tree, Power) and isinstance(below[0], tuple):
            return self._power_of_matrix(tree, below[0], below[1])
        return _valued(tree, _applied(tree, [_scalar(*pair) for pair in zip(children(tree), below, strict=True)]))

    def _verb(self, tree: Call, below: Sequence[Expression]) -> Expression:
        if tree.function == "transpose":
            return _transposed(below[0])
        if tree.function not in self._verbs:
            raise FormulaError(f"{tree.function} is not read here", span=tree.span)
        try:
            return self._verbs[tree.function](below)
        except FormulaError as error:
            raise FormulaError(error.message, span=error.span or tree.span) from None

    def _power_of_matrix(self, tree: Power, matrix: Expression, exponent: Expression) -> Expression:
        """A whole power by products; a negative one of the inverse."""
        if not _is_matrix(matrix) or len(_rows(matrix)) != len(_rows(matrix)[0]):
            raise FormulaError("a power of a matrix needs as many rows as columns", span=tree.base.span)
        if not isinstance(exponent, sp.Integer) or not -LARGEST_MATRIX_POWER <= int(exponent) <= LARGEST_MATRIX_POWER:
            raise FormulaError(
                f"a matrix is raised to whole powers from -{LARGEST_MATRIX_POWER} to {LARGEST_MATRIX_POWER}",
                span=tree.exponent.span,
            )
        power = int(exponent)
        base = matrix if power > 0 else self._verb(Call("inv", (tree.base,), span=tree.span), [matrix])
        if not power:
            return identity(len(_rows(matrix)))
        return reduce(_times, [base] * abs(power))

    def _leaf(self, tree: Number | Constant | Name) -> Expression:
        match tree:
            case Number():
                return sp.Rational(tree.value)
            case Constant(name):
                return _CONSTANTS[name]
            case Name(name) if name in self._symbols:
                return self._symbols[name]
            case Name(name) if name in self._bound:
                return self._bound[name]
            case Name(name):
                raise FormulaError(unknown_name(name, self._symbols), span=tree.span)


def _applied(tree: Power | Call, operands: Sequence[Expr]) -> Expr:
    match tree:
        case Power(Constant("e")):
            return sp.exp(operands[1])
        case Power(base) if not isinstance(operands[1], sp.Rational) and not operands[0].is_positive:
            raise FormulaError(
                "an exponent that is no plain number is read only over e or what is positive", span=base.span
            )
        case Power():
            return operands[0] ** operands[1]
        case Call(function):
            return _FUNCTIONS[function](*operands)


def _valued(tree: Tree, expression: Expr) -> Expr:
    """What a part is worth; one without a value may be lost in what stands around it: 1/(1/(r - r)) is not 0."""
    if expression in {sp.zoo, sp.nan}:
        raise FormulaError(NO_NUMBER, span=tree.span)
    return expression


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
    """Scalars, and arrays in the order in which they stand."""
    scalar = sp.Mul(*(factor for factor in factors if not isinstance(factor, tuple)))
    arrays: list[Expression] = [factor for factor in factors if isinstance(factor, tuple)]
    return _scaled(scalar, reduce(_times, arrays)) if arrays else scalar


def _times(first: Expression, second: Expression) -> Expression:
    """The matrix product; a vector behind a matrix stands as a column, and so does one before a row."""
    columns = _rows(second) if _is_matrix(second) else transposed((_entries(second),))
    rows = _rows(first) if _is_matrix(first) else transposed((_entries(first),))
    found = product(rows, columns)
    return found if _is_matrix(second) else transposed(found)[0]


def _transposed(array: Expression) -> Expression:
    return transposed(_rows(array)) if _is_matrix(array) else (_entries(array),)


def _is_matrix(array: Expression) -> bool:
    return isinstance(array, tuple) and isinstance(array[0], tuple)


def _rows(array: Expression) -> Matrix:
    return cast("Matrix", array)


def _entries(array: Expression) -> Vector:
    return cast("Vector", array)


def _picked(array: Expression, places: Sequence[Place]) -> Expression:
    if not places or not isinstance(array, tuple):
        return array
    first, *rest = places
    if isinstance(first, int):
        return _picked(array[first], rest)
    return tuple(_picked(part, rest) for part in array[slice(*first)])


def _scaled(scalar: Expr, expression: Expression) -> Expression:
    if isinstance(expression, tuple):
        return tuple(_scaled(scalar, entry) for entry in expression)
    return scalar * expression


def is_real(expression: Expression) -> bool:
    """Whether no infinity, undefined value or imaginary unit arose."""
    if isinstance(expression, tuple):
        return all(map(is_real, expression))
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
