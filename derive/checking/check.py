"""Compares a printed formula with the derived one and says what it found."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from radartrack.derive.checking.asking import ask
from radartrack.derive.checking.question.declared_world import having_models
from radartrack.derive.checking.question.world import CATALOGUE, World
from radartrack.derive.checking.reporting.verdict import Outcome, Verdict
from radartrack.derive.language.model import Model
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.verbs.no_closed_form import NoClosedForm


def check(
    quantity: str | Quantity,
    formula: str,
    *,
    latex: bool = False,
    code: str = "",
    function: str = "",
    given: Mapping[str, str] | None = None,
    let: Mapping[str, str] | None = None,
    models: Iterable[Model] = (),
    world: World = CATALOGUE,
) -> Verdict:
    """Compare a printed formula with what was derived.

    Args:
        quantity: one of the catalogue or of a model of one's own, `polar.covariance.linear`; one entry of it,
            `polar.covariance.linear[0,1]`; a slice, `polar.hessian[:,0,1]`; or an expression over several. A quantity
            itself, in place of its name, is compared whole.
        formula: as typed, or as printed in LaTeX; vectors and matrices as nested lists.
        latex: whether it is LaTeX.
        code: the language, where it is code: python, c, cpp or matlab.
        function: of code, the function that is meant.
        given: conditions under which to compare, `{"rho": "0"}`.
        let: the paper's own names, `{"D_beta": "sigma_beta**2"}`.
        models: of one's own, whose quantities may be named.
        world: quantities, letters, definitions and conditions of a paper.

    Raises:
        UnknownQuantity: for a name that neither the catalogue nor a model has.
        TableError: for a model with a name of the catalogue's, and two of one name.
        UnknownEntry: for an entry that the quantity does not have.
        FormulaError: when the formula, a condition or a definition cannot be read.
    """
    world = having_models(models, world)
    try:
        question = ask(quantity, formula, latex=latex, code=code, function=function, given=given, let=let, world=world)
        *_, verdict = question.answers()
    except NoClosedForm as error:
        return too_much(quantity if isinstance(quantity, str) else quantity.name, formula, error)
    return verdict


def too_much(quantity: str, printed: str, error: NoClosedForm) -> Verdict:
    """That nothing can be decided, and the part that was too much."""
    return Verdict(Outcome.UNDECIDED, quantity, printed, "", f"cannot decide: {error}")
