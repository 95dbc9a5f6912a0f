"""Tables of four libraries give what the conversions give of their columns, and say which rows cannot be converted."""

import math
from collections.abc import Callable, Mapping
from decimal import Decimal
from typing import Any

import numpy as np
import pytest

import radartrack as rt

for _library in ("narwhals", "pandas", "pint", "polars", "pyarrow", "xarray"):
    pytest.importorskip(_library, reason=f"tables are tested with {_library}")

import pandas as pd  # noqa: E402
import pint  # noqa: E402
import polars as pl  # noqa: E402
import pyarrow as pa  # noqa: E402
import xarray as xr  # noqa: E402

COUNT = 7
NAUTICAL_MILE, KNOT = 1852.0, 1852.0 / 3600.0


def plots() -> dict[str, Any]:
    generator = np.random.default_rng(3)
    return {
        "slant": generator.uniform(1, 50, COUNT),
        "bearing": generator.uniform(-400, 400, COUNT),
        "closing": generator.uniform(-300, 300, COUNT),
        "spread": generator.uniform(0.1, 9, COUNT),
        "name": [f"plot {number}" for number in range(COUNT)],
    }


def variables(data: Mapping[str, Any]) -> xr.Dataset:
    return xr.Dataset({name: ("plot", values) for name, values in data.items()})


LIBRARIES: dict[str, tuple[Callable[[Any], Any], type]] = {
    "pandas": (lambda data: pd.DataFrame(data, index=[f"i{n}" for n in range(COUNT)]), pd.DataFrame),
    "polars": (pl.DataFrame, pl.DataFrame),
    "pyarrow": (pa.table, pa.Table),
    "xarray": (variables, xr.Dataset),
}
COLUMNS: dict[str, str | float] = {
    "r": "slant", "azimuth": "bearing", "range_rate": "closing", "azimuth_std": "spread",
    "range_std": 0.05, "range_rate_std": 3.0, "correlation": 0.4,
}  # fmt: skip
UNITS = {"r": "nautical_mile", "azimuth": "deg", "range_rate": "knot", "azimuth_std": "deg", "range_std": "km"}


@pytest.fixture(params=LIBRARIES)
def library(request: pytest.FixtureRequest) -> tuple[Callable[[Any], Any], type]:
    return LIBRARIES[request.param]


def column(table: Any, name: str) -> Any:
    return np.asarray(table[name])


def direct(data: Mapping[str, Any], method: Any = "unbiased") -> rt.convert.Converted:
    return rt.convert.polar_doppler(
        NAUTICAL_MILE * data["slant"], np.deg2rad(data["bearing"]), KNOT * data["closing"],
        50.0, np.deg2rad(data["spread"]), 3.0, 0.4, method, azimuth_from="y",
    )  # fmt: skip


def test_a_table_of_the_same_library_has_the_old_columns_and_what_the_conversion_gives(library: Any) -> None:
    make, kind = library
    given = make(plots())
    found = rt.tables.convert(given, "polar_doppler", COLUMNS, UNITS, azimuth_from="y")
    mean, covariance = direct(plots())
    assert type(found) is kind
    assert [str(one) for one in column(found, "name")] == plots()["name"]
    names = ["x", "y", "eta"]
    for i, first in enumerate(names):
        np.testing.assert_allclose(column(found, first), mean[:, i], rtol=1e-12)
        for j, second in enumerate(names[i:], i):
            entries = column(found, f"cov_{first}_{second}")
            np.testing.assert_allclose(
                entries, covariance[:, i, j], rtol=1e-9, atol=1e-9 * abs(covariance[:, i, j]).max()
            )
    pairs = ("x_x", "x_y", "x_eta", "y_y", "y_eta", "eta_eta")
    assert kind_columns(found) == [*plots(), *names, *(f"cov_{pair}" for pair in pairs)]


def kind_columns(table: Any) -> list[str]:
    names = table.column_names if isinstance(table, pa.Table) else getattr(table, "columns", table)
    return [*map(str, names)]


