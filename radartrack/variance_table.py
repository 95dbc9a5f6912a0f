"""Measurement variances by range, azimuth sector and season, gathered from straight flights.

The table keeps what every flight contributed to every cell, never the totals: sums over all flights are
formed with exact rounding when they are asked for, so that tables merge in any order to the same numbers.
"""

import errno
import hashlib
import math
from collections.abc import Mapping
from dataclasses import dataclass, fields
from functools import cached_property
from os import PathLike
from pathlib import Path
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from radartrack import line
from radartrack._arrays import bounded_archive
from radartrack._arrays.bounded_archive import ArchiveError, Stored
from radartrack._arrays.validation import (
    ANGLE,
    COVARIANCE,
    RANGE,
    broadcast_shape,
    kept,
    number_between,
    real_arrays,
    require_covariance,
    require_parts,
    require_trailing_shape,
    require_within,
    whole_number,
)
from radartrack._system.directory_swap import replace_file
from radartrack.generated import line as formulas

Floats: TypeAlias = NDArray[np.float64]
Columns: TypeAlias = Mapping[str, NDArray[Any]]

FORMAT = "radartrack variance table"
VERSION = 1
VARIANCE = COVARIANCE._replace(unit=" m^2")
ROUNDING = 1e-9  # beside it, rounding errors of 1e-16 are nothing: of 1 - leverage, and of a correlation of 1
MOST_CELLS = 2**20
SMALLEST_FREEDOM = 1e-300  # of a cell; without any there is no covariance
LARGEST_SUM = 1e250  # of squares of deviations below 1e100; sums of these do not overflow
VANISHING = float(np.finfo(np.float64).tiny / np.finfo(np.float64).eps)  # a variance below it has not all its digits


class VarianceTableError(ValueError):
    """A file is no variance table, was changed since it was saved, or comes from a newer version."""


class Lookup(NamedTuple):
    """Covariances of x and y.

    Attributes:
        covariance: covariances [m^2], shape (..., 2, 2).
        share: how much of each the table gave, from 0 (all is fallback) to 1, shape (...).
    """

    covariance: Floats
    share: Floats


@dataclass(frozen=True, eq=False)
class Contributions:
    """What each flight contributed to each cell that it crossed: one entry a flight and cell.

    Attributes:
        label: season, weather, or what else tells tables apart.
        range_bin: index of the range bin.
        sector: index of the azimuth sector.
        degrees_of_freedom: what the fitted lines leave of the number of plots.
        radial: sum of the squared residuals along the line of sight [m^2].
        mixed: sum of the products of residuals along and across it [m^2].
        transverse: sum of the squared residuals across it [m^2].
    """

    label: NDArray[np.str_]
    range_bin: NDArray[np.int64]
    sector: NDArray[np.int64]
    degrees_of_freedom: Floats
    radial: Floats
    mixed: Floats
    transverse: Floats

    @property
    def columns(self) -> dict[str, NDArray[Any]]:
        """All columns by name."""
        return {field.name: getattr(self, field.name) for field in fields(self)}

    @classmethod
    def none(cls) -> "Contributions":
        """Of no flight at all."""
        whole, real = np.zeros(0, np.int64), np.zeros(0)
        return cls(np.zeros(0, "U1"), whole, whole, real, real, real, real)


class _Totals(NamedTuple):
    """Sums over all flights of one label, shape (ranges, sectors)."""

    degrees_of_freedom: Floats
    radial: Floats
    mixed: Floats
    transverse: Floats


