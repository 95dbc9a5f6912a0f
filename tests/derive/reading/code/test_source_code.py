"""Code is read with the arithmetic of its language, and whatever else it is refused."""

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from radartrack.derive.reading import LANGUAGES, FormulaError, read_code, to_expression, to_text
from radartrack.derive.symbolic import Rational
from tests.effort import at_most

BLOCKS = "[[1, dt, 0, 0], [0, 1, 0, 0], [0, 0, 1, dt], [0, 0, 0, 1]]"
VALUES = {"x": Fraction(7, 3), "y": Fraction(-2, 5), "r": Fraction(11, 4)}


@pytest.fixture(autouse=True)
def _parsers(request: pytest.FixtureRequest) -> None:
    if "python" not in request.node.name:
        pytest.importorskip("tree_sitter")


def echo(code: str, language: str) -> str:
    return to_text(read_code(code, language, None).tree)


def refusal(code: str, language: str) -> FormulaError:
    with pytest.raises(FormulaError) as caught:
        read_code(code, language, None)
    return caught.value


@pytest.mark.parametrize(
    ("language", "code", "text"),
    [
        ("python", "math.sin(az)*rng", "sin(az)*rng"),
        ("python", "np.arctan2(y, x) + math.radians(b)", "atan2(y, x) + b*pi/180"),
        ("python", "x[0] + x[1,2] + x[1][2] + self.dt + plot.r", "x_0 + x_1_2 + x_1_2 + dt + plot_r"),
        ("python", "a, b = np.cos(t), x\nreturn a*b", "cos(t)*x"),
        ("python", "y = x\ny *= 3\ny -= x", "x*3 - x"),
        ("python", "np.array([[1, dt], [0, 1]], dtype=float)", "[[1, dt], [0, 1]]"),
        ("python", "H = np.zeros((2, 2))\nH[0, 0] = x\nH[1, 1] = y", "[[x, 0], [0, y]]"),
        ("python", "H[0, 0] = x\nH[0, 1] = y", "[[x, y]]"),
        ("python", "J = np.array([[c, -s], [s, c]])\nJ @ R @ J.T", "[[c, -s], [s, c]]*R*[[c, -s], [s, c]].T"),
        ("python", "f = 1\ndef g(x):\n    '''Doc.'''\n    y = 2*x  # twice\n    return y", "1"),
        ("python", "def g(x):\n    '''Doc.'''\n    y = 2*x  # twice\n    return y", "2*x"),
        ("python", "class A:\n    def f(self):\n        return self.x**2", "x**2"),
        ("python", "    y = x\n    return y*2", "x*2"),
        ("python", "np.linalg.norm([x, y]) + np.hypot(x, y)", "sqrt(x**2 + y**2) + hypot(x, y)"),
        ("python", "-x**2 + 2**-x", "-x**2 + 2**(-x)"),
        ("c", "1.0f*r + 2e-3", "1.0*r + 2e-3"),
        ("c", "double a = x*x; y = sqrtf(a) + M_PI;", "sqrt(x*x) + pi"),
        ("c", "double F[2][2] = {{1, dt}, {0, 1}};", "[[1, dt], [0, 1]]"),
        ("c", "z[2][0] = p->x*s.vx;", "p_x*s_vx"),
        ("c", "a*b;", "a*b"),
        ("c", "double g(double a) { return a; }\nfloat f(float x) {\n  x *= 2;\n  return x; // end\n}", "x*2"),
        ("cpp", "Hj(2,0) = std::pow(py, 2);", "py**2"),
        ("cpp", "MatrixXd H(2,2);\nH << x, 0,\n  1, y;", "[[x, 0], [1, y]]"),
        ("cpp", "Matrix2d F; F(0,1) = dt; F(0,0) = 1; F(1,1) = 1;", "[[1, dt], [0, 1]]"),
        ("cpp", "ekf_.F_ << 1, dt,\n  0, 1;", "[[1, dt], [0, 1]]"),
        ("cpp", "F << 1, dt, x, 0, 1, dt, 0, 0, 1;", "[[1, dt, x], [0, 1, dt], [0, 0, 1]]"),
        ("cpp", "h << r,\n  atan2(y, x), x;", "[r, atan2(y, x), x]"),
        ("cpp", "h << r,\n  x;", "[r, x]"),
        ("cpp", "MatrixXd F = MatrixXd(2, 2); F << 1, dt, 0, 1;", "[[1, dt], [0, 1]]"),
        ("cpp", "Eigen::Matrix<double, 2, 2> F; F.setIdentity(); F(0, 1) = dt;", "[[1, dt], [0, 1]]"),
        ("cpp", "Matrix<T, 2, 2> F = Matrix<T, 2, 2>::Identity(); F(0, 1) = dt;", "[[1, dt], [0, 1]]"),
        ("cpp", "return (Eigen::Vector2d() << x, y).finished();", "[x, y]"),
        ("cpp", "cv::Mat F = (cv::Mat_<float>(2, 2) << 1, dt, 0, 1);", "[[1, dt], [0, 1]]"),
        ("cpp", "F = *(Mat_<float>(2, 2) << 1, dt, 0, 1);", "[[1, dt], [0, 1]]"),
        ("cpp", "return (x)*cos(b);", "x*cos(b)"),
        ("cpp", "auto c = std::cos(b); const double s = sin(b); return c*s;", "cos(b)*sin(b)"),
        ("cpp", "Eigen::Matrix2d R = Eigen::Vector2d(x*x, y*y).asDiagonal();", "diag([x*x, y*y])"),
        ("cpp", "A.transpose()*B.inverse()", "A.T*inv(B)"),
        ("matlab", "F = [1 dt; 0 1]", "[[1, dt], [0, 1]]"),
        ("matlab", "F = [...\n 1 dt;... % position\n 0 1];", "[[1, dt], [0, 1]]"),
        ("matlab", "y = 2*x; # as Octave says it\ny + 1", "2*x + 1"),
        ("matlab", "% what follows ...\nz = x + ...\n y;", "x + y"),
        ("matlab", "x(1).*cos(x(2))", "x_1*cos(x_2)"),
        ("matlab", "cosd(b) + atan2d(y, x)", "cos(b*pi/180) + atan2(y, x)*180/pi"),
        ("matlab", "A = [x, y]; A(2)^2", "y**2"),
        ("matlab", "H*P*H' + P\\x", "H*P*H.T + inv(P)*x"),
        ("matlab", "[x y]' + [x; y] + [x -y]", "[x, y] + [x, y] + [x, -y]"),
        ("matlab", "g = [x; y]; Q = g*g'*q", "[x, y]*[x, y].T*q"),
        ("matlab", "g = [x, y]; Q = g'*q*g", "[x, y]*q*[x, y].T"),
        ("matlab", "Q = -[x; y]*[x y]", "-[x, y]*[x, y].T"),
        ("matlab", "g = 2*[x, y]; s = g*g'", "(2*[x, y]).T*(2*[x, y])"),
        ("python", "g = np.array([[x], [y]]); Q = g @ g.T * q / 2", "[[x], [y]]*[[x], [y]].T*q/2"),
        ("matlab", "H = zeros(2); H(1,2) = x;", "[[0, x], [0, 0]]"),
        ("matlab", "function [a, b] = f(x)\n b = 2;\n a = b*x; % that\nend", "2*x"),
        ("matlab", "x = y; % σ\nz = 2*x ...\n + 1;", "2*y + 1"),
        ("matlab", "x -1", "x - 1"),
    ],
    ids=str,
)
def test_reading(language: str, code: str, text: str):
    assert echo(code, language) == text


