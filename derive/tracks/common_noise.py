"""Two tracks of one target: their errors are correlated, for the same process noise drives both (Bar-Shalom & Campo).

With K₁ and K₂ the gains of two filters, the cross covariance of their errors goes from scan to scan by
X ← (1 − K₁ H) (F X Fᵀ + Q) (1 − K₂ H)ᵀ. The measurement errors, which are independent, do not enter. Of two α-β
filters in the steady state the solution is rational in the roots w = √(1 + 8/λ) of both indices, and symmetric.

Weights of two correlated errors are those of least variance again. Of errors whose correlation is not known,
covariance intersection (Julier & Uhlmann) weighs information: whatever the correlation, the true covariance is not
larger than (ω P₁⁻¹ + (1 − ω) P₂⁻¹)⁻¹.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.rational_function import is_zero
from radartrack.derive.bibliography import cite
from radartrack.derive.language.matrix import Matrix, product, rows, transposed
from radartrack.derive.language.quantity import Conditioning, Quantity, scalar
from radartrack.derive.language.shared_symbols import T
from radartrack.derive.language.stable_form import NotProved, StableForm
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.motion.polynomial_motion import motion
from radartrack.derive.motion.steady_state import ALPHA_BETA, solved, w
from radartrack.derive.symbolic import Expr
from radartrack.derive.tracks.fusion_weights import plane_covariance, sigma
from radartrack.derive.tracks.least_squares_line import root_of_linear
from radartrack.derive.units import METRE, METRE_PER_SECOND, ONE, SECOND

SOURCE = cite("barshalom1986")
INTERSECTION = cite("julier1997")
STATE = (METRE, METRE_PER_SECOND)

alphas = tuple(Variable(f"alpha_{j}", f"gain of the position in filter {j}", ONE, 1e-3, 1.0) for j in (1, 2))
betas = tuple(Variable(f"beta_{j}", f"gain of the velocity in filter {j}, times T", ONE, 1e-6, 2.0) for j in (1, 2))
indices = tuple(
    Variable(f"index_{j}", f"tracking index T^2 sigma_w/sigma_r of filter {j}", ONE, 1e-9, 1e3) for j in (1, 2)
)
sigma_w = Variable(
    "sigma_w", "standard deviation of the acceleration, constant over a period", METRE / SECOND**2, 1e-6, 1e3
)
before = tuple(
    tuple(
        Variable(f"cross_{m}{n}", f"cross covariance of {one} in filter 1 and {other} in filter 2", unit, -1e6, 1e6)
        for n, other, unit in ((0, "position", METRE * of), (1, "velocity", METRE_PER_SECOND * of))
    )
    for m, one, of in ((0, "position", METRE), (1, "velocity", METRE_PER_SECOND))
)
w_1, w_2, excess_1, excess_2 = (sp.Symbol(name, positive=True) for name in ("w_1", "w_2", "excess_1", "excess_2"))
rho = Variable("rho_12", "correlation of both errors", ONE, -0.999, 0.999, is_correlation=True)
share = Variable("weight", "share of the first in the information, from 0 to 1", ONE, 1e-3, 0.999)


def scanned(cross: Matrix, gains: tuple[tuple[Expr, Expr], tuple[Expr, Expr]], noise: Matrix, period: Expr) -> Matrix:
    """The cross covariance a scan later: both moved, and each reduced by its own gain."""
    F = rows(motion(2).transition.map(lambda entry: entry.xreplace({T: period})))
    moved = product(F, product(cross, transposed(F)))
    total = tuple(tuple(a + b for a, b in zip(*pair, strict=True)) for pair in zip(moved, noise, strict=True))
    first, second = (((1 - alpha, sp.Integer(0)), (-beta / period, sp.Integer(1))) for alpha, beta in gains)
    return product(first, product(total, transposed(second)))


def updated() -> Tensor[Expr]:
    """A step of the recursion."""
    noise = rows(motion(2).piecewise_noise(sigma_w))
    gains = ((alphas[0], betas[0]), (alphas[1], betas[1]))
    return _tensor(scanned(before, gains, noise, T))


@cache
def steady() -> Matrix:
    """The cross covariance that the recursion leaves as it is, for T = 1 and sigma_w = 1, over w_1 and w_2.

    Raises:
        NotProved: when it does not.
    """
    one = sp.Integer(1)
    first, second = map(_gain, (w_1, w_2))
    noise = rows(motion(2).piecewise_noise(one).map(lambda entry: entry.xreplace({T: one})))
    of_positions, mixed, of_velocities = (sp.Symbol(f"cross_{n}", real=True) for n in range(3))
    unknown = ((of_positions, mixed), (mixed, of_velocities))  # symmetric, as the proof confirms
    equations = [sp.together(change).as_numer_denom()[0] for change in _change(unknown, (first, second), noise)]
    known = solved(equations, [of_velocities, mixed, of_positions])
    found = tuple(tuple(sp.factor(known[symbol]) for symbol in row) for row in unknown)
    if not all(map(is_zero, _change(found, (first, second), noise))):
        raise NotProved("the steady cross covariance is not left as it is by a scan")
    return found


def steady_form() -> StableForm:
    """The same with w - 1, which is small where an index is large, by the index, and sums of one sign."""
    sum_of_roots, spread = w_1 + w_2, 8 / indices[0] + 8 / indices[1]
    both = excess_1 * excess_2
    mixed = T**3 * both**2 * (sum_of_roots + 2) / (8 * sum_of_roots * spread)
    entries = (
        T**4 * both**2 * (excess_1 * w_2 + excess_2) / (16 * sum_of_roots * spread),
        mixed,
        mixed,
        T**2 * both * (w_1**2 + w_2**2 + w_1 * w_2 + w_2 + excess_1) / (2 * sum_of_roots * spread),
    )
    definitions: dict[sp.Symbol, Expr] = {}
    for root, excess, index in zip((w_1, w_2), (excess_1, excess_2), indices, strict=True):
        definitions |= {root: sp.sqrt(1 + 8 / index), excess: 8 / (index * (root + 1))}
    return StableForm(definitions, Tensor((2, 2), tuple(sigma_w**2 * entry for entry in entries)))


def steady_over_indices() -> Tensor[Expr]:
    """In metres and seconds, over the tracking indices."""
    roots = {root: sp.sqrt(1 + 8 / index) for root, index in zip((w_1, w_2), indices, strict=True)}
    found = steady()
    return Tensor.build((2, 2), lambda m, n: sigma_w**2 * T ** (4 - m - n) * found[m][n].xreplace(roots))


def _gain(root: Expr) -> tuple[Expr, Expr]:
    alpha, beta = (gain.xreplace({w: root}) for gain in ALPHA_BETA.gain)
    return alpha, beta


def _change(cross: Matrix, gains: tuple[tuple[Expr, Expr], tuple[Expr, Expr]], noise: Matrix) -> Iterator[Expr]:
    later = scanned(cross, gains, noise, sp.Integer(1))
    return (later[m][n] - cross[m][n] for m in range(2) for n in range(2))


def correlated_weights() -> Tensor[Expr]:
    """Where the derivative of the variance of w e_1 + (1 - w) e_2 by w vanishes."""
    weight = sp.Symbol("weight", real=True)
    first = root_of_linear(sp.expand(sp.diff(_variance(weight), weight)), weight)
    return Tensor((2,), (first, sp.cancel(1 - first)))


def correlated_weights_form() -> StableForm:
    """Over the variance of the difference of both errors, a sum of one sign."""
    one, two = sigma[:2]
    numerators = (two * (two - rho * one), one * (one - rho * two))
    return StableForm({}, Tensor((2,), tuple(numerator / _of_difference() for numerator in numerators)))


def correlated_variance() -> Expr:
    """The variance at those weights."""
    first, _ = correlated_weights()
    return sp.cancel(_variance(first))


def correlated_variance_form() -> StableForm:
    """Without a difference that may cancel."""
    one, two = sigma[:2]
    return StableForm({}, Tensor((), ((one * two) ** 2 * (1 - rho) * (1 + rho) / _of_difference(),)))


def _variance(weight: Expr) -> Expr:
    one, two = weight * sigma[0], (1 - weight) * sigma[1]
    return one**2 + two**2 + 2 * rho * one * two


def _of_difference() -> Expr:
    one, two = sigma[:2]
    return (one - two) ** 2 + 2 * one * two * (1 - rho)


def intersection() -> Tensor[Expr]:
    """(w P1^-1 + (1 - w) P2^-1)^-1 in the plane."""
    (first, _), (second, _) = plane_covariance(1), plane_covariance(2)
    inverse = (first.inv() * share + second.inv() * (1 - share)).inv()
    return Tensor((2, 2), tuple(sp.cancel(entry) for entry in inverse))


def intersection_form() -> StableForm:
    """(w |P2| P1 + (1 - w) |P1| P2) over a sum of one sign.

    The adjugate of an inverse is the matrix over its determinant.
    """
    (first, (x_1, y_1, rho_1)), (second, (x_2, y_2, rho_2)) = plane_covariance(1), plane_covariance(2)
    of_first, of_second = ((x * y) ** 2 * (1 - r) * (1 + r) for x, y, r in ((x_1, y_1, rho_1), (x_2, y_2, rho_2)))
    unlike = ((1 - rho_1) * (1 + rho_2) + (1 + rho_1) * (1 - rho_2)) / 2  # 1 - rho_1 rho_2
    mixed = (x_1 * y_2 - y_1 * x_2) ** 2 + 2 * x_1 * y_1 * x_2 * y_2 * unlike
    left = 1 - share
    total = share**2 * of_second + left**2 * of_first + share * left * mixed
    weighed = first * (share * of_second) + second * (left * of_first)
    return StableForm({}, Tensor((2, 2), tuple(entry / total for entry in weighed)))


def _tensor(matrix: Matrix) -> Tensor[Expr]:
    return Tensor.build((len(matrix), len(matrix)), lambda m, n: matrix[m][n])


def quantities() -> Iterator[Quantity]:
    """The cross covariance of two filters, fusion of correlated errors, and covariance intersection."""
    yield Quantity(
        "fusion.cross_covariance.updated",
        "cross covariance of the errors of two alpha-beta filters of one target after a scan, from that before",
        (STATE, STATE),
        (*before[0], *before[1], alphas[0], betas[0], alphas[1], betas[1], sigma_w, T),
        Conditioning.NONE,
        SOURCE,
        "(1 - K1 H) (F X F' + Q) (1 - K2 H)'",
        updated,
        lambda: StableForm({}, updated()),
        is_difference=True,
    )
    yield Quantity(
        "fusion.cross_covariance.steady",
        "steady cross covariance of the errors of two alpha-beta filters of one target",
        (STATE, STATE),
        (*indices, sigma_w, T),
        Conditioning.NONE,
        SOURCE,
        "X = (1 - K1 H) (F X F' + Q) (1 - K2 H)'",
        steady_over_indices,
        steady_form,
        scale=steady_over_indices,
        measured_against="itself",
    )
    yield Quantity(
        "fusion.correlated.weights",
        "weights of two unbiased measurements of one thing, or of two tracks, with correlated errors",
        ((ONE, ONE),),
        (*sigma[:2], rho),
        Conditioning.TRUTH,
        SOURCE,
        "argmin of the fused variance, weights summing to 1",
        correlated_weights,
        correlated_weights_form,
        is_difference=True,
    )
    yield scalar(
        "fusion.correlated.variance",
        "variance of the fused mean of two measurements or tracks with correlated errors",
        METRE**2,
        (*sigma[:2], rho),
        SOURCE,
        "w1^2 sigma_1^2 + w2^2 sigma_2^2 + 2 w1 w2 rho sigma_1 sigma_2",
        correlated_variance,
        correlated_variance_form,
        conditioning=Conditioning.TRUTH,
    )
    (_, symbols), (_, more) = plane_covariance(1), plane_covariance(2)
    yield Quantity(
        "fusion.covariance_intersection.covariance",
        "covariance in the plane by covariance intersection, whatever the correlation of both errors",
        ((METRE, METRE), (METRE, METRE)),
        (*symbols, *more, share),
        Conditioning.NONE,
        INTERSECTION,
        "(w P1^-1 + (1 - w) P2^-1)^-1",
        intersection,
        intersection_form,
    )
