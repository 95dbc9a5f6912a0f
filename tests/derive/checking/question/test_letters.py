"""A formula in the letters of a paper is the same formula: matched by meaning, units and trial."""

import os
from collections.abc import Mapping
from functools import partial
from random import Random

import pytest

from radartrack.derive import check
from radartrack.derive.catalogue import catalogue
from radartrack.derive.checking.question.compared_quantity import UnknownEntry
from radartrack.derive.checking.question.letters.letter_meanings import Role, meanings
from radartrack.derive.checking.reporting.derived_formula import shown
from radartrack.derive.checking.reporting.verdict import Outcome
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.fold import rebuild
from radartrack.derive.formula.printing import to_latex, to_text
from radartrack.derive.formula.tree import Name, Tree, names
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.reading.text import read_text

THOROUGH = int(os.environ.get("RADARTRACK_MUTANTS", "2")) >= 100
LONG = 20_000 if THOROUGH else 300  # characters of a formula
EQUAL = {Outcome.EQUAL, Outcome.EQUAL_NUMERICALLY}

# As the field writes them; what is not here keeps its own name.
USUAL = {
    "r": ("R", "rng", "r_m"),
    "beta": ("theta", "az", "phi", "bearing"),
    "epsilon": ("el", "elev"),
    "rdot": ("rr", "vr", "range_rate"),
    "sigma_r": ("s_r", "sr", "sigma_rho", "std_r", "range_std"),
    "sigma_beta": ("s_theta", "sth", "sigma_az", "std_az", "sigma_phi"),
    "sigma_epsilon": ("s_el", "sigma_el"),
    "sigma_rdot": ("s_rr", "sigma_rr"),
    "T": ("dt", "Delta_t", "tau", "Ts"),
    "x": ("px", "east"),
    "y": ("py", "north"),
    "z": ("pz", "up"),
    "vx": ("xdot", "v_x"),
    "vy": ("ydot", "v_y"),
}


def renamed(tree: Tree, symbols: set[str], random: Random) -> tuple[Tree, dict[str, str]]:
    """The tree in other letters, and which letter stands for which symbol."""
    letters: dict[str, str] = {}
    for name in sorted(names(tree)):
        usual = [letter for letter in USUAL.get(name, ()) if letter not in symbols]
        letters[name] = random.choice(usual) if usual else name
    change: Mapping[str, str] = letters
    return rebuild(tree, lambda node: Name(change[node.name]) if isinstance(node, Name) else node), letters


def entries(name: str) -> list[tuple[str, str]]:
    """Different entries of a quantity with their formulas; outside the thorough run one of them."""
    quantity = catalogue()[name]
    found: dict[str, str] = {}
    for index, expression in quantity.expression.items():
        if expression.free_symbols and len(str(expression)) <= LONG:
            place = f"[{','.join(map(str, index))}]" if index else ""
            found.setdefault(shown(Tensor((), (expression,))), f"{name}{place}")
    chosen = [(entry, formula) for formula, entry in found.items()]
    return chosen if THOROUGH else Random(name).sample(chosen, min(1, len(chosen)))


@pytest.mark.parametrize("name", sorted(catalogue())[:: 1 if THOROUGH else 5])
def test_every_formula_is_equal_in_the_letters_of_the_field_and_told_with_what_it_was_read(name: str) -> None:
    symbols = {symbol.name for symbol in catalogue()[name].symbols}
    for entry, formula in entries(name):
        tree, letters = renamed(read_text(formula, symbols), symbols, Random(entry))
        verdict = check(entry, to_text(tree))
        assert verdict.verdict in EQUAL, (entry, to_text(tree), verdict.reason, verdict.reading)
        told = dict(words.split(" for ") for words in verdict.reading)
        changed = {letter: symbol for symbol, letter in letters.items() if letter != symbol}
        assert told.keys() == changed.keys()
        assert told == changed


