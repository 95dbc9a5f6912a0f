"""Correlated tracks, covariance intersection and registration, beside dense algebra, searches and simulation."""

import contextlib
import math
from collections.abc import Callable
from typing import Any, cast

import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.optimize import minimize_scalar

from radartrack import fusion, kalman
from radartrack.generated import fusion as formulas
from radartrack.generated import steady_state
from tests.examples import share
from tests.radartrack.plots import Floats

SEEDS = st.integers(0, 10**6)


def covariances(seed: int, size: int, count: int = 2, spread: float = 1.0) -> Floats:
    """Positive definite matrices with axes of their own, of very unlike lengths."""
    generator = np.random.default_rng(seed)
    root = generator.standard_normal((count, size, size)) * 10.0 ** generator.uniform(-spread, spread, (count, 1, size))
    matrices: Floats = root @ np.swapaxes(root, -1, -2)
    return matrices


def intersected(P: Floats, w: float) -> Floats:
    found: Floats = np.linalg.inv(w * np.linalg.inv(P[0]) + (1 - w) * np.linalg.inv(P[1]))
    return found


SIZES: dict[str, Any] = {"trace": np.trace, "determinant": lambda P: np.linalg.slogdet(P)[1]}


@pytest.mark.parametrize("criterion", SIZES)
@given(seed=SEEDS, size=st.integers(1, 6))
@share(0.3)
def test_no_other_weight_makes_the_intersection_smaller(criterion: Any, seed: int, size: int) -> None:
    P = covariances(seed, size)
    got = fusion.covariance_intersection(np.zeros((2, size)), P, criterion)
    best = minimize_scalar(lambda w: SIZES[criterion](intersected(P, w)), bounds=(0, 1), method="bounded")
    candidates = [best.fun, SIZES[criterion](P[0]), SIZES[criterion](P[1])]
    found = SIZES[criterion](got.covariance)
    assert found <= min(candidates) + 1e-7 * max(1.0, abs(min(candidates)))
    expected, tolerance = intersected(P, float(got.weight)), 1e-13 * np.linalg.cond(P).max()
    deviations = np.sqrt(np.diagonal(expected))
    assert (np.abs(got.covariance - expected) <= max(tolerance, 1e-12) * np.outer(deviations, deviations)).all()


@given(seed=SEEDS, size=st.integers(1, 4), w=st.floats(0.0, 1.0))
@share(0.3)
def test_the_intersection_holds_the_true_covariance_whatever_the_correlation(seed: int, size: int, w: float) -> None:
    P = covariances(seed, size, spread=0.5)
    generator = np.random.default_rng(seed + 1)
    mean = generator.standard_normal((2, size))
    got = fusion.covariance_intersection(mean, P, weight=w)
    turn, _ = np.linalg.qr(generator.standard_normal((size, size)))
    cross = np.linalg.cholesky(P[0]) @ turn @ np.linalg.cholesky(P[1]).T  # fully correlated, the worst there is
    gains = [w * got.covariance @ np.linalg.inv(P[0]), (1 - w) * got.covariance @ np.linalg.inv(P[1])]
    rounding = 1e-9 + 1e-15 * np.linalg.cond(P).max()  # of the inverses here
    assert np.allclose(got.mean, gains[0] @ mean[0] + gains[1] @ mean[1], rtol=1e-8, atol=rounding)
    mixed = gains[0] @ cross @ gains[1].T
    true = gains[0] @ P[0] @ gains[0].T + gains[1] @ P[1] @ gains[1].T + mixed + mixed.T
    excess = np.linalg.eigvalsh(got.covariance - true)
    assert excess[0] >= -1e-9 * np.trace(got.covariance)


@pytest.mark.parametrize("criterion", ["trace", "determinant"])
def test_covariances_that_are_the_same_share_the_weight(criterion: Any) -> None:
    P = np.array([[4.0, 1.0], [1.0, 3.0]])
    got = fusion.covariance_intersection([[1.0, 5.0], [3.0, 1.0]], np.stack([P, P]), criterion)
    np.testing.assert_allclose(got.mean, [2.0, 3.0], rtol=1e-14)
    np.testing.assert_allclose(got.covariance, P, rtol=1e-14)
    assert got.weight == 0.5