@dataclass(frozen=True, eq=False)
class VarianceTable:
    """Variances of one radar's plots in the plane, by range bin, azimuth sector and label.

    Every flight is a straight course at constant speed. Its x and y are fitted to time by ordinary least
    squares, and the residuals are turned into the direction of each plot, where variances change slowly:
    along the line of sight and across it. A plot counts 1 less its leverage as degrees of freedom, so that
    those of a flight sum to n - 2, and the estimate of a cell is unbiased where the variance is the same
    along the flight. Where it is less than 1e-9, the line goes through the plot whatever its error, and the plot
    counts for nothing.

    Attributes:
        range_edges: edges of the range bins [m], ascending, shape (ranges + 1,).
        sectors: number of equal azimuth sectors, from north clockwise.
        contributions: what the flights gave.

    Raises:
        TypeError: the edges are no real numbers, or the number of sectors is not whole.
        ValueError: the edges do not ascend from 0 or more, there are fewer than two, no sector, more than a million
            cells, or a contribution is impossible.
    """

    range_edges: Floats
    sectors: int
    contributions: Contributions

    def __post_init__(self) -> None:
        ranges = _require_edges(self.range_edges)
        sectors = whole_number("sectors", self.sectors, 1)  # a narrow integer of NumPy would overflow
        object.__setattr__(self, "sectors", sectors)
        object.__setattr__(self, "range_edges", kept(self.range_edges))
        if ranges * sectors > MOST_CELLS:
            given = f"{ranges} range bins by {sectors} sectors"
            raise ValueError(f"range_edges and sectors must make at most {MOST_CELLS} cells; got {given}")
        _require_sound(self.contributions, ranges, self.sectors)

    @classmethod
    def empty(cls, range_edges: ArrayLike, sectors: int) -> "VarianceTable":
        """A table without flights.

        Raises:
            TypeError: the edges are no real numbers, or the number of sectors is not whole.
            ValueError: the edges do not ascend from 0 or more, there are fewer than two, no sector, or more than a
                million cells.
        """
        edges = real_arrays({"range_edges": range_edges})["range_edges"].astype(np.float64)
        return cls(edges, sectors, Contributions.none())

    @property
    def labels(self) -> tuple[str, ...]:
        """The labels of all flights, in alphabetical order."""
        return tuple(np.unique(self.contributions.label).tolist())

    def with_flights(
        self, t: ArrayLike, r: ArrayLike, azimuth: ArrayLike, elevation: ArrayLike = 0.0, *, label: str = ""
    ) -> "VarianceTable":
        """The table with more straight flights; nothing tells whether a flight was given before.

        Args:
            t: times [s], shape (..., n), n at least 3; leading axes run over flights.
            r: slant ranges [m], within the edges of the table.
            azimuth: azimuths [rad], clockwise from north (the y axis).
            elevation: elevations [rad]; 0 for a two-coordinate radar.
            label: to keep seasons, weathers and the like apart.

        Raises:
            TypeError: an argument is not made of real numbers, or the label is no text.
            ValueError: an argument is out of its domain or of the table, shapes do not broadcast, a flight
                has too few plots or its times are all the same, or the label ends in a NUL.
        """
        _require_text(label)
        if label.endswith("\0"):
            raise ValueError(f"label must not end in a NUL, which arrays of text drop; got {label!r}")
        x, y = line.to_plane(r, azimuth, elevation)
        arrays = {"t": t, "r": r, "azimuth": azimuth, "x": x, "y": y}
        flights = {name: array.astype(np.float64, order="C") for name, array in real_arrays(arrays).items()}
        shape = broadcast_shape(flights)
        if not shape or shape[-1] < 3:
            raise ValueError(f"a flight must have at least 3 plots on the last axis; got the shape {shape}")
        rows = {name: np.broadcast_to(a, shape).reshape(-1, shape[-1]) for name, a in flights.items()}
        return self._joined([self.contributions, self._contributions(rows, label)])

    def merged(self, *others: "VarianceTable") -> "VarianceTable":
        """All flights of several tables; the order does not matter.

        Raises:
            TypeError: one is no table.
            ValueError: the tables have different edges or sectors.
        """
        for other in others:
            require_parts("others", other, ("range_edges", "sectors", "contributions"), "each a VarianceTable")
            if other.sectors != self.sectors or not np.array_equal(other.range_edges, self.range_edges):
                raise ValueError(
                    f"tables to merge must have the same cells; got {self.sectors} sectors and range_edges "
                    f"{self.range_edges}, and {other.sectors} and {other.range_edges}"
                )
        return self._joined([self.contributions, *(other.contributions for other in others)])

    def degrees_of_freedom(self, label: str = "") -> Floats:
        """Degrees of freedom of each cell, shape (ranges, sectors)."""
        return self._totals(label).degrees_of_freedom

    def covariance(self, label: str = "") -> Floats:
        """Covariance along and across the line of sight [m^2], shape (ranges, sectors, 2, 2).

        Cells without flights have NaN.
        """
        totals = self._totals(label)
        counts = np.where(totals.degrees_of_freedom > 0, totals.degrees_of_freedom, np.nan)
        entries = np.stack([totals.radial, totals.mixed, totals.mixed, totals.transverse], axis=-1)
        return (entries / counts[..., np.newaxis]).reshape(*counts.shape, 2, 2)

    def lookup(
        self,
        r: ArrayLike,
        azimuth: ArrayLike,
        fallback: ArrayLike,
        *,
        label: str = "",
        minimum_degrees: float = 30.0,
    ) -> Lookup:
        """Covariances of x and y of plots, between the centres of the cells by bilinear interpolation.

        Sectors go round the circle; below the first and beyond the last centre of a range bin its value
        holds. Cells with fewer degrees of freedom than asked for, and ranges outside the table, leave their
        part of the weight to the fallback, for which `fusion.propagated_covariance` computes error
        propagation.

        Args:
            r: slant ranges [m].
            azimuth: azimuths [rad], clockwise from the y axis.
            fallback: covariance of x and y for thin cells [m^2], shape (..., 2, 2).
            label: which part of the table; one without flights leaves all to the fallback.
            minimum_degrees: fewer degrees of freedom make a cell thin; more than 0.

        Raises:
            TypeError: an argument is not made of real numbers, or the label is no text.
            ValueError: an argument is out of its domain, or the shapes do not broadcast.
        """
        least = number_between("minimum_degrees", minimum_degrees, SMALLEST_FREEDOM, math.inf)
        given = real_arrays({"r": r, "azimuth": azimuth, "fallback": fallback})
        arrays = {name: array.astype(np.float64) for name, array in given.items()}
        for name, domain in (("r", RANGE), ("azimuth", ANGLE), ("fallback", VARIANCE)):
            require_within(name, arrays[name], domain)
        spare = arrays.pop("fallback")
        require_trailing_shape("fallback", spare, (2, 2))
        require_covariance("fallback", spare)
        spare = (spare + np.swapaxes(spare, -1, -2)) / 2
        shape = broadcast_shape({**arrays, "fallback": spare[..., 0, 0]})
        ranges, angles = (np.broadcast_to(array, shape) for array in arrays.values())
        table, share = self._interpolated(ranges, angles, label, least)
        return Lookup(_turned(table, angles) + (1 - share)[..., np.newaxis, np.newaxis] * spare, share)

    def save(self, path: str | PathLike[str]) -> None:
        """Write the table as a NumPy archive (NPZ) with its format, version and checksum.

        It is written beside and put in place in one step: whatever happens, at the path is all of the table or
        what was there before.

        Raises:
            OSError: the file system refuses, or at the path is something other than a file.
        """
        columns = self._columns()
        head = {
            "format": np.array(FORMAT),
            "version": np.array(VERSION),
            "digest": np.array(_digest(columns)),
        }
        target = Path(path)
        if target.exists() and not target.is_file():
            number = errno.EISDIR if target.is_dir() else errno.EINVAL
            raise OSError(number, "a table is saved to a file, and this is something else", str(path))
        try:
            replace_file(target, bounded_archive.packed({**head, **columns}))
        except OSError as error:  # which names the file beside
            raise OSError(error.errno, error.strerror, str(path)) from error

    @classmethod
    def load(cls, path: str | PathLike[str]) -> "VarianceTable":
        """Read a table that `save` has written; the file is never evaluated.

        Raises:
            VarianceTableError: the file is something else, damaged, changed, or of a newer version.
            OSError: it cannot be read.
        """
        columns = _read(Path(path))
        edges, sectors = columns.pop("range_edges"), columns.pop("sectors")
        freedom = columns["degrees_of_freedom"]
        # Earlier versions kept the rounding error of 1 - leverage where that is 0.
        columns["degrees_of_freedom"] = np.where(np.abs(freedom) < ROUNDING, 0.0, freedom)
        try:
            return cls(edges, int(sectors), Contributions(**columns))
        except (TypeError, ValueError) as error:
            raise VarianceTableError(f"{path} holds no sound variance table: {error}") from error

    def _columns(self) -> dict[str, NDArray[Any]]:
        return {
            "range_edges": self.range_edges,
            "sectors": np.array(self.sectors, np.int64),
            **self.contributions.columns,
        }

    def _joined(self, parts: list[Contributions]) -> "VarianceTable":
        """One table, its entries in an order that does not depend on that of the parts."""
        columns = {name: np.concatenate([part.columns[name] for part in parts]) for name in parts[0].columns}
        order = np.lexsort(list(reversed(columns.values())))
        joined = Contributions(**{name: column[order] for name, column in columns.items()})
        return VarianceTable(self.range_edges, self.sectors, joined)

    def _contributions(self, rows: Columns, label: str) -> Contributions:
        """Residuals of each flight, gathered by the cells that it crosses."""
        t, azimuth = rows["t"], rows["azimuth"]
        fits = [line.fit(t, rows[name]) for name in "xy"]
        if not np.all(fits[0].converged):
            raise ValueError("t must differ within a flight; got a flight with identical times")
        east, north = (fit.residual(t, rows[name]) for fit, name in zip(fits, "xy", strict=True))
        radial = east * np.sin(azimuth) + north * np.cos(azimuth)
        transverse = east * np.cos(azimuth) - north * np.sin(azimuth)
        cells = self._range_bin(rows["r"]) * self.sectors + self._sector(azimuth)
        flight = np.arange(len(t))[:, np.newaxis] * (self.range_edges.size - 1) * self.sectors
        keys, place = np.unique(flight + cells, return_inverse=True)

        def gathered(values: Floats) -> Floats:
            return np.bincount(place.ravel(), values.ravel(), minlength=keys.size).astype(np.float64)

        cell = keys % ((self.range_edges.size - 1) * self.sectors)
        freedom = 1 - _leverage(t)
        tells = freedom > ROUNDING
        squares = [gathered(np.where(tells, radial * radial, 0.0)), gathered(np.where(tells, transverse**2, 0.0))]
        return Contributions(
            np.full(keys.size, label),
            cell // self.sectors,
            cell % self.sectors,
            gathered(np.where(tells, freedom, 0.0)),
            squares[0],
            line.bounded_product(gathered(np.where(tells, radial * transverse, 0.0)), *squares),
            squares[1],
        )

    def _range_bin(self, r: Floats) -> NDArray[np.int64]:
        edges = self.range_edges
        if not np.all((r >= edges[0]) & (r <= edges[-1])):
            raise ValueError(
                f"r must be within the table, from {edges[0]:g} to {edges[-1]:g} m; got {r.min():g} to {r.max():g}"
            )
        return np.minimum(np.searchsorted(edges, r, side="right") - 1, edges.size - 2).astype(np.int64)

    def _sector(self, azimuth: Floats) -> NDArray[np.int64]:
        return np.floor(azimuth / (2 * np.pi) * self.sectors).astype(np.int64) % self.sectors

    @cached_property
    def _by_label(self) -> dict[str, _Totals]:
        parts = self.contributions
        return {label: self._summed(np.flatnonzero(parts.label == label)) for label in self.labels}

    def _totals(self, label: str) -> _Totals:
        _require_text(label)
        empty = np.zeros((self.range_edges.size - 1, self.sectors))
        return self._by_label.get(label, _Totals(empty, empty, empty, empty))

    def _summed(self, chosen: NDArray[np.intp]) -> _Totals:
        parts = self.contributions
        shape = self.range_edges.size - 1, self.sectors
        cells = parts.range_bin[chosen] * self.sectors + parts.sector[chosen]
        columns = (parts.degrees_of_freedom, parts.radial, parts.mixed, parts.transverse)
        sums = (np.bincount(cells, column[chosen], minlength=math.prod(shape)) for column in columns)
        freedom, radial, mixed, transverse = (total.reshape(shape).astype(np.float64) for total in sums)
        return _Totals(freedom, radial, line.bounded_product(mixed, radial, transverse), transverse)

    def _interpolated(self, r: Floats, azimuth: Floats, label: str, minimum_degrees: float) -> tuple[Floats, Floats]:
        """Weighted sum over the cells around each plot that are not thin, and the sum of the weights."""
        thin = self.degrees_of_freedom(label) < minimum_degrees
        cells = np.where(thin[..., np.newaxis, np.newaxis], 0.0, self.covariance(label))
        inside = (r >= self.range_edges[0]) & (r <= self.range_edges[-1])
        total, share = np.zeros((*r.shape, 2, 2)), np.zeros(r.shape)
        for i, by_range in self._neighbours_in_range(r):
            for j, by_azimuth in self._neighbours_in_azimuth(azimuth):
                weight = np.where(inside & ~thin[i, j], by_range * by_azimuth, 0.0)
                total += weight[..., np.newaxis, np.newaxis] * cells[i, j]
                share += weight
        return total, np.minimum(share, 1.0)

    def _neighbours_in_range(self, r: Floats) -> list[tuple[NDArray[np.intp], Floats]]:
        centres = _centres(self.range_edges)
        place = np.interp(r, centres, np.arange(centres.size, dtype=np.float64))
        below = np.floor(place).astype(np.intp)
        above = np.minimum(below + 1, centres.size - 1)
        return [(below, 1 - (place - below)), (above, place - below)]

    def _neighbours_in_azimuth(self, azimuth: Floats) -> list[tuple[NDArray[np.intp], Floats]]:
        place = azimuth / (2 * np.pi) * self.sectors - 0.5
        before = np.floor(place)
        index = before.astype(np.intp) % self.sectors
        return [(index, 1 - (place - before)), ((index + 1) % self.sectors, place - before)]


