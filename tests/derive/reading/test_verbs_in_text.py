"""Verbs, matrices and picked entries in typed formulas: read, printed as they are read, and worked out."""

import re
from pathlib import Path

import pytest

from radartrack.derive import reading
from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.equality import proved_equal
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.functions import VERBS as NAMES_OF_VERBS
from radartrack.derive.formula.printing import to_text
from radartrack.derive.formula.shape import shape
from radartrack.derive.formula.to_expression import Expression, Reader
from radartrack.derive.reading.text import read_text
from radartrack.derive.verbs.table import VERBS

POSITIVE = ("r", "T", "alpha", "k", "lambda", "sigma")
SYMBOLS = {name: sp.Symbol(name, positive=True) for name in POSITIVE} | {
    name: sp.Symbol(name, real=True) for name in ("beta", "omega", "x", "y")
}
MATRIX = tuple(tuple(SYMBOLS[name] for name in row) for row in (("x", "y"), ("omega", "beta")))
SAME = {
    "expm([[0, 1], [0, 0]]*T)": "[[1, T], [0, 1]]",
    "[1, T; 0, 1]": "[[1, T], [0, 1]]",
    "[1, T; 0, 1] @ [x, y]": "[x + T*y, y]",
    "[x, y].T*[1, 2; 3, 4]*[x, y]": "[x^2 + 5*x*y + 4*y^2]",
    "[x, y]*[x, y].T": "outer([x, y], [x, y])",
    "[1, T; 0, 1]^-2": "[1, -2*T; 0, 1]",
    "[1, T; 0, 1]^3*[x, y]": "[x + 3*T*y, y]",
    "[x, y; 1, 2].T": "[x, 1; y, 2]",
    "e^([0, 1; 0, 0]*T)": "[1, T; 0, 1]",
    "e^([0, 1; 0, 0]*T)*[x, y]": "[x + T*y, y]",
    "e^-([-x].T*[y])": "exp(x*y)",
    "[A, 0; 0, A]": "[x, y, 0, 0; omega, beta, 0, 0; 0, 0, x, y; 0, 0, omega, beta]",
    "diag(A, A)": "[x, y, 0, 0; omega, beta, 0, 0; 0, 0, x, y; 0, 0, omega, beta]",
    "diag(A, [r; T], eye(1))": "[x, y, 0, 0; omega, beta, 0, 0; 0, 0, r, 0; 0, 0, T, 0; 0, 0, 0, 1]",
    "[eye(2), T*eye(2); 0, eye(2)]": "[1, 0, T, 0; 0, 1, 0, T; 0, 0, 1, 0; 0, 0, 0, 1]",
    "[A, -A.T; 0, 2*A]": "[x, y, -x, -omega; omega, beta, -y, -beta; 0, 0, 2*x, 2*y; 0, 0, 2*omega, 2*beta]",
    "[A, [r; T]; [[1, 2]], [[k]]]": "[x, y, r; omega, beta, T; 1, 2, k]",
    "diag(A, k)": "[x, y, 0; omega, beta, 0; 0, 0, k]",
    "[A, [r, T]; [[0, 0]], 1]": "[x, y, r; omega, beta, T; 0, 0, 1]",
    "exp([0, 1; 0, 0]*T)": "[1, T; 0, 1]",
    "A*A'": "A*A.T",
    "[x; y]'*A'*[r; T]": "[[x, y]]*A.T*[r; T]",
    "(A*A')'": "A*A.T",
    "norm([x, y])": "sqrt(x^2 + y^2)",
    "norm([x; y]) + norm(A[0, :].T)": "2*sqrt(x^2 + y^2)",
    "|[x, y]| + |-r|": "sqrt(x^2 + y^2) + r",
    "||[x, y]||": "sqrt(x^2 + y^2)",
    "[x, y]*[omega, beta]": "[x*omega + y*beta]",
    "2*[x, y]*[omega, beta]/norm([x; y])^2": "[2*(x*omega + y*beta)/(x^2 + y^2)]",
    "[x; y]*[omega; beta]*A": "(x*omega + y*beta)*A",
    "sqrt([x, y].T*[x, y])": "sqrt(x^2 + y^2)",
    "[x, y].T*[x, y] + 1": "x^2 + y^2 + 1",
    "1/([x, y].T*[x, y])": "1/(x^2 + y^2)",
    "([x, y].T*[x, y])^2": "(x^2 + y^2)^2",
    "[[x, y].T*[x, y], 1]": "[x^2 + y^2, 1]",
    "([x, y].T*[x, y])*A": "(x^2 + y^2)*A",
    "inv([2, 1; 1, 1])": "[1, -1; -1, 2]",
    "trace(A*A.T)": "x^2 + y^2 + omega^2 + beta^2",
    "det(A)": "x*beta - y*omega",
    "A[1, 0] + A[0, :][1]": "omega + y",
    "A[0:1, 0:2]": "[[x, y]]",
    "diag(x, y) + eye(2)": "[x + 1, 0; 0, y + 1]",
    "diff(r*cos(beta), beta, r)": "-sin(beta)",
    "jacobian([r*cos(beta), r*sin(beta)], [r, beta])": "[cos(beta), -r*sin(beta); sin(beta), r*cos(beta)]",
    "hessian(x*y^2, [x, y])": "[0, 2*y; 2*y, 2*x]",
    "taylor(exp(-sigma^2/2), [sigma], 4)": "1 - sigma^2/2 + sigma^4/8",
    "sum(j, j, 1, k)": "k*(k + 1)/2",
    "sum(lambda^(k - j), j, 1, k)": "(lambda^k - 1)/(lambda - 1)",
    "integral([s, s^2], s, 0, T)": "[T^2/2, T^3/3]",
    "limit((1 - exp(-alpha*T))/alpha, alpha, 0)": "T",
    "limit(k/(2*k + 1), k, inf)": "1/2",
    "chi2inv(99/100, 2)": "2*log(100)",
    "chi2cdf(x, 4)": "1 - exp(-x/2)*(1 + x/2)",
    "chi2cdf([2*r, 4*r], 2)": "[1 - exp(-r), 1 - exp(-2*r)]",
    "expectation(r*cos(beta), {beta: sigma})": "r*cos(beta)*exp(-sigma^2/2)",
}


