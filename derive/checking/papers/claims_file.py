"""Claims files: what a paper prints, and which derived quantity each of its formulas and numbers claims to be.

Everything in a file is data; formulas are read by `radartrack.derive.reading`, never evaluated as Python.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, TypeAlias

MAX_BYTES = 1_000_000
MAX_CLAIMS = 2_000
MAX_WHOLE = 10_000  # values of a range
ID = re.compile(r"[A-Za-z0-9_]+(?:[.-][A-Za-z0-9_]+)*")
NUMBER = re.compile(r"[+-]?\d{1,40}(?:\.\d{1,40})?(?:[eE][+-]?\d{1,2})?")
UNITS = ("1", "%", "m", "km", "m^2", "s", "m/s", "m/s^2", "rad", "deg", "mrad")
TRENDS = ("increasing", "decreasing", "convex", "concave")

Along: TypeAlias = "tuple[str, tuple[str, ...]]"


class ClaimsError(ValueError):
    """A claims file that cannot be used: it says file, claim, field and what is allowed."""


class UnreadableClaim(ValueError):
    """A claim names a quantity that there is not, or holds a formula that cannot be read."""


@dataclass(frozen=True)
class Claim:
    """One claim of a paper.

    Attributes:
        id: unique in its file, and stable.
        quantity: what the formula or number claims to be: a quantity, an entry, or an expression over several.
        formula: as typed.
        latex: the formula in LaTeX instead.
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
    """

    id: str
    quantity: str = ""
    formula: str = ""
    latex: str = ""
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

    @property
    def is_formula(self) -> bool:
        """Whether a formula is compared, not a number."""
        return bool(self.formula or self.latex)

    @property
    def printed(self) -> str:
        """What the paper says, in one line."""
        unit = f" {self.unit}" if self.unit not in {"", "1"} else ""
        bounds = (("at_most", "at most"), ("at_least", "at least"), ("crosses", "crosses"))
        said = [f"{words} {getattr(self, name)}" for name, words in bounds if getattr(self, name)]
        parts = [
            self.formula or self.latex,
            f"{self.value}{unit}" if self.value else "",
            f"at {self.maximum_over[0]} = {self.attained_at}" if self.attained_at and self.maximum_over else "",
            self.trend,
            *said,
        ]
        return " ".join(part for part in parts if part) or self.note

    @property
    def settings(self) -> str:
        """Where a number is meant, as short text."""
        return ", ".join(f"{name} = {value}" for name, value in self.at.items())


@dataclass(frozen=True)
class ClaimsFile:
    """A paper and its claims."""

    name: str
    paper: str
    claims: tuple[Claim, ...]


def read_claims(path: Path) -> ClaimsFile:
    """Read a claims file.

    Raises:
        ClaimsError: when it cannot be read, naming file, claim and field.
    """
    try:
        if path.stat().st_size > MAX_BYTES:
            raise ClaimsError(f"{path}: a claims file has at most {MAX_BYTES} bytes")
        data = tomllib.loads(path.read_bytes().decode("utf-8"))
    except OSError as error:
        raise ClaimsError(f"{path}: {error.strerror or error}") from None
    except (tomllib.TOMLDecodeError, UnicodeDecodeError, RecursionError) as error:
        raise ClaimsError(f"{path}: not TOML: {error}") from None
    return _file(data, str(path))


def shipped() -> list[Path]:
    """The claims files that come with the package, by name."""
    return sorted((Path(__file__).parents[2] / "claims").glob("*.toml"))


def _file(data: Mapping[str, Any], name: str) -> ClaimsFile:
    allowed = {"paper", "claim"}
    if unknown := sorted(data.keys() - allowed):
        raise ClaimsError(f"{name}: {unknown[0]} is no field of a claims file; allowed: paper, claim")
    if not isinstance(data.get("paper"), str) or not data["paper"].strip():
        raise ClaimsError(f"{name}: paper must be text: author, title, year")
    tables = data.get("claim")
    if not isinstance(tables, list) or not tables or not all(isinstance(table, dict) for table in tables):
        raise ClaimsError(f"{name}: claim must be one or more tables, each begun by [[claim]]")
    if len(tables) > MAX_CLAIMS:
        raise ClaimsError(f"{name}: at most {MAX_CLAIMS} claims are read, given {len(tables)}")
    claims = tuple(_claim(table, f"{name}: claim {number}") for number, table in enumerate(tables, start=1))
    _check_unique(claims, name)
    return ClaimsFile(name, data["paper"].strip(), claims)


def _check_unique(claims: tuple[Claim, ...], name: str) -> None:
    seen: set[str] = set()
    for claim in claims:
        if claim.id in seen:
            raise ClaimsError(f"{name}: claim {claim.id}: id occurs twice; every id must be unique")
        seen.add(claim.id)


def _claim(table: Mapping[str, Any], where: str) -> Claim:
    if isinstance(table.get("id"), str):
        where = f"{where.rpartition(' ')[0]} {table['id'][:80]!r}"
    if unknown := sorted(table.keys() - _FIELDS.keys()):
        raise ClaimsError(f"{where}: {unknown[0]} is no field of a claim; allowed: {', '.join(_FIELDS)}")
    if "id" not in table:
        raise ClaimsError(f"{where}: id is missing; every claim has one, such as smith.eq3")
    values = {name: _FIELDS[name](value, f"{where}: {name}") for name, value in table.items()}
    claim = Claim(**values)
    for problem in _problems(claim):
        raise ClaimsError(f"{where}: {problem}")
    return claim


def _problems(claim: Claim) -> Iterator[str]:
    """What does not fit together."""
    if claim.undecided:
        if claim.is_formula or claim.value:
            yield "undecided excludes formula, latex and value"
        return
    if not claim.quantity:
        yield "quantity is missing: a catalogue name, one entry of it, or an expression over several"
    kinds = _kinds(claim)
    if len(kinds) != 1:
        yield f"exactly one of {', '.join(_KINDS)} is needed, given {' and '.join(kinds) or 'none'}"
    yield from _misplaced(claim)


def _misplaced(claim: Claim) -> Iterator[str]:
    """Fields that need others, or belong to another kind of claim."""
    if claim.attained_at and not claim.maximum_over:
        yield "attained_at needs maximum_over"
    if (claim.trend or claim.crosses) and not claim.along:
        yield "along is missing: the symbol and its values, such as along = { k = [3, 20] }"
    if claim.crosses and claim.along and len(claim.along[1]) != 2:
        yield "along of a crossing has two values: before it and after it"
    if claim.significant is not None and not claim.value:
        yield "significant needs value"
    if claim.is_formula and (claim.at or claim.along or claim.maximum_over):
        yield "at, along and maximum_over belong to numbers; conditions on a formula are written as given"
    if not claim.is_formula and (claim.given or claim.let):
        yield "given and let belong to formulas; numbers have at"


_KINDS = ("formula", "latex", "value", "attained_at", "trend", "crosses", "at_most", "at_least", "undecided")


def _kinds(claim: Claim) -> list[str]:
    """What the claim is about; a value at its maximum is one thing."""
    found = [kind for kind in _KINDS if getattr(claim, kind)]
    return [kind for kind in found if not (kind == "attained_at" and claim.value)]


def _text(value: object, where: str) -> str:
    if not isinstance(value, str) or not value.strip():
        raise ClaimsError(f"{where} must be text, given {_shown(value)}")
    return value.strip()


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
    if isinstance(value, bool) or not isinstance(value, int | str):
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
    if all(isinstance(one, str) for one in values):
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
    "value": _number,
    "unit": _one_of(UNITS),
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
}
