"""Faults of public code, retold: functions as engineers write them, right and wrong."""

import ctypes
import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np


def radar_jacobian(px: float, py: float, vx: float, vy: float) -> Any:
    """Of range, azimuth and range rate, as in the filters of robots."""
    c1 = px * px + py * py
    c2 = math.sqrt(c1)
    c3 = c1 * c2
    return np.array([
        [px / c2, py / c2, 0, 0],
        [-py / c1, px / c1, 0, 0],
        [py * (vx * py - vy * px) / c3, px * (px * vy - py * vx) / c3, px / c2, py / c2],
    ])  # fmt: skip


def x_for_y(px: float, py: float, vx: float, vy: float) -> Any:
    found = radar_jacobian(px, py, vx, vy)
    found[2, 0] *= px / py
    return found


def whole_number_power(px: float, py: float, vx: float, vy: float) -> Any:
    """3/2 of whole numbers is 1."""
    found = radar_jacobian(px, py, vx, vy)
    found[2, :2] *= math.sqrt(px * px + py * py)
    return found


def interleaved(state: Any) -> Any:
    """The state as x, vx, y, vy in one vector, and the columns likewise."""
    px, vx, py, vy = state
    return radar_jacobian(px, py, vx, vy)[:, [0, 2, 1, 3]]


def guarded(px: float, py: float, vx: float, vy: float) -> Any:
    """Zero where the target is near."""
    return radar_jacobian(px, py, vx, vy) if px * px + py * py > 1e-4 and px > -5e5 else np.zeros((3, 4))


def lost_power_signs(east: float, north: float, up: float) -> Any:
    """Of range, azimuth and elevation; the last row has sqrt(E² + 2 + N) for sqrt(E² + N²)."""
    ground, distance = east**2 + north**2, east**2 + north**2 + up**2
    wrong, slant = math.sqrt(2 + east**2 + north), math.sqrt(distance)
    return [
        [east / slant, north / slant, up / slant],
        [north / ground, -east / ground, 0.0],
        [-east * up / (wrong * distance), -north * up / (wrong * distance), wrong / distance],
    ]


def rotated(r: float, theta: float, sr: float, st: float, *, across: Callable[[float, float], float]) -> Any:
    """R S Rᵀ."""
    c, s = math.cos(theta), math.sin(theta)
    turn = np.array([[c, -s], [s, c]])
    return turn @ np.diag([sr**2, across(r, st) ** 2]) @ turn.T


def without_range(r: float, theta: float, sr: float, st: float) -> Any:
    """The deviation of the angle is not multiplied by the range."""
    return rotated(r, theta, sr, st, across=lambda _, angle: angle)


def linear(r: float, theta: float, sr: float, st: float) -> Any:
    return rotated(r, theta, sr, st, across=lambda distance, angle: distance * angle)


def of_variances(r: float, theta: float, p: float, q: float) -> Any:
    return linear(r, theta, math.sqrt(p), math.sqrt(q))


def in_degrees(r: float, bearing: float, sr: float, sb: float) -> Any:
    return linear(r, math.radians(bearing), sr, math.radians(sb))


def printed_unbiased(r: float, theta: float, sr: float, st: float, kind: Any = np.float64) -> Any:
    """As it is printed: a small difference of large squares."""
    distance, angle, along, across = map(kind, (r, theta, sr, st))
    half, two = kind(0.5), kind(2)
    attenuation = np.exp(-across * across / two)
    excess = (attenuation**-2 - two) * distance**2
    size, fourth = half * (distance**2 + along**2), attenuation**4
    c, s = np.cos(angle), np.sin(angle)
    mixed = excess * c * s + size * fourth * np.sin(two * angle)
    return np.array([
        [excess * c * c + size * (1 + fourth * np.cos(two * angle)), mixed],
        [mixed, excess * s * s + size * (1 - fourth * np.cos(two * angle))],
    ], dtype=kind)  # fmt: skip


def printed_unbiased_single(r: float, theta: float, sr: float, st: float) -> Any:
    return printed_unbiased(r, theta, sr, st, np.float32)


def bias_of_truth(r: float, theta: float, s: float) -> Any:
    """The bias given the truth."""
    shortfall = math.expm1(-s * s / 2)
    return [r * math.cos(theta) * shortfall, r * math.sin(theta) * shortfall]


def half_plane(x: float, y: float) -> Any:
    return math.hypot(x, y), math.atan(y / x)


def hypot_of_c() -> Any:
    """A function of a shared library."""
    found = ctypes.CDLL(None).hypot
    found.argtypes, found.restype = (ctypes.c_double, ctypes.c_double), ctypes.c_double
    return found


def white_noise_velocity(q: float, dt: float) -> Any:
    """The process noise of constant velocity with a fourth power where the third belongs."""
    return q * np.array([[dt**4 / 4, dt**2 / 2], [dt**2 / 2, dt]])


