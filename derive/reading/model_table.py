"""Reads models of one's own from tables, `[[model]]`, and writes a model as such a table.

Everything in a table is data: formulas are read as a stranger's text, definitions are put into them as trees, within
the limits of one formula for the whole.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.multiplied_out import terms
from radartrack.derive.catalogue import catalogue, common_symbols
from radartrack.derive.evaluation.real_outputs import require_real
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.fold import rebuild
from radartrack.derive.formula.from_expression import to_tree
from radartrack.derive.formula.functions import SPELLINGS
from radartrack.derive.formula.limits import check_size
from radartrack.derive.formula.magnitude import magnitudes
from radartrack.derive.formula.printing import to_text
from radartrack.derive.formula.to_expression import Expression, Reader
from radartrack.derive.formula.tree import Name, Tree, names
from radartrack.derive.formula.unknown_names import unusable
from radartrack.derive.language.model import Model
from radartrack.derive.language.source import Source
from radartrack.derive.language.variable import Variable, correlation
from radartrack.derive.reading.fitting_units import fitting_units, turned_names
from radartrack.derive.reading.symbol_table import SHOWN, TableError, read_symbol, shown, shown_name
from radartrack.derive.reading.text import read_text
from radartrack.derive.reading.unit_text import read_unit
from radartrack.derive.symbolic import Expr
from radartrack.derive.units import METRE, ONE, Unit

FIELDS = (
    "name", "title", "measured", "parameters", "outputs", "units", "deviations", "correlations", "source",
)  # fmt: skip
NEEDED = ("name", "measured", "outputs", "units")
SOURCE = ("author", "year", "where", "doi")
MOST_MODELS = 20
MOST_SYMBOLS = 12  # measured, and parameters
MOST_OUTPUTS = 6
MOST_CHARACTERS = 10_000  # of a formula
DEEPEST = 50  # definitions within definitions
NEAR = 1e4  # metres: the most of a length of which nothing is said, where more leaves the outputs without a value
MOST_TERMS = 1_000  # of an output, multiplied out

Table = Mapping[str, Any]


def read_models(data: Table) -> list[Model]:
    """The models of a file, which may use its symbols and definitions.

    Args:
        data: the whole of it: `model`, a list of tables, and perhaps `symbols`, `let`, `paper` and `doi`.

    Raises:
        TableError: naming the model, the field, what was given and what is allowed.
    """
    return [read_model(table, data) for table in model_tables(data).values()]


def model_tables(data: Table) -> dict[str, Table]:
    """The tables of a file's models by their names; nothing else in them is read.

    Raises:
        TableError: where there are no such tables, too many, or one without a name of its own.
    """
    tables = data.get("model", [])
    if not isinstance(tables, list) or not all(isinstance(table, Mapping) for table in tables):
        raise TableError("model must be one or more tables, each begun by [[model]]")
    if len(tables) > MOST_MODELS:
        raise TableError(f"at most {MOST_MODELS} models are read, given {len(tables)}")
    found: dict[str, Table] = {}
    for number, table in enumerate(tables, start=1):
        name = table.get("name")
        if not isinstance(name, str) or not name.strip():
            raise TableError(f'model {number}: name must be text, such as "bistatic_w"; given {shown(name)}')
        if name in found:
            raise TableError(f"model {shown_name(name)}: name occurs twice; every model has a name of its own")
        found[name] = table
    return found


def read_model(table: Table, data: Table) -> Model:
    """One of these models.

    Raises:
        TableError: naming the model, the field, what was given and what is allowed.
    """
    return _ModelTable(table, data).model()


def require_own_name(model: Model) -> None:
    """Refuse the name of a model that hides what is built in.

    Raises:
        TableError: naming it.
    """
    if model.name in {quantity.module for quantity in catalogue().values()}:
        raise TableError(f"model {model.name}: name is one of the catalogue's; give your model another, such as my_...")


class _ModelTable:
    """One `[[model]]`, and what the file says for all of them."""

    def __init__(self, table: Table, data: Table) -> None:
        self._where = f"model {shown_name(str(table['name']))}"
        self._table, self._data = table, data
        self._fitting: Mapping[str, Variable] = {}

    def model(self) -> Model:
        for field in self._table:
            if field not in FIELDS:
                raise self._error(f"{shown_name(field)} is no field of a model; allowed: {', '.join(FIELDS)}")
        for field in NEEDED:
            if field not in self._table:
                raise self._error(f"{field} is missing; a model has {', '.join(NEEDED)}")
        self._fitting = self._fitting_symbols()
        try:
            return self._model()
        except TableError:
            if not any(symbol.unit == METRE for symbol in self._fitting.values()):
                raise
        near = {name: one.on(one.low, NEAR) if one.unit == METRE else one for name, one in self._fitting.items()}
        self._fitting = near
        return self._model()

    def _model(self) -> Model:
        measured, parameters = self._symbols("measured"), self._symbols("parameters")
        outputs = self._outputs({symbol.name: symbol for symbol in (*measured, *parameters)})
        deviations = self._deviations(measured)
        correlations = self._correlations(measured)
        try:
            model = Model(
                name=self._text("name"),
                title=self._text("title", self._table["name"]),
                measured=measured,
                parameters=parameters,
                deviations=deviations,
                correlations=correlations,
                outputs=outputs,
                units=self._units(outputs),
                source=self._source(),
            )
            require_own_name(model)
            require_real(model.outputs.items(), model.arguments, model.measured)
        except TableError:
            raise
        except (ArithmeticError, TypeError, ValueError) as error:
            raise self._error(str(error)) from None
        return model

    def _error(self, message: str) -> TableError:
        return TableError(f"{self._where}: {message}")

    def _text(self, field: str, otherwise: str = "") -> str:
        value = self._table.get(field, otherwise)
        if not isinstance(value, str) or not value.strip():
            raise self._error(f"{field} must be text, given {shown(value)}")
        return value

    def _names(self, field: str) -> list[str]:
        value = self._table.get(field, [])
        if not isinstance(value, list) or not all(isinstance(name, str) for name in value):
            raise self._error(f'{field} must be a list of symbols, such as ["r", "theta"]; given {shown(value)}')
        if len(value) > MOST_SYMBOLS:
            raise self._error(f"{field} names at most {MOST_SYMBOLS} symbols, given {len(value)}")
        return value

    def _mapping(self, field: str, such_as: str) -> Table:
        value = self._table.get(field, {})
        if not isinstance(value, Mapping):
            raise self._error(f"{field} must be a table, such as {such_as}; given {shown(value)}")
        return value

    def _symbols(self, field: str) -> tuple[Variable, ...]:
        return tuple(self._symbol(name, field) for name in self._names(field))

    def _symbol(self, name: str, field: str) -> Variable:
        said = self._said()
        if name not in said and name not in self._fitting:
            known = ", ".join(map(shown_name, list(said)[:20])) or "nothing"
            raise self._error(f"{field}: [symbols] says nothing of {shown_name(name)}; it has {known}")
        return self._fitting[name] if name not in said else self._own(lambda: read_symbol(name, said[name]))

    def _fitting_symbols(self) -> dict[str, Variable]:
        """Those of which nothing is said: the catalogue's, or of the unit in which the outputs have theirs."""
        named = {name: None for field in ("measured", "parameters") for name in self._names(field)}
        known = {name: self._symbol(name, "symbols") for name in named if name in self._said()}
        unknown = [name for name in named if name not in known and not unusable(name)]
        if not unknown:
            return {}
        own = {name: symbol for name, symbol in common_symbols().items() if name in unknown}
        provisional = {name: read_symbol(name, {"unit": "1"}) for name in unknown}
        outputs = self._outputs({**known, **provisional, **own})
        trees = {name: to_tree(sp.unguarded(value)) for name, value in outputs.items()}
        turned = {name for tree in trees.values() for name in turned_names(tree)}
        sure = {name: symbol for name, symbol in own.items() if symbol.unit != ONE or name not in turned}
        units = {name: symbol.unit for name, symbol in {**known, **sure}.items()}
        groups = [([trees[name]], unit) for name, unit in zip(outputs, self._units(outputs), strict=True)]
        used = {symbol.name for value in outputs.values() for symbol in value.free_symbols}
        fitting = fitting_units(units, [name for name in unknown if name not in sure and name in used], groups)
        return {**sure, **{name: read_symbol(name, {"unit": str(unit)}) for name, unit in fitting.items()}}

    def _said(self) -> Table:
        """`[symbols]` of the file."""
        said = self._data.get("symbols", {})
        if not isinstance(said, Mapping):
            raise TableError(f'symbols must be a table, such as r = {{ unit = "m" }}; given {shown(said)}')
        return said

    def _own(self, read: Callable[[], Variable]) -> Variable:
        try:
            return read()
        except TableError as error:
            raise self._error(str(error)) from None

    def _outputs(self, symbols: Mapping[str, Variable]) -> dict[str, Expr]:
        outputs = self._mapping("outputs", '{ x = "r*cos(beta)" }')
        if not 0 < len(outputs) <= MOST_OUTPUTS:
            raise self._error(f"outputs must be one to {MOST_OUTPUTS} formulas, given {len(outputs)}")
        definitions = _Definitions(self._data.get("let", {}), symbols)
        found = {}
        for name, text in outputs.items():
            try:
                found[name] = definitions.expression(text)
            except FormulaError as error:
                raise self._error(f"outputs.{shown_name(name)}: {error}") from None
            except TableError as error:
                raise self._error(f"outputs.{shown_name(name)} {error}") from None
        return found

    def _units(self, outputs: Iterable[str]) -> tuple[Unit, ...]:
        """In SI: an output is worked out from symbols that are."""
        units = self._mapping("units", '{ x = "m" }')
        if set(units) != set(outputs):
            raise self._error(f"units must name each output once: {', '.join(outputs)}; given {shown(dict(units))}")
        return tuple(self._unit(name, units[name]) for name in outputs)

    def _unit(self, name: str, text: object) -> Unit:
        if not isinstance(text, str):
            raise self._error(f'units.{name} must be a unit in quotes, such as "m"; given {shown(text)}')
        try:
            scale = read_unit(text)
        except ValueError as error:
            raise self._error(f"units.{name}: {error}") from None
        if scale.formula != "1":
            raise self._error(f"units.{name} must be an SI unit, {scale.unit}; formulas are in SI; given {shown(text)}")
        return scale.unit

    def _deviations(self, measured: Sequence[Variable]) -> tuple[Variable, ...]:
        given = self._mapping("deviations", '{ r = "sigma_r" }')
        if not given:
            return ()
        if set(given) != {symbol.name for symbol in measured} or not all(isinstance(n, str) for n in given.values()):
            wanted = ", ".join(symbol.name for symbol in measured)
            raise self._error(f"deviations must name a symbol for each of {wanted}; given {shown(dict(given))}")
        return tuple(self._deviation(symbol, given[symbol.name]) for symbol in measured)

    def _deviation(self, of: Variable, name: str) -> Variable:
        meaning = f"standard deviation of the error of {of.name}"
        said = self._said().get(name, {"unit": str(of.unit)})
        fields = {"meaning": meaning, **said} if isinstance(said, Mapping) else said
        return self._own(lambda: read_symbol(name, fields, deviation_of=of))

    def _correlations(self, measured: Sequence[Variable]) -> dict[tuple[Variable, Variable], Variable]:
        by_name = {symbol.name: symbol for symbol in measured}
        found: dict[tuple[Variable, Variable], Variable] = {}
        for name, pair in self._mapping("correlations", '{ rho = ["r", "beta"] }').items():
            fits = isinstance(pair, list) and len(pair) == 2 and all(isinstance(one, str) for one in pair)
            if not fits or not set(pair) <= by_name.keys():
                wanted = f"two of {', '.join(by_name)}"
                raise self._error(f"correlations.{shown_name(name)} must name {wanted}; given {shown(pair)}")
            first, second = by_name[pair[0]], by_name[pair[1]]
            if (first, second) in found:
                raise self._error(f"correlations.{shown_name(name)}: {shown(pair)} have a correlation already")
            found[first, second] = self._correlation(name, first, second)
        return found

    def _correlation(self, name: str, first: Variable, second: Variable) -> Variable:
        own = correlation(name, first, second)
        said = self._said().get(name)
        if said is None:
            return own
        fields = {"unit": "1", "meaning": own.meaning, **said} if isinstance(said, Mapping) else said
        read = self._own(lambda: read_symbol(name, fields))
        return Variable(name, read.meaning, read.unit, read.low, read.high, is_correlation=True)

    def _source(self) -> Source:
        """That of the model, or the paper."""
        given = self._table.get("source", self._data.get("paper", "a model of one's own"))
        if isinstance(given, str):
            return Source(given.strip(), None, doi=self._doi() if "source" not in self._table else "")
        table = given if isinstance(given, Mapping) else {}
        year = table.get("year")
        words = [word for field in ("author", "where", "doi") if isinstance(word := table.get(field, ""), str)]
        fits = "author" in table and set(table) <= set(SOURCE) and len(words) == 3
        if not fits or not (year is None or type(year) is int):
            raise self._error(
                f"source must be text, or a table of {', '.join(SOURCE)}, the year a number; given {shown(given)}"
            )
        return Source(words[0], year, words[1], words[2])

    def _doi(self) -> str:
        doi = self._data.get("doi", "")
        if not isinstance(doi, str):
            raise TableError(f"doi must be text, given {shown(doi)}")
        return doi


