"""The languages of code that is read; who only names them need not load what reads it."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

# What each is called, and where its arrays begin.
SPOKEN: Mapping[str, tuple[str, int]] = MappingProxyType(
    {"python": ("Python", 0), "c": ("C", 0), "cpp": ("C++", 0), "matlab": ("MATLAB", 1)}
)
LANGUAGES = tuple(SPOKEN)
