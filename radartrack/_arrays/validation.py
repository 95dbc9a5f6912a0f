"""How public functions check their arguments.

Every error names the argument, what was given and what is allowed. `TypeError` is for what is no real number:
strings, complex numbers, None, other objects, and bool, which beside ranges and angles is nearly always a
mistake. `ValueError` is for a number out of place. Whatever NumPy reads as an array is welcome (lists, pandas
Series), a masked array as long as none of its entries is masked.

The computation is in float32 where every array given is float32, and otherwise in float64, also for integers
and float16. Python's own int and float adapt to the arrays beside them, as they do in NumPy.
"""

import math
import operator
import reprlib
import sys
from collections.abc import Collection, Iterable, Iterator, Mapping
from typing import Any, NamedTuple, TypeAlias, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

RealArray: TypeAlias = NDArray[np.floating[Any]]
Choice = TypeVar("Choice", bound=str)
SINGLE, DOUBLE = np.dtype(np.float32), np.dtype(np.float64)
PLAIN = frozenset({np.ndarray, int, float})  # of which nothing is lost when NumPy reads them


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
        # Seven digits where that does not name a number outside: pi, rounded so, is refused.
        least = f"{low:.7g}" if float(f"{low:.7g}") >= low else repr(low)
        most = f"{high:.7g}" if float(f"{high:.7g}") <= high else repr(high)
        return f"from {least} to {most}{self.unit} in {dtype} ({self.reason})"


RANGE = Domain(" m", 1e100, 1e10, "squares of larger numbers overflow")
ANGLE = Domain(" rad", 1e6, 1e3, "rounding blurs the direction of a larger angle", signed=True)
ANGLE_STD = Domain(" rad", math.pi, math.pi, "a wrapped angle with a larger deviation says nothing about direction")
ELEVATION = Domain(" rad", math.pi / 2, math.pi / 2, "the vertical; beyond it the azimuth turns round", signed=True)
RANGE_RATE = Domain(" m/s", 1e50, 1e8, "the square of a larger number times a range overflows", signed=True)
RANGE_RATE_STD = Domain(" m/s", 1e50, 1e8, "the square of a larger number times a range overflows")
DIRECTION_COSINE = Domain("", 1.0, 1.0, "no cosine is larger", signed=True)
DIRECTION_COSINE_STD = Domain("", 1.0, 1.0, "no cosine is larger")
PATH = Domain(" m", 1e100, 1e10, "squares of larger numbers overflow, and a path has a length", smallest=1e-30)
PATH_AZIMUTH_STD = Domain(" rad", 0.5, 0.5, "of a larger deviation the series of fourth order leaves a per cent")
COVARIANCE = Domain("", 1e200, 1e20, "squares of larger deviations overflow", signed=True)
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


def by_name(name: str, given: Mapping[str, Any]) -> dict[str, Any]:
    """Read arguments by name, from a dict or what else has keys.

    Raises:
        TypeError: it has none.

    """
    try:
        return {**given}
    except TypeError:
        raise TypeError(f"{name} must be arguments by name, such as a dict; got {_shown(given)}") from None


def require_parts(name: str, given: object, parts: Iterable[str], kind: str) -> None:
    """Check that something has the parts by which a thing of its kind is known.

    Raises:
        TypeError: it lacks one.

    """
    if not all(hasattr(given, part) for part in parts):
        raise TypeError(f"{name} must be {kind}; got {_shown(given)}")


def whole_number(name: str, given: object, least: int, most: int | None = None) -> int:
    """Read a whole number: an int, or what stands for one, such as an integer of NumPy.

    Raises:
        TypeError: it is none; a bool is none either.
        ValueError: it is less or more than allowed.

    """
    try:
        number = operator.index(given)  # type: ignore[arg-type]
    except TypeError:
        number = None
    if number is None or isinstance(given, (bool, np.bool_)):
        raise TypeError(f"{name} must be a whole number; got {_shown(given)}")
    if number < least or (most is not None and number > most):
        allowed = f"at least {least}" if most is None else f"from {least} to {most}"
        raise ValueError(f"{name} must be {allowed}; got {_brief(number)}")
    return number


def real_number(name: str, given: object) -> float:
    """Read one finite real number.

    Raises:
        TypeError: it is none; a bool is none either.
        ValueError: it is not finite, or too large for float64.

    """
    number = _as_float(name, given)
    if not math.isfinite(number):
        raise ValueError(f"{name} must be finite; got {_brief(given)}")
    return number


