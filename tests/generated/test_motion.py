"""Generated motions against exponentials of matrices in many digits, over the whole domain and at zero rate."""

import mpmath
import numpy as np
import pytest
import scipy.linalg
from hypothesis import given
from hypothesis import strategies as st

from radartrack.derive.catalogue import catalogue
from radartrack.generated import motion
from radartrack.testing import strategies
from tests.examples import share

SIZES = {"singer": 3, "ornstein_uhlenbeck": 2}
STRENGTH = {"singer": "sigma_m", "ornstein_uhlenbeck": "q"}
PERIODS = st.floats(-3, 3).map(lambda exponent: 10.0**exponent)
RATES = st.floats(-0.5, 0.5) | st.floats(-12, -3).map(lambda exponent: 10.0**exponent)
NEAR = {"x": (-1e3, 1e3), "y": (-1e3, 1e3), "T": (1e-2, 10.0)}
POLYNOMIALS = ("constant_position", "constant_velocity", "constant_acceleration", "constant_jerk")


def van_loan(drift: mpmath.matrix, inputs: mpmath.matrix, period: float) -> tuple[mpmath.matrix, mpmath.matrix]:
    """F and Q for white noise of intensity one."""
    size = drift.rows
    both = mpmath.matrix(2 * size, 2 * size)
    both[:size, :size], both[:size, size:], both[size:, size:] = -drift, inputs * inputs.T, drift.T
    found = mpmath.expm(both * mpmath.mpf(period))
    transition = found[size:, size:].T
    return transition, transition * found[:size, size:]


def forgetting(size: int, alpha: float) -> tuple[mpmath.matrix, mpmath.matrix]:
    drift, last = mpmath.zeros(size), mpmath.zeros(size, 1)
    for n in range(size - 1):
        drift[n, n + 1] = 1
    drift[size - 1, size - 1], last[size - 1] = -mpmath.mpf(alpha), 1
    return drift, last


def turning(omega: float) -> np.ndarray:
    return np.array([[0, 1, 0, 0], [0, 0, 0, -omega], [0, 0, 0, 1], [0, omega, 0, 0]], dtype=float)


def as_array(matrix: mpmath.matrix) -> np.ndarray:
    return np.array(matrix.tolist(), dtype=float)


@pytest.mark.parametrize("name", SIZES)
@given(period=PERIODS, share_of_period=st.floats(-9, 3))
@share(0.2)
def test_a_derivative_that_forgets_itself_keeps_its_digits_at_every_time_constant(
    name: str, period: float, share_of_period: float
) -> None:
    alpha = 10.0**share_of_period / period
    size = SIZES[name]
    with mpmath.workdps(60 + int(900 * (alpha * period > 30))):
        exact_F, exact_Q = van_loan(*forgetting(size, alpha), period)
        strength = 2 * mpmath.mpf(alpha) if name == "singer" else 1
        expected_F, expected_Q = as_array(exact_F), as_array(exact_Q * strength)
    F = getattr(motion, f"{name}_transition")(T=period, alpha=alpha)
    Q = getattr(motion, f"{name}_process_noise")(T=period, alpha=alpha, **{STRENGTH[name]: 1.0})
    np.testing.assert_array_less(abs(F - expected_F), 1e-14 * (abs(expected_F) + np.eye(size)) + 1e-300)
    deviations = np.sqrt(np.diag(expected_Q))
    np.testing.assert_array_less(abs(Q - expected_Q) / np.outer(deviations, deviations), 1e-14)


@given(period=st.floats(1e-3, 10), omega=RATES)
@share(0.5)
def test_a_turn_of_known_rate_is_the_exponential_of_its_matrix(period: float, omega: float) -> None:
    F = motion.turn_known_rate_transition(T=period, omega=omega)
    np.testing.assert_allclose(F, scipy.linalg.expm(turning(omega) * period), rtol=1e-12, atol=1e-12 * period)


@given(period=st.floats(1e-2, 10), omega=RATES)
@share(0.2)
def test_the_process_noise_of_a_turn_is_that_of_its_matrix(period: float, omega: float) -> None:
    inputs = mpmath.matrix([[0, 0], [1, 0], [0, 0], [0, 1]])
    with mpmath.workdps(40):
        drift = mpmath.matrix(turning(omega).tolist())
        white = as_array(van_loan(drift, inputs, period)[1])
        both = mpmath.zeros(6)
        both[:4, :4], both[:4, 4:] = drift, inputs
        shifts = as_array(mpmath.expm(both * period)[:4, 4:])
    for found, expected in (
        (motion.turn_known_rate_process_noise_continuous(T=period, omega=omega, q=1.0), white),
        (motion.turn_known_rate_process_noise_piecewise(T=period, omega=omega, sigma_w=1.0), shifts @ shifts.T),
    ):
        deviations = np.sqrt(np.diag(expected))
        np.testing.assert_array_less(abs(found - expected) / np.outer(deviations, deviations), 1e-13)


