from io import StringIO
from typing import Any

import pytest
from rich.console import Console

from radartrack._reports import audit_table

LONG = "abs(finite_sample.degree2.range_rate.correlation[0,1]) - sqrt(finite_sample.degree2.range.covariance[0,0])**2"
SUM = " + ".join(f"finite_sample.degree2.range_rate.covariance[0,{i}]" for i in range(9))
REASON = "the smallest value of all is 0.543551 at sigma_1 = 8000, and that is not far from a half"


def _record(identity: str, verdict: str, quantity: str, reason: str) -> dict[str, Any]:
    known = {"id": identity, "verdict": verdict, "quantity": quantity, "reason": reason}
    return (
        known
        | {"printed": "r", "derived": "", "note": "", "counterexample": None, "order": None}
        | {name: [] for name in ("suggestions", "remarks", "conditions")}
    )


PAPER = {
    "paper": "Smith J., " + "A paper with a title that goes on and on, " * 5 + "2001",
    "claims": [
        _record("smith.eq1", "equal", LONG, REASON),
        _record("smith.a_claim_with_a_long_name", "wrong_dimensions", SUM, "[bold]no markup[/bold] in a reason"),
        _record("smith.eq3", "undecided", "", "a definition"),
    ],
}


def _lines(width: int) -> list[str]:
    console = Console(file=StringIO(), width=width)
    audit_table.show(PAPER, console)
    assert isinstance(console.file, StringIO)
    return console.file.getvalue().splitlines()


@pytest.mark.parametrize("width", [60, 80, 100, 120, 140, 200])
def test_no_line_is_wider_than_the_terminal(width: int) -> None:
    assert all(len(line.rstrip()) <= width for line in _lines(width))


@pytest.mark.parametrize("width", [80, 100, 120, 140])
def test_words_and_names_stay_whole(width: int) -> None:
    words = {
        word for line in _lines(width) for word in line.replace("(", " ").replace(")", " ").replace(".", " ").split()
    }
    assert {"finite_sample", "correlation[0,1]", "covariance[0,0]", "sigma_1", "0", "543551"} <= words
    assert {"[bold]no", "markup[/bold]"} <= words


@pytest.mark.parametrize("width", [80, 140])
def test_the_paper_s_name_takes_one_line_and_ends_in_dots(width: int) -> None:
    name = next(line for line in _lines(width) if line)
    assert name.startswith("Smith J.,")
    assert name.endswith("…")


@pytest.mark.parametrize("width", [80, 140])
def test_a_quantity_of_many_lines_is_cut_with_dots(width: int) -> None:
    shown = [line for line in _lines(width) if "covariance[0," in line]
    assert len(shown) <= audit_table.MOST_LINES + 2
    assert any(line.rstrip().endswith("…") or " …  " in line for line in shown)


def test_every_claim_has_its_verdict_beside_it() -> None:
    for width in (80, 140):
        text = "\n".join(_lines(width))
        for identity, words in (("smith.eq1", "equal"), ("smith.eq3", "undecided")):
            assert any(line.split()[:2] == [identity, words] for line in text.splitlines())
