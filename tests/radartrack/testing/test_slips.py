"""Slips of real code are told where they were made: in J and K, under roots, in half planes, beside a convention."""

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from radartrack.derive.catalogue import find
from radartrack.derive.checking.repairing.edit_in_words import edit_in_words
from radartrack.derive.reading.text import read_text
from radartrack.testing import CannotDiagnose, diagnose
from radartrack.testing.examination import Examination
from radartrack.testing.function_conventions import AS_ASKED
from radartrack.testing.value_tables import tabulated
from radartrack.testing.wanted import wanted_by
from radartrack.verification.subject import generated
from tests.radartrack.testing.black_boxes import named
from tests.radartrack.testing.test_value_tables import filled

Matrix = Any
CORRELATED = {"polar": 1, "spherical": 1, "polar_doppler": 0, "ruv": 1}  # model → a coordinate with a correlation


def product(name: str, errors: Callable[[Matrix], None], jacobian: Callable[[Matrix], None] = lambda _: None) -> Any:
    """The linear covariance of a conversion, computed as J K Jᵀ from matrices that are changed first."""
    quantity, derivative = find(f"{name}.covariance.linear"), find(f"{name}.jacobian")
    model = quantity.model
    assert model is not None
    names = [symbol.name for symbol in quantity.symbols]

    def converted(*values: float) -> Any:
        at = dict(zip(names, values, strict=True))
        J = np.array(generated(derivative)(**{symbol.name: at[symbol.name] for symbol in derivative.symbols}))
        deviations = [at[sigma.name] for sigma in model.deviations]
        K = np.diag(np.square(deviations))
        for pair, rho in model.correlations.items():
            i, j = map(model.measured.index, pair)
            K[i, j] = K[j, i] = at[rho.name] * deviations[i] * deviations[j]
        errors(K)
        jacobian(J)
        return J @ K @ J.T

    return named(converted, names)


def root(index: tuple[int, int]) -> Callable[[Matrix], None]:
    def change(K: Matrix) -> None:
        K[index] = math.sqrt(K[index])

    return change


def nothing(index: tuple[int, int]) -> Callable[[Matrix], None]:
    def change(K: Matrix) -> None:
        K[index] = 0

    return change


def exchange(K: Matrix) -> None:
    K[0, 0], K[1, 1] = K[1, 1], K[0, 0]


@pytest.mark.parametrize("name", CORRELATED)
def test_a_slip_in_the_covariance_of_the_errors_is_told_there(name: str) -> None:
    place = CORRELATED[name]
    not_squared = str(diagnose(product(name, root((place, place))), f"{name}.covariance.linear"))
    assert f"K's entry [{place}, {place}]: the power 2 is 1" in not_squared
    exchanged = str(diagnose(product(name, exchange), f"{name}.covariance.linear"))
    assert "K's entries [0, 0] and [1, 1]: exchanged" in exchanged


@pytest.mark.parametrize(("name", "index"), [("polar", (1, 0)), ("spherical", (0, 1)), ("polar_doppler", (2, 0))])
def test_a_correlation_on_one_side_alone_is_told(name: str, index: tuple[int, int]) -> None:
    found = diagnose(product(name, nothing(index)), f"{name}.covariance.linear")
    assert f"K's entry [{index[0]}, {index[1]}]: 0 for " in found.slip, str(found)


def test_slips_in_two_rows_of_a_jacobian_are_told() -> None:
    def change(J: Matrix) -> None:
        J[0, 2] *= -1
        J[2, 2] = math.sqrt(abs(J[2, 2]) * 0) + 1

    found = diagnose(product("spherical", lambda _: None, change), "spherical.covariance.linear")
    assert "the Jacobian's entry [0, 2]: the sign of" in found.slip, str(found)
    assert "the Jacobian's entry [2, 2]: 1 for r*cos(epsilon)" in found.slip, str(found)