@pytest.mark.parametrize(
    ("language", "code", "message"),
    [
        ("python", "r^2", "^ is exclusive or in Python, and a power in mathematics: write ** for the power"),
        ("c", "r^2", "^ is exclusive or in C, and a power in mathematics: write pow(x, n) for the power"),
        ("cpp", "r^2", "^ is exclusive or in C++, and a power in mathematics: write pow(x, n) for the power"),
        ("python", "x//2", "// drops the fraction in Python"),
        ("python", "x if y else r", "formulas have no cases"),
        ("c", "x > 0 ? y : r", "formulas have no cases"),
        ("matlab", "x = 2;\nif x > 1\n y = 1;\nend", "formulas have no cases"),
        ("python", "for i in x: y = i", "loops are not read"),
        ("c", "for (;;) x = 1;", "loops are not read"),
        ("python", "np.array([x, y])*np.eye(2)", "* of arrays multiplies entry by entry in Python, and these are of"),
        ("matlab", "[x; y].*[x y]", "* of arrays multiplies entry by entry in MATLAB, and these are of"),
        ("matlab", "F = eye(2); F(1, :) = [1 2 3];", "what is set here is of another shape than its place"),
        (
            "python",
            "A = np.matrix([[x, y], [y, x]])\nA*np.array([[x, y], [y, x]])",
            "whether this works entry by entry",
        ),
        ("python", "A = np.matrix([[x]])\nnp.array([x, y])**2", "whether this works entry by entry"),
        ("python", "B = np.eye(2)\nA = B.T\nA[0, 1] = x", "A and B are one array in Python"),
        ("python", "B = np.eye(2)\nA = B[0]\nB[0, 1] = x", "A and B are one array in Python"),
        ("python", "B = np.eye(2)\nA = B\nA *= 2\nB", "A and B are one array in Python"),
        ("python", "np.sum(np.eye(2))", "sum takes a vector whose entries are known"),
        ("c", "double F[2] = {1, 2, 3};", "these are more entries than the array has"),
        ("python", "a, b, c = np.array([x, y])", "as many values as names are needed here"),
        ("c", "&x + 2", "pointer expression has no place in a formula"),
        ("python", "F = np.eye(2)\nF[2, 0] = x", "the entry 2 is beyond an array of shape (2, 2)"),
        ("python", "F = A @ B\nF[0, 0] = x", "the shape of this array is not known"),
        ("matlab", "[eye(2) zeros(3)]", "these blocks make no matrix of at most 12 rows and columns"),
        ("c", "int n = x;", "n is int, which drops the fraction"),
        ("c", "double f(double x, int n) { return x*(1/n); }", "whole numbers divide without remainder in C"),
        ("c", "x = 010", "010 is no decimal number"),
        ("python", "g(x)", "g is not a function here"),
        ("python", "x = ", "this is not Python: invalid syntax"),
        ("c", "x = ;", "this is not C"),
        ("matlab", "x = [1 2", "[ is never closed"),
        ("python", "'text'*x", "only numbers stand in a formula"),
        ("python", "__import__('os').system('ls')", "only numbers stand in a formula"),
        ("python", "σ*r", "the character GREEK SMALL LETTER SIGMA (U+03C3) is not read: type sigma"),
        ("python", "x[-1]", "an entry is picked by a whole number"),
        ("matlab", "x(0)", "entries are counted from 1 in MATLAB"),
        ("cpp", "MatrixXd H(2,2); H << x, y;", "H has 4 entries, here are 2"),
        ("cpp", "F = (Mat_<float>(2, 2) << x, y);", "the array has 4 entries, here are 2"),
        ("cpp", "F = (x, y);", "a comma has no meaning here"),
    ],
    ids=str,
)
def test_what_code_does_and_formulas_do_not_is_refused(language: str, code: str, message: str):
    assert refusal(code, language).message.startswith(message)


