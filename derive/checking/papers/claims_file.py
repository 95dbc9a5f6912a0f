"""Claims files: what a paper prints, and which derived quantity each of its formulas and numbers claims to be.

Everything in a file is data; formulas are read by `radartrack.derive.reading`, never evaluated as Python.
"""

from __future__ import annotations

import errno
import re
import tomllib
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, TypeAlias

from radartrack.derive.checking.comparing.printed_number import PrintedNumber
from radartrack.derive.code_languages import LANGUAGES
from radartrack.derive.reading.unit_text import BASE

MAX_BYTES = 1_000_000
MAX_CLAIMS = 2_000
MAX_WHOLE = 10_000  # values of a range
MOST_STEPS = 40  # of a chain
MAX_BITS = 133  # of a whole number: 40 digits, as in a formula
ID = re.compile(r"[A-Za-z0-9_]+(?:[.-][A-Za-z0-9_]+)*")
NUMBER = re.compile(r"[+-]?\d{1,40}(?:\.\d{1,40})?(?:[eE][+-]?\d{1,2})?")
WORD = re.compile(r"(?<![\w.])[A-Za-z_]\w*")
OF_NUMBERS = {"e", "pi", "sqrt"}  # words that a number may be written with
UNITS = tuple(BASE)
OF_UNIT = re.compile(r"[^\W\d_]+")
HIGHEST_ORDER = 12  # in the deviations
BOUND = re.compile(rf"(?P<number>{NUMBER.pattern})\s*(?P<unit>.*)")
DECLARED = ("paper", "doi", "symbols", "let", "given", "model", "define")  # what a file says for all its claims
ORIGIN = ("kind", "url", "commit", "seen")  # where a file has its claims from
KINDS = ("paper", "library")
TOLD = ("id", "equation", "page", "note", "file", "lines", "seen", "matters", "repair", "finding")
SHIPPED = Path(__file__).parents[2] / "claims"
WORLD = ("symbols", "let", "given", "model", "define")  # of these, what formulas can use
TRENDS = ("increasing", "decreasing", "convex", "concave")

Along: TypeAlias = "tuple[str, tuple[str, ...]]"


class ClaimsError(ValueError):
    """A claims file that cannot be used: it says file, claim, field and what is allowed."""


class UnreadableClaim(ValueError):
    """A claim has fields that do not fit, names a quantity that there is not, or holds an unreadable formula."""


