"""Typed formulas: how they are read, and how they are refused."""

import pickle

import pytest

from radartrack.derive.reading import (
    Array,
    Call,
    Constant,
    FormulaError,
    Name,
    Negation,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Tree,
    read_text,
)

NAMES = ("r", "beta", "sigma_r", "sigma_beta", "k", "C")
r, k, two = Name("r"), Name("k"), Number("2")


def refusal(formula: str, names: tuple[str, ...] = NAMES) -> FormulaError:
    with pytest.raises(FormulaError) as caught:
        read_text(formula, names)
    return caught.value


@pytest.mark.parametrize(
    ("formula", "tree"),
    [
        ("-r^2", Negation(Power(r, two))),
        ("(-r)^2", Power(Negation(r), two)),
        ("2^r^2", Power(two, Power(r, two))),
        ("2^-1", Power(two, Negation(Number("1")))),
        ("2**-r**2", Power(two, Negation(Power(r, two)))),
        ("r/k*2", Product((Quotient(r, k), two))),
        ("r*k/2", Quotient(Product((r, k)), two)),
        ("r/k/2", Quotient(Quotient(r, k), two)),
        ("r*(k/2)", Product((r, Quotient(k, two)))),
        ("(r*k)*2", Product((Product((r, k)), two))),
        ("-r*k", Negation(Product((r, k)))),
        ("r*-k", Product((r, Negation(k)))),
        ("r - k + 2", Sum((r, Negation(k), two))),
        ("r - (k + 2)", Sum((r, Negation(Sum((k, two)))))),
        ("(r - k) + 2", Sum((Sum((r, Negation(k))), two))),
        ("+r - -k", Sum((r, Negation(Negation(k))))),
        (
            "|r|*|k - |r||",
            Product((Call("abs", (r,)), Call("abs", (Sum((k, Negation(Call("abs", (r,))))),)))),
        ),
        ("ln(r) + arctan(k)", Sum((Call("log", (r,)), Call("atan", (k,))))),
        ("atan2(r, k)", Call("atan2", (r, k))),
        ("2*pi*e*E", Product((two, Constant("pi"), Constant("e"), Constant("e")))),
        ("2.5e-3", Number("2.5e-3")),
        ("[r, k]", Array((r, k))),
        ("[[r, k], [2, r]]", Array((Array((r, k)), Array((two, r))))),
        ("r*[r, k]/2", Quotient(Product((r, Array((r, k)))), two)),
        ("\tr\r\n+ k\n", Sum((r, k))),
    ],
    ids=repr,
)
def test_reading(formula: str, tree: Tree):
    assert read_text(formula, NAMES) == tree


@pytest.mark.parametrize(("typed", "name"), [("arccos", "acos"), ("arcsin", "asin"), ("arctan", "atan"), ("ln", "log")])
def test_functions_by_their_other_names(typed: str, name: str):
    assert read_text(f"{typed}(r)", NAMES) == Call(name, (r,))


@pytest.mark.parametrize("function", ["abs", "acos", "arccos", "cos", "exp", "log", "sqrt", "tanh"])
@pytest.mark.parametrize("brackets", ["()", "[]"])
def test_functions_as_algebra_systems_print_them(function: str, brackets: str):
    opener, closer = brackets[0], brackets[1]
    for name in (function.capitalize(), function.upper(), "ArcCos" if function == "arccos" else function.title()):
        typed = f"2*{name}{opener}k + {name}{opener}r{closer}{closer}"
        assert read_text(typed, NAMES) == read_text(f"2*{function}(k + {function}(r))", NAMES)


@pytest.mark.parametrize(
    ("printed", "typed"),
    [
        ("{r Cos[k], r Sin[k]}", "[r*cos(k), r*sin(k)]"),
        ("{{r, 0}, {-(r/k), 1/2 (r - k) Sin[2 k]}}", "[[r, 0], [-(r/k), 1/2*(r - k)*sin(2*k)]]"),
        ("E^(-k^2/2) r Cos[k]", "e^(-k^2/2)*r*cos(k)"),
        ("ArcTan[k - 1, Sqrt[r^2 + k^2]] + ArcTan[r/k]", "atan2(sqrt(r^2 + k^2), k - 1) + atan(r/k)"),
        (r"Sin[\[Beta]]^2 r - Pi", "sin(beta)^2*r - pi"),
        ("x r where x = Cos[k]", "cos(k)*r"),
        ("Matrix([[r, 0], [k, r*Abs(k)]])", "[[r, 0], [k, r*abs(k)]]"),
        ("Matrix([\n[r, 0],\n[k, 1]])", "[[r, 0], [k, 1]]"),
        ("ImmutableDenseMatrix([[r], [k]])", "[[r], [k]]"),
        ("matrix([r, 0], [k, 1])", "[[r, 0], [k, 1]]"),
    ],
)
def test_formulas_as_algebra_systems_print_them(printed: str, typed: str):
    names = {*NAMES, "beta"}
    assert read_text(printed, names) == read_text(typed, names)


