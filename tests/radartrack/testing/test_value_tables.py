"""Values that another language computed at given points are diagnosed as the function that computed them would be."""

import csv
import io
import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from radartrack.derive.catalogue import catalogue
from radartrack.testing import CannotDiagnose, Diagnosis
from radartrack.testing.examination import Examination
from radartrack.testing.function_conventions import AS_ASKED
from radartrack.testing.value_tables import points_table, tabulated
from radartrack.testing.wanted import Wanted, wanted_by
from radartrack.verification.subject import generated
from tests.radartrack.testing import own_functions as own

WANTED = wanted_by("polar.map", {})


def filled(wanted: Wanted, formula: Callable[..., Any], spelled: str = "r") -> str:
    """The table with values in more columns, written by another program, which writes the points again."""
    return _table(wanted, formula, len(wanted.places), lambda value: _spelled(value, spelled), spelled)


def filled_with(wanted: Wanted, formula: Callable[..., Any], spelled: str, columns: int = 0) -> str:
    """The same by one that leaves the points as they are."""
    return _table(wanted, formula, columns or len(wanted.places), repr, spelled)


def _table(
    wanted: Wanted, formula: Callable[..., Any], columns: int, again: Callable[[float], str], spelled: str
) -> str:
    rows = list(csv.reader(io.StringIO(points_table(wanted))))
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\r\n")
    writer.writerow([*rows[0], *(f"entry {n}" for n in range(columns))])
    for row in rows[1:]:
        at = [*map(float, row)]
        writer.writerow([*map(again, at), *(_spelled(value, spelled) for value in formula(*at))])
    return text.getvalue()


def _spelled(value: float, spelled: str) -> str:
    return repr(float(value)) if spelled == "r" else format(value, spelled)


def diagnosed(wanted: Wanted, text: str) -> Diagnosis:
    places = {f"argument {place}": symbol.name for place, symbol in enumerate(wanted.symbols, start=1)}
    return Examination(tabulated(wanted, text), wanted, places, AS_ASKED).diagnosis()


def right(r: float, beta: float) -> tuple[float, float]:
    return r * math.cos(beta), r * math.sin(beta)


@pytest.mark.parametrize("spelled", ["r", ".15g", ".17e"])
def test_a_right_table_is_told_to_be_right_however_its_numbers_are_written(spelled: str) -> None:
    found = diagnosed(WANTED, filled(WANTED, right, spelled))
    assert found.agrees, str(found)
    assert found.ulp is not None
    assert found.ulp < 64


def of_excel(text: str) -> str:
    return "\ufeff" + text.replace(",", ";").replace(".", ",")


def numbered(text: str) -> str:
    """As pandas writes a table, with the numbers of the lines."""
    names, *lines = text.split("\r\n")
    return "\r\n".join([f",{names}", *(f"{number},{line}" for number, line in enumerate(lines) if line)])


def with_gaps(text: str) -> str:
    """Without some lines, and without values in others."""
    names, *lines = text.split("\r\n")
    kept = [line for number, line in enumerate(lines) if number % 7 != 3]
    kept[40] = kept[40].rpartition(",")[0] + ",NaN"
    return "\r\n".join([names, *kept])


@pytest.mark.parametrize(
    ("change", "verdict"),
    [
        (of_excel, "agrees"),
        (lambda text: text.replace(",", "\t"), "agrees"),
        (numbered, "agrees"),
        (with_gaps, "undefined"),
        (lambda text: text.replace("\r\n", "\r\n\r\n"), "agrees"),
        (lambda text: text.replace("\r\n", "\n"), "agrees"),
        (lambda text: text.replace("\r\n", "\r"), "agrees"),
        (lambda text: of_excel(text).replace("\r\n", "\r"), "agrees"),
    ],
    ids=["Excel", "tabulators", "numbered", "gaps", "empty lines", "Unix", "Macintosh", "Excel for Macintosh"],
)
def test_tables_are_read_as_other_programs_write_them(change: Callable[[str], str], verdict: str) -> None:
    found = diagnosed(WANTED, change(filled(WANTED, right)))
    assert found.verdict == verdict, str(found)
    slip = diagnosed(WANTED, change(filled(WANTED, lambda r, beta: (r * math.cos(beta) ** 2, r * math.sin(beta)))))
    assert slip.slip == "entry [0]: the power 1 is 2: cos(beta)**2 for cos(beta)"


@pytest.mark.parametrize("spelled", [".7g", ".5f"])
def test_of_few_digits_no_more_is_asked_than_they_hold(spelled: str) -> None:
    found = diagnosed(WANTED, filled(WANTED, right, spelled))
    assert found.agrees, str(found)
    assert not diagnosed(WANTED, filled(WANTED, lambda r, beta: (r * math.cos(beta) * 1.001, r), spelled)).agrees


def test_a_table_that_another_form_has_lost_digits_in_is_right() -> None:
    wanted = wanted_by("observe.spherical.map", {})
    text = filled(wanted, own.elevation_by_arcsine)
    taken = {f"argument {place + 1}": symbol.name for place, symbol in enumerate(wanted.symbols)}
    found = Examination(tabulated(wanted, text), wanted, taken, AS_ASKED).diagnosis()
    assert found.verdict == "loses_digits", str(found)


def single(r: float, beta: float) -> tuple[float, float]:
    range_, azimuth = np.float32(r), np.float32(beta)
    return float(range_ * np.cos(azimuth)), float(range_ * np.sin(azimuth))


