"""How public functions check their arguments.

Every error names the argument, what was given and what is allowed. `TypeError` is for what is no real number:
strings, complex numbers, None, other objects, and bool, which beside ranges and angles is nearly always a
mistake. `ValueError` is for a number out of place. Whatever NumPy reads as an array is welcome (lists, pandas
Series), a masked array as long as none of its entries is masked.

The computation is in float32 where every array given is float32, and otherwise in float64, also for integers
and float16. Python's own int and float adapt to the arrays beside them, as they do in NumPy.
"""

import math
import reprlib
from collections.abc import Iterable, Mapping
from typing import Any, NamedTuple, TypeAlias, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

RealArray: TypeAlias = NDArray[np.floating[Any]]
Choice = TypeVar("Choice", bound=str)
SINGLE, DOUBLE = np.dtype(np.float32), np.dtype(np.float64)


class Domain(NamedTuple):
    """The interval that an argument may come from.

    It ends at `largest`, in float32 at `largest_single`; it begins at `smallest` or, where signed, at the
    negative of its end.
    """

    unit: str
    largest: float
    largest_single: float
    reason: str
    signed: bool = False
    smallest: float = 0.0

    def bounds(self, dtype: np.dtype[Any]) -> tuple[float, float]:
        """The least and the largest value in arrays of this type."""
        largest = self.largest_single if dtype == SINGLE else self.largest
        return (-largest if self.signed else self.smallest), largest

    def holds(self, value: float) -> bool:
        """Whether a number in float64 is finite and in the interval."""
        return (-self.largest if self.signed else self.smallest) <= value <= self.largest

    def describe(self, dtype: np.dtype[Any]) -> str:
        """The interval in words."""
        low, high = self.bounds(dtype)
        return f"from {low:.7g} to {high:.7g}{self.unit} in {dtype} ({self.reason})"


RANGE = Domain(" m", 1e100, 1e10, "squares of larger numbers overflow")
ANGLE = Domain(" rad", 1e6, 1e3, "rounding blurs the direction of a larger angle", signed=True)
ANGLE_STD = Domain(" rad", math.pi, math.pi, "a wrapped angle with a larger deviation says nothing about direction")
ELEVATION = Domain(" rad", math.pi / 2, math.pi / 2, "the vertical; beyond it the azimuth turns round", signed=True)
RANGE_RATE = Domain(" m/s", 1e50, 1e8, "the square of a larger number times a range overflows", signed=True)
RANGE_RATE_STD = Domain(" m/s", 1e50, 1e8, "the square of a larger number times a range overflows")
DIRECTION_COSINE = Domain("", 1.0, 1.0, "no cosine is larger", signed=True)
DIRECTION_COSINE_STD = Domain("", 1.0, 1.0, "no cosine is larger")
CORRELATION = Domain("", 1.0, 1.0, "no correlation is larger", signed=True)


def one_of(name: str, given: str | None, allowed: Iterable[Choice]) -> Choice:
    """Find the allowed word that was given.

    Raises:
        TypeError: it is no string.
        ValueError: it is none of the allowed words, which the message lists, the closest first.

    """
    words = list(allowed)
    if not isinstance(given, str):
        raise TypeError(f"{name} must be one of {words}; got {_shown(given)}")
    for word in words:
        if word == given:
            return word
    import difflib  # noqa: PLC0415 - only this message needs it

    words.sort(key=lambda word: difflib.SequenceMatcher(None, given.lower(), word).ratio(), reverse=True)
    raise ValueError(f"{name} must be one of {words}; got {given!r}")


def real_arrays(given: Mapping[str, ArrayLike]) -> dict[str, RealArray]:
    """Read the arguments, by name, as arrays of the one type in which to compute, float64 or float32.

    Raises:
        TypeError: an argument is not made of real numbers.
        ValueError: an argument is ragged, has masked entries, or is too large for the type.

    """
    arrays = {name: _array(name, value) for name, value in given.items()}
    typed = [arrays[name].dtype for name, value in given.items() if type(value) not in {int, float}]
    dtype = SINGLE if typed and all(dtype.char == SINGLE.char for dtype in typed) else DOUBLE
    return {name: array if array.dtype == dtype else _cast(name, array, dtype) for name, array in arrays.items()}


def require_within(name: str, values: RealArray, domain: Domain) -> None:
    """Check that all values are finite and in the domain.

    Raises:
        ValueError: some are not; the message says how many, and which is the first.

    """
    low, high = domain.bounds(values.dtype)
    # One pass each: a NaN passes through min and max, and compares false.
    least, greatest = (values.min(initial=low), values.max(initial=high)) if values.ndim else (values[()], values[()])
    if not (least >= low and greatest <= high):
        _require(name, values, "finite", np.isfinite(values))
        _require(name, values, domain.describe(values.dtype), (values >= low) & (values <= high))


