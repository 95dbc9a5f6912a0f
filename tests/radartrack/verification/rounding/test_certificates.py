"""Proved rounding errors: certificates hold of the code as it stands, and forged ones are refused."""

import ast
import math
from collections.abc import Callable, Mapping
from dataclasses import replace
from decimal import Decimal, localcontext
from fractions import Fraction
from operator import add, mul, sub, truediv
from random import Random
from typing import Any

import pytest

from radartrack._regeneration.accuracy import read_record
from radartrack._regeneration.output_directory import source_directory
from radartrack.derive.catalogue import catalogue
from radartrack.verification.layers.rounding import Rounding
from radartrack.verification.outcome import Verdict
from radartrack.verification.rounding import error_rules
from radartrack.verification.rounding.bisection import bisected
from radartrack.verification.rounding.certificates import (
    WORTH,
    claim_of,
    code_of,
    confirmed_bound,
    kept,
    proved_bounds,
    source_of,
)
from radartrack.verification.rounding.checker.certificate_checker import WAYS, confirmed
from radartrack.verification.rounding.checker.known_numbers import DOUBLE, Refused
from radartrack.verification.subject import generated

pytest.importorskip("flint")
KEPT = kept()
PROVED = {name: proved_bounds(row) for name, row in KEPT.items() if "bound" in row["double"]}
SHOWN = (
    "polar.covariance.linear", "polar.unbiased.estimate", "observe.polar.jacobian", "fusion.weights.two",
    "finite_sample.degree2.range_rate.covariance", "finite_sample.degree1.range.range_weights",
    "frames.ecef_from_geodetic.map", "observe.range_difference.jacobian", "ruv.covariance.second_order",
    "motion.ctrv.map", "motion.singer.transition", "steady_state.alpha_beta_gamma.covariance",
    "finite_sample.degree1.range.at_lag.range_weights", "line.slope", "motion.ornstein_uhlenbeck.process_noise",
    "finite_sample.degree3.range.range_weights", "spherical_doppler.covariance.third_order",
)  # fmt: skip
SPLIT = "polar.covariance.averaged"


def positive(name: str, low: float, high: float) -> dict[str, object]:
    return {"name": name, "low": low, "high": high, "kind": "positive"}


def claim(names: str, scale: str, trees: dict[str, str]) -> dict[str, object]:
    arguments = [positive(name, 1e-3, 1e5) for name in names]
    return {
        "function": "f", "arguments": arguments, "shape": (), "scale": scale, "groups": [[0]], "correlated": False,
        "precision": "double", "trees": trees,
    }  # fmt: skip


def source(expression: str) -> str:
    return f"def f():\n    result[...] = {expression}\n"


def test_every_certificate_is_of_the_code_that_is_there():
    assert KEPT.keys() == catalogue().keys()
    digests = {name: code_of(source_of(quantity), quantity.function) for name, quantity in catalogue().items()}
    assert {name: row["code"] for name, row in KEPT.items()} == digests


def test_no_bound_is_so_large_that_it_says_nothing():
    assert [
        name for name, row in KEPT.items() for kind, bound in proved_bounds(row).items() if bound > WORTH[kind]
    ] == []


def test_no_error_that_was_measured_is_above_the_proved_bound():
    directory = source_directory()
    assert directory is not None
    measured = read_record(directory)
    assert len(PROVED) > len(KEPT) / 2
    assert {name for name, bounds in PROVED.items() if measured[name].ulp > max(bounds["double"], 0.5)} == set()
    single = {name: measured[name].single for name, bounds in PROVED.items() if "single" in bounds}
    assert {name for name, ulp in single.items() if ulp > max(PROVED[name]["single"], 0.5)} == set()


@pytest.mark.parametrize("name", [*SHOWN, SPLIT])
def test_the_checker_confirms_a_certificate(name: str):
    outcome = Rounding()(catalogue()[name], generated(catalogue()[name]))
    assert outcome.verdict is Verdict.PASSED, outcome.detail
    assert outcome.figure is not None
    assert outcome.figure <= PROVED[name]["double"]