def worked_out(text: str) -> Expression:
    tree = read_text(text, {*SYMBOLS, "A"}, {"A": (2, 2)})
    return Reader({**SYMBOLS, "A": MATRIX}, VERBS)(tree)


def same(first: Expression, second: Expression) -> bool:
    if isinstance(first, tuple) and isinstance(second, tuple):
        return len(first) == len(second) and all(map(same, first, second))
    return not isinstance(first, tuple) and not isinstance(second, tuple) and proved_equal(first, second)


@pytest.mark.parametrize(("text", "expected"), SAME.items(), ids=SAME)
def test_a_verb_gives_what_it_says(text: str, expected: str):
    assert same(worked_out(text), worked_out(expected))


@pytest.mark.parametrize("text", SAME)
def test_what_is_printed_of_a_formula_with_verbs_is_read_as_the_same_tree(text: str):
    tree = read_text(text, {*SYMBOLS, "A"}, {"A": (2, 2)})
    assert read_text(to_text(tree), {*SYMBOLS, "A"}, {"A": (2, 2)}) == tree


@pytest.mark.parametrize("text", SAME)
def test_the_shape_that_is_read_is_the_shape_that_comes_out(text: str):
    def shape_of(value: Expression) -> tuple[int, ...]:
        return (len(value), *shape_of(value[0])) if isinstance(value, tuple) else ()

    tree = read_text(text, {*SYMBOLS, "A"}, {"A": (2, 2)})
    assert shape(tree, {"A": (2, 2)}) == shape_of(worked_out(text))


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("sum(x, 3, 1, k)", "the second argument of sum is a name"),
        ("sum(x, j, 1)", "sum takes 4 arguments, here it has 3"),
        ("[1, 2; 3, 4]*[1, 2, 3]", "cannot be multiplied"),
        ("[x, y]*A", "a vector before a matrix is written as a row, x.T"),
        ("inv([1, 2, 3])", "inv needs as many rows as columns"),
        ("norm(A)", "the length of a vector is meant, this is an array of shape (2, 2)"),
        ("[x, y]*[x, y, r]", "cannot be multiplied"),
        ("[x, y] + [x, y].T*[x, y]", "cannot be added"),
        ("[A, 1; 0, A]", "the rows of this array differ in length"),
        ("[A, [x, y]; 0, A]", "the rows of this array differ in length"),
        ("diag(A, 0)", "diag takes the entries of the diagonal"),
        ("1/A", "cannot stand in a denominator"),
        ("cos(A)", "cannot stand in a denominator, a power or a function"),
        ("A^(1/2)", "a matrix is raised to whole powers"),
        ("A[2, 0]", "the entry 2 is beyond"),
        ("A[1:1, 0]", "this picks no entry"),
        ("A[0, 0, 0]", "has no entry with 3 places"),
        ("A[x]", "entries are picked by numbers"),
        ("eye(40)", "eye takes a whole number from 1 to 12"),
        ("jacobian(r, x)", "takes a formula or a vector, and a list of names"),
        ("diff(r^2, 2*r)", "wants a symbol where"),
        ("expectation(x, [x])", "expectation takes the deviation"),
        ("chi2inv(x, 3)", "a probability between 0 and 1 as a number"),
        ("chi2inv(1.5, 3)", "a probability between 0 and 1 as a number"),
        ("chi2inv(99, 2)", "a probability between 0 and 1 as a number; given 99"),
        ("chi2inv(1, 2)", "a probability between 0 and 1 as a number; given 1"),
        ("chi2inv(-0.5, 2)", "a probability between 0 and 1 as a number"),
        ("chi2inv(sqrt(2), 2)", "a probability between 0 and 1 as a number"),
        ("chi2cdf(-1, 2)", "chi2cdf takes a value from 0 on; given -1"),
        ("chi2cdf(-sqrt(2), 3)", "chi2cdf takes a value from 0 on"),
        ("chi2cdf(x, 2.5)", "degrees of freedom are a whole number"),
        ("taylor(x, [x], 40)", "the order of a Taylor polynomial"),
        ("r + inf", "inf stands only where a limit goes"),
        ("j*sum(j, j, 1, k)*s", "s is not a name here"),
        ("(r - 2)^k", "read only over e, a positive number or a name"),
        ("x^k", "read only over e or what is positive"),
    ],
)
def test_what_makes_no_sense_is_refused_with_a_word(text: str, message: str):
    with pytest.raises(FormulaError, match=re.escape(message)):
        worked_out(text)


