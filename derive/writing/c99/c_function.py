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
START, SOME = "start", "count"  # of those whose sines are computed at once
SINGLE = "f"  # behind the names of functions in single precision
BATCH = "_n"
INSIDE = "_at"  # what takes the sines of angles from whoever has computed them
AT_ONCE = 64  # plots of a batch whose sines are computed before the rest
WORDS = """
    auto break case char const continue default do double else enum extern float for goto if inline int long register
    restrict return short signed sizeof static struct switch typedef union unsigned void volatile while
    alignas alignof and and_eq asm bitand bitor bool catch char16_t char32_t char8_t class co_await co_return co_yield
    compl concept consteval constexpr constinit const_cast decltype delete dynamic_cast explicit export false friend
    mutable namespace new noexcept not not_eq nullptr operator or or_eq private protected public reinterpret_cast
    requires static_assert static_cast template this thread_local throw true try typeid typename using virtual wchar_t
    xor xor_eq
    EOF HUGE_VAL HUGE_VALF HUGE_VALL I INFINITY MAXFLOAT NAN NULL SNAN SNANF SNANL assert errno linux math_errhandling
    offsetof unix
"""  # of C99 and C++20, and what headers may define
OTHERS = (PREFIX, "FP_", "MATH_", "M_")  # beginnings of what these headers and math.h define
TAKEN = frozenset([*WORDS.split(), RESULT, "mean", "covariance", COUNT, PLACE, START, SOME])


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
        angles: arguments of which they take sine and cosine, and what they call these.
    """

    name: str
    arguments: tuple[str, ...]
    outputs: tuple[Output, ...]
    bodies: tuple[str, str]
    angles: tuple[tuple[str, str, str], ...] = ()

    @property
    def names(self) -> list[str]:
        """All that is defined: in two precisions, for one and for many."""
        kinds = ("", *((BATCH,) if self.arguments else ()), *((INSIDE,) if self.angles else ()))
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
        kind, body = "void" if self.outputs else real, self.bodies[bool(suffix)]
        if not self.angles:
            return _definition(_signature(f"static inline {kind}", f"{self.name}{suffix}", [*given, *filled]), body)
        sines = [f"{real} {name}" for _, *names in self.angles for name in names]
        inside = _signature(f"RADARTRACK_INLINE {kind}", f"{self.name}{INSIDE}{suffix}", [*given, *sines, *filled])
        passed = [*self.arguments, *self._sines, *(one.name for one in self.outputs)]
        called = f"{self.name}{INSIDE}{suffix}({', '.join(passed)});"
        lines = [
            f"{real} {', '.join(self._sines)};",
            *(f"{PREFIX}sin_and_cos{suffix}({angle}, &{sine}, &{cosine});" for angle, sine, cosine in self.angles),
            called if self.outputs else f"return {called}",
        ]
        outside = _signature(f"static inline {kind}", f"{self.name}{suffix}", [*given, *filled])
        return f"{_definition(inside, body)}\n{_definition(outside, chr(10).join(lines))}"

    @property
    def _sines(self) -> list[str]:
        return [name for _, *names in self.angles for name in names]

    def _for_many(self, suffix: str) -> str:
        real = real_of(suffix)
        names = [one.name for one in self.outputs] or [RESULT]
        given = [f"const {real} *{name}" for name in self.arguments]
        filled = [f"{real} *RADARTRACK_RESTRICT {name}" for name in names]
        signature = _signature(
            "RADARTRACK_BATCH void", f"{self.name}{BATCH}{suffix}", [f"size_t {COUNT}", *given, *filled]
        )
        place = f"{START} + {PLACE}" if self.angles else PLACE
        at = [f"{name}[{place}]" for name in self.arguments] + [f"{name}[{PLACE}]" for name in self._sines]
        to = [f"{one.name} + {one.size}u * {f'({place})' if self.angles else place}" for one in self.outputs]
        called = f"{self.name}{INSIDE if self.angles else ''}{suffix}({', '.join([*at, *to])});"
        inside = called if self.outputs else f"{RESULT}[{place}] = {called}"
        if not self.angles:
            loop = f"size_t {PLACE};\nfor ({PLACE} = 0; {PLACE} < {COUNT}; ++{PLACE})\n{INDENT}{inside}"
            return _definition(signature, loop)
        lines = [
            *(f"{real} {name}[{AT_ONCE}];" for name in self._sines),
            f"size_t {START}, {PLACE};",
            f"for ({START} = 0; {START} < {COUNT}; {START} += {AT_ONCE}u) {{",
            f"{INDENT}const size_t {SOME} = {COUNT} - {START} < {AT_ONCE}u ? {COUNT} - {START} : {AT_ONCE}u;",
            *(
                f"{INDENT}{PREFIX}sin_and_cos_n{suffix}({SOME}, {angle} + {START}, {sine}, {cosine});"
                for angle, sine, cosine in self.angles
            ),
            f"{INDENT}for ({PLACE} = 0; {PLACE} < {SOME}; ++{PLACE})",
            f"{2 * INDENT}{inside}",
            "}",
        ]
        return _definition(signature, "\n".join(lines))


def of_quantity(quantity: Quantity, form: StableForm) -> CFunction:
    """The function of a quantity as it is rewritten."""
    outputs = (Output(RESULT, quantity.shape),) if quantity.shape else ()
    symbols = [symbol.name for symbol in quantity.symbols]
    name = f"{PREFIX}{quantity.module}_{quantity.function}"
    return function(name, symbols, outputs, statements_of(quantity, form))


def function(name: str, symbols: Sequence[str], outputs: Sequence[Output], statements: Statements) -> CFunction:
    """Statements as a function of symbols; names that C or C++ has for something else get an underscore."""
    said = [*symbols, *(name for name, _ in statements.definitions)]
    angles = {symbol: _names_of_sines(symbol, said) for symbol in _angles(symbols, statements)}
    names = _free_names([*said, *(name for both in angles.values() for name in both)])
    arguments = tuple(names[symbol] for symbol in symbols)
    given = _with_sines(statements, angles)
    known = tuple((names[symbol], names[sine], names[cosine]) for symbol, (sine, cosine) in angles.items())
    passed = [*arguments, *(name for _, *sines in known for name in sines)]
    double, single = (
        "\n".join(body(given, passed, outputs, CExpression(suffix, names=names))) for suffix in ("", SINGLE)
    )
    return CFunction(name, arguments, tuple(outputs), (double, single), known)


def _angles(symbols: Sequence[str], statements: Statements) -> list[str]:
    """The arguments whose sine or cosine is taken."""
    expressions = [*(value for _, value in statements.definitions), *statements.results]
    taken = {wave.args[0] for one in expressions for wave in one.atoms(sp.sin, sp.cos)}
    names = {angle.name for angle in taken if isinstance(angle, sp.Symbol)}
    return [symbol for symbol in symbols if symbol in names]


def _names_of_sines(angle: str, taken: Sequence[str]) -> tuple[str, str]:
    """Of its sine and cosine, which no symbol has."""
    sine, cosine = f"sine_of_{angle}", f"cosine_of_{angle}"
    while sine in taken or cosine in taken:
        sine, cosine = f"{sine}_", f"{cosine}_"
    return sine, cosine


def _with_sines(statements: Statements, angles: Mapping[str, tuple[str, str]]) -> Statements:
    """The same with names for the sines and cosines of arguments."""
    expressions = [*(value for _, value in statements.definitions), *statements.results]
    waves = {wave for one in expressions for wave in one.atoms(sp.sin, sp.cos)}
    known = {
        wave: sp.Symbol(angles[wave.args[0].name][isinstance(wave, sp.cos)], real=True)
        for wave in waves
        if isinstance(wave.args[0], sp.Symbol) and wave.args[0].name in angles
    }
    definitions = tuple((name, value.xreplace(known)) for name, value in statements.definitions)
    return Statements(definitions, tuple(value.xreplace(known) for value in statements.results))


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
        while free in TAKEN or free.startswith(OTHERS) or (free != name and free in known):
            free = f"{free}_" if not free.startswith(OTHERS) else f"of_{free}"
        known.add(free)
        found[name] = free
    return found


def _definition(signature: str, body: str) -> str:
    return f"{signature}\n{{\n{textwrap.indent(body, INDENT)}\n}}\n"


def _signature(kind: str, name: str, arguments: Sequence[str]) -> str:
    line = f"{kind} {name}({', '.join(arguments) or 'void'})"
    if len(line) <= WIDTH:
        return line
    inside = textwrap.fill(", ".join(arguments), WIDTH - 4, break_long_words=False, break_on_hyphens=False)
    return f"{kind} {name}(\n{textwrap.indent(inside, INDENT)})"


def _assignment(target: str, value: Expr | str, language: CExpression) -> str:
    line = f"{target} {value if isinstance(value, str) else language.code(value)};"
    if len(line) + len(INDENT) <= WIDTH or not isinstance(value, sp.Add):
        return line
    return f"{target}\n" + "\n".join(f"{INDENT}{term}" for term in language.terms(value)) + ";"
