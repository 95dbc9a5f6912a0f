"""What the printed deviations estimate, against integrals and against the eigenvectors of the population."""

import mpmath
import numpy as np
import pytest

from radartrack.derive import symbolic as sp
from radartrack.derive.evaluation.many_digits import evaluate
from radartrack.derive.language.variable import Variable
from radartrack.derive.symbolic import Symbol
from radartrack.derive.tracks import deviation_from_line, least_squares_line, line_over_time
from radartrack.derive.tracks.fusion_weights import weights
from radartrack.derive.units import METRE, METRE_PER_SECOND, ONE


def absolute_moment(power: int) -> mpmath.mpf:
    """E |l|^power of a standard normal l, by quadrature of the definition."""
    with mpmath.workdps(40):
        normal = mpmath.npdf
        return mpmath.quad(lambda length: abs(length) ** power * normal(length), [-mpmath.inf, -8, 0, 8, mpmath.inf])


def test_the_fold_factors_are_the_moments_of_the_folded_normal() -> None:
    mean, square = absolute_moment(1), absolute_moment(2)
    with mpmath.workdps(40):
        assert abs(evaluate(deviation_from_line.folded_mean_factor(), {}) - mean) < 1e-30
        assert abs(evaluate(deviation_from_line.folded_std_factor(), {}) - mpmath.sqrt(square - mean**2)) < 1e-30


@pytest.mark.parametrize(
    ("speed", "sigma", "std_t", "c"),
    [(0.5, 3.0, 20.0, 1.0), (40.0, 900.0, 30.0, 7.0), (0.02, 80.0, 25.0, 1.0)],
)
def test_the_limits_of_the_perpendicular_fit_are_eigenvalue_and_eigenvector_of_the_population(
    speed: float, sigma: float, std_t: float, c: float
) -> None:
    time, error = c * std_t * np.array([1.0, speed / c]), np.array([0.0, sigma])
    values, vectors = np.linalg.eigh(np.outer(time, time) + np.outer(error, error))
    s = deviation_from_line
    at: dict[Symbol, float] = {s.speed: speed, s.sigma_x: sigma, s.std_t: std_t, s.c: c}
    assert float(evaluate(s.variance_limit(), at)) == pytest.approx(values[0], rel=1e-9)
    assert float(evaluate(s.slope_limit(), at)) == pytest.approx(c * vectors[1, 1] / vectors[0, 1], rel=1e-9)


def test_about_a_long_track_the_printed_variance_is_that_of_the_error_over_one_plus_the_slope_squared() -> None:
    s = deviation_from_line
    long: dict[Symbol, float] = {s.std_t: 1e30, s.speed: 3.5, s.sigma_x: 2.0, s.c: 0.5}
    expected: dict[Symbol, float] = {line_over_time.v: 3.5, s.sigma_x: 2.0, s.c: 0.5}
    fold = evaluate(s.folded_std_factor(), {})
    assert fold**2 * evaluate(s.variance_limit(), long) == pytest.approx(evaluate(s.printed_std(), expected) ** 2)


def test_the_printed_root_adds_one_to_a_squared_speed() -> None:
    """In the plane of two lengths the slope is a number; in that of time and length it is a speed."""
    assert least_squares_line.k.unit == ONE
    assert isinstance(line_over_time.v, Variable)
    assert line_over_time.v.unit == METRE_PER_SECOND
    [printed] = (q for q in deviation_from_line.quantities() if q.name == "line.motion.printed_std")
    assert printed.unit(()) == METRE
    assert deviation_from_line.c in printed.symbols


def test_what_the_print_estimates_depends_on_the_units_of_time() -> None:
    s = deviation_from_line
    in_seconds = evaluate(s.printed_std(), {line_over_time.v: 200.0, s.sigma_x: 100.0, s.c: 1.0})
    in_minutes = evaluate(s.printed_std(), {line_over_time.v: 200.0, s.sigma_x: 100.0, s.c: 1.0 / 60})
    assert in_seconds / in_minutes == pytest.approx(60, rel=1e-3)


def test_a_common_slope_cancels_in_the_weights_of_one_coordinate_and_not_in_those_of_the_position() -> None:
    s = deviation_from_line
    first, second = sp.Symbol("first", positive=True), sp.Symbol("second", positive=True)
    factor = s.printed_std() / s.sigma_x
    printed = weights([(factor * first) ** 2, (factor * second) ** 2])
    assert all(sp.cancel(a - b) == 0 for a, b in zip(printed, weights([first**2, second**2]), strict=True))

    def position_variance(sigma_x: float, sigma_y: float) -> mpmath.mpf:
        at: dict[Symbol, float] = {s.v_x: 200.0, s.v_y: 0.0, s.sigma_x: sigma_x, s.sigma_y: sigma_y, s.c: 1.0}
        return evaluate(s.printed_position_std(), at) ** 2

    alike = position_variance(300.0, 100.0), position_variance(100.0, 300.0)
    assert alike[1] / alike[0] == pytest.approx(9, rel=0.01)
