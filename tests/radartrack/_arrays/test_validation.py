"""What is refused, and in which words; what is taken, and as what."""

import math
import re
from collections import UserList, deque
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

from radartrack import consistency, fixed_gain, frames
from radartrack._arrays import validation
from radartrack._arrays.validation import (
    ANGLE,
    ANGLE_STD,
    CORRELATION,
    RANGE,
    Domain,
    RealArray,
    broadcast_shape,
    number_between,
    one_of,
    positive_number,
    real_arrays,
    real_number,
    require_covariance,
    require_finite,
    require_trailing_shape,
    require_variances,
    require_within,
)
from radartrack.testing import strategies

METHODS = ("linear", "second_order", "unbiased")
DOMAINS = {"range": RANGE, "angle": ANGLE, "angle_std": ANGLE_STD, "correlation": CORRELATION}
TYPES = [np.dtype(np.float32), np.dtype(np.float64)]


def read(value: Any) -> RealArray:
    return real_arrays({"r": value})["r"]


@pytest.mark.parametrize(
    ("value", "shown"),
    [
        ("12", "'12' (str)"),
        (["1", "2"], "['1', '2'] (list)"),
        (b"1", "b'1' (bytes)"),
        (1 + 2j, "(1+2j) (complex)"),
        (np.array([1j]), "complex128"),
        (None, "None (NoneType)"),
        ([1.0, None], "[1.0, None] (list)"),
        (object(), "object"),
        ({1.0}, "{1.0} (set)"),
        (True, "True (bool)"),
        (np.array([True]), "bool"),
        (np.datetime64("2020-01-01"), "datetime64"),
        (np.timedelta64(1, "s"), "timedelta64"),
        ([10**400], "object"),
    ],
)
def test_what_is_no_real_number_is_a_type_error_that_shows_it(value: Any, shown: str) -> None:
    with pytest.raises(TypeError, match=r"^r must be real numbers; got ") as raised:
        read(value)
    assert shown in str(raised.value)


BOOLS = [True, np.True_, np.array([True]), np.array(False)]
NUMBERS = [2.0, 3, np.float64(2.0), np.float32(2.0), np.int8(1), np.array([2.0])]


@given(
    bool_=st.sampled_from(BOOLS),
    others=st.lists(st.sampled_from(NUMBERS), min_size=1, max_size=4),
    place=st.integers(0, 4),
    wrap=st.sampled_from([list, tuple, deque, UserList, lambda part: [part, part], lambda part: [[part], [part]]]),
)
def test_a_bool_among_numbers_is_none_wherever_it_stands(bool_: Any, others: list[Any], place: int, wrap: Any) -> None:
    """NumPy reads [True, 2.0] as [1.0, 2.0]."""
    as_arrays = any(np.ndim(entry) for entry in (bool_, *others))
    entries = [np.atleast_1d(entry) if as_arrays else entry for entry in (*others[:place], bool_, *others[place:])]
    with pytest.raises(TypeError, match=r"^r must be real numbers; got "):
        read(wrap(entries))


@given(entries=st.lists(st.sampled_from(NUMBERS[:-1]), max_size=5), wrap=st.sampled_from([list, tuple, deque]))
def test_numbers_without_a_bool_among_them_are_read(entries: list[Any], wrap: Any) -> None:
    assert read(wrap(entries)).tolist() == [float(entry) for entry in entries]


def test_what_can_be_read_as_an_array_is_not_searched_entry_by_entry() -> None:
    class Column:
        """As a series of pandas: an array of its own making, not a sequence."""

        def __init__(self, values: Any) -> None:
            self.values = np.asarray(values)
            self.dtype = self.values.dtype

        def __array__(self, dtype: Any = None, copy: Any = None) -> Any:
            return self.values

    assert read(Column([1.0, 2.0])).tolist() == [1.0, 2.0]
    assert read([Column([1.0, 2.0])]).tolist() == [[1.0, 2.0]]
    with pytest.raises(TypeError, match="real numbers"):
        read([Column([True, False]), Column([1.0, 2.0])])


def test_ragged_nesting_is_refused() -> None:
    with pytest.raises(ValueError, match=r"^r must be a number or an array; got \[\[1.0\], \[2.0, 3.0\]\]"):
        read([[1.0], [2.0, 3.0]])


def test_an_integer_beyond_float64_is_refused() -> None:
    with pytest.raises(ValueError, match=r"^r must be a number or an array; got 10+.*too large"):
        read(10**400)


