"""Formulas made of others by rules: some always keep the value, some only on a branch, some never."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from random import Random

from radartrack.derive.formula.fold import rebuild
from radartrack.derive.formula.tree import Array, Call, Name, Number, Power, Tree, children, replace_at, walk
from radartrack.derive.language.variable import Variable
from radartrack.derive.reading.text import read_text

# X is a part of a formula, A some other small formula. These keep the value of X where all of it is real.
KEEP = (
    "X + A - A", "X + (A - A)", "(X - A) + A", "-(-X)", "2*X - X", "X/2 + X/2", "3*X/3",
    "X*(sin(A)**2 + cos(A)**2)", "X*(cosh(sin(A))**2 - sinh(sin(A))**2)", "X*(1 + A**2)/(1 + A**2)",
    "X/(1/(2 + cos(A)))/(2 + cos(A))", "sqrt(X)**2", "sqrt(X)*sqrt(X)", "(X**(1/3))**3", "X**3/X**2",
    "X**(3/2)/X**(1/2)", "1/(1/X)", "tan(atan(X))", "sin(asin(X))", "cos(acos(X))", "X*abs(A)**2/A**2",
    "(X + abs(X))/2 + (X - abs(X))/2", "abs(X)**2/X", "X*tan(A)*cot(A)", "X*sec(A)*cos(A)", "X*sin(A)*csc(A)",
    "X*tanh(cos(A))*coth(cos(A))", "X*exp(cos(A))*exp(-cos(A))", "X - sin(A)*cos(A) + sin(2*A)/2",
    "(X**2 - 1)/(X + 1) + 1", "X*(expm1(cos(A)) + 1)/exp(cos(A))", "X + log(2)/2 - log(sqrt(2))", "X*exp(0*A)",
    "X + 0*A", "X*cos(atan(A))*sqrt(1 + A**2)", "X*sqrt(A**2 + 1)/hypot(A, 1)", "X*sqrt(A**2)/abs(A)",
    "X*2**(1/2)/sqrt(2)", "X*(A**2)**(1/4)/sqrt(abs(A))", "X + sin(pi - A) - sin(A)",
    "X*abs(sin(A) + 2)/(sin(A) + 2)",
)  # fmt: skip
# The same for calls: of A, or of A and B.
KEEP_CALLS: Mapping[str, tuple[str, ...]] = {
    "cos": (
        "cos(-A)", "sin(A + pi/2)", "sin(pi/2 - A)", "-cos(A + pi)", "2*cos(A/2)**2 - 1", "1/sec(A)",
        "sin(A)/tan(A)",
    ),
    "sin": ("-sin(-A)", "cos(A - pi/2)", "sin(pi - A)", "2*sin(A/2)*cos(A/2)", "tan(A)*cos(A)", "cos(A)/cot(A)"),
    "tan": ("sin(A)/cos(A)", "cot(pi/2 - A)", "1/cot(A)", "-tan(-A)", "tan(A + pi)"),
    "sqrt": ("A**(1/2)", "sqrt(4*A)/2", "(A**2)**(1/4)", "sqrt(A/9)*3", "A/sqrt(A)"),
    "exp": ("1/exp(-A)", "exp(A/2)**2", "cosh(A) + sinh(A)", "expm1(A) + 1", "e**A"),
    "cosh": ("(exp(A) + exp(-A))/2", "cosh(-A)", "2*cosh(A/2)**2 - 1", "sqrt(1 + sinh(A)**2)"),
    "sinh": ("(exp(A) - exp(-A))/2", "-sinh(-A)", "tanh(A)*cosh(A)"),
    "atan2": (
        "-atan2(-A, B)", "2*atan2(A, B + hypot(A, B))", "atan2(2*A, 2*B)", "pi/2 - atan2(B, A)", "atan2(A, abs(B))",
    ),
    "atan": ("-atan(-A)", "atan2(A, 1)", "asin(A/sqrt(1 + A**2))", "pi/2 - atan(1/A)"),
    "abs": ("sqrt(A**2)", "abs(-A)", "A"),
    "hypot": ("sqrt(A**2 + B**2)", "hypot(B, A)", "hypot(-A, B)", "abs(A)*sqrt(1 + (B/A)**2)"),
}  # fmt: skip
KEEP_WHOLE = ("X*cos(2*pi*K)", "X*cos(pi*K)**2", "X + sin(pi*K)", "X*abs(cos(pi*K))", "X*cos(4*pi*K + A)/cos(A)")
# These keep it on a branch alone, or nowhere, or nearly.
SPOIL = (
    "sqrt(X**2)", "abs(X)", "X*sqrt(A)*sqrt(1/A)", "X*sqrt(A)/sqrt(abs(A))", "atan(tan(X))", "asin(sin(X))",
    "acos(cos(X))", "(X**3)**(1/3)", "(X**2)**(1/2)", "X*abs(A)/A", "X*sqrt(A**2)/A", "sqrt(X)*abs(sqrt(X))",
    "abs(sqrt(X))**2", "X*(1 + 1e-30)", "X + 1e-30", "X*sqrt(A*A)/(sqrt(A)*sqrt(A))", "log(exp(X))",
    "X*exp(A)/exp(abs(A))", "hypot(X, 0)", "sqrt(X**2 + 1e-20)", "X*sqrt(X)/sqrt(abs(X))", "X**(3/2)/abs(X)**(1/2)",
    "X*A/A + 1e-25*A", "(sqrt(X)**3)**(2/3)", "X*sqrt(cos(A))*sqrt(1/cos(A))", "X*log(A**2)/(2*log(abs(A)))",
    "X*log(A**2)/(2*log(A))", "X*acos(cos(A))/A", "sin(acos(X))", "X*cos(asin(A))**2/(1 - A**2)",
    "X*sqrt(1 - A)*sqrt(1 + A)/sqrt(1 - A**2)", "X*atan2(A, A)*4/pi", "X*atan2(0, A + 2)", "X*(1 + atan2(0, A))",
    "X*cot(A + pi/2)/tan(A)", "X*tan(A - pi/2)*tan(A)", "X*exp(abs(sqrt(A)))", "X*abs(sqrt(A) + 1)/(sqrt(A) + 1)",
    "2*X", "X/3", "-X", "X**2", "X + A", "X*A", "X/A", "X*cos(A)", "X**(1/2)", "X + 1", "X*pi", "X*atan(tan(A))/A",
    "X*cos(atan(tan(A)))/cos(A)", "X*sqrt(sin(A)**2)/sin(A)", "X*tanh(A)",
)  # fmt: skip
SPOIL_CALLS: Mapping[str, tuple[str, ...]] = {
    "cos": (
        "sin(A)", "cosh(A)", "sqrt(1 - sin(A)**2)", "cos(2*A)", "cos(A + pi)", "cos(atan(tan(A)))",
        "1/sqrt(1 + tan(A)**2)",
    ),
    "sin": (
        "cos(A)", "sinh(A)", "sqrt(1 - cos(A)**2)", "sin(A + pi)", "sin(acos(cos(A)))", "A",
        "sin(asin(sin(A)))*sqrt(1)",
    ),
    "tan": ("cot(A)", "tan(A/2)", "tanh(A)", "A"),
    "sqrt": ("A", "A**(1/3)", "abs(A)**(1/2)", "-sqrt(A)"),
    "exp": ("exp(-A)", "1 + A", "exp(2*A)", "expm1(A)"),
    "cosh": ("sinh(A)", "cos(A)", "exp(A)/2"),
    "sinh": ("cosh(A)", "sin(A)", "A"),
    "atan2": (
        "atan2(B, A)", "atan(A/B)", "atan2(A, -B)", "acos(B/hypot(A, B))", "asin(A/hypot(A, B))",
        "2*atan(A/(hypot(A, B) + B))",
    ),
    "atan": ("acos(1/sqrt(1 + A**2))", "asin(A)", "A"),
    "abs": ("A", "-A"),
    "hypot": ("A + B", "sqrt(A**2 - B**2)", "abs(A)"),
}  # fmt: skip
SPOIL_WHOLE = ("X*cos(pi*K)", "X*cos(pi*K/2)**2", "X + sin(pi*K/2)*0.001", "X*abs(cos(K))")
LEAVES = ("2", "1/3", "pi", "e", "0.7")
SMALL = (
    "{0}",
    "{0}/7",
    "{0}*{1}",
    "{0} + 2",
    "{0}/(1 + {1}**2)",
    "sin({0})",
    "{0} - {1}",
    "atan({0})",
    "{0}**2",
    "cos({0})",
)


def rewritten(tree: Tree, symbols: Sequence[Variable], random: Random) -> Tree:
    """The formula after up to three changes that keep it, as far as they go."""
    for _ in range(random.randint(1, 3)):
        tree = _changed(tree, symbols, random, KEEP, KEEP_CALLS, KEEP_WHOLE)
    return tree


def spoilt(tree: Tree, symbols: Sequence[Variable], random: Random) -> Tree:
    """The formula after a change that may spoil it, and perhaps one that does not, before or after."""
    if random.random() < 0.3:
        tree = _changed(tree, symbols, random, KEEP, KEEP_CALLS, KEEP_WHOLE)
    tree = _changed(tree, symbols, random, SPOIL, SPOIL_CALLS, SPOIL_WHOLE)
    if random.random() < 0.3:
        tree = _changed(tree, symbols, random, KEEP, KEEP_CALLS, KEEP_WHOLE)
    return tree


def _changed(
    tree: Tree,
    symbols: Sequence[Variable],
    random: Random,
    rules: Sequence[str],
    calls: Mapping[str, Sequence[str]],
    whole: Sequence[str],
) -> Tree:
    places = [(path, node) for path, node in walk(tree) if not _is_fixed(tree, path)]
    path, node = random.choice(places)
    meant: dict[str, Tree] = {"X": node, "A": _small(symbols, random)}
    if isinstance(node, Call) and node.function in calls and random.random() < 0.6:
        meant |= dict(zip("AB", children(node), strict=False))
        rule = random.choice(calls[node.function])
    else:
        numbers = [symbol for symbol in symbols if symbol.whole]
        if numbers and random.random() < 0.2:
            meant["K"], rules = Name(random.choice(numbers).name), whole
        rule = random.choice(rules)
    return replace_at(tree, path, _filled(rule, meant))


def _is_fixed(tree: Tree, path: tuple[int, ...]) -> bool:
    """Whether it stands in an exponent, which must stay a plain number, or is no scalar."""
    for place in path:
        if isinstance(tree, Array) or (isinstance(tree, Power) and place == 1):
            return True
        tree = children(tree)[place]
    return False


def _small(symbols: Sequence[Variable], random: Random) -> Tree:
    names = [symbol.name for symbol in symbols]
    parts = [random.choice([*names, random.choice(LEAVES)]) for _ in range(2)]
    return read_text(random.choice(SMALL).format(*(f"({part})" for part in parts)), names)


def _filled(rule: str, meant: Mapping[str, Tree]) -> Tree:
    """A rule with formulas for its letters."""
    return rebuild(
        read_text(rule, set("XABK")), lambda node: meant[node.name] if isinstance(node, Name) else _as_printed(node)
    )


def _as_printed(node: Tree) -> Tree:
    return Number(node.text) if isinstance(node, Number) else node
