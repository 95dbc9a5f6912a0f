"""Claims about numbers against exact rational arithmetic: units, rounding, order and ties."""

import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict
from decimal import ROUND_HALF_EVEN, ROUND_HALF_UP, Decimal
from fractions import Fraction
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from radartrack.derive.catalogue import catalogue
from radartrack.derive.checking.papers.audit import decide
from radartrack.derive.checking.papers.claim import Claim, UnreadableClaim
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.variable import Variable

# A quantity that is one number, in SI units: a length, a share, and an angle in halves of a right angle.
LENGTH = "polar.map[0]"
SHARE = "fusion.weights.two[0]"
UNITS = {"": (LENGTH, Fraction(1)), "m": (LENGTH, Fraction(1)), "km": (LENGTH, Fraction(1000))}
EVERY_UNIT = {**UNITS, "%": (SHARE, Fraction(1, 100))}


def _at(unit: str, value: Fraction) -> tuple[str, dict[str, str]]:
    """A quantity that has this many units, and where: a share is var_2/(var_1 + var_2)."""
    quantity, scale = EVERY_UNIT[unit]
    if quantity == LENGTH:
        return quantity, {"beta": "0", "r": str(value * scale)}
    share = value * scale
    return quantity, {"sigma_1": f"sqrt({1 - share})", "sigma_2": f"sqrt({share})"}


def _holds(claim: Claim) -> bool:
    verdict = decide(claim).verdict
    assert verdict in {"equal", "differs"}
    return verdict == "equal"


numbers = st.builds(Decimal, st.integers(1, 9999)).map(lambda number: number.scaleb(-2))
offsets = st.sampled_from(["0", "0.5", "-0.5", "0.49999999999999999999", "-0.50000000000000000001", "1"])


@given(numbers, st.integers(0, 3), offsets, st.sampled_from(sorted(EVERY_UNIT)), st.sampled_from(["", "-"]))
def test_a_value_holds_where_it_is_rounded_half_up_or_half_to_even(
    number: Decimal, decimals: int, offset: str, unit: str, sign: str
) -> None:
    last = Decimal(1).scaleb(-decimals)
    printed = number.quantize(last, ROUND_HALF_UP)
    derived = Fraction(printed) + Fraction(offset) * Fraction(last)
    if derived < 0 or (unit == "%" and derived >= 100):
        return
    exact = Decimal(derived.numerator) / Decimal(derived.denominator)
    rounded = {exact.quantize(last, how) for how in (ROUND_HALF_UP, ROUND_HALF_EVEN)}
    quantity, at = _at(unit, derived)
    claim = Claim("a", f"{sign}{quantity}", value=f"{sign}{printed}", unit=unit, at=at)
    assert _holds(claim) is (printed in rounded)
    assert claim.printed == f"{sign}{printed} {unit}".strip()


@given(numbers, numbers, st.sampled_from(sorted(EVERY_UNIT)), st.sampled_from(["at_most", "at_least"]))
def test_a_bound_is_in_the_unit_of_the_claim(number: Decimal, bound: Decimal, unit: str, kind: str) -> None:
    quantity, at = _at(unit, Fraction(number))
    wanted = number <= bound if kind == "at_most" else number >= bound
    assert _holds(_claim(quantity, unit, at, kind, str(bound))) is wanted
    claim = _claim(quantity, unit, at, kind, str(number))
    assert _holds(claim)
    assert claim.printed == f"{kind.replace('_', ' ')} {number} {unit}".strip()


def _claim(quantity: str, unit: str, at: Mapping[str, str], kind: str, level: str) -> Claim:
    return Claim("a", quantity, unit=unit, at=at, **{kind: level})  # type: ignore[arg-type]


@given(st.lists(numbers, min_size=2, max_size=2, unique=True), numbers, st.sampled_from(sorted(UNITS)))
def test_a_level_is_in_the_unit_of_the_claim(ends: list[Decimal], level: Decimal, unit: str) -> None:
    scale = UNITS[unit][1]
    along = ("r", tuple(str(Fraction(end) * scale) for end in ends))
    claim = Claim("a", LENGTH, unit=unit, at={"beta": "0"}, along=along, crosses=str(level))
    assert _holds(claim) is (min(ends) <= level <= max(ends))


