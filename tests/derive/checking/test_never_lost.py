"""A verdict that is known is told, whatever the formula, its conditions and its names do."""

from collections.abc import Callable, Mapping

import mpmath
import pytest
import sympy

from radartrack.derive import check
from radartrack.derive.algebra.equality import proved_equal
from radartrack.derive.checking import answers as checking
from radartrack.derive.checking.asking import ask
from radartrack.derive.checking.comparing.counterexample import find_difference
from radartrack.derive.checking.comparing.numerical_comparison import Comparison, Values
from radartrack.derive.checking.comparing.question_domain import Domain
from radartrack.derive.checking.papers.claim import Claim
from radartrack.derive.checking.papers.deadline import Decider
from radartrack.derive.checking.question.compared_quantity import UnknownEntry
from radartrack.derive.checking.question.names import Names
from radartrack.derive.checking.repairing import least_to_explain
from radartrack.derive.checking.reporting.derived_formula import shown
from radartrack.derive.checking.reporting.verdict import Outcome
from radartrack.derive.evaluation.floating_point import RoughEvaluator
from radartrack.derive.evaluation.many_digits import Evaluator, NotComputed, evaluate
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.language.tensor import Tensor

WRONG = {Outcome.DIFFERS, Outcome.WRONG_DIMENSIONS}
x, y = sympy.symbols("x y", real=True)

# SymPy turns one function into another, or into none that has a value.
TURNED = [
    ("polar.map[0]", "r*cos(atan(tan(beta)))"),
    ("polar.map[0]", "r*tan(pi/2 - beta)"),
    ("polar.map[0]", "r*tan(beta + pi/2)"),
    ("polar.map[0]", "r*cos(asin(beta/4))*tan(acos(beta/4))"),
    ("polar.map[0]", "r*acos(sec(beta))"),
    ("polar.map[0]", "r*cot(beta - pi/2)*csc(beta + pi/2)"),
    ("polar.map[0]", "r*abs(sqrt(beta))*abs(log(beta))"),
    ("polar.map[0]", "r*abs(sqrt(cos(beta)) + sqrt(sin(beta)))"),
    ("polar.map[0]", "r*log(exp(sqrt(beta)))"),
    ("polar.map[0]", "r*atan2(0, beta)*atan2(beta, 0*r)"),
    ("polar.map[0]", "r*atan2(sqrt(beta), beta)*abs(atan2(sqrt(beta), 1))"),
    ("polar.map[0]", "r*cos(beta)/atan(tan(beta + pi/2))"),
    ("polar.validity.linear[0]", "sqrt(3)*r*(--(sigma_beta*0.9999999999))**2/sin(asin(2*sigma_r))"),
    ("polar.covariance.linear[0,0]", "r**2*sigma_beta**2*tan(asin(rho)) + sigma_r**2*sin(acos(rho))"),
]  # fmt: skip


@pytest.mark.parametrize(("name", "formula"), TURNED)
def test_whatever_sympy_makes_of_a_wrong_formula_it_is_told_and_explained(name: str, formula: str) -> None:
    verdict = check(name, formula)
    assert verdict.verdict in WRONG
    assert verdict.counterexample is not None
    assert "cannot be worked out" not in str(verdict)


UNDEFINED = [
    ("observe.polar.map[1]", {"x": "0", "y": "0"}),
    ("line.slope", {"S_xy": "0"}),
    ("observe.spherical.jacobian[1,0]", {"x": "0", "y": "0"}),
    ("ruv.jacobian[2,1]", {"u": "1", "v": "0"}),
    ("fusion.weights.two[0]", {"sigma_1": "0", "sigma_2": "0"}),
]


@pytest.mark.parametrize(("name", "given"), UNDEFINED)
@pytest.mark.parametrize("formula", ["0", "1/7"])
def test_what_is_undefined_under_a_condition_is_undecided_with_a_word(
    name: str, given: Mapping[str, str], formula: str
) -> None:
    verdict = check(name, formula, given=given)
    assert verdict.verdict is Outcome.UNDECIDED
    assert "what was derived has no value when" in verdict.reason
    assert "cannot be worked out" not in str(verdict)


