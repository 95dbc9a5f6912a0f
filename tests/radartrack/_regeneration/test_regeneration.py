"""The generated directory is all of what the derivations give, or what it was before; and `--check` says which."""

import json
import os
import shutil
import subprocess
import sys
from collections.abc import Callable, Mapping
from pathlib import Path
from types import MappingProxyType

import numpy as np
import pytest
from typer.testing import CliRunner, Result

import radartrack.generated
import radartrack.generated.polar
from radartrack._regeneration import regeneration
from radartrack.cli import app
from radartrack.derive import catalogue as catalogue_module
from radartrack.derive.catalogue import find
from radartrack.derive.language.stable_form import NotProved

ROOT = Path(__file__).parents[3]
GENERATED = Path(radartrack.generated.__path__[0])
SMALL = {name: find(name) for name in ("polar.map", "polar.bias.truth", "polar.covariance.linear")}
RUN = "from radartrack.cli import app; app()"


def shipped() -> dict[str, bytes]:
    """The generated package and the formula book, as they lie in one directory elsewhere."""
    return contents(GENERATED) | {"formulas.md": (ROOT / "docs" / "formulas.md").read_bytes()}


def contents(directory: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in directory.iterdir() if path.name != "__pycache__"}


def regenerate(*arguments: str | Path) -> Result:
    return CliRunner().invoke(app, ["regenerate", *map(str, arguments)])


@pytest.fixture
def small(monkeypatch: pytest.MonkeyPatch) -> None:
    """A catalogue of three quantities, derived in this process and measured at few points."""
    monkeypatch.setattr(regeneration, "catalogue", dict)
    monkeypatch.setattr(catalogue_module, "catalogue", lambda: SMALL)
    monkeypatch.setattr(regeneration, "POINTS", 40)


@pytest.fixture
def out(small: None, tmp_path: Path) -> Path:  # noqa: ARG001 - in this order
    """Where `regenerate` wrote the small catalogue."""
    out = tmp_path / "out"
    result = regenerate("--out", out)
    assert result.exit_code == 0, result.output
    assert "3 functions written to" in result.output
    return out


def run_in_process_of_its_own(
    *arguments: str | Path, cwd: Path = ROOT, environment: Mapping[str, str] = MappingProxyType({})
) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-c", RUN, "regenerate", *map(str, arguments)],
        cwd=cwd,
        env={**os.environ, **environment},
        capture_output=True,
        text=True,
        check=False,
    )


def package_copy(folder: Path) -> Path:
    """The package as an installed wheel has it, in a folder of its own."""
    package = folder / "radartrack"
    ignored = shutil.ignore_patterns("__pycache__")
    shutil.copytree(ROOT / "radartrack", package, ignore=ignored)
    shutil.copytree(ROOT / "derive", package / "derive", ignore=ignored)
    shutil.copytree(GENERATED, package / "generated", ignore=ignored)
    return package


def test_every_byte_of_damaged_code_is_restored_whatever_hash_seed_and_ground_types(tmp_path: Path):
    """Pure Python integers here; `make drift` takes the ground types that are installed, and a seed of its own."""
    package = package_copy(tmp_path)
    for name in ("__init__.py", "polar.py"):
        (package / "generated" / name).write_text("def (:\n")
    environment = {"PYTHONHASHSEED": "4242", "SYMPY_GROUND_TYPES": "python"}
    result = run_in_process_of_its_own("--out", package / "generated", cwd=tmp_path, environment=environment)
    assert result.returncode == 0, result.stderr
    assert contents(package / "generated") == shipped()


def test_outside_a_checkout_the_command_asks_where_to_write(tmp_path: Path):
    package_copy(tmp_path)
    result = run_in_process_of_its_own(cwd=tmp_path)
    assert result.returncode == 2
    assert "--out" in result.stderr
    assert "Traceback" not in result.stderr


def test_the_checkout_is_known_by_its_generated_folder():
    found = regeneration.source_directory()
    assert found is not None
    assert found.samefile(GENERATED)


@pytest.mark.usefixtures("small")
def test_a_file_in_place_of_the_directory_is_left_alone(tmp_path: Path):
    target = tmp_path / "file"
    target.write_text("mine")
    result = regenerate("--out", target)
    assert result.exit_code == 2
    assert "is a file" in result.stderr
    assert target.read_text() == "mine"