def _require_text(label: object) -> None:
    if not isinstance(label, str):
        raise TypeError(f"label must be text; got {label!r}")


_COLUMNS = ("range_edges", "sectors", *(field.name for field in fields(Contributions)))
_KINDS = {"sectors": "i8", "label": "U", "range_bin": "i8", "sector": "i8"}


def _leverage(t: Floats) -> Floats:
    elapsed = t - t[..., :1]
    elapsed = elapsed / np.abs(elapsed).max(axis=-1, keepdims=True)
    mean = elapsed.mean(axis=-1, keepdims=True)
    spread = np.sum((elapsed - mean) ** 2, axis=-1, keepdims=True)
    leverage = formulas.ordinary_leverage(t=elapsed, mean_t=mean, n=t.shape[-1], S_tt=spread)
    return leverage.astype(np.float64)


def _turned(local: Floats, azimuth: Floats) -> Floats:
    """Covariances along and across the line of sight as those of x and y.

    What is turned is a root of them, so that rounding leaves them symmetric and positive semidefinite; a variance that
    underflows is 0, and its covariance with it.
    """
    sine, cosine = np.sin(azimuth), np.cos(azimuth)
    along = np.sqrt(local[..., 0, 0])
    mixed = local[..., 0, 1] / np.where(along > 0, along, 1.0)
    across = np.sqrt(np.maximum(local[..., 1, 1] - mixed**2, 0.0))
    x = sine * along + cosine * mixed, cosine * across
    y = cosine * along - sine * mixed, -sine * across
    entries = [a[0] * b[0] + a[1] * b[1] for a, b in ((x, x), (x, y), (y, x), (y, y))]
    bound = np.sqrt(entries[0]) * np.sqrt(entries[3])  # which the covariance passes where a variance loses its digits
    vanishing = np.minimum(entries[0], entries[3]) < VANISHING
    entries[1:3] = [np.where(vanishing, np.clip(one, -bound, bound), one) for one in entries[1:3]]
    stacked: Floats = np.stack(entries, axis=-1).reshape(*azimuth.shape, 2, 2).astype(np.float64, copy=False)
    return stacked


