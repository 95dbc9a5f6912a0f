"""The tracking experiment of Prosov: plots of a target, converted and weighed in one way or another, and filtered.

A filter needs a covariance for every plot. Where it is computed from the plot itself, the error of the plot sways
its own weight, whatever the conversion. `track` therefore takes two choices: how a plot becomes a position, and
where its covariance is evaluated.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Literal, NamedTuple, TypeAlias

import numpy as np

from radartrack import convert, kalman, observe
from radartrack._arrays.validation import RealArray
from radartrack.convert import Converted, Method
from radartrack.generated import motion as motions
from radartrack.kalman import Belief, Motion
from radartrack.simulate import Plots, Radar, Straight, plots

Weighting: TypeAlias = Literal["measurement", "prediction", "truth"]
Plot: TypeAlias = Mapping[str, RealArray | float]

RANGE = 150e3
SPEED = 200.0
RANGE_STD = 250.0
START = Belief(np.zeros(4), np.diag([1e14, 1e12, 1e14, 1e12]))
"""Nothing is known before the first plot: deviations of 10 000 km and 1000 km/s of (x, vx, y, vy)."""
WITHOUT_PREDICTION = 2
"""The first plots are weighed by themselves: a line needs two before it predicts anything."""
HANDED_OVER = 5
"""How many plots `track_handed_over` weighs by themselves, as the prediction from two is poorer than a plot."""


class Conversion(NamedTuple):
    """How a plot becomes a position, and the method whose covariance goes with it."""

    position: Callable[[Plot], RealArray]
    covariance: Method


def position_as_printed(plot: Plot) -> RealArray:
    """Prosov's (10) as it is printed: the correction, which is negative itself, is added."""
    return _converted("linear", plot).mean * (1 - np.square(plot["azimuth_std"]) / 2)


def position_with_sign_reversed(plot: Plot) -> RealArray:
    """Prosov's (10) with the sign that makes it the unbiased estimate to second order."""
    return _converted("linear", plot).mean * (1 + np.square(plot["azimuth_std"]) / 2)


def _mean_of(method: Method) -> Callable[[Plot], RealArray]:
    return lambda plot: _converted(method, plot).mean


CONVERSIONS: Mapping[str, Conversion] = {
    "linear": Conversion(_mean_of("linear"), "linear"),
    "printed": Conversion(position_as_printed, "averaged"),
    "reversed": Conversion(position_with_sign_reversed, "averaged"),
    "averaged": Conversion(_mean_of("averaged"), "averaged"),
    "unbiased": Conversion(_mean_of("unbiased"), "unbiased"),
    "posterior": Conversion(_mean_of("posterior"), "posterior"),
}
"""(8)-(9); (10)-(11) as printed and with the sign reversed, where (11) is the averaged covariance; and the others."""


class Scene(NamedTuple):
    """What the radar sees of the target, and what is known of its errors."""

    radar: Radar
    seen: Plots

    @property
    def plots(self) -> Plot:
        """The measurements as the conversion takes them, shape (trials, scans)."""
        return {**self.seen.measured, **self.radar.noise}

    @property
    def exact(self) -> Plot:
        """The same without errors, shape (scans,)."""
        return {**self.seen.truth, **self.radar.noise}

    @property
    def position(self) -> RealArray:
        """True x and y, shape (scans, 2)."""
        return self.seen.states[:, :2]


def scene(period: float, azimuth_std: float, direction: int, scans: int, trials: int, seed: int = 0) -> Scene:
    """A target that starts at 150 km on the x axis and flies along it.

    Args:
        period: from scan to scan [s].
        azimuth_std: deviation of the azimuth [rad].
        direction: 1 away from the radar, -1 towards it.
        scans: number of scans.
        trials: number of trials.
        seed: of the simulation.

    """
    radar = Radar("polar", period, {"range_std": RANGE_STD, "azimuth_std": azimuth_std})
    target = Straight((RANGE, 0.0), (direction * SPEED, 0.0))
    return Scene(radar, plots(target, radar, scans=scans, trials=trials, seed=seed))


def motion(period: float) -> Motion:
    """Constant velocity in the plane without process noise, as in the paper but for the misprint in F."""
    return Motion(motions.plane_transition(T=period), np.zeros((4, 4)))


def motion_as_printed(period: float) -> Motion:
    """The F of the paper as it is printed: each scan adds the x coordinate to the speed along x."""
    transition = motion(period).transition.copy()
    transition[1, 0] = 1.0
    return Motion(transition, np.zeros((4, 4)))


