"""Letters of a formula in which something is worked out: what comes out is matched, in letters without a meaning.

A sum over an index or a Jacobian has no entries to be tried before it is worked out.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence

from radartrack.derive.checking.question.compared_quantity import Reference
from radartrack.derive.checking.question.definitions.loose_definitions import LooseDefinitions
from radartrack.derive.checking.question.letters.letter_readings import LONGEST, NO_LETTERS, Letter, Letters
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.shape import Shape
from radartrack.derive.formula.tree import Tree, bound_names, names
from radartrack.derive.language.variable import Variable
from radartrack.derive.reading.any_letters import read_loosely
from radartrack.derive.units import ONE

TRANSPOSE = "T"  # above an array


def unmeant_letters(
    read: Callable[[Sequence[str], Mapping[str, Shape]], Tree],
    reference: Reference,
    let: Mapping[str, str],
    declared: Collection[str],
) -> Letters:
    """The letters of a formula and its definitions that are not known, each as a positive number of its own.

    Args:
        read: the formula as it is read where names are known, with shapes if they are arrays, and others let through.
        reference: what it is compared with.
        let: definitions, in any order.
        declared: letters of which the paper says what they are.
    """
    own = [symbol.name for symbol in reference.symbols]
    known = {*own, *declared, *let}
    try:
        shapes = LooseDefinitions(let, own).shapes
        trees = [read([*known], shapes), *(read_loosely(text, [*known], shapes=shapes) for text in let.values())]
    except (FormulaError, ValueError):  # is told where they are read
        return NO_LETTERS
    used = set[str]().union(*map(names, trees)) - set[str]().union(*map(bound_names, trees))
    unknown = sorted(name for name in used - known if name.isidentifier() and name != TRANSPOSE)
    if any(len(name) > LONGEST for name in unknown):
        return NO_LETTERS
    return {name: Letter(Variable(name, "a letter", ONE, 1e-3, 1e3)) for name in unknown}
