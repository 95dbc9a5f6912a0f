"""Tables of plots, of whatever library, converted to tables of Cartesian positions with their covariances.

    converted = rt.tables.convert(frame, "polar", columns={"r": "slant range", "range_std": 50}, units={"r": "km"})

`radartrack convert` does the same with Parquet files, larger than memory or many of them.
"""

from radartrack.tables.bad_rows import BadRows
from radartrack.tables.frame_conversion import convert

__all__ = ["BadRows", "convert"]


def __dir__() -> list[str]:
    return __all__
