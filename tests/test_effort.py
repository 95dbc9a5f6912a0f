"""The limits of processor time notice what takes longer, and grow on a slow machine."""

import pytest

from tests import effort
from tests.effort import at_most


def test_more_than_the_limit_is_noticed() -> None:
    with pytest.raises(AssertionError), at_most(0.0):
        sum(range(100_000))


def test_a_limit_grows_with_the_slowness_of_the_machine(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(effort, "slowness", lambda: 1e12)
    with at_most(1e-12):
        sum(range(100_000))
