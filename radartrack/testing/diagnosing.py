"""Says of a function what it is, beside a derived quantity."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

from radartrack._arrays.validation import number_between
from radartrack.derive.checking.question.declared_world import having_models
from radartrack.derive.language.model import Model
from radartrack.testing.calling.argument_bindings import ANY_NAMES, declared
from radartrack.testing.diagnosis import FEW_ULP, Diagnosis
from radartrack.testing.examination import examined
from radartrack.testing.function_conventions import (
    AS_ASKED,
    angles_of,
    as_variances,
    deviations_of,
    in_degrees,
)
from radartrack.testing.reading import CannotDiagnose
from radartrack.testing.wanted import wanted_by

__all__ = ["CannotDiagnose", "assert_derived", "diagnose"]

Some = bool | str | Iterable[str]


def diagnose(
    function: Callable[..., Any],
    name: str,
    *,
    arguments: Mapping[str, str | Sequence[str]] | None = None,
    degrees: Some = False,
    variances: Some = False,
    given: Mapping[str, float] | None = None,
    models: Iterable[Model] = (),
) -> Diagnosis:
    """Compare a function with a derived quantity.

    Args:
        function: takes numbers or vectors, in any order, and returns what can be seen as an array of the quantity's
            shape. It is called a few hundred times, one point a call.
        name: of the quantity, `polar.covariance.linear`, or of one entry, `polar.covariance.linear[0, 1]`.
        arguments: parameter → the symbol that it takes, or the symbols of the vector that it takes, where names and
            trial do not tell.
        degrees: whether angles, their rates and the deviations of both are passed in degrees; or the symbols that are.
        variances: whether variances are passed in place of deviations; or the symbols of the deviations.
        given: symbol → its value, for symbols that the function takes for known: {"rho": 0}.
        models: of one's own, whose quantities may be named.

    Raises:
        CannotDiagnose: the function cannot be called, raises wherever it is, or returns what cannot be compared.
        UnknownQuantity: there is no quantity of that name.
        ValueError: there is no such entry, symbol or parameter, or a model has a name of the catalogue's.
    """
    own = having_models(models).quantities.values()
    wanted = wanted_by(name, {key: float(value) for key, value in (given or {}).items()}, own)
    names = [symbol.name for symbol in wanted.quantity.symbols]
    for parameter, taken in (arguments or {}).items():
        for one in (taken,) if isinstance(taken, str) else taken:
            if one not in names:
                raise ValueError(
                    f"arguments must name symbols of {name}: {', '.join(names)}; given {one!r} for {parameter}"
                )
    _require_parameters(function, arguments or {})
    stated = AS_ASKED
    in_angles = _chosen("degrees", degrees, angles_of(wanted.symbols), arguments or {})
    if in_angles:
        stated = stated.beside(in_degrees(in_angles))
    in_squares = _chosen("variances", variances, deviations_of(wanted.symbols), arguments or {})
    if in_squares:
        stated = stated.beside(as_variances(in_squares))
    return examined(function, wanted, arguments or {}, stated)


def assert_derived(
    function: Callable[..., Any],
    name: str,
    *,
    ulp: float = FEW_ULP,
    arguments: Mapping[str, str | Sequence[str]] | None = None,
    degrees: Some = False,
    variances: Some = False,
    given: Mapping[str, float] | None = None,
    models: Iterable[Model] = (),
) -> None:
    """Assert that a function is a derived quantity, all over its domain.

    Args:
        function: as for `diagnose`, and so are the others.
        name: of the quantity.
        ulp: the largest error allowed, in units of the last place.
        arguments: parameter → symbol.
        degrees: what is passed in degrees.
        variances: what is passed as a variance.
        given: symbol → value.
        models: of one's own.

    Raises:
        AssertionError: it is something else, or less accurate; the message is the diagnosis.
        CannotDiagnose, UnknownQuantity: as `diagnose`.
        TypeError: ulp is no number.
        ValueError: as `diagnose`; or ulp is less than 0.
    """
    allowed = number_between("ulp", ulp, 0, math.inf)
    conventions = {"degrees": degrees, "variances": variances}
    found = diagnose(function, name, arguments=arguments, given=given, models=models, **conventions)
    if not found.agrees or found.ulp is None or not found.ulp <= allowed:
        limit = f"\n  {allowed:g} ulp are allowed" if found.agrees else ""
        raise AssertionError(f"{found}{limit}")


def _require_parameters(function: Callable[..., Any], arguments: Mapping[str, str | Sequence[str]]) -> None:
    """Refuse names of parameters that the function does not have."""
    known = declared(function)
    names = [name for name, _, _ in known or ()]
    unknown = sorted(set(arguments) - set(names))
    if known is not None and ANY_NAMES not in known and unknown:
        raise ValueError(f"arguments must name parameters: {', '.join(names)}; given {', '.join(unknown)}")


def _chosen(
    option: str, given: Some, allowed: Sequence[str], arguments: Mapping[str, str | Sequence[str]]
) -> list[str]:
    """The symbols for which an option holds; parameters stand for theirs."""
    if isinstance(given, bool):
        return list(allowed) if given else []
    found: list[str] = []
    for name in (given,) if isinstance(given, str) else given:
        stated = arguments.get(name, name)
        found += [stated] if isinstance(stated, str) else stated
    unknown = sorted(set(found) - set(allowed))
    if unknown:
        raise ValueError(f"{option} may name {', '.join(allowed) or 'nothing here'}; given {', '.join(unknown)}")
    return found