@pytest.mark.parametrize(
    ("language", "code", "text"),
    [
        ("python", "F = np.eye(2)\nF[0, 1] = dt", "[[1, dt], [0, 1]]"),
        ("matlab", "F = eye(2); F(1, 2) = dt;", "[[1, dt], [0, 1]]"),
        ("cpp", "Matrix2d F = MatrixXd::Identity(2, 2); F(0, 1) = dt;", "[[1, dt], [0, 1]]"),
        ("python", "A = np.outer([x, y], [x, y])\nA[1, 1] = r", "[[x*x, x*y], [y*x, r]]"),
        ("python", "A = np.array([2*np.array([x, y]), np.array([x, y])])\nA[0, 1]", "(2*[x, y])[1]"),
        ("python", "A = np.array([2*np.array([x, y]), np.array([x, y])])\nA[0, 1] = r", "[[2*x, r], [x, y]]"),
        ("python", "F = np.eye(3)\nF[:2, 1:] = x*np.eye(2)", "[[1, x, 0], [0, 0, x], [0, 0, 1]]"),
        ("matlab", "F = eye(3); F(1:2, 2:3) = x*eye(2);", "[[1, x, 0], [0, 0, x], [0, 0, 1]]"),
        ("python", "F = np.zeros((2, 2))\nF[0] = 1\nF[:, 1] = [x, y]", "[[1, x], [0, y]]"),
        ("python", "np.array([x, y])*np.array([x, y])*2", "[x*x, y*y]*2"),
        ("python", "r*np.array([x, y])*np.array([x, y])", "[(r*x)*x, (r*y)*y]"),
        ("python", "(r*np.array([x, y]))**2", "[(r*x)**2, (r*y)**2]"),
        ("python", "A = np.matrix([[x, y], [y, x]])\nA*A.T", "[[x, y], [y, x]]*[[x, y], [y, x]].T"),
        ("python", "A = sympy.Matrix([[x, y], [y, x]])\nA**2", "[[x, y], [y, x]]**2"),
        ("python", "a = np.array([x, y])\na @ np.diag([1, r]) @ a", "(([x, y].T*diag([1, r]))[0].T*[x, y])[0]"),
        ("python", "np.dot(np.array([x, y]), np.diag([1, r]))", "([x, y].T*diag([1, r]))[0]"),
        ("python", "a = np.array([x, y])\na @ a", "([x, y].T*[x, y])[0]"),
        ("python", "a = np.array([x, y])\nnp.sum(a*a) + (a*a).sum()", "(x*x + y*y) + (x*x + y*y)"),
        ("python", "z = np.empty(2)\nz[0] = x\nz[1] = y", "[x, y]"),
        ("python", "h = lambda x, y: np.array([x, x*y])", "[x, x*y]"),
        ("cpp", "Eigen::Matrix2d F = Eigen::Matrix2d::Identity(); F(0, 1) = dt;", "[[1, dt], [0, 1]]"),
        ("cpp", "MatrixXd F(2, 2); F.setIdentity(); F(0, 1) = dt;", "[[1, dt], [0, 1]]"),
        ("cpp", "Matrix2d F = x*Matrix2d::Zero(); F.setZero(); F(1, 1) = y;", "[[0, 0], [0, y]]"),
        ("c", "double F[2][2] = {{0}}; F[0][0] = F[1][1] = 1; F[0][1] = dt;", "[[1, dt], [0, 1]]"),
        ("c", "double F[2][2] = {x, 1, y};", "[[x, 1], [y, 0]]"),
        ("python", "B = np.eye(2)\nA = B.copy()\nA[0, 1] = x\nA", "[[1, x], [0, 1]]"),
        ("python", "B = np.eye(2)\nA = B\nA = 2*B\nB[0, 1] = x\nB", "[[1, x], [0, 1]]"),
        ("python", "A = np.array([[x, y], [r, x]])\nA.T[0, 1]", "[[x, y], [r, x]].T[0, 1]"),
        ("python", "np.diag([x, y])**2", "[[x**2, 0**2], [0**2, y**2]]"),
        (
            "python",
            "A = np.array([[x, y], [y, x]])\nA @ A * A",
            "[[(x*x + y*y)*x, (x*y + y*x)*y], [(y*x + x*y)*y, (y*y + x*x)*x]]",
        ),
        ("matlab", "[1 2; 3 4].^2", "[[1**2, 2**2], [3**2, 4**2]]"),
        ("matlab", "diag([x y].^2)", "diag([x**2, y**2])"),
        ("matlab", "A = [x y; 1 2]; v = A(1, :)'; Q = v*v';", "[[x, y], [1, 2]][0, :]*[[x, y], [1, 2]][0, :].T"),
        ("matlab", "A = [x y; 1 2]; A(1, :)*A(:, 1)", "[[x, y], [1, 2]][0, :].T*[[x, y], [1, 2]][:, 0]"),
        ("matlab", "[x y].*[x y]", "[x*x, y*y]"),
        ("matlab", "F = [1 dt; 0 1]; [F zeros(2); zeros(2) F]", BLOCKS),
        ("matlab", "F = [1 dt; 0 1]; blkdiag(F, F)", BLOCKS),
        ("matlab", "kron(eye(2), [1 dt; 0 1])", BLOCKS),
        ("python", "F = np.array([[1, dt], [0, 1]])\nblock_diag(F, F)", BLOCKS),
        ("python", "np.kron(np.eye(2), [[1, dt], [0, 1]])", BLOCKS),
        ("python", "F = np.array([[1, dt], [0, 1]])\nZ = np.zeros((2, 2))\nnp.block([[F, Z], [Z, F]])", BLOCKS),
        ("python", "np.block([[np.array([[1, dt]])], [np.array([[0, 1]])]])", "[[1, dt], [0, 1]]"),
        ("python", "np.block([[1, dt], [0, 1]])", "[[1, dt], [0, 1]]"),
    ],
    ids=str,
)
def test_arrays_are_set_and_computed_entry_by_entry(language: str, code: str, text: str):
    assert echo(code, language) == text


