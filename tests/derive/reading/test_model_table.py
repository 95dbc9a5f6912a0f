"""Models of one's own as tables: what they give, what is refused with a word, and that no table is dangerous."""

import json
import math
import tomllib
from collections.abc import Callable
from operator import itemgetter
from typing import Any

import mpmath
import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

from radartrack.derive.evaluation.many_digits import Evaluator
from radartrack.derive.language.model import Model
from radartrack.derive.moments.conversion_quantities import quantities_of
from radartrack.derive.reading import model_table
from radartrack.derive.reading.model_table import data_of, read_models
from radartrack.derive.reading.symbol_table import TableError
from radartrack.derive.sensors import models
from tests.examples import share

COSTLY = ("fourth_order", "semidefinite", "decorrelated", "covariance.averaged", "unbiased.covariance")


def bistatic() -> dict[str, Any]:
    return tomllib.loads("""
        paper = "Willis, Bistatic Radar, 1991"
        [symbols]
        S = { unit = "m", low = 3e4, high = 1e6, meaning = "transmitter to target to receiver" }
        theta = { unit = "rad" }
        L = { unit = "km", low = 1, high = 20 }
        [let]
        x = "R*cos(theta)"
        unused = "nothing that can be read +"
        R = "(S^2 - L^2)/(2*D)"
        D = "S - L*cos(theta)"
        [[model]]
        name = "bistatic_w"
        measured = ["S", "theta"]
        parameters = ["L"]
        outputs = { x = "x", y = "R*sin(theta)" }
        units = { x = "m", y = "m" }
        deviations = { S = "sigma_S", theta = "sigma_theta" }
        correlations = { rho = ["S", "theta"] }
    """)


@pytest.mark.parametrize("said", [("S",), ("S", "theta"), ("S", "L")])
def test_a_symbol_of_which_nothing_is_said_has_the_unit_that_its_outputs_ask_for(said: tuple[str, ...]):
    """The catalogue has a theta too, which is no angle: a fading factor."""
    data = bistatic()
    data["symbols"] = {name: data["symbols"][name] for name in said}
    (model,) = read_models(data)
    assert {symbol.name: str(symbol.unit) for symbol in model.arguments} == {"S": "m", "theta": "rad", "L": "m"}
    assert "fading" not in "".join(symbol.meaning for symbol in model.arguments)


def test_a_symbol_of_the_catalogue_need_not_be_declared_and_a_rate_is_found_from_what_it_is_added_to():
    (model,) = read_models(
        tomllib.loads("""
        [[model]]
        name = "moving"
        measured = ["r", "beta"]
        parameters = ["speed", "T", "rate"]
        outputs = { x = "r*cos(beta + rate*T) + speed*T", y = "r*sin(beta)" }
        units = { x = "m", y = "m" }
        """)
    )
    units = {symbol.name: str(symbol.unit) for symbol in model.arguments}
    assert units == {"r": "m", "beta": "rad", "speed": "m/s", "T": "s", "rate": "rad/s"}
    assert model.measured[0] in models()["polar"].measured