@given(seed=st.integers(0, 10**6), decades=st.floats(0.0, 2.4))
@share(0.3)
def test_intersections_along_axes_of_very_different_deviations_keep_their_digits(seed: int, decades: float) -> None:
    """One estimate is up to 1e10 times the better along one axis than along another, compared with the other one."""
    generator = np.random.default_rng(seed)
    root = np.eye(4) + 0.3 * generator.standard_normal((2, 4, 4))
    root *= 10.0 ** (decades * generator.choice([-1.0, 1.0], (2, 4, 1)))
    P = root @ np.swapaxes(root, -1, -2)
    got = fusion.covariance_intersection(np.zeros((2, 4)), P, weight=0.3).covariance
    with mpmath.workdps(50):
        first, second = (mpmath.inverse(mpmath.matrix(part.tolist())) for part in P)
        exact = mpmath.inverse(mpmath.mpf(0.3) * first + (1 - mpmath.mpf(0.3)) * second)
    deviations = np.sqrt([float(exact[k, k]) for k in range(4)])
    errors = (got - np.array(exact.tolist(), float)) / np.outer(deviations, deviations)
    assert np.abs(errors).max() <= 1e-5


@pytest.mark.parametrize("size", [1, 3])
@given(seed=SEEDS, decades=st.tuples(st.floats(-10, 10), st.floats(-10, 10)), w=st.sampled_from([0.0, 0.3, 1.0]))
@share(0.3)
def test_a_poor_estimate_takes_no_digits_from_a_good_one(
    seed: int, decades: tuple[float, float], w: float, size: int
) -> None:
    """However far it is off: nothing is rounded to the digits of the poor one, be it the first or the second."""
    P = covariances(seed, size, spread=0.3) + np.eye(size)
    P *= 100.0 ** np.reshape(decades, (2, 1, 1))
    generator = np.random.default_rng(seed)
    deviations = np.sqrt(np.diagonal(P, axis1=1, axis2=2))
    mean = generator.standard_normal(size) + deviations * generator.standard_normal((2, size))
    roots = np.linalg.cholesky(P)
    cross = 0.5 * roots[0] @ roots[1].T
    got = [fusion.Fused(*fusion.covariance_intersection(mean, P, weight=w)[:2]), fusion.fuse_correlated(mean, P, cross)]
    with mpmath.workdps(80):
        inverse = [mpmath.inverse(mpmath.matrix(part.tolist())) for part in P]
        joint = mpmath.inverse(mpmath.matrix(np.block([[P[0], cross], [cross.T, P[1]]]).tolist()))
        both = mpmath.matrix(np.concatenate([np.eye(size)] * 2).tolist())
        points = [mpmath.matrix(part.tolist()) for part in mean]
        parts = [mpmath.mpf(weight) * part for weight, part in zip((w, 1 - w), inverse, strict=True)]
        information = parts[0] + parts[1], both.T * joint * both
        told = parts[0] * points[0] + parts[1] * points[1], both.T * joint * mpmath.matrix(mean.ravel().tolist())
        for found, inverted, weighed in zip(got, information, told, strict=True):
            expected = np.array(mpmath.lu_solve(inverted, weighed).tolist(), float)[:, 0]
            error = np.abs(found.mean - expected) - 4e-16 * np.abs(expected)
            assert (error <= 1e-9 * np.sqrt(np.diagonal(found.covariance))).all()


@given(
    decades=st.tuples(st.floats(-307, 200), st.floats(-307, 200)), criterion=st.sampled_from(["trace", "determinant"])
)
@share(0.3)
def test_intersections_of_any_sizes_are_right_or_refused_as_too_unequal(
    decades: tuple[float, float], criterion: Any
) -> None:
    variances = 10.0 ** np.array(decades)
    unequal = abs(decades[0] - decades[1]) > 60
    with pytest.raises(ValueError, match="not too unequal") if unequal else contextlib.nullcontext():
        got = fusion.covariance_intersection([[1.0], [1.0]], variances.reshape(2, 1, 1), criterion)
        np.testing.assert_allclose(got.covariance, variances.min(), rtol=1e-14)


