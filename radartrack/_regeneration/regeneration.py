"""Derives everything, writes the generated modules with their measured accuracy, and compares them with the disk."""

from __future__ import annotations

import difflib
import errno
import importlib.metadata
import importlib.util
import json
import math
import os
import tempfile
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from functools import partial
from multiprocessing import get_context
from pathlib import Path
from types import ModuleType
from typing import Any, NamedTuple

import numpy as np

from radartrack._regeneration.single_precision import error_in_single
from radartrack._system import written_files
from radartrack._system.deriving_process import prepare
from radartrack._system.directory_swap import replace_directory, replace_file
from radartrack._system.worker_processes import Workers, ended_on_failure
from radartrack._system.written_files import Owners
from radartrack.derive.catalogue import catalogue
from radartrack.derive.finding import screening_values
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.stable_form import NotProved
from radartrack.derive.stable.quantity_form import form_of
from radartrack.derive.writing import elementary_functions
from radartrack.derive.writing.conversion_functions import (
    ARRAYS,
    LOOPS,
    ConversionCode,
    conversion_code,
    conversions_of,
    covariance_of,
)
from radartrack.derive.writing.conversion_functions import module_text as conversion_code_text
from radartrack.derive.writing.formula_book import Page, book, formula
from radartrack.derive.writing.numpy_writer import Function, body, module_text
from radartrack.verification.domain_points import sample
from radartrack.verification.error_in_ulp import errors
from radartrack.verification.rounding.certificates import code_of, proved_bounds
from radartrack.verification.rounding.certificates import kept as kept_certificates

RECORD = "accuracy.json"
CHUNK = 20  # neighbours in the catalogue share what they are derived from
POINTS = 500
PACKAGE = '"""NumPy functions written from the derivations; see the docstring of each for source and accuracy."""\n'

PROVED_FOR = {
    "double": ", proved for elementary functions within 1 ulp (float64)",
    "independent": " with independent errors, proved for elementary functions within 1 ulp (float64)",
    "correlated": "with correlations up to 0.99 in size",
    "single": "in float32, with functions within 4 of its ulp,",
}
BOOK = "formulas.md"
SCREENING = "screening.json"
Files = dict[str, str]
Written = tuple[str, str, dict[str, Any]]  # statements, formula, and values to screen formulas by
Task = str | tuple[str, str]  # a quantity's name, or model and method of a conversion
Step = Callable[[str], None]


class Writer(NamedTuple):
    """How a language writes one quantity, and one conversion by model and method."""

    quantity: Callable[[Quantity], Any]
    conversion: Callable[[Mapping[str, Quantity], str, str], Any]


@dataclass(frozen=True)
class Accuracy:
    """What was measured of one function.

    Attributes:
        code: the digest of its code.
        ulp: the largest error in double precision.
        single: that in single precision, in ulp of that.
        single_points: at how many points that was: where nothing leaves the range of single precision.
        proved: bounds that certificates prove, in ulp, by what they are for, a key of `PROVED_FOR`.
    """

    code: str
    ulp: float
    single: float = math.nan
    single_points: int | None = None
    proved: Mapping[str, float] = field(default_factory=dict)

    @property
    def is_complete(self) -> bool:
        """Whether nothing is left to be measured."""
        return not math.isnan(self.ulp) and self.single_points is not None

    @property
    def sentence(self) -> str:
        """For the docstring: what is proved, else what was measured."""
        if not self.proved:
            return f"measured, not proved: {self.measured}" if not math.isnan(self.ulp) else self.measured
        said = [
            f"at most {bound:g} ulp anywhere in this domain{PROVED_FOR[kind]}"
            if kind in {"double", "independent"}
            else f"{PROVED_FOR[kind]} at most {bound:g}"
            for kind, bound in self.proved.items()
        ]
        return f"{'; '.join(said)}."

    @property
    def measured(self) -> str:
        """The error at points."""
        if math.isnan(self.ulp):
            return "not measured."
        return (
            f"at most {self.ulp:g} ulp from 50-digit arithmetic at {POINTS} points of this domain "
            "(float64, independent errors)."
        )

    @property
    def in_double(self) -> str:
        """For the comment in C."""
        return f"Accuracy in double: {self.measured.replace('float64', 'double, by the same statements in NumPy')}"

    @property
    def in_single(self) -> str:
        """For the comment in C."""
        if self.single_points is None:
            return "Accuracy in float: not measured."
        if not self.single_points:
            return "Accuracy in float: none; everywhere in this domain something leaves the range of float."
        where = "these points" if self.single_points >= POINTS else f"the {self.single_points} of these points"
        outside = "" if self.single_points >= POINTS else " at which nothing leaves the range of float"
        return f"Accuracy in float: at most {self.single:g} ulp of float at {where}{outside}."


