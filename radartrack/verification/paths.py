"""The ways in which users come by the values of a quantity: its function, and the conversions that compute it.

`radartrack.convert` runs neither the function of an estimate nor that of a covariance: it runs one function for both,
over arrays, as machine code where Numba is installed, and for one plot in plain numbers. A mean from which a bias is
taken stands for the bias: it is the map less the mean.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cache
from importlib import import_module
from typing import Any

import numpy as np
import numpy.typing as npt

from radartrack._arrays import machine_code
from radartrack.derive import symbolic as sp
from radartrack.derive.catalogue import catalogue
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.writing.conversion_functions import METHODS, conversions_of, covariance_of, quantity_of
from radartrack.verification.outcome import FUNCTION, Function
from radartrack.verification.subject import generated

Array = npt.NDArray[np.float64]
Fill = Callable[..., object]
ARRAYS, ONE_PLOT, MACHINE_CODE = "arrays", "one plot", "machine code"


def paths_of(quantity: Quantity) -> tuple[str, ...]:
    """The ways to a quantity on this machine; its function comes first."""
    if quantity.name not in _conversions():
        return (FUNCTION,)
    return (FUNCTION, ARRAYS, ONE_PLOT, MACHINE_CODE) if machine_code.is_available() else (FUNCTION, ARRAYS, ONE_PLOT)


def conversion_of(name: str) -> str | None:
    """The name of the conversion that computes a quantity, if one does."""
    return _conversions()[name].conversion if name in _conversions() else None


def along(path: str, quantity: Quantity) -> tuple[Quantity, Function]:
    """What computes a quantity on this path, and the quantity as its errors are to be measured there.

    Raises:
        NotGenerated: when there is no function.
    """
    if path == FUNCTION:
        return quantity, generated(quantity)
    part = _conversions()[quantity.name]
    measured = replace(quantity, scale=lambda: _sizes(part.map_quantity)) if part.is_bias else quantity
    return measured, ByConversion(part, path)


@dataclass(frozen=True)
class Part:
    """What a conversion computes of one quantity.

    Attributes:
        conversion: the name of its functions.
        model: of the measurement.
        symbols: the names of its arguments, and a value for those that the quantity does not depend on.
        is_mean: whether it is in the mean, else in the covariance.
        is_bias: whether it is what the mean lacks of the map.
    """

    conversion: str
    model: str
    symbols: tuple[tuple[str, float], ...]
    is_mean: bool
    is_bias: bool

    @property
    def map_quantity(self) -> Quantity:
        """The plain conversion."""
        return catalogue()[f"{self.model}.map"]


@dataclass(frozen=True)
class ByConversion:
    """A quantity as a conversion computes it, called like its own function."""

    part: Part
    path: str

    def __call__(self, **given: npt.ArrayLike) -> Array:
        """Keywords that broadcast; shape (..., *tensor)."""
        columns = [np.asarray(given.get(name, other), dtype=np.float64) for name, other in self.part.symbols]
        shape = np.broadcast_shapes(*(column.shape for column in columns))
        flat = [np.broadcast_to(column, shape).flatten() for column in columns]
        size = self.part.map_quantity.shape[0]
        mean, covariance = np.full((len(flat[0]), size), np.nan), np.full((len(flat[0]), size, size), np.nan)
        _fill(self.path, self.part.conversion, size)(*flat, mean, covariance)
        if not self.part.is_mean:
            return covariance.reshape(*shape, size, size)
        if self.part.is_bias:
            plain = self.part.map_quantity
            measured = dict(zip((name for name, _ in self.part.symbols), flat, strict=True))
            mean = generated(plain)(**{symbol.name: measured[symbol.name] for symbol in plain.symbols}) - mean
        return mean.reshape(*shape, size)


@cache
def _conversions() -> dict[str, Part]:
    """Every quantity that a conversion computes."""
    known, found = catalogue(), {}
    for model, method in conversions_of(known):
        words = METHODS[method]
        covariance = covariance_of(known, model, method)
        mean = quantity_of(known, model, words.bias or words.estimate)
        symbols = tuple((symbol.name, symbol.high / 16) for symbol in known[covariance].symbols)
        name = f"{model}_{method}"
        found[mean] = Part(name, model, symbols, is_mean=True, is_bias=words.bias is not None)
        found[covariance] = Part(name, model, symbols, is_mean=False, is_bias=False)
    return found


def _fill(path: str, name: str, size: int) -> Fill:
    """What fills mean and covariance."""
    compiled = machine_code.conversion(name, size) if path == MACHINE_CODE else None
    if compiled is not None:
        return compiled
    module = import_module(f"radartrack.generated.{'loops' if path == ONE_PLOT else 'conversions'}")
    function: Fill = getattr(module, name)
    return function if path != ONE_PLOT else lambda *arrays: _plot_by_plot(function, *arrays)


def _plot_by_plot(loop: Fill, *arrays: Array) -> None:
    """Each plot alone in plain numbers, into dictionaries, as `radartrack._conversion.one_plot` calls the loop."""
    *inputs, means, covariances = arrays
    for plot, values in enumerate(zip(*(column.tolist() for column in inputs), strict=True)):
        mean: dict[tuple[int, ...], float] = {}
        covariance: dict[tuple[int, ...], float] = {}
        loop([[value] for value in values], mean, covariance)
        _put(mean, means[plot])
        _put(covariance, covariances[plot])


def _put(found: dict[tuple[int, ...], float], into: Array) -> None:
    """The numbers in the order in which they were filled in, which must be that of their places."""
    if [*found] != [(0, *index) for index in np.ndindex(into.shape)]:
        raise ValueError(f"a single plot is filled in at {[*found]}")
    into[...] = np.reshape([*found.values()], into.shape)


def _sizes(plain: Quantity) -> Tensor[Any]:
    """For each coordinate the norm of those that share its unit: what a mean is measured against."""
    outputs: Sequence[Any] = plain.expression.entries
    units = [plain.unit((a,)) for a in range(len(outputs))]
    norms = [sp.sqrt(sp.Add(*(h**2 for h, other in zip(outputs, units, strict=True) if other == u))) for u in units]
    return Tensor(plain.shape, tuple(norms))
