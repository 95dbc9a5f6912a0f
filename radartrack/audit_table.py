"""An audit as a table on the terminal, followed by what is wrong and what would be right."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from typing import Any

from rich.console import Console
from rich.markup import escape
from rich.padding import Padding
from rich.table import Table

from radartrack import audit_text

STYLES = {
    "equal": "green",
    "equal_numerically": "green",
    "differs": "bold red",
    "wrong_dimensions": "bold red",
    "undecided": "yellow",
}


def show(paper: Mapping[str, Any], console: Console) -> None:
    """Print the verdicts on one paper."""
    console.print(f"\n[bold]{escape(paper['paper'])}[/bold]", highlight=False)
    table = Table(box=None, pad_edge=False)
    table.add_column("claim", no_wrap=True)
    table.add_column("verdict", no_wrap=True)
    table.add_column("quantity", overflow="fold", ratio=1)
    table.add_column("reason", overflow="fold", ratio=1)
    for record in paper["claims"]:
        verdict = record["verdict"]
        words = f"[{STYLES[verdict]}]{audit_text.WORDS[verdict]}[/]"
        table.add_row(*map(escape, (record["id"],)), words, *map(escape, (record["quantity"], record["reason"])))
    console.print(table, highlight=False)
    for record in paper["claims"]:
        if record["verdict"] in audit_text.WRONG:
            _explain(record, console)
    console.print(_summary(paper["claims"]), highlight=False)


def _explain(record: Mapping[str, Any], console: Console) -> None:
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


def _summary(records: list[Mapping[str, Any]]) -> str:
    counts = Counter(audit_text.WORDS[record["verdict"]] for record in records)
    return f"\n{len(records)} claims: " + ", ".join(f"{count} {words}" for words, count in counts.items())
