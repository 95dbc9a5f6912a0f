"""The grammars themselves."""

import logging
from pathlib import Path

import pytest
from lark import Lark, logger

from radartrack.derive import reading

FOLDER = Path(reading.__file__).parent


@pytest.mark.parametrize("name", ["text", "tex/latex"])
def test_a_grammar_has_no_conflict_and_so_reads_nothing_in_two_ways(name: str, caplog: pytest.LogCaptureFixture):
    before = logger.level
    logger.addHandler(caplog.handler)
    logger.setLevel(logging.DEBUG)
    try:
        Lark.open(str(FOLDER / f"{name}.lark"), parser="lalr", lexer="basic", debug=True)
    finally:
        logger.removeHandler(caplog.handler)
        logger.setLevel(before)
    assert [record.getMessage() for record in caplog.records if "conflict" in record.getMessage()] == []


def test_a_grammar_with_two_ways_would_be_found(caplog: pytest.LogCaptureFixture):
    logger.addHandler(caplog.handler)
    before = logger.level
    logger.setLevel(logging.DEBUG)
    try:
        Lark('start: start "+" start | "x"', parser="lalr", lexer="basic", debug=True)
    finally:
        logger.removeHandler(caplog.handler)
        logger.setLevel(before)
    assert any("conflict" in record.getMessage() for record in caplog.records)
