"""`regenerate --language c`: all headers or what was there before, drift told, and what others build with."""

import json
import math
import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner, Result

from radartrack import convert
from radartrack._regeneration import accuracy, c_headers
from radartrack._regeneration.accuracy import Accuracy
from radartrack._regeneration.single_precision import error_in_single
from radartrack.cli import app
from radartrack.derive import catalogue as catalogue_module
from radartrack.derive.catalogue import find
from radartrack.verification.domain_points import sample
from radartrack.verification.subject import generated
from tests import own_models
from tests.c_programs import needs_compiler, run
from tests.radartrack._regeneration import small_catalogue

NAMES = ("polar.map", "polar.unbiased.estimate", "polar.unbiased.covariance", "motion.plane.observation")
SMALL = {name: find(name) for name in NAMES}
EXPECTED = {
    "CMakeLists.txt",
    "accuracy.json",
    "example.c",
    "radartrack.h",
    "radartrack.pc",
    "radartrack_convert.h",
    "radartrack_elementary.h",
    "radartrack_motion.h",
    "radartrack_polar.h",
    "written.json",
}


def regenerate(*arguments: str | Path) -> Result:
    return CliRunner().invoke(app, ["regenerate", *map(str, arguments)])


def make_small(patch: pytest.MonkeyPatch) -> None:
    """A catalogue of four quantities, derived in this process and measured at few points."""
    small_catalogue.install(patch, SMALL, 40)


