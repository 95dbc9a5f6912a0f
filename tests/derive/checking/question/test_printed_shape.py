"""Matrices of several axes that a quantity of one axis is compared with."""

from itertools import product

import pytest

from radartrack.derive import check
from radartrack.derive.checking.question.printed_shape import blocks_of, reshaped
from radartrack.derive.checking.reporting.verdict import Outcome, Verdict
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.language.tensor import Tensor, indices

TRANSITION = [["1", "T", "T**2/2"], ["0", "1", "T"], ["0", "0", "1"]]
ORDERS = ["axis by axis", "derivative by derivative"]


def spread(blocks: list[list[list[str]]], order: str) -> list[list[str]]:
    """The blocks for several axes in one matrix."""
    count, rows, columns = len(blocks), len(blocks[0]), len(blocks[0][0])
    found = [["0"] * (count * columns) for _ in range(count * rows)]
    for block, i, j in product(range(count), range(rows), range(columns)):
        place = (
            (i * count + block, j * count + block) if order == ORDERS[1] else (block * rows + i, block * columns + j)
        )
        found[place[0]][place[1]] = blocks[block][i][j]
    return found


def text(rows: list[list[str]]) -> str:
    return str(rows).replace("'", "")


def checked(blocks: list[list[list[str]]], order: str) -> Verdict:
    return check("motion.constant_acceleration.transition", text(spread(blocks, order)))


@pytest.mark.parametrize("order", ORDERS)
@pytest.mark.parametrize("axes", [2, 3])
def test_a_matrix_with_the_same_block_for_each_axis_is_compared_as_one(order: str, axes: int) -> None:
    right = checked([TRANSITION] * axes, order)
    assert right.verdict is Outcome.EQUAL
    assert any(f"one axis of {axes}" in remark for remark in right.remarks)
    wrong = checked([[["1", "T", "T**2/3"], *TRANSITION[1:]]] * axes, order)
    assert (wrong.verdict, wrong.suggestions[0].entry) == (Outcome.DIFFERS, (0, 2))


@pytest.mark.parametrize("order", ORDERS)
def test_an_axis_that_differs_is_compared_alone(order: str) -> None:
    other = [TRANSITION[0], ["0", "1", "2*T"], TRANSITION[2]]
    wrong = checked([TRANSITION, other], order)
    assert (wrong.verdict, wrong.suggestions[0].entry) == (Outcome.DIFFERS, (1, 2))
    assert "read for axis 2 of 2" in wrong.remarks


def noise(letter: str, half: str = "1/2") -> list[list[str]]:
    return [[f"{letter}*T**4/4", f"{half}*{letter}*T**3"], [f"{half}*{letter}*T**3", f"{letter}*T**2"]]


def checked_noise(blocks: list[list[list[str]]], **let: str) -> Verdict:
    return check("motion.constant_velocity.process_noise.piecewise", text(spread(blocks, ORDERS[1])), let=let)


def test_letters_may_differ_by_axis() -> None:
    right = checked_noise([noise("q_x"), noise("q_y"), noise("q_z")])
    assert right.verdict is Outcome.EQUAL
    assert any("one axis of 3" in remark and "q_y for q_x, q_z for q_x" in remark for remark in right.remarks)
    wrong = checked_noise([noise("q_x", "1/3"), noise("q_y", "1/3")])
    assert (wrong.verdict, wrong.suggestions[0].entry) == (Outcome.DIFFERS, (0, 1))
    other = checked_noise([noise("q_x"), noise("q_y", "1/3")])
    assert other.verdict is Outcome.DIFFERS


def test_letters_that_are_known_stand_for_no_others() -> None:
    both = {"a": "sigma_w^2", "b": "sigma_w^2"}
    assert checked_noise([noise("a"), noise("b")], **both).verdict is Outcome.EQUAL
    wrong = checked_noise([noise("a"), noise("b")], **{**both, "b": "2*sigma_w^2"})
    assert wrong.verdict is Outcome.DIFFERS
    with pytest.raises(FormulaError, match="noise_x is no name that is known here"):
        checked_noise([noise("noise_x"), noise("noise_y")])


def test_blocks_between_axes_have_letters_of_their_own() -> None:
    blocks = {place: [[f"R{place}", f"R{place}/T"], [f"R{place}/T", f"2*R{place}/T^2"]] for place in (11, 12, 22)}
    rows = [[*blocks[11][i], *blocks[12][i]] for i in (0, 1)] + [[*blocks[12][i], *blocks[22][i]] for i in (0, 1)]
    found = check("initiation.two_plots.covariance", text(rows), given={"first_covariance": "second_covariance"})
    assert found.verdict is Outcome.EQUAL


def test_a_column_for_each_axis_is_a_vector() -> None:
    printed: dict[tuple[int, ...], str] = {(0, 0): "a", (1, 0): "b", (2, 1): "a", (3, 1): "b"}
    entries = Tensor((4, 2), tuple(printed.get(index, 0) for index in indices((4, 2))))
    assert reshaped(entries, (2,)) == Tensor((2,), ("a", "b"))
    unlike = Tensor((4, 2), tuple({**printed, (3, 1): "c"}.get(index, 0) for index in indices((4, 2))))
    assert reshaped(unlike, (2,)) is unlike


@pytest.mark.parametrize("shape", [(3, 3), (4, 2), (2, 4), (2, 2), (5, 4)])
def test_a_matrix_of_another_size_has_no_blocks(shape: tuple[int, int]) -> None:
    assert not blocks_of(Tensor(shape, (0,) * (shape[0] * shape[1])), (2, 2))


def test_a_matrix_with_something_between_the_axes_has_no_blocks() -> None:
    assert not blocks_of(Tensor((4, 4), (1,) * 16), (2, 2))
