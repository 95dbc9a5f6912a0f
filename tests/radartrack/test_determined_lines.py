"""Lines, motions and fused points against exact rational arithmetic, whatever the times, positions and accuracies.

Either they are right, or an error names the argument; what is not determined is said to be so.
"""

import math
from collections.abc import Callable
from fractions import Fraction
from typing import Any, NamedTuple, TypeVar

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from radartrack import fusion, line
from tests.least_squares import Row, inverse

Array = NDArray[Any]
EPSILON = float(np.finfo(float).eps)

BEGINNINGS = st.sampled_from([0.0, 9320.596866133783, 1.7e9 + 0.1, -1e15])
STEPS = st.sampled_from([0.0, 5e-324, 1e-170, 1e-12, 2.0**-22, 0.1, 0.3, 1.0, 71.40314492, 1e5])
WEIGHTS = st.sampled_from([0.0, 1e-50, 1e-20, 1e-3, 1.0, 7.0, 1e20, 1e50])


@st.composite
def coordinates(draw: st.DrawFn, count: int) -> list[float]:
    """Numbers that repeat, or nearly."""
    beginning = draw(BEGINNINGS)
    return [beginning + draw(STEPS) for _ in range(count)]


class Track(NamedTuple):
    t: list[float]
    x: list[float]
    weights: list[float]


@st.composite
def tracks(draw: st.DrawFn) -> Track:
    count = draw(st.integers(2, 6))
    weights = draw(st.lists(WEIGHTS, min_size=count, max_size=count).filter(any))
    return Track(draw(coordinates(count)), draw(coordinates(count)), weights)


class Exact(NamedTuple):
    mean_t: Fraction
    mean_x: Fraction
    S_tt: Fraction
    S_tx: Fraction
    S_xx: Fraction


def exact(track: Track) -> Exact:
    """Weighted means, and sums about them; weights of less than 1e-100 of the largest do not count."""
    share = [Fraction(w) if w >= 1e-100 * max(track.weights) else Fraction(0) for w in track.weights]
    total = sum(share)
    share = [w / total for w in share]
    t, x = [Fraction(v) for v in track.t], [Fraction(v) for v in track.x]
    mean_t, mean_x = (sum((w * v for w, v in zip(share, values, strict=True)), Fraction(0)) for values in (t, x))
    t, x = [v - mean_t for v in t], [v - mean_x for v in x]
    sums = (
        sum((w * a * b for w, a, b in zip(share, first, second, strict=True)), Fraction(0))
        for first, second in ((t, t), (t, x), (x, x))
    )
    return Exact(mean_t, mean_x, *sums)


Answer = TypeVar("Answer")


def answered(call: Callable[[], Answer]) -> Answer | str:
    """What a call returns, or the words of its ValueError."""
    try:
        return call()
    except ValueError as error:
        return str(error)


def root(value: Fraction) -> float:
    """The square root, also of what is no float."""
    if not value:
        return 0.0
    half = (value.numerator.bit_length() - value.denominator.bit_length()) // 2
    return math.ldexp(math.sqrt(value / Fraction(2) ** (2 * half)), half)


@given(track=tracks())
def test_the_ordinary_line_is_that_of_exact_arithmetic_or_there_is_none(track: Track) -> None:
    sums = exact(track)
    fitted = answered(lambda: line.fit(track.t, track.x, weights=track.weights))
    if isinstance(fitted, str):
        assert "t must differ by more" in fitted
        assert abs(sums.S_tx) > Fraction(10) ** 199 * sums.S_tt
        return
    assert fitted.converged == (sums.S_tt > 0)
    if not sums.S_tt:
        assert np.isnan(fitted.slope)
        return
    slope = sums.S_tx / sums.S_tt
    rounding, least = 64 * EPSILON, 1e-320  # denormal numbers have fewer digits
    assert abs(float(Fraction(float(fitted.slope)) - slope)) <= least + rounding * root(sums.S_xx / sums.S_tt)
    for t, x, w in zip(track.t, track.x, track.weights, strict=True):
        expected = Fraction(x) - sums.mean_x - slope * (Fraction(t) - sums.mean_t)
        error = abs(float(Fraction(float(fitted.residual([t], [x])[0])) - expected))
        extent = root(sums.S_xx) + abs(float(Fraction(t) - sums.mean_t)) * root(sums.S_xx / sums.S_tt)
        assert not w or error <= least + rounding * (extent + abs(x) + abs(float(expected)))


