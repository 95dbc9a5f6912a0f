"""Files that `verify` writes of rounding errors alone: in one step, and nothing that is asked for is passed over."""

from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner, Result

from radartrack.cli import app
from radartrack.verification.rounding import certificates, worst_points

FILES = {"--prove": "proofs.json", "--worst": "worst.json", "--plot": "errors.svg"}
each_option = pytest.mark.parametrize(("option", "name"), FILES.items())


def verified(option: str, path: Path, *more: str) -> Result:
    return CliRunner().invoke(app, ["verify", "line.slope", option, str(path), *more])


@pytest.fixture
def quick(monkeypatch: pytest.MonkeyPatch) -> None:
    """Nothing is proved or searched for."""
    rows: Any = lambda *_: {}  # noqa: E731
    monkeypatch.setattr(certificates, "certificate", rows)
    monkeypatch.setattr(worst_points, "worst_point", rows)


@each_option
@pytest.mark.usefixtures("quick")
def test_a_file_that_was_there_is_replaced_in_one_step(option: str, name: str, tmp_path: Path) -> None:
    """What is written into an open file is half a file where the disk is full, and the old one is gone."""
    if option == "--plot":
        pytest.importorskip("matplotlib")
    if option == "--worst":
        pytest.importorskip("flint")
    path, second_name = tmp_path / name, tmp_path / "second name"
    path.write_text("before")
    second_name.hardlink_to(path)
    assert verified(option, path).exit_code == 0
    assert second_name.read_text() == "before"
    assert path.stat().st_size > 1000


@each_option
def test_a_record_of_layers_that_are_not_measured_is_refused(option: str, name: str, tmp_path: Path) -> None:
    result = verified(option, tmp_path / name, "--json", str(tmp_path / "record.json"))
    assert result.exit_code == 2
    assert "leave --json out" in " ".join(result.stderr.replace("│", " ").split())
    assert not list(tmp_path.iterdir())
