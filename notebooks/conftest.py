"""Notebooks keep their outputs, and nothing of when and where they were executed."""

import nbformat
import pytest
from nbformat import NotebookNode

from tests.drawn import show_the_same
from tests.printed import say_the_same

BEFORE = pytest.StashKey[list[NotebookNode]]()


def pytest_runtest_setup(item: pytest.Item) -> None:
    """Remember what a notebook says that is about to be executed."""
    if _is_written(item):
        item.stash[BEFORE] = nbformat.read(item.path, as_version=4).cells


def pytest_runtest_teardown(item: pytest.Item) -> None:
    """Leave in an executed notebook what is the same at every execution, on every processor."""
    if not _is_written(item):
        return
    notebook = nbformat.read(item.path, as_version=4)
    notebook.metadata = {
        "kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
        "language_info": {"name": "python"},
    }
    for cell in notebook.cells:
        cell.metadata.pop("execution", None)
        if cell.cell_type == "code":
            cell.outputs = _joined(cell.outputs)
    for cell, before in zip(notebook.cells, item.stash[BEFORE], strict=True):
        if cell.cell_type == "code" and _said_again(cell.outputs, before.outputs):
            cell.outputs = before.outputs
    nbformat.write(notebook, item.path)


def _is_written(item: pytest.Item) -> bool:
    return item.path.suffix == ".ipynb" and bool(item.config.getoption("overwrite"))


def _said_again(now: list[NotebookNode], before: list[NotebookNode]) -> bool:
    """Whether outputs say and show what was there before."""
    return len(now) == len(before) and all(
        one.output_type == other.output_type
        and say_the_same(one.get("text", ""), other.get("text", ""))
        and set(one.get("data", {})) == set(other.get("data", {}))
        and all(_alike(kind, one.data[kind], other.data[kind]) for kind in one.get("data", {}))
        for one, other in zip(now, before, strict=True)
    )


def _alike(kind: str, now: str, before: str) -> bool:
    return show_the_same(now, before) if kind == "image/png" else say_the_same(str(now), str(before))


def _joined(outputs: list[NotebookNode]) -> list[NotebookNode]:
    """What a cell prints arrives in pieces, which differ from time to time."""
    joined: list[NotebookNode] = []
    for output in outputs:
        if joined and output.output_type == joined[-1].output_type == "stream" and output.name == joined[-1].name:
            joined[-1].text += output.text
        else:
            joined.append(output)
    return joined
