"""Calls a function of the user's, whatever it takes and returns, and makes arrays of what comes back."""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable, Coroutine, Iterator, Mapping, ValuesView
from dataclasses import dataclass, field, fields, is_dataclass
from enum import Enum
from itertools import islice
from typing import Any

import numpy as np
import numpy.typing as npt

from radartrack.derive.language.tensor import Index
from radartrack.verification.domain_points import Points

Array = npt.NDArray[np.float64]
Change = Callable[[Any], Any]


MOST = 10_000  # values that are taken of an iterator, which may have no end
RETURNS = "it returns"  # how what is said of a result begins


class NotKnown(LookupError):
    """A function that is a table has no value there."""


@dataclass(frozen=True)
class Precision:
    """How exact the values of a table are written.

    Attributes:
        share: half of the last digit, in units of a value of ordinary size.
        least: half of the last decimal, where all values have as many; 0 where they have as many digits.
    """

    share: float
    least: float


class Form(Enum):
    """How arguments are handed over."""

    SCALARS = "numbers"
    COLUMNS = "column vectors"
    ROWS = "matrices of one row, as of many plots"
    ARRAYS = "arrays of one element"
    WHOLE = "whole numbers as such"


@dataclass(frozen=True)
class Made:
    """What is passed in place of a vector.

    Attributes:
        words: what that is, before the symbols.
        of: makes it of the values, in the order of the symbols.
        is_ordered: whether it tells the values from each other by their order, not by names.
    """

    words: str
    of: Callable[[list[float]], Any] = field(compare=False)
    is_ordered: bool = False


@dataclass(frozen=True)
class Parameter:
    """What is passed in one place.

    Attributes:
        name: of the parameter.
        symbols: one, or several in one vector.
        is_vector: whether they are passed as a vector.
        is_keyword: whether it is passed by name.
        correlated: of deviations that are passed as a covariance matrix, for each correlation among the symbols the
            places of its deviations; None where they are passed as they are.
        made: what is made of the values where no vector is passed: an object, a complex number.
    """

    name: str
    symbols: tuple[str, ...]
    is_vector: bool = False
    is_keyword: bool = False
    correlated: tuple[tuple[int, int], ...] | None = None
    made: Made | None = None

    @property
    def is_ordered(self) -> bool:
        """Whether the function tells several values from each other by their order."""
        return self.made is None or self.made.is_ordered

    def words(self, changed: Mapping[str, str]) -> str:
        """`az: beta`, `az_deg: beta in degrees`, `state: (x, y)`.

        Args:
            changed: symbol → what is passed for it, in words, where that is another thing.
        """
        taken = [changed.get(name, name) for name in self.symbols]
        listed = ", ".join(taken)
        if self.correlated is not None:
            return f"{self.name}: the covariance matrix of {listed}"
        if self.made is not None:
            return f"{self.name}: {self.made.words} of {listed}"
        return f"{self.name}: ({listed})" if self.is_vector else f"{self.name}: {taken[0]}"

    def matrix(self, values: list[float]) -> Array:
        """The covariance matrix of deviations, with the correlations that come after them."""
        assert self.correlated is not None  # noqa: S101 - only then is there one
        count = len(values) - len(self.correlated)
        found = np.eye(count)
        for (i, j), correlation in zip(self.correlated, values[count:], strict=True):
            found[i, j] = found[j, i] = correlation
        return found * np.outer(values[:count], values[:count])


@dataclass(frozen=True)
class Binding:
    """Which symbol is passed where, and as what.

    Attributes:
        parameters: in the order of the call.
        form: how vectors and numbers are handed over.
        changes: what is passed in place of a symbol's value: degrees, a variance.
        told: whether the names of all parameters say it.
    """

    parameters: tuple[Parameter, ...]
    form: Form = Form.SCALARS
    changes: Mapping[str, Change] = field(default_factory=dict, hash=False)
    told: bool = field(default=False, compare=False)

    @property
    def symbols(self) -> tuple[str, ...]:
        """All that are passed, in the order of the call."""
        return tuple(name for parameter in self.parameters for name in parameter.symbols)

    def arguments(self, point: Mapping[str, float]) -> tuple[list[Any], dict[str, Any]]:
        """Those at one point, in places and by name."""
        places: list[Any] = []
        named: dict[str, Any] = {}
        for parameter in self.parameters:
            values = [self.changes.get(name, _itself)(point[name]) for name in parameter.symbols]
            value = self._handed(parameter, values)
            if parameter.is_keyword:
                named[parameter.name] = value
            else:
                places.append(value)
        return places, named

    def _number(self, value: float) -> Any:
        if self.form is Form.ARRAYS:
            return np.array([value])
        return int(value) if self.form is Form.WHOLE and float(value).is_integer() else float(value)

    def _handed(self, parameter: Parameter, values: list[float]) -> Any:
        if parameter.correlated is not None:
            return parameter.matrix(values)
        if parameter.made is not None:
            return parameter.made.of(values)
        if not parameter.is_vector:
            return self._number(values[0])
        axis = {Form.COLUMNS: 1, Form.ROWS: 0}.get(self.form)
        return np.array(values) if axis is None else np.expand_dims(values, axis)


