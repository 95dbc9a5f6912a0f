"""Balls of Arb (python-flint), which round outward, as their ends."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

Ball = Any
Rational = Any
ENDLESS = 1e9


def upper_float(ball: Ball) -> float:
    """Close to its upper end; infinite where it is no number."""
    value = float(ball.upper())
    return math.inf if math.isnan(value) else value


def nearest_float(ball: Ball) -> float:
    """Close to its middle; as good as endless where it is no finite number."""
    value = float(ball)
    return value if math.isfinite(value) else math.copysign(ENDLESS, -1.0 if math.isnan(value) else value)


def log_of(ball: Ball) -> float:
    """About the logarithm."""
    return nearest_float(ball.log()) if ball > 0 else -ENDLESS


def largest(balls: Sequence[Ball]) -> Ball:
    """One that no other is above."""
    return max(balls, key=upper_float)


def smallest(*bounds: Ball | None) -> Ball | None:
    """The smallest bound; none where no one is finite."""
    finite = [bound for bound in bounds if bound is not None and bound.is_finite()]
    return min(finite, key=upper_float, default=None)