@pytest.mark.parametrize("transposed", ["a.T", "a.transpose()", "np.transpose(a)"])
def test_a_vector_of_numpy_is_its_transpose(transposed: str):
    read = read_code(f"a = np.array([x, y])\na @ {transposed}", "python", None)
    assert to_text(read.tree) == "([x, y].T*[x, y])[0]"
    assert [remark.words for remark in read.remarks] == [
        "the transpose of a vector is itself in Python: np.outer is a v v^T"
    ]
    column = read_code(f"a = np.array([[x], [y]])\na @ {transposed}", "python", None)
    assert (to_text(column.tree), column.remarks) == ("[[x], [y]]*[[x], [y]].T", ())
    matrix = read_code(f"a = sympy.Matrix([x, y])\na * {transposed}", "python", None)
    assert (to_text(matrix.tree), matrix.remarks) == ("[x, y]*[x, y].T", ())


@pytest.mark.parametrize("code", ["np.eye(2)*np.diag([x, y])", "np.diag([x, y])**2"])
def test_it_is_said_where_python_works_entry_by_entry_on_matrices(code: str):
    sign = "**" if "**" in code else "*"
    said = [remark.words for remark in read_code(code, "python", None).remarks]
    assert said == [f"{sign} of matrices works entry by entry in Python: @ is their product"]
    assert read_code("np.array([x, y])*np.array([x, y])", "python", None).remarks == ()


