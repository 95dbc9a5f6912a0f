"""Operations on arrays as a list."""

from typing import Any

import numpy as np
import pytest

from radartrack.verification.simulation.tracing import SUMMED, Tape, traced, with_products_summed


def played(tape: Tape, inputs: list[np.ndarray]) -> list[np.ndarray]:
    """With each operation looked up in NumPy by its name."""
    values: dict[int, Any] = dict(enumerate(inputs))
    values |= {place: number for number, place in tape.constants.items()}
    summed = {new: getattr(np, old) for old, new in SUMMED.items()}
    for step in tape.steps:
        operands = [values[place] for place in step.operands]
        if step.operation in summed:
            a, b, c, d = operands
            values[step.place] = summed[step.operation](a * b, c * d)
        else:
            values[step.place] = getattr(np, step.operation)(*operands)
    return [values[place] for place in tape.results]


def some_operations(arrays: list[Any]) -> list[Any]:
    a, b = arrays
    return [3.0 - a * b, np.float64(2.0) * np.sin(a) / b - -a, np.hypot(b, 3) ** 2 + np.arctan2(a, b), b, 7.0]


def test_the_list_does_what_the_function_did() -> None:
    inputs = list(np.random.default_rng(0).normal(size=(2, 9)))
    for found, expected in zip(played(traced(some_operations, 2), inputs), some_operations(inputs), strict=True):
        np.testing.assert_array_equal(found, expected)


def test_places_are_all_different() -> None:
    tape = traced(some_operations, 2)
    places = [0, 1, *tape.constants.values(), *(step.place for step in tape.steps)]
    assert sorted(places) == list(range(tape.places))


def test_what_is_asked_for_twice_is_done_once() -> None:
    tape = traced(lambda arrays: [np.cos(arrays[0] + 1.0) * np.cos(arrays[0] + 1.0)], 1)
    assert [step.operation for step in tape.steps] == ["add", "cos", "multiply"]


def products(arrays: list[Any]) -> list[Any]:
    a, b, c = arrays
    twice, kept, square = a * b, b * c, a * a
    return [twice + c, c - twice, kept, kept - a, square - c * c, 2.0 * a + b, b - 3.0 * c, square * c + a * c, a + b]


def test_sums_of_products_have_the_same_bits_and_products_needed_nowhere_else_are_not_kept() -> None:
    inputs = list(np.random.default_rng(1).normal(size=(3, 99)) * 10.0 ** np.arange(-49, 50))
    inputs[0][:4] = [0.0, -0.0, np.inf, np.nan]
    tape = traced(products, 3)
    summed = with_products_summed(tape)
    for found, expected in zip(played(summed, inputs), played(tape, inputs), strict=True):
        np.testing.assert_array_equal(found, expected)
    assert [step.operation for step in summed.steps if step.operation != "multiply"] == [
        "add", "subtract", "subtract", "difference of products", "sum of products", "difference of products",
        "sum of products", "add",
    ]  # fmt: skip
    assert sum(step.operation == "multiply" for step in summed.steps) == 3


def only_some(array: Any) -> Any:
    return np.exp(array, where=[True])


def with_an_array(array: Any) -> Any:
    return array + np.ones(3)


@pytest.mark.parametrize("more", [np.sum, np.add.accumulate, only_some, with_an_array, float])
def test_more_than_operations_on_arrays_and_numbers_is_refused(more: Any) -> None:
    with pytest.raises(TypeError):
        traced(lambda arrays: [more(arrays[0])], 1)
