"""The quantities of every measurement model that is shipped: from plots to Cartesian coordinates."""

from __future__ import annotations

from radartrack.derive.language.quantity import Quantity
from radartrack.derive.moments.conversion_quantities import quantities_of
from radartrack.derive.sensors import models


def quantities() -> list[Quantity]:
    """Those of all models, in alphabetical order of the models."""
    return [quantity for model in models().values() for quantity in quantities_of(model)]
