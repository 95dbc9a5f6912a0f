"""Formulas in LaTeX: how print is read, what papers print, and what is refused as ambiguous."""

import pytest

from radartrack.derive.reading import FormulaError, read_latex, to_text
from radartrack.derive.reading.any_letters import read_loosely

NAMES = (
    "r", "beta", "epsilon", "rdot", "u", "v", "k", "j", "C", "T", "t", "rho", "theta", "alpha",
    "sigma_r", "sigma_beta", "sigma_epsilon", "sigma_rdot", "sigma_rho", "sigma_theta", "sigma_alpha",
    "betadot", "rddot", "D_r", "D_beta", "C_theta", "x0", "v_1", "w_a_b", "sigma_p", "d_av", "range", "Delta",
)  # fmt: skip


def echo(latex: str) -> str:
    return to_text(read_latex(latex, NAMES))


def refusal(latex: str) -> FormulaError:
    with pytest.raises(FormulaError) as caught:
        read_latex(latex, NAMES)
    return caught.value


@pytest.mark.parametrize(
    ("latex", "text"),
    [
        (r"\sigma_\beta^2", "sigma_beta**2"),
        (r"\sigma_{\beta}^{2}", "sigma_beta**2"),
        (r"\sigma^2_\beta", "sigma_beta**2"),
        (r"\sigma^{2}_{\beta} r", "sigma_beta**2*r"),
        (r"{\sigma_\beta}^2", "sigma_beta**2"),
        (r"{r^2}^2", "(r**2)**2"),
        (r"\sigma_{\dot r}\sigma_{\dot{r}}", "sigma_rdot*sigma_rdot"),
        (r"\dot r\dot{r}\ddot r\dot\beta", "rdot*rdot*rddot*betadot"),
        (r"\mathrm{rdot}+\mathrm{range}", "rdot + range"),
        (r"\varepsilon\epsilon\varrho\vartheta\Delta", "epsilon*epsilon*rho*theta*Delta"),
        (r"x_0 + x_{0} + v_1", "x0 + x0 + v_1"),
        (r"w_{a,b}", "w_a_b"),
        (r"\sigma_{\rm p} + d_{\mathrm{av}} + d_{\text{av}} + d_{av}", "sigma_p + d_av + d_av + d_av"),
        (r"\frac12 r", "1/2*r"),
        (r"\frac1{2} + \frac{1}2 + \frac\beta2", "1/2 + 1/2 + beta/2"),
        (r"\dfrac{r}{k} + \tfrac{r}{k}", "r/k + r/k"),
        (r"\frac{r}{k}\cdot\frac{k}{r}", "r/k*(k/r)"),
        (r"r\frac{1}{2}", "r*(1/2)"),
        (r"\sqrt2 + \sqrt r + \sqrt{r+k}", "sqrt(2) + sqrt(r) + sqrt(r + k)"),
        (r"\sqrt[3]{r}", "r**(1/3)"),
        (r"r^2 + r^{12} + 2^k + r^{-1}", "r**2 + r**12 + 2**k + r**(-1)"),
        (r"r^{1/2}", "r**(1/2)"),
        (r"2^{2^{k}}", "2**2**k"),
        (r"\cos\beta", "cos(beta)"),
        (r"\cos^2\beta", "cos(beta)**2"),
        (r"\cos^{2}\!\left(\beta\right)", "cos(beta)**2"),
        (r"\cos(\beta)^2", "cos(beta)**2"),
        (r"\cos2\beta + \cosh 2\beta^2", "cos(2*beta) + cosh(2*beta**2)"),
        (r"\cos{\beta}r + \cos{2\beta}r + \cos{(\beta)}", "cos(beta)*r + cos(2*beta)*r + cos(beta)"),
        (r"\cos\frac{\beta}{2}", "cos(beta/2)"),
        (r"\cos\beta\sin\beta\tan\beta", "cos(beta)*sin(beta)*tan(beta)"),
        (r"\cos\beta\left(1-\rho\right)", "cos(beta)*(1 - rho)"),
        (r"\cos\beta\cdot r", "cos(beta)*r"),
        (r"\cos\beta\,e^{-\sigma_\beta^2}", "cos(beta)*e**(-sigma_beta**2)"),
        (r"\cos\beta + r", "cos(beta) + r"),
        (r"r\cos\beta", "r*cos(beta)"),
        (r"r/\sin\beta + \sin(\beta)/r", "r/sin(beta) + sin(beta)/r"),
        (r"kr/2", "k*r/2"),
        (r"\ln|r| + \log r", "log(abs(r)) + log(r)"),
        (r"\ln^2 r", "log(r)**2"),
        (r"\arccos u + \arctan\left(\frac{u}{v}\right)", "acos(u) + atan(u/v)"),
        (r"\operatorname{atan2}(u, v) + \mathrm{cosh}(u)", "atan2(u, v) + cosh(u)"),
        (r"\operatorname{ch} u + \sh u + \tg u", "cosh(u) + sinh(u) + tan(u)"),
        (r"\exp\left\{-\frac{\sigma_\beta^2}{2}\right\}", "exp(-sigma_beta**2/2)"),
        (r"e^{-2\sigma_\beta^2}", "e**(-2*sigma_beta**2)"),
        (r"\mathrm{e}^{-k} + \mathrm e^k", "e**(-k) + e**k"),
        (r"2\pi r", "2*pi*r"),
        (r"k(k+1)(k+2)", "k*(k + 1)*(k + 2)"),
        (r"2kT", "2*k*T"),
        (r"2 \times 3 \cdot r", "2*3*r"),
        (r"|u| - |v|k", "abs(u) - abs(v)*k"),
        (r"\left|u - |v|\right|", "abs(u - abs(v))"),
        (r"\lvert u\rvert^2", "abs(u)**2"),
        (r"\vert u \vert + \bigl|v\bigr|", "abs(u) + abs(v)"),
        (r"|u(|v| + k)|", "abs(u*(abs(v) + k))"),
        (r"\bigl[ r \bigr] \Big( k \Big) \left\{ T \right\} \lbrace j \rbrace", "r*k*T*j"),
        (r"r\,k\;T\quad j~u\ v", "r*k*T*j*u*v"),
        (r"\displaystyle r", "r"),
        (r"\begin{pmatrix} r \\ k \end{pmatrix}", "[r, k]"),
        (r"\begin{bmatrix} r & k \\[2pt] -k & r \\ \end{bmatrix}", "[[r, k], [-k, r]]"),
        (r"\begin{matrix} r & k \end{matrix}", "[[r, k]]"),
        (r"\left(\begin{array}{cc} r & k \\ k & r \end{array}\right)", "[[r, k], [k, r]]"),
        (r"-\frac{1}{2}\begin{pmatrix} r\cos\beta \\ r\sin\beta \end{pmatrix}D_\beta",
         "-1/2*[r*cos(beta), r*sin(beta)]*D_beta"),
    ],
    ids=lambda value: value[:50],
)  # fmt: skip
def test_reading(latex: str, text: str):
    assert echo(latex) == text


