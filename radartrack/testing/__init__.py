"""Is a function of one's own the derived quantity? Diagnoses of functions, and strategies for property tests."""

from __future__ import annotations

from radartrack.testing.diagnosing import CannotDiagnose, assert_derived, diagnose
from radartrack.testing.diagnosis import Diagnosis, LostDigits, Slip, Worst

__all__ = ["CannotDiagnose", "Diagnosis", "LostDigits", "Slip", "Worst", "assert_derived", "diagnose"]


def __dir__() -> list[str]:
    return __all__
