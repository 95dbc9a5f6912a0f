"""Arguments of functions without brackets: what is clear is read, what is open is told with all that it may be."""

from copy import copy
from itertools import product

import pytest

from radartrack.derive.reading import FormulaError, read_latex, to_text
from radartrack.derive.reading.any_letters import possible_trees
from radartrack.derive.reading.notation import LATEX
from radartrack.derive.reading.tex.latex_arguments import AmbiguousArgument

ANGLES = [r"\beta", r"2\theta", r"\hat\phi", r"\theta_k", r"\frac{\theta}{2}"]

DEVIATIONS = [r"\sigma_r^2", r"\sigma_{\theta}", r"\sigma^2_r r"]


def readings(formula: str) -> list[str]:
    with pytest.raises(AmbiguousArgument) as caught:
        read_latex(formula, None)
    assert copy(caught.value).readings == caught.value.readings
    return [to_text(read_latex(one, None)) for one in caught.value.readings]


@pytest.mark.parametrize("function", ["sin", "cos", "tan", "cot"])
@pytest.mark.parametrize("angle", ANGLES)
def test_a_deviation_behind_an_angle_is_no_part_of_it(function: str, angle: str) -> None:
    for power, space, deviation in product(["", "^2 ", "^{2}"], [" ", r"\,", r"\;"], DEVIATIONS):
        bare = rf"a\{function}{power}{angle}{space}{deviation} + b\{function}{power}{angle}"
        bracketed = rf"a\{function}{power}({angle}){deviation} + b\{function}{power}({angle})"
        assert read_latex(bare, None) == read_latex(bracketed, None)


@pytest.mark.parametrize("formula", [r"\exp\lambda\sigma_r", r"\sin\sigma_r\sigma_\theta", r"\sin\theta r\sigma_r"])
def test_a_deviation_elsewhere_is_ambiguous(formula: str) -> None:
    assert len(readings(formula)) > 1


@pytest.mark.parametrize("power", ["", "^2"])
@pytest.mark.parametrize("angle", ANGLES)
@pytest.mark.parametrize("factors", [["c"], ["r", "c"], [r"\frac{1}{2}", "T", "v"], ["c^2"], ["a", "(t - s)"]])
def test_an_argument_may_end_behind_each_factor(power: str, angle: str, factors: list[str]) -> None:
    expected = []
    for count in range(len(factors) + 1):
        inside, outside = r"\,".join([angle, *factors[:count]]), " ".join(factors[count:])
        expected.append(to_text(read_latex(rf"b + \sin{power}({inside}){outside}", None)))
    assert readings(rf"b + \sin{power} {angle}\,{' '.join(factors)}") == expected


def test_what_is_alike_ends_alike_and_all_else_in_all_ways() -> None:
    assert readings(r"\cos\beta\, c - \frac{\sin\beta\, c}{2} + \alpha, \alpha = e^{\sin x y}") == [
        "cos(beta)*c - sin(beta)*c/2 + e**(sin(x)*y)",
        "cos(beta)*c - sin(beta)*c/2 + e**sin(x*y)",
        "cos(beta*c) - sin(beta*c)/2 + e**(sin(x)*y)",
        "cos(beta*c) - sin(beta*c)/2 + e**sin(x*y)",
    ]


def test_of_too_many_ways_none_is_told() -> None:
    assert readings(" + ".join(rf"\cos a_{n} b_{n}" for n in range(4))) == []


@pytest.mark.parametrize("formula", [r"\sin\theta^2 r", r"\cos 2\theta^{k} r"])
def test_whose_power_it_is_stays_open(formula: str) -> None:
    assert readings(formula) == []


def test_of_a_page_too_all_ways_are_told() -> None:
    trees = possible_trees("r cos θ c")
    assert [to_text(tree) for tree in trees] == ["r*cos(theta)*c", "r*cos(theta*c)"]


def test_what_can_be_read_in_no_way_is_refused() -> None:
    with pytest.raises(FormulaError, match="ambiguous"):
        possible_trees(r"\sin\theta 2 r", notation=LATEX)
