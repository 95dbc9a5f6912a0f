"""Formulas that are code: the verdict, what the language makes of them, and claims that hold code."""

from pathlib import Path

import pytest

from radartrack.derive import check
from radartrack.derive.checking.papers.audit import decisions
from radartrack.derive.checking.papers.claim import ClaimsError
from radartrack.derive.checking.papers.claims_file import read_claims
from radartrack.derive.checking.reporting.verdict import Outcome

CLAIMS = """
paper = "Smith 2001"

[[claim]]
id = "smith.listing1"
quantity = "polar.map"
language = "python"
function = "convert"
code = '''
def other(x):
    return x

def convert(r, beta):
    return [r*np.cos(beta), r*np.sin(beta)]
'''
"""


def test_a_claim_may_hold_code(tmp_path: Path):
    path = tmp_path / "claims.toml"
    path.write_text(CLAIMS)
    (claim,) = read_claims(path).claims
    *_, verdict = decisions(claim)
    assert verdict.verdict is Outcome.EQUAL


@pytest.mark.parametrize("field", ["language", "code"])
def test_code_and_its_language_stand_together(tmp_path: Path, field: str):
    path = tmp_path / "claims.toml"
    path.write_text(CLAIMS.replace(f"{field} = ", f"note{'' if field == 'language' else 's'} = "))
    with pytest.raises(ClaimsError):
        read_claims(path)


def test_integer_division_is_told_as_the_slip_with_its_line():
    pytest.importorskip("tree_sitter")
    code = "c1 = x*x + y*y;\nJ(0,0) = x*x*x/pow(c1, 3/2) + x*y*y/pow(c1, 3/2);"
    verdict = check("observe.polar.jacobian[0,0]", code, code="cpp")
    assert verdict.verdict in {Outcome.DIFFERS, Outcome.WRONG_DIMENSIONS}
    assert (
        "line 2: 3/2 is 1 in C++, where whole numbers divide without remainder: 3.0/2 is the fraction"
        in verdict.remarks
    )
    assert check("observe.polar.jacobian[0,0]", code.replace("3/2", "1.5"), code="cpp").verdict is Outcome.EQUAL


@pytest.mark.parametrize("line", [2, 3, 4])
def test_a_slip_is_told_with_its_line(line: int):
    lines = ["c = np.cos(beta)", "s = sigma_beta**2", "half = s/2", "y = -half*r*c"]
    spoilt = {2: ("**2", "**3"), 3: ("s/2", "s/3"), 4: ("-half", "half")}
    old, new = spoilt[line]
    lines[line - 1] = lines[line - 1].replace(old, new)
    verdict = check("polar.bias.second_order[0]", "\n".join(lines), code="python", given={"rho": "0"})
    assert verdict.verdict in {Outcome.DIFFERS, Outcome.WRONG_DIMENSIONS}
    assert verdict.suggestions[0].edit.startswith(f"line {line}: ")


def test_what_the_language_makes_of_a_right_formula_is_said_too():
    pytest.importorskip("tree_sitter")
    verdict = check("polar.map[0]", "y = 4/2*r*cos(beta)/2;", code="c")
    assert verdict.verdict is Outcome.EQUAL
    assert verdict.remarks


@pytest.mark.parametrize(
    ("code", "language", "name"),
    [
        ("x = r*math.cos(az); y = r*math.sin(az)", "python", "polar.map"),
        ("c = cos(az); s = sin(az); x = r*c; y = r*s;", "c", "polar.map"),
        ("[x, y] = pol2cart(az, r)", "matlab", "polar.map"),
        ("[th, R] = cart2pol(e, n); h = [R; th];", "matlab", "observe.polar.map"),
        ("J << cos(az), -r*sin(az), sin(az), r*cos(az);", "cpp", "polar.jacobian"),
        (
            "J = np.array([[cos(b), -r*sin(b)], [sin(b), r*cos(b)]])\nP = J @ np.diag([sr**2, sb**2]) @ J.T",
            "python",
            "polar.covariance.linear",
        ),
    ],
)
def test_code_that_computes_several_numbers_is_all_of_them(code: str, language: str, name: str):
    if language != "python":
        pytest.importorskip("tree_sitter")
    given = {"rho": "0"} if "covariance" in name else None
    assert check(name, code, code=language, given=given).is_equal
