"""Writes trees in the dialects of LaTeX and in the languages that people use: for tests, which read them back."""

from collections.abc import Callable
from dataclasses import dataclass

from radartrack.derive.formula.latex_names import GREEK
from radartrack.derive.reading import (
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
)

GREEK_NAMES = set(GREEK.values())
LATEX_CALLS = {"acos": r"\arccos", "asin": r"\arcsin", "atan": r"\arctan", "log": r"\ln"}


def letter(word: str) -> str:
    if word.endswith("dot") and len(word) > 3:
        return rf"\dot{{{letter(word[:-3])}}}"
    return f"\\{word}" if word in GREEK_NAMES else word if len(word) == 1 else rf"\mathrm{{{word}}}"


def symbol(name: str) -> str:
    """A name as papers print it."""
    base, *below = name.split("_")
    if not below:
        return letter(base)
    return f"{letter(base)}_{{{','.join(map(letter, below))}}}"


@dataclass(frozen=True)
class Dialect:
    """What differs between authors."""

    name: Callable[[str], str]
    fraction: Callable[[str, str], str]
    power: Callable[[str, str], str]
    function: Callable[[str, str, str], str]
    around: Callable[[str], str]
    brackets: tuple[str, str]
    root: Callable[[str], str] = lambda inside: rf"\sqrt{{{inside}}}"

    def formula(self, tree: Tree) -> str:
        return self.around(self.show(tree))

    def show(self, tree: Tree) -> str:  # noqa: C901 - one case a kind of node
        match tree:
            case Number(text):
                return text
            case Constant(name):
                return {"pi": r"\pi", "e": r"\mathrm{e}"}[name]
            case Name(name):
                return self.name(name)
            case Sum(terms):
                return "".join(
                    f" - {self.factor(term.operand)}" if isinstance(term, Negation) else f" + {self.show(term)}"
                    for term in terms
                ).removeprefix(" + ")
            case Negation(operand):
                return f"-{self.factor(operand)}"
            case Product(factors):
                return r" \cdot ".join(map(self.factor, factors))
            case Quotient(above, below):
                return self.fraction(self.show(above), self.show(below))
            case Power(base, exponent):
                simple = isinstance(base, Name | Number)
                return self.power(self.show(base) if simple else self.bracketed(base), self.show(exponent))
            case Call("sqrt", (inside,)):
                return self.root(self.show(inside))
            case Call(function, arguments):
                return self.function(function, ", ".join(map(self.show, arguments)), "")
            case Array(entries):
                rows = (entry.entries if isinstance(entry, Array) else (entry,) for entry in entries)
                body = r" \\ ".join(" & ".join(map(self.show, row)) for row in rows)
                return rf"\begin{{bmatrix}} {body} \end{{bmatrix}}"
        raise AssertionError(tree)

    def factor(self, tree: Tree) -> str:
        return self.bracketed(tree) if isinstance(tree, Sum | Negation | Product) else self.show(tree)

    def bracketed(self, tree: Tree) -> str:
        return f"{self.brackets[0]}{self.show(tree)}{self.brackets[1]}"


def _called(function: str) -> str:
    known = {"abs", "atan2", "expm1", "hypot"}
    return rf"\operatorname{{{function}}}" if function in known else LATEX_CALLS.get(function, f"\\{function}")


def _hatted(name: str) -> str:
    base, below, rest = symbol(name).partition("_")
    return base if base.startswith("\\dot") else rf"\hat{{{base}}}{below}{rest}"


def _in_mathtype(name: str) -> str:
    base, below, rest = symbol(name).partition("_")
    return f"{{{{{base} }}{below}{rest}}}" if below else base


