"""`--model FILE`: every command treats a model of one's own as one that is built in."""

import json
import re
import tomllib
from collections.abc import Callable
from pathlib import Path

import pytest
from typer.testing import CliRunner, Result

from radartrack.cli import app
from radartrack.commands.model_file import NoModel, load_models
from radartrack.derive.checking.check import check
from radartrack.derive.checking.reporting.verdict import Outcome
from radartrack.derive.moments.conversion_quantities import quantities_of
from radartrack.derive.reading.model_table import read_models
from radartrack.derive.reading.symbol_table import TableError
from radartrack.derive.sensors import models
from tests import own_models
from tests.written import module_of

RIGHT = "-r*T*sin(w*T)"
CLAIMS = """
paper = "Nobody, 2026"
[[claim]]
id = "right"
quantity = "rotor.jacobian[0,1]"
formula = "-r*T*sin(w*T)"
[[claim]]
id = "wrong"
quantity = "rotor.jacobian[0,1]"
formula = "r*T*sin(w*T)"
[[claim]]
id = "built.in"
quantity = "polar.map[0]"
formula = "r*cos(beta)"
[[claim]]
id = "number"
quantity = "rotor.map[0]"
value = "540"
unit = "m"
at = { r = "1000", w = "0.1", T = "10" }
"""


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    return own_models.files(tmp_path_factory.mktemp("models"))


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[..., Result]:
    monkeypatch.chdir(tmp_path)
    return lambda *arguments: CliRunner().invoke(app, [str(one) for one in arguments])


both = pytest.mark.parametrize("kind", ["toml", "py"])


@pytest.mark.parametrize(
    ("kind", "formula", "code"),
    [("toml", RIGHT, 0), ("py", "r*T*cos(w*T)", 1), ("toml", "r*T*sin(phi)", 1), ("toml", "r*T*sin(phi*t*p*q)", 2)],
    ids=str,
)
def test_check_decides_of_an_own_model(
    run: Callable[..., Result], files: dict[str, Path], kind: str, formula: str, code: int
):
    result = run("check", "rotor.jacobian[0,1]", formula, "--model", files[kind])
    assert result.exit_code == code, result.output


@pytest.mark.parametrize("kind", ["toml", "py"])
@pytest.mark.parametrize("name", ["polar.map", "no such"])
def test_verify_says_of_what_there_is_no_quantity(
    run: Callable[..., Result], files: dict[str, Path], kind: str, name: str
):
    result = run("verify", name, "--model", files[kind])
    assert result.exit_code == 2
    said = re.sub(r"[\s│]", "", result.output)
    assert f"noquantityof{files[kind]}iscalled" in said


SHIFTED = """
[symbols]
p = { unit = "m", low = -1e5, high = 1e5 }
q = { unit = "m", low = -1e5, high = 1e5 }
[[model]]
name = "shifted"
measured = ["p", "q"]
outputs = { x = "0.8*p - 0.6*q + 100", y = "p*q" }
units = { x = "m", y = "m^2" }
"""


@pytest.mark.parametrize(
    ("entry", "formula", "outcome"),
    [
        ("map[0]", "0.8*p - 0.6*q + 100", Outcome.EQUAL),
        ("map[0]", "0.8*p - 0.6*q + 10", Outcome.DIFFERS),
        ("map[0]", "0.8*p - 0.6*q", Outcome.DIFFERS),
        ("map[1]", "p*q + 100", Outcome.WRONG_DIMENSIONS),
        ("map[1]", "p + q", Outcome.WRONG_DIMENSIONS),
        ("jacobian[0,0]", "0.8*p", Outcome.WRONG_DIMENSIONS),
    ],
)
def test_dimensions_decide_nothing_where_the_model_adds_a_number_to_a_length(
    entry: str, formula: str, outcome: Outcome
):
    assert check(f"shifted.{entry}", formula, models=read_models(tomllib.loads(SHIFTED))).verdict is outcome


def test_a_claim_that_is_another_quantity_of_the_model_is_said_to_be_that(files: dict[str, Path]):
    verdict = check("rotor.jacobian[0,1]", "r*T*cos(w*T)", models=load_models(files["toml"]))
    assert "rotor.jacobian[1,1]" in {suggestion.formula for suggestion in verdict.suggestions}


def test_a_quantity_itself_is_compared_whole(files: dict[str, Path]):
    (model,) = load_models(files["toml"])
    jacobian = next(one for one in quantities_of(model) if one.name == "rotor.jacobian")
    right = "[[cos(w*T), -r*T*sin(w*T)], [sin(w*T), r*T*cos(w*T)]]"
    assert check(jacobian, right).verdict is Outcome.EQUAL
    assert check(jacobian, right.replace("-r", "r")).verdict is Outcome.DIFFERS


