import json
import math
import time
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import asdict
from itertools import pairwise
from pathlib import Path

import pytest

from radartrack.derive.checking.papers import audit, deadline, worker
from radartrack.derive.checking.papers.claim import Claim, UnreadableClaim
from radartrack.derive.checking.papers.deadline import Decider, decide_all, undecided
from radartrack.derive.checking.question.world import World
from radartrack.derive.checking.reporting.verdict import Verdict
from tests.processes import python

AT_ONCE = 300.0  # seconds, of a machine that has much else to do; without the limits there is no end
RIGHT = Claim("a", "polar.map[0]", formula="r*cos(beta)")
HOSTILE = [
    "9**9**9**9",
    "(" * 10_000 + "r" + ")" * 10_000,
    "r+" * 500_000 + "r",
    "r\0",
    "σ_β",
    "sigma_bеta",
    "r.__class__",
    "__import__('os').system('true')",
    "1e400*r",
    "1/(r - r)",
    "[" * 200,
]


def test_a_claim_is_decided_in_a_child() -> None:
    with Decider(60) as decider:
        assert decider.decide(RIGHT)["verdict"] == "equal"


def _child(*lines: object, ends: bool) -> str:
    """What a child runs that gives these answers to its first request, and then ends or says nothing for an hour."""
    answers = "".join(f"print({json.dumps(line)!r}, flush=True); " for line in lines)
    rest = "" if ends else "time.sleep(3600)"
    return f"import sys, time; print('ready', flush=True); sys.stdin.readline(); {answers}{rest}"


def _decided_by(code: str, monkeypatch: pytest.MonkeyPatch, timeout: float = 60) -> dict[str, object]:
    with monkeypatch.context() as patch, Decider(timeout) as decider:
        patch.setattr(deadline, "COMMAND", (deadline.COMMAND[0], "-c", code))
        return decider.decide(RIGHT)


def test_the_time_limit_is_kept_and_the_next_claim_is_decided_all_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    with Decider(0.3) as decider:
        with monkeypatch.context() as patch:
            patch.setattr(deadline, "COMMAND", (deadline.COMMAND[0], "-c", _child(ends=False)))
            record = decider.decide(RIGHT)
        assert record["verdict"] == "undecided"
        assert record["reason"] == "cannot decide in 0.3 s"
        decider._timeout = 60
        assert decider.decide(RIGHT)["verdict"] == "equal"