def test_masked_entries_are_refused_and_counted() -> None:
    masked = np.ma.masked_array([1.0, 2.0, 3.0], mask=[False, True, True])
    with pytest.raises(ValueError, match=r"^r must have no masked entries; got 2 among 3$"):
        read(masked)


@pytest.mark.parametrize("container", [list, tuple, deque, UserList])
def test_masked_entries_of_arrays_in_a_list_are_refused_and_counted(container: Any) -> None:
    """NumPy takes what is under a mask for a number there."""
    masked = np.ma.masked_array([1.0, 2.0, 3.0], mask=[False, True, True])
    with pytest.raises(ValueError, match=r"^r must have no masked entries; got 3 among 9$"):
        read(container([masked, np.ones(3), np.ma.masked_array([1.0, 2.0, 3.0], mask=[True, False, False])]))


class Variable:
    """What netCDF4 hands over: read as an array it is a masked one."""

    def __array__(self, *_: Any, **__: Any) -> Any:
        return np.ma.masked_array([1.0, 9.97e36, 3.0], mask=[False, True, False])


def test_what_reads_as_a_masked_array_is_one() -> None:
    with pytest.raises(ValueError, match=r"^r must have no masked entries; got 1 among 3$"):
        read(Variable())


class Quantity(np.ndarray):
    """Numbers with a unit, as astropy and unyt have them."""

    unit = "km"


def test_what_has_a_unit_is_refused() -> None:
    one = np.ones(2).view(Quantity)
    for value in (one, [one], (1.0, [one[:1]])):
        with pytest.raises(TypeError, match=r"^r must be real numbers; got .*, whose unit would be lost$"):
            read(value)


def test_quantities_of_pint_are_refused() -> None:
    pint = pytest.importorskip("pint")
    for value in (pint.Quantity(5.0, "km"), pint.Quantity(np.ones(2), "km"), [pint.Quantity(5.0, "km")] * 2):
        with pytest.raises(TypeError, match=r"^r must be real numbers; got .*kilometer"):
            read(value)


def test_what_is_missing_in_a_dictionary_of_pyarrow_is_no_number() -> None:
    pa = pytest.importorskip("pyarrow")
    chunks = pa.chunked_array([pa.array([1.0, None, 3.0]).dictionary_encode()])
    assert np.isnan(read(chunks)).tolist() == [False, True, False]


def test_a_masked_array_without_masked_entries_is_an_array() -> None:
    array = read(np.ma.masked_array([1.0, 2.0], mask=False))
    assert type(array) is np.ndarray
    assert array.tolist() == [1.0, 2.0]


@pytest.mark.parametrize(
    "value",
    [
        3,
        3.0,
        [3],
        (3.0,),
        np.array(3),
        np.uint8(3),
        np.float16(3),
        np.array([3], dtype=">f8"),
        np.longdouble(3),
    ],
)
def test_real_numbers_are_read_as_float64(value: Any) -> None:
    array = read(value)
    assert array.dtype == np.float64
    assert array.shape == np.shape(value)
    assert (array == 3).all()


def test_arrays_are_not_copied() -> None:
    array = np.ones(3)
    assert read(array) is array


SINGLE = [np.ones(2, np.float32), np.float32(1), np.ones(2, ">f4")]
WEAK = [1, 1.0]
DOUBLE = [np.ones(2), np.float64(1), np.ones(2, int), np.int8(1), np.float16(1), [1.0], [np.float32(1), 1.0]]


@given(st.lists(st.sampled_from(SINGLE), min_size=1), st.lists(st.sampled_from(WEAK)))
def test_float32_arrays_and_python_numbers_compute_in_float32(single: list[Any], weak: list[Any]) -> None:
    arrays = real_arrays(dict(enumerate_names([*weak, *single])))
    assert {array.dtype for array in arrays.values()} == {np.dtype(np.float32)}


@given(st.lists(st.sampled_from(SINGLE + WEAK)), st.sampled_from(DOUBLE))
def test_any_other_array_makes_all_compute_in_float64(others: list[Any], double: Any) -> None:
    arrays = real_arrays(dict(enumerate_names([*others, double])))
    assert {array.dtype for array in arrays.values()} == {np.dtype(np.float64)}


def test_python_numbers_alone_compute_in_float64() -> None:
    arrays = real_arrays({"r": 1, "azimuth": 2.0})
    assert {array.dtype for array in arrays.values()} == {np.dtype(np.float64)}


def enumerate_names(values: list[Any]) -> list[tuple[str, Any]]:
    return [(f"argument {number}", value) for number, value in enumerate(values)]