def number_between(name: str, given: object, least: float, most: float) -> float:
    """Read one real number from an interval, whose ends belong to it.

    Raises:
        TypeError: it is none; a bool is none either.
        ValueError: it lies outside.

    """
    number = _as_float(name, given)
    if not least <= number <= most:
        raise ValueError(f"{name} must be from {least:g} to {most:g}; got {_brief(given)}")
    return number


def positive_number(name: str, given: object) -> float:
    """Read one finite real number that is more than zero.

    Raises:
        TypeError: as `real_number`.
        ValueError: as `real_number`, or it is not positive.

    """
    number = real_number(name, given)
    if number <= 0:
        raise ValueError(f"{name} must be more than 0; got {number:g}")
    return number


def real_arrays(given: Mapping[str, ArrayLike]) -> dict[str, RealArray]:
    """Read the arguments, by name, as arrays of the one type in which to compute, float64 or float32.

    Raises:
        TypeError: an argument is not made of real numbers.
        ValueError: an argument is ragged, has masked entries, or is too large for the type.

    """
    arrays = {name: _array(name, value) for name, value in given.items()}
    typed = [arrays[name].dtype for name, value in given.items() if type(value) not in {int, float}]
    dtype = SINGLE if typed and all(dtype.char == SINGLE.char for dtype in typed) else DOUBLE
    return {name: rounded_to(dtype, name, array) for name, array in arrays.items()}


def kept(array: RealArray) -> RealArray:
    """A copy that cannot be written to, for an object that was checked: who gave the array may use it again."""
    copy = np.array(array)
    copy.flags.writeable = False
    return copy


def rounded_to(dtype: np.dtype[Any], name: str, array: NDArray[Any]) -> RealArray:
    """Take numbers over to a type.

    Raises:
        ValueError: a number is too large for it.

    """
    if array.dtype == dtype:
        return array
    try:
        with np.errstate(over="raise", under="ignore"):
            return array.astype(dtype)
    except FloatingPointError:
        limit, largest = np.finfo(dtype).max, np.nanmax(np.abs(array))
        raise ValueError(f"{name} must be at most {limit:.7g} to compute in {dtype}; got {largest}") from None


def require_within(name: str, values: RealArray, domain: Domain) -> None:
    """Check that all values are finite and in the domain.

    Raises:
        ValueError: some are not; the message says how many, and which is the first.

    """
    low, high = domain.bounds(values.dtype)
    # One pass each: a NaN passes through min and max, and compares false.
    least, greatest = (values.min(initial=low), values.max(initial=high)) if values.ndim else (values[()], values[()])
    if not (least >= low and greatest <= high):
        require_finite(name, values)
        _require(name, values, domain.describe(values.dtype), (values >= low) & (values <= high))


def require_finite(name: str, values: RealArray) -> None:
    """Check that all values are finite.

    Raises:
        ValueError: some are not; the message says how many, and which is the first.

    """
    _require(name, values, "finite", np.isfinite(values))


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
    require_finite(name, matrices)
    variances = np.diagonal(matrices, axis1=-2, axis2=-1)
    _require(name, matrices, "without a negative variance", (variances >= 0).all(axis=-1))
    deviations = np.sqrt(variances)
    scale = deviations[..., :, np.newaxis] * deviations[..., np.newaxis, :]
    tolerance = math.sqrt(np.finfo(matrices.dtype).eps)
    with np.errstate(over="ignore"):  # what overflows is larger, too
        asymmetry = np.abs(matrices - np.swapaxes(matrices, -1, -2))
        bounded = (np.abs(matrices) <= (1 + tolerance) * scale).all(axis=(-2, -1))
    _require(name, matrices, "symmetric", (asymmetry <= tolerance * scale).all(axis=(-2, -1)))
    _require(name, matrices, "positive semidefinite", bounded)
    if matrices.shape[-1] > 2:  # of two variables there is one correlation
        _require_semidefinite(name, matrices, matrices / np.where(scale > 0, scale, 1), tolerance)


def _require_semidefinite(name: str, matrices: RealArray, correlations: RealArray, tolerance: float) -> None:
    size = matrices.shape[-1]
    try:
        np.linalg.cholesky(correlations + size * tolerance * np.eye(size, dtype=matrices.dtype))
    except np.linalg.LinAlgError:  # eigenvalues take ten times as long, and say which it is
        least = np.linalg.eigvalsh(correlations)[..., 0]
        _require(name, matrices, "positive semidefinite", least >= -size * tolerance)