@pytest.fixture(scope="module")
def written(tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("written") / "include"
    with pytest.MonkeyPatch.context() as patch:
        make_small(patch)
        result = regenerate("--language", "c", "--out", out)
    assert result.exit_code == 0, result.output
    return out


@pytest.fixture
def out(written: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """What was written, where a test may spoil it."""
    make_small(monkeypatch)
    return Path(shutil.copytree(written, tmp_path / "include"))


def contents(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def test_headers_and_what_goes_with_them_are_written_and_named_before(out: Path):
    assert set(contents(out)) == EXPECTED == c_headers.names(SMALL)
    assert "at most" in (out / "radartrack_polar.h").read_text()
    assert str(out.parent) not in "".join(path.read_text() for path in out.iterdir())


def test_written_twice_it_is_the_same_and_check_is_content(out: Path):
    before = contents(out)
    assert regenerate("--language", "c", "--out", out).exit_code == 0
    assert contents(out) == before
    assert regenerate("--language", "c", "--out", out, "--check").exit_code == 0


def test_check_tells_drift_and_the_next_run_mends_it_keeping_what_was_edited(out: Path):
    header = out / "radartrack_polar.h"
    right = header.read_text()
    header.write_text(right.replace("cos_beta * r;", "cos_beta * r * 2.0;"))
    result = regenerate("--language", "c", "--out", out, "--check")
    assert result.exit_code == 1
    assert "cos_beta * r * 2.0" in result.output
    assert regenerate("--language", "c", "--out", out).exit_code == 0
    assert header.read_text() == right
    assert "* 2.0" in (out.with_name("include.edited") / header.name).read_text()


def test_a_header_that_no_derivation_owns_any_more_goes_and_a_stranger_stays(
    out: Path, monkeypatch: pytest.MonkeyPatch
):
    (out / "mine.h").write_text("/* mine */\n")
    monkeypatch.setattr(catalogue_module, "catalogue", lambda: {"polar.map": SMALL["polar.map"]})
    assert regenerate("--language", "c", "--out", out).exit_code == 0
    assert (out / "mine.h").exists()
    assert not (out / "radartrack_motion.h").exists()


def test_a_directory_is_for_one_language(out: Path, tmp_path: Path):
    before = contents(out)
    result = regenerate("--out", out)
    assert result.exit_code == 2
    assert f"{out} is one of --language c" in result.output.replace("\n", " ")
    assert contents(out) == before
    assert regenerate("--out", tmp_path / "numpy").exit_code == 0
    assert regenerate("--language", "c", "--out", tmp_path / "numpy").exit_code == 2


def test_the_directory_must_be_named():
    result = regenerate("--language", "c")
    assert result.exit_code == 2
    assert "--out" in result.output


def test_a_model_of_ones_own_is_written_too(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(accuracy, "POINTS", 5)
    model = own_models.files(tmp_path)["toml"]
    out = tmp_path / "headers"
    result = regenerate("--language", "c", "--model", model, "--out", out)
    assert result.exit_code == 0, result.output
    assert "radartrack_convert_rotor_unbiased(" in (out / "radartrack_convert.h").read_text()
    assert not (out / "example.c").exists()


def test_the_bytes_do_not_depend_on_the_order_of_hashes(out: Path, tmp_path: Path):
    elsewhere = tmp_path / "elsewhere"
    script = f"""
import pytest
from radartrack.derive.catalogue import find
from tests.radartrack._regeneration import small_catalogue
small_catalogue.install(pytest.MonkeyPatch(), {{name: find(name) for name in {list(SMALL)}}}, 40)
from radartrack.cli import app
app()
"""
    shutil.copytree(out, elsewhere)  # with what was measured
    for name in EXPECTED - {"accuracy.json", "written.json"}:
        (elsewhere / name).unlink()
    command = [sys.executable, "-c", script, "regenerate", "--language", "c", "--out", str(elsewhere)]
    environment = {**os.environ, "PYTHONHASHSEED": "77", "SYMPY_GROUND_TYPES": "python"}
    subprocess.run(command, env=environment, check=True, capture_output=True)
    assert contents(elsewhere) == contents(out)


@needs_compiler
def test_the_example_is_of_twenty_lines_and_computes_what_the_package_does(out: Path, tmp_path: Path):
    source = (out / "example.c").read_text()
    assert len(source.splitlines()) <= 20
    printed = run(source, tmp_path, f"-I{out}").splitlines()
    plots = convert.polar([40e3, 80e3], [0.5, 2.0], 50.0, 0.02)
    for line, mean, covariance in zip(printed, plots.mean, plots.covariance, strict=True):
        assert line == (
            f"x {mean[0]:10.3f} m, y {mean[1]:10.3f} m, variances {covariance[0, 0]:.1f} and {covariance[1, 1]:.1f} "
            f"m^2, covariance {covariance[0, 1]:.1f} m^2"
        )


@needs_compiler
@pytest.mark.skipif(not shutil.which("cmake"), reason="there is no CMake on this machine")
def test_cmake_and_pkg_config_find_the_headers(out: Path, tmp_path: Path):
    def command(*words: str | Path) -> str:
        environment = {
            **os.environ,
            "PKG_CONFIG_PATH": os.pathsep.join(map(str, tmp_path.glob("prefix/lib*/**/pkgconfig"))),
        }
        done = subprocess.run([*map(str, words)], capture_output=True, text=True, check=False, env=environment)
        assert done.returncode == 0, done.stdout + done.stderr
        return done.stdout

    prefix, user = tmp_path / "prefix", tmp_path / "user"
    command("cmake", "-S", out, "-B", tmp_path / "build", f"-DCMAKE_INSTALL_PREFIX={prefix}")
    command("cmake", "--install", tmp_path / "build")
    assert {path.name for path in (prefix / "include").iterdir()} == {name for name in EXPECTED if name.endswith(".h")}
    user.mkdir()
    shutil.copy(out / "example.c", user)
    (user / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.15)\nproject(user C)\nfind_package(radartrack REQUIRED)\n"
        "add_executable(user example.c)\ntarget_link_libraries(user PRIVATE radartrack::radartrack)\n"
    )
    command("cmake", "-S", user, "-B", user / "build", f"-DCMAKE_PREFIX_PATH={prefix}")
    command("cmake", "--build", user / "build")
    assert command(user / "build" / "user").startswith("x  35110.324 m")
    if shutil.which("pkg-config"):
        flags = command("pkg-config", "--cflags", "--libs", "radartrack").split()
        assert (Path(flags[0].removeprefix("-I")) / "radartrack.h").exists()
        assert flags[1:] == ["-lm"]


def test_single_precision_is_measured_where_nothing_leaves_its_range():
    quantity = find("finite_sample.degree3.range.information")
    points = sample(quantity, 60)
    ulp, count = error_in_single(generated(quantity), quantity, points)
    assert 0 < count < 60
    assert 0.5 <= ulp < 16


def test_a_loss_of_digits_in_single_precision_is_seen():
    quantity = find("polar.map")

    def careless(**given: np.ndarray) -> np.ndarray:
        value = generated(quantity)(**given)
        return (value + 1e6 * given["r"][:, None]) - 1e6 * given["r"][:, None]

    assert error_in_single(careless, quantity, sample(quantity, 20))[0] > 1e4


def test_what_was_measured_is_read_back(tmp_path: Path):
    record = {
        "a": Accuracy("1" * 64, 2.5, 3.5, 400),
        "b": Accuracy("2" * 64, 1.0, math.nan, 0),
        "c": Accuracy("3", 1.0),
    }
    (tmp_path / "accuracy.json").write_text(accuracy.record_text(record))
    found = accuracy.read_record(tmp_path)
    assert json.loads(accuracy.record_text(found)) == json.loads(accuracy.record_text(record))
    assert (found["a"], found["c"].is_complete) == (record["a"], False)
    assert "400 of these points" in found["a"].in_single
    assert "none" in found["b"].in_single
    assert "not measured" in found["c"].in_single
