"""A function is told to be what it is: right, in another convention, with a slip, inexact, or undefined somewhere."""

import math
import os
import re
from collections.abc import Callable
from random import Random
from typing import Any

import mpmath
import numpy as np
import pytest

from radartrack.derive.catalogue import UnknownQuantity, catalogue, find
from radartrack.derive.evaluation.many_digits import Evaluator
from radartrack.derive.formula.to_expression import to_expression
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.reading.text import read_text
from radartrack.testing import CannotDiagnose, Diagnosis, assert_derived, diagnose
from radartrack.verification.domain_points import coarse
from radartrack.verification.layers.formula_mutants import mutants
from radartrack.verification.subject import generated
from tests.radartrack.testing import own_functions as own
from tests.radartrack.testing.black_boxes import Function, function_of, named, rewritings
from tests.radartrack.testing.told_slips import is_told

FUNCTIONS = int(os.environ.get("RADARTRACK_FUNCTIONS", "0"))  # mutants of each quantity as functions; 0 for a sample
SAMPLE = (
    "polar.jacobian", "polar.covariance.truth", "polar.unbiased.estimate", "observe.polar_doppler.jacobian",
    "motion.constant_acceleration.process_noise.continuous", "ruv.covariance.linear", "fusion.weights.three",
)  # fmt: skip
RIGHT = ("polar.covariance.averaged", "observe.spherical.jacobian", "fusion.variance.three")
SHARE = 0.95
JACOBIAN = "observe.polar_doppler.jacobian"
WEIGHTS = "fusion.weights.two"
WRONG = {"slip", "differs", "undefined"}


@pytest.mark.parametrize("name", sorted(catalogue()) if FUNCTIONS else RIGHT)
def test_right_functions_in_any_order_convention_and_precision_are_not_called_wrong(name: str) -> None:
    quantity = find(name)
    for kind, function in rewritings(generated(quantity), quantity, Random(name)).items():
        found = diagnose(function, name)
        assert found.verdict not in WRONG, (kind, str(found))
        if kind in {"as it is", "another order of arguments", "lists"}:
            assert found.agrees, (kind, str(found))


@pytest.mark.parametrize("name", [name for name in sorted(catalogue()) if FUNCTIONS or name in SAMPLE])
def test_mutants_are_never_called_right_and_nearly_always_told_by_the_edit_that_was_put_in(name: str) -> None:
    """That edit, or one that is equal to it in value, and no other beside it."""
    quantity = find(name)
    told = []
    for mutant in mutants(quantity, FUNCTIONS or 2, seed=7):
        found = diagnose(function_of(mutant.entries, quantity), name)
        assert not found.agrees, (mutant.kind, str(found))
        told.append(is_told(found, quantity, mutant.entries))
    assert sum(told) >= SHARE * len(told) - 1


@pytest.mark.parametrize(
    ("function", "name", "words"),
    [
        (own.x_for_y, "observe.polar_doppler.jacobian", "entry [2, 0]: x for y"),
        (own.whole_number_power, "observe.polar_doppler.jacobian", "entries [2, 0] and [2, 1]: the power 3/2 is 1"),
        (own.lost_power_signs, "observe.spherical.jacobian", "y + 2 for y**2"),
        (own.without_range, "polar.covariance.linear", "the factor r**2 is missing"),
        (own.lost_product, "ruv.covariance.second_order[2, 2]", "the term r**2*sigma_u**2*sigma_v**2*u**2*v**2"),
        (own.white_noise_velocity, "motion.constant_velocity.process_noise.continuous", "the power 3 is 4 in T**3"),
        (own.other_side_of_the_baseline, "bistatic.map", "the sign of baseline*cos(beta)"),
        (own.slope_with_a_doubled_term, "line.slope", "an extra factor 2 in 2*S_yy"),
    ],
)  # fmt: skip
def test_slips_of_public_code_are_named(function: Function, name: str, words: str) -> None:
    found = diagnose(function, name)
    assert not found.agrees
    assert words in found.slip
    assert found.slip in str(found)