@given(track=tracks())
def test_the_perpendicular_line_is_that_of_exact_arithmetic_or_there_is_none(track: Track) -> None:
    sums = exact(track)
    trace, excess = sums.S_tt + sums.S_xx, sums.S_tt - sums.S_xx
    squared_gap = excess**2 + 4 * sums.S_tx**2  # of the eigenvalues
    fitted = answered(lambda: line.fit(track.t, track.x, weights=track.weights, method="perpendicular"))
    if isinstance(fitted, str):
        assert "t must differ by more" in fitted
        return
    if squared_gap <= trace**2 / 10**24:
        assert not fitted.converged or squared_gap > 0
    elif np.isinf(fitted.slope):
        assert sums.S_xx > sums.S_tt
        assert abs(sums.S_tx) <= trace / 10**14
    else:
        k = Fraction(float(fitted.slope))
        stretch = 1 + k**2
        assert fitted.converged
        assert abs((sums.S_tx * (1 - k**2) - k * excess) / stretch) <= trace / 10**14
        assert (sums.S_tt + 2 * k * sums.S_tx + k**2 * sums.S_xx) / stretch >= Fraction(49, 100) * trace


@given(
    turn=st.floats(0.0, 7.0), corners=st.integers(3, 8), size=st.sampled_from([1e-90, 1e-3, 0.1, 1.0, 1e5, 1e90]),
    method=st.sampled_from(["perpendicular", "reweighted"]),
)  # fmt: skip
def test_plots_that_scatter_alike_in_all_directions_determine_no_line_however_they_are_rounded(
    turn: float, corners: int, size: float, method: line.Method
) -> None:
    angles = turn + 2 * np.pi * np.arange(corners) / corners
    fitted = line.fit(size * np.cos(angles), size * np.sin(angles), method=method)
    assert not fitted.converged
    assert np.isnan(fitted.slope)


@given(track=tracks(), method=st.sampled_from(["consistent", "printed"]))
def test_deviations_are_finite_where_there_are_lines(track: Track, method: line.StdMethod) -> None:
    if len(track.t) < 3:
        return
    found = answered(lambda: line.measurement_std(track.t, track.x, track.x[::-1], method))
    if isinstance(found, str):
        assert "t must differ by more" in found
        return
    assert method == "printed" or found.converged == (len(set(track.t)) > 1)
    if found.converged:
        assert np.isfinite([found.x, found.y, found.position]).all()


@pytest.mark.parametrize("scale", [1e-200, 1e-90, 1.0, 1e90])
@pytest.mark.parametrize("method", ["consistent", "printed"])
def test_deviations_go_with_the_scale_of_the_plots(scale: float, method: line.StdMethod) -> None:
    generator = np.random.default_rng(2)
    t, x, y = np.arange(9.0), *generator.normal(size=(2, 9))
    times = t * scale if method == "printed" else t
    expected, found = line.measurement_std(t, x, y, method), line.measurement_std(times, x * scale, y * scale, method)
    assert found.x == pytest.approx(expected.x * scale, rel=1e-6)
    assert found.position == pytest.approx(expected.position * scale, rel=1e-6)


# Fusion


class Plots(NamedTuple):
    t: list[float]
    position: Array
    covariance: Array


@st.composite
def plots(draw: st.DrawFn, reach: int) -> Plots:
    """Up to five plots whose deviations are up to ten to the reach, or its inverse."""
    count = draw(st.integers(1, 5))
    position = [draw(coordinates(count)) for _ in "xy"]
    covariance = []
    for _ in range(count):
        first, second = (10.0 ** draw(st.integers(-reach, reach)) * draw(st.floats(1.0, 3.0)) for _ in "xy")
        mixed = draw(st.sampled_from([0.0, 0.5, -0.99])) * first * second
        covariance.append([[first**2, mixed], [mixed, second**2]])
    return Plots(draw(coordinates(count)), np.transpose(position), np.array(covariance))