@pytest.mark.parametrize(
    ("printed", "name"),
    [
        *(
            (name, name)
            for name in ["cos", "cosh", "cot", "coth", "csc", "exp", "log", "sec", "sin", "sinh", "tan", "tanh"]
        ),
        *(("arccos", "acos"), ("arcsin", "asin"), ("arctan", "atan"), ("ln", "log")),
        *(("arctg", "atan"), ("ch", "cosh"), ("ctg", "cot"), ("sh", "sinh"), ("tg", "tan"), ("th", "tanh")),
    ],
)
def test_functions_by_their_printed_names(printed: str, name: str):
    assert echo(f"\\{printed} u") == echo(f"\\operatorname{{{printed}}} u") == f"{name}(u)"


PROSOV_9A = r"\sigma_r^2\cos^2\beta+r^2\sigma_\beta^2\sin^2\beta"
PROSOV_9C = r"\left(\sigma_r^2-r^2\sigma_\beta^2\right)\sin\beta\cos\beta"
PROSOV_10 = (
    r"\begin{pmatrix} r\cos\beta \\ r\sin\beta \end{pmatrix}"
    r"-\frac{1}{2}\begin{pmatrix} r\cos\beta \\ r\sin\beta \end{pmatrix}D_\beta"
)
PROSOV_11A = (
    r"r^2 e^{-2\sigma_\beta^2}[\cos^2\beta\left(\cosh 2\sigma_\beta^2-\cosh\sigma_\beta^2\right)"
    r"+\sin^2\beta\left(\sinh 2\sigma_\beta^2-\sinh\sigma_\beta^2\right)]"
    r"+\sigma_r^2 e^{-2\sigma_\beta^2}[\cos^2\beta\left(2\cosh 2\sigma_\beta^2-\cosh\sigma_\beta^2\right)"
    r"+\sin^2\beta\left(2\sinh(2\sigma_\beta^2)-\sinh(\sigma_\beta^2)\right)]"
)
PROSOV_11C = (
    r"\sin\beta\cos\beta\, e^{-4\sigma_\beta^2}"
    r"\left[\sigma_r^2+(r^2+\sigma_r^2)(1-e^{\sigma_\beta^2})\right]"
)
GAO_1 = (
    r"\sqrt{(\cos\alpha\sin\theta)^2\sigma_{\rho}^2+(\rho\cos\alpha\cos\theta)^{2}\sigma_{\theta}^{2}"
    r"+(\rho\sin\alpha\sin\theta)^2\sigma_\alpha^2}"
)
GORSHKOV_11 = r"\frac{60(k-2)D_r}{t^2 k(k+1)(60C_\theta+k^2-4)}"


