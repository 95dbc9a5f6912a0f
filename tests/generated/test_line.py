"""The generated functions of lines and fusion keep their digits where textbook forms lose them."""

import math

import numpy as np
import pytest

from radartrack.derive.language.quantity import Quantity
from radartrack.derive.tracks import deviation_from_line, line_over_time
from radartrack.derive.tracks import fusion_weights as derived_fusion
from radartrack.derive.tracks import least_squares_line as derived_line
from radartrack.generated import fusion, line
from radartrack.verification.domain_points import sample
from radartrack.verification.error_in_ulp import errors

MODULES = {"line": line, "fusion": fusion}
QUANTITIES = [
    quantity
    for family in (derived_line, line_over_time, deviation_from_line, derived_fusion)
    for quantity in family.quantities()
]


@pytest.mark.parametrize("quantity", QUANTITIES, ids=lambda quantity: quantity.name)
def test_the_error_is_at_most_sixteen_ulp(quantity: Quantity) -> None:
    function = getattr(MODULES[quantity.module], quantity.function)
    assert errors(function, quantity, sample(quantity, 200, seed=31)).max() <= 16


SHARES = np.array([1e-15, 1e-12, 1e-8, 1e-4, 0.3, 0.999])
EXCESSES = np.array([0.0, 1e-15, 1e-8, 1e-2, 1.0, 1e6])


@pytest.mark.parametrize("steep", [False, True])
@pytest.mark.parametrize("sign", [-1.0, 1.0])
def test_the_slope_keeps_its_digits_for_every_share_of_the_mixed_sum_and_every_excess(
    *, steep: bool, sign: float
) -> None:
    [quantity] = (q for q in derived_line.quantities() if q.name == "line.slope")
    share, excess = (grid.ravel() for grid in np.meshgrid(SHARES, EXCESSES))
    small, large = np.ones_like(excess), 1.0 + excess
    s_xx, s_yy = (small, large) if steep else (large, small)
    points = {"S_xx": s_xx, "S_xy": sign * share, "S_yy": s_yy}
    assert errors(line.slope, quantity, points).max() <= 4


def test_the_textbook_root_would_lose_them() -> None:
    s_xx, s_xy, s_yy = 1e6, 1e-3, 1.0
    textbook = (s_yy - s_xx + math.sqrt((s_xx - s_yy) ** 2 + 4 * s_xy**2)) / (2 * s_xy)
    assert textbook != pytest.approx(float(line.slope(S_xx=s_xx, S_xy=s_xy, S_yy=s_yy)), rel=1e-3)


def test_float32_stays_float32() -> None:
    single = np.array([2.0, 3.0], np.float32)
    assert line.slope(S_xx=single, S_xy=single, S_yy=single).dtype == np.float32
    assert fusion.weights_two(sigma_1=single, sigma_2=single).dtype == np.float32


def test_constants_take_no_arguments() -> None:
    assert line.folded_mean_factor() == pytest.approx(math.sqrt(2 / math.pi), rel=1e-15)
    assert line.folded_std_factor() == pytest.approx(math.sqrt(1 - 2 / math.pi), rel=1e-15)
