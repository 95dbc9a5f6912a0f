"""What the checker's page asks is answered, in words for people, whatever is asked."""

from __future__ import annotations

import json
import subprocess
import sys
from typing import Any

import pytest

from radartrack._page.answering import ASKED, answer
from radartrack._page.typeset_record import applied

ESTIMATE = {
    "quantity": "polar.unbiased.estimate[0]",
    "formula": "r*cos(beta)*(1 - sigma_beta^2/2)",
    "given": {"rho": "0"},
}
NOT_IN_A_BROWSER = """
import sys
import radartrack._page.answering
print([name for name in ("numpy", "rich", "typer", "scipy", "matplotlib", "multiprocessing") if name in sys.modules])
"""


def asked(ask: str, **request: Any) -> list[dict[str, Any]]:
    answers: list[str] = []
    answer(json.dumps({"ask": ask, **request}), answers.append)
    return [json.loads(one) for one in answers]


def test_it_loads_nothing_that_a_browser_lacks() -> None:
    finished = subprocess.run([sys.executable, "-c", NOT_IN_A_BROWSER], capture_output=True, text=True, check=True)
    assert finished.stdout.strip() == "[]"


def test_a_verdict_is_told_at_once_and_again_with_more() -> None:
    first, *_, last = asked("check", **ESTIMATE)
    assert {first["verdict"], last["verdict"]} == {"differs"}
    assert first["suggestions"] == []
    assert last["suggestions"][0]["formula"] == "r*cos(beta)*exp(sigma_beta**2/2)"
    assert last["headline"] == "differs"
    assert last["rest"].startswith(": not equal when rho = 0")
    assert 'class="different"' in last["printed_mathml"]


def test_what_a_suggestion_makes_of_the_formula_is_right() -> None:
    last = asked("check", **ESTIMATE)[-1]
    meant = last["suggestions"][0]["applied"]
    for notation, formula in (("text", meant["text"]), ("latex", meant["latex"])):
        again = asked("check", **{**ESTIMATE, "formula": formula, "notation": notation})[-1]
        assert again["verdict"] == "equal"


def test_an_entry_is_put_into_the_whole() -> None:
    question = {"quantity": "polar.jacobian", "formula": "[[cos(beta), -r*sin(beta)], [sin(beta), r*sin(beta)]]"}
    last = asked("check", **question)[-1]
    again = asked("check", **{**question, "formula": last["suggestions"][0]["applied"]["text"]})[-1]
    assert again["verdict"] == "equal"


def test_a_definition_is_mended_where_the_slip_is_in_it() -> None:
    question = {"quantity": "polar.bias.second_order[0]", "formula": "-D*r*cos(beta)/2", "given": {"rho": "0"}}
    last = asked("check", **question, let={"D": "sigma_beta^3"})[-1]
    mended = [one["applied"] for one in last["suggestions"] if "let" in one["applied"]]
    assert asked("check", **question, **mended[0])[-1]["verdict"] == "equal"


def test_another_quantity_is_a_name_to_check_against() -> None:
    record = {"printed": "r"}
    told = {"formula": "polar.map[1]", "edit": "this is polar.map[1], not polar.map[0]", "entry": [], "definition": ""}
    assert applied(record, told) == {"quantity": "polar.map[1]"}


def test_numbers_can_be_changed() -> None:
    (found,) = asked("values", **ESTIMATE, point={"r": 100e3, "beta": 0.5, "sigma_beta": 0.25})
    assert [symbol["name"] for symbol in found["symbols"]] == ["r", "beta", "sigma_beta"]
    assert found["printed"] == pytest.approx(100e3 * 0.8775825618903728 * (1 - 0.25**2 / 2))
    assert found["derived"] == pytest.approx(100e3 * 0.8775825618903728 * 1.031743407499103)
    assert found["relative_difference"] == pytest.approx(1 - found["printed"] / found["derived"])


def test_numbers_at_which_a_formula_has_no_value_are_said_to_have_none() -> None:
    (found,) = asked("values", quantity="polar.map[0]", formula="r*sqrt(-1 - beta^2)", point={"r": 1.0, "beta": 0.0})
    assert found["printed"] is None
    assert found["derived"] == 1.0
    assert found["relative_difference"] is None


def test_a_formula_is_read_before_it_is_known_what_it_is() -> None:
    (found,) = asked("read", formula="\\frac{a}{b_1}", notation="latex")
    assert found["letters"] == ["a", "b_1"]
    assert "<mfrac>" in found["mathml"]


@pytest.mark.parametrize(
    ("request_", "words"),
    [
        ({"ask": "read", "formula": "r*("}, "("),
        ({"ask": "check", "quantity": "polar.mapp", "formula": "r"}, "polar.map"),
        ({"ask": "check", "quantity": "polar.map[7]", "formula": "r"}, "polar.map"),
        ({"ask": "check", "quantity": "polar.map[0]", "formula": "__import__('os')"}, ""),
        ({"ask": "claims", "text": "no TOML"}, "not TOML"),
        ({"ask": "claims", "text": 'paper = "P"'}, "claim"),
        ({"ask": "nothing"}, "cannot be worked out"),
    ],
)
def test_what_cannot_be_answered_is_said_in_words(request_: dict[str, Any], words: str) -> None:
    (found,) = asked(request_.pop("ask"), **request_)
    assert words in found["error"]
    assert "Traceback" not in found["error"]


def test_a_fault_is_told_with_its_place() -> None:
    (found,) = asked("read", formula="r + * 2")
    assert found["span"][0] == 4


def test_a_formula_is_found() -> None:
    *_, last = asked("find", formula="r*cos(beta)")
    assert any(one["quantity"].endswith("map[0]") and one["words"] == "proved" for one in last["quantities"])


def test_words_find_quantities() -> None:
    (found,) = asked("list", words="debiased covariance")
    assert found["names"][0].split(".")[1] == "covariance"


CLAIMS = """
paper = "P"
[let]
D = "sigma_beta^2"
[[claim]]
id = "right"
quantity = "polar.bias.second_order[0]"
formula = "-D*r*cos(beta)/2"
given = { rho = "0" }
[[claim]]
id = "wrong"
quantity = "polar.map[0]"
formula = "r*sin(beta)"
[[claim]]
id = "unreadable"
quantity = "polar.map[0]"
formula = "r*("
"""


def test_a_claims_file_is_decided_claim_by_claim_and_reported() -> None:
    (file,) = asked("claims", text=CLAIMS)
    decided = [asked("decide", claim=claim, files=file["files"])[-1] for claim in file["claims"]]
    assert [one["verdict"] for one in decided] == ["equal", "differs", "undecided"]
    assert decided[2]["unreadable"]
    (report,) = asked("report", audits=[{"paper": file["paper"], "file": "p.toml", "claims": decided}])
    assert report["summary"] == "3 claims: 1 equal, 1 differs, 1 undecided"
    assert report["html"].index('id="wrong"') < report["html"].index('id="right"')


def test_every_kind_of_request_is_tried_here() -> None:
    assert set(ASKED) == {"read", "check", "decide", "values", "find", "list", "claims", "report"}
