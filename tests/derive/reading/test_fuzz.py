"""Nonsense is refused with a FormulaError or read; nothing else ever happens."""

from hypothesis import given
from hypothesis import strategies as st

from radartrack.derive.reading import (
    Array,
    FormulaError,
    Number,
    Tree,
    read_latex,
    read_text,
    rebuild,
    to_expression,
    to_latex,
    to_text,
    walk,
)
from radartrack.derive.symbolic import Symbol

NAMES = ("r", "beta", "sigma_r", "sigma_beta", "rdot", "k", "x0", "C")
SYMBOLS = {name: Symbol(name, positive=True) for name in NAMES}

TEXT_PIECES = (
    *"+-*/^()[]|,.0123456789eE \n",
    *(
        "**",
        "r",
        "k",
        "beta",
        "sigma_beta",
        "x0",
        "pi",
        "cos(",
        "exp(",
        "sqrt(",
        "atan2(",
        "abs(",
        "1/2",
        "r_",
        "_",
    ),
    *(
        "__import__",
        "lambda",
        "'",
        '"',
        "\\",
        "{",
        "}",
        "=",
        "#",
        ";",
        ":",
        "@",
        "%",
        "&",
        "!",
        "\0",
        "σ",
        "\ud800",
    ),
)
LATEX_PIECES = (
    *"+-*/^_()[]{}|,.0123456789erk &'=$%~\n",
    *(
        "\\frac",
        "\\frac{1}{2}",
        "\\sqrt",
        "\\sqrt[3]",
        "\\cos",
        "\\sin^2",
        "\\cosh",
        "\\exp",
        "\\ln",
        "\\beta",
        "\\pi",
    ),
    *(
        "\\sigma",
        "\\sigma_",
        "\\sigma_{\\beta}",
        "^2",
        "^{-1}",
        "^{",
        "_{",
        "\\dot",
        "\\dot{r}",
        "\\mathrm{",
        "\\rm",
    ),
    *(
        "\\mathrm{rdot}",
        "\\operatorname{cosh}",
        "\\left",
        "\\right",
        "\\left(",
        "\\right)",
        "\\left|",
        "\\right|",
    ),
    *(
        "\\{",
        "\\}",
        "\\lvert",
        "\\rvert",
        "\\cdot",
        "\\times",
        "\\,",
        "\\!",
        "\\\\",
        "\\\\[2pt]",
        "\\",
        "\\unknown",
    ),
    *(
        "\\begin{pmatrix}",
        "\\end{pmatrix}",
        "\\begin{array}{cc}",
        "\\end{array}",
        "\\bigl(",
        "\\bigr)",
        "\0",
        "σ",
    ),
)


def fragments(pieces: tuple[str, ...]) -> st.SearchStrategy[str]:
    return st.lists(st.sampled_from(pieces), max_size=25).map("".join)


def has_narrow_matrix(tree: Tree) -> bool:
    """Whether a matrix of one column occurs, which LaTeX prints like a vector."""
    return any(isinstance(node, Array) and any(_is_single(row) for row in node.entries) for _, node in walk(tree))


def _is_single(row: Tree) -> bool:
    return isinstance(row, Array) and len(row.entries) == 1


def by_value(tree: Tree) -> Tree:
    """The tree with its numbers written in one way: LaTeX has no 1e-3."""
    return rebuild(tree, lambda node: Number(str(node.value)) if isinstance(node, Number) else node)


def check_what_was_read(tree: Tree) -> None:
    assert read_text(to_text(tree), NAMES) == tree
    if not has_narrow_matrix(tree):
        assert by_value(read_latex(to_latex(tree), NAMES)) == by_value(tree)
    try:
        to_expression(tree, SYMBOLS)
    except FormulaError as error:
        assert error.message == "this is not a real number, whatever the symbols are"  # noqa: PT017


@given(st.one_of(st.text(), fragments(TEXT_PIECES)))
def test_any_text_is_read_or_refused(formula: str):
    try:
        tree = read_text(formula, NAMES)
    except FormulaError as error:
        assert str(error)  # noqa: PT017
    else:
        check_what_was_read(tree)


@given(st.one_of(st.text(), fragments(LATEX_PIECES)))
def test_any_latex_is_read_or_refused(formula: str):
    try:
        tree = read_latex(formula, NAMES)
    except FormulaError as error:
        assert str(error)  # noqa: PT017
    else:
        check_what_was_read(tree)


SOUND_TEXT = "r**2*exp(-2*sigma_beta**2)*(cos(beta)**2*(cosh(2*sigma_beta**2) - 1) + |k - 1|/2e-3)"
SOUND_LATEX = (
    r"\frac{1}{2}r^2 e^{-2\sigma_\beta^2}"
    r"\left[\cos^2\beta\left(\cosh 2\sigma^2_\beta - 1\right) + \sqrt{|k|}\right]"
)
edits = st.lists(st.tuples(st.integers(0, 200), st.integers(0, 3)), min_size=1, max_size=4)


def edited(formula: str, changes: list[tuple[tuple[int, int], str]]) -> str:
    for (place, dropped), piece in changes:
        start = place % (len(formula) + 1)
        formula = formula[:start] + piece + formula[start + dropped :]
    return formula


@given(edits, st.lists(st.sampled_from(["", *TEXT_PIECES]), min_size=4, max_size=4))
def test_a_sound_text_with_a_few_edits_is_read_or_refused(where: list[tuple[int, int]], what: list[str]):
    try:
        tree = read_text(edited(SOUND_TEXT, list(zip(where, what, strict=False))), NAMES)
    except FormulaError as error:
        assert str(error)  # noqa: PT017
    else:
        check_what_was_read(tree)


@given(edits, st.lists(st.sampled_from(["", *LATEX_PIECES]), min_size=4, max_size=4))
def test_sound_latex_with_a_few_edits_is_read_or_refused(where: list[tuple[int, int]], what: list[str]):
    try:
        tree = read_latex(edited(SOUND_LATEX, list(zip(where, what, strict=False))), NAMES)
    except FormulaError as error:
        assert str(error)  # noqa: PT017
    else:
        check_what_was_read(tree)