@pytest.mark.parametrize(
    ("name", "formula"),
    [
        ("polar.map", "[a*cos(b), a*sin(b)]"),
        ("polar.map", "[rho*cos(g), rho*sin(g)]"),
        ("spherical.map", "[a*cos(c)*sin(b), a*cos(c)*cos(b), a*sin(c)]"),
        ("spherical.map", "[R*cos(phi)*sin(theta), R*cos(phi)*cos(theta), R*sin(phi)]"),
        ("spherical.map", "[R*cos(theta)*sin(phi), R*cos(theta)*cos(phi), R*sin(theta)]"),
        ("polar.covariance.linear[0,0]", "a^2*b^2*sin(c)^2 + d^2*cos(c)^2"),
        ("observe.spherical.map", "[sqrt(e^2+n^2+u^2), atan2(e,n), atan(u/sqrt(e^2+n^2))]"),
        ("observe.spherical.map", "[sqrt(a^2+b^2+c^2), atan2(a,b), asin(c/sqrt(a^2+b^2+c^2))]"),
        ("motion.constant_velocity.process_noise.continuous", "[[w*h^3/3, w*h^2/2], [w*h^2/2, w*h]]"),
        ("fusion.weights.two", "[b^2/(a^2 + b^2), a^2/(a^2 + b^2)]"),
    ],
)
def test_letters_without_a_meaning_are_matched_one_to_one_by_units_and_trial(name: str, formula: str) -> None:
    given = {"rho": "0"} if "covariance" in name else None
    assert check(name, formula, given=given).verdict in EQUAL


@pytest.mark.parametrize(
    "letters", [("s_r", "s_theta"), ("sigma_rho", "sigma_az"), ("std_r", "std_phi"), ("sr", "sth")]
)
def test_deviations_that_are_exchanged_are_a_slip_however_well_the_exchange_fits(letters: tuple[str, str]) -> None:
    first, second = letters
    right = f"r^2*{second}^2*sin(az)^2 + {first}^2*cos(az)^2"
    wrong = f"r^2*{first}^2*sin(az)^2 + {second}^2*cos(az)^2"
    assert check("polar.covariance.linear[0,0]", right, given={"rho": "0"}).verdict is Outcome.EQUAL
    verdict = check("polar.covariance.linear[0,0]", wrong, given={"rho": "0"})
    assert verdict.verdict is Outcome.WRONG_DIMENSIONS
    assert f"{first} for sigma_r" in verdict.reading
    assert any("swapped" in one.edit for one in verdict.suggestions)


def test_the_name_of_a_symbol_means_it_unless_no_unit_is_possible_then() -> None:
    formula = "(rho*s_th*cos(th))^2 + (s_rho*sin(th))^2"
    verdict = check("polar.covariance.linear[1,1]", formula, given={"rho": "0"})
    assert verdict.verdict is Outcome.EQUAL
    assert "rho for r" in verdict.reading
    own = check("polar.covariance.linear[0,1]", "rho*r*s_r*s_th*cos(2*th) + (s_r^2 - r^2*s_th^2)*sin(2*th)/2")
    assert own.verdict is Outcome.EQUAL
    assert not any(words.startswith("rho ") for words in own.reading)


@pytest.mark.parametrize(
    ("name", "formula", "edit"),
    [
        ("polar.bias.second_order[0]", "-R*cos(theta)*s_theta^2", "a missing factor 1/2"),
        ("polar.map", "[a*cos(b), -a*sin(b)]", "the sign of a*sin(b)"),
        ("spherical.map[2]", "a*cos(el)", "cos should be sin"),
        ("observe.polar.map[0]", "sqrt(e^2 - n^2)", "the sign of n**2"),
        ("motion.constant_velocity.process_noise.continuous[0,0]", "q*dt^3/4", "4 should be 3"),
    ],
)
def test_a_wrong_formula_is_read_with_what_leaves_the_least_to_explain(name: str, formula: str, edit: str) -> None:
    given = {"rho": "0"} if "bias" in name else None
    verdict = check(name, formula, given=given)
    assert verdict.verdict in {Outcome.DIFFERS, Outcome.WRONG_DIMENSIONS}
    assert verdict.reading
    assert any(one.edit.startswith(edit) for one in verdict.suggestions), verdict.suggestions


def test_letters_of_a_definition_are_matched_too() -> None:
    let = {"l": "exp(-s_th^2/2)"}
    assert check("polar.unbiased.estimate", "[d*cos(th)/l, d*sin(th)/l]", given={"rho": "0"}, let=let).is_equal


def test_a_variance_is_read_as_the_square_of_a_deviation() -> None:
    verdict = check("polar.covariance.linear[0,0]", "var_r*cos(az)^2 + r^2*var_az*sin(az)^2", given={"rho": "0"})
    assert verdict.verdict is Outcome.EQUAL
    assert "var_r for sigma_r**2" in verdict.reading


def test_latex_is_read_in_its_own_letters() -> None:
    formula = to_latex(read_text("[rho*cos(theta), rho*sin(theta)]", ["rho", "theta"]))
    assert check("polar.map", formula, latex=True).verdict is Outcome.EQUAL


