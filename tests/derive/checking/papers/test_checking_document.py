"""The reference of fields and verbs says what is so: every example in it is decided."""

import re
import tomllib
from pathlib import Path

import pytest

from radartrack.derive.checking.asking import ask_identity
from radartrack.derive.checking.papers.audit import decide
from radartrack.derive.checking.papers.claim import Claim
from radartrack.derive.checking.papers.claims_file import read_claims
from radartrack.derive.checking.question.declared_world import world_of
from radartrack.derive.formula.functions import VERBS

DOCUMENT = (Path(__file__).parents[4] / "docs" / "checking.md").read_text()
WORLD = next(block for block in re.findall(r"```toml\n(.*?)```", DOCUMENT, re.DOTALL) if "[[define]]" in block)
EXPECTED = dict(re.findall(r'^id = "([\w.]+)" +# (\w+)$', WORLD, re.MULTILINE))
LETTERS = world_of([{"symbols": {"x": {"unit": "1"}, "y": {"unit": "1"}, "T": {"unit": "1", "low": 0.1, "high": 10}}}])
EXAMPLES = re.findall(r"^\| [^|]+ \| `([^|]+)` \| `([^|]+)` \|$", DOCUMENT, re.MULTILINE)


def test_every_claim_of_the_document_has_a_verdict_beside_it():
    assert EXPECTED.keys() == {table["id"] for table in tomllib.loads(WORLD)["claim"]}


@pytest.mark.parametrize("name", EXPECTED)
def test_the_verdict_of_the_document_is_given(name: str, tmp_path: Path):
    path = tmp_path / "claims.toml"
    path.write_text(WORLD)
    file = read_claims(path)
    (claim,) = [one for one in file.claims if one.id == name]
    assert decide(claim, world_of(file.declared)).verdict == EXPECTED[name]


def test_the_chain_of_the_document_breaks_at_its_last_step():
    table = next(one for one in tomllib.loads(WORLD)["claim"] if one["id"] == "chain")
    verdict = decide(Claim("chain", chain=tuple(table["chain"])), world_of([tomllib.loads(WORLD)]))
    assert verdict.reason.startswith("step 3 of 3: ")


def test_every_verb_has_an_example():
    assert VERBS.keys() <= {word for example, _ in EXAMPLES for word in re.findall(r"\w+(?=\()", example)}


@pytest.mark.parametrize(("example", "result"), EXAMPLES)
def test_a_verb_is_what_the_document_says(example: str, result: str):
    *_, verdict = ask_identity(example, result, world=LETTERS).answers()
    assert verdict.is_equal