def direction_cosines(r: float, u: float, v: float, sr: float, su: float, sv: float, *, product: float = 1.0) -> Any:
    """The variance of z to second order, of range and direction cosines with independent errors."""
    w2 = 1 - u * u - v * v
    linear = w2 * sr**2 + (r * u * su) ** 2 / w2 + (r * v * sv) ** 2 / w2
    curved = (r * (1 - v * v) * su**2) ** 2 / (2 * w2**3) + (r * (1 - u * u) * sv**2) ** 2 / (2 * w2**3)
    mixed = (u * sr * su) ** 2 / w2 + (v * sr * sv) ** 2 / w2
    return linear + curved + mixed + product * (r * u * v * su * sv) ** 2 / w2**3


def lost_product(r: float, u: float, v: float, sr: float, su: float, sv: float) -> Any:
    """Without the product of both variances."""
    return direction_cosines(r, u, v, sr, su, sv, product=0.0)


def other_product(r: float, u: float, v: float, sr: float, su: float, sv: float) -> Any:
    """With another factor in the place of u²v²/w⁶."""
    w2 = 1 - u * u - v * v
    factor = (u * u * v * v / w2**3 - (u * u + v * v) / w2**2 - 1 / w2) / 2
    return lost_product(r, u, v, sr, su, sv) + (r * su * sv) ** 2 * factor


def piecewise_noise(dt: float, sigma: float) -> Any:
    """Of an acceleration that is constant over a period."""
    g = np.array([dt**2 / 2, dt])
    return sigma**2 * np.outer(g, g)


def bearing_of_compass(x: float, y: float) -> float:
    """Degrees from north, from 0 to 360."""
    return math.degrees(math.atan2(x, y)) % 360


def bearing_in_degrees(x: float, y: float) -> float:
    return math.degrees(math.atan2(y, x)) % 360


def turning(x: Any, dt: float) -> Any:
    """A state whose name is that of its first part."""
    px, py, v, yaw, w = x
    late = yaw + w * dt
    return [
        px + v / w * (math.sin(late) - math.sin(yaw)),
        py + v / w * (math.cos(yaw) - math.cos(late)),
        v,
        late,
        w,
    ]


def of_a_matrix(z: Any, R: Any) -> Any:
    """The covariance of the errors as a matrix."""
    r, b = z
    jacobian = np.array([[math.cos(b), -r * math.sin(b)], [math.sin(b), r * math.cos(b)]])
    return jacobian @ R @ jacobian.T


def of_a_matrix_in_space(r: float, az: float, el: float, covariance: Any) -> Any:
    c, s, k, t = math.cos(az), math.sin(az), math.cos(el), math.sin(el)
    jacobian = np.array([[k * s, r * k * c, -r * t * s], [k * c, -r * k * s, -r * t * c], [t, 0, r * k]])
    return jacobian @ covariance @ jacobian.T


def of_a_matrix_wrongly(z: Any, R: Any) -> Any:
    """The deviations of the matrix are not squared."""
    return of_a_matrix(z, np.sqrt(np.abs(R)) * np.sign(R))


def of_physics(r: float, theta: float, phi: float) -> Any:
    """Spherical coordinates as physics has them: theta from the zenith, phi from x."""
    return r * math.sin(theta) * math.cos(phi), r * math.sin(theta) * math.sin(phi), r * math.cos(theta)


def elevation_by_arcsine(x: float, y: float, z: float) -> Any:
    """Right, and exact nowhere near the vertical."""
    r = math.sqrt(x * x + y * y + z * z)
    return [r, math.atan2(x, y), math.asin(z / r)]


def gain_by_its_printed_formula(index: float) -> Any:
    """Kalata's, which is one less what is nearly one."""
    root = (4 + index - math.sqrt(8 * index + index**2)) / 4
    alpha = 1 - root * root
    return [alpha, 2 * (2 - alpha) - 4 * math.sqrt(1 - alpha)]


def single_inside(r: float, az: float) -> Any:
    """Sines of single precision, and everything else double."""
    return [r * float(np.cos(np.float32(az))), r * float(np.sin(np.float32(az)))]


def nearly_degrees(r: float, az: float) -> Any:
    """With too few digits of π, which is no rounding."""
    return [r * math.cos(az * 3.14159 / 180), r * math.sin(az * 3.14159 / 180)]


def variances_first(r: float, theta: float, sr: float, st: float) -> Any:
    found = linear(r, theta, sr, st)
    return found[0, 0], found[1, 1], found[0, 1]


def wiener_sequence(dt: float, sigma: float, last: float = 1.0) -> Any:
    """The noise of an acceleration that steps between periods."""
    g = np.array([dt**2 / 2, dt, 1.0])
    found = sigma**2 * np.outer(g, g)
    found[2, 2] *= last
    return found


