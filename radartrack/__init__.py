"""Radar tracking formulas that were derived, not copied: conversion, filters, fusion, simulation, verification.

Parts are loaded when they are first used, so that the command line can restore generated code that is damaged.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from radartrack import (
        consistency,
        convert,
        fixed_gain,
        frames,
        fusion,
        initiate,
        kalman,
        line,
        observe,
        ros,
        simulate,
        tables,
        validity,
    )
    from radartrack.finite_sample_filter import FiniteSampleFilter
    from radartrack.variance_table import VarianceTable

__all__ = [
    "FiniteSampleFilter",
    "VarianceTable",
    "consistency",
    "convert",
    "fixed_gain",
    "frames",
    "fusion",
    "initiate",
    "kalman",
    "line",
    "observe",
    "ros",
    "simulate",
    "tables",
    "validity",
]

_CLASSES = {"FiniteSampleFilter": "finite_sample_filter", "VarianceTable": "variance_table"}


def __getattr__(name: str) -> Any:
    if name not in __all__:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    if name in _CLASSES:
        return getattr(import_module(f"{__name__}.{_CLASSES[name]}"), name)
    return import_module(f"{__name__}.{name}")


def __dir__() -> list[str]:
    return __all__