Record = dict[str, Accuracy]  # by quantity


@dataclass(frozen=True)
class Derived:
    """A quantity as code, as a formula to read, and as values."""

    function: Function
    formula: str
    values: Mapping[str, Any]


@dataclass(frozen=True)
class Derivation:
    """All that is written: the quantities, and the conversions that join some of them."""

    quantities: list[Derived]
    conversions: list[ConversionCode]

    @property
    def functions(self) -> list[Function]:
        """Those of the quantities."""
        return [derived.function for derived in self.quantities]


def source_directory() -> Path | None:
    """`generated/` of the source checkout that this package is imported from; None for an installed wheel."""
    folder = _package()
    return folder if _is_of_checkout(folder) else None


def _package() -> Path:
    """Where `radartrack.generated` is imported from."""
    here = importlib.util.find_spec("radartrack.generated")
    places = list(here.submodule_search_locations or ()) if here else []
    return Path(places[0]) if places else Path(__file__).with_name("generated")


def _is_of_checkout(folder: Path) -> bool:
    """Whether it is the one of this package, with its project around it; a user's own folder may be called the same."""
    package = Path(os.path.realpath(_package()))
    of_checkout = package.name == "generated" and (package.parent / "pyproject.toml").exists()
    return of_checkout and Path(os.path.realpath(folder)) == package


def place(directory: Path, name: str) -> Path:
    """Where a file stands: with the modules, and in a checkout the formula book among the documents."""
    return directory.parent / "docs" / name if name == BOOK and _is_of_checkout(directory) else directory / name


def owners(directory: Path) -> Owners:
    """Whose the files of a directory are; those that come with the package are ours wherever they are found."""
    return written_files.owners(directory, written_files.read_record(_package()))


def may_be_written(directory: Path) -> bool:
    """Whether a directory is for generated code: by the record in it, or because it holds nothing else."""
    found = owners(directory)
    return found.recorded or not found.others or _is_of_checkout(directory)


class NotDerived(ValueError):
    """A quantity has no code: what it holds cannot be rewritten, proved, written or measured."""


def _on_one_line(said: object) -> str:
    """Text of a stranger's, without what a terminal would obey."""
    return "".join(c if c.isprintable() else " " for c in " ".join(str(said).split()))


def derive(quantities: Mapping[str, Quantity], step: Step) -> Derivation:
    """The code and formula of all quantities, and their conversions; `step` is told each name as its turn comes."""
    done = worked_out(quantities, step, Writer(written, conversion_code))
    derived = []
    for name, quantity in quantities.items():
        statements, typeset, values = done[name]
        derived.append(Derived(Function(quantity, statements), typeset, values))
    return Derivation(derived, [code for code in done.values() if isinstance(code, ConversionCode)])


def worked_out(quantities: Mapping[str, Quantity], step: Step, writer: Writer) -> dict[Task, Any]:
    """What is written of each quantity and conversion.

    Those of the catalogue are derived in one process a core, a model of a user's own in this one.
    """
    tasks = _tasks(quantities)
    if quantities == catalogue():
        with ended_on_failure(Workers(mp_context=get_context("spawn"), initializer=prepare)) as pool:
            return _told(tasks, pool.map(partial(_of_catalogue, writer=writer), tasks, chunksize=CHUNK), step)
    return _told(tasks, (_done_or_refused(task, quantities, writer) for task in tasks), step)


def _tasks(quantities: Mapping[str, Quantity]) -> list[Task]:
    """Names of quantities, and each conversion behind the covariance that it shares most with."""
    tasks: list[Task] = list(quantities)
    for conversion in reversed(conversions_of(quantities)):
        tasks.insert(tasks.index(covariance_of(quantities, *conversion)) + 1, conversion)
    return tasks


