"""The examples in the documents run, and print what the documents say that they print."""

import re
import shlex
import subprocess
import sys
from pathlib import Path

import pytest

from tests.printed import say_the_same

ROOT = Path(__file__).parents[1]
DOCUMENTS = sorted([ROOT / "README.md", *(ROOT / "docs").rglob("*.md")])
EXAMPLE = re.compile(r"^```python\n(?P<code>.*?)^```\n(?:\n```text\n(?P<output>.*?)^```$)?", re.MULTILINE | re.DOTALL)
SEPARATOR = "\x1e"
WITH_EXAMPLES = [document for document in DOCUMENTS if EXAMPLE.search(document.read_text())]

OPTIONAL = re.compile(
    r"^(?:from|import) (polars|stonesoup)", re.MULTILINE
)  # what a document shows and no extra of ours needs

SHOWN = re.compile(r"^```console\n\$ (?P<command>[^\n]*)\n(?P<output>.*?)^```$", re.MULTILINE | re.DOTALL)
CONSOLE = [
    (shown["command"], shown["output"]) for document in DOCUMENTS for shown in SHOWN.finditer(document.read_text())
]


def run(blocks: list[str], folder: Path) -> list[str]:
    """What each block of a document prints when they are run one after another."""
    script = folder / "document.py"
    script.write_text("".join(f"{block}\nprint(end={SEPARATOR!r})\n" for block in blocks))
    finished = subprocess.run([sys.executable, script], capture_output=True, text=True, cwd=folder, check=False)
    assert finished.returncode == 0, finished.stderr
    return finished.stdout.split(SEPARATOR)


@pytest.mark.parametrize("document", WITH_EXAMPLES, ids=lambda path: path.name)
def test_examples_run_and_print_what_is_written(document: Path, tmp_path: Path) -> None:
    examples = list(EXAMPLE.finditer(document.read_text()))
    for library in {library for example in examples for library in OPTIONAL.findall(example["code"])}:
        pytest.importorskip(library, reason=f"{document.name} shows what is done with {library}")
    for example, printed in zip(examples, run([e["code"] for e in examples], tmp_path), strict=False):
        if example["output"] is not None:
            assert say_the_same(printed, example["output"]), printed


@pytest.mark.parametrize(("command", "output"), CONSOLE, ids=lambda text: text[:40])
def test_commands_print_what_is_written(command: str, output: str) -> None:
    program, *arguments = shlex.split(command)
    if "--code" in arguments and "python" not in arguments:
        pytest.importorskip("tree_sitter", reason="other languages than Python are read with it")
    finished = subprocess.run(
        [Path(sys.executable).with_name(program), *arguments], capture_output=True, text=True, cwd=ROOT, check=False
    )
    assert [line.rstrip() for line in finished.stdout.splitlines()] == output.splitlines()


def test_relative_links_lead_somewhere() -> None:
    link = re.compile(r"\]\((?!https?:|#)(?P<target>[^)#]+)")
    missing = [
        f"{document.relative_to(ROOT)}: {match['target']}"
        for document in DOCUMENTS
        for match in link.finditer(document.read_text())
        if not (document.parent / match["target"]).exists()
    ]
    assert not missing