@pytest.mark.parametrize("spelled", [".7g", ".8g", ".7e", ".9g", ".12g", ".17g"])
def test_single_precision_is_right_with_however_many_digits_it_is_written(spelled: str) -> None:
    found = diagnosed(WANTED, filled_with(WANTED, single, spelled))
    assert found.agrees, str(found)
    assert found.lost_digits is None
    wrong = diagnosed(WANTED, filled_with(WANTED, lambda r, beta: single(r, -beta), spelled))
    assert not wrong.agrees


def test_double_precision_in_few_digits_is_not_taken_for_single() -> None:
    found = diagnosed(WANTED, filled_with(WANTED, right, ".9g"))
    assert found.agrees
    assert found.remarks == ("the values are written with 9 digits, in units of whose last one errors are told",)


def linear(r: float, beta: float, sigma_r: float, sigma_beta: float) -> list[float]:
    (xx, xy), (_, yy) = own.linear(r, beta, sigma_r, sigma_beta)
    return [xx, xy, yy]


def test_of_a_covariance_one_triangle_is_enough() -> None:
    wanted = wanted_by("polar.covariance.linear", {"rho": 0.0})
    found = diagnosed(wanted, filled_with(wanted, linear, "r", columns=3))
    assert found.agrees, str(found)
    jacobian = wanted_by("polar.jacobian", {})
    with pytest.raises(CannotDiagnose, match="the table has 3 columns"):
        tabulated(jacobian, filled_with(jacobian, lambda *_: (1.0, 0.0, 1.0), "r", columns=3))


def test_of_a_convention_in_which_no_point_was_computed_no_error_is_told() -> None:
    wanted = wanted_by("polar.covariance.linear[0, 0]", {})

    def of_variance(r: float, beta: float, variance: float, sigma_beta: float, rho: float) -> list[float]:
        radial, across = math.sqrt(variance) * math.cos(beta), r * sigma_beta * math.sin(beta)
        return [radial**2 + across**2 - 2 * rho * radial * across]

    found = diagnosed(wanted, filled(wanted, of_variance))
    assert found.convention == "variances in place of sigma_r"
    assert (found.ulp, found.worst) == (None, None)
    assert "nan" not in str(found)


def test_degrees_and_slips_are_found_in_tables() -> None:
    degrees = diagnosed(WANTED, filled(WANTED, lambda r, beta: right(r, math.radians(beta))))
    assert (degrees.verdict, degrees.convention) == ("convention", "beta in degrees")
    slip = diagnosed(WANTED, filled(WANTED, lambda r, beta: (r * math.cos(beta) ** 2, r * math.sin(beta))))
    assert slip.slip == "entry [0]: the power 1 is 2: cos(beta)**2 for cos(beta)"
    strange = diagnosed(WANTED, filled(WANTED, lambda r, beta: (math.tanh(r) * math.atan(beta), r * math.sin(beta))))
    assert strange.differences == ("entry [0]: differs",)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda _: "", "lines of values"),
        (lambda text: text[: len(text) // 3].rpartition("\r\n")[0], "lines of values"),
        (lambda text: text + text.rpartition("\r\n")[0].rpartition("\r\n")[2] + "\r\n", "lines of values"),
        (lambda text: text.replace("entry 1", "beta"), "1 columns"),
        (lambda text: text.replace("\r\n", "x\r\n", 2), "is no number"),
        (lambda text: text.replace("\r\n", ",1\r\n").replace(",1", "", 1), "has 5 values"),
        (lambda text: "\r\n".join([text.split("\r\n")[0], *text.split("\r\n")[:0:-1]]), "that point has"),
        (lambda _: "\0" * 200_000, "cannot be read as a table"),
    ],
    ids=["empty", "short", "long", "columns", "text", "cells", "order", "no table"],
)
def test_what_is_no_table_of_the_points_is_refused_with_a_word(change: Callable[[str], str], words: str) -> None:
    with pytest.raises(CannotDiagnose, match=words):
        tabulated(WANTED, change(filled(WANTED, right)))


@pytest.mark.parametrize("name", [name for name in catalogue() if name.endswith((".map", ".covariance.linear"))])
def test_tables_of_every_sensor_motion_and_frame_hold_the_points_that_are_asked_for(name: str) -> None:
    """As they are written in full, and with the few digits that other programs show."""
    wanted = wanted_by(name, {})
    head, *rows = (line.split(",") for line in points_table(wanted).splitlines())
    points = {symbol: np.array([float(row[place]) for row in rows]) for place, symbol in enumerate(head)}
    with np.errstate(all="ignore"):
        values = np.broadcast_to(generated(wanted.quantity)(**points), (len(rows), *wanted.shape)).reshape(
            len(rows), -1
        )
    for written in (repr, "{:.6g}".format):
        cells = ([*row, *map(written, map(float, entries))] for row, entries in zip(rows, values, strict=True))
        lines = map(",".join, cells)
        text = "\n".join([",".join([*head, *(f"v{place}" for place in range(values.shape[1]))]), *lines])
        taken = {f"argument {place + 1}": symbol for place, symbol in enumerate(head)}
        found = Examination(tabulated(wanted, text), wanted, taken, AS_ASKED).diagnosis()
        assert found.verdict in {"agrees", "loses_digits", "undefined"}, str(found)
