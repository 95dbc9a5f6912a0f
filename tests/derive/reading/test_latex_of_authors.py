"""LaTeX as authors write it: displays, dialects, decorations, matrices; each reading over its kind."""

import pytest

from radartrack.derive.reading import FormulaError, names, read_latex, to_text

KNOWN = ("r", "rho", "theta", "sigma_r", "sigma_theta", "sigma_rho", "x", "y", "k", "T", "q", "rdot")
ENVIRONMENTS = ("equation", "equation*", "align", "align*", "gather", "multline", "eqnarray", "split", "aligned")
PLAIN = r"r\cos\theta"
READ = "r*cos(theta)"


def echo(latex: str, *known: str) -> str:
    return to_text(read_latex(latex, known or KNOWN))


def refusal(latex: str) -> str:
    with pytest.raises(FormulaError) as caught:
        read_latex(latex, None)
    return caught.value.message


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("$", "$"),
        ("$$", "$$"),
        (r"\(", r"\)"),
        (r"\[", r"\]"),
        *((rf"\begin{{{name}}}", rf"\end{{{name}}}") for name in ENVIRONMENTS),
        (r"\begin{equation}\begin{aligned}", r"\end{aligned}\end{equation}"),
        ("", ""),
    ],
)
def test_what_only_sets_a_formula_changes_nothing(before: str, after: str):
    for left in ("", "x = ", "x &= ", r"x(\rho,\theta) \triangleq ", "\\mathbf{x}_k & := \n", r"x = y \approx "):
        for end in ("", ".", ",", r" \,,", r"\;.", r" \tag{8b}", r". \label{eq:x} % as in print", r" \nonumber \\"):
            is_bare = not before and ("&" in left or "\\\\" in end)  # they stand only in a display
            assert is_bare or echo(before + left + PLAIN + end + after) == READ


@pytest.mark.parametrize(
    "latex",
    [
        r"r {{\cos }^{2}}\theta",
        r"r{{\left( \cos \theta  \right)}^{2}}",
        r"r \cos^{2}{\theta}",
        r"r {\rm cos}^2 \theta",
        r"r \mathrm{cos}^2\left(\theta\right)",
        r"r\,{\mathop{\rm cos}\nolimits}^2 \theta",
        r"r \operatorname{cos}^2 {\theta}",
        r"{{r}} \cos ^2 \theta",
        r"\mathit{r} \cos^2 {\it \theta}",
        r"\boldsymbol{r}\cos^2\boldsymbol{\theta}",
        r"\hat{r}\cos^2\hat\theta",
        r"\bar r \cos^2 \bar{\theta}",
        r"r' \cos^2 \theta'",
        r"r^{\prime}\cos^2\theta^\prime",
        r"\widetilde{r} \cos^2 \tilde\theta",
        r"r_{k|k-1}\cos^2\theta_{k|k-1}",
        r"r^* \cos^2\theta^{*}",
        r"r \hspace{2pt} \cos^2 \phantom{x} \theta",
        r"\vec{r} \cos^2 \theta",
    ],
)
def test_a_dialect_is_read_as_plain_latex(latex: str):
    assert echo(latex) == "r*cos(theta)**2"
    assert to_text(read_latex(latex, None)) == "r*cos(theta)**2"


@pytest.mark.parametrize(
    ("decoration", "word"), [(r"\hat", "hat"), (r"\bar", "bar"), (r"\tilde", "tilde"), ("'", "prime"), ("^*", "star")]
)
@pytest.mark.parametrize(("letter", "name"), [("r", "r"), (r"\lambda", "lambda")])
def test_a_decoration_is_kept_where_a_letter_occurs_in_two_ways(decoration: str, word: str, letter: str, name: str):
    decorated = f"{decoration}{{{letter}}}" if decoration.startswith("\\") else letter + decoration
    assert names(read_latex(decorated, None)) == {name}
    assert names(read_latex(f"{decorated} + {letter}", None)) == {name, f"{name}_{word}"}
    assert names(read_latex(decorated, [name, f"{name}_{word}"])) == {f"{name}_{word}"}
    assert names(read_latex(f"{decorated}^2" if decoration != "^*" else decorated, [name])) == {name}