BOOK = Dialect(
    name=symbol,
    fraction=lambda above, below: rf"\frac{{{above}}}{{{below}}}",
    power=lambda base, exponent: f"{base}^{{{exponent}}}",
    function=lambda function, inside, raised: rf"{_called(function)}{raised}\left({inside}\right)",
    around=lambda formula: rf"\[ {formula} \, . \]",
    brackets=(r"\left(", r"\right)"),
)
MATHTYPE = Dialect(
    name=_in_mathtype,
    fraction=lambda above, below: rf"\frac{{{above}}}{{{below}}}",
    power=lambda base, exponent: f"{{{{{base}}}^{{{exponent}}}}}",
    function=lambda function, inside, raised: rf"{{{_called(function)} }}{raised}\left( {inside} \right)",
    around=lambda formula: formula,
    brackets=(r"\left( ", r" \right)"),
)
JOURNAL = Dialect(
    name=_hatted,
    fraction=lambda above, below: rf"\dfrac{{{above}}}{{{below}}}",
    power=lambda base, exponent: f"{base}^{{{exponent}}}",
    function=lambda function, inside, raised: rf"{_called(function)}{raised}\!\bigl[{inside}\bigr]",
    around=lambda formula: f"\\begin{{align}}\n y & = {formula}, \\label{{eq}} \\tag{{8b}} \\\\\n\\end{{align}}",
    brackets=(r"\Bigl(", r"\Bigr)"),
)
PLAIN_TEX = Dialect(
    name=symbol,
    fraction=lambda above, below: rf"{{{above} \over {below}}}",
    power=lambda base, exponent: f"{base}^{{{exponent}}}",
    function=lambda function, inside, raised: rf"{{\rm {function}}}{raised}({inside})",
    around=lambda formula: f"$${formula}$$",
    brackets=("(", ")"),
)
DIALECTS = {"book": BOOK, "MathType": MATHTYPE, "journal": JOURNAL, "plain TeX": PLAIN_TEX}


@dataclass(frozen=True)
class Language:
    """How a language writes what formulas have."""

    prefix: str
    power: Callable[[str, str], str]
    array: Callable[[list[str]], str]
    calls: dict[str, str]
    number: Callable[[str], str] = lambda text: text
    signs: tuple[str, str] = ("*", "/")

    def formula(self, tree: Tree) -> str:  # noqa: C901 - one case a kind of node
        match tree:
            case Number(text):
                return self.number(text)
            case Constant(name):
                return {"pi": self.calls["pi"], "e": self.calls["e"]}[name]
            case Name(name):
                return name
            case Sum(terms):
                return "(" + " + ".join(map(self.formula, terms)) + ")"
            case Negation(operand):
                return f"(-{self.formula(operand)})"
            case Product(factors):
                return "(" + self.signs[0].join(map(self.formula, factors)) + ")"
            case Quotient(above, below):
                return f"({self.formula(above)}{self.signs[1]}{self.formula(below)})"
            case Power(base, exponent):
                return self.power(self.formula(base), self.formula(exponent))
            case Call(function, arguments):
                called = self.calls.get(function, self.prefix + function)
                return f"{called}({', '.join(map(self.formula, arguments))})"
            case Array(entries):
                return self.array([self.formula(entry) for entry in entries])
        raise AssertionError(tree)


NUMPY = Language(
    "np.",
    lambda base, exponent: f"{base}**{exponent}",
    lambda entries: f"np.array([{', '.join(entries)}])",
    {"pi": "np.pi", "e": "np.e", "acos": "np.arccos", "asin": "np.arcsin", "atan": "np.arctan", "atan2": "np.arctan2"},
)
CPP = Language(
    "std::",
    lambda base, exponent: f"std::pow({base}, {exponent})",
    lambda entries: f"{{{', '.join(entries)}}}",
    {"pi": "M_PI", "e": "std::exp(1.0)", "abs": "std::fabs"},
    lambda text: text if "." in text else f"{text}.0",
)
C = Language(
    "",
    lambda base, exponent: f"pow({base}, {exponent})",
    lambda entries: f"{{{', '.join(entries)}}}",
    {"pi": "M_PI", "e": "expf(1.0f)", "abs": "fabs", "sqrt": "sqrtf"},
    lambda text: text if "." in text else f"{text}.0f",
)
MATLAB = Language(
    "",
    lambda base, exponent: f"{base}.^{exponent}",
    lambda entries: f"[{'; '.join(entry.strip('[]') for entry in entries)}]",
    {"pi": "pi", "e": "exp(1)"},
    signs=(".*", "./"),
)
LANGUAGES = {"python": NUMPY, "cpp": CPP, "c": C, "matlab": MATLAB}