@pytest.mark.parametrize("spelled", ["r", ".7g", ".5g", ".6f"])
@pytest.mark.parametrize(
    ("errors", "sign", "words"),
    [
        (lambda _: None, -1, "the Jacobian's entry [0, 1]: the sign of r*sin(beta)"),
        (nothing((0, 1)), 1, "K's entry [0, 1]: 0 for rho*sigma_beta*sigma_r"),
        (exchange, 1, "K's entries [0, 0] and [1, 1]: exchanged"),
    ],
    ids=["J", "K", "exchanged"],
)
def test_slips_in_a_product_are_told_of_tables_with_few_digits(
    errors: Callable[[Matrix], None], sign: int, words: str, spelled: str
) -> None:
    def change(J: Matrix) -> None:
        J[0, 1] *= sign

    wanted = wanted_by("polar.covariance.linear", {})
    function = product("polar", errors, change)
    text = filled(wanted, lambda *values: function(*values).ravel().tolist(), spelled)
    taken = {f"argument {place + 1}": symbol.name for place, symbol in enumerate(wanted.symbols)}
    found = Examination(tabulated(wanted, text), wanted, taken, AS_ASKED).diagnosis()
    assert words in found.slip, str(found)


def slant(x: float, y: float, z: float) -> Matrix:
    """The Jacobian of range, azimuth and elevation."""
    r, ground = math.sqrt(x * x + y * y + z * z), math.hypot(x, y)
    return np.array([
        [x / r, y / r, z / r],
        [y / ground**2, -x / ground**2, 0],
        [-x * z / (r * r * ground), -y * z / (r * r * ground), ground / r**2],
    ])  # fmt: skip


@pytest.mark.parametrize("spelled", ["r", ".7g", ".4g"])
def test_a_column_of_whole_numbers_says_nothing_of_the_digits_and_two_edits_are_found(spelled: str) -> None:
    def values(x: float, y: float, z: float) -> list[float]:
        found = slant(x, y, z)
        found[2, 0] *= -math.sqrt(x * x + y * y + z * z)
        return found.ravel().tolist()

    wanted = wanted_by("observe.spherical.jacobian", {})
    found = Examination(
        tabulated(wanted, filled(wanted, values, spelled)), wanted, {}, AS_ASKED
    ).diagnosis()  # fmt: skip
    assert found.slips[0].formula == "x*z/(sqrt(x**2 + y**2)*sqrt(x**2 + y**2 + z**2))", str(found)


@pytest.mark.parametrize("term", [1e-6, 1e-9, 1e-12])
def test_a_constant_against_division_by_zero_is_told_in_the_root_or_under_it(term: float) -> None:
    def in_range(x: float, y: float) -> Any:
        r = math.hypot(x, y) + term
        return [[x / r, y / r], [-y / r**2, x / r**2]]

    def under_roots(x: float, y: float, z: float) -> Any:
        r, ground = math.sqrt(x * x + y * y + z * z + term), math.sqrt(x * x + y * y + term)
        across = r * r * ground
        return [
            [x / r, y / r, z / r],
            [y / ground**2, -x / ground**2, 0],
            [-x * z / across, -y * z / across, ground / r**2],
        ]

    found = diagnose(in_range, "observe.polar.jacobian")
    assert f"x/(sqrt(x**2 + y**2) + {term:g})" in str(found), str(found)
    assert f"(sqrt(x**2 + y**2) + {term:g})**2 for x**2 + y**2" in found.slip
    found = diagnose(under_roots, "observe.spherical.jacobian")
    assert f"an extra term {term:g} in x**2 + y**2 + z**2 + {term:g}" in found.slip, str(found)
    assert "for example" in str(found)


@pytest.mark.parametrize(
    ("azimuth", "words"),
    [
        (lambda x, y: math.atan(x / y), "atan(x/y) for atan2(x, y), which differs only where y < 0"),
        (lambda x, y: math.asin(x / math.hypot(x, y)), "asin(x/sqrt("),
        (lambda x, y: math.acos(y / math.hypot(x, y)), "acos(y/sqrt("),
        (lambda x, y: math.atan2(abs(x), y), "abs("),
    ],
    ids=["atan", "asin", "acos", "abs"],
)
def test_what_is_right_in_one_half_plane_is_named(azimuth: Callable[[float, float], float], words: str) -> None:
    def measured(x: float, y: float, z: float) -> Any:
        return [math.sqrt(x * x + y * y + z * z), azimuth(x, y), math.atan2(z, math.hypot(x, y))]

    found = diagnose(measured, "observe.spherical.map")
    assert (found.verdict, words in found.slip) == ("slip", True), str(found)


