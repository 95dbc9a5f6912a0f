"""Symbols that several subjects share, so that they are one symbol in all of them."""

from __future__ import annotations

from radartrack.derive.language.variable import Variable
from radartrack.derive.units import SECOND

T = Variable("T", "time from scan to scan", SECOND, 1e-3, 1e3)
