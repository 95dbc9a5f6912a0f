"""What is printed and what was derived at a point whose numbers a reader chose."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import Any

from radartrack.derive.checking.answers import Question
from radartrack.derive.checking.asking import ask
from radartrack.derive.checking.comparing.numerical_comparison import is_real
from radartrack.derive.checking.papers.claim import Claim
from radartrack.derive.checking.papers.mathml import element
from radartrack.derive.evaluation.many_digits import Evaluator, Number
from radartrack.derive.formula.tree import Name
from radartrack.derive.language.tensor import Index, Tensor

Named = tuple[tuple[str, str], ...]


def values_at(claim: Claim, point: Mapping[str, float], entry: Sequence[int] = ()) -> dict[str, Any]:
    """Both values, and the symbols that the numbers are of.

    Args:
        claim: that a formula is a quantity.
        point: numbers for the symbols, in SI units; those that are missing are taken from a round point.
        entry: which entry is compared.

    Raises:
        FormulaError, UnknownQuantity, UnknownEntry: when it cannot be read.
    """
    question = _question(
        claim.quantity,
        claim.formula or claim.latex or claim.code,
        bool(claim.latex),
        claim.language,
        tuple(claim.given.items()),
        tuple(claim.let.items()),
    )
    index = _index(question, entry)
    usual = next(question.domain.round(), None) or next(question.domain.ordinary(1), {})
    chosen = {symbol.name: float(point.get(symbol.name, usual.get(symbol.name, 1.0))) for symbol in question.symbols}
    printed, derived = _evaluated(question, index, chosen)
    return {
        "entry": index,
        "symbols": [
            {
                "name": symbol.name,
                "mathml": f"<math>{element(Name(symbol.name))}</math>",
                "meaning": symbol.meaning,
                "unit": str(symbol.unit),
                "value": chosen[symbol.name],
                "low": symbol.low,
                "high": symbol.high,
            }
            for symbol in question.symbols
        ],
        "printed": printed,
        "derived": derived,
        "relative_difference": _relative(printed, derived),
    }


@lru_cache(maxsize=8)
def _question(quantity: str, formula: str, latex: bool, code: str, given: Named, let: Named) -> Question:  # noqa: FBT001
    return ask(quantity, formula, latex=latex, code=code, given=dict(given), let=dict(let))


def _index(question: Question, entry: Sequence[int]) -> Index:
    """The entry that is meant, if there is one of this place; else the first."""
    places = [index for index, _ in question.printed.entries.items()]
    return tuple(entry) if tuple(entry) in places else places[0]


def _evaluated(question: Question, entry: Index, point: Mapping[str, float]) -> tuple[float | None, float | None]:
    """The values; none for what has no real one there."""
    pair = question.printed_entry(entry), question.derived_entry(entry)
    numbers = [point[symbol.name] for symbol in question.symbols]
    printed, derived = (_value(Evaluator(Tensor((1,), (one,)), question.symbols), numbers) for one in pair)
    return printed, derived


def _value(evaluator: Evaluator, numbers: Sequence[float]) -> float | None:
    try:
        value: Number = evaluator(numbers).entries[0]
    except (ArithmeticError, ValueError):
        return None
    number = float(value) if is_real(value) else math.nan
    return number if math.isfinite(number) else None


def _relative(printed: float | None, derived: float | None) -> float | None:
    if printed is None or derived is None:
        return None
    scale = abs(derived) or abs(printed)
    return abs(printed - derived) / scale if scale else 0.0