@pytest.mark.usefixtures("small")
@pytest.mark.parametrize("check", [[], ["--check"]], ids=["write", "check"])
def test_a_directory_with_other_files_is_left_alone(tmp_path: Path, check: list[str]):
    (tmp_path / "thesis.tex").write_text("mine")
    result = regenerate("--out", tmp_path, *check)
    assert result.exit_code == 2
    assert "holds other files" in result.stderr
    assert contents(tmp_path) == {"thesis.tex": b"mine"}


def test_what_was_just_written_passes_the_check_and_is_not_written_again(out: Path):
    before, inode = contents(out), out.stat().st_ino
    assert regenerate("--out", out, "--check").exit_code == 0
    result = regenerate("--out", out)
    assert result.exit_code == 0
    assert "as they stand in" in result.output
    assert (contents(out), out.stat().st_ino) == (before, inode)
    assert sorted(before) == sorted(
        ["__init__.py", "accuracy.json", "conversions.py", "formulas.md", "loops.py", "polar.py", "py.typed"]
    )


def edit_code(out: Path) -> None:
    path = out / "polar.py"
    path.write_text(path.read_text().replace("r * sin_beta", "-r * sin_beta", 1))


def edit_docstring(out: Path) -> None:
    path = out / "polar.py"
    path.write_text(path.read_text().replace("Exact bias", "Bias", 1))


def edit_accuracy(out: Path) -> None:
    rows = json.loads((out / "accuracy.json").read_text())
    rows["polar.map"]["ulp"] = 0.5
    (out / "accuracy.json").write_text(json.dumps(rows, indent=1) + "\n")


def drop_measurement(out: Path) -> None:
    rows = json.loads((out / "accuracy.json").read_text())
    del rows["polar.map"]
    (out / "accuracy.json").write_text(json.dumps(rows, indent=1) + "\n")


def add_orphan(out: Path) -> None:
    (out / "cylindrical.py").write_text("def map(): ...\n")


def add_folder(out: Path) -> None:
    (out / "folder").mkdir()
    (out / "folder" / "file").write_text("more")


def remove_module(out: Path) -> None:
    (out / "polar.py").unlink()


def remove_marker(out: Path) -> None:
    (out / "py.typed").unlink()


def change_line_endings(out: Path) -> None:
    path = out / "polar.py"
    path.write_bytes(path.read_bytes().replace(b"\n", b"\r\n"))


def cut_last_line_ending(out: Path) -> None:
    path = out / "polar.py"
    path.write_bytes(path.read_bytes().rstrip())


def make_undecodable(out: Path) -> None:
    (out / "polar.py").write_bytes(b"\xff\xfe\x00")


def make_a_folder_of_it(out: Path) -> None:
    (out / "polar.py").unlink()
    (out / "polar.py").mkdir()


def make_syntax_error(out: Path) -> None:
    (out / "polar.py").write_text("def (:\n")


DAMAGES: dict[Callable[[Path], None], list[str]] = {
    edit_code: ["polar.py on disk", "-    result[..., 1] = -r * sin_beta", "+    result[..., 1] = r * sin_beta"],
    edit_docstring: ['-    """Bias of', '+    """Exact bias of'],
    edit_accuracy: ["-    Accuracy: at most 1 ulp", "+    Accuracy: at most 0.5 ulp"],
    drop_measurement: ["+    Accuracy: not measured."],
    add_orphan: ["cylindrical.py: no derivation owns this file"],
    add_folder: ["folder: no derivation owns this file"],
    remove_module: ["polar.py: missing"],
    remove_marker: ["py.typed: missing"],
    change_line_endings: ["polar.py on disk"],
    cut_last_line_ending: ["polar.py"],
    make_undecodable: ["polar.py: cannot be read"],
    make_a_folder_of_it: ["polar.py: cannot be read"],
    make_syntax_error: ["polar.py on disk", "-def (:"],
}


@pytest.mark.parametrize("damage", DAMAGES, ids=lambda damage: damage.__name__)
def test_damage_is_shown_by_the_check_and_mended_by_the_command(out: Path, damage: Callable[[Path], None]):
    right = contents(out)
    damage(out)
    damaged = sorted(path.name for path in out.iterdir())
    checked = regenerate("--out", out, "--check")
    assert checked.exit_code == 1
    for shown in DAMAGES[damage]:
        assert shown in checked.stdout
    assert "is not what the derivations give" in checked.stderr
    assert sorted(path.name for path in out.iterdir()) == damaged
    mended = regenerate("--out", out)
    assert mended.exit_code == 0
    orphans = [shown for shown in DAMAGES[damage] if "no derivation owns" in shown]
    assert [line for line in mended.stderr.splitlines() if "removed" in line] == [f"{o}; removed" for o in orphans]
    if damage is not edit_accuracy:  # what was measured is believed; the docstring follows it
        assert contents(out) == right
    assert regenerate("--out", out, "--check").exit_code == 0


