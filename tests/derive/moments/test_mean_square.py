"""Mean squares of polynomials in correlated errors: what they are, by quadrature, and that nothing cancels in them."""

import itertools
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from radartrack.derive import Model, Source, angle, correlation, deviation, length
from radartrack.derive import symbolic as sp
from radartrack.derive.language.stable_form import StableForm
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.moments.mean_square import MeanSquare, Powers
from radartrack.derive.units import METRE
from tests.examples import share

MEASURED = (length("a", "range"), angle("b", "azimuth"), angle("c", "elevation"))
NUMBERS = st.integers(-8, 8).map(float)
POWERS = [n for n in itertools.product(range(4), repeat=3) if 0 < sum(n) <= 3]


def model_with(*pairs: tuple[int, int]) -> Model:
    joined = {(MEASURED[i], MEASURED[j]): f"rho_{i}{j}" for i, j in pairs}
    return Model(
        name="any",
        title="any",
        measured=MEASURED,
        deviations=tuple(deviation(variable, 0.1, 10.0) for variable in MEASURED),
        correlations={pair: correlation(name, *pair) for pair, name in joined.items()},
        outputs={"x": MEASURED[0]},
        units=(METRE,),
        source=Source("nobody", None),
    )


def named(powers: list[Powers]) -> dict[Powers, sp.Symbol]:
    return {n: sp.Symbol("c_" + "".join(map(str, n)), real=True) for n in powers}


def value_of(model: Model, coefficients: dict[Powers, float], point: dict[str, float]) -> float:
    names = named(list(coefficients))
    mean_square = MeanSquare(model, list(names.values()))
    form = StableForm(mean_square.definitions, Tensor((), (mean_square.of(names),)))
    values = point | {names[n].name: c for n, c in coefficients.items()}
    (expression,) = form.expanded()
    exact = {symbol: sp.Rational(Fraction(values[symbol.name])) for symbol in expression.free_symbols}
    return float(expression.xreplace(exact))


def by_quadrature(matrix: np.ndarray, coefficients: dict[Powers, float]) -> float:
    eigenvalues, vectors = np.linalg.eigh(matrix)
    nodes, weights = np.polynomial.hermite_e.hermegauss(4)  # exact for squares of cubics
    grid = np.array(list(itertools.product(nodes, repeat=3)))
    products = np.array([np.prod(w) for w in itertools.product(weights / weights.sum(), repeat=3)])
    errors = grid @ (vectors * np.sqrt(np.maximum(eigenvalues, 0))).T
    values = sum(c * np.prod(errors**n, axis=1) for n, c in coefficients.items())
    return float(products @ values**2)


@pytest.mark.parametrize("pairs", [[], [(0, 1)], [(2, 1)], [(0, 1), (1, 2)]], ids=str)
@given(
    coefficients=st.dictionaries(st.sampled_from(POWERS), NUMBERS, min_size=1, max_size=6),
    deviations=st.tuples(*[st.integers(1, 6).map(float)] * 3),
    rho=st.integers(-4, 4).map(lambda n: n / 4),
)
@share(0.2)
def test_it_is_the_expectation_of_the_square(
    pairs: list[tuple[int, int]], coefficients: dict[Powers, float], deviations: tuple[float, ...], rho: float
) -> None:
    shared = rho / len(pairs) if pairs else 0.0
    matrix = np.diag(np.square(deviations))
    for i, j in pairs:
        matrix[i, j] = matrix[j, i] = shared * deviations[i] * deviations[j]
    point = {f"sigma_{v.name}": s for v, s in zip(MEASURED, deviations, strict=True)}
    point |= {f"rho_{i}{j}": shared for i, j in pairs}
    expected = by_quadrature(matrix, coefficients)
    assert value_of(model_with(*pairs), coefficients, point) == pytest.approx(expected, rel=1e-9, abs=1e-9)


def test_of_paired_errors_it_is_a_sum_of_squares() -> None:
    names = named([(2, 0, 0), (1, 1, 0), (0, 2, 0)])
    found = MeanSquare(model_with((0, 1)), list(names.values())).of(names)
    assert found.is_Add
    assert all(sp.sqrt(term).is_real for term in found.args)
    assert not found.has(sp.Abs)


def test_a_term_that_is_positive_anyway_stays_as_its_moments() -> None:
    names = named([(1, 1, 0)])
    found = MeanSquare(model_with((0, 1)), list(names.values())).of(names)
    a, b, rho = (sp.Symbol(name) for name in ("sigma_a", "sigma_b", "rho_01"))
    plain = found.xreplace({symbol: sp.Symbol(symbol.name) for symbol in found.free_symbols})
    assert sp.expand(plain - sp.Symbol("c_110") ** 2 * a**2 * b**2 * (1 + 2 * rho**2)) == 0