def test_none_of_these_ends_the_process_that_decides_them() -> None:
    with Decider(60) as decider:
        decider.decide(Claim("a", "polar.map[0]", formula="r"))
        child = decider._child
        told = [decider.decide(Claim("a", name, formula=formula)) for name, formula in TURNED]
        undefined = [decider.decide(Claim("a", name, formula="0", given=given)) for name, given in UNDEFINED]
        assert decider._child is child
    assert {record["verdict"] for record in told} <= {"differs", "wrong_dimensions"}
    assert {record["verdict"] for record in undefined} == {"undecided"}


def test_a_print_that_is_undefined_under_a_condition_is_undecided_with_a_word() -> None:
    verdict = check("observe.polar.map[0]", "(x**2 - y**2)/(x - y)", given={"x": "y"})
    assert verdict.verdict is Outcome.UNDECIDED
    assert verdict.reason == "what is printed has no value when x = y"


SYMPY = [
    sympy.Abs, sympy.acos, sympy.acot, sympy.acsc, sympy.arg, sympy.asec, sympy.asin, sympy.asinh, sympy.atan,
    sympy.acoth, sympy.atanh, sympy.conjugate, sympy.cos, sympy.cosh, sympy.cot, sympy.coth, sympy.csc, sympy.csch,
    sympy.erf, sympy.exp, sympy.Heaviside, sympy.im, sympy.log, sympy.re, sympy.sec, sympy.sech, sympy.sign, sympy.sin,
    sympy.sinh, sympy.tan, sympy.tanh,
]  # fmt: skip


@pytest.mark.parametrize("function", SYMPY, ids=lambda function: function.__name__)
@pytest.mark.parametrize("value", [0.375, -0.375, 2.5, -2.5])
def test_functions_that_sympy_brings_in_have_the_values_that_it_finds(
    function: Callable[..., sympy.Expr], value: float
) -> None:
    for argument in (x, x * sympy.I + sympy.Rational(1, 3)):
        expression = function(argument, evaluate=False) if function is not sympy.Heaviside else function(x)
        expected = mpmath.mpmathify(sympy.N(expression.xreplace({x: sympy.Rational(value)}).doit(), 60))
        with mpmath.workdps(60):
            assert mpmath.almosteq(evaluate(expression, {x: value}), expected, 1e-50)


@pytest.mark.parametrize(
    "nothing",
    [sympy.zoo, sympy.oo, -sympy.oo, sympy.nan, sympy.gamma(x), sympy.Piecewise((x, x > 0), (1, True)), sympy.Max(x, 1),
     sympy.Function("f")(x), sympy.EulerGamma, sympy.Float("0.5"), sympy.floor(x), sympy.besselj(1, x), y],
    ids=str,
)  # fmt: skip
def test_what_has_no_value_here_is_refused_where_it_is_evaluated_and_never_proved(nothing: sympy.Expr) -> None:
    expression = x + nothing
    evaluator = Evaluator(Tensor((1,), (expression,)), [x])
    with pytest.raises((ZeroDivisionError, NotComputed)):
        evaluator([0.5])
    assert not proved_equal(expression, x)
    assert isinstance(shown(Tensor((), (expression,))), str)
    if nothing.has(x) or not nothing.is_real:
        assert RoughEvaluator([expression], [x])([0.5]) is None


FAILURES = [KeyError("cot"), MemoryError()]
BESIDE = {
    "shown": checking,
    "worst_over_domain": checking,
    "orders": checking,
    "suggest": least_to_explain,
    "explanations": least_to_explain,
    "other_quantities": checking,
    "check_dimension": checking,
}


