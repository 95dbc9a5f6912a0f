r"""Turns pieces of LaTeX into the tokens of the grammar, as TeX would take them.

What TeX decides by itself is decided here: an exponent without braces is one character, a subscript belongs
to the letter before it even when an exponent stands between, `\frac12` is a half. What belongs to what on
the printed page is the grammar's business.
"""

from __future__ import annotations

import re
from collections.abc import Callable

from lark import Token

from radartrack.derive.formula.error import FormulaError, Span
from radartrack.derive.formula.functions import SPELLINGS, SQUARED_BY_NAME
from radartrack.derive.formula.latex_names import ACCENTS, GREEK, resolve
from radartrack.derive.formula.limits import MAX_PRINTED, check_brackets, check_count
from radartrack.derive.formula.unknown_names import unknown_function, unknown_name
from radartrack.derive.reading.latex_pieces import CLOSERS, FUNCTIONS, Piece, pieces

_BRACKET_TOKENS = {
    **dict.fromkeys(("(", "[", "\\{"), "LPAR"),
    **dict.fromkeys((")", "]", "\\}"), "RPAR"),
    "{": "LBRACE",
    "}": "RBRACE",
    "\\lvert": "LBAR",
    "\\rvert": "RBAR",
}
_SIGN_TOKENS = {
    "plus": "PLUS",
    "minus": "MINUS",
    "times": "TIMES",
    "slash": "SLASH",
    "comma": "COMMA",
    "column": "AMPERSAND",
    "newline": "NEWLINE",
}
_CONSTANT_TOKENS = {"e": "EULER", "pi": "CONSTANT"}
WORDS = {**SPELLINGS, **FUNCTIONS}
_OPERANDS = frozenset({"CONSTANT", "EULER", "FRACTION", "FUNCTION", "LBAR", "NAME", "NUMBER", "ROOT"})
_INVISIBLE = frozenset({"{", "}", "\\rm"})
_NUMBER = re.compile(r"\d+(?:\.\d+)?|\.\d+")
_SINGLE = frozenset({"digit", "letter", "greek", "word"})  # what may be an argument without braces


def tokens(source: str, names: frozenset[str], *, any_name: bool = False) -> list[Token]:
    """The tokens of a formula in LaTeX.

    Raises:
        FormulaError: for what is not read, for unknown symbols, and for brackets without partners.
    """
    return _Tokenizer(pieces(source), names, any_name=any_name).run()