@pytest.mark.parametrize("unit", ["deg", "mrad", "rad"])
def test_angles_are_in_the_unit_of_the_claim(unit: str) -> None:
    exact = {"deg": "45", "mrad": "250*pi", "rad": "pi/4"}[unit]
    printed = {"deg": "45", "mrad": "785.4", "rad": "0.7854"}[unit]
    above = {"deg": "45.0000000001", "mrad": "785.399", "rad": "0.7854"}[unit]
    angle, at = "observe.polar.map[1]", {"x": "3", "y": "3"}
    assert _holds(Claim("a", angle, value=printed, unit=unit, at=at))
    assert _holds(Claim("a", angle, at_most=exact, unit=unit, at=at))
    assert _holds(Claim("a", angle, at_least=exact, unit=unit, at=at))
    assert not _holds(Claim("a", angle, at_least=above, unit=unit, at=at))


SHAPES: Mapping[str, Callable[[Fraction], Fraction]] = {
    "polar.map[0]": lambda r: r,
    "polar.map[0]**2": lambda r: r**2,
    "1/polar.map[0]": lambda r: 1 / r,
    "polar.map[0]**2/3": lambda r: r**2 / 3,
    "-polar.map[0]**3": lambda r: -(r**3),
}


@given(
    st.sampled_from(sorted(SHAPES)),
    st.lists(st.fractions(Fraction(1, 10), 9, max_denominator=10), min_size=3, max_size=5, unique=True),
    st.sampled_from(["increasing", "decreasing", "convex", "concave"]),
)
def test_a_trend_is_that_of_the_values_in_order(quantity: str, values: list[Fraction], trend: str) -> None:
    points = [(value, SHAPES[quantity](value)) for value in sorted(values)]
    slopes = [(y - b) / (x - a) for (a, b), (x, y) in pairwise(points)]
    changes = (
        slopes if trend in {"increasing", "decreasing"} else [after - before for before, after in pairwise(slopes)]
    )
    sign = 1 if trend in {"increasing", "convex"} else -1
    claim = Claim("a", quantity, at={"beta": "0"}, along=("r", tuple(map(str, values))), trend=trend)
    assert _holds(claim) is all(sign * change > 0 for change in changes)


@given(st.lists(st.integers(-24, 24), min_size=2, max_size=6, unique=True), st.integers(-24, 24))
def test_a_maximum_is_attained_wherever_it_is(turns: list[int], attained: int) -> None:
    """The cosine of a twelfth of a turn is largest nearest to whole turns."""
    from_whole = {turn: min(turn % 12, -turn % 12) for turn in turns}
    largest = {turn for turn in turns if from_whole[turn] == min(from_whole.values())}
    over = ("beta", tuple(f"{turn}*pi/6" for turn in turns))
    claim = Claim("a", LENGTH, at={"r": "1"}, maximum_over=over, attained_at=f"{attained}*pi/6")
    assert _holds(claim) is (attained in largest)


@pytest.mark.parametrize(
    ("kind", "said"),
    [
        ({"along": ("r", ("7",)), "trend": "increasing"}, "two values"),
        ({"along": ("r", ("7", "8")), "trend": "convex"}, "three values"),
        ({"along": ("r", ("7", "8")), "trend": "concave"}, "three values"),
        ({"along": ("r", ("7", "8", "7.0")), "trend": "increasing"}, "same"),
        ({"along": ("r", ("1/3", "2", "2/6")), "trend": "convex"}, "same"),
        ({"along": ("r", ("7", "14/2")), "crosses": "7"}, "same"),
        ({"along": ("r", ("7", "8", "9")), "crosses": "7"}, "two values"),
        ({"maximum_over": ("r", ("7",)), "attained_at": "7"}, "two or more"),
        ({"maximum_over": ("r", ("7", "sqrt(49)")), "attained_at": "7"}, "same"),
        ({"maximum_over": ("r", ("7", "8")), "along": ("r", ("1", "2")), "trend": "increasing"}, "set twice"),
        ({"along": ("r", ("7", "8")), "value": "7"}, "along belongs to"),
    ],
)
def test_a_claim_that_could_not_fail_is_refused(kind: dict[str, object], said: str) -> None:
    with pytest.raises(UnreadableClaim, match=said):
        decide(Claim("a", LENGTH, at={"beta": "0"}, **kind))  # type: ignore[arg-type]