def test_the_index_of_pandas_stays_and_nothing_is_joined_by_it() -> None:
    given = pd.DataFrame(plots(), index=[3, 1, 1, 0, 9, -2, 5])
    found = rt.tables.convert(given, "polar_doppler", COLUMNS, UNITS, azimuth_from="y")
    assert found.index.tolist() == given.index.tolist()
    np.testing.assert_allclose(found["x"].to_numpy(), direct(plots()).mean[:, 0], rtol=1e-12)


def spoilt() -> dict[str, Any]:
    data = plots()
    data["slant"][1], data["spread"][4], data["closing"][6] = np.nan, -2.0, math.inf
    return data


def test_bad_rows_are_an_error_that_has_their_numbers_and_what_is_wrong(library: Any) -> None:
    with pytest.raises(rt.tables.BadRows, match=r"3 of 7 rows cannot be converted: .*r is missing") as caught:
        rt.tables.convert(library[0](spoilt()), "polar_doppler", COLUMNS, UNITS)
    assert caught.value.rows == [1, 4, 6]
    assert caught.value.reasons[1].startswith("azimuth_std must be from 0 to 3.14")
    assert caught.value.reasons[1].endswith("got -2 deg")
    assert "got inf knot" in caught.value.reasons[2]


def test_marked_rows_stay_without_numbers_and_the_others_are_as_if_alone(library: Any) -> None:
    found = rt.tables.convert(library[0](spoilt()), "polar_doppler", COLUMNS, UNITS, bad_rows="mark", azimuth_from="y")
    good = [0, 2, 3, 5]
    assert len(column(found, "x")) == COUNT
    assert np.isnan(column(found, "cov_x_y")[[1, 4, 6]].astype(float)).all()
    np.testing.assert_allclose(column(found, "y")[good], direct(plots()).mean[good, 1], rtol=1e-12)
    said = [one if isinstance(one, str) and one else None for one in column(found, "problem").tolist()]
    assert [row for row, problem in enumerate(said) if problem] == [1, 4, 6]


def test_missing_values_of_each_library_are_bad_rows() -> None:
    polars = pl.DataFrame(
        {"r": [1, None, 3], "azimuth": [0.1, 0.2, None], "range_std": [1] * 3, "azimuth_std": [0.1] * 3}
    )
    nullable = polars.to_pandas().convert_dtypes()
    for table in (polars, polars.to_arrow(), nullable):
        with pytest.raises(rt.tables.BadRows) as caught:
            rt.tables.convert(table)
        assert caught.value.rows == [1, 2]
        assert caught.value.reasons == ["r is missing", "azimuth is missing"]


def test_what_several_columns_make_impossible_together_is_told_by_row() -> None:
    table = pl.DataFrame({"r": [1e4] * 3, "u": [0.1, 0.99, 0.2], "v": [0.1, 0.1, 0.1]})
    constants = {"range_std": 10.0, "u_std": 0.01, "v_std": 0.01}
    with pytest.raises(rt.tables.BadRows, match=r"row 1: sqrt\(u\^2 \+ v\^2\)") as caught:
        rt.tables.convert(table, "ruv", constants)
    assert caught.value.rows == [1]


def test_variables_of_several_dimensions_are_broadcast_and_have_the_units_they_say() -> None:
    bearing = xr.DataArray(np.array([10.0, 200.0, 350.0]), dims="beam", attrs={"units": "degree"})
    gates = xr.DataArray(np.array([20.0, 40.0]), dims="gate", attrs={"units": "km"})
    scan = xr.Dataset({"azimuth": bearing, "r": gates})
    found = rt.tables.convert(scan, "polar", {"range_std": 50.0, "azimuth_std": 0.02})
    wanted = rt.convert.polar(np.array([2e4, 4e4])[:, np.newaxis], np.deg2rad([10.0, 200.0, 350.0]), 50.0, 0.02).mean
    np.testing.assert_allclose(found["x"].transpose("gate", "beam"), wanted[..., 0], rtol=1e-12)
    with pytest.raises(rt.tables.BadRows, match=r"entry gate=1, beam=0|entry beam=0, gate=1"):
        rt.tables.convert(scan.assign(r=("gate", [20.0, -1.0])), "polar", {"range_std": 50.0, "azimuth_std": 0.02})