@pytest.mark.parametrize("text", ["r k", "r (k + 1)", "r^{k, k}", "{r: k, k: r}", "2 Cos(k)"])
def test_nothing_else_is_taken_for_such_a_formula(text: str):
    with pytest.raises(FormulaError):
        read_text(text, NAMES)


@pytest.mark.parametrize(
    ("typed", "meant"),
    [
        ("ArcTan[r, ArcTan[k, C]]", "atan2(atan2(C, k), r)"),
        ("ArcTan[ArcTan[k, C], r]", "atan2(r, atan2(C, k))"),
        ("ArcTan[Cos[r], Sqrt[k]*ArcTan[r, k]]", "atan2(sqrt(k)*atan2(k, r), cos(r))"),
    ],
)
def test_arctangents_of_two_are_turned_inside_each_other_too(typed: str, meant: str):
    assert read_text(typed, NAMES) == read_text(meant, NAMES)


def test_a_symbol_in_capitals_is_no_function():
    assert read_text("EXP*(r)", ("EXP", "r")) == Product((Name("EXP"), r))
    with pytest.raises(FormulaError, match="written out"):
        read_text("COS(r)", ("COS", "r"))
    with pytest.raises(FormulaError):
        read_text("MyCos(r)", NAMES)


def test_a_symbol_hides_a_constant():
    assert read_text("e*E*pi", ["e", "pi"]) == Product((Name("e"), Constant("e"), Name("pi")))


def test_every_node_knows_where_it_stood():
    formula = "r + 2*(k - 1)/cos(beta)"
    tree = read_text(formula, NAMES)
    assert isinstance(tree, Sum)
    quotient = tree.terms[1]
    assert isinstance(quotient, Quotient)
    places = [node.span for node in (tree, quotient, quotient.numerator, quotient.denominator)]
    assert [formula[slice(*place)] for place in places if place] == [
        formula,
        "2*(k - 1)/cos(beta)",
        "2*(k - 1)",
        "cos(beta)",
    ]


