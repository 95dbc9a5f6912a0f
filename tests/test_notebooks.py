"""Notebooks lie in the tree executed, to be read where they lie, and say nothing of the machine that executed them."""

import json
import tempfile
from pathlib import Path
from typing import Any

import pytest

NOTEBOOKS = sorted((Path(__file__).parents[1] / "notebooks").glob("*.ipynb"))


@pytest.fixture(params=NOTEBOOKS, ids=lambda path: path.stem)
def notebook(request: pytest.FixtureRequest) -> Any:
    return json.loads(request.param.read_text(encoding="utf-8"))


def test_there_is_one_for_each_paper_and_each_use() -> None:
    names = {path.stem for path in NOTEBOOKS}
    assert names >= {
        "prosov",
        "gao",
        "gorshkov",
        "model_of_your_own",
        "audit_a_paper",
        "audit_an_unknown_sensor",
        "choose_a_conversion",
        "from_plots_to_a_track",
        "stone_soup",
    }


def test_every_cell_was_executed_in_order_without_errors(notebook: Any) -> None:
    code = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
    assert [cell["execution_count"] for cell in code] == list(range(1, len(code) + 1))
    outputs = [output for cell in code for output in cell["outputs"]]
    assert outputs
    assert all(output["output_type"] != "error" for output in outputs)
    assert all(output.get("name") != "stderr" for output in outputs)


def test_nothing_tells_when_where_and_with_which_python_it_was_executed(notebook: Any) -> None:
    assert notebook["metadata"]["language_info"] == {"name": "python"}
    assert all("execution" not in cell["metadata"] for cell in notebook["cells"])
    text = "".join(
        line
        for cell in notebook["cells"]
        for output in cell.get("outputs", [])
        for line in [*output.get("text", []), *output.get("data", {}).get("text/plain", [])]
    )
    assert not [word for word in ("site-packages", "/home/", "/root/", tempfile.gettempdir(), "C:\\") if word in text]


def test_every_picture_is_described_in_words(notebook: Any) -> None:
    for cell in notebook["cells"]:
        for output in cell.get("outputs", []):
            if "image/png" in output.get("data", {}):
                assert len("".join(output["data"]["text/plain"])) > 60
