"""Derivations: what is measured, how the rest follows, and how it is written and checked. SymPy only.

What a model of one's own is made of can be imported from here; parts are loaded when they are first used.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from radartrack.derive.catalogue import find
    from radartrack.derive.checking.check import check
    from radartrack.derive.language.model import Model
    from radartrack.derive.language.quantity import Quantity
    from radartrack.derive.language.source import Source
    from radartrack.derive.language.variable import Variable, angle, correlation, deviation, length, speed
    from radartrack.derive.moments.conversion_quantities import quantities_of, word_to_order
    from radartrack.derive.moments.validity_of_linearisation import validity
    from radartrack.derive.reading.model_table import data_of, read_models

_HOMES = {
    "catalogue": ("find",),
    "checking.check": ("check",),
    "moments.conversion_quantities": ("quantities_of", "word_to_order"),
    "language.model": ("Model",),
    "moments.validity_of_linearisation": ("validity",),
    "reading.model_table": ("data_of", "read_models"),
    "language.quantity": ("Quantity",),
    "language.source": ("Source",),
    "language.variable": ("Variable", "angle", "correlation", "deviation", "length", "speed"),
}
_HOME_OF = {name: home for home, names in _HOMES.items() for name in names}

__all__ = [
    "Model",
    "Quantity",
    "Source",
    "Variable",
    "angle",
    "check",
    "correlation",
    "data_of",
    "deviation",
    "find",
    "length",
    "quantities_of",
    "read_models",
    "speed",
    "validity",
    "word_to_order",
]


def __getattr__(name: str) -> Any:
    if name not in _HOME_OF:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{_HOME_OF[name]}"), name)


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
