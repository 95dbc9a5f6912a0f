"""Progress is seen on terminals, and nothing of it elsewhere."""

import pytest
from rich.console import Console
from rich.progress import Progress, TextColumn

from radartrack._system import terminal
from radartrack._system.progress import progress_on_terminals


def work() -> None:
    with progress_on_terminals(TextColumn("{task.description}")) as progress:
        task = progress.add_task("first", total=2)
        progress.update(task, description="second", advance=1)
        progress.refresh()


def test_where_there_is_no_terminal_nothing_is_written(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
):
    """Older versions of Rich end what was not shown with an empty line."""

    def stop(progress: Progress) -> None:
        progress.console.print()

    monkeypatch.setattr(Progress, "stop", stop)
    work()
    assert capsys.readouterr() == ("", "")


def test_on_a_terminal_it_is_seen_on_the_error_stream(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.setattr(terminal, "error_console", lambda: Console(stderr=True, force_terminal=True))
    work()
    out, err = capsys.readouterr()
    assert out == ""
    assert "second" in err
