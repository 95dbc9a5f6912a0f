"""What a block of code makes of names, one statement after another, with the arithmetic of its language."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace

from radartrack.derive.formula.error import FormulaError, Span
from radartrack.derive.formula.functions import SPELLINGS
from radartrack.derive.formula.latex_names import candidates
from radartrack.derive.formula.limits import MAX_DEPTH, MAX_NODES, check_number
from radartrack.derive.formula.shape import Shape, shape_of_node
from radartrack.derive.formula.shape import shape as shape_of
from radartrack.derive.formula.tree import (
    Array,
    Call,
    Constant,
    Entries,
    Name,
    Negation,
    Number,
    Place,
    Power,
    Product,
    Quotient,
    Sum,
    Tree,
)
from radartrack.derive.formula.written_out import array_of
from radartrack.derive.language.tensor import Tensor, indices
from radartrack.derive.reading.code.array_entries import changed, entries_of, entry_of
from radartrack.derive.reading.joined_equations import expanded_size, results

LONGEST_CONDITION = 200  # characters
MAX_ROWS = 12
# abs(d) < 1e-4, d == 0: what keeps code from dividing by zero, and cuts nothing from the domain of a formula.
_SMALL = r"(?:0?\.0\d+|\d+(?:\.\d*)?[eE]-\d+)[fF]?"
_CALLED_SMALL = r"(?:\w+(?:<\w+>)?(?:\.|::|\(\w*\)\.))*\w*(?:eps|tol|small|tiny)\w*(?:\(\))?"
_SIZE = r"[^<>=!&|?~]*\bf?abs\w?\s*\([^<>=!&|?~]*"
_ZERO = r"0(?:\.0*)?[fF]?"
_BRANCHES = tuple(
    (is_first, re.compile(rf"(?:{form})[\s)]*", re.IGNORECASE))
    for is_first, form in (
        (False, rf"[^<>=!&|?~]*<=?\s*{_SMALL}|{_SIZE}<=?\s*{_CALLED_SMALL}|(?P<equal>[^<>=!&|?~]*)==\s*{_ZERO}"),
        (True, rf"{_SIZE}>=?\s*(?:{_SMALL}|{_CALLED_SMALL}|{_ZERO})|(?P<equal>[^<>=!&|?~]*)[!~]=\s*{_ZERO}"),
    )
)
NOT_COMPARED = "this branch, for a divisor next to zero, is not compared"
_BARE = re.compile(r"[A-Za-z_]\w*")  # if omega: it is not zero, where omega divides
_WORD = re.compile(r"[A-Za-z_]\w*")
_PI = frozenset({"pi", "M_PI", "PI"})


@dataclass(frozen=True, slots=True)
class Remark:
    """Something that the language does and a formula does not: where, and in words."""

    span: Span
    words: str


@dataclass(frozen=True, slots=True)
class Value:
    """What an expression is worth.

    Attributes:
        tree: as a formula, names replaced by what was assigned to them.
        shape: of the array; None where it is not known.
        whole: whether it is of a type of whole numbers, in a language where those divide without remainder.
        size: the parts and the depth of the tree with all that is shared written out.
        is_row: whether a vector lies, in a language where that makes a difference.
        is_matrix: whether it is of a class of matrices, whose * is their product where that of arrays is none.
    """

    tree: Tree
    shape: Shape | None = ()
    whole: bool = False
    size: tuple[int, int] = (1, 1)
    is_row: bool = False
    is_matrix: bool = False


@dataclass
class Workspace:
    """The names of a block and what they are worth.

    Args:
        language: its name, for messages.
        first: the number of the first entry of an array.
        names: the symbols that are known.
        shapes: of those that stand for arrays.
        wanted: how many numbers the code is to compute.
    """

    language: str
    first: int
    names: Collection[str]
    shapes: Mapping[str, Shape]
    wanted: int = 1
    remarks: list[Remark] = field(default_factory=list)
    has_matrices: bool = False  # besides arrays
    _values: dict[str, Value] = field(default_factory=dict)
    _entries: dict[str, dict[tuple[int, ...], Value]] = field(default_factory=dict)
    _called: dict[str, str] = field(default_factory=dict)  # entries of arrays that are not known, by the block
    _shared: set[frozenset[str]] = field(default_factory=set)
    _free: set[str] = field(default_factory=set)  # names that occur without a value
    _used: set[str] = field(default_factory=set)  # of those that have values, which others rest on
    _last: Value | str | None = None  # a value, or the name of an array of which entries are set

    def made(self, tree: Tree, parts: Sequence[Value], *, whole: bool = False) -> Value:
        """A node over values, if it has a meaning and is not too large.

        Raises:
            FormulaError: when it is, or has none.
        """
        nodes = 1 + sum(part.size[0] for part in parts)
        depth = 1 + max((part.size[1] for part in parts), default=0)
        if nodes > MAX_NODES:
            raise FormulaError(f"the formula has more than {MAX_NODES} parts", span=tree.span)
        if depth > MAX_DEPTH:
            raise FormulaError(f"the formula is nested more than {MAX_DEPTH} deep", span=tree.span)
        shapes = [part.shape for part in parts]
        known = [one for one in shapes if one is not None]
        found = shape_of_node(tree, known) if len(known) == len(shapes) else None
        return Value(tree, found, whole, (nodes, depth), is_matrix=any(part.is_matrix for part in parts))

    def number(self, text: str, span: Span, *, whole: bool = False) -> Value:
        """A number as written."""
        check_number(text, span)
        return Value(Number(text, span=span), whole=whole)

    def constant(self, name: str, span: Span) -> Value:
        """Pi, or Euler's number."""
        return Value(Constant(name, span=span))

    def name(self, name: str, span: Span, *, whole: bool = False) -> Value:
        """What a name is worth; `whole` where it is declared as a whole number."""
        if name in self._values:
            self._used.add(name)
            return self._values[name]
        if name in self._entries:
            return self._matrix(name, span)
        if name in _PI and name not in self.names:
            return self.constant("pi", span)
        return self._symbol(name, span, whole=whole)

    def _symbol(self, name: str, span: Span, *, whole: bool = False) -> Value:
        """A name that means itself, whatever it is assigned later."""
        if name in SPELLINGS:
            raise FormulaError(f"{name} is a function: give its argument in brackets", span=span)
        is_known = name in self.names
        self._free.add(name)
        return Value(Name(name, span=span), self.shapes.get(name, ()) if is_known else None, whole)

    def branch(self, condition: str, branches: tuple[str, str], span: Span) -> bool | None:
        """Whether the first of two branches is a formula's, as the other is only taken next to zero of a divisor.

        None for other cases, such as a switch that is compared with zero and that neither branch computes with. That a
        branch is not compared is said.
        """
        found = ((is_first, form.fullmatch(condition[: LONGEST_CONDITION + 1])) for is_first, form in _BRANCHES)
        is_first, meant = next((one for one in found if one[1]), (False, None))
        bare = _BARE.fullmatch(condition.strip())
        is_bare = bare is not None and re.search(rf"/\s*\(*\s*{bare.group()}\b", branches[0]) is not None
        if (meant is None and not is_bare) or len(condition) > LONGEST_CONDITION:
            return None
        is_first = is_first or is_bare
        words = set(_WORD.findall(condition if meant is None else meant["equal"] or ""))
        if words and all(branches) and words.isdisjoint(_WORD.findall(branches[not is_first])):
            return None
        self.remarks.append(Remark(span, NOT_COMPARED))
        return is_first

    def is_defined(self, name: str) -> bool:
        """Whether something was assigned to a name."""
        return name in self._values or name in self._entries

    def is_known(self, name: str) -> bool:
        """Whether a name has a value here, or is a symbol."""
        return self.is_defined(name) or name in self.names

    def named_anew(self, name: str, span: Span) -> Value:
        """What a name is worth that no longer means what was assigned to it before."""
        self._values.pop(name, None)
        self._entries.pop(name, None)
        return self.name(name, span)

    def entry(self, name: str, places: Sequence[Place], span: Span) -> Value:
        """An entry of an array, counted as the language does; of an unknown one, a name of its own: x[0] is x_0."""
        counted = tuple(places)
        for place in counted:
            self._from_zero(place, span)  # refuses one before the first
        if name in self._entries and name not in self._values:
            found = self._entries[name].get(_numbers(counted))
            if found is None:
                raise FormulaError(f"this entry of {name} was not set", span=span)
            return found
        if name in self._values or name in self.shapes:
            array = self.name(name, span)
            return self.picked(array, places, span)
        below = "_".join(map(str, _numbers(counted))) if all(isinstance(place, int) for place in counted) else ""
        if not below:
            raise FormulaError(f"the shape of {name} is not known: entries are picked from it one by one", span=span)
        possible = candidates(name, below)
        called = next((one for one in possible if one in self.names), possible[0])
        return self._symbol(self._called[called], span) if called in self._called else self.name(called, span)

    def picked(self, array: Value, places: Sequence[Place], span: Span) -> Value:
        """Entries of an array that is known."""
        shifted = tuple(self._from_zero(place, span) for place in places)
        if isinstance(array.tree, Array) and all(isinstance(place, int) for place in shifted):
            return self._part(array, _numbers(shifted), span)
        return self.made(Entries(array.tree, shifted, span=span), [array])

    def _part(self, array: Value, places: tuple[int, ...], span: Span) -> Value:
        """One entry of an array that is written out."""
        there = self.made(Entries(array.tree, places, span=span), [array])  # refuses one that is not there
        tree = entry_of(array.tree, places, span)
        return replace(there, tree=tree, size=expanded_size(tree))

    def _from_zero(self, place: Place, span: Span) -> Place:
        if isinstance(place, int):
            if place < self.first:
                raise FormulaError(f"entries are counted from {self.first} in {self.language}", span=span)
            return place - self.first
        start, end = place  # of a slice
        return (None if start is None else start - self.first), end  # MATLAB's last one is in, others' end is out

    def sum(self, terms: Sequence[Value], span: Span) -> Value:
        """Two or more terms; a subtracted one is a negation."""
        tree = Sum(tuple(term.tree for term in terms), span=span)
        return self.made(tree, terms, whole=all(term.whole for term in terms))

    def negated(self, value: Value, span: Span) -> Value:
        """A value with the other sign."""
        return replace(self.made(Negation(value.tree, span=span), [value], whole=value.whole), is_row=value.is_row)

    def product(self, factors: Sequence[Value], span: Span, *, of_entries: bool = False) -> Value:
        """Two or more factors; of arrays the matrix product, unless the language takes entry by entry."""
        if of_entries and not self._are_matrices(factors, span):
            return self._entrywise(factors, span)
        first = factors[0]
        if isinstance(first.tree, Negation):  # -a*b is printed as -(a*b)
            positive = replace(first, tree=first.tree.operand)
            return self.negated(self.product([positive, *factors[1:]], span, of_entries=of_entries), span)
        arrays = [factor for factor in factors if factor.shape]
        if len(arrays) > 1:
            factors = [self.call("transpose", [factor], span) if factor.is_row else factor for factor in factors]
        tree = Product(tuple(factor.tree for factor in factors), span=span)
        found = self.made(tree, factors, whole=all(factor.whole for factor in factors))
        return replace(found, is_row=arrays[0].is_row) if len(arrays) == 1 else found

    def quotient(self, above: Value, below: Value, span: Span) -> Value:
        """A quotient; of whole numbers, where the language says so, without the remainder."""
        if above.whole and below.whole:
            return self._whole_quotient(above, below, span)
        if isinstance(above.tree, Negation):
            positive = Value(above.tree.operand, above.shape, above.whole, above.size)
            return self.negated(self.quotient(positive, below, span), span)
        return self.made(Quotient(above.tree, below.tree, span=span), [above, below])

    def _whole_quotient(self, above: Value, below: Value, span: Span) -> Value:
        first, second = _whole_number(above.tree), _whole_number(below.tree)
        if first is None or second is None:
            raise FormulaError(
                f"whole numbers divide without remainder in {self.language}: write 2.0 for 2 if that is not meant",
                span=span,
            )
        if not second:
            raise FormulaError("this divides by zero", span=span)
        result = abs(first) // abs(second) * (1 if (first < 0) == (second < 0) else -1)
        self.remarks.append(
            Remark(
                span,
                f"{first}/{second} is {result} in {self.language}, where whole numbers divide without remainder: "
                f"{first}.0/{second} is the fraction",
            )
        )
        number = Value(Number(str(abs(result)), span=span), whole=True)
        return number if result >= 0 else self.negated(number, span)

    def power(self, base: Value, exponent: Value, span: Span, *, of_entries: bool = False) -> Value:
        """A power; of a matrix the product of it with itself, unless the language takes entry by entry."""
        if of_entries and self.sized(base).shape and not self._are_matrices([base], span):
            opened = self.opened(base, span)
            self._say_of_entries("**", [self.sized(base)], span)
            powers: list[Tree] = [Power(entry, exponent.tree, span=span) for entry in opened]
            entries = Tensor(opened.shape, tuple(powers))
            self.made(Power(entries.entries[0], exponent.tree, span=span), [replace(base, shape=()), exponent])
            return self.of_entries(entries, [base, exponent], is_row=base.is_row)
        return self.made(Power(base.tree, exponent.tree, span=span), [base, exponent])

    def _are_matrices(self, factors: Sequence[Value], span: Span) -> bool:
        """Whether arrays are of a class of matrices.

        Raises:
            FormulaError: where that is not known, as there are some.
        """
        arrays = [factor for factor in factors if self.sized(factor).shape]
        if self.has_matrices and not all(one.is_matrix for one in arrays):
            raise FormulaError(
                "whether this works entry by entry depends on the class: write @ for products", span=span
            )
        return self.has_matrices

    def _say_of_entries(self, sign: str, arrays: Sequence[Value], span: Span) -> None:
        """Say that a sign of Python works entry by entry on matrices, whose product is written otherwise."""
        if self.language == "Python" and any(len(one.shape or ()) > 1 for one in arrays):
            self.remarks.append(Remark(span, f"{sign} of matrices works entry by entry in Python: @ is their product"))

    def _entrywise(self, factors: Sequence[Value], span: Span) -> Value:
        """The product of arrays of one shape, entry by entry; numbers among them are factors of all."""
        factors = [self.sized(factor) for factor in factors]
        arrays = [factor for factor in factors if factor.shape]
        self._say_of_entries("*", arrays, span)
        if len({(one.shape, one.is_row) for one in arrays}) > 1:
            raise FormulaError(
                f"* of arrays multiplies entry by entry in {self.language}, and these are of different shapes",
                span=span,
            )
        columns = [self.opened(one, span) if one.shape else None for one in factors]

        def entry(*at: int) -> Tree:
            its = (one.tree if column is None else column[at] for one, column in zip(factors, columns, strict=True))
            return Product(tuple(its), span=span)

        entries = Tensor.build(arrays[0].shape or (), entry)
        return self.of_entries(entries, factors, is_row=arrays[0].is_row)

    def opened(self, array: Value, span: Span) -> Tensor[Tree]:
        """The entries of an array, or the number that it is.

        Raises:
            FormulaError: for an array whose shape is not known.
        """
        array = self.sized(array)
        if array.shape is None:
            raise FormulaError("the shape of this array is not known: write its entries out", span=span)
        return entries_of(array.tree, array.shape, span)

    def both_arrays(self, factors: Sequence[Value], factor: Value) -> bool:
        """Whether one of the factors, and the one that follows them, are arrays."""
        return bool(self.sized(factor).shape) and any(self.sized(one).shape for one in factors)

    def are_vectors(self, values: Sequence[Value]) -> bool:
        """Whether all are vectors, of which the product is a number."""
        return all(len(self.sized(one).shape or ()) == 1 for one in values)

    def sized(self, value: Value) -> Value:
        """A value with the shape that it has if all names of unknown shape are numbers, where that is an array."""
        if value.shape is not None:
            return value
        try:
            return replace(value, shape=shape_of(value.tree, self.shapes) or None)
        except FormulaError:
            return value

    def of_entries(self, entries: Tensor[Tree], parts: Sequence[Value], *, is_row: bool = False) -> Value:
        """An array of entries, which each may hold all of the parts.

        Raises:
            FormulaError: for one that is too large.
        """
        nodes = len(entries.entries) * (1 + sum(part.size[0] for part in parts))
        if nodes > MAX_NODES:
            raise FormulaError(f"the formula has more than {MAX_NODES} parts")
        depth = len(entries.shape) + 1 + max(part.size[1] for part in parts)
        return Value(array_of(entries), entries.shape, size=(nodes, depth), is_row=is_row)

    def array(self, entries: Sequence[Value], span: Span) -> Value:
        """A vector, or a matrix of rows.

        Raises:
            FormulaError: for one without entries.
        """
        if not entries:
            raise FormulaError("an array without entries is not read", span=span)
        known = [Value(one.tree, one.shape or (), size=one.size) for one in entries]  # what is not known is a number
        return self.made(Array(tuple(entry.tree for entry in entries), span=span), known)

    def fitting(self, values: Sequence[Value]) -> Value | None:
        """The one of several values that are computed together, a mean and its covariance, that may be meant.

        None where they are the entries of one array.
        """
        sized = [self.sized(value) for value in values]
        if len({value.shape for value in sized}) < 2 or not any(value.shape for value in sized):
            return None
        ranks = [len(value.shape or ()) for value in sized]
        meant = [one for one in sized if one.shape == (self.wanted,)]
        return meant[0] if meant else sized[ranks.index(max(ranks))]

    def call(self, function: str, arguments: Sequence[Value], span: Span) -> Value:
        """A function or a verb of formulas."""
        return self.made(Call(function, tuple(one.tree for one in arguments), span=span), arguments)

    def assign(self, name: str, value: Value) -> None:
        """Give a name a value."""
        self._shared = {pair for pair in self._shared if name not in pair}
        self._values[name] = value
        self._entries.pop(name, None)
        self._last = value

    def share(self, name: str, other: str) -> None:
        """Let two names be of one array: an entry of it is then set in both, which is not followed here."""
        if self.sized(self._values[name]).shape and self.is_defined(other):
            self._shared.add(frozenset((name, other)))

    def check_alone(self, name: str, span: Span) -> None:
        """Refuse to change an array in place that another name is of too.

        Raises:
            FormulaError: where one is.
        """
        if shared := next((pair for pair in self._shared if name in pair), None):
            both = " and ".join(sorted(shared))
            raise FormulaError(
                f"{both} are one array in {self.language}, which is changed here: write .copy()", span=span
            )

    def call_entry(self, called: str, name: str, places: Sequence[Place]) -> None:
        """Let an entry of an array that is not known have a name from here on: px = state[0]."""
        numbers = _numbers(tuple(places))
        if len(name) == 1 or not numbers or len(numbers) < len(places) or self.is_known(name) or name in self._entries:
            return
        possible = candidates(name, "_".join(map(str, numbers)))
        is_free = not self.is_defined(called) and called not in self._free
        if is_free and possible[0] not in self._called and not any(one in self.names for one in possible):
            self._called[possible[0]] = called

    def assign_entry(self, name: str, places: Sequence[Place], value: Value, span: Span) -> None:
        """Give an entry of an array a value, or a slice of one that has values.

        Raises:
            FormulaError: for entries that the array does not have, and a value of another shape than the slice.
        """
        shifted = tuple(self._from_zero(place, span) for place in places)
        self.check_alone(name, span)
        if name in self._values:
            self._values[name] = self._last = self._with_entries(self._values[name], shifted, value, span)
            return
        if not all(isinstance(place, int) for place in places):
            raise FormulaError(f"entries of {name}, whose size is not known, are set one by one", span=span)
        self._entries.setdefault(name, {})[_numbers(tuple(places))] = value
        self._last = name

    def _with_entries(self, array: Value, places: tuple[Place, ...], value: Value, span: Span) -> Value:
        """An array in which what is at these places has another value; a number is that of all of them."""
        target = self.made(Entries(array.tree, places, span=span), [array])  # refuses what is not there
        value = self.sized(value) if target.shape else value
        if value.shape is None and target.shape:
            raise FormulaError("the shape of what is set here is not known: set the entries one by one", span=span)
        if value.shape and value.shape != target.shape:
            raise FormulaError("what is set here is of another shape than its place", span=span)
        new = self.opened(value, span) if value.shape else value.tree
        entries = changed(self.opened(array, span), places, new)
        tree = array_of(entries)
        size = expanded_size(tree)
        if size[0] > MAX_NODES:
            raise FormulaError(f"the formula has more than {MAX_NODES} parts", span=span)
        return replace(array, tree=tree, size=size)

    def declare(self, name: str, shape: Shape) -> None:
        """An array of this shape, zero until it is set.

        Raises:
            FormulaError: for one with too many rows or columns.
        """
        self._values[name] = self.zeros(shape, (0, 0))

    def zeros(self, shape: Shape, span: Span) -> Value:
        """An array of zeros."""
        if not shape or len(shape) > 2 or not all(1 <= size <= MAX_ROWS for size in shape):
            raise FormulaError(f"arrays have 1 to {MAX_ROWS} rows and columns", span=span)
        zero = self.number("0", span)
        row = self.array([zero] * shape[-1], span)
        return row if len(shape) == 1 else self.array([row] * shape[0], span)

    def of_kind(self, diagonal: str, shape: Shape, span: Span) -> Value:
        """A matrix with a number on its diagonal, else of zeros."""
        made = self.zeros(shape, span)
        numbers = (Number(diagonal if len(set(at)) == 1 else "0", span=span) for at in indices(shape))
        return replace(made, tree=array_of(Tensor(shape, tuple(numbers))))

    def filled(self, value: Value, shape: Shape, span: Span) -> Value:
        """An array of C of which the first entries are given, row by row or one after the other; the rest are zero."""
        value = self.sized(value)
        if not value.shape or value.shape == shape:
            return value
        given = self.opened(value, span)
        zeros = self.opened(self.zeros(shape, span), span)
        flat = len(given.shape) == 1
        places = zip(zeros.indices, given, strict=False) if flat else given.items()
        entries = dict(zeros.items()) | dict(places)
        if len(entries) != len(zeros.entries) or len(given.entries) > len(zeros.entries):
            raise FormulaError("these are more entries than the array has", span=span)
        return self.of_entries(Tensor(shape, tuple(entries.values())), [value])

    def result(self, value: Value | None = None) -> Value:
        """A value that was returned, or else what was assigned last: all entries of an array, where those were set.

        Where several numbers are wanted, those of `results`, if they are as many.

        Raises:
            FormulaError: when nothing was.
        """
        if value is not None:
            return value
        if self._last is None:
            raise FormulaError("no value is assigned or returned here")
        if isinstance(self._last, str):
            return self._matrix(self._last, (0, 0))
        numbers = {name: value for name, value in self._values.items() if not value.shape}
        meant = [list(numbers.values())[place] for place in results(list(numbers), self._used, self.wanted)]
        if self.wanted != 1 and len(meant) == (self.wanted or max(len(meant), 2)) and not self._last.shape:
            spans = [value.tree.span or (0, 0) for value in meant]
            return self.array(meant, (spans[0][0], spans[-1][1]))
        return self._last

    def _matrix(self, name: str, span: Span) -> Value:
        entries = self._entries[name]
        if len(entries) == 1:
            return next(iter(entries.values()))
        ranks = {len(places) for places in entries}
        sizes = [max(one) - self.first + 1 for one in zip(*entries, strict=False)]
        if len(ranks) > 1 or len(sizes) > 2 or not all(1 <= size <= MAX_ROWS for size in sizes):
            raise FormulaError(f"the entries of {name} that are set make no vector or matrix", span=span)
        return self._filled(name, (), sizes, span)

    def _filled(self, name: str, before: tuple[int, ...], sizes: Sequence[int], span: Span) -> Value:
        if not sizes:
            if before not in self._entries[name]:
                raise FormulaError(f"the entry {', '.join(map(str, before))} of {name} is not set", span=span)
            return self._entries[name][before]
        rows = [self._filled(name, (*before, self.first + at), sizes[1:], span) for at in range(sizes[0])]
        spans = [row.tree.span for row in rows if row.tree.span]
        return self.array(rows, (min(one[0] for one in spans), max(one[1] for one in spans)) if spans else span)


def _numbers(places: Sequence[Place]) -> tuple[int, ...]:
    return tuple(place for place in places if isinstance(place, int))


def _whole_number(tree: Tree) -> int | None:
    """A whole number, computed from whole numbers."""
    match tree:
        case Number(text) if text.isdigit():
            return int(text)
        case Negation(operand):
            value = _whole_number(operand)
            return None if value is None else -value
        case Sum(terms):
            values = [_whole_number(term) for term in terms]
            return sum(value for value in values if value is not None) if None not in values else None
        case Product(factors):
            product = 1
            for factor in factors:
                value = _whole_number(factor)
                if value is None:
                    return None
                product *= value
            return product
    return None
