"""The Hypothesis profile that was asked for is the one that runs."""

import os
import subprocess
import sys
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given
from hypothesis import strategies as st

from tests.conftest import PROFILES, profile_name

ROOT = Path(__file__).parents[1]
EXAMPLES = {"dev": 50, "ci": 100, "thorough": 2000}


def collect(**wishes: str) -> subprocess.CompletedProcess[str]:
    """Start pytest on this file in an environment of these wishes only, without running its tests."""
    environment = {k: v for k, v in os.environ.items() if k not in {"CI", "RADARTRACK_HYPOTHESIS"}}
    command = [sys.executable, "-m", "pytest", "--collect-only", "-p", "no:cacheprovider", __file__]
    return subprocess.run(command, env=environment | wishes, cwd=ROOT, capture_output=True, text=True, check=False)


@pytest.mark.parametrize(
    ("wishes", "profile"),
    [
        ({}, "dev"),
        ({"RADARTRACK_HYPOTHESIS": ""}, "dev"),
        ({"CI": "true"}, "ci"),
        ({"RADARTRACK_HYPOTHESIS": "thorough"}, "thorough"),
        ({"RADARTRACK_HYPOTHESIS": "dev", "CI": "true"}, "dev"),
    ],
)
def test_the_environment_chooses_the_profile(wishes: dict[str, str], profile: str) -> None:
    assert profile_name(wishes) == profile
    assert PROFILES[profile].max_examples == EXAMPLES[profile]


def test_the_profile_that_was_chosen_is_loaded_and_told() -> None:
    result = collect(RADARTRACK_HYPOTHESIS="thorough", CI="true")
    assert result.returncode == 0, result.stdout + result.stderr
    assert "hypothesis profile: thorough, 2000 examples" in result.stdout


@pytest.mark.parametrize("profile", PROFILES)
def test_no_profile_measures_time(profile: str) -> None:
    assert PROFILES[profile].deadline is None
    assert HealthCheck.too_slow in PROFILES[profile].suppress_health_check


def test_an_unknown_profile_is_refused_by_name() -> None:
    result = collect(RADARTRACK_HYPOTHESIS="thorogh")
    assert result.returncode == pytest.ExitCode.USAGE_ERROR
    assert "'thorogh'; allowed: dev, ci, thorough" in result.stderr


def test_the_loaded_profile_governs_how_many_examples_run() -> None:
    runs = []

    @given(st.integers())
    def property_under_test(value: int) -> None:
        runs.append(value)

    property_under_test()
    assert len(runs) == EXAMPLES[profile_name(os.environ)]