PRINTED = {
    "prosov.eq9a": (PROSOV_9A, "sigma_r**2*cos(beta)**2 + r**2*sigma_beta**2*sin(beta)**2"),
    "prosov.eq9c": (PROSOV_9C, "(sigma_r**2 - r**2*sigma_beta**2)*sin(beta)*cos(beta)"),
    "prosov.eq10": (PROSOV_10, "[r*cos(beta), r*sin(beta)] - 1/2*[r*cos(beta), r*sin(beta)]*D_beta"),
    "prosov.eq11a": (
        PROSOV_11A,
        (
            "r**2*e**(-2*sigma_beta**2)*(cos(beta)**2*(cosh(2*sigma_beta**2) - cosh(sigma_beta**2))"
            " + sin(beta)**2*(sinh(2*sigma_beta**2) - sinh(sigma_beta**2)))"
            " + sigma_r**2*e**(-2*sigma_beta**2)*("
            "cos(beta)**2*(2*cosh(2*sigma_beta**2) - cosh(sigma_beta**2))"
            " + sin(beta)**2*(2*sinh(2*sigma_beta**2) - sinh(sigma_beta**2)))"
        ),
    ),
    "prosov.eq11c": (
        PROSOV_11C,
        "sin(beta)*cos(beta)*e**(-4*sigma_beta**2)*(sigma_r**2 + (r**2 + sigma_r**2)*(1 - e**sigma_beta**2))",
    ),
    "gao.eq1": (
        GAO_1,
        (
            "sqrt((cos(alpha)*sin(theta))**2*sigma_rho**2 + (rho*cos(alpha)*cos(theta))**2*sigma_theta**2"
            " + (rho*sin(alpha)*sin(theta))**2*sigma_alpha**2)"
        ),
    ),
    "gorshkov.eq11": (GORSHKOV_11, "60*(k - 2)*D_r/(t**2*k*(k + 1)*(60*C_theta + k**2 - 4))"),
}


