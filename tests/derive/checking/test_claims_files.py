"""Claims files as strangers write them: one clear refusal of what cannot be read, and the rest is kept."""

import json
import math
from pathlib import Path

import pytest
from typer.testing import CliRunner

from radartrack.cli import app
from radartrack.derive.checking.papers.audit import decide, record
from radartrack.derive.checking.papers.claim import Claim, ClaimsError, UnreadableClaim
from radartrack.derive.checking.papers.claim_fields import FIELDS
from radartrack.derive.checking.papers.claims_file import read_claims
from radartrack.derive.checking.reporting.verdict import Counterexample, Outcome, Verdict

GOOD = 'paper = "Smith 2001"\n\n[[claim]]\nid = "good"\nquantity = "polar.map[0]"\nformula = "r*cos(beta)"\n'
# A field, and what it must not hold, as TOML.
VALUES = (
    '""',
    '" "',
    "3.5",
    "true",
    "inf",
    "nan",
    "-nan",
    "2001-01-01",
    "2001-01-01T00:00:00Z",
    "[]",
    "[1, 'a']",
    "[[[[]]]]",
    "{}",
    "{ r = [1] }",
    "{ r = { s = 1 } }",
    "{ r = '' }",
    "{ r = true }",
    "{ r = [1, 'x'] }",
    "{ r = [2, 1] }",
    "{ r = ['1', ' '] }",
    "{ r = 1, s = 2 }",
    "9" * 50,
    "0x" + "f" * 6000,
    "[0x" + "f" * 6000 + "]",
    "{ r = 0x" + "f" * 6000 + " }",
    "{ r = [1, 0x" + "f" * 6000 + "] }",
)


def _write(folder: Path, content: str | bytes) -> Path:
    path = folder / "claims.toml"
    path.write_bytes(content.encode() if isinstance(content, str) else content)
    return path


def _with(field: str, value: str, number: int) -> str:
    """A claim that can be read but for one field."""
    fields = {"id": f"'bad.{number}'", "quantity": "'polar.map[0]'", "value": "'1'", field: value}
    return "[[claim]]\n" + "".join(f"{name} = {one}\n" for name, one in fields.items())


@pytest.mark.parametrize("field", sorted({*FIELDS, "formule", "unreadable", "'a b'"}))
def test_no_value_of_a_field_spoils_the_other_claims(tmp_path: Path, field: str) -> None:
    bad = "".join(_with(field, value, number) for number, value in enumerate(VALUES))
    path = _write(tmp_path, GOOD + bad + GOOD.partition("\n\n")[2].replace("good", "last"))
    claims = read_claims(path, keep_unreadable=True).claims
    assert [claims[0].id, claims[-1].id] == ["good", "last"]
    assert len({claim.id for claim in claims}) == len(VALUES) + 2
    assert not claims[0].unreadable
    assert not claims[-1].unreadable
    for claim in claims[1:-1]:
        with pytest.raises(UnreadableClaim, match=field.strip("'") if claim.unreadable else "symbol|missing"):
            decide(claim)
    with pytest.raises(ClaimsError, match="claim"):
        read_claims(path)


@pytest.mark.parametrize(
    ("field", "text"),
    [
        (field, text)
        for field in ("formula", "latex", "at_most", "at_least", "crosses", "quantity", "attained_at")
        for text in ("9" * 5000, "1e999999999", "(" * 200, "10**10**10", "1/0", "r" * 3000, "\\x00", "r*", "é")
    ],
)
def test_no_text_ends_in_anything_but_a_refusal_or_a_verdict(field: str, text: str) -> None:
    others: dict[str, dict[str, object]] = {
        "formula": {},
        "latex": {},
        "quantity": {"formula": "r"},
        "crosses": {"at": {"beta": "0"}, "along": ("r", ("1", "2"))},
        "attained_at": {"at": {"beta": "0"}, "maximum_over": ("r", ("1", "2"))},
    }
    rest = others.get(field, {"at": {"beta": "0", "r": "1"}})
    with pytest.raises(UnreadableClaim, match="claim 'a': "):
        decide(Claim(**({"id": "a", "quantity": "polar.map[0]", field: text} | rest)))  # type: ignore[arg-type]


@pytest.mark.parametrize(
    "text", ["9" * 5000, "1e999999999", "exp(exp(exp(9)))", "1/0", "sqrt(-1)", "beta", "", "[1, 2]"]
)
def test_no_setting_ends_in_anything_but_a_refusal(text: str) -> None:
    for claim in (
        Claim("a", "polar.map[0]", value="1", at={"beta": "0", "r": text}),
        Claim("a", "polar.map[0]", at={"beta": "0"}, along=("r", ("1", text)), trend="increasing"),
        Claim("a", "polar.map[0]", at={"beta": "0"}, maximum_over=("r", ("1", text)), value="1"),
        Claim("a", "polar.map[0]", formula="r", given={"r": text}),
        Claim("a", "polar.map[0]", formula="a", let={"a": text.replace("beta", "sigma_gamma")}),
    ):
        with pytest.raises(UnreadableClaim, match="claim 'a': "):
            decide(claim)


