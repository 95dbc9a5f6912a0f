"""One computation as a C99 function, in double and single precision, for one point and for many."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from hashlib import sha256
from math import prod

from radartrack.derive import symbolic as sp
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.stable_form import StableForm
from radartrack.derive.language.tensor import Index, indices
from radartrack.derive.symbolic import Expr
from radartrack.derive.writing.c99.c_expression import PREFIX, CExpression
from radartrack.derive.writing.computed_statements import Statements, first_or_known, statements_of
from radartrack.derive.writing.numpy_writer import INDENT, WIDTH

RESULT = "result"
COUNT, PLACE = "n", "i"  # of the points of a batch
SINGLE = "f"  # behind the names of functions in single precision
BATCH = "_n"
WORDS = """
    auto break case char const continue default do double else enum extern float for goto if inline int long register
    restrict return short signed sizeof static struct switch typedef union unsigned void volatile while
    alignas alignof and and_eq asm bitand bitor bool catch char16_t char32_t char8_t class co_await co_return co_yield
    compl concept consteval constexpr constinit const_cast decltype delete dynamic_cast explicit export false friend
    mutable namespace new noexcept not not_eq nullptr operator or or_eq private protected public reinterpret_cast
    requires static_assert static_cast template this thread_local throw true try typeid typename using virtual wchar_t
    xor xor_eq
    EOF HUGE_VAL HUGE_VALF HUGE_VALL I INFINITY NAN NULL assert errno linux math_errhandling offsetof unix
