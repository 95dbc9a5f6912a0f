"""Claims files: what a paper prints, and which derived quantity each of its formulas and numbers claims to be.

Everything in a file is data; formulas are read by `radartrack.derive.reading`, never evaluated as Python.
"""

from __future__ import annotations

import errno
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from radartrack.derive.checking.papers.claim import Claim, ClaimsError, problems
from radartrack.derive.checking.papers.claim_fields import FIELDS, ID, ORIGIN_FIELDS, shown

MAX_BYTES = 1_000_000
MAX_CLAIMS = 2_000
MAX_BITS = 133  # of a whole number: 40 digits, as in a formula
DECLARED = ("paper", "doi", "symbols", "let", "given", "model", "define")  # what a file says for all its claims
ORIGIN = ("kind", "url", "commit", "seen")  # where a file has its claims from
SHIPPED = Path(__file__).parents[2] / "claims"
WORLD = ("symbols", "let", "given", "model", "define")  # of these, what formulas can use


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
    origin = {name: ORIGIN_FIELDS[name](data[name], name) for name in ORIGIN_FIELDS if name in data}
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
        where = f"claim {shown(table['id'])}"
    if unknown := sorted(table.keys() - FIELDS.keys()):
        raise ClaimsError(f"{where}: {unknown[0][:80]} is no field of a claim; allowed: {', '.join(FIELDS)}")
    if "id" not in table:
        raise ClaimsError(f"{where}: id is missing; every claim has one, such as smith.eq3")
    for name, value in table.items():
        if _is_huge(value):
            raise ClaimsError(f"{where}: {name}: a whole number has at most 40 digits")
    claim = Claim(**{name: FIELDS[name](value, f"{where}: {name}") for name, value in table.items()})
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