@pytest.mark.parametrize("kind", ["continuous", "piecewise"])
@pytest.mark.parametrize("strength", [0.5, 2.0])
def test_a_turn_of_rate_zero_is_a_straight_flight_to_the_last_bit(kind: str, strength: float) -> None:
    symbol = {"continuous": "q", "piecewise": "sigma_w"}[kind]
    straight = getattr(motion, f"constant_velocity_process_noise_{kind}")(T=3.0, **{symbol: strength})
    turn = getattr(motion, f"turn_known_rate_process_noise_{kind}")(T=3.0, omega=0.0, **{symbol: strength})
    np.testing.assert_allclose(turn, np.kron(np.eye(2), straight), rtol=2.0**-52)
    np.testing.assert_array_equal(motion.turn_known_rate_transition(T=3.0, omega=0.0), motion.plane_transition(T=3.0))


@given(strategies.arguments("motion.turn.unknown_rate.map", within=NEAR))
@share(0.5)
def test_a_turn_of_unknown_rate_moves_as_one_of_known_rate(point: dict[str, float]) -> None:
    *state, omega, period = point.values()
    known = motion.turn_known_rate_transition(T=period, omega=omega) @ state
    moved = motion.turn_unknown_rate_map(**point)
    size = np.abs(state).max() * (1 + period)
    np.testing.assert_allclose(moved, [*known, omega], rtol=1e-13, atol=1e-13 * size)


@given(strategies.arguments("motion.ctrv.map", within=NEAR))
@share(0.5)
def test_constant_turn_rate_and_velocity_moves_as_a_turn_of_unknown_rate(point: dict[str, float]) -> None:
    x, y, speed, heading, omega, period = point.values()
    vx, vy = speed * np.cos(heading), speed * np.sin(heading)
    turned = motion.turn_unknown_rate_map(x=x, vx=vx, y=y, vy=vy, omega=omega, T=period)
    moved = motion.ctrv_map(**point)
    ahead = moved[2] * np.cos(moved[3]), moved[2] * np.sin(moved[3])
    size = max(map(abs, (x, y, speed, heading))) * (1 + period)
    np.testing.assert_allclose([moved[0], ahead[0], moved[1], ahead[1]], turned[:4], atol=1e-12 * size)


SLOW = {**dict.fromkeys(("x", "y", "vx", "vy", "speed"), (-10.0, 10.0)), "T": (2.0, 2.0)}


@pytest.mark.parametrize("name", ["turn_unknown_rate", "ctrv"])
@given(data=st.data())
@share(0.3)
def test_derivatives_of_turns_are_those_of_the_map_and_symmetric_at_every_rate(name: str, data: st.DataObject) -> None:
    (quantity,) = (one for one in catalogue().values() if (one.module, one.function) == ("motion", f"{name}_map"))
    *names, _ = (symbol.name for symbol in quantity.symbols)
    within = {known: SLOW[known] for known in (*names, "T") if known in SLOW}
    at = data.draw(strategies.arguments(quantity.name, within=within))
    del at["T"]
    jacobian = getattr(motion, f"{name}_jacobian")(**at, T=2.0)
    hessian = getattr(motion, f"{name}_hessian")(**at, T=2.0)
    np.testing.assert_array_equal(hessian, np.swapaxes(hessian, 1, 2))
    step = 1e-4
    for place, moved in enumerate(names):
        after, before = ({**at, moved: at[moved] + sign * step} for sign in (1, -1))
        by_map = getattr(motion, f"{name}_map")(**after, T=2.0) - getattr(motion, f"{name}_map")(**before, T=2.0)
        slopes = getattr(motion, f"{name}_jacobian")
        by_jacobian = slopes(**after, T=2.0) - slopes(**before, T=2.0)
        np.testing.assert_allclose(jacobian[:, place], by_map / (2 * step), atol=1e-5)
        np.testing.assert_allclose(hessian[:, :, place], by_jacobian / (2 * step), atol=1e-5)


@pytest.mark.parametrize("size", [1, 2, 3, 4])
@given(period=PERIODS)
@share(0.2)
def test_noise_that_is_constant_over_a_period_is_a_step_of_the_motion_with_one_more_derivative(
    size: int, period: float
) -> None:
    name = POLYNOMIALS[size - 1]
    last = [period ** (size - n) / float(mpmath.factorial(size - n)) for n in range(size)]
    found = getattr(motion, f"{name}_process_noise_piecewise")(T=period, sigma_w=3.0)
    np.testing.assert_allclose(found, 9.0 * np.outer(last, last), rtol=1e-14)


@pytest.mark.parametrize("name", POLYNOMIALS)
def test_a_wiener_sequence_jumps_before_the_motion(name: str) -> None:
    last = getattr(motion, f"{name}_transition")(T=1.7)[:, -1]
    found = getattr(motion, f"{name}_process_noise_wiener_sequence")(T=1.7, sigma_w=3.0)
    np.testing.assert_allclose(found, 9.0 * np.outer(last, last), rtol=1e-14)