@dataclass(frozen=True)
class Claim:
    """One claim of a paper.

    Attributes:
        id: unique in its file, and stable.
        quantity: what the formula or number claims to be: a quantity, an entry, or an expression over several.
        formula: as typed.
        latex: the formula in LaTeX instead.
        left: one side of an identity of the paper's own, without a quantity.
        right: the other side.
        chain: formulas of which each is said to equal the one before it.
        to_order: the order in the standard deviations up to which a formula is said to be right.
        limit: where symbols go, for a formula that is right in the limit.
        within: from where to where symbols lie.
        error_at_most: how much the formula differs at most there, as a number with a unit.
        code: the formula as code instead.
        language: of the code: python, c, cpp or matlab.
        function: of the code, the one that is meant.
        value: a printed number instead, with its digits; or the number at a maximum.
        unit: of the number; without one it is in SI units.
        significant: how many of its digits count, where the last ones are zeros that round.
        at: values of symbols, as formulas.
        given: conditions under which a formula is compared.
        let: the paper's own names.
        maximum_over: the number is the largest over whole numbers from and to.
        attained_at: where the maximum is.
        along: a symbol and the values that it takes, for a trend, a crossing or a bound.
        trend: how the quantity changes along them.
        crosses: a level that the quantity passes between the two values of `along`.
        at_most: a bound from above.
        at_least: a bound from below.
        undecided: why nothing that is derived can decide the claim.
        equation: number in print.
        page: in print.
        note: what a reader should know, such as what is illegible.
        file: in the sources of a library.
        lines: of that file.
        seen: where the formula was seen printed, or from where its form is known, if not as the others of the file.
        matters: of a claim that is wrong, what a radar would see of it.
        repair: of a claim that is wrong, what would be right, where nothing is suggested.
        finding: of a claim that is wrong, the page of `docs/findings` about it, without its ending.
        unreadable: what is wrong with the fields in a file; nothing else of the claim is known then.
    """

    id: str
    quantity: str = ""
    formula: str = ""
    latex: str = ""
    left: str = ""
    right: str = ""
    chain: tuple[str, ...] = ()
    to_order: int | None = None
    limit: Mapping[str, str] = field(default_factory=dict)
    within: Mapping[str, tuple[str, str]] = field(default_factory=dict)
    error_at_most: str = ""
    code: str = ""
    language: str = ""
    function: str = ""
    value: str = ""
    unit: str = ""
    significant: int | None = None
    at: Mapping[str, str] = field(default_factory=dict)
    given: Mapping[str, str] = field(default_factory=dict)
    let: Mapping[str, str] = field(default_factory=dict)
    maximum_over: Along | None = None
    attained_at: str = ""
    along: Along | None = None
    trend: str = ""
    crosses: str = ""
    at_most: str = ""
    at_least: str = ""
    undecided: str = ""
    equation: str = ""
    page: str = ""
    note: str = ""
    file: str = ""
    lines: str = ""
    seen: str = ""
    matters: str = ""
    repair: str = ""
    finding: str = ""
    unreadable: str = ""

    @property
    def is_formula(self) -> bool:
        """Whether formulas are compared, not numbers."""
        return bool(self.formula or self.latex or self.code or self.is_identity)

    @property
    def is_identity(self) -> bool:
        """Whether formulas are compared with each other, not with a quantity."""
        return bool(self.left or self.right or self.chain)

    @property
    def printed(self) -> str:
        """What the paper says, in one line."""
        bounds = (("at_most", "at most"), ("at_least", "at least"), ("crosses", "crosses"))
        said = [f"{words} {self._in_unit(getattr(self, name))}" for name, words in bounds if getattr(self, name)]
        parts = [
            self.formula or self.latex or self.code or self.right or " = ".join(self.chain),
            self._in_unit(self.value) if self.value else "",
            f"at {self.maximum_over[0]} = {self.attained_at}" if self.attained_at and self.maximum_over else "",
            self.trend,
            *said,
        ]
        return " ".join(part for part in parts if part) or self.note

    def _in_unit(self, number: str) -> str:
        """A number with the unit; a formula in symbols has its own."""
        has_unit = self.unit not in {"", "1"} and set(WORD.findall(number)) <= OF_NUMBERS
        return f"{number} {self.unit}" if has_unit else number

    @property
    def told(self) -> dict[str, Any]:
        """What a record tells of the claim beside the verdict."""
        return {name: getattr(self, name) for name in TOLD} | {"sense": self.sense, "at": dict(self.at)}

    @property
    def sense(self) -> str:
        """In which sense a formula is right, where it is not exactly: to an order, in a limit, nearly."""
        return ", ".join(
            [
                *([f"to order {self.to_order}"] if self.to_order is not None else []),
                *(f"where {name} goes to {value}" for name, value in self.limit.items()),
                *([f"to {self.error_at_most}"] if self.error_at_most else []),
            ]
        )

    @property
    def settings(self) -> str:
        """Where a number is meant, as short text."""
        return ", ".join(f"{name} = {value}" for name, value in self.at.items())


@dataclass(frozen=True)
class ClaimsFile:
    """A paper and its claims.

    Attributes:
        name: of the file.
        paper: author, title, year.
        claims: in their order.
        declared: what the file says beside claims, models and their symbols, as data; it is read with the first claim.
        kind: paper, or library of code.
        doi: of the paper, where there is one.
        url: of the library.
        commit: of its sources.
        seen: where the formulas were seen printed, or from where their form is known.
    """

    name: str
    paper: str
    claims: tuple[Claim, ...]
    declared: tuple[Mapping[str, Any], ...] = ()
    kind: str = "paper"
    doi: str = ""
    url: str = ""
    commit: str = ""
    seen: str = ""

    @property
    def told(self) -> dict[str, Any]:
        """What an audit tells of the file beside its claims."""
        return {"paper": self.paper, "file": self.name} | {name: getattr(self, name) for name in ("doi", *ORIGIN)}


