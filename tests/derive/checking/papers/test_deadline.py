import resource
import time
from contextlib import suppress

import pytest

from radartrack.derive.checking.papers import deadline
from radartrack.derive.checking.papers.claims_file import Claim, UnreadableClaim
from radartrack.derive.checking.papers.deadline import Decider, decide_all

RIGHT = Claim("a", "polar.map[0]", formula="r*cos(beta)")
# Each is small on paper and could be large in algebra.
SLOW = Claim(
    "b",
    "polar.covariance.linear[0,0]",
    formula="r**2*sigma_beta**2*("
    + "+".join(f"(sin(beta) + cos({n}*beta) + exp(sigma_beta**2) + rho)**50" for n in range(2, 9))
    + ")",
)
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


def test_the_time_limit_is_kept_and_the_next_claim_is_decided_all_the_same() -> None:
    with Decider(60) as decider:
        decider.decide(RIGHT)
        decider._timeout = 0.3
        start = time.monotonic()
        record = decider.decide(SLOW)
        assert time.monotonic() - start < 3
        assert record["verdict"] == "undecided"
        assert record["reason"] == "cannot decide in 0.3 s"
        decider._timeout = 60
        assert decider.decide(RIGHT)["verdict"] == "equal"


def test_hostile_formulas_are_refused_at_once_and_in_little_memory() -> None:
    with Decider(60) as decider:
        decider.decide(RIGHT)
        for formula in HOSTILE:
            start = time.monotonic()
            with pytest.raises(UnreadableClaim):
                decider.decide(Claim("c", "polar.map[0]", formula=formula))
            assert time.monotonic() - start < 5
    assert resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss < 500 * 1024


LONG = {
    "powers of sums": "+".join(f"(r + {n}*beta)**64" for n in range(3_000)),
    "roots": "+".join(f"sqrt(r**2 + {n}*sigma_beta**2)" for n in range(1, 2_500)),
    "exponentials": "*".join(f"(1 + exp(-{n}*beta**2))" for n in range(250)),
}


@pytest.mark.parametrize("formula", LONG.values(), ids=LONG.keys())
def test_a_long_formula_within_the_limits_takes_no_more_time_and_memory_than_it_is_given(formula: str) -> None:
    with Decider(60) as decider:
        decider.decide(RIGHT)
        decider._timeout = 1
        start = time.monotonic()
        with suppress(UnreadableClaim):  # where the numbers turn out to be too large before the time is over
            decider.decide(Claim("e", "polar.covariance.linear[0,0]", formula=formula))
        assert time.monotonic() - start < 4
    assert resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss < 500 * 1024


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