@pytest.mark.parametrize(
    ("formula", "message", "marked"),
    [
        ("sin^2(beta)", "write sin(x)**2: a power stands after the brackets", "^"),
        ("cosh**3 (beta)", "write cosh(x)**3: a power stands after the brackets", "**"),
        ("cosh 2*r", "cosh wants its argument in brackets: cosh(x)", "2"),
        ("1 + cosh", "cosh wants its argument in brackets: cosh(x)", ""),
        ("2r", "products are written out: 2*r", "r"),
        ("2 r", "products are written out: 2*r", "r"),
        ("r cos(beta)", "products are written out: r*cos(...)", "cos"),
        ("k(k + 1)", "products are written out: k*(...)", "("),
        ("(k + 1)(k + 2)", "products are written out: (...)*(...)", "("),
        ("(k + 1)k", "products are written out: (...)*k", "k"),
        ("r 2", "products are written out: r*2", "2"),
        ("2|r|", "products are written out: 2*(...)", "|"),
        (
            "r*sigma_b",
            "sigma_b is not a name here: did you mean sigma_beta? The names are sigma_beta,",
            "sigma_b",
        ),
        ("R**2", "R is not a name here: did you mean r? The names are r,", "R"),
        ("sigmabeta", "sigmabeta is not a name here: did you mean sigma_beta?", "sigmabeta"),
        ("sinn(beta)", "sinn is not a function here: did you mean sin? The functions are sin,", "sinn"),
        ("f(r)", "f is not a function here. The functions are", "f"),
        ("r.real", "a dot stands only inside a number", "."),
        ("r.__class__", "a dot stands only inside a number", "."),
        ("__import__('os')", "__import__ is not a function here", "__import__"),
        ("r[0]", "a scalar has no entry with 1 places", "r[0]"),
        ("[r, k][2]", "the entry 2 is beyond an array of shape (2,); counting begins at 0", "[r, k][2]"),
        ("lambda x: x", "lambda is not a name here", "lambda"),
        ("r if k else 2", "if is not a name here", "if"),
        ("r == 2", "give the right-hand side alone, without an equals sign", "="),
        ("r := 2", ": has no meaning here", ":"),
        ("'r'", "quoted text has no place in a formula", "'"),
        ('"r"', "quoted text has no place in a formula", '"'),
        ("r # range", "comments are not read", "#"),
        ("r, , k", "a value is missing before ,", ","),
        ("k!", "factorials are not read", "!"),
        ("{r}", "braces stand only around the deviations of an expectation: use round brackets", "{"),
        ("r*\\sigma", "a backslash belongs to LaTeX: read this formula as LaTeX", "\\"),
        ("0,5*r", "decimals follow a point: 0.5", ","),
        ("r +", "the formula ends too early", ""),
        ("2*|r", "the formula ends too early: a | is not closed", ""),
        ("r*/k", "a value is missing before /", "/"),
        ("cos()", "a value is missing before )", ")"),
        ("[]", "a value is missing before ]", "]"),
        ("[r,]", "a value is missing before ]", "]"),
        ("(r + k", "( is never closed", "("),
        ("r + k)", ") closes nothing", ")"),
        ("[r + k)", ") cannot close [, which is still open", ")"),
        ("atan2(r)", "atan2 takes 2 arguments, here it has 1", "atan2(r)"),
        ("log(r, 2)", "log takes 1 argument, here it has 2", "log(r, 2)"),
        ("[r, [r, k]]", "the rows of this array differ in length", "[r, [r, k]]"),
        ("[[r, k], [r]]", "the rows of this array differ in length", "[[r, k], [r]]"),
        ("[[[[r]]]]", "arrays are nested at most 3 deep", "[[[[r]]]]"),
        ("1 + [r, k]", "a scalar and an array of shape (2,) cannot be added", "1 + [r, k]"),
        (
            "[r, k]*[r, k, 1]",
            "an array of shape (2,) and an array of shape (3,) cannot be multiplied: the columns",
            "[r, k]*[r, k, 1]",
        ),
        ("1/[r, k]", "a vector or matrix cannot stand in a denominator, a power or a function", "1/[r, k]"),
        ("[r, k]**2", "a power of a matrix needs as many rows as columns, this is an array of shape (2,)", "[r, k]**2"),
        ("cos([r, k])", "a vector or matrix cannot stand in", "cos([r, k])"),
        ("1/0", "this divides by zero", "1/0"),
        ("r + 1/(2 - 2)", "this divides by zero", "1/(2 - 2)"),
        ("0**-1", "this divides by zero", "0**-1"),
        ("sqrt(-2)", "this is not a real number", "sqrt(-2)"),
        ("(-8)**(1/3)", "this is not a real number", "(-8)**(1/3)"),
        ("r*log(0)", "this is not a real number", "log(0)"),
        ("asin(2)", "this is not a real number", "asin(2)"),
    ],
    ids=lambda value: repr(value)[:40],
)
def test_refusals(formula: str, message: str, marked: str):
    error = refusal(formula)
    assert error.message.startswith(message)
    assert error.span is not None
    assert formula[slice(*error.span)] == marked


@pytest.mark.parametrize("formula", ["", " ", "\n\t"], ids=repr)
def test_nothing_is_refused_as_empty(formula: str):
    assert refusal(formula).message == "the formula is empty"


def test_names_that_hide_functions_are_the_callers_mistake():
    with pytest.raises(ValueError, match="names: exp cannot name a symbol, it is a function"):
        read_text("exp(r)", ["r", "exp"])


def test_an_error_shows_where_it_is():
    error = refusal("r +\n  2*sigma_b**2")
    assert (error.line, error.column) == (2, 5)
    assert str(error).splitlines()[0].endswith("(line 2, column 5)")
    assert error.excerpt == "      2*sigma_b**2\n        ^^^^^^^"


def test_an_error_in_a_long_line_shows_what_is_around_it():
    error = refusal("r*" * 500 + "x" + "*r" * 500)
    assert error.column == 1001
    above, below = error.excerpt.splitlines()
    assert len(above) < 80
    assert above[below.index("^")] == "x"


def test_an_error_survives_the_way_between_processes():
    error = refusal("2*sigma_b")
    again = pickle.loads(pickle.dumps(error))  # noqa: S301 - made in this line
    assert (str(again), again.message, again.span) == (str(error), error.message, error.span)


@pytest.mark.parametrize("left", ["x", "P_11", "P[0, 1]", "f(r, beta)"])
def test_what_stands_left_of_an_equals_sign_is_left_out(left: str):
    assert read_text(f"{left} = 2*r", ["r"]) == read_text("2*r", ["r"])
    assert read_text(f"{left} = 2*r", ["r"]).span == (len(left) + 3, len(left) + 6)


@pytest.mark.parametrize("names", [["J"], ["J", "T"]])
def test_a_t_above_an_array_is_a_transpose_whatever_else_it_is_called(names: list[str]):
    assert read_text("J*J^T", names, {"J": (2, 2)}) == read_text("J*J.T", names, {"J": (2, 2)})
    assert read_text("2^T", ["T"]) == Power(Number("2"), Name("T"))
