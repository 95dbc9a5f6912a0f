"""What to write instead of what the grammar of typed formulas does not read."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from types import MappingProxyType

from radartrack.derive.formula.functions import SPELLINGS

_LAST = re.compile(r"(?:[A-Za-z_]\w*|(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?|[)\]|])$")
_OPERAND = re.compile(r"[\w.(|]")
_FOREIGN = MappingProxyType(
    {
        "=": "give the right-hand side alone, without an equals sign",
        "[": "entries are picked by numbers, such as A[0,1] or A[0:2,0]; a list of entries stands alone",
        ".": "a dot stands only inside a number, and before the T of a transpose",
        "\\": "a backslash belongs to LaTeX: read this formula as LaTeX",
        "{": "braces stand only around the deviations of an expectation: use round brackets",
        "}": "braces stand only around the deviations of an expectation: use round brackets",
        "!": "factorials are not read",
        "#": "comments are not read",
        "'": "quoted text has no place in a formula",
        '"': "quoted text has no place in a formula",
    }
)


@dataclass(frozen=True, slots=True)
class Fault:
    """Where the parser stopped: what it stopped at, the operand before that, if any, the text around.

    Attributes:
        is_in_array: whether an array is open there.
    """

    last: str
    before: str
    at: str
    after: str
    is_in_array: bool = False


def hint(before: str, at: str, after: str) -> str:
    """What is wrong where the parser stopped, and what to write instead.

    Args:
        before: the formula up to there.
        at: what the parser stopped at; empty at the end of the formula.
        after: what follows.
    """
    last = _LAST.search(before.rstrip()[-200:])
    fault = Fault(last.group() if last else "", before.rstrip()[-1:], at, after, before.count("[") > before.count("]"))
    return next(said for rule in _RULES if (said := rule(fault)))


def _function_without_brackets(fault: Fault) -> str | None:
    if fault.last not in SPELLINGS:
        return None
    if fault.at in {"^", "**"}:
        exponent = re.match(r"\s*(-?\w{1,9})", fault.after)
        power = f"{fault.last}(x)**{exponent.group(1) if exponent else 2}"
        return f"write {power}: a power stands after the brackets"
    return f"{fault.last} wants its argument in brackets: {fault.last}(x)"


def _decimal_comma(fault: Fault) -> str | None:
    if fault.at == "," and fault.last.isdigit() and (decimals := re.match(r"\d{1,9}", fault.after)):
        return f"decimals follow a point: {fault.last[-9:]}.{decimals.group()}"
    return None


def _product(fault: Fault) -> str | None:
    if not fault.last or not _OPERAND.match(fault.at) or fault.at == ".":
        return None
    left = "(...)" if fault.last in ")]|" else fault.last
    right = "(...)" if fault.at in "(|" else fault.at
    call = "(...)" if right in SPELLINGS else ""
    array = f"; entries of an array stand between commas: [{left[:40]}, {right[:40]}{call}]"
    return f"products are written out: {left[:40]}*{right[:40]}{call}{array if fault.is_in_array else ''}"


def _index(fault: Fault) -> str | None:
    """A bracket behind an operand picks entries; one that begins a list takes what follows."""
    return _FOREIGN["["] if fault.before == "[" and fault.at != "]" else None


def _foreign(fault: Fault) -> str | None:
    return _FOREIGN.get(fault.at)


def _end(fault: Fault) -> str | None:
    if fault.at:
        return None
    return "the formula ends too early" if not fault.last else "the formula ends too early: a | is not closed"


def _misplaced(fault: Fault) -> str:
    if fault.at in {"+", "-", "*", "/", "^", "**", ")", "]", ",", ";"}:
        return f"a value is missing before {fault.at}"
    return f"{fault.at} has no meaning here"


_RULES: tuple[Callable[[Fault], str | None], ...] = (
    _function_without_brackets,
    _decimal_comma,
    _product,
    _index,
    _foreign,
    _end,
    _misplaced,
)