def test_a_name_as_latex_prints_it_is_defined_whatever_the_formula_is_written_in() -> None:
    for name in ("R_{11}", "R_11"):
        assert check("polar.map[0]", r"R_{11} r", latex=True, let={name: r"\cos\theta"}).is_equal
        assert check("polar.map[0]", "R_11*r", let={name: "cos(theta)"}).is_equal


def test_where_several_readings_are_as_likely_the_definitions_to_type_are_offered() -> None:
    with pytest.raises(FormulaError, match="--let a=sigma_1"):
        check("fusion.weights.two[0]", "exp(a^2*b + a/b)")


def test_more_letters_than_the_quantity_has_symbols_are_refused() -> None:
    with pytest.raises(FormulaError, match="is not a name here"):
        check("polar.map[0]", "a*cos(b)*c")


@pytest.mark.parametrize(
    ("name", "role"),
    [
        ("sigma_1", Role.DEVIATION),
        ("std_range", Role.DEVIATION),
        ("range_std", Role.DEVIATION),
        ("var_az", Role.VARIANCE),
        ("rho_12", Role.CORRELATION),
        ("sum_of", None),
        ("speed", None),
    ],
)
def test_the_spelling_of_a_name_says_its_role(name: str, role: Role | None) -> None:
    assert meanings(name).role is role


@pytest.mark.parametrize("argument", ["-sigma_phi^2", "2*sigma_phi^2", "sigma_phi**2/2"])
def test_powers_of_euler_s_number_are_none_of_a_letter_however_many_there_are(argument: str) -> None:
    printed = f"r*cos(phi)*e^({argument})*e^(sigma_phi^2)*(1 - e^({argument})) "
    verdict = check("polar.unbiased.estimate[0]", printed)
    assert verdict.verdict is Outcome.DIFFERS
    assert not any(word.startswith("e ") for word in verdict.reading)


@pytest.mark.parametrize(
    ("name", "formula", "let"),
    [
        ("polar.map", "[foo*cos(beta), foo*sin(beta)]", "--let foo=r"),
        ("polar.map", "[rnage*cos(beta), rnage*sin(beta)]", "did you mean r.*--let rnage=r"),
        ("polar.map", "[r*cos(bteta), r*sin(bteta)]", "did you mean beta.*--let bteta=beta"),
        ("polar.bias.second_order[0]", "-r*cos(beta)*sigma_bta^2/2", "--let sigma_bta=sigma_beta"),
        ("polar.map", "[r*cos(elevation), r*sin(elevation)]", "elevation is no name that is known here"),
    ],
)
def test_a_word_that_means_nothing_here_is_asked_for_and_never_taken_for_what_fits(
    name: str, formula: str, let: str
) -> None:
    with pytest.raises(FormulaError, match=let):
        check(name, formula)


@pytest.mark.parametrize(
    ("name", "formula", "reading"),
    [
        ("polar.map", "[targetRange*cos(azimuthAngle), targetRange*sin(azimuthAngle)]", "azimuthAngle for beta"),
        ("motion.constant_velocity.process_noise.piecewise[1,1]", "dt^2*sigma_acc^2", "sigma_acc for sigma_w"),
        ("motion.constant_velocity.transition[0,1]", "update_period", "update_period for T"),
        ("motion.constant_velocity.process_noise.continuous[1,1]", "Te*q", "Te for T"),
        ("polar.map", "[rngMeas*cos(brngMeas), rngMeas*sin(brngMeas)]", "brngMeas for beta"),
        ("motion.singer.transition[1,2]", "tau_m*(1 - exp(-dt/tau_m))", "tau_m for 1/alpha"),
        ("fusion.variance.two", "P1*P2/(P1 + P2)", "P1 for sigma_1**2"),
        ("motion.turn.known_rate.transition[0,1]", "sin(turn_rate*dt)/turn_rate", "turn_rate for omega"),
        ("motion.constant_velocity.process_noise.continuous[1,1]", "spectral_density*dt", "spectral_density for q"),
        ("motion.constant_velocity.process_noise.piecewise[1,1]", "var*dt^2", "var for sigma_w**2"),
        ("finite_sample.degree0.range.covariance[0,0]", "variance/k", "variance for sigma_r**2"),
    ],
)
def test_words_time_constants_and_variances_are_read_as_what_they_are(name: str, formula: str, reading: str) -> None:
    verdict = check(name, formula)
    assert verdict.verdict is Outcome.EQUAL
    assert reading in verdict.reading