def read_claims(path: Path, *, keep_unreadable: bool = False) -> ClaimsFile:
    """Read a claims file.

    Args:
        path: of the file, UTF-8.
        keep_unreadable: whether a claim whose fields do not fit stands among the others, marked as unreadable,
            instead of being an error of the whole file.

    Raises:
        ClaimsError: when it cannot be read, naming file, claim and field.
    """
    data = read_toml(path)
    try:
        return _file(data, str(path), keep_unreadable=keep_unreadable)
    except ClaimsError as error:
        raise ClaimsError(f"{path}: {error}") from None


def read_toml(path: Path) -> dict[str, Any]:
    """The data of a file, which nothing is known of yet.

    Raises:
        ClaimsError: when it cannot be read.
    """
    try:
        return tomllib.loads(_content(path).decode("utf-8-sig"))
    except OSError as error:
        raise ClaimsError(f"{path}: {error.strerror or error}") from None
    except (ValueError, RecursionError) as error:  # a whole number of 5000 digits is a ValueError
        raise ClaimsError(f"{path}: not TOML: {error}") from None


def declarations(data: Mapping[str, Any]) -> dict[str, Any]:
    """What a file says beside its claims.

    Raises:
        ClaimsError: naming a number with too many digits.
    """
    declared = {name: data[name] for name in DECLARED if name in data}
    for name, value in declared.items():
        if _is_huge(value):
            raise ClaimsError(f"{name}: a whole number has at most 40 digits")
    return declared


def _content(path: Path) -> bytes:
    """All of a file that is not too large, whatever its size is said to be."""
    with path.open("rb") as stream:
        content = stream.read(MAX_BYTES + 1)
    if len(content) > MAX_BYTES:
        raise OSError(errno.EFBIG, f"a claims file has at most {MAX_BYTES} bytes")
    return content


def shipped(name: str = "papers") -> list[Path]:
    """The claims files of this name that come with the package: of a folder, or a single one; none for no such name.

    The papers whose experiments are repeated stand alone, `literature` and `libraries` beside them.
    """
    if name == "papers":
        return sorted(SHIPPED.glob("*.toml"))
    return sorted(
        path for path in SHIPPED.rglob("*.toml") if name in {path.stem, *path.relative_to(SHIPPED).parts[:-1]}
    )


def shipped_names() -> list[str]:
    """The names that `shipped` knows: folders, then files."""
    folders = sorted(path.name for path in SHIPPED.iterdir() if path.is_dir())
    return ["papers", *folders, *sorted(path.stem for path in SHIPPED.rglob("*.toml"))]


def _file(data: Mapping[str, Any], name: str, *, keep_unreadable: bool) -> ClaimsFile:
    allowed = (*DECLARED, *ORIGIN, "claim")
    if unknown := sorted(data.keys() - set(allowed)):
        raise ClaimsError(f"{unknown[0][:80]} is no field of a claims file; allowed: {', '.join(allowed)}")
    if not isinstance(data.get("paper"), str) or not data["paper"].strip():
        raise ClaimsError("paper must be text: author, title, year")
    origin = {name: _ORIGIN[name](data[name], name) for name in _ORIGIN if name in data}
    tables = data.get("claim")
    if not isinstance(tables, list) or not tables or not all(isinstance(table, dict) for table in tables):
        raise ClaimsError("claim must be one or more tables, each begun by [[claim]]")
    if len(tables) > MAX_CLAIMS:
        raise ClaimsError(f"at most {MAX_CLAIMS} claims are read, given {len(tables)}")
    claims: dict[str, Claim] = {}
    for number, table in enumerate(tables, start=1):
        claim = _claim(table, number, claims, keep_unreadable=keep_unreadable)
        claims[claim.id] = claim
    declared = (declarations(data),) if data.keys() & set(WORLD) else ()
    return ClaimsFile(name, data["paper"].strip(), tuple(claims.values()), declared, **origin)