@pytest.mark.parametrize("failing", BESIDE)
@pytest.mark.parametrize("error", FAILURES, ids=lambda error: type(error).__name__)
def test_what_fails_beside_a_verdict_does_not_lose_it(
    failing: str, error: Exception, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(*_: object, **__: object) -> None:
        raise error

    monkeypatch.setattr(BESIDE[failing], failing, fail)
    verdict = check("polar.map[0]", "2*r*cos(beta)")
    assert verdict.verdict is Outcome.DIFFERS
    assert verdict.counterexample is not None
    assert bool(verdict.suggestions) == (failing != "suggest")
    assert len(verdict.remarks) == (failing != "check_dimension")
    assert check("polar.map[0]", "r*cos(beta)").verdict is Outcome.EQUAL


def test_a_proof_that_fails_leaves_the_comparison_in_numbers(monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(*_: object) -> bool:
        raise RecursionError

    monkeypatch.setattr(checking, "proved_equal", fail)
    assert check("polar.map[0]", "r*sin(beta + pi/2)/1 + 0*r").verdict is Outcome.EQUAL  # the same to SymPy
    assert check("polar.map[0]", "r*(1 - 2*sin(beta/2)**2)").verdict is Outcome.EQUAL_NUMERICALLY


def test_an_entry_that_cannot_be_worked_out_is_undecided_and_the_others_are_decided(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    question = ask("polar.map", "[r*cos(beta) + r, r*cos(beta)]")
    failing = question.printed_entry((0,))

    def difference(comparison: Comparison, domain: Domain) -> Values | None:
        if comparison.printed == failing:
            raise KeyError("cot")
        return find_difference(comparison, domain)

    monkeypatch.setattr(checking, "find_difference", difference)
    assert question.finding((0,)).outcome is Outcome.UNDECIDED
    *_, verdict = question.answers()
    assert verdict.verdict is Outcome.DIFFERS
    assert verdict.counterexample is not None
    assert verdict.counterexample.entry == (1,)


def test_the_verdict_comes_before_all_that_is_said_beside_it() -> None:
    first, *_, last = ask("polar.map[0]", "r*sin(beta)").answers()
    assert first.verdict is last.verdict is Outcome.DIFFERS
    assert first.counterexample is not None
    assert last.counterexample is not None
    assert first.counterexample.point == last.counterexample.point
    assert not first.suggestions
    assert last.suggestions


@pytest.mark.parametrize(
    "name", ["polar.map[0]+quantity_1", "quantity_0+polar.map[0]", "quantity_*polar.map[0]", "polar.map[0] + x"]
)
def test_a_word_that_stands_for_nothing_is_refused_by_its_name(name: str) -> None:
    word = name.replace("polar.map[0]", "").strip("+* ")
    with pytest.raises(UnknownEntry, match=f"{word} is not a name here"):
        ask(name, "r*cos(beta)")


@pytest.mark.parametrize(
    "name",
    [
        "sin",
        "tan",
        "sqrt",
        "arccos",
        "ln",
        "g(x)",
        "3b",
        r"\frac{x}{y}",
        "a b",
        "a.b",
        "",
        "é",
        "a-b",
        "a\n",
        r"\sigma_x^2",
        "R^{12}",
        "x^2",
    ],
)
def test_a_name_that_no_formula_can_use_is_refused(name: str) -> None:
    with pytest.raises(FormulaError, match="let "):
        ask("polar.map[0]", "r", let={name: "r"})


@pytest.mark.parametrize("angle", ["C*k", "C*k**2", "C**3 + k", "C/k", "sin(C)*k"])
def test_angles_of_any_kind_are_shown(angle: str) -> None:
    verdict = check(f"0*finite_sample.degree1.gain[0] + cos({angle})^2", f"(1 + cos(2*({angle})))/2")
    assert verdict.verdict is Outcome.EQUAL
    assert check(verdict.derived.join(("0*finite_sample.degree1.gain[0] + (", ")")), f"cos({angle})^2").is_equal
    assert "cannot be worked out" not in str(verdict)


def test_names_of_a_paper_are_read_in_every_entry() -> None:
    assert isinstance(ask("polar.map", "[a, r*sin(beta)]", let={"a": "r*cos(beta)"}).printed.names, Names)
