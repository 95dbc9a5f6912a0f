from pathlib import Path

import pytest

from radartrack.derive.checking.papers.audit import decide
from radartrack.derive.checking.papers.claim import Claim, ClaimsError, UnreadableClaim
from radartrack.derive.checking.papers.claims_file import read_claims, shipped, shipped_names
from radartrack.derive.checking.reporting.verdict import Verdict

GOOD = """
paper = "Smith 2001"

[[claim]]
id = "smith.eq3"
quantity = "polar.map[0]"
formula = "r*cos(beta)"
"""

# What is not right in the papers; everything else is equal.
DIFFERENT = {
    "prosov.eq2": "differs",
    "prosov.eq7": "differs",
    "prosov.eq7.uncorrelated": "differs",
    "prosov.eq10": "differs",
    "prosov.F": "differs",
    "gao.eq8": "wrong_dimensions",
    "gao.eq9": "wrong_dimensions",
    "gao.eq9.estimate": "differs",
    "gorshkov.table.radar4.C": "differs",
    "gorshkov.correlation.range_and_rate": "differs",
    "gorshkov.range.second_scan": "differs",
    "gorshkov.gain.exponential": "differs",
}
STABLE = """
prosov.eq2 prosov.eq5 prosov.eq7 prosov.eq8 prosov.eq9a prosov.eq9b prosov.eq9c prosov.H prosov.h_rr prosov.h_rb
prosov.h_br prosov.h_bb prosov.delta prosov.eq10 prosov.eq11a prosov.eq11b prosov.eq11c prosov.F
gao.eq1 gao.sigma_x gao.sigma_y gao.sigma_z gao.eq2 gao.eq3 gao.eq4 gao.eq5 gao.eq6 gao.eq7 gao.eq8 gao.eq9 gao.eq10
gao.example.50km gao.example.500km
gorshkov.eq1 gorshkov.eq2 gorshkov.eq5 gorshkov.eq11 gorshkov.eq12 gorshkov.eq13 gorshkov.eq21 gorshkov.eq22
gorshkov.table.radar1.C gorshkov.table.radar2.C gorshkov.table.radar3.C gorshkov.table.radar4.C
gorshkov.table.radar5.C gorshkov.table.radar6.C gorshkov.gain.radar1 gorshkov.gain.radar6 gorshkov.rate.crossing
"""


def _shipped() -> dict[str, Claim]:
    return {claim.id: claim for path in shipped() for claim in read_claims(path).claims}


@pytest.mark.parametrize("name", sorted(_shipped()))
def test_the_verdict_on_every_claim_of_the_papers(name: str) -> None:
    claim = _shipped()[name]
    expected = "undecided" if claim.undecided else DIFFERENT.get(name, "equal")
    assert decide(claim).verdict == expected


def test_what_is_shipped_is_found_by_folder_and_by_name() -> None:
    assert {path.stem for path in shipped()} == {"gao", "gorshkov", "prosov"}
    assert {path.parent.name for path in shipped("literature")} == {"literature"}
    assert [path.stem for path in shipped("mo")] == ["mo"]
    assert shipped("nonsense") == []
    assert {"papers", "literature", "libraries", "mo", "prosov"} <= set(shipped_names())


def test_all_equations_keep_their_ids() -> None:
    assert set(STABLE.split()) <= set(_shipped())


@pytest.mark.parametrize(
    ("name", "formula"),
    [
        ("prosov.eq2", "(f_xx*dx**2 + 2*f_xy*dx*dy + f_yy*dy**2)/2"),
        ("prosov.eq7", "1/2*(h_11*D_1 + 2*h_12*K_12 + h_22*D_2)"),
        ("prosov.eq10", "r*cos(beta) + 1/2*r*cos(beta)*D_beta"),
        ("prosov.F", "0"),
        ("gao.eq9", "(abs((X - k_x*t - d_x)/sqrt(1)) - d_av)**2"),
    ],
)
def test_what_was_probably_meant(name: str, formula: str) -> None:
    assert decide(_shipped()[name]).suggestions[0].formula == formula