def test_single_precision_stays_where_every_column_read_has_it() -> None:
    single = {name: np.ones(3, np.float32) for name in ("r", "azimuth", "azimuth_std")}
    found = rt.tables.convert(pl.DataFrame(single), "polar", {"range_std": 1.0})
    assert found["x"].dtype == pl.Float32
    double = rt.tables.convert(pl.DataFrame({**single, "r": np.ones(3)}), "polar", {"range_std": 1.0})
    assert double["x"].dtype == pl.Float64


def test_no_rows_give_no_rows_with_the_new_columns() -> None:
    found = rt.tables.convert(pl.DataFrame(plots()).clear(), "polar_doppler", COLUMNS, UNITS)
    assert found.height == 0
    assert "cov_x_eta" in found.columns


@pytest.mark.parametrize(
    ("given", "error", "message"),
    [
        ({"units": {"r": "kilogram"}}, ValueError, "a unit of length such as 'km'; got 'kilogram', which is one of"),
        ({"units": {"r": "furlongish"}}, ValueError, "pint knows no unit 'furlongish'"),
        ({"units": {"r": "m**99999999"}}, ValueError, "the unit of r must be a unit of length"),
        ({"units": {"azimuth": 180}}, TypeError, "the unit of azimuth must be a text such as 'deg'; got 180"),
        ({"columns": {"rnage": "slant"}}, ValueError, "an argument in columns must be one of .*'rnage'"),
        ({"columns": {"r": "slnat"}}, ValueError, "r must be one of the columns .*; got 'slnat'"),
        ({"columns": {"r": "name"}}, TypeError, "r must be a column of real numbers; 'name' holds"),
        ({"columns": {"r": -1.0}}, ValueError, "r must be from 0"),
        ({"columns": {"r": True}}, TypeError, "must be a real number; got True"),
        ({"method": "decorrelated"}, ValueError, "method must be one of"),
        ({"bad_rows": "drop"}, ValueError, "bad_rows must be one of .'raise', 'mark'.|bad_rows must be one of"),
        ({"sensor": "lidar"}, ValueError, "sensor must be one of"),
    ],
)
def test_what_is_no_question_is_refused_with_what_was_given_and_what_is_allowed(
    given: dict[str, Any], error: type[Exception], message: str
) -> None:
    columns = {**COLUMNS, **given.get("columns", {})}
    arguments = {"sensor": "polar_doppler", "units": UNITS} | given | {"columns": columns}
    with pytest.raises(error, match=message):
        rt.tables.convert(pl.DataFrame(plots()), **arguments)


def test_a_column_is_not_written_over_and_a_prefix_makes_room() -> None:
    table = pl.DataFrame({**plots(), "x": range(COUNT)})
    with pytest.raises(ValueError, match=r"must have no columns \['x'\] yet"):
        rt.tables.convert(table, "polar_doppler", COLUMNS, UNITS)
    found = rt.tables.convert(table, "polar_doppler", COLUMNS, UNITS, prefix="cartesian_")
    assert found["x"].to_list() == [*range(COUNT)]
    assert "cartesian_cov_x_x" in found.columns


def test_what_is_no_table_in_memory_is_refused() -> None:
    with pytest.raises(TypeError, match="LazyFrame, which is not computed yet: collect it first"):
        rt.tables.convert(pl.LazyFrame(plots()), "polar_doppler", COLUMNS, UNITS)
    with pytest.raises(TypeError, match=r"frame must be a table of pandas, polars, pyarrow .*; got 'dict'"):
        rt.tables.convert(plots(), "polar_doppler", COLUMNS, UNITS)


SIMPLE = {"r": [1e3, 2e3, 1e3], "azimuth": [0.1, 0.2, 0.3], "range_std": [10.0] * 3, "azimuth_std": [0.01] * 3}


def dictionary_in_pandas(values: list[Any]) -> Any:
    return pd.arrays.ArrowExtensionArray(pa.chunked_array([pa.array(values).dictionary_encode()]))


def decimals(values: list[Any], kind: Any) -> Any:
    return pa.array([None if value is None else Decimal(value) for value in values], kind)


