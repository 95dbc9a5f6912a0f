"""What was found out about a function, as data and in words."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any

FEW_ULP = 64.0
CHANGING = "not deterministic"  # how what is said of a function begins that does not give the same twice
WRAP = 3  # sentences of one kind that are shown
LONG = 300  # characters of a formula that is shown


@dataclass(frozen=True)
class Worst:
    """Where a function is farthest from the exact value.

    Attributes:
        entry: its index, () for a number.
        point: symbol → value.
        found: what the function returns there.
        exact: the exact value, rounded.
    """

    entry: tuple[int, ...]
    point: Mapping[str, float]
    found: float
    exact: float


@dataclass(frozen=True)
class LostDigits:
    """Where cancellation eats digits.

    Attributes:
        digits: how many of the sixteen (or seven) decimal digits are lost at worst.
        where: when, in words.
        why: what cancels, in words; empty where that is not known.
        instead: what to call; empty for a model of one's own, whose code is the user's.
    """

    digits: int
    where: str
    why: str
    instead: str

    def __str__(self) -> str:
        because = f": {self.why}" if self.why else ""
        kept = f"; {self.instead} keeps them" if self.instead else ""
        return f"it loses {self.digits} digits {self.where}{because}{kept}"


@dataclass(frozen=True)
class Slip:
    """One edit of the derived formula under which the function is reproduced.

    Attributes:
        entries: the entries that have it.
        edit: what the function has, in words: "x for y".
        formula: what the function computes there; empty where the edit alone says it.
        derived: what is derived.
        cost: the higher, the less likely.
    """

    entries: tuple[tuple[int, ...], ...]
    edit: str
    formula: str
    derived: str
    cost: float

    def __str__(self) -> str:
        return f"{place(*self.entries)}{self.edit}"


@dataclass(frozen=True)
class Diagnosis:
    """What a function is, beside a derived quantity.

    Attributes:
        quantity: with what it was compared.
        agrees: whether it is that quantity, as it was asked for, up to rounding.
        ulp: its largest error in units of the last place (of single precision where it returns that) over the domain;
            None where it is not the quantity in any convention.
        worst: where that is; of a function that is wrong, where it differs clearly.
        lost_digits: where cancellation eats digits of a right function.
        convention: in which convention, or as which other quantity, it is right but for slips; empty as asked for.
        slip: the edits of the derived formula under which the function is reproduced; empty without any.
        slips: the same as data.
        differences: where nothing explains it: which entries differ, and on what that depends.
        undefined: where it raises, is infinite, undefined or complex, or returns another shape.
        remarks: what else there is to say: how it was called, what was taken as zero.
        arguments: for each parameter, the symbol or symbols that it takes.
    """

    quantity: str
    agrees: bool
    ulp: float | None = None
    worst: Worst | None = None
    lost_digits: LostDigits | None = None
    convention: str = ""
    slip: str = ""
    slips: tuple[Slip, ...] = ()
    differences: tuple[str, ...] = ()
    undefined: tuple[str, ...] = ()
    remarks: tuple[str, ...] = ()
    arguments: tuple[str, ...] = ()

    @property
    def verdict(self) -> str:
        """In one word: agrees, loses_digits, convention, slip, undefined or differs."""
        if self.agrees:
            return "loses_digits" if self.lost_digits else "agrees"
        if self.slip:
            return "slip"
        if self.differences:
            return "differs"
        return "undefined" if self.undefined else "convention"

    @property
    def record(self) -> dict[str, Any]:
        """For machines."""
        return {"verdict": self.verdict, **asdict(self)}

    def __str__(self) -> str:
        return "\n".join(self._lines())

    def _lines(self) -> list[str]:
        lines = [self._headline()]
        lines += [
            f"  the function computes {slip.formula}\n  derived is           {slip.derived}" for slip in self._shown
        ]
        lines += [f"  {difference}" for difference in self.differences]
        if self.lost_digits is not None:
            lines.append(f"  {self.lost_digits}")
        if self.worst is not None:
            lines.append(f"  {self._worst()}")
        lines += [f"  {one}" for one in (*self.undefined, *self.remarks)]
        if self.arguments:
            lines.append(f"  called with {', '.join(self.arguments)}")
        return lines

    @property
    def _shown(self) -> tuple[Slip, ...]:
        """Those whose formulas a reader takes in."""
        return tuple(slip for slip in self.slips[:WRAP] if 0 < max(len(slip.formula), len(slip.derived)) <= LONG)

    def _headline(self) -> str:
        convention = f" with {self.convention}" if self.convention else ""
        if self.convention.startswith("this is "):
            convention = f": {self.convention}"
        match self.verdict:
            case "agrees":
                return f"This is {self.quantity}, to {self.ulp:.3g} ulp."
            case "loses_digits":
                return f"This is {self.quantity}, but it loses digits."
            case "convention":
                found = convention if convention.startswith(":") else f"; it is{convention}"
                exactly = "" if self.ulp is None or self.lost_digits else f", to {self.ulp:.3g} ulp"
                return f"This is not {self.quantity} as asked for{found}{exactly}."
            case "slip":
                beside = f" (read{convention.replace(': this is', ' as')})" if convention else ""
                return f"This is {self.quantity} but for a slip{beside}: {self.slip}."
            case "undefined" if all(one.startswith(CHANGING) for one in self.undefined):
                return f"This is {self.quantity}{convention}, but not deterministic."
            case "undefined":
                return f"This is {self.quantity}{convention} where it has a value, but not everywhere."
            case _:
                return f"This is not {self.quantity}{convention}."

    def _worst(self) -> str:
        assert self.worst is not None  # noqa: S101 - asked by the caller
        one = self.worst
        at = ", ".join(f"{name} = {value:.6g}" for name, value in one.point.items())
        which = "for example" if self.slip or self.differences else "worst"
        return f"{which} at {at}: {place(one.entry)}{one.found!r}, exact {one.exact!r}"


def place(*entries: tuple[int, ...]) -> str:
    """`entry [2, 0]: `, nothing for a number."""
    named = [f"[{', '.join(map(str, entry))}]" for entry in entries if entry]
    if not named:
        return ""
    listed = named[0] if len(named) == 1 else f"{', '.join(named[:-1])} and {named[-1]}"
    return f"{'entry' if len(named) == 1 else 'entries'} {listed}: "