@pytest.mark.parametrize(
    "difference", [r"\Delta t", r"\Delta_t", r"\hat{\Delta}_{t}", r"\Delta{t}", r"{\Delta}t", r"\bar{\Delta}_t"]
)
def test_a_difference_is_one_letter_whatever_stands_over_it(difference: str):
    assert to_text(read_loosely(f"{difference}^2/2", notation="latex")) == "Delta_t**2/2"


@pytest.mark.parametrize(("latex", "text"), PRINTED.values(), ids=PRINTED.keys())
def test_what_papers_print(latex: str, text: str):
    assert echo(latex) == text


@pytest.mark.parametrize(
    ("latex", "message", "marked"),
    [
        (
            r"\cos 2\beta r",
            r"where the argument of \cos ends is ambiguous: put it in brackets, \cos(...)",
            "r",
        ),
        (r"\cos u v", r"where the argument of \cos ends is ambiguous", "v"),
        (
            r"\arccos u v",
            r"where the argument of \arccos ends is ambiguous: put it in brackets, \arccos(...)",
            "v",
        ),
        (r"\sin u / v", r"where the argument of \sin ends is ambiguous", "/"),
        (r"\sin u \frac{u}{v}", r"where the argument of \sin ends is ambiguous", r"\frac"),
        (r"\sin u 2", r"where the argument of \sin ends is ambiguous", "2"),
        (r"\cos 2\pi(k-1)", r"where the argument of \cos ends is ambiguous", "("),
        (r"\cos 2\pi\cdot k", r"where the argument of \cos ends is ambiguous", r"\cdot"),
        (r"\sin\frac{u}{2}v", r"where the argument of \sin ends is ambiguous", "v"),
        (r"\cosh^{-1}\beta", "^-1 may mean the inverse or the reciprocal: write", "^{-1}"),
        (r"\cos\beta^2", r"this may be the power of \cos or of its argument", r"\cos\beta^2"),
        (r"\cos 2\beta^2", r"this may be the power of \cos or of its argument", r"\cos 2\beta^2"),
        (r"\sin^k\beta", r"write the power of sin behind brackets: \sin(...)^{...}", "^k"),
        (r"\exp^2(u)", r"write the power of exp behind brackets: \exp(...)^{...}", "^2"),
        (r"\sin -\beta", r"put the argument of \sin in brackets: \sin(...)", "-"),
        (r"\sin\cos\beta", r"put the argument of \sin in brackets: \sin(...)", r"\cos"),
        (r"\cos", r"put the argument of \cos in brackets: \cos(...)", ""),
        (r"1/2 r", r"what is divided by what is ambiguous after a slash: write \frac{...}{...}", "r"),
        (r"u/v\cdot r", "what is divided by what is ambiguous after a slash", r"\cdot"),
        (r"u/v/r", "what is divided by what is ambiguous after a slash", "/"),
        (r"2\frac{1}{2}", "this may be a mixed number or a product", r"2\frac{1}{2}"),
        (r"r^23", "only the first digit is raised: write ^{...} around them all", "3"),
        (r"r^-1", "what belongs to ^ must stand in braces behind it", "^"),
        (r"r^\frac12", "what belongs to ^ must stand in braces behind it", "^"),
        (r"r^", "what belongs to ^ must stand in braces behind it", "^"),
        (r"\sqrt", r"what belongs to \sqrt must stand in braces behind it", r"\sqrt"),
        (r"\frac{u}", r"what belongs to } must stand in braces behind it", "}"),
        (r"2e-3", "this may be a power of ten or a product with e", "e"),
        (r"2e3", "this may be a power of ten or a product with e", "e"),
        (r"\log_{10} r", "log has no subscript; a logarithm is the natural one", r"\log"),
        (r"\lg r", r"\lg is not read: write \frac{\ln x}{\ln 10}", r"\lg"),
        (r"cos\beta", r"cos is a product of letters here: write \cos for the function", "cos"),
        (r"2rdot", r"rdot is a product of letters here: write \mathrm{rdot} for the symbol", "rdot"),
        (r"\sigma_b", "sigma_b is not a name here: did you mean sigma_beta?", r"\sigma_b"),
        (
            r"\sigma_{\beta r}",
            "sigma_betar is not a name here: did you mean sigma_beta?",
            r"\sigma_{\beta r}",
        ),
        (
            r"\operatorname{cosin}(r)",
            "cosin is not a function here: did you mean cos?",
            r"\operatorname{cosin}",
        ),
        (r"\mathrm{cosin}", "cosin is not a name here", r"\mathrm{cosin}"),
        (r"\sigma_{r^2}", "a subscript is made of letters, digits and commas", "^"),
        (r"(u)_r", "a subscript stands only behind a letter", "_"),
        (r"r_1_2", "a subscript stands only behind a letter", "_"),
        (r"\dot{ru}", r"\dot stands over one letter: \dot{r}", r"\dot"),
        (r"{u+v}r", r"braces are not printed: write \left( ... \right) around a sum or product", "+"),
        (r"\cos{u+v}", r"braces are not printed: write \left( ... \right) around a sum or product", "+"),
        (r"u \cdot -v", "two signs stand side by side: put what follows in brackets", "-"),
        (r"u + -v", "two signs stand side by side: put what follows in brackets", "-"),
        (r"0,5r", "decimals follow a point", ","),
        (r"0{,}5r", "decimals follow a point", ","),
        (r"r 2", r"a number stands behind a factor: write it before the others, or \cdot", "2"),
        (r"\cos(u) 2", "a number stands behind a factor", "2"),
        (r"\cos u (v) 2", "a number stands behind a factor", "2"),
        (r"u / (v) r", "what is divided by what is ambiguous after a slash", "r"),
        (r"u \cdot / v", "a value is missing before /", "/"),
        (r"u + / v", "a value is missing before /", "/"),
        (r"\begin{pmatrix} \end{pmatrix}", "a value is missing before \\end{pmatrix}", r"\end{pmatrix}"),
        (r"1\,000", "a number stands behind a factor", "000"),
        (r"r^2^2", "an exponent stands here without a base, or behind another one", "^"),
        (r"1.2.3", "1.2.3 is no number", "1.2.3"),
        (r"\pm r", r"\pm is not read: a formula has one sign: write + or -", r"\pm"),
        (r"\theta^\circ", r"\circ stands behind a number: angles are in radians", r"^"),
        (r"\sum_j j", "both limits are needed: write it as", r"\sum"),
        (r"\input{x}", r"\input is not read: it has no meaning in a formula", r"\input"),
        (r"\begin{cases} r \end{cases}", r"\begin{cases} is not read", r"\begin{cases}"),
        (r"\left. r \right|", r"\left is not read: a bracket follows it", r"\left"),
        (r"\left( r \right]", "] cannot close (, which is still open", "]"),
        (r"\frac{r}{k", "{ is never closed", "{"),
        (r"|r", r"\lvert is never closed", "|"),
        (r"r \\ k", r"& and \\ stand only inside a matrix", r"\\"),
        (r"r & k", r"& and \\ stand only inside a matrix", "&"),
        (r"\begin{pmatrix} r & k \\ r \end{pmatrix}", "the rows of this array differ in length", None),
        (r"()", "a value is missing before )", ")"),
        (r"r +", "the formula ends too early", ""),
        (r"\operatorname{atan2}(u)", "atan2 takes 2 arguments, here it has 1", r"\operatorname{atan2}(u)"),
    ],
    ids=lambda value: str(value)[:40],
)
def test_refusals(latex: str, message: str, marked: str | None):
    error = refusal(latex)
    assert error.message.startswith(message)
    assert error.span is not None
    assert marked is None or latex[slice(*error.span)] == marked


