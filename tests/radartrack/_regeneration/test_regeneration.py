"""The generated directory is all of what the derivations give, or what it was before; and `--check` says which."""

import ast
import errno
import json
import os
import shutil
import subprocess
import sys
import tomllib
from collections.abc import Callable, Mapping
from pathlib import Path
from types import MappingProxyType

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from typer.testing import CliRunner, Result

import radartrack.generated
import radartrack.generated.polar
from radartrack._regeneration import accuracy, measuring, numpy_modules, output_directory
from radartrack._system import written_files
from radartrack.cli import app
from radartrack.derive import catalogue as catalogue_module
from radartrack.derive.catalogue import find
from radartrack.derive.language.stable_form import NotProved
from radartrack.derive.moments.conversion_quantities import quantities_of
from radartrack.derive.reading.model_table import read_models
from radartrack.derive.writing.numpy_writer import Function
from tests import own_models
from tests.radartrack._regeneration import small_catalogue

ROOT = Path(__file__).parents[3]
GENERATED = Path(radartrack.generated.__path__[0])
SMALL = {name: find(name) for name in ("polar.map", "polar.bias.truth", "polar.covariance.linear")}
ANOTHER = {"line.slope": find("line.slope")}
POINTS = 40
RUN = "from radartrack.cli import app; app()"
RUN_SMALL = f"""
import pytest
from radartrack.derive.catalogue import find
from tests.radartrack._regeneration.small_catalogue import install, install_known
small = {{name: find(name) for name in {list(SMALL)}}}
install(pytest.MonkeyPatch(), small, {POINTS})
{RUN}
"""


def contents(directory: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in directory.iterdir() if path.name != "__pycache__"}


def regenerate(*arguments: str | Path) -> Result:
    return CliRunner().invoke(app, ["regenerate", *map(str, arguments)])


def contents_of_all(directory: Path) -> dict[str, bytes]:
    """Of folders too, by their paths."""
    return {path.relative_to(directory).as_posix(): read(path) for path in directory.rglob("*") if is_leaf(path)}


def is_leaf(path: Path) -> bool:
    return path.is_symlink() or not path.is_dir() or not any(path.iterdir())


def read(path: Path) -> bytes:
    return path.read_bytes() if path.is_file() else b"a link or a folder"


def assert_nothing_is_lost(before: Mapping[str, bytes], place: Path, but: Mapping[str, bytes]) -> None:
    """Whatever there was is still somewhere, apart from what was written; line ends do not count."""
    after = list(contents_of_all(place).values())
    plain = {name: content.replace(b"\r\n", b"\n") for name, content in but.items()}
    for name, content in before.items():
        assert content in after or content.replace(b"\r\n", b"\n") == plain.get(name) or name == "written.json"


@pytest.fixture
def small(monkeypatch: pytest.MonkeyPatch) -> None:
    small_catalogue.install(monkeypatch, SMALL, POINTS)


@pytest.fixture
def out(small: None, tmp_path: Path) -> Path:  # noqa: ARG001 - in this order
    """Where `regenerate` wrote the small catalogue."""
    out = tmp_path / "out"
    result = regenerate("--out", out)
    assert result.exit_code == 0, result.output
    assert "3 functions written to" in result.output
    return out


def run_in_process_of_its_own(
    *arguments: str | Path, cwd: Path = ROOT, environment: Mapping[str, str] = MappingProxyType({}), code: str = RUN
) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-X", "utf8=0", "-c", code, "regenerate", *map(str, arguments)],
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


def test_a_new_directory_and_another_hash_seed_ground_types_and_locale_give_the_same_code_unmeasured(tmp_path: Path):
    """Of a few quantities; `make drift` does so with all of them, in place."""
    environment = {"PYTHONHASHSEED": "4242", "SYMPY_GROUND_TYPES": "python", "LC_ALL": "C", "PYTHONCOERCECLOCALE": "0"}
    unmeasured = (
        RUN_SMALL.replace("install(", "install_known(", 1)
        .replace(f"small, {POINTS}", f"small, {accuracy.POINTS}")
        .replace(RUN, f"from radartrack._regeneration import measuring\nmeasuring.measure = None\n{RUN}")
    )
    result = run_in_process_of_its_own("--out", tmp_path / "out", environment=environment, code=unmeasured)
    assert result.returncode == 0, result.stderr
    written, shipped = functions(tmp_path / "out" / "polar.py"), functions(GENERATED / "polar.py")
    assert {"map", "bias_truth", "covariance_linear"} <= written.keys()
    assert written.items() <= shipped.items()


def functions(module: Path) -> dict[str, str]:
    """Each as it is written, docstring and measured accuracy included."""
    text = module.read_text()
    found = (node for node in ast.parse(text).body if isinstance(node, ast.FunctionDef))
    return {node.name: str(ast.get_source_segment(text, node)) for node in found}