def test_intersections_of_a_batch_are_those_of_each_and_the_closed_form_of_the_plane() -> None:
    P = np.stack([covariances(seed, 2) for seed in range(50)]).reshape(5, 10, 2, 2, 2)
    got = fusion.covariance_intersection(np.zeros((2, 2)), P, "determinant")
    assert (got.mean.shape, got.covariance.shape, got.weight.shape) == ((5, 10, 2), (5, 10, 2, 2), (5, 10))
    alone = fusion.covariance_intersection(np.zeros((2, 2)), P[3, 4], "determinant")
    assert np.allclose(got.weight[3, 4], alone.weight, atol=1e-12)
    deviations = np.sqrt(np.diagonal(P, axis1=-2, axis2=-1))
    rho = P[..., 0, 1] / deviations.prod(axis=-1)
    names = {f"sigma_{axis}{j + 1}": deviations[..., j, place] for j in range(2) for place, axis in enumerate("xy")}
    plane = formulas.covariance_intersection_covariance(
        **names, rho_1=rho[..., 0], rho_2=rho[..., 1], weight=got.weight
    )
    assert np.allclose(plane, got.covariance, rtol=1e-6)


@pytest.mark.parametrize("criterion", ["trace", "determinant"])
def test_an_estimate_that_is_worse_in_every_way_gets_no_weight(criterion: Any) -> None:
    P = np.stack([np.diag([1.0, 4.0]), np.diag([2.0, 5.0])])
    mean = np.array([[1.0, 2.0], [9.0, 9.0]])
    for order, weight in (([0, 1], 1.0), ([1, 0], 0.0)):
        got = fusion.covariance_intersection(mean[order], P[order], criterion)
        assert got.weight == weight
        assert np.allclose(got.mean, mean[0])
        assert np.allclose(got.covariance, P[0])


@given(seed=SEEDS, size=st.integers(1, 5))
@share(0.3)
def test_correlated_estimates_are_fused_as_bar_shalom_and_campo_do(seed: int, size: int) -> None:
    generator = np.random.default_rng(seed)
    joint = covariances(seed, 2 * size, 1, 0.4)[0]
    P1, P2, P12 = joint[:size, :size], joint[size:, size:], joint[:size, size:]
    mean = generator.standard_normal((2, size))
    gain = (P1 - P12) @ np.linalg.inv(P1 + P2 - P12 - P12.T)
    got = fusion.fuse_correlated(mean, np.stack([P1, P2]), P12)
    tolerance = 1e-6 * np.linalg.cond(joint) / 1e4 + 1e-8
    assert np.allclose(got.mean, mean[0] + gain @ (mean[1] - mean[0]), rtol=tolerance, atol=tolerance)
    assert np.allclose(got.covariance, P1 - gain @ (P1 - P12.T), rtol=tolerance, atol=tolerance * np.trace(P1))


def test_independent_estimates_are_fused_as_ever() -> None:
    mean, P = np.random.default_rng(0).standard_normal((7, 2, 3)), covariances(3, 3, 14).reshape(7, 2, 3, 3)
    got, expected = fusion.fuse_correlated(mean, P, np.zeros((3, 3))), fusion.fuse(mean, P)
    assert np.allclose(got.mean, expected.mean, rtol=1e-9)
    assert np.allclose(got.covariance, expected.covariance, rtol=1e-9)


H = np.array([[1.0, 0.0]])
PERIOD, SIGMA_W, STDS = 2.0, 0.8, (15.0, 40.0)


def steady_filters() -> tuple[kalman.Motion, list[fusion.Filtered]]:
    moves = kalman.motion("constant_velocity", PERIOD, std=SIGMA_W)
    filters = []
    for std in STDS:
        P = steady_state.alpha_beta_covariance(index=PERIOD**2 * SIGMA_W / std, sigma_r=std, T=PERIOD)
        filters.append(fusion.Filtered(P, H, [[std**2]]))
    return moves, filters


