"""How long a number and how deep and large a formula may be, so that a walk over it is short."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping

from radartrack.derive.formula.error import FormulaError, Span
from radartrack.derive.formula.tree import Tree, children

MAX_DEPTH = 100  # of brackets, and of the tree
MAX_NODES = 30_000
MAX_PRINTED = 5_000  # nodes of what is printed in LaTeX
MAX_DIGITS = 40  # of one number; its decimal exponent is at most as large

_NUMBER = re.compile(r"(\d*)\.?(\d*)(?:[eE]([+-]?\d+))?")


def check_brackets(brackets: Iterable[tuple[str, Span]], closers: Mapping[str, str]) -> dict[int, int]:
    """Match brackets; the places of openers in the sequence, each with that of its closer.

    Args:
        brackets: opening and closing brackets in order, with their places in the text.
        closers: what closes each opener.

    Raises:
        FormulaError: for one without a partner, or nested too deeply.
    """
    pairs: dict[int, int] = {}
    waiting: list[tuple[int, str, Span]] = []
    for index, (bracket, span) in enumerate(brackets):
        if bracket in closers:
            waiting.append((index, bracket, span))
            if len(waiting) > MAX_DEPTH:
                raise FormulaError(f"brackets are nested more than {MAX_DEPTH} deep", span=span)
            continue
        if not waiting:
            raise FormulaError(f"{bracket} closes nothing", span=span)
        opened_at, opener, _ = waiting.pop()
        if closers[opener] != bracket:
            raise FormulaError(f"{bracket} cannot close {opener}, which is still open", span=span)
        pairs[opened_at] = index
    if waiting:
        raise FormulaError(f"{waiting[-1][1]} is never closed", span=waiting[-1][2])
    return pairs


def check_count(parts: int, most: int = MAX_NODES) -> None:
    """Refuse more parts than a tree may have nodes, before the tree is made.

    Raises:
        FormulaError: naming the limit.
    """
    if parts > most:
        raise FormulaError(f"the formula has more than {most} parts")


def check_number(text: str, span: Span | None = None) -> None:
    """Refuse a number with too many digits, or too large a decimal exponent.

    Raises:
        FormulaError: naming the limit.
    """
    whole, decimals, exponent = _NUMBER.fullmatch(text).groups(default="")  # type: ignore[union-attr]
    if len(whole) + len(decimals) > MAX_DIGITS:
        raise FormulaError(
            f"a number has {len(whole) + len(decimals)} digits; at most {MAX_DIGITS} are read", span=span
        )
    if len(exponent) > len(str(MAX_DIGITS)) + 1 or abs(int(exponent or 0)) > MAX_DIGITS:
        raise FormulaError(f"the decimal exponent of a number is at most {MAX_DIGITS}", span=span)


def check_size(tree: Tree) -> None:
    """Refuse a tree that is too deep or has too many nodes; safe on trees of any depth.

    Raises:
        FormulaError: naming the limit.
    """
    nodes = 0
    waiting = [(tree, 1)]
    while waiting:
        node, depth = waiting.pop()
        nodes += 1
        if depth > MAX_DEPTH:
            raise FormulaError(f"the formula is nested more than {MAX_DEPTH} deep", span=node.span)
        check_count(nodes)
        waiting.extend((child, depth + 1) for child in children(node))
