"""Names that are not known, and those that may have been meant."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable
from difflib import SequenceMatcher

from radartrack.derive.formula.functions import NUMBER_OF_ARGUMENTS, SPELLINGS

CONSTANTS = {"pi": "pi", "e": "e", "E": "e", "inf": "inf"}
MEANT = 0.6  # similarity from which a name is offered as the one meant
_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")
SHOWN = 40  # characters of an unknown name that are repeated


def check_names(names: Iterable[str]) -> frozenset[str]:
    """The names a caller allows, unless one of them is a function's.

    Raises:
        ValueError: when a symbol would hide a function.
    """
    allowed = frozenset(names)
    if hidden := sorted(allowed & SPELLINGS.keys()):
        raise ValueError(f"names: {', '.join(hidden)} cannot name a symbol, it is a function")
    return allowed


def unusable(name: str) -> str:
    """Why a formula cannot use this as the name of a symbol; nothing where it can."""
    if name in SPELLINGS:
        return f"{name} is a function"
    return "" if _NAME.fullmatch(name) else "a name is a letter, and letters, digits and _ after it"


def constants(names: Collection[str]) -> dict[str, str]:
    """The constants that no symbol hides, by how they are written."""
    return {spelling: name for spelling, name in CONSTANTS.items() if spelling not in names}


def unknown_name(name: str, names: Collection[str]) -> str:
    """The refusal of a name."""
    return _unknown("name", name, {*names, *constants(names).values()} - {"inf"})  # which stands in limits alone


def unknown_function(name: str) -> str:
    """The refusal of a function."""
    return _unknown("function", name, NUMBER_OF_ARGUMENTS)


def _unknown(kind: str, name: str, allowed: Collection[str]) -> str:
    nearest = sorted(sorted(allowed), key=lambda other: -_similarity(name, other))
    meant = nearest and _similarity(name, nearest[0]) >= MEANT
    shown = name if len(name) <= SHOWN else f"{name[:SHOWN]}..."
    guess = f": did you mean {nearest[0]}?" if meant else "."
    return f"{shown} is not a {kind} here{guess} The {kind}s are {', '.join(nearest)}"


def _similarity(name: str, other: str) -> float:
    """From 0 to 1: one begins with the other, or has letters in common; capitals do not matter."""
    short, long = name[:SHOWN].lower(), other.lower()
    return 1.0 if len(short) > 1 and long.startswith(short) else SequenceMatcher(None, short, long).ratio()