def _claim(table: Mapping[str, Any], number: int, before: Mapping[str, Claim], *, keep_unreadable: bool) -> Claim:
    """A claim, or what stands for one that cannot be read."""
    try:
        return _read_claim(table, f"claim {number}", before)
    except ClaimsError as error:
        if not keep_unreadable:
            raise
        return Claim(f"claim.{number}" if _name(table) in {None, *before} else str(table["id"]), unreadable=str(error))


def _read_claim(table: Mapping[str, Any], where: str, before: Mapping[str, Claim]) -> Claim:
    if isinstance(table.get("id"), str):
        where = f"claim {_shown(table['id'])}"
    if unknown := sorted(table.keys() - _FIELDS.keys()):
        raise ClaimsError(f"{where}: {unknown[0][:80]} is no field of a claim; allowed: {', '.join(_FIELDS)}")
    if "id" not in table:
        raise ClaimsError(f"{where}: id is missing; every claim has one, such as smith.eq3")
    for name, value in table.items():
        if _is_huge(value):
            raise ClaimsError(f"{where}: {name}: a whole number has at most 40 digits")
    claim = Claim(**{name: _FIELDS[name](value, f"{where}: {name}") for name, value in table.items()})
    if claim.id in before:
        raise ClaimsError(f"{where}: id occurs twice; every id must be unique")
    for problem in problems(claim):
        raise ClaimsError(f"{where}: {problem}")
    return claim


def _name(table: Mapping[str, Any]) -> str | None:
    name = table.get("id")
    return name if isinstance(name, str) and ID.fullmatch(name) else None


def _is_huge(value: object) -> bool:
    """Whether a whole number within has more digits than are read, and more than Python would print."""
    waiting = [value]
    while waiting:
        one = waiting.pop()
        if isinstance(one, int) and one.bit_length() > MAX_BITS:
            return True
        waiting.extend(one.values() if isinstance(one, dict) else one if isinstance(one, list) else ())
    return False


def problems(claim: Claim) -> Iterator[str]:
    """What does not fit together in a claim."""
    if claim.undecided:
        if claim.value:
            yield "undecided excludes value"
        return
    if claim.is_identity and claim.quantity:
        yield "left, right and chain need no quantity: they are compared with each other"
    if bool(claim.left) != bool(claim.right):
        yield "left and right belong together"
    if not claim.quantity and not claim.is_identity:
        yield "quantity is missing: a catalogue name, one entry of it, or an expression over several"
    kinds = _kinds(claim)
    if len(kinds) != 1:
        given = " and ".join(kinds) or "none, or an empty one"
        yield f"exactly one of {', '.join(_KINDS)} is needed, given {given}"
    yield from _misplaced(claim)
    yield from _misplaced_senses(claim)
    yield from _contradictory(claim)


def _misplaced(claim: Claim) -> Iterator[str]:
    """Fields that need others, or belong to another kind of claim."""
    if claim.attained_at and not claim.maximum_over:
        yield "attained_at needs maximum_over"
    if (claim.trend or claim.crosses) and not claim.along:
        yield "along is missing: the symbol and its values, such as along = { k = [3, 20] }"
    if claim.crosses and claim.along and len(claim.along[1]) != 2:
        yield "along of a crossing has two values: before it and after it"
    if claim.along and (claim.value or claim.attained_at):
        yield "along belongs to trend, crosses, at_most and at_least; a value has at"
    if bool(claim.code) != bool(claim.language) or (claim.function and not claim.code):
        yield f"code and language stand together; the languages are {', '.join(LANGUAGES)}"
    if claim.significant is not None and not claim.value:
        yield "significant needs value"
    if claim.is_formula and (claim.at or claim.along or claim.maximum_over):
        yield "at, along and maximum_over belong to numbers; conditions on a formula are written as given"
    if claim.is_formula and claim.unit:
        yield "unit belongs to numbers; a formula has the units of its symbols"
    if not claim.is_formula and (claim.given or claim.let):
        yield "given and let belong to formulas; numbers have at"


