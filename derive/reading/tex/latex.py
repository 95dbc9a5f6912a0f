r"""Reads a formula in LaTeX, as papers print it: `\frac{1}{2}\sigma_\beta^2 r\cos\beta`."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Mapping, Sequence
from functools import cache, partial
from itertools import pairwise

from lark import Lark, Token, UnexpectedToken

from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.functions import VERBS
from radartrack.derive.formula.shape import NO_SHAPES, Shape, shape
from radartrack.derive.formula.tree import (
    Array,
    Call,
    Constant,
    Name,
    Number,
    Power,
    Product,
    Quotient,
    Tree,
    with_span,
)
from radartrack.derive.formula.unknown_names import check_names
from radartrack.derive.reading.characters import check_characters
from radartrack.derive.reading.grammar import Part, TreeBuilder, call, check_decimals, finished, place, trees, verb
from radartrack.derive.reading.joined_equations import Definition, combined
from radartrack.derive.reading.tex.author_macros import defined_macros, expanded
from radartrack.derive.reading.tex.latex_arguments import AmbiguousArgument, bracketed
from radartrack.derive.reading.tex.latex_equations import Equation, equations, without_formula_before
from radartrack.derive.reading.tex.latex_hints import refusal
from radartrack.derive.reading.tex.latex_kronecker import with_kronecker
from radartrack.derive.reading.tex.latex_letters import Letter, Names, full_name
from radartrack.derive.reading.tex.latex_phases import power_of_which
from radartrack.derive.reading.tex.latex_pieces import is_typed
from radartrack.derive.reading.tex.latex_symmetric import with_mirrored
from radartrack.derive.reading.tex.latex_times import raised_times
from radartrack.derive.reading.tex.latex_tokens import WORDS, LatexTokens

_ARRAY = re.compile(r"matrix\}|\{array\}|diag|\]\s*\^")
_APPLIED = re.compile(r"(?P<name>[^()=]*?)\s*(?P<argument>\([^()=]*\))\s*")
_COMMA = re.compile(r"[,;]|\\q?quad(?![A-Za-z])")
_OF_ANGLES = frozenset({"acos", "asin", "atan", "cos", "cot", "csc", "sec", "sin", "tan"})


def read_latex(
    text: str,
    names: Collection[str] | None,
    shapes: Mapping[str, Shape] = NO_SHAPES,
    *,
    strangers: bool = False,
    wanted: int = 1,
) -> Tree:
    r"""Read a formula in these symbols, or the equations of a display; what print leaves ambiguous is refused.

    A symbol is named by its letters: \sigma_{\beta} is sigma_beta, \dot{r} is rdot, \mathrm{abc} is abc. Hats, bars
    and primes are kept in the name where one letter occurs in two ways, and dropped elsewhere. Letters side by side
    are a product, and so is a letter before a bracket: show the reading, `to_text` of the tree, to whoever asked. \pi,
    \mathrm{e} and e are the constants where no symbol has their name. A matrix of one column or row is a vector.
    Of an equation the right side is read; of several, the one that the others define, or all. Commands that the text
    defines itself, with \newcommand or \def, are put in.

    Args:
        text: the formula, with or without delimiters and environments.
        names: the symbols; None where none are known, and every name is let through.
        shapes: of those that stand for arrays.
        strangers: whether names that are not known are let through.
        wanted: of how many numbers it is to be.

    Raises:
        FormulaError: when it is no such formula, is ambiguous, or too large.
        ValueError: when one of the names is a function's.
    """
    allowed = check_names(names or ())
    strangers = strangers or names is None
    check_characters(text, allowed, latex=True)
    try:
        macros, text = defined_macros(text)
        text = with_kronecker(with_mirrored(expanded(text, macros)))
        found = _with_plain_functions([part for one in equations(text) for part in _parted(one)])
        arrays = {**shapes, **{letter.base: () for one in found if (letter := _array_defined(one))}}
        raised = raised_times(one.left for one in found)
        read = partial(LatexTokens, known=allowed, raised=raised, typed=is_typed(text))
        rights = [read(one.right, shapes=arrays, strangers=strangers) for one in found]
        lefts = [_letter(one.left, allowed, read) if len(found) > 1 else None for one in found]
        letters = [letter for tokens in rights for letter in tokens.letters]
        spelling = Names([*letters, *filter(None, lefts)], allowed, strangers=strangers)
        defined = [spelling.of(letter) if letter else "" for letter in lefts]
        named = [tokens.named(spelling, {*defined} - {""}) for tokens in rights]
        trees = _parsed(text, dict(zip((one.right for one in found), named, strict=True)))
        tree = combined([Definition(name, tree) for name, tree in zip(defined, trees, strict=True)], wanted)
        return finished(tree, shapes=shapes, strangers=strangers)
    except FormulaError as error:
        raise error.within(text) from None


def _parted(equation: Equation) -> list[Equation]:
    """An equation, and the formula before it of which it defines a letter; x, y = 1, 2 defines two and is one."""
    before, own = without_formula_before(equation)
    if _letter(own.left, frozenset()) is None:
        return [equation]
    pieces = [piece for piece in _COMMA.split(before) if piece.strip()]
    if not pieces:
        return [own]
    return [equation] if all(_letter(piece, frozenset()) for piece in pieces) else [Equation("", before), own]


def _with_plain_functions(found: Sequence[Equation]) -> list[Equation]:
    r"""Equations in which N(\phi) is N where one of them defines it under that name."""
    for equation in found:
        applied = _APPLIED.fullmatch(equation.left)
        if not applied or _letter(applied["name"], frozenset()) is None:
            continue
        argument = applied["argument"]
        used = re.compile(rf"(?P<name>{re.escape(applied['name'].strip())})(?P<argument>\s*{re.escape(argument)})")
        if any(used.search(one.right) for one in found):
            plain = [Equation(_bare(used, one.left), _bare(used, one.right)) for one in found]
            return _with_plain_functions(plain)
    return list(found)


def _bare(applied: re.Pattern[str], text: str) -> str:
    return applied.sub(lambda found: found["name"] + " " * len(found["argument"]), text)


def _array_defined(equation: Equation) -> Letter | None:
    """The letter that an equation defines as a vector or a matrix."""
    return _letter(equation.left, frozenset()) if _ARRAY.search(equation.right) else None


def latex_name(text: str) -> str | None:
    r"""The name of what is printed, if it is one letter, with all that decorates it: \lambda' is lambda_prime."""
    letter = _letter(text, frozenset())
    return full_name(letter) if letter else None


