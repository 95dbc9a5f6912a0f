"""The letters of a stranger's formula: which symbols of a quantity they may stand for."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence

MOST_ASSIGNMENTS = 5000  # of one set of symbols

_ANGLES = ("beta", "epsilon")
# What a letter means wherever it stands, the likeliest first; a letter without a meaning may be anything.
_MEANINGS: Mapping[str, tuple[str, ...]] = {
    **dict.fromkeys(("theta", "phi", "psi", "az", "azimuth", "azi", "bearing", "brg", "b", "th"), _ANGLES),
    **dict.fromkeys(("el", "elevation", "eps", "elev", "e"), ("epsilon", "beta", "x")),
    **dict.fromkeys(("R", "range", "rng", "d", "D", "dist"), ("r", "path", "distance")),
    **dict.fromkeys(("rr", "rdot", "doppler", "rrate", "range_rate", "dr"), ("rdot",)),
    **dict.fromkeys(("dt", "Delta_t", "Deltat", "delta_t", "tau", "h", "T_s", "Ts", "Delta"), ("T", "tau", "t")),
    **dict.fromkeys(("px", "east", "E", "xpos", "p_x"), ("x",)),
    **dict.fromkeys(("py", "north", "n", "N", "ypos", "p_y"), ("y", "n", "k")),
    **dict.fromkeys(("pz", "up", "U", "zpos", "p_z"), ("z",)),
    **dict.fromkeys(("v_x", "xdot", "dx"), ("vx",)),
    **dict.fromkeys(("v_y", "ydot", "dy"), ("vy",)),
    **dict.fromkeys(("v_z", "zdot", "dz"), ("vz",)),
    "rho": ("rho", "r"),
    "u": ("u", "z"),
    "N": ("k", "n", "y"),
}
_DEVIATION = re.compile(r"(?:sigma|std|sig|s)_?(?P<of>\w+)")


def assignments(letters: Sequence[str], symbols: Mapping[str, str]) -> Iterator[dict[str, str]]:
    """Ways to read letters as symbols, one to one, the likeliest first.

    Args:
        letters: of a formula.
        symbols: of a quantity, and of what kind each is.
    """
    choices = [_choices(letter, symbols) for letter in letters]
    order = sorted(range(len(letters)), key=lambda place: len(choices[place]))
    left = MOST_ASSIGNMENTS

    def chosen(depth: int, taken: dict[str, str]) -> Iterator[dict[str, str]]:
        nonlocal left
        if depth == len(order):
            left -= 1
            yield dict(taken)
            return
        letter = letters[order[depth]]
        for symbol in choices[order[depth]]:
            if symbol not in taken.values() and left > 0:
                yield from chosen(depth + 1, taken | {letter: symbol})

    yield from chosen(0, {})


def _choices(letter: str, symbols: Mapping[str, str]) -> list[str]:
    """The symbols that a letter may stand for: those that it means, or any where it means none."""
    if letter in symbols:
        return [letter, *(other for other in _MEANINGS.get(letter, ()) if other in symbols and other != letter)]
    if letter in _MEANINGS:
        return [symbol for symbol in _MEANINGS[letter] if symbol in symbols] or _of_like_kind(letter, symbols)
    if (deviation := _DEVIATION.fullmatch(letter)) and any(symbol.startswith("sigma_") for symbol in symbols):
        meant = _deviations(deviation["of"], symbols)
        return meant or [symbol for symbol in symbols if symbol.startswith("sigma_")]
    return list(symbols)


def _of_like_kind(letter: str, symbols: Mapping[str, str]) -> list[str]:
    """An angle's letter is an angle; any other may be what is no angle."""
    is_angle = _MEANINGS[letter] == _ANGLES and len(letter) > 1
    return [symbol for symbol, kind in symbols.items() if (kind == "angle") == is_angle]


def _deviations(of: str, symbols: Mapping[str, str]) -> list[str]:
    """The deviations of what a letter means: sigma_theta is sigma_beta, s_rho is sigma_r."""
    names = (of, *_MEANINGS.get(of, ()), *_MEANINGS.get(of.lower(), ()))
    return [f"sigma_{name}" for name in dict.fromkeys(names) if f"sigma_{name}" in symbols]