@pytest.mark.parametrize("name", models())
def test_a_built_in_model_written_as_a_table_gives_the_identical_quantities(name: str, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(model_table, "require_own_name", lambda _: None)
    built_in = models()[name]
    (read,) = read_models(json.loads(json.dumps(data_of(built_in))))
    for own, known in zip(quantities_of(read), quantities_of(built_in), strict=True):
        assert (own.name, own.axes, own.symbols, own.meaning) == (known.name, known.axes, known.symbols, known.meaning)
        assert list(map(vars_of, own.symbols)) == list(map(vars_of, known.symbols))
        assert str(own.source) == str(known.source)
        if name == "polar" or not any(word in own.name for word in COSTLY):
            assert own.expression == known.expression


def vars_of(symbol: Any) -> tuple[Any, ...]:
    return symbol.name, symbol.meaning, symbol.unit, symbol.low, symbol.high, symbol.is_correlation


def test_symbols_definitions_and_defaults_are_what_the_file_says():
    (model,) = read_models(bistatic())
    assert [(s.name, s.low, s.high) for s in model.arguments] == [
        ("S", 3e4, 1e6),
        ("theta", -math.pi, math.pi),
        ("L", 1e3, 2e4),
    ]
    assert [s.name for s in model.noise_symbols] == ["sigma_S", "sigma_theta", "rho"]
    assert str(model.source) == "Willis, Bistatic Radar, 1991"
    s, t, b = 5e4, 0.7, 1e4
    r = (s**2 - b**2) / (2 * (s - b * math.cos(t)))
    assert [float(v) for v in Evaluator(model.map, model.arguments)([s, t, b])] == pytest.approx(
        [r * math.cos(t), r * math.sin(t)], rel=1e-14
    )


# Random maps: each is built as text and, beside it, as a function of numbers.
Both = tuple[str, Callable[[Any], Any]]
LEAVES: list[Both] = [
    ("u", itemgetter(0)),
    ("v", itemgetter(1)),
    ("p", itemgetter(2)),
    ("2", lambda _: mpmath.mpf(2)),
    ("0.25", lambda _: mpmath.mpf(1) / 4),
]
ONES: dict[str, Callable[[Any], Any]] = {
    "sin({})": mpmath.sin,
    "cos({})": mpmath.cos,
    "exp(-({}))": lambda x: mpmath.exp(-x),
    "sqrt(3 + ({})^2)": lambda x: mpmath.sqrt(3 + x**2),
    "atan({})": mpmath.atan,
    "log(2 + ({})^2)": lambda x: mpmath.log(2 + x**2),
    "asin(({})/(1 + ({0})^2))": lambda x: mpmath.asin(x / (1 + x**2)),
    "-({})": lambda x: -x,
}
TWOS: dict[str, Callable[[Any, Any], Any]] = {
    "({}) + ({})": lambda a, b: a + b,
    "({}) - ({})": lambda a, b: a - b,
    "({})*({})": lambda a, b: a * b,
    "({})/(1 + ({})^2)": lambda a, b: a / (1 + b**2),
}


def _one(how: str, of: Both) -> Both:
    return how.replace("{0}", "{}").replace("{}", of[0]), lambda at: ONES[how](of[1](at))


def _two(how: str, first: Both, second: Both) -> Both:
    return how.format(first[0], second[0]), lambda at: TWOS[how](first[1](at), second[1](at))


def _is_read(of: Both) -> bool:
    """An exponential of a logarithm is to be written as a power."""
    return "log(" not in of[0].partition("exp(")[2]


maps = st.recursive(
    st.sampled_from(LEAVES),
    lambda inner: (
        st.builds(_one, st.sampled_from(sorted(ONES)), inner)
        | st.builds(_two, st.sampled_from(sorted(TWOS)), inner, inner)
    ),
    max_leaves=4,
)


@share(0.4)
@given(st.lists(maps.filter(_is_read), min_size=1, max_size=3))
def test_of_any_map_the_values_and_slopes_are_those_of_its_formulas(outputs: list[Both]):
    number = {"unit": "1", "low": 0.1, "high": 0.9}
    table = {
        "name": "mine",
        "measured": ["u", "v"],
        "parameters": ["p"],
        "outputs": {f"y{n}": text for n, (text, _) in enumerate(outputs)},
        "units": {f"y{n}": "1" for n in range(len(outputs))},
        "deviations": {"u": "s_u", "v": "s_v"},
    }
    (model,) = read_models({"symbols": {"u": number, "v": number, "p": number}, "model": [table]})
    known = {quantity.name: quantity for quantity in quantities_of(model)}
    at = [mpmath.mpf("0.3"), mpmath.mpf("0.55"), mpmath.mpf("0.7")]
    with mpmath.workdps(40):
        values = Evaluator(known["mine.map"].expression, model.arguments)(at)
        slopes = Evaluator(known["mine.jacobian"].expression, model.arguments)(at)
        for n, (_, function) in enumerate(outputs):
            assert values[n,] == pytest.approx(function(at), rel=1e-20, abs=1e-20)
            by_u = mpmath.diff(lambda u, f=function: f([u, *at[1:]]), at[0])
            by_v = mpmath.diff(lambda v, f=function: f([at[0], v, at[2]]), at[1])
            assert [slopes[n, 0], slopes[n, 1]] == pytest.approx([by_u, by_v], rel=1e-12, abs=1e-12)


def test_a_motion_has_its_map_and_the_derivatives_of_it_alone():
    data = {
        "symbols": {"x": {"unit": "m", "low": -1e5, "high": 1e5}, "w": {"unit": "rad/s"}, "T": {"unit": "s"}},
        "model": [
            {
                "name": "swing",
                "measured": ["x", "w"],
                "parameters": ["T"],
                "outputs": {"x": "x*cos(w*T)", "w": "w"},
                "units": {"x": "m", "w": "rad/s"},
            }
        ],
    }
    (model,) = read_models(data)
    assert [quantity.name for quantity in quantities_of(model)] == ["swing.map", "swing.jacobian", "swing.hessian"]


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"name": "polar"}, "name is one of the catalogue's"),
        ({"name": "observe"}, "name is one of the catalogue's"),
        ({"name": "lambda"}, "must be an identifier of Python and no keyword"),
        ({"name": 3}, "name must be text"),
        ({"outputs": {}}, "outputs must be one to 6 formulas"),
        ({"outputs": {f"x{n}": "S" for n in range(7)}}, "outputs must be one to 6 formulas, given 7"),
        ({"outputs": {"x": "S*cos(phi)", "y": "S"}}, "outputs.x: phi is not a name here"),
        ({"outputs": {"x": "S + theta", "y": "S"}}, "theta in 1 and S in m cannot be added"),
        ({"outputs": {"x": "S*theta", "y": "log(S)"}}, "S in m cannot be inside of log(S)"),
        ({"outputs": {"x": "[S, S]", "y": "S"}}, "must be one number, and is a vector or matrix"),
        ({"outputs": {"x": "abs(S - L)", "y": "S"}}, "is not known to have derivatives"),
        ({"outputs": {"x": "S*sqrt(theta)", "y": "S"}}, "sqrt(theta) is no real number at theta = -3.14159"),
        ({"outputs": {"x": ["S"], "y": "S"}}, "must be a formula in quotes"),
        ({"outputs": {"x": "S*__import__('os')", "y": "S"}}, "outputs.x"),
        ({"units": {"x": "m"}}, "units must name each output once: x, y"),
        ({"units": {"x": "km", "y": "m"}}, "units.x must be an SI unit, m"),
        ({"units": {"x": "furlong", "y": "m"}}, "'furlong' is no unit"),
        ({"units": {"x": "s", "y": "m"}}, "output x is said to be in s"),
        ({"measured": ["S", "theta", "phi"]}, "measured: [symbols] says nothing of phi"),
        ({"measured": "S"}, "measured must be a list of symbols"),
        ({"measured": ["S"] * 13}, "measured names at most 12 symbols"),
        ({"deviations": {"S": "sigma_S"}}, "deviations must name a symbol for each of S, theta"),
        ({"correlations": {"rho": ["S", "L"]}}, "correlations.rho must name two of S, theta"),
        ({"correlations": {"rho": ["S", "theta"], "c": ["S", "theta"]}}, "have a correlation already"),
        ({"source": {"year": "1991"}}, "source must be text, or a table of author"),
        ({"sensor": 1}, "sensor is no field of a model; allowed: name, title"),
    ],
)
def test_what_does_not_fit_is_refused_naming_model_field_and_what_is_allowed(change: dict[str, Any], said: str):
    data = bistatic()
    data["model"][0] |= change
    with pytest.raises(TableError) as refused:
        read_models(data)
    assert said in str(refused.value)
    assert str(refused.value).startswith("model ")


