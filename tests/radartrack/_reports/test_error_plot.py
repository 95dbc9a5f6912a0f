"""The picture of rounding errors: what it shows, and what cannot be asked for."""

from pathlib import Path

import pytest
from typer.testing import CliRunner

from radartrack.cli import app
from radartrack.derive.catalogue import catalogue
from radartrack.verification.errors_over_domain import errors_over_domain

pytest.importorskip("matplotlib")
NAME = "polar.bias.truth"


def test_the_stable_form_keeps_the_digits_that_the_textbook_form_loses():
    found = errors_over_domain(catalogue()[NAME], 60)
    assert found.stable.max() < 5
    assert found.textbook.max() > 1e6


def test_there_is_a_panel_for_every_argument_that_varies(tmp_path: Path):
    result = CliRunner().invoke(app, ["verify", NAME, "--plot", str(tmp_path / "f.svg")])
    assert result.exit_code == 0, result.output
    from radartrack._reports.error_plot import error_plot  # noqa: PLC0415 - matplotlib is an extra

    picture = error_plot(errors_over_domain(catalogue()[NAME], 30), {"double": 8.01})
    shown = [axes.get_xlabel() for axes in picture.figure.axes if axes.get_visible()]
    assert shown == [f"{s.name} [{s.unit}]" for s in catalogue()[NAME].symbols if not s.is_correlation]
    assert picture.svg() == picture.svg()


@pytest.mark.parametrize(
    ("file", "names"), [("f.pdf", [NAME]), ("f.svg", ["polar.bias"]), ("f.svg", ["line.folded_mean_factor"])]
)
def test_what_cannot_be_drawn_is_told(file: str, names: list[str], tmp_path: Path):
    result = CliRunner().invoke(app, ["verify", *names, "--plot", str(tmp_path / file)])
    assert result.exit_code == 2
    assert not (tmp_path / file).exists()


def test_what_is_asked_for_beside_a_plot_is_refused_and_not_left_out(tmp_path: Path):
    asked = ["--plot", str(tmp_path / "f.svg"), "--worst", str(tmp_path / "worst.json")]
    result = CliRunner().invoke(app, ["verify", NAME, *asked])
    assert result.exit_code == 2
    assert "one at a time" in result.output
    assert not list(tmp_path.iterdir())
