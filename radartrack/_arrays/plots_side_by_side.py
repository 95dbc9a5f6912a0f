"""The loops over plots as machine code that computes several plots at once: loaded where Numba is.

A compiler does so where it sees that no result is read as an argument, and where nothing branches. So plots are copied
into columns of its own, some at a time, which stay in the nearest cache, while memory is asked for the next ones. In
place of `math` stand the generated elementary functions, whose two primitives become a selection and the bits of a
number. They are compiled without leave to reorder or to fuse operations, so results have the same bits on every
processor.
"""

import math
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import cache
from hashlib import sha256
from inspect import getsource
from types import FunctionType, MappingProxyType, ModuleType
from typing import Any

import llvmlite.binding
import numba
import numpy as np
from llvmlite import ir
from numba.extending import intrinsic

from radartrack._arrays.validation import RealArray
from radartrack.generated import elementary

PLOTS = 16  # at a time, two vectors of AVX-512; of more, memory is asked for too many lines at once
AHEAD = 64  # plots; as many take longer than memory does
LINE = 8  # numbers that come together from memory
CHAINS = 2  # with four, registers run out: AVX2 has 16
INTERLEAVE, NEWEST_LLVM = "-force-vector-interleave", 22  # tried from 15
ELEMENTARY = ("sin_and_cos", "sin", "cos", "exp", "expm1")  # in the order in which they call each other
_NJIT: Any = numba.njit
_TYPES: Any = numba.types
INLINED = {"forceinline": True, "error_model": "numpy"}
TO_WHOLE, MANTISSA, ONE = 1.5 * 2.0**52, 52, 0x3FF << 52
Fill = Callable[[tuple[RealArray, ...], RealArray, RealArray, RealArray], tuple[bool, bool]]


@intrinsic
def _chosen(_context: Any, condition: Any, first: Any, second: Any) -> Any:
    """`elementary.chosen` as a selection: of an `if` a compiler makes a branch, and computes one side."""
    del condition, first, second

    def generate(_: Any, builder: Any, __: Any, values: Sequence[Any]) -> Any:
        return builder.select(*values)

    return numba.float64(numba.boolean, numba.float64, numba.float64), generate


@intrinsic
def _power_of_two(_context: Any, exponent: Any) -> Any:
    """`elementary.power_of_two` from -1022 to 1023, by its bits: they are read off a sum whose last digit is one."""
    del exponent

    def generate(_: Any, builder: Any, __: Any, values: Sequence[Any]) -> Any:
        whole = ir.IntType(64)
        shifted = builder.fadd(values[0], ir.Constant(ir.DoubleType(), TO_WHOLE))
        bits = builder.shl(builder.bitcast(shifted, whole), ir.Constant(whole, MANTISSA))
        return builder.bitcast(builder.add(bits, ir.Constant(whole, ONE)), ir.DoubleType())

    return numba.float64(numba.float64), generate


def _fetching(*, to_be_written: bool) -> Any:
    """Lets the line of memory come that holds an element of an array, or would beyond its end; nothing waits for it.

    Without it a processor waits: it asks ahead by itself only of what is read without a pause.
    """

    def generate(context: Any, builder: Any, signature: Any, values: Sequence[Any]) -> Any:
        array, place = values
        first = context.make_array(signature.args[0])(context, builder, array).data
        address = builder.bitcast(builder.gep(first, [place]), ir.IntType(8).as_pointer())
        word = ir.IntType(32)
        kind = ir.FunctionType(ir.VoidType(), [address.type, word, word, word])
        fetch = builder.module.declare_intrinsic("llvm.prefetch", (address.type,), kind)
        builder.call(fetch, [address, *(ir.Constant(word, flag) for flag in (int(to_be_written), 3, 1))])
        return context.get_dummy_value()

    def typed(_context: Any, array: Any, place: Any) -> Any:
        del place
        return numba.void(array, numba.int64), generate

    return intrinsic(typed)


_fetch_to_read, _fetch_to_write = _fetching(to_be_written=False), _fetching(to_be_written=True)


def compiled(loop: Callable[..., None], inputs: int, coordinates: int, **options: Any) -> Fill:
    """A conversion of columns between limits, which fills means and covariances.

    It says whether no mean is NaN, and whether all that it was given lies between the limits, shape (inputs, 2).

    Args:
        loop: of `radartrack.generated.loops`.
        inputs: how many arrays it is given.
        coordinates: that a mean has.
        options: of Numba.

    """
    functions = ModuleType("math")
    vars(functions).update({**vars(math), **elementary_functions()})
    loop_inlined = _NJIT(**INLINED)(_with(loop, {"math": functions}))
    fetch_inlined, take_inlined, put_inlined = (
        _NJIT(**INLINED)(_with(part, {"COORDINATES": coordinates})) for part in (_fetch, _take, _put)
    )
    parts = {"LOOP": loop_inlined, "FETCH": fetch_inlined, "TAKE": take_inlined, "PUT": put_inlined}
    filling = _with(_fill, {**parts, "COORDINATES": coordinates})
    filling.__qualname__ = f"{loop.__name__}_{_digest(loop)}"  # by which Numba finds what it kept
    readable = _TYPES.Array(numba.float64, 1, "C", readonly=True)
    limits = _TYPES.Array(numba.float64, 2, "C", readonly=True)
    outputs = (numba.float64[:, ::1], numba.float64[:, :, ::1])
    found: Any = _NJIT(**options)(filling)
    with interleaved(CHAINS):
        found.compile((_TYPES.UniTuple(readable, inputs), limits, *outputs))
    found.disable_compile()
    fill: Fill = found
    return fill


