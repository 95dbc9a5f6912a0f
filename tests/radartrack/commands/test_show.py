"""`radartrack show`: every quantity and entry in every format, and hints for what is not there."""

import re
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from radartrack.cli import app
from radartrack.derive.catalogue import catalogue, find
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.writing import quantity_text
from radartrack.verification.domain_points import sample
from tests import conversions
from tests.written import module_of

POLAR = [find(f"polar.{row}") for row in ("map", "hessian", "bias.truth", "covariance.averaged", "std.position")]
FORMATS = {
    "text": quantity_text.text,
    "latex": quantity_text.latex,
    "python": quantity_text.python,
    "c": quantity_text.c,
}
COMMENTS = {"text": "", "latex": "% ", "python": "# ", "c": "// "}


def show(*arguments: str) -> str:
    result = CliRunner().invoke(app, ["show", *arguments])
    assert result.exit_code == 0, result.output
    return result.stdout


@pytest.mark.parametrize("kind", FORMATS)
@pytest.mark.parametrize("quantity", POLAR, ids=conversions.ids)
def test_heading_and_formula_are_shown_for_the_whole_and_for_every_entry(quantity: Quantity, kind: str):
    for index in [None, *(np.ndindex(quantity.shape) if quantity.shape else [])]:
        name = quantity.name if index is None else f"{quantity.name}[{','.join(map(str, index))}]"
        heading, _, formula = show(name, "--format", kind).partition("\n\n")
        assert formula == FORMATS[kind](quantity, index) + "\n"
        assert [line.removeprefix(COMMENTS[kind]) for line in heading.splitlines()] == quantity_text.heading(quantity)
        assert all(line.startswith(COMMENTS[kind]) for line in heading.splitlines())


@pytest.mark.parametrize("name", ["polar.covariance.averaged", "polar.bias.truth[0]", "polar.unbiased.covariance[0,1]"])
def test_what_is_shown_as_c_is_read_back_and_proved_equal(name: str):
    pytest.importorskip("tree_sitter_c")
    result = CliRunner().invoke(app, ["check", name, show(name, "--format", "c"), "--code", "c"])
    assert result.exit_code == 0, result.output
    assert "equal, proved" in result.output


@pytest.mark.parametrize("quantity", [q for q in catalogue().values() if q.module == "observe"], ids=conversions.ids)
def test_code_holds_all_that_it_uses(quantity: Quantity, tmp_path: Path):
    code = show(quantity.name, "--format", "python")
    points = sample(quantity, 3, seed=5)
    expected = conversions.generated(quantity)(**points)
    for n, row in enumerate(zip(*points.values(), strict=True)):
        values = "".join(f"{name} = {float(value)!r}\n" for name, value in zip(points, row, strict=True))
        assert np.asarray(module_of(values + code, tmp_path).result) == pytest.approx(
            expected[n], rel=1e-12, abs=1e-300
        )


def test_text_is_the_format_when_none_is_asked_for():
    assert show("polar.map") == show("polar.map", "--format", "text")


def test_blanks_in_an_index_do_not_matter():
    assert show("polar.jacobian[ 1 , 0 ]") == show("polar.jacobian[1,0]")


def test_a_heading_says_name_meaning_source_conditioning_and_symbols():
    text = show("polar.bias.truth")
    for fact in (
        "polar.bias.truth",
        "(e^L - 1) h",
        "truth-conditioned",
        "Lerro & Bar-Shalom 1993",
        "sigma_beta",
        "[rad]",
    ):
        assert fact in text


@pytest.mark.parametrize("name", ["polar.covariance.truth", "finite_sample.degree1.range.covariance", "line.slope"])
def test_a_heading_says_the_domain_in_which_formulas_are_compared(name: str):
    text = show(name)
    for symbol in find(name).symbols:
        (line,) = (line for line in text.splitlines() if line.startswith(f"{symbol.name}: "))
        low, high = line.rpartition("], ")[2].split(" to ")
        assert [float(low), float(high)] == pytest.approx([symbol.low, symbol.high], rel=1e-4)


@pytest.mark.parametrize(
    ("arguments", "hints"),
    [
        (["polar.mapp"], ["polar.mapp", "did you mean", "polar.map"]),
        (["sphericl.bias.truth"], ["spherical.bias.truth"]),
        (["xyz"], ["radartrack list"]),
        (["polar.map[2]"], ["polar.map[2]", "shape [2]", "count from 0"]),
        (["polar.map[0,0]"], ["shape [2]"]),
        (["polar.jacobian[0]"], ["shape [2, 2]"]),
        (["polar.map[-1]"], ["no name of a quantity"]),
        (["polar.map[]"], ["no name of a quantity"]),
        (["polar.map[a]"], ["no name of a quantity"]),
        (["polar.map[0"], ["no name of a quantity"]),
        (["polar map"], ["no name of a quantity"]),
        ([""], ["no name of a quantity"]),
        (["polar.map", "--format", "word"], ["text", "latex", "python"]),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, list) else None,
)
def test_what_is_not_there_is_answered_with_exit_code_two_and_a_hint(arguments: list[str], hints: list[str]):
    result = CliRunner(env={"COLUMNS": "200"}).invoke(app, ["show", *arguments])
    assert result.exit_code == 2
    said = re.sub(r"[\s│]+", " ", result.stderr)
    for hint in hints:
        assert hint in said
    assert "Traceback" not in result.output