PRODUCT = "[[cos(b), -r*sin(b)], [sin(b), r*cos(b)]]*diag(s_r^2, s_b^2)*[[cos(b), -r*sin(b)], [sin(b), r*cos(b)]].T"


@pytest.mark.parametrize(
    ("name", "formula", "let"),
    [
        ("polar.covariance.linear", PRODUCT, {}),
        (
            "polar.covariance.linear",
            "J*K*J^T",
            {"J": "[[cos(b), -r*sin(b)], [sin(b), r*cos(b)]]", "K": "diag(s_r^2, s_b^2)"},
        ),
        ("polar.map", "[[R*cos(b)], [R*sin(b)]]", {}),
        ("polar.map", "[[R*cos(b), R*sin(b)]]", {}),
        ("polar.map", "[R*cos(b), R*sin(b), R][0:2]", {}),
        ("observe.bearing.map", "atan2(n, e)", {}),
    ],
)
def test_letters_are_matched_in_products_rows_columns_and_slices(name: str, formula: str, let: dict[str, str]) -> None:
    given = {"rho": "0"} if "covariance" in name else None
    assert check(name, formula, given=given, let=let).verdict is Outcome.EQUAL


@pytest.mark.parametrize("given", [{"azimuth": "0"}, {"theta": "0", "corr": "0"}, {"beta": "0"}])
def test_conditions_are_in_any_letters_too(given: dict[str, str]) -> None:
    assert check("polar.covariance.linear[0,0]", "sigma_r^2", given=given).verdict is Outcome.EQUAL


@pytest.mark.parametrize("pair", ["P{}", "a{}", "s_{}", "sigma_{}", "var_{}", "w{}"])
@pytest.mark.parametrize("first", [0, 1, 5])
def test_numbered_letters_keep_their_order(pair: str, first: int) -> None:
    one, two = pair.format(first), pair.format(first + 1)
    squared = "" if pair.startswith(("P", "var")) else "^2"
    above, below = f"{two}{squared}", f"({one}{squared} + {two}{squared})"
    right, wrong = f"{above}/{below}", f"{one}{squared}/{below}"
    assert check("fusion.weights.two", f"[{right}, {wrong}]").verdict in EQUAL
    assert check("fusion.weights.two", f"[{wrong}, {right}]").verdict is Outcome.DIFFERS


def test_a_deviation_is_that_of_its_own_subscript_whatever_else_that_may_mean() -> None:
    verdict = check("motion.ctrv.process_noise.piecewise[4,4]", "s_omega^2*dt^2")
    assert verdict.verdict in EQUAL
    entry = catalogue()["motion.ctrv.process_noise.piecewise"].expression[0, 0]
    printed = shown(Tensor((), (entry,))).replace("sigma_w", "s_w").replace("T", "dt")
    verdict = check("motion.ctrv.process_noise.piecewise[0,0]", printed)
    assert verdict.verdict in EQUAL
    assert "s_w for sigma_w" in verdict.reading


@pytest.mark.parametrize(
    ("name", "formula", "edit"),
    [
        ("motion.singer.transition[0,2]", "tau_m^2*(1 + T/tau_m + exp(-T/tau_m))", "the sign of 1"),
        ("motion.singer.process_noise[2,2]", "sm^2*(1 + exp(-2*T/tau))", "the sign of exp(-2*T/tau)"),
    ],
)
def test_a_slip_beside_a_time_constant_is_told(name: str, formula: str, edit: str) -> None:
    verdict = check(name, formula)
    assert any("for 1/alpha" in words for words in verdict.reading)
    assert edit in [one.edit for one in verdict.suggestions]


@pytest.mark.parametrize("name", ["azimuth_deg", "bearing_degrees", "azDeg"])
def test_a_name_that_says_degrees_is_told_where_it_is_read_in_radians(name: str) -> None:
    assert f"{name}, in radians, for beta" in check("polar.map[0]", f"r*cos({name})").reading
    assert "equal with beta in degrees" in check("polar.map[0]", f"r*cos({name}*pi/180)").remarks


def test_what_has_two_meanings_is_told_before_what_is_no_name() -> None:
    with pytest.raises(FormulaError, match="may be the power of"):
        check("polar.map[0]", r"\rho\cos\theta^2", latex=True)


