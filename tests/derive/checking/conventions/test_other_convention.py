"""A formula that differs may be right under a condition, in another convention, or in another order of its entries."""

import pytest

from radartrack.derive import check
from radartrack.derive import symbolic as sp
from radartrack.derive.catalogue import catalogue
from radartrack.derive.checking.reporting.derived_formula import shown
from radartrack.derive.checking.reporting.verdict import Outcome
from radartrack.derive.language.tensor import Tensor


def test_what_is_right_without_correlation_is_not_said_to_be_another_quantity_there() -> None:
    formula = "sin(beta)*cos(beta)*(sigma_r**2 - r**2*sigma_beta**2)"
    right = check("polar.covariance.linear[0,1]", formula)
    assert right.remarks == ("equal when rho = 0",)
    assert not any("this is" in suggestion.edit for suggestion in right.suggestions)
    other = check("polar.covariance.linear[0,0]", formula).suggestions[-1]
    assert other.formula == "polar.covariance.linear[0,1] when rho = 0"


@pytest.mark.parametrize(
    ("name", "formula", "remark"),
    [
        ("polar.map", "[r*sin(beta), r*cos(beta)]", "pi/2 - beta for beta"),
        (
            "spherical.map",
            "[r*sin(epsilon)*cos(beta), r*sin(epsilon)*sin(beta), r*cos(epsilon)]",
            "pi/2 - beta for beta and pi/2 - epsilon for epsilon",
        ),
        (
            "polar.covariance.linear[0,0]",
            "sigma_r**2*sin(beta)**2 + r**2*sigma_beta**2*cos(beta)**2",
            "pi/2 - beta for beta when rho = 0",
        ),
        (
            "polar.covariance.linear[0,0]",
            "sigma_r**2*sin(beta)**2 + r**2*sigma_beta**2*cos(beta)**2 + r*rho*sigma_r*sigma_beta*sin(2*beta)",
            "pi/2 - beta for beta and -rho for rho",
        ),
    ],
)
def test_an_angle_that_is_counted_from_the_other_axis_is_noticed(name: str, formula: str, remark: str) -> None:
    verdict = check(name, formula)
    assert verdict.verdict is Outcome.DIFFERS
    assert verdict.remarks == (f"equal with {remark}: counted from the other axis",)
    assert check(name, formula.replace("sin(beta)", "2*sin(beta)")).remarks == ()


@pytest.mark.parametrize(
    ("name", "formula", "remark"),
    [
        ("polar.jacobian", "[[cos(beta), sin(beta)], [-r*sin(beta), r*cos(beta)]]", "when transposed"),
        ("observe.polar.map", "[atan2(y, x), hypot(x, y)]", "with the entries in the order 1, 0"),
        (
            "motion.plane.transition",
            "[[1, 0, T, 0], [0, 1, 0, T], [0, 0, 1, 0], [0, 0, 0, 1]]",
            "with rows and columns in the order 0, 2, 1, 3",
        ),
        (
            "polar.jacobian",
            "[[-r*sin(beta), cos(beta)], [r*cos(beta), sin(beta)]]",
            "with the columns in the order 1, 0",
        ),
        (
            "polar_doppler.jacobian",
            "[[rdot, 0, r], [cos(beta), -r*sin(beta), 0], [sin(beta), r*cos(beta), 0]]",
            "with the rows in the order 2, 0, 1",
        ),
        ("polar.jacobian", "[[cos(beta), sin(beta)], [-r*sin(beta), 2*r*cos(beta)]]", ""),
    ],
)
def test_entries_in_another_order_are_noticed(name: str, formula: str, remark: str) -> None:
    assert check(name, formula).remarks == ((f"equal {remark}",) if remark else ())


@pytest.mark.parametrize(
    "formula",
    [
        "[sqrt(x^2 + y^2), 180/pi*atan2(x, y)]",
        "[sqrt(x^2 + y^2), atan(x/y)*180/pi]",
    ],
)
def test_what_is_returned_from_the_other_axis_and_in_degrees_is_both(formula: str) -> None:
    (remark,) = check("observe.polar.map", formula).remarks
    assert remark.startswith("equal with the azimuth from the y axis and what is returned in degrees")


def test_a_slip_beside_two_conventions_of_what_is_returned_is_told() -> None:
    verdict = check("observe.polar.map", "[sqrt(x^2 - y^2), 180/pi*atan2(x, y)]")
    assert "with the azimuth from the y axis and what is returned in degrees" in verdict.convention
    assert [one.edit.startswith("the sign of y**2") for one in verdict.suggestions] == [True]