def test_damaged_generated_code_does_not_keep_the_command_from_restoring_every_byte(out: Path, tmp_path: Path):
    package = package_copy(tmp_path)
    shutil.rmtree(package / "generated")
    shutil.copytree(out, package / "generated")
    for name in ("__init__.py", "polar.py"):
        (package / "generated" / name).write_text("def (:\n")
    environment = {
        "PYTHONHASHSEED": "1",
        "SYMPY_GROUND_TYPES": "flint",
        "PYTHONPATH": str(ROOT),
    }  # the tests, not the package
    result = subprocess.run(
        [sys.executable, "-c", RUN_SMALL, "regenerate", "--out", package / "generated"],
        cwd=tmp_path,
        env={**os.environ, **environment},
        capture_output=True,
        text=True,
        check=False,
    )
    assert result.returncode == 0, result.stderr
    assert contents(package / "generated") == contents(out)


def test_outside_a_checkout_the_command_asks_where_to_write(tmp_path: Path):
    package_copy(tmp_path)
    result = run_in_process_of_its_own(cwd=tmp_path)
    assert result.returncode == 2
    assert "--out" in result.stderr
    assert "Traceback" not in result.stderr


def test_the_checkout_is_known_by_its_generated_folder():
    found = output_directory.source_directory()
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
        ["__init__.py", "accuracy.json", "conversions.py", "formulas.md", "loops.py", "polar.py", "py.typed",
         "written.json"]
    )  # fmt: skip


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


def leave_only_what_the_package_has_too(out: Path) -> None:
    for name in ("conversions.py", "loops.py", "polar.py", "accuracy.json", "formulas.md", "written.json"):
        (out / name).unlink()


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


def make_a_pipe_of_it(out: Path) -> None:
    (out / "polar.py").unlink()
    os.mkfifo(out / "polar.py")


def make_a_folder_of_it(out: Path) -> None:
    (out / "polar.py").unlink()
    (out / "polar.py").mkdir()


def make_syntax_error(out: Path) -> None:
    (out / "polar.py").write_text("def (:\n")


DAMAGES: dict[Callable[[Path], None], list[str]] = {
    edit_code: ["polar.py on disk", "-    result[..., 1] = -r * sin_beta", "+    result[..., 1] = r * sin_beta"],
    edit_docstring: ['-    """Bias of', '+    """Exact bias of'],
    edit_accuracy: ["written.json on disk"],
    drop_measurement: ["accuracy.json on disk"],
    leave_only_what_the_package_has_too: ["written.json: missing", "polar.py: missing"],
    remove_module: ["polar.py: missing"],
    remove_marker: ["py.typed: missing"],
    change_line_endings: ["polar.py on disk"],
    cut_last_line_ending: ["polar.py"],
    make_undecodable: ["polar.py: cannot be read"],
    make_a_folder_of_it: ["polar.py: cannot be read"],
    make_a_pipe_of_it: ["polar.py: cannot be read"],
    make_syntax_error: ["polar.py on disk", "-def (:"],
}


@pytest.mark.parametrize("damage", DAMAGES, ids=lambda damage: damage.__name__)
def test_damage_is_shown_by_the_check_and_mended_by_the_command(
    out: Path, damage: Callable[[Path], None], tmp_path: Path
):
    right = contents(out)
    damage(out)
    damaged = contents_of_all(out)
    checked = regenerate("--out", out, "--check")
    assert checked.exit_code == 1
    for shown in DAMAGES[damage]:
        assert shown in checked.stdout
    assert "is not what the derivations give" in checked.stderr
    assert contents_of_all(out) == damaged
    mended = regenerate("--out", out)
    assert mended.exit_code == 0
    assert "removed" not in mended.stderr
    assert_nothing_is_lost(damaged, tmp_path, but=right)
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

    monkeypatch.setattr(numpy_modules, "form_of", unproved)
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

    monkeypatch.setattr(measuring, "measure", interrupted)
    assert regenerate("--out", out).exit_code != 0
    assert contents(out) == before
    assert [path.name for path in out.parent.iterdir()] == ["out"]


STRANGERS = [
    b'{"resnet": 0.93}',
    (GENERATED / "written.json").read_bytes()[:-3],
    b'{"thesis.tex": "none"}',
    b'["thesis.tex"]',
    b'{"../thesis.tex": "' + b"0" * 64 + b'"}',
    b"{}",
    b"[",
    b"\xff\xfe",
    b"[" * 100_000,
]


