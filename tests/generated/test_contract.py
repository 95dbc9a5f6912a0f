"""What every generated function promises whatever it computes: shapes, types, and what it refuses."""

import inspect
from collections.abc import Mapping

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

from radartrack.derive.catalogue import catalogue
from radartrack.derive.language.quantity import Quantity
from tests import conversions
from tests.examples import share

WITH_SYMBOLS = [quantity for quantity in catalogue().values() if quantity.symbols]
EACH = pytest.mark.parametrize("quantity", WITH_SYMBOLS, ids=conversions.ids)
OF_EACH_MODULE = pytest.mark.parametrize(
    "quantity", {quantity.module: quantity for quantity in WITH_SYMBOLS}.values(), ids=conversions.ids
)  # what arguments become is decided by code that a module's functions share


def example(quantity: Quantity) -> dict[str, float]:
    """A point amid the domain, exact in float32."""
    return {s.name: 0.5 if s.high <= 1 else 1.0 if s.high < 4 else max(s.low, 8.0) for s in quantity.symbols}


def whole(quantity: Quantity) -> dict[str, float]:
    """A point of ones, and zeros where ones are beyond the domain of a signed symbol."""
    return {s.name: float(not (s.low < 0 and s.high < 1)) for s in quantity.symbols}


def filled(point: Mapping[str, float], shapes: Mapping[str, tuple[int, ...]]) -> dict[str, np.ndarray]:
    """Arrays of these shapes with values near the point's, all different."""
    return {
        name: point[name] * (1 + np.arange(np.prod(shape, dtype=int)).reshape(shape) / 64)
        for name, shape in shapes.items()
    }


def assert_same(computed: np.ndarray, expected: np.ndarray, relative: float = 1e-13) -> None:
    assert computed.shape == expected.shape
    np.testing.assert_allclose(computed, expected, rtol=relative, atol=relative * np.abs(expected).max(initial=0.0))


@EACH
@given(data=st.data())
@share(0.06)
def test_arguments_broadcast_and_every_element_is_what_its_scalars_give(quantity: Quantity, data: st.DataObject):
    names = [symbol.name for symbol in quantity.symbols]
    drawn = data.draw(arrays.mutually_broadcastable_shapes(num_shapes=len(names), max_dims=3, max_side=3, min_side=0))
    given_arrays = filled(example(quantity), dict(zip(names, drawn.input_shapes, strict=True)))
    function = conversions.generated(quantity)
    result = function(**given_arrays)
    assert result.shape == drawn.result_shape + quantity.shape
    assert result.dtype == np.float64
    spread = dict(zip(names, np.broadcast_arrays(*given_arrays.values()), strict=True))
    for index in np.ndindex(drawn.result_shape):
        assert_same(result[index], function(**{name: float(array[index]) for name, array in spread.items()}))


@EACH
def test_one_array_among_scalars_shapes_every_entry_constants_included(quantity: Quantity):
    point = example(quantity)
    for name in point:
        result = conversions.generated(quantity)(**point | filled(point, {name: (2, 3)}))
        assert result.shape == (2, 3, *quantity.shape)
        assert np.isfinite(result).all()


@OF_EACH_MODULE
def test_scalars_of_every_kind_give_the_tensor_alone(quantity: Quantity):
    point, function = example(quantity), conversions.generated(quantity)
    plain = function(**point)
    assert np.shape(plain) == quantity.shape
    for kind in (np.float64, np.array):
        np.testing.assert_array_equal(function(**{name: kind(value) for name, value in point.items()}), plain)


@EACH
def test_scalar_formulas_give_numbers_not_arrays_without_axes(quantity: Quantity):
    result = conversions.generated(quantity)(**example(quantity))
    assert isinstance(result, np.ndarray if quantity.shape else np.float64)


@OF_EACH_MODULE
def test_empty_arrays_give_empty_results(quantity: Quantity):
    result = conversions.generated(quantity)(**filled(example(quantity), dict.fromkeys(example(quantity), (0, 2))))
    assert result.shape == (0, 2, *quantity.shape)


@OF_EACH_MODULE
def test_arrays_of_single_precision_give_single_precision(quantity: Quantity):
    point, function = example(quantity), conversions.generated(quantity)
    single = function(**{name: np.array([value], dtype=np.float32) for name, value in point.items()})
    assert single.dtype == np.float32
    assert_same(single[0], np.asarray(function(**point)), relative=2e-5)


