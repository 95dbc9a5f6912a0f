"""A draft holds every displayed equation of a source, with its number, and is a claims file whatever the source is."""

from __future__ import annotations

import tomllib
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from typer.testing import CliRunner

from radartrack.cli import app
from radartrack.derive.checking.papers.claims_file import read_claims
from radartrack.derive.finding.formula_search import Candidate
from radartrack.derive.finding.paper_draft import (
    Drafted,
    Understood,
    beside,
    claims,
    defined,
    equations,
    equations_in_text,
    is_credible,
    readings,
    title,
    understood,
)
from radartrack.derive.formula.printing import to_text
from radartrack.derive.formula.tree import names
from radartrack.derive.reading.any_letters import read_loosely

PAPER = r"""
\documentclass{article}\title{On \emph{converted} measurements}
\begin{document}
\begin{equation}\label{eq:lambda} \lambda = e^{-\sigma_\theta^2/2} \end{equation}
\begin{align} x &= \rho\cos\theta, \nonumber \\ y &= \rho\sin\theta. \label{eq:y} \end{align}
\[ b_x = \rho\lambda\cos\theta - \rho\cos\theta \tag{8b} \]
% \begin{equation} commented = 1 \end{equation}
\begin{equation} Q_{11} = \frac{q T^3}{3} \end{equation}
\begin{equation*} w = \alpha\beta\gamma + \delta^7 \end{equation*}
$$ A = \begin{bmatrix} 1 & T \\ 0 & 1 \end{bmatrix} $$
"""


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


def test_definitions_are_put_in_and_circles_are_left_alone() -> None:
    found = understood(equations(r"\[a = b + 1\] \[b = 2 c\] \[d = a^2\] "))
    assert said_by(found[2], found) == ["(2*c + 1)**2", "(b + 1)**2", "a**2"]
    circle = understood(equations(r"\[b = c + 1\] \[c = b - 1\] \[d = b c\]"))
    assert said_by(circle[2], circle)[-1] == "b*c"


def said_by(one: Understood, everything: Sequence[Understood]) -> list[str]:
    """The readings of an equation, as text."""
    return [to_text(tree) for tree, _ in readings(one, defined(everything), beside(one, everything))]


def test_what_is_measured_with_an_error_is_not_put_in_unless_all_is() -> None:
    found = understood(equations(r"\[r_m = r + \tilde r\] \[\lambda = e^{-\sigma^2}\] \[x = \lambda r_m\]"))
    assert said_by(found[2], found) == ["e**(-sigma**2)*(r + r_tilde)", "e**(-sigma**2)*r_m", "lambda*r_m"]


def test_where_definitions_go_in_a_circle_those_of_the_same_display_are_put_in() -> None:
    source = r"\[ x = r a \] \[ y = r b \] \[ z = r c \] \[ H = x/r, \quad r = \sqrt{x^2 + y^2 + z^2} \]"
    found = understood(equations(source))
    assert "x/sqrt(x**2 + y**2 + z**2)" in said_by(found[3], found)


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


CLASSIC = r"""
\begin{equation} \rho_m = \rho + \tilde\rho,\qquad \theta_m = \theta + \tilde\theta \end{equation}
\begin{align} x_m &= \rho_m \cos\theta_m, \\ y_m &= \rho_m \sin\theta_m. \end{align}
With $\lambda_\theta = e^{-\sigma_\theta^2/2}$ and $\lambda'_\theta = \lambda_\theta^4$,
\begin{equation}\begin{split} R_{11} &= (\lambda_\theta^{-2} %s 2)\rho_m^2\cos^2\theta_m \\
&\quad + \tfrac{1}{2}(\rho_m^2+\sigma_\rho^2)(1+\lambda'_\theta\cos 2\theta_m) \end{split}\end{equation}
"""


@pytest.mark.parametrize(("sign", "said"), [("-", "polar.unbiased.covariance[0,0]"), ("+", "the sign of 2")])
def test_a_paper_s_own_words_lead_to_the_quantity_and_to_its_slip(sign: str, said: str, tmp_path: Path) -> None:
    source, out = tmp_path / "paper.tex", tmp_path / "paper.toml"
    source.write_text(CLASSIC % sign)
    assert CliRunner().invoke(app, ["draft", str(source), "--out", str(out)]).exit_code == 0
    *_, first, second, last = read_claims(out).claims
    assert (first.quantity, second.quantity) == ("polar.map[0]", "polar.map[1]")
    assert said in (last.quantity or last.undecided)
    assert "polar.unbiased.covariance[0,0]" in (last.quantity or last.undecided)


@given(st.text(st.sampled_from(list("\\begin{equation}[]$&=xy^_%\n\"'\x00é{}()2 ")), max_size=80), st.text(max_size=20))
def test_whatever_the_source_is_the_draft_is_a_claims_file(body: str, said: str) -> None:
    found = understood(equations(f"\\[ {body} = x \\] \\title{{{said}}} \\begin{{equation}} y = 2 \\end{{equation}}"))
    text = claims(title(f"\\title{{{said}}}"), [Drafted(one) for one in found])
    data = tomllib.loads(text)
    assert len(data.get("claim", [])) == len(found)
    assert len({claim["id"] for claim in data.get("claim", [])}) == len(found)


def test_a_paper_is_drafted_into_claims_that_are_equal(tmp_path: Path) -> None:
    source, out = tmp_path / "paper.tex", tmp_path / "paper.toml"
    source.write_text(PAPER)
    result = CliRunner().invoke(app, ["draft", str(source), "--out", str(out)])
    assert result.exit_code == 0
    assert "7 equations: 7 read, 5 found in the catalogue, 2 undecided" in result.output
    by_id = {claim.id: claim for claim in read_claims(out).claims}
    assert by_id["eq_y"].quantity == "polar.map[1]"
    assert by_id["eq8b"].let == {"lambda": "e**(-sigma_beta**2/2)"}
    assert "lambda" in by_id["eq8b"].formula
    assert "5 equal" in CliRunner().invoke(app, ["audit", str(out)]).output


@pytest.mark.parametrize("step", [r"\mathbf{x}_{k+1}", r"x_{k|k-1}", r"\hat{x}(k+1)", r"x_{n - 1}"])
def test_a_step_of_a_filter_defines_nothing_and_is_no_quantity_by_chance(step: str, tmp_path: Path) -> None:
    source, out = tmp_path / "paper.tex", tmp_path / "paper.toml"
    source.write_text(rf"\[ {step} = F x_k + w_k \] \[ H = \frac{{x}}{{r}}, \quad r = \sqrt{{x^2 + y^2}} \]")
    assert CliRunner().invoke(app, ["draft", str(source), "--out", str(out)]).exit_code == 0
    first, second, _ = read_claims(out).claims
    assert first.undecided
    assert second.quantity == "observe.polar.jacobian[0,0]"
    assert second.let == {"r": "sqrt(x**2 + y**2)"}


@pytest.mark.parametrize("text", ["", "no equation", r"\begin{equation} x \end{equation}"])
def test_a_source_without_equations_is_refused(tmp_path: Path, text: str) -> None:
    source = tmp_path / "paper.tex"
    source.write_text(text)
    assert CliRunner().invoke(app, ["draft", str(source)]).exit_code == 2
    assert CliRunner().invoke(app, ["draft", str(tmp_path / "missing.tex")]).exit_code == 2


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
