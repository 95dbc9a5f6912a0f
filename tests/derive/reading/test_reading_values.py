"""What a formula is read as, against values found while the formula was written down.

Each strategy writes a piece of a formula, typed and in LaTeX, and computes beside it what a reader of the
page would: terms from left to right, products before sums, powers before products. Functions are stood in
for by rational ones, so that all is exact.
"""

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from math import prod

from hypothesis import given, reject
from hypothesis import strategies as st

from radartrack.derive.reading import (
    Call,
    FormulaError,
    Name,
    Negation,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Tree,
    children,
    read_latex,
    read_text,
)

VALUES = {
    "r": Fraction(7, 3),
    "beta": Fraction(2, 5),
    "sigma_r": Fraction(3, 2),
    "sigma_beta": Fraction(1, 7),
    "rdot": Fraction(-5, 4),
    "k": Fraction(11),
}
LATEX_NAMES = {
    "r": ["r"],
    "beta": ["\\beta", "{\\beta}"],
    "sigma_r": ["\\sigma_r", "\\sigma_{r}", "\\sigma_{\\rm r}", "\\sigma_\\mathrm{r}"],
    "sigma_beta": ["\\sigma_\\beta", "\\sigma_{\\beta}"],
    "rdot": ["\\dot r", "\\dot{r}", "\\mathrm{rdot}"],
    "k": ["k"],
}
STAND_INS: dict[str, Callable[..., Fraction]] = {
    "cos": lambda x: x / (1 + x * x) + 1,
    "sin": lambda x: 2 * x + 1 / (3 + x * x),
    "cosh": lambda x: x * x - 5,
    "exp": lambda x: (x + 1) / (x * x + 2),
    "abs": abs,
    "atan2": lambda y, x: y - 3 * x,
}


@dataclass(frozen=True)
class Written:
    """A piece of a formula: as typed, in LaTeX, and what it is worth.

    `ends` says what may follow side by side: anything, or after an open function a bracket or a function.
    """

    text: str
    latex: str
    value: Fraction
    begins: str = "letter"
    ends: str = "closed"


@st.composite
def names(draw: st.DrawFn) -> Written:
    name = draw(st.sampled_from(sorted(VALUES)))
    return Written(name, draw(st.sampled_from(LATEX_NAMES[name])), VALUES[name])


numbers = st.sampled_from(["1", "2", "12", "0.5", "3.25"]).map(
    lambda text: Written(text, text, Fraction(text), begins="number")
)


@st.composite
def brackets(draw: st.DrawFn, inner: st.SearchStrategy[Written]) -> Written:
    one = draw(inner)
    left, right = draw(st.sampled_from(["()", "[]", ("\\left(", "\\right)"), ("\\bigl\\{", "\\bigr\\}")]))
    return Written(f"({one.text})", f"{left}{one.latex}{right}", one.value, begins="bracket")


@st.composite
def bars(draw: st.DrawFn, inner: st.SearchStrategy[Written]) -> Written:
    one = draw(inner)
    text = draw(st.sampled_from(["abs({})", "|{}|"])).format(one.text)
    return Written(text, f"\\left|{one.latex}\\right|", abs(one.value), begins="bracket")


@st.composite
def calls(draw: st.DrawFn, inner: st.SearchStrategy[Written]) -> Written:
    function = draw(st.sampled_from(["cos", "sin", "cosh", "exp"]))
    one = draw(inner)
    command = draw(st.sampled_from(["\\{}", "\\operatorname{{{}}}", "\\mathrm{{{}}}"])).format(function)
    value = STAND_INS[function](one.value)
    return Written(f"{function}({one.text})", f"{command}({one.latex})", value, begins="function")


@st.composite
def powers_of_functions(draw: st.DrawFn, inner: st.SearchStrategy[Written]) -> Written:
    one, power = draw(inner), draw(st.integers(2, 3))
    return Written(
        f"cos({one.text})^{power}",
        f"\\cos^{power}\\left({one.latex}\\right)",
        STAND_INS["cos"](one.value) ** power,
        begins="function",
    )


@st.composite
def open_calls(draw: st.DrawFn) -> Written:
    """A function before one symbol or twice that; only of cosh, which takes no angles, before its power."""
    function = draw(st.sampled_from(["cos", "sin", "cosh"]))
    name, factor, power = (
        draw(names()),
        draw(st.sampled_from(["", "2", "0.5"])),
        draw(st.sampled_from(["", "2", "3"])) if function == "cosh" else "",
    )
    raised = draw(st.sampled_from(["", "2"]))
    argument = name.value ** int(power or 1) * Fraction(factor or 1)
    typed = f"{factor}*{name.text}" if factor else name.text
    latex = name.latex.strip("{}") if name.latex.startswith("{") else name.latex
    return Written(
        f"{function}({typed}{'**' + power if power else ''}){'**' + raised if raised else ''}",
        f"\\{function}{'^' + raised if raised else ''} {factor}{latex}{'^' + power if power else ''}",
        STAND_INS[function](argument) ** int(raised or 1),
        begins="function",
        ends="open",
    )


@st.composite
def arctangents(draw: st.DrawFn, inner: st.SearchStrategy[Written]) -> Written:
    one, two = draw(inner), draw(inner)
    return Written(
        f"atan2({one.text}, {two.text})",
        f"\\operatorname{{atan2}}({one.latex}, {two.latex})",
        STAND_INS["atan2"](one.value, two.value),
        begins="function",
    )


