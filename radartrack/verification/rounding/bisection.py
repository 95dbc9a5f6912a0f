"""Boxes of a certificate by asking its checker: the worst box is halved where that helps most, until all will do."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass, field
from time import process_time
from typing import Any

from radartrack.verification.rounding.checker.certificate_checker import figure
from radartrack.verification.rounding.checker.domain_cases import boxes_of, cases_of
from radartrack.verification.rounding.checker.known_numbers import Refused
from radartrack.verification.rounding.domain_boxes import tree_of

Ends = dict[str, tuple[float, float]]
HOPELESS = 300.0  # of a logarithm: what a box without any bound counts
AT = (0.9, 1.0)  # of the way along a box: where other arguments are points
POINT = 1e-6  # of a logarithm
USELESS = 1e4  # ulp; a box with more counts as one without any bound
IDLE = 3  # times that halving an argument gained nothing: then it is left alone


@dataclass
class _Case:
    """The boxes of one choice of signs, by their paths; a path says by 0 and 1 which halves were taken."""

    source: str
    claim: Mapping[str, Any]
    case: str
    decisive: set[str] = field(default_factory=set)  # arguments whose whole range alone leaves no useful bound
    splits: dict[str, int] = field(default_factory=dict)
    boxes: dict[str, tuple[float, Ends]] = field(default_factory=dict)
    idle: Counter[str] = field(default_factory=Counter)

    def __post_init__(self) -> None:
        (whole,) = boxes_of(self.claim, self.case, ".")
        self.boxes[""] = self._bound(whole), whole

    def _bound(self, box: Ends) -> float:
        try:
            return figure(self.source, self.claim, self.case, box)
        except Refused:
            return math.inf

    @property
    def worst(self) -> str:
        """The path of the box with the largest bound; of several without one the widest."""
        return max(self.boxes, key=lambda path: (self.boxes[path][0], -len(path)))

    def halve(self) -> None:
        """Put two halves for the worst box."""
        path = self.worst
        before, box = self.boxes.pop(path)
        tried = []
        for name in self._worth_halving(box) if before > USELESS else self._not_idle(box):
            low, high = box[name]
            middle = (low + high) / 2
            halves = [{**box, name: ends} for ends in ((low, middle), (middle, high))]
            bounds = [self._bound(half) for half in halves]
            self.idle[name] += math.isfinite(before) and min(bounds) > 0.99 * before
            logs = sorted(min(math.log(max(bound, 1.0)), HOPELESS) for bound in bounds)
            gain = logs[1] + 0.5 * logs[0] - 1e-3 * min(high - low, 50.0)
            tried.append((gain, list(box).index(name), list(zip(bounds, halves, strict=True))))
        _, self.splits[path], found = min(tried, key=lambda one: one[:2])
        self.boxes |= {path + str(n): half for n, half in enumerate(found)}

    def _not_idle(self, box: Ends) -> list[str]:
        return [name for name in box if self.idle[name] < IDLE] or list(box)

    def _worth_halving(self, box: Ends) -> list[str]:
        """The widest of the arguments whose range alone leaves no useful bound, the others being points; else all."""
        if not self.splits:
            self.decisive |= set(self._decisive(box, box))
        found = self._decisive(box, self.decisive)
        return [max(found, key=lambda name: box[name][1] - box[name][0])] if found else self._not_idle(box)

    def _decisive(self, box: Ends, names: Collection[str]) -> list[str]:
        """In the order of the box: what is chosen of equal ones does not depend on how names are hashed."""
        there = (name for name in box if name in names)
        return [name for name in there if any(self._bound(line) > USELESS for line in _lines(box, name))]

    @property
    def tree(self) -> str:
        """In preorder."""
        return tree_of(self.splits)


def _lines(box: Ends, name: str) -> Iterator[Ends]:
    """Along one argument, the others being points."""
    for share in AT:
        points = {other: low + share * (high - low) for other, (low, high) in box.items()}
        yield {other: (max(at - POINT, box[other][0]), at) for other, at in points.items()} | {name: box[name]}


def bisected(source: str, claim: Mapping[str, Any], enough: float, most: int, seconds: float) -> dict[str, str]:
    """The trees of all cases.

    Args:
        source: the text of the generated module.
        claim: as the checker takes it; its trees are not looked at.
        enough: a bound in ulp that need not be made smaller.
        most: boxes that a case may have.
        seconds: of processor time after which a box is halved only where there is no bound, and twice that at all.

    Raises:
        Refused: there is a box without a bound.
    """
    start, cases = process_time(), [_Case(source, claim, case) for case in cases_of(claim)]
    for case in cases:
        while len(case.boxes) < most:
            bound, box = case.boxes[case.worst]
            spent = process_time() - start
            if bound <= enough or not box or spent > seconds * (1 if math.isfinite(bound) else 2):
                break
            case.halve()
        if not math.isfinite(case.boxes[case.worst][0]):
            figure(source, claim, case.case, case.boxes[case.worst][1])
    return {case.case: case.tree for case in cases}
