"""Every command on terminals of any encoding, with streams that are closed or full, and with a hostile claims file."""

import errno
import io
import json
import os
import subprocess
import sys
import unicodedata
from collections.abc import Callable
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner, Result

from radartrack._regeneration import numpy_modules, output_directory
from radartrack.cli import app
from radartrack.commands import audit, reproduce
from radartrack.derive import catalogue
from radartrack.derive.checking.papers import deadline
from radartrack.reproduction.results import Finding, Reproduction
from radartrack.verification import campaign

ENCODINGS = ["ascii", "cp1252", "cp437", "latin-1", "cp1251", "koi8-r", "utf-8"]
SIGNS = "σ² − ½·β° … Müller Кузнецов 中 [bold] :smile: \\"
HAS_PICTURES = find_spec("matplotlib") is not None
FEW = {name: catalogue.find(name) for name in ("polar.map", "polar.bias.truth")}
ESCAPES = "\x1b[31m\x1b]0;t\x07\x9b31m\u202e\u2028\r\n"


def record(text: str) -> dict[str, Any]:
    """Of a claim, with a text in every place that a paper or a formula can reach."""
    example = {
        "point": {"r": 1.0}, "entry": [0], "printed": 1.0, "derived": 2.0, "relative_difference": 1e9,
        "units": {"r": "m"}, "largest_relative_difference": 2.0, "largest_at": {"r": 1.0},
    }  # fmt: skip
    suggestion = {"formula": text, "edit": text, "entry": [], "proved": False}
    texts = dict.fromkeys(("id", "equation", "page", "note", "quantity", "printed", "derived", "reason"), text)
    return texts | {
        "at": {text: text}, "verdict": "differs", "counterexample": example, "suggestions": [suggestion],
        "order": [4, 2], "conditions": [text], "remarks": [text + "!"],
    }  # fmt: skip


def with_text(text: str, patch: pytest.MonkeyPatch) -> None:
    """Every command has its result at once, and the text is in it."""
    patch.setattr(catalogue, "catalogue", lambda: FEW)
    audits = [{"paper": text, "file": text, "claims": [record(text)]}]
    patch.setattr(audit, "decided", lambda *_, **__: (audits, [text]))
    patch.setattr(deadline.Decider, "decide", lambda *_: record(text))
    layer = {"layer": "ulp", "verdict": "failed", "figure": float("inf"), "bound": 1.0, "detail": text}
    records = [{"quantity": text, "verdict": "failed", "paths": ["function"], "layers": [layer]}]
    patch.setattr(campaign.Campaign, "run", lambda *_: records)
    finding = Finding(text, text, text, text, "depends", text)
    found = Reproduction("gao", text, {}, (finding,))
    if HAS_PICTURES:
        papers = import_module("radartrack.reproduction.papers")
        patch.setattr(papers, "PAPERS", {"gao": papers.Paper(lambda *_: found, lambda _: iter(()))})
    patch.setattr(reproduce, "_report", lambda *_: "σ")
    patch.setattr(numpy_modules, "derive", lambda *_: numpy_modules.Derivation([], []))
    patch.setattr(output_directory, "differences", lambda *_: [text])


COMMANDS: dict[str, tuple[list[str], int]] = {
    "list": (["list"], 0),
    "show": (["show", "polar.bias.truth"], 0),
    "check": (["check", "polar.map[0]", "r"], 1),
    "check json": (["check", "polar.map[0]", "r", "--json"], 1),
    "check unreadable": (["check", "polar.map[0]", "r", "--given", "σ−\x1b"], 2),
    "audit": (["audit"], 2),
    "verify": (["verify", "polar.map"], 1),
    "reproduce": (["reproduce", "gao", "--out", "out"], 0 if HAS_PICTURES else 2),
    "regenerate": (["regenerate", "--check"], 1),
    "help": (["--help"], 0),
    "version": (["--version"], 0),
    "wrong": (["σ−"], 2),
}
each_command = pytest.mark.parametrize(("arguments", "code"), COMMANDS.values(), ids=COMMANDS.keys())


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[..., Result]:
    """A command in an empty folder."""
    monkeypatch.chdir(tmp_path)
    return lambda arguments, encoding="utf-8", **env: CliRunner(charset=encoding, env=env).invoke(app, arguments)


def quiet(result: Result) -> Result:
    assert "Traceback" not in result.output
    assert "a fault of radartrack" not in result.output
    return result


@each_command
@pytest.mark.parametrize("encoding", ENCODINGS)
def test_no_encoding_changes_what_a_command_does(
    run: Callable[..., Result], monkeypatch: pytest.MonkeyPatch, arguments: list[str], code: int, encoding: str
) -> None:
    with_text(SIGNS, monkeypatch)
    result = quiet(run(arguments, encoding))
    assert result.exit_code == code, result.output
    assert result.output


@each_command
@pytest.mark.parametrize("columns", ["1", "", "abc", "999"])
def test_no_width_changes_what_a_command_does(
    run: Callable[..., Result], monkeypatch: pytest.MonkeyPatch, arguments: list[str], code: int, columns: str
) -> None:
    with_text(SIGNS, monkeypatch)
    assert quiet(run(arguments, COLUMNS=columns)).exit_code == code


@each_command
def test_no_text_of_a_stranger_is_obeyed_by_the_terminal(
    run: Callable[..., Result], monkeypatch: pytest.MonkeyPatch, arguments: list[str], code: int
) -> None:
    with_text(f"a{ESCAPES}b", monkeypatch)
    result = quiet(run(arguments))
    assert result.exit_code == code
    for sign in result.output:
        assert sign in "\n\t" or unicodedata.category(sign) not in {"Cc", "Cf", "Cs", "Zl", "Zp"}