@pytest.mark.parametrize(
    ("table", "name", "value", "said"),
    [
        ("symbols", "S", "m", "symbols.S must be a table"),
        ("symbols", "S", {"low": 1}, "symbols.S.unit must be a unit in quotes"),
        ("symbols", "S", {"unit": "m", "hi": 1}, "hi is no field of a symbol; allowed: unit, low, high"),
        ("symbols", "S", {"unit": "m", "low": "0"}, "symbols.S.low must be a number"),
        ("symbols", "S", {"unit": "m", "low": 10**400}, "symbols.S.low must be a number that floats hold"),
        ("symbols", "S", {"unit": "m", "low": 5, "high": 4}, "from one finite number up to another"),
        ("symbols", "S", {"unit": "m", "high": float("nan")}, "from one finite number up to another"),
        ("symbols", "S", {"unit": "m", "meaning": "two\nlines"}, "must be one line of printable text"),
        ("symbols", "sigma_S", {"unit": "s"}, "the deviation of S must have its unit"),
        ("symbols", "rho", {"unit": "1", "high": 2}, "a correlation must be a number from -1 to 1"),
        ("let", "R", "R + S", "needs a definition that needs itself: R → R"),
        ("let", "D", "x", "needs itself"),
        ("let", "R", "S +", "let R: "),
        ("let", "R", ["S"], "must be a formula in quotes"),
        ("let", "sin", "S", "let sin: sin is a function; define another name"),
        ("let", "ln", "S", "let ln: ln is a function; define another name"),
    ],
)
def test_a_symbol_or_definition_that_does_not_fit_is_named(table: str, name: str, value: Any, said: str):
    data = bistatic()
    data[table][name] = value
    with pytest.raises(TableError) as refused:
        read_models(data)
    assert said in str(refused.value)


def _doubling(depth: int) -> dict[str, str]:
    return {f"a{n}": f"a{n + 1} + a{n + 1}*cos(a{n + 1}/S)" for n in range(depth)} | {f"a{depth}": "S"}