@pytest.mark.parametrize(
    "content",
    [
        b"",
        b" \n",
        b"\xff\xfe" + GOOD.encode("utf-16-le"),
        b"\x00",
        ("paper = 'a'\nclaim = " + "[" * 5000).encode(),
        ("paper = 'a'\n[[claim]]\npage = " + "9" * 5000).encode(),
        b"paper = 'a'\nclaim = [1]",
        b"paper = 'a'\nclaim = []",
        b"paper = 3\n[[claim]]\nid = 'a'",
        b"#" * 1_000_001,
    ],
    ids=["empty", "blank", "utf-16", "nul", "nested", "5000 digits", "no tables", "no claims", "paper", "long"],
)
def test_a_file_that_cannot_be_read_is_one_error_that_names_it(tmp_path: Path, content: bytes) -> None:
    path = _write(tmp_path, content)
    for keep in (False, True):
        with pytest.raises(ClaimsError, match=r"claims\.toml: "):
            read_claims(path, keep_unreadable=keep)


@pytest.mark.parametrize("mark", [b"", b"\xef\xbb\xbf"])
@pytest.mark.parametrize("end", ["\n", "\r\n"])
def test_a_byte_order_mark_and_ends_of_lines_change_nothing(tmp_path: Path, mark: bytes, end: str) -> None:
    (claim,) = read_claims(_write(tmp_path, mark + GOOD.replace("\n", end).encode())).claims
    assert claim == Claim("good", "polar.map[0]", formula="r*cos(beta)")


@pytest.mark.parametrize(
    ("fields", "said"),
    [
        ('formula = "r"\nunit = "km"', "unit belongs to numbers"),
        ('value = "8735"\nsignificant = 3', "leaves digits of 8735"),
        ('value = "1"\nalong = { r = ["1", "2"] }', "along belongs to"),
        ('value = "1"\nat = { r = "1" }\nmaximum_over = { r = [1, 2] }', "r is set twice"),
        ('trend = "convex"\nmaximum_over = { r = [1, 2] }\nalong = { r = [1, 5] }', "r is set twice"),
    ],
)
def test_fields_that_contradict_each_other_are_refused(tmp_path: Path, fields: str, said: str) -> None:
    text = f'paper = "Smith"\n[[claim]]\nid = "a"\nquantity = "polar.map[0]"\n{fields}\n'
    with pytest.raises(ClaimsError, match=said):
        read_claims(_write(tmp_path, text))


def test_an_id_that_occurs_twice_leaves_the_first(tmp_path: Path) -> None:
    path = _write(tmp_path, GOOD + GOOD.partition("\n\n")[2])
    first, second = read_claims(path, keep_unreadable=True).claims
    assert not first.unreadable
    assert "twice" in second.unreadable
    assert first.id != second.id


def test_an_audit_tells_every_claim_that_can_be_read(tmp_path: Path) -> None:
    out = tmp_path / "out.json"
    path = _write(tmp_path, GOOD + '[[claim]]\nid = "bad"\nformule = "r"\n')
    result = CliRunner().invoke(app, ["audit", str(path), "--json", str(out)])
    assert result.exit_code == 2
    assert "formule is no field" in result.output
    verdicts = {claim["id"]: claim["verdict"] for claim in json.loads(out.read_text())["papers"][0]["claims"]}
    assert verdicts == {"good": "equal", "bad": "undecided"}


def test_a_record_is_strict_json_whatever_the_numbers() -> None:
    point = {"r": math.inf, "x": math.nan}
    example = Counterexample(point, (0, 1), math.inf, -math.inf, math.inf, {}, math.nan, point)
    verdict = Verdict(Outcome.DIFFERS, "q", "p", "d", "r", example)
    told = json.loads(json.dumps(record(Claim("a"), verdict), allow_nan=False))["counterexample"]
    assert told["point"] == {"r": None, "x": None}
    assert told["relative_difference"] is None
    assert told["entry"] == [0, 1]


@pytest.mark.parametrize(
    "claim",
    [
        Claim("a", "polar.map[0]", formula="r*cos(beta)*10**60*10**60*10**60*10**60*10**59"),
        Claim("a", "polar.map[0] - polar.map[0] + r*10**-60*10**-60*10**-60*10**-60*10**-60*10**-20", formula="r"),
        Claim("a", "exp(polar.map[0]/polar.map[1])", value="3", at={"r": "1", "beta": "1/100000"}),
    ],
)
def test_a_number_beyond_those_of_a_machine_is_decided_and_strict_json(claim: Claim) -> None:
    verdict = decide(claim)
    assert verdict.verdict == "differs"
    json.dumps(record(claim, verdict), allow_nan=False)
