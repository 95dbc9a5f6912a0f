import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any, ClassVar

import pytest
from typer.testing import CliRunner, Result

from radartrack.cli import app
from radartrack.derive.checking.papers import deadline
from radartrack.derive.checking.papers.deadline import Decider

CLAIMS = """
paper = "Smith 2001"

[[claim]]
id = "smith.eq3"
quantity = "polar.map[0]"
formula = "r*sin(beta)"

[[claim]]
id = "smith.value"
quantity = "polar.map[0]"
value = "2.0"
at = { r = "2", beta = "0" }
"""


class _Shared(Decider):
    """Hands its child on to the next one, where it is still of use: to start one takes longer than to decide."""

    idle: ClassVar[list[Any]] = []

    def __init__(self, *arguments: Any, **options: Any) -> None:
        super().__init__(*arguments, **options)
        self._child = self.idle.pop() if self.idle else None

    def __exit__(self, *_: object) -> None:
        if self._child is not None:
            self.idle.append(self._child)


@pytest.fixture(scope="module", autouse=True)
def _shared_children() -> Iterator[None]:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(deadline, "Decider", _Shared)
        yield
    for child in _Shared.idle:
        child.end()


def _run(*arguments: str) -> Result:
    return CliRunner().invoke(app, list(arguments))


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        (("polar.map[0]", "r*cos(beta)"), 0),
        (("polar.map[0]", "r*sin(beta)"), 1),
        (("polar.map[0]", "r**2"), 1),
        (("polar.jacobian[0,1]", "-r*sin(beta)"), 0),
        (("polar.covariance.linear[0,0]", "sigma_r**2*cos(beta)**2", "--given", "rho=0", "--given", "sigma_beta=0"), 0),
        (("polar.bias.second_order[0]", "-D/2*r*cos(beta)", "--given", "rho=0", "--let", "D=sigma_beta**2"), 0),
        (("polar.bias.second_order[0]", r"-\frac{\sigma_\beta^2}{2}r\cos\beta", "--latex", "--given", "rho=0"), 0),
        (("polar.map[0]", "r +"), 2),
        (("polar.nothing", "r"), 2),
        (("polar.map[7]", "r"), 2),
        (("polar.map[0]", "r", "--given", "rho"), 2),
        (("polar.map[0]", "sin^2(beta)"), 2),
    ],
)
def test_exit_codes_of_check(arguments: tuple[str, ...], code: int) -> None:
    result = _run("check", *arguments)
    assert result.exit_code == code, result.output


@pytest.mark.parametrize(
    ("timeout", "code"), [("inf", 0), ("1e12", 0), ("nan", 2), ("-inf", 2), ("-1", 2), ("soon", 2)]
)
def test_no_limit_of_time_ends_in_the_code_of_a_difference(timeout: str, code: int, tmp_path: Path) -> None:
    assert _run("check", "polar.map[0]", "r*cos(beta)", f"--timeout={timeout}").exit_code == code
    claims = tmp_path / "smith.toml"
    claims.write_text(CLAIMS, encoding="utf-8")
    assert _run("audit", str(claims), f"--timeout={timeout}").exit_code == code


def test_check_says_what_differs_and_what_was_meant() -> None:
    output = _run("check", "polar.bias.second_order[0]", "-r*cos(beta)*sigma_beta**2", "--given", "rho=0").output
    for said in ("differs", "for example", "r = 50 km", "order σ^2", "perhaps meant", "a missing factor 1/2"):
        assert said in output


@pytest.mark.parametrize(
    ("arguments", "code", "said"),
    [
        (("polar.map[0]", "r*cos(beta)"), 0, "equal, proved\n"),
        (
            ("polar.bias.second_order[0]", "-r*cos(beta)*sigma_beta^2/2", "--given", "rho=0"),
            0,
            "equal, proved when rho = 0\n",
        ),
        (
            ("observe.polar.map[1]", "2*atan2(y, x + sqrt(x**2 + y**2))"),
            0,
            "equal to 50 digits at 105 points, not proved\n",
        ),
        (("polar.map[0]", "r*sin(beta)"), 1, "differs: not equal: sin should be cos"),
        (("polar.map[0]", "r**2*cos(beta)"), 1, "wrong dimensions: the formula has the unit m^2"),
        (("spherical.covariance.averaged[0,0]", "r", "--timeout", "0.1"), 3, "cannot decide in 0.1 s\n"),
    ],
)
def test_the_verdict_comes_first_in_the_same_words(arguments: tuple[str, ...], code: int, said: str) -> None:
    result = _run("check", *arguments)
    assert result.exit_code == code, result.output
    assert result.output.startswith(said)


def test_check_repeats_how_latex_was_read() -> None:
    assert "read as: r cos(β)" in _run("check", "polar.map[0]", r"r\cos\beta", "--latex").output