def test_a_python_number_beyond_float32_beside_float32_arrays_is_refused() -> None:
    with pytest.raises(ValueError, match=r"^range_std must be at most 3.402823e\+38 .* float32; got 1e\+60$"):
        real_arrays({"r": np.ones(2, np.float32), "range_std": 1e60})


@pytest.mark.parametrize("bad", [math.nan, math.inf, -math.inf])
@pytest.mark.parametrize("domain", DOMAINS.values(), ids=DOMAINS)
@given(data=st.data())
def test_what_is_not_finite_is_refused_with_count_and_first(bad: float, domain: Domain, data: st.DataObject) -> None:
    values = data.draw(hnp.arrays(np.float64, hnp.array_shapes(max_dims=3), elements=st.just(0.5)))
    places = data.draw(st.sets(st.integers(0, values.size - 1), min_size=1))
    values.flat[list(places)] = bad
    first = ", ".join(map(str, np.unravel_index(min(places), values.shape)))
    with pytest.raises(ValueError, match=r"^azimuth must be finite; ") as raised:
        require_within("azimuth", values, domain)
    expected = f"got {bad} at [{first}], the first of {len(places)} among {values.size}"
    assert str(raised.value).endswith(expected)


@pytest.mark.parametrize(
    ("domain", "double", "single"),
    [
        (RANGE, (0, 1e100), (0, 1e10)),
        (ANGLE, (-1e6, 1e6), (-1e3, 1e3)),
        (ANGLE_STD, (0, math.pi), (0, math.pi)),
        (CORRELATION, (-1, 1), (-1, 1)),
    ],
)
def test_intervals_are_as_documented(domain: Domain, double: tuple[float, float], single: tuple[float, float]) -> None:
    assert domain.bounds(np.dtype(np.float64)) == double
    assert domain.bounds(np.dtype(np.float32)) == single


@pytest.mark.parametrize("dtype", TYPES, ids=str)
@pytest.mark.parametrize("domain", DOMAINS.values(), ids=DOMAINS)
def test_the_ends_of_an_interval_belong_to_it_and_their_neighbours_do_not(domain: Domain, dtype: np.dtype[Any]) -> None:
    for end, beyond in zip(domain.bounds(dtype), (-np.inf, np.inf), strict=True):
        last = np.array([end], dtype)
        require_within("r", last, domain)
        with pytest.raises(ValueError, match=r"^r must be from .* to .*; got .* at \[0\], the first of 1 among 1$"):
            require_within("r", np.nextafter(last, dtype.type(beyond)), domain)


def test_out_of_place_numbers_are_counted_and_the_first_is_shown() -> None:
    values = np.ones((3, 4))
    values[1, 2] = -2.5
    values[2] = -7.0
    allowed = r"from 0 to 1e\+100 m in float64 \(squares of larger numbers overflow\)"
    with pytest.raises(
        ValueError, match=rf"^range_std must be {allowed}; got -2.5 at \[1, 2\], the first of 5 among 12$"
    ):
        require_within("range_std", values, RANGE)


def test_a_scalar_has_no_index() -> None:
    with pytest.raises(ValueError, match=r"^correlation must be from -1 to 1 in float64 \(.*\); got 1.5$"):
        require_within("correlation", np.array(1.5), CORRELATION)


def test_a_large_angle_std_is_told_that_it_means_nothing() -> None:
    with pytest.raises(
        ValueError, match=r"from 0 to 3.141592653589793 rad .*larger deviation says nothing about direction"
    ):
        require_within("azimuth_std", np.array(3.2), ANGLE_STD)


MODULES = (validation, consistency, fixed_gain.known_gains, frames.cartesian, frames.geodetic)


@pytest.mark.parametrize(
    "domain", dict.fromkeys(part for each in MODULES for part in vars(each).values() if isinstance(part, Domain))
)
def test_the_numbers_that_a_message_allows_are_allowed(domain: Domain) -> None:
    low, high = re.findall(r"[-+.e\d]+", domain.describe(np.dtype(np.float64)))[:2]
    require_within("the ends", np.array([float(low), float(high)]), domain)


def test_nothing_is_wrong_with_no_values() -> None:
    require_within("r", np.empty((0, 3)), RANGE)


@pytest.mark.parametrize("dtype", TYPES, ids=str)
def test_pi_as_rounded_to_the_type_is_allowed_as_angle_std(dtype: np.dtype[Any]) -> None:
    require_within("azimuth_std", np.array(math.pi, dtype), ANGLE_STD)


