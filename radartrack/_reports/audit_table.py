"""An audit as a table on the terminal, followed by what is wrong and what would be right."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from itertools import zip_longest
from textwrap import shorten, wrap
from typing import Any

from rich.cells import cell_len
from rich.console import Console
from rich.markup import escape
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from radartrack._reports import audit_text
from radartrack._system import terminal

STYLES = {
    "equal": "green",
    "equal_numerically": "green",
    "differs": "bold red",
    "wrong_dimensions": "bold red",
    "undecided": "yellow",
}
GAP = 2
INDENT = 4
NARROW = 56  # columns for quantity and reason below which they stand under the claim
MOST_LINES = 4  # of one cell; the whole of it is in the JSON and on the page
NAME_ENDS = re.compile(r"(?<=[./ (])|(?<=\*)(?!\*)")  # where a quantity may go on in the next line

Record = Mapping[str, Any]


def show(paper: Mapping[str, Any], console: Console) -> None:
    """Print the verdicts on one paper; what comes from its file is made harmless."""
    paper = terminal.shown(paper)
    records = paper["claims"]
    console.print(f"\n[bold]{escape(shorten(paper['paper'], console.width, placeholder=' …'))}[/bold]", highlight=False)
    for line in _lines(records, console.width):
        console.print(line, soft_wrap=True)
    for record in records:
        if record["verdict"] in audit_text.WRONG:
            _explain(record, console)
    console.print(f"\n{audit_text.summary(records)}", highlight=False)


def _lines(records: Sequence[Record], width: int) -> Iterator[Text]:
    """A row for each claim; where the terminal is narrow, quantity and reason stand under it."""
    claim = max(cell_len(text) for text in ["claim", *(record["id"] for record in records)])
    verdict = max(cell_len(audit_text.WORDS[record["verdict"]]) for record in records)
    widths = [claim, verdict]
    room = width - sum(widths) - GAP * 3
    if room < NARROW:
        for record in records:
            yield from _stacked(record, widths, width - INDENT)
        return
    longest = max(cell_len(record["quantity"]) for record in records)
    quantity = min(max(longest, len("quantity")), room // 2)
    widths += [quantity, room - quantity]
    yield Text((" " * GAP).join(_padded(["claim", "verdict", "quantity", "reason"], widths)).rstrip(), style="bold")
    for record in records:
        yield from _row(record, widths)


def _row(record: Record, widths: Sequence[int]) -> Iterator[Text]:
    words = audit_text.WORDS[record["verdict"]]
    cells = [[record["id"]], [words], _names(record["quantity"], widths[2]), _sentence(record["reason"], widths[3])]
    for place, parts in enumerate(zip_longest(*cells, fillvalue="")):
        line = Text((" " * GAP).join(_padded(parts, widths)).rstrip())
        if not place:
            start = widths[0] + GAP
            line.stylize(STYLES[record["verdict"]], start, start + len(words))
        yield line


def _stacked(record: Record, widths: Sequence[int], room: int) -> Iterator[Text]:
    words = audit_text.WORDS[record["verdict"]]
    yield Text.assemble(record["id"].ljust(widths[0] + GAP), (words, STYLES[record["verdict"]]))
    for text in (*_names(record["quantity"], room), *_sentence(record["reason"], room)):
        yield Text(" " * INDENT + text)


def _padded(parts: Sequence[str], widths: Sequence[int]) -> list[str]:
    return [part + " " * (width - cell_len(part)) for part, width in zip(parts, widths, strict=True)]


def _names(text: str, width: int) -> list[str]:
    """A quantity in lines that end where a name or an operation does."""
    lines: list[str] = []
    for part in NAME_ENDS.split(text) if text else ():
        if lines and cell_len(lines[-1] + part.rstrip()) <= width:
            lines[-1] += part
        else:
            lines += [part[at : at + width] for at in range(0, len(part), width)]
    return _few([line.rstrip() for line in lines], width)


def _sentence(text: str, width: int) -> list[str]:
    return _few(wrap(text, width, break_on_hyphens=False), width)


def _few(lines: list[str], width: int) -> list[str]:
    if len(lines) <= MOST_LINES:
        return lines
    return [*lines[: MOST_LINES - 1], lines[MOST_LINES - 1][: width - 2] + " …"]


def _explain(record: Record, console: Console) -> None:
    verdict = record["verdict"]
    heading = f"\n[{STYLES[verdict]}]{escape(record['id'])}[/] {audit_text.WORDS[verdict]}: {escape(record['reason'])}"
    console.print(heading, highlight=False)
    lines = [("printed", record["printed"]), ("derived", record["derived"]), *audit_text.explanation(record)]
    if record["note"]:
        lines.append(("note", record["note"]))
    details = Table(box=None, pad_edge=False, show_header=False)
    details.add_column(style="dim", no_wrap=True)
    details.add_column(overflow="fold")
    for name, text in lines:
        details.add_row(name, escape(text))
    console.print(Padding(details, (0, 0, 0, 2)), highlight=False)