def test_a_subscript_goes_with_the_decoration():
    assert (
        echo(r"\lambda_\theta' + \lambda_\theta", "lambda_theta", "lambda_theta_prime")
        == "lambda_theta_prime + lambda_theta"
    )
    assert echo(r"\lambda_\theta^{\prime}", "lambda_theta") == "lambda_theta"
    assert echo(r"\sigma_{\hat\theta}^2") == "sigma_theta**2"
    assert names(read_latex(r"\hat{x}_{k|k} - \hat{x}_{k|k-1}", None)) == {"x_hat_k_k", "x_hat_k_km1"}


@pytest.mark.parametrize(
    ("latex", "text"),
    [
        (r"\Delta t^{3}/3", "Delta_t**3/3"),
        (r"\frac{\Delta t^2}{2}\Delta t", "Delta_t**2/2*Delta_t"),
        (r"\tan^{-1}(y/x)", "atan(y/x)"),
        (r"\sin^{-1}\frac{y}{x}", "asin(y/x)"),
        (r"{x \over \sqrt{x^2+y^2}}", "x/sqrt(x**2 + y**2)"),
        (r"x + 1 \over 2 \text{.}", "(x + 1)/2"),
        (r"x \mbox{cos}\, \theta \eqno(5)", "x*cos(theta)"),
        (r"x = \cos(2)", "cos(2)"),
        (r"\mathbf{H}\mathbf{R}\mathbf{H}^{T}", "H*R*H.T"),
        (r"{\bf H}{\bf P}{\bf H}^{\rm T}", "H*P*H.T"),
        (r"(\mathbf{H}\mathbf{P}\mathbf{H}^\top + \mathbf{R})^{-1}", "(H*P*H.T + R)**(-1)"),
        (r"\left[\, x, \; y \,\right]^{\top}", "[x, y]"),
        (r"(x, y)^T", "[x, y]"),
        (r"\begin{bmatrix} x & y \end{bmatrix}^T", "[x, y]"),
        (r"\begin{bmatrix} x \\ y \end{bmatrix}^\mathsf{T}", "[x, y].T"),
        (r"\operatorname{diag}(\sigma_r^2, \sigma_\theta^2)", "diag(sigma_r**2, sigma_theta**2)"),
        (r"\det(A) + \operatorname{tr}(A)", "det(A) + trace(A)"),
        (r"r {}+ k", "r + k"),
        (r"\quad{}- \sigma_{r}{}^2", "-sigma_r**2"),
        (r"\sin{}(\theta)\,{}r{}", "sin(theta)*r"),
        (r"\cos{}^2\theta{}{}", "cos(theta)**2"),
        (r"\sum_{j=1}^{k} j^2 r + 1", "sum(j**2*r, j, 1, k) + 1"),
        (r"2\sum\limits_{j=0}^{k-1} (j + 1)", "2*sum((j + 1), j, 0, k - 1)"),
        (r"\int_0^T s^2 \,\mathrm{d}s", "integral(s**2, s, 0, T)"),
        (r"q\int\limits_{0}^{T} (T - \tau)^2 d\tau", "q*integral((T - tau)**2, tau, 0, T)"),
    ],
)
def test_what_authors_write(latex: str, text: str):
    assert to_text(read_latex(latex, None)) == text.replace("((j + 1)", "(j + 1")