@pytest.mark.parametrize(
    ("language", "code"),
    [
        ("python", "d = x*x\nif abs(d) < 1e-4:\n    raise ValueError('zero')\ny = 1/d"),
        ("python", "d = x*x\nif d == 0:\n    return 0\nreturn 1/d"),
        ("c", "d = x*x;\nif (fabs(d) < 0.0001f) {\n  return H;\n}\nreturn 1/d;"),
        ("cpp", "auto d = x*x;\nif (d == 0.0) throw 1;\ny = 1/d;"),
    ],
)
def test_a_branch_against_a_division_by_zero_is_passed_over_and_told(language: str, code: str):
    read = read_code(code, language, None)
    assert to_text(read.tree) == "1/(x*x)"
    assert [remark.words for remark in read.remarks] == ["this branch, for a divisor next to zero, is not compared"]


@pytest.mark.parametrize(
    ("language", "code"),
    [
        (language, form.format(condition=condition, first=first, other=other))
        for language, form in (
            ("python", "if {condition}:\n    y = {first}\nelse:\n    y = {other}"),
            ("python", "y = {first} if {condition} else {other}"),
            ("python", "def f(x):\n    if {condition}:\n        return {first}\n    return {other}"),
            ("c", "if ({condition}) {{ y = {first}; }} else {{ y = {other}; }}"),
            ("cpp", "if ({condition}) y = {first}; else y = {other};"),
            ("cpp", "y = ({condition}) ? {first} : {other};"),
            ("matlab", "if {condition}\n y = {first};\nelse\n y = {other};\nend"),
        )
        for conditions, first, other in (
            (("abs(x) < 1e-4", "fabs(x) <= EPS", "x == 0", "x == 0.0", "abs(x) < tol"), "2", "1/x"),
            (("abs(x) > 1e-4", "fabs(x) >= EPS", "abs(x) > 0", "x != 0", "x"), "1/x", "2"),
        )
        for condition in conditions
        if not (language == "matlab" and "!=" in condition)
    ],
)
def test_of_two_branches_the_one_away_from_a_division_by_zero_is_compared(language: str, code: str):
    read = read_code(code, language, None)
    assert to_text(read.tree) == "1/x"
    assert [remark.words for remark in read.remarks] == ["this branch, for a divisor next to zero, is not compared"]


