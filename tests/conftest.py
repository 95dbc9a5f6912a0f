"""Chooses how hard Hypothesis searches: RADARTRACK_HYPOTHESIS=dev, ci or thorough."""

import os
from collections.abc import Mapping
from datetime import timedelta

import pytest
from hypothesis import HealthCheck, settings

PROFILES = {
    "dev": settings(max_examples=50, deadline=timedelta(seconds=5)),
    "ci": settings(
        max_examples=100,
        deadline=None,
        derandomize=True,
        print_blob=True,
        suppress_health_check=[HealthCheck.too_slow],  # a shared machine is slow by accident
    ),
    "thorough": settings(
        max_examples=2000, deadline=None, print_blob=True, suppress_health_check=[HealthCheck.too_slow]
    ),
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


def pytest_report_header() -> str:
    return f"hypothesis profile: {settings.get_current_profile_name()}, {settings().max_examples} examples"
