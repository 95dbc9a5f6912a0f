"""The verbs by name: what each makes of its arguments as they were read."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from types import MappingProxyType
from typing import cast

from radartrack.derive import symbolic as sp
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.to_expression import Expression, Verb
from radartrack.derive.language.matrix import Matrix, Vector, diagonal, identity, kronecker, outer, trace
from radartrack.derive.symbolic import Expr, Symbol
from radartrack.derive.verbs.derivatives import derivative, gradient, hessian, jacobian
from radartrack.derive.verbs.determinants import determinant, inverse
from radartrack.derive.verbs.expectation import expectation
from radartrack.derive.verbs.gates import probability, quantile
from radartrack.derive.verbs.integrals import integrated
from radartrack.derive.verbs.limit import limit
from radartrack.derive.verbs.matrix_exponential import exponential
from radartrack.derive.verbs.sums import summed
from radartrack.derive.verbs.taylor_polynomial import taylor

HIGHEST_ORDER = 12  # of a Taylor polynomial


def entrywise(function: Callable[..., Expr]) -> Verb:
    """A verb that changes every entry of its first argument alike."""

    def verb(arguments: Sequence[Expression]) -> Expression:
        first, *others = arguments
        if isinstance(first, tuple):
            return tuple(verb([entry, *others]) for entry in first)
        return function(first, *others)

    return verb


def _diff(function: Expr, *variables: Expression) -> Expr:
    return derivative(function, [_symbol("diff", variable) for variable in variables])


def _sum(term: Expr, index: Expression, first: Expr, last: Expr) -> Expr:
    return summed(term, _symbol("sum", index), first, last)


def _integral(function: Expr, variable: Expression, low: Expr, high: Expr) -> Expr:
    return integrated(function, _symbol("integral", variable), low, high)


def _limit(function: Expr, variable: Expression, point: Expr) -> Expr:
    return limit(function, _symbol("limit", variable), point)


def _taylor(function: Expr, increments: Expression, order: Expr) -> Expr:
    if not isinstance(order, sp.Integer) or not 0 <= int(order) <= HIGHEST_ORDER:
        raise FormulaError(f"the order of a Taylor polynomial is a whole number from 0 to {HIGHEST_ORDER}")
    return taylor(function, _symbols("taylor", increments), int(order))


def _expectation(function: Expr, pairs: Expression) -> Expr:
    rows = pairs if isinstance(pairs, tuple) else ()
    if not rows or any(not isinstance(row, tuple) or len(row) != 2 for row in rows):
        raise FormulaError("expectation takes the deviation of each error, such as {x: sigma_x}")
    return expectation(function, {_symbol("expectation", x): sigma for x, sigma in cast("Matrix", rows)})


def _jacobian(arguments: Sequence[Expression]) -> Expression:
    outputs, variables = arguments
    symbols = _symbols("jacobian", variables)
    return jacobian(_vector(outputs), symbols) if isinstance(outputs, tuple) else gradient(outputs, symbols)


def _hessian(arguments: Sequence[Expression]) -> Expression:
    outputs, variables = arguments
    symbols = _symbols("hessian", variables)
    if isinstance(outputs, tuple):
        return tuple(hessian(output, symbols) for output in _vector(outputs))
    return hessian(outputs, symbols)


def _diag(arguments: Sequence[Expression]) -> Expression:
    first = arguments[0]
    return diagonal(_vector(first) if isinstance(first, tuple) else _vector(tuple(arguments)))


def _norm(arguments: Sequence[Expression]) -> Expression:
    first = arguments[0]
    return sp.sqrt(sp.Add(*(entry**2 for entry in _flat(first)))) if isinstance(first, tuple) else sp.Abs(first)


def _flat(array: Expression) -> list[Expr]:
    return [entry for part in array for entry in _flat(part)] if isinstance(array, tuple) else [array]


def _eye(arguments: Sequence[Expression]) -> Expression:
    return identity(int(cast("Expr", arguments[0])))


def _vector(array: Expression) -> Vector:
    return cast("Vector", array)


def _matrix(array: Expression) -> Matrix:
    return cast("Matrix", array)


def _symbol(verb: str, argument: Expression) -> Symbol:
    if not isinstance(argument, Symbol):
        raise FormulaError(f"{verb} wants a symbol where {argument} stands: a name that is defined is no symbol")
    return argument


def _symbols(verb: str, argument: Expression) -> list[Symbol]:
    return [_symbol(verb, one) for one in (argument if isinstance(argument, tuple) else (argument,))]


VERBS: Mapping[str, Verb] = MappingProxyType(
    {
        "chi2cdf": entrywise(probability),
        "chi2inv": entrywise(quantile),
        "det": lambda arguments: determinant(_matrix(arguments[0])),
        "diag": _diag,
        "diff": entrywise(_diff),
        "expectation": entrywise(_expectation),
        "expm": lambda arguments: exponential(_matrix(arguments[0])),
        "eye": _eye,
        "hessian": _hessian,
        "integral": entrywise(_integral),
        "inv": lambda arguments: inverse(_matrix(arguments[0])),
        "jacobian": _jacobian,
        "kron": lambda arguments: kronecker(*map(_matrix, arguments)),
        "limit": entrywise(_limit),
        "norm": _norm,
        "outer": lambda arguments: outer(*map(_vector, arguments)),
        "sum": entrywise(_sum),
        "taylor": entrywise(_taylor),
        "trace": lambda arguments: trace(_matrix(arguments[0])),
    }
)
