"""`radartrack reproduce`: what it writes, and what it says without matplotlib."""

import csv
import importlib
import importlib.util
from collections.abc import Iterator
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner, Result

from radartrack._system import written_files
from radartrack.cli import app
from radartrack.commands import audit, reproduce
from radartrack.reproduction.results import Reproduction

pytest.importorskip("matplotlib")
papers: Any = importlib.import_module("radartrack.reproduction.papers")


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[Result, Path]]:
    out = tmp_path_factory.mktemp("reproduction")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(audit, "decided", lambda papers, *_, **__: ([_verdicts(paper) for paper in papers], []))
        yield CliRunner().invoke(app, ["reproduce", "gorshkov", "--fast", "--out", str(out)]), out


def _verdicts(paper: Any) -> dict[str, Any]:
    """One claim of the paper, so that the page has a part of formulas too."""
    record = {"id": f"{paper.claims[0].id}", "verdict": "equal", "quantity": "q", "printed": "a", "reason": "proved"}
    return {"paper": paper.paper, "file": paper.name, "claims": [record | {"equation": "", "page": "", "note": ""}]}


def test_figures_data_findings_and_report_are_written(run: tuple[Result, Path]) -> None:
    result, out = run
    assert result.exit_code == 0
    names = {path.name for path in out.iterdir()}
    pictures = {f"gorshkov_figure_{n}.{kind}" for n in (1, 2, 3) for kind in ("svg", "png")}
    assert names == pictures | {
        "gorshkov_errors.csv",
        "gorshkov_gains.csv",
        "gorshkov_findings.csv",
        "report.html",
        "written.json",
    }
    with (out / "gorshkov_findings.csv").open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert {"what", "printed", "ours", "interval", "verdict", "remark"} == set(rows[0])
    assert "C of radar 4" in result.output
    assert "11.01" in result.output


class _Page(HTMLParser):
    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.images: list[dict[str, str | None]] = []
        self.links: list[str] = []
        self.ids: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        given = dict(attrs)
        self.ids += [given["id"] or ""] if "id" in given else []
        self.links += [given["href"] or ""] if "href" in given else []
        if tag == "img":
            self.images.append(given)
        elif tag not in {"input", "meta"}:
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag


def test_the_report_holds_everything_itself_and_links_lead_somewhere(run: tuple[Result, Path]) -> None:
    page = _Page()
    page.feed((run[1] / "report.html").read_text(encoding="utf-8"))
    assert page.open == []
    assert len(page.images) == 3
    assert all((image["src"] or "").startswith("data:image/svg+xml;base64,") for image in page.images)
    assert all(len(image["alt"] or "") > 60 for image in page.images)
    assert page.links
    assert all(link.startswith("#") and link[1:] in page.ids for link in page.links)
    assert len(page.ids) == len(set(page.ids))


def test_without_matplotlib_the_extra_is_named(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    found = importlib.util.find_spec
    monkeypatch.setattr(reproduce, "find_spec", lambda name: None if name == "matplotlib" else found(name))
    result = CliRunner().invoke(app, ["reproduce", "--out", str(tmp_path)])
    assert result.exit_code == 2
    assert "radartrack[plots]" in result.output


@pytest.mark.parametrize("name", ["report.html", "gao_findings.csv", "gao_figure_1.svg", "written.json"])
@pytest.mark.parametrize("written", [False, True], ids=["a stranger's", "edited"])
def test_what_was_not_written_by_the_command_or_was_edited_is_never_overwritten(
    tmp_path: Path, name: str, written: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(reproduce, "_written", None)
    written_files.write(tmp_path, "prosov_other.csv", "1,2")
    if written and name != "written.json":
        written_files.write(tmp_path, name, "ours")
    (tmp_path / name).write_text("mine")
    before = {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    result = CliRunner().invoke(app, ["reproduce", "gao", "--out", str(tmp_path)])
    assert result.exit_code == 2
    assert f"{name} is in the way" in result.stderr
    assert {path.name: path.read_bytes() for path in tmp_path.iterdir()} == before


def test_the_same_directory_takes_another_run_and_keeps_what_is_not_in_the_way(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    found = Reproduction("gao", "t", {}, ())
    monkeypatch.setattr(papers, "PAPERS", {"gao": papers.Paper(lambda *_: found, lambda _: iter(()))})
    monkeypatch.setattr(reproduce, "_report", lambda *_: "page")
    (tmp_path / "notes.txt").write_text("mine")
    (tmp_path / "gorshkov_findings.csv").write_text("mine")
    for _ in range(2):
        assert CliRunner().invoke(app, ["reproduce", "gao", "--out", str(tmp_path)]).exit_code == 0
    assert {path.name for path in tmp_path.iterdir()} == {
        "notes.txt", "gorshkov_findings.csv", "gao_findings.csv", "report.html", "written.json",
    }  # fmt: skip
    assert (tmp_path / "notes.txt").read_text() == (tmp_path / "gorshkov_findings.csv").read_text() == "mine"


def test_an_unknown_paper_and_a_file_in_the_way_are_refused(tmp_path: Path) -> None:
    assert CliRunner().invoke(app, ["reproduce", "nobody"]).exit_code == 2
    (tmp_path / "file").touch()
    result = CliRunner().invoke(app, ["reproduce", "gao", "--out", str(tmp_path / "file")])
    assert result.exit_code == 2
    assert "file" in result.output