def test_the_word_that_is_allowed_is_returned() -> None:
    assert [one_of("method", word, METHODS) for word in METHODS] == list(METHODS)


@pytest.mark.parametrize(
    ("given", "closest"),
    [
        ("unbaised", "unbiased"),
        ("UNBIASED", "unbiased"),
        ("second-order", "second_order"),
        ("debiased", "unbiased"),
    ],
)
def test_an_unknown_word_gets_all_that_are_allowed_the_closest_first(given: str, closest: str) -> None:
    with pytest.raises(ValueError, match=rf"^method must be one of \['{closest}'.*; got '{given}'$") as raised:
        one_of("method", given, METHODS)
    assert all(repr(word) in str(raised.value) for word in METHODS)


@pytest.mark.parametrize("given", [None, 1, b"linear", ["linear"]])
def test_what_is_no_word_is_a_type_error(given: Any) -> None:
    with pytest.raises(TypeError, match=r"^method must be one of \['linear', .*; got "):
        one_of("method", given, METHODS)


@given(hnp.mutually_broadcastable_shapes(num_shapes=3))
def test_shapes_broadcast_as_numpy_says(shapes: hnp.BroadcastableShapes) -> None:
    arrays = {f"argument {number}": np.empty(shape) for number, shape in enumerate(shapes.input_shapes)}
    assert broadcast_shape(arrays) == shapes.result_shape


def test_shapes_that_do_not_broadcast_are_all_named() -> None:
    arrays = {
        "r": np.ones(3),
        "azimuth": np.ones((4, 1)),
        "range_std": np.ones(2),
        "azimuth_std": np.ones(()),
    }
    named = r"r \(3,\), azimuth \(4, 1\), range_std \(2,\), azimuth_std \(\)"
    with pytest.raises(ValueError, match=rf"^the shapes must broadcast; got {named}$"):
        broadcast_shape(arrays)


def test_trailing_shapes_are_compared() -> None:
    require_trailing_shape("covariance", np.ones((5, 2, 2)), (2, 2))
    with pytest.raises(ValueError, match=r"^covariance must have shape \(..., 2, 2\); got shape \(2, 5, 2\)$"):
        require_trailing_shape("covariance", np.ones((2, 5, 2)), (2, 2))
    with pytest.raises(ValueError, match=r"^mean must have shape \(..., 2\); got shape \(\)$"):
        require_trailing_shape("mean", np.array(1.0), (2,))


@pytest.mark.parametrize("dtype", TYPES, ids=str)
@given(
    std=st.tuples(st.just(0.0) | st.floats(1e-15, 1e6), st.just(0.0) | st.floats(1e-15, 3)),
    correlation=st.floats(-1, 1),
)
def test_every_covariance_made_from_deviations_and_a_correlation_passes(
    dtype: np.dtype[Any], std: tuple[float, float], correlation: float
) -> None:
    scaled = np.array(std, dtype)
    matrix = scaled[:, np.newaxis] * np.array([[1, correlation], [correlation, 1]], dtype) * scaled
    require_covariance("covariance", np.broadcast_to(matrix, (3, 2, 2)))


@pytest.mark.parametrize("dtype", TYPES, ids=str)
def test_rounding_of_a_covariance_is_tolerated_and_more_is_not(dtype: np.dtype[Any]) -> None:
    little, much = 1 + np.sqrt(np.finfo(dtype).eps) * np.array([0.5, 2])
    require_covariance("covariance", np.array([[[1, little], [little, 1]], [[1, 1], [little, 1]]], dtype))
    with pytest.raises(ValueError, match="positive semidefinite"):
        require_covariance("covariance", np.array([[1, much], [much, 1]], dtype))
    with pytest.raises(ValueError, match="symmetric"):
        require_covariance("covariance", np.array([[1, 1], [much, 1]], dtype))


