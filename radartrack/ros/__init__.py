"""Plots from and to the fields of ROS's `radar_msgs/RadarReturn`; nothing of ROS is needed."""

from radartrack.ros.radar_return import RadarReturn, plots_of, returns_of

__all__ = ["RadarReturn", "plots_of", "returns_of"]


def __dir__() -> list[str]:
    return __all__