PACKED: dict[str, Callable[[Any], Any]] = {
    "pandas category": lambda values: pd.DataFrame({**SIMPLE, "r": pd.Categorical(values)}),
    "pandas objects": lambda values: pd.DataFrame({**SIMPLE, "r": pd.Series(values, dtype=object)}),
    "pandas sparse": lambda values: pd.DataFrame({**SIMPLE, "r": pd.arrays.SparseArray(values)}),
    "pandas nullable": lambda values: pd.DataFrame({**SIMPLE, "r": pd.array(values, dtype="Float64")}),
    "pyarrow dictionary": lambda values: pa.table({**SIMPLE, "r": pa.array(values).dictionary_encode()}),
    "pyarrow decimal": lambda values: pa.table({**SIMPLE, "r": decimals(values, pa.decimal128(20, 3))}),
    "pyarrow long decimal": lambda values: pa.table({**SIMPLE, "r": decimals(values, pa.decimal256(60, 3))}),
    "pyarrow runs": lambda values: pa.table({**SIMPLE, "r": pa.RunEndEncodedArray.from_arrays([1, 2, 3], values)}),
    "pandas of pyarrow": lambda values: pd.DataFrame({**SIMPLE, "r": dictionary_in_pandas(values)}),
    "polars decimal": lambda values: pl.DataFrame({**SIMPLE, "r": pl.Series(values).cast(pl.Decimal(20, 3))}),
}


@pytest.mark.parametrize("kind", PACKED)
def test_numbers_are_numbers_however_a_library_keeps_them(kind: str):
    expected = rt.convert.polar(SIMPLE["r"], SIMPLE["azimuth"], SIMPLE["range_std"], SIMPLE["azimuth_std"]).mean
    found = rt.tables.convert(PACKED[kind](SIMPLE["r"]))
    np.testing.assert_array_equal(np.transpose([column(found, "x"), column(found, "y")]), expected)


@pytest.mark.parametrize("kind", PACKED)
@pytest.mark.parametrize("place", range(3))
def test_what_is_missing_is_missing_however_a_library_keeps_numbers(kind: str, place: int):
    """Of a dictionary, pyarrow's own arrays have another row's number where nothing is."""
    with pytest.raises(rt.tables.BadRows) as error:
        rt.tables.convert(PACKED[kind]([None if row == place else value for row, value in enumerate(SIMPLE["r"])]))
    assert (error.value.rows, error.value.reasons) == ([place], ["r is missing"])


@pytest.mark.parametrize(
    "empty",
    [
        pd.DataFrame(columns=[*SIMPLE]),
        pl.DataFrame({name: [] for name in SIMPLE}),
        pa.table({name: pa.nulls(0) for name in SIMPLE}),
    ],
    ids=["pandas", "polars", "pyarrow"],
)
def test_a_table_without_rows_is_converted_whatever_types_its_columns_have(empty: Any):
    assert len(column(rt.tables.convert(empty), "x")) == 0


@pytest.mark.parametrize("nothing", [pl.DataFrame({**SIMPLE, "r": [None] * 3}), pa.table({**SIMPLE, "r": pa.nulls(3)})])
def test_a_column_without_a_value_is_missing_in_every_row(nothing: Any):
    with pytest.raises(rt.tables.BadRows) as error:
        rt.tables.convert(nothing)
    assert error.value.reasons == ["r is missing"] * 3


@pytest.mark.parametrize(
    "values", [["a", "b", "a"], [True, False, True], [1 + 0j] * 3, [np.datetime64("2020-01-01")] * 3]
)
def test_what_is_no_number_is_refused_however_it_is_kept(values: list[Any]):
    for packed in (pd.Series(values), pd.Series(values, dtype=object), pd.Categorical(values)):
        with pytest.raises(TypeError, match="r must be a column of real numbers"):
            rt.tables.convert(pd.DataFrame({**SIMPLE, "r": packed}))


def test_two_columns_of_one_name_are_refused():
    twice = pa.Table.from_arrays([pa.array([1.0])] * 2, names=["r", "r"])
    with pytest.raises(ValueError, match="different names"):
        rt.tables.convert(twice)