def wiener_sequence_of_variance(dt: float, q: float) -> Any:
    return wiener_sequence(dt, math.sqrt(q))


def wiener_sequence_with_a_slip(dt: float, sigma: float) -> Any:
    return wiener_sequence(dt, sigma, dt)


def in_kilometres(r: float, az: float) -> Any:
    return r * math.cos(az) / 1000, r * math.sin(az) / 1000


def milliradians(r: float, theta: float, sr: float, st: float) -> Any:
    return linear(r, theta, sr, st / 1000)


def other_side_of_the_baseline(path: float, beta: float, baseline: float) -> Any:
    r = (path**2 - baseline**2) / (2 * (path + baseline * math.cos(beta)))
    return [r * math.cos(beta), r * math.sin(beta)]


def slope_with_a_doubled_term(S_xx: float, S_xy: float, S_yy: float) -> float:
    """A slip below a square."""
    return (S_yy - S_xx + math.sqrt((S_xx - 2 * S_yy) ** 2 + 4 * S_xy**2)) / (2 * S_xy)


@dataclass
class Plot:
    """As code with types has it."""

    rng: float
    az: float


def to_xy(r: float, az: float) -> Any:
    return r * math.cos(az), r * math.sin(az)


def of_many_plots(plots: Any) -> Any:
    """Of an array of plots, and of nothing else."""
    _, two = plots.shape
    assert two == 2
    return np.column_stack([plots[:, 0] * np.cos(plots[:, 1]), plots[:, 0] * np.sin(plots[:, 1])])


def of_an_object(plot: Plot) -> Any:
    return to_xy(plot.rng, plot.az)


def of_a_mapping(plot: Any) -> Any:
    return to_xy(plot["range"], plot["azimuth"])


def intersection(P1: Any, P2: Any, w: float) -> Any:
    return np.linalg.inv(w * np.linalg.inv(P1) + (1 - w) * np.linalg.inv(P2))


def least_squares_of_scans(T: float, s: float, k: int = 7) -> Any:
    design = np.array([[1, (j - k) * T] for j in range(1, k + 1)])
    return s**2 * np.linalg.inv(design.T @ design)


def on_wgs84(lat: float, lon: float, h: float, *, polar: float = (1 - 1 / 298.257223563) ** 2) -> Any:
    """Geodetic coordinates on the ellipsoid that everybody has."""
    normal = 6378137.0 / math.hypot(math.cos(lat), (1 - 1 / 298.257223563) * math.sin(lat))
    across = (normal + h) * math.cos(lat)
    return across * math.cos(lon), across * math.sin(lon), (normal * polar + h) * math.sin(lat)


def on_wgs84_wrongly(lat: float, lon: float, h: float) -> Any:
    return on_wgs84(lat, lon, h, polar=1.0)


def correlations_of(covariance: Any, diagonal: Any = 1.0) -> Any:
    deviations = np.sqrt(np.diagonal(covariance))
    found = covariance / np.outer(deviations, deviations)
    np.fill_diagonal(found, diagonal)
    return found


def weights_exchanged(s1: float, s2: float) -> Any:
    return s1**2 / (s1**2 + s2**2), s2**2 / (s1**2 + s2**2)


def of_a_time_constant(T: float, tau: float) -> Any:
    fade = math.exp(-T / tau)
    return [[1, T, tau * T - tau**2 * (1 - fade)], [0, 1, tau * (1 - fade)], [0, 0, fade]]


def turning_in_another_order(x: Any, dt: float) -> Any:
    found = turning([x[0], x[1], x[3], x[2], x[4]], dt)
    return [found[0], found[1], found[3], found[2], found[4]]


def turned(state: Any, dt: float, slow: float = 0.0) -> Any:
    """Position, speed, heading and rate of a turn, a period later; a straight line where it is slow."""
    x, y, v, heading, omega = state
    later = heading + omega * dt
    if abs(omega) <= slow:
        return x + v * dt * math.cos(heading), y + v * dt * math.sin(heading), v, later, omega
    dx, dy = math.sin(later) - math.sin(heading), math.cos(heading) - math.cos(later)
    return x + v / omega * dx, y + v / omega * dy, v, later, omega


def straight_where_slow(state: Any, dt: float) -> Any:
    """As code does that would divide by zero."""
    return turned(state, dt, 1e-4)


def turned_in_degrees(state: Any, dt: float) -> Any:
    """The same with all angles of the state in degrees."""
    x, y, v, heading, omega = state
    x, y, v, heading, omega = turned([x, y, v, math.radians(heading), math.radians(omega)], dt)
    return x, y, v, math.degrees(heading), math.degrees(omega)


def from_zenith(r: float, az: float, zenith: float) -> Any:
    """East, north and up of a range, an azimuth from north and an angle from the zenith."""
    ground = r * math.sin(zenith)
    return ground * math.sin(az), ground * math.cos(az), r * math.cos(zenith)
