"""How much a formula may ask for, and how soon more than that is refused."""

import json
import subprocess
import sys
from collections.abc import Callable

import pytest

from radartrack.derive.reading import FormulaError, Tree, names, read_latex, read_text, to_expression
from radartrack.derive.symbolic import Symbol
from tests.effort import at_most

NAMES = ("r", "k", "x")
SECONDS = 2.0

HOSTILE_TEXT = {
    "a tower of powers": "9**9**9**9",
    "a power of a power of a power": "(((x + 1)^64)^64)^64",
    "a root of a power of a power": "(((x + 1)^64)^(1/2))^64",
    "a power hidden in a product": "(x^64*x^64)^5",
    "a power hidden in a function": "sqrt(x^64 + 1)^64",
    "digits hidden in a power": "((1 + 1e-40)^64)^64",
    "digits hidden in a power of a symbol": "*".join(["((1 + 1e-40)*x)^64"] * 4),
    "digits hidden in a sum": "+".join(f"1/{10**39 + i}" for i in range(450)),
    "a power in disguise": "exp(64*log(exp(64*log(exp(64*log(2))))))",
    "a power of e in disguise": "e**(64*log(x))",
    "a power of two in disguise": "2**(64*log(x))",
    "a power in hyperbolic disguise": "cosh(64*log(cosh(64*log(2))))",
    "an exponential of exponentials": "exp(exp(exp(exp(exp(9)))))",
    "a negative power": "r**-65",
    "a large power": "r**65",
    "a power by a fine fraction": "r**(1/9)",
    "a power by a symbol": "(r + 1)**k",
    "a power of something negative by a symbol": "(-2)**k",
    "a number too large": "((10^64)^5)",
    "a number too small": "((10^-64)^5)",
    "a number too large in the end": "exp(700)",
    "a number too small in the end": "exp(-800)",
    "a product too large": "*".join(["10^60"] * 6),
    "a quotient too small": "1e-40/1e40/1e40/1e40/1e40/1e40/1e40/1e40",
    "ten thousand brackets": "(" * 10_000,
    "nine thousand pairs of brackets": "(" * 9_000 + "r" + ")" * 9_000,
    "ten thousand square brackets": "[" * 10_000,
    "brackets one too deep": "(" * 101 + "r" + ")" * 101,
    "ten thousand bars": "|" * 10_000,
    "bars in bars": "|" * 8_000 + "r" + "|" * 8_000,
    "a megabyte": "r+" * 500_000,
    "a megabyte of bytes that are nothing": "\0" * 1_000_000,
    "eighty thousand digits": "9" * 79_996,
    "41 digits": "1" * 41,
    "a large decimal exponent": "1e999999999",
    "a decimal exponent of many digits": "1e" + "9" * 60_000,
    "a decimal exponent of many zeros": "1e" + "0" * 60_000 + "1",
    "a long name": "r" * 79_996,
    "many words": "a " * 39_996,
    "many functions": "sin " * 19_996,
    "signs": "-" * 76_000 + "r",
    "signs between": "r" + "-" * 76_000 + "r",
    "many terms": "r" + "+r" * 39_000,
    "many factors": "r" + "*r" * 39_000,
    "many divisors": "r" + "/r" * 39_000,
    "many powers": "2" + "^2" * 39_000,
    "functions in functions": "sin(" * 99 + "r + 1" + ")" * 99,
    "many entries": "[" + "r," * 39_000 + "r]",
    "white space": " " * 79_996,
}
HOSTILE_LATEX = {
    "fractions": "\\frac" * 3_999,
    "fractions in fractions": "\\frac{1}{1+" * 99 + "r" + "}" * 99,
    "fractions too deep": "\\frac{1}{1+" * 1_000 + "r" + "}" * 1_000,
    "roots": "\\sqrt" * 3_999,
    "brackets": "\\left(" * 3_000,
    "subscripts": "r_" * 9_999,
    "exponents": "r^" * 9_999,
    "exponents and subscripts": "r^2_r" * 3_999,
    "braces in subscripts": "r_{" * 4_000 + "r" + "}" * 4_000,
    "bars": "|" * 19_999,
    "letters": "r" * 19_999,
    "letters apart": "r " * 9_999,
    "digits": "1" * 19_999,
    "digits and points": "1." * 9_999,
    "functions": "\\cos" * 4_000,
    "functions of symbols": "\\cos r" * 3_000,
    "matrices": "\\begin{pmatrix}" * 1_300,
    "columns": "\\begin{array}{" + "c" * 19_000,
    "entries": "\\begin{pmatrix}" + "r&" * 9_000 + "r\\end{pmatrix}",
    "rows": "\\\\ " * 6_000,
    "rows with lengths": "\\\\[" * 6_000,
    "row with a long length": "\\\\[" + "1" * 19_000,
    "dots": "\\dot" * 4_999,
    "dots in dots": "\\dot{" * 3_000 + "r" + "}" * 3_000,
    "sizes": "\\left" + " " * 19_000,
    "a long word": "\\mathrm{" + "a" * 19_000,
    "words": "\\mathrm{a}" * 1_999,
    "a megabyte": "r+" * 500_000,
    "a tower of powers": "9^{9^{9^9}}",
    "a power of a power": "((r^{64})^{64})^{64}",
    "a root": "\\sqrt[9]{r}",
    "a power by a symbol": "(r + 1)^k",
}
HOSTILE = [(read_text, name, formula) for name, formula in HOSTILE_TEXT.items()] + [
    (read_latex, name, formula) for name, formula in HOSTILE_LATEX.items()
]