def test_the_model_whose_letters_a_wrong_formula_has_is_named() -> None:
    with pytest.raises(FormulaError, match=r"may be meant for motion\.constant_velocity\.process_noise\.piecewise"):
        check("motion.constant_velocity.process_noise.continuous", "[[dt^4/4, dt^3/3], [dt^3/3, dt^2]]*sigma_a^2")


@pytest.mark.parametrize(
    ("let", "given"),
    [
        ({"λ": "exp(-σβ²/2)"}, {"ρ": "0"}),
        ({"λ": "exp(-s/2)", "s": "σβ²"}, {"rho": "0"}),
        ({"l": "σβ²", "λ": "e^(-l/2)"}, {"ρ": "0"}),
    ],
)
def test_definitions_and_conditions_are_read_as_they_stand_on_a_page(
    let: dict[str, str], given: dict[str, str]
) -> None:
    assert check("polar.posterior.estimate[0]", "λ r cosβ", let=let, given=given).verdict in EQUAL


@pytest.mark.parametrize("place", ["0:2,0:2", "0:2,:2", ":2,0:2"])
def test_a_part_of_a_matrix_is_a_slice(place: str) -> None:
    formula, let = "[[x/d, y/d], [-y/d^2, x/d^2]]", {"d": "hypot(x, y)"}
    assert check(f"observe.polar_doppler.jacobian[{place}]", formula, let=let).verdict in EQUAL


@pytest.mark.parametrize("place", ["0:2,0:5", "2:1,0", "-1,0", "3", "0,0,0", "3:,0"])
def test_a_slice_that_there_is_not_is_refused(place: str) -> None:
    with pytest.raises(UnknownEntry, match="has shape"):
        check(f"observe.polar_doppler.jacobian[{place}]", "x")


def _renamed(letters: Mapping[str, str], node: Tree) -> Tree:
    return Name(letters.get(node.name, node.name)) if isinstance(node, Name) else node


@pytest.mark.parametrize("name", [name for name in catalogue() if name.startswith(("line.", "initiation.two"))])
def test_a_name_without_its_underscores_is_the_same_name(name: str) -> None:
    for entry, formula in entries(name):
        tree = read_text(formula, None)
        letters = {one: one.replace("_", "") for one in names(tree) if "_" in one and not one[-1].isdigit()}
        plain = rebuild(tree, partial(_renamed, letters))
        assert check(entry, to_text(plain)).verdict in EQUAL, to_text(plain)


@pytest.mark.parametrize(
    ("name", "formula", "read"),
    [
        ("motion.constant_velocity.process_noise.continuous", "s_v^2*[[T^3/3, T^2/2], [T^2/2, T]]", "s_v for sqrt(q)"),
        ("motion.ornstein_uhlenbeck.process_noise[1,1]", "sigma^2*(1 - exp(-2*a*T))/(2*a)", "sigma for sqrt(q)"),
        (
            "initiation.two_plots.covariance",
            "[[sigma_2^2, sigma_2^2/T], [sigma_2^2/T, (sigma_1^2 + sigma_2^2)/T^2]]",
            "sigma_2 for sqrt(second_covariance)",
        ),
    ],
)
def test_a_deviation_may_be_the_root_of_a_variance(name: str, formula: str, read: str) -> None:
    verdict = check(name, formula)
    assert verdict.verdict in EQUAL
    assert read in verdict.reading
    assert check(name, f"3*{formula}").verdict not in EQUAL


def test_numbered_deviations_keep_their_order_where_variances_are_first_and_second() -> None:
    swapped = "[[sigma_1^2, sigma_1^2/T], [sigma_1^2/T, (sigma_1^2 + sigma_2^2)/T^2]]"
    verdict = check("initiation.two_plots.covariance", swapped)
    assert verdict.verdict is Outcome.DIFFERS
    assert verdict.suggestions[0].edit == "sigma_1 should be sigma_2"


def test_one_index_of_a_matrix_is_a_row() -> None:
    row = "[y*(vx*y - vy*x)/r^3, x*(vy*x - vx*y)/r^3, x/r, y/r]"
    assert check("observe.polar_doppler.jacobian[2]", row, let={"r": "hypot(x, y)"}).verdict in EQUAL


def test_a_condition_in_a_letter_that_is_read_as_its_symbol_sets_the_other_one() -> None:
    given = {"sigma_1": "s", "sigma_2": "s"}
    assert check("fusion.variance.two", "s^2/2", given=given).verdict in EQUAL
    assert check("fusion.variance.two", "s^2/3", given=given).verdict is Outcome.DIFFERS