@pytest.mark.parametrize("name", ["observe.polar_doppler.jacobian", "observe.spherical_doppler.jacobian"])
def test_rows_for_columns_are_read_transposed_where_that_can_be_seen(name: str) -> None:
    quantity = catalogue()[name]
    rows, columns = quantity.shape
    turned = Tensor.build((columns, rows), lambda i, j: quantity.expression[j, i])
    verdict = check(name, shown(turned))
    assert verdict.is_equal
    assert f"read transposed: it has shape [{columns}, {rows}], the quantity [{rows}, {columns}]" in verdict.remarks
    wrong = Tensor.build((columns, rows), lambda i, j: quantity.expression[j, i] * (-1 if (i, j) == (1, 0) else 1))
    verdict = check(name, shown(wrong))
    assert not verdict.is_equal
    assert {one.entry for one in verdict.suggestions} == {(0, 1)}


def test_a_convention_that_explains_everything_leaves_no_slip() -> None:
    verdict = check("observe.spherical.map[2]", "atan2(hypot(x, y), z)")
    assert verdict.reason == "not equal, but equal with the elevation from the vertical up to whole turns"


EQUAL_SENSORS = sorted(
    name
    for name, quantity in catalogue().items()
    if any(symbol.name.endswith("_2") or symbol.name.startswith("second_") for symbol in quantity.symbols)
    and name.startswith(("fusion.", "initiation."))
)


@pytest.mark.parametrize("name", EQUAL_SENSORS)
def test_one_letter_for_numbered_symbols_is_told_as_the_condition_that_they_are_equal(name: str) -> None:
    quantity = catalogue()[name]
    by_name = {symbol.name: symbol for symbol in quantity.symbols}
    pairs = [("sigma_1", "sigma_2"), ("sigma_1", "sigma_3"), ("second_covariance", "first_covariance")]
    same = {by_name[other]: by_name[one] for one, other in pairs if one in by_name and other in by_name}
    if not same:
        return
    entries = quantity.expression.map(lambda entry: sp.cancel(entry.subs(same)))
    if all(entry == right for entry, right in zip(entries, quantity.expression, strict=True)):
        return
    verdict = check(name, shown(entries))
    assert verdict.verdict == "differs"
    assert "equal when" in verdict.reason, verdict.reason
    assert not verdict.suggestions


@pytest.mark.parametrize(
    ("name", "formula", "where"),
    [
        ("line.distance", "abs(m*x - y + b)/sqrt(1 + m^2)", "where d + k*x - y < 0"),
        ("observe.polar_doppler.map[2]", "abs(x*vx + y*vy)/sqrt(x^2 + y^2)", "where vx*x + vy*y > 0"),
        ("polar.map[0]", "r*cos(atan(tan(beta)))", "where cos(beta) > 0"),
        ("polar.map[1]", "r*sin(atan(sin(beta)/cos(beta)))", "where cos(beta) > 0"),
        (
            "observe.polar.jacobian",
            "[[cos(atan(y/x)), sin(atan(y/x))], [-sin(atan(y/x))/d, cos(atan(y/x))/d]]",
            "where x > 0",
        ),
    ],
)
def test_a_magnitude_is_right_where_what_is_in_it_has_that_sign(name: str, formula: str, where: str) -> None:
    let = {"d": "sqrt(x^2 + y^2)"} if "/d" in formula else None
    assert check(name, formula, let=let).remarks == (f"equal {where}",)
    assert not any(one.startswith("equal") for one in check(name, f"2*{formula}", let=let).remarks)


GAINS = [name for name in catalogue() if name.startswith(("fading_memory.", "steady_state.")) and "_gamma" not in name]


@pytest.mark.parametrize("name", GAINS)
def test_gains_may_be_divided_by_the_period_and_covariances_be_of_one_measurement(name: str) -> None:
    quantity = catalogue()[name]
    if quantity.shape[0] == 1 or "T" in {symbol.name for symbol in quantity.symbols}:
        return
    period, sigma = sp.Symbol("T"), sp.Symbol("sigma")
    words = "equal with gains divided by 1, T, T**2, ..."

    def printed(*index: int) -> sp.Expr:
        return quantity.expression[index] / period ** sum(index)

    def measured(*index: int) -> sp.Expr:
        return sigma**2 * printed(*index)

    found = check(name, shown(Tensor.build(quantity.shape, printed)))
    assert found.remarks == (words,)
    assert found.suggestions == ()
    if quantity.is_covariance:
        assert check(name, shown(Tensor.build(quantity.shape, measured))).remarks == (
            f"{words} and sigma_r**2 as a factor",
        )


NORTH = "[-sin(lat)*cos(lon), -sin(lat)*sin(lon), cos(lat)]"
EAST = "[-sin(lon), cos(lon), 0]"
DOWN = "[-cos(lat)*cos(lon), -cos(lat)*sin(lon), -sin(lat)]"


