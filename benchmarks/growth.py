"""Prints how times grow: per plot with the number of plots, and of derivations with the degree of the filter."""

import time
import tracemalloc
from collections.abc import Callable

import numpy as np

from radartrack import convert
from radartrack._regeneration.numpy_modules import written
from radartrack.derive import check
from radartrack.derive.catalogue import catalogue
from radartrack.derive.finite_sample.least_squares_filter import FiniteSample

SIZES = (10**3, 10**4, 10**5, 10**6, 10**7)
SHORTEST = 10**6  # plots in all, so that a pause of the machine does not count
DEGREES = range(9)


def main() -> None:
    """Print all tables in Markdown."""
    print("\n## Growth\n\n| plots | ns a plot, `convert.polar` |\n|---|---|")
    for size in SIZES:
        print(f"| {size:,} | {1e9 * per_plot(size):.0f} |")
    print(f"\nAt 1e7 plots the memory's peak is {100 * peak(SIZES[-1]):.0f} % of the result.")
    print("\n| degree d | deriving covariance and weights, range and range rate [s] |\n|---|---|")
    for degree in DEGREES:
        print(f"| {degree} | {timed(lambda d=degree: derived(d)):.2f} |")
    print("\n| quantities | deriving and writing [s] | checking the first entry of each [s] |\n|---|---|---|")
    names = list(catalogue())
    for count in (10, 20, 40, 80):
        chosen = names[:: len(names) // count][:count]
        writing = timed(lambda some=chosen: [written(catalogue()[name]) for name in some])
        checking = timed(lambda some=chosen: [checked(name) for name in some])
        print(f"| {len(chosen)} | {writing:.1f} | {checking:.1f} |")


def timed(call: Callable[[], object]) -> float:
    start = time.perf_counter()
    call()
    return time.perf_counter() - start


def per_plot(size: int) -> float:
    arrays = plots(size)
    convert.polar(*arrays)
    rounds = max(3, SHORTEST // size)
    return min(timed(lambda: convert.polar(*arrays)) for _ in range(rounds)) / size


def plots(size: int) -> list[np.ndarray]:
    generator = np.random.default_rng(0)
    bounds = [(1e3, 1e5), (-3, 3), (10, 100), (1e-3, 2e-2)]
    return [generator.uniform(low, high, size) for low, high in bounds]


def peak(size: int) -> float:
    """Of the memory that a conversion takes, as a share of its result."""
    arrays = plots(size)
    tracemalloc.start()
    result = convert.polar(*arrays)
    _, most = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    return most / (result.mean.nbytes + result.covariance.nbytes)


def derived(degree: int) -> None:
    found = FiniteSample(degree, with_rate=True)
    _ = found.covariance, found.range_weights, found.rate_weights


def checked(name: str) -> None:
    """The first entry against itself."""
    entries = catalogue()[name].expression
    place = f"[{','.join('0' * len(entries.shape))}]" if entries.shape else ""
    check(f"{name}{place}", str(entries.entries[0]))


if __name__ == "__main__":
    main()