@pytest.mark.parametrize(
    ("latex", "text"),
    [
        (r"\begin{align} x &= r\cos\theta, \\ y &= r\sin\theta. \end{align}", "[r*cos(theta), r*sin(theta)]"),
        (r"x = r, \quad y = k", "[r, k]"),
        (r"x = r \qquad y = k", "[r, k]"),
        (r"x = r \text{ and } y = k", "[r, k]"),
        (r"x = r; y = k \quad\mbox{where}", "[r, k]"),
        (r"x \quad = r, \quad y = \quad k", "[r, k]"),
        (r"y = r \quad + k", "r + k"),
        (r"\begin{gather} R_{11} = r \\ R_{12} = k \\ R_{22} = q \end{gather}", "[[r, k], [k, q]]"),
        (r"\begin{align} R_{11} &= r \\ R_{12} &= k \\ R_{21} &= T \\ R_{22} &= q \end{align}", "[[r, k], [T, q]]"),
        (r"\begin{align} y &= \lambda r \\ \lambda &= e^{-k} \end{align}", "e**(-k)*r"),
        (r"\begin{align} \lambda &= e^{-k} \\ y &= \lambda r \end{align}", "e**(-k)*r"),
        (r"\begin{align} y &= r \\ &\quad + k \\ & - q \end{align}", "r + k - q"),
        (r"\begin{align} y &= r + k \\ &= k + r \end{align}", "k + r"),
        (r"\begin{multline} y = \left( r \right. \\ \left. + k \right) q \end{multline}", "(r + k)*q"),
        (r"\begin{cases} x = r\cos\theta \\ y = r\sin\theta \end{cases}", "[r*cos(theta), r*sin(theta)]"),
        (r"\left\{\begin{array}{l} x = r, \\ y = k. \end{array}\right.", "[r, k]"),
        (r"\newcommand{\sq}[1]{#1^{2}}\newcommand{\rr}{\rho} \sqrt{\sq{\rr}+\sq{k}}", "sqrt(rho**2 + k**2)"),
        (r"\def\half{\frac12}\def\of#1#2{#1(#2)} \half\,\of{\cos}{\theta} r", "1/2*cos(theta)*r"),
        (r"\DeclareMathOperator{\dg}{diag} \dg(q, k)", "diag(q, k)"),
        (r"\newcommand{\s}[2][r]{#2_{#1}} \s{\sigma} + \s[\rho]{\sigma}", "sigma_r + sigma_rho"),
    ],
)
def test_several_equations(latex: str, text: str):
    assert echo(latex) == text


@pytest.mark.parametrize(
    ("latex", "message"),
    [
        (r"\sin\theta^2", r"this may be the power of \sin or of its argument"),
        (r"\tan 2\theta^2", r"this may be the power of \tan or of its argument"),
        (r"\sin^2\theta^2", r"this may be the power of \sin or of its argument"),
        (r"\begin{cases} r \\ k \end{cases}", r"\begin{cases} is not read: give the branch that is meant"),
        (r"x = \begin{cases} r & k > 0 \\ q = 1 & k = 0 \end{cases}", r"\begin{cases} is not read"),
        (r"\newcommand{\a}{2\a} \a", r"\a stands for itself"),
        (r"\def\a{\b\b}\def\b{\c\c}\def\c{\a\a} \a", "\\"),
        (r"\frac{dx}{dt}", "this may be a derivative"),
        (r"\frac{\mathrm{d}x}{\mathrm{d}t}", "this may be a derivative"),
        (r"x^T T", "^T may mean a transpose or a power by T"),
        (r"\mathbf{H}'", "a prime at a matrix may mean its transpose or another matrix"),
        (r"\cosh^{-1} x", "^-1 may mean the inverse or the reciprocal"),
        (r"x = ", "nothing stands right of this relation"),
        (r"a = b, b = a", "each of these equations is used by another one"),
        (r"a = b + y, b = a, c = a", "a is defined by itself"),
        (r"R_{11} = x, R_{13} = y", "the entry R_12 is missing"),
        (r"\sum_j^k j", "a sum says its index and both limits"),
        (r"\int_0^1 x", "an integral ends with its variable"),
        (r"(a \over b)", r"write one \over in braces"),
        (r"x = r\cos\theta \quad (8b)", "(8b) may be the number of the equation or a factor"),
        (r"x = r\cos\theta \;\; (8)", "(8) may be the number of the equation or a factor"),
        (r"r \text{ for } k", "words between formulas are not read"),
        ("%", "the formula is empty"),
    ],
)
def test_what_has_two_meanings_or_none_is_refused_with_a_word(latex: str, message: str):
    assert refusal(latex).startswith(message)


