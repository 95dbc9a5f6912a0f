"""What a formula has in place of another, in words: "x for y", "the power 3/2 is 1"."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from radartrack.derive.formula.printing import to_text
from radartrack.derive.formula.tree import (
    Call,
    Name,
    Negation,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Tree,
    children,
)

LONG = 60  # characters of a part that is shown whole


class Difference(NamedTuple):
    """Two parts that differ.

    Attributes:
        old: what is derived.
        new: what the edited formula has in its place.
        around: of what that is directly a part; None for the whole formula.
    """

    old: Tree
    new: Tree
    around: Tree | None

    def words(self, whole: Tree) -> str:
        """What is there in place of what, and in which part of the whole edited formula, where that does not show."""
        words = _words(self.old, self.new)
        match self.old, self.new:
            case (Name(), Name()) | (Number(), Number()):
                shown = self.around if isinstance(self.around, Product | Quotient | Power) else whole
            case _ if words.endswith("missing"):
                shown = self.old
            case _:
                shown = self.new if words.startswith("an extra") else whole
        is_all = whole in {shown, self.new, Negation(shown), Negation(self.new)}
        return words if is_all else f"{words} in {_shown(shown)}"


def edit_in_words(derived: Tree, edited: Tree) -> str:
    """What stands in the edited formula in place of parts of the derived one."""
    differences = list(_differences(derived, edited))
    distinct = list(dict.fromkeys((one.old, one.new) for one in differences))
    if len(differences) == 1:
        return differences[0].words(edited)
    if len(distinct) == 1:
        return f"{_words(*distinct[0])} everywhere"
    names = {(old.name, new.name) for old, new in distinct if isinstance(old, Name) and isinstance(new, Name)}
    if len(names) == len(distinct) == 2 and {(new, old) for old, new in names} == names:
        return f"{' and '.join(sorted(next(iter(names))))} are swapped"
    if len(differences) == 2:
        return " and ".join(one.words(edited) for one in differences)
    if len(distinct) == 2:
        return " and ".join(_words(*pair) for pair in distinct)
    return _swapped_functions(distinct) or _words(derived, edited)


def _differences(old: Tree, new: Tree, around: Tree | None = None) -> Iterator[Difference]:
    """The smallest parts that differ."""
    if old == new:
        return
    below = children(old), children(new)
    alike = type(old) is type(new) and len(below[0]) == len(below[1]) > 0
    if isinstance(old, Call) and isinstance(new, Call):
        alike = alike and old.function == new.function
    if not alike or (isinstance(old, Power) and old.base == children(new)[0]):
        yield Difference(old, new, around)
        return
    found = [one for pair in zip(*below, strict=True) for one in _differences(*pair, new)]
    several = len({(one.old, one.new) for one in found}) > 2
    yield from [Difference(old, new, around)] if isinstance(old, Sum | Product) and several else found


def _words(old: Tree, new: Tree) -> str:
    match old, new:
        case Negation(operand), _ if operand == new:
            return f"the sign of {_shown(new)}"
        case _, Negation(operand) if operand == old:
            return f"the sign of {_shown(old)}"
        case Power(base, exponent), Power(other, power) if base == other:
            return f"the power {_shown(exponent)} is {_shown(power)} in {_shown(old)}"
        case Power(base, exponent), _ if base == new:
            return f"the power {_shown(exponent)} is 1 in {_shown(old)}"
        case _, Power(base, exponent) if base == old:
            return f"the power 1 is {_shown(exponent)}: {_shown(new)} for {_shown(old)}"
        case Call("sqrt", (operand,)), _ if operand == new:
            return f"the root is missing: {_shown(new)} for {_shown(old)}"
        case (Sum(), _) | (_, Sum()):
            return _of_one_factor(old, new) or _of_parts(old, new, Sum, "term")
        case (Product() | Quotient(), _) | (_, Product() | Quotient()):
            return _of_factors(old, new)
        case _:
            return _replaced(old, new)


def _of_one_factor(old: Tree, new: Tree) -> str:
    """Which factor a sum has lost or got; empty where it is none."""
    match old, new:
        case Product((first, *rest)), _ if rest == [new]:
            return f"the factor {_shown(first)} is missing"
        case _, Product((first, *rest)) if rest == [old]:
            return f"an extra factor {_shown(first)}"
        case _:
            return ""


def _of_parts(old: Tree, new: Tree, kind: type[Sum | Product], called: str) -> str:
    """Which term or factor is missing, is too many, or has another sign."""
    before, after = (Counter(children(one) if isinstance(one, kind) else (one,)) for one in (old, new))
    missing, extra = list((before - after).elements()), list((after - before).elements())
    if len(missing) == 1 and len(extra) == 1:
        return _words(*missing, *extra) if not isinstance(missing[0], kind) else _replaced(old, new)
    if len(missing) == 1 and not extra:
        return f"the {called} {_shown(missing[0])} is missing"
    if len(extra) == 1 and not missing:
        return f"an extra {called} {_shown(extra[0])}"
    return _replaced(old, new)


def _of_factors(old: Tree, new: Tree) -> str:
    """As `_of_parts`, above and below the line."""
    (above, below), (over, under) = _fraction(old), _fraction(new)
    gone_above, new_above = list((above - over).elements()), list((over - above).elements())
    gone_below, new_below = list((below - under).elements()), list((under - below).elements())
    match gone_above, new_above, gone_below, new_below:
        case [[one], [], [], []]:
            return f"the factor {_shown(one)} is missing"
        case [[], [one], [], []]:
            return f"an extra factor {_shown(one)}"
        case [[], [], [one], []]:
            return f"the divisor {_shown(one)} is missing"
        case [[], [], [], [one]]:
            return f"an extra divisor {_shown(one)}"
        case [[one], [other], [], []] | [[], [], [one], [other]] if not isinstance(one, Product | Quotient):
            return _words(one, other)
        case _:
            return _replaced(old, new)


def _fraction(tree: Tree) -> tuple[Counter[Tree], Counter[Tree]]:
    """The factors above and below the line."""
    above, below = (tree.numerator, tree.denominator) if isinstance(tree, Quotient) else (tree, Number("1"))
    return tuple(  # type: ignore[return-value]
        Counter(factor for factor in (one.factors if isinstance(one, Product) else (one,)) if factor != Number("1"))
        for one in (above, below)
    )


def _swapped_functions(pairs: Sequence[tuple[Tree, Tree]]) -> str:
    """`sin and cos are swapped everywhere`."""
    kinds = {(old.function, new.function) for old, new in pairs if isinstance(old, Call) and isinstance(new, Call)}
    if kinds and len(kinds) <= 2 and {(new, old) for old, new in kinds} == kinds:
        return f"{' and '.join(sorted(next(iter(kinds))))} are swapped everywhere"
    return ""


def _replaced(old: Tree, new: Tree) -> str:
    return f"{_shown(new)} for {_shown(old)}"


def _shown(tree: Tree) -> str:
    text = to_text(tree)
    return text if len(text) <= LONG else f"{text[: LONG - 3]}..."
