"""Drafts a claims file from a paper's equations, each found in the catalogue or left undecided."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from radartrack.derive.finding.formula_search import Candidate
from radartrack.derive.finding.paper_equations import Equation
from radartrack.derive.finding.paper_readings import Printed, Understood

NOTE = 600  # characters of what is quoted

_ID = re.compile(r"[^A-Za-z0-9_]+")


@dataclass(frozen=True)
class Drafted:
    """An equation and what was found of it.

    Attributes:
        understood: the equation.
        candidate: the quantity that it is.
        printed: the formula by the paper's own definitions, where it uses some.
        near: the quantity that it is but for a slip.
    """

    understood: Understood
    candidate: Candidate | None = None
    printed: Printed | None = None
    near: Candidate | None = None


def claims(paper: str, drafted: Sequence[Drafted]) -> str:
    """The text of a claims file."""
    used: set[str] = set()
    blocks = [f"paper = {_quoted(paper)}\n"]
    for place, one in enumerate(drafted, start=1):
        name = _identifier(one.understood.equation, place, used)
        blocks.append("[[claim]]\n" + "".join(f"{key} = {value}\n" for key, value in _fields(name, one)))
    return "\n".join(blocks)


def _fields(name: str, drafted: Drafted) -> Iterator[tuple[str, str]]:
    one, candidate, printed = drafted.understood, drafted.candidate, drafted.printed
    yield "id", _quoted(name)
    if candidate is not None:
        yield "quantity", _quoted(candidate.quantity)
        yield "formula", _quoted(printed.formula if printed else candidate.formula)
        if printed:
            yield "let", _table(printed.let)
        if candidate.given:
            yield "given", _table(candidate.given)
    else:
        yield "undecided", _quoted(_open_question(one, drafted.near)[:NOTE])
    if one.equation.number:
        yield "equation", _quoted(one.equation.number)
    yield "note", _quoted(" ".join(_remarks(one, candidate)))


def _open_question(one: Understood, near: Candidate | None) -> str:
    if near is not None:
        return f"it is near {near.quantity}: {near.slip}; perhaps meant: {near.formula}"
    is_none = "is no quantity of the catalogue"
    return one.reason or (f"it defines {one.name}, and {is_none}" if one.name else f"it {is_none}")


def _table(pairs: Mapping[str, str]) -> str:
    return "{ " + ", ".join(f"{name} = {_quoted(value)}" for name, value in pairs.items()) + " }"


def _remarks(one: Understood, candidate: Candidate | None) -> Iterator[str]:
    equation = one.equation
    yield f"{equation.left} = {equation.right}"[:NOTE] if equation.left else equation.right[:NOTE]
    if equation.label:
        yield f"(label {equation.label})"
    if candidate is not None and candidate.read:
        yield "(read with " + ", ".join(f"{letter} for {symbol}" for letter, symbol in candidate.read.items()) + ")"
    if candidate is not None and candidate.convention:
        yield f"({candidate.convention})"


def _identifier(equation: Equation, place: int, used: set[str]) -> str:
    """The label, or the number, as an identifier that no other claim has."""
    word = _ID.sub("_", equation.label or (f"eq{equation.number}" if equation.number else f"display{place}")).strip("_")
    name = word or f"display{place}"
    while name in used:
        name = f"{name}_{place}"
    used.add(name)
    return name


def _quoted(text: str) -> str:
    """A basic string of TOML, which is one of JSON but for a character."""
    return json.dumps("".join(sign if sign.isprintable() else " " for sign in text), ensure_ascii=False)