LARGE = {
    "terms": "r" + "+r*k" * 1_600,
    "factors": "*".join(f"(x + {i})" for i in range(500)),
    "roots in roots": "sqrt(1 + r*" * 32 + "r" + ")" * 32,
    "logarithms in logarithms": "log(2 + r*" * 32 + "r" + ")" * 32,
    "exponentials in exponentials": "exp(-r*" * 32 + "r" + ")" * 32,
    "bars in bars": "abs(r - " * 33 + "k" + ")" * 33,
    "denominators": "+".join(f"x/{10**39 + i}" for i in range(200)),
    "a number hard to factor": "sqrt(1234567890123456789012345678901234567891)",
    "multiples of pi": "cos(pi/9999999999999999999999999999999999999999)",
    "brackets": "(" * 100 + "r" + ")" * 100,
}


@pytest.fixture(scope="module", autouse=True)
def warm():
    """The grammars are built once, at the first formula."""
    read_text("r", NAMES)
    read_latex("r", NAMES)


@pytest.mark.parametrize(
    ("reader", "formula"),
    [(reader, formula) for reader, _, formula in HOSTILE],
    ids=[f"{reader.__name__}: {name}" for reader, name, _ in HOSTILE],
)
def test_a_formula_that_asks_for_too_much_is_refused_at_once(reader: Callable[..., Tree], formula: str):
    with at_most(SECONDS), pytest.raises(FormulaError) as caught:
        reader(formula, NAMES)
    assert len(str(caught.value)) < 1_000


@pytest.mark.parametrize("formula", LARGE.values(), ids=LARGE.keys())
def test_the_largest_formulas_are_read_and_made_into_expressions_at_once(formula: str):
    with at_most(SECONDS):
        to_expression(read_text(formula, NAMES), {name: Symbol(name, positive=True) for name in NAMES})


READ_ALL = """
import json, resource, sys
resource.setrlimit(resource.RLIMIT_AS, (500_000_000, 500_000_000))
from radartrack.derive.reading import FormulaError, read_latex, read_text
refused = 0
for reader, formula in json.load(sys.stdin):
    try:
        {"read_text": read_text, "read_latex": read_latex}[reader](formula, ["r", "k", "x"])
    except FormulaError:
        refused += 1
print(refused)
"""


def test_all_that_is_refused_is_refused_in_little_memory():
    formulas = json.dumps([(reader.__name__, formula) for reader, _, formula in HOSTILE])
    done = subprocess.run(
        [sys.executable, "-c", READ_ALL],
        input=formulas,
        capture_output=True,
        text=True,
        check=False,
    )
    assert (done.stdout, done.stderr) == (f"{len(HOSTILE)}\n", "")


@pytest.mark.parametrize(
    ("formula", "message"),
    [
        ("9**9**9**9", "exponents lie between -64 and 64"),
        ("r**(1/9)", "the denominator of an exponent is at most 8"),
        ("(((x + 1)^64)^64)^64", "expanded, this has degree 4096; at most 512 is allowed"),
        ("(r + 1)**k", "an exponent that is no plain number is read only over e, a positive number or a name"),
        ("exp(2*log(r))", "an exponential of a logarithm is not read: write it as a power"),
        ("exp(1000)", "a number that arises here is larger than 1e300"),
        ("exp(-1000)", "a number that arises here is smaller than 1e-300"),
        ("1" * 41, "a number has 41 digits; at most 40 are read"),
        ("1e41", "the decimal exponent of a number is at most 40"),
        ("(" * 101, "brackets are nested more than 100 deep"),
        ("-" * 101 + "r", "the formula is nested more than 100 deep"),
        ("r" + "+r" * 30_000, "the formula has more than 30000 parts"),
        ("r" * 80_001, "the formula has 80001 characters; at most 80000 are read"),
        (
            "((1 + 1e-40)^64)^64",
            "the numbers that arise here have some 188416 digits; at most 10000 are allowed",
        ),
    ],
    ids=lambda value: value[:30],
)
def test_a_refusal_names_the_limit(formula: str, message: str):
    with pytest.raises(FormulaError) as caught:
        read_text(formula, NAMES)
    assert caught.value.message == message


def test_what_is_printed_in_latex_is_shorter_than_what_is_typed():
    for formula, message in [
        ("r" * 20_001, "the formula has 20001 characters; at most 20000 are read"),
        ("r+" * 5_000 + "r", "the formula has more than 5000 parts"),
    ]:
        with pytest.raises(FormulaError) as caught:
            read_latex(formula, NAMES)
        assert caught.value.message == message
    assert names(read_text("r+" * 15_000 + "r", NAMES)) == {"r"}


@pytest.mark.parametrize(
    "formula",
    [
        "r**64",
        "r**-64",
        "r**(1/8)",
        "(r**64)**8",
        "e**(-2*r**2)",
        "2**k",
        "0.5**k",
        "(1/2)**(k - 1)",
        "2**sqrt(2)",
        "exp(600)",
        "log(r)**2",
        "0**0*r",
        "0*1e-40",
        "cos(0)*sin(0)*exp(0)",
        "1" * 40,
        "1e40 + 1e-40",
        "-" * 99 + "r",
    ],
)
def test_what_stays_within_the_limits_is_read(formula: str):
    assert names(read_text(formula, NAMES)) <= {*NAMES}