@pytest.mark.parametrize(
    ("function", "name", "words"),
    [
        (own.of_variances, "polar.covariance.linear", "variances in place of sigma_r and sigma_beta"),
        (own.in_degrees, "polar.covariance.linear", "beta and sigma_beta in degrees"),
        (own.interleaved, "observe.polar_doppler.jacobian", "the columns in the order x, vx, y, vy"),
        (own.bias_of_truth, "polar.bias.averaged", "this is polar.bias.truth"),
        (
            own.piecewise_noise,
            "motion.constant_velocity.process_noise.continuous",
            "this is motion.constant_velocity.process_noise.piecewise",
        ),
        (
            own.wiener_sequence_of_variance,
            "motion.constant_acceleration.process_noise.continuous",
            "this is motion.constant_acceleration.process_noise.wiener_sequence with variances in place of sigma_w",
        ),
        (own.of_physics, "spherical.map", "beta counted from the other axis and epsilon counted from the zenith"),
        (own.variances_first, "polar.covariance.linear", "the entries in the order of the diagonal, then the others"),
        (own.in_kilometres, "polar.map", "the result in kilometres"),
        (own.milliradians, "polar.covariance.linear", "sigma_beta in milliradians"),
        (own.of_a_time_constant, "motion.singer.transition", "1/alpha in place of alpha"),
        (own.turning_in_another_order, "motion.ctrv.map", "the entries in the order 0, 1, 3, 2, 4"),
        (own.bearing_in_degrees, "observe.bearing.map", "the result in degrees"),
        (own.bearing_of_compass, "observe.bearing.map", "from the other axis (pi/2 - beta) and the result in degrees"),
    ],
)  # fmt: skip
def test_other_conventions_are_told_and_no_slip_is_made_of_them(function: Function, name: str, words: str) -> None:
    found = diagnose(function, name)
    assert (found.verdict, found.slip, found.agrees) == ("convention", "", False)
    assert words in found.convention
    assert words in str(found)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ((0, 1, -1.0), "in J K J^T, the Jacobian's entry [0, 1]: the sign of r*sin(beta)"),
        ((0, 1, lambda _, b: -math.sin(b)), "in J K J^T, the Jacobian's entry [0, 1]: the factor r is missing"),
        ((1, 0, lambda _, b: math.cos(b)), "in J K J^T, the Jacobian's entry [1, 0]: cos(beta) for sin(beta)"),
        ((1, 1, lambda r, b: r * math.sin(b)), "in J K J^T, the Jacobian's entry [1, 1]: sin(beta) for cos(beta)"),
    ],
)  # fmt: skip
def test_a_slip_in_a_jacobian_is_told_where_it_was_made(change: tuple[int, int, Any], words: str) -> None:
    i, j, other = change

    def converted(r: float, b: float, sr: float, sb: float, rho: float) -> Any:
        J = np.array([[math.cos(b), -r * math.sin(b)], [math.sin(b), r * math.cos(b)]])
        J[i, j] = other(r, b) if callable(other) else other * J[i, j]
        return J @ np.array([[sr * sr, rho * sr * sb], [rho * sr * sb, sb * sb]]) @ J.T

    found = diagnose(converted, "polar.covariance.linear")
    assert found.verdict == "slip"
    assert words in str(found)


@pytest.mark.parametrize("name", ["spherical", "ruv", "polar_doppler", "bistatic"])
def test_every_sign_in_a_jacobian_is_told(name: str) -> None:
    """In the entry or in one that does the same; or as a convention: the sign of a correlation."""
    quantity, jacobian = find(f"{name}.covariance.linear"), find(f"{name}.jacobian")
    chance, model = Random(name), quantity.model
    assert model is not None
    places = [place for place, entry in jacobian.expression.items() if entry != 0]
    for i, j in chance.sample(places, 2):

        def converted(i: int = i, j: int = j, **at: float) -> Any:
            J = generated(jacobian)(**{symbol.name: at[symbol.name] for symbol in jacobian.symbols}).copy()
            J[i, j] *= -1
            deviations = np.array([at[sigma.name] for sigma in model.deviations])
            K = np.diag(deviations**2)
            for (one, two), rho in model.correlations.items():
                a, b = model.measured.index(one), model.measured.index(two)
                K[a, b] = K[b, a] = at[rho.name] * deviations[a] * deviations[b]
            return J @ K @ J.T

        names = [symbol.name for symbol in quantity.symbols]
        function = named(lambda *values, of=converted, names=names: of(**dict(zip(names, values, strict=True))), names)
        found = diagnose(function, quantity.name)
        assert found.verdict in {"slip", "convention"}, str(found)
        assert re.search(r"the Jacobian's entry \[\d, \d\]: the sign of", str(found)) or found.convention, str(found)


def test_matrices_that_are_multiplied_in_another_order_are_told_as_that() -> None:
    def converted(r: float, b: float, sr: float, sb: float) -> Any:
        J = np.array([[math.cos(b), -r * math.sin(b)], [math.sin(b), r * math.cos(b)]])
        return J.T @ np.diag([sr * sr, sb * sb]) @ J

    assert diagnose(converted, "polar.covariance.linear").slip == "J^T K J for J K J^T"


