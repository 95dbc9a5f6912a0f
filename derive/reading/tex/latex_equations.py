r"""The equations of a piece of a paper: what stands left and right of the equals signs, without what only sets them.

Delimiters, environments, tags, labels, alignment and the punctuation behind a formula are overwritten with spaces, so
that all that is left stands where the paper has it.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from radartrack.derive.formula.error import FormulaError, Span

MAX_EQUATIONS = 60
MAX_ROWS = 300
MOST_SIGNS_BEHIND = 3  # a decimal point, a comma, and a word in place of one
LONGEST_NUMBER = 40  # characters of the number of an equation with the spaces before it

_DISPLAYS = (
    "equation", "align", "alignat", "aligned", "alignedat", "flalign", "gather", "gathered", "multline", "multlined",
    "split", "eqnarray", "math", "displaymath", "subequations", "IEEEeqnarray", "dmath",
)  # fmt: skip
_DISPLAY = "|".join(_DISPLAYS)
_SET = re.compile(
    rf"""
    (?P<kept> \\\\ | \\[%$] )
    | (?P<comment> %[^\n]* )
    | (?P<word> \\(?:text|mbox|mathrm|textrm)\s*\{{[\s,]*(?:(?:and|where|with|or)[\s,]*|,\s*)\}} )
    | (?P<end> \\end\s*\{{\s*(?:{_DISPLAY})\*?\s*\}} | \\\] | \$\$ )
    | (?P<begin> \\begin\s*\{{\s*(?:{_DISPLAY})\*?\s*\}}
        (?: (?<=at\}})\s*\{{\d+\}} | (?<=array\}})\s*\{{[lcrLCR]+\}} | (?<=(?:ed|it)\}})\s*\[[tcb]\] )? | \\\[ )
    | (?P<set> \\(?:tag\*?|label|intertext)\s*\{{[^{{}}]*\}} | \\(?:nonumber|notag|hfill|qedhere|allowbreak)(?![A-Za-z])
        | \\[()] | \$ | \\l?eqno\s*(?:\([^()]*\)|\{{[^{{}}]*\}}) )
    """,
    re.VERBOSE,
)
RELATION = (
    r"\\stackrel\s*\{[^{}]*\}\s*\{\s*=\s*\} | \\(?:triangleq|coloneqq|coloneq|doteq|approx|equiv|simeq|cong|eqdef)"
    r"(?![A-Za-z]) | \\overset\s*\{[^{}]*\}\s*\{\s*=\s*\} | :\s*= | ="
)
_DOLLAR = re.compile(r"(?<![\\$])\$(?!\$)")
_DELIMITED = re.compile(r"\\begin|\\\[|\$\$|\\\(")
_RELATION = re.compile(RELATION, re.VERBOSE)
_DEFINING = re.compile(
    r"\n(?=\s*(?:\\[A-Za-z]+\s*\{?\s*\\?[A-Za-z]*\}?|[A-Za-z])'*(?:[_^](?:\{[^{}]*\}|[A-Za-z0-9]))*'*\s*&?\s*"
    rf"(?:{RELATION}))",
    re.VERBOSE,
)
_ENVIRONMENT = re.compile(r"\\begin\s*\{(?P<name>\w+)\}.*?\\end\s*\{(?P=name)\}", re.DOTALL)
_GOES_ON = re.compile(r"(?:[-+*/=,;(\[&{^_]|\\(?:cdot|times|\\|q?quad))\s*$")
_NESTING = ((r"(?<!\\)\{", r"(?<!\\)\}"), (r"\\begin", r"\\end"), (r"[(\[]", r"[)\]]"))
_PART = re.compile(
    rf"""
    (?P<relation> {RELATION} )
    | (?P<open> \\begin\s*\{{\s*[A-Za-z]+\s*\}} | (?<!\\)\{{ )
    | (?P<close> \\end\s*\{{\s*[A-Za-z]+\s*\}} | (?<!\\)\}} )
    | (?P<row> \\\\(?:\s*\[\s*-?[\d.]+\s*[a-z]{{2}}\s*\])? )
    | (?P<left> [(\[] | \\\{{ | \\lbrace(?![A-Za-z]) )
    | (?P<right> [)\]] | \\\}} | \\rbrace(?![A-Za-z]) )
    | (?P<comma> [,;] | \\q?quad(?![A-Za-z]) )
    | (?P<column> & )
    | \\[A-Za-z]+ | \\.
    """,
    re.VERBOSE | re.DOTALL,
)
_CONTINUES = re.compile(r"(?:\s|\\[,;:!>]|\\(?:quad|qquad|left|right|[bB]igg?[lr]?)(?![A-Za-z])|\{\})*"
                        r"(?:[-+*/)\]]|\\(?:cdot|times)(?![A-Za-z]))")  # fmt: skip
_SPACE = r"(?:\s|~|\\[,;:!> ]|\\(?:quad|qquad)(?![A-Za-z])|\{\})"
_BLANK = re.compile(rf"{_SPACE}*")
_SPACES_BEHIND = ("\\,", "\\;", "\\:", "\\!", "\\>", "\\quad", "\\qquad", "~")
_NUMBERED = re.compile(r"(?:~|\\[,;:> ]|\\q?quad(?![A-Za-z])|\s\s)\s*(?P<number>\(\d{1,3}[a-z]?\))$")
_NULL = re.compile(r"\\(?P<side>left|right)\s*\.")
# Equations under each other behind a brace: a system, unlike the branches of one function, has a relation in each row.
_SYSTEM = re.compile(
    r"(?P<open>\\left\s*(?:\\\{|\\lbrace)\s*|\\\{\s*)?"
    r"(?P<begin>\\begin\s*\{(?P<name>[dr]?cases|array)\}(?:\s*\{[lcr|@{}\s]*\})?)"
    r"(?P<body>(?:(?!\\(?:begin|end)\s*\{(?P=name)\}).)*)(?P<end>\\end\s*\{(?P=name)\})(?P<close>\s*\\right\s*\.)?",
    re.DOTALL,
)
_BRACED_DISPLAY = re.compile(
    r"(?P<open>\\left\s*(?:\\\{|\\lbrace)\s*)(?P<inside>\\begin\s*\{(?P<name>aligned|alignedat|split|gathered)\}"
    r"(?:(?!\\begin).)*?\\end\s*\{(?P=name)\}\s*)(?P<close>\\right\s*\.)",
    re.DOTALL,
)
_RELATED = re.compile(rf"(?:{RELATION})\s*$", re.VERBOSE)


@dataclass(frozen=True, slots=True)
class Equation:
    """The sides of an equation, as long as what it was cut from, with spaces for all else; the left may be empty."""

    left: str
    right: str


def equations(source: str) -> list[Equation]:
    """All equations, in order; a formula alone is one without a left side.

    Raises:
        FormulaError: for an equation without a right side, and for more than are read.
    """
    bare = _without_setting(source)
    found = [_equation(bare, *line) for line in _lines(bare, aligned=bare != source)]
    if not found:
        raise FormulaError("the formula is empty")
    return found


def without_formula_before(equation: Equation) -> tuple[str, Equation]:
    r"""What stands before the name that an equation defines, \lambda r in `\lambda r, \lambda = 2`; the equation."""
    commas = [span for kind, span in _outer(equation.left) if kind == "comma"]
    if not commas:
        return "", equation
    cut = commas[-1]
    length = len(equation.left)
    before = _without_punctuation(_overwritten(equation.left, [(cut[0], length)]))
    return before, Equation(_overwritten(equation.left, [(0, cut[1])]), equation.right)


def _without_setting(source: str) -> str:
    """The source without delimiters and comments; a display that ends, ends a line, a word between two is a comma."""

    def replaced(found: re.Match[str]) -> str:
        if found["kept"]:
            return found.group()
        blank = " " * len(found.group())
        if found["word"]:
            return "," + blank[1:]
        return "\\\\" + blank[2:] if found["end"] else blank

    source = _without_words_between(source)
    source = _BRACED_DISPLAY.sub(
        lambda found: f"{' ' * len(found['open'])}{found['inside']}{' ' * len(found['close'])}", source
    )
    bare = _with_lines_parted(_SET.sub(replaced, source))
    bare = _without_braces(bare)
    sides = [found["side"] for found in _NULL.finditer(bare)]
    if sides.count("left") == sides.count("right"):  # brackets that go over two lines
        bare = _NULL.sub(lambda found: " " * len(found.group()), bare)
    return bare


def _without_words_between(source: str) -> str:
    """Formulas of a sentence, each between two dollars, parted by a semicolon and without the words around them."""
    places = [found.start() for found in _DOLLAR.finditer(source)]
    if len(places) < 2 * 2 or len(places) % 2 or _DELIMITED.search(source):
        return source
    gaps = [(0, places[0]), *zip(places[1:-1:2], places[2::2], strict=True), (places[-1] + 1, len(source))]
    bare = _overwritten(source, [(start, end + 1) for start, end in gaps])
    for start, _ in gaps[1:-1]:
        bare = f"{bare[:start]};{bare[start + 1 :]}"
    return bare


def _with_lines_parted(bare: str) -> str:
    """Equations on a line each parted by a semicolon: a line that begins with what it defines goes on with none."""
    for found in _DEFINING.finditer(bare):
        before = _ENVIRONMENT.sub("0", bare[: found.start()])
        is_inside = any(len(re.findall(one, before)) > len(re.findall(other, before)) for one, other in _NESTING)
        if not is_inside and _RELATION.search(before.rsplit("\\\\", 1)[-1]) and not _GOES_ON.search(before):
            bare = f"{bare[: found.start()]};{bare[found.start() + 1 :]}"
    return bare


def _without_braces(text: str) -> str:
    """A text where equations under each other behind a brace stand without it, each place as it was."""
    return _SYSTEM.sub(_without_brace, text)


def _without_brace(found: re.Match[str]) -> str:
    """The equations of a system without the brace before them; what is no system stays as it is."""
    rows = [row for row in found["body"].split("\\\\") if not _BLANK.fullmatch(row)]
    related = all("=" in (row.split("&")[0] if "if" in row or "text" in row else row) for row in rows)
    if not rows or not related or _RELATED.search(found.string, 0, found.start()):
        return found.group()
    blank = {name: " " * len(found[name] or "") for name in ("open", "begin", "end", "close")}
    return f"{blank['open']}{blank['begin']}{found['body']}\\\\{blank['end'][2:]}{blank['close']}"


def _lines(bare: str, *, aligned: bool) -> Iterator[tuple[list[Span], list[Span]]]:
    """Of each equation the columns and relations within it, and the stretches between relations.

    A row that begins with a sign goes on with the equation before it; rows without any relation are left to the
    grammar, which refuses them.
    """
    found = list(_outer(bare))
    relations = [span for kind, span in found if kind == "relation"]
    if len(relations) > MAX_EQUATIONS:
        raise FormulaError(f"at most {MAX_EQUATIONS} equations are read together", span=relations[MAX_EQUATIONS])
    has_relations = bool(relations)
    rows = [span for kind, span in found if kind == "row"] if has_relations or aligned else []
    marks = [span for kind, span in found if kind == "column"] if has_relations or aligned else []
    if len(rows) > MAX_ROWS:
        raise FormulaError(f"a formula has at most {MAX_ROWS} rows", span=rows[MAX_ROWS])
    commas = [span for kind, span in found if kind == "comma"]
    joined: list[list[Span]] = []  # the stretches of an equation, one or more rows
    aligned_away = _overwritten(bare, marks)
    for start, end in _between(rows, len(bare)):
        if _BLANK.fullmatch(aligned_away, start, end):
            continue
        first = _first(relations, start, end)
        is_chained = first < end and bool(_BLANK.fullmatch(aligned_away, start, first))
        goes_on = first == end and bool(_CONTINUES.match(aligned_away, start, end))
        if joined and (is_chained or goes_on):
            joined[-1].append((start, end))
        else:
            joined.append([(start, end)])
    for stretches in joined:
        for one in _parted(stretches, relations, commas):
            ends = (one[0][0], one[-1][1])
            breaks = [span for span in rows + marks if ends[0] <= span[0] < ends[1]]
            yield breaks, list(_sides(ends, _within(relations, ends)))


def _parted(stretches: list[Span], relations: list[Span], commas: list[Span]) -> list[list[Span]]:
    """Equations side by side, x = a, y = b; what has no relation belongs to its neighbour."""
    whole = (stretches[0][0], stretches[-1][1])
    cuts = [whole[0], *(end for _, end in _within(commas, whole)), whole[1]]
    parts: list[Span] = []
    for start, end in pairwise(cuts):
        if parts and not (_within(relations, parts[-1]) and _within(relations, (start, end))):
            parts[-1] = (parts[-1][0], end)
        else:
            parts.append((start, end))
    return [[part] for part in parts]


def _outer(bare: str) -> Iterator[tuple[str, Span]]:
    """What parts equations, outside of braces and matrices; relations and commas outside of brackets too."""
    depth = brackets = 0
    for part in _PART.finditer(bare):
        kind = part.lastgroup or ""
        depth += (kind == "open") - (kind == "close")
        brackets += (kind == "left") - (kind == "right")
        if kind == "row" and depth <= 0:
            brackets = 0
        if depth <= 0 and (kind in {"row", "column"} or (kind in {"relation", "comma"} and brackets <= 0)):
            yield kind, part.span()


def _equation(bare: str, breaks: Sequence[Span], sides: Sequence[Span]) -> Equation:
    clean = _overwritten(bare, breaks)
    shown = [side for side in sides if not _BLANK.fullmatch(clean, *side)]
    if not shown:
        return Equation("", bare)
    right = _only(clean, shown[-1])
    formula = _without_punctuation(right)
    if numbered := _NUMBERED.search(formula, max(len(formula) - LONGEST_NUMBER, 0)):
        raise FormulaError(
            f"{numbered['number']} may be the number of the equation or a factor: write \\tag{{...}} or \\cdot",
            span=numbered.span("number"),
        )
    if len(sides) > 1 and (shown[-1] != sides[-1] or not formula.strip()):
        raise FormulaError("nothing stands right of this relation", span=(sides[-1][0] - 1, sides[-1][0]))
    return Equation(_only(clean, sides[0]) if len(sides) > 1 else "", formula.ljust(len(right)))


def _without_punctuation(text: str) -> str:
    """A formula without the spaces and the punctuation behind it; a word that parts two equations is a comma too."""
    text = _without_spaces(text)
    for _ in range(MOST_SIGNS_BEHIND):
        text = _without_spaces(text[:-1]) if text.endswith((".", ",", ";")) else text
    return text


def _without_spaces(text: str) -> str:
    text = text.rstrip()
    while behind := next((space for space in _SPACES_BEHIND if text.endswith(space)), ""):
        text = text.removesuffix(behind).rstrip()
    if text.endswith("\\") and not text.endswith("\\\\"):  # a backslash and the space that is gone
        return _without_spaces(text[:-1])
    return text


def _sides(ends: Span, relations: Sequence[Span]) -> Iterator[Span]:
    yield from _between_spans(relations, *ends)


def _between(cuts: Sequence[Span], length: int) -> list[Span]:
    return list(_between_spans(cuts, 0, length))


def _between_spans(cuts: Sequence[Span], start: int, end: int) -> Iterator[Span]:
    for cut in cuts:
        yield start, cut[0]
        start = cut[1]
    yield start, end


def _within(spans: Sequence[Span], ends: Span) -> list[Span]:
    return [span for span in spans if ends[0] <= span[0] < ends[1]]


def _first(spans: Sequence[Span], start: int, end: int) -> int:
    return next((span[0] for span in spans if start <= span[0] < end), end)


def _overwritten(text: str, spans: Sequence[Span]) -> str:
    characters = list(text)
    for start, end in spans:
        characters[start:end] = " " * (end - start)
    return "".join(characters)


def _only(text: str, kept: Span) -> str:
    start, end = kept
    return " " * start + text[start:end] + " " * (len(text) - end)