def require_trailing_shape(name: str, values: RealArray, shape: tuple[int, ...]) -> None:
    """Check the lengths of the last axes.

    Raises:
        ValueError: they differ.

    """
    if values.shape[-len(shape) :] != shape:
        raise ValueError(f"{name} must have shape (..., {str(shape).strip('(,)')}); got shape {values.shape}")


def require_covariance(name: str, matrices: RealArray) -> None:
    """Check an array (..., n, n) of covariance matrices.

    Rounding may make a matrix asymmetric, a correlation larger than one, or an eigenvalue of the correlations
    negative, by the square root of the machine precision, relative to the product of the standard deviations.

    Raises:
        ValueError: an entry is not finite, a variance is negative, or a matrix is, beyond rounding, not
            symmetric or not positive semidefinite.

    """
    _require(name, matrices, "finite", np.isfinite(matrices))
    variances = np.diagonal(matrices, axis1=-2, axis2=-1)
    _require(name, matrices, "without a negative variance", (variances >= 0).all(axis=-1))
    deviations = np.sqrt(variances)
    scale = deviations[..., :, np.newaxis] * deviations[..., np.newaxis, :]
    tolerance = math.sqrt(np.finfo(matrices.dtype).eps)
    asymmetry = np.abs(matrices - np.swapaxes(matrices, -1, -2))
    _require(name, matrices, "symmetric", (asymmetry <= tolerance * scale).all(axis=(-2, -1)))
    bounded = (np.abs(matrices) <= (1 + tolerance) * scale).all(axis=(-2, -1))
    _require(name, matrices, "positive semidefinite", bounded)
    if matrices.shape[-1] > 2:  # of two variables there is one correlation
        correlations = matrices / np.where(scale > 0, scale, 1)
        least = np.linalg.eigvalsh(correlations)[..., 0]
        _require(name, matrices, "positive semidefinite", least >= -matrices.shape[-1] * tolerance)


def broadcast_shape(arrays: Mapping[str, RealArray]) -> tuple[int, ...]:
    """Find the shape that arrays, by name, broadcast to.

    Raises:
        ValueError: they do not; the message names the shape of each.

    """
    try:
        return common_shape(array.shape for array in arrays.values())
    except ValueError:
        shapes = ", ".join(f"{name} {array.shape}" for name, array in arrays.items())
        raise ValueError(f"the shapes must broadcast; got {shapes}") from None


def common_shape(shapes: Iterable[tuple[int, ...]]) -> tuple[int, ...]:
    """Find the shape that shapes broadcast to.

    Raises:
        ValueError: they do not.

    """
    distinct = {*shapes, ()}
    # Nearly always there is one beside numbers, which needs none of NumPy's care.
    return max(distinct) if len(distinct) <= 2 else np.broadcast_shapes(*distinct)


def _array(name: str, value: object) -> NDArray[Any]:
    if isinstance(value, np.ma.MaskedArray) and np.ma.is_masked(value):
        masked = np.count_nonzero(np.ma.getmaskarray(value))
        raise ValueError(f"{name} must have no masked entries; got {masked} among {value.size}")
    try:
        array = np.asarray(float(value) if type(value) is int else value)
    except (ValueError, OverflowError) as error:
        raise ValueError(f"{name} must be a number or an array; got {_shown(value)}: {error}") from error
    if array.dtype.kind not in "iuf":
        raise TypeError(f"{name} must be real numbers; got {_shown(value)}, which reads as {array.dtype}")
    return array


def _cast(name: str, array: NDArray[Any], dtype: np.dtype[Any]) -> RealArray:
    try:
        with np.errstate(over="raise", under="ignore"):
            return array.astype(dtype)
    except FloatingPointError:
        limit, largest = np.finfo(dtype).max, np.abs(array).max()
        raise ValueError(f"{name} must be at most {limit:.7g} to compute in {dtype}; got {largest}") from None


def _require(name: str, values: RealArray, allowed: str, fulfilled: NDArray[np.bool_] | np.bool_) -> None:
    if fulfilled.all():
        return
    first = np.unravel_index(np.argmin(fulfilled), fulfilled.shape)
    failing = np.count_nonzero(~fulfilled)
    index = ", ".join(map(str, first))
    place = f" at [{index}], the first of {failing} among {fulfilled.size}" if first else ""
    raise ValueError(f"{name} must be {allowed}; got {values[first].tolist()}{place}")


def _shown(value: object) -> str:
    return f"{reprlib.repr(value)} ({type(value).__name__})"
