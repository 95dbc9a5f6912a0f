"""The one door between the checker's page and the library: a request as JSON, answers as JSON, each with more in it.

A request says in `ask` what is asked, one of `ASKED`; the answers are objects. One with `error` says, for people, why
there is no other. What is asked comes from a page and from files that strangers hand over: it is data.
"""

from __future__ import annotations

import json
import tempfile
from collections.abc import Callable, Iterator, Mapping
from dataclasses import asdict
from functools import lru_cache
from pathlib import Path
from typing import Any

from radartrack._page.formula_found import found
from radartrack._page.typeset_record import typeset
from radartrack._page.values_at_point import values_at
from radartrack._reports import audit_page, audit_text
from radartrack.derive.catalogue import UnknownQuantity, catalogue
from radartrack.derive.checking.papers import audit
from radartrack.derive.checking.papers.claim import Claim, ClaimsError, UnreadableClaim
from radartrack.derive.checking.papers.claims_file import read_claims
from radartrack.derive.checking.papers.deadline import undecided
from radartrack.derive.checking.papers.mathml import block
from radartrack.derive.checking.question.compared_quantity import UnknownEntry
from radartrack.derive.checking.question.declared_world import world_of
from radartrack.derive.checking.question.world import CATALOGUE, World
from radartrack.derive.checking.reporting.barrier import reason
from radartrack.derive.finding.word_search import by_words
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.tree import names
from radartrack.derive.reading.any_letters import read_loosely
from radartrack.derive.reading.notation import TEXT
from radartrack.derive.reading.symbol_table import TableError
from radartrack.derive.verbs.no_closed_form import NoClosedForm

Request = Mapping[str, Any]
Answers = Iterator[dict[str, Any]]

SAID = (FormulaError, TableError, UnknownQuantity, UnknownEntry, UnreadableClaim, ClaimsError, NoClosedForm)
"""Errors whose words are for people."""


def answer(request: str, tell: Callable[[str], None]) -> None:
    """Answer one request.

    Args:
        request: an object as JSON.
        tell: takes each answer as JSON, the last with all that is known.
    """
    try:
        asked = json.loads(request)
        for one in ASKED[asked["ask"]](asked):
            tell(json.dumps(one, default=str))  # TOML has dates, which nothing asks for
    except SAID as error:
        tell(json.dumps({"error": str(error).removeprefix("claim 'formula': "), **_place(error)}))
    except Exception as error:  # noqa: BLE001 - a stranger's formula may find a fault anywhere
        tell(json.dumps({"error": f"This {reason(error)}."}))


def prepare() -> None:
    """Do once what every answer needs."""
    catalogue()


def _place(error: Exception) -> dict[str, Any]:
    """Where in the formula the fault is, for an error that knows it."""
    is_placed = isinstance(error, FormulaError) and error.span is not None
    return {"message": error.message, "span": error.span} if isinstance(error, FormulaError) and is_placed else {}


def _read(asked: Request) -> Answers:
    """A formula as it is read, whatever its letters mean."""
    formula = asked["formula"]
    tree = read_loosely(formula, (), asked.get("notation", TEXT), asked.get("function", ""))
    yield {"mathml": block(tree), "letters": sorted(names(tree))}


def _check(asked: Request) -> Answers:
    """The verdict on a formula, then the same with more beside it."""
    yield from _decided(claim_of(asked), CATALOGUE)


def claim_of(asked: Request) -> Claim:
    """What the page asks to be checked, as a claim."""
    formula, notation = asked["formula"], asked.get("notation", TEXT)
    written = {TEXT: "formula", "latex": "latex"}.get(notation, "code")
    language = {"language": notation} if written == "code" else {}
    return Claim(
        "formula",
        asked["quantity"],
        given=asked.get("given", {}),
        let=asked.get("let", {}),
        **{written: formula},
        **language,
    )


def _decide(asked: Request) -> Answers:
    """The verdict on a claim of a file, likewise; one that cannot be read is undecided, which is said."""
    claim = Claim(**asked["claim"])
    try:
        yield from _decided(claim, _world(json.dumps(asked.get("files", []))))
    except (UnreadableClaim, TableError) as error:
        yield typeset(claim, undecided(claim, str(error)), None) | {"unreadable": True}


@lru_cache(maxsize=2)
def _world(files: str) -> World:
    """What a file declares, for all its claims."""
    declared = json.loads(files)
    return world_of(declared) if declared else CATALOGUE


def _decided(claim: Claim, world: World) -> Answers:
    known: dict[str, Any] = {}
    try:
        for verdict in audit.decisions(claim, world):
            known = typeset(claim, audit.record(claim, verdict), verdict)
            yield known
    except SAID:
        raise
    except Exception as error:  # noqa: BLE001 - as in `answer`: what is known stays known
        yield known or typeset(claim, undecided(claim, f"this {reason(error)}"), None)


def _values(asked: Request) -> Answers:
    """Both sides at a point whose numbers the reader chose."""
    yield values_at(claim_of(asked), asked.get("point", {}), asked.get("entry", ()))


def _find(asked: Request) -> Answers:
    """Which quantities a formula is, one after the other as they are proved; then which it is near."""
    yield from found(read_loosely(asked["formula"], (), asked.get("notation", TEXT), asked.get("function", "")))


def _list(asked: Request) -> Answers:
    """The names of the quantities that words mean, the best first."""
    yield {"names": [quantity.name for quantity in by_words(asked["words"].split(), catalogue().values())]}


def _claims(asked: Request) -> Answers:
    """The claims of a file, and what it declares beside them."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "claims.toml"
        path.write_text(asked["text"], encoding="utf-8")
        try:
            file = read_claims(path, keep_unreadable=True)
        except ClaimsError as error:
            raise ClaimsError(str(error).replace(f"{path}: ", "")) from None
    yield {"paper": file.paper, "files": list(file.declared), "claims": [asdict(claim) for claim in file.claims]}


def _report(asked: Request) -> Answers:
    """The audit as a page of its own, and in one line."""
    records = [record for paper in asked["audits"] for record in paper["claims"]]
    yield {"html": audit_page.page(asked["audits"]), "summary": audit_text.summary(records)}


ASKED: Mapping[str, Callable[[Request], Answers]] = {
    "read": _read,
    "check": _check,
    "decide": _decide,
    "values": _values,
    "find": _find,
    "list": _list,
    "claims": _claims,
    "report": _report,
}