def _letter(left: str, names: frozenset[str], read: Callable[..., LatexTokens] = LatexTokens) -> Letter | None:
    """The letter that stands left of an equals sign, if nothing else does."""
    if not left.strip():
        return None
    try:
        return read(left, known=names, strangers=True).only_letter
    except FormulaError:
        return None  # a left side may say anything


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
        function = WORDS[str(parts[0])]
        applied = (verb if function in VERBS else call)(function, trees(parts), span)
        self._check_power_of_argument(applied, parts)
        exponents = [part for part in parts if isinstance(part, Token) and part.type == "NUMBER"]
        return Power(applied, self.number(exponents), span=span) if exponents else applied

    def _check_power_of_argument(self, applied: Tree, parts: Sequence[Part]) -> None:
        r"""Refuse \sin\theta^2; of \cosh\sigma^2 the square is that of a deviation, which is a variance."""
        has_brackets = any(isinstance(part, Token) and part.type in {"LPAR", "LBAR", "LBRACE"} for part in parts[1:3])
        if has_brackets or not isinstance(applied, Call) or applied.function not in _OF_ANGLES:
            return
        argument = applied.arguments[-1]
        last = argument.factors[-1] if isinstance(argument, Product) else argument
        if isinstance(last, Power):
            raise FormulaError(power_of_which(str(parts[0])), span=place(parts))

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

    def power(self, parts: Sequence[Part]) -> Tree:
        """A base and an exponent; a T behind an array is no exponent."""
        base, exponent = trees(parts)
        if exponent == Name("T") and _is_array(base):
            return self.transposed([base, with_span(base, exponent.span)])
        return super().power(parts)

    def transposed(self, parts: Sequence[Part]) -> Tree:
        """A matrix with rows for columns; one row becomes a vector."""
        array = next(iter(trees(parts)))
        if isinstance(array, Array) and len(array.entries) == 1 and isinstance(array.entries[0], Array):
            return with_span(array.entries[0], place(parts))
        return Call("transpose", (array,), span=place(parts))

    def listed(self, parts: Sequence[Part]) -> Tree:
        """Entries of a vector, in any brackets or none; without square ones 0,5 may be a half."""
        if parts[0] != "[":
            check_decimals(parts)
        return Array(tuple(trees(parts)), span=place(parts))

    column = listed

    def summed(self, parts: Sequence[Part]) -> Tree:
        """A sum over an index."""
        index, lower, upper, term = trees(parts)
        return verb("sum", (term, index, lower, upper), place(parts))

    def integral(self, parts: Sequence[Part]) -> Tree:
        """An integral between limits."""
        lower, upper, integrand = trees(parts)
        variable = parts[-1]
        return verb("integral", (integrand, Name(str(variable), span=place([variable])), lower, upper), place(parts))

    def row(self, parts: Sequence[Part]) -> Tree:
        """A row of a matrix."""
        return self.array(parts)

    def matrix(self, parts: Sequence[Part]) -> Tree:
        """Rows of a matrix; one column is a vector."""
        rows = [row for row in trees(parts) if isinstance(row, Array)]
        if all(len(row.entries) == 1 for row in rows):
            return Array(tuple(row.entries[0] for row in rows), span=place(parts))
        return Array(tuple(rows), span=place(parts))


def _is_array(tree: Tree) -> bool:
    return bool(shape(tree))


def _is_fraction_of_numbers(part: Part) -> bool:
    match part:
        case Quotient(Number(), Number()):
            return True
    return False


@cache
def _parser() -> Lark:
    return Lark.open("latex.lark", rel_to=__file__, parser="lalr", lexer="basic", transformer=_LatexBuilder())


def _parsed(text: str, formulas: Mapping[str, Sequence[Token]]) -> list[Tree]:
    """The formulas in a text, whose tokens these are."""
    try:
        return [_parse(tokens, len(text)) for tokens in formulas.values()]
    except AmbiguousArgument as error:
        raise error.read_as(bracketed(text, formulas)) from None


def _parse(found: Sequence[Token], length: int) -> Tree:
    parser = _parser().parse_interactive()
    for index, token in enumerate(found):
        try:
            parser.feed_token(token)
        except UnexpectedToken:
            raise refusal(found, index, place([token])) from None
    try:
        tree: Tree = parser.feed_eof()  # type: ignore[no-untyped-call]
    except UnexpectedToken:
        raise refusal(found, len(found), (length, length)) from None
    return tree