def _of_catalogue(task: Task, writer: Writer) -> Any:
    return _done(task, catalogue(), writer)


def _done(task: Task, quantities: Mapping[str, Quantity], writer: Writer) -> Any:
    return writer.quantity(quantities[task]) if isinstance(task, str) else writer.conversion(quantities, *task)


def _done_or_refused(task: Task, quantities: Mapping[str, Quantity], writer: Writer) -> Any:
    """The code of one task of a model of a user's own.

    Raises:
        NotDerived: saying of which quantity, and why.
        NotProved: a rewritten form is not proved equal to its definition.
    """
    with _refusing(task if isinstance(task, str) else ".".join(task)):
        return _done(task, quantities, writer)


@contextmanager
def _refusing(name: str) -> Iterator[None]:
    """What goes wrong with a formula of a user's own, said of the quantity."""
    try:
        yield
    except NotProved:
        raise
    except (ArithmeticError, AssertionError, LookupError, RecursionError, TypeError, ValueError) as error:
        raise NotDerived(f"{name} cannot be derived: {_on_one_line(error)}") from error


def _told(tasks: Sequence[Task], done: Iterable[Any], step: Step) -> dict[Task, Any]:
    found = {}
    for task, result in zip(tasks, done, strict=True):
        if isinstance(task, str):
            step(task)
        found[task] = result
    return found


def written(quantity: Quantity) -> Written:
    """The statements, the typeset formula and the values of one quantity."""
    form = form_of(quantity)
    values = screening_values.row(quantity) if catalogue().get(quantity.name) is quantity else {}
    return body(quantity, form), formula(quantity, form), values


def read_record(directory: Path) -> Record:
    """The accuracy measured before, by quantity; empty where there is none or it cannot be read."""
    try:
        stored = json.loads((directory / RECORD).read_bytes())
        return {name: _accuracy(row) for name, row in stored.items()}
    except (OSError, ValueError, TypeError, KeyError, AttributeError):
        return {}


def _accuracy(row: Mapping[str, Any]) -> Accuracy:
    single = row.get("single")
    known = Accuracy(str(row["code"]), float(row["ulp"]))
    if single is None:
        return known
    return replace(
        known, single=math.nan if single["ulp"] is None else float(single["ulp"]), single_points=int(single["points"])
    )


def read_records(directory: Path, quantities: Mapping[str, Quantity]) -> list[Record]:
    """What is known of quantities: the record in the directory and, for the catalogue, the one in the package."""
    known = catalogue()
    shipped = read_record(_package())
    same = {name: shipped[name] for name in quantities.keys() & shipped if quantities[name] is known.get(name)}
    return [read_record(directory), same]


def as_recorded(functions: Iterable[Function], records: Sequence[Record]) -> Record:
    """The accuracy of each function from the first record that knows its very code; else it is NaN, not measured."""
    return {function.quantity.name: _recorded(function, records) for function in functions}


def _recorded(function: Function, records: Sequence[Record]) -> Accuracy:
    known = (record.get(function.quantity.name) for record in records)
    fitting = (accuracy for accuracy in known if accuracy is not None and accuracy.code == function.digest)
    return next(fitting, Accuracy(function.digest, math.nan))


def with_measured(functions: Iterable[Function], known: Sequence[Record], step: Step) -> Record:
    """The same with the missing measurements made.

    Raises:
        NotDerived: the formula cannot be evaluated over its domain.
    """
    by_name = {function.quantity.name: function for function in functions}
    record = as_recorded(by_name.values(), known)
    missing = [by_name[name] for name, accuracy in record.items() if not accuracy.is_complete]
    with tempfile.TemporaryDirectory() as folder:
        modules = _load(_modules(missing, record), Path(folder))
        for function in missing:
            quantity = function.quantity
            step(f"{quantity.name}: measuring")
            try:
                record[quantity.name] = measured(modules[quantity.module], function, record[quantity.name])
            except (ArithmeticError, TypeError, ValueError) as error:
                raise NotDerived(f"{quantity.name} cannot be measured: {_on_one_line(error)}") from error
    return record


