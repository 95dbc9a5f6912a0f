"""Polynomial filters of fading memory: least squares over all scans there have been, of which older ones count less.

A residual n scans old has the weight θⁿ. With h_n the powers (−n)ⁱ/i! by which the range n scans ago follows from value
and derivatives now, for T = 1, least squares gives the gain S⁻¹ h₀ with S = Σ θⁿ h_n h_nᵀ, and errors of variance one
the covariance S⁻¹ (Σ θ²ⁿ h_n h_nᵀ) S⁻¹. The sums are closed: Σ nᵖ θⁿ is (θ d/dθ)ᵖ of 1/(1 − θ).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cache
from math import factorial

from radartrack.derive import symbolic as sp
from radartrack.derive.bibliography import cite
from radartrack.derive.finite_sample.filter_quantities import STATES, as_derived
from radartrack.derive.finite_sample.orthogonal_polynomials import HIGHEST_DEGREE
from radartrack.derive.language.matrix import Matrix, product, transposed
from radartrack.derive.language.quantity import Conditioning, Quantity
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.symbolic import Expr
from radartrack.derive.units import ONE
from radartrack.derive.verbs.determinants import inverse

theta = Variable("theta", "fading factor, the weight of a residual by that of the next", ONE, 1e-3, 0.9999)


@cache
def moment(power: int) -> Expr:
    """Σ nᵖ θⁿ over n from 0, times (1 − θ)ᵖ⁺¹: a polynomial."""
    if not power:
        return sp.Integer(1)
    before: Expr = moment(power - 1)  # θ d/dθ of it over (1 − θ)ᵖ
    return sp.expand(theta * (sp.diff(before, theta) * (1 - theta) + power * before))


@cache
def information(degree: int) -> Matrix:
    """S, in which row and column i are divided by (1 − θ)ⁱ, and all by 1 − θ."""
    size = degree + 1

    def entry(m: int, n: int) -> Expr:
        return sp.Integer((-1) ** (m + n)) * moment(m + n) / sp.Integer(factorial(m) * factorial(n))

    return tuple(tuple(entry(m, n) for n in range(size)) for m in range(size))


@cache
def weights(degree: int) -> Matrix:
    """S⁻¹, in which row and column i are multiplied by (1 − θ)ⁱ, and all by 1 − θ."""
    return tuple(tuple(map(sp.cancel, row)) for row in inverse(information(degree)))


@cache
def gain(degree: int) -> Tensor[Expr]:
    """What a residual of the newest scan adds to value and derivatives, times 1, T, T², …."""
    return Tensor((degree + 1,), tuple(_factored(row[0], m + 1) for m, row in enumerate(weights(degree))))


@cache
def covariance(degree: int) -> Tensor[Expr]:
    """That of the estimate, for T = 1 and errors of variance one; in it 1 − θ² is (1 − θ)(1 + θ)."""
    size = degree + 1
    squares = tuple(
        tuple(entry.xreplace({theta: theta**2}) * (1 + theta) ** (2 * degree - m - n) for n, entry in enumerate(row))
        for m, row in enumerate(information(degree))
    )
    found = product(weights(degree), product(squares, transposed(weights(degree))))

    def entry(m: int, n: int) -> Expr:
        return _factored(found[m][n] / (1 + theta) ** (2 * degree + 1), m + n + 1)

    return Tensor.build((size, size), entry)


def _factored(entry: Expr, power: int) -> Expr:
    """The entry times this power of 1 − θ, in factors that are positive: 1 − θ, not θ − 1."""
    older = sp.Symbol("1 - theta", positive=True)
    factors = (factor.as_base_exp() for factor in sp.Mul.make_args(sp.factor(entry)))
    positive = ((-older if base == theta - 1 else base) ** exponent for base, exponent in factors)
    return sp.Mul(older**power, *positive).xreplace({older: 1 - theta})


def quantities() -> Iterator[Quantity]:
    """Gain and covariance of every degree."""
    for degree in range(HIGHEST_DEGREE + 1):
        yield _quantity(
            degree,
            "",
            "what a residual adds to {}, times 1, T, T^2, ..., in a filter of fading memory",
            "S^-1 h_0, S = sum_n theta^n h_n h_n'",
            gain,
        )
        yield _quantity(
            degree,
            ".covariance",
            "error covariance of {} in a filter of fading memory, for errors of variance one, times powers of T",
            "S^-1 (sum_n theta^2n h_n h_n') S^-1",
            covariance,
        )


def _quantity(
    degree: int,
    row: str,
    meaning: str,
    word: str,
    derive: Callable[[int], Tensor[Expr]],
) -> Quantity:
    return Quantity(
        name=f"fading_memory.degree{degree}{row}",
        meaning=meaning.format(STATES[degree]),
        axes=((ONE,) * (degree + 1),) * (2 if row else 1),
        symbols=(theta,),
        conditioning=Conditioning.NONE,
        source=cite("morrison1969"),
        word=word,
        derivation=lambda: derive(degree),
        rewriting=as_derived(lambda: derive(degree)),
    )