@pytest.mark.parametrize("condition", ["mode", "mode == 0", "mode != 0", "x > 1e-4", "abs(x) > 1", "x < epsilon"])
def test_no_branch_is_chosen_by_a_switch_or_a_size(condition: str):
    for language, code in (("python", f"y = r if {condition} else z"), ("c", f"y = {condition} ? r : z;")):
        assert refusal(code, language).message.startswith("formulas have no cases")


@pytest.mark.parametrize(
    ("language", "code", "text"),
    [
        ("python", "px, py, vx, vy = x_state\npx*vx", "px*vx"),
        ("python", "px = state[0]\nstate[0]*state[1]*px", "px*state_1*px"),
        ("cpp", "float px = x_state(0); float py = x_state[1]; return px*py;", "px*py"),
        ("matlab", "px = state(1); py = state(2); px*py", "px*py"),
        ("python", "x = state[0]\nx = state[1]\nx*state[0]", "state_1*x"),
        ("python", "a = x[0]; a*x[1]", "x_0*x_1"),
        ("python", "px, py = self.state[:2]\npx*py", "px*py"),
        ("python", "a, b = np.array([x, y])\na*b", "x*y"),
        ("python", "x = 2\nx, y = z\nx*y", "x*y"),
        ("c", "void f(double r, double b, double *x) { *x = r*cos(b); }", "r*cos(b)"),
    ],
)
def test_names_are_given_to_what_is_not_known(language: str, code: str, text: str):
    assert echo(code, language) == text


@pytest.mark.parametrize("condition", ["x < 0", "x > 1e-4", "x < 1", "x == 1", "x < 1e-4 and y > 0"])
def test_any_other_branch_of_python_is_refused(condition: str):
    assert refusal(f"if {condition}:\n    return y\nreturn x", "python").message.startswith("formulas have no cases")


@pytest.mark.parametrize("language", ["c", "cpp"])
@given(above=st.integers(-40, 40), below=st.integers(-9, 9).filter(bool))
def test_whole_numbers_divide_towards_zero_in_c_and_it_is_said(language: str, above: int, below: int):
    read = read_code(f"x*(({above})/({below}))", language, None)
    exact = Fraction(above, below)
    drops = int(exact)  # Python's own truncation is that of C
    assert to_expression(read.tree, {"x": Rational(1, 1)}) == drops
    assert [f"{above}/{below} is {drops} in" in remark.words for remark in read.remarks] == [True]
    for spelled in (f"({above})/({below}.0)", f"(double)({above})/({below})", f"({above}.f)/({below})"):
        assert to_expression(read_code(spelled, language, None).tree, {}) == Rational(
            exact.numerator, exact.denominator
        )


@dataclass(frozen=True)
class Written:
    """An expression in Python, C and MATLAB with as few brackets as their tables of precedence ask for."""

    python: str
    c: str
    matlab: str
    value: Fraction
    binds: int  # 0 a sum, 1 a product, 2 a sign before it, 3 a power, 4 all else

    def around(self, least: int) -> tuple[str, str, str]:
        texts = self.python, self.c, self.matlab
        return texts if self.binds >= least else (f"({texts[0]})", f"({texts[1]})", f"({texts[2]})")


def _joined(left: Written, sign: str, right: Written) -> Written:
    level = 0 if sign in "+-" else 1
    before, after = left.around(level), right.around(level + 1)
    value = {
        "+": lambda: left.value + right.value,
        "-": lambda: left.value - right.value,
        "*": lambda: left.value * right.value,
        "/": lambda: left.value / (right.value or 1),
    }[sign]()
    if sign == "/" and not right.value:
        return left
    texts = [f"{one} {sign} {other}" for one, other in zip(before, after, strict=True)]
    return Written(texts[0], texts[1], texts[2], value, level)


def _negative(one: Written) -> Written:
    python, _, matlab = one.around(2)
    return Written(f"-{python}", f"-{one.around(4)[1]}", f"-{matlab}", -one.value, 2)


def _raised(base: Written, exponent: int) -> Written:
    python, _, matlab = base.around(4)
    return Written(
        f"{python}**{exponent}", f"pow({base.c}, {exponent})", f"{matlab}^{exponent}", base.value**exponent, 3
    )


