"""What the grammars of text and LaTeX share: each rule that is recognised becomes a node of the tree."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import TypeAlias

from lark import Token, Transformer

from radartrack.derive.formula.error import FormulaError, Span
from radartrack.derive.formula.fold import Fold, shared
from radartrack.derive.formula.functions import BINDING, NUMBER_OF_ARGUMENTS, VERBS
from radartrack.derive.formula.limits import check_number, check_size
from radartrack.derive.formula.magnitude import Measure, magnitudes
from radartrack.derive.formula.shape import NO_SHAPES, Shape, shape
from radartrack.derive.formula.tree import (
    Array,
    Call,
    Entries,
    Name,
    Negation,
    Number,
    Place,
    Power,
    Product,
    Quotient,
    Sum,
    Tree,
    children,
    has_verbs,
    with_span,
)
from radartrack.derive.reading.vectors import with_numbers

Part: TypeAlias = Token | Tree


class TreeBuilder(Transformer[Token, Tree]):
    """Makes nodes while the parser runs, so that nothing recurses; the methods are named as the rules."""

    def number(self, parts: Sequence[Token]) -> Tree:
        """A number as printed."""
        check_number(parts[0], place(parts))
        return Number(str(parts[0]), span=place(parts))

    def name(self, parts: Sequence[Token]) -> Tree:
        """A symbol."""
        return Name(str(parts[0]), span=place(parts))

    def bracketed(self, parts: Sequence[Part]) -> Tree:
        """Something in brackets: itself, said to stand where the brackets do."""
        (inner,) = trees(parts)
        return with_span(inner, place(parts))

    def absolute(self, parts: Sequence[Part]) -> Tree:
        """Something between bars: the length of a vector, the magnitude of a number."""
        return Call("norm", tuple(trees(parts)), span=place(parts))

    def signed(self, parts: Sequence[Part]) -> Tree:
        """Something after a sign."""
        (operand,) = trees(parts)
        return operand if parts[0] == "+" else Negation(operand, span=place(parts))

    def sum(self, parts: Sequence[Part]) -> Tree:
        """Terms between signs."""
        terms: list[Tree] = []
        sign: Token | None = None
        for part in parts:
            if isinstance(part, Token):
                sign = part
                continue
            terms.append(self.signed([sign, part]) if sign else part)
        return Sum(tuple(terms), span=place(parts))

    def product(self, parts: Sequence[Part]) -> Tree:
        """Factors, or factors and divisors from left to right: a*b/c*d is ((a*b)/c)*d."""
        factors: list[Tree] = []
        divides = False
        for part in parts:
            if isinstance(part, Token):
                divides = part == "/"
            elif divides:
                factors = [_quotient(_product(factors), part)]
                divides = False
            else:
                factors.append(part)
        return _product(factors)

    def power(self, parts: Sequence[Part]) -> Tree:
        """A base and an exponent."""
        base, exponent = trees(parts)
        return Power(base, exponent, span=place(parts))

    def array(self, parts: Sequence[Part]) -> Tree:
        """Entries of a vector, or rows; a semicolon ends a row."""
        rows: list[list[Tree]] = [[]]
        for part in parts:
            if not isinstance(part, Token):
                rows[-1].append(part)
            elif part == ";":
                rows.append([])
        if len(rows) == 1:
            return Array(tuple(rows[0]), span=place(parts))
        return Array(tuple(Array(tuple(row), span=place(row)) for row in rows), span=place(parts))

    def verb(self, parts: Sequence[Part]) -> Tree:
        """A verb and its arguments."""
        return verb(str(parts[0]), trees(parts), place(parts))

    def transposed(self, parts: Sequence[Part]) -> Tree:
        """A matrix with rows for columns."""
        return Call("transpose", tuple(trees(parts)), span=place(parts))

    def pairs(self, parts: Sequence[Part]) -> Tree:
        """A table of names and formulas, kept as rows of two."""
        return Array(tuple(trees(parts)), span=place(parts))

    def pair(self, parts: Sequence[Part]) -> Tree:
        """A name and a formula."""
        names = [part for part in parts if isinstance(part, Token)]
        return Array((self.name(names[:1]), *trees(parts)), span=place(parts))

    def entries(self, parts: Sequence[Part]) -> Tree:
        """Entries that are picked from an array."""
        (array,) = trees(parts)
        tokens = [part for part in parts if isinstance(part, Token)][1:-1]  # without the brackets
        groups: list[list[Token]] = [[]]
        for one in tokens:
            if one == ",":
                groups.append([])
            else:
                groups[-1].append(one)
        return Entries(array, tuple(map(_picked, groups)), span=place(parts))


def call(function: str, arguments: Iterable[Tree], span: Span) -> Tree:
    """A function applied to as many arguments as it takes; an arc tangent of two is atan2(y, x).

    Raises:
        FormulaError: for more or fewer.
    """
    given = tuple(arguments)
    function = "atan2" if function == "atan" and len(given) == NUMBER_OF_ARGUMENTS["atan2"] else function
    needed = NUMBER_OF_ARGUMENTS[function]
    if len(given) != needed:
        plural = "" if needed == 1 else "s"
        raise FormulaError(f"{function} takes {needed} argument{plural}, here it has {len(given)}", span=span)
    return Call(function, given, span=span)


def verb(name: str, arguments: Iterable[Tree], span: Span) -> Tree:
    """A verb with its arguments.

    Raises:
        FormulaError: for more or fewer than it takes, or where it wants a name of its own.
    """
    given = tuple(arguments)
    fewest, most = VERBS[name]
    if not fewest <= len(given) <= most:
        wanted = str(fewest) if fewest == most else f"{fewest} to {most}"
        raise FormulaError(f"{name} takes {wanted} arguments, here it has {len(given)}", span=span)
    if name in BINDING and not isinstance(given[1], Name):
        raise FormulaError(f"the second argument of {name} is a name, such as {name}(..., j, ...)", span=span)
    return Call(name, given, span=span)


def trees(parts: Iterable[Part]) -> Iterator[Tree]:
    """The parts that are trees."""
    return (part for part in parts if not isinstance(part, Token))


def place(parts: Sequence[Part]) -> Span:
    """From where the first part begins to where the last one ends."""
    return _span(parts[0])[0], _span(parts[-1])[1]


def check_decimals(parts: Sequence[Part]) -> None:
    """Refuse two numbers that only a comma parts.

    Raises:
        FormulaError: saying how a decimal is written.
    """
    for before, comma, after in zip(parts, parts[1:], parts[2:], strict=False):
        if not isinstance(comma, Token) or isinstance(before, Token) or isinstance(after, Token):
            continue
        left, right = _outermost(before, -1), _outermost(after, 0)
        spans = (left.span or (0, 0))[1], (right.span or (0, 0))[0]
        if isinstance(left, Number) and isinstance(right, Number) and spans == place([comma]):
            said = f"decimals follow a point: {left.text}.{right.text}; a vector is [{left.text}, {right.text}]"
            raise FormulaError(said, span=place([comma]))


def _outermost(tree: Tree, which: int) -> Tree:
    """The first or the last part of a formula that has none itself."""
    while below := children(tree):
        tree = below[which]
    return tree


def finished(
    tree: Tree,
    resolved: Callable[[Tree], Tree] = lambda node: node,
    shapes: Mapping[str, Shape] = NO_SHAPES,
    *,
    strangers: bool = False,
) -> Tree:
    """A tree as a parser made it, let through when it is safe to work on, with one object for all equal parts.

    Args:
        tree: the formula.
        resolved: makes of each node what it means.
        shapes: of the names that stand for arrays.
        strangers: whether names of which nothing is known may stand for arrays.

    Raises:
        FormulaError: when it is too large, or has no meaning.
    """
    check_size(tree)
    plain = with_numbers(shared(tree, resolved), shapes)
    return _check_meaning(plain, magnitudes(), shapes, strangers=strangers)


def check_tree(
    tree: Tree,
    measure: Fold[Measure] | None = None,
    shapes: Mapping[str, Shape] = NO_SHAPES,
    *,
    strangers: bool = False,
) -> Tree:
    """Let through a tree that is safe to work on.

    Args:
        tree: the formula.
        measure: the magnitudes of formulas that share parts with it.
        shapes: of the names that stand for arrays.
        strangers: whether names of which nothing is known may stand for arrays.

    Raises:
        FormulaError: when it is too large, or has no meaning.
    """
    check_size(tree)
    return _check_meaning(tree, measure or magnitudes(), shapes, strangers=strangers)


def _check_meaning(tree: Tree, measure: Fold[Measure], shapes: Mapping[str, Shape], *, strangers: bool) -> Tree:
    """Let through a tree of allowed size that has a meaning.

    Raises:
        FormulaError: when it has none, or its powers and numbers are too large.
    """
    measure(tree)
    if not (strangers and has_verbs(tree)):
        shape(tree, shapes)
    return tree


def _span(part: Part) -> Span:
    if isinstance(part, Token):
        return part.start_pos or 0, part.end_pos or 0
    return part.span or (0, 0)


def _picked(tokens: Sequence[Token]) -> Place:
    """A place, or from where to where."""
    colon = next((at for at, one in enumerate(tokens) if one == ":"), None)
    if colon is None:
        return _whole(tokens[0])
    before, after = tokens[:colon], tokens[colon + 1 :]
    return (_whole(before[0]) if before else None), (_whole(after[0]) if after else None)


def _whole(token: Token) -> int:
    if not token.isdigit() or len(token) > 3:
        raise FormulaError("an entry is picked by a whole number of at most three digits", span=place([token]))
    return int(token)


def _product(factors: Sequence[Tree]) -> Tree:
    return factors[0] if len(factors) == 1 else Product(tuple(factors), span=place(factors))


def _quotient(numerator: Tree, denominator: Tree) -> Tree:
    return Quotient(numerator, denominator, span=place([numerator, denominator]))