def test_the_layer_says_why_there_is_no_proof():
    name = next(name for name, row in KEPT.items() if "reason" in row["double"])
    outcome = Rounding()(catalogue()[name], generated(catalogue()[name]))
    assert outcome.verdict is Verdict.NOT_APPLICABLE
    assert outcome.detail.endswith(KEPT[name]["double"]["reason"])


@pytest.mark.parametrize("forgery", ["bound", "code", "case", "short", "long", "axis"])
def test_a_forged_certificate_is_refused(forgery: str):
    quantity = catalogue()[SPLIT]
    row = dict(KEPT[SPLIT])
    trees, bound = dict(row["double"]["trees"]), row["double"]["bound"]
    case = max(trees, key=lambda name: len(trees[name]))
    if forgery == "case":
        del trees[case]
    else:
        tree = trees[case]
        forged = {"short": tree[:-1], "long": tree + ".", "axis": tree.replace(tree[0], "z", 1)}
        trees[case] = forged.get(forgery, tree)
    if forgery == "bound":
        bound = 0.99 * confirmed_bound(quantity, row, source_of(quantity))
    row |= {"double": {"trees": trees, "bound": bound}}
    row |= {"code": "0" * 16} if forgery == "code" else {}
    with pytest.raises(Refused):
        confirmed_bound(quantity, row, source_of(quantity))


def test_a_certificate_says_nothing_of_a_wider_domain():
    quantity = catalogue()["ruv.jacobian"]
    wider = [s.on(s.low, 0.9) if s.name == "u" else s for s in quantity.symbols]
    row = KEPT[quantity.name] | {"double": {"bound": 1e9, "trees": "."}}
    confirmed_bound(quantity, row, source_of(quantity))
    with pytest.raises(Refused, match="root"):
        confirmed_bound(replace(quantity, symbols=tuple(wider)), row, source_of(quantity))