def exact_estimate(designs: list[list[Row]], seen: Array, covariance: Array) -> tuple[Row, list[Row]]:
    """Generalised least squares of independent observations, and the covariance of its error."""
    size = len(designs[0][0])
    information, gathered = [[Fraction(0)] * size for _ in range(size)], [Fraction(0)] * size
    for design, values, errors in zip(designs, seen.tolist(), covariance.tolist(), strict=True):
        weight = inverse([[Fraction(entry) for entry in row] for row in errors])
        for i, j in np.ndindex(len(values), len(values)):
            for a in range(size):
                gathered[a] += design[i][a] * weight[i][j] * Fraction(values[j])
                for b in range(size):
                    information[a][b] += design[i][a] * weight[i][j] * design[j][b]
    spread = inverse(information)
    return [sum((a * b for a, b in zip(row, gathered, strict=True)), Fraction(0)) for row in spread], spread


def assert_close(value: Array, spread: Array, expected: tuple[Row, list[Row]], size: list[float]) -> None:
    """Within a thousandth of the deviation or some digits of the size, and the covariance to eight digits."""
    deviations = [root(expected[1][i][i]) for i in range(len(size))]
    for i, deviation in enumerate(deviations):
        error = abs(float(Fraction(float(value[i])) - expected[0][i]))
        assert error <= 2e-3 * deviation + 1e-8 * abs(float(expected[0][i])) + 1e-8 * size[i]
        for j, other in enumerate(deviations):
            assert abs(float(Fraction(float(spread[i, j])) - expected[1][i][j])) <= 1e-8 * deviation * other
    assert np.array_equal(spread, spread.T)
    scaled = np.sqrt(spread.diagonal())
    assert np.linalg.eigvalsh(spread / scaled / scaled[:, np.newaxis]).min() >= -1e-14


ONE, NONE = Fraction(1), Fraction(0)


def assert_right_or_refused(seen: Plots) -> bool:
    """Whether there is a motion through plots, which then is that of exact arithmetic; else an error says why not."""
    motion = answered(lambda: fusion.fuse_plots(*seen))
    if isinstance(motion, str):
        few = len(set(seen.t)) < 2
        assert ("two different times" in motion) == few
        assert few or "t must differ by more" in motion or "covariance must be less unequal" in motion
        return False
    elapsed = [Fraction(time) - Fraction(float(motion.time)) for time in seen.t]
    designs = [[[ONE, NONE, time, NONE], [NONE, ONE, NONE, time]] for time in elapsed]
    extents, duration = np.ptp(seen.position, axis=0), np.ptp(seen.t)
    size = [*np.abs(seen.position).max(axis=0) * 1e-6 + extents, *extents / duration]
    assert motion.covariance is not None
    value = np.concatenate([motion.position, motion.velocity])
    assert_close(value, motion.covariance, exact_estimate(designs, seen.position, seen.covariance), size)
    return True


@given(seen=st.one_of(plots(2), plots(10), plots(40)))
def test_the_motion_through_plots_is_that_of_exact_arithmetic_or_an_error_says_why_not(seen: Plots) -> None:
    assert_right_or_refused(seen)


@pytest.mark.parametrize("spread", [0.0, 1e5], ids=["on a line", "off a line"])
def test_motions_through_plots_of_very_unequal_accuracies_are_right_or_refused(spread: float) -> None:
    """Of variances from 1e-40 to 1e40; off a line, by so many deviations that some cannot be fused."""
    generator, fused = np.random.default_rng(3), 0
    for _ in range(150):
        t = generator.choice([0.0, 1.0, 7.3, 100.0], 5) + generator.choice([0.0, 1.7e9])
        deviations = 10.0 ** generator.integers(-20, 21, (5, 2)) * generator.uniform(1, 3, (5, 2))
        position = 1e5 + (t - t[0])[:, np.newaxis] * [300.0, -200.0] + spread * generator.normal(size=(5, 2))
        covariance = deviations[:, :, np.newaxis] * deviations[:, np.newaxis] * np.array([[1.0, 0.5], [0.5, 1.0]])
        fused += assert_right_or_refused(Plots(t.tolist(), position, covariance))
    assert fused > (140 if spread == 0 else 100)


