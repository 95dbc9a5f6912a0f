"""A draft holds every displayed equation of a source, with its number, and is a claims file whatever the source is."""

from __future__ import annotations

import tomllib
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from typer.testing import CliRunner

from radartrack.cli import app
from radartrack.derive.checking.papers.claims_file import read_claims
from radartrack.derive.finding.paper_draft import (
    Drafted,
    claims,
    defined,
    definitions_in_text,
    equations,
    title,
    understood,
    with_definitions,
)
from radartrack.derive.formula.printing import to_text

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
    known = defined(found)
    tree = with_definitions(found[2], known)
    assert tree is not None
    assert to_text(tree) == "(2*c + 1)**2"
    circle = understood(equations(r"\[b = c + 1\] \[c = b - 1\] \[d = b c\]"))
    assert with_definitions(circle[2], defined(circle)) is None


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


@pytest.mark.parametrize("inline", ["$%s$", r"\(%s\)"])
def test_what_is_defined_in_the_text_is_known_and_no_equation(inline: str) -> None:
    said = inline % r"\lambda = e^{-\sigma_\theta^2/2}"
    source = (
        rf"With {said}, where $k = 1, \ldots, n$, $T = 10$ and $P$: \[ x^u = \lambda^{{-1}} r\cos\theta \] costs \$5"
    )
    assert [one.left for one in equations(source)] == ["x^u"]
    found = defined(definitions_in_text(source))
    assert {name: to_text(tree) for name, tree in found.items()} == {"lambda": "e**(-sigma_theta**2/2)"}
