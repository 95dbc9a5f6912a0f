"""Weights for fusing several unbiased measurements of one thing: least variance, the weights summing to one.

The Lagrangian is Σ w_j² σ_j² + 2 μ (1 − Σ w_j). Each weight occurs in one term of each sum, so the condition
for any one of them, w σ² = μ, is that for all, however many there are; the constraint gives μ, which is the
fused variance.

For vectors with error covariances P_j the weights are matrices that sum to the unit matrix, and the trace of
the fused covariance Σ W_j P_j W_jᵀ is the least. With a matrix M of multipliers the condition is W_j P_j = M.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from itertools import chain

from radartrack.derive import symbolic as sp
from radartrack.derive.bibliography import cite
from radartrack.derive.language.quantity import Conditioning, Quantity, scalar
from radartrack.derive.language.stable_form import NotProved
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import Variable, angle, deviation, length
from radartrack.derive.symbolic import Expr, Matrix, Symbol
from radartrack.derive.tracks.least_squares_line import root_of_linear
from radartrack.derive.units import METRE, ONE

FULLEST = 0.999  # two covariances that are singular together may have no weights
r = length("r", "range")
beta = angle("beta", "azimuth")
sigma_beta = deviation(beta, low=1e-9, high=1.0)
sigma = tuple(Variable(f"sigma_{j}", f"standard deviation of measurement {j}", METRE, 1e-2, 1e5) for j in (1, 2, 3))
information = Variable("information", "sum of 1/sigma^2 over all measurements", METRE**-2, 1e-10, 1e6)
weight = sp.Symbol("weight", real=True)
multiplier = sp.Symbol("multiplier", real=True)


def stationary_weight(variance: Expr) -> Expr:
    """The weight at which the Lagrangian's derivative vanishes, as a function of the multiplier."""
    terms = weight**2 * variance - 2 * multiplier * weight
    return root_of_linear(sp.diff(terms, weight), weight)


def weights(variances: Sequence[Expr]) -> tuple[Expr, ...]:
    """The weights of least fused variance for any list of variances."""
    stationary = [stationary_weight(variance) for variance in variances]
    fused = root_of_linear(sp.together(sp.Add(*stationary)) - 1, multiplier)
    return tuple(sp.cancel(one.xreplace({multiplier: fused})) for one in stationary)


def fused_variance(variances: Sequence[Expr]) -> Expr:
    """The variance of the weighted mean."""
    pairs = zip(weights(variances), variances, strict=True)
    return sp.cancel(sp.Add(*(one**2 * variance for one, variance in pairs)))


def weight_of_one() -> Expr:
    """The weight of one of any number of measurements; the multiplier is one over the information."""
    return stationary_weight(sigma[0] ** 2).xreplace({multiplier: 1 / information})


def matrix_weights(covariances: Sequence[Matrix]) -> list[Matrix]:
    """The weights W_j = M P_j⁻¹ with M = (Σ P_j⁻¹)⁻¹.

    Raises:
        NotProved: when the derivative of the Lagrangian by some entry of some weight does not vanish there.
    """
    inverses = [covariance.inv() for covariance in covariances]
    multipliers = sum(inverses[1:], inverses[0]).inv().applyfunc(sp.cancel)
    found = [(multipliers * inverse).applyfunc(sp.cancel) for inverse in inverses]
    for one, covariance in zip(found, covariances, strict=True):
        for condition in lagrangian_derivatives(one, covariance, multipliers):
            if sp.cancel(condition) != sp.Integer(0):
                raise NotProved("the derivative of the fused covariance's trace should vanish at the weights")
    return found


def lagrangian_derivatives(at: Matrix, covariance: Matrix, multipliers: Matrix) -> list[Expr]:
    """The derivatives of tr(W P Wᵀ) − 2 tr(Mᵀ W) by the entries of W, at a given W; one for each entry."""
    rows, columns = at.shape
    names = [[sp.Symbol(f"weight_{i}_{j}", real=True) for j in range(columns)] for i in range(rows)]
    free = Matrix(names)
    terms = sp.Add(*diagonal(free * covariance * free.T)) - 2 * sp.Add(*diagonal(multipliers.T * free))
    values = dict(zip(chain.from_iterable(names), at, strict=True))
    return [sp.diff(sp.expand(terms), entry).xreplace(values) for entry in values]


def diagonal(matrix: Matrix) -> list[Expr]:
    """The entries on the diagonal."""
    return [matrix[i, i] for i in range(matrix.shape[0])]


def plane_covariance(number: int) -> tuple[Matrix, tuple[Variable, Variable, Variable]]:
    """The error covariance of x and y of one measurement, and its symbols."""
    first, second = (
        Variable(f"sigma_{axis}{number}", f"standard deviation of {axis} of measurement {number}", METRE, 1e-2, 1e5)
        for axis in "xy"
    )
    meaning = f"correlation of the errors of x and y of measurement {number}"
    rho = Variable(f"rho_{number}", meaning, ONE, -FULLEST, FULLEST, is_correlation=True)
    mixed = rho * first * second
    return Matrix([[first**2, mixed], [mixed, second**2]]), (first, second, rho)


def quantities() -> Iterator[Quantity]:
    """Weights and variances of two and three measurements, of one among many, and of two in the plane."""
    for name, some in (("two", sigma[:2]), ("three", sigma)):
        yield _weights(name, some)
        yield scalar(
            f"fusion.variance.{name}",
            f"variance of the best weighted mean of {name} measurements",
            METRE**2,
            some,
            AITKEN,
            "sum of w^2 sigma^2",
            partial(fused_variance, _squares(some)),
            conditioning=Conditioning.TRUTH,
        )
    yield scalar(
        "fusion.weight",
        "weight of one measurement among any number",
        ONE,
        (sigma[0], information),
        AITKEN,
        "argmin of the fused variance, weights summing to 1",
        weight_of_one,
        conditioning=Conditioning.TRUTH,
    )
    yield _matrix_weights()
    yield scalar(
        "fusion.cross_range_std",
        "error across the line of sight from an error of azimuth",
        METRE,
        (r, sigma_beta),
        cite("gao2020", "introduction"),
        "r times the error of azimuth",
        lambda: r * sigma_beta,
        conditioning=Conditioning.TRUTH,
    )


AITKEN = cite("aitken1936")


def _squares(deviations: Sequence[Symbol]) -> list[Expr]:
    return [one**2 for one in deviations]


def _weights(name: str, deviations: tuple[Variable, ...]) -> Quantity:
    return Quantity(
        f"fusion.weights.{name}",
        f"weights of {name} unbiased measurements of one thing",
        ((ONE,) * len(deviations),),
        deviations,
        Conditioning.TRUTH,
        AITKEN,
        "argmin of the fused variance, weights summing to 1",
        lambda: Tensor((len(deviations),), weights(_squares(deviations))),
    )


def _matrix_weights() -> Quantity:
    (first, symbols), (second, more) = plane_covariance(1), plane_covariance(2)
    return Quantity(
        "fusion.matrix_weights.two",
        "weight of the first of two measurements in the plane, [out, in]",
        ((ONE, ONE), (ONE, ONE)),
        (*symbols, *more),
        Conditioning.TRUTH,
        AITKEN,
        "argmin of the trace of the fused covariance, weights summing to the unit matrix",
        lambda: Tensor((2, 2), tuple(matrix_weights([first, second])[0])),
    )