@pytest.mark.parametrize(
    ("matrix", "allowed"),
    [
        ([[1.0, math.nan], [math.nan, 1.0]], "finite"),
        ([[math.inf, 0.0], [0.0, 1.0]], "finite"),
        ([[1.0, 0.0], [0.0, -1.0]], "without a negative variance"),
        ([[-1.0, 0.0], [0.0, 1.0]], "without a negative variance"),
        ([[1e6, 0.3], [0.4, 1e-6]], "symmetric"),
        ([[1e6, 1.1], [1.1, 1e-6]], "positive semidefinite"),
        ([[1e6, -1.1], [-1.1, 1e-6]], "positive semidefinite"),
        ([[0.0, 1e-9], [1e-9, 1.0]], "positive semidefinite"),
    ],
)
def test_what_is_no_covariance_is_refused_with_the_reason_and_the_first(
    matrix: list[list[float]], allowed: str
) -> None:
    matrices = np.tile(np.eye(2), (4, 1, 1))
    matrices[2] = matrix
    with pytest.raises(ValueError, match=rf"^covariance must be {allowed}; got ") as raised:
        require_covariance("covariance", matrices)
    assert "[2" in str(raised.value)
    with pytest.raises(ValueError, match=rf"^covariance must be {allowed}; got "):
        require_covariance("covariance", np.array(matrix))


@given(matrix=st.integers(1, 6).flatmap(strategies.covariances))
def test_every_covariance_is_taken_for_one(matrix: np.ndarray) -> None:
    """Of any rank, and however different the units of its quantities are."""
    require_covariance("matrix", matrix)


@given(least=st.floats(-1, -1e-6), scales=st.lists(st.floats(-8, 8), min_size=3, max_size=3))
def test_a_negative_eigenvalue_of_the_correlations_is_refused_though_each_correlation_is_possible(
    least: float, scales: list[float]
) -> None:
    """With correlations (c, c, -c) the least eigenvalue is 1 - 2c."""
    c = (1 - least) / 2
    deviations = 10.0 ** np.array(scales)
    matrix = np.array([[1, c, c], [c, 1, -c], [c, -c, 1]]) * np.outer(deviations, deviations)
    with pytest.raises(ValueError, match="matrix must be positive semidefinite; got"):
        require_covariance("matrix", matrix)


def test_a_domain_may_begin_above_zero() -> None:
    domain = Domain(" m", 10.0, 5.0, "why", smallest=2.0)
    require_within("r", np.array([2.0, 10.0]), domain)
    with pytest.raises(ValueError, match=r"r must be from 2 to 10 m in float64 \(why\); got 1.9"):
        require_within("r", np.array(1.9), domain)


@pytest.mark.parametrize(
    "read_one", [real_number, positive_number, lambda name, given: number_between(name, given, 1, 9)]
)
def test_one_real_number_is_read_as_a_float(read_one: Any) -> None:
    for given_number in (3, 3.0, np.float32(3), np.float16(3), np.int64(3), np.uint8(3), np.longdouble(3)):
        assert (read_one("x", given_number), type(read_one("x", given_number))) == (3.0, float)
    for none in (True, np.True_, "3", None, [3.0], np.array([3.0]), 3 + 0j):
        with pytest.raises(TypeError, match=r"^x must be a real number; got "):
            read_one("x", none)
    for far in (math.nan, math.inf, -math.inf, 10**400, -(10**400), 10**5000):
        with pytest.raises(ValueError, match=r"^x must be (finite|from 1 to 9); got "):
            read_one("x", far)


def test_numbers_out_of_bounds_are_refused() -> None:
    for low in (0, -1.0):
        with pytest.raises(ValueError, match=r"^x must be more than 0; got "):
            positive_number("x", low)
        with pytest.raises(ValueError, match=r"^x must be from 1 to 9; got "):
            number_between("x", low, 1, 9)
    assert [number_between("x", end, 1, 9) for end in (1, 9)] == [1, 9]


@pytest.mark.parametrize("dtype", TYPES, ids=str)
def test_variances_that_overflow_or_lose_digits_are_refused(dtype: np.dtype[Any]) -> None:
    limits = np.finfo(dtype)
    require_variances("c", np.array([limits.tiny, 1, limits.max, math.nan], dtype))
    for bad in (limits.tiny / 2, 0, math.inf, -1):
        with pytest.raises(ValueError, match=r"^c must be of variances from .* at \[1\]"):
            require_variances("c", np.array([1, bad], dtype))


@pytest.mark.parametrize("bad", [math.nan, math.inf, -math.inf])
def test_what_is_not_finite_is_told(bad: float) -> None:
    require_finite("x", np.ones((2, 2)))
    with pytest.raises(ValueError, match=r"^x must be finite; got .* at \[0, 1\], the first of 1 among 2"):
        require_finite("x", np.array([[1.0, bad]]))


def test_covariances_of_the_largest_numbers_do_not_overflow_in_the_check() -> None:
    require_covariance("covariance", np.full((3, 3), 1e308))
    with pytest.raises(ValueError, match="symmetric"):
        require_covariance("covariance", np.array([[1e308, -1e308], [1e308, 1e308]]))
