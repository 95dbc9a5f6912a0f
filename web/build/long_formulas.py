"""Formulas too long for the formula book: entry by entry and without correlation, as far as a page takes them."""

from __future__ import annotations

from itertools import product

from radartrack.derive.catalogue import catalogue
from radartrack.derive.checking.question.compared_quantity import refer_to
from radartrack.derive.checking.question.printed_formula import conditions_for
from radartrack.derive.writing import quantity_text

LONGEST = 6000  # characters of LaTeX on a page


def long_formula(name: str) -> str:
    """The entries that are not equal, in Markdown; nothing where they are too long for a page."""
    quantity = catalogue()[name]
    independent = {one.name: "0" for one in quantity.symbols if one.name.endswith("rho")}
    conditions = conditions_for(refer_to(quantity), independent)
    places: dict[str, list[tuple[int, ...]]] = {}
    for place in product(*map(range, quantity.shape)):
        places.setdefault(quantity_text.latex(quantity, place, conditions), []).append(place)
        if sum(map(len, places)) > LONGEST:
            return ""
    lines = [f"{' = '.join(map(_bracket, where))} &= {latex}" for latex, where in places.items() if latex != "0"]
    body = " \\\\\n".join(lines)
    others = "" if "0" not in places else "\n\nThe other entries are 0."
    said = "Without correlation of the errors:\n\n" if independent else ""
    return f"{said}```math\n\\begin{{aligned}}\n{body}\n\\end{{aligned}}\n```{others}"


def _bracket(place: tuple[int, ...]) -> str:
    return f"[{','.join(map(str, place))}]"