def test_the_grammar_knows_the_verbs_and_no_others():
    grammar = (Path(reading.__file__).parent / "text.lark").read_text()
    (listed,) = re.findall(r"VERB\.2: /\(([a-z0-9|]+)\)", grammar)
    assert set(listed.split("|")) == set(NAMES_OF_VERBS)
    assert set(VERBS) | {"transpose"} == set(NAMES_OF_VERBS)


def test_a_name_that_begins_like_a_verb_or_stands_without_brackets_is_a_name():
    names = {"sum", "summand", "limit_1"}
    assert to_text(read_text("sum + summand*limit_1", names)) == "sum + summand*limit_1"


@pytest.mark.parametrize("text", ["[{0}, 0; 0, {0}]", "diag({0}, {0})", "[{0}, {0}; {0}, {0}]"])
def test_matrices_of_matrices_do_not_grow_beyond_what_is_printed(text: str):
    grown = "A"
    for _ in range(12):
        grown = text.format(grown)
    with pytest.raises(FormulaError):
        read_text(grown, {"A"}, {"A": (2, 2)})


def test_a_long_product_of_vectors_is_refused_with_a_word():
    with pytest.raises(FormulaError, match=r"cannot be multiplied"):
        read_text("*".join(["v"] * 300), {"v"}, {"v": (3,)})
