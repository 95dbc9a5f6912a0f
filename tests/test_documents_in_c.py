"""The C programs in the documents are those that are shipped, and print what the documents say that they print."""

import re
from pathlib import Path

import pytest

from radartrack.derive.writing.c99.c_package import EXAMPLE
from tests.c_programs import WARNINGS, needs_compiler, run, write_headers

ROOT = Path(__file__).parents[1]
DOCUMENT = ROOT / "docs" / "c.md"
PRINTED = re.findall(r"^```text\n(.*?)^```$", DOCUMENT.read_text(), re.MULTILINE | re.DOTALL)


@pytest.fixture(scope="module")
def headers(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("headers")
    names = ("polar.unbiased.estimate", "polar.unbiased.covariance")
    write_headers(folder, *names, conversions=(("polar", "unbiased"),))
    return folder


def test_the_example_stands_in_the_document():
    assert f"```c\n{EXAMPLE}```\n" in DOCUMENT.read_text()


@needs_compiler
def test_the_example_prints_what_is_written(headers: Path, tmp_path: Path):
    assert run(EXAMPLE, tmp_path, *WARNINGS, f"-I{headers}") == PRINTED[0]


@needs_compiler
def test_the_printed_covariance_is_indefinite_in_single_precision_and_ours_is_right(headers: Path, tmp_path: Path):
    source = (ROOT / "docs" / "examples" / "float_covariance.c").read_text()
    found = run(source, tmp_path, *WARNINGS, f"-I{headers}").splitlines()
    *derived, printed = PRINTED[1].splitlines()
    assert found[:-1] == derived
    assert found[-1].endswith(" indefinite")  # by how much depends on the last bits of a cosine
    assert printed.endswith(" indefinite")