def test_places_are_those_of_the_source():
    source = "\\begin{align}\n x &= r \\\\\n y &= k + z \\tag{3}\n\\end{align}"
    with pytest.raises(FormulaError) as caught:
        read_latex(source, KNOWN)
    assert (caught.value.line, source[slice(*caught.value.span or (0, 0))]) == (3, "z")


@pytest.mark.parametrize(
    ("mathtype", "plain"),
    [
        (r"\left( {{x^2} + {y^2}} \right)", "x^2 + y^2"),
        (r"{\left( {{x^2} + {y^2}} \right)^{1/2}}", "(x^2 + y^2)^{1/2}"),
        (r"\arctan \left( {y/x} \right)", r"\arctan(y/x)"),
        (r"\frac{{ - y}}{{{x^2} + {y^2}}}", r"\frac{-y}{x^2 + y^2}"),
        (
            r"\left[ {\begin{array}{*{20}{c}} {a + b}&{ - c}\\ {\frac{a}{b}}&1 \end{array}} \right]",
            r"\begin{bmatrix} a + b & -c \\ \frac{a}{b} & 1 \end{bmatrix}",
        ),
        (r"\begin{array}{@{}c|c@{}} a & b \end{array}", r"\begin{matrix} a & b \end{matrix}"),
        (r"{{\sin }^2}\left( {2\beta } \right)", r"\sin^2(2\beta)"),
        (r"({\sigma^2 \over 2})", r"\frac{\sigma^2}{2}"),
    ],
)
def test_braces_that_group_nothing_are_dropped(mathtype: str, plain: str) -> None:
    assert read_latex(mathtype, None) == read_latex(plain, None)


@pytest.mark.parametrize("sign", [r"^\circ", r"^{\circ}", r"\degree"])
@pytest.mark.parametrize(
    ("before", "after", "text"),
    [
        (r"r\sin(90", r"-\theta)", "r*sin(90*pi/180 - theta)"),
        (r"r\cos 22.5", "", "r*cos(22.5*pi/180)"),
        (r"\frac{180", r"}{\pi}\theta", "180*pi/180/pi*theta"),
    ],
)
def test_degrees_behind_a_number_are_an_angle(before: str, sign: str, after: str, text: str):
    assert echo(before + sign + after) == text
    with pytest.raises(FormulaError):
        read_latex(rf"\theta{sign}", KNOWN)


@pytest.mark.parametrize(
    ("latex", "text"),
    [
        (r"r\cos {\theta }_{k}", "r*cos(theta_k)"),
        (r"\sin {\theta }_{k}\cos {\theta }_{k}", "sin(theta_k)*cos(theta_k)"),
        (r"{{\sigma }_{r}}^{2}{{\cos }^{2}}{{\theta }_{k}}", "sigma_r**2*cos(theta_k)**2"),
        (r"\frac{\delta t^2}{2}", "delta_t**2/2"),
        (r"\delta T\,q", "delta_T*q"),
        (r"\delta r", "delta*r"),
    ],
)
def test_letters_with_subscripts_behind_braces_and_small_steps_of_time(latex: str, text: str):
    assert to_text(read_latex(latex, {*KNOWN, "delta_t", "delta_T"}, strangers=True)) == text


def test_a_symbol_called_delta_is_no_step():
    assert echo(r"\delta t", "delta", "t") == "delta*t"