def test_a_number_that_is_wrong_is_shown_beside_the_derived_one() -> None:
    verdict = decide(_shipped()["gorshkov.table.radar4.C"])
    assert verdict.counterexample is not None
    assert verdict.counterexample.printed == 11.01
    assert verdict.counterexample.derived == pytest.approx(250**2 / (5**2 * 15**2))


def test_a_good_file_is_read(tmp_path: Path) -> None:
    file = read_claims(_written(tmp_path, GOOD))
    assert file.paper == "Smith 2001"
    assert [claim.id for claim in file.claims] == ["smith.eq3"]


@pytest.mark.parametrize(
    ("replaced", "by", "said"),
    [
        ('paper = "Smith 2001"', "", "paper must be text"),
        ('paper = "Smith 2001"', 'paper = "Smith"\nauthor = "S"', "author is no field of a claims file"),
        ('id = "smith.eq3"', "", "claim 1: id is missing"),
        ('id = "smith.eq3"', 'id = "smith eq3"', "id must be letters"),
        ('formula = "r*cos(beta)"', "", "exactly one of formula"),
        ('formula = "r*cos(beta)"', "formula = 3", "formula must be text, given 3"),
        ('formula = "r*cos(beta)"', 'formula = "r"\nvalue = "3"', "given formula and value"),
        ('formula = "r*cos(beta)"', 'formule = "r"', "formule is no field of a claim; allowed: id, quantity"),
        ('formula = "r*cos(beta)"', "value = 2.78", 'must be a number in quotes, as printed, such as "2.78"'),
        ('formula = "r*cos(beta)"', 'value = "3"\nunit = "mile"', "unit must be one of"),
        ('formula = "r*cos(beta)"', 'formula = "r"\ngiven = "rho=0"', "given must be a table"),
        ('formula = "r*cos(beta)"', 'formula = "r"\ngiven = { rho = 0.5 }', "given.rho must be a whole number or"),
        ('formula = "r*cos(beta)"', 'formula = "r"\nat = { r = "1" }', "belong to numbers"),
        ('formula = "r*cos(beta)"', 'value = "3"\nlet = { a = "1" }', "given and let belong to formulas"),
        ('formula = "r*cos(beta)"', 'trend = "increasing"', "along is missing"),
        ('formula = "r*cos(beta)"', 'trend = "up"\nalong = { r = [1, 2] }', "trend must be one of"),
        ('formula = "r*cos(beta)"', 'trend = "convex"\nalong = { r = [2, 1] }', "two whole numbers, from and to"),
        ('formula = "r*cos(beta)"', 'crosses = "1"\nalong = { r = [1, 5] }', "two values: before it and after"),
        ('quantity = "polar.map[0]"', "", "quantity is missing"),
        ("[[claim]]", "[claim]", "claim must be one or more tables"),
        ("[[claim]]", "[[claim", "not TOML"),
    ],
)
def test_an_error_names_file_claim_and_field(tmp_path: Path, replaced: str, by: str, said: str) -> None:
    assert replaced in GOOD
    path = _written(tmp_path, GOOD.replace(replaced, by, 1))
    with pytest.raises(ClaimsError) as refused:
        read_claims(path)
    assert said in str(refused.value)
    assert str(path) in str(refused.value)


def test_an_id_occurs_once(tmp_path: Path) -> None:
    twice = GOOD + GOOD.partition("\n\n")[2]
    with pytest.raises(ClaimsError, match=r"smith\.eq3.*twice"):
        read_claims(_written(tmp_path, twice))


def test_a_missing_file_is_an_error_of_its_own_kind(tmp_path: Path) -> None:
    with pytest.raises(ClaimsError, match="No such file"):
        read_claims(tmp_path / "none.toml")


def test_a_file_that_is_too_large_or_no_text_is_refused(tmp_path: Path) -> None:
    large = tmp_path / "large.toml"
    large.write_bytes(b"#" * 1_000_001)
    with pytest.raises(ClaimsError, match="at most"):
        read_claims(large)
    binary = tmp_path / "binary.toml"
    binary.write_bytes(b"\xff\xfe\x00")
    with pytest.raises(ClaimsError, match="not TOML"):
        read_claims(binary)


