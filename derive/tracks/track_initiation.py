"""The first state of a track: from one plot, and from two.

Of a plot with a range rate the radial velocity is known but for its error, and of the others only what is known of all
targets: every component of a velocity is N(0, σ_v²), whatever its direction. In the directions along and across the
line of sight the components are again independent, of the same deviation, and the range rate is a measurement of one of
them. So given the plot all of range, angles and components is normal, and position and velocity are polynomials of them
times sines: their mean and covariance, given the plot, are closed forms.

Of two plots the velocity is the difference of the positions over the time between them; what is linear has the
covariance that follows from the plots'.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property

from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.exponential_polynomial import ExponentialPolynomial
from radartrack.derive.bibliography import cite
from radartrack.derive.language.model import Model
from radartrack.derive.language.quantity import Conditioning, Quantity
from radartrack.derive.language.stable_form import StableForm
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import Variable, correlation, deviation, length, speed
from radartrack.derive.moments import debiased_conversion
from radartrack.derive.moments.closed_form import Closed
from radartrack.derive.sensors import polar_doppler, spherical_doppler
from radartrack.derive.stable.rewriting import general_form
from radartrack.derive.symbolic import Expr, Symbol, cos, sin
from radartrack.derive.units import METRE, METRE_PER_SECOND, SECOND, Unit

sigma_v = Variable("sigma_v", "standard deviation of each component of targets' velocities", METRE_PER_SECOND, 1.0, 1e3)

# What is known of range and radial velocity once the plot is: their means, deviations and correlation.
likely_range = length("likely_range", "mean range given the range rate too")
likely_rate = speed("likely_rate", "mean radial velocity given the plot")
sigma_likely_range = deviation(likely_range, low=1e-3, high=1e4)
sigma_likely_rate = deviation(likely_rate, low=1e-4, high=1e3)
likely_rho = correlation("likely_rho", likely_range, likely_rate)
across = speed("across", "horizontal velocity across the line of sight")
up = speed("up", "velocity across both")
sigma_across, sigma_up = (deviation(velocity, low=1.0, high=1e3) for velocity in (across, up))


@dataclass(frozen=True, eq=False)
class OnePlot:
    """The first state from one plot with a range rate.

    Attributes:
        sensor: whose plot it is.
        angles: those that it measures, with their deviations.
        across: velocities across the line of sight, with their deviations.
        axes: the directions of sight and of those velocities.
    """

    sensor: Model
    angles: Mapping[Variable, Variable]
    across: Mapping[Variable, Variable]
    axes: tuple[tuple[Expr, ...], ...]

    @property
    def symbols(self) -> tuple[Variable, ...]:
        """What the state depends on."""
        return (*self.sensor.measured, *self.sensor.noise_symbols, sigma_v)

    @property
    def units(self) -> tuple[Unit, ...]:
        """Of positions, then of velocities."""
        return (METRE,) * len(self.axes) + (METRE_PER_SECOND,) * len(self.axes)

    @cached_property
    def calculus(self) -> Closed:
        """Position and velocity, and expectations of them given the plot."""
        components = (likely_rate, *self.across)
        position = [likely_range * cosine for cosine in self.axes[0]]
        velocity = [
            sp.Add(*(component * axis[k] for component, axis in zip(components, self.axes, strict=True)))
            for k in range(len(self.axes))
        ]
        names = "xyz"[: len(self.axes)]
        return Closed(
            Model(
                name="track",
                title="Range, angles and the components of the velocity to position and velocity",
                measured=(likely_range, *self.angles, likely_rate, *self.across),
                deviations=(sigma_likely_range, *self.angles.values(), sigma_likely_rate, *self.across.values()),
                correlations={(likely_range, likely_rate): likely_rho},
                outputs=dict(zip([*names, *(f"v{name}" for name in names)], [*position, *velocity], strict=True)),
                units=self.units,
                source=self.sensor.source,
            )
        )

    def form(self, word: Callable[[Closed], Tensor[ExponentialPolynomial]]) -> StableForm:
        """A moment of the state, over what is known of range and radial velocity."""
        nothing = dict.fromkeys(self.across, sp.Integer(0)) | dict.fromkeys(self.across.values(), sigma_v)
        entries = word(self.calculus).map_distinct(lambda entry: entry.expression().xreplace(nothing))
        form = general_form(entries)
        return StableForm({**_along_the_line_of_sight(), **form.definitions}, form.entries).only(form.entries)


def _along_the_line_of_sight() -> dict[Symbol, Expr]:
    """Range and radial velocity given both measurements: no range is likelier than another, the velocity N(0, σ_v²).

    The error of the range is ρ σ_r/σ_ṙ that of the range rate, which the prior tells something of, and one that is
    independent of it.
    """
    r, rdot = polar_doppler.r, polar_doppler.rdot
    sigma_r, _, sigma_rdot = polar_doppler.MODEL.deviations
    (rho,) = polar_doppler.MODEL.correlations.values()
    total = sp.Symbol("total_variance", positive=True)
    kept = sp.Symbol("share_of_the_plot", positive=True)
    spread = sp.Symbol("spread_of_the_range", nonnegative=True)
    return {
        total: sigma_v**2 + sigma_rdot**2,
        kept: sigma_v**2 / total,
        spread: sp.sqrt((1 - rho) * (1 + rho) + rho**2 * kept),
        likely_range: r - rho * sigma_r * sigma_rdot * rdot / total,
        likely_rate: rdot * kept,
        sigma_likely_range: sigma_r * spread,
        sigma_likely_rate: sigma_rdot * sp.sqrt(kept),
        likely_rho: rho * sp.sqrt(kept) / spread,
    }


def _one_plot(sensor: Model) -> OnePlot:
    beta = next(variable for variable in sensor.measured if variable.name == "beta")
    deviations = dict(zip(sensor.measured, sensor.deviations, strict=True))
    if sensor is polar_doppler.MODEL:
        axes = ((cos(beta), sin(beta)), (-sin(beta), cos(beta)))
        return OnePlot(sensor, {beta: deviations[beta]}, {across: sigma_across}, axes)
    epsilon = spherical_doppler.epsilon
    in_space = (
        (cos(epsilon) * sin(beta), cos(epsilon) * cos(beta), sin(epsilon)),
        (cos(beta), -sin(beta), sp.Integer(0)),
        (-sin(epsilon) * sin(beta), -sin(epsilon) * cos(beta), cos(epsilon)),
    )
    angles = {beta: deviations[beta], epsilon: deviations[epsilon]}
    return OnePlot(sensor, angles, {across: sigma_across, up: sigma_up}, in_space)


T = Variable("T", "time from the first plot to the second", SECOND, 1e-3, 1e3)
first, second = (Variable(name, f"a coordinate of the {name} plot", METRE, -1e6, 1e6) for name in ("first", "second"))
first_covariance, second_covariance = (
    Variable(f"{name}_covariance", f"covariance of two coordinates of the {name} plot", METRE**2, -1e8, 1e8)
    for name in ("first", "second")
)


def two_plots_weights() -> Tensor[Expr]:
    """What position and velocity at the second plot are of both plots."""
    return Tensor((2, 2), (sp.Integer(0), sp.Integer(1), -1 / T, 1 / T))


def two_plots_estimate() -> Tensor[Expr]:
    """Position and velocity along one axis."""
    weights = two_plots_weights()
    return Tensor((2,), tuple(weights[i, 0] * first + weights[i, 1] * second for i in range(2)))


def two_plots_covariance() -> Tensor[Expr]:
    """Of positions and velocities along two axes, whose plots' errors are independent from plot to plot."""
    weights = two_plots_weights()

    def entry(i: int, j: int) -> Expr:
        return weights[i, 0] * weights[j, 0] * first_covariance + weights[i, 1] * weights[j, 1] * second_covariance

    return Tensor.build((2, 2), entry)