@pytest.mark.parametrize("unit", ["dB", "percent", "ppm", "m", "degC"])
def test_no_unit_of_something_else_is_an_angle(unit: str):
    with pytest.raises(ValueError, match="unit of angle"):
        rt.tables.convert(pd.DataFrame(SIMPLE), units={"azimuth": unit})


LARGE = [2**53 + 1, None, 2**62 + 1]


@pytest.mark.parametrize(
    "packed",
    [
        pa.table({**SIMPLE, "r": pa.array(LARGE, pa.int64())}),
        pa.table({**SIMPLE, "r": pa.array(LARGE, pa.uint64())}),
        pd.DataFrame({**SIMPLE, "r": pd.array(LARGE, "int64[pyarrow]")}),
        pd.DataFrame({**SIMPLE, "r": pd.array(LARGE, "Int64")}),
        pd.DataFrame({**SIMPLE, "r": pd.Series(LARGE, dtype=object)}),
        pl.DataFrame({**SIMPLE, "r": pl.Series(LARGE, dtype=pl.Int64)}),
    ],
    ids=["pyarrow", "pyarrow, no sign", "pandas of pyarrow", "pandas with NA", "pandas of objects", "polars"],
)
def test_whole_numbers_that_are_no_floats_are_rounded_in_every_library(packed: Any):
    rounded = pd.DataFrame({**SIMPLE, "r": [2.0**53, np.nan, 2.0**62]})
    expected, found = (rt.tables.convert(each, bad_rows="mark") for each in (rounded, packed))
    for name in ("x", "cov_y_y"):
        np.testing.assert_array_equal(column(found, name), column(expected, name))


@pytest.mark.parametrize(
    ("value", "reason"),
    [
        (pd.NA, "r is missing"),
        (pd.NaT, "r is missing"),
        (None, "r is missing"),
        (math.nan, "r is missing"),
        (Decimal("NaN"), "r is missing"),
        (10**400, "got inf"),
        (-(10**400), "got -inf"),
        (Decimal("1e400"), "got inf"),
    ],
    ids=repr,
)
def test_among_objects_what_is_missing_or_beyond_all_floats_is_a_bad_row(value: object, reason: str):
    packed = pd.DataFrame({**SIMPLE, "r": pd.Series([1.0, value, 2.5], dtype=object)})
    with pytest.raises(rt.tables.BadRows, match=f"row 1: .*{reason}") as error:
        rt.tables.convert(packed)
    assert error.value.rows == [1]


def test_a_column_of_several_numbers_a_row_is_refused():
    with pytest.raises(TypeError, match="r must be a column of real numbers"):
        rt.tables.convert(pl.DataFrame({**SIMPLE, "r": np.ones((3, 2))}))


@pytest.mark.parametrize("name", ["x", "cov_x_y", "problem"])
def test_no_new_variable_becomes_the_index_of_a_dimension(name: str):
    given = xr.Dataset({each: (name, values) for each, values in SIMPLE.items()})
    with pytest.raises(ValueError, match=f"no columns .*{name}.*prefix"):
        rt.tables.convert(given, bad_rows="mark")
    assert "new_x" in rt.tables.convert(given, bad_rows="mark", prefix="new_").data_vars


def test_a_number_has_the_unit_one_as_netcdf_writes_it():
    given = xr.Dataset({**{each: ("plot", values) for each, values in SIMPLE.items()}})
    given["correlation"] = ("plot", np.full(3, 0.5), {"units": "1"})
    found = rt.tables.convert(given, columns={"correlation": "correlation"})
    expected = rt.convert.polar(SIMPLE["r"], SIMPLE["azimuth"], SIMPLE["range_std"], SIMPLE["azimuth_std"], 0.5)
    np.testing.assert_array_equal(column(found, "x"), expected.mean[:, 0])
    with pytest.raises(ValueError, match="unit of length"):
        rt.tables.convert(pd.DataFrame(SIMPLE), units={"r": "1"})