def _misplaced_senses(claim: Claim) -> Iterator[str]:
    """In which sense a formula is meant, where there is none."""
    if not claim.is_formula and (claim.to_order is not None or claim.limit or claim.within or claim.error_at_most):
        yield "to_order, limit, within and error_at_most belong to formulas"
    if claim.error_at_most and (claim.to_order is not None or claim.limit or claim.chain):
        yield "error_at_most excludes to_order, limit and chain"


def _contradictory(claim: Claim) -> Iterator[str]:
    """Fields that set one thing twice, or say how a number rounds against its digits."""
    symbols = [*claim.at, *(one[0] for one in (claim.along, claim.maximum_over) if one)]
    for symbol in dict.fromkeys(one for one in symbols if symbols.count(one) > 1):
        yield f"{symbol} is set twice: it has one value in at, or several in along or maximum_over"
    if claim.value and not PrintedNumber(claim.value, claim.significant).counts_whole:
        yield f"significant = {claim.significant} leaves digits of {claim.value} that are not zero"


_KINDS = (
    "formula", "latex", "code", "left", "chain", "value", "attained_at", "trend", "crosses", "at_most", "at_least",
    "undecided",
)  # fmt: skip


def _kinds(claim: Claim) -> list[str]:
    """What the claim is about; a value at its maximum is one thing."""
    found = [kind for kind in _KINDS if getattr(claim, kind)]
    return [kind for kind in found if not (kind == "attained_at" and claim.value)]


def _text(value: object, where: str) -> str:
    if not isinstance(value, str) or not value.strip():
        raise ClaimsError(f"{where} must be text, given {_shown(value)}")
    return value.strip()


def _code(value: object, where: str) -> str:
    _text(value, where)
    return str(value)  # with the spaces before its lines


def _id(value: object, where: str) -> str:
    if not isinstance(value, str) or not ID.fullmatch(value):
        raise ClaimsError(f"{where} must be letters, digits and _ with dots between, given {_shown(value)}")
    return value


def _number(value: object, where: str) -> str:
    if not isinstance(value, str) or not NUMBER.fullmatch(value):
        raise ClaimsError(f'{where} must be a number in quotes, as printed, such as "2.78"; given {_shown(value)}')
    return value


def _one_of(allowed: tuple[str, ...]) -> Callable[[object, str], str]:
    def read(value: object, where: str) -> str:
        if value not in allowed:
            raise ClaimsError(f"{where} must be one of {', '.join(allowed)}; given {_shown(value)}")
        return str(value)

    return read


def _unit(value: object, where: str) -> str:
    if not isinstance(value, str) or not value or set(OF_UNIT.findall(value)) - set(UNITS):
        raise ClaimsError(
            f"{where} must be one of {', '.join(UNITS)}, or a product of their powers such as m/s^2; "
            f"given {_shown(value)}"
        )
    return value


def _chain(value: object, where: str) -> tuple[str, ...]:
    if not isinstance(value, list) or not 2 <= len(value) <= MOST_STEPS:
        raise ClaimsError(f"{where} must be a list of 2 to {MOST_STEPS} formulas, given {_shown(value)}")
    return tuple(_text(one, where) for one in value)


def _order(value: object, where: str) -> int:
    if not isinstance(value, int) or isinstance(value, bool) or not 0 <= value <= HIGHEST_ORDER:
        raise ClaimsError(f"{where} must be a whole number from 0 to {HIGHEST_ORDER}, given {_shown(value)}")
    return value


