"""Each convention alone explains a print, and with one slip in it the convention is told first, then the slip."""

from __future__ import annotations

import os
from collections.abc import Iterator
from itertools import islice
from random import Random

import pytest

from radartrack.derive import check
from radartrack.derive import symbolic as sp
from radartrack.derive.catalogue import catalogue
from radartrack.derive.checking.question.compared_quantity import refer
from radartrack.derive.checking.question.printed_formula import names_for
from radartrack.derive.checking.reporting.derived_formula import shown
from radartrack.derive.checking.reporting.verdict import Outcome, Verdict
from radartrack.derive.formula.printing import to_text
from radartrack.derive.formula.tree import Tree
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.tensor import Index, Tensor, indices
from radartrack.derive.reading.text import read_text
from radartrack.derive.symbolic import Expr
from radartrack.derive.units import RADIAN
from tests.derive.checking.repairing.mutants import mutants

THOROUGH = int(os.environ.get("RADARTRACK_MUTANTS", "2")) >= 100
LONG = 8_000 if THOROUGH else 500  # characters of a whole tensor
SHARE = 0.9
WRONG = {Outcome.DIFFERS, Outcome.WRONG_DIMENSIONS}


def _in_other_conventions(quantity: Quantity) -> Iterator[tuple[str, Tensor[Expr]]]:
    """What would be printed in each convention that makes a difference, with words that tell it."""
    derived, symbols = quantity.expression, quantity.symbols
    found = [
        ("in degrees", _changed(derived, {s: s * sp.pi / 180 for s in symbols if s.is_angle})),
        ("**2 for sigma", _changed(derived, {s: sp.sqrt(s) for s in symbols if s.name.startswith("sigma_")})),
        (" = 0", _changed(derived, {s: sp.Integer(0) for s in symbols if s.is_correlation})),
        *_turned(quantity),
        *_reordered(derived),
    ]
    yield from ((words, printed) for words, printed in found if printed.entries != derived.entries)


def _changed(derived: Tensor[Expr], changes: dict[Expr, Expr]) -> Tensor[Expr]:
    return derived.map(lambda entry: entry.xreplace(changes))


def _turned(quantity: Quantity) -> Iterator[tuple[str, Tensor[Expr]]]:
    """With the first angle counted from the other axis: derivatives by it have the other sign."""
    angles = [symbol for symbol in quantity.symbols if symbol.is_angle and not symbol.name.startswith("predicted")]
    if not angles or any(symbol.name.startswith("predicted") for symbol in quantity.symbols):
        return
    places = [axis.index(RADIAN**-1) if RADIAN**-1 in axis else None for axis in quantity.axes]

    def printed(*index: int) -> Expr:
        count = sum(place == i for place, i in zip(places, index, strict=True))
        return (-1) ** count * quantity.expression[index].xreplace({angles[0]: sp.pi / 2 - angles[0]})

    yield "counted from the other axis", Tensor.build(quantity.shape, printed)


def _reordered(derived: Tensor[Expr]) -> Iterator[tuple[str, Tensor[Expr]]]:
    shape = derived.shape
    if len(shape) != 2 or max(shape) > 4:
        return
    rows, columns = shape
    if rows == columns:
        yield "transposed", Tensor.build(shape, lambda i, j: derived[j, i])
    yield "in the order", Tensor.build(shape, lambda i, j: derived[(i + 1) % rows, j])
    yield "in the order", Tensor.build(shape, lambda i, j: derived[i, (j + 1) % columns])


def _cases() -> list[str]:
    """Quantities of several entries that are not too long."""
    names = [name for name, one in catalogue().items() if one.shape and len(list(indices(one.shape))) > 2]
    return sorted(names)[:: 1 if THOROUGH else 11]


def _text(printed: Tensor[Expr]) -> str:
    return shown(printed)


@pytest.mark.parametrize("name", _cases())
def test_a_convention_alone_explains_everything_and_nothing_is_edited_beside_it(name: str) -> None:
    quantity = catalogue()[name]
    for words, printed in _in_other_conventions(quantity):
        if len(_text(printed)) > LONG:
            continue
        verdict = check(name, _text(printed))
        assert verdict.verdict in {*WRONG, Outcome.EQUAL}, (name, words)
        if verdict.verdict in WRONG:
            assert any(remark.startswith("equal ") for remark in verdict.remarks), (name, words, verdict.reason)
            assert all(one.edit.startswith("this is") for one in verdict.suggestions), (name, words)


def _slips() -> Iterator[tuple[str, str, Index, Tree, str]]:
    """One slip in one entry of a print in another convention: the name, the print, where, what was there, words."""
    for name in _cases():
        quantity = catalogue()[name]
        kinds = names_for(refer(name), {}).dimensions
        for words, printed in _in_other_conventions(quantity):
            random = Random(f"{name} {words}")
            long = len(_text(printed)) > LONG
            places = [index for index, entry in printed.items() if entry.free_symbols]
            if long or len(places) < 3 or len(set(printed.entries)) < 3:
                continue
            index = random.choice(places)
            tree = read_text(shown(Tensor((), (printed[index],))), kinds)
            (slip,) = mutants(tree, kinds, 1, random)
            texts = {place: shown(Tensor((), (entry,))) for place, entry in printed.items()} | {index: to_text(slip)}
            yield name, _nested(quantity.shape, texts), index, tree, words


def _nested(shape: Index, texts: dict[Index, str], at: Index = ()) -> str:
    if len(at) == len(shape):
        return texts[at]
    return "[" + ", ".join(_nested(shape, texts, (*at, i)) for i in range(shape[len(at)])) + "]"