def test_from_python_too_a_name_of_the_catalogue_and_one_that_is_taken_are_refused(files: dict[str, Path]):
    model = load_models(files["toml"])
    with pytest.raises(TableError, match="name occurs twice"):
        check("rotor.map[0]", "r", models=[*model, *load_models(files["py"])])
    with pytest.raises(TableError, match="name is one of the catalogue's"):
        check("polar.map[0]", "r", models=[models()["polar"]])


@both
def test_show_prints_what_check_reads(run: Callable[..., Result], files: dict[str, Path], kind: str):
    shown = run("show", "rotor.bias.truth[0]", "--model", files[kind])
    assert shown.exit_code == 0, shown.output
    formula = shown.stdout.strip().rpartition("\n\n")[2]
    assert check("rotor.bias.truth[0]", formula, models=load_models(files[kind])).verdict is Outcome.EQUAL


@both
def test_list_names_every_quantity_of_the_model(run: Callable[..., Result], files: dict[str, Path], kind: str):
    (model,) = load_models(files[kind])
    listed = run("list", "rotor", "--model", files[kind]).stdout
    assert [q.name for q in quantities_of(model) if q.name not in listed] == []
    assert run("list", "rotor").exit_code == 1


def test_audit_takes_models_beside_the_papers(run: Callable[..., Result], files: dict[str, Path]):
    Path("claims.toml").write_text(CLAIMS)
    result = run("audit", "claims.toml", "--model", files["py"], "--json", "out.json")
    assert result.exit_code == 0, result.output
    (paper,) = json.loads(Path("out.json").read_text())["papers"]
    assert [claim["verdict"] for claim in paper["claims"]] == ["equal", "differs", "equal", "equal"]


def test_a_claims_file_declares_models_of_its_own(run: Callable[..., Result]):
    head, _, claims = CLAIMS.partition("[[claim]]")
    Path("claims.toml").write_text(head + own_models.TOML + "[[claim]]" + claims)
    result = run("audit", "claims.toml", "--model", "claims.toml", "--json", "out.json")  # to say it twice does no harm
    assert result.exit_code == 0, result.output
    (paper,) = json.loads(Path("out.json").read_text())["papers"]
    assert [claim["verdict"] for claim in paper["claims"]] == ["equal", "differs", "equal", "equal"]
    assert [model.name for model in load_models(Path("claims.toml"))] == ["rotor"]


def test_a_model_that_cannot_be_read_spoils_its_own_claims_and_no_others(run: Callable[..., Result]):
    head, _, claims = CLAIMS.partition("[[claim]]")
    broken = own_models.TOML.replace("sin(w*T)", "sin(w*t)")
    Path("claims.toml").write_text(head + broken + "[[claim]]" + claims)
    result = run("audit", "claims.toml", "--json", "out.json")
    assert result.exit_code == 2
    assert "model rotor: outputs.y: t is not a name here" in result.stderr
    (paper,) = json.loads(Path("out.json").read_text())["papers"]
    assert [claim["verdict"] for claim in paper["claims"]] == ["undecided", "undecided", "equal", "undecided"]


MOTION = """
[symbols]
r = { unit = "m" }
w = { unit = "rad/s" }
T = { unit = "s" }
[[model]]
name = "plain"
measured = ["r", "w"]
parameters = ["T"]
outputs = { x = "r*w", y = "r*w*T" }
units = { x = "m*rad/s", y = "m*rad" }
"""


def test_regenerate_writes_the_model_alone(run: Callable[..., Result], tmp_path: Path):
    Path("plain.toml").write_text(MOTION)
    result = run("regenerate", "--model", "plain.toml", "--out", "out")
    assert result.exit_code == 0, result.output
    assert run("regenerate", "--model", "plain.toml", "--out", "out", "--check").exit_code == 0
    module = module_of((tmp_path / "out" / "plain.py").read_text(), tmp_path)
    assert module.map(r=2000.0, w=0.05, T=3.0).tolist() == pytest.approx([100.0, 300.0], rel=1e-15)


