r"""Turns pieces of LaTeX into the tokens of the grammar, as TeX would take them.

What TeX decides by itself is decided here: an exponent without braces is one character, a subscript belongs
to the letter before it even when an exponent stands between, `\frac12` is a half. What belongs to what on
the printed page is the grammar's business.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Mapping
from dataclasses import replace
from functools import cached_property
from itertools import takewhile

from lark import Token

from radartrack.derive.formula.error import FormulaError, Span
from radartrack.derive.formula.functions import SPELLINGS, SQUARED_BY_NAME
from radartrack.derive.formula.latex_names import ACCENTS, GREEK
from radartrack.derive.formula.limits import MAX_PRINTED, check_count
from radartrack.derive.formula.shape import NO_SHAPES, Shape
from radartrack.derive.formula.unknown_names import unknown_function, unknown_name
from radartrack.derive.reading.tex.latex_arguments import before_deviations
from radartrack.derive.reading.tex.latex_letters import (
    DECORATIONS,
    OF_TIME,
    SAYS_NOTHING,
    Letter,
    Names,
    possible_names,
    spelled,
)
from radartrack.derive.reading.tex.latex_phases import with_phases
from radartrack.derive.reading.tex.latex_pieces import FUNCTIONS, VERB_WORDS, Piece, pieces, sided, with_typed_words
from radartrack.derive.reading.tex.latex_rewriting import partners, rewritten
from radartrack.derive.reading.tex.latex_times import with_times

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
    "differential": "DIFFERENTIAL",
    "integral": "INTEGRAL",
    "transposed": "TRANSPOSED",
}
_CONSTANT_TOKENS = {"e": "EULER", "pi": "CONSTANT"}
WORDS = {**SPELLINGS, **FUNCTIONS, **VERB_WORDS}
INVERSES = {"cos": "acos", "sin": "asin", "tan": "atan"}  # \\tan^{-1} is the inverse in every paper
_OPERANDS = frozenset({"CONSTANT", "EULER", "FRACTION", "FUNCTION", "LBAR", "NAME", "NUMBER", "ROOT"})
_INVISIBLE = frozenset({"{", "}"})
_IN_SUBSCRIPTS = frozenset({"letter", "digit", "greek", "accent", "word"})
_OF_INDICES = frozenset({"given", "plus", "minus", "slash"})  # k|k-1, k/k
_PARTING_WORDS = frozenset({"comma", "lowered"})  # in a subscript
_FACTORS_END = frozenset({"NAME", "RPAR"})
_TAKE_GROUPS = frozenset({"FRACTION", "RAISED", "ROOT"})
_FACTORS_BEGIN = frozenset({"letter", "greek", "word", "accent", "fraction", "function"})
_COORDINATES = frozenset("xyz")
MOST_ACCENTS = 4  # over one letter
_NUMBER = re.compile(r"\d+(?:\.\d+)?|\.\d+")
_SINGLE = frozenset({"digit", "letter", "greek", "word"})  # what may be an argument without braces


class LatexTokens:
    """The tokens of a formula in LaTeX; its letters have names when all formulas beside it are known too.

    Args:
        source: the formula.
        known: the symbols that are known.
        shapes: of those that stand for arrays.
        strangers: whether other names are let through.
        raised: letters that are times where they are raised.
        typed: whether letters side by side are a word, as in code.

    Raises:
        FormulaError: for what is not read, and for brackets without partners.
    """

    def __init__(
        self,
        source: str,
        known: frozenset[str],
        shapes: Mapping[str, Shape] = NO_SHAPES,
        *,
        strangers: bool = False,
        raised: Collection[str] = (),
        typed: bool = False,
    ) -> None:
        found = with_typed_words(pieces(source), known) if typed else pieces(source)
        found = list(sided(with_times(found, known, raised)))
        self._tokenizer = _Tokenizer(rewritten(found), known, shapes, strangers=strangers)
        self._tokens = self._tokenizer.run()
        self._strangers = strangers
        self._known = known

    @property
    def letters(self) -> Collection[Letter]:
        """All letters that may be symbols."""
        return self._tokenizer.letters.values()

    @property
    def only_letter(self) -> Letter | None:
        r"""The letter that the formula is, if it is nothing else; R^{12} is R_{12}, and \sigma_x^2 is \sigma_{xx}."""
        letter = self._tokenizer.letters.get(0)
        kinds = [token.type for token in self._tokens]
        if letter is None or kinds == ["NAME"]:
            return letter if len(kinds) == 1 else None
        if kinds != ["NAME", "RAISED", "LBRACE", "NUMBER", "RBRACE"]:
            return None
        raised = str(self._tokens[3])
        if raised == "2" and letter.base == "sigma" and letter.below in _COORDINATES:
            return replace(letter, below=2 * letter.below)
        is_place = len(raised) == 2 and raised.isdigit()
        return replace(letter, below=f"{letter.below}_{raised}".strip("_")) if is_place else None

    def named(self, names: Names, defined: Collection[str] = ()) -> list[Token]:
        """The tokens, with names for the letters.

        Raises:
            FormulaError: for the first name that is not known, unless strangers are let through.
        """
        found = list(self._tokens)
        for index, letter in self._tokenizer.letters.items():
            found[index] = self._named(found[index], letter, names.of(letter), defined)
        return before_deviations(with_phases(found))

    def _named(self, token: Token, letter: Letter, name: str, defined: Collection[str]) -> Token:
        known = self._known | set(defined) | self._tokenizer.bound
        if name in known and name == "e" and letter.is_upright:
            raise FormulaError("e is a symbol here: write \\exp(...) for powers of Euler's number", span=letter.span)
        if name in known:
            return token.update(type="NAME", value=name)
        if name in _CONSTANT_TOKENS:
            return token.update(type=_CONSTANT_TOKENS[name], value=name)
        if letter.is_upright and letter.is_applied:
            raise FormulaError(unknown_function(name), span=letter.span)
        if not self._strangers:
            raise FormulaError(unknown_name(name, self._known), span=letter.span)
        return token.update(type="NAME", value=name)


class _Tokenizer:
    """One pass over the pieces; what an earlier piece says of later ones is kept by their index."""

    def __init__(
        self, found: list[Piece], names: frozenset[str], shapes: Mapping[str, Shape], *, strangers: bool
    ) -> None:
        self.pieces = found
        self.names = names
        self.shapes = shapes
        self.strangers = strangers
        self.partner = partners(found)
        self.alone: set[int] = set()  # arguments without braces
        self.taken: dict[int, int] = {}  # subscripts that stand behind an exponent, with where they end
        self.roots: set[int] = set()  # the brackets around the index of a root
        self.tokens: list[Token] = []
        self.letters: dict[int, Letter] = {}  # by the tokens that they are
        self.bound: set[str] = set()  # indices of sums and variables of integration
        self.operands = 0
        for index, piece in enumerate(found):
            if piece.kind == "differential":
                self.bound.add(piece.text)
            elif piece.kind == "bigsum" and index + 1 < len(found):
                self.bound.add(GREEK.get(found[index + 1].text, found[index + 1].text))

    def run(self) -> list[Token]:
        index = 0
        while index < len(self.pieces):
            index = self.taken[index] if index in self.taken else self._step(index)
        self._drop_times_of_arrays()
        return self.tokens

    def _drop_times_of_arrays(self) -> None:
        """J_k is J where this is an array, and stands for one time only."""
        for base in {letter.base for letter in self.letters.values()} & self.shapes.keys():
            own = [place for place, letter in self.letters.items() if letter.base == base]
            times = {self.letters[place].below for place in own}
            if len(times) == 1 and times <= OF_TIME and f"{base}_{next(iter(times))}" not in self.names:
                for place in own:
                    self.letters[place] = replace(self.letters[place], below="")

    def _step(self, index: int) -> int:
        piece = self.pieces[index]
        if index not in self.alone:
            return self._handler(piece)(index)
        self._emit("LBRACE", "{", (piece.span[0], piece.span[0]))
        after = self._handler(piece)(index)
        self._emit("RBRACE", "}", (piece.span[1], piece.span[1]))
        return after

    def _handler(self, piece: Piece) -> Callable[[int], int]:
        if piece.kind == "function" or (piece.kind == "word" and self._is_function(piece.text)):
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
            "bigsum": self._sum,
            "prime": self._prime,
        }
        return handlers.get(piece.kind, self._sign)

    def _is_function(self, word: str) -> bool:
        return word in WORDS and word not in self.names

    def _number(self, index: int) -> int:
        """Digits that touch, or the single digit that an argument without braces is."""
        after = index + 1
        while index not in self.alone and self._kind(after) == "digit" and self._touches(after):
            after += 1
        text = "".join(piece.text for piece in self.pieces[index:after])
        span = (self.pieces[index].span[0], self.pieces[after - 1].span[1])
        if not _NUMBER.fullmatch(text):
            raise FormulaError(f"{text[:40]} is no number: leave out punctuation after the formula", span=span)
        if self._is_coefficient(index, after):
            self._emit("TIMES", "\\cdot", (span[0], span[0]))
        self._emit("NUMBER", text, span)
        return after

    def _is_coefficient(self, index: int, after: int) -> bool:
        r"""Whether a number stands apart behind a factor and before another one: \sigma^2 2\alpha."""
        stands_apart = not self._touches(index) or self.pieces[index - 1].text == "}"
        is_behind = self._has_factor and index not in self.alone
        return is_behind and stands_apart and self._kind(after) in _FACTORS_BEGIN and not self._has_open_function

    @property
    def _has_factor(self) -> bool:
        """Whether what was emitted last ends a factor; of groups in braces, the sign that takes them tells."""
        depth, takes = 0, _FACTORS_END
        for token in reversed(self.tokens):
            depth += (token.type == "RBRACE") - (token.type == "LBRACE")
            takes = _TAKE_GROUPS if token.type == "RBRACE" else takes
            if not depth and token.type not in {"LBRACE", "RBRACE"}:
                return token.type in takes
        return False

    @property
    def _has_open_function(self) -> bool:
        """Whether a function without brackets stands in the same term, whose argument may go on."""
        before = takewhile(lambda token: token.type not in {"PLUS", "MINUS", "AMPERSAND"}, reversed(self.tokens))
        return any(token.type in {"FUNCTION", "SLASH"} for token in before)

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
        if len(run) > 1 and run in self.names and not (self._is_period(index) and run[0] == "d"):
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
        """A letter with all that is over, below and beside it."""
        letter, after = self._letter_at(index)
        is_transposed = self._is_primed_array(letter, index)
        if is_transposed:
            letter = replace(letter, decorations=tuple(word for word in letter.decorations if word != "prime"))
        elif letter.is_bold and "prime" in letter.decorations:
            raise FormulaError(
                "a prime at a matrix may mean its transpose or another matrix: write ^{\\top}, or another letter",
                span=letter.span,
            )
        self.letters[len(self.tokens)] = letter
        self._emit("NAME", letter.base, letter.span)
        if is_transposed:
            self._emit("TRANSPOSED", "T", letter.span)
        return after

    def _is_primed_array(self, letter: Letter, index: int) -> bool:
        """Whether a prime is the transpose of an array that is defined without one: F P F' beside F = [...]."""
        if letter.decorations.count("prime") != 1:
            return False
        plain = replace(letter, decorations=tuple(word for word in letter.decorations if word != "prime"))
        array = next((name for name in (letter.base, *possible_names(plain)) if name in self.shapes), None)
        if array is None or not self.names.isdisjoint(set(possible_names(letter)) - set(possible_names(plain))):
            return False
        said = self.pieces[index].text
        places = (at for at, piece in enumerate(self.pieces) if piece.text == said)
        return bool(self.shapes[array]) or any(self._kind(at + 1) != "prime" for at in places)

    def _letter_at(self, index: int) -> tuple[Letter, int]:
        base, decorations, below, after = self._base(index)
        if index not in self.alone:
            joined = self._joined(index, after)
            base = base if joined == after else f"{base}{'' if base == 'd' else '_'}{self._base(after)[0]}"
            after = joined
            after = self._primes(after, decorations)
            if not below:
                below, after = self._subscript_behind(after, decorations)
                after = self._primes(after, decorations)
            before, _, time = below.rpartition("_")
            if _is_of_time(time):
                decorations, below = [*decorations, _as_name(time)], before
        piece = self.pieces[index]
        letter = Letter(
            base,
            _as_name(below),
            tuple(decorations),
            (piece.span[0], max(self.pieces[after - 1].span[1], piece.span[1])),
            is_upright=piece.kind == "word" and not piece.is_typed,
            is_applied=self._kind(after) == "open",
            is_bold=piece.is_bold,
        )
        return letter, after

    def _joined(self, index: int, after: int) -> int:
        r"""Where \Delta t ends, \delta t or dt, which is one symbol unless there is one called Delta or d."""
        said = self.pieces[index].text
        if said == "d" and self._is_period(index) and "d" not in self.names and self._d_is_of_time:
            return after + 1
        is_time = self._kind(after) == "letter" and self.pieces[after].text in {"t", "T"}
        if said == "\\Delta" and "Delta" not in self.names and self._kind(after) in {"letter", "greek"}:
            return after + 1
        return after + 1 if said == "\\delta" and "delta" not in self.names and is_time else after

    def _is_period(self, index: int) -> bool:
        """Whether dt stands here, without a space."""
        return (
            self._kind(index + 1) == "letter" and self.pieces[index + 1].text in {"t", "T"} and self._touches(index + 1)
        )

    @cached_property
    def _d_is_of_time(self) -> bool:
        """Whether each d of the formula stands before a time, so that none is a letter of its own."""
        ds = (at for at, piece in enumerate(self.pieces) if piece.kind == "letter" and piece.text == "d")
        return all(map(self._is_period, ds))

    def _primes(self, index: int, decorations: list[str]) -> int:
        while self._kind(index) == "prime":
            decorations.append(self.pieces[index].text.replace("'", "prime").replace("\\prime", "prime"))
            index += 1
        return index

    def _subscript_behind(self, index: int, decorations: list[str]) -> tuple[str, int]:
        """The subscript of a letter that ends here, be it behind an exponent, and where the letter ends."""
        if self._kind(index) == "lowered":
            return self._subscript(index, decorations)
        if self._kind(index) == "raised" and self._kind(end := self._argument_end(index)) == "lowered":
            below, self.taken[end] = self._subscript(end, decorations)
            return below, index
        return "", index

    def _base(self, index: int, above: int = 0) -> tuple[str, list[str], str, int]:
        """The name of a letter, dotted or not, what is over it, a subscript that is there too, and where it ends."""
        piece = self.pieces[index]
        if piece.kind != "accent":
            return GREEK.get(piece.text, piece.text), [], "", index + 1
        inner = index + 1
        braced = self._kind(inner) == "open" and self.pieces[inner].text == "{"
        inner += braced
        if self._kind(inner) not in {"letter", "greek", "accent", "word"} or above > MOST_ACCENTS:
            raise FormulaError(f"{piece.text} stands over one letter: {piece.text}{{r}}", span=piece.span)
        base, decorations, below, after = self._base(inner, above + 1)
        if braced:
            after = self._primes(after, decorations)
            if self._kind(after) == "lowered":
                below, after = self._subscript(after, decorations)
            if self.partner[index + 1] != after:
                raise FormulaError(f"{piece.text} stands over one letter: {piece.text}{{r}}", span=piece.span)
            after += 1
        if piece.text in ACCENTS:
            return base + ACCENTS[piece.text], decorations, below, after
        over = [] if piece.text in SAYS_NOTHING else [DECORATIONS[piece.text]]
        return base, [*decorations, *over], below, after

    def _subscript(self, index: int, decorations: list[str]) -> tuple[str, int]:
        """What a subscript says, and where it ends: letters side by side are a word, commas part words, as in a_x.

        What stands over its letters decorates the letter that it is below.
        """
        end = self._argument_end(index)
        said = ""
        index += 1
        while index < end:
            piece = self.pieces[index]
            if piece.kind in _IN_SUBSCRIPTS:
                part, over, below, index = self._base(index)
                said += part + below
                decorations += over
                continue
            is_bracket = piece.text in {"(", ")"}
            if piece.kind not in _OF_INDICES | _PARTING_WORDS and piece.text not in _INVISIBLE and not is_bracket:
                raise FormulaError("a subscript is made of letters, digits and commas", span=piece.span)
            said += piece.text if piece.kind in _OF_INDICES else "_" if piece.kind in _PARTING_WORDS else ""
            index += 1
        return said, end

    def _function(self, index: int) -> int:
        piece = self.pieces[index]
        function = piece.text.removeprefix("\\")
        if self._kind(index + 1) == "lowered":
            raise FormulaError(f"{function} has no subscript; a logarithm is the natural one", span=piece.span)
        if self._kind(index + 1) == "raised":
            end = self._argument_end(index + 1)
            if function in INVERSES and self._exponent(index + 1) == "-1":
                self._emit("FUNCTION", INVERSES[function], (piece.span[0], self.pieces[end - 1].span[1]))
                return end
            self._check_raised_function(function, index + 1)
        self._emit("FUNCTION", function, piece.span)
        return index + 1

    def _exponent(self, index: int) -> str:
        inside = self.pieces[index + 1 : self._argument_end(index)]
        return "".join(piece.text for piece in inside if piece.text not in _INVISIBLE)

    def _check_raised_function(self, function: str, index: int) -> None:
        exponent = self._exponent(index)
        span = (self.pieces[index].span[0], self.pieces[self._argument_end(index) - 1].span[1])
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
        text = piece.text
        if text == "(" and self._is_transpose(self.partner[index] + 1):
            text = "["  # (x, y)^T is a column
        self._emit(kind, text, piece.span)
        return index + 1

    def _is_transpose(self, index: int) -> bool:
        """Whether a transpose stands here, be it a T that could be a symbol."""
        return self._kind(index) == "transposed" or (self._kind(index) == "raised" and self._exponent_is_t(index))

    def _exponent_is_t(self, index: int) -> bool:
        inside = [piece for piece in self.pieces[index + 1 : index + 4] if piece.text not in _INVISIBLE]
        is_braced = self._kind(index + 1) == "open"
        return bool(inside) and inside[0].text == "T" and (not is_braced or self._argument_end(index) == index + 4)

    def _prime(self, index: int) -> int:
        """A prime behind a bracket or a matrix, which are transposed by it; behind a letter it is part of its name."""
        if not index or self.pieces[index - 1].kind != "close":
            return self._sign(index)
        self._emit("TRANSPOSED", "T", self.pieces[index].span)
        return index + 1

    def _raised(self, index: int) -> int:
        if self._exponent_is_t(index) and self._is_of_matrix(index):
            end = self._argument_end(index)
            self._emit("TRANSPOSED", "T", (self.pieces[index].span[0], self.pieces[end - 1].span[1]))
            return end
        end = self._argument(index)
        digit = end - 1
        if digit in self.alone and self._kind(digit) == self._kind(end) == "digit" and self._touches(end):
            raise FormulaError(
                "only the first digit is raised: write ^{...} around them all", span=self.pieces[end].span
            )
        self._emit("RAISED", "^", self.pieces[index].span)
        return index + 1

    def _is_of_matrix(self, index: int) -> bool:
        """Whether a T that is raised is no symbol, judged by what it is raised behind."""
        before = self.pieces[index - 1] if index else self.pieces[index]
        letter = self.letters.get(len(self.tokens) - 1)
        is_array = letter is not None and (
            letter.is_bold or not self.shapes.keys().isdisjoint({letter.base, *possible_names(letter)})
        )
        if is_array or before.text == "]" or before.text.startswith("\\end"):
            return True
        if "T" in self.names:
            return False
        if self._has_symbol_t and (letter is None or letter.base != "e"):
            raise FormulaError(
                "^T may mean a transpose or a power by T: write ^{\\top} for the transpose",
                span=self.pieces[index].span,
            )
        return letter is None or letter.base != "e"

    @cached_property
    def _has_symbol_t(self) -> bool:
        """Whether a T stands elsewhere than raised alone."""
        all_ts = sum(piece.text == "T" and piece.kind in {"letter", "word"} for piece in self.pieces)
        raised = sum(piece.kind == "raised" and self._exponent_is_t(at) for at, piece in enumerate(self.pieces))
        return all_ts > raised

    def _sum(self, index: int) -> int:
        """A sum, then its index, which is no factor of it."""
        self._emit("BIGSUM", self.pieces[index].text, self.pieces[index].span)
        return index + 1

    def _fraction(self, index: int) -> int:
        self._check_derivative(index)
        self._emit("FRACTION", self.pieces[index].text, self.pieces[index].span)
        self._argument(self._argument(index) - 1)
        return index + 1

    def _check_derivative(self, index: int) -> None:
        end = self.partner.get(index + 1, index + 1)
        above, below = self.pieces[index + 1 : index + 3], self.pieces[end + 1 : end + 4]
        parts = [[piece for piece in part if piece.text != "{"] for part in (above, below)]
        if all(part and part[0].text == "d" for part in parts) and len(parts[1]) > 1 and "d" not in self.names:
            raise FormulaError("this may be a derivative: write it out, or \\dot{x}", span=self.pieces[index].span)

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
        if piece.kind == "equals":
            raise FormulaError("= is not read: give the right-hand side alone", span=piece.span)
        if piece.kind not in _SIGN_TOKENS:
            raise FormulaError(f"{piece.text} stands only behind a letter, or in a subscript", span=piece.span)
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


def _is_of_time(below: str) -> bool:
    """Whether a subscript is an index of time with a sign in it, k|k-1, and not a word."""
    return any(sign in below for sign in "|+-/")


def _as_name(below: str) -> str:
    return "".join(map(spelled, below))
