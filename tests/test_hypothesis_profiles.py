"""The Hypothesis profile that was asked for is the one that runs."""

import os
import subprocess
import sys
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

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
        ({"CI": "true"}, "ci"),
        ({"RADARTRACK_HYPOTHESIS": "thorough"}, "thorough"),
        ({"RADARTRACK_HYPOTHESIS": "dev", "CI": "true"}, "dev"),
    ],
)
def test_the_environment_chooses_the_profile(wishes: dict[str, str], profile: str) -> None:
    result = collect(**wishes)
    assert result.returncode == 0, result.stdout + result.stderr
    assert f"hypothesis profile: {profile}, {EXAMPLES[profile]} examples" in result.stdout


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
    assert len(runs) == EXAMPLES[settings.get_current_profile_name()]
