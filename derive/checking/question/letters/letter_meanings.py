"""What the letters of the field usually mean: `theta` is an azimuth or an elevation, `s_r` the deviation of a range.

A strong word is read as what it means wherever the quantity has such a symbol. A weak one, mostly a single letter that
has many uses, is only tried first as that.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from difflib import get_close_matches
from enum import Enum
from functools import lru_cache
from typing import Protocol, TypeVar

from radartrack.derive.formula.latex_names import GREEK


class Known(Protocol):
    """A symbol of a quantity, as far as letters are concerned."""

    @property
    def name(self) -> str:
        """As it is called here."""
        ...

    @property
    def meaning(self) -> str:
        """In the field's words."""
        ...

    @property
    def unit(self) -> object:
        """Its unit, which is printed as text."""
        ...

    @property
    def is_correlation(self) -> bool:
        """Whether it is the correlation of two errors."""
        ...

    def __hash__(self) -> int:
        """What is known of it is kept."""
        ...


Symbol = TypeVar("Symbol", bound=Known)


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
    "azimuth": "beta az azi azimuth theta th phi ph bearing brg brng bearing_angle vartheta varphi",
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
    "period": "T dt Dt DT Ts T_s tau delta_t deltat Delta_t Deltat period scan_period dT Delta_T DeltaT "
    "Te T_e time_step timestep time_interval sample_time sampling_time deltaTime delta_time",
    "intensity": "q q_c qc psd q_tilde qtilde spectral_density spectral_intensity noise_density noise_intensity "
    "noise_diff_coeff noise_diff",
    "count": "k",
    "index": "j",
    "turn_rate": "omega Omega turn_rate turnrate yaw_rate yawrate yawd yaw_dot yawdot psi_dot psidot psid dpsi "
    "heading_rate theta_dot thetadot course_rate",
    "heading": "heading course hdg yaw",
    "speed": "speed",
    "path": "path bistatic_range total_range",
    "baseline": "baseline",
    "rate": "alpha",
    "latitude": "latitude lat phi varphi",
    "longitude": "longitude lon lng long lambda lam",
    "height": "height h H alt altitude hgt",
    "semi_major_axis": "semi_major_axis a a_e R_a",
    "flattening": "flattening f",
    "tracking_index": "index tracking_index Lambda lambda lam",
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
    "intensity": "Q S S_w N_0 Sw Phi Phi_s",
    "count": "n N m",
    "index": "i l",
    "turn_rate": "w W",
    "heading": "psi theta phi",
    "speed": "s v V",
    "path": "r R rho rng range",
    "baseline": "L B b",
}
# What a name says of how it was got, or in which unit: target_range, az_rad and rngTrue are ranges and azimuths.
_LITTLE = (
    "angle value val meas measured measurement true truth target tgt radar sensor obs observed est estimated raw rad "
    "radians deg degrees meters metres polar update sampling sample"
)
_SAYS_LITTLE = frozenset(_LITTLE.split())
_INDICES = frozenset("ijklmnt")  # of a scan, a plot or what is measured
_CAMEL = re.compile(r"(?<=[a-z0-9])(?=[A-Z])")
# Words of the meanings of symbols that tell none apart from another.
_COMMON = (
    "along axis axes between both clockwise coordinate correlation counter deviation direction each error errors from "
    "length mean measurement number other over part point points prediction predictions square standard sum than that "
    "the third time two unit variable variance weight weighted where which with"
)
_COMMON_WORDS = frozenset(_COMMON.split())
_TOLD_APART = 3  # letters: of so many a word is one, and may begin a longer one
_DOTTED = re.compile(r"(?:d?dot|hat|tilde|bar|prime|\d)+$")
_GREEK = frozenset(name.lower() for name in GREEK.values()) | frozenset({"lam", "sig", "eps", "omg", "gam"})
_DECORATION = re.compile(r"_?(?:hat|tilde|bar|meas|measured|prime|true|0|m|k)$")
_DEVIATION = re.compile(
    r"(?:sigma|sig|stdev|std|sd|s)_?(?P<of>\w*)$|(?P<before>\w+?)_(?:sigma|std|stdev|sd|dev)$|(?P<joined>\w+)std$"
)
_VARIANCE = re.compile(
    r"[vV]ar(?:iance)?$"
    r"|(?:var|Var|sigma2|s2|V|D)_(?P<of>\w+)$|(?P<before>\w+?)_(?:var|variance)$|var(?P<joined>\w+)$"
)
_CORRELATION = re.compile(r"(?:rho|corr|correlation)_(?P<of>\w+)$|corr$|correlation$")
_SPELT_OUT = re.compile(r"sigma|(?:sig|stdev|std|sd|s|var|Var|s2|V|D)_|\w+_(?:sigma|stdev|std|sd|dev|var|variance)$")
_PREDICTED = re.compile(r"pred(?:icted)?_(?P<after>\w+)$|(?P<before>\w+)_(?:p|pred|predicted)$")


