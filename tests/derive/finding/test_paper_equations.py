"""Every equation of a source is read, with its number, whatever stands around it."""

import pytest

from radartrack.derive.finding.paper_equations import equations
from radartrack.derive.finding.paper_readings import understood
from radartrack.derive.formula.printing import to_text
from radartrack.derive.formula.tree import names
from tests.derive.finding.printed_paper import PAPER


def test_equations_have_the_numbers_and_labels_of_print() -> None:
    found = [(one.number, one.label, one.left) for one in equations(PAPER)]
    assert found == [
        ("1", "eq:lambda", r"\lambda"),
        ("", "", "x"),
        ("2", "eq:y", "y"),
        ("8b", "", "b_x"),
        ("3", "", "Q_{11}"),
        ("", "", "w"),
        ("", "", "A"),
    ]


@pytest.mark.parametrize(
    "display",
    [
        r"\[ %s \]",
        "$$ %s $$",
        r"\begin{equation} %s \end{equation}",
        r"\begin{equation*} %s. \end{equation*}",
        r"\begin{gather} %s, \label{a} \end{gather}",
        r"\begin{align*} %s \end{align*}",
        r"\begin{equation}\begin{split} %s \end{split}\end{equation}",
        r"\begin{eqnarray} %s \nonumber \end{eqnarray}",
        r"\begin{multline} %s \tag{3} \end{multline}",
    ],
)
def test_a_formula_is_read_out_of_every_display(display: str) -> None:
    (one,) = understood(equations(display % r"x &= \rho\cos\theta"))
    assert one.tree is not None
    assert to_text(one.tree) == "rho*cos(theta)"
    assert one.name == "x"


@pytest.mark.parametrize("row", [r"&\quad + ", r"& - ", r"&\qquad{} + ", r"\times", r"\cdot & "])
@pytest.mark.parametrize(
    "display",
    [r"\begin{align} %s \nonumber \end{align}", r"\begin{equation}\begin{split} %s \end{split}\end{equation}"],
)
def test_a_row_that_sets_nothing_goes_on_with_the_equation_before_it(row: str, display: str) -> None:
    (one,) = understood(equations(display % (r"R_{11} &= a^2 \\ " + row + r" b^2 ")))
    assert one.tree is not None
    assert names(one.tree) == {"a", "b"}
    assert one.equation.number == "1"


def test_an_author_s_commands_and_systems_behind_a_brace_are_equations_too() -> None:
    source = r"""
    \newcommand{\be}{\begin{equation}} \newcommand{\ee}{\end{equation}} \newcommand{\sq}[1]{#1^{2}}
    \be d = \sqrt{\sq{x} + \sq{y}} \ee
    \be \begin{cases} x = r\cos\theta \\ y = r\sin\theta \end{cases} \ee
    """
    found = understood(equations(source))
    assert [(one.equation.number, to_text(one.tree) if one.tree else "") for one in found] == [
        ("1", "sqrt(x**2 + y**2)"),
        ("2", "r*cos(theta)"),
        ("2", "r*sin(theta)"),
    ]


@pytest.mark.parametrize("between", [r", \quad ", r" \qquad ", "; ", r"\text{ and } ", ", "])
def test_equations_beside_each_other_are_two(between: str) -> None:
    source = r"\begin{equation} x = r\cos\theta" + between + r"y = f(r, \theta) + r\sin\theta \end{equation}"
    assert [(one.left, one.number) for one in equations(source)] == [("x", "1"), ("y", "1")]


def test_what_is_no_equation_stays_with_the_one_before_it() -> None:
    (found,) = equations(r"\[ P = \begin{bmatrix} a, & b \\ b, & c = 1 \end{bmatrix}, \quad j, k \]")
    assert found.left == "P"
