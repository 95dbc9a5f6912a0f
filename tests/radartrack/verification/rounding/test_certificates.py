"""Proved rounding errors: certificates hold of the code as it stands, and forged ones are refused."""

import ast
import math
from collections.abc import Callable, Mapping
from dataclasses import replace
from fractions import Fraction
from operator import add, mul, sub, truediv
from random import Random
from typing import Any

import pytest

from radartrack._regeneration.regeneration import read_record, source_directory
from radartrack.derive.catalogue import catalogue
from radartrack.verification.layers.rounding import Rounding
from radartrack.verification.outcome import Verdict
from radartrack.verification.rounding import certificate_checker, error_rules
from radartrack.verification.rounding.certificate_checker import Refused, confirmed
from radartrack.verification.rounding.certificates import code_of, confirmed_bound, kept, source_of
from radartrack.verification.subject import generated

pytest.importorskip("flint")
KEPT = kept()
PROVED = {name: row for name, row in KEPT.items() if "bound" in row}
SHOWN = ("polar.covariance.linear", "polar.unbiased.estimate", "observe.polar.jacobian", "fusion.weights.two")
SPLIT = "polar.covariance.truth"


def positive(name: str, low: float, high: float) -> dict[str, object]:
    return {"name": name, "low": low, "high": high, "kind": "positive"}


def claim(names: str, scale: str, trees: dict[str, str]) -> dict[str, object]:
    arguments = [positive(name, 1e-3, 1e5) for name in names]
    return {
        "function": "f", "arguments": arguments, "shape": (), "scale": scale, "groups": [[0]], "correlated": False,
        "trees": trees,
    }  # fmt: skip


def source(expression: str) -> str:
    return f"def f():\n    result[...] = {expression}\n"


def test_every_certificate_is_of_the_code_that_is_there():
    assert KEPT.keys() == catalogue().keys()
    digests = {name: code_of(source_of(quantity), quantity.function) for name, quantity in catalogue().items()}
    assert {name: row["code"] for name, row in KEPT.items()} == digests


def test_no_error_that_was_measured_is_above_the_proved_bound():
    directory = source_directory()
    assert directory is not None
    measured = read_record(directory)
    assert len(PROVED) > 20
    assert {name for name, row in PROVED.items() if measured[name].ulp > max(row["bound"], 1.0)} == set()


@pytest.mark.parametrize("name", [*SHOWN, SPLIT])
def test_the_checker_confirms_a_certificate(name: str):
    outcome = Rounding()(catalogue()[name], generated(catalogue()[name]))
    assert outcome.verdict is Verdict.PASSED, outcome.detail
    assert outcome.figure is not None
    assert outcome.figure <= PROVED[name]["bound"]


def test_the_layer_says_why_there_is_no_proof():
    name = next(name for name, row in KEPT.items() if "reason" in row)
    outcome = Rounding()(catalogue()[name], generated(catalogue()[name]))
    assert outcome.verdict is Verdict.NOT_APPLICABLE
    assert outcome.detail.endswith(KEPT[name]["reason"])


@pytest.mark.parametrize("forgery", ["bound", "code", "case", "short", "long", "axis"])
def test_a_forged_certificate_is_refused(forgery: str):
    quantity = catalogue()[SPLIT]
    row = dict(PROVED[SPLIT])
    trees = dict(row["trees"])
    case = max(trees, key=lambda name: len(trees[name]))
    if forgery == "case":
        del trees[case]
    else:
        tree = trees[case]
        forged = {"short": tree[:-1], "long": tree + ".", "axis": tree.replace(tree[0], "z", 1)}
        trees[case] = forged.get(forgery, tree)
    row |= {"trees": trees}
    row |= {"bound": row["bound"] * 0.9} if forgery == "bound" else {"code": "0" * 16} if forgery == "code" else {}
    with pytest.raises(Refused):
        confirmed_bound(quantity, row, source_of(quantity))


def test_a_certificate_says_nothing_of_a_wider_domain():
    quantity = catalogue()["polar.bias.truth"]
    wider = [s.on(s.low, 60.0) if s.name == "sigma_beta" else s for s in quantity.symbols]
    with pytest.raises(Refused, match="underflow"):
        confirmed_bound(replace(quantity, symbols=tuple(wider)), PROVED[quantity.name], source_of(quantity))


@pytest.mark.parametrize(
    ("expression", "scale"),
    [
        ("a * b - c * d", "terms"),
        ("(a * b + c) / (d + a)", "norm"),
        ("(a - b) * (c - d) + 0.5 * a * c", "terms"),
        ("(a + b) * (a + b) / (3.0 * c) - a * b * b / d", "terms"),
        ("a / (b * c + d) + 7.0 * a / (c + d)", "norm"),
    ],
)
def test_no_error_is_above_the_bound_whatever_the_statement(expression: str, scale: str):
    text = source(expression)
    bound = confirmed(text, claim("abcd", scale, {"a:+ b:+ c:+ d:+": "."}))
    written, of_sizes = (ast.parse(text, mode="eval").body for text in (expression, expression.replace("-", "+")))
    random, worst = Random(5), 0.0
    for _ in range(500):
        point = {name: math.exp(random.uniform(math.log(1e-3), math.log(1e5))) for name in "abcd"}
        if random.random() < 0.5:
            point["b"] = min(max(point["a"] * (1 + random.uniform(-1e-9, 1e-9)), 1e-3), 1e5)
        exact = evaluated(written, point, Fraction)
        measure = evaluated(of_sizes, point, Fraction) if scale == "terms" else abs(exact)
        error = abs(Fraction(evaluated(written, point, float)) - exact) / (measure * Fraction(1, 2**53))
        worst = max(worst, float(error))
    assert bound / 8 < worst <= bound  # a bound that nothing comes near would show nothing


def evaluated(node: ast.expr, names: Mapping[str, Any], number: Callable[[float], Any]) -> Any:
    if isinstance(node, ast.Constant) and isinstance(node.value, int | float):
        return number(node.value)
    if isinstance(node, ast.Name):
        return number(names[node.id])
    assert isinstance(node, ast.BinOp)
    left, right = (evaluated(side, names, number) for side in (node.left, node.right))
    return {ast.Add: add, ast.Sub: sub, ast.Mult: mul, ast.Div: truediv}[type(node.op)](left, right)


def test_a_statement_that_the_rules_do_not_know_is_refused():
    with pytest.raises(Refused, match="no rule"):
        confirmed(source("np.gamma(a)"), claim("a", "norm", {"a:+": "."}))


def test_a_divisor_that_may_vanish_is_refused():
    with pytest.raises(Refused):
        confirmed(source("a / (b - a)"), claim("ab", "norm", {"a:+ b:+": "."}))


def test_a_result_that_may_underflow_is_refused():
    power = "((((((a**2)**2)**2)**2)**2)**2)**2"  # 1e-3 to the 128
    with pytest.raises(Refused, match="underflow"):
        confirmed(source(f"({power}) * b"), claim("ab", "norm", {"a:+ b:+": "."}))


def test_the_assumptions_are_those_of_search_and_checker():
    assert certificate_checker.ULPS == error_rules.ULPS
