"""A period printed as the difference of two times: t_{k+1} - t_k, t - t_0, t2 - t1."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable
from dataclasses import dataclass

from radartrack.derive.formula.fold import rebuild
from radartrack.derive.formula.tree import Name, Negation, Sum, Tree, walk
from radartrack.derive.language.variable import Variable
from radartrack.derive.units import SECOND

_TIME = re.compile(r"t(?:_?(?P<number>\d+)|_?(?P<index>[kntij])(?:(?P<sign>[mp])(?P<shift>\d+))?)?")
PERIOD = "T"  # as the catalogue calls it
ORIGIN = Variable("origin", "from which times are counted", SECOND, -1e12, 1e12)


@dataclass(frozen=True)
class Elapsed:
    """Two times of which formulas know the difference only, so that the earlier one may be 0."""

    later: str
    earlier: str


def elapsed(formulas: Iterable[Tree]) -> Elapsed | None:
    """The times on whose difference alone these formulas depend, if there are two."""
    nodes = [node for formula in formulas for _, node in walk(formula)]
    times = {node.name for node in nodes if isinstance(node, Name) and _TIME.fullmatch(node.name)}
    if len(times) != 2:
        return None
    earlier, later = sorted(times, key=lambda name: _moment(name)[1])
    if _moment(later)[1] < math.inf and _moment(earlier)[0] != _moment(later)[0]:
        return None  # t_k and t_1: nobody knows which is later
    occurring = sum(isinstance(node, Name) and node.name in times for node in nodes)
    together = sum(2 for node in nodes if isinstance(node, Sum) and _is_difference(node, times))
    return Elapsed(later, earlier) if occurring == together else None


def with_period(tree: Tree, times: Elapsed, period: Name) -> Tree:
    """The formula with a period for the difference of these times."""

    def changed(node: Tree) -> Tree:
        if not isinstance(node, Sum) or not _is_difference(node, {times.later, times.earlier}):
            return node
        is_later_taken = any(term == Negation(Name(times.later)) for term in node.terms)
        elapsed_time = Negation(period) if is_later_taken else period
        own = [Name(times.later), Name(times.earlier)]
        rest = tuple(one for one in node.terms if (one.operand if isinstance(one, Negation) else one) not in own)
        return Sum((elapsed_time, *rest)) if rest else elapsed_time

    return rebuild(tree, changed)


def _is_difference(node: Sum, times: set[str]) -> bool:
    """Whether one of the times is added in a sum, and the other taken away."""
    plain = [term.name for term in node.terms if isinstance(term, Name) and term.name in times]
    taken = [term.operand for term in node.terms if isinstance(term, Negation)]
    less = [one.name for one in taken if isinstance(one, Name) and one.name in times]
    return len(plain) == len(less) == 1 and plain != less


def _moment(name: str) -> tuple[str, float]:
    """What counts a time, and the count; a plain t comes after all others."""
    found = _TIME.fullmatch(name)
    if found is None or not (found["number"] or found["index"]):
        return "", math.inf
    if found["number"]:
        return "", float(found["number"])
    shift = float(found["shift"] or 0)
    return found["index"], -shift if found["sign"] == "m" else shift