def test_a_convention_and_slips_in_two_entries_are_told_together() -> None:
    def from_x(x: float, y: float, z: float) -> Any:
        found = slant(x, y, z)
        found[1] *= -1
        found[1, 1] *= math.hypot(x, y)
        found[2, 0] *= math.sqrt(x * x + y * y + z * z)
        return found

    found = diagnose(from_x, "observe.spherical.jacobian")
    assert "from the other axis" in found.convention, str(found)
    assert [slip.entries for slip in found.slips] == [((1, 1),), ((2, 0),)]


def test_an_angle_in_degrees_that_is_not_converted_in_one_place_is_told() -> None:
    found = diagnose(lambda r, az_deg: [r * math.cos(math.radians(az_deg)), r * math.sin(az_deg)], "polar.map")
    assert found.slip == "entry [1]: 180*beta/pi for beta"
    found = diagnose(lambda r, az: [r * math.cos(math.radians(az)), r * math.sin(az)], "polar.map")
    assert found.slip == "entry [0]: pi*beta/180 for beta"


@pytest.mark.parametrize("more", [1, -1])
def test_a_count_that_is_one_off_is_told(more: int) -> None:
    function = generated(find("finite_sample.degree1.range.covariance"))
    found = diagnose(
        lambda k, T, s: function(k=k + more, T=T, sigma_r=s), "finite_sample.degree1.range.covariance"
    )  # fmt: skip
    assert f"k {'+' if more > 0 else '-'} 1 for k" in found.slip, str(found)


def test_one_edit_goes_before_two_conventions() -> None:
    found = diagnose(lambda T, sigma_r, sigma_v: sigma_r**2 / (T**4 * sigma_v**2), "finite_sample.C")
    assert found.slip == "the power 2 is 4 in T**2"


def test_entries_of_a_whole_matrix_in_wrong_places_are_no_list_of_its_upper_half() -> None:
    def exchanged(*values: float) -> Any:
        found = np.array(function(**dict(zip(names, values, strict=True))))
        found[0, 1], found[1, 1] = found[1, 1], found[0, 1]
        return found

    quantity = find("polar.covariance.linear")
    function, names = generated(quantity), [symbol.name for symbol in quantity.symbols]
    assert diagnose(named(exchanged, names), quantity.name).slip == "entries [0, 1] and [1, 1]: exchanged"


def test_a_class_is_refused_with_a_word() -> None:
    class Filter:
        def __call__(self, r: float, az: float) -> Any:
            return r * math.cos(az), r * math.sin(az)

    assert diagnose(Filter(), "polar.map").agrees
    with pytest.raises(CannotDiagnose, match="Filter is a class"):
        diagnose(Filter, "polar.map")


@pytest.mark.parametrize(
    ("derived", "edited", "words"),
    [
        ("sqrt(x**2 + y**2)", "sqrt(x**2 + 2*y**2)", "an extra factor 2 in 2*y**2"),
        ("x*y", "2*x*y", "an extra factor 2"),
        ("-x*y", "-2*x*y", "an extra factor 2"),
        ("exp(-3*x)", "exp(-x)", "the factor 3 is missing in 3*x"),
        ("x*(y + z)", "x*y", "the term z is missing in y + z"),
        ("-x*y/(x + z)", "-x*z/(x + z)", "z for y in x*z"),
        ("x**3*y/3", "x**3*y/2", "2 for 3"),
        ("exp(-3*x) + exp(-4*x)", "exp(-x) + exp(-2*x)", "the factor 3 is missing in 3*x and 2 for 4 in 2*x"),
    ],
)
def test_words_of_an_edit_say_where_it_is(derived: str, edited: str, words: str) -> None:
    assert edit_in_words(*(read_text(text, ["x", "y", "z"]) for text in (derived, edited))) == words