def _by_word(table: dict[str, str]) -> dict[str, frozenset[str]]:
    words = {word for line in table.values() for word in line.split()}
    return {word: frozenset(of for of, line in table.items() if word in line.split()) for word in words}


_STRONG_WORDS, _WEAK_WORDS = _by_word(_STRONG), _by_word(_WEAK)

_NEAR = 0.7  # similarity from which a word is perhaps another one misspelt


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
                if of in _INDICES or of in _SAYS_LITTLE:
                    continue  # rho_k is a range at scan k
                return Meanings(frozenset(), frozenset(), role)
            if of and not words and not _SPELT_OUT.match(plain):
                continue  # a word that only begins so
            meant = _as_meanings(role, words, predicted=predicted)
            return Meanings(meant, frozenset(), role)
    strong = _as_meanings(Role.VALUE, _words(plain, _STRONG_WORDS), predicted=predicted)
    weak = _as_meanings(Role.VALUE, _words(plain, _WEAK_WORDS), predicted=predicted)
    return Meanings(strong, weak, None)


@lru_cache(maxsize=4096)
def meaning_of(symbol: Known) -> Meaning:
    """What a symbol of a quantity means."""
    name, predicted = symbol.name.removeprefix("predicted_"), symbol.name.startswith("predicted_")
    if symbol.is_correlation:
        return Meaning(Role.CORRELATION, "", predicted)
    role = Role.DEVIATION if name.startswith("sigma") else Role.VALUE
    base = name.removeprefix("sigma_") if role is Role.DEVIATION else name
    return Meaning(role, _OWN.get(base, ""), predicted)


def is_variance(symbol: Known) -> bool:
    """Whether a symbol is the square of a deviation: a variance, the covariance of a coordinate, an intensity."""
    return symbol.meaning.partition(" ")[0] in {"variance", "covariance", "intensity"}


def means(name: str, symbols: Iterable[Symbol], *, weak: bool = False) -> list[tuple[Symbol, int]]:
    """The symbols that a name means, each with the power to which it is meant: 2 for a variance."""
    said, known = meanings(name), list(symbols)
    if weak:
        return list(_meant(said.weak, known))
    return (
        list(_by_subscript(name, known))
        or list(_spelled(name, known))
        or list(_meant(said.strong, known))
        or list(_in_words(name, known))
    )


def is_known_word(name: str) -> bool:
    """Whether a name of several letters is spelled exactly as a word of known meaning."""
    return len(name) > 1 and name in _STRONG_WORDS


def is_angle_word(name: str) -> bool:
    """Whether a name means an angle."""
    return any(one.of in {"azimuth", "elevation", "heading"} for one in meanings(name).strong)


def says_degrees(name: str) -> bool:
    """Whether a name says that it is in degrees."""
    return bool({"deg", "degrees"} & {part.lower() for part in _CAMEL.sub("_", name).split("_")})