names = st.sampled_from(sorted(VALUES)).map(lambda name: Written(name, name, name, VALUES[name], 4))
numbers = st.integers(1, 9).map(lambda n: Written(f"{n}", f"{n}.0", f"{n}", Fraction(n), 4))
written: st.SearchStrategy[Written] = st.recursive(
    st.one_of(names, numbers),
    lambda inner: st.one_of(
        st.builds(_joined, inner, st.sampled_from("+-*/"), inner),
        st.builds(_negative, inner),
        st.builds(_raised, inner, st.integers(2, 3)),
    ),
    max_leaves=7,
)


@pytest.mark.parametrize("language", ["python", "c", "cpp", "matlab"])
@given(one=written)
def test_signs_powers_and_brackets_bind_as_the_language_says(language: str, one: Written):
    code = {"python": one.python, "c": one.c, "cpp": one.c, "matlab": one.matlab}[language]
    symbols = {name: Rational(value.numerator, value.denominator) for name, value in VALUES.items()}
    try:
        read = to_expression(read_code(code, language, VALUES).tree, symbols)
    except FormulaError as error:  # large powers of large numbers are refused
        assert "digits" in error.message or "degree" in error.message  # noqa: PT017
    else:
        assert read == Rational(one.value.numerator, one.value.denominator)


@pytest.mark.parametrize("language", LANGUAGES)
def test_definitions_are_put_in_whatever_their_order_of_lines(language: str):
    code = "a = x;\nb = a*a;\na = b + y;\nc = a*b;"
    assert echo(code, language) == "(x*x + y)*(x*x)"


@pytest.mark.parametrize(("language", "first"), [("python", 0), ("cpp", 0), ("matlab", 1)])
def test_names_that_are_known_stand_for_indexed_ones(language: str, first: int):
    bracket = {"python": f"x[{first}]", "cpp": f"x({first})", "matlab": f"x({first})"}[language]
    assert to_text(read_code(bracket, language, {f"x{first}"}).tree) == f"x{first}"
    with pytest.raises(FormulaError, match=f"x_{first} is not a name here"):
        read_code(bracket, language, {"y"})


BOMBS: dict[str, Callable[[str], str]] = {
    "doubling": lambda end: "\n".join(f"a{n + 1} = a{n}*a{n}{end}" for n in range(60)),
    "brackets": lambda end: "(" * 5_000 + "x" + ")" * 5_000 + end,
    "signs": lambda end: "- " * 30_000 + "x" + end,
    "terms": lambda end: "x" + "+x*y" * 10_500 + end,
    "factors": lambda end: "x" + "*y" * 3_000 + end,
    "calls": lambda end: "sin(" * 200 + "x" + ")" * 200 + end,
    "a tower of powers": lambda _: "pow(9, pow(9, pow(9, 9)))",
    "a long number": lambda end: "9" * 5_000 + end,
    "length": lambda end: "x + " * 30_000 + end,
    "nulls": lambda end: "x\0y" + end,
    "commas": lambda _: "x," * 19_000 + "^",
    "indices": lambda _: "x" + "[0]" * 10_000,
    "attributes": lambda _: "x" + ".y" * 10_000,
    "attributes without end": lambda _: "x." * 19_000,
    "quotes": lambda _: "x'" * 19_000,
    "dots and spaces": lambda _: "x . " * 9_000,
    "lines": lambda end: f"x = x + 1{end}\n" * 6_000,
    "entries": lambda end: "\n".join(f"x[{n}] = {n}{end}" for n in range(900)),
}


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("bomb", BOMBS)
def test_what_asks_for_too_much_is_refused_at_once(language: str, bomb: str):
    read_code("x", language, None)  # the parser is loaded once
    with at_most(1.0), pytest.raises(FormulaError) as caught:
        read_code(BOMBS[bomb](";" if language != "python" else ""), language, {"x", "y"})
    assert len(str(caught.value)) < 1_000


PIECES = (
    *"+-*/^()[]{},.;:=0123456789xyr \n'\"%#&|<>!~@\\?",
    *("**", ".*", "./", ".^", "==", "<<", "sin(", "pow(", "x[0]", "x(1)", "np.", "std::", "return ", "int ", "double "),
    *("if ", "for ", "while ", "end", "def f(x):\n ", "function y = f(x)\n", "lambda x: ", "1.0f", "3/2", "0x1", "1e9"),
    *("σ", "\0", "/*", "//", "...", "A.T", "[1 2; 3 4]", "{{1,2},{3,4}}", "struct ", "template<", "\t"),
)


