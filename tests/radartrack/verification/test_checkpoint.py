"""A checkpoint belongs to one run: no other run and no stranger loses anything by it."""

import os
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from typer.testing import CliRunner, Result

from radartrack.cli import app
from radartrack.commands import verify
from radartrack.verification import campaign
from radartrack.verification.checkpoint import Checkpoint, NotACheckpoint
from radartrack.verification.engines import Local

KEYS = st.text(min_size=1, max_size=3)


def contents(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in folder.iterdir() if path.is_file()}


@given(
    done=st.dictionaries(KEYS, st.integers() | st.floats(allow_nan=False) | st.none(), min_size=1), cut=st.integers(0)
)
def test_what_a_killed_run_has_written_is_read_up_to_the_cut_and_the_run_goes_on(
    tmp_path_factory: pytest.TempPathFactory, done: dict[str, Any], cut: int
) -> None:
    path = tmp_path_factory.mktemp("run") / "kept.jsonl"
    first = Checkpoint(path, "a")
    for key, result in done.items():
        first.add(key, result)
    text = path.read_bytes()
    begun = text.index(b"\n") + 1  # the first line is there from the first moment
    path.write_bytes(text[: begun + cut % (len(text) - begun + 1)])
    again = Checkpoint(path, "a")
    assert again.done.items() <= done.items()
    assert len(done) - len(again.done) <= text.count(b"\n") - path.read_bytes().count(b"\n") + 1
    for key in done.keys() - again.done.keys():
        again.add(key, done[key])
    assert Checkpoint(path, "a").done == done
    again.finish()
    assert not path.exists()


@pytest.mark.parametrize("finishes", [True, False])
def test_a_run_neither_uses_nor_changes_the_checkpoint_of_another(tmp_path: Path, finishes: bool) -> None:
    path = tmp_path / "kept.jsonl"
    Checkpoint(path, "a").add("key", 1)
    before = path.read_bytes()
    other = Checkpoint(path, "b")
    other.add("key", 2)
    assert other.path != path
    assert path.read_bytes() == before
    assert Checkpoint(path, "b").done == {"key": 2}
    if finishes:
        other.finish()
        assert contents(tmp_path) == {path.name: before}
    assert Checkpoint(path, "a").done == {"key": 1}


def test_an_interrupted_run_finds_its_checkpoint_when_the_other_one_has_gone(tmp_path: Path) -> None:
    path = tmp_path / "kept.jsonl"
    first, second = Checkpoint(path, "a"), Checkpoint(path, "b")
    first.add("key", 1)
    second = Checkpoint(path, "b")
    second.add("key", 2)
    first.finish()
    assert Checkpoint(path, "b").done == {"key": 2}


STRANGE = [
    b"thesis\n", b"{}\n", b"[1]\n", b'{"digest": "a"}\n', b"\xff\xfe\0", b"\n", b"x" * 100_000, b"[" * 100_000,
    b'{"digest": "a", "key": 1, "result": 2}\n', b'{"digest": "cut sh',
]  # fmt: skip


@pytest.mark.parametrize("content", STRANGE, ids=lambda content: content[:20].decode(errors="replace"))
def test_any_other_file_is_refused_untouched(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "mine"
    path.write_bytes(content)
    with pytest.raises(NotACheckpoint, match="mine"):
        Checkpoint(path, "a")
    assert contents(tmp_path) == {"mine": content}


def test_what_is_no_file_is_refused(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "loop").symlink_to(tmp_path / "loop")
    for path in (tmp_path, tmp_path / "pipe", tmp_path / "loop"):
        with pytest.raises(NotACheckpoint):
            Checkpoint(path, "a")


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Any:
    """The command in an empty folder; the work is done at once."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(campaign, "QUICK", campaign.Effort(points=20, nodes=1, draws=1, mutants=0))

    def command(*arguments: str) -> Result:
        return CliRunner().invoke(app, ["verify", "line.slope", "--workers", "1", *arguments])

    return command


def interrupted(monkeypatch: pytest.MonkeyPatch) -> None:
    whole = Local.run

    def after_two(self: Local, tasks: Any) -> Any:
        for done, result in enumerate(whole(self, tasks)):
            if done == 2:
                raise KeyboardInterrupt
            yield result

    monkeypatch.setattr(Local, "run", after_two)


def test_a_finished_run_leaves_the_checkpoint_of_an_interrupted_one(
    run: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with monkeypatch.context() as patch:
        interrupted(patch)
        result = run("--points", "40")
        assert result.exit_code == 130
        assert verify.CHECKPOINT in result.stderr
    before = contents(tmp_path)
    assert list(before) == [verify.CHECKPOINT]
    for others in (["--points", "30"], ["polar.map", "--points", "40"], ["--seed", "1"]):
        assert " 0 failed." in run(*others).stdout
        assert contents(tmp_path) == before
    run("--points", "40")
    assert contents(tmp_path) == {}


def test_a_run_that_has_done_nothing_yet_promises_no_file(
    run: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def at_once(*_: Any) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(campaign.Campaign, "run", at_once)
    result = run()
    assert (result.exit_code, result.stderr) == (130, "")
    assert contents(tmp_path) == {}


@pytest.mark.parametrize("given", ["mine", ".", "missing/kept", "/proc/kept", "pipe"])
def test_a_place_that_is_not_for_a_checkpoint_is_refused_before_the_work(
    run: Any, tmp_path: Path, given: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "mine").write_text("thesis")
    os.mkfifo(tmp_path / "pipe")
    monkeypatch.setattr(campaign.Campaign, "run", None)
    result = run("--checkpoint", given)
    assert (result.exit_code, len(result.stderr.splitlines())) == (2, 1)
    assert "--checkpoint" in result.stderr
    assert contents(tmp_path) == {"mine": b"thesis"}


def test_without_being_asked_for_a_checkpoint_is_no_condition(run: Any, tmp_path: Path) -> None:
    (tmp_path / verify.CHECKPOINT).write_text("thesis")
    result = run()
    assert "No checkpoint is kept" in result.stderr
    assert "1 function," in result.stdout
    assert contents(tmp_path) == {verify.CHECKPOINT: b"thesis"}


def test_what_was_found_is_told_and_kept_when_the_record_cannot_be_written_in_the_end(
    run: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    found = campaign.Campaign.run

    def then_the_place_goes(self: campaign.Campaign, *given: Any) -> Any:
        records = found(self, *given)
        (tmp_path / "out").rmdir()
        return records

    (tmp_path / "out").mkdir()
    monkeypatch.setattr(campaign.Campaign, "run", then_the_place_goes)
    result = run("--json", "out/record.json")
    assert result.exit_code == 2
    assert result.stderr == f"{tmp_path}/out/record.json: No such file or directory\n"
    assert "1 function," in result.stdout
    assert verify.CHECKPOINT in contents(tmp_path)


@pytest.mark.parametrize("out", [".", "missing/record.json", "/proc/record.json", "claims", "radartrack-verify.jsonl"])
def test_a_record_that_cannot_be_written_is_refused_before_the_work(
    run: Any, tmp_path: Path, out: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "claims").symlink_to("missing/record.json")
    monkeypatch.setattr(campaign.Campaign, "run", None)
    result = run("--json", out)
    assert (result.exit_code, len(result.stderr.splitlines())) == (2, 1)
    assert result.stderr.startswith("--json must be a file that can be written; ")