@given(seen=st.one_of(plots(2), plots(10), plots(40)))
def test_fused_points_are_those_of_exact_arithmetic_or_an_error_says_why_not(seen: Plots) -> None:
    fused = answered(lambda: fusion.fuse(seen.position, seen.covariance))
    if isinstance(fused, str):
        assert "covariance must be less unequal" in fused
        return
    expected = exact_estimate([[[ONE, NONE], [NONE, ONE]]] * len(seen.t), seen.position, seen.covariance)
    assert_close(fused.mean, fused.covariance, expected, [*np.abs(seen.position).max(axis=0)])


@given(seen=plots(2))
def test_plots_of_ordinary_accuracies_are_always_fused(seen: Plots) -> None:
    times = seen.t[0] + np.arange(len(seen.t)) * 10.0
    near = seen.position[0] + np.arange(2 * len(seen.t)).reshape(-1, 2)
    assert np.isfinite(fusion.fuse(near, seen.covariance).covariance).all()
    if len(times) > 1:
        assert np.isfinite(fusion.fuse_plots(times, near, seen.covariance).velocity).all()


@pytest.mark.parametrize("times", [[0.0, 10.0], [0.0, 0.0, 10.0], [0.0, 10.0, 10.0, 20.0]])
def test_plots_of_which_one_is_worth_forty_digits_more_than_the_others_are_fused(times: list[float]) -> None:
    variances = np.where(np.arange(len(times)) == 0, 1e-20, 1e20)
    position = np.array(times)[:, np.newaxis] * [3.0, -2.0]
    motion = fusion.fuse_plots(times, position, variances[:, np.newaxis, np.newaxis] * np.eye(2))
    assert motion.velocity == pytest.approx([3.0, -2.0])
    assert motion.at([0.0])[0] == pytest.approx([0.0, 0.0], abs=1e-9)


@given(seen=plots(2), weights=st.lists(WEIGHTS, min_size=5, max_size=5), layer=st.sampled_from(["equal", "reweighted"]))
def test_radars_of_few_plots_are_fused_in_every_way_and_order(
    seen: Plots, weights: list[float], layer: fusion.FirstLayer
) -> None:
    """One plot a radar: both layers are one weighted line."""
    each = [[time] for time in seen.t], seen.position[:, :1].tolist(), seen.position[:, 1:].tolist()
    given_weights = weights[: len(seen.t)]
    motion = answered(lambda: fusion.fuse_lines(*each, given_weights, first_layer=layer))
    if isinstance(motion, str):
        words = "radar_weights must have", "t must h", "t must differ by more"
        assert any(word in motion for word in words)
        counted = {t for t, w in zip(seen.t, given_weights, strict=True) if w and w >= 1e-100 * max(given_weights)}
        assert len(counted) < 2 or "differ by more" in motion
        return
    fits = [line.fit(seen.t, seen.position[:, axis], weights=given_weights) for axis in (0, 1)]
    assert motion.velocity == pytest.approx([float(fit.slope) for fit in fits], rel=1e-9)
    assert motion.covariance is None


def test_a_track_of_one_radar_with_one_plot_is_weighted_by_it_as_by_any_other() -> None:
    t, x = [[0.0, 5.0, 10.0, 15.0], [20.0]], [[0.0, 6.0, 9.0, 15.0], [21.0]]
    motion = fusion.fuse_lines(t, x, x, [1.0, 2.0], first_layer="reweighted")
    own = line.fit(t[0], x[0], method="reweighted").weights
    weights = [*own / own.mean(), 2.0]
    assert motion.velocity[0] == pytest.approx(line.fit([*t[0], *t[1]], [*x[0], *x[1]], weights=weights).slope)