def test_the_steady_cross_covariance_is_the_closed_form_and_what_the_recursion_comes_to() -> None:
    moves, filters = steady_filters()
    steady = fusion.steady_cross_covariance(moves, *filters)
    indices = {f"index_{j + 1}": PERIOD**2 * SIGMA_W / std for j, std in enumerate(STDS)}
    closed = formulas.cross_covariance_steady(**indices, sigma_w=SIGMA_W, T=PERIOD)
    assert np.allclose(steady, closed, rtol=1e-11)
    scans = [one._replace(covariance=np.broadcast_to(one.covariance, (300, 2, 2))) for one in filters]
    assert np.allclose(fusion.cross_covariances(moves, scans[0], scans[1])[-1], closed, rtol=1e-9)


def test_the_cross_covariance_is_that_of_simulated_filters_also_with_plots_missing() -> None:
    generator = np.random.default_rng(5)
    runs, scans, push_std = 40_000, 6, 5.0
    moves = kalman.motion("constant_velocity", PERIOD, std=push_std)
    start = np.diag([100.0**2, 10.0**2])
    seen = np.array([True, True, False, True, True, True])
    truth = np.zeros((runs, 2))
    truths, plots = [], []
    for _ in range(scans):
        push = push_std * generator.standard_normal((runs, 1)) * [PERIOD**2 / 2, PERIOD]
        truth = truth @ moves.transition.T + push
        truths.append(truth)
        plots.append([truth[:, :1] + std * generator.standard_normal((runs, 1)) for std in STDS])
    errors, filters = [], []
    for j, std in enumerate(STDS):
        measured = np.stack([scan[j] for scan in plots], axis=1)
        if j:
            measured[:, ~seen] = np.nan
        first = generator.multivariate_normal(np.zeros(2), start, runs, method="cholesky")
        track = kalman.run(kalman.Belief(first, start), moves, measured, H, [[std**2]])
        errors.append(track.mean[:, -1] - truths[-1])
        filters.append(fusion.Filtered(track.covariance[0], H, [[std**2]], seen if j else True))
    got = fusion.cross_covariances(moves, filters[0], filters[1])[-1]
    products = errors[0][:, :, np.newaxis] * errors[1][:, np.newaxis]
    band = 4.5 * products.std(axis=0) / math.sqrt(runs)
    assert (np.abs(products.mean(axis=0) - got) <= band).all()
    assert (np.abs(got) > 3 * band).all()  # so that no cross covariance would be noticed


@pytest.mark.parametrize(
    ("starts", "tracks"),
    [((), ()), ((0,), ()), ((3,), ()), ((3,), (1,)), ((0,), (1,)), ((), (3,)), ((1,), (3,)), ((2, 3), (3,))],
)
def test_starts_and_filters_broadcast_each_pair_as_alone(starts: tuple[int, ...], tracks: tuple[int, ...]) -> None:
    moves = kalman.motion("constant_velocity", PERIOD, std=5.0)
    generator = np.random.default_rng(3)
    spread = np.diag([30.0, 4.0]) * generator.uniform(1, 2, (*tracks, 4, 1, 1))
    one, other = fusion.Filtered(spread, H, [[9.0]]), fusion.Filtered(2 * spread, H, [[16.0]])
    start = generator.standard_normal((*starts, 2, 2))
    got = fusion.cross_covariances(moves, one, other, start)
    shape = np.broadcast_shapes(starts, tracks)
    assert got.shape == (*shape, 4, 2, 2)
    start, spread = np.broadcast_to(start, (*shape, 2, 2)), np.broadcast_to(spread, (*shape, 4, 2, 2))
    for index in np.ndindex(shape):
        own = (one._replace(covariance=spread[index]), other._replace(covariance=2 * spread[index]))
        np.testing.assert_allclose(got[index], fusion.cross_covariances(moves, *own, start[index]), rtol=1e-12)


