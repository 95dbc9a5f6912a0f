"""A formula of the catalogue is found whatever its letters are, and what is none is not."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from radartrack.derive.catalogue import catalogue
from radartrack.derive.finding.formula_search import Candidate, FormulaSearch
from radartrack.derive.finding.screening_values import row
from radartrack.derive.finding.usual_letters import usual_forms
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.fold import rebuild
from radartrack.derive.formula.from_expression import to_tree
from radartrack.derive.formula.printing import to_text
from radartrack.derive.formula.tree import Name, Product, Quotient, Tree
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.reading.any_letters import read_loosely
from radartrack.derive.reading.notation import LATEX, TEXT

VALUES = json.loads((Path(__file__).parents[3] / "generated" / "screening.json").read_text())
QUICK = ("polar.", "observe.polar", "observe.spherical.map", "motion.constant", "spherical.jacobian")
ENTRIES = [
    (quantity, index)
    for quantity in catalogue().values()
    if quantity.name.startswith(QUICK) and "semidefinite" not in quantity.name and "validity" not in quantity.name
    for index, _ in zip(range(1000), VALUES[quantity.name]["values"], strict=False)
]
OTHERS = {  # what people write, by what the symbol is called here
    "r": ("R", "rng", "d", "rho", "range"),
    "beta": ("theta", "az", "phi", "b", "bearing"),
    "epsilon": ("el", "elevation", "eps"),
    "sigma_r": ("s_r", "sigma_R", "std_range", "sr"),
    "sigma_beta": ("s_theta", "sigma_az", "sigma_phi", "std_b"),
    "T": ("dt", "Delta_t", "h", "tau"),
    "x": ("east", "px", "E"),
    "y": ("north", "py", "N"),
    "vx": ("v_x", "xdot"),
    "vy": ("v_y", "ydot"),
    "q": ("S", "q_c", "Phi"),
    "k": ("n", "N", "m"),
}

KINDS = {"theta_m": {"angle"}, "beta": {"angle"}, "T": {"s"}, "tau": {"s"}}  # of letters with a meaning


@cache
def search() -> FormulaSearch:
    return FormulaSearch(VALUES)


def spelled(tree: Tree, letters: dict[str, str]) -> str:
    return to_text(
        rebuild(tree, lambda node: Name(letters.get(node.name, node.name)) if isinstance(node, Name) else node)
    )


@settings(max_examples=25)
@given(st.sampled_from(ENTRIES), st.data())
def test_every_entry_is_found_in_other_letters(entry: tuple[Quantity, int], data: st.DataObject) -> None:
    quantity, place = entry
    expression = quantity.expression.entries[place]
    if not expression.free_symbols or len(text := to_text(to_tree(expression))) > 400:
        return
    names = sorted(symbol.name for symbol in expression.free_symbols)
    letters = {name: data.draw(st.sampled_from(OTHERS[name])) for name in names if name in OTHERS}
    letters = {old: new for old, new in letters.items() if new not in names and list(letters.values()).count(new) == 1}
    tree = read_loosely(spelled(read_loosely(text), letters))
    found = search().candidates(tree)
    assert any(VALUES_OF[one.quantity] == VALUES_OF[_name(quantity, place)] for one in found if not one.given), letters


def _name(quantity: Quantity, place: int) -> str:
    index: list[str] = []
    for size in reversed(quantity.shape):
        place, last = divmod(place, size)
        index.insert(0, str(last))
    return quantity.name + (f"[{','.join(index)}]" if index else "")


def _flat() -> dict[str, tuple[float, ...]]:
    found = {}
    for name, data in VALUES.items():
        quantity = catalogue()[name]
        found[name] = tuple(data["values"][0])
        found |= {_name(quantity, place): tuple(value) for place, value in enumerate(data["values"])}
    return found


VALUES_OF = _flat()


@pytest.mark.parametrize(
    ("formula", "latex", "quantity", "given"),
    [
        ("(rho*s_th*cos(th))^2 + (s_rho*sin(th))^2", False, "polar.covariance.linear[1,1]", {"rho": "0"}),
        ("[sqrt(e^2+n^2+u^2), atan2(e,n), atan(u/sqrt(e^2+n^2))]", False, "observe.spherical.map", {}),
        ("[[q*dt^3/3, q*dt^2/2], [q*dt^2/2, q*dt]]", False, "constant_velocity.process_noise", {}),
        ("[R*cos(theta), R*sin(theta)]", False, "polar.map", {}),
        (r"\rho\sin\theta", True, "polar.map[1]", {}),
        ("R*exp(-s_theta^2/2)*cos(theta) - R*cos(theta)", False, "polar.bias.truth[0]", {"rho": "0"}),
    ],
)
def test_formulas_as_people_write_them_are_found(
    formula: str, latex: bool, quantity: str, given: dict[str, str]
) -> None:
    found = search().candidates(read_loosely(formula, notation=LATEX if latex else TEXT))
    assert any(quantity in one.quantity and one.given == given and not one.convention for one in found)


@pytest.mark.parametrize(
    ("formula", "quantity", "convention"),
    [
        ("[r*sin(az), r*cos(az)]", "polar.map", "counted from the other axis"),
        ("r*cos(pi*az/180)", "polar.map[0]", "in degrees"),
        ("[[sin(b), r*cos(b)], [cos(b), -r*sin(b)]]", "polar.jacobian", ""),
    ],
)
def test_another_convention_is_said(formula: str, quantity: str, convention: str) -> None:
    found = search().candidates(read_loosely(formula))
    assert [one for one in found if one.quantity == quantity and convention in one.convention] or not convention


@pytest.mark.parametrize(
    ("formula", "quantity"),
    [
        ("r*cos(b)*(1 - exp(-s^2/2))", "-polar.bias.truth[0]"),
        ("P1*P2/(P1 + P2)", "fusion.variance.two"),
        ("[[dt^4/4, dt^3/2], [dt^3/2, dt^2]]*s^2", "motion.constant_velocity.process_noise.piecewise"),
        ("[[cos(b), sin(b)], [-a*sin(b), a*cos(b)]]", "polar.jacobian"),
        ("[[1, 0, T, 0], [0, 1, 0, T], [0, 0, 1, 0], [0, 0, 0, 1]]", "motion.plane.transition"),
        ("[sqrt(x^2 + y^2), atan2(x, y)]", "observe.polar.map"),
        ("[[x/sqrt(x^2+y^2), 0, y/sqrt(x^2+y^2), 0], [y/(x^2+y^2), 0, -x/(x^2+y^2), 0]]", "observe.polar.jacobian"),
        (
            "[[cos(b), -r*sin(b)], [sin(b), r*cos(b)]]*diag(s_r^2, s_b^2)*[[cos(b), sin(b)], [-r*sin(b), r*cos(b)]]",
            "polar.covariance.linear",
        ),
    ],
)
def test_other_signs_orders_and_products_are_candidates_too(formula: str, quantity: str) -> None:
    assert quantity in {one.quantity for one in search().candidates(read_loosely(formula))}


@pytest.mark.parametrize("formula", ["exp(-T/tau)", "exp(-dt/tau)", "e^(-h/tau_m)"])
def test_a_time_constant_is_the_inverse_of_a_rate(formula: str) -> None:
    found = {one.quantity: one.read for one in search().candidates(read_loosely(formula))}
    assert "1/alpha" in found["motion.singer.transition[2,2]"].values()


@pytest.mark.parametrize(
    "formula", ["r_m*cos(theta_m)/lambda_theta", "exp(-(T/tau)^3)", "(1 - beta)^2", "a/sqrt(1 - e^2*sin(lat)^2)"]
)
def test_what_is_near_has_letters_that_can_mean_its_symbols(formula: str) -> None:
    for one in search().near(read_loosely(formula)):
        kinds = {name: kind for row in [VALUES[one.quantity.split("[")[0]]] for name, kind in row["kinds"].items()}
        assert all(kinds[one.read.get(name, name)] in kind for name, kind in KINDS.items() if name in one.read)


@pytest.mark.parametrize("slip", ["-R*cos(theta)*s_theta^2/3", "-R*cos(theta)*s_theta^2/1.9", "1.1*R*cos(theta)"])
def test_a_slip_is_near_and_never_found(slip: str) -> None:
    tree = read_loosely(slip)
    assert search().candidates(tree) == []
    near: list[Candidate] = search().near(tree)
    assert near
    assert all(0 < one.difference < 0.5 for one in near)


@pytest.mark.parametrize(
    ("slip", "quantity", "right"),
    [
        (
            "y*(vx*y + vy*x)/(x^2 + y^2)^(3/2)",
            "observe.polar_doppler.jacobian[2,0]",
            "y*(vx*y - vy*x)/(x**2 + y**2)**(3/2)",
        ),
        ("R*cos(theta)*exp(s_theta^2)", "polar.unbiased.estimate[0]", "r*cos(beta)*exp(sigma_beta**2/2)"),
    ],
)
def test_a_slip_is_undone_and_never_found(slip: str, quantity: str, right: str) -> None:
    tree = read_loosely(slip)
    assert search().candidates(tree) == []
    assert (quantity, right) in {(one.quantity, one.formula) for one in search().slipped(tree) if one.slip}


QUOTIENTS = {
    to_text(tree): tree
    for quantity, place in ENTRIES
    if isinstance(tree := to_tree(quantity.expression.entries[place]), Quotient) and len(to_text(tree)) < 60
}


@pytest.mark.parametrize("printed", sorted(QUOTIENTS))
def test_what_is_above_and_should_be_below_is_told(printed: str) -> None:
    tree = QUOTIENTS[printed]
    slip = Product((tree.numerator, tree.denominator))
    assert search().candidates(slip) == []
    wanted = {one.quantity for one in search().candidates(tree)}
    assert any(one.quantity in wanted for one in search().slipped(slip))


@pytest.mark.parametrize(
    ("formula", "quantity"),
    [
        ("[[x/r, y/r], [-y/r^2, x/r^2]]", "observe.polar.jacobian"),
        ("(N*(1 - e^2) + h)*sin(phi)", "frames.ecef_from_geodetic.map[2]"),
        ("-r*u/w", "ruv.jacobian[2,1]"),
        ("dt^3/3", "motion.constant_velocity.process_noise.continuous[0,0]"),
        ("2*(2*n + 1)/((n + 1)*(n + 2))", "finite_sample.degree1.range.covariance[0,0]"),
        ("12/(k*(k^2 - 1))", "finite_sample.degree1.range.covariance[1,1]"),
        ("6/(N*(N + 1))", "finite_sample.degree1.range.covariance[0,1]"),
        ("[1 - theta^2, (1 - theta)^2/dt]", "fading_memory.degree1"),
        ("2*(2 - alpha) - 4*sqrt(1 - alpha)", "steady_state.alpha_beta.gain[1]"),
    ],
)
def test_letters_that_are_functions_and_factors_that_are_understood_are_put_in(formula: str, quantity: str) -> None:
    forms = usual_forms(read_loosely(formula))
    assert any(
        quantity in {one.quantity for one in search().among(form.family).candidates(form.tree)} for form in forms
    )


@pytest.mark.parametrize("nothing", ["a*b", "A*B*C", "b*c + d", "a/c"])
def test_letters_without_a_meaning_are_nothing_with_a_factor_beside_them(nothing: str) -> None:
    assert not [form for form in usual_forms(read_loosely(nothing)) if search().candidates(form.tree)]


@pytest.mark.parametrize(
    "nothing",
    [
        "7",
        "a*b + c*d + f*g",
        "9**60*x**60*9**60*9**60*9**60*9**60*9**60",
        "log(x - x)",
        "sum(j, j, 1, k)",
        "[[a], [b]]",
    ],
)
def test_what_is_no_quantity_is_not_found(nothing: str) -> None:
    assert search().candidates(read_loosely(nothing)) == []


@pytest.mark.parametrize("broken", ["r*cos(", "", "[1, [2, 3]]", r"\frac{1}{"])
def test_what_cannot_be_read_is_refused(broken: str) -> None:
    with pytest.raises(FormulaError):
        read_loosely(broken, notation=LATEX if "\\" in broken else TEXT)


@pytest.mark.parametrize("name", ["polar.covariance.linear", "motion.constant_velocity.process_noise.continuous"])
def test_values_are_what_anyone_computes_from_the_formula(name: str) -> None:
    quantity = catalogue()[name]
    data = row(quantity)
    for number in range(3):
        point = {symbol: data["symbols"][symbol.name][number] for symbol in quantity.symbols}
        for entry, values in zip(quantity.expression, data["values"], strict=True):
            assert values[number] == pytest.approx(float(entry.subs(point)), rel=1e-9, abs=1e-300)


@pytest.mark.parametrize("formula", ["a*b + c", "F*x_k + w_k", "a + b*(c + f)", "-a*b - c"])
def test_sums_and_products_of_letters_without_a_meaning_are_nothing(formula: str) -> None:
    assert search().candidates(read_loosely(formula)) == []
    assert search().near(read_loosely(formula)) == []


def test_the_plainest_quantity_comes_first_be_it_under_a_condition() -> None:
    found = search().candidates(read_loosely("r^2*s_theta^2*sin(theta)^2 + s_r^2*cos(theta)^2"))
    assert [one.quantity for one in found[:2]] == [
        "polar.covariance.linear[0,0]",
        "polar_doppler.covariance.linear[0,0]",
    ]
    assert found[0].given == {"rho": "0"}


@pytest.mark.parametrize("formula", ["a*b", "a*b^2", "g^2/h", "r^2*sigma_theta^2*q", "w*R1 + (1 - w)*R2"])
def test_letters_without_a_meaning_are_near_nothing(formula: str) -> None:
    tree = read_loosely(formula)
    assert not search().candidates(tree)
    assert not search().slipped(tree)
    assert not search().near(tree)


@pytest.mark.parametrize("axes", [2, 3])
@pytest.mark.parametrize("by_axis", [True, False])
def test_a_matrix_with_the_same_block_for_each_axis_is_found_by_the_block(axes: int, by_axis: bool) -> None:
    block = [["h**4/4", "h**3/2", "h**2/2"], ["h**3/2", "h**2", "h"], ["h**2/2", "h", "1"]]
    rows = [["0"] * (3 * axes) for _ in range(3 * axes)]
    for axis in range(axes):
        for i in range(3):
            for j in range(3):
                place = (3 * axis + i, 3 * axis + j) if by_axis else (axes * i + axis, axes * j + axis)
                rows[place[0]][place[1]] = f"{block[i][j]}*s**2"
    tree = read_loosely(str(rows).replace("'", ""))
    best, *_ = search().candidates(tree)
    assert best.quantity == "motion.constant_acceleration.process_noise.wiener_sequence"
    assert best.convention == f"for each of {axes} axes"
    rows[0][0] = "h**4/3*s**2"
    assert not search().candidates(read_loosely(str(rows).replace("'", "")))
