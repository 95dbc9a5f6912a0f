"""`radartrack find`: which quantity a formula is, whatever its letters are."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from importlib.resources import files
from types import MappingProxyType
from typing import TYPE_CHECKING, Annotated, Any, Literal, TypeAlias, TypeVar

import typer

from radartrack._system import terminal
from radartrack.commands.code_argument import code_argument
from radartrack.commands.model_file import ModelFile, declared, own_quantities
from radartrack.commands.seconds import seconds

if TYPE_CHECKING:
    from radartrack.derive.checking.papers.deadline import Decider
    from radartrack.derive.finding.formula_search import Candidate, FormulaSearch
    from radartrack.derive.formula.tree import Tree
    from radartrack.derive.language.quantity import Quantity

_T = TypeVar("_T")
Judged: TypeAlias = "tuple[Candidate, str, bool]"  # how a formula is a quantity, or near it, and whether it is
PROVED = 6  # candidates that are proved, of those that are worth the same
FOUND, ONLY_NEAR, UNREADABLE = 0, 1, 2


def find(
    formula: Annotated[str, typer.Argument(help="The printed formula, in any letters; arrays as nested lists.")],
    latex: Annotated[bool, typer.Option("--latex", help="The formula is LaTeX.")] = False,
    code: Annotated[
        Literal["python", "c", "cpp", "matlab"] | None,
        typer.Option(help="The formula is code, or FILE:function, or FILE:first-last."),
    ] = None,
    timeout: Annotated[
        float, typer.Option(help="Seconds after which a proof is given up.", min=0.1, callback=seconds)
    ] = 20.0,
    model: ModelFile = None,
) -> None:
    """Say which quantity a formula is, under which condition and in which convention.

    Exit 0 when it is one, 1 when one is only near or none is, 2 when it cannot be read.
    """
    from radartrack.derive.checking.papers.deadline import Decider
    from radartrack.derive.formula.error import FormulaError
    from radartrack.derive.reading.any_letters import possible_trees
    from radartrack.derive.reading.notation import LATEX, TEXT

    if latex and code:
        raise typer.BadParameter("a formula is LaTeX or code, not both", param_hint="--code")
    source, function = code_argument(formula) if code else (formula, "")
    try:
        trees = possible_trees(source, notation=code or (LATEX if latex else TEXT), function=function)
    except FormulaError as error:
        terminal.complain(str(error))
        raise typer.Exit(UNREADABLE) from None
    own, models = own_quantities(model).values(), declared(model)
    with Decider(timeout) as decider:
        decider.start()
        every = ((search_over(rows_until_found(own, tree)), tree) for tree in trees)
        looked_up = ((search, tree, _looked_up(search, tree, decider, models)) for search, tree in every)
        searched = list(_until(lambda one: _has_found(one[2]), looked_up))
    search, tree, judged = min(searched, key=lambda one: (not _has_found(one[2]), not one[2]))
    found = _has_found(judged)
    for candidate, words, is_found in judged:
        if is_found or not found:
            _tell(candidate, words)
    if not judged:
        _tell_what_is_near(search, tree)
    raise typer.Exit(FOUND if found else ONLY_NEAR)


def _has_found(judged: Iterable[Judged]) -> bool:
    return any(is_found for *_, is_found in judged)


def _until(is_last: Callable[[_T], bool], items: Iterable[_T]) -> Iterator[_T]:
    """The items up to the first of which this holds."""
    for item in items:
        yield item
        if is_last(item):
            return


def _looked_up(
    search: FormulaSearch, tree: Tree, decider: Decider, models: tuple[Mapping[str, Any], ...]
) -> list[Judged]:
    """What a formula is, or near; what is a quantity but for a slip is hardly another in other letters."""
    from radartrack.derive.checking.question.letters.elapsed_time import elapsed

    judged = list(_judged(search.candidates(tree), decider, models))
    if judged and not (elapsed([tree]) and not _has_found(judged)):
        return judged
    return _in_usual_letters(search, tree, decider) or judged


def _tell_what_is_near(search: FormulaSearch, tree: Tree) -> None:
    slipped = search.slipped(tree)
    for candidate in slipped:
        _tell(candidate, f"near: {candidate.slip}; perhaps meant: {candidate.formula}")
    near = [] if slipped else search.near(tree)
    for candidate in near:
        _tell(candidate, f"near: at most {candidate.difference * 100:.2g} % apart at three points")
    if not (slipped or near):
        terminal.complain("No quantity of the catalogue is this formula, nor near it.")


def _in_usual_letters(search: FormulaSearch, tree: Tree, decider: Decider) -> list[Judged]:
    """What a formula is with the letters that are usual for functions of symbols, or a factor understood."""
    from radartrack.derive.finding.usual_letters import usual_forms

    near: list[Judged] = []
    for usual in usual_forms(tree):
        narrow = search.among(usual.family) if usual.family else search
        said = [
            (replace(candidate, convention=f"{candidate.convention} with {usual.words}".strip()), words, is_found)
            for candidate, words, is_found in _judged(
                [one for one in narrow.candidates(usual.tree) if not usual.own & one.read.keys()], decider
            )
        ]
        if _has_found(said):
            return said
        near = near or said
    return near


def search_over(own: Mapping[str, Mapping[str, Any]] = MappingProxyType({})) -> FormulaSearch:
    """The search over rows of one's own, and the catalogue by the values that `radartrack regenerate` wrote."""
    from radartrack.derive.finding.formula_search import FormulaSearch

    text = files("radartrack.generated").joinpath("screening.json").read_text(encoding="utf-8")
    return FormulaSearch({**own, **json.loads(text)})


