"""Verdicts on formulas made by chance, held against an evaluator that shares nothing with the checker.

Here a few; RADARTRACK_FORMULAS=100000 takes as many rewritten and as many spoilt ones, in hours of one core, and
RADARTRACK_SEED=2 takes others.
"""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Callable, Sequence
from functools import cache
from random import Random
from typing import TypeAlias

import pytest

from radartrack.derive.catalogue import catalogue
from radartrack.derive.checking.answers import Finding, Question
from radartrack.derive.checking.comparing.numerical_comparison import Comparison, Imaginary, Values
from radartrack.derive.checking.comparing.question_domain import Domain
from radartrack.derive.checking.question.compared_quantity import Reference, refer
from radartrack.derive.checking.question.printed_formula import Printed, names_for
from radartrack.derive.checking.reporting.derived_formula import shown
from radartrack.derive.checking.reporting.verdict import Outcome
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.printing import to_text
from radartrack.derive.formula.tree import Tree
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.reading.text import read_text
from tests.derive.checking.own_values import ROUNDING, No, anywhere, inside, same, soon_same, worth
from tests.derive.checking.random_formulas import rewritten, spoilt

FORMULAS = int(os.environ.get("RADARTRACK_FORMULAS", "24"))
SEED = int(os.environ.get("RADARTRACK_SEED", "1"))
PARTS = 2 if FORMULAS < 1000 else 20
SOON = ("polar.", "observe.", "line.", "finite_sample.degree1.range.")
LONG = 90  # characters of a formula
POINTS = 25 if FORMULAS < 1000 else 8  # for each formula
EXPLAINED = 40  # of so many formulas of a part, one is explained too
Change: TypeAlias = Callable[[Tree, Sequence[Variable], Random], Tree]
EQUAL = {Outcome.EQUAL, Outcome.EQUAL_NUMERICALLY}


@cache
def _known() -> list[tuple[str, str]]:
    """Short entries of quantities, and their formulas; of few formulas, those that are soon derived."""
    found: dict[str, str] = {}
    for name, quantity in catalogue().items():
        if FORMULAS < 1000 and not name.startswith(SOON):
            continue
        for index, expression in quantity.expression.items():
            if expression.free_symbols and len(str(expression)) <= LONG:
                found.setdefault(str(expression), f"{name}[{','.join(map(str, index))}]" if index else name)
    return [(entry, shown(refer(entry).entries)) for entry in found.values()]