def test_euler_s_number_stands_aside_for_a_symbol():
    assert to_text(read_latex("e^2", ["e"])) == "e**2"
    with pytest.raises(FormulaError, match="e is a symbol here"):
        read_latex(r"\mathrm{e}^2", ["e"])


def test_pi_stands_aside_for_a_symbol():
    assert to_text(read_latex(r"\cos 2\pi(r + 1)", ["pi", "r"])) == "cos(2*pi)*(r + 1)"


def test_a_subscript_may_be_part_of_the_letter_or_follow_it():
    assert to_text(read_latex(r"x_1 + y_{12}", ["x1", "y_12"])) == "x1 + y_12"


@pytest.mark.parametrize("function", ["sin", "cos", "tan"])
@pytest.mark.parametrize("power", ["", "^2 ", "^{2}"])
@pytest.mark.parametrize(
    "phase",
    [
        r"\omega T",
        r"\Omega T",
        r"\omega\,\Delta t",
        r"\omega_k T_k",
        r"2\omega t",
        r"\omega \tau",
        r"\omega(t - t_0)",
        r"\omega\left(t_{k+1} - t_k\right)",
        r"2\Omega_k (t_2 - t_1 + \Delta t)",
    ],
)
def test_a_rate_and_a_time_behind_a_sine_are_its_argument(function: str, power: str, phase: str) -> None:
    bare = read_latex(rf"a\{function}{power}{phase} + b", None)
    assert bare == read_latex(rf"a\{function}{power}({phase}) + b", None)
    assert read_latex(rf"\frac{{\{function}{power}{phase}}}{{a}}", None) == read_latex(
        rf"\frac{{\{function}{power}({phase})}}{{a}}", None
    )


