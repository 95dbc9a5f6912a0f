"""Functions compiled from C, by ctypes or cffi, as functions that take numbers and vectors and return their result."""

from __future__ import annotations

import ctypes
import inspect
from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module
from typing import Any

import numpy as np
import numpy.typing as npt

Function = Callable[..., Any]

CFFI = "_cffi_backend"
ROOM = 1024  # numbers behind each pointer: a function that takes more than it is given reads and writes inside still
UNWRITTEN = {np.dtype(np.float64): 0x7FF4DEADBEEF0001, np.dtype(np.float32): 0x7FA0BEEF}  # NaNs that no function makes
NO_TYPES = "a function of ctypes must say what it takes and returns: argtypes = (c_double, …), restype = c_double"
NO_NUMBER = "the function returns a whole number, as ctypes takes for granted: restype = c_double says otherwise"


class NotCallable(ValueError):
    """A function of a shared library of which is not said how it is called."""


@dataclass(frozen=True)
class _Place:
    """What is taken in one place.

    Attributes:
        dtype: of what a pointer points to; None for a number.
        handed: a buffer as the pointer that is taken.
    """

    dtype: np.dtype[Any] | None = None
    handed: Callable[[npt.NDArray[Any]], Any] = np.asarray


@dataclass(frozen=True)
class _Declaration:
    """What a compiled function takes, and whether it returns a number."""

    places: tuple[_Place, ...]
    returns: bool


@dataclass(frozen=True)
class _Compiled:
    """A function whose last pointers are to what it computes."""

    function: Function
    declaration: _Declaration
    outputs: int

    @property
    def nin(self) -> int:
        """How many arguments it takes, as a ufunc says it."""
        return len(self.declaration.places) - self.outputs

    def __call__(self, *arguments: Any) -> Any:
        """What it returns or computes."""
        taken, filled = self.declaration.places[: self.nin], self.declaration.places[self.nin :]
        given = [_buffer(place, value) if place.dtype else value for place, value in zip(taken, arguments, strict=True)]
        results = [_buffer(place, ()) for place in filled]
        places = zip(self.declaration.places, (*given, *results), strict=True)
        returned = self.function(*(place.handed(value) if place.dtype else value for place, value in places))
        return tuple(map(_written, results)) if len(results) > 1 else next(map(_written, results), returned)


def as_called(function: Function, entries: int) -> list[Function]:
    """The function, or, where it takes pointers, one of numbers and vectors for each number of results they may be.

    Args:
        function: the user's.
        entries: of the quantity; so many pointers at the end may be to one entry each.

    Raises:
        NotCallable: it is of ctypes, and does not say what it takes, or that it returns a number.
    """
    declaration = _declared(function)
    if declaration is None:
        return [function]
    pointers = [place.dtype is not None for place in declaration.places]
    if not any(pointers):
        if not declaration.returns:
            raise NotCallable(NO_NUMBER)
        return [function]
    if declaration.returns:
        return [_Compiled(function, declaration, 0)]
    last = len(pointers) if all(pointers) else pointers[::-1].index(False)
    counts = [count for count in (entries, 1, last) if 0 < count <= last and count < max(len(pointers), 2)]
    return [_Compiled(function, declaration, count) for count in dict.fromkeys(counts)]


def _declared(function: Function) -> _Declaration | None:
    own = inspect.unwrap(function)
    if hasattr(own, "argtypes") and hasattr(own, "restype"):
        if own.argtypes is None:
            raise NotCallable(NO_TYPES)
        return _Declaration(tuple(map(_of_ctypes, own.argtypes)), own.restype in {ctypes.c_double, ctypes.c_float})
    if CFFI in {type(own).__module__, type(getattr(own, "__self__", None)).__module__}:
        return _of_cffi(own)
    return None


def _of_ctypes(kind: Any) -> _Place:
    dtype = getattr(kind, "_dtype_", None)
    if hasattr(kind, "_shape_"):  # of numpy.ctypeslib.ndpointer
        shape = getattr(kind, "_shape_", None)
        count = int(np.prod(shape)) if shape else ROOM
        return _Place(np.dtype(dtype or np.float64), lambda buffer: buffer[:count].reshape(shape or (-1,)))
    inner = getattr(kind, "_type_", None)
    if isinstance(inner, str) or inner is None:
        return _Place()
    if issubclass(kind, ctypes.Array):
        return _Place(np.dtype(inner).base, kind.from_buffer)
    return _Place(np.dtype(inner).base, lambda buffer: buffer.ctypes.data_as(kind))


def _of_cffi(function: Any) -> _Declaration | None:
    """Of a function that is opened, or of a library that is compiled."""
    ffi = import_module(CFFI).FFI()  # that of the package does not know functions of compiled libraries
    kind = ffi.typeof(function)
    if kind.kind != "function":
        return None
    return _Declaration(tuple(_of_c(ffi, taken) for taken in kind.args), kind.result.cname in {"double", "float"})


def _of_c(ffi: Any, kind: Any) -> _Place:
    inner = kind
    while inner.kind in {"pointer", "array"}:
        inner = inner.item
    if inner is kind:
        return _Place()
    dtype = np.dtype(np.float32 if inner.cname == "float" else np.float64)
    return _Place(dtype, lambda buffer: ffi.cast(kind, buffer.ctypes.data))


def _buffer(place: _Place, values: Any) -> npt.NDArray[Any]:
    """Room for what a pointer points to, and behind the values numbers that are none."""
    assert place.dtype is not None  # noqa: S101 - it is a pointer
    unsigned = np.dtype(f"u{place.dtype.itemsize}")
    found = np.full(ROOM, UNWRITTEN[place.dtype], unsigned).view(place.dtype)
    flat = np.ravel(np.asarray(values, place.dtype))
    found[: len(flat)] = flat
    return found


def _written(buffer: npt.NDArray[Any]) -> npt.NDArray[Any]:
    """What a function has put behind a pointer."""
    unsigned = buffer.view(f"u{buffer.dtype.itemsize}")
    return buffer[: int(np.flatnonzero(unsigned != UNWRITTEN[buffer.dtype]).max(initial=-1)) + 1]