@pytest.mark.parametrize(
    "field", [{"along": ("r", ("1", "2")), "trend": "increasing"}, {"maximum_over": ("r", ("1", "2")), "value": "2"}]
)
def test_a_symbol_is_set_once(field: dict[str, object]) -> None:
    with pytest.raises(UnreadableClaim, match="r is set twice"):
        decide(Claim("a", LENGTH, at={"beta": "0", "r": "1"}, **field))  # type: ignore[arg-type]


def test_a_level_that_is_the_quantity_itself_is_not_crossed() -> None:
    along = ("r", ("7", "8"))
    assert not _holds(Claim("a", LENGTH, at={"beta": "0"}, along=along, crosses="r"))
    assert _holds(Claim("a", LENGTH, at={"beta": "0"}, along=along, crosses="7"))


def test_what_no_number_of_digits_tells_is_decided_by_algebra() -> None:
    """A difference of 1e-400, and one that vanishes in a way that has to be proved."""
    small = "*".join(["10**-50"] * 4)
    below = {"beta": "0", "r": f"(1 + {small})*(1 - {small})"}
    assert _holds(Claim("a", LENGTH, at=below, at_most="1"))
    assert not _holds(Claim("a", LENGTH, at=below, at_least="1"))
    assert not _holds(Claim("a", f"1/{LENGTH}", at=below, at_most="1"))
    root = {"beta": "0", "r": "sqrt(2) + sqrt(3)"}
    assert _holds(Claim("a", f"{LENGTH}**2", at=root, at_most="5 + 2*sqrt(6)"))
    assert _holds(Claim("a", f"{LENGTH}**2", at=root, at_least="5 + 2*sqrt(6)"))


def test_a_bound_on_a_maximum_is_decided() -> None:
    over = ("r", ("1", "2"))
    assert _holds(Claim("a", LENGTH, at={"beta": "0"}, maximum_over=over, at_most="2"))
    assert not _holds(Claim("a", LENGTH, at={"beta": "0"}, maximum_over=over, at_most="1.9"))


@pytest.mark.parametrize(
    ("quantity", "unit", "at"),
    [
        (LENGTH, "s", {"r": "1", "beta": "0"}),
        (LENGTH, "%", {"r": "1", "beta": "0"}),
        (SHARE, "deg", {"sigma_1": "1", "sigma_2": "1"}),
        ("observe.polar.map[1]", "%", {"x": "1", "y": "1"}),
    ],
)
@pytest.mark.parametrize("kind", ["value", "at_most", "at_least"])
def test_a_unit_that_does_not_fit_is_told_for_every_kind(
    quantity: str, unit: str, at: dict[str, str], kind: str
) -> None:
    assert decide(_claim(quantity, unit, at, kind, "1")).verdict == "wrong_dimensions"


@pytest.mark.parametrize("kind", ["at_most", "at_least"])
def test_a_formula_as_bound_is_in_si_and_has_the_dimension_of_the_quantity(kind: str) -> None:
    at = {"r": "2000", "beta": "0"}
    assert _holds(_claim(LENGTH, "km", at, kind, "r"))
    assert decide(_claim(LENGTH, "km", at, kind, "r**2")).verdict == "wrong_dimensions"
    with pytest.raises(UnreadableClaim, match="leave one of them out"):
        decide(_claim("finite_sample.degree2.gain[0]", "%", {"C": "1", "k": "5"}, kind, "C"))


def _impossible(symbol: Variable) -> Sequence[str]:
    """What no such symbol is, by its meaning."""
    if symbol.is_correlation or (symbol.name in {"u", "v"} and str(symbol.unit) == "1"):
        return "1.0000000000000000000001", "-2"
    if symbol.whole:
        return "2.5", "0", "-3"
    if symbol.name.removeprefix("predicted_").startswith(("sigma", "std")) or symbol.name in {"r", "T"}:
        return "-1", "-1e-30"
    return ("1.6", "-1.6") if symbol.name == "epsilon" else ()