@pytest.mark.parametrize("unit", ["m s-1", "m s^-1", "m s**-1", "m/s", "m.s-1"])
def test_a_speed_has_the_unit_that_netcdf_conventions_write(unit: str):
    given = variables({**SIMPLE, "range_rate": [1.0, 2.0, 3.0], "range_rate_std": [1.0] * 3})
    expected = rt.tables.convert(given, "polar_doppler")
    given["range_rate"].attrs["units"] = unit
    xr.testing.assert_equal(rt.tables.convert(given, "polar_doppler"), expected)


@pytest.mark.parametrize("unit", ["m s-2", "m2 s-1", "s-1", "m s -1", "m s-1 rad-1"])
def test_no_other_power_is_a_speed(unit: str):
    with pytest.raises(ValueError, match="unit of speed"):
        rt.tables.convert(pd.DataFrame(SIMPLE), "polar_doppler", units={"range_rate": unit})


@pytest.mark.parametrize("word", ["scale_factor", "add_offset", "_FillValue", "missing_value"])
def test_a_variable_that_is_still_packed_is_refused(word: str):
    """Its numbers are not what they stand for."""
    given = variables(SIMPLE)
    given["r"].attrs[word] = SIMPLE["r"][0]
    with pytest.raises(ValueError, match=rf"r must be .*xarray.decode_cf.*'r' .*{word}"):
        rt.tables.convert(given)
    for harmless in ({"scale_factor": 1.0, "add_offset": 0.0, "_FillValue": -9999.0, "missing_value": np.nan}, {}):
        rt.tables.convert(given.assign(r=given["r"].drop_attrs().assign_attrs(harmless)))


def test_a_whole_number_that_names_a_column_is_not_taken_for_one_number_of_all_rows():
    """A table without a header has the columns 0, 1, 2, ... in pandas."""
    given = pd.DataFrame(SIMPLE).rename(columns={"r": 0, "azimuth": 1})
    with pytest.raises(ValueError, match=r"columns\['r'\] must be a text, .*; got 0, which is one: rename .*0\.0"):
        rt.tables.convert(given, columns={"r": 0, "azimuth": 1})
    assert len(rt.tables.convert(given, columns={"r": 0.0, "azimuth": 2})) == 3


@pytest.mark.parametrize("argument", ["r", "range_std", "range_rate"])
@pytest.mark.parametrize("length", ["nm", "angstrom"])
def test_a_nanometre_is_not_taken_for_a_nautical_mile(argument: str, length: str):
    unit = f"{length}/h" if argument == "range_rate" else length
    with pytest.raises(ValueError, match=f"the unit of {argument} must .*; got '{unit}', which is .* 'nautical_mile'"):
        rt.tables.convert(pd.DataFrame(SIMPLE), "polar_doppler", units={argument: unit})


def test_quantities_of_pint_in_xarray_have_their_units():
    expected = rt.tables.convert(variables(SIMPLE))
    in_kilometres = ("plot", pint.Quantity(np.array(SIMPLE["r"]) / 1e3, "km"))
    in_degrees = ("plot", pint.Quantity(np.degrees(SIMPLE["azimuth"]), "deg"))
    found = rt.tables.convert(variables(SIMPLE).assign(r=in_kilometres, azimuth=in_degrees))
    np.testing.assert_allclose(column(found, "x"), column(expected, "x"), rtol=1e-14)
    with pytest.raises(ValueError, match="unit of angle"):
        rt.tables.convert(variables(SIMPLE).assign(azimuth=in_kilometres))
    with pytest.raises(TypeError, match=r"r must be real numbers; .* whose unit would be lost"):
        rt.convert.polar(found["r"], 0.1, 5.0, 0.1)


def test_a_speed_in_xarray_is_one_of_pint():
    given = variables({**SIMPLE, "range_rate": [1.0, 2.0, 3.0], "range_rate_std": [1.0] * 3})
    expected = rt.tables.convert(given, "polar_doppler")
    knots = pint.Quantity(np.array([1.0, 2.0, 3.0]) / KNOT, "nautical_mile/hour")
    found = rt.tables.convert(given.assign(range_rate=("plot", knots)), "polar_doppler")
    np.testing.assert_allclose(column(found, "eta"), column(expected, "eta"), rtol=1e-14)