@pytest.mark.parametrize("behind", [r"\, v", "/2", r"(x + y)", r"\sigma_v"])
def test_a_time_in_brackets_ends_the_argument(behind: str) -> None:
    bare = read_latex(rf"a\sin\omega(t - t_0){behind} + b", None)
    assert bare == read_latex(rf"a\sin(\omega(t - t_0)){behind} + b", None)


def test_a_sine_of_a_rate_and_a_time_is_divided_by_the_rate() -> None:
    assert read_latex(r"\sin\omega T/\omega", None) == read_latex(r"\frac{\sin(\omega T)}{\omega}", None)


@pytest.mark.parametrize(
    "formula",
    [
        r"\sin\omega T^2",
        r"\sin\omega T/2",
        r"\sin\theta T",
        r"\sin\omega r",
        r"\sin\omega T r",
    ],
)
def test_what_else_stands_behind_a_sine_is_ambiguous(formula: str) -> None:
    with pytest.raises(FormulaError, match="ambiguous"):
        read_latex(formula, None)


@pytest.mark.parametrize(
    ("formula", "text"),
    [
        (r"\sigma^2 2\alpha", "sigma**2*2*alpha"),
        (r"\sigma_m^{2}2\alpha T", "sigma_m**2*2*alpha*T"),
        (r"\sqrt{x} 2 \cos y", "sqrt(x)*2*cos(y)"),
        (r"(x + y) 2 \frac{x}{y}", "(x + y)*2*(x/y)"),
        (r"\frac 12 x", "1/2*x"),
        (r"\sum_{j=1}^{k} 2 j", "sum(2*j, j, 1, k)"),
        (r"\int_0^T 2 s\, ds", "integral(2*s, s, 0, T)"),
    ],
)
def test_a_number_apart_between_factors_is_one(formula: str, text: str) -> None:
    assert to_text(read_latex(formula, None)) == text


@pytest.mark.parametrize("formula", ["x2y", r"x^2 2", r"\cos x 2 y", r"x/y 2 z"])
def test_a_number_that_touches_a_letter_or_ends_a_term_is_refused(formula: str) -> None:
    with pytest.raises(FormulaError):
        read_latex(formula, None)


@pytest.mark.parametrize(
    "formula", [r"\sin\omega(t - t_0)^2", r"\cos 2\omega(t_2 - t_1)^{2}", r"\sin^2\omega(t - t_0)^2"]
)
def test_a_power_behind_a_time_in_brackets_may_be_that_of_the_sine(formula: str) -> None:
    with pytest.raises(FormulaError, match="may be the power of"):
        read_latex(formula, None)
