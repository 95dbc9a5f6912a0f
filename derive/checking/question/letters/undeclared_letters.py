"""Letters of an identity of which the paper says nothing: each has the unit in which both sides add up."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from contextlib import suppress
from difflib import get_close_matches

from radartrack.derive import symbolic as sp
from radartrack.derive.catalogue import common_symbols
from radartrack.derive.checking.question.definitions.loose_definitions import WORD
from radartrack.derive.checking.question.names import Names
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.from_expression import to_tree
from radartrack.derive.formula.tree import Name, Power, Tree, bound_names, parts, rational_value
from radartrack.derive.formula.tree import names as names_of
from radartrack.derive.formula.unknown_names import CONSTANTS
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.reading.any_letters import read_loosely
from radartrack.derive.reading.fitting_units import fitting_units, turned_names
from radartrack.derive.reading.symbol_table import read_symbol
from radartrack.derive.units import ONE, Unit
from radartrack.derive.verbs.no_closed_form import NoClosedForm

MISSPELT = 0.88  # similarity from which a longer name is another one misspelt: sigma_bta is, sigma_S is not sigma_r
SHORTEST = 4  # letters of a name that may be one misspelt


def undeclared_letters(formulas: Sequence[str], names: Names, declared: Collection[str] = ()) -> dict[str, Variable]:
    """Symbols for the names of formulas that stand for nothing, each in the unit in which the formulas are alike.

    A letter that is a plain number in the catalogue, such as a fading factor theta, is an angle where a sine is taken
    of it and the paper does not say otherwise.

    Args:
        formulas: those that are said to be equal.
        names: what the other names stand for, definitions among them.
        declared: the names of which the paper says what they are.
    """
    trees = _trees(formulas, names)
    unknown = _unknown(trees, names)
    if _misspelt(unknown, names):
        return {}
    raised = _raised(trees) - set(declared) - names.let.keys()
    unknown += [name for name in sorted(raised) if name in names.symbols and not names.symbols[name].is_positive]
    provisional = names.with_symbols({name: _symbol(name, ONE, positive=name in raised) for name in unknown})
    groups: list[tuple[Sequence[Tree], Unit | None]] = []
    with suppress(FormulaError, NoClosedForm):  # is told where they are compared
        sides = [_entries(formula, provisional) for formula in formulas]
        if len({side.shape for side in sides}) == 1:
            groups = [(alike, None) for alike in zip(*(side.entries for side in sides), strict=True)]
    turned = {name for trees, _ in groups for tree in trees for name in turned_names(tree)}
    unknown += [name for name in sorted(turned - set(declared)) if _is_plain_number(names.symbols.get(name))]
    units = {symbol.name: symbol.unit for symbol in names.symbols.values()}
    fitting = fitting_units(units, unknown, groups)
    return {name: _symbol(name, unit, positive=name in raised) for name, unit in fitting.items()}


def _is_plain_number(symbol: Variable | None) -> bool:
    return symbol is not None and symbol.unit == ONE and not (symbol.whole or symbol.is_correlation)


def words(letters: Mapping[str, Variable]) -> str:
    """What is assumed of them."""
    units = dict.fromkeys(symbol.unit for symbol in letters.values())
    said = (_listed([n for n, one in letters.items() if one.unit == unit], unit) for unit in units)
    return f"read with {', '.join(said)}: [symbols] says nothing of {'it' if len(letters) == 1 else 'them'}"


def _listed(names: Sequence[str], unit: Unit) -> str:
    *most, last = names
    all_of_them = f"{', '.join(most)} and {last}" if most else last
    return f"{all_of_them} in {unit}" if unit != ONE else f"{all_of_them} as {'numbers' if most else 'a number'}"


def _trees(formulas: Iterable[str], names: Names) -> list[Tree]:
    """Formulas, and the definitions that they need, whatever their names mean."""
    found, waiting, seen = [], list(formulas), set[str]()
    while waiting:
        try:
            found.append(read_loosely(waiting.pop(), tuple(names)))
        except FormulaError:  # is told where it is read
            continue
        new = names_of(found[-1]) & names.let.keys() - seen
        seen |= new
        waiting += [names.let[name] for name in new]
    return found


def _unknown(trees: Iterable[Tree], names: Names) -> list[str]:
    """The names that stand for nothing."""
    mentioned = {name for tree in trees for name in names_of(tree) - bound_names(tree)}
    return sorted(name for name in mentioned - CONSTANTS.keys() if name not in names and WORD.fullmatch(name))


def _raised(trees: Iterable[Tree]) -> set[str]:
    """The names that are raised to what is no number, as only positive numbers can be."""
    powers = [node for node in parts(*trees) if isinstance(node, Power) and rational_value(node.exponent) is None]
    return {power.base.name for power in powers if isinstance(power.base, Name)}


def _misspelt(unknown: Iterable[str], names: Names) -> bool:
    """Whether one of them is rather another name misspelt, which is refused where it is read."""
    known = [name for name in {*names, *common_symbols()} if len(name) >= SHORTEST]
    return any(len(name) >= SHORTEST and get_close_matches(name, known, 1, MISSPELT) for name in unknown)


def _symbol(name: str, unit: Unit, *, positive: bool) -> Variable:
    symbol = read_symbol(name, {"unit": str(unit)})
    return read_symbol(name, {"unit": str(unit), "low": symbol.high / 1e3}) if positive and symbol.low <= 0 else symbol


def _entries(formula: str, names: Names) -> Tensor[Tree]:
    """The entries of a formula with all in them worked out."""
    trees, opened = names.entries(names.tree(formula))
    return trees.map(lambda entry: to_tree(sp.unguarded(opened.read(entry))))
