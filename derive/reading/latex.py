r"""Reads a formula in LaTeX, as papers print it: `\frac{1}{2}\sigma_\beta^2 r\cos\beta`."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from functools import cache
from itertools import pairwise

from lark import Lark, Token, UnexpectedToken

from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.shape import NO_SHAPES, Shape
from radartrack.derive.formula.tree import (
    Array,
    Call,
    Constant,
    Number,
    Power,
    Quotient,
    Tree,
)
from radartrack.derive.formula.unknown_names import check_names
from radartrack.derive.reading.characters import check_characters
from radartrack.derive.reading.grammar import Part, TreeBuilder, call, finished, place, trees
from radartrack.derive.reading.latex_hints import hint
from radartrack.derive.reading.latex_tokens import WORDS, tokens


def read_latex(
    text: str, names: Collection[str], shapes: Mapping[str, Shape] = NO_SHAPES, *, any_name: bool = False
) -> Tree:
    r"""Read a formula in these symbols; what print leaves ambiguous is refused.

    A symbol is named by its letters: \sigma_{\beta} is sigma_beta, \dot{r} is rdot, \mathrm{abc} is abc.
    Letters side by side are a product, and so is a letter before a bracket: show the reading, `to_text` of
    the tree, to whoever asked. \pi, \mathrm{e} and e are the constants where no symbol has their name. A
    matrix of one column is a vector. With `any_name` other names may occur as well, whatever they mean.

    Raises:
        FormulaError: when it is no such formula, is ambiguous, or too large.
        ValueError: when one of the names is a function's.
    """
    allowed = check_names(names)
    check_characters(text, allowed, latex=True)
    try:
        return finished(_parse(tokens(text, allowed, any_name=any_name), len(text)), shapes=shapes)
    except FormulaError as error:
        raise error.within(text) from None


class _LatexBuilder(TreeBuilder):
    def constant(self, parts: Sequence[Token]) -> Tree:
        """The number pi."""
        return Constant(str(parts[0]), span=place(parts))

    euler = constant

    def raised(self, parts: Sequence[Part]) -> Part:
        """The power of a function, before its argument."""
        return parts[2]

    def call(self, parts: Sequence[Part]) -> Tree:
        r"""A function, with or without brackets; \cos^2\beta is the square of the cosine."""
        span = place(parts)
        applied = call(WORDS[str(parts[0])], trees(parts), span)
        exponents = [part for part in parts if isinstance(part, Token) and part.type == "NUMBER"]
        return Power(applied, self.number(exponents), span=span) if exponents else applied

    def call_of_absolute(self, parts: Sequence[Part]) -> Tree:
        r"""A function of something between bars, \log|r|."""
        bar = next(index for index, part in enumerate(parts) if isinstance(part, Token) and part.type == "LBAR")
        return self.call([*parts[:bar], self.absolute(parts[bar:])])

    def fraction(self, parts: Sequence[Part]) -> Tree:
        """A numerator above a denominator."""
        numerator, denominator = trees(parts)
        return Quotient(numerator, denominator, span=place(parts))

    def root(self, parts: Sequence[Part]) -> Tree:
        """A square root, or a power of one over the index."""
        *index, radicand = trees(parts)
        if not index:
            return Call("sqrt", (radicand,), span=place(parts))
        return Power(radicand, Quotient(Number("1"), index[0], span=index[0].span), span=place(parts))

    def product(self, parts: Sequence[Part]) -> Tree:
        """Factors side by side or with a dot between, perhaps over one behind a slash."""
        for left, right in pairwise(parts):
            if isinstance(left, Number) and _is_fraction_of_numbers(right):
                raise FormulaError(
                    "this may be a mixed number or a product: write \\cdot, or one fraction",
                    span=place([left, right]),
                )
        return super().product(parts)

    def row(self, parts: Sequence[Part]) -> Tree:
        """A row of a matrix."""
        return self.array(parts)

    def matrix(self, parts: Sequence[Part]) -> Tree:
        """Rows of a matrix; one column is a vector."""
        rows = [row for row in trees(parts) if isinstance(row, Array)]
        if all(len(row.entries) == 1 for row in rows):
            return Array(tuple(row.entries[0] for row in rows), span=place(parts))
        return Array(tuple(rows), span=place(parts))


def _is_fraction_of_numbers(part: Part) -> bool:
    match part:
        case Quotient(Number(), Number()):
            return True
    return False


@cache
def _parser() -> Lark:
    return Lark.open("latex.lark", rel_to=__file__, parser="lalr", lexer="basic", transformer=_LatexBuilder())


def _parse(found: Sequence[Token], length: int) -> Tree:
    parser = _parser().parse_interactive()
    for index, token in enumerate(found):
        try:
            parser.feed_token(token)
        except UnexpectedToken:
            raise FormulaError(hint(found, index), span=place([token])) from None
    try:
        tree: Tree = parser.feed_eof()  # type: ignore[no-untyped-call]
    except UnexpectedToken:
        raise FormulaError(hint(found, len(found)), span=(length, length)) from None
    return tree