@dataclass
class Calls:
    """What came back at some points.

    Attributes:
        values: shape (points, entries); NaN where there is no real number.
        raised: place → what was raised there.
        complex: places where a complex number came back.
        wrong: place → a shape that cannot be compared.
        unknown: places beside those of a table.
        single: whether all came back in single precision.
    """

    values: Array
    raised: dict[int, str] = field(default_factory=dict)
    complex: list[int] = field(default_factory=list)
    wrong: dict[int, str] = field(default_factory=dict)
    unknown: list[int] = field(default_factory=list)
    single: bool = False

    @property
    def trouble(self) -> str:
        """Why there is no value at the first point; empty where there is one."""
        return self.raised.get(0, "") or self.wrong.get(0, "") or "it has no values there" * (0 in self.unknown)


def called(function: Callable[..., Any], binding: Binding, points: Points, shape: Index) -> Calls:
    """The values of a function, one call a point.

    Args:
        function: whose result has `shape`, or can be seen as having it: a column for a vector, a flat list of the
            entries, the upper triangle of a symmetric matrix, or one of several results.
        binding: how it is called.
        points: symbol name → array of shape (count,).
        shape: of a result.
    """
    count = len(next(iter(points.values()))) if points else 1
    size = math.prod(shape)
    calls = Calls(np.full((count, size), np.nan))
    singles = 0
    for place in range(count):
        point = {name: float(values[place]) for name, values in points.items()}
        places, named = binding.arguments(point)
        try:
            with warnings.catch_warnings(), np.errstate(all="ignore"):
                warnings.simplefilter("ignore")
                result = _drained(function(*places, **named))
        except NotKnown:
            calls.unknown.append(place)
            continue
        except (Exception, SystemExit) as error:  # noqa: BLE001 - whatever a stranger's function raises
            calls.raised[place] = f"it raises {type(error).__name__}: {error}".removesuffix(": ")
            continue
        found = shaped(result, shape)
        if isinstance(found, str):
            calls.wrong[place] = found
        elif np.iscomplexobj(found) and np.any(np.imag(found) != 0):
            calls.complex.append(place)
        else:
            calls.values[place] = np.real(found).astype(np.float64).reshape(size)
            singles += found.dtype == np.float32 or _is_single(calls.values[place])
    calls.single = count > 0 and singles == count
    return calls


def shaped(result: Any, shape: Index) -> npt.NDArray[Any] | str:
    """The result as an array of a shape; what is wrong with it, in words, where it cannot be one."""
    result = _parts(result, shape)
    found = _array(result)
    if found is None:
        fitting = (
            [one for one in map(_array, result) if one is not None and _fitted(one, shape) is not None]
            if isinstance(result, tuple | list)
            else []
        )
        if len(fitting) != 1:
            return f"{RETURNS} {_described(result)}; {_spoken(shape)} is wanted"
        found = fitting[0]
    fitted = _fitted(found, shape)
    if fitted is not None:
        return fitted
    given = _described(result) if found.shape == () and np.iscomplexobj(found) else _spoken(found.shape)
    return f"{RETURNS} {given}; {_spoken(shape)} is wanted"


def _parts(result: Any, shape: Index) -> Any:
    """The values of a dict or of the fields of an object, in their order; both parts of x + iy; else the result."""
    if isinstance(result, Mapping):
        return list(result.values())
    if is_dataclass(result) and not isinstance(result, type):
        return [getattr(result, one.name) for one in fields(result)]
    if shape == (2,) and isinstance(result, complex | np.complexfloating):
        return [result.real, result.imag]
    own = getattr(result, "__dict__", None)
    return list(own.values()) if own and _array(result) is None and not callable(result) else result


def as_array(result: Any) -> npt.NDArray[Any] | None:
    """What a function returns as an array of numbers; None for what is none."""
    return _array(_parts(_drained(result), ()))


def _drained(result: Any) -> Any:
    """The values of an iterator, which are computed only now, or of a dict; anything else as it is."""
    if isinstance(result, Coroutine):
        result.close()  # nothing waits for it
    return list(islice(result, MOST)) if isinstance(result, Iterator | ValuesView) else result


def _array(result: Any) -> npt.NDArray[Any] | None:
    if result is None:
        return None
    try:
        found = np.asarray(result)
    except (TypeError, ValueError):  # results of different shapes
        return None
    if found.dtype == object:
        try:
            found = found.astype(np.float64)
        except (TypeError, ValueError):
            return None
    return found if found.dtype.kind in "fiubc" else None


def _fitted(found: npt.NDArray[Any], shape: Index) -> npt.NDArray[Any] | None:
    if found.shape == shape:
        return found
    if _without_ones(found.shape) == _without_ones(shape) or (found.ndim == 1 and found.size == math.prod(shape)):
        return found.reshape(shape)
    is_square = len(shape) == 2 and shape[0] == shape[1]
    if is_square and found.ndim == 1 and found.size == shape[0] * (shape[0] + 1) // 2:
        full = np.zeros(shape, found.dtype)
        rows, columns = np.triu_indices(shape[0])
        full[rows, columns] = full[columns, rows] = found
        return full
    return None


def _without_ones(shape: Index) -> Index:
    return tuple(size for size in shape if size != 1)


def _is_single(values: Array) -> bool:
    """Whether single precision holds the values, as a float of C is handed over; whole numbers say nothing."""
    with np.errstate(all="ignore"):
        return bool(np.all(values == values.astype(np.float32)) and np.any(values != np.round(values)))


def _spoken(shape: Index) -> str:
    return f"an array of shape {shape}" if shape else "a number"


def _described(result: Any) -> str:
    if isinstance(result, complex | np.complexfloating):
        return "a complex number"
    return "nothing" if result is None else f"a {type(result).__name__}"


def _itself(value: Any) -> Any:
    return value