def test_verify_looks_at_the_model_s_code(run: Callable[..., Result], files: dict[str, Path]):
    wanted = ["rotor.map", "rotor.bias.truth", "rotor.covariance.linear"]
    arguments = ["--points", "40", "--draws", "1", "--workers", "1", "--json", "out.json"]
    result = run("verify", *wanted, "--model", files["py"], *arguments)
    assert result.exit_code == 0, result.output
    found = {one["quantity"]: one for one in json.loads(Path("out.json").read_text())["functions"]}
    assert set(found) == set(wanted)
    passed = {layer["layer"] for layer in found["rotor.bias.truth"]["layers"] if layer["verdict"] == "passed"}
    assert passed == {"dimensions", "identity", "ulp", "quadrature", "Monte Carlo"}


FUNCTIONS = """
from math import cos, sin

def right(rate, period, range):
    return [range*cos(rate*period), range*sin(rate*period)]

def wrong(rate, period, range):
    return [range*cos(rate*period), range*cos(rate*period)]
"""


@pytest.mark.parametrize(("kind", "function", "code"), [("toml", "right", 0), ("py", "wrong", 1)])
def test_diagnose_says_whether_a_function_is_the_model_s(
    run: Callable[..., Result], files: dict[str, Path], kind: str, function: str, code: int
):
    Path("mine.py").write_text(FUNCTIONS)
    arguments = [part for pair in ("rate=w", "period=T", "range=r") for part in ("--argument", pair)]
    result = run("diagnose", f"mine.py:{function}", "rotor.map", *arguments, "--model", files[kind])
    assert result.exit_code == code, result.output
    assert run("points", "rotor.map", "--out", "points.csv", "--model", files[kind]).exit_code == 0


@pytest.mark.parametrize("command", ["check", "show", "list", "audit", "verify", "regenerate", "diagnose", "points"])
@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("missing.toml", None),
        ("missing.py", None),
        ("empty.toml", ""),
        ("broken.toml", "[[model]"),
        ("huge.toml", "[[model]]\nname = 1" + "0" * 5000),
        ("taken.py", own_models.PYTHON.replace('"rotor"', '"polar"')),
        ("fails.py", "raise ValueError('one\\ntwo\\x1b[31m')"),
        ("ends.py", "raise SystemExit"),
        ("none.py", "MODEL = 3"),
    ],
)
def test_a_file_without_a_model_is_refused_in_one_line(
    run: Callable[..., Result], command: str, name: str, text: str | None
):
    if text is not None:
        Path(name).write_text(text)
    Path("mine.py").write_text(FUNCTIONS)
    asked = {"check": ["polar.map[0]", "r"], "show": ["polar.map"], "regenerate": ["--out", "out"]}
    asked |= {"diagnose": ["mine.py:right", "polar.map"], "points": ["polar.map", "--out", "out"]}
    result = run(command, *asked.get(command, []), "--model", name)
    assert (result.exit_code, len(result.stderr.splitlines())) == (2, 1), result.output
    assert name in result.stderr or "polar" in result.stderr
    assert result.stderr.strip().isprintable()
    assert not Path("out").exists()


def test_a_table_is_data_and_never_run(run: Callable[..., Result], tmp_path: Path):
    mark = tmp_path / "mark"
    hostile = f"__import__('pathlib').Path('{mark}').touch()"
    text = own_models.TOML.replace("r*sin(w*T)", hostile).replace("Range and rate", hostile)
    Path("hostile.toml").write_text(text)
    for command in (["list", "x"], ["check", "rotor.map[0]", "r"], ["show", "rotor.map"], ["verify"]):
        assert run(*command, "--model", "hostile.toml").exit_code == 2
    assert not mark.exists()


def test_both_languages_declare_the_same(files: dict[str, Path]):
    (first,), (second,) = load_models(files["toml"]), load_models(files["py"])
    for one, other in zip(quantities_of(first), quantities_of(second), strict=True):
        assert (one.name, one.symbols, one.axes) == (other.name, other.symbols, other.axes)
        assert one.expression == other.expression


def test_the_examples_of_the_documents_are_models_and_stand_there_as_they_are():
    documents = Path(__file__).parents[3] / "docs"
    page = (documents / "model_of_your_own.md").read_text()
    table, code = (documents / "examples" / f"bistatic.{kind}" for kind in ("toml", "py"))
    assert table.read_text().partition("\n")[2] in page
    assert code.read_text().partition("\n\n")[2] in page
    assert [load_models(path)[0].name for path in (table, code)] == ["bistatic_w"] * 2


def test_of_a_python_file_that_is_none_the_reason_is_told(tmp_path: Path):
    (tmp_path / "model.py").write_text(own_models.PYTHON.replace("METRE, METRE)", "METRE, SECOND)"))
    with pytest.raises(NoModel, match="output y is said to be in s"):
        load_models(tmp_path / "model.py")
