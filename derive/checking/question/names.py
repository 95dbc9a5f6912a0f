"""What the names of a formula stand for: symbols, quantities, and definitions, which are read when they are needed."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from contextlib import suppress
from dataclasses import replace
from functools import cached_property
from itertools import count, islice
from types import MappingProxyType

from radartrack.derive import symbolic as sp
from radartrack.derive.catalogue import UnknownQuantity, catalogue, common_symbols
from radartrack.derive.checking.question.definitions.known_constants import with_symbols
from radartrack.derive.checking.question.definitions.loose_definitions import WORD, LooseDefinitions
from radartrack.derive.checking.question.formula_entries import entries_of
from radartrack.derive.checking.question.formula_units import (
    NOTHING,
    Dimension,
    WrongDimensions,
    dimensions,
    in_definition,
)
from radartrack.derive.checking.question.meaning import Meaning, number_of_parts, shape_of
from radartrack.derive.checking.question.single_number import only_scalar
from radartrack.derive.checking.question.world import CATALOGUE, World
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.fold import Fold, rebuild
from radartrack.derive.formula.from_expression import to_tree
from radartrack.derive.formula.functions import BINDING, SPELLINGS
from radartrack.derive.formula.limits import MAX_NODES
from radartrack.derive.formula.magnitude import Measure, magnitudes
from radartrack.derive.formula.printing import to_text
from radartrack.derive.formula.shape import Shape
from radartrack.derive.formula.to_expression import Expression, Reader
from radartrack.derive.formula.tree import Array, Call, Entries, Name, Tree, bound_names, has_verbs
from radartrack.derive.formula.tree import names as names_of
from radartrack.derive.formula.tree import parts as tree_parts
from radartrack.derive.formula.unknown_names import unknown_name, unusable
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.tensor import Index, Tensor, indices
from radartrack.derive.language.variable import Variable
from radartrack.derive.reading.any_letters import read_loosely
from radartrack.derive.reading.joined_equations import Insertion
from radartrack.derive.reading.notation import LATEX, TEXT, Reading, read_formula
from radartrack.derive.reading.printed_text import is_printed
from radartrack.derive.reading.unit_text import measured
from radartrack.derive.symbolic import Expr
from radartrack.derive.verbs.no_closed_form import NoClosedForm
from radartrack.derive.verbs.table import VERBS

NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")
QUANTITY = re.compile(r"(?<![\w.])[A-Za-z_]\w*(?:\.(?!T\b)[A-Za-z_]\w*)+")
_BINDING = re.compile(r"\b(?:integral|limit|sum)\b|\\(?:int|lim|sum)|[∑∫]")
SHOWN = 40  # characters of a name that is refused
MOST_COMPLETED = 60  # definitions of a file that another may have been meant for
MOST_PARTS = 100_000  # of what a formula is when it is worked out


class Names(Mapping[str, Expression]):
    """The names that a formula may use, each with what it stands for.

    Args:
        symbols: by the name that a formula has for each.
        let: definitions as formulas, in any order. One may mention the symbol that it hides: beta = "pi/2 - beta".
        world: where quantities are found by name.
        known: what other names stand for.
        fixed: definitions on which what is compared with rests too: a slip in them would spoil both sides.
    """

    def __init__(
        self,
        symbols: Mapping[str, Variable],
        let: Mapping[str, str] = MappingProxyType({}),
        world: World = CATALOGUE,
        known: Mapping[str, Meaning] = MappingProxyType({}),
        fixed: frozenset[str] = frozenset(),
    ) -> None:
        self.symbols = {name: symbol for name, symbol in symbols.items() if name not in world.spoiled}
        self.let = let
        self._world = world
        self.fixed = fixed
        self._known: dict[str, Meaning] = dict(known)
        self._mentioned: set[str] = set()  # quantities
        self._being_defined: set[str] = set()
        self.remarks: list[str] = []  # what the reader of definitions has to say

    def __getitem__(self, name: str) -> Expression:
        return self.meaning(name).value

    def __iter__(self) -> Iterator[str]:
        return iter({**self.symbols, **self.let, **self._known, **self._world.spoiled})

    def __len__(self) -> int:
        return len({**self.symbols, **self.let, **self._known, **self._world.spoiled})

    def __contains__(self, name: object) -> bool:
        known = (self.symbols, self.let, self._known, self._mentioned, self._world.spoiled)
        return any(name in names for names in known)

    @property
    def values(self) -> Names:  # type: ignore[override]  # what the names stand for is this mapping itself
        """What each name stands for."""
        return self

    @property
    def numbers(self) -> dict[str, Expr]:
        """The names that stand for numbers, as far as they are known: of definitions, those that were needed."""
        found = {**self.symbols, **{name: one.value for name, one in self._known.items()}}
        return {name: value for name, value in found.items() if not isinstance(value, tuple)}

    @property
    def definitions(self) -> dict[str, Tree]:
        """Those that are known and are plain formulas of numbers, each after those that it needs."""
        known = {name: one for name, one in self._known.items() if one.tree is not None}
        return {
            name: one.tree
            for name, one in known.items()
            if one.tree is not None and not isinstance(one.value, tuple) and not _is_worked_out(one.tree)
        }

    @property
    def dimensions(self) -> dict[str, Dimension | None]:
        """Their dimensions; None where one has none."""
        return {name: self._dimension_or_none(name) for name in self.numbers}

    def knowing(self, more: Mapping[str, Meaning]) -> Names:
        """The same names and more."""
        return Names(self.symbols, self.let, self._world, {**self._known, **more}, self.fixed) if more else self

    def besides(self, more: Mapping[str, Variable]) -> Names:
        """The same names, and symbols more where these have none."""
        known = {name: symbol for name, symbol in more.items() if name not in self}
        return Names({**self.symbols, **known}, self.let, self._world, self._known, self.fixed)

    def with_symbols(self, more: Mapping[str, Variable]) -> Names:
        """The same names and symbols more; what was worked out without them is worked out again."""
        return Names({**self.symbols, **more}, self.let, self._world) if more else self

    def meaning(self, name: str) -> Meaning:
        """What a name stands for.

        Raises:
            FormulaError: for a name that is not known, and for a definition that cannot be read.
            NoClosedForm: when a definition cannot be worked out.
        """
        if name not in self._known:
            if name in self.let:
                for one in self._in_order(name):
                    self._known[one] = self._defined(one)
            elif name in self.symbols:
                return Meaning.of_symbol(self.symbols[name])
            elif name in self._world.spoiled:
                raise FormulaError(self._world.spoiled[name])
            elif "." in name:
                self._known[name] = Meaning.of_quantity(self._world.find(name))
            else:
                raise FormulaError(unknown_name(name, set(self)))
        return self._known[name]

    def tree(self, text: str, *, latex: bool = False) -> Tree:
        """A formula in these names, as typed or in LaTeX; raises as `reading`."""
        return self.reading(text, LATEX if latex else TEXT).tree

    def reading(self, text: str, notation: str = TEXT, function: str = "", wanted: int = 1) -> Reading:
        """A formula in these names, in one of the `NOTATIONS`; of code, perhaps one function, or several numbers.

        Raises:
            FormulaError, UnknownQuantity: when it cannot be read, names what there is not, or becomes too large.
        """
        typed = notation == TEXT and not is_printed(text)
        words = set(WORD.findall(text)) & self.let.keys() if typed else set(self.let) - self._being_defined
        mentioned = set(QUANTITY.findall(text)) if typed else set()
        for word in mentioned:
            self.meaning(word)
        self._mentioned |= mentioned
        opened = self.resting_on(indices_in(text, self.let, notation, function))
        of_opened = {name: one for name, one in _loose(self.let).shapes.items() if name in opened} if opened else {}
        known = words - opened.keys() | mentioned | (self._known.keys() & set(WORD.findall(text)))
        shapes = self._shapes(known, tolerant=not typed) | of_opened
        found = read_formula(text, notation, {*self, *mentioned}, shapes, function=function, wanted=wanted)
        if bound_names(found.tree) & (self.let.keys() | _words(opened.values())):
            found = replace(found, tree=rebuild(found.tree, lambda node: self._with_own_index(node, opened)))
        self.largeness(found.tree)
        return found

    def resting_on(self, indices: Collection[str]) -> dict[str, Tree]:
        """The definitions that rest on one of these, and no symbol of its name: F(s) under an integral over s."""
        names = [name for name in self.let if name not in indices and self._rests_on(name) & set(indices)]
        shapes = _loose(self.let).shapes if names else {}
        return {name: read_loosely(self.let[name], [*self, *indices], shapes=shapes) for name in names}

    def _with_own_index(self, node: Tree, opened: Mapping[str, Tree]) -> Tree:
        """A sum or the like whose index is meant in all that stands in it, in definitions too.

        Definitions that rest on the index are put in; where it is called as one, it gets a name of its own.
        """
        if not isinstance(node, Call) or node.function not in BINDING:
            return node
        inside, index, *ends = node.arguments
        if not isinstance(index, Name):
            return node
        name = index.name
        resting = {one: tree for one, tree in opened.items() if name in self._rests_on(one)}
        inside = Insertion(resting)(inside) if resting else inside
        if name not in self.let:
            return replace(node, arguments=(inside, index, *ends))
        own = replace(index, name=next(one for n in count(1) if (one := f"{name}_{n}") not in self))
        return replace(node, arguments=(rebuild(inside, lambda part: own if part == index else part), own, *ends))

    def _rests_on(self, name: str) -> set[str]:
        """The words of a definition, and those of the definitions that it mentions."""
        found: set[str] = set()
        waiting = [name]
        while waiting:
            words = set(WORD.findall(self.let.get(waiting.pop(), ""))) - found
            found |= words
            waiting += words
        return found

    def read(self, tree: Tree) -> Expr:
        """A tree that is a number, in symbols."""
        return only_scalar(self.worked_out(tree), tree)

    def worked_out(self, tree: Tree) -> Expression:
        """A tree in symbols, with its verbs worked out.

        Raises:
            NoClosedForm: naming the part that was too much.
        """
        found = self._reader(tree)
        if has_verbs(tree) or isinstance(found, tuple):
            size, most = number_of_parts(found), MOST_PARTS if isinstance(found, tuple) else MAX_NODES
            if size > most:
                raise NoClosedForm(f"worked out, {_shown(tree)} has more than {most} parts")
        return found

    def entries(self, tree: Tree) -> tuple[Tensor[Tree], Names]:
        """The entries of a formula, and the names with those that stand in them for what is worked out."""
        entries, parts = entries_of(tree, self)
        return entries, self.knowing(parts)

    def dimension_of(self, tree: Tree) -> Dimension:
        """The dimension of a tree that is a number, its verbs opened.

        Raises:
            WrongDimensions: when it has none.
        """
        return self._dimension_of(tree)

    def dimension_of_part(self, node: Tree) -> Dimension:
        """The dimension of a part that is worked out, from what comes out.

        Raises:
            WrongDimensions: when it has none, or a definition in it has none.
        """
        if isinstance(node, Entries) and isinstance(node.array, Name) and all(isinstance(i, int) for i in node.places):
            return self.meaning(node.array.name).dimension(tuple(i for i in node.places if isinstance(i, int)))
        for name in sorted(names_of(node) - (bound_names(node) - self.let.keys())):
            value = self.meaning(name).value
            for index in indices(shape_of(value)):
                self.meaning(name).dimension(index)
        expression = sp.unguarded(self.read(node))
        known = {
            symbol.name: Dimension.of(symbol.unit) for symbol in expression.free_symbols if isinstance(symbol, Variable)
        }
        return dimensions(known)(to_tree(expression))

    @cached_property
    def _reader(self) -> Reader:
        return Reader(self, VERBS)

    @cached_property
    def _dimension_of(self) -> Fold[Dimension]:
        return dimensions(_Dimensions(self))

    def _dimension_or_none(self, name: str) -> Dimension | None:
        try:
            return self.meaning(name).dimension(())
        except WrongDimensions:
            return None

    def _shapes(self, words: Iterable[str], *, tolerant: bool) -> dict[str, Shape]:
        """The shapes of those that stand for arrays; a tolerant look leaves out what cannot be read."""
        found = {}
        for word in words:
            try:
                found[word] = shape_of(self[word])
            except (FormulaError, NoClosedForm, UnknownQuantity):
                if not tolerant:
                    raise
        return {word: shape for word, shape in found.items() if shape}

    def largeness(self, tree: Tree) -> tuple[Measure, int]:
        """How large a formula may become, and how many parts it has, with all that its names stand for.

        Raises:
            FormulaError: when these are too many, or its numbers and powers become too large.
        """
        known = {name: self._known[name] for name in names_of(tree) & self._known.keys()}
        measure = magnitudes({name: one.measure for name, one in known.items()})(tree)
        size = _size(known)(tree)
        if size > MAX_NODES:
            raise FormulaError(f"with what its names stand for, this has more than {MAX_NODES} parts", span=tree.span)
        return measure, size

    def _in_order(self, name: str) -> list[str]:
        """The definitions that one needs, itself the last, each after those that it needs.

        Raises:
            FormulaError: naming those that define each other.
        """
        order: list[str] = []
        path = {name: iter(self._needed(name))}
        while path:
            last = next(reversed(path))
            needed = next(path[last], None)
            if needed is None:
                order.append(last)
                path.popitem()
            elif needed in path:
                cycle = [*list(path)[list(path).index(needed) :], needed]
                raise FormulaError(f"let {needed}: it is defined by itself: {' needs '.join(cycle)}")
            elif needed not in order:
                path[needed] = iter(self._needed(needed))
        return order

    def _needed(self, name: str) -> list[str]:
        """The definitions that one mentions and that are not known yet."""
        text = self.let[name]
        functions = self.resting_on(indices_in(text, self.let))
        words = sorted(set(WORD.findall(text)) & self.let.keys() - self._known.keys() - functions.keys())
        return [word for word in words if word != name or name not in self.symbols]

    def _defined(self, name: str) -> Meaning:
        check_name(name)
        text = self.let[name]
        hides = name in self.symbols and name in WORD.findall(text)
        others = self._without(name) if hides else self
        self._being_defined.add(name)
        try:
            number = measured(text)
            tree, constants = with_symbols(others.tree(number.formula if number else text), self.symbols)
            self.remarks += constants
            value = others.worked_out(tree)
            measure, size = others.largeness(tree)
        except FormulaError as error:
            raise FormulaError(f"let {name}: {error.message}", error.source or text, error.span) from None
        except NoClosedForm as error:
            raise NoClosedForm(f"let {name}: {error}") from None
        finally:
            self._being_defined.discard(name)
        if value == 0:
            return Meaning(value, lambda _: NOTHING, measure, size, tree)
        if number:
            return Meaning(value, lambda _: Dimension.of(number.unit), measure, size, tree)
        return Meaning(value, _dimensions_of(f"let {name}", tree, others), measure, size, tree)

    def completed(self) -> Names:
        """The same with all definitions that can be read."""
        found = Names(self.symbols, self.let, self._world, self._known, self.fixed)
        for name in islice(self.let, MOST_COMPLETED):
            with suppress(FormulaError, NoClosedForm, UnknownQuantity):
                found.meaning(name)
        return found

    def definitions_in(self, tree: Tree) -> dict[str, Tree]:
        """The definitions that a formula needs, each after those that it needs itself."""
        found: dict[str, Tree] = {}
        waiting = sorted(names_of(tree))
        while waiting:
            name = waiting[-1]
            own = self._known[name].tree if name in self._known else None
            below = [] if own is None else sorted(names_of(own) - found.keys() - {name})
            missing = [one for one in below if one in self._known and self._known[one].tree is not None]
            if missing:
                waiting += missing
                continue
            if own is not None:
                found[name] = own
            waiting.pop()
        return found

    def redefined(self, name: str, tree: Tree) -> Names:
        """The same names where a definition is another, and so are those that need it."""
        changed = {name}
        meanings = {one: found for one, found in self._known.items() if one != name}
        order = [one for one, found in self._known.items() if found.tree is not None]
        for one in order:  # each after those that it needs
            own = tree if one == name else self._known[one].tree
            if own is not None and (one == name or names_of(own) & changed):
                changed.add(one)
                before = Names(self.symbols, {}, self._world, {k: v for k, v in meanings.items() if k != one})
                meanings[one] = replace(self._known[one], value=before.worked_out(own), tree=own)
        return Names(self.symbols, self.let, self._world, meanings, self.fixed)

    def fixing(self, tree: Tree) -> Names:
        """The same names, of which the definitions that a formula needs are not to be mended."""
        fixed = self.fixed | self.definitions_in(tree).keys()
        return Names(self.symbols, self.let, self._world, self._known, fixed)

    def _without(self, name: str) -> Names:
        let = {one: text for one, text in self.let.items() if one != name}
        return Names(self.symbols, let, self._world, self._known)


def indices_in(text: str, let: Mapping[str, str], notation: str = TEXT, function: str = "") -> frozenset[str]:
    """The indices of sums and the like in a formula, of which definitions may be functions."""
    if not let or not _BINDING.search(text):
        return frozenset()
    try:
        return bound_names(read_loosely(text, [*let], notation, function, _loose(let).shapes))
    except (FormulaError, ValueError):  # is told where the formula is read
        return frozenset()


def _loose(let: Mapping[str, str]) -> LooseDefinitions:
    """The definitions before it is known what is in them; none where they are wrong, which is told later."""
    try:
        return LooseDefinitions(let, ())
    except (FormulaError, ValueError):
        return LooseDefinitions({}, ())


def symbols_for(
    texts: Iterable[str],
    let: Mapping[str, str],
    world: World,
    quantities: Iterable[Quantity] = (),
    *,
    of_models: bool = False,
) -> dict[str, Variable]:
    """The symbols that formulas may use, by name: the paper's letters, and those of quantities that occur in them.

    A letter of the same unit is the quantity's symbol, where the paper says that it lies; a letter of another unit is
    another symbol, and hides the quantity's.

    Args:
        texts: the formulas.
        let: definitions, of which those count that the formulas need.
        world: where quantities are found, and letters.
        quantities: further ones that occur.
        of_models: whether the symbols of their models count too: a covariance is made of a Jacobian and deviations.
    """
    mentioned = {name: None for text in _with_definitions(texts, let) for name in QUANTITY.findall(text)}
    known = [*quantities, *(found for name in mentioned if (found := _found(name, world)))]
    modules = {quantity.module for quantity in known} if of_models else set()
    family = (one for one in (*catalogue().values(), *world.quantities.values()) if one.module in modules)
    own = each_once(symbol for quantity in (*family, *known) for symbol in quantity.symbols)
    return own | {name: _letter(letter, own.get(name)) for name, letter in world.letters.items()}


def each_once(symbols: Iterable[Variable]) -> dict[str, Variable]:
    """Each symbol once: the number of scans of several quantities is as large as all of them ask."""
    found: dict[str, Variable] = {}
    for symbol in symbols:
        found[symbol.name] = max(found.get(symbol.name, symbol), symbol, key=lambda one: one.low)
    return found


def letters_of_catalogue(texts: Iterable[str], let: Mapping[str, str]) -> dict[str, Variable]:
    """The letters of formulas that mean one thing in all of the catalogue, such as r: no paper need declare them."""
    words = {word for text in _with_definitions(texts, let) for word in WORD.findall(text)}
    return {name: symbol for name, symbol in common_symbols().items() if name in words}


def _found(name: str, world: World) -> Quantity | None:
    try:
        return world.find(name)
    except (UnknownQuantity, FormulaError, NoClosedForm):  # is told where the formula is read
        return None


def _with_definitions(texts: Iterable[str], let: Mapping[str, str]) -> list[str]:
    """Formulas and all the definitions that they need."""
    found = list(texts)
    seen: set[str] = set()
    for text in found:  # grows
        new = set(WORD.findall(text)) & let.keys() - seen
        seen |= new
        found += [let[name] for name in new]
    return found


def _letter(letter: Variable, own: Variable | None) -> Variable:
    if own is None:
        return letter
    if own.unit != letter.unit:
        return Variable(f"{letter.name}'", letter.meaning, letter.unit, letter.low, letter.high, whole=letter.whole)
    low, high = max(own.low, letter.low), min(own.high, letter.high)
    return own.on(low, high) if low < high else own


def check_name(name: str) -> None:
    """Refuse what no formula is read to contain.

    Raises:
        FormulaError: saying what names are allowed.
    """
    if name in SPELLINGS:
        raise FormulaError(f"let {name}: {name} is a function; define another name")
    if not NAME.fullmatch(name):
        raise FormulaError(
            f"let {name[:SHOWN]}: a name is letters, digits and _, and begins with no digit; "
            r"\dot{x} is defined as xdot, \sigma_\theta as sigma_theta, and g(x) cannot be defined"
        )
    if why := unusable(name):
        raise FormulaError(f"let {name}: {why}")


class _Dimensions(Mapping[str, Dimension]):
    """The dimensions of names that stand for numbers; what has none is told when it is asked for."""

    def __init__(self, names: Names) -> None:
        self._names = names

    def __getitem__(self, name: str) -> Dimension:
        return self._names.meaning(name).dimension(())

    def __iter__(self) -> Iterator[str]:
        return iter(self._names)

    def __len__(self) -> int:
        return len(self._names)


def _dimensions_of(what: str, tree: Tree, names: Names) -> Callable[[Index], Dimension]:
    """The dimensions of the entries of a definition."""
    known: dict[Index, Dimension] = {}

    def dimension(index: Index) -> Dimension:
        if index not in known:
            try:
                entries, opened = names.entries(tree)
                known[index] = opened.dimension_of(entries[index])
            except WrongDimensions as error:
                raise in_definition(what, error) from None
        return known[index]

    return dimension


def _is_worked_out(tree: Tree) -> bool:
    """Whether there are verbs or parts of arrays in a formula."""
    return has_verbs(tree) or any(isinstance(node, Array | Entries) for node in tree_parts(tree))


def _words(trees: Iterable[Tree]) -> set[str]:
    return set[str]().union(*map(names_of, trees))


def _shown(tree: Tree) -> str:
    text = to_text(tree)
    return text if len(text) <= SHOWN else f"{text[:SHOWN]}..."


def _size(known: Mapping[str, Meaning]) -> Fold[int]:
    def step(node: Tree, below: Collection[int]) -> int:
        return known[node.name].size if isinstance(node, Name) and node.name in known else 1 + sum(below)

    return Fold(step)