def is_word(name: str) -> bool:
    """Whether a name is a word, not a letter with what stands above and below it: of a word it is known what it means.

    So is what a deviation is said to be of: sigma_bta is none of a letter.
    """
    role = meanings(name).role
    plain = _of(name) if role in {Role.DEVIATION, Role.VARIANCE} else name
    bare = _DOTTED.sub("", _CAMEL.sub("_", plain).strip("_").split("_")[0])
    while (shorter := _DOTTED.sub("", bare)) != bare:
        bare = shorter
    letter = bare.lower()
    return len(letter) >= _TOLD_APART and letter not in _GREEK and letter.removeprefix("d").lower() not in _GREEK


def alike(name: str, symbols: Iterable[Symbol]) -> Symbol | None:
    """The symbol that was perhaps meant by a name that means none, if it is spelled nearly as one that does."""
    own = {symbol.name: symbol for symbol in symbols}
    words = own | {word: symbol for word in _STRONG_WORDS for symbol, power in means(word, own.values()) if power == 1}
    words |= {f"sigma_{word}": symbol for word in _STRONG_WORDS for symbol, _ in means(f"sigma_{word}", own.values())}
    near = get_close_matches(name, [word for word in words if len(word) >= _TOLD_APART], 1, _NEAR)
    return words[near[0]] if near else None


def _in_words(name: str, symbols: Iterable[Symbol]) -> Iterator[tuple[Symbol, int]]:
    """The symbols that are described by the word that a name is, or that it begins with: accel, lat, height."""
    role = meanings(name).role or Role.VALUE
    word = (_of(name) if role is not Role.VALUE else name).lower()
    if role is Role.CORRELATION:
        yield from ((symbol, 1) for symbol in symbols if symbol.is_correlation)
        return
    if len(word) < _TOLD_APART:
        return
    for symbol in symbols:
        said = set(re.findall(r"[a-z]+", symbol.meaning.lower())) - _COMMON_WORDS
        plays = Role.DEVIATION if symbol.name.startswith("sigma") else Role.VALUE
        if plays is (Role.DEVIATION if role is Role.VARIANCE else role) and any(one.startswith(word) for one in said):
            yield symbol, 2 if role is Role.VARIANCE else 1


def _by_subscript(name: str, symbols: Iterable[Symbol]) -> Iterator[tuple[Symbol, int]]:
    """The deviation of just what a deviation or a variance is said to be of: s_w is sigma_w, whatever else w may be.

    Numbers bind less: papers and code count from one or from zero.
    """
    for pattern, power in ((_VARIANCE, 2), (_DEVIATION, 1)):
        if (found := pattern.match(name)) and (of := next(filter(None, found.groupdict().values()), "")):
            yield from ((symbol, power) for symbol in symbols if symbol.name == f"sigma_{of}" and not of.isdigit())
            return


def _spelled(name: str, symbols: Iterable[Symbol]) -> Iterator[tuple[Symbol, int]]:
    """The symbol of the same name but for its underscores: Sxx is S_xx. Numbers bind less."""
    letters = name.replace("_", "")
    yield from (
        (symbol, 1)
        for symbol in symbols
        if symbol.name.replace("_", "") == letters != symbol.name and not letters[-1].isdigit()
    )


def _of(name: str) -> str:
    """What a deviation or a variance is of, by its spelling."""
    found = next((one for pattern in (_VARIANCE, _DEVIATION) if (one := pattern.match(name))), None)
    return next((part for part in found.groupdict().values() if part), "") if found else name


def _meant(said: frozenset[Meaning], symbols: Iterable[Symbol]) -> Iterator[tuple[Symbol, int]]:
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
    parts = [part for part in _CAMEL.sub("_", word).split("_") if part]
    telling = [part for part in parts if part.lower() not in _SAYS_LITTLE]
    if telling and len(parts) > 1:
        plain = "_".join(telling)
        if found := table.get(plain) or table.get(plain.lower()):
            return found
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
    "omega": "turn_rate",
    "alpha": "rate",
    "index": "tracking_index",
    **{name: name for name in ("u", "v", "x", "y", "z", "vx", "vy", "vz", "heading", "speed", "path", "baseline")},
    **{name: name for name in ("latitude", "longitude", "height", "semi_major_axis", "flattening")},
}
