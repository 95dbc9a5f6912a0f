"""Chooses how hard Hypothesis searches: RADARTRACK_HYPOTHESIS=dev, ci or thorough."""

import gc
import os
from collections.abc import Mapping

import pytest
from hypothesis import HealthCheck, settings

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before NumPy is loaded; a worker a core leaves none for threads

# A shared machine is slow by accident.
ON_ANY_MACHINE = settings(deadline=None, suppress_health_check=[HealthCheck.too_slow])
PROFILES = {
    "dev": settings(ON_ANY_MACHINE, max_examples=50),
    "ci": settings(ON_ANY_MACHINE, max_examples=100, derandomize=True, print_blob=True),
    "thorough": settings(ON_ANY_MACHINE, max_examples=2000, print_blob=True),
}


def profile_name(environment: Mapping[str, str]) -> str:
    """The profile asked for; without a wish, `ci` where CI is set, else `dev`."""
    name = environment.get("RADARTRACK_HYPOTHESIS") or ("ci" if environment.get("CI") else "dev")
    if name not in PROFILES:
        raise pytest.UsageError(f"RADARTRACK_HYPOTHESIS is {name!r}; allowed: {', '.join(PROFILES)}")
    return name


def pytest_configure() -> None:
    for name, profile in PROFILES.items():
        settings.register_profile(name, parent=profile)
    settings.load_profile(profile_name(os.environ))


def pytest_collection_finish() -> None:
    """What was collected is there to the end; the search for garbage need not go through it again and again."""
    gc.freeze()


@pytest.fixture(scope="session", autouse=True)
def _shared_derivations(tmp_path_factory: pytest.TempPathFactory) -> None:
    """Workers share a folder beside their own ones."""
    if "PYTEST_XDIST_WORKER" in os.environ:
        from tests.shared_derivations import share  # noqa: PLC0415 - it loads SymPy

        share(tmp_path_factory.getbasetemp().parent / "derivations")


def pytest_report_header() -> str:
    return f"hypothesis profile: {profile_name(os.environ)}, {settings().max_examples} examples"
