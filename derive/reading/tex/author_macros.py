r"""Commands that an author defines, `\newcommand{\sq}[1]{#1^{2}}`, put in where they are used, as TeX would.

They are text for text and nothing is run; how often, and how long the result, is bounded.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

from radartrack.derive.formula.error import FormulaError

MOST_USES = 2_000  # of one text
LONGEST = 200_000  # characters of a text with its commands put in
MOST_MACROS = 500
DEEPEST = 100  # braces in braces

_DEFINED = re.compile(
    r"\\(?:(?:re)?newcommand|providecommand|DeclareRobustCommand)\s*\*?\s*\{?\s*\\(?P<new>[A-Za-z]+)\s*\}?\s*"
    r"(?:\[(?P<count>[0-9])\])?\s*(?:\[(?P<default>[^\[\]]*)\])?\s*(?=\{)"
    r"|\\def\s*\\(?P<plain>[A-Za-z]+)\s*(?P<parameters>(?:\#[1-9]\s*)*)(?=\{)"
    r"|\\DeclareMathOperator\s*\*?\s*\{?\s*\\(?P<operator>[A-Za-z]+)\s*\}?\s*(?=\{)"
)
_COMMAND = re.compile(r"\\([A-Za-z]+)\s*")
_PARAMETER = re.compile(r"#([1-9])")


@dataclass(frozen=True, slots=True)
class Macro:
    """A command of an author.

    Attributes:
        body: what it stands for, with #1, #2, … for its arguments.
        count: how many arguments it takes.
        default: of the first, where that may be left out.
    """

    body: str
    count: int = 0
    default: str | None = None


NO_MACROS: Mapping[str, Macro] = MappingProxyType({})


def defined_macros(source: str) -> tuple[dict[str, Macro], str]:
    """The commands that a source defines, and the source without their definitions, each place as it was."""
    found: dict[str, Macro] = {}
    kept: list[str] = []
    end = 0
    for definition in _DEFINED.finditer(source):
        if definition.start() < end or len(found) == MOST_MACROS:
            continue
        body, after = _group(source, definition.end())
        if after <= definition.end():
            continue
        if name := definition["operator"]:
            found[name] = Macro(f"\\operatorname{{{body}}}")
        elif name := definition["plain"]:
            found[name] = Macro(body, definition["parameters"].count("#"))
        else:
            found[definition["new"]] = Macro(body, int(definition["count"] or 0), definition["default"])
        kept += [source[end : definition.start()], " " * (after - definition.start())]
        end = after
    return found, "".join([*kept, source[end:]])


def expanded(source: str, macros: Mapping[str, Macro]) -> str:
    """The source with the commands put in, and those in what they stand for.

    Raises:
        FormulaError: for a command that stands for itself, or more text than is read.
    """
    if not macros:
        return source
    done: list[str] = []
    waiting = source
    uses = 0
    while found := next((one for one in _COMMAND.finditer(waiting) if one[1] in macros), None):
        uses += 1
        if uses > MOST_USES or len(waiting) > LONGEST:
            raise FormulaError(f"\\{found[1]} stands for itself, or for more than is read")
        macro = macros[found[1]]
        arguments, after = _arguments(waiting, found.end(), macro)
        body = _PARAMETER.sub(lambda place, given=arguments: _argument(given, place), macro.body)  # type: ignore[misc]
        done.append(waiting[: found.start()])
        waiting = f"{body} {waiting[after:]}"
    return "".join([*done, waiting])


def _argument(arguments: list[str], place: re.Match[str]) -> str:
    number = int(place[1])
    return arguments[number - 1] if number <= len(arguments) else ""


def _arguments(text: str, start: int, macro: Macro) -> tuple[list[str], int]:
    """What a command is given, and where that ends."""
    found: list[str] = []
    if macro.default is not None:
        own = re.compile(r"\s*\[([^\[\]]*)\]").match(text, start)
        found.append(own[1] if own else macro.default)
        start = own.end() if own else start
    while len(found) < macro.count:
        given, start = _group(text, start)
        found.append(given)
    return found, start


def _group(text: str, start: int) -> tuple[str, int]:
    """What stands in the braces that open there, or the one sign or command, and where that ends."""
    while start < len(text) and text[start].isspace():
        start += 1
    if not text.startswith("{", start):
        command = _COMMAND.match(text, start)
        end = command.end() if command else min(start + 1, len(text))
        return text[start:end].strip(), end
    depth = 0
    for at in range(start, len(text)):
        escaped = at > 0 and text[at - 1] == "\\"
        depth += (text[at] == "{" and not escaped) - (text[at] == "}" and not escaped)
        if not depth:
            return text[start + 1 : at], at + 1
        if depth > DEEPEST:
            break
    return "", start
