"""Trees are worth the same in every way of evaluating them, and what a part would have to be worth makes it so."""

import math

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from radartrack.derive.checking.repairing.monomial_fit import Fitter
from radartrack.derive.evaluation.tree_values import Program, Screen, close
from radartrack.derive.formula.tree import Name, Tree, children, walk, with_children
from radartrack.derive.reading.text import read_text
from tests.derive.formula.random_trees import NAMES, scalars

SIZE = 3
VALUES = {name: (0.3 + 0.1 * place, 1.7 - 0.1 * place, 0.9) for place, name in enumerate(NAMES)}


@given(scalars)
def test_a_program_gives_what_a_walk_over_the_tree_gives(tree: Tree) -> None:
    screen = Screen(VALUES, SIZE)
    program = Program(tree)
    found = [program({name: values[place] for name, values in VALUES.items()}) for place in range(SIZE)]
    values = screen(tree)
    if values is not None:
        assert all(close(one, (value,)) for one, value in zip(found, values, strict=True))


def test_a_program_without_a_real_value_has_none() -> None:
    assert Program(read_text("(r - 2)**(1/2)", {"r"}))({"r": 1.0}) is None
    assert Program(read_text("1/(r - 1)", {"r"}))({"r": 1.0}) is None


@given(scalars, st.one_of(st.floats(0.5, 2), st.floats(-2, -0.5)))
@example(read_text("-asin(pi/pi)", NAMES), 1.5)
@example(read_text("abs(r)", NAMES), -1.0)
@example(read_text("acos(r/9)", NAMES), -1.0)
@example(read_text("atan2(r, 1)", NAMES), 2.0)
@example(read_text("hypot(r, 1)", NAMES), -1.5)
def test_a_part_that_is_worth_what_is_required_makes_the_whole_worth_what_is_needed(tree: Tree, factor: float) -> None:
    screen = Screen(VALUES | {"wanted": (0.0,) * SIZE}, SIZE)
    for _, node in walk(tree):
        values = screen(node)
        if values is None or not all(1e-3 < abs(value) < 1e3 for value in values):
            continue
        needed = tuple(value * factor for value in values)
        for place, required in enumerate(screen.required(node, needed)):
            if required is not None and all(1e-3 < abs(value) < 1e3 for value in required):
                changed = [*children(node)]
                changed[place] = Name("wanted")
                again = Screen(VALUES | {"wanted": required}, SIZE)(with_children(node, tuple(changed)))
                assert again is None or _near(again, needed)


def _near(first: tuple[float, ...], second: tuple[float, ...]) -> bool:
    return all(math.isclose(a, b, rel_tol=1e-6, abs_tol=1e-6) for a, b in zip(first, second, strict=True))


@pytest.mark.parametrize("formula", ["atan2(r, {})", "atan2({}, r)", "hypot(r, {})", "hypot({}, r)"])
def test_what_a_side_of_a_triangle_would_have_to_be_follows_from_the_angle_and_the_hypotenuse(formula: str) -> None:
    screen = Screen({"r": (0.3, 1.7, 0.9), "s": (0.4, 1.1, 2.5)}, SIZE)
    needed = screen(read_text(formula.format("s"), {"r", "s"}))
    assert needed is not None
    printed = read_text(formula.format("3*s"), {"r", "s"})
    assert any(close(required, (0.4, 1.1, 2.5)) for required in screen.required(printed, needed))


def test_a_fit_finds_the_powers_and_sees_what_is_no_monomial() -> None:
    screen = Screen(
        {name: tuple(0.3 + (7 * i + 3 * j) % 11 / 9 for j in range(12)) for i, name in enumerate("abc")}, 12
    )
    factors = [(Name(name), values) for name, values in screen.names.items()]
    fitter = Fitter(factors, 12)
    found = fitter.fit(screen(read_text("-3/2*a**3/b", {"a", "b"})))
    assert found is not None
    assert str(found.number) == "-3/2"
    assert found.powers == ((Name("a"), 3), (Name("b"), -1))
    for other in ("a + b", "a**2 + 1e-6*c", "sin(a)*b", "a**(1/2)"):
        assert fitter.fit(screen(read_text(other, {"a", "b", "c"}))) is None