@contextmanager
def interleaved(chains: int) -> Iterator[None]:
    """What is compiled inside computes so many vectors of plots at once, which changes no bit.

    A plot is one long chain of operations that wait for each other, and a processor does not look far enough ahead to
    begin the next one meanwhile. LLVM has a word for that in a loop's metadata, which Numba does not write, and this
    option, which is the process's, so it is taken back; an LLVM that does not know it would end the process.
    """
    known = llvmlite.binding.llvm_version_info[0] <= NEWEST_LLVM
    if known:
        llvmlite.binding.set_option("", f"{INTERLEAVE}={chains}")
    try:
        yield
    finally:
        if known:
            llvmlite.binding.set_option("", f"{INTERLEAVE}=0")


@cache
def elementary_functions() -> Mapping[str, Any]:
    """Those of the generated module, for code that Numba compiles; each is compiled once."""
    ours: dict[str, Any] = {"chosen": _chosen, "power_of_two": _power_of_two}
    for name in ELEMENTARY:
        ours[name] = _NJIT(**INLINED)(_with(getattr(elementary, name), ours))
    return MappingProxyType({name: ours[name] for name in ELEMENTARY})


def _with(function: Callable[..., Any], names: dict[str, Any]) -> FunctionType:
    """A function with other things under some of its global names."""
    return FunctionType(function.__code__, function.__globals__ | names, function.__name__)


def _digest(loop: Callable[..., None]) -> str:
    """Of all that is compiled: Numba itself looks at the file of one function only."""
    texts = [getsource(loop), getsource(elementary), getsource(sys.modules[__name__])]
    return sha256("".join([str(PLOTS), *texts]).encode()).hexdigest()[:16]


LOOP: Any = None  # of one conversion, as is the number of coordinates
FETCH: Any = None  # `_fetch`, compiled, as are the next two
TAKE: Any = None
PUT: Any = None
COORDINATES = 0


def _fill(
    inputs: tuple[RealArray, ...], limits: RealArray, mean: RealArray, covariance: RealArray
) -> tuple[bool, bool]:
    """The columns have sizes that are known to the compiler, so it sees that they do not overlap.

    Behind the last plots of all, columns still hold earlier ones, which do no harm.
    """
    given = np.empty((len(inputs), PLOTS))
    means, covariances = np.empty((COORDINATES, PLOTS)), np.empty((COORDINATES, COORDINATES, PLOTS))
    flat = mean.reshape(-1), covariance.reshape(-1)
    strange = outside = 0
    for n in range(len(inputs) if len(mean) else 0):
        given[n] = inputs[n][0]
    for start in range(0, len(mean), PLOTS):
        count = min(PLOTS, len(mean) - start)
        FETCH(inputs, start + AHEAD, *flat)
        if count == PLOTS:
            TAKE(inputs, start, PLOTS, given)
        else:
            TAKE(inputs, start, count, given)
        LOOP(given, means.T, covariances.T)
        for i in range(PLOTS):
            for n in range(len(inputs)):
                outside += not ((given[n, i] >= limits[n, 0]) & (given[n, i] <= limits[n, 1]))  # `and` would branch
            for a in range(COORDINATES):
                strange += means[a, i] != means[a, i]
        if count == PLOTS:
            PUT(means, covariances, start, PLOTS, *flat)
        else:
            PUT(means, covariances, start, count, *flat)
    return strange == 0, outside == 0


def _fetch(inputs: tuple[RealArray, ...], start: int, mean: RealArray, covariance: RealArray) -> None:
    """What will be read and written of plots from there on, by its place: of each view a reference would be counted."""
    for n in range(len(inputs)):
        column = inputs[n]
        if len(column) > 1:
            for place in range(0, PLOTS, LINE):
                _fetch_to_read(column, start + place)
    for place in range(0, COORDINATES * PLOTS, LINE):
        _fetch_to_write(mean, COORDINATES * start + place)
    for place in range(0, COORDINATES**2 * PLOTS, LINE):
        _fetch_to_write(covariance, COORDINATES**2 * start + place)


def _take(inputs: tuple[RealArray, ...], start: int, count: int, given: RealArray) -> None:
    """Column by column; for a number of plots that it knows, a compiler copies several at once."""
    for n in range(len(inputs)):
        column = inputs[n]
        if len(column) > 1:
            for i in range(count):
                given[n, i] = column[start + i]


def _put(
    means: RealArray, covariances: RealArray, start: int, count: int, mean: RealArray, covariance: RealArray
) -> None:
    """Plot by plot: in one dimension, and for a number of plots that it knows, a compiler shuffles several at once."""
    for i in range(count):
        for a in range(COORDINATES):
            mean[COORDINATES * (start + i) + a] = means[a, i]
    for i in range(count):
        for a in range(COORDINATES):
            for b in range(COORDINATES):
                covariance[COORDINATES * (COORDINATES * (start + i) + a) + b] = covariances[b, a, i]
