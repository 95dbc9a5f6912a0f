"""A draft is a claims file whatever the source is, and its claims are what the paper says."""

import tomllib
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from typer.testing import CliRunner

from radartrack.cli import app
from radartrack.derive.checking.papers.claims_file import read_claims
from radartrack.derive.finding.paper_draft import Drafted, claims
from radartrack.derive.finding.paper_equations import equations, title
from radartrack.derive.finding.paper_readings import understood
from tests.derive.finding.printed_paper import PAPER

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
