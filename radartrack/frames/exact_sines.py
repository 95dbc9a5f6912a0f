"""Sines and cosines with half as many digits again, for lengths of the Earth's size to a nanometre."""

import math

import numpy as np

from radartrack._arrays.validation import RealArray
from radartrack.frames.exact_products import Pair, product, sum_of

QUARTER = math.pi / 2
REST = math.cos(QUARTER)  # of a quarter turn, which float64 cuts off
TERMS = 9  # the tenth is 1e-19 at an eighth of a turn
SINE = [(-1.0) ** n / math.factorial(2 * n + 1) for n in range(1, TERMS)]
COSINE = [(-1.0) ** n / math.factorial(2 * n) for n in range(2, TERMS)]


def sine_and_cosine(angle: RealArray) -> tuple[Pair, Pair]:
    """Both of an angle up to 1e6 rad, to 1e-17: a nanometre of the Earth's radius is 1.6e-16.

    Of the power series the terms up to the square are taken in twice the digits; the others are small.
    """
    quarters = np.rint(angle / QUARTER)
    turned = product(quarters, np.asarray(QUARTER))
    y = sum_of(angle - turned.high, -turned.low - quarters * REST)
    squared = y.squared()
    square = squared.high
    sine = sum_of(y.high, y.low * (1 - square / 2) + square * y.high * _polynomial(SINE, square))
    head = sum_of(np.ones_like(square), -square / 2)
    cosine = sum_of(head.high, head.low - squared.low / 2 + square * square * _polynomial(COSINE, square))
    odd, back = quarters % 2 == 1, quarters % 4 >= 2
    return _chosen(odd, cosine, sine, back), _chosen(odd, sine, cosine, odd != back)


def angle_of(x: RealArray, y: RealArray) -> RealArray:
    """The angle from the x axis to a point, but for its last rounding, which `arctan2` of many libraries is not.

    How far the direction of that angle passes the point by tells what it lacks. The point is brought near to one by a
    power of two, so that nothing underflows.
    """
    exponent = -np.frexp(np.maximum(np.abs(x), np.abs(y)))[1]
    a, b = np.ldexp(x, exponent), np.ldexp(y, exponent)
    angle = np.arctan2(b, a)
    sine, cosine = sine_and_cosine(angle)
    distance = np.hypot(a, b)
    aside = (cosine * b - sine * a).rounded()
    return np.asarray(angle + np.divide(aside, distance, out=np.zeros_like(aside), where=distance > 0))


def _polynomial(coefficients: list[float], x: RealArray) -> RealArray:
    total = np.full_like(x, coefficients[-1])
    for coefficient in coefficients[-2::-1]:
        total = total * x + coefficient
    return total


def _chosen(condition: RealArray, first: Pair, second: Pair, negative: RealArray) -> Pair:
    sign = np.where(negative, -1.0, 1.0)
    return Pair(*(sign * np.where(condition, *parts) for parts in zip(first, second, strict=True)))