def require_variances(name: str, variances: RealArray) -> None:
    """Check that computed variances, NaN where there are none, neither overflowed nor lost their digits.

    Raises:
        ValueError: some did.

    """
    limits = np.finfo(variances.dtype)
    with np.errstate(invalid="ignore"):
        fits = np.isnan(variances) | ((variances >= limits.tiny) & (variances <= limits.max))
    allowed = f"of variances from {limits.tiny:.7g} to {limits.max:.7g} to compute in {variances.dtype}"
    _require(name, variances, allowed, fits)


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


def _array(name: str, value: Any) -> NDArray[Any]:
    if type(value) in PLAIN:
        return _numbers(name, value)
    parts = [*_parts(value)]
    _require_unmasked(name, value, parts)
    if any(map(_has_unit, parts)):
        raise TypeError(f"{name} must be real numbers; got {_shown(value)}, whose unit would be lost")
    whole = getattr(value, "combine_chunks", lambda: value)()  # chunks of pyarrow's have any number for what is missing
    array = _numbers(name, whole)
    if any(map(_is_bool, parts)):
        raise TypeError(f"{name} must be real numbers; got {_shown(value)}, which reads as {array.dtype}")
    _require_unmasked(name, array, [array])  # a variable of netCDF is no masked array, but is read as one
    return np.asarray(array)


def _numbers(name: str, value: Any) -> NDArray[Any]:
    try:
        array = np.asanyarray(float(value) if type(value) is int else value)
    except (ValueError, OverflowError) as error:
        raise ValueError(f"{name} must be a number or an array; got {_shown(value)}: {error}") from error
    if array.dtype.kind not in "iuf":
        raise TypeError(f"{name} must be real numbers; got {_shown(value)}, which reads as {array.dtype}")
    return array


def _parts(value: object) -> Iterator[object]:
    """An array or a number, or those that a list or the like holds beside plain numbers."""
    if hasattr(value, "__array__") or isinstance(value, (str, bytes)) or not isinstance(value, Collection):
        yield value
    elif not set(map(type, value)) <= {int, float, np.float64}:
        for part in value:
            yield from _parts(part)


def _require_unmasked(name: str, value: Any, parts: Iterable[object]) -> None:
    """Check that no entry of any part is masked, under which NumPy would read some number."""
    if "numpy.ma" not in sys.modules:  # without it there are no masked arrays, and it takes long to load
        return
    masked = sum(int(np.ma.getmaskarray(part).sum()) for part in parts if isinstance(part, np.ma.MaskedArray))
    if masked:
        raise ValueError(f"{name} must have no masked entries; got {masked} among {np.size(value)}")


def _is_bool(part: object) -> bool:
    """Whether it is a bool, or an array of such, which NumPy would read as 0 or 1."""
    return isinstance(part, bool) or getattr(getattr(part, "dtype", None), "kind", "") == "b"


def _has_unit(part: object) -> bool:
    """Whether it is a quantity of pint, astropy or the like, of which NumPy would read the number alone."""
    arrays = getattr(sys.modules.get("xarray"), "DataArray", ())  # which keep quantities inside
    kind = type(part.data if isinstance(part, arrays) else part)
    return hasattr(kind, "units") or hasattr(kind, "unit")


def _as_float(name: str, given: object) -> float:
    if isinstance(given, (bool, np.bool_)) or not isinstance(given, (int, float, np.integer, np.floating)):
        raise TypeError(f"{name} must be a real number; got {_shown(given)}")
    try:
        return float(given)
    except OverflowError:
        return math.inf if given > 0 else -math.inf


def _require(name: str, values: RealArray, allowed: str, fulfilled: NDArray[np.bool_] | np.bool_) -> None:
    if fulfilled.all():
        return
    first = np.unravel_index(np.argmin(fulfilled), fulfilled.shape)
    failing = np.count_nonzero(~fulfilled)
    index = ", ".join(map(str, first))
    place = f" at [{index}], the first of {failing} among {fulfilled.size}" if first else ""
    raise ValueError(f"{name} must be {allowed}; got {values[first].tolist()}{place}")


def _shown(value: object) -> str:
    return f"{_brief(value)} ({type(value).__name__})"


def _brief(value: object) -> str:
    """What was given, in a few characters; Python does not write integers of thousands of digits."""
    try:
        return reprlib.repr(value)
    except ValueError:
        return "too many digits to show"
