"""Derivatives of printed formulas: single ones, Jacobians, Hessians."""

from __future__ import annotations

from collections.abc import Sequence

from radartrack.derive import symbolic as sp
from radartrack.derive.language.matrix import Matrix, Vector
from radartrack.derive.symbolic import Expr, Symbol


def derivative(function: Expr, variables: Sequence[Symbol]) -> Expr:
    """The derivative by one variable after the other."""
    for variable in variables:
        function = sp.diff(function, variable)
    return function


def jacobian(outputs: Sequence[Expr], variables: Sequence[Symbol]) -> Matrix:
    """First derivatives, [out, in]."""
    return tuple(gradient(output, variables) for output in outputs)


def gradient(function: Expr, variables: Sequence[Symbol]) -> Vector:
    """First derivatives of one function."""
    return tuple(sp.diff(function, variable) for variable in variables)


def hessian(function: Expr, variables: Sequence[Symbol]) -> Matrix:
    """Second derivatives of one function, [in, in]."""
    return jacobian(gradient(function, variables), variables)


def is_finite(value: Expr) -> bool:
    """Whether nothing in a value is infinite or undefined."""
    return not value.has(sp.oo, sp.zoo, sp.nan)
