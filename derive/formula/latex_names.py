r"""How symbols are named in LaTeX: \sigma_{\beta} is sigma_beta, \dot{r} is rdot."""

from __future__ import annotations

import re
from collections.abc import Collection

_LOWER = (
    "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau upsilon "
    "phi chi psi omega"
)
_UPPER = "Gamma Delta Theta Lambda Xi Pi Sigma Upsilon Phi Psi Omega"
_VARIANTS = ("epsilon", "theta", "kappa", "pi", "rho", "sigma", "phi")

GREEK = {f"\\{name}": name for name in f"{_LOWER} {_UPPER}".split()} | {f"\\var{name}": name for name in _VARIANTS}
ACCENTS = {"\\dot": "dot", "\\ddot": "ddot"}

_LETTERS = {name: command for command, name in reversed(GREEK.items())}
_DOTTED = re.compile(r"(?P<letter>[A-Za-z]+?)(?P<dots>d?dot)")
_NUMBERED = re.compile(r"(?P<letter>[A-Za-z]+)(?P<digits>\d+)")


def latex_name(name: str) -> str:
    """A symbol's name in LaTeX, as `candidates` reads it back."""
    base, *below = name.split("_")
    if not base or not all(below):
        return _roman(name)
    numbered = _NUMBERED.fullmatch(base)
    if numbered and not below and _is_letter(numbered["letter"]):
        base, below = numbered["letter"], [numbered["digits"]]
    return _part(base) + (f"_{{{','.join(map(_part, below))}}}" if below else "")


def candidates(base: str, below: str) -> tuple[str, ...]:
    """The names that a letter with a subscript may stand for: x_0 or x0, sigma_beta, s_a_b for s_{a,b}."""
    return (f"{base}_{below}", f"{base}{below}") if below.isdigit() else (f"{base}_{below}",)


def resolve(base: str, below: str, names: Collection[str]) -> str:
    """The one symbol that is meant; when there is none, the name that was to be expected."""
    possible = candidates(base, below) if below else (base,)
    return next((name for name in possible if name in names), possible[0])


def _part(word: str) -> str:
    dotted = _DOTTED.fullmatch(word)
    if dotted and _is_letter(dotted["letter"]):
        return f"\\{dotted['dots']}{{{_part(dotted['letter'])}}}"
    if word.isdigit() or len(word) == 1:
        return word
    return _LETTERS.get(word) or _roman(word)


def _is_letter(word: str) -> bool:
    return len(word) == 1 or word in _LETTERS


def _roman(word: str) -> str:
    return "\\mathrm{" + word.replace("_", "\\_") + "}"