def test_check_prints_json() -> None:
    record = json.loads(_run("check", "polar.map[0]", "r*sin(beta)", "--json").stdout)
    assert record["verdict"] == "differs"
    assert record["counterexample"]["printed"] == pytest.approx(25e3)
    assert record["suggestions"][0]["formula"] == "r*cos(beta)"


def test_audit_prints_verdicts_and_writes_json_and_html(tmp_path: Path) -> None:
    file, as_json, as_html = (tmp_path / name for name in ("smith.toml", "out.json", "out.html"))
    file.write_text(CLAIMS, encoding="utf-8")
    result = _run("audit", str(file), "--json", str(as_json), "--html", str(as_html))
    assert result.exit_code == 0, result.output
    assert "smith.eq3" in result.output
    (paper,) = json.loads(as_json.read_text(encoding="utf-8"))["papers"]
    assert [claim["verdict"] for claim in paper["claims"]] == ["differs", "equal"]
    wanted = {"id", "verdict", "quantity", "printed", "derived", "counterexample", "suggestions"}
    assert wanted <= paper["claims"][0].keys()
    assert "<math" in as_html.read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("replaced", "by", "said"),
    [
        ("r*sin(beta)", "r*sin(beta", "smith.eq3"),
        ('quantity = "polar.map[0]"\nformula', 'quantity = "polar.mop"\nformula', "did you mean polar.map"),
        ('paper = "Smith 2001"', "", "paper must be text"),
    ],
)
def test_audit_exits_2_where_a_file_cannot_be_read(tmp_path: Path, replaced: str, by: str, said: str) -> None:
    file = tmp_path / "smith.toml"
    file.write_text(CLAIMS.replace(replaced, by, 1), encoding="utf-8")
    result = _run("audit", str(file))
    assert result.exit_code == 2
    assert said in result.output
    assert str(file.name) in result.output.replace("\n", "")


def test_audit_says_what_is_shipped_where_a_name_is_neither_file_nor_shipped() -> None:
    result = _run("audit", "nonsense")
    assert result.exit_code == 2
    for word in ("nonsense", "papers", "literature", "libraries", "filterpy"):
        assert word in result.output


CODE = """import numpy as np


def bias(r, beta, sigma_beta):
    c = np.cos(beta)
    factor = sigma_beta**2/3
    return -r*c*factor


def mean(r, beta):
    return r*np.cos(beta)
"""


@pytest.fixture
def source(tmp_path: Path) -> Path:
    path = tmp_path / "code.py"
    path.write_text(CODE)
    return path


@pytest.mark.parametrize(
    ("where", "quantity", "exit_code", "said"),
    [
        ("bias", "polar.bias.second_order[0]", 1, "line 6: 3 should be 2"),
        ("5-7", "polar.bias.second_order[0]", 1, "line 6: 3 should be 2"),
        ("mean", "polar.map[0]", 0, "read as: r cos(β)"),
        ("11", "polar.map[0]", 0, "equal, proved"),
        ("median", "polar.map[0]", 2, "there is no function median here"),
        ("5-99", "polar.map[0]", 2, "lines 1 to 12"),
    ],
)
def test_a_function_or_lines_of_a_file_are_checked(source: Path, where: str, quantity: str, exit_code: int, said: str):
    given = ("--given", "rho=0") if "bias" in quantity else ()
    result = _run("check", quantity, f"{source}:{where}", "--code", "python", *given)
    assert (result.exit_code, said in result.output) == (exit_code, True), result.output


def test_a_whole_file_is_checked_as_its_function(tmp_path: Path):
    path = tmp_path / "noise.m"
    path.write_text("function Q = noise(T, s)\n G = [T^2/2; T];\n Q = G*G'*s^2;\nend\n")
    pytest.importorskip("tree_sitter")
    result = _run("check", "motion.constant_velocity.process_noise.piecewise", str(path), "--code", "matlab")
    assert (result.exit_code, "equal, proved" in result.output) == (0, True), result.output


@pytest.mark.parametrize("notation", [(), ("--latex",), ("--code", "python")])
def test_an_empty_formula_is_said_to_be_empty(notation: tuple[str, ...]):
    result = _run("check", "polar.map[0]", " ", *notation)
    assert (result.exit_code, "the formula is empty" in result.output) == (2, True)


def test_a_formula_is_latex_or_code_and_not_both():
    assert _run("check", "polar.map[0]", "r", "--latex", "--code", "c").exit_code == 2


def test_text_from_a_page_is_read_and_echoed():
    result = _run("check", "polar.covariance.linear[0,0]", "c₁₁ = r²σβ² sin²β + σr² cos²β", "--given", "rho=0")
    assert (result.exit_code, result.output.splitlines()[0]) == (0, "read as: r² σ_β² sin²(β) + σ_r² cos²(β)")


def test_of_a_number_nothing_is_at_worst_anywhere() -> None:
    said = CliRunner().invoke(app, ["check", "chi2inv(0.99, 2)", "9.3"]).output
    assert "for example: printed 9.3, derived 9.21034" in said
    assert "at worst" not in said