class _Tokenizer:
    """One pass over the pieces; what an earlier piece says of later ones is kept by their index."""

    def __init__(self, found: list[Piece], names: frozenset[str], *, any_name: bool) -> None:
        self.pieces = found
        self.names = names
        self.any_name = any_name
        self.partner = _partners(found)
        self.alone: set[int] = set()  # arguments without braces
        self.taken: dict[int, int] = {}  # subscripts that stand behind an exponent, with where they end
        self.roots: set[int] = set()  # the brackets around the index of a root
        self.tokens: list[Token] = []
        self.operands = 0

    def run(self) -> list[Token]:
        index = 0
        while index < len(self.pieces):
            index = self.taken[index] if index in self.taken else self._step(index)
        return self.tokens

    def _step(self, index: int) -> int:
        piece = self.pieces[index]
        if index not in self.alone:
            return self._handler(piece)(index)
        self._emit("LBRACE", "{", (piece.span[0], piece.span[0]))
        after = self._handler(piece)(index)
        self._emit("RBRACE", "}", (piece.span[1], piece.span[1]))
        return after

    def _handler(self, piece: Piece) -> Callable[[int], int]:
        if piece.kind == "function" or (piece.kind == "word" and piece.text in WORDS.keys() - self.names):
            return self._function
        handlers = {
            "digit": self._number,
            "letter": self._letter,
            "greek": self._symbol,
            "accent": self._symbol,
            "word": self._symbol,
            "open": self._bracket,
            "close": self._bracket,
            "raised": self._raised,
            "fraction": self._fraction,
            "root": self._root,
        }
        return handlers.get(piece.kind, self._sign)

    def _number(self, index: int) -> int:
        """Digits that touch, or the single digit that an argument without braces is."""
        after = index + 1
        while index not in self.alone and self._kind(after) == "digit" and self._touches(after):
            after += 1
        text = "".join(piece.text for piece in self.pieces[index:after])
        span = (self.pieces[index].span[0], self.pieces[after - 1].span[1])
        if not _NUMBER.fullmatch(text):
            raise FormulaError(f"{text[:40]} is no number: leave out punctuation after the formula", span=span)
        self._emit("NUMBER", text, span)
        return after

    def _letter(self, index: int) -> int:
        """A letter is a symbol, unless the letters around it spell something that print would set upright."""
        if not (self._kind(index - 1) == "letter" and self._touches(index)):
            after = index + 1
            while self._kind(after) == "letter" and self._touches(after):
                after += 1
            self._check_run("".join(piece.text for piece in self.pieces[index:after]), index, after)
        return self._symbol(index)

    def _check_run(self, run: str, index: int, after: int) -> None:
        span = (self.pieces[index].span[0], self.pieces[after - 1].span[1])
        if len(run) > 1 and run in WORDS:
            raise FormulaError(f"{run} is a product of letters here: write \\{run} for the function", span=span)
        if len(run) > 1 and run in self.names:
            raise FormulaError(f"{run} is a product of letters here: write \\mathrm{{{run}}} for the symbol", span=span)
        if run == "e" and self._kind(index - 1) == "digit" and self._touches(index) and self._is_signed_digit(after):
            raise FormulaError(
                "this may be a power of ten or a product with e: write \\cdot 10^{...} for the power",
                span=span,
            )

    def _is_signed_digit(self, index: int) -> bool:
        """Whether what follows without a space is a digit, or a sign and a digit."""
        if self._kind(index) in {"plus", "minus"} and self._touches(index):
            index += 1
        return self._kind(index) == "digit" and self._touches(index)

    def _symbol(self, index: int) -> int:
        """A letter with its subscript."""
        base, after = self._base(index)
        below, after = ("", after) if index in self.alone else self._subscript_behind(after)
        name = resolve(base, below, self.names)
        span = (self.pieces[index].span[0], self.pieces[after - 1].span[1])
        upright = self.pieces[index].kind == "word"
        if name in self.names and name == "e" and upright:
            raise FormulaError("e is a symbol here: write \\exp(...) for powers of Euler's number", span=span)
        if name in self.names:
            self._emit("NAME", name, span)
        elif name in _CONSTANT_TOKENS:
            self._emit(_CONSTANT_TOKENS[name], name, span)
        elif upright and self._kind(after) == "open":
            raise FormulaError(unknown_function(name), span=span)
        elif self.any_name:
            self._emit("NAME", name, span)
        else:
            raise FormulaError(unknown_name(name, self.names), span=span)
        return after

    def _subscript_behind(self, index: int) -> tuple[str, int]:
        """The subscript of a letter that ends here, be it behind an exponent, and where the letter ends."""
        if self._kind(index) == "lowered":
            return self._subscript(index)
        if self._kind(index) == "raised" and self._kind(end := self._argument_end(index)) == "lowered":
            below, self.taken[end] = self._subscript(end)
            return below, index
        return "", index

    def _base(self, index: int) -> tuple[str, int]:
        """The name of a letter, dotted or not, and where it ends."""
        piece = self.pieces[index]
        if piece.kind != "accent":
            return GREEK.get(piece.text, piece.text), index + 1
        inner = index + 1
        braced = self._kind(inner) == "open" and self.pieces[inner].text == "{"
        inner += braced
        after = inner + 1 + braced
        if self._kind(inner) not in {"letter", "greek"} or (braced and self.partner[index + 1] != inner + 1):
            raise FormulaError(f"{piece.text} stands over one letter: {piece.text}{{r}}", span=piece.span)
        return self._base(inner)[0] + ACCENTS[piece.text], after

    def _subscript(self, index: int) -> tuple[str, int]:
        """What a subscript says, and where it ends: letters side by side are a word, commas part words."""
        end = self._argument_end(index)
        said = ""
        index += 1
        while index < end:
            piece = self.pieces[index]
            if piece.kind in {"letter", "digit", "greek", "accent", "word"}:
                part, index = self._base(index)
                said += part
                continue
            if piece.kind != "comma" and piece.text not in _INVISIBLE:
                raise FormulaError("a subscript is made of letters, digits and commas", span=piece.span)
            said += "_" if piece.kind == "comma" else ""
            index += 1
        return said, end

    def _function(self, index: int) -> int:
        piece = self.pieces[index]
        function = piece.text.removeprefix("\\")
        self._emit("FUNCTION", function, piece.span)
        if self._kind(index + 1) == "lowered":
            raise FormulaError(f"{function} has no subscript; a logarithm is the natural one", span=piece.span)
        if self._kind(index + 1) == "raised":
            self._check_raised_function(function, index + 1)
        return index + 1

    def _check_raised_function(self, function: str, index: int) -> None:
        end = self._argument_end(index)
        exponent = "".join(piece.text for piece in self.pieces[index + 1 : end] if piece.text not in _INVISIBLE)
        span = (self.pieces[index].span[0], self.pieces[end - 1].span[1])
        if exponent.startswith("-"):
            raise FormulaError(
                f"^{exponent} may mean the inverse or the reciprocal: write \\arc... or \\frac{{1}}{{...}}",
                span=span,
            )
        if WORDS[function] not in SQUARED_BY_NAME or not exponent.isdigit():
            raise FormulaError(f"write the power of {function} behind brackets: \\{function}(...)^{{...}}", span=span)

    def _bracket(self, index: int) -> int:
        piece = self.pieces[index]
        kind = _BRACKET_TOKENS.get(piece.text) or ("BEGIN" if piece.kind == "open" else "END")
        if index in self.roots:
            kind = "LINDEX" if piece.kind == "open" else "RINDEX"
        self._emit(kind, piece.text, piece.span)
        return index + 1

    def _raised(self, index: int) -> int:
        end = self._argument(index)
        digit = end - 1
        if digit in self.alone and self._kind(digit) == self._kind(end) == "digit" and self._touches(end):
            raise FormulaError(
                "only the first digit is raised: write ^{...} around them all", span=self.pieces[end].span
            )
        self._emit("RAISED", "^", self.pieces[index].span)
        return index + 1

    def _fraction(self, index: int) -> int:
        self._emit("FRACTION", self.pieces[index].text, self.pieces[index].span)
        self._argument(self._argument(index) - 1)
        return index + 1

    def _root(self, index: int) -> int:
        self._emit("ROOT", self.pieces[index].text, self.pieces[index].span)
        before = index
        if self._kind(index + 1) == "open" and self.pieces[index + 1].text == "[":
            before = self.partner[index + 1]
            self.roots |= {index + 1, before}
        self._argument(before)
        return index + 1

    def _sign(self, index: int) -> int:
        piece = self.pieces[index]
        if piece.kind == "lowered":
            raise FormulaError("a subscript stands only behind a letter", span=piece.span)
        if piece.kind not in _SIGN_TOKENS:
            raise FormulaError(f"{piece.text} stands only in a subscript", span=piece.span)
        self._emit(_SIGN_TOKENS[piece.kind], piece.text, piece.span)
        return index + 1

    def _argument(self, index: int) -> int:
        """Where the argument that follows a piece ends; one without braces is remembered."""
        end = self._argument_end(index)
        if self.pieces[index + 1].text != "{":
            self.alone.add(index + 1)
        return end

    def _argument_end(self, index: int) -> int:
        piece = self.pieces[index]
        kind = self._kind(index + 1)
        if kind == "open" and self.pieces[index + 1].text == "{":
            return self.partner[index + 1] + 1
        if kind in _SINGLE:
            return index + 2
        raise FormulaError(f"what belongs to {piece.text} must stand in braces behind it", span=piece.span)

    def _kind(self, index: int) -> str:
        return self.pieces[index].kind if 0 <= index < len(self.pieces) else ""

    def _touches(self, index: int) -> bool:
        """Whether a piece follows the one before it without a space."""
        return self.pieces[index - 1].span[1] == self.pieces[index].span[0]

    def _emit(self, kind: str, value: str, span: Span) -> None:
        self.operands += kind in _OPERANDS
        check_count(self.operands, MAX_PRINTED)
        self.tokens.append(Token(kind, value, start_pos=span[0], end_pos=span[1]))


def _partners(found: list[Piece]) -> dict[int, int]:
    """Where the bracket that a piece opens is closed."""
    places = [index for index, piece in enumerate(found) if piece.kind in {"open", "close"}]
    pairs = check_brackets([(found[index].text, found[index].span) for index in places], CLOSERS)
    return {places[opener]: places[closer] for opener, closer in pairs.items()}
