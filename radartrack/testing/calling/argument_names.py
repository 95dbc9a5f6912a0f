"""What parameters of functions are called, and which symbols they may stand for."""

from __future__ import annotations

import re
from collections.abc import Sequence

from radartrack.derive.checking.comparing.order_of_difference import is_deviation
from radartrack.derive.language.variable import Variable

# What the letters and words of code stand for; a word may stand for several symbols.
ALIASES: dict[str, tuple[str, ...]] = {
    "r": ("r", "rng", "range", "rho", "dist", "distance", "slantrange", "slant", "rg", "d", "ranges"),
    "beta": ("b", "az", "azi", "azimuth", "theta", "th", "bearing", "brg", "phi", "psi", "alpha", "angle", "azim"),
    "epsilon": ("e", "el", "elev", "elevation", "eps", "phi", "theta", "pitch"),
    "rdot": ("rdot", "rr", "rangerate", "doppler", "rrate", "dr", "drange", "rhodot", "radialvelocity", "vr"),
    "u": ("u", "dcu", "cosx"),
    "v": ("v", "dcv", "cosy", "speed", "velocity", "vel"),
    "x": ("x", "px", "posx", "xpos", "east", "e", "x1"),
    "y": ("y", "py", "posy", "ypos", "north", "n"),
    "z": ("z", "pz", "posz", "zpos", "up", "alt", "altitude", "height", "h"),
    "vx": ("vx", "xdot", "dx", "velx", "xvel", "veast"),
    "vy": ("vy", "ydot", "dy", "vely", "yvel", "vnorth"),
    "vz": ("vz", "zdot", "dz", "velz", "zvel", "vup"),
    "T": ("t", "dt", "deltat", "period", "ts", "tau", "step", "timestep", "interval", "scantime", "scanperiod"),
    "omega": ("omega", "w", "turnrate", "yawrate", "psidot"),
    "heading": ("heading", "psi", "yaw", "hdg", "theta", "phi", "h"),
    "k": ("k", "n", "count", "samples", "scans"),
    "q": ("q", "intensity", "psd", "spectraldensity", "qc"),
    "rho": ("rho", "corr", "correlation", "correlationcoefficient"),
    "path": ("path", "pathlength", "s"),
    "baseline": ("l", "bl", "base"),
    "speed": ("v", "vel", "velocity"),
    "latitude": ("lat", "phi"),
    "longitude": ("lon", "lng", "long", "lam", "lambda"),
    "height": ("h", "alt", "altitude", "hgt"),
    "semi_major_axis": ("a", "semimajor"),
    "flattening": ("f",),
    "index": ("lam", "lambda", "trackingindex"),
    "alpha": ("a",),
    "weight": ("w", "omega"),
    "azimuth": ("az", "azim"),
    "first": ("z1", "x1", "m1"),
    "second": ("z2", "x2", "m2"),
}
DEVIATION = ("sigma", "sig", "std", "stddev", "deviation", "s", "sd", "stdev", "noise")
VARIANCE = ("var", "variance", "sigma2", "sigmasq", "sig2", "cov")
DEGREES = ("deg", "degs", "degree", "degrees", "dps")  # the last: degrees a second
PREDICTED = ("predicted", "pred", "p", "prior")
WORD = re.compile(r"[A-Z]?[a-z]+|[A-Z]+(?![a-z])|\d+")


def meanings(parameter: str, symbols: Sequence[Variable]) -> list[str]:
    """The symbols that a parameter may stand for by its name, the likeliest first."""
    exact = [symbol.name for symbol in symbols if symbol.name == parameter]
    if exact:
        return exact
    words = _words(parameter)
    joined = "".join(words)
    same = [symbol.name for symbol in symbols if _joined(symbol.name) == joined]
    return same or [symbol.name for symbol in symbols if _may_mean(words, joined, symbol)]


def is_same_name(parameter: str, symbol: str) -> bool:
    """Whether it is the symbol's own, but for how words are joined: `sigma2` of sigma_2 is no square."""
    return _joined(parameter) == _joined(symbol)


def is_variance(parameter: str) -> bool:
    """Whether the name says that a variance is passed: `var_r`, `sigma2_theta`."""
    words = _words(parameter)
    return any(word in VARIANCE[:-1] for word in words) or bool({"sigma", "sig"} & set(words) and "2" in words[1:])


def is_degrees(parameter: str) -> bool:
    """Whether the name says that degrees are passed: `az_deg`."""
    return any(word in DEGREES for word in _words(parameter))


def _may_mean(words: list[str], joined: str, symbol: Variable) -> bool:
    name = symbol.name
    if name.startswith("predicted_"):
        rest = [word for word in words if word not in PREDICTED]
        return len(rest) < len(words) and _is_called(rest, "".join(rest), name.removeprefix("predicted_"), symbol)
    return _is_called(words, joined, name, symbol)


def _is_called(words: list[str], joined: str, name: str, symbol: Variable) -> bool:
    if not is_deviation(symbol):
        kept = [word for word in words if word not in DEGREES]
        return bool(kept) and _is_alias("".join(kept), name)
    of = symbol.deviation_of
    marks = {*DEVIATION, *VARIANCE}
    dropped = {*DEGREES} if of == "2" else {*DEGREES, "2"}  # sigma2_r is a square, sigma_2 the second
    kept = [word for word in words if word not in {*marks, *dropped}]
    if len(kept) == len([word for word in words if word not in dropped]):  # s_r or sr: no mark of its own
        return any(joined.startswith(mark) and _is_alias(joined.removeprefix(mark), of) for mark in marks)
    return _is_alias("".join(kept), of) if kept else False


def _is_alias(word: str, name: str) -> bool:
    return word == _joined(name) or word in ALIASES.get(name, ())


def _words(name: str) -> list[str]:
    return [word.lower() for word in WORD.findall(name)]


def _joined(name: str) -> str:
    return "".join(_words(name))