def _within(value: object, where: str) -> dict[str, tuple[str, str]]:
    fits = (
        isinstance(value, dict) and value and all(isinstance(ends, list) and len(ends) == 2 for ends in value.values())
    )
    if not fits or not isinstance(value, dict):
        raise ClaimsError(
            f'{where} must be from where to where, such as {{ r = ["1e3", "1e5"] }}; given {_shown(value)}'
        )
    return {name: (_formula(low, where), _formula(high, where)) for name, (low, high) in value.items()}


def _bound(value: object, where: str) -> str:
    found = BOUND.fullmatch(value.strip()) if isinstance(value, str) else None
    if found is None:
        raise ClaimsError(f'{where} must be a number and a unit, such as "1 %" or "5 m"; given {_shown(value)}')
    if found["unit"]:
        _unit(found["unit"], where)
    return str(value).strip()


def _positive(value: object, where: str) -> int:
    if not isinstance(value, int) or isinstance(value, bool) or not 1 <= value <= 40:
        raise ClaimsError(f"{where} must be a whole number from 1 to 40, given {_shown(value)}")
    return value


def _page(value: object, where: str) -> str:
    if isinstance(value, bool) or not isinstance(value, int | str):
        raise ClaimsError(f"{where} must be a number or text, given {_shown(value)}")
    return str(value)


def _formulas(value: object, where: str) -> dict[str, str]:
    if not isinstance(value, dict) or not value:
        raise ClaimsError(f'{where} must be a table of formulas, such as {{ rho = "0" }}; given {_shown(value)}')
    return {name: _formula(one, f"{where}.{name}") for name, one in value.items()}


def _formula(value: object, where: str) -> str:
    if isinstance(value, bool) or not isinstance(value, int | str) or not str(value).strip():
        raise ClaimsError(
            f'{where} must be a whole number or a formula in quotes, such as "0.5"; given {_shown(value)}'
        )
    return str(value)


def _along(value: object, where: str) -> Along:
    if not isinstance(value, dict) or len(value) != 1:
        raise ClaimsError(f"{where} must name one symbol, such as {{ k = [3, 20] }}; given {_shown(value)}")
    ((symbol, values),) = value.items()
    if not isinstance(values, list) or not values:
        raise ClaimsError(f"{where}.{symbol} must be two whole numbers, from and to, or a list of formulas in quotes")
    if all(isinstance(one, str) and one.strip() for one in values):
        return symbol, tuple(values)
    whole = len(values) == 2 and all(isinstance(one, int) and not isinstance(one, bool) for one in values)
    if not whole or not 0 < values[1] - values[0] <= MAX_WHOLE:
        raise ClaimsError(f"{where}.{symbol} must be two whole numbers, from and to, or a list of formulas in quotes")
    return symbol, tuple(str(number) for number in range(values[0], values[1] + 1))


def _shown(value: object) -> str:
    text = repr(value)
    return text if len(text) <= 60 else f"{text[:57]}..."


_FIELDS: Mapping[str, Callable[[object, str], Any]] = {
    "id": _id,
    "quantity": _text,
    "formula": _text,
    "latex": _text,
    "left": _text,
    "right": _text,
    "chain": _chain,
    "to_order": _order,
    "limit": _formulas,
    "within": _within,
    "error_at_most": _bound,
    "code": _code,
    "language": _one_of(LANGUAGES),
    "function": _text,
    "value": _number,
    "unit": _unit,
    "significant": _positive,
    "at": _formulas,
    "given": _formulas,
    "let": _formulas,
    "maximum_over": _along,
    "attained_at": _formula,
    "along": _along,
    "trend": _one_of(TRENDS),
    "crosses": _text,
    "at_most": _text,
    "at_least": _text,
    "undecided": _text,
    "equation": _text,
    "page": _page,
    "note": _text,
    "file": _text,
    "lines": _text,
    "seen": _text,
    "matters": _text,
    "repair": _text,
    "finding": _id,
}
_ORIGIN: Mapping[str, Callable[[object, str], str]] = {
    "doi": _text,
    "kind": _one_of(KINDS),
    "url": _text,
    "commit": _text,
    "seen": _text,
}
