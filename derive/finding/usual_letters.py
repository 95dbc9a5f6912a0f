"""Formulas in letters that are usual for functions of a quantity's symbols, and without a factor that is understood."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from radartrack.derive.catalogue import catalogue
from radartrack.derive.checking.question.letters.dependent_letters import Dependent, dependents
from radartrack.derive.checking.question.letters.elapsed_time import PERIOD, elapsed, with_period
from radartrack.derive.checking.question.letters.letter_meanings import meanings, means
from radartrack.derive.checking.reporting.derived_formula import as_printed
from radartrack.derive.finding.formula_search import is_of_letters_alone
from radartrack.derive.formula.fold import rebuild
from radartrack.derive.formula.tree import Name, Number, Power, Product, Quotient, Tree
from radartrack.derive.formula.tree import names as names_of
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.symbolic import Expr

# One quantity of each subject that has letters of its own.
SUBJECTS = (
    "observe.polar_doppler.jacobian",
    "observe.spherical_doppler.jacobian",
    "observe.ruv.jacobian",
    "observe.bistatic.jacobian",
    "polar.jacobian",
    "spherical.jacobian",
    "ruv.jacobian",
    "bistatic.jacobian",
    "frames.ecef_from_geodetic.map",
    "finite_sample.degree1.range_rate.rate_weights",
    "fusion.correlated.variance",
    "steady_state.alpha_beta.gain",
    "motion.singer.process_noise",
)
# Process noise is printed for an intensity of one, a covariance as the factor by which variances are reduced.
FEW = 2  # letters: a longer formula lacks no factor, and readings with one more letter are many
# Of two scans a rate is reduced by the square of the period too.
UNDERSTOOD: tuple[tuple[tuple[str, int], ...], ...] = (
    (("q", 1),),
    (("sigma_w", 2),),
    (("sigma_r", 2),),
    (("sigma_m", 2),),
    (("sigma_r", 2), ("T", -1)),
    (("sigma_r", 2), ("T", -2)),
)


@dataclass(frozen=True)
class Usual:
    """A formula in symbols.

    Attributes:
        tree: the formula.
        words: what was done to it.
        family: how the names of the quantities begin that it may be; nothing for any.
        own: names in the tree that are what they say, and nothing else of their unit.
    """

    tree: Tree
    words: str
    family: str = ""
    own: frozenset[str] = frozenset()


def usual_forms(tree: Tree) -> Iterator[Usual]:
    """What a formula may be short for, the likeliest first."""
    plain = list(_in_symbols(tree))
    yield from plain
    if len(names_of(tree)) <= FEW:
        for one in (*plain, Usual(tree, "")):
            yield from _with_factors(one)
    yield from _of_a_unit_period(tree)
    if (times := elapsed([tree])) and PERIOD not in names_of(tree):
        words = f"{PERIOD} for {times.later} - {times.earlier}"
        yield Usual(with_period(tree, times, Name(PERIOD)), words, own=frozenset({PERIOD}))


def _of_a_unit_period(tree: Tree) -> Iterator[Usual]:
    """With a period of one: of gains that a filter divides by it."""
    for name in sorted(names_of(tree)):
        if any(one.of == "period" for one in meanings(name).strong):
            plain = rebuild(tree, lambda node, name=name: Number("1") if node == Name(name) else node)  # type: ignore[misc]
            yield Usual(plain, f"{name} = 1")


def _in_symbols(tree: Tree) -> Iterator[Usual]:
    """With the functions of symbols for which letters stand, in each subject that has all the other letters."""
    letters = names_of(tree)
    for subject in SUBJECTS:
        quantity = catalogue()[subject]
        known = dependents([quantity])
        for rank in sorted({one.rank for one in known}):
            meant = _meant(letters, quantity, [one for one in known if one.rank <= rank])
            if meant and all(_may_be_of(name, quantity) for name in letters - meant.keys()):
                meant |= _symbols_meant(letters - meant.keys(), quantity)
                trees = {name: as_printed(value) for name, value in meant.items()}
                written = rebuild(tree, lambda node, trees=trees: _put(node, trees))  # type: ignore[misc]
                said = ", ".join(f"{name} for {value}" for name, value in meant.items())
                yield Usual(written, said, f"{quantity.module}.")


def _meant(letters: frozenset[str], quantity: Quantity, known: Sequence[Dependent]) -> dict[str, Expr]:
    own = {symbol.name for symbol in quantity.symbols}
    found: dict[str, Expr] = {}
    for one in known:
        called = (name for name in sorted(letters) if name not in own and name not in found and one.is_called(name))
        if (name := next(called, None)) is not None and not means(name, quantity.symbols):
            found[name] = one.value
    return found


def _symbols_meant(letters: frozenset[str], quantity: Quantity) -> dict[str, Expr]:
    """The symbols that letters mean: in what was put in these stand by their own names."""
    own = {symbol.name for symbol in quantity.symbols}
    said = {name: means(name, quantity.symbols) for name in sorted(letters - own)}
    return {name: found[0][0] for name, found in said.items() if len(found) == 1 and found[0][1] == 1}


def _may_be_of(name: str, quantity: Quantity) -> bool:
    """Whether a letter is one of the subject, or means nothing."""
    own = any(symbol.name == name for symbol in quantity.symbols)
    return own or bool(means(name, quantity.symbols)) or not meanings(name).strong


def _with_factors(one: Usual) -> Iterator[Usual]:
    if is_of_letters_alone(one.tree):
        return  # a*b is many things with a factor beside it
    for factors in UNDERSTOOD:
        own = frozenset(name for name, _ in factors)
        if not own & names_of(one.tree):
            tree = Product((*(_raised(name, power) for name, power in factors), one.tree))
            said = ", ".join(f"{name} = 1" for name, _ in factors) + " understood"
            yield Usual(tree, f"{one.words}, {said}" if one.words else said, one.family, own)


def _raised(name: str, power: int) -> Tree:
    if power < 0:
        return Quotient(Number("1"), _raised(name, -power))
    return Name(name) if power == 1 else Power(Name(name), Number(str(power)))


def _put(node: Tree, trees: dict[str, Tree]) -> Tree:
    return trees.get(node.name, node) if isinstance(node, Name) else node