class Tracked(NamedTuple):
    """Errors of the filtered x and y after each scan, shape (trials, scans, 2), and their covariances as filtered."""

    error: RealArray
    covariance: RealArray

    @property
    def nees(self) -> RealArray:
        """Normalised error squared over the two coordinates, shape (trials, scans); 1 on average if consistent."""
        weighted = np.linalg.solve(self.covariance, self.error[..., np.newaxis])[..., 0]
        halved: RealArray = (self.error * weighted).sum(axis=-1) / 2
        return halved


def track(
    view: Scene, conversion: Conversion, weighting: Weighting = "measurement", moves: Motion | None = None
) -> Tracked:
    """Filter the plots of a scene.

    Args:
        view: the plots.
        conversion: how they become positions.
        weighting: where their covariances are evaluated: at the "measurement" itself; at the "prediction" of the
            filter, which does not know the error of the plot; or at the "truth", which no filter knows.
        moves: F and Q of the filter.

    """
    moves = moves or motion(view.radar.period)
    position = conversion.position(view.plots)
    if weighting == "prediction":
        noise = _converted(conversion.covariance, view.plots).covariance[:, :WITHOUT_PREDICTION]
        return _tracked(view, _by_prediction(view, position, noise, moves, _at_mean(conversion.covariance)))
    at = view.plots if weighting == "measurement" else view.exact
    noise = _converted(conversion.covariance, at).covariance
    return _tracked(view, kalman.run(START, moves, position, motions.plane_observation(), noise))


def track_decorrelated(view: Scene) -> Tracked:
    """Filter unbiased positions with the decorrelated covariance, averaged over each prediction."""
    return _started("unbiased", WITHOUT_PREDICTION, view)


def track_handed_over(view: Scene) -> Tracked:
    """The same, but the first five plots are posterior positions with their own posterior covariances."""
    return _started("posterior", HANDED_OVER, view)


def _started(method: Method, count: int, view: Scene) -> Tracked:
    """Begin with so many plots of one method, each weighed by itself, and go on decorrelated."""
    own = _converted(method, view.plots)
    later = CONVERSIONS["unbiased"].position(view.plots)[:, count:]
    position = np.concatenate([own.mean[:, :count], later], axis=1)
    return _tracked(
        view, _by_prediction(view, position, own.covariance[:, :count], motion(view.radar.period), _averaged)
    )


Covariance: TypeAlias = Callable[[Mapping[str, float], Belief], RealArray]
"""The covariance of plots from the noise of the radar and the predicted (x, vx, y, vy)."""


def _at_mean(method: Method) -> Covariance:
    def covariance(noise: Mapping[str, float], predicted: Belief) -> RealArray:
        r, azimuth = np.moveaxis(observe.polar(predicted.mean[..., ::2]).measurement, -1, 0)
        return _converted(method, {"r": r, "azimuth": azimuth, **noise}).covariance

    return covariance


def _averaged(noise: Mapping[str, float], predicted: Belief) -> RealArray:
    at = observe.project("polar", predicted.mean[..., ::2], predicted.covariance[..., ::2, ::2])
    r, azimuth = np.moveaxis(at.mean, -1, 0)
    return convert.polar(
        r, azimuth, noise["range_std"], noise["azimuth_std"], method="decorrelated", predicted=(at.mean, at.covariance)
    ).covariance


def _by_prediction(view: Scene, position: RealArray, first: RealArray, moves: Motion, covariance: Covariance) -> Belief:
    """Filter with covariances that come from what is predicted, after the first ones, which are given."""
    belief, beliefs = START, []
    for scan in range(position.shape[-2]):
        belief = kalman.predict(belief, moves)
        noise = first[:, scan] if scan < first.shape[1] else covariance(view.radar.noise, belief)
        belief = kalman.update(belief, position[:, scan], motions.plane_observation(), noise)
        beliefs.append(belief)
    return Belief(*(np.stack(parts, axis=1) for parts in zip(*beliefs, strict=True)))


def _tracked(view: Scene, belief: Belief) -> Tracked:
    return Tracked(belief.mean[..., ::2] - view.position, belief.covariance[..., ::2, ::2])


def _converted(method: Method, plot: Plot) -> Converted:
    return convert.polar(plot["r"], plot["azimuth"], plot["range_std"], plot["azimuth_std"], method=method)