def test_scans_that_were_seen_are_as_many_as_the_covariances() -> None:
    moves = kalman.motion("constant_velocity", PERIOD, std=5.0)
    filtered = fusion.Filtered(np.tile(np.eye(2), (4, 1, 1)), H, [[9.0]])
    with pytest.raises(ValueError, match=r"second\.seen \(3,\), second\.covariance \(4,\)"):
        fusion.cross_covariances(moves, filtered, filtered._replace(seen=np.ones(3, dtype=bool)))


def test_a_cross_covariance_that_overflows_is_refused() -> None:
    moves = kalman.Motion(1e100 * np.eye(2), np.eye(2))
    filtered = fusion.Filtered(np.tile(0.1 * np.eye(2), (5, 1, 1)), H, [[1.0]])
    with pytest.raises(ValueError, match="cross covariance of the result must be finite"):
        fusion.cross_covariances(moves, filtered, filtered)


SITES = np.array([[0.0, 0.0], [60e3, 10e3], [20e3, 70e3]])
BIAS = np.array([[120.0, 0.004], [-80.0, -0.003], [40.0, 0.002]])
STD = np.array([[30.0, 0.002], [60.0, 0.003], [45.0, 0.001]])


def plots_of(generator: np.random.Generator, runs: int, targets: int, axis: str, bias: Floats) -> tuple[Floats, Floats]:
    positions = generator.uniform(-10e3, 80e3, (runs, 1, targets, 2))
    x, y = np.moveaxis(positions - SITES[:, np.newaxis], -1, 0)
    true = np.stack([np.hypot(x, y), np.arctan2(y, x) if axis == "x" else np.arctan2(x, y)], axis=-1)
    noise = STD[:, np.newaxis] * generator.standard_normal(true.shape)
    measured = true + bias[:, np.newaxis] + noise
    return measured[..., 0], measured[..., 1]


