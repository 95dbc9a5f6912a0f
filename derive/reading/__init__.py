"""Reads printed formulas, typed, in LaTeX or as code, as data: nothing in them is ever evaluated as Python.

`read_formula` is the door for all notations; `read_text`, `read_latex` and `read_code` give a tree that keeps what was
printed. `to_text` and `to_latex` print it again, and `to_expression` makes algebra of it, for which alone SymPy is
loaded. What cannot be read, is ambiguous or too large raises `FormulaError`.
"""

from typing import TYPE_CHECKING, Any

from radartrack.derive.code_languages import LANGUAGES
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.fold import rebuild
from radartrack.derive.formula.printing import to_latex, to_text
from radartrack.derive.formula.shape import shape
from radartrack.derive.formula.tree import (
    Array,
    Call,
    Constant,
    Name,
    Negation,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Tree,
    children,
    names,
    replace_at,
    subtree,
    walk,
    with_children,
)
from radartrack.derive.reading.code.source_code import read_code
from radartrack.derive.reading.notation import NOTATIONS, Reading, read_formula
from radartrack.derive.reading.tex.latex import read_latex
from radartrack.derive.reading.text import read_text

if TYPE_CHECKING:
    from radartrack.derive.formula.to_expression import Expression, to_expression

__all__ = [
    "LANGUAGES",
    "NOTATIONS",
    "Array",
    "Call",
    "Constant",
    "Expression",
    "FormulaError",
    "Name",
    "Negation",
    "Number",
    "Power",
    "Product",
    "Quotient",
    "Reading",
    "Sum",
    "Tree",
    "children",
    "names",
    "read_code",
    "read_formula",
    "read_latex",
    "read_text",
    "rebuild",
    "replace_at",
    "shape",
    "subtree",
    "to_expression",
    "to_latex",
    "to_text",
    "walk",
    "with_children",
]


def __getattr__(name: str) -> Any:
    if name not in {"Expression", "to_expression"}:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from radartrack.derive.formula import to_expression as algebra  # noqa: PLC0415 - loads SymPy

    return getattr(algebra, name)
