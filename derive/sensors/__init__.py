"""Sensors: measurement models, one a file that defines `MODEL`, and the maps from a state to what a radar measures."""

from __future__ import annotations

from functools import cache
from importlib import import_module
from pkgutil import iter_modules

from radartrack.derive.language.model import Model


@cache
def models() -> dict[str, Model]:
    """All models by name, in alphabetical order."""
    modules = (import_module(f"{__name__}.{found.name}") for found in iter_modules(__path__))
    found = (module.MODEL for module in modules if hasattr(module, "MODEL"))
    return {model.name: model for model in sorted(found, key=lambda model: model.name)}
