"""The bibliography: every work is cited, every citation is of a work, and what has a DOI shows it."""

import re

import pytest

from radartrack.derive.bibliography import WORKS, cite
from radartrack.derive.catalogue import catalogue
from radartrack.derive.language.source import Source
from radartrack.derive.tracks.gaussian_coverage import COVERAGE
from radartrack.derive.writing.quantity_text import heading

DOI = re.compile(r"10\.\d{4,9}/\S+")


def sources() -> list[Source]:
    own = [quantity.source for quantity in (*catalogue().values(), COVERAGE)]
    return [*own, *(other for source in own for other in source.also)]


def test_every_quantity_cites_a_work_of_the_bibliography():
    known = {(work.author, work.year, work.doi) for work in WORKS.values()}
    assert [source for source in sources() if (source.author, source.year, source.doi) not in known] == []


def test_every_work_is_cited():
    cited = {(source.author, source.year) for source in sources()}
    assert [key for key, work in WORKS.items() if (work.author, work.year) not in cited] == []


def test_no_two_works_have_one_doi_and_each_is_one():
    dois = [work.doi for work in WORKS.values() if work.doi]
    assert len(set(dois)) == len(dois)
    assert [doi for doi in dois if not DOI.fullmatch(doi)] == []


def test_no_two_works_are_cited_alike():
    assert len({(work.author, work.year) for work in WORKS.values()}) == len(WORKS)


def test_what_is_shown_of_a_quantity_holds_the_doi_of_its_source():
    for quantity in catalogue().values():
        shown = "\n".join(heading(quantity))
        assert all(f"doi:{doi}" in shown for doi in quantity.source.dois), quantity.name


def test_further_sources_are_told_behind_the_first_and_each_doi_once():
    source = cite("lerro1993", "(14)", cite("mo1998", "(5)"), cite("lerro1993", "(15)"))
    assert str(source) == "Lerro & Bar-Shalom 1993 (14); Mo et al. 1998 (5); Lerro & Bar-Shalom 1993 (15)"
    assert source.reference == f"{source}, doi:10.1109/7.220948, doi:10.1109/7.705921"


def test_an_unknown_work_is_refused_with_those_that_are_known():
    with pytest.raises(KeyError, match=r"mo1998.*given 'mo1999'"):
        cite("mo1999")
