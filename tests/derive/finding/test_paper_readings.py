"""What a paper defines is known where it is used: in displays and sentences, with decorated letters, in circles."""

from collections.abc import Sequence
from dataclasses import replace

import pytest

from radartrack.derive.finding.formula_search import Candidate
from radartrack.derive.finding.paper_equations import equations, equations_in_text
from radartrack.derive.finding.paper_readings import Understood, beside, defined, is_credible, readings, understood
from radartrack.derive.formula.printing import to_text
from radartrack.derive.reading.any_letters import read_loosely


def said_by(one: Understood, everything: Sequence[Understood]) -> list[str]:
    """The readings of an equation, as text."""
    return [to_text(tree) for tree, _ in readings(one, defined(everything), beside(one, everything))]


def test_definitions_are_put_in_and_circles_are_left_alone() -> None:
    found = understood(equations(r"\[a = b + 1\] \[b = 2 c\] \[d = a^2\] "))
    assert said_by(found[2], found) == ["(2*c + 1)**2", "(b + 1)**2", "a**2"]
    circle = understood(equations(r"\[b = c + 1\] \[c = b - 1\] \[d = b c\]"))
    assert said_by(circle[2], circle)[-1] == "b*c"


def test_what_is_measured_with_an_error_is_not_put_in_unless_all_is() -> None:
    found = understood(equations(r"\[r_m = r + \tilde r\] \[\lambda = e^{-\sigma^2}\] \[x = \lambda r_m\]"))
    assert said_by(found[2], found) == ["e**(-sigma**2)*(r + r_tilde)", "e**(-sigma**2)*r_m", "lambda*r_m"]


def test_where_definitions_go_in_a_circle_those_of_the_same_display_are_put_in() -> None:
    source = r"\[ x = r a \] \[ y = r b \] \[ z = r c \] \[ H = x/r, \quad r = \sqrt{x^2 + y^2 + z^2} \]"
    found = understood(equations(source))
    assert "x/sqrt(x**2 + y**2 + z**2)" in said_by(found[3], found)


@pytest.mark.parametrize(
    "text", [r"with $\lambda = e^{-s^2/2}$ and", r"with \(\lambda = e^{-s^2/2}\),", r"$\mu=1, \lambda = e^{-s^2/2}$"]
)
def test_letters_are_defined_in_sentences_too_and_numbers_are_values_of_examples(text: str) -> None:
    source = text + r"\begin{equation} x = \lambda \mu r \end{equation} costs 5\$, and \[ y = 2 \] is $z = 3$"
    said = understood([*equations_in_text(source), *equations(source)])
    assert {name: to_text(tree) for name, tree in defined(said).items()} == {
        "lambda": "e**(-s**2/2)",
        "x": "lambda*mu*r",
    }


def test_letters_that_differ_by_what_decorates_them_are_two() -> None:
    source = r"$\lambda = e^{-s^2/2}$, $\lambda' = \lambda^4$ \[ R = \lambda^{-2} + \lambda' \] \[ S = 1 + \lambda' \]"
    said = understood([*equations_in_text(source), *equations(source)])
    assert said_by(said[3], said)[0] == "1 + (e**(-s**2/2))**4"


def test_a_letter_that_the_paper_defines_stands_for_nothing_that_it_never_means() -> None:
    candidate = Candidate("fading_memory.degree1[0]", "", "1 - theta**2", {"r": "theta"}, rank=4)
    known = {"r": read_loosely("sqrt(x**2 + y**2)")}
    assert not is_credible(candidate, known, {})
    assert is_credible(candidate, {}, {})
    assert is_credible(candidate, {"r": read_loosely("a + b")}, {})
    assert is_credible(replace(candidate, rank=0), known, {})