@pytest.mark.parametrize("display", ["aligned", "split", "gathered"])
def test_a_display_behind_a_brace_is_its_equations(display: str):
    mark = "" if display == "gathered" else "&"
    rows = rf"x {mark}= r\cos\theta, \\ y {mark}= r\sin\theta"
    braced = rf"\left\{{ \begin{{{display}}} {rows} \end{{{display}}} \right."
    for text in (
        braced,
        rf"\begin{{equation}} {braced} \label{{a}} \end{{equation}}",
        braced.replace(r"\{", r"\lbrace"),
    ):
        assert echo(text) == "[r*cos(theta), r*sin(theta)]"
    assert echo(r"\left\{ r + x \right\} y") == "(r + x)*y"


@pytest.mark.parametrize("name", [r"\operatorname{arctan2}", r"\mathrm{atan2}"])
def test_the_angle_of_two_coordinates_by_either_name(name: str):
    assert echo(rf"{name}\left(y, x\right)") == "atan2(y, x)"


BARS = (
    (r"\|", r"\|"),
    (r"\lVert", r"\rVert"),
    (r"\Vert", r"\Vert"),
    (r"\left\|", r"\right\|"),
    (r"\left\Vert", r"\right\Vert"),
    (r"\bigl\|", r"\bigr\|"),
    (r"\|", r"\|_2"),
    (r"\lVert", r"\rVert_{2}"),
    ("|", "|"),
    (r"\left|", r"\right|"),
    (r"\norm{", "}"),
    (r"\abs{", "}"),
)


@pytest.mark.parametrize(("opening", "closing"), BARS)
def test_bars_around_a_vector_are_its_length_and_around_a_number_its_magnitude(opening: str, closing: str):
    def read(inside: str) -> str:
        latex = rf"\frac{{x}}{{{opening} {inside} {closing}^2}}"
        return to_text(read_latex(latex, (*KNOWN, "p"), {"p": (2,)}))

    for vector in ("p", r"\mathbf{p}", r"\vec p"):
        assert read(vector) == "x/norm(p)**2"
    assert read(r"x - y") == "x/abs(x - y)**2"
    assert read(r"[x, y]") == "x/norm([x, y])**2"


def test_bars_of_both_kinds_are_told_apart():
    assert to_text(read_latex(r"\| |x| p \|", (*KNOWN, "p"), {"p": (2,)})) == "norm(abs(x)*p)"


@pytest.mark.parametrize("raised", ["^T", r"^{\top}", r"^{\mathsf T}"])
@pytest.mark.parametrize("vector", ["e_r", r"e_{r}", r"\hat e_r", "p"])
def test_a_t_behind_a_letter_that_is_an_array_is_a_transpose_whatever_its_subscript(vector: str, raised: str):
    shapes = {"e_r": (2,), "p": (2,)}
    name = "p" if vector == "p" else "e_r"
    tree = read_latex(f"{vector} {vector}{raised}", (*KNOWN, *shapes), shapes)
    assert to_text(tree) == f"{name}*{name}.T"


@pytest.mark.parametrize(
    ("latex", "text"),
    [
        (r"[1, T; 0, 1]", "[[1, T], [0, 1]]"),
        (r"\left[ 1,\, T;\; 0,\, 1 \right]", "[[1, T], [0, 1]]"),
        (r"q[\frac{T^3}{3}, \frac{T^2}{2}; \frac{T^2}{2}, T]", "q*[[T**3/3, T**2/2], [T**2/2, T]]"),
        (r"[x; y]", "[x, y]"),
        (r"[1, T; 0, 1][x; y]", "[[1, T], [0, 1]]*[x, y]"),
        (r"[1, T; 0, 1]^T", "[[1, T], [0, 1]].T"),
    ],
)
def test_rows_of_a_matrix_may_be_parted_by_semicolons(latex: str, text: str):
    assert echo(latex) == text


@pytest.mark.parametrize("latex", ["r; 1", r"\cos(r; 1)", r"\{r; 1\}", "[x, (y; r)]"])
def test_a_semicolon_elsewhere_is_refused(latex: str):
    assert "rows are parted by it in [a, b; c, d] only" in refusal(latex) or "is not read" in refusal(latex)