def _digest(columns: Columns) -> str:
    """A checksum of names, shapes and bytes, against accidents and careless edits."""
    total = hashlib.sha256()
    for name in _COLUMNS:
        values = columns[name]
        total.update(f"{name} {values.dtype.str} {values.shape};".encode())
        total.update(np.ascontiguousarray(values).tobytes())
    return total.hexdigest()


def _read(path: Path) -> dict[str, NDArray[Any]]:
    """The columns of a table of this version, with a checksum that fits."""
    try:
        with path.open("rb") as file:
            stored = bounded_archive.unpacked(file)
        return _table(path, stored)
    except ArchiveError as error:
        raise VarianceTableError(f"{path} is no variance table: {error}") from error


def _table(path: Path, stored: Mapping[str, Stored]) -> dict[str, NDArray[Any]]:
    if "format" not in stored or "version" not in stored or str(_column(stored, "format", "U", 0)) != FORMAT:
        raise VarianceTableError(f"{path} is no variance table: it does not say so")
    version = stored["version"]
    if version.descr != "<i8" or version.shape or not 1 <= version.values() <= VERSION:
        raise VarianceTableError(f"{path} has another format version; this version of radartrack reads up to {VERSION}")
    missing = {*_COLUMNS, "digest"} - stored.keys()
    if missing:
        raise VarianceTableError(f"{path} is no variance table: it lacks {', '.join(sorted(missing))}")
    columns = {name: _column(stored, name, _KINDS.get(name, "f8"), int(name != "sectors")) for name in _COLUMNS}
    if str(_column(stored, "digest", "U", 0)) != _digest(columns):
        raise VarianceTableError(f"{path} was changed or damaged since it was saved: the checksum does not fit")
    return columns


