"""Formulas as strangers type them: any entry of the catalogue, in other letters, in any notation, right or with a slip.

Right ones are equal; with a slip none is, and what was meant is told in nine of ten. `RADARTRACK_STRANGERS=1000` takes
as many formulas of each kind.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from random import Random

import pytest

from radartrack.derive import check
from radartrack.derive.catalogue import catalogue
from radartrack.derive.checking.question.compared_quantity import refer
from radartrack.derive.checking.question.printed_formula import names_for
from radartrack.derive.checking.reporting.derived_formula import as_printed
from radartrack.derive.checking.reporting.verdict import Outcome, Verdict
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.fold import rebuild
from radartrack.derive.formula.printing import to_text
from radartrack.derive.formula.tree import Name, Tree, names, walk
from radartrack.derive.language.variable import Variable
from radartrack.derive.reading.text import read_text
from radartrack.derive.symbolic import Expr
from tests.derive.checking.own_values import No, anywhere, same, worth
from tests.derive.checking.repairing.mutants import mutants
from tests.derive.reading.printers import DIALECTS, LANGUAGES

COUNT = int(os.environ.get("RADARTRACK_STRANGERS", "6"))
LONGEST = 60  # nodes
SHARE = 0.9
POINTS = 3
EQUAL = {Outcome.EQUAL, Outcome.EQUAL_NUMERICALLY}
NOTATIONS = ("text", *DIALECTS, *LANGUAGES)

# As the field writes them; what is not here keeps its own name.
USUAL = {
    "r": ("R", "rho", "d", "rng"),
    "beta": ("theta", "az", "phi", "b"),
    "epsilon": ("el", "gamma", "phi"),
    "rdot": ("rr", "v_r"),
    "sigma_r": ("s_r", "sigma_rho", "sigma_R"),
    "sigma_beta": ("s_theta", "sigma_az", "sigma_phi"),
    "sigma_epsilon": ("sigma_el", "s_el"),
    "sigma_rdot": ("sigma_rr",),
    "T": ("dt", "Delta_t", "T_s", "h"),
    "q": ("S", "q_c"),
    "sigma_w": ("sigma_a", "s_w"),
    "omega": ("w", "Omega"),
    "x": ("p_x", "e", "X"),
    "y": ("p_y", "n", "Y"),
    "z": ("p_z", "h", "Z"),
    "vx": ("v_x", "xdot"),
    "vy": ("v_y", "ydot"),
    "vz": ("v_z", "zdot"),
    "k": ("n", "N"),
}


@dataclass(frozen=True)
class Typed:
    """What a stranger types, and what was meant."""

    quantity: str
    formula: str
    notation: str
    letters: dict[str, str]
    tree: Tree
    right: Tree
    symbols: tuple[Variable, ...]

    def verdict(self) -> Verdict:
        """What the checker says."""
        is_code = self.notation in LANGUAGES
        return check(
            self.quantity, self.formula, latex=self.notation in DIALECTS, code=self.notation if is_code else ""
        )

    def is_right(self, tree: Tree) -> bool:
        """Whether a formula in the quantity's symbols has the values of the right one."""
        points = [anywhere(self.symbols, Random(f"{self.formula} {n}")) for n in range(POINTS)]
        pairs = [(worth(tree, point), worth(self.right, point)) for point in points]
        return all(one is other if No in {type(one), type(other)} else same(one, other) for one, other in pairs)


@cache
def entries() -> list[tuple[str, Tree, tuple[Variable, ...]]]:
    """The entries of the catalogue that are formulas and not too long, as people print them."""
    found: dict[Expr, tuple[str, Tree, tuple[Variable, ...]]] = {}
    for name, quantity in sorted(catalogue().items()):
        for index, expression in quantity.expression.items():
            tree = as_printed(expression)
            if names(tree) and sum(1 for _ in walk(tree)) <= LONGEST:
                place = f"[{','.join(map(str, index))}]" if index else ""
                found.setdefault(expression, (f"{name}{place}", tree, quantity.symbols))
    return list(found.values())


def typed(kind: str, *, slips: bool) -> Iterator[Typed]:
    """As many formulas as are asked for, always the same."""
    random = Random(kind)
    known = entries()
    for number in range(COUNT):
        quantity, right, symbols = random.choice(known)
        own = {symbol.name for symbol in symbols}
        letters: dict[str, str] = {}
        for name in sorted(names(right)):
            usual = [one for one in USUAL.get(name, ()) if one not in own and one not in letters.values()]
            letters[name] = random.choice([name, *usual])
        tree = right
        if slips:
            found = mutants(right, names_for(refer(quantity), {}).dimensions, 1, random)
            tree = found[0] if found else right
        if not names(tree) <= letters.keys():
            letters |= {name: name for name in names(tree) - letters.keys()}
        printed = rebuild(tree, lambda node, to=letters: Name(to[node.name]) if isinstance(node, Name) else node)  # type: ignore[misc]
        notation = NOTATIONS[number % len(NOTATIONS)]
        symbols = refer(quantity).symbols  # with what is understood: a slip may write that, too
        yield Typed(quantity, _written(printed, notation), notation, letters, tree, right, symbols)


def _written(tree: Tree, notation: str) -> str:
    if notation in DIALECTS:
        return DIALECTS[notation].formula(tree)
    return LANGUAGES[notation].formula(tree) if notation in LANGUAGES else to_text(tree)


def _is_told(one: Typed, verdict: Verdict) -> bool:
    """Whether what was meant is among the suggestions, or a known quantity or convention is named that it is."""
    if verdict.remarks and any(remark.startswith("equal ") for remark in verdict.remarks):
        return True
    back = {letter: name for name, letter in one.letters.items()}
    for suggestion in verdict.suggestions:
        if suggestion.edit.startswith("this is"):
            return True
        try:
            tree = read_text(suggestion.formula, None)
        except FormulaError:
            continue
        tree = rebuild(tree, lambda node: Name(back.get(node.name, node.name)) if isinstance(node, Name) else node)
        if one.is_right(tree):
            return True
    return False


@pytest.fixture(autouse=True)
def _parsers() -> None:
    pytest.importorskip("tree_sitter")


def test_a_right_formula_is_equal_in_any_letters_and_notation() -> None:
    for one in typed("right", slips=False):
        verdict = one.verdict()
        assert verdict.verdict in EQUAL, (one.quantity, one.notation, one.formula, verdict.reason, verdict.reading)


def test_a_formula_with_a_slip_is_never_equal_and_what_was_meant_is_told() -> None:
    told = []
    for one in typed("slips", slips=True):
        if one.is_right(one.tree):
            continue  # a slip that changes nothing
        try:
            verdict = one.verdict()
        except FormulaError as error:
            told.append(False)
            print(one.quantity, one.notation, one.formula, "refused:", error.message)
            continue
        assert not verdict.is_equal, (one.quantity, one.notation, one.formula, verdict.reading)
        told.append(_is_told(one, verdict))
        if not told[-1]:
            print(one.quantity, one.notation, one.formula, verdict.reason, [s.edit for s in verdict.suggestions])
    assert sum(told) >= SHARE * len(told) - 1, f"{sum(told)} of {len(told)}"
