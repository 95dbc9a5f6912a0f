"""Words find quantities: any name, source, symbol and word of the field, in any case, with a slip in it."""

from __future__ import annotations

from collections.abc import Callable
from fnmatch import fnmatchcase

import pytest
from hypothesis import given
from hypothesis import strategies as st

from radartrack.derive.catalogue import catalogue
from radartrack.derive.finding.word_search import FieldWord, by_words, field_words, missed
from radartrack.derive.language.quantity import Quantity

QUANTITIES = list(catalogue().values())
NAMES = [quantity.name for quantity in QUANTITIES]
KNOWN = [one for one in field_words() if any(fnmatchcase(name, p) for name in NAMES for p in one.patterns)]
SPELLED = [(spelling, one) for one in KNOWN for spelling in one.spellings]


def found(*words: str) -> list[str]:
    return [quantity.name for quantity in by_words(words, QUANTITIES)]


def means(one: FieldWord, name: str) -> bool:
    return any(fnmatchcase(name, pattern) for pattern in one.patterns)


@given(st.sampled_from(NAMES), st.booleans())
def test_a_name_finds_itself_in_any_case(name: str, upper: bool) -> None:
    assert name in found(name.upper() if upper else name)


@given(st.sampled_from(SPELLED), st.sampled_from([str.upper, str.lower, str.title]))
def test_a_word_of_the_field_finds_what_it_means_first(
    pair: tuple[tuple[str, ...], FieldWord], case: Callable[[str], str]
) -> None:
    spelling, one = pair
    names = found(case(" ".join(spelling)))
    assert names
    in_names = all(" ".join(spelling) in name for name in names)
    assert in_names or means(one, names[0]) or any(means(w, names[0]) for s, w in SPELLED if s == spelling)


@given(st.sampled_from([s for s, _ in SPELLED if min(map(len, s)) > 6]), st.data())
def test_a_slip_in_a_long_word_finds_the_same(spelling: tuple[str, ...], data: st.DataObject) -> None:
    place = data.draw(st.integers(1, len(spelling[0]) - 2))
    word = spelling[0]
    slipped = data.draw(st.sampled_from([word[:place] + word[place + 1 :], word[:place] + word[place] + word[place:]]))
    assert set(found(" ".join((slipped, *spelling[1:])))) & set(found(" ".join(spelling)))


@given(st.sampled_from([q for q in QUANTITIES if q.source.author]))
def test_an_author_finds_what_is_cited_from_him(quantity: Quantity) -> None:
    author = quantity.source.author.split()[0]
    assert quantity.name in found(author)


@pytest.mark.parametrize(
    ("words", "first"),
    [
        ("Lerro covariance polar", "polar.covariance.truth"),
        ("bias second order polar", "polar.bias.second_order"),
        ("Jacobian azimuth elevation", "observe.spherical.jacobian"),
        ("sigma_rdot linear", "polar_doppler.std.linear"),
        ("process noise acceleration", "constant_acceleration.process_noise"),
        ("CI", "fusion.covariance_intersection"),
        ("NED", "frames."),
    ],
)
def test_several_words_are_all_met(words: str, first: str) -> None:
    assert first in found(*words.split())[0]


@pytest.mark.parametrize(("words", "unknown"), [("sidereal time", ["sidereal"]), ("singer bananas", ["bananas"])])
def test_words_that_are_said_of_nothing_are_told(words: str, unknown: list[str]) -> None:
    assert missed(words.split(), by_words(words.split(), QUANTITIES)) == unknown


@pytest.mark.parametrize(("letter", "name"), [("sigma_theta", "polar.std.linear"), ("lambda", "alpha_beta.gain")])
def test_a_letter_of_the_field_finds_what_has_its_symbol(letter: str, name: str) -> None:
    assert any(name in one for one in found(letter))


@pytest.mark.parametrize(
    "nothing", ["xyzzy", "sidereal", "nothing.like.this", "zq", "?", "...", "qqqqqqqqqqqqqqqqqqqqqqqq " * 50]
)
def test_what_means_nothing_finds_nothing(nothing: str) -> None:
    assert found(nothing) == []


@pytest.mark.parametrize(
    ("words", "first"),
    [
        ("converted measurement", "polar.unbiased"),
        ("bistatic range rate", "observe.bistatic_range_rate.map"),
        ("range rate", "observe.polar_doppler.map"),
        ("two point differencing", "initiation.two_plots"),
        ("single point initiation", "initiation.one_plot"),
        ("R matrix", "polar.covariance.linear"),
        ("LLA to ECEF", "frames.ecef_from_geodetic.map"),
        ("angle only", "observe.bearing"),
        ("polar to cartesian", "polar.map"),
        ("cartesian to spherical", "observe.spherical.map"),
        ("track to track fusion", "fusion.cross_covariance"),
        ("CV model", "motion.constant_velocity"),
        ("hessian", "polar.hessian"),
    ],
)
def test_what_is_alike_comes_in_the_order_of_what_is_likelier_meant_and_plainer(words: str, first: str) -> None:
    assert found(*words.split())[0].startswith(first)


def test_a_slip_is_one_letter() -> None:
    assert found("gating") == []