"""  # of C99 and C++20, and what headers may define
TAKEN = frozenset([*WORDS.split(), RESULT, "mean", "covariance", COUNT, PLACE])


@dataclass(frozen=True)
class Output:
    """An array that a function fills.

    Attributes:
        name: of the argument.
        shape: of the tensor, which is filled in row-major order.
        is_flat: whether it has one index; else, to be read, as many as the tensor.
    """

    name: str
    shape: Index
    is_flat: bool = True

    @property
    def declared(self) -> str:
        """As an argument."""
        return f"{self.name}[{self.size}]" if self.is_flat else self._at(self.shape)

    @property
    def places(self) -> list[str]:
        """Its elements in order."""
        return [self._at((n,) if self.is_flat else index) for n, index in enumerate(indices(self.shape))]

    def _at(self, index: Index) -> str:
        return self.name + "".join(f"[{i}]" for i in index)

    @property
    def size(self) -> int:
        """How many numbers it holds."""
        return prod(self.shape)


@dataclass(frozen=True)
class CFunction:
    """A function, written; what stands in comments is not a part of it.

    Attributes:
        name: in double precision, for one point.
        arguments: their names.
        outputs: the arrays that it fills; none where it returns a number.
        bodies: the statements in double and in single precision.
    """

    name: str
    arguments: tuple[str, ...]
    outputs: tuple[Output, ...]
    bodies: tuple[str, str]

    @property
    def names(self) -> list[str]:
        """All that is defined: in two precisions, for one and for many."""
        kinds = ("", BATCH) if self.arguments else ("",)
        return [f"{self.name}{kind}{suffix}" for kind in kinds for suffix in ("", SINGLE)]

    @property
    def size(self) -> int:
        """How many numbers it computes."""
        return sum(one.size for one in self.outputs) or 1

    @cached_property
    def digest(self) -> str:
        """What identifies the code."""
        return sha256("".join([self.name, *self.arguments, *self.bodies]).encode()).hexdigest()

    def text(self, comment: str) -> str:
        """The definitions under a comment."""
        double, single = (self.for_one(suffix) for suffix in ("", SINGLE))
        written = [f"{in_comment(comment)}\n{double}", f"/* {self.name} in single precision */\n{single}"]
        if self.arguments:
            filled = " and ".join(f"{one.name}[{COUNT} * {one.size}]" for one in self.outputs) or f"{RESULT}[{COUNT}]"
            said = f"{self.name} at {COUNT} points: arguments [{COUNT}], {filled}, one point after the other"
            written += [
                f"/* {said} */\n{self._for_many('')}",
                f"/* the same in single precision */\n{self._for_many(SINGLE)}",
            ]
        return "\n".join(written)

    def for_one(self, suffix: str) -> str:
        """The definition in one precision, for one point."""
        real = real_of(suffix)
        given = [f"{real} {name}" for name in self.arguments]
        filled = [f"{real} {one.declared}" for one in self.outputs]
        kind = "void" if self.outputs else real
        signature = _signature(kind, f"{self.name}{suffix}", [*given, *filled])
        return f"{signature}\n{{\n{textwrap.indent(self.bodies[bool(suffix)], INDENT)}\n}}\n"

    def _for_many(self, suffix: str) -> str:
        real = real_of(suffix)
        names = [one.name for one in self.outputs] or [RESULT]
        given = [f"const {real} *{name}" for name in self.arguments]
        filled = [f"{real} *RADARTRACK_RESTRICT {name}" for name in names]
        signature = _signature("void", f"{self.name}{BATCH}{suffix}", [f"size_t {COUNT}", *given, *filled])
        at = [f"{name}[{PLACE}]" for name in self.arguments]
        to = [f"{one.name} + {one.size}u * {PLACE}" for one in self.outputs]
        called = f"{self.name}{suffix}({', '.join([*at, *to])});"
        inside = called if self.outputs else f"{RESULT}[{PLACE}] = {called}"
        loop = f"size_t {PLACE};\nfor ({PLACE} = 0; {PLACE} < {COUNT}; ++{PLACE})\n{INDENT}{inside}"
        return f"{signature}\n{{\n{textwrap.indent(loop, INDENT)}\n}}\n"


def of_quantity(quantity: Quantity, form: StableForm) -> CFunction:
    """The function of a quantity as it is rewritten."""
    outputs = (Output(RESULT, quantity.shape),) if quantity.shape else ()
    symbols = [symbol.name for symbol in quantity.symbols]
    name = f"{PREFIX}{quantity.module}_{quantity.function}"
    return function(name, symbols, outputs, statements_of(quantity, form))


def function(name: str, symbols: Sequence[str], outputs: Sequence[Output], statements: Statements) -> CFunction:
    """Statements as a function of symbols; names that C or C++ has for something else get an underscore."""
    names = _free_names([*symbols, *(definition for definition, _ in statements.definitions)])
    arguments = tuple(names[symbol] for symbol in symbols)
    double, single = (
        "\n".join(body(statements, arguments, outputs, CExpression(suffix, names=names))) for suffix in ("", SINGLE)
    )
    return CFunction(name, arguments, tuple(outputs), (double, single))


def body(
    statements: Statements, arguments: Sequence[str], outputs: Sequence[Output], language: CExpression
) -> Iterator[str]:
    """The lines: what is not used, intermediates, results."""
    used = {
        language.names.get(symbol.name, symbol.name)
        for expression in [*(value for _, value in statements.definitions), *statements.results]
        for symbol in expression.free_symbols
    }
    yield from (f"(void){name};" for name in arguments if name not in used)
    named = [(language.names.get(name, name), value) for name, value in statements.definitions]
    for target, value in first_or_known(named):
        yield _assignment(f"const {language.real} {target} =", value, language)
    if not outputs:
        yield _assignment("return", statements.results[0], language)
        return
    places = [place for one in outputs for place in one.places]
    for target, value in first_or_known(zip(places, statements.results, strict=True)):
        yield _assignment(f"{target} =", value, language)


def listing(statements: Statements, symbols: Iterable[str], name: str, shape: Index, language: CExpression) -> str:
    """A function in double precision, to be read."""
    names = _free_names([*symbols, *(definition for definition, _ in statements.definitions)])
    arguments = tuple(names[symbol] for symbol in symbols)
    outputs = (Output(RESULT, shape, is_flat=False),) if shape else ()
    lines = "\n".join(body(statements, arguments, outputs, replace(language, names=names)))
    return CFunction(name, arguments, outputs, (lines, "")).for_one("")


def in_comment(text: str) -> str:
    """As a comment that nothing in it ends."""
    safe = text.replace("*/", "* /").replace("/*", "/ *").replace("??/", "?? /")
    return "/*\n" + "".join(f" * {line}".rstrip() + "\n" for line in safe.splitlines()) + " */"


def real_of(suffix: str) -> str:
    """The type of a precision."""
    return "float" if suffix else "double"


def _free_names(names: Iterable[str]) -> Mapping[str, str]:
    """Each name as C can have it, all different."""
    names = list(names)
    known = set(names)
    found: dict[str, str] = {}
    for name in names:
        free = name
        while free in TAKEN or free.startswith(PREFIX) or (free != name and free in known):
            free = f"{free}_" if not free.startswith(PREFIX) else f"of_{free}"
        known.add(free)
        found[name] = free
    return found


def _signature(kind: str, name: str, arguments: Sequence[str]) -> str:
    line = f"static inline {kind} {name}({', '.join(arguments) or 'void'})"
    if len(line) <= WIDTH:
        return line
    inside = textwrap.fill(", ".join(arguments), WIDTH - 4, break_long_words=False, break_on_hyphens=False)
    return f"static inline {kind} {name}(\n{textwrap.indent(inside, INDENT)})"


def _assignment(target: str, value: Expr | str, language: CExpression) -> str:
    line = f"{target} {value if isinstance(value, str) else language.code(value)};"
    if len(line) + len(INDENT) <= WIDTH or not isinstance(value, sp.Add):
        return line
    return f"{target}\n" + "\n".join(f"{INDENT}{term}" for term in language.terms(value)) + ";"
