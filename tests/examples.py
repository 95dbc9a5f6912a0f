"""How many Hypothesis examples a costly property gets: a share of what the profile gives a cheap one."""

from hypothesis import Phase, settings


def share(fraction: float) -> settings:
    """A fraction of the profile's examples, at least one; no deadline, and no search for a simpler failure."""
    return settings(
        max_examples=max(1, round(settings().max_examples * fraction)),
        deadline=None,
        phases=(Phase.explicit, Phase.reuse, Phase.generate),
    )
