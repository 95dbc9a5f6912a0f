"""A catalogue of a few quantities for the command, derived in its own process and measured at few points."""

from collections.abc import Mapping

import pytest

from radartrack._regeneration import accuracy, deriving, numpy_modules
from radartrack.derive import catalogue
from radartrack.derive.language.quantity import Quantity

KNOWING = (accuracy, deriving, numpy_modules)  # of the catalogue that the package comes with


def install(patch: pytest.MonkeyPatch, quantities: Mapping[str, Quantity], points: int) -> None:
    """The command takes the quantities for all that there are, and none of them for one that the package knows."""
    for module in KNOWING:
        patch.setattr(module, "catalogue", dict)
    install_known(patch, quantities, points)


def install_known(patch: pytest.MonkeyPatch, quantities: Mapping[str, Quantity], points: int) -> None:
    """The command takes the quantities for all that there are, and the package's records hold for them."""
    patch.setattr(catalogue, "catalogue", lambda: quantities)
    patch.setattr(accuracy, "POINTS", points)