@pytest.mark.parametrize(
    ("expression", "scale"),
    [
        ("a * b - c * d", "terms"),
        ("(a * b + c) / (d + a)", "norm"),
        ("(a - b) * (c - d) + 0.5 * a * c", "terms"),
        ("(a + b) * (a + b) / (3.0 * c) - a * b * b / d", "terms"),
        ("a / (b * c + d) + 7.0 * a / (c + d)", "norm"),
        ("(a + b) * (a + b) - 2.0 * a * b", "norm"),
        ("(a * b - c * d) * (a * b - c * d) + 4.0 * a * b * c * d", "norm"),
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


WITH_SIGNS_THAT_ARE_KNOWN = (
    "(1.0 - a * a - b * b) * c + d",
    "(1.0 - a * a - b * b) * (1.0 - a * a - b * b) * (a * a - 1.0 + b * b) * c / (1.0 - a * b)",
    "c * (2.0 - a * a - 3.0 * b * b) / ((1.0 - a) * (1.0 + b)) + (1.0 - a * a) * d",
)


@pytest.mark.parametrize("expression", WITH_SIGNS_THAT_ARE_KNOWN)
@pytest.mark.parametrize("way", range(len(WAYS)))
def test_in_every_way_of_telling_errors_no_error_is_above_the_bound(expression: str, way: int):
    arguments = [positive(name, 1e-3, 0.6) for name in "ab"] + [positive(name, 1e-3, 1e5) for name in "cd"]
    shares = claim("abcd", "norm", {"a:+ b:+ c:+ d:+": "."}) | {"arguments": arguments, "ways": [way]}
    try:
        bound = confirmed(source(expression), shares)
    except Refused:
        assert not WAYS[way].signed_whole  # what signs that are known are good for
        assert not WAYS[way].factors_whole
        return
    random, worst = Random(way), 0.0
    written = ast.parse(expression, mode="eval").body
    for _ in range(400):
        point = {name: math.exp(random.uniform(math.log(1e-3), math.log(0.6))) for name in "ab"}
        point |= {name: math.exp(random.uniform(math.log(1e-3), math.log(1e5))) for name in "cd"}
        exact = evaluated(written, point, Fraction)
        error = abs(Fraction(evaluated(written, point, float)) - exact) / (abs(exact) * Fraction(1, 2**53))
        worst = max(worst, float(error))
    assert bound / 60 < worst <= bound


@pytest.mark.parametrize(
    "expression",
    ["b / (np.exp(-a) + np.exp(-b) + 0.5 * (a + b) - 1.3)", "b / (np.exp(-(a * b)) + 0.5 * a - 0.5)"],
)
def test_where_the_whole_domain_has_no_bound_boxes_are_found_that_have(expression: str):
    arguments = [positive(name, 1e-9, 1.0) for name in "ab"]
    whole = claim("ab", "norm", {"a:+ b:+": "."}) | {"arguments": arguments}
    with pytest.raises(Refused):
        confirmed(source(expression), whole)
    trees = bisected(source(expression), whole, 30.0, 60, math.inf)
    assert confirmed(source(expression), {**whole, "trees": trees}) < 1e3


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


def test_a_divisor_that_cancels_after_rounding_is_refused():
    with pytest.raises(Refused):
        confirmed(source("a / (b * b - a * a)"), claim("ab", "norm", {"a:+ b:+": "."}))


def test_a_result_that_may_overflow_is_refused():
    power = "((((((a**2)**2)**2)**2)**2)**2)**2"  # 1e5 to the 128
    with pytest.raises(Refused, match="overflow"):
        confirmed(source(f"({power}) * b"), claim("ab", "norm", {"a:+ b:+": "."}))


def test_what_underflow_takes_is_part_of_the_bound():
    power = "((((((a**2)**2)**2)**2)**2)**2)**2"
    small = claim("ab", "norm", {"a:+ b:+": "."})
    arguments = [positive("a", 1e-3, 1e-1), positive("b", 1.0, 1e5)]
    beside_one = confirmed(source(f"{power} + b"), {**small, "arguments": arguments})
    assert beside_one < 3
    assert confirmed(source(f"{power} * b"), {**small, "arguments": arguments}) > 1e30


def test_whole_numbers_are_exact_as_long_as_they_fit():
    k = {**positive("k", 2.0, 1e6), "whole": True}
    of_k = {**claim("", "norm", {"k:zero": ".", "k:+": "."}), "arguments": [k]}
    assert confirmed(source("(k + 1.0) * (k - 1.0) - 0.5 * k"), of_k) == 0.0
    assert 0 < confirmed(source("(k * k) * (k * k) / 3.0"), of_k) < 3


@pytest.mark.parametrize("low", [1.0, 0.9])
def test_a_sign_that_comes_of_an_argument_in_k_is_found(low: float):
    k = {**positive("k", low, 1e6), "whole": True}
    of_k = {**claim("", "norm", {"k:zero": ".", "k:+": "."}), "arguments": [k]}
    text = source("1.0 / (2.0 * k**2 - 3.0 * k + 1.5)")  # 0.375 and more, from 1 on 0.5 and more
    assert 1 < confirmed(text, of_k) < 40


def test_the_assumptions_are_those_of_search_and_checker():
    assert DOUBLE.ulps == error_rules.ULPS


def stated(expression: str, *, paired: bool = False) -> dict[str, object]:
    return {"scale": "stated", "stated": f"def stated():\n    result[...] = {expression}\n", "paired": paired}


def test_an_error_is_measured_against_the_scale_that_is_stated():
    text, trees = source("a - b * c"), {"a:+ b:+ c:+": "."}
    against_terms = confirmed(text, claim("abc", "terms", trees))
    assert confirmed(text, claim("abc", "norm", trees) | stated("a + b * c")) == pytest.approx(against_terms)
    assert confirmed(text, claim("abc", "norm", trees) | stated("2.0 * (a + b * c)")) <= against_terms / 2 * (1 + 1e-9)
    with pytest.raises(Refused, match="zero"):
        confirmed(text, claim("abc", "norm", trees) | stated("a - a"))


@pytest.mark.parametrize("name", ["bistatic.covariance.linear", "bistatic.covariance.truth.fourth_order"])
def test_a_covariance_whose_variance_vanishes_is_measured_against_the_sum_of_variances(name: str):
    said = claim_of(catalogue()[name], {})
    assert said["scale"] == "stated"
    assert said["paired"]
    assert said["sides"]  # of a cosine that divides


def written(*lines: str) -> str:
    return "def f():\n" + "".join(f"    {line}\n" for line in lines)


@pytest.mark.parametrize("terms", ["(A - e) / c + c / (A + c)", "(A - e) * c + 3.0 * A + c", "c / (A + c) + 0.25 * A"])
def test_a_difference_is_followed_with_either_sign(terms: str):
    text = written("e = a - b", "A = np.abs(e)", f"result[...] = {terms}")
    bound = confirmed(text, claim("abc", "norm", {"a:+ b:+ c:+": "."}))
    expression, random, worst = ast.parse(terms, mode="eval").body, Random(6), 0.0
    for _ in range(500):
        a, c = (math.exp(random.uniform(math.log(1e-3), math.log(1e5))) for _ in "ac")
        b = random.choice((a, a * (1 + random.uniform(-1e-6, 1e-6)), random.uniform(1e-3, 1e5)))
        both = []
        for number in (float, Fraction):
            e = number(a) - number(b)
            both.append(evaluated(expression, {"e": e, "A": abs(e), "c": number(c)}, number))
        if both[1]:
            worst = max(worst, float(abs(Fraction(both[0]) - both[1]) / (abs(both[1]) * Fraction(1, 2**53))))
        else:
            assert both[0] == 0
    assert bound / 20 < worst <= bound


def test_a_difference_that_may_be_computed_of_the_other_sign_does_not_cancel_with_its_size():
    text = written("e = a * b - c * d", "A = np.abs(e)", "result[...] = A - e")
    with pytest.raises(Refused):
        confirmed(text, claim("abcd", "norm", {"a:+ b:+ c:+ d:+": "."}))
    assert confirmed(text, claim("abcd", "terms", {"a:+ b:+ c:+ d:+": "."})) > 1


def test_what_is_positive_but_may_be_computed_negative_does_not_cancel_with_its_size():
    text = written("x = (a + 1e-15) - a", "A = np.abs(x)", "result[...] = (A - x) + a")
    assert confirmed(text, claim("a", "norm", {"a:+": "."})) >= 1


def test_a_formula_that_divides_by_zero_is_not_defined_there():
    signed_one = {**positive("a", -1e5, 1e5), "kind": "signed"}
    of_a = {**claim("ab", "norm", {"a:zero b:+": ".", "a:± b:+": "."}), "arguments": [signed_one, positive("b", 1, 2)]}
    assert 1 <= confirmed(source("b / a"), of_a) < 3
    several = written("result[..., 0] = b / a", "result[..., 1] = b")
    with pytest.raises(Refused, match="zero"):
        confirmed(several, {**of_a, "shape": (2,), "groups": [[0], [1]]})


def test_every_choice_of_two_comparisons_that_a_box_leaves_open_counts():
    first, second = (
        "np.less({0}, {1}) * {2} + (1.0 - np.less({0}, {1})) * {0}".format(*names)
        for names in (("a", "b", "(a * b * a * b * a * b)"), ("d", "c", "d"))
    )
    second = second.replace("* d", "* (c * d * c * d)", 2).replace(
        "np.less(d, c) * (c * d * c * d)", "np.less(d, c) * d"
    )
    either = confirmed(source(f"({first}) * ({second})"), claim("abcd", "norm", {"a:+ b:+ c:+ d:+": "."}))
    worst = confirmed(
        source("a * b * a * b * a * b * (c * d * c * d)"), claim("abcd", "norm", {"a:+ b:+ c:+ d:+": "."})
    )
    assert either >= worst


def test_what_a_comparison_says_of_what_it_compared_is_used():
    near = "np.less(a, 2.0)"
    text = source(f"{near} * (3.0 - 0.7 * a) + (1.0 - {near}) * a")
    assert 1 <= confirmed(text, claim("a", "norm", {"a:+": "."})) < 1e5
    with pytest.raises(Refused):
        confirmed(text.replace("3.0 - 0.7", "1.3 - 0.7"), claim("a", "norm", {"a:+": "."}))


def test_an_exponential_less_one_may_be_told_as_a_multiple_of_its_argument():
    text = source("a + 0.5 * np.expm1(-a)")
    little = {**claim("a", "norm", {"a:+": "."}), "arguments": [positive("a", 1e-9, 1.0)]}
    as_multiple = [number for number, way in enumerate(WAYS) if way.by_argument]
    bound = confirmed(text, little | {"ways": as_multiple})
    random, worst = Random(4), 0.0
    for _ in range(300):
        a = math.exp(random.uniform(math.log(1e-9), 0.0))
        exact = Fraction(a) + Fraction(*of_many_digits(a).as_integer_ratio()) / 2
        worst = max(worst, float(abs(Fraction(a + 0.5 * math.expm1(-a)) - exact) / (exact * Fraction(1, 2**53))))
    assert bound / 20 < worst <= bound
    with pytest.raises(Refused):
        confirmed(text, little | {"ways": [number for number in range(len(WAYS)) if number not in as_multiple]})


def test_exponentials_of_one_product_cancel_in_the_bound_as_they_do():
    text = written("x = a * b", "result[...] = np.exp(-x) - np.expm1(-x) - 0.9")  # always 0.1
    arguments = [positive("a", 1e-3, 2.0), positive("b", 1e-3, 2.0)]
    both = {**claim("ab", "norm", {"a:+ b:+": "."}), "arguments": arguments}
    bound = confirmed(text, both | {"ways": [n for n, way in enumerate(WAYS) if way.by_argument]})
    random, worst = Random(9), 0.0
    for _ in range(300):
        x = math.prod(math.exp(random.uniform(math.log(1e-3), math.log(2.0))) for _ in "ab")
        worst = max(worst, abs(math.exp(-x) - math.expm1(-x) - 0.9 - (1 - 0.9)) / 0.1 * 2**53)
    assert worst <= bound < 200
    with pytest.raises(Refused):
        confirmed(text, both | {"ways": [n for n, way in enumerate(WAYS) if not way.by_argument]})


def of_many_digits(a: float) -> Decimal:
    """e^-a - 1."""
    with localcontext() as context:
        context.prec = 60
        return (-Decimal(a)).exp() - 1


def test_both_outcomes_of_a_comparison_count_where_a_box_leaves_it_open():
    text = source("np.less(a, b) * (a + a * b) + (1.0 - np.less(a, b)) * (a * b * a * b)")
    one_way = [
        confirmed(source(part), claim("ab", "norm", {"a:+ b:+": "."})) for part in ("a + a * b", "a * b * a * b")
    ]
    assert confirmed(text, claim("ab", "norm", {"a:+ b:+": "."})) >= max(one_way)


@pytest.mark.parametrize("name", ["motion.ctrv.map", "motion.singer.transition", "steady_state.alpha_beta_gamma.gain"])
def test_a_certificate_is_of_the_helpers_too(name: str):
    quantity = catalogue()[name]
    text = source_of(quantity)
    spoilt = text.replace("order + 30", "order + 3").replace("12.0 * c**2 - 3.0)", "12.0 * c**2 - 2.0)")
    assert text != spoilt
    assert code_of(text, quantity.function) != code_of(spoilt, quantity.function)
    with pytest.raises(Refused, match="other code"):
        confirmed_bound(quantity, KEPT[name], spoilt)


@pytest.mark.parametrize("name", ["polar.covariance.averaged", "line.slope", "motion.singer.transition"])
def test_a_bound_does_not_depend_on_the_precision_that_others_set(name: str):
    import flint  # noqa: PLC0415 - the extra that the rest of this file is skipped without

    quantity, row = catalogue()[name], KEPT[name]
    for kind in PROVED[name]:
        bounds = set()
        for bits in (30, 53, 170):
            with flint.ctx.workprec(bits):
                bounds.add(confirmed_bound(quantity, row, source_of(quantity), kind))
                assert flint.ctx.prec == bits
        assert len(bounds) == 1