def _column(stored: Mapping[str, Stored], name: str, kind: str, dimensions: int) -> NDArray[Any]:
    """One array, which must be of a type and have so many axes."""
    column = stored[name]
    if not column.descr.startswith(f"<{kind}") or len(column.shape) != dimensions:
        raise ArchiveError(f"the column {name} has dtype {column.descr} and shape {column.shape}")
    return column.values()


def _require_edges(edges: Floats) -> int:
    """Check the edges of the range bins, and count the bins.

    Raises:
        TypeError: they are no array of float64.
        ValueError: they do not ascend from 0 or more, nor do their centres, or there are fewer than two.
    """
    if getattr(edges, "dtype", None) != np.float64:
        raise TypeError(f"range_edges must be an array of float64; got {edges!r}")
    require_within("range_edges", edges, RANGE)
    if edges.ndim != 1 or edges.size < 2 or not np.all(np.diff(edges) > 0):
        raise ValueError(f"range_edges must be two or more ascending ranges; got {edges}")
    if not np.all(np.diff(_centres(edges)) > 0):
        raise ValueError(f"range_edges must be further apart, for the bins to have centres; got {edges}")
    return edges.size - 1


def _centres(edges: Floats) -> Floats:
    return (edges[:-1] + edges[1:]) / 2


