"""The functions of Python, C, C++ and MATLAB in terms of those that formulas have."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from math import prod
from types import MappingProxyType
from typing import TypeAlias

from radartrack.derive.formula.error import FormulaError, Span
from radartrack.derive.formula.functions import NUMBER_OF_ARGUMENTS, SPELLINGS, VERBS
from radartrack.derive.formula.tree import Array, Number, Tree, children
from radartrack.derive.formula.unknown_names import unknown_function
from radartrack.derive.formula.written_out import ZERO, kronecker
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.reading.code.array_entries import joined
from radartrack.derive.reading.code.workspace import MAX_ROWS, Value, Workspace

Maker: TypeAlias = Callable[[Workspace, Sequence[Value], Span], Value]

_SAME = MappingProxyType(
    {
        **SPELLINGS,
        "absolute": "abs",
        "fabs": "abs",
        "chi2cdf": "chi2cdf",
        "chi2inv": "chi2inv",
        "det": "det",
        "determinant": "det",
        "expm": "expm",
        "inv": "inv",
        "inverse": "inv",
        "outer": "outer",
        "trace": "trace",
        "transpose": "transpose",
    }
)


def applied(space: Workspace, function: str, arguments: Sequence[Value], span: Span) -> Value:
    """A function of code, applied.

    Args:
        space: where it is called.
        function: its name, without module or namespace.
        arguments: their values.
        span: where.

    Raises:
        FormulaError: for a function that formulas do not have, and for too many or too few arguments.
    """
    name = _plain(function)
    if name in _MADE:
        fewest, most, maker = _MADE[name]
        _check_number(function, len(arguments), fewest, most, span)
        return maker(space, arguments, span)
    if name not in _SAME:
        raise FormulaError(unknown_function(function), span=span)
    own = _SAME[name]
    needed = NUMBER_OF_ARGUMENTS.get(own)
    fewest, most = (needed, needed) if needed else VERBS[own]
    _check_number(function, len(arguments), fewest, most, span)
    return space.call(own, arguments, span)


def is_function(function: str) -> bool:
    """Whether code calls a function by this name, which else is an array."""
    return _plain(function) in {*_MADE, *_SAME}


SEVERAL = frozenset({"cart2pol", "cart2sph", "pol2cart", "sph2cart"})


def changed_coordinates(space: Workspace, function: str, arguments: Sequence[Value], span: Span) -> list[Value]:
    """What MATLAB's functions between coordinates return; azimuth and elevation come first, the range last.

    Raises:
        FormulaError: for another number of arguments.
    """
    flat = function in {"cart2pol", "pol2cart"}
    _check_number(function, len(arguments), 2 if flat else 3, 3, span)
    if function in {"pol2cart", "sph2cart"}:
        return _to_cartesian(space, arguments, span, flat=flat)
    x, y, *z = arguments
    ground = space.call("hypot", [x, y], span)
    azimuth = space.call("atan2", [y, x], span)
    if flat:
        return [azimuth, ground, *z]
    elevation = space.call("atan2", [z[0], ground], span)
    return [azimuth, elevation, space.call("hypot", [ground, z[0]], span)]


def _to_cartesian(space: Workspace, arguments: Sequence[Value], span: Span, *, flat: bool) -> list[Value]:
    azimuth, *others = arguments
    if flat:
        ground, *z = others
    else:
        elevation, distance = others
        ground = space.product([distance, space.call("cos", [elevation], span)], span)
        z = [space.product([distance, space.call("sin", [elevation], span)], span)]
    turned = [space.product([ground, space.call(one, [azimuth], span)], span) for one in ("cos", "sin")]
    return [*turned, *z]


def _plain(function: str) -> str:
    """The name without the suffix of a type: sinf, sinl."""
    for suffix in ("f", "l"):
        shorter = function.removesuffix(suffix)
        if function not in _MADE and function not in _SAME and (shorter in _MADE or shorter in _SAME):
            return shorter
    return function


def _check_number(function: str, given: int, fewest: int, most: int, span: Span) -> None:
    if not fewest <= given <= most:
        wanted = str(fewest) if fewest == most else f"{fewest} to {most}"
        plural = "" if wanted == "1" else "s"
        raise FormulaError(f"{function} takes {wanted} argument{plural}, here it has {given}", span=span)


def _itself(_space: Workspace, arguments: Sequence[Value], _span: Span) -> Value:
    return Value(arguments[0].tree, arguments[0].shape, size=arguments[0].size)


def _matrix(space: Workspace, arguments: Sequence[Value], _span: Span) -> Value:
    space.has_matrices = True
    return Value(arguments[0].tree, arguments[0].shape, size=arguments[0].size, is_matrix=True)


def _summed(space: Workspace, arguments: Sequence[Value], span: Span) -> Value:
    """The sum of the entries of a vector; a matrix is summed along an axis in MATLAB, and is not read."""
    entries = space.opened(arguments[0], span)
    if len(entries.shape) != 1:
        raise FormulaError("sum takes a vector whose entries are known", span=span)
    terms = [Value(entry, size=arguments[0].size) for entry in entries]
    return space.sum(terms, span) if len(terms) > 1 else terms[0]


def _power(space: Workspace, arguments: Sequence[Value], span: Span) -> Value:
    return space.power(arguments[0], arguments[1], span, of_entries=True)


def _raised(exponent: str) -> Maker:
    return lambda space, arguments, span: space.power(arguments[0], space.number(exponent, span), span, of_entries=True)


def _reciprocal(space: Workspace, arguments: Sequence[Value], span: Span) -> Value:
    return space.quotient(space.number("1", span), arguments[0], span)


def _logarithm(base: str) -> Maker:
    def made(space: Workspace, arguments: Sequence[Value], span: Span) -> Value:
        below = space.call("log", [space.number(base, span)], span)
        return space.quotient(space.call("log", arguments, span), below, span)

    return made


def _of_one_more(space: Workspace, arguments: Sequence[Value], span: Span) -> Value:
    return space.call("log", [space.sum([space.number("1", span), *arguments], span)], span)


def _cube_root(space: Workspace, arguments: Sequence[Value], span: Span) -> Value:
    third = space.quotient(space.number("1", span), space.number("3", span), span)
    return space.power(arguments[0], third, span)


def _scaled(space: Workspace, value: Value, above: str, below: str, span: Span) -> Value:
    """A value times pi/180, or 180/pi."""
    parts = {name: space.constant("pi", span) if name == "pi" else space.number(name, span) for name in (above, below)}
    return space.quotient(space.product([value, parts[above]], span), parts[below], span)


def _radians(space: Workspace, arguments: Sequence[Value], span: Span) -> Value:
    return _scaled(space, arguments[0], "pi", "180", span)


def _degrees(space: Workspace, arguments: Sequence[Value], span: Span) -> Value:
    return _scaled(space, arguments[0], "180", "pi", span)


def _of_degrees(function: str) -> Maker:
    return lambda space, arguments, span: space.call(function, [_radians(space, arguments, span)], span)


def _in_degrees(function: str) -> Maker:
    return lambda space, arguments, span: _degrees(space, [space.call(function, arguments, span)], span)


def _norm(space: Workspace, arguments: Sequence[Value], span: Span) -> Value:
    """The root of a sum of squares, of a vector that is written out."""
    array = arguments[0]
    if not isinstance(array.tree, Array) or array.shape is None or len(array.shape) != 1:
        raise FormulaError("norm takes a vector whose entries are known: write the root of the squares", span=span)
    entries = [Value(entry, size=array.size) for entry in children(array.tree)]
    squares = [space.power(entry, space.number("2", span), span) for entry in entries]
    return space.call("sqrt", [space.sum(squares, span) if len(squares) > 1 else squares[0]], span)


def _product(space: Workspace, arguments: Sequence[Value], span: Span) -> Value:
    """Of two vectors the scalar product; of a vector before a matrix, in NumPy, a vector."""
    shapes = [space.sized(one).shape or () for one in arguments]
    is_row = space.language == "Python" and len(shapes[1]) > 1 and not any(one.is_matrix for one in arguments)
    if len(shapes[0]) == 1 and (len(shapes[1]) == 1 or is_row):
        product = space.product([space.call("transpose", arguments[:1], span), *arguments[1:]], span)
        return space.picked(product, [space.first], span)
    return space.product(arguments, span)


def _unit(space: Workspace, arguments: Sequence[Value], span: Span) -> Value:
    return space.call("eye", arguments[:1], span)


def _vector(space: Workspace, arguments: Sequence[Value], span: Span) -> Value:
    return space.array(arguments, span)


def _diagonal(space: Workspace, arguments: Sequence[Value], span: Span) -> Value:
    return space.call("diag", arguments, span)


def _blocks(space: Workspace, arguments: Sequence[Value], span: Span) -> Value:
    """Matrices along the diagonal."""
    matrices = [space.opened(one, span) for one in arguments]
    if any(len(one.shape) != len(("rows", "columns")) for one in matrices):
        raise FormulaError("blocks along a diagonal are matrices", span=span)
    blocks = [
        [one if row == column else _of_zeros(one.shape[0], other.shape[1]) for column, other in enumerate(matrices)]
        for row, one in enumerate(matrices)
    ]
    return of_blocks(space, blocks, arguments, span)


def _of_zeros(*shape: int) -> Tensor[Tree]:
    return Tensor(shape, (ZERO,) * prod(shape))


def of_blocks(space: Workspace, blocks: Sequence[Sequence[Tensor[Tree]]], parts: Sequence[Value], span: Span) -> Value:
    """The matrix that rows of blocks make.

    Raises:
        FormulaError: where they do not fit.
    """
    found = joined(blocks)
    if found is None or max(found.shape) > MAX_ROWS:
        raise FormulaError(f"these blocks make no matrix of at most {MAX_ROWS} rows and columns", span=span)
    return space.of_entries(found, parts)


def _kronecker(space: Workspace, arguments: Sequence[Value], span: Span) -> Value:
    """A matrix with the second one, times its entry, for each entry of the first."""
    first, second = (space.opened(one, span) for one in arguments)
    if not len(first.shape) == len(second.shape) == len(("rows", "columns")):
        raise FormulaError("kron takes two matrices", span=span)
    return of_blocks(space, [[kronecker([first, second])]], arguments, span)


def _zeros(space: Workspace, arguments: Sequence[Value], span: Span) -> Value:
    sizes = [part for one in arguments for part in (children(one.tree) if isinstance(one.tree, Array) else [one.tree])]
    if not all(isinstance(size, Number) and size.text.isdigit() and len(size.text) < 4 for size in sizes):
        raise FormulaError("the size of an array is written as whole numbers", span=span)
    shape = tuple(int(size.text) for size in sizes if isinstance(size, Number))
    is_square = space.language == "MATLAB" and len(shape) == 1
    return space.zeros(shape * 2 if is_square else tuple(size for size in shape if size > 1) or (1,), span)


_MADE: Mapping[str, tuple[int, int, Maker]] = MappingProxyType(
    {
        **dict.fromkeys(("pow", "power", "float_power"), (2, 2, _power)),
        **dict.fromkeys(("array", "asarray", "copy", "float", "double", "float64", "single"), (1, 2, _itself)),
        **dict.fromkeys(("matrix", "mat", "Matrix"), (1, 2, _matrix)),
        **dict.fromkeys(("radians", "deg2rad"), (1, 1, _radians)),
        **dict.fromkeys(("degrees", "rad2deg"), (1, 1, _degrees)),
        **dict.fromkeys(("dot", "matmul", "mtimes"), (2, 2, _product)),
        **dict.fromkeys(("eye", "identity", "Identity"), (1, 2, _unit)),
        **dict.fromkeys(("block_diag", "blkdiag"), (1, 12, _blocks)),
        "kron": (2, 2, _kronecker),
        **dict.fromkeys(("zeros", "zeros_like", "Zero", "empty"), (1, 2, _zeros)),
        **{f"{name}d": (1, 1, _of_degrees(name)) for name in ("sin", "cos", "tan", "sec", "csc", "cot")},
        **{f"{name}d": (1, 1, _in_degrees(name)) for name in ("asin", "acos", "atan")},
        **{f"Vector{size}{kind}": (size, size, _vector) for size in (2, 3, 4) for kind in "df"},
        "asDiagonal": (1, 1, _diagonal),
        "atan2d": (2, 2, _in_degrees("atan2")),
        "cbrt": (1, 1, _cube_root),
        "diag": (1, 12, _diagonal),
        "log10": (1, 1, _logarithm("10")),
        "log2": (1, 1, _logarithm("2")),
        "log1p": (1, 1, _of_one_more),
        "norm": (1, 1, _norm),
        "reciprocal": (1, 1, _reciprocal),
        "sum": (1, 1, _summed),
        "square": (1, 1, _raised("2")),
    }
)