@st.composite
def powers(draw: st.DrawFn, inner: st.SearchStrategy[Written]) -> Written:
    base, exponent = draw(inner), draw(st.integers(-3, 4))
    if base.value == 0 and exponent < 0:
        reject()
    raised = draw(st.sampled_from(["^", "**", " ^ "]))
    short = exponent >= 0 and draw(st.booleans())
    return Written(
        f"{base.text}{raised}{exponent}",
        f"{base.latex}^{exponent}" if short else f"{base.latex}^{{{exponent}}}",
        base.value**exponent,
        begins=base.begins,
    )


@st.composite
def subscripted_powers(draw: st.DrawFn) -> Written:
    """The exponent before the subscript, as many papers print it."""
    power = draw(st.integers(2, 4))
    latex = draw(st.sampled_from(["\\sigma^{}_\\beta", "\\sigma^{{{}}}_{{\\beta}}"])).format(power)
    return Written(f"sigma_beta**{power}", latex, VALUES["sigma_beta"] ** power)


@st.composite
def towers(draw: st.DrawFn) -> Written:
    """Powers of powers, from the top down."""
    name, lower, upper = draw(names()), draw(st.integers(2, 3)), draw(st.integers(1, 3))
    latex = f"{name.latex}^{{{lower}^{{{upper}}}}}"
    return Written(f"{name.text}^{lower}^{upper}", latex, name.value ** (lower**upper))


@st.composite
def fractions(draw: st.DrawFn, inner: st.SearchStrategy[Written]) -> Written:
    above, below = draw(inner), draw(inner)
    if below.value == 0:
        reject()
    command = draw(st.sampled_from(["\\frac", "\\dfrac", "\\tfrac"]))
    return Written(
        f"(({above.text})/({below.text}))",
        f"{command}{{{above.latex}}}{{{below.latex}}}",
        above.value / below.value,
        begins="fraction",
    )


@st.composite
def products(draw: st.DrawFn, factors: st.SearchStrategy[Written], most: int) -> Written:
    """Factors side by side in LaTeX, with a dot where print needs one; typed, some of them divided by."""
    first, *others = draw(st.lists(factors, min_size=1, max_size=most))
    text, latex, value, ends = first.text, first.latex, first.value, first.ends
    for factor in others:
        if draw(st.integers(0, 3)) == 0 and factor.value != 0:
            text, latex = f"{text}/{factor.text}", f"\\frac{{{latex}}}{{{factor.latex}}}"
            value, ends = value / factor.value, "closed"
            continue
        beside = factor.begins in {"bracket", "function"} or (ends == "closed" and factor.begins == "letter")
        between = draw(st.sampled_from([" ", "\\,"])) if beside else draw(st.sampled_from(["\\cdot ", "\\times "]))
        text, latex = f"{text}*{factor.text}", f"{latex}{between}{factor.latex}"
        value, ends = value * factor.value, factor.ends
    return Written(text, latex, value)


@st.composite
def sums(draw: st.DrawFn, terms: st.SearchStrategy[Written], most: int) -> Written:
    text, latex, value = "", "", Fraction(0)
    for index, term in enumerate(draw(st.lists(terms, min_size=1, max_size=most))):
        sign = draw(st.sampled_from(["+", "-", " + ", " - "] if index else ["", "-"]))
        text, latex = f"{text}{sign}{term.text}", f"{latex}{sign}{term.latex}"
        value += -term.value if "-" in sign else term.value
    return Written(text, latex, value)


def _grown(inner: st.SearchStrategy[Written], most: int) -> st.SearchStrategy[Written]:
    atoms = st.one_of(names(), numbers, brackets(inner), bars(inner), calls(inner), arctangents(inner))
    factors = st.one_of(
        atoms,
        powers(atoms),
        fractions(inner),
        powers_of_functions(inner),
        open_calls(),
        subscripted_powers(),
        towers(),
    )
    return sums(products(factors, most), most)


simple = sums(products(st.one_of(names(), numbers), most=2), most=2)
formulas = st.one_of(_grown(simple, most=4), _grown(_grown(simple, most=2), most=2))


def value(tree: Tree) -> Fraction:
    """What a tree is worth, with the stand-ins."""
    parts = [value(child) for child in children(tree)]
    match tree:
        case Number():
            return tree.value
        case Name(name):
            return VALUES[name]
        case Sum():
            return sum(parts, Fraction(0))
        case Product():
            return prod(parts, start=Fraction(1))
        case Quotient():
            return parts[0] / parts[1]
        case Negation():
            return -parts[0]
        case Power():
            return parts[0] ** int(parts[1])
        case Call(function):
            return STAND_INS[function](*parts)
    raise AssertionError(tree)


def read(reader: Callable[..., Tree], source: str) -> Tree:
    try:
        return reader(source, VALUES)
    except FormulaError as error:
        if any(limit in error.message for limit in ("expanded", "digits", "divides by zero", "e-300", "1e300")):
            reject()
        raise


@given(formulas)
def test_a_typed_formula_is_read_as_it_was_meant(written: Written):
    assert value(read(read_text, written.text)) == written.value


@given(formulas)
def test_a_formula_in_latex_is_read_as_it_was_meant(written: Written):
    assert value(read(read_latex, written.latex)) == written.value
