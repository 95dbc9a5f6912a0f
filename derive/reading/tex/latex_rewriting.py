r"""Brings pieces of LaTeX into the one form that the grammar reads, whatever the dialect.

Fonts are taken off and remembered for matrices, braces that group nothing are dropped (`{{\sin }^{2}}\theta`), primes
and stars become decorations, `{a \over b}` becomes a fraction, and the parts of a sum or an integral are put in one
order.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from radartrack.derive.formula.error import FormulaError, Span
from radartrack.derive.formula.latex_names import GREEK
from radartrack.derive.formula.limits import MAX_DEPTH, check_brackets
from radartrack.derive.reading.tex.latex_pieces import BOLD, CLOSERS, Piece

_SYMBOLS = frozenset({"letter", "greek", "word"})
_TAKES_AN_ARGUMENT = frozenset({"raised", "lowered", "accent", "root", "fraction", "function"})
_DECORATING = {"*": "star", "\\ast": "star", "\\star": "star", "+": "plus", "-": "minus"}
_TRANSPOSING = frozenset({"\\top", "\\intercal", "\\dagger"})
_BIG = frozenset({"bigsum", "integral"})


def rewritten(found: list[Piece]) -> list[Piece]:
    """The pieces of a formula in one dialect.

    Raises:
        FormulaError: for brackets without partners, and for sums and integrals that lack a part.
    """
    steps: tuple[Callable[[list[Piece]], list[Piece]], ...] = (
        _with_degrees,
        _with_bars,
        _with_rows,
        _without_last_columns,
        _without_fonts,
        _without_braces,
        _with_decorations,
        _with_fractions,
        _without_whole_groups,
        _with_big_operators,
    )
    for step in steps:
        found = step(found)
    return found


def partners(found: Sequence[Piece]) -> dict[int, int]:
    """Where the bracket that a piece opens is closed.

    Raises:
        FormulaError: for one without a partner, or nested too deeply.
    """
    places = [index for index, piece in enumerate(found) if piece.kind in {"open", "close"}]
    pairs = check_brackets([(found[index].text, found[index].span) for index in places], CLOSERS)
    return {places[opener]: places[closer] for opener, closer in pairs.items()}


def _with_degrees(found: list[Piece]) -> list[Piece]:
    r"""90^\circ as \frac{90\pi}{180}.

    Raises:
        FormulaError: where the sign does not stand behind a number.
    """
    if not any(piece.kind == "degree" for piece in found):
        return found
    result: list[Piece] = []
    index = 0
    while index < len(found):
        piece = found[index]
        said, end = _raised(found, index) if piece.kind == "raised" else ([piece], index + 1)
        if [one.kind for one in said] != ["degree"]:
            result.append(piece)
            index += 1
            continue
        start = len(result)
        while start and result[start - 1].kind == "digit":
            start -= 1
        if start == len(result):
            raise FormulaError(f"{said[0].text} stands behind a number: angles are in radians", span=piece.span)
        span = _span(result[start], found[end - 1])
        above = [*result[start:], Piece("greek", "\\pi", span)]
        below = [Piece("digit", one, (span[1] + at, span[1] + at + 1)) for at, one in enumerate("180")]  # side by side
        result[start:] = [Piece("fraction", "\\frac", span), *_braced(above), *_braced(below)]
        index = end
    return result


def _with_bars(found: list[Piece]) -> list[Piece]:
    r"""\norm{...} and \abs{...} as |...|.

    Raises:
        FormulaError: where no brace follows.
    """
    if not any(piece.kind == "bars" for piece in found):
        return found
    pairs, result = partners(found), list(found)
    for index, piece in enumerate(found):
        if piece.kind == "bars":
            if index + 1 not in pairs or found[index + 1].text != "{":
                raise FormulaError(f"{piece.text} takes what follows in braces: {piece.text}{{r}}", span=piece.span)
            for at, bar in ((index + 1, "\\lvert"), (pairs[index + 1], "\\rvert")):
                result[at] = replace(found[at], text=bar)
    return [piece for piece in result if piece.kind != "bars"]


def _with_rows(found: list[Piece]) -> list[Piece]:
    r"""[a, b; c, d] as a matrix.

    Raises:
        FormulaError: for a semicolon elsewhere.
    """
    pairs, result = partners(found), list(found)
    for opener, marks in _parting(found).items():
        first = next((mark for mark in marks if found[mark].kind == "semicolon"), None)
        if first is None:
            continue
        if opener < 0 or found[opener].text != "[":
            raise FormulaError("; is not read: rows are parted by it in [a, b; c, d] only", span=found[first].span)
        for index, text in ((opener, "\\begin{bmatrix}"), (pairs[opener], "\\end{bmatrix}")):
            result[index] = replace(found[index], text=text)
        for mark in marks:
            result[mark] = replace(found[mark], kind="newline" if found[mark].kind == "semicolon" else "column")
    return result


def _without_last_columns(found: list[Piece]) -> list[Piece]:
    r"""a & b & \\\\ without the last column of a matrix, where all its rows end so."""
    last: dict[int, list[int]] = {}  # by where a matrix opens, the signs before what ends its rows
    opened: list[int] = []
    for index, piece in enumerate(found):
        if opened and (piece.kind == "newline" or (piece.kind == "close" and found[index - 1].kind != "newline")):
            last.setdefault(opened[-1], []).append(index - 1)
        if piece.kind == "open":
            opened.append(index)
        elif piece.kind == "close" and opened:
            opened.pop()
    empty = (ends for ends in last.values() if all(found[end].kind == "column" for end in ends))
    dropped = {end for ends in empty for end in ends}
    return [piece for index, piece in enumerate(found) if index not in dropped] if dropped else found


def _parting(found: Sequence[Piece]) -> dict[int, list[int]]:
    """The commas and semicolons that stand directly in each bracket, by where that opens; -1 for those in none."""
    opened = [-1]
    marks: dict[int, list[int]] = {}
    for index, piece in enumerate(found):
        if piece.kind == "open":
            opened.append(index)
        elif piece.kind == "close":
            opened.pop()
        elif piece.kind in {"comma", "semicolon"}:
            marks.setdefault(opened[-1], []).append(index)
    return marks


def _without_fonts(found: list[Piece]) -> list[Piece]:
    r"""Letters without \mathbf{...}, {\bf ...} and the like; those that are bold know it, upright ones are words."""
    if not any(piece.kind in {"font", "roman"} for piece in found):
        return found
    pairs = partners(found)
    bold_to = upright_to = -1
    dropped: set[int] = set()
    ends: list[int] = []  # of the groups that are open
    result: list[Piece] = []
    for index, piece in enumerate(found):
        if piece.text == "{" and index in pairs:
            ends.append(pairs[index])
        elif ends and index == ends[-1]:
            ends.pop()
        if piece.kind in {"font", "roman"}:
            opener = index + 1
            has_argument = opener in pairs and found[opener].text == "{" and piece.text not in _SWITCHES
            end = pairs[opener] if has_argument else (ends[-1] if ends else len(found)) - 1
            end = end if has_argument or piece.text in _SWITCHES else opener
            if has_argument and (not index or found[index - 1].kind not in _TAKES_AN_ARGUMENT - {"function"}):
                dropped |= {opener, end}
            bold_to = max(bold_to, end) if piece.text in BOLD else bold_to
            upright_to = max(upright_to, end) if piece.kind == "roman" else upright_to
        elif index not in dropped:
            is_upright = index <= upright_to
            is_word = is_upright and piece.kind == "letter"
            before = result[-1] if result else None
            goes_on = before is not None and before.kind == "word" and before.span[1] == piece.span[0]
            if before and goes_on and is_upright and piece.kind in {"letter", "digit"}:
                result[-1] = replace(before, text=before.text + piece.text, span=_span(before, piece))
            else:
                result.append(replace(piece, kind="word" if is_word else piece.kind, is_bold=index <= bold_to))
    return result


_SWITCHES = frozenset({"\\bf", "\\rm", "\\it", "\\cal", "\\sf"})  # they hold to the end of their group


def _without_braces(found: list[Piece]) -> list[Piece]:
    r"""Groups of nothing, of one symbol, or of a function and its power are no groups, unless somebody takes them."""
    partners(found)
    result: list[Piece] = []
    waiting: list[tuple[int, bool, int]] = []  # where a brace stands, whether it is an argument, how many more follow
    owed = 0  # arguments that what stands before still takes
    for index, piece in enumerate(found):
        if piece.text == "{":
            waiting.append((len(result), owed > 0, max(owed - 1, 0)))
            result.append(piece)
            owed = 0
        elif piece.text == "}":
            start, is_argument, owed = waiting.pop()
            inside = result[start + 1 :]
            is_of_function = bool(start) and result[start - 1].kind == "function"
            if not inside and (is_of_function or not is_argument):  # it keeps a space or a sign: \sin{} x, {}+ b
                del result[start:]
                owed = int(is_of_function)
            elif (is_argument and not (is_of_function and _is_lowered(found, index + 1))) or not _is_one(inside):
                result.append(piece)
            else:
                result[start:] = inside
                owed = int(inside[0].kind == "function")
        else:
            owed = _owed(piece, result, owed)
            result.append(piece)
    return result


def _is_lowered(found: Sequence[Piece], index: int) -> bool:
    r"""Whether a subscript stands here, as in \cos {\theta }_{k}: braces before it are around a letter."""
    return index < len(found) and found[index].kind == "lowered"


def _without_whole_groups(found: list[Piece]) -> list[Piece]:
    r"""Groups that are all between brackets or of an entry of a matrix are no groups: \left( {a + b} \right), {{a}}."""
    pairs = partners(found)
    dropped: set[int] = set()
    for opener, closer in sorted(pairs.items()):  # outer groups first
        is_doubled = found[opener - 1].text == "{" and pairs.get(opener - 1) == closer + 1
        is_whole = is_doubled or (_begins(found, opener, dropped) and _ends(found, closer, dropped))
        if found[opener].text == "{" and is_whole:
            dropped |= {opener, closer}
    return [piece for index, piece in enumerate(found) if index not in dropped]


def _begins(found: Sequence[Piece], index: int, dropped: set[int]) -> bool:
    """Whether nothing stands before a piece between brackets, or in an entry."""
    before = index - 1
    while before in dropped:
        before -= 1
    return before >= 0 and (found[before].kind in _PARTS_ENTRIES or _is_bracket(found[before], "open"))


def _ends(found: Sequence[Piece], index: int, dropped: set[int]) -> bool:
    """Whether nothing stands behind it."""
    after = index + 1
    while after in dropped:
        after += 1
    return after < len(found) and (found[after].kind in _PARTS_ENTRIES or _is_bracket(found[after], "close"))


def _is_bracket(piece: Piece, kind: str) -> bool:
    return piece.kind == kind and piece.text not in {"{", "}"}


_PARTS_ENTRIES = frozenset({"column", "newline"})


def _owed(piece: Piece, before: Sequence[Piece], owed: int) -> int:
    r"""How many arguments in braces a piece is followed by."""
    if piece.kind == "fraction":
        return 2
    if piece.kind in _TAKES_AN_ARGUMENT:  # \sin^{2}{\theta} has two
        return 1 + (piece.kind == "raised" and bool(before) and before[-1].kind == "function")
    if piece.text == "[" and before and before[-1].kind == "root":
        return 2  # the index, and the radicand
    if piece.text == "]":
        return owed
    return 0 if piece.kind == "open" else max(owed - 1, 0)


def _is_one(inside: Sequence[Piece]) -> bool:
    if len(inside) == 1:
        return inside[0].kind in _SYMBOLS | {"function"}
    is_power = len(inside) > 2 and inside[0].kind == "function" and inside[1].kind == "raised"
    return is_power and _is_argument(inside[2:])


def _is_argument(pieces: Sequence[Piece]) -> bool:
    is_group = pieces[0].text == "{" and pieces[-1].text == "}" and sum(piece.text == "{" for piece in pieces) == 1
    return len(pieces) == 1 or is_group


def _with_decorations(found: list[Piece]) -> list[Piece]:
    r"""A raised prime, star or sign is a decoration, a raised \top a transpose."""
    result: list[Piece] = []
    index = 0
    while index < len(found):
        piece = found[index]
        said, end = _raised(found, index) if piece.kind == "raised" else ([], index + 1)
        made = _decorations(said, is_braced=end > index + 2)
        if made:
            kind, words = made
            result += [Piece(kind, word, _span(piece, found[end - 1])) for word in words]
            index = end
        else:
            result.append(piece)
            index += 1
    return result


def _raised(found: Sequence[Piece], index: int) -> tuple[list[Piece], int]:
    """A short exponent, and where it ends."""
    if index + 1 < len(found) and found[index + 1].text != "{":
        return [found[index + 1]], index + 2
    for end in range(index + 2, min(index + 6, len(found))):
        if found[end].text == "}":
            return list(found[index + 2 : end]), end + 1
    return [], index + 1


def _decorations(said: Sequence[Piece], *, is_braced: bool) -> tuple[str, Sequence[str]] | None:
    """What an exponent says that is none: the kind of piece, and the words."""
    if said and all(one.kind == "prime" for one in said):
        return "prime", ["prime"] * len(said)
    if len(said) != 1:
        return None
    text = said[0].text
    if text in _TRANSPOSING or (text == "T" and said[0].kind == "word"):
        return "transposed", "T"
    return ("prime", [_DECORATING[text]]) if text in _DECORATING and (is_braced or text not in "+-") else None


def _with_fractions(found: list[Piece]) -> list[Piece]:
    r"""`{a \over b}` as `{\frac{a}{b}}`."""
    if not any(piece.kind == "over" for piece in found):
        return found
    if _has_over_outside(found):
        found = _braced(found)
    pairs, over = partners(found), _overs(found)
    ends = {pairs[opener] for opener in over}
    result: list[Piece] = []
    for index, piece in enumerate(found):
        opens, closes = Piece("open", "{", piece.span), Piece("close", "}", piece.span)
        if index in over:
            result += [opens, Piece("fraction", "\\over", piece.span), opens]
        elif piece.kind == "over":
            result += [closes, opens]
        else:
            result += [closes, piece] if index in ends else [piece]
    return result


def _overs(found: Sequence[Piece]) -> dict[int, int]:
    """Where the line of a fraction stands in the braces that open at each place."""
    groups: list[int] = []
    over: dict[int, int] = {}
    for index, piece in enumerate(found):
        if piece.kind == "open":
            groups.append(index)
        elif piece.kind == "close":
            groups.pop()
        elif piece.kind == "over":
            if not groups or found[groups[-1]].text != "{" or groups[-1] in over:
                raise FormulaError("write one \\over in braces: {a \\over b}", span=piece.span)
            over[groups[-1]] = index
    return over


def _has_over_outside(found: Sequence[Piece]) -> bool:
    depth = 0
    for piece in found:
        depth += (piece.kind == "open") - (piece.kind == "close")
        if piece.kind == "over" and not depth:
            return True
    return False


def _with_big_operators(found: list[Piece]) -> list[Piece]:
    r"""\sum_{j=1}^{k} and \int_0^T ... ds with the index first, then both limits in braces."""
    operators = [index for index, piece in enumerate(found) if piece.kind in _BIG]
    if len(operators) > MAX_DEPTH:
        raise FormulaError(f"at most {MAX_DEPTH} sums and integrals are read", span=found[operators[MAX_DEPTH]].span)
    for index in reversed(operators):
        found = (_sum if found[index].kind == "bigsum" else _integral)(found, index)
    return found


def _sum(found: list[Piece], index: int) -> list[Piece]:
    lower, upper, end = _limits(found, index)
    equals = next((at for at, piece in enumerate(lower) if piece.kind == "equals"), 0)
    span = _span(found[index], found[end - 1])
    if not equals or not _is_one(lower[:equals]) or not lower[equals + 1 :]:
        raise FormulaError("a sum says its index and both limits: \\sum_{j=1}^{k}", span=span)
    big = replace(found[index], span=span)
    return [*found[:index], big, *lower[:equals], *_braced(lower[equals + 1 :]), *_braced(upper), *found[end:]]


def _integral(found: list[Piece], index: int) -> list[Piece]:
    lower, upper, end = _limits(found, index)
    at = _differential(found, end)
    name = GREEK.get(found[at + 1].text, found[at + 1].text)
    differential = Piece("differential", name, _span(found[at], found[at + 1]))
    body = found[end:at] or [Piece("digit", "1", differential.span)]
    return [*found[: index + 1], *_braced(lower), *_braced(upper), *body, differential, *found[at + 2 :]]


def _differential(found: Sequence[Piece], index: int) -> int:
    r"""Where the `ds` of an integral stands that begins here."""
    depth = 0
    for at in range(index, len(found) - 1):
        depth += (found[at].kind == "open") - (found[at].kind == "close")
        if depth < 0:
            break
        is_d = found[at].text == "d" and found[at].kind in _SYMBOLS
        if not depth and is_d and found[at + 1].kind in {"letter", "greek"}:
            return at
    raise FormulaError("an integral ends with its variable: \\int_0^T ... \\, ds", span=found[index - 1].span)


def _limits(found: Sequence[Piece], index: int) -> tuple[list[Piece], list[Piece], int]:
    """What stands below and above an operator, and where that ends."""
    said: dict[str, list[Piece]] = {}
    at = index + 1
    while at + 1 < len(found) and found[at].kind in {"raised", "lowered"} and found[at].kind not in said:
        kind = found[at].kind
        end = at + 2 if found[at + 1].text != "{" else _closing(found, at + 1) + 1
        said[kind] = list(found[at + 1 : end]) if end == at + 2 else list(found[at + 2 : end - 1])
        at = end
    if not said.get("lowered") or not said.get("raised"):
        raise FormulaError(
            "both limits are needed: write it as \\sum_{j=1}^{k} or \\int_{0}^{T}", span=found[index].span
        )
    return said["lowered"], said["raised"], at


def _closing(found: Sequence[Piece], index: int) -> int:
    """Where a brace is closed; all are."""
    depth = 0
    while True:
        depth += (found[index].text == "{") - (found[index].text == "}")
        if not depth:
            return index
        index += 1


def _braced(inside: Sequence[Piece]) -> list[Piece]:
    return [Piece("open", "{", inside[0].span), *inside, Piece("close", "}", inside[-1].span)]


def _span(first: Piece, last: Piece) -> Span:
    return first.span[0], last.span[1]
