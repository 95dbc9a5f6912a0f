"""Random trees of formulas, for tests that print and read them."""

from hypothesis import strategies as st

from radartrack.derive.formula.functions import NUMBER_OF_ARGUMENTS
from radartrack.derive.formula.tree import (
    Array,
    Call,
    Constant,
    Name,
    Negation,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Tree,
)

NAMES = (
    "r",
    "beta",
    "sigma_r",
    "sigma_beta",
    "rdot",
    "sigma_rdot",
    "k",
    "C_theta",
    "x0",
    "w_a_b",
    "range",
    "_odd_",
)

decimals = st.sampled_from(["0", "1", "2", "3", "10", "64", "0.5", "2.50", "0.125"])
leaves = st.one_of(
    st.sampled_from(NAMES).map(Name),
    decimals.map(Number),
    st.sampled_from(["pi", "e"]).map(Constant),
)


def _over(parts: st.SearchStrategy[Tree]) -> st.SearchStrategy[Tree]:
    several = st.lists(parts, min_size=2, max_size=4).map(tuple)
    return st.one_of(
        several.map(Sum),
        several.map(Product),
        parts.map(Negation),
        st.tuples(parts, parts).map(lambda two: Quotient(*two)),
        st.tuples(parts, st.one_of(exponents, parts)).map(lambda two: Power(*two)),
        st.sampled_from(sorted(NUMBER_OF_ARGUMENTS)).flatmap(lambda function: _calls(function, parts)),
    )


def _calls(function: str, parts: st.SearchStrategy[Tree]) -> st.SearchStrategy[Tree]:
    number = NUMBER_OF_ARGUMENTS[function]
    arguments = st.lists(parts, min_size=number, max_size=number).map(tuple)
    return arguments.map(lambda given: Call(function, given))


exponents = st.one_of(
    st.integers(0, 9).map(lambda n: Number(str(n))),
    st.integers(1, 4).map(lambda n: Negation(Number(str(n)))),
    st.integers(2, 4).map(lambda n: Quotient(Number("1"), Number(str(n)))),
)
scalars = st.recursive(leaves, _over, max_leaves=10)


@st.composite
def arrays(draw: st.DrawFn) -> Tree:
    """A vector or a matrix of at least two columns, perhaps times something, perhaps in a sum."""
    rows, columns = draw(st.tuples(st.integers(1, 3), st.sampled_from([0, 2, 3])))
    small = st.recursive(leaves, _over, max_leaves=3)

    def array() -> Tree:
        if not columns:
            return Array(tuple(draw(small) for _ in range(rows)))
        return Array(tuple(Array(tuple(draw(small) for _ in range(columns))) for _ in range(rows)))

    match draw(st.sampled_from(["plain", "negative", "scaled", "divided", "sum"])):
        case "negative":
            return Negation(array())
        case "scaled":
            return Product((draw(small), array()))
        case "divided":
            return Quotient(array(), draw(small))
        case "sum":
            return Sum((array(), Negation(array())))
        case _:
            return array()


trees = st.one_of(scalars, arrays())
