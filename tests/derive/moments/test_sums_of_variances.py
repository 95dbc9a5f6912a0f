"""What errors of covariances are measured against where a variance vanishes inside of the domain."""

import math

import numpy as np

from radartrack.derive.catalogue import catalogue
from radartrack.derive.moments.conversion_quantities import quantities_of
from radartrack.derive.sensors import bistatic, ruv
from radartrack.verification.error_in_ulp import Yardstick


def test_the_scale_is_the_trace_of_the_linear_covariance_also_where_a_variance_vanishes():
    quantity = catalogue()["bistatic.covariance.linear"]
    level = math.acos(2e4 / 1e5)
    points = {"path": 1e5, "beta": [0.3, level], "baseline": 2e4, "sigma_path": 1e-3, "sigma_beta": 0.1, "rho": 0.0}
    given = {name: np.broadcast_to(np.array(value), (2,)) for name, value in points.items()}
    measured = Yardstick(quantity, given)
    traces = [float(entries[0] + entries[3]) for entries in measured.exact]
    np.testing.assert_allclose(measured.scales, np.repeat(np.array(traces)[:, np.newaxis], 4, axis=1), rtol=1e-12)
    assert float(measured.exact[1][3]) < 1e-9 * traces[1]


def test_only_covariances_of_a_model_that_says_so_have_a_scale_of_their_own():
    stated = {quantity.name for quantity in quantities_of(bistatic.MODEL) if quantity.scale is not None}
    assert stated == {quantity.name for quantity in quantities_of(bistatic.MODEL) if quantity.is_covariance}
    assert not any(quantity.scale for quantity in quantities_of(ruv.MODEL))
