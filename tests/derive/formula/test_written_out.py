"""Arrays are written out entry by entry as the algebra of matrices has them, whatever their letters mean."""

from random import Random

import numpy as np
import pytest

from radartrack.derive.evaluation.tree_values import Program
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.tree import Name, Tree
from radartrack.derive.formula.written_out import array_of, written_out
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.reading.any_letters import read_loosely

LETTERS = "abcdfghklmnopqrs"
VALUES = {letter: Random(letter).uniform(-2, 2) for letter in LETTERS}
FOUR = "[[a, b, c, d], [b, a, c, d], [c, d, a, b], [d, c, a, a]]"
A, B, V = "[[a, b], [c, d]]", "[[f, g, h], [k, l, m]]", "[p, q]"
ARRAYS = {
    A: np.array([VALUES[letter] for letter in "abcd"]).reshape(2, 2),
    B: np.array([VALUES[letter] for letter in "fghklm"]).reshape(2, 3),
    V: np.array([VALUES[letter] for letter in "pq"]),
}


def worth(formula: str) -> np.ndarray:
    """The values of a formula of arrays, written out."""
    found = written_out(read_loosely(formula))
    assert found is not None
    values = [Program(entry)(VALUES) for entry in found]
    assert None not in values
    return np.array([value[0] for value in values if value]).reshape(found.shape)


@pytest.mark.parametrize(
    ("formula", "value"),
    [
        (f"{A}*{B}", ARRAYS[A] @ ARRAYS[B]),
        (f"{A}*{V}", ARRAYS[A] @ ARRAYS[V]),
        (f"{V}*{V}.T", np.outer(ARRAYS[V], ARRAYS[V])),
        (f"s^2*{A} - {A}.T/2", VALUES["s"] ** 2 * ARRAYS[A] - ARRAYS[A].T / 2),
        (f"{A}*diag(r, s)*{A}.T", ARRAYS[A] @ np.diag([VALUES["r"], VALUES["s"]]) @ ARRAYS[A].T),
        (f"{A}^3", np.linalg.matrix_power(ARRAYS[A], 3)),
        (f"{B}[0:2, 1:3]", ARRAYS[B][0:2, 1:3]),
        (f"{B}[1]", ARRAYS[B][1]),
        (f"{B}[:, 2]", ARRAYS[B][:, 2]),
        (f"trace({A}*{A})*eye(2)", np.trace(ARRAYS[A] @ ARRAYS[A]) * np.eye(2)),
        (f"kron({A}, {B})", np.kron(ARRAYS[A], ARRAYS[B])),
        (f"kron({B}.T, eye(2))", np.kron(ARRAYS[B].T, np.eye(2))),
        (f"outer({V}, {V}) + eye(2)", np.outer(ARRAYS[V], ARRAYS[V]) + np.eye(2)),
    ],
)
def test_what_is_written_out_has_the_values_of_the_arrays(formula: str, value: np.ndarray) -> None:
    assert worth(formula) == pytest.approx(value)


def test_names_that_stand_for_arrays_are_put_in() -> None:
    array: Tensor[Tree] = Tensor((2, 2), tuple(map(Name, "abcd")))
    found = written_out(read_loosely("J*J.T", ["J"], shapes={"J": (2, 2)}), {"J": array})
    assert found is not None
    assert found == written_out(read_loosely(f"{A}*{A}.T"))
    assert written_out(array_of(found)) == found


@pytest.mark.parametrize("formula", ["sum(j*a, j, 1, 3)", f"inv({FOUR})", "diff(a^2, a)", f"{A}^(1/2)"])
def test_what_has_to_be_worked_out_is_left(formula: str) -> None:
    assert written_out(read_loosely(formula)) is None


def test_products_of_many_matrices_are_refused_before_they_are_long() -> None:
    rows = "[[a+b+c, d+f], [g, h]]"
    with pytest.raises(FormulaError, match="more than"):
        written_out(read_loosely("*".join([f"{rows}^12"] * 2)))


def test_shapes_that_do_not_fit_are_refused() -> None:
    with pytest.raises(FormulaError, match="cannot be multiplied"):
        written_out(read_loosely(f"{B}*{A}"))