SYMBOLS = {
    (symbol.name, symbol.unit): (quantity, symbol) for quantity in catalogue().values() for symbol in quantity.symbols
}
BOUNDED = [(quantity, symbol) for quantity, symbol in SYMBOLS.values() if _impossible(symbol)]


@pytest.mark.parametrize(("quantity", "symbol"), BOUNDED, ids=[f"{q.name}-{symbol}" for q, symbol in BOUNDED])
def test_what_a_symbol_cannot_be_is_refused_with_its_domain(quantity: Quantity, symbol: Variable) -> None:
    entry = f"{quantity.name}[{','.join('0' for _ in quantity.shape)}]".replace("[]", "")
    at = {one.name: str(round(one.low + 1)) if one.low > 0 else "0" for one in quantity.symbols}
    rest = {name: value for name, value in at.items() if name != symbol.name}
    for value in _impossible(symbol):
        along = (symbol.name, (value, "1"))
        for claim in (
            Claim("a", entry, value="1", at=at | {symbol.name: value}),
            Claim("a", entry, at=rest, along=along, trend="increasing"),
            Claim("a", entry, at=rest, along=along, crosses="1"),
            Claim("a", entry, at=rest, maximum_over=along, value="1"),
            Claim("a", entry, formula="1", given={symbol.name: value}),
        ):
            with pytest.raises(UnreadableClaim, match=f"outside the domain of {symbol}: "):
                decide(claim)


def test_a_symbol_that_another_one_bounds_is_held_to_it() -> None:
    quantity, at = "finite_sample.degree1.range.range_weights[0]", {"T": "1"}
    for claim in (
        Claim("a", quantity, value="1", at=at | {"j": "4", "k": "3"}),
        Claim("a", quantity, at=at | {"k": "3"}, along=("j", ("1", "4")), trend="increasing"),
        Claim("a", quantity, at=at, along=("k", ("3", "9")), maximum_over=("j", ("2", "4")), trend="increasing"),
        Claim("a", quantity, formula="1", given={"j": "4", "k": "3"}),
    ):
        with pytest.raises(UnreadableClaim, match="at most k, which is 3"):
            decide(claim)


def test_directions_may_turn_further_and_limits_may_be_reached() -> None:
    assert _holds(Claim("a", LENGTH, value="1", at={"r": "1", "beta": "2*pi"}))
    assert _holds(Claim("a", "polar.covariance.linear[0,0]", value="0", at={
        "r": "0", "beta": "0", "sigma_r": "0", "sigma_beta": "0", "rho": "1"
    }))  # fmt: skip
    assert _holds(Claim("a", "spherical.map[2]", value="1", at={"r": "1", "beta": "0", "epsilon": "pi/2"}))


@pytest.mark.parametrize(
    ("value", "r", "said"),
    [
        ("99.61995", "99619.95", "derived is 99.61995 km, as printed"),
        ("99.62", "99619.53", "99.6195 km rounds to 99.62 km"),
        ("99.6", "99619.53", "99.6195 km rounds to 99.6 km"),
        ("3", "2500", "2.5 km is midway, and rounds to 3"),
        ("2", "2500.0000000001", "derived is 2.5000000000001 km, printed 2 km"),
    ],
)
def test_a_derived_number_has_the_digits_that_tell(value: str, r: str, said: str) -> None:
    reason = decide(Claim("a", LENGTH, value=value, unit="km", at={"beta": "0", "r": r})).reason
    assert said in reason


def test_numbers_that_differ_are_shown_to_differ() -> None:
    at = {"beta": "0", "r": "5.00000000001"}
    assert decide(Claim("a", LENGTH, at=at, at_most="5")).reason == "5.00000000001 is above 5"


def test_a_claim_is_the_same_after_a_journey_as_json() -> None:
    claim = Claim("a", LENGTH, at={"beta": "0"}, maximum_over=("r", ("1", "2")), value="2", attained_at="2")
    assert _holds(Claim(**json.loads(json.dumps(asdict(claim)))))