class _Definitions:
    """`[let]` of a file: each is read where it is needed, in whatever order they stand."""

    def __init__(self, texts: object, symbols: Mapping[str, Variable]) -> None:
        if not isinstance(texts, Mapping):
            raise TableError(f'let must be a table of formulas, such as R = "r + h"; given {shown(texts)}')
        if hidden := sorted(texts.keys() & SPELLINGS.keys()):
            raise TableError(f"let {hidden[0]}: {hidden[0]} is a function; define another name")
        self._texts: Mapping[str, object] = texts
        self._symbols = symbols
        self._trees: dict[str, Tree] = {}
        self._open: list[str] = []

    def expression(self, text: object) -> Expr:
        """A formula in the symbols alone.

        Raises:
            FormulaError: where it cannot be read, or a definition in it.
            TableError: where it is no text, and for one that is too large.
        """
        found = Reader(self._symbols, {"sum": _written_out})(self._tree(text))
        if isinstance(found, tuple):
            raise TableError("must be one number, and is a vector or matrix")
        if terms(found) > MOST_TERMS:
            raise TableError(f"is too large: multiplied out it has more than {MOST_TERMS} terms")
        return found

    def _tree(self, text: object) -> Tree:
        if isinstance(text, bool) or not isinstance(text, int | float | str) or not str(text).strip():
            raise TableError(f'must be a formula in quotes, such as "r*cos(beta)"; given {shown(text)}')
        if len(str(text)) > MOST_CHARACTERS:
            raise TableError(f"must have at most {MOST_CHARACTERS} characters, given {len(str(text))}")
        tree = read_text(str(text), self._symbols.keys() | self._texts.keys())
        inner = {name: self._definition(name) for name in names(tree) & self._texts.keys() - self._symbols.keys()}
        whole = rebuild(tree, lambda node: inner.get(node.name, node) if isinstance(node, Name) else node)
        check_size(whole)
        magnitudes()(whole)
        return whole

    def _definition(self, name: str) -> Tree:
        if name in self._open:
            ring = " → ".join([*self._open[self._open.index(name) :], name])
            raise TableError(f"needs a definition that needs itself: {ring[:SHOWN]}")
        if len(self._open) > DEEPEST:
            raise TableError(f"needs definitions that need others, more than {DEEPEST} deep")
        if name not in self._trees:
            self._open.append(name)
            try:
                self._trees[name] = self._tree(self._texts[name])
            except FormulaError as error:
                raise FormulaError(f"let {name}: {error.message}", error.source, error.span) from None
            self._open.pop()
        return self._trees[name]


