"""Letters that the field uses for whole arrays: p for a position, v for a velocity, P_1 for a covariance."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator

POSITION = ("p", "r")  # the likeliest first: r is the length of it as well
VELOCITY = ("v", "V")
SITE = ("s", "q", "b")
COVARIANCE = ("P", "R", "C", "K", "S", "Sigma")
_AXES = "xyz"


def array_letters(symbols: Collection[str], text: str, taken: Collection[str] = ()) -> dict[str, str]:
    """What letters of a formula stand for, if they stand for arrays of symbols, by their names.

    Args:
        symbols: those of the quantity.
        text: the formula, in any notation.
        taken: names that are defined.
    """
    return {name: array for name, array in _meant(symbols, text) if name not in taken}


def _meant(symbols: Collection[str], text: str) -> Iterator[tuple[str, str]]:
    kinds = ((POSITION, ""), (VELOCITY, "v"), (SITE, "receiver_"))
    for letters, prefix in kinds:
        coordinates = [f"{prefix}{axis}" for axis in _AXES if f"{prefix}{axis}" in symbols]
        letter = next((one for one in letters if re.search(rf"(?<![A-Za-z_]){one}(?![A-Za-z0-9_.])", text)), None)
        if letter and len(coordinates) > 1:
            yield letter, f"[{', '.join(coordinates)}]"
    for number in "12":
        deviations, rho = [f"sigma_{axis}{number}" for axis in "xy"], f"rho_{number}"
        if {*deviations, rho} <= {*symbols}:
            x, y = deviations
            for letter in COVARIANCE:
                if found := re.search(rf"(?<![A-Za-z_]){letter}\}}?(?P<lowered>_?)\{{?{number}(?!\d)", text):
                    yield f"{letter}{found['lowered']}{number}", f"[{x}^2, {rho}*{x}*{y}; {rho}*{x}*{y}, {y}^2]"