@pytest.mark.parametrize("language", LANGUAGES)
@given(code=st.one_of(st.text(), st.lists(st.sampled_from(PIECES), max_size=20).map("".join)))
def test_any_code_is_read_or_refused(language: str, code: str):
    try:
        read = read_code(code, language, None)
    except FormulaError as error:
        assert str(error)  # noqa: PT017
    else:
        assert to_text(read.tree)


def test_a_language_that_is_not_read_is_named():
    with pytest.raises(ValueError, match="language: 'fortran' is not read; it is one of python, c, cpp, matlab"):
        read_code("x", "fortran", None)


def test_without_the_parsers_it_is_said_how_to_get_them(monkeypatch: pytest.MonkeyPatch):
    from radartrack.derive.reading.code import syntax_trees  # noqa: PLC0415

    def missing(name: str) -> None:
        raise ImportError(name)

    syntax_trees._parser.cache_clear()
    monkeypatch.setattr(syntax_trees, "import_module", missing)
    with pytest.raises(FormulaError, match=r"pip install 'radartrack\[code\]'"):
        read_code("x", "c", None)
    syntax_trees._parser.cache_clear()


def test_a_fault_is_told_with_its_line():
    assert refusal("a = x\nb = 2*^y", "python").line == 2
    assert refusal("a = x;\n\nb = y^2;", "c").line == 3
    assert refusal("a = x;\nb = [1 2; 3];", "matlab").line == 2


@pytest.mark.parametrize("name", ["ca", "sp", "np", "math", "torch"])
def test_a_name_that_modules_have_too_is_a_name_where_it_is_assigned(name: str) -> None:
    assert to_text(read_code(f"{name}, b = cos(x), 2\n{name}*b", "python", ["x"]).tree) == "cos(x)*2"


@pytest.mark.parametrize("code", ["double a, b; a = b = x*x; a + b", "Q[0] = Q[1] = x*x; Q[0] + Q[1]"])
def test_an_assignment_has_a_value(code: str) -> None:
    assert to_text(read_code(code, "c", ["x"]).tree) == "x*x + x*x"


@pytest.mark.parametrize("state", ["x", "state", "x[0:2]", "self.x"])
@pytest.mark.parametrize("known", [("x", "y"), ("x", "px"), ()])
def test_what_is_unpacked_is_an_array_though_a_symbol_is_called_so(state: str, known: tuple[str, ...]):
    code = f"def h(x):\n    px, py = {state}\n    return np.hypot(px, py)"
    assert to_text(read_code(code, "python", known, strangers=True).tree) == "hypot(px, py)"


@pytest.mark.parametrize("code", ["a = 2\npx, py = a\npx", "np.block([x, y])", "np.block([[np.array([x, y]), 1]])"])
def test_what_is_no_array_is_not_unpacked_and_vectors_are_no_blocks(code: str):
    assert refusal(code, "python").message.startswith(("as many values as names", "block takes rows of matrices"))


TWO = {
    "python": "def f(r, b, s):\n    z = np.array([r*np.cos(b), r*np.sin(b)])\n    R = np.diag([s, q])\n    return z, R",
    "matlab": "function [z, R] = f(r, b, s)\nz = [r*cos(b); r*sin(b)];\nR = diag([s, q]);\nend",
}


@pytest.mark.parametrize("language", TWO)
def test_of_a_mean_and_its_covariance_the_one_that_is_wanted_is_read(language: str):
    mean = read_code(TWO[language], language, ["r", "b"], wanted=2)
    assert to_text(mean.tree) == "[r*cos(b), r*sin(b)]"
    assert to_text(read_code(TWO[language], language, None).tree) == "diag([s, q])"


def test_names_of_lines_that_do_not_matter_are_let_through():
    lines = "dt = (stamp - before)/1e6\nx = r*np.cos(b)"
    assert to_text(read_code(lines, "python", ["r", "b"]).tree) == "r*cos(b)"
    with pytest.raises(FormulaError, match="b is not a name here"):
        read_code(lines, "python", ["r"])