def _is_told(verdict: Verdict, name: str, index: Index, right: Tree) -> bool:
    """Whether the right formula of the entry is suggested, in whatever form that is the same expression."""
    names = names_for(refer(name), {})
    wanted = names.read(right)
    return any(
        one.entry == index and sp.expand(names.read(read_text(one.formula, names.values)) - wanted) == 0
        for one in verdict.suggestions
        if not one.edit.startswith("this is")
    )


def test_with_one_slip_the_convention_is_told_first_and_then_the_slip() -> None:
    told = []
    for name, printed, index, right, words in islice(_slips(), None if THOROUGH else 20):
        verdict = check(name, printed)
        assert verdict.verdict in WRONG, (name, words)
        found = _is_told(verdict, name, index, right)
        told.append(found)
        if not found:
            print(name, words, index, to_text(right), verdict.reason, printed)
    assert sum(told) >= SHARE * len(told), f"{sum(told)} of {len(told)}"


CLOCKWISE = (
    "[[1, sin(w*T)/w, 0, (1-cos(w*T))/w], [0, cos(w*T), 0, sin(w*T)], [0, -(1-cos(w*T))/w, 1, sin(w*T)/w], "
    "[0, -sin(w*T), 0, cos(w*T)]]"
)


@pytest.mark.parametrize(
    ("name", "formula", "convention"),
    [
        (
            "observe.polar.jacobian",
            "[[x/sqrt(x^2+y^2), y/sqrt(x^2+y^2)], [y/(x^2+y^2), -x/(x^2+y^2)]]",
            "with the azimuth from the y axis",
        ),
        (
            "observe.spherical.map",
            "[sqrt(x^2+y^2+z^2), atan2(y, x), asin(z/sqrt(x^2+y^2+z^2))]",
            "with the azimuth from the x axis up to whole turns",
        ),
        ("observe.polar.map", "[hypot(x, y), atan(y/x)]", "where x > 0"),
        ("observe.polar.map", "[hypot(x, y), atan(x/y)]", "with the azimuth from the y axis where y > 0"),
        ("observe.polar.map", "[hypot(x, y), atan2(y, x)*180/pi]", "with what is returned in degrees"),
        ("observe.polar.map", "[hypot(x, y), asin(y/hypot(x, y))]", "where x > 0"),
        ("observe.spherical.map[2]", "acos(hypot(x, y)/sqrt(x^2+y^2+z^2))", "where z > 0"),
        (
            "motion.turn.known_rate.transition",
            CLOCKWISE,
            "with -omega for omega: counted the other way",
        ),
        ("polar.map[0]", "r*cos(pi*az/180)", "with beta in degrees"),
        ("polar.bias.truth[1]", "r*sin(beta)*(exp(-sigma_beta^2/2) - 1)", "when rho = 0"),
        (
            "polar.covariance.linear[0,0]",
            "var_r*cos(beta)^2 + r^2*sigma_beta*sin(beta)^2",
            "with sigma_beta**2 for sigma_beta when rho = 0: the variance of what is a deviation here",
        ),
    ],
)
def test_the_convention_is_said_in_the_words_of_the_field(name: str, formula: str, convention: str) -> None:
    verdict = check(name, formula)
    assert verdict.verdict in WRONG
    assert verdict.remarks == (f"equal {convention}",)


@pytest.mark.parametrize("formula", ["asin(z/sqrt(x^2+y^2+z^2))", "atan(z/sqrt(x^2+y^2))", "atan2(z, hypot(x, y))"])
def test_an_elevation_is_proved_by_whatever_inverse_function(formula: str) -> None:
    assert check("observe.spherical.map[2]", formula).verdict is Outcome.EQUAL


def test_an_inverse_function_with_another_range_is_not_proved() -> None:
    formula = "acos(sqrt(x^2+y^2)/sqrt(x^2+y^2+z^2))"
    verdict = check("observe.spherical.map[2]", formula)
    assert verdict.verdict is Outcome.DIFFERS
    assert verdict.remarks == ("equal where z > 0",)  # below the radar it has the other sign


@pytest.mark.parametrize(
    ("formula", "left_out"),
    [
        ("[[x/d, y/d, 0, 0], [-y/d^2, x/d^2, 0, 0]]", "columns 2, 3"),
        ("[[x/d, 0, y/d, 0], [-y/d^2, 0, x/d^2, 0]]", "columns 1, 3"),
        ("[[x/d, y/d], [-y/d^2, x/d^2], [0, 0]]", "row 2"),
    ],
)
def test_rows_and_columns_of_zeros_are_left_out_and_told(formula: str, left_out: str) -> None:
    let = {"d": "sqrt(x^2 + y^2)"}
    verdict = check("observe.polar.jacobian", formula, let=let)
    assert verdict.verdict is Outcome.EQUAL
    assert verdict.remarks[0].startswith(f"without {left_out}, which")
    slip = check("observe.polar.jacobian", formula.replace("-y", "y"), let=let)
    assert slip.verdict is Outcome.DIFFERS
    assert any(one.entry == (1, 0) for one in slip.suggestions)


@pytest.mark.parametrize(
    ("name", "formula"),
    [
        ("polar.bias.second_order[0]", "r*cos(beta)*sigma_beta^2/2"),
        ("polar.jacobian[1,1]", "r*sin(beta)"),
        ("observe.polar_doppler.jacobian[2,0]", "y*(y*vx - x*vy)/(x^2 + y^2)"),
    ],
)
def test_the_shortest_edit_of_a_place_is_told_alone(name: str, formula: str) -> None:
    edits = [one.edit for one in check(name, formula, given={"rho": "0"} if "bias" in name else None).suggestions]
    assert sum("the sign of" in edit for edit in edits) <= 1, edits
    assert not any("everywhere" in edit for edit in edits), edits