def test_time_in_which_others_compute_is_not_a_childs(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(deadline, "processor_time", lambda _: 0.0)
    monkeypatch.setattr(deadline, "PATIENCE", math.inf)
    known = {**undecided(RIGHT, "not equal"), "verdict": "differs"}
    late = _child(known, deadline.DONE, ends=True).replace("readline(); ", "readline(); time.sleep(0.5); ")
    assert _decided_by(late, monkeypatch, timeout=0.1)["verdict"] == "differs"


def test_a_child_that_never_computes_is_ended_all_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(deadline, "processor_time", lambda _: 0.0)
    assert _decided_by(_child(ends=False), monkeypatch, timeout=0.1)["reason"] == "cannot decide in 0.1 s"


@pytest.mark.parametrize("ends", [False, True])
@pytest.mark.parametrize("told", [1, 2])
def test_a_verdict_that_is_known_is_told_though_the_child_hangs_or_dies_over_the_rest(
    ends: bool, told: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    known = {**undecided(RIGHT, "not equal"), "verdict": "differs", "remarks": ["equal when rho = 0"]}
    record = _decided_by(_child(*[{"reason": "early"}, known][-told:], ends=ends), monkeypatch, timeout=0.3)
    assert record == {**known, "remarks": ["equal when rho = 0", deadline.UNFINISHED]}


def test_what_is_said_beside_a_verdict_has_a_time_of_its_own(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(deadline, "EXPLANATION", 0.2)
    known = {**undecided(RIGHT, "not equal"), "verdict": "differs"}
    record = _decided_by(_child(known, ends=False), monkeypatch, timeout=3600)
    assert record["verdict"] == "differs"


@pytest.mark.parametrize("formula", ["r*cos(beta)", "r*sin(beta)", "r*cos(beta)*sin(beta)**2/(1 - cos(beta)**2)"])
def test_each_answer_of_a_child_says_what_the_one_before_it_says_and_more(formula: str) -> None:
    request = {"claim": asdict(Claim("a", "polar.map[0]", formula=formula)), "typeset": True, "world": 0}
    *answers, last = worker._answers(request, worker.Worlds())
    assert last == deadline.DONE
    assert len({answer["verdict"] for answer in answers}) == 1
    for before, after in pairwise(answers):
        assert all(after[name] for name in before if before[name])


def test_what_fails_before_a_verdict_is_known_is_undecided_with_a_word(monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(_: Claim, __: World) -> None:
        raise KeyError("cot")

    monkeypatch.setattr(audit, "decisions", fail)
    told, last = worker._answers({"claim": asdict(RIGHT), "typeset": False, "world": 0}, worker.Worlds())
    assert told == {"undecided": "this cannot be worked out: KeyError"}
    assert last == deadline.DONE


def test_what_fails_after_a_verdict_is_known_does_not_undo_it(monkeypatch: pytest.MonkeyPatch) -> None:
    verdict = audit.decide(RIGHT)

    def fail(_: Claim, __: World) -> Iterator[Verdict]:
        yield verdict
        raise MemoryError

    monkeypatch.setattr(audit, "decisions", fail)
    request = {"claim": asdict(RIGHT), "typeset": True, "world": 0}
    answers = worker._answers(request, worker.Worlds())
    assert [answer.get("verdict") for answer in answers] == ["equal", "equal", None]


@pytest.mark.parametrize("timeout", [math.inf, 1e12])
def test_any_number_of_seconds_may_be_given(timeout: float) -> None:
    with Decider(timeout) as decider:
        assert decider.decide(RIGHT)["verdict"] == "equal"


@pytest.mark.parametrize("timeout", [math.nan, 0, -1])
def test_what_is_no_time_is_refused(timeout: float) -> None:
    with pytest.raises(ValueError, match="timeout"):
        Decider(timeout)


def largest_child(call: str) -> int:
    """The most memory, in kB, of the processes that a call starts; a child of a large process begins as large."""
    measured = "print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)"
    code = f"import resource; from {__name__} import *; {call}; {measured}"
    done = python(code, environment={"PYTHONPATH": str(Path(__file__).parents[4])})
    assert done.returncode == 0, done.stderr
    return int(done.stdout)


def refuse_all_that_is_hostile() -> None:
    with Decider(60) as decider:
        decider.decide(RIGHT)
        for formula in HOSTILE:
            start = time.monotonic()
            with pytest.raises(UnreadableClaim):
                decider.decide(Claim("c", "polar.map[0]", formula=formula))
            assert time.monotonic() - start < AT_ONCE


def test_hostile_formulas_are_refused_at_once_and_in_little_memory() -> None:
    assert largest_child("refuse_all_that_is_hostile()") < 500 * 1024


LONG = {
    "powers of sums": "+".join(f"(r + {n}*beta)**64" for n in range(3_000)),
    "roots": "+".join(f"sqrt(r**2 + {n}*sigma_beta**2)" for n in range(1, 2_500)),
    "exponentials": "*".join(f"(1 + exp(-{n}*beta**2))" for n in range(250)),
}


def decide_in_a_second(name: str) -> None:
    formula = LONG[name]
    with Decider(60) as decider:
        decider.decide(RIGHT)
        decider._timeout = 1
        start = time.monotonic()
        with suppress(UnreadableClaim):  # where the numbers turn out to be too large before the time is over
            decider.decide(Claim("e", "polar.covariance.linear[0,0]", formula=formula))
        assert time.monotonic() - start < AT_ONCE


@pytest.mark.parametrize("name", LONG)
def test_a_long_formula_within_the_limits_takes_no_more_time_and_memory_than_it_is_given(name: str) -> None:
    assert largest_child(f"decide_in_a_second({name!r})") < 500 * 1024


def test_a_child_that_dies_is_no_verdict(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(deadline, "COMMAND", (deadline.COMMAND[0], "-c", "print('ready')"))
    with Decider(60) as decider:
        record = decider.decide(RIGHT)
    assert record["verdict"] == "undecided"


def test_many_claims_keep_their_order_and_errors_stand_in_their_place() -> None:
    unreadable = Claim("d", "polar.map[0]", formula="r +")
    steps: list[int] = []
    answers = decide_all([RIGHT, unreadable, RIGHT], 60, 2, lambda: steps.append(1))
    assert [answer["id"] if isinstance(answer, dict) else "error" for answer in answers] == ["a", "error", "a"]
    assert len(steps) == 3
