"""Statements in exact arithmetic agree with the formula; at the worst points they are off by no more than is proved."""

import numpy as np
import pytest

from radartrack.derive.catalogue import catalogue
from radartrack.verification.domain_points import sample
from radartrack.verification.error_in_ulp import errors
from radartrack.verification.rounding import certificates, worst_points
from radartrack.verification.rounding.certificates import proved_bounds, source_of
from radartrack.verification.rounding.worst_points import errors_at, replayed
from radartrack.verification.subject import generated

pytest.importorskip("flint")
KEPT = worst_points.kept()
CERTIFICATES = certificates.kept()
HEADROOM = 1.5  # other libraries round sines another way
SAMPLES = (
    "polar.covariance.truth", "observe.spherical.hessian", "finite_sample.degree1.gain", "motion.singer.transition",
    "motion.turn.known_rate.transition", "steady_state.alpha_beta_gamma.gain", "line.gradient",
    "finite_sample.degree1.range_rate.at_lag.covariance", "frames.geodetic_from_ecef.jacobian",
    "line.folded_std_factor",
)  # fmt: skip


@pytest.mark.parametrize("name", SAMPLES)
def test_errors_of_statements_are_errors_of_the_formula(name: str):
    quantity = catalogue()[name]
    points = sample(quantity, 12, seed=77)
    expected = errors(generated(quantity), quantity, points)
    np.testing.assert_allclose(errors_at(quantity, source_of(quantity), points), expected, atol=1e-6)


def test_worst_points_are_kept_of_all_functions():
    assert KEPT.keys() == catalogue().keys()


@pytest.mark.parametrize("module", sorted({name.partition(".")[0] for name in KEPT}))
def test_where_a_search_found_functions_worst_they_are_no_worse_than_is_proved_or_was_found(module: str):
    for name, row in KEPT.items():
        if name.partition(".")[0] == module:
            found = replayed(catalogue()[name], source_of(catalogue()[name]), row)
            bound = proved_bounds(CERTIFICATES[name]).get("double")
            assert found <= HEADROOM * row["ulp"] + 1, name
            assert bound is None or found <= max(bound, 0.5), name
