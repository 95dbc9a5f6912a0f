"""A limit of time as an option of several commands."""

from __future__ import annotations

import math

import typer


def seconds(value: float) -> float:
    """A number of seconds, which may be infinite.

    Raises:
        BadParameter: for one that is no number.
    """
    if math.isnan(value):
        raise typer.BadParameter("nan is no number of seconds; inf sets no limit")
    return value