@pytest.mark.parametrize(
    ("latex", "text"),
    [
        ("dt", "dt"),
        (r"\frac{dt^2}{2}", "dt**2/2"),
        (r"e^{-Kdt}", "e**(-K*dt)"),
        (r"\frac{\sin\omega dt}{\omega} + dT", "sin(omega*dt)/omega + dT"),
        (r"d t + d", "d*t + d"),
        (r"dt + d^2", "d*t + d**2"),
        (r"\int_0^{dt} q\,ds", "integral(q, s, 0, dt)"),
    ],
)
def test_dt_is_one_letter_unless_there_is_one_called_d(latex: str, text: str):
    assert to_text(read_latex(latex, None)) == text
    assert to_text(read_latex("dt", ("d", "t"))) == "d*t"
    assert to_text(read_latex("dt", ("dt", "t"))) == "dt"


@pytest.mark.parametrize("matrix", [r"\Gamma", "F", r"\mathbf{F}", r"\tilde F", "F_c"])
@pytest.mark.parametrize("prime", ["'", r"^{\prime}", r"^\prime"])
def test_a_prime_behind_an_array_is_its_transpose(matrix: str, prime: str):
    """So Bar-Shalom prints it."""
    name = {r"\Gamma": "Gamma", "F_c": "F_c"}.get(matrix, "F")
    shapes = {name: (2, 1)}
    latex = f"{matrix} q {matrix}{prime}"
    assert to_text(read_latex(latex, (*KNOWN, *shapes), shapes)) == f"{name}*q*{name}.T"
    together = rf"{latex},\quad {matrix} = \begin{{bmatrix}} T & 1 \\ 0 & T \end{{bmatrix}}"
    assert echo(together) == "[[T, 1], [0, T]]*q*[[T, 1], [0, T]].T"


def test_a_prime_is_part_of_the_name_where_a_name_has_one():
    shapes = {"F": (2, 2), "F_prime": (2, 2)}
    assert to_text(read_latex("F F'", shapes, shapes)) == "F*F_prime"
    assert to_text(read_latex(r"x + \lambda'", ("x", "lambda", "lambda_prime"))) == "x + lambda_prime"
    assert to_text(read_latex("F x'", ("F", "x", "x_prime"), {"F": (2, 2)}, strangers=True)) == "F*x_prime"
    assert "may mean its transpose or another matrix" in refusal(r"\mathbf{F}\mathbf{F}'")


HALF = ("x", "q", "y")


@pytest.mark.parametrize(
    "left",
    [
        ("R_a^{11}", "R_a^{12}", "R_a^{22}"),
        ("R^{11}_L", "R^{12}_L", "R^{22}_L"),
        ("R^{11}", "R^{12}", "R^{22}"),
        ("R_{xx}", "R_{xy}", "R_{yy}"),
        ("R_{xx}", "R_{yx}", "R_{yy}"),
        ("P_{xx}", "P_{xz}", "P_{zz}"),
        (r"\sigma_x^2", r"\sigma_{xy}", r"\sigma_y^2"),
        (r"\sigma_{x}^{2}", r"\sigma_{xy}", r"\sigma^2_y"),
    ],
)
def test_entries_of_a_covariance_are_named_in_many_ways(left: tuple[str, ...]):
    rows = r" \\ ".join(f"{name} &= {entry}" for name, entry in zip(left, HALF, strict=True))
    assert echo(rf"\begin{{align}} {rows} \end{{align}}") == "[[x, q], [q, y]]"


def test_names_that_are_no_entries_make_a_vector():
    assert echo(r"d_{xx} = x, \quad d_{yy} = y") == "[x, y]"
    assert echo(r"\sigma_x^2 = x, \quad \sigma_y^2 = y") == "[x, y]"


TIMES = ("k", "n", "t", "k+1", "k-1", "k|k", r"k\mid k-1", "k/k-1", "1", r"t \,")


