"""Rewrites exponential polynomials so that nothing cancels when they are computed in floating point.

A textbook form such as e^(−2σ²)(cosh 2σ² − cosh σ²) loses every digit for small σ. It is a polynomial in the
attenuation q = e^(−σ²), and with the shortfall u = 1 − q = −expm1(−σ²), which is computed without loss, every constant
can be multiplied by a power of q + u = 1 until all terms have one degree. Cancellation then happens between exact
rationals, in the derivation; a polynomial that is positive between 0 and 1 ends as a sum of positive terms
(Bernstein). Sines and cosines get the same treatment with cos² + sin² = 1.

Where an exponent is a covariance, of either sign, or there are many, multiplying out gives no such form or too long
a one; then a sum of exponentials is written over what each exponent adds by itself (`derive/stable/exponents.py`).

Each rewritten entry is expanded again and proved equal to what it came from.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache, reduce
from itertools import chain
from math import gcd, lcm
from typing import TYPE_CHECKING

from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.exponential_polynomial import ExponentialPolynomial, ring_over, split
from radartrack.derive.language.stable_form import NotProved, StableForm
from radartrack.derive.language.tensor import Index, Tensor
from radartrack.derive.stable.bernstein_polynomials import Decay, Monomial, rational_number
from radartrack.derive.stable.exponents import Exponents
from radartrack.derive.stable.separated_attenuations import without_cancellation
from radartrack.derive.symbolic import Expr, PolyElement, PolyRing, Symbol

if TYPE_CHECKING:
    from radartrack.derive.symbolic import PolyCoefficient

MOST_DECAYS = 4  # those of a plot in space and its prediction; products of powers of more outgrow what can be read
Spectrum = dict[Expr, Expr]
Form = dict[Expr, "PolyCoefficient"]


@dataclass(frozen=True)
class Wave:
    """The cosine and sine of a multiple of an angle, which may be a product of symbols, or a number."""

    monomial: Monomial
    angle: Expr
    step: Fraction
    cosine: Symbol
    sine: Symbol

    @classmethod
    def of(cls, monomial: Monomial, ring: PolyRing, step: Fraction) -> Wave:
        """Named after the angle."""
        symbols = [s.name for s, power in zip(ring.symbols, monomial, strict=True) for _ in range(power)]
        angle = ring.from_dict({monomial: ring.domain.one}).as_expr()
        plain = "_".join(symbols) or "number"
        name = plain if step == 1 else f"{plain}_times_{step}".replace("/", "_over_")
        return cls(monomial, angle, step, sp.Symbol(f"cos_{name}", real=True), sp.Symbol(f"sin_{name}", real=True))

    def definitions(self) -> dict[Symbol, Expr]:
        """Cosine and sine in the plain symbols."""
        argument = sp.Rational(self.step) * self.angle
        return {self.cosine: sp.cos(argument), self.sine: sp.sin(argument)}


@lru_cache(maxsize=256)
def stable_form(entries: Tensor[Expr]) -> StableForm:
    """Rewrite a tensor of exponential polynomials.

    Raises:
        NotExponentialPolynomial: when an entry is none.
        NotProved: when the rewritten form is not the same function; it is never returned then.
    """
    ring = ring_over(symbol for entry in entries for symbol in entry.free_symbols)
    values = entries.map(lambda entry: ExponentialPolynomial.read(entry, ring))
    rewriter = _Rewriter(ring, values)
    spectra = values.map_distinct(rewriter.spectrum)
    amplitudes = _Amplitudes(spectra)
    rewritten = spectra.map(amplitudes.entry)
    form = StableForm(rewriter.definitions() | amplitudes.definitions, rewritten).only(rewritten)
    _prove(form, values, ring)
    return form


def _prove(form: StableForm, values: Tensor[ExponentialPolynomial], ring: PolyRing) -> None:
    known: dict[Symbol, ExponentialPolynomial] = {}
    for symbol, definition in form.definitions.items():
        known[symbol] = ExponentialPolynomial.read(definition, ring, known)
    expanded = form.entries.map_distinct(lambda entry: ExponentialPolynomial.read(entry, ring, known))
    for entry, found, value in zip(form.entries, expanded, values, strict=True):
        if found != value:
            raise NotProved(f"{entry} was rewritten from {value.expression()} and is not equal to it")


class _Amplitudes:
    """Names for the amplitudes of waves that are sums or that several entries share, up to sign."""

    def __init__(self, spectra: Tensor[Spectrum]) -> None:
        self.definitions: dict[Symbol, Expr] = {}
        self._names: dict[Expr, Symbol] = {}
        counts = Counter(amplitude for spectrum in _distinct(spectra) for amplitude in spectrum.values())
        for index, spectrum in spectra.items():
            for wave, amplitude in spectrum.items():
                shared = counts[amplitude] + counts[-amplitude] > 1 and len(amplitude.free_symbols) > 1
                if (shared or amplitude.is_Add) and wave != 1 and self._named(amplitude) is None:
                    self._define(amplitude, sp.Symbol(f"part_{_label(index, wave)}", real=True))

    def entry(self, spectrum: Spectrum) -> Expr:
        parts = ((wave, amplitude, self._named(amplitude)) for wave, amplitude in spectrum.items())
        return sp.Add(*(wave * (amplitude if name is None else name) for wave, amplitude, name in parts))

    def _named(self, amplitude: Expr) -> Expr | None:
        if amplitude in self._names:
            return self._names[amplitude]
        return -self._names[-amplitude] if -amplitude in self._names else None

    def _define(self, amplitude: Expr, name: Symbol) -> None:
        self._names[amplitude] = name
        self.definitions[name] = amplitude


def _distinct(spectra: Tensor[Spectrum]) -> list[Spectrum]:
    """Each spectrum once: a symmetric tensor repeats its entries."""
    found: list[Spectrum] = []
    for spectrum in spectra:
        if spectrum not in found:
            found.append(spectrum)
    return found


def _label(index: Index, wave: Expr) -> str:
    powers = sorted(wave.as_powers_dict().items(), key=str)
    return "_".join(["".join(map(str, index)), *(f"{base}{'' if power == 1 else power}" for base, power in powers)])


class _Rewriter:
    """The waves and decays that all entries of a tensor share, and the rewriting of one entry."""

    def __init__(self, ring: PolyRing, values: Tensor[ExponentialPolynomial]) -> None:
        self.ring = ring
        frequencies = [[split(exponent)[1] for exponent in value.terms] for value in values]
        growths = [[split(exponent)[0] for exponent in value.terms] for value in values]
        self.waves = tuple(
            Wave.of(monomial, ring, _even_step(monomial, step, frequencies))
            for monomial, step in _common_steps(frequencies)
        )
        self.decays = tuple(
            Decay.of(monomial, ring.from_dict({monomial: ring.domain.one}).as_expr(), step)
            for monomial, step in _common_steps(growths)
        )
        self.exponents = Exponents(self.decays)

    @property
    def are_attenuations(self) -> bool:
        """Whether every decay is that of a variance, which is between 0 and 1, and few enough to multiply out."""
        return len(self.decays) <= MOST_DECAYS and all(d.variance_is_positive for d in self.decays)

    def definitions(self) -> dict[Symbol, Expr]:
        waves = [wave.definitions() for wave in self.waves]
        decays = [decay.definitions() for decay in self.decays] if self.are_attenuations else [self.exponents.names]
        return {symbol: definition for part in (*waves, *decays) for symbol, definition in part.items()}

    def spectrum(self, value: ExponentialPolynomial) -> Spectrum:
        """Products of cosines and sines → amplitude, a sum over monomials of monomial × polynomial in the decays."""
        grouped: dict[Expr, dict[Monomial, dict[Monomial, Fraction]]] = {}
        for wave, monomial, decay, coefficient in self._flatten(value):
            by_decay = grouped.setdefault(wave, {}).setdefault(monomial, {})
            by_decay[decay] = by_decay.get(decay, Fraction(0)) + coefficient
        amplitudes = {
            wave: sp.Add(*(self._term(monomial, by_decay) for monomial, by_decay in by_monomial.items()))
            for wave, by_monomial in grouped.items()
        }
        return {wave: amplitude for wave, amplitude in amplitudes.items() if amplitude != 0}

    def _flatten(self, value: ExponentialPolynomial) -> Iterable[tuple[Expr, Monomial, Monomial, Fraction]]:
        """Terms as (product of cosines and sines, monomial, decay counts, coefficient)."""
        counted = [self._counts(exponent) for exponent in value.terms]
        unity: Form = {sp.Integer(1): sp.QQ_I(1, 0)}
        for (turns, decays), coefficient in zip(counted, value.terms.values(), strict=True):
            degrees = [
                max(abs(other[w]) for other, _ in counted if (other[w] - turns[w]) % 2 == 0)
                for w in range(len(self.waves))
            ]
            oscillation = reduce(
                _multiply,
                map(_unit_circle, self.waves, turns, degrees),
                unity,
            )
            for wave, weight in oscillation.items():
                for monomial, number in coefficient.terms():
                    real = (weight * number).x
                    if real:
                        yield wave, monomial, decays, rational_number(real)

    def _counts(self, exponent: PolyElement) -> tuple[Monomial, Monomial]:
        growth, frequency = split(exponent)
        turns = tuple(_steps(frequency, wave.monomial, wave.step) for wave in self.waves)
        return turns, tuple(-_steps(growth, decay.variance, decay.step) for decay in self.decays)

    def _term(self, monomial: Monomial, by_decay: Mapping[Monomial, Fraction]) -> Expr:
        product = self.ring.from_dict({monomial: self.ring.domain.one}).as_expr()
        if self.are_attenuations:
            return product * without_cancellation(frozenset(by_decay.items()), self.decays)
        return product * self.exponents.total(by_decay)


def _common_steps(polynomials: Sequence[Sequence[PolyElement]]) -> list[tuple[Monomial, Fraction]]:
    """For each monomial in real polynomials, the largest number of which all its coefficients are multiples."""
    found: dict[Monomial, list[Fraction]] = {}
    for polynomial in chain.from_iterable(polynomials):
        for monomial, coefficient in polynomial.terms():
            found.setdefault(monomial, []).append(abs(rational_number(coefficient.x)))
    return [(monomial, _common_step(found[monomial])) for monomial in sorted(found, reverse=True)]


def _even_step(monomial: Monomial, step: Fraction, entries: Sequence[Sequence[PolyElement]]) -> Fraction:
    """Half the step where an entry mixes even and odd multiples of it, as 1 + cos 2x = 2 cos²x does."""
    parities = ({_steps(frequency, monomial, step) % 2 for frequency in entry} for entry in entries)
    return step / 2 if any(len(found) > 1 for found in parities) else step


def _common_step(values: Sequence[Fraction]) -> Fraction:
    denominator = lcm(*(value.denominator for value in values))
    return Fraction(gcd(*(int(value * denominator) for value in values)), denominator)


def _steps(polynomial: PolyElement, monomial: Monomial, step: Fraction) -> int:
    coefficient = polynomial.get(monomial)
    if not coefficient:
        return 0
    return int(rational_number(coefficient.x) / step)


def _unit_circle(wave: Wave, turns: int, degree: int) -> Form:
    """e^(i·turns·angle) as a form of the given degree in cosine and sine: (c + is)^m (c − is)^n, m − n = turns."""
    form: dict[tuple[int, int], PolyCoefficient] = {(0, 0): sp.QQ_I(1, 0)}
    for sign in [1] * ((degree + turns) // 2) + [-1] * ((degree - turns) // 2):
        following: dict[tuple[int, int], PolyCoefficient] = {}
        for (cosines, sines), weight in form.items():
            following[cosines + 1, sines] = following.get((cosines + 1, sines), sp.QQ_I(0, 0)) + weight
            turned = weight * sp.QQ_I(0, sign)
            following[cosines, sines + 1] = following.get((cosines, sines + 1), sp.QQ_I(0, 0)) + turned
        form = following
    return {wave.cosine**c * wave.sine**s: weight for (c, s), weight in form.items() if weight}


def _multiply(first: Form, second: Form) -> Form:
    return {a * b: x * y for a, x in first.items() for b, y in second.items()}
