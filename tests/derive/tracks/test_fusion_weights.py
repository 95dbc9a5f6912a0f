"""Fusion weights, against the definition of a minimum under the constraint."""

from functools import cache

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from radartrack.derive import symbolic as sp
from radartrack.derive.evaluation.many_digits import evaluate
from radartrack.derive.symbolic import Expr, Matrix, Symbol
from radartrack.derive.tracks import fusion_weights
from radartrack.testing import strategies

SIGMA = [sp.Symbol(f"s_{j}", positive=True) for j in range(4)]


@pytest.mark.parametrize("count", [2, 3, 4])
def test_weights_sum_to_one_and_every_shift_along_the_constraint_adds_variance(count: int) -> None:
    found = fusion_weights.weights([s**2 for s in SIGMA[:count]])
    assert sp.cancel(sp.Add(*found) - 1) == 0
    steps = [sp.Symbol(f"step_{j}", real=True) for j in range(count - 1)]
    moves: list[Expr] = [*steps, -sp.Add(*steps)]
    moved = sp.Add(*((w + m) ** 2 * s**2 for w, m, s in zip(found, moves, SIGMA[:count], strict=True)))
    added = sp.Add(*(m**2 * s**2 for m, s in zip(moves, SIGMA[:count], strict=True)))
    assert sp.cancel(moved - fusion_weights.fused_variance([s**2 for s in SIGMA[:count]]) - added) == 0


def test_a_common_factor_of_all_deviations_cancels_in_the_weights() -> None:
    factor = sp.Symbol("factor", positive=True)
    scaled = fusion_weights.weights([(factor * s) ** 2 for s in SIGMA[:3]])
    assert all(
        sp.cancel(a - b) == 0 for a, b in zip(scaled, fusion_weights.weights([s**2 for s in SIGMA[:3]]), strict=True)
    )


def test_one_weight_among_any_number_is_that_of_the_list() -> None:
    information = sp.Add(*(1 / s**2 for s in SIGMA))
    one = fusion_weights.weight_of_one().xreplace(
        {fusion_weights.information: information, fusion_weights.sigma[0]: SIGMA[0]}
    )
    assert sp.cancel(one - fusion_weights.weights([s**2 for s in SIGMA])[0]) == 0


@cache
def matrix_weights() -> list[Matrix]:
    return fusion_weights.matrix_weights([fusion_weights.plane_covariance(1)[0], fusion_weights.plane_covariance(2)[0]])


WITHIN = {f"sigma_{axis}{track}": (0.1, 50.0) for track in (1, 2) for axis in "xy"}
WITHIN |= {"rho_1": (-0.95, 0.95), "rho_2": (-0.95, 0.95)}


@given(point=strategies.arguments("fusion.matrix_weights.two", within=WITHIN), seed=st.integers(0, 10**6))
def test_no_other_unbiased_matrix_weights_have_a_smaller_trace(point: dict[str, float], seed: int) -> None:
    (first, one), (second, two) = fusion_weights.plane_covariance(1), fusion_weights.plane_covariance(2)
    values: dict[Symbol, float] = {symbol: point[symbol.name] for symbol in (*one, *two)}

    def numeric(matrix: Matrix) -> np.ndarray[tuple[int, int], np.dtype[np.float64]]:
        return np.array([float(evaluate(entry, values)) for entry in matrix]).reshape(2, 2)

    p, q = numeric(first), numeric(second)
    weight = numeric(matrix_weights()[0])

    def trace(w: np.ndarray[tuple[int, int], np.dtype[np.float64]]) -> float:
        rest = np.eye(2) - w
        return float(np.trace(w @ p @ w.T + rest @ q @ rest.T))

    move = np.random.default_rng(seed).normal(size=(2, 2))
    assert trace(weight) <= trace(weight + move) * (1 + 1e-12)
    assert trace(weight) == pytest.approx(np.trace(np.linalg.inv(np.linalg.inv(p) + np.linalg.inv(q))), rel=1e-9)


def test_matrix_weights_sum_to_the_unit_matrix() -> None:
    total = (matrix_weights()[0] + matrix_weights()[1]).applyfunc(sp.cancel)
    assert list(total) == [1, 0, 0, 1]


def test_a_degree_at_50_km_is_873_m_across_and_at_500_km_ten_times_as_much() -> None:
    [quantity] = (q for q in fusion_weights.quantities() if q.name == "fusion.cross_range_std")
    degree = float(np.pi / 180)
    across = [
        float(evaluate(quantity.expression[()], {fusion_weights.r: r, fusion_weights.sigma_beta: degree}))
        for r in (5e4, 5e5)
    ]
    assert across == pytest.approx([872.66, 8726.6], abs=0.05)