@pytest.mark.usefixtures("small")
@pytest.mark.parametrize("name", ["accuracy.json", "written.json", "polar.py", "py.typed"])
@pytest.mark.parametrize("content", STRANGERS, ids=lambda content: content[:20].decode(errors="replace"))
def test_no_file_makes_a_directory_ours_by_its_name(tmp_path: Path, name: str, content: bytes):
    mine = tmp_path / "mine"
    (mine / "sub").mkdir(parents=True)
    (mine / name).write_bytes(content)
    (mine / "sub" / "data.csv").write_text("1,2")
    (mine / "thesis.tex").write_text("precious")
    before = contents_of_all(tmp_path)
    result = regenerate("--out", mine)
    assert result.exit_code == 2
    assert "holds other files" in result.stderr
    assert contents_of_all(tmp_path) == before


@pytest.mark.usefixtures("small")
@pytest.mark.parametrize("name", ["accuracy.json", "written.json", "notes.txt"])
def test_a_stranger_s_only_file_is_left_alone(tmp_path: Path, name: str):
    (tmp_path / name).write_text("{}")
    assert regenerate("--out", tmp_path).exit_code == 2
    assert contents_of_all(tmp_path) == {name: b"{}"}


FILES = ("__init__.py", "accuracy.json", "polar.py", "notes.txt", "sub")
CONTENTS = st.sampled_from([b"", b"ours, old\n", b"ours, old\r\n", b"a stranger's\n", b"\xff\0"])


@settings(max_examples=25)
@given(
    written=st.dictionaries(st.sampled_from(FILES), CONTENTS.filter(lambda content: b"\xff" not in content)),
    changed=st.dictionaries(st.sampled_from(FILES), CONTENTS),
    wanted=st.sets(st.sampled_from(FILES)),
    folder=st.booleans(),
)
def test_whatever_a_directory_holds_nothing_but_what_was_written_there_is_lost(
    tmp_path_factory: pytest.TempPathFactory,
    written: dict[str, bytes],
    changed: dict[str, bytes],
    wanted: set[str],
    folder: bool,
):
    place = tmp_path_factory.mktemp("place")
    out = place / "out"
    texts = {"py.typed": ""} | {name: content.decode() for name, content in written.items()}
    output_directory.write(out, texts | {"written.json": written_files.record(texts)})
    for name, content in changed.items():
        (out / name).write_bytes(content)
    if folder and "sub" not in {*written, *changed}:
        (out / "sub" / "deep").mkdir(parents=True)
        (out / "sub" / "deep" / "data").write_bytes(b"deep")
        (out / "sub" / "link").symlink_to("nowhere")
    before = contents_of_all(out)
    new = dict.fromkeys(wanted, "new\n")
    new |= {"py.typed": ""}
    new |= {"written.json": written_files.record(new)}
    try:
        output_directory.write(out, new)
    except FileExistsError:
        assert contents_of_all(out) == before
        assert wanted & (changed.keys() | {"sub"}) - written.keys()
    else:
        assert {name: (out / name).read_text() for name in new} == new
        assert_nothing_is_lost(before, place, but=written | {"written.json": (out / "written.json").read_bytes()})
        assert not [path for path in (out / name for name in written.keys() - changed.keys() - wanted) if path.exists()]


def test_what_a_user_adds_is_kept_named_and_no_drift(out: Path):
    (out / "notes.txt").write_text("mine")
    (out / "folder").mkdir()
    (out / "folder" / "file").write_text("more")
    edit_code(out)
    assert regenerate("--out", out, "--check").exit_code == 1
    result = regenerate("--out", out)
    assert result.exit_code == 0
    for said in ("notes.txt: no derivation owns this file; kept", "folder: no derivation owns this file; kept"):
        assert said in result.stderr
    assert (out / "notes.txt").read_text() == "mine"
    assert (out / "folder" / "file").read_text() == "more"
    assert regenerate("--out", out, "--check").exit_code == 0


def test_what_was_written_and_has_no_derivation_any_more_is_drift_and_is_removed_by_name(
    out: Path, monkeypatch: pytest.MonkeyPatch
):
    less = {name: quantity for name, quantity in SMALL.items() if name != "polar.bias.truth"}
    found = numpy_modules.texts
    monkeypatch.setattr(
        numpy_modules, "texts", lambda *given: {n: t for n, t in found(*given).items() if n != "formulas.md"}
    )
    monkeypatch.setattr(catalogue_module, "catalogue", lambda: less)
    checked = regenerate("--out", out, "--check")
    assert checked.exit_code == 1
    assert "formulas.md: no derivation owns this file" in checked.stdout
    assert "formulas.md: no derivation owns this file; removed" in regenerate("--out", out).stderr
    assert not (out / "formulas.md").exists()
    assert regenerate("--out", out, "--check").exit_code == 0


def test_the_names_that_are_tried_beforehand_are_those_that_are_written(out: Path):
    assert numpy_modules.names(SMALL) == {path.name for path in out.iterdir()}