BOMBS: dict[str, dict[str, Any]] = {
    "doubling definitions": {"let": _doubling(40), "x": "a0"},
    "squares of squares": {"let": {f"a{n}": f"a{n + 1}^64" for n in range(30)} | {"a30": "S"}, "x": "a0"},
    "numbers of numbers": {"let": {f"a{n}": f"a{n + 1}^60" for n in range(30)} | {"a30": "10^30"}, "x": "S*a0"},
    "a large exponent": {"x": "S^999999999999"},
    "a tower": {"x": "S*9^9^9^9"},
    "a product of sums": {"x": "S*" + "*".join(f"(theta + {n})" for n in range(60))},
    "a power of a sum": {"x": "S*(S/L + theta + cos(theta) + L/S)^60"},
    "a product of waves": {"x": "S*" + "*".join(f"cos({n}*theta)" for n in range(1, 60))},
    "brackets": {"x": "(" * 5000 + "S" + ")" * 5000},
    "many terms": {"x": "+".join(["S"] * 40_000)},
    "a chain of definitions": {"let": {f"a{n}": f"sin(a{n + 1})" for n in range(450)} | {"a450": "theta"}, "x": "S*a0"},
    "no text": {"x": "S*\0"},
}


@pytest.mark.parametrize("bomb", BOMBS.values(), ids=BOMBS)
def test_a_hostile_table_is_refused_with_a_word_and_without_work(bomb: dict[str, Any]):
    data = bistatic()
    data["let"] = bomb.get("let", {})
    data["model"][0]["outputs"] = {"x": bomb["x"]}
    data["model"][0]["units"] = {"x": "m"}
    with pytest.raises(TableError, match=r"outputs\.x"):
        read_models(data)


def test_two_models_of_one_name_and_too_many_are_refused():
    data = bistatic()
    with pytest.raises(TableError, match="name occurs twice"):
        read_models(data | {"model": data["model"] * 2})
    with pytest.raises(TableError, match="at most 20 models"):
        read_models(data | {"model": data["model"] * 21})


def test_the_same_table_gives_the_same_model_each_time_and_its_quantities_are_its_own():
    first, second = (read_models(bistatic())[0] for _ in range(2))
    assert isinstance(first, Model)
    assert quantities_of(first) == quantities_of(first)
    assert quantities_of(first)[0] is quantities_of(first)[0]
    assert quantities_of(first)[0] != quantities_of(second)[0]  # what is kept of one never serves the other


def summing(formula: str) -> dict[str, Any]:
    """A model of one output."""
    return tomllib.loads(f"""
        [symbols]
        x = {{ unit = "m" }}
        v = {{ unit = "m/s" }}
        T = {{ unit = "s" }}
        [let]
        k = "2"
        [[model]]
        name = "sums"
        measured = ["x", "v"]
        parameters = ["T"]
        outputs = {{ x = "{formula}" }}
        units = {{ x = "m" }}
    """)


@pytest.mark.parametrize(
    ("formula", "meant"),
    [
        ("sum(x + v*T*j, j, 1, 5)/5", "x + 3*v*T"),
        ("sum(sum(v*T*i*j, i, 1, 2), j, 1, 3)", "18*v*T"),
        ("sum(x*cos(v*T*j/x), j, 0, 2)", "x + x*cos(v*T/x) + x*cos(2*v*T/x)"),
        ("x + sum(x, j, 3, 1)", "x"),
    ],
)
def test_a_sum_over_scans_is_written_out(formula: str, meant: str):
    (one,), (other,) = read_models(summing(formula)), read_models(summing(meant))
    assert sympy.expand(one.outputs["x"] - other.outputs["x"]) == 0


@pytest.mark.parametrize(
    ("formula", "said"),
    [
        ("sum(x*j, j, 1, T)", "goes from one whole number to another"),
        ("sum(x*j, j, 1, 10^6)", "the sum is too large"),
        ("sum(sum(sum(x*cos(i*j*k1), i, 1, 99), j, 1, 99), k1, 1, 99)", "the sum is too large"),
        ("sum(x*k, k, 1, 3)", "a name that is defined is no symbol"),
        ("sum([x, x], j, 1, 3)", "that of numbers"),
        ("integral(x*t, t, 0, 1)", "integral is not read here"),
        ("limit(x*t, t, 1)", "limit is not read here"),
    ],
)
def test_what_cannot_be_summed_is_refused_with_a_word(formula: str, said: str):
    with pytest.raises(TableError, match=r"outputs\.x") as caught:
        read_models(summing(formula))
    assert said in str(caught.value)


def test_a_deviation_that_two_errors_share_is_told_by_its_own_name():
    data = bistatic()
    data["symbols"]["theta"] = {"unit": "m"}
    data["model"][0] |= {"outputs": {"x": "S + theta + L"}, "units": {"x": "m"}, "correlations": {}}
    data["model"][0]["deviations"] = {"S": "sigma", "theta": "sigma"}
    with pytest.raises(TableError, match=r"must occur once; given S, theta, L, sigma, sigma$"):
        read_models(data)