def _written_out(arguments: Sequence[Expression]) -> Expr:
    """The sum of a term over a few whole numbers.

    Raises:
        FormulaError: its ends are no whole numbers, or it is too large.
    """
    term, index, first, last = arguments
    if not isinstance(index, sp.Symbol):
        raise FormulaError(f"sum wants a symbol where {index} stands: a name that is defined is no symbol")
    if not (isinstance(first, sp.Integer) and isinstance(last, sp.Integer)):
        raise FormulaError("the sum of a model goes from one whole number to another: sum(x*j, j, 1, 5)")
    if isinstance(term, tuple):
        raise FormulaError("the sum of a model is that of numbers")
    count = max(int(last) - int(first) + 1, 0)
    if count * terms(term) > MOST_TERMS:
        raise FormulaError(f"the sum is too large: written out it has more than {MOST_TERMS} terms")
    return sp.Add(*(term.xreplace({index: first + sp.Integer(place)}) for place in range(count)))


def data_of(model: Model) -> dict[str, Any]:
    """A model as the data of a file, from which `read_models` makes the same model."""
    symbols = {symbol.name: _symbol_table(symbol) for symbol in (*model.arguments, *model.noise_symbols)}
    return {"symbols": symbols, "model": [_table_of(model)]}


def _symbol_table(symbol: Variable) -> dict[str, Any]:
    known = {"unit": str(symbol.unit), "low": symbol.low, "high": symbol.high, "meaning": symbol.meaning}
    return known | ({"whole": True} if symbol.whole else {})


def _table_of(model: Model) -> dict[str, Any]:
    source = {"author": model.source.author, "where": model.source.where, "doi": model.source.doi}
    year = {} if model.source.year is None else {"year": model.source.year}
    return {
        "name": model.name,
        "title": model.title,
        "measured": [symbol.name for symbol in model.measured],
        "parameters": [symbol.name for symbol in model.parameters],
        "outputs": {name: to_text(to_tree(value)) for name, value in model.outputs.items()},
        "units": {name: str(unit) for name, unit in zip(model.outputs, model.units, strict=True)},
        "deviations": {of.name: s.name for of, s in zip(model.measured, model.deviations, strict=False)},
        "correlations": {rho.name: [a.name, b.name] for (a, b), rho in model.correlations.items()},
        "source": source | year,
    }