@pytest.mark.parametrize("time", TIMES)
def test_one_time_in_brackets_behind_every_letter_says_nothing(time: str):
    latex = rf"r^2({time})\cos\theta({time}) + \hat{{x}}_m({time})\mathbf{{y}}\left({time}\right) + \dot q({time})"
    assert to_text(read_latex(latex, None)) == "r**2*cos(theta) + x_m*y + qdot"
    assert to_text(read_latex(rf"r({time})\cos\theta({time})", ("r", "theta"))) == "r*cos(theta)"


@pytest.mark.parametrize(
    ("latex", "text"),
    [
        (r"\frac{z(1) - z(0)}{T}", "(z_1 - z_0)/T"),
        (r"\frac{z(k) - z(k-1)}{T}", "(z_k - z_km1)/T"),
        (r"\frac{z_{k} - z_{k-1}}{T}", "(z_k - z_km1)/T"),
        (r"x_m(k+1) - x_m(k)", "x_kp1_m - x_m_k"),
        (r"x_{m,k+1} - x_{m,k}", "x_kp1_m - x_m_k"),
        (r"x^2_{m}(k+1) - x_m^2(k)", "x_kp1_m**2 - x_m_k**2"),
        (r"x(k) + \dot{x}(k) T(k)", "x + xdot*T"),
        (r"\frac{2(2k-1)}{k(k+1)}", "2*(2*k - 1)/(k*(k + 1))"),
        (r"N(N+1) + r(k) + k", "N*(N + 1) + r*k + k"),
        (r"\sum_{j=1}^{k} (j+1)", "sum(j + 1, j, 1, k)"),
        (r"\frac{a}{b}(k)", "a/b*k"),
        (r"\cos(k)", "cos(k)"),
        (r"\frac{\sigma}{T(n-1)}", "sigma/(T*(n - 1))"),
        (r"\frac{\sigma}{\Delta t(n-1)}", "sigma/(Delta_t*(n - 1))"),
        (r"\frac{\sigma^2}{T^2(n+1)(n+2)}", "sigma**2/(T**2*(n + 1)*(n + 2))"),
        (r"(x + y)(k)", "(x + y)*k"),
    ],
)
def test_several_times_in_brackets_tell_letters_apart_and_factors_stay_factors(latex: str, text: str):
    assert to_text(read_latex(latex, None)) == text


def test_a_bracket_with_a_symbol_is_a_factor():
    assert to_text(read_latex("r(k)", ("r", "k"))) == "r*k"


@pytest.mark.parametrize(
    "latex", [r"\arctan(y, x)", r"\tan^{-1}(y, x)", r"\arctan\left(y, x\right)", r"\operatorname{atan}(y,x)"]
)
def test_an_arc_tangent_of_two_numbers_is_that_of_a_point(latex: str):
    assert echo(latex) == "atan2(y, x)"


@pytest.mark.parametrize(
    ("latex", "text"),
    [
        (r"J_k R_k J_k^T", "J*R*J.T"),
        (r"J_{k} R_{k} J_{k}'", "J*R*J.T"),
        (r"\mathbf{J}_n\mathbf{R}\mathbf{J}_n^{\top}", "J*R*J.T"),
        (r"J(k) R(k) J(k)'", "J*R*J.T"),
        (r"R(k|k-1) - R(k|k-1) J(k)'J(k) R(k|k-1)", "R - R*J.T*J*R"),
    ],
)
@pytest.mark.parametrize("strangers", [False, True])
def test_an_array_of_one_time_is_the_array(latex: str, text: str, *, strangers: bool):
    shapes = {"J": (2, 2), "R": (2, 2)}
    assert to_text(read_latex(latex, shapes, shapes, strangers=strangers)) == text


def test_arrays_of_two_times_are_told_apart():
    shapes = {"J": (2, 2), "J_k": (2, 2)}
    assert to_text(read_latex("J_k J^T", shapes, shapes)) == "J_k*J.T"
    assert to_text(read_latex("J_n J_k", {"J"}, {"J": (2, 2)}, strangers=True)) == "J_n*J_k"


