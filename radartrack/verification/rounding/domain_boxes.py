"""The domain of a function as boxes in coordinates in which bounds of errors are nearly flat.

Every coordinate is a logarithm: where an error does not depend on a scale, a box may be as wide as the domain.

An angle counts by its distance from the nearest quarter turn, where its sine or its cosine vanishes. Values of either
sign have their size for a coordinate, from `SMALLEST` on; zero is a case of its own, as every rule of signs is.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np

from radartrack.verification.rounding.enclosures import SLACK, Array, Enclosure, curve
from radartrack.verification.rounding.error_rules import ULPS, Signs, Value, exact, settled

SMALLEST = 1e-20
LARGEST_CORRELATION = 0.99
QUARTER = math.pi / 2
EIGHTH = math.pi / 4 * (1 + 1e-9)


@dataclass(frozen=True)
class Argument:
    """One argument: its name, domain and what kind of number it is."""

    name: str
    low: float
    high: float
    kind: str  # "positive", "signed", "angle", "correlation"


@dataclass(frozen=True)
class Case:
    """One choice of signs and zeros: of each argument what it is in this case.

    Attributes:
        choices: argument → "zero", "+", "-", "±", or of an angle the signs of cosine and sine and which is small:
            "+±s" has a positive cosine and a small sine.
    """

    choices: Mapping[str, str]

    @property
    def text(self) -> str:
        """As certificates have it."""
        return " ".join(f"{name}:{choice}" for name, choice in self.choices.items())


@dataclass(frozen=True)
class Coordinates:
    """Which coordinate an argument is, and from where to where the coordinates go."""

    places: Mapping[str, int]
    low: Array
    high: Array


def cases(arguments: Sequence[Argument], *, correlated: bool) -> Iterator[Case]:
    """All choices of signs and zeros that the domain has."""
    choices = [_choices(argument, correlated=correlated) for argument in arguments]
    for chosen in product(*choices):
        yield Case({argument.name: choice for argument, choice in zip(arguments, chosen, strict=True)})


def _choices(argument: Argument, *, correlated: bool) -> list[str]:
    low, high = argument.low, argument.high
    if argument.kind == "correlation":
        return ["+", "-"] if correlated else ["zero"]
    if argument.kind == "angle":
        octants = ["+±s"] if max(-low, high) <= EIGHTH else ["+±s", "±±c"]
        octants = octants if max(-low, high) <= QUARTER else ["±±s", "±±c"]
        if octants[-1] == "±±c" and max(-low, high) <= QUARTER:
            octants[-1] = "+±c"
        if correlated:
            octants = [o for octant in octants for o in _signed(octant)]
        return ["zero", *octants] if low <= 0 <= high else octants
    if argument.kind == "signed":
        return ["zero", "±"]
    return ["zero", "+"] if low == 0 else ["+"]


def _signed(octant: str) -> list[str]:
    each = ["+-" if sign == "±" else sign for sign in octant[:2]]
    return [f"{cosine}{sine}{octant[2]}" for cosine in each[0] for sine in each[1]]


def coordinates(arguments: Sequence[Argument], case: Case) -> Coordinates:
    """A coordinate for every argument that is not zero."""
    present = [argument for argument in arguments if case.choices[argument.name] != "zero"]
    ends = np.array([ends_of(argument) for argument in present]).reshape(-1, 2)
    places = {argument.name: position for position, argument in enumerate(present)}
    return Coordinates(places, ends[:, 0], ends[:, 1])


def ends_of(argument: Argument) -> tuple[float, float]:
    """Of the logarithm of an argument's size, or of an angle's distance from a quarter turn."""
    if argument.kind == "angle":
        return math.log(SMALLEST), math.log(min(EIGHTH, max(-argument.low, argument.high)))
    if argument.kind == "correlation":
        return math.log(SMALLEST), math.log(LARGEST_CORRELATION)
    largest = max(abs(argument.low), abs(argument.high))
    return math.log(argument.low if argument.low > 0 else min(SMALLEST, largest)), math.log(largest)


@dataclass(frozen=True)
class Given:
    """The arguments of a function in a batch of boxes: values, and cosine and sine of the angles; None is zero."""

    values: Mapping[str, Value | None]
    cosines: Mapping[str, Value | None]
    sines: Mapping[str, Value | None]
    like: Enclosure  # one, in as many boxes and coordinates


def given(arguments: Sequence[Argument], case: Case, place: Coordinates, low: Array, high: Array) -> Given:
    """The arguments in boxes whose ends have shape (boxes, coordinates)."""
    middle, half = (low + high) / 2, (high - low) / 2
    count = len(low)
    zeros = np.zeros(count)
    one = Enclosure(zeros, np.zeros_like(half), zeros, zeros, zeros, zeros)
    values: dict[str, Value | None] = {}
    cosines: dict[str, Value | None] = {}
    sines: dict[str, Value | None] = {}
    for argument in arguments:
        name, choice = argument.name, case.choices[argument.name]
        if choice == "zero":
            values[name] = None
            if argument.kind == "angle":
                sines[name], cosines[name] = None, exact(one, _sign("+", count), number=True)
            continue
        size = _logarithm(place.places[name], middle, half)
        if argument.kind != "angle":
            values[name] = exact(size, _sign(choice, count))
            continue
        small, large = _sine(size, "sin"), _sine(size, "cos")
        sine, cosine = (small, large) if choice[2] == "s" else (large, small)
        sines[name] = _of_library(sine, _sign(choice[1], count), "sin")
        cosines[name] = _of_library(cosine, _sign(choice[0], count), "cos")
    return Given(values, cosines, sines, one)


def _of_library(size: Enclosure, sign: Signs, function: str) -> Value:
    relative = np.full_like(size.middle, 2 * ULPS[function])
    return settled(size, sign, relative, None, size, size.low - 1e-6)


def _sign(choice: str, count: int) -> Signs:
    return np.full(count, {"+": 1, "-": -1, "±": 0}[choice], dtype=np.int8)


def _logarithm(coordinate: int, middle: Array, half: Array) -> Enclosure:
    slopes = np.zeros_like(half)
    slopes[:, coordinate] = half[:, coordinate]
    centre, slack = middle[:, coordinate], np.full(len(middle), SLACK)
    low, high = centre - half[:, coordinate] - SLACK, centre + half[:, coordinate] + SLACK
    return Enclosure(centre, slopes, slack, slack, low, high)


def _sine(distance: Enclosure, function: str) -> Enclosure:
    """Sine or cosine of the distance from a quarter turn, both concave in its logarithm."""

    def logarithm(of: Array) -> Array:
        return np.asarray(np.log(np.sin(np.exp(of)) if function == "sin" else np.cos(np.exp(of))))

    def slope(of: Array) -> Array:
        x = np.exp(of)
        return np.asarray(x / np.tan(x) if function == "sin" else -x * np.tan(x))

    return curve(distance, logarithm, slope, concave=True)


def tree_of(splits: Mapping[str, int]) -> str:
    """In preorder: a box by its path of halves, with the coordinate at whose middle it is halved, or a dot."""
    stack, letters = [""], []
    while stack:
        path = stack.pop()
        axis = splits.get(path)
        letters.append("." if axis is None else chr(ord("a") + axis))
        if axis is not None:
            stack += [path + "1", path + "0"]
    return "".join(letters)