def test_files_of_an_audit_hold_the_text_and_neither_page_nor_json_an_escape(
    run: Callable[..., Result], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    with_text(f"a{ESCAPES}\udcffb", monkeypatch)
    quiet(run(["audit", "--json", "out.json", "--html", "out.html"]))
    (paper,) = json.loads((tmp_path / "out.json").read_text(encoding="ascii"))["papers"]
    assert paper["paper"] == f"a{ESCAPES}\udcffb"
    for name in ("out.json", "out.html"):
        text = (tmp_path / name).read_text(encoding="utf-8")
        assert not [sign for sign in text if sign != "\n" and unicodedata.category(sign) in {"Cc", "Cf", "Cs", "Zl"}]


def test_a_hostile_claims_file_that_cannot_be_read_is_told_in_one_harmless_line(
    run: Callable[..., Result], tmp_path: Path
) -> None:
    for text in ('"\\u001b[31m\\nevil" = 1', 'paper = "a"\nclaim = [{ id = "\\u202e" }]', "paper = \x1b", "\xff"):
        (tmp_path / "claims\x1b[31m.toml").write_text(text, encoding="latin-1")
        result = quiet(run(["audit", "claims\x1b[31m.toml"]))
        assert result.exit_code == 2
        assert len(result.stderr.splitlines()) == 1
        assert "\x1b" not in result.output
        assert "\u202e" not in result.output


class Failing(io.RawIOBase):
    """A stream that takes nothing."""

    def __init__(self, number: int) -> None:
        self.number = number
        self.nowhere = os.open(os.devnull, os.O_WRONLY)

    def fileno(self) -> int:
        return self.nowhere

    def close(self) -> None:
        if not self.closed:
            os.close(self.nowhere)
        super().close()

    def writable(self) -> bool:
        return True

    def write(self, _: Any) -> int:
        raise OSError(self.number, os.strerror(self.number))


@each_command
@pytest.mark.parametrize("number", [errno.ENOSPC, errno.EIO, errno.EPIPE, errno.EBADF])
@pytest.mark.usefixtures("run")
def test_output_that_cannot_be_written_is_code_two_and_at_most_one_line(
    monkeypatch: pytest.MonkeyPatch,
    arguments: list[str],
    code: int,
    number: int,
    capsys: pytest.CaptureFixture[str],
) -> None:
    with_text("σ", monkeypatch)
    with monkeypatch.context() as patch:
        stream = io.TextIOWrapper(io.BufferedWriter(Failing(number), 10), encoding="utf-8")
        patch.setattr(sys, "stdout", stream)
        with pytest.raises(SystemExit) as end:
            app(arguments)
    said = capsys.readouterr().err
    monkeypatch.setattr(Failing, "write", lambda _, data: len(data))
    stream.close()
    assert end.value.code == 2
    assert "Traceback" not in said
    if code != 2:  # else an error is told on the error stream, and nothing on this one
        assert said == ("" if number == errno.EPIPE else f"The output cannot be written: {os.strerror(number)}\n")


@each_command
def test_nobody_to_hear_of_it_changes_nothing(
    run: Callable[..., Result], monkeypatch: pytest.MonkeyPatch, arguments: list[str], code: int
) -> None:
    with_text("σ", monkeypatch)
    run([])
    for stream in ("stdout", "stderr"):
        monkeypatch.setattr(sys, stream, None)
    with pytest.raises(SystemExit) as end:
        app(arguments)
    sys.stdout.close()
    sys.stderr.close()
    assert end.value.code == code


SHELL = """
r() { "$PYTHON" -c 'from radartrack.cli import app; app()' "$@"; }
r audit "$1" --json closed.json >&- 2>&- <&-; echo $?
r show polar.map >/dev/full 2>full; echo $?
r show nothing 2>/dev/full; echo $?
PYTHONIOENCODING=ascii:strict HOME=/nonexistent r show polar.map >ascii 2>&1; echo $?
"""


def test_closed_and_full_descriptors_and_no_home(tmp_path: Path) -> None:
    """With real descriptors: a file that is opened must not get the number of a closed one."""
    claims = tmp_path / "claims.toml"
    claims.write_text('paper = "a"\n[[claim]]\nid = "b"\nundecided = "c"\n', encoding="utf-8")
    done = subprocess.run(
        ["/bin/sh", "-c", SHELL, "sh", str(claims)],
        env={**os.environ, "PYTHON": sys.executable},
        cwd=tmp_path,
        capture_output=True,
        text=True,
        check=False,
    )
    assert (done.stdout.split(), done.stderr) == (["0", "2", "2", "0"], "")
    (paper,) = json.loads((tmp_path / "closed.json").read_text(encoding="ascii"))["papers"]
    assert paper["claims"][0]["verdict"] == "undecided"
    assert (tmp_path / "full").read_text() == f"The output cannot be written: {os.strerror(errno.ENOSPC)}\n"
    assert "polar.map" in (tmp_path / "ascii").read_text(encoding="ascii")


@pytest.mark.parametrize("option", ["--show-completion", "--install-completion"])
def test_a_completion_that_is_shown_or_installed_is_code_zero(
    run: Callable[..., Result], option: str, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    shellingham = pytest.importorskip("shellingham")
    monkeypatch.setattr(shellingham, "detect_shell", lambda *_: ("bash", "/bin/bash"))
    monkeypatch.setenv("HOME", str(tmp_path))
    result = quiet(run([option]))
    assert result.exit_code == 0
    assert "completion" in result.output