def _require_sound(parts: Contributions, ranges: int, sectors: int) -> None:
    """Check that contributions are what flights can have given.

    Raises:
        ValueError: a column has the wrong type or shape, or an entry is impossible.
    """
    for name, column in parts.columns.items():
        typed = column.dtype.str.startswith(f"<{_KINDS.get(name, 'f8')}")
        if not typed or column.shape != parts.label.shape or column.ndim != 1:
            raise ValueError(f"the column {name} has dtype {column.dtype} and shape {column.shape}")
    for name, column, below in (("range_bin", parts.range_bin, ranges), ("sector", parts.sector, sectors)):
        if not np.all((column >= 0) & (column < below)):
            raise ValueError(f"{name} must be from 0 to {below - 1}")
    sums = (parts.degrees_of_freedom, parts.radial, parts.transverse)
    if not all(np.all((column >= 0) & (column <= LARGEST_SUM)) for column in sums):
        raise ValueError(f"degrees of freedom and sums of squares must be finite (to {LARGEST_SUM:g}) and not negative")
    if np.any((parts.degrees_of_freedom > 0) & (parts.degrees_of_freedom < ROUNDING)):
        raise ValueError(f"degrees of freedom must be 0, or at least {ROUNDING:g}")
    if not np.all(np.abs(parts.mixed) <= np.sqrt(parts.radial) * np.sqrt(parts.transverse) * (1 + ROUNDING)):
        raise ValueError("a mixed sum must not exceed the geometric mean of both sums of squares")