@pytest.mark.parametrize(
    ("name", "formula", "words"),
    [
        ("frames.enu_from_ecef.jacobian", f"[{EAST}, {NORTH}, {DOWN}]", "with z downwards"),
        ("frames.enu_from_ecef.jacobian", f"[{NORTH}, {EAST}, {DOWN}]", "rows in the order 1, 0, 2 with z downwards"),
        ("spherical.map", "[r*cos(el)*sin(az), r*cos(el)*cos(az), -r*sin(el)]", "with z downwards"),
        (
            "spherical.jacobian",
            "[c*cos(az), -r*c*sin(az), -r*s*cos(az); c*sin(az), r*c*cos(az), -r*s*sin(az); -s, 0, -r*c]",
            "with pi/2 - beta for beta and z downwards: counted from the other axis",
        ),
        (
            "observe.spherical.map",
            "[sqrt(x^2+y^2+z^2), atan2(y, x), atan2(-z, sqrt(x^2+y^2))]",
            "with the azimuth from the x axis and z downwards",
        ),
        (
            "observe.spherical.jacobian",
            "[[x/r, y/r, z/r], [y/d^2, -x/d^2, 0], [x*z/(r^2*d), y*z/(r^2*d), -d/r^2]]",
            "with z downwards",
        ),
    ],
)
def test_a_third_axis_may_point_down(name: str, formula: str, words: str) -> None:
    verdict = check(name, formula, let={"c": "cos(el)", "s": "sin(el)"} if "c*cos" in formula else None)
    assert verdict.verdict is Outcome.DIFFERS
    assert "but equal with" in verdict.reason
    assert words in verdict.reason
    assert verdict.suggestions == ()


@pytest.mark.parametrize("name", ["spherical.covariance.linear", "spherical_doppler.covariance.linear"])
def test_covariances_with_what_points_down_change_their_sign(name: str) -> None:
    derived = catalogue()[name].expression
    turned = Tensor.build(derived.shape, lambda i, j: derived[i, j] * (-1) ** ((i == 2) + (j == 2)))
    verdict = check(name, shown(turned))
    assert verdict.convention == "with z downwards"
    assert check("spherical.map[2]", "-r*sin(el)").suggestions[0].formula == "r*sin(el)"


COMPASS = "pi/2 - heading for heading and -omega for omega: headings counted from the y axis, clockwise"
NORTH = "[x + v/w*(cos(h) - cos(h + w*T)), y + v/w*(sin(h + w*T) - sin(h)), v, h + w*T, w]"


def test_a_heading_of_the_state_may_be_one_of_a_compass() -> None:
    verdict = check("motion.ctrv.map", NORTH)
    assert (verdict.verdict, verdict.suggestions) == (Outcome.DIFFERS, ())
    assert f"but equal with {COMPASS}" in verdict.reason
    wrong = check("motion.ctrv.map", NORTH.replace("- sin(h)", "+ sin(h)"))
    assert (wrong.convention, wrong.suggestions[0].entry) == (f"with {COMPASS}", (1,))


def test_derivatives_by_the_heading_of_a_compass_are_told_too() -> None:
    verdict = check("motion.ctrv.jacobian", f"jacobian({NORTH}, [x, y, v, h, w])")
    assert f"but equal with {COMPASS}" in verdict.reason


@pytest.mark.parametrize(
    ("name", "formula", "words"),
    [
        (
            "fusion.variance.two",
            "s_1*s_2/sqrt(s_1^2 + s_2^2)",
            "with its root: the deviation of what is a variance here",
        ),
        ("fusion.variance.two", "1/s_1^2 + 1/s_2^2", "with its inverse: the information of what is a variance here"),
        ("finite_sample.degree1.range.covariance[1, 1]", "sigma_r/T*sqrt(12/(k*(k^2 - 1)))", "with its root"),
        ("line.position_std", "(sigma_x^2 + sigma_y^2)/2", "with its square: the variance of what is a deviation"),
    ],
)
def test_a_deviation_for_a_variance_is_told_as_that(name: str, formula: str, words: str) -> None:
    verdict = check(name, formula)
    assert verdict.verdict is Outcome.WRONG_DIMENSIONS
    assert f"but equal {words}" in verdict.reason


def test_a_slip_in_a_deviation_for_a_variance_is_told_in_it() -> None:
    verdict = check("fusion.variance.two", "s_1*s_2/sqrt(s_1^2 - s_2^2)")
    assert verdict.suggestions[0].formula == "s_1*s_2/sqrt(s_1**2 + s_2**2)"
