"""A verdict as the page shows it: in words, typeset, and what a click on a suggestion would make of the formula."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from typing import Any

from radartrack._reports import audit_text
from radartrack.derive.checking.papers import mathml
from radartrack.derive.checking.papers.claim import Claim
from radartrack.derive.checking.reporting.barrier import attempted
from radartrack.derive.checking.reporting.verdict import Verdict
from radartrack.derive.formula.printing import to_latex, to_text
from radartrack.derive.formula.tree import Tree, replace_at

SHOWN_OTHERWISE = {"for example", "at worst", "perhaps meant"}  # with numbers to change, and typeset


def typeset(claim: Claim, record: Mapping[str, Any], verdict: Verdict | None) -> dict[str, Any]:
    """A record with the words of its verdict and its formulas as MathML.

    Args:
        claim: what is decided.
        record: of it.
        verdict: the same; None where there is none.
    """
    headline, rest = audit_text.headline(record)
    said = [pair for pair in audit_text.explanation(record) if pair[0] not in SHOWN_OTHERWISE]
    worst = [text for heading, text in audit_text.explanation(record) if heading == "at worst"]
    shown = attempted(lambda: mathml.formulas(claim, verdict), lambda _: {}) if verdict is not None else {}
    return {
        **record,
        **shown,
        "headline": headline,
        "rest": rest,
        "said": said,
        "at_worst": worst[0] if worst else "",
        "suggestions": [
            {**one, "applied": attempted(partial(applied, record, one), lambda _: {})} for one in record["suggestions"]
        ],
    }


def applied(record: Mapping[str, Any], suggestion: Mapping[str, Any]) -> dict[str, Any]:
    """What a suggestion makes of what was asked: another formula, another definition, or another quantity.

    Nothing, where it cannot be put into the formula.
    """
    formula = suggestion["formula"]
    if suggestion["definition"]:
        return {"let": {suggestion["definition"]: formula.partition(" = ")[2]}}
    if suggestion["edit"].startswith("this is "):
        return {"quantity": formula}
    tree = mathml.tree_of(formula)
    if tree is None:
        return {}
    if suggestion["entry"]:
        whole = mathml.tree_of(record["printed"])
        if whole is None:
            return {}
        tree = replace_at(whole, tuple(suggestion["entry"]), tree)
    return _written(tree)


def _written(tree: Tree) -> dict[str, Any]:
    return {"text": to_text(tree), "latex": to_latex(tree)}