@pytest.mark.parametrize("part", range(PARTS))
@pytest.mark.parametrize("change", [rewritten, spoilt], ids=["rewritten", "spoilt"])
def test_no_verdict_on_a_formula_by_chance_is_wrong_or_lost(change: Change, part: int) -> None:
    counts: Counter[str] = Counter()
    faults = []
    for number in range(part, FORMULAS, PARTS):
        random = Random(f"{change.__name__} {SEED} {number}")
        entry, formula = random.choice(_known())
        reference = refer(entry)
        names = names_for(reference, {})
        tree = read_text(formula, names.values)
        changed = change(tree, reference.symbols, random)
        try:
            question = _question(reference, changed)
        except FormulaError:
            counts["not read"] += 1
            continue
        if fault := _fault(question, tree, random, counts, explained=number // PARTS % EXPLAINED == 0):
            faults.append(f"{entry} for {to_text(changed)}: {fault}")
    print(dict(counts))
    assert not faults, "\n".join(faults[:20])
    assert counts["not read"] < FORMULAS / PARTS / 2


def _question(reference: Reference, tree: Tree) -> Question:
    names = names_for(reference, {})
    tree = read_text(to_text(tree), names.values)
    return Question(reference, Printed(tree, Tensor((), (tree,)), Tensor((), (names.read(tree),)), names), {})


def _fault(question: Question, derived: Tree, random: Random, counts: Counter[str], *, explained: bool) -> str:
    """What is wrong with the verdict; nothing where it is right."""
    finding = question.finding(())
    counts[finding.outcome.value] += 1
    if "cannot be worked out" in finding.reason or "memory" in finding.reason:
        return f"lost: {finding.reason}"
    if explained:
        *_, verdict = question.answers()
        if "cannot be worked out" in str(verdict.remarks):
            return f"not explained: {verdict.remarks}"
    if finding.outcome in EQUAL:
        return _not_equal(question, derived, random)
    if finding.outcome is Outcome.UNDECIDED:
        return _decidable(question, derived)
    return _no_counterexample(question, derived, finding)


def _not_equal(question: Question, derived: Tree, random: Random) -> str:
    printed = question.printed.tree
    for _ in range(POINTS):
        point = anywhere(question.reference.symbols, random)
        if soon_same(derived, printed, point):
            continue
        right, found = worth(derived, point), worth(printed, point)
        if isinstance(right, No) or found in {No.UNDEFINED, No.UNKNOWN}:
            continue
        if found is No.UNREAL or not same(right, found):
            return f"called equal, but {found} against {right} at {point}"
    return ""


def _decidable(question: Question, derived: Tree) -> str:
    """Nothing where the formula has no value at one of the points of the domain, or the derived one at all."""
    points = [point for point in question.domain.sample() if not isinstance(worth(derived, _all(question, point)), No)]
    unknown = [point for point in points if worth(question.printed.tree, _all(question, point)) in set(No)]
    return "" if unknown or not points else "lost: undecided though both have a value at all points"


def _differs_anywhere(question: Question, derived: Tree) -> bool:
    random = Random(0)
    points = [anywhere(question.reference.symbols, random) for _ in range(POINTS)]
    return not any(soon_same(derived, question.printed.tree, point) for point in points)


def _all(question: Question, point: dict[str, float]) -> dict[str, float]:
    """The point with a value for the symbols that fell out of both formulas; not the middle, which is often 0."""
    return {symbol.name: 0.4 * symbol.low + 0.6 * symbol.high for symbol in question.reference.symbols} | point


def _no_counterexample(question: Question, derived: Tree, finding: Finding) -> str:
    if not isinstance(finding.values, Values | Imaginary):
        return "called different without an example"
    point = finding.values.point
    if not inside(question.symbols, point):
        return f"called different at a point outside the domain: {point}"
    right, found = (worth(tree, _all(question, point)) for tree in (derived, question.printed.tree))
    if found is No.UNKNOWN or right is No.UNKNOWN:
        return ""
    if isinstance(right, No) or (found is No.UNDEFINED and not _differs_anywhere(question, derived)):
        return f"called different where {found} stands against {right}, at {point}"
    if found is No.UNDEFINED:  # a quotient of two zeros, which is told by what it is beside the point
        return ""
    if isinstance(finding.values, Imaginary):
        return "" if found is No.UNREAL else f"called not real, but {found} at {point}"
    if found is No.UNREAL or same(right, found, within=ROUNDING):
        return f"called different, but {found} against {right} at {point}"
    told = finding.values
    is_told = same(told.printed, found, beside=right) and same(told.derived, right, beside=found)
    return "" if is_told else f"told {told.printed}, {told.derived} for {found}, {right} at {point}"


def _no_difference(*_: object) -> None:
    return None


def _always(*_: object) -> bool:
    return True


def _any_point(_: Comparison, domain: Domain) -> Values:
    """A difference wherever there is none."""
    return Values(next(domain.round()), 1, 2)


@pytest.mark.parametrize(
    ("change", "broken"),
    [
        (spoilt, {"find_difference": _no_difference, "proved_equal": _always}),
        (rewritten, {"find_difference": _any_point}),
    ],
    ids=["all is equal", "all differs"],
)
def test_a_checker_that_is_wrong_is_caught(
    change: Change, broken: dict[str, Callable[..., object]], monkeypatch: pytest.MonkeyPatch
) -> None:
    for name, replacement in broken.items():
        monkeypatch.setattr(f"radartrack.derive.checking.answers.{name}", replacement)
    with pytest.raises(AssertionError, match="called"):
        test_no_verdict_on_a_formula_by_chance_is_wrong_or_lost(change, 0)