@OF_EACH_MODULE
def test_python_numbers_follow_arrays_of_single_precision(quantity: Quantity):
    point, function = example(quantity), conversions.generated(quantity)
    first = next(iter(point))
    assert function(**point | {first: np.array([point[first]], dtype=np.float32)}).dtype == np.float32


@OF_EACH_MODULE
def test_one_array_of_double_precision_makes_the_result_double(quantity: Quantity):
    point = {name: np.array([value], dtype=np.float32) for name, value in example(quantity).items()}
    first = next(iter(point))
    assert conversions.generated(quantity)(**point | {first: point[first].astype(float)}).dtype == np.float64


@OF_EACH_MODULE
@pytest.mark.parametrize("dtype", [int, np.int8, np.uint64, np.float16, np.longdouble, bool])
def test_other_real_types_compute_in_double_precision(quantity: Quantity, dtype: type):
    point, function = whole(quantity), conversions.generated(quantity)
    result = function(**{name: np.array([value], dtype=dtype) for name, value in point.items()})
    assert result.dtype == np.float64
    np.testing.assert_array_equal(result, function(**{name: np.array([value]) for name, value in point.items()}))


@OF_EACH_MODULE
def test_lists_are_arrays(quantity: Quantity):
    point, function = example(quantity), conversions.generated(quantity)
    listed = function(**{name: [value, value] for name, value in point.items()})
    np.testing.assert_array_equal(listed, function(**{name: np.array([value] * 2) for name, value in point.items()}))


@pytest.mark.parametrize(
    "bad",
    [1j, np.array([1 + 0j]), "1", np.array(["1"]), None, object()],
    ids=lambda bad: type(bad).__name__ + np.asarray(bad).dtype.kind,
)
@OF_EACH_MODULE
def test_what_is_no_real_number_is_refused(quantity: Quantity, bad: object):
    for name in example(quantity):
        with pytest.raises((TypeError, ValueError)):
            conversions.generated(quantity)(**example(quantity) | {name: bad})


@OF_EACH_MODULE
def test_shapes_that_do_not_broadcast_are_refused(quantity: Quantity):
    point = example(quantity)
    first, *_, last = [*point, *point]
    if len(point) > 1:
        with pytest.raises(ValueError, match="broadcast"):
            conversions.generated(quantity)(**point | {first: np.ones(2), last: np.ones(3)})


@EACH
def test_arguments_are_the_symbols_by_keyword_only(quantity: Quantity):
    function, point = conversions.generated(quantity), example(quantity)
    parameters = inspect.signature(function).parameters
    assert list(parameters) == [symbol.name for symbol in quantity.symbols]
    assert {parameter.kind for parameter in parameters.values()} == {inspect.Parameter.KEYWORD_ONLY}
    for call in ({}, {**point, "azimut": 1.0}):
        with pytest.raises(TypeError):
            function(**call)
    with pytest.raises(TypeError):
        function(*point.values())


@OF_EACH_MODULE
def test_arguments_are_left_alone_and_share_no_memory_with_the_result(quantity: Quantity):
    given_arrays = filled(example(quantity), dict.fromkeys(example(quantity), (3,)))
    copies = {name: array.copy() for name, array in given_arrays.items()}
    result = conversions.generated(quantity)(**given_arrays)
    result[...] = -1.0
    for name, array in given_arrays.items():
        np.testing.assert_array_equal(array, copies[name])


@EACH
def test_the_docstring_says_what_a_user_must_know(quantity: Quantity):
    text = " ".join((conversions.generated(quantity).__doc__ or "").split())
    facts = [quantity.name, quantity.word, quantity.conditioning.value, str(quantity.source), "Accuracy: "]
    facts += [f"{symbol.name}: {symbol.meaning} [{symbol.unit}]" for symbol in quantity.symbols]
    for fact in facts:
        assert " ".join(fact.split()) in text


@EACH
def test_results_are_finite_at_the_corners_of_the_domain(quantity: Quantity):
    ends = ([s.low, s.high] for s in quantity.symbols)
    corners = np.meshgrid(*ends, indexing="ij")
    result = conversions.generated(quantity)(
        **{s.name: corner for s, corner in zip(quantity.symbols, corners, strict=True)}
    )
    assert np.isfinite(result).all()