@pytest.mark.parametrize(
    ("function", "words"),
    [
        (lambda T, q: [[q * (T**3 // 3), q * T**2 / 2], [q * T**2 / 2, q * T]], "T**3/3 is rounded down"),
        (lambda T, q: [[q * T**3 / 3, q * (T**2 // 2)], [q * (T**2 // 2), q * T]], "T**2/2 is rounded down"),
        (lambda T, q: [[q * T**3 / 3, q * T**2 / 2], [q * T**2 / 2, q * int(T)]], "T is rounded down"),
        (lambda T, q: [[q * T**3 / 3, q * T**2 / 2], [q * T**2 / 2, round(q * T)]], "T*q is rounded to a whole number"),
    ],
)  # fmt: skip
def test_a_part_that_is_cut_to_a_whole_number_is_named(function: Function, words: str) -> None:
    assert words in diagnose(function, "motion.constant_velocity.process_noise.continuous").slip


@pytest.mark.parametrize("term", [1e-6, 1e-9, 1e-12])
def test_a_constant_that_is_added_is_told_however_small_it_is(term: float) -> None:
    def converted(r: float, b: float, sr: float, sb: float) -> Any:
        return np.array(own.linear(r, b, sr, sb)) + term * np.eye(2)

    found = diagnose(converted, "polar.covariance.linear")
    assert found.slip == f"entries [0, 0] and [1, 1]: an extra term {term:g}"


def test_a_constant_in_the_midst_of_a_formula_is_told() -> None:
    def jacobian(x: float, y: float) -> Any:
        square = x * x + y * y + 1e-6
        return [[x / math.sqrt(square), y / math.sqrt(square)], [-y / square, x / square]]

    found = diagnose(jacobian, "observe.polar.jacobian")
    assert "an extra term 1e-06" in found.slip
    assert "x**2 + y**2 + 1e-06" in str(found)


@pytest.mark.parametrize(
    "function",
    [
        lambda r, **kw: own.to_xy(r, kw["azimuth"]),
        lambda r, **kw: own.to_xy(r, kw.get("az")),
        lambda **kw: own.to_xy(kw["rng"], math.radians(kw["az_deg"])),
    ],
    ids=["a key", "get", "degrees"],
)  # fmt: skip
def test_any_names_beside_named_arguments_are_those_that_the_code_asks_for(function: Function) -> None:
    assert_derived(function, "polar.map")


@pytest.mark.parametrize(
    ("name", "place", "change", "words"),
    [
        ("observe.polar_doppler.map", (2,), lambda f: lambda **at: f(**at | {"vy": -at["vy"]}), "the sign of vy*y"),
        ("polar.map", (1,), lambda f: lambda r, beta: f(r=r, beta=beta + math.pi / 2), "cos(beta) for sin(beta)"),
        ("polar.covariance.linear", (0, 0), lambda f: lambda **at: f(**at | {"rho": -at["rho"]}), "the sign of 2*r"),
        ("polar.covariance.linear", (1, 1), lambda f: lambda **at: -f(**at), "the sign of"),
        ("motion.constant_velocity.process_noise.piecewise", (0, 0), lambda f: lambda **at: 2 * f(**at), "2 for 4"),
    ],
)  # fmt: skip
def test_slips_of_functions_in_single_precision_are_named(
    name: str, place: tuple[int, ...], change: Callable[[Any], Any], words: str
) -> None:
    right = generated(find(name))
    other, names = change(right), [symbol.name for symbol in find(name).symbols]

    def single(*values: float) -> Any:
        at = dict(zip(names, values, strict=True))
        found = np.array(right(**at), np.float32)
        found[place] = other(**at)[place]
        return found

    found = diagnose(named(single, names), name)
    assert found.verdict == "slip", str(found)
    assert words in found.slip


def test_what_is_passed_in_another_unit_is_said_where_it_is_passed() -> None:
    found = diagnose(lambda r, az_deg: own.to_xy(r, math.radians(az_deg)), "polar.map")
    assert found.arguments == ("r: r", "az_deg: beta in degrees")


@pytest.mark.parametrize(
    ("function", "name", "words"),
    [
        (
            lambda r, az_deg: (r * math.cos(az_deg), r * math.sin(az_deg)),
            "polar.map",
            "beta itself for az_deg, which says degrees",
        ),
        (
            lambda r, az, var_r, sigma_az: np.array(own.linear(r, az, var_r, sigma_az)),
            "polar.covariance.linear",
            "sigma_r itself for var_r, which says a variance",
        ),
    ],
)
def test_a_parameter_that_is_not_what_its_name_says_is_told(function: Function, name: str, words: str) -> None:
    found = diagnose(function, name, given={"rho": 0} if "linear" in name else None)
    assert found.verdict == "convention"
    assert found.convention == words


def test_a_name_that_a_symbol_has_itself_says_no_convention_and_the_user_knows_better() -> None:
    assert_derived(lambda sigma2, sigma1: [sigma2**2, sigma1**2] / (sigma1**2 + sigma2**2 + np.zeros(2)), WEIGHTS)
    in_radians = lambda r, az_deg: (r * math.cos(az_deg), r * math.sin(az_deg))  # noqa: E731 - as a stranger writes
    assert_derived(in_radians, "polar.map", arguments={"az_deg": "beta"})
    assert_derived(lambda r, deg: own.to_xy(r, math.radians(deg)), "polar.map", arguments={"deg": "beta"})


def test_iterators_and_the_values_of_a_dict_are_what_they_hold() -> None:
    def to_xy(r: float, az: float) -> Any:
        yield from own.to_xy(r, az)

    assert_derived(to_xy, "polar.map")
    assert_derived(lambda r, az: dict(zip("xy", own.to_xy(r, az), strict=True)).values(), "polar.map")


def test_a_state_all_of_whose_angles_are_in_degrees_has_its_rate_in_degrees_a_second() -> None:
    function = own.turned_in_degrees
    assert diagnose(function, "motion.ctrv.map").convention == "heading and omega in degrees and the result in degrees"
    assert diagnose(function, "motion.ctrv.map", degrees=True).convention == "the result in degrees"
    assert diagnose(function, "motion.ctrv.map", degrees="heading").convention.startswith("omega in degrees")


@pytest.mark.parametrize(
    ("stated", "words"),
    [
        ({"degrees": True}, "variances in place of sigma_r and sigma_beta"),
        ({"variances": True}, "beta and sigma_beta in degrees"),
        ({"degrees": True, "variances": True}, ""),
    ],
)
def test_beside_a_convention_that_is_said_another_is_found(stated: dict[str, Any], words: str) -> None:
    def of_degrees(r: float, az: float, p: float, q: float) -> Any:
        return own.linear(r, math.radians(az), math.sqrt(p), math.radians(math.sqrt(q)))

    found = diagnose(of_degrees, "polar.covariance.linear", given={"rho": 0}, **stated)
    assert found.verdict == ("convention" if words else "agrees")
    assert found.convention == words


def test_an_angle_is_turned_before_it_is_told_in_degrees() -> None:
    def of_zenith(r: float, az: float, zenith: float) -> Any:
        return own.from_zenith(r, math.radians(az), math.radians(zenith))

    found = diagnose(of_zenith, "spherical.map", degrees=True)
    assert found.convention == "epsilon counted from the zenith (pi/2 - epsilon)"
    assert "zenith: (pi/2 - epsilon) in degrees" in found.arguments


def test_results_in_the_order_in_which_a_state_is_passed_are_a_convention_whether_it_is_a_vector_or_not() -> None:
    def moved(x: float, y: float, heading: float, speed: float, omega: float, dt: float) -> Any:
        px, py, v, psi, rate = own.turned([x, y, speed, heading, omega], dt)
        return px, py, psi, v, rate

    assert diagnose(moved, "motion.ctrv.map").convention == "the entries in the order 0, 1, 3, 2, 4"


def test_variances_are_said_of_what_is_taken_alone() -> None:
    found = diagnose(
        lambda r, b, s: [r * math.exp(s / 2) * f(b) for f in (math.cos, math.sin)], "polar.unbiased.estimate"
    )
    assert found.convention == "variances in place of sigma_beta"


def test_two_covariances_are_no_complex_number() -> None:
    with pytest.raises(CannotDiagnose, match="it returns an array"):
        diagnose(lambda R, T: np.block([[R, R / T], [R / T, 2 * R / T**2]]), "initiation.two_plots.covariance")


def test_a_straight_line_in_place_of_a_slow_turn_is_not_told_as_a_subtraction_that_loses_less() -> None:
    lost = diagnose(own.straight_where_slow, "motion.ctrv.map").lost_digits
    assert lost is not None
    assert lost.digits > 8
    assert not lost.why


def test_a_state_in_which_x_and_y_are_exchanged_is_not_taken_for_right() -> None:
    def measured(x: Any) -> Any:
        px, py, vx, vy = x
        return [math.hypot(px, py), math.atan2(px, py), (px * vx + py * vy) / math.hypot(px, py)]

    assert diagnose(measured, "observe.polar_doppler.map").verdict == "convention"
    found = diagnose(lambda state: own.radar_jacobian(state[1], state[0], state[3], state[2]), JACOBIAN)
    assert found.verdict == "convention"
    assert found.convention == "state in the order y, x, vy, vx"
    order = {"state": ("y", "x", "vy", "vx")}
    right = lambda state: own.radar_jacobian(state[1], state[0], state[3], state[2])[:, [1, 0, 3, 2]]  # noqa: E731
    assert_derived(right, JACOBIAN, arguments=order)


def test_the_opposite_sign_of_a_correlation_and_of_a_range_rate_are_told() -> None:
    function, name = generated(find("polar_doppler.covariance.linear")), "polar_doppler.covariance.linear"
    names = [symbol.name for symbol in find(name).symbols]
    opposite = named(lambda *at: function(**(p := dict(zip(names, at, strict=True))) | {"rho": -p["rho"]}), names)
    assert diagnose(opposite, name).convention == "the opposite sign of rho"


def test_what_is_said_of_the_convention_makes_a_function_right() -> None:
    assert_derived(own.of_variances, "polar.covariance.linear", variances=True)
    assert_derived(own.in_degrees, "polar.covariance.linear", degrees=True)
    order = {"state": ("x", "vx", "y", "vy")}
    assert_derived(own.interleaved, "observe.polar_doppler.jacobian", arguments=order)
    assert_derived(own.linear, "polar.covariance.linear", given={"rho": 0})


def test_a_convention_and_a_slip_are_told_together() -> None:
    def turned(r: float, azimuth: float, elevation: float) -> Any:
        (c, s), (k, t) = ((math.cos(one), math.sin(one)) for one in (azimuth, elevation))
        return [[k * c, -r * k * s, -r * t * c], [k * s, r * k * c, r * t * s], [t, 0, r * k]]

    found = diagnose(turned, "spherical.jacobian")
    assert "from the other axis" in found.convention
    assert found.slip.startswith("entry [1, 2]: the sign")


def test_another_quantity_and_a_slip_are_told_together_where_that_leaves_least_to_explain() -> None:
    name = "motion.constant_acceleration.process_noise"
    found = diagnose(own.wiener_sequence_with_a_slip, f"{name}.piecewise")
    assert f"(read as {name}.wiener_sequence): entry [2, 2]: an extra factor T" in str(found)


@pytest.mark.parametrize(
    ("function", "name"),
    [
        (own.elevation_by_arcsine, "observe.spherical.map"),
        (own.gain_by_its_printed_formula, "steady_state.alpha_beta.gain"),
    ],
)
def test_a_right_function_that_cancels_where_the_derived_formula_does_not_is_right(
    function: Function, name: str
) -> None:
    found = diagnose(function, name)
    assert found.verdict == "loses_digits", str(found)
    assert found.lost_digits is not None
    assert found.lost_digits.digits >= 4
    assert name.startswith("observe") or "rounding numbers near 1," in found.lost_digits.why


def test_another_order_of_parameters_is_found_without_their_names() -> None:
    found = diagnose(lambda a, b: [b * math.cos(a), b * math.sin(a)], "polar.map")
    assert found.agrees
    assert found.arguments == ("a: beta", "b: r")


@pytest.mark.parametrize(
    ("function", "name", "taken"),
    [
        (own.turning, "motion.ctrv.map", "x: (x, y, speed, heading, omega)"),
        (own.of_a_matrix, "polar.covariance.linear", "R: the covariance matrix of sigma_r, sigma_beta, rho"),
        (
            own.of_a_matrix_in_space,
            "spherical.covariance.linear",
            "covariance: the covariance matrix of sigma_r, sigma_beta, sigma_epsilon, rho",
        ),
    ],
)
def test_states_and_covariances_are_passed_whole(function: Function, name: str, taken: str) -> None:
    found = diagnose(function, name)
    assert found.agrees
    assert taken in found.arguments
    assert not diagnose(own.of_a_matrix_wrongly, "polar.covariance.linear").agrees


@pytest.mark.parametrize(
    ("function", "taken"),
    [
        (own.of_many_plots, "plots: (r, beta)"),
        (own.of_an_object, "plot: a Plot of r, beta"),
        (own.of_a_mapping, "plot: a record of r, beta"),
        (lambda *, azimuth, rng: own.to_xy(rng, azimuth), "azimuth: beta"),
        (lambda **plot: own.to_xy(plot["r"], plot["beta"]), "r: r"),
        (lambda r, az: dict(zip("xy", own.to_xy(r, az), strict=True)), "az: beta"),
        (lambda r, az: r * complex(math.cos(az), math.sin(az)), "az: beta"),
        (np.vectorize(own.to_xy), "argument 1: r"),
    ],
    ids=["rows", "object", "mapping", "keywords", "any keywords", "to a mapping", "to a complex number", "vectorized"],
)  # fmt: skip
def test_plots_come_and_go_as_objects_rows_mappings_and_complex_numbers(function: Function, taken: str) -> None:
    found = diagnose(function, "polar.map")
    assert found.agrees, str(found)
    assert taken in found.arguments


def test_two_matrices_whole_numbers_and_customary_constants_are_passed_as_code_takes_them() -> None:
    assert_derived(own.intersection, "fusion.covariance_intersection.covariance")
    assert_derived(own.least_squares_of_scans, "finite_sample.degree1.range.covariance", given={"k": 7})
    found = diagnose(own.on_wgs84, "frames.ecef_from_geodetic.map")
    assert found.agrees
    assert "semi_major_axis = 6378137" in str(found)
    assert (
        "the factor (1 - flattening)**2 is missing"
        in diagnose(own.on_wgs84_wrongly, "frames.ecef_from_geodetic.map").slip
    )


@pytest.mark.parametrize(
    ("put", "words"),
    [
        (np.diagonal, "the diagonal of the result alone"),
        (lambda c: np.sqrt(np.diagonal(c)), "deviations alone"),
        (np.linalg.inv, "inverted"),
        (np.linalg.cholesky, "the lower Cholesky factor"),
        (lambda c: np.linalg.cholesky(c).T, "the upper Cholesky factor"),
        (own.correlations_of, "as a correlation matrix"),
        (lambda c: own.correlations_of(c, np.sqrt(np.diagonal(c))), "deviations on the diagonal"),
    ],
    ids=["diagonal", "deviations", "inverse", "lower", "upper", "correlations", "both"],
)  # fmt: skip
def test_what_else_is_returned_of_a_covariance_is_told(put: Callable[[Any], Any], words: str) -> None:
    found = diagnose(lambda r, b, sr, sb: put(np.array(own.linear(r, b, sr, sb))), "polar.covariance.linear")
    assert (found.verdict, words in found.convention) == ("convention", True), str(found)


def test_a_jacobian_column_by_column_and_a_deviation_for_a_variance_are_told() -> None:
    found = diagnose(lambda px, py, vx, vy: own.radar_jacobian(px, py, vx, vy).T, "observe.polar_doppler.jacobian")
    assert found.convention == "the result transposed"
    found = diagnose(lambda s1, s2: 1 / math.hypot(1 / s1, 1 / s2), "fusion.variance.two")
    assert "the square root of the result" in found.convention
    assert "in the order 1, 0" in diagnose(own.weights_exchanged, "fusion.weights.two").convention


@pytest.mark.parametrize(
    ("angle", "words"),
    [
        (lambda az: az * 3.14 / 180, "beta in degrees with 3.14 for pi"),
        (lambda az: az / 57.3, "beta in degrees with 57.3 for 180/pi"),
        (lambda az: az * 0.01745, "beta in degrees with 0.01745 for pi/180"),
        (lambda az: az * float(np.float32(math.pi / 180)), "beta in degrees with pi/180 in single precision"),
        (lambda az: az - 0.01, "beta - 0.01 for beta"),
    ],
    ids=["pi", "180/pi", "pi/180", "single", "offset"],
)  # fmt: skip
def test_constants_with_few_digits_and_offsets_are_named(angle: Callable[[float], float], words: str) -> None:
    found = diagnose(lambda r, az: own.to_xy(r, angle(az)), "polar.map")
    assert found.slip == f"entries [0] and [1]: {words}", str(found)


def test_a_function_that_remembers_is_told_to_and_no_slip_is_made_of_it() -> None:
    calls: list[float] = []

    def counting(r: float, az: float) -> Any:
        calls.append(r)
        return r * math.cos(az) + (len(calls) > 10), r * math.sin(az)

    found = diagnose(counting, "polar.map")
    assert (found.verdict, found.slip) == ("differs", "")
    assert "when it was called before" in str(found)


def test_a_function_that_divides_by_what_may_vanish_loses_its_digits_near_there() -> None:
    found = diagnose(own.turning, "motion.ctrv.map")
    assert found.lost_digits is not None
    assert found.lost_digits.digits >= 6


def test_a_function_that_draws_is_told_to_be_no_function() -> None:
    generator = np.random.default_rng(3)
    found = diagnose(lambda r, beta: [r * math.cos(beta) + generator.normal(), r * math.sin(beta)], "polar.map")
    assert not found.agrees
    assert found.differences == ("not deterministic: two calls with the same arguments give different values",)


def test_a_function_of_a_shared_library_is_diagnosed() -> None:
    assert_derived(own.hypot_of_c(), "observe.polar.map[0]", ulp=2)


@pytest.mark.parametrize("ulp", ["2", None, True, [2.0], math.nan, -1.0])
def test_an_allowance_that_is_none_is_refused_before_any_call(ulp: Any) -> None:
    with pytest.raises((TypeError, ValueError), match="ulp must be"):
        assert_derived(lambda r, beta: [r / 0, beta], "polar.map", ulp=ulp)


def test_a_textbook_form_is_right_and_said_to_lose_its_digits_by_which_subtraction() -> None:
    found = diagnose(own.printed_unbiased, "polar.unbiased.covariance")
    assert found.agrees
    assert found.lost_digits is not None
    assert found.lost_digits.digits >= 12
    assert "sigma_beta is small" in found.lost_digits.where
    assert "cancels" in found.lost_digits.why
    assert found.lost_digits.instead == "radartrack.generated.polar.unbiased_covariance"
    with pytest.raises(AssertionError, match="loses"):
        assert_derived(own.printed_unbiased, "polar.unbiased.covariance")


def test_a_covariance_that_single_precision_makes_indefinite_is_told_as_that() -> None:
    found = diagnose(own.printed_unbiased_single, "polar.unbiased.covariance")
    assert found.agrees
    assert "indefinite" in str(found)
    assert "single precision" in str(found)


@pytest.mark.parametrize(
    "name",
    ["finite_sample.degree3.range.information", "finite_sample.degree3.range.covariance", "polar.covariance.truth"],
)
@pytest.mark.parametrize("put", [np.float32, lambda found: found.astype(np.float32).astype(float)], ids=["array", "C"])
def test_what_single_precision_cannot_hold_is_told_and_is_not_wrong(name: str, put: Callable[[Any], Any]) -> None:
    function = generated(find(name))
    names = [symbol.name for symbol in find(name).symbols]
    found = diagnose(named(lambda *values: put(function(**dict(zip(names, values, strict=True)))), names), name)
    assert found.agrees, str(found)
    assert ("beyond what single precision holds" in str(found)) == name.startswith("finite"), str(found)


def test_an_intermediate_that_overflows_single_precision_is_told() -> None:
    def to_xy(r: float, az: float) -> Any:
        eighth = np.float32(r) ** 8
        return np.array([r * math.cos(az), r * math.sin(az)], np.float32) * (eighth / eighth)

    found = diagnose(to_xy, "polar.map")
    assert (found.verdict, "undefined" in str(found)) == ("undefined", True), str(found)


def test_single_precision_inside_is_rounding_and_a_constant_of_few_digits_is_none() -> None:
    found = diagnose(own.single_inside, "polar.map")
    assert found.agrees
    assert "it computes in single precision" in str(found)
    assert diagnose(own.nearly_degrees, "polar.map", degrees=True).slip == "entries [0] and [1]: 3.14159 for pi"


def test_where_a_function_is_wrong_in_a_half_plane_is_said() -> None:
    found = diagnose(own.half_plane, "observe.polar.map")
    assert found.slip == "entry [1]: atan(y/x) for atan2(y, x), which differs only where x < 0"
    assert found.worst is not None
    assert found.worst.point["x"] < 0
    assert "ZeroDivisionError" in str(found)


def test_where_a_function_leaves_the_formula_is_said() -> None:
    found = diagnose(own.guarded, "observe.polar_doppler.jacobian")
    assert found.verdict == "differs"
    assert "right at ordinary points" in str(found)


def polar_map(change: Callable[[float, float, list[float]], Any]) -> Function:
    return named(lambda r, az: change(r, az, [r * math.cos(az), r * math.sin(az)]), ["r", "az"])


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda r, _, found: [math.nan, math.nan] if r > 1e7 else found, "undefined"),
        (lambda r, _, found: [math.inf, found[1]] if r > 1e7 else found, "infinite"),
        (lambda r, _, found: [complex(0, 1), found[1]] if r > 1e7 else found, "complex"),
        (lambda r, _, found: 1 / 0 if r > 1e7 else found, "ZeroDivisionError"),
        (lambda r, _, found: [1.0] if r > 1e7 else found, r"shape \(1,\)"),
    ],
)  # fmt: skip
def test_where_there_is_no_real_value_is_said(change: Callable[[float, float, list[float]], Any], words: str) -> None:
    found = diagnose(polar_map(change), "polar.map")
    assert found.verdict == "undefined"
    with pytest.raises(AssertionError, match=words):
        assert_derived(polar_map(change), "polar.map")


def test_a_function_that_does_not_give_the_same_twice_is_told() -> None:
    chance = Random(1)
    found = diagnose(
        polar_map(lambda _, __, values: [values[0] * (1 + 1e-13 * chance.random()), values[1]]), "polar.map"
    )
    assert not found.agrees
    assert str(found).startswith("This is polar.map, but not deterministic.")


@pytest.mark.parametrize(
    ("function", "words"),
    [
        (lambda *_: 1.0, "it returns a number"),
        (lambda *_: None, "it returns nothing"),
        (lambda *_: "xy", "it returns a str"),
        (lambda *_: [1j, 1j, 1j], "shape \\(3,\\)"),
        (lambda self, r, az: [self, r, az], "the method of a class"),
        (lambda r, az, t: [r, az, t], "give the others their values"),
        (lambda a, b, c, d: [a, b, c, d], "for it takes a, b, c, d"),
        (lambda r, _: {}[r], "KeyError"),
        (lambda: [1.0, 2.0], "cannot be called with r, beta"),
    ],
)  # fmt: skip
def test_what_cannot_be_compared_is_refused_with_a_word(function: Function, words: str) -> None:
    with pytest.raises(CannotDiagnose, match=words):
        diagnose(function, "polar.map")


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"given": {"rho": 0}}, "given may fix r, beta of polar.map; given also rho"),
        ({"degrees": "r"}, "degrees may name beta; given r"),
        ({"arguments": {"az": "theta"}}, "arguments must name symbols"),
        ({"arguments": {"state": "r"}}, "arguments must name parameters: r, az; given state"),
    ],
)  # fmt: skip
def test_options_that_name_nothing_are_refused(options: dict[str, Any], words: str) -> None:
    with pytest.raises(ValueError, match=words):
        diagnose(lambda r, az: [r, az], "polar.map", **options)
    with pytest.raises(UnknownQuantity):
        diagnose(lambda r, az: [r, az], "polar.mop")


def test_of_what_no_edit_explains_it_is_said_on_what_the_difference_depends_and_of_what_order_it_is() -> None:
    def strange(r: float, az: float, sr: float, saz: float) -> Any:
        found = np.array(own.linear(r, az, sr, saz))
        found[0, 0] += math.tanh(r) * saz**4 * math.atan(az + 0.3)
        return found

    found = diagnose(strange, "polar.covariance.linear")
    assert found.verdict == "differs"
    (words,) = found.differences
    assert (
        words
        == "entry [0, 0]: differs; the difference depends on r, beta, sigma_beta and is of order 4 in the deviations"
    )


def test_the_formula_of_a_slip_is_what_the_function_computes() -> None:
    """Read again and evaluated in many digits, beside the mutant that the function was made of."""
    quantity = find("polar.covariance.linear")
    symbols = {symbol.name: symbol for symbol in quantity.symbols}
    points = coarse(quantity, 5, seed=77)
    for mutant in mutants(quantity, 4, seed=3):
        found: Diagnosis = diagnose(function_of(mutant.entries, quantity), quantity.name)
        for slip in found.slips:
            read: Any = to_expression(read_text(slip.formula, symbols), symbols) if slip.formula else None
            if read is not None:
                pair = Evaluator(Tensor((2,), (read, mutant.entries[slip.entries[0]])), quantity.symbols)
                for n in range(5):
                    first, second = pair([float(values[n]) for values in points.values()])
                    assert mpmath.almosteq(first, second, 1e-30)


def test_beside_an_exact_zero_all_digits_are_lost_and_that_is_told() -> None:
    quantity = find("observe.bistatic_range_rate.jacobian")
    rows, columns = quantity.shape
    order = [0, 1, 3, 2]
    turned = tuple(quantity.expression[row, order[column]] for row in range(rows) for column in range(columns))
    found = diagnose(function_of(Tensor(quantity.shape, turned), quantity), quantity.name)
    assert found.verdict == "convention"
    assert "order 0, 1, 3, 2" in str(found)
    assert found.lost_digits is None or 0 < found.lost_digits.digits <= 16
