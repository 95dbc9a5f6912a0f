"""What sums are condensed to, and how often an error goes into two variances, against their values at points."""

import math
from random import Random

import pytest

from radartrack.verification.rounding.checker.sums import shares
from radartrack.verification.rounding.checker.sums.shares import MOST_PAIRS, condensed, paired
from tests.drawn_sums import drawn_point, drawn_sum, size, wide_sizes

flint = pytest.importorskip("flint")


def test_a_long_sum_is_condensed_to_few_terms_that_are_as_much():
    random, shorter = Random(7), 0
    for _ in range(40):
        sizes, ends = wide_sizes(flint, random)
        sum_ = drawn_sum(sizes, ends, random, 100)
        before = len(sizes.atoms)
        found = condensed(sizes, sum_)
        if found is None:
            continue
        shorter += len(found) < len(sum_) / 2
        for _ in range(20):
            point = drawn_point(sizes, ends, None, random)
            exact = size(sum_, sizes, point, before, 0)
            low, high = (size(found, sizes, point, before, end) for end in (0, 1))
            assert low * (1 - 1e-12) <= exact <= high * (1 + 1e-12)
    assert shorter > 20


@pytest.mark.parametrize("most", [MOST_PAIRS, 500])
def test_no_error_is_above_its_share_of_two_variances(most: int, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(shares, "MOST_PAIRS", most)
    random, found = Random(12), 0
    for _ in range(40):
        sizes, ends = wide_sizes(flint, random)
        first, second, error = (drawn_sum(sizes, ends, random, n) for n in (12, 9, 5))
        share = paired(sizes, error, first, second)
        if share is None:
            continue
        found += 1
        for _ in range(20):
            point = drawn_point(sizes, ends, None, random)
            a, b, e = (size(one, sizes, point, len(sizes.atoms), 0) for one in (first, second, error))
            assert e <= float(share) * math.sqrt(a * b) * (1 + 1e-12)
    assert found > 10