def test_a_stranger_s_file_where_a_module_will_be_is_refused_before_anything_is_derived(
    out: Path, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.setattr(catalogue_module, "catalogue", lambda: ANOTHER)
    monkeypatch.setattr(numpy_modules, "derive", None)
    (out / "line.py").write_text("mine")
    before = contents_of_all(out)
    result = regenerate("--out", out)
    assert result.exit_code == 2
    assert "line.py is in the way" in result.stderr
    assert contents_of_all(out) == before


@pytest.mark.usefixtures("small")
def test_a_folder_of_a_user_s_project_is_not_taken_for_the_checkout(tmp_path: Path):
    (tmp_path / "pyproject.toml").write_text("[project]")
    (tmp_path / "docs").mkdir()
    (tmp_path / "docs" / "formulas.md").write_text("mine")
    assert regenerate("--out", tmp_path / "generated").exit_code == 0
    assert (tmp_path / "docs" / "formulas.md").read_text() == "mine"
    assert (tmp_path / "generated" / "formulas.md").is_file()


@pytest.mark.usefixtures("small")
@pytest.mark.parametrize("below", ["file/out", "file/deep/out"])
def test_a_place_that_takes_no_directory_is_refused_before_anything_is_derived(
    tmp_path: Path, below: str, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.setattr(numpy_modules, "derive", None)
    (tmp_path / "file").touch()
    result = regenerate("--out", tmp_path / below)
    assert (result.exit_code, len(result.stderr.splitlines())) == (2, 1)
    assert "--out must be a directory that can be written" in result.stderr


@pytest.mark.usefixtures("small")
def test_a_full_disk_is_told_in_one_line_and_leaves_everything(out: Path, monkeypatch: pytest.MonkeyPatch):
    edit_code(out)
    before = contents_of_all(out)

    def full(*_: object) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(written_files, "keep", full)
    result = regenerate("--out", out)
    assert (result.exit_code, result.stderr) == (2, f"{out}: No space left on device\n")
    assert contents_of_all(out) == before


@pytest.mark.parametrize("code", ["import sys; sys.exit(0)", "raise SystemExit", "exit()", "1/0", "def (", "MODEL = 1"])
def test_a_model_file_that_ends_or_fails_is_refused(tmp_path: Path, code: str):
    (tmp_path / "model.py").write_text(code)
    result = regenerate("--model", tmp_path / "model.py", "--out", tmp_path / "out")
    assert (result.exit_code, len(result.stderr.splitlines())) == (2, 1)
    assert "model.py" in result.stderr
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("step", [3, 8, 13, 20, 30])
def test_killed_in_mid_write_the_directory_is_the_old_set_or_the_new_one(tmp_path: Path, step: int):
    old, new = (
        {name: f"{age} {name}\n" * 9 for name in ("__init__.py", "accuracy.json", "polar.py")} for age in ("old", "new")
    )
    old, new = (files | {"written.json": written_files.record(files)} for files in (old, new))
    target = tmp_path / "out"
    output_directory.write(target, old)
    code = (
        "import json, sys; from pathlib import Path; from radartrack._regeneration import output_directory;"
        "from tests.radartrack._system.replacements import kill_at; files = json.loads(sys.argv[2]);"
        f"kill_at({step}); output_directory.write(Path(sys.argv[1]), files)"
    )
    killed = subprocess.run([sys.executable, "-c", code, str(target), json.dumps(new)], cwd=ROOT, check=False)
    assert killed.returncode in {-9, 0}
    found = {name: text.decode() for name, text in contents(target).items()}
    assert found in (old, new)
    assert found == new or killed.returncode == -9
    output_directory.write(target, new)
    assert {name: text.decode() for name, text in contents(target).items()} == new
    assert [path.name for path in tmp_path.iterdir()] == ["out"]


@pytest.mark.usefixtures("small")
def test_the_measured_error_is_rounded_up_to_half_an_ulp_and_infinite_for_what_is_not_finite(
    monkeypatch: pytest.MonkeyPatch,
):
    for found, stated in ((0.0, 0.0), (0.2, 0.5), (1.5, 1.5), (1.51, 2.0), (np.inf, np.inf), (np.nan, np.inf)):
        monkeypatch.setattr(measuring, "errors", lambda *_, found=found: np.array([0.0, found]))
        assert measuring.measure(radartrack.generated.polar, find("polar.map")) == stated


def test_no_proof_is_looked_for_of_code_that_is_none_of_the_package_s_however_long_its_sums():
    (model,) = read_models(tomllib.loads(own_models.TOML))
    function = Function(quantities_of(model)[0], " + ".join(["return r", *["w"] * 3000]))
    record = {function.quantity.name: accuracy.Accuracy(function.digest, 1.0)}
    assert accuracy.with_proofs([function], record) == record
