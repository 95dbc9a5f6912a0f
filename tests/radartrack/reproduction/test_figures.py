"""Figures: the same bytes each time, nothing of the machine in them, and words for who cannot see them."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from radartrack.reproduction.pictures import Picture

NAMES = ["prosov", "gao", "gorshkov"]


@pytest.fixture(scope="module", params=NAMES)
def pictures(request: pytest.FixtureRequest) -> list[Picture]:
    pytest.importorskip("matplotlib")
    from radartrack.reproduction.papers import PAPERS  # noqa: PLC0415 - it needs matplotlib

    assert list(PAPERS) == NAMES
    return list(PAPERS[request.param].pictures(request.getfixturevalue(f"{request.param}_found")))


def test_svg_and_png_have_the_same_bytes_each_time_and_no_date(pictures: list[Picture]) -> None:
    drawn = [picture.svg() for picture in pictures]
    assert not any(b"<dc:date>" in svg for svg in drawn)
    svg, png = drawn[0], pictures[0].png()
    assert (svg, png) == (pictures[0].svg(), pictures[0].png())
    assert b"matplotlib" not in png


def test_every_axis_has_a_name_and_a_unit_where_it_has_one(pictures: list[Picture]) -> None:
    for picture in pictures:
        shared = [axes.get_xlabel() for axes in picture.figure.axes] + [a.get_ylabel() for a in picture.figure.axes]
        named = [label for label in shared if label]
        assert named
        without = [label for label in named if not re.search(r"\[.+\]|cycle|scan|over|NEES", label)]
        assert not without


def test_captions_and_alternative_texts_say_what_is_seen(pictures: list[Picture]) -> None:
    for picture in pictures:
        assert len(picture.caption) > 60
        assert len(picture.alt) > 60
    assert pictures[0]._repr_mimebundle_()["text/plain"] == pictures[0].alt