@pytest.mark.parametrize(
    ("latex", "text"),
    [
        (r"vx * cos(theta) + atan \frac{py}{px}", "vx*cos(theta) + atan(py/px)"),
        (r"\frac{py(py*vx - px*vy)}{rho^3}", "py*(py*vx - px*vy)/rho**3"),
        (r"q*dt^3/3", "q*dt**3/3"),
        (r"x1*y2", "x1*y2"),
        (r"qr * x^*", "q*r*x"),
    ],
)
def test_letters_side_by_side_are_words_where_factors_are_starred(latex: str, text: str):
    names = ("px", "py", "vx", "vy", "rho", "theta", "q", "r", "x", "dt", "x1", "y2")
    assert echo(latex, *names) == text


@pytest.mark.parametrize("before", [r"\begin{align*} x &=", "x^* ="])
def test_other_stars_make_no_words(before: str):
    assert echo(before + r" qr \cos\theta" + (r"\end{align*}" if "align" in before else "")) == "q*r*cos(theta)"


@pytest.mark.parametrize("time", ["k", "{k}", "{(k)}"])
@pytest.mark.parametrize("later", ["{k+1}", "{k + 1}", "{(k+1)}"])
def test_times_that_are_raised_are_no_powers(time: str, later: str):
    step = rf"p_x^{later} = p_x^{time} + T v_x^{time}"
    assert to_text(read_latex(step, None)) == "p_x_k + T*v_x_k"
    system = rf"\begin{{align}} {step} \\ v_x^{later} &= v_x^{time} \end{{align}}"
    assert to_text(read_latex(system, None)) == "[p_x_k + T*v_x_k, v_x_k]"


def test_powers_are_no_times_where_nothing_is_defined_at_one():
    assert echo(r"y = x^k + r") == "x**k + r"
    assert to_text(read_latex(r"x^{k+1} = e^{k} x^{k}", None)) == "e**k*x_k"


@pytest.mark.parametrize(
    ("latex", "name"), [(r"\sigma_{a_x}^2", "sigma_a_x"), (r"\sigma^2_{\theta_{m}}", "sigma_theta_m")]
)
def test_a_subscript_may_have_one(latex: str, name: str):
    assert to_text(read_latex(latex, None)) == f"{name}**2"


def test_a_column_that_is_empty_in_every_row_is_none():
    assert echo(r"\begin{bmatrix} x & y & \\ 0 & r & \\ \end{bmatrix}") == "[[x, y], [0, r]]"
    assert refusal(r"\begin{bmatrix} x & y & \\ 0 & r \end{bmatrix}")


@pytest.mark.parametrize(
    "system",
    [
        "x = r\\cos\\theta\ny = r\\sin\\theta",
        "x = r\\cos\\theta\n\n  y &= r\\sin\\theta",
        r"$x = r\cos\theta$ and $y = r\sin\theta$",
        r"where $x = r\cos\theta$, with the height $y = r\sin\theta$ above it.",
        "$x = r\\cos\\theta$\n\n$y = r\\sin\\theta$",
    ],
)
def test_equations_on_lines_and_in_sentences_are_all_read(system: str):
    assert to_text(read_latex(system, KNOWN, wanted=2)) == "[r*cos(theta), r*sin(theta)]"


def test_a_line_behind_a_matrix_may_use_it():
    lines = "F = \\begin{bmatrix} 1 & T \\\\ 0 & 1 \\end{bmatrix}\nQ = q F F^T"
    assert to_text(read_latex(lines, KNOWN)) == "q*[[1, T], [0, 1]]*[[1, T], [0, 1]].T"


@pytest.mark.parametrize("formula", ["x = r\n\\cos\\theta", "y = x +\n r = r\\cos\\theta", "x = y\n = r\\cos\\theta"])
def test_a_line_that_goes_on_is_one_with_the_line_before(formula: str):
    assert echo(formula) == READ