@pytest.mark.parametrize(("axis", "reference"), [("x", None), ("y", None), ("y", 1)])
def test_biases_of_radars_are_found_with_their_covariance(axis: Any, reference: int | None) -> None:
    generator = np.random.default_rng(8)
    bias = BIAS.copy()
    if reference is not None:
        bias[reference] = 0.0
    runs, targets = 300, 40
    r, azimuth = plots_of(generator, runs, targets, axis, bias)
    r[:, 2, :10] = np.nan
    azimuth[:, 0, 35:] = np.nan
    got = fusion.registration(r, azimuth, STD[:, :1], STD[:, 1:], SITES, azimuth_from=axis, reference=reference)
    error = np.stack([got.range_bias, got.azimuth_bias], axis=-1) - bias
    error = error.reshape(runs, -1)
    kept = [k for k in range(6) if reference is None or k // 2 != reference]
    assert np.delete(error, kept, axis=1).size == 0 or not np.delete(error, kept, axis=1).any()
    error, P = error[:, kept], got.covariance[:, kept][:, :, kept]
    nees = np.einsum("ri,rij,rj->r", error, np.linalg.inv(P), error)
    band = 4.5 * math.sqrt(2 * len(kept) / runs)
    assert abs(nees.mean() - len(kept)) <= band
    deviations = np.sqrt(np.diagonal(P, axis1=-2, axis2=-1)).mean(axis=0)
    assert (np.abs(error.mean(axis=0)) <= 4.5 * deviations / math.sqrt(runs)).all()
    if reference is None:
        assert (deviations < np.abs(bias).ravel()).all()


def test_biases_that_no_target_tells_are_refused() -> None:
    generator = np.random.default_rng(9)
    r, azimuth = plots_of(generator, 1, 30, "x", BIAS)
    with pytest.raises(ValueError, match="targets must determine the biases"):
        fusion.registration(r[0, :2, :1], azimuth[0, :2, :1], 30.0, 0.002, SITES[:2])
    alone = r[0].copy()
    alone[1:] = np.nan
    with pytest.raises(ValueError, match="targets must determine the biases"):
        fusion.registration(alone, azimuth[0], 30.0, 0.002, SITES)
    with pytest.raises(ValueError, match="targets must determine the biases"):
        fusion.registration(r[0], azimuth[0], 30.0, 0.002, np.zeros((3, 2)))


GOOD = np.stack([np.eye(2), 2 * np.eye(2)])


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: fusion.covariance_intersection(np.zeros((3, 2)), GOOD), r"mean must have shape \(\.\.\., 2, d\)"),
        (
            lambda: fusion.covariance_intersection(np.zeros((2, 2)), GOOD, cast("Any", "area")),
            "criterion must be one of",
        ),
        (lambda: fusion.covariance_intersection(np.zeros((2, 2)), GOOD * [[[1, 0], [0, 0]]]), "positive definite"),
        (
            lambda: fusion.covariance_intersection(np.zeros((2, 2)), [np.diag([1, 1e-14]), np.diag([1e-14, 1])]),
            "not too unequal",
        ),
        (
            lambda: fusion.covariance_intersection(np.zeros((2, 2)), GOOD * [[[1, 0], [0, 1]], [[0, 0], [0, 1]]]),
            "definite",
        ),
        (
            lambda: fusion.covariance_intersection(np.zeros((2, 2)), [np.diag([1, 1e-300]), np.diag([1e-300, 1])]),
            "no variance may be more than 1e60 times the other",
        ),
        (lambda: fusion.covariance_intersection(np.zeros((2, 2)), GOOD, weight=1.5), "weight must be from 0 to 1"),
        (lambda: fusion.fuse_correlated(np.zeros((2, 2)), GOOD, 2 * np.eye(2)), "covariance with cross_covariance"),
        (lambda: fusion.fuse_correlated(np.zeros((2, 2)), GOOD, np.eye(3)), "cross_covariance must have shape"),
        (lambda: fusion.registration([[1e4]], [[0.1]], 10.0, 0.01, [[0.0, 0.0]]), "two radars or more"),
        (lambda: fusion.registration([[1e4]] * 2, [[0.1]] * 2, 10.0, 0.0, [[0.0, 0.0]] * 2), "azimuth_std must be"),
        (lambda: fusion.registration([[1e4]] * 2, [[0.1]] * 2, 10.0, 1e-300, [[0.0, 0.0]] * 2), "got 1e-300"),
    ],
)
def test_what_does_not_fit_is_refused(call: Any, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        call()


def test_filters_that_do_not_settle_have_no_steady_cross_covariance() -> None:
    moves = kalman.motion("constant_velocity", PERIOD, std=SIGMA_W)
    blind = fusion.Filtered(np.eye(2), np.zeros((1, 2)), [[1.0]])
    with pytest.raises(ValueError, match="do not die away"):
        fusion.steady_cross_covariance(moves, blind, blind)


@pytest.mark.parametrize(
    "way", ["fuse", "fuse_plots", "fuse_correlated", "covariance_intersection", "cross_covariances"]
)
@given(powers=st.tuples(st.floats(-3, 3), st.floats(-3, 3)), sign=st.sampled_from([-1.0, 1.0]), both=st.booleans())
@share(0.3)
def test_errors_that_are_one_are_refused_whichever_way_they_are_rounded(
    way: str, powers: tuple[float, float], sign: float, *, both: bool
):
    """What is to be inverted has an inverse by more than rounding: of a correlation of 1 it is rounding."""
    deviations = 10.0 ** np.array(powers)
    one = np.outer(deviations, deviations) * [[1.0, sign], [sign, 1.0]]
    P = np.stack([one, one if both else np.diag(deviations**2)])
    moves = kalman.constant_velocity(1.0, 1.0)
    track = fusion.Filtered(P, np.eye(2), one)
    calls: dict[str, Callable[[], object]] = {
        "fuse": lambda: fusion.fuse(np.zeros((2, 2)), P),
        "fuse_plots": lambda: fusion.fuse_plots([0.0, 1.0], np.zeros((2, 2)), P),
        "fuse_correlated": lambda: fusion.fuse_correlated(np.zeros((2, 2)), P, np.zeros((2, 2))),
        "covariance_intersection": lambda: fusion.covariance_intersection(np.zeros((2, 2)), P),
        "cross_covariances": lambda: fusion.cross_covariances(moves, track, track),
    }
    with pytest.raises(ValueError, match="must be positive definite, by more than rounding"):
        calls[way]()