def _of_one_plot(sensor: Model) -> list[Quantity]:
    start = _one_plot(sensor)
    rows = (
        ("estimate", "mean", (start.units,), "E[h | plot]", debiased_conversion.posterior_estimate),
        (
            "covariance",
            "covariance",
            (start.units, start.units),
            "E[h h' | plot] - E[h | plot] E[h | plot]'",
            debiased_conversion.covariance_truth,
        ),
    )
    return [_quantity(start, *row) for row in rows]


def _quantity(
    start: OnePlot,
    name: str,
    moment: str,
    axes: tuple[tuple[Unit, ...], ...],
    word: str,
    derive: Callable[[Closed], Tensor[ExponentialPolynomial]],
) -> Quantity:
    return Quantity(
        name=f"initiation.one_plot.{start.sensor.name}.{name}",
        meaning=f"{moment} of position and velocity given one plot of {start.sensor.name}",
        axes=axes,
        symbols=start.symbols,
        conditioning=Conditioning.MEASUREMENT,
        source=cite("barshalom2001", "one-point initialisation"),
        word=word,
        derivation=lambda: start.form(derive).expanded(),
        rewriting=lambda: start.form(derive),
    )


def quantities() -> list[Quantity]:
    """The first state from one plot and from two."""
    of_one = [quantity for sensor in (polar_doppler, spherical_doppler) for quantity in _of_one_plot(sensor.MODEL)]
    both = (METRE, METRE_PER_SECOND)
    return [
        *of_one,
        Quantity(
            "initiation.two_plots.estimate",
            "position and velocity along an axis at the second of two plots",
            (both,),
            (first, second, T),
            Conditioning.NONE,
            cite("barshalom2001", "two-point differencing"),
            "(second, (second - first)/T)",
            two_plots_estimate,
            lambda: StableForm({}, Tensor((2,), (second, (second - first) / T))),
            is_difference=True,
        ),
        Quantity(
            "initiation.two_plots.covariance",
            "covariance of positions and velocities along two axes at the second of two plots",
            (both, both),
            (first_covariance, second_covariance, T),
            Conditioning.MEASUREMENT,
            cite("barshalom2001", "two-point differencing"),
            "W diag(C1, C2) W'",
            two_plots_covariance,
            is_difference=True,
        ),
    ]