def rows_until_found(own: Iterable[Quantity], tree: Tree) -> dict[str, Mapping[str, Any]]:
    """The rows of quantities, up to the first that the formula may be: the later ones take the longest to derive."""
    from radartrack.derive.finding.formula_search import FormulaSearch, letters_of
    from radartrack.derive.finding.screening_values import row

    found: dict[str, Mapping[str, Any]] = {}
    for quantity in own:
        found[quantity.name] = one = row(quantity, letters_of(tree))
        if FormulaSearch({quantity.name: one}).candidates(tree):
            break
    return found


def proved(candidates: Sequence[Candidate], decider: Decider) -> Iterator[tuple[Candidate, str]]:
    """Those that a formula is proved to be, or is to many digits, and which of the two; perhaps in another convention.

    In which convention a formula is another quantity's is what a check of it says.
    """
    return ((candidate, words) for candidate, words, is_found in _judged(candidates, decider) if is_found)


def _judged(
    candidates: Sequence[Candidate], decider: Decider, models: tuple[Mapping[str, Any], ...] = ()
) -> Iterator[Judged]:
    """The same, and those that a formula is but for a slip that a check of it tells."""
    from radartrack.derive.checking.papers.claim import Claim, UnreadableClaim

    for candidate in candidates[:PROVED]:
        claim = Claim("formula", candidate.quantity, candidate.formula, given=candidate.given, let=candidate.let)
        try:
            record = decider.decide(claim, models)
        except UnreadableClaim:
            continue  # an entry that the quantity of today does not have
        if record["verdict"] in {"equal", "equal_numerically"}:
            yield candidate, "proved" if record["verdict"] == "equal" else record["reason"], True
        elif otherwise := next((one for one in record["remarks"] if one.startswith("equal ")), ""):
            words = " ".join(part for part in (candidate.convention, otherwise.removeprefix("equal ")) if part)
            yield replace(candidate, convention=words), "proved", True
        elif slips := [one for one in record["suggestions"] if one["entry"]]:
            meant = "; ".join(f"{one['entry']}: {one['formula']}" for one in slips)
            yield candidate, f"near: {record['reason']}; perhaps meant: {meant}", False


def _tell(candidate: Candidate, proof: str) -> None:
    conditions = [f"{name} = {value}" for name, value in candidate.given.items()]
    when = f" when {' and '.join(conditions)}" if conditions else ""
    convention = f" {candidate.convention}" if candidate.convention else ""
    read = ", ".join(f"{letter} for {symbol}" for letter, symbol in candidate.read.items())
    terminal.say(f"{candidate.quantity}{when}{convention}: {proof}" + (f", with {read}" if read else ""))
    terminal.say(f"    {candidate.meaning}")
