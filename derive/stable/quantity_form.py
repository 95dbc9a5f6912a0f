"""The form in which a quantity is written and shown, proved equal to what was derived."""

from __future__ import annotations

from fractions import Fraction
from functools import cache

from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.equality import proved_zero
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.stable_form import NotProved, StableForm
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.stable.rewriting import general_form
from radartrack.derive.stable.shifted_count import with_sums_expanded
from radartrack.derive.symbolic import Expr


def form_of(quantity: Quantity) -> StableForm:
    """The quantity's own rewriting where it has one, else a general form in which little cancels.

    Raises:
        NotProved: when a rewriting is not equal to the derivation.
    """
    return _form(quantity, quantity.derivation, quantity.rewriting)


def scaled(form: StableForm, quantity: Quantity, scale: Variable) -> StableForm:
    """The same with every length over one of them, so that no power of a length overflows that need not.

    A quantity in m^d is homogeneous of the degree d in all that is measured in metres: f(s, x) = s^d f(1, x/s). That
    every quantity of a model has its unit follows from the outputs', which are checked where a model is made.
    """
    lengths = [symbol for symbol in quantity.symbols if symbol.unit.metre and symbol != scale]
    shares = {symbol: sp.Symbol(f"{symbol.name}_per_{scale.name}", real=True) for symbol in lengths}
    over_scale: dict[Expr, Expr] = {symbol: shares.get(symbol, sp.Integer(1)) for symbol in (scale, *lengths)}
    definitions = {shares[symbol]: symbol / scale ** sp.Rational(*_ratio(symbol.unit.metre)) for symbol in lengths}
    definitions |= {name: value.xreplace(over_scale) for name, value in form.definitions.items()}
    entries = [
        scale ** sp.Rational(*_ratio(quantity.unit(index).metre)) * entry.xreplace(over_scale)
        for index, entry in form.entries.items()
    ]
    return StableForm(definitions, form.entries, form.arbitrary).only(Tensor(form.entries.shape, tuple(entries)))


def _ratio(exponent: Fraction) -> tuple[int, int]:
    return exponent.numerator, exponent.denominator


@cache
def _form(quantity: Quantity, *_origin: object) -> StableForm:
    """Kept by what it is derived from: another model may have the same names."""
    if quantity.rewriting is not None:
        form = quantity.rewriting()
        _prove(form, quantity.expression)
    else:
        form = general_form(quantity.expression)
    return form if quantity.scaled_by is None else scaled(form, quantity, quantity.scaled_by)


def readable(quantity: Quantity) -> Tensor[Expr]:
    """The form with its intermediates filled in, to be read: 1 − e^x stands where code calls expm1."""
    form = legible(quantity, form_of(quantity))
    plain = {symbol: without_expm1(definition) for symbol, definition in form.definitions.items()}
    return StableForm(plain, form.entries.map(without_expm1)).expanded()


def legible(quantity: Quantity, form: StableForm) -> StableForm:
    """The form that people read.

    Where code is written over Stumpff's functions, that is the derivation; where it chooses between two forms of a
    function by size, the second of them, the textbook's.
    """
    if any(entry.has(sp.stumpff) for entry in form.entries):
        return StableForm({}, quantity.expression)
    choices = {symbol: sp.Integer(0) for symbol, value in form.definitions.items() if isinstance(value, sp.below)}
    entries = form.entries.map(lambda entry: entry.xreplace(choices))
    return StableForm(form.definitions, entries, form.arbitrary).only(entries)


def without_expm1(expression: Expr) -> Expr:
    """The expression with e^x − 1 in place of calls of expm1, and what is left of other series likewise."""
    expression = expression.xreplace({call: call.expanded() for call in expression.atoms(sp.Abbreviation)})
    calls = expression.atoms(sp.expm1)
    opposites = {-call: 1 - sp.exp(call.args[0]) for call in calls}
    return expression.xreplace(opposites).xreplace({call: sp.exp(call.args[0]) - 1 for call in calls})


def _prove(form: StableForm, derived: Tensor[Expr]) -> None:
    for rewritten, expected in zip(form.proposition(), derived, strict=True):
        if rewritten == expected or with_sums_expanded(rewritten) == with_sums_expanded(expected):
            continue
        if not proved_zero(sp.unguarded(rewritten) - expected):
            raise NotProved(f"{rewritten} is not equal to {expected}")