@given(
    exponents=st.lists(st.integers(-320, 99), min_size=3, max_size=3),
    azimuth=st.floats(-7.0, 7.0), elevation=st.floats(-1.6, 1.6),
)  # fmt: skip
def test_propagated_covariances_are_symmetric_and_positive_semidefinite_at_every_scale(
    exponents: list[int], azimuth: float, elevation: float
) -> None:
    r, range_std, angle = (float(f"1e{exponent}") for exponent in exponents)
    std = min(angle, 3.0)
    matrix = fusion.propagated_covariance(r, azimuth, range_std, std, elevation, std)
    assert matrix[0, 1] == matrix[1, 0]
    assert abs(matrix[0, 1]) <= math.sqrt(matrix[0, 0]) * math.sqrt(matrix[1, 1]) * (1 + 1e-12)
    stated = math.hypot(range_std, r * std) / math.sqrt(2)
    propagated = math.hypot(*np.sqrt(matrix.diagonal())) / math.sqrt(2)
    assert fusion.stated_std(range_std, std, r) == pytest.approx(stated, rel=1e-12, abs=1e-322)
    assert fusion.position_std(matrix) == pytest.approx(propagated, rel=1e-12, abs=0.0)


# No tracks, and what is refused


def test_no_tracks_give_no_lines() -> None:
    none = np.zeros((0, 4))
    for method in ("ordinary", "perpendicular", "reweighted"):
        fitted = line.fit(np.arange(4.0), none, method=method)
        assert fitted.slope.shape == fitted.converged.shape == (0,)
        assert fitted.at([0.0]).shape == (0, 1)
    for name in ("consistent", "printed"):
        assert line.measurement_std(np.arange(4.0), none, none, name).position.shape == (0,)
    assert fusion.weights(none).shape == (0, 4)
    assert fusion.fuse(np.zeros((0, 3, 2)), np.eye(2) * np.ones((3, 1, 1))).covariance.shape == (0, 2, 2)
    motion = fusion.fuse_plots(np.arange(4.0), np.zeros((0, 4, 2)), np.eye(2))
    assert motion.at([0.0]).shape == (0, 1, 2)
    assert motion.covariance is not None
    assert motion.covariance.shape == (0, 4, 4)
    assert fusion.fuse_lines([np.arange(4.0)], [none], [none], [1.0]).velocity.shape == (0, 2)
    assert line.to_plane([], [])[0].shape == (0,)


TWO: Any = [1.0, 2.0]
REFUSED: dict[str, tuple[Callable[[], object], str]] = {
    "no radars": (lambda: fusion.fuse_lines([], [], [], []), "t must hold the times of at least one radar"),
    "no weight": (lambda: fusion.fuse_lines([TWO], [TWO], [TWO], [0.0]), "radar_weights must have a positive"),
    "no plots": (lambda: fusion.fuse_plots([], np.zeros((0, 2)), np.eye(2)), "two different times"),
    "one plot": (lambda: fusion.fuse_plots([0.0], np.zeros((1, 2)), np.eye(2)), "two different times"),
    "no axis of plots": (lambda: fusion.fuse_plots(0.0, np.zeros(2), np.eye(2)), "two different times"),
    "fast motion": (lambda: fusion.fuse_plots([0.0, 5e-324], np.eye(2), np.eye(2)), "t must differ by more"),
    "no variance": (lambda: fusion.fuse([TWO], [np.zeros((2, 2))]), "covariance must be positive definite"),
    "wild": (lambda: fusion.fuse([TWO], [[[1e-300, 1e200], [1e200, 1e-300]]]), "covariance must be positive"),
    "correlation 5": (
        lambda: fusion.position_std([[1.0, 5.0], [5.0, 1.0]]),
        "covariance must be positive semidefinite",
    ),
    "one side": (lambda: fusion.position_std([[1.0, 0.5], [0.0, 1.0]]), "covariance must be symmetric"),
    "fast": (lambda: line.fit([0.0, 5e-324], [0.0, 1.0]), "t must differ by more"),
    "steep": (lambda: line.fit([0.0, 1e-220], [0.0, 1.0], method="perpendicular"), "t must differ by more"),
    "at no time": (lambda: line.fit(TWO, TWO).at(["a"]), "t must be"),
    "at the end of time": (lambda: line.fit(TWO, TWO).residual([np.inf], [0.0]), "t must be finite"),
    "beyond": (lambda: line.fit(TWO, TWO).distance([0.0], [1e200]), "x must be from"),
}


@pytest.mark.parametrize("case", REFUSED)
def test_what_has_no_answer_is_refused_by_name(case: str) -> None:
    call, words = REFUSED[case]
    with pytest.raises((ValueError, TypeError), match=words):
        call()
