"""Parts for Stone Soup: measurement models, an initiator, a feeder and updaters that know the bias of radar plots.

They are used where Stone Soup's own stand, and take its models and detections as they are. This package is also
`stonesoup.plugins.radartrack`. It needs the extra `stonesoup`.
"""

from radartrack.stone_soup.debiasing_feeder import DebiasedClutter, DebiasedTrueDetection, DebiasingFeeder
from radartrack.stone_soup.exact_models import (
    ExactBearing2D,
    ExactBearingRange,
    ExactBearingRangeRate,
    ExactBearingRangeRate2D,
    ExactElevationBearing,
    ExactElevationBearingRange,
    ExactElevationBearingRangeRate,
)
from radartrack.stone_soup.one_plot_initiator import OnePlotInitiator
from radartrack.stone_soup.plot_conversion import PositionAndRangeRate
from radartrack.stone_soup.updaters import DecorrelatedUpdater, SecondOrderUpdater

__all__ = [
    "DebiasedClutter",
    "DebiasedTrueDetection",
    "DebiasingFeeder",
    "DecorrelatedUpdater",
    "ExactBearing2D",
    "ExactBearingRange",
    "ExactBearingRangeRate",
    "ExactBearingRangeRate2D",
    "ExactElevationBearing",
    "ExactElevationBearingRange",
    "ExactElevationBearingRangeRate",
    "OnePlotInitiator",
    "PositionAndRangeRate",
    "SecondOrderUpdater",
]


def __dir__() -> list[str]:
    return __all__
