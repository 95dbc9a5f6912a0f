"""Filters of a position and its derivatives whose gain is the same at each scan: α-β, α-β-γ, fading memory.

tracker = rt.fixed_gain.alpha_beta(period=4.0, range_std=50.0, acceleration_std=0.8)
states = tracker.run(measured, start)
"""

from radartrack.fixed_gain.fixed_gain_filter import FixedGainFilter
from radartrack.fixed_gain.known_gains import alpha_beta, alpha_beta_gamma, fading_memory, tracking_index

__all__ = ["FixedGainFilter", "alpha_beta", "alpha_beta_gamma", "fading_memory", "tracking_index"]


def __dir__() -> list[str]:
    return __all__