def measured(module: ModuleType, function: Function, known: Accuracy) -> Accuracy:
    """What is known of a function with what is missing."""
    quantity = function.quantity
    ulp = measure(module, quantity) if math.isnan(known.ulp) else known.ulp
    single, points = error_in_single(getattr(module, quantity.function), quantity, sample(quantity, POINTS))
    everywhere = points if quantity.symbols else POINTS * points
    return Accuracy(function.digest, ulp, _rounded_up(single) if points else math.nan, everywhere)


def measure(module: ModuleType, quantity: Quantity) -> float:
    """The largest error over random points, rounded up to half an ulp."""
    with np.errstate(all="ignore"):  # what overflows is an infinite error
        found = errors(getattr(module, quantity.function), quantity, sample(quantity, POINTS)).max()
    return _rounded_up(found)


def _rounded_up(ulp: float) -> float:
    """To half an ulp; what is no number is infinitely wrong."""
    return math.ceil(2 * ulp) / 2 if math.isfinite(ulp) else math.inf


def texts(derivation: Derivation, record: Record) -> Files:
    """The files of the generated package, the formula book, of the catalogue its values, and the record of them all."""
    proved = with_proofs(derivation.functions, record)
    pages = [
        Page(derived.function.quantity, derived.formula, proved[derived.function.quantity.name].sentence)
        for derived in derivation.quantities
    ]
    files = {
        "__init__.py": PACKAGE,
        "py.typed": "",
        RECORD: record_text(record),
        BOOK: book(pages),
        **_modules(derivation.functions, proved),
    }
    if record.keys() == catalogue().keys():
        files[SCREENING] = _screening(derivation.quantities)
    if derivation.conversions:
        files["conversions.py"] = conversion_code_text(derivation.conversions, ARRAYS)
        files["loops.py"] = conversion_code_text(derivation.conversions, LOOPS)
    if SCREENING in files:
        files[elementary_functions.NAME] = elementary_functions.module_text()
    return files | {written_files.RECORD: written_files.record(files)}


def with_proofs(functions: Iterable[Function], record: Record) -> Record:
    """The same with the bounds that certificates of the package prove of the very code, over the very domain."""
    rows, known = kept_certificates(), catalogue()
    found = dict(record)
    for function in functions:
        name, row = function.quantity.name, rows.get(function.quantity.name, {})
        if known.get(name) is function.quantity and row.get("code") == code_of(
            function.text(""), function.quantity.function
        ):
            found[name] = replace(record[name], proved=_said(function.quantity, proved_bounds(row)))
    return found


def _said(quantity: Quantity, bounds: Mapping[str, float]) -> Mapping[str, float]:
    """The bounds of a docstring: none without one in double precision, which is not all where errors correlate."""
    if "double" not in bounds or not any(symbol.is_correlation for symbol in quantity.symbols):
        return bounds if "double" in bounds else {}
    return {"independent": bounds["double"]} | {kind: bound for kind, bound in bounds.items() if kind != "double"}


def record_text(record: Record) -> str:
    """The file of what was measured."""
    rows = {name: _row(accuracy) for name, accuracy in sorted(record.items())}
    return json.dumps(rows, indent=1) + "\n"


def _row(accuracy: Accuracy) -> dict[str, Any]:
    row: dict[str, Any] = {"code": accuracy.code, "ulp": accuracy.ulp}
    if accuracy.single_points is not None:
        ulp = None if math.isnan(accuracy.single) else accuracy.single
        row["single"] = {"ulp": ulp, "points": accuracy.single_points}
    return row


def own_version() -> str:
    """Of the installed package."""
    try:
        return importlib.metadata.version("radartrack")
    except importlib.metadata.PackageNotFoundError:
        return "0"


def _screening(quantities: Iterable[Derived]) -> str:
    """The values of all quantities, a line each."""
    rows = [f"{json.dumps(one.function.quantity.name)}: {json.dumps(one.values)}" for one in quantities]
    return "{\n" + ",\n".join(rows) + "\n}\n"


def differences(directory: Path, expected: Files) -> Iterator[str]:
    """What stands on disk against what the derivations give, file by file, as unified diffs."""
    for orphan in orphans(directory, expected):
        yield f"{orphan}: no derivation owns this file\n"
    for name, text in sorted(expected.items()):
        path = place(directory, name)
        yield _difference(path, text) if path.exists() else f"{name}: missing\n"


