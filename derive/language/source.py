"""Where a formula stands in print."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Source:
    """A work and a place in it, and further works that print the same.

    Attributes:
        author: the authors, as they are cited.
        year: of publication, where it is known.
        where: the equation, section or keyword.
        doi: of the work, where it has one.
        also: further sources of the same formula.
    """

    author: str
    year: int | None
    where: str = ""
    doi: str = ""
    also: tuple[Source, ...] = ()

    def __str__(self) -> str:
        own = " ".join(part for part in (self.author, str(self.year or ""), self.where) if part)
        return "; ".join([own, *map(str, self.also)])

    @property
    def dois(self) -> tuple[str, ...]:
        """Of all works that have one, each once."""
        found = [source.doi for source in (self, *self.also) if source.doi]
        return tuple(dict.fromkeys(found))

    @property
    def reference(self) -> str:
        """The source with its DOIs: `Lerro & Bar-Shalom 1993, doi:10.1109/7.220948`."""
        return ", ".join([str(self), *(f"doi:{doi}" for doi in self.dois)])
