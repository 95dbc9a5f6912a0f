"""Derivatives of printed formulas: single ones, Jacobians, Hessians, Taylor polynomials."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations_with_replacement
from math import factorial, prod

from radartrack.derive import symbolic as sp
from radartrack.derive.language.matrix import Matrix, Vector
from radartrack.derive.symbolic import Expr, Symbol
from radartrack.derive.verbs.no_closed_form import NoClosedForm

MOST_TERMS = 500  # of a Taylor polynomial: six variables to order 4 have 210, to order 5 462


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


def taylor(function: Expr, increments: Sequence[Symbol], order: int) -> Expr:
    """The Taylor polynomial in some symbols about zero, to an order in all of them together.

    Raises:
        NoClosedForm: when it would be too long, or a derivative is not finite at zero.
    """
    terms = [
        choice
        for degree in range(order + 1)
        for choice in combinations_with_replacement(range(len(increments)), degree)
    ]
    if len(terms) > MOST_TERMS:
        raise NoClosedForm(f"a Taylor polynomial of {len(terms)} terms is too long; {MOST_TERMS} are allowed")
    known: dict[tuple[int, ...], Expr] = {(): function}
    at_zero = dict.fromkeys(increments, sp.Integer(0))
    parts = []
    for choice in terms:
        if choice:
            known[choice] = sp.diff(known[choice[:-1]], increments[choice[-1]])
        value = known[choice].xreplace(at_zero)
        if not is_finite(value):
            raise NoClosedForm("the function has no Taylor polynomial at zero: a derivative is not finite there")
        powers = [choice.count(place) for place in range(len(increments))]
        below = prod(factorial(power) for power in powers)
        parts.append(value * prod(i**p for i, p in zip(increments, powers, strict=True)) / sp.Integer(below))
    return sp.Add(*parts)


def is_finite(value: Expr) -> bool:
    """Whether nothing in a value is infinite or undefined."""
    return not value.has(sp.oo, sp.zoo, sp.nan)