def orphans(directory: Path, expected: Files) -> list[str]:
    """The names of what was written to the directory and no derivation owns any more; not what was edited since."""
    return sorted(owners(directory).ours - expected.keys())


def names(quantities: Mapping[str, Quantity]) -> set[str]:
    """Of the files that are written for quantities; as in `texts`, before anything is derived."""
    conversions = {"conversions.py", "loops.py"} if conversions_of(quantities) else set()
    modules = {f"{quantity.module}.py" for quantity in quantities.values()}
    of_catalogue = {SCREENING, elementary_functions.NAME} if quantities.keys() == catalogue().keys() else set()
    return {"__init__.py", "py.typed", RECORD, BOOK, written_files.RECORD} | modules | conversions | of_catalogue


def in_the_way(directory: Path, wanted: Collection[str]) -> list[str]:
    """The names that are to be written and are somebody else's."""
    return [] if _is_of_checkout(directory) else sorted(owners(directory).others.intersection(wanted))


def kept(directory: Path, files: Files) -> list[str]:
    """The names of what is not ours, or not any more, and stays where it is."""
    found = owners(directory)
    return sorted((found.others | found.edited) - files.keys())


def edited(directory: Path, files: Files) -> list[str]:
    """The names of what was edited since it was written, and is written anew; a checkout keeps a history of its own."""
    return [] if _is_of_checkout(directory) else sorted(owners(directory).edited & files.keys())


def write(directory: Path, files: Files) -> Path | None:
    """Replace the directory in one step: whoever looks sees the old set or the new one, and what is kept in both.

    Returns:
        Where what was edited is kept; None when nothing was.

    Raises:
        OSError: naming the directory or file, when it cannot be written or is somebody else's; all is then as before.
    """
    if others := in_the_way(directory, files):
        raise FileExistsError(errno.EEXIST, "this was not written by this command", str(directory / others[0]))
    changed = edited(directory, files)
    beside = {name: place(directory, name) for name in files if place(directory, name).parent == directory}
    stay = kept(directory, files) + [name for name in (written_files.CACHE,) if (directory / name).is_dir()]

    def fill(folder: Path) -> None:
        for name in beside:
            (folder / name).write_bytes(files[name].encode())
        written_files.keep(directory, stay, folder)

    try:
        directory.parent.mkdir(parents=True, exist_ok=True)
        aside = written_files.keep_beside(directory, changed) if changed else None
        replace_directory(directory, fill)
        for name in files.keys() - beside.keys():
            replace_file(place(directory, name), files[name])
    except OSError as error:
        raise type(error)(error.errno, error.strerror, error.filename or str(directory)) from None
    return aside


def _difference(path: Path, expected: str) -> str:
    try:
        found = path.read_bytes().decode()
    except (OSError, UnicodeDecodeError) as error:
        return f"{path.name}: cannot be read ({error})\n"
    lines = difflib.unified_diff(
        found.splitlines(keepends=True), expected.splitlines(keepends=True), f"{path.name} on disk", "as derived"
    )
    shown = "".join(line if line.endswith("\n") else f"{line}\n" for line in lines)
    return shown or ("" if found == expected else f"{path.name}: line endings differ\n")


def _modules(functions: Iterable[Function], record: Record) -> Files:
    by_module: dict[str, list[Function]] = {}
    for function in functions:
        by_module.setdefault(function.quantity.module, []).append(function)
    sentences = {name: accuracy.sentence for name, accuracy in record.items()}
    return {f"{name}.py": module_text(_title(name), group, sentences) for name, group in by_module.items()}


def _title(module: str) -> str:
    return f"NumPy functions of the quantities {module}.*"


def _load(files: Files, folder: Path) -> dict[str, ModuleType]:
    modules: dict[str, ModuleType] = {}
    for name, text in files.items():
        path = folder / name
        path.write_bytes(text.encode())
        spec = importlib.util.spec_from_file_location(f"_measured_{path.stem}", path)
        modules[path.stem] = _executed(spec)
    return modules


def _executed(spec: Any) -> ModuleType:
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module
