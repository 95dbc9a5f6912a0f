"""What the letters of the field usually mean: `theta` is an azimuth or an elevation, `s_r` the deviation of a range.

A strong word is read as what it means wherever the quantity has such a symbol. A weak one, mostly a single letter that
has many uses, is only tried first as that.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from enum import Enum
from functools import lru_cache

from radartrack.derive.language.variable import Variable


class Role(Enum):
    """What a name says about a measured quantity."""

    VALUE = "value"
    DEVIATION = "deviation"
    VARIANCE = "variance"
    CORRELATION = "correlation"


@dataclass(frozen=True)
class Meaning:
    """What a name means: the role it plays, of what, and whether of a prediction.

    Attributes:
        role: the role.
        of: a word of `_STRONG`; empty where the name does not say.
        predicted: whether it is one of a prediction.
    """

    role: Role
    of: str
    predicted: bool = False


@dataclass(frozen=True)
class Meanings:
    """All that a name may mean.

    Attributes:
        strong: what it means where there is such a symbol.
        weak: what it is tried as first.
        role: the role that its spelling says, whatever it is of: `sigma_1` is a deviation.
    """

    strong: frozenset[Meaning]
    weak: frozenset[Meaning]
    role: Role | None


_STRONG = {
    "range": "r R rho rng range dist distance rg slant_range slantrange rtrue varrho",
    "azimuth": "beta az azi azimuth theta th phi ph bearing brg bearing_angle vartheta varphi",
    "elevation": "epsilon eps el elev elevation varepsilon theta th phi ph vartheta varphi",
    "range_rate": "rdot rhodot range_rate rangerate rrate rr doppler rng_rate v_r vr dotr rho_dot r_dot Rdot",
    "u": "u",
    "v": "v",
    "x": "x px pos_x x_pos east",
    "y": "y py pos_y y_pos north",
    "z": "z pz pos_z z_pos up altitude",
    "vx": "vx v_x xdot x_dot dotx vel_x velx Vx",
    "vy": "vy v_y ydot y_dot doty vel_y vely Vy",
    "vz": "vz v_z zdot z_dot dotz vel_z velz Vz",
    "period": "T dt Dt DT Ts T_s tau delta_t deltat Delta_t Deltat period scan_period dT Delta_T DeltaT",
    "intensity": "q q_c qc psd q_tilde qtilde",
    "count": "k",
    "index": "j",
}
_WEAK = {
    "range": "d D a",
    "azimuth": "b A a alpha psi az0 B",
    "elevation": "e E el0 alpha gamma psi eta",
    "range_rate": "v d s rd",
    "x": "e E X",
    "y": "n N Y",
    "z": "u U h H Z",
    "vx": "dx xd u",
    "vy": "dy yd v",
    "vz": "dz zd w",
    "period": "t h delta Delta",
    "intensity": "Q S S_w N_0 Sw",
    "count": "n N m",
    "index": "i l",
}
_DECORATION = re.compile(r"_?(?:hat|tilde|bar|meas|measured|prime|true|0|m|k)$")
_DEVIATION = re.compile(
    r"(?:sigma|sig|stdev|std|sd|s)_?(?P<of>\w*)$|(?P<before>\w+?)_(?:sigma|std|stdev|sd|dev)$|(?P<joined>\w+)std$"
)
_VARIANCE = re.compile(r"(?:var|Var|sigma2|s2|V|D)_(?P<of>\w+)$|(?P<before>\w+?)_(?:var|variance)$|var(?P<joined>\w+)$")
_CORRELATION = re.compile(r"(?:rho|corr|correlation)_(?P<of>\w+)$|corr$|correlation$")
_SPELT_OUT = re.compile(r"sigma|(?:sig|stdev|std|sd|s|var|Var|s2|V|D)_|\w+_(?:sigma|stdev|std|sd|dev|var|variance)$")
_PREDICTED = re.compile(r"pred(?:icted)?_(?P<after>\w+)$|(?P<before>\w+)_(?:p|pred|predicted)$")


def _by_word(table: dict[str, str]) -> dict[str, frozenset[str]]:
    words = {word for line in table.values() for word in line.split()}
    return {word: frozenset(of for of, line in table.items() if word in line.split()) for word in words}


_STRONG_WORDS, _WEAK_WORDS = _by_word(_STRONG), _by_word(_WEAK)


@lru_cache(maxsize=4096)
def meanings(name: str) -> Meanings:
    """What a name may mean, by its spelling."""
    plain = _without_prediction(name)
    predicted = plain != name
    for role, pattern in ((Role.VARIANCE, _VARIANCE), (Role.DEVIATION, _DEVIATION), (Role.CORRELATION, _CORRELATION)):
        if (found := pattern.match(plain)) and (plain not in _STRONG_WORDS):
            of = next((part for part in found.groupdict().values() if part), "")
            words = _words(of, _STRONG_WORDS) | _words(of, _WEAK_WORDS)
            if role is Role.CORRELATION:
                return Meanings(frozenset(), frozenset(), role)
            if of and not words and not _SPELT_OUT.match(plain):
                continue  # a word that only begins so
            meant = _as_meanings(role, words, predicted=predicted)
            return Meanings(meant, frozenset(), role)
    strong = _as_meanings(Role.VALUE, _words(plain, _STRONG_WORDS), predicted=predicted)
    weak = _as_meanings(Role.VALUE, _words(plain, _WEAK_WORDS), predicted=predicted)
    return Meanings(strong, weak, None)


@lru_cache(maxsize=4096)
def meaning_of(symbol: Variable) -> Meaning:
    """What a symbol of a quantity means."""
    name, predicted = symbol.name.removeprefix("predicted_"), symbol.name.startswith("predicted_")
    if symbol.is_correlation:
        return Meaning(Role.CORRELATION, "", predicted)
    role = Role.DEVIATION if name.startswith("sigma") else Role.VALUE
    base = name.removeprefix("sigma_") if role is Role.DEVIATION else name
    return Meaning(role, _OWN.get(base, ""), predicted)


def means(name: str, symbols: Iterable[Variable], *, weak: bool = False) -> list[tuple[Variable, int]]:
    """The symbols that a name means, each with the power to which it is meant: 2 for a variance."""
    said = meanings(name)
    return list(_meant(said.weak if weak else said.strong, symbols))


def _meant(said: frozenset[Meaning], symbols: Iterable[Variable]) -> Iterator[tuple[Variable, int]]:
    for symbol in symbols:
        own = meaning_of(symbol)
        if not own.of:
            continue
        if own in said:
            yield symbol, 1
        elif own.role is Role.DEVIATION and Meaning(Role.VARIANCE, own.of, own.predicted) in said:
            yield symbol, 2


def _without_prediction(name: str) -> str:
    found = _PREDICTED.match(name)
    return (found["after"] or found["before"]) if found and name not in _STRONG_WORDS else name


def _words(word: str, table: dict[str, frozenset[str]]) -> frozenset[str]:
    """What a word means, with or without what decorates it."""
    if word in table:
        return table[word]
    bare = _DECORATION.sub("", word)
    return (
        table.get(bare, frozenset()) or table.get(bare.lower(), frozenset())
        if len(bare) > 1 or bare in table
        else (frozenset())
    )


def _as_meanings(role: Role, words: Iterable[str], *, predicted: bool) -> frozenset[Meaning]:
    return frozenset(Meaning(role, of, predicted) for of in words)


# The names that the catalogue itself uses.
_OWN = {
    "r": "range",
    "beta": "azimuth",
    "epsilon": "elevation",
    "rdot": "range_rate",
    "T": "period",
    "q": "intensity",
    "k": "count",
    "j": "index",
    **{name: name for name in ("u", "v", "x", "y", "z", "vx", "vy", "vz")},
}
