"""The line of least distance, against sums over explicit points and against the definition of a minimum."""

from fractions import Fraction

import mpmath
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from radartrack.derive import symbolic as sp
from radartrack.derive.evaluation.many_digits import evaluate
from radartrack.derive.symbolic import Expr, Symbol
from radartrack.derive.tracks import least_squares_line

Point = tuple[Fraction, Fraction, Fraction]
RATIONAL = st.fractions(min_value=-9, max_value=9, max_denominator=7)
POINTS = st.lists(
    st.tuples(RATIONAL, RATIONAL, st.fractions(min_value=Fraction(1, 5), max_value=5, max_denominator=5)),
    min_size=3,
    max_size=5,
)


def rational(value: Fraction) -> Expr:
    return sp.Rational(value.numerator, value.denominator)


def sums_of(points: list[Point]) -> dict[Expr, Expr]:
    """The moments of weighted points, straight from their definition."""
    total = sum(w for _, _, w in points)
    mean_x = sum(w * x for x, _, w in points) / total
    mean_y = sum(w * y for _, y, w in points) / total
    squares = sum(w * (x - mean_x) ** 2 for x, _, w in points)
    products = sum(w * (x - mean_x) * (y - mean_y) for x, y, w in points)
    others = sum(w * (y - mean_y) ** 2 for _, y, w in points)
    values = (total, mean_x, mean_y, squares, products, others)
    return dict(zip(least_squares_line.SUMS, (rational(Fraction(value)) for value in values), strict=True))


def explicit_objective(points: list[Point], k: Expr, d: Expr) -> Expr:
    """The weighted sum of squared distances, term by term."""
    terms = (rational(w) * (rational(y) - k * rational(x) - d) ** 2 / (1 + k**2) for x, y, w in points)
    return sp.Add(*terms)


@given(points=POINTS, slope=RATIONAL, intercept=RATIONAL)
def test_the_objective_over_moments_is_the_sum_over_any_weighted_points(
    points: list[Point], slope: Fraction, intercept: Fraction
) -> None:
    at = {least_squares_line.k: rational(slope), least_squares_line.d: rational(intercept)}
    assert least_squares_line.objective().xreplace(sums_of(points) | at) == explicit_objective(
        points, at[least_squares_line.k], at[least_squares_line.d]
    )


SCATTERED = [
    (Fraction(1), Fraction(2), Fraction(1, 3)),
    (Fraction(-2), Fraction(5, 2), Fraction(2)),
    (Fraction(4), Fraction(-7, 3), Fraction(1)),
    (Fraction(0), Fraction(1), Fraction(3, 2)),
]


def test_gradient_and_hessian_are_the_derivatives_of_the_sum_over_weighted_points() -> None:
    f, moments = explicit_objective(SCATTERED, least_squares_line.k, least_squares_line.d), sums_of(SCATTERED)
    parameters: tuple[Symbol, ...] = (least_squares_line.k, least_squares_line.d)
    for first, derived in zip(parameters, least_squares_line.gradient(), strict=True):
        assert sp.cancel(derived.xreplace(moments) - sp.diff(f, first)) == 0
    for (i, j), derived in least_squares_line.hessian().items():
        assert sp.cancel(derived.xreplace(moments) - sp.diff(f, parameters[i], parameters[j])) == 0


@given(s_xx=st.floats(0.01, 1e6), s_yy=st.floats(0.01, 1e6), share=st.floats(-0.999, 0.999), other=RATIONAL)
def test_no_other_slope_has_a_smaller_sum_of_squared_distances(
    s_xx: float, s_yy: float, share: float, other: Fraction
) -> None:
    s_xy = share * (s_xx * s_yy) ** 0.5
    assume(abs(share) > 1e-6)
    point: dict[Symbol, float] = {
        least_squares_line.S_xx: s_xx,
        least_squares_line.S_xy: s_xy,
        least_squares_line.S_yy: s_yy,
    }
    best = evaluate(least_squares_line.slope(), point)

    def distance_sum(slope: mpmath.mpf) -> mpmath.mpf:
        return (s_yy - 2 * slope * s_xy + slope**2 * s_xx) / (1 + slope**2)

    with mpmath.workdps(60):
        assert distance_sum(best) <= distance_sum(mpmath.mpf(other.numerator) / other.denominator) * (1 + 1e-40)
        assert mpmath.tan(evaluate(least_squares_line.inclination(), point)) == pytest.approx(best, rel=1e-40)


@pytest.mark.parametrize("s_xy", [-3.0, 2.5])
def test_the_hessian_is_positive_definite_at_the_best_line_and_indefinite_at_the_other_stationary_one(
    s_xy: float,
) -> None:
    moments: dict[Symbol, float] = {
        least_squares_line.W: 2.0,
        least_squares_line.mean_x: 0.7,
        least_squares_line.mean_y: -1.5,
        least_squares_line.S_xx: 4.0,
        least_squares_line.S_xy: s_xy,
        least_squares_line.S_yy: 9.0,
    }
    determinants = []
    for root in least_squares_line.stationary():
        slope = evaluate(
            root, {s: moments[s] for s in (least_squares_line.S_xx, least_squares_line.S_xy, least_squares_line.S_yy)}
        )
        with mpmath.workdps(60):
            intercept = moments[least_squares_line.mean_y] - slope * moments[least_squares_line.mean_x]
        at = moments | {least_squares_line.k: slope, least_squares_line.d: intercept}
        gradient = [evaluate(entry, at) for entry in least_squares_line.gradient()]
        assert all(abs(entry) < mpmath.mpf(10) ** -40 for entry in gradient)
        (kk, kd, _, dd) = (evaluate(entry, at) for entry in least_squares_line.hessian())
        assert dd > 0
        determinants.append((slope == evaluate(least_squares_line.slope(), at), kk * dd - kd**2 > 0))
    assert sorted(determinants) == [(False, False), (True, True)]


def test_weighted_distances_weigh_with_the_squares_of_their_weights() -> None:
    v = sp.Symbol("v", positive=True)
    one_point = {
        least_squares_line.S_xx: sp.Integer(0),
        least_squares_line.S_xy: sp.Integer(0),
        least_squares_line.S_yy: sp.Integer(0),
        least_squares_line.W: v**2,
    }
    weighted = (v * least_squares_line.distance()).xreplace(
        {least_squares_line.x: least_squares_line.mean_x, least_squares_line.y: least_squares_line.mean_y}
    )
    assert sp.cancel(least_squares_line.objective().xreplace(one_point) - weighted**2) == 0