@pytest.mark.parametrize(
    "claim",
    [
        Claim("a", quantity="polar.nothing", formula="r"),
        Claim("a", quantity="polar.map[5]", formula="r"),
        Claim("a", quantity="polar.map[0]", formula="import os"),
        Claim("a", quantity="polar.map[0]", value="3"),
        Claim("a", quantity="polar.map[0]", value="3", at={"r": "1", "beta": "1", "q": "1"}),
        Claim("a", quantity="polar.map", value="3", at={"r": "1", "beta": "1"}),
        Claim("a", quantity="polar.map[0]", at={"r": "1", "beta": "1"}, at_most="sigma_r"),
        Claim("a", quantity="sqrt(-1-polar.map[0]**2)", value="3", at={"r": "1", "beta": "1"}),
    ],
)
def test_a_claim_that_cannot_be_decided_on_is_refused_by_its_id(claim: Claim) -> None:
    with pytest.raises(UnreadableClaim, match="'a'"):
        decide(claim)


POINT = {"r": "2", "beta": "0"}


@pytest.mark.parametrize(
    ("claim", "holds"),
    [
        (Claim("a", "polar.map[0]", value="2.0", at=POINT), True),
        (Claim("a", "polar.map[0]", value="2", unit="m", at=POINT), True),
        (Claim("a", "polar.map[0]", value="0.002", unit="km", at=POINT), True),
        (Claim("a", "polar.map[0]", value="2.1", at=POINT), False),
        (Claim("a", "1000*polar.map[0]", value="2040", at=POINT), False),
        (Claim("a", "1024*polar.map[0]", value="2050", significant=3, at=POINT), True),
        (Claim("a", "polar.map[0]", value="-1.99", at={"r": "2", "beta": "3.05"}), True),
        (Claim("a", "polar.map[0]", at=POINT, at_most="2"), True),
        (Claim("a", "polar.map[0]", at=POINT, at_most="1.9"), False),
        (Claim("a", "polar.map[0]", at=POINT, at_least="1.9"), True),
        (Claim("a", "polar.map[0]", at={"r": "1"}, along=("beta", ("0", "1", "2")), trend="decreasing"), True),
        (Claim("a", "polar.map[0]", at={"r": "1"}, along=("beta", ("0", "1", "2")), trend="increasing"), False),
        (Claim("a", "polar.map[0]**2", at={"beta": "0"}, along=("r", ("1", "2", "5")), trend="convex"), True),
        (Claim("a", "polar.map[0]**2", at={"beta": "0"}, along=("r", ("1", "2", "5")), trend="concave"), False),
        (Claim("a", "polar.map[0]", at={"r": "1"}, along=("beta", ("1", "2")), crosses="0"), True),
        (Claim("a", "polar.map[0]", at={"r": "1"}, along=("beta", ("0", "1")), crosses="0"), False),
        (
            Claim(
                "a", "polar.map[1]", "", maximum_over=("beta", ("0", "pi/2", "3")), attained_at="pi/2", at={"r": "1"}
            ),
            True,
        ),
        (Claim("a", "polar.map[1]", value="1.0", maximum_over=("beta", ("0", "pi/2", "3")), at={"r": "1"}), True),
        (
            Claim("a", "polar.map[1]", "", maximum_over=("beta", ("0", "pi/2", "3")), attained_at="3", at={"r": "1"}),
            False,
        ),
    ],
)
def test_claims_about_numbers(claim: Claim, holds: bool) -> None:
    assert (decide(claim).verdict == "equal") is holds


def test_a_number_in_another_kind_of_unit_has_wrong_dimensions() -> None:
    verdict: Verdict = decide(Claim("a", "polar.map[0]", value="2", unit="s", at=POINT))
    assert verdict.verdict == "wrong_dimensions"


def _written(folder: Path, text: str) -> Path:
    path = folder / "claims.toml"
    path.write_text(text, encoding="utf-8")
    return path
