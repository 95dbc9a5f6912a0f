"""One small reproduction of each paper, for all tests of this folder."""

from collections.abc import Iterator

import pytest

from radartrack.reproduction import gao, gorshkov, prosov
from radartrack.reproduction.results import Reproduction


@pytest.fixture(scope="session")
def prosov_found() -> Iterator[Reproduction]:
    """With a small map."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(prosov, "PERIODS", (10.0,))
        patch.setattr(prosov, "MAPPED_CYCLES", 10)
        yield prosov.reproduce(trials=400, mapped_trials=50)


@pytest.fixture(scope="session")
def gao_found() -> Reproduction:
    return gao.reproduce(runs=100, tracks=100)


@pytest.fixture(scope="session")
def gorshkov_found() -> Reproduction:
    return gorshkov.reproduce(trials=2000)
