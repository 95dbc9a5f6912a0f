"""No command writes its result over what it was given to read."""

import shutil
from pathlib import Path

import pytest
from typer.testing import CliRunner

from radartrack.cli import app
from radartrack.derive.checking.papers.claims_file import shipped

MODEL = Path(__file__).parents[3] / "docs" / "examples" / "bistatic.toml"
PAPER = r"\begin{document}\begin{equation} x = r\cos\beta \end{equation}\end{document}"
CLAIMS = 'paper = "a"\n[[claim]]\nid = "b"\nundecided = "c"\n'
COMMANDS = {
    "audit, JSON": ["audit", "claims.toml", "--json", "claims.toml"],
    "audit, page": ["audit", "claims.toml", "--html", "link.toml"],
    "audit of models": ["audit", "claims.toml", "--model", "model.toml", "--json", "model.toml"],
    "audit of what is shipped": ["audit", "kalata", "--json", str(shipped("kalata")[0])],
    "draft": ["draft", "paper.tex", "--out", "paper.tex"],
    "points": ["points", "bistatic_w.map", "--model", "model.toml", "--out", "model.toml"],
    "verify": ["verify", "bistatic_w.map", "--model", "model.toml", "--json", "./model.toml"],
}


@pytest.mark.parametrize("arguments", COMMANDS.values(), ids=COMMANDS.keys())
def test_a_result_is_refused_in_the_place_of_what_is_read(
    arguments: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("claims.toml").write_text(CLAIMS, encoding="utf-8")
    Path("link.toml").symlink_to("claims.toml")
    Path("paper.tex").write_text(PAPER, encoding="utf-8")
    shutil.copy(MODEL, "model.toml")
    target = Path(arguments[-1])
    before = target.read_bytes()
    result = CliRunner().invoke(app, arguments)
    after = target.read_bytes()
    target.write_bytes(before)  # where this fails, what is shipped is as it was
    assert after == before
    assert result.exit_code == 2
    assert result.stderr.startswith(f"{arguments[-2]} must be a file that can be written; ")
    assert "is read" in result.stderr