@pytest.mark.parametrize(
    "record",
    ["", "{", "[]", "null", '"text"', "{}", '{"polar.map": 1}', '{"polar.map": {}}', '{"polar.map": {"code": "x"}}',
     '{"polar.map": {"code": "x", "ulp": "much"}}', '{"polar.map": {"code": "x", "ulp": 0.5}}'],
)  # fmt: skip
def test_a_record_that_cannot_be_read_or_is_of_other_code_is_measured_anew(out: Path, record: str):
    right = contents(out)
    (out / "accuracy.json").write_text(record)
    assert regenerate("--out", out, "--check").exit_code == 1
    assert regenerate("--out", out).exit_code == 0
    assert contents(out) == right


def test_a_record_that_is_no_text_is_measured_anew(out: Path):
    right = contents(out)
    (out / "accuracy.json").write_bytes(b"\xff\xfe")
    assert regenerate("--out", out).exit_code == 0
    assert contents(out) == right


def test_the_cache_of_imported_modules_is_no_orphan(out: Path):
    (out / "__pycache__").mkdir()
    (out / "__pycache__" / "polar.pyc").write_bytes(b"")
    assert regenerate("--out", out, "--check").exit_code == 0


@pytest.mark.usefixtures("small")
def test_a_directory_that_is_missing_is_drift_and_is_not_created_by_the_check(tmp_path: Path):
    result = regenerate("--out", tmp_path / "missing", "--check")
    assert result.exit_code == 1
    assert "polar.py: missing" in result.stdout
    assert not (tmp_path / "missing").exists()


def test_an_unproved_form_stops_the_command_and_leaves_the_old_files(out: Path, monkeypatch: pytest.MonkeyPatch):
    before = contents(out)

    def unproved(_: object) -> None:
        raise NotProved("sin is not equal to cos")

    monkeypatch.setattr(regeneration, "form_of", unproved)
    result = regenerate("--out", out)
    assert result.exit_code == 1
    assert "sin is not equal to cos" in result.output
    assert "Traceback" not in result.output
    assert contents(out) == before


def test_an_interrupted_measurement_leaves_the_old_files(out: Path, monkeypatch: pytest.MonkeyPatch):
    edit_code(out)
    (out / "accuracy.json").write_text("{}")
    before = contents(out)

    def interrupted(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(regeneration, "measure", interrupted)
    assert regenerate("--out", out).exit_code != 0
    assert contents(out) == before
    assert [path.name for path in out.parent.iterdir()] == ["out"]


@pytest.mark.parametrize("step", [3, 8, 13, 20, 30])
def test_killed_in_mid_write_the_directory_is_the_old_set_or_the_new_one(tmp_path: Path, step: int):
    old, new = (
        {name: f"{age} {name}\n" * 9 for name in ("__init__.py", "accuracy.json", "polar.py")} for age in ("old", "new")
    )
    target = tmp_path / "out"
    regeneration.write(target, old)
    code = (
        "import json, sys; from pathlib import Path; from radartrack._regeneration import regeneration;"
        "from tests.radartrack._system.replacements import kill_at; files = json.loads(sys.argv[2]);"
        f"kill_at({step}); regeneration.write(Path(sys.argv[1]), files)"
    )
    killed = subprocess.run([sys.executable, "-c", code, str(target), json.dumps(new)], cwd=ROOT, check=False)
    assert killed.returncode in {-9, 0}
    found = {name: text.decode() for name, text in contents(target).items()}
    assert found in (old, new)
    assert found == new or killed.returncode == -9
    regeneration.write(target, new)
    assert {name: text.decode() for name, text in contents(target).items()} == new
    assert [path.name for path in tmp_path.iterdir()] == ["out"]


@pytest.mark.usefixtures("small")
def test_the_measured_error_is_rounded_up_to_half_an_ulp_and_infinite_for_what_is_not_finite(
    monkeypatch: pytest.MonkeyPatch,
):
    for found, stated in ((0.0, 0.0), (0.2, 0.5), (1.5, 1.5), (1.51, 2.0), (np.inf, np.inf), (np.nan, np.inf)):
        monkeypatch.setattr(regeneration, "errors", lambda *_, found=found: np.array([0.0, found]))
        assert regeneration.measure(radartrack.generated.polar, find("polar.map")) == stated
