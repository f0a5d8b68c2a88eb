"""CGT: lines, bodies, loops, calls and exits, run here a second time in the plainest way (spec/cgt.md §5.2 to §5.6, §11, *Lines*, *Brackets*)."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import dataclass, field

from hypothesis import given, settings
from hypothesis import strategies as st

from support.cgt import expanded

NAMES = ("START", "one", "two")
WORDS = ("V1", "V2")


@dataclass
class Choice:
    """A body that is output or not: `word` changed (a bracket), or `word` below `limit` (an `#IF`)."""

    word: str
    limit: int | None
    inside: list[Line]
    other: list[Line] | None


@dataclass
class Repeat:
    """A loop."""

    count: int
    inside: list[Line]


@dataclass
class Act:
    """A command, or text."""

    kind: str
    said: str


Line = list[Choice | Repeat | Act]


def acts(number: int) -> st.SearchStrategy[Act]:
    """What stands in a section: it calls only those behind it, so that most runs end."""
    plain = [Act("text", said) for said in "ABD "] * 2
    plain += [Act(kind, word) for kind in ("word", "word", "more", "more", "reset") for word in WORDS]
    calls = [Act("CALL", name) for name in NAMES[number + 1 :]] * 2
    rare = [Act("EXITC", "")] * bool(number) + [Act("GOTO", "two")] * (number < 2) + [Act("EXIT", "")] * (number == 1)
    return st.sampled_from(plain + calls + rare)


def body(number: int, deep: int) -> st.SearchStrategy[list[Line]]:
    """Lines that may hold bodies of lines; more than one, as often as not with nothing on the first and the last."""
    act = acts(number)
    parts = act
    if deep:
        inside = body(number, deep - 1)
        choice = st.builds(Choice, st.sampled_from(WORDS), st.sampled_from((None, 1, 3)), inside, st.none() | inside)
        parts = st.one_of(act, act, choice, st.builds(Repeat, st.integers(0, 3), inside))
    line = st.lists(parts, min_size=1, max_size=3)
    blank: st.SearchStrategy[list[Line]] = st.sampled_from(([], [[]]))
    return st.builds(lambda first, among, last: first + among + last or [[]], blank, st.lists(line, max_size=3), blank)


templates = st.tuples(*[body(number, 3 - number) for number in range(3)])


def written(part: Choice | Repeat | Act) -> str:
    match part:
        case Act("text", said):
            return said
        case Act("word", said):
            return f"#{said}"
        case Act("more", said):
            return f"#EVAL(#{said}=#{said}+1)"
        case Act("reset", said):
            return f"#RESET(#{said})"
        case Act("CALL" | "GOTO" as kind, said):
            return f"#{kind}({said})"
        case Act(kind, _):
            return f"#{kind}"
        case Repeat(count, inside):
            return f"#REPEAT({count})<{body_of(inside)}>"
        case Choice(word, None, inside, other):
            # A bracket tests the words that stand in it, so one stands in front of all else.
            return f"<#{word}{body_of(inside)}>{f'#ELSE<{body_of(other)}>' if other is not None else ''}"
        case Choice(word, limit, inside, other):
            return f"#IF(#{word}<{limit})<{body_of(inside)}>{f'#ELSE<{body_of(other)}>' if other is not None else ''}"
    raise AssertionError


def body_of(inside: list[Line]) -> str:
    return "\n".join("".join(map(written, line)) for line in inside)


class Skip(Exception):
    """The rest of the calling line is dropped."""


class ExitC(Exception):
    """A called section is left."""


class Go(Exception):
    """Another section in place of the one that runs."""

    def __init__(self, name: str) -> None:
        super().__init__(name)
        self.name = name


class Exit(Exception):
    """All that the generator ran is left."""


class Endless(Exception):
    """This run is too long to be compared."""


@dataclass
class Naive:
    """The plainest interpreter."""

    sections: dict[str, list[Line]]
    flat: list[str] = field(default_factory=list)
    out: str = ""
    values: dict[str, int] = field(default_factory=lambda: dict.fromkeys(WORDS, 0))
    last: dict[str, str] = field(default_factory=dict)
    steps: int = 0

    def flush(self) -> None:
        if self.out:
            self.flat.append(self.out)
        self.out = ""

    def section(self, name: str, depth: int) -> None:
        """A section, or the one that it goes to in place of itself."""
        if depth > 60:
            raise Endless
        while name:
            try:
                for line in self.sections[name]:
                    with suppress(Skip):
                        self.line(line, name, depth)
                    self.flush()
                name = ""
            except Go as go:
                name = go.name

    def body(self, inside: list[Line], name: str, depth: int, head: bool = False) -> None:
        """``head``: text stands before the body's first line already."""
        last = len(inside) - 1
        for at, line in enumerate(inside):
            try:
                self.line(line, name, depth)
            except Skip:
                if at == last:
                    raise
            empty_first = at == 0 and not line and not head
            if at < last and not empty_first and not (at == last - 1 and not inside[last]):
                self.flush()

    def line(self, line: Line, name: str, depth: int) -> None:
        self.steps += 1
        if self.steps > 2_000:
            raise Endless
        for part in line:
            self.part(part, name, depth)

    def part(self, part: Choice | Repeat | Act, name: str, depth: int) -> None:
        match part:
            case Act("text", said):
                self.out += said
            case Act("word", said):
                self.word(said)
            case Act("more", said):
                self.values[said] += 1
            case Act("reset", said):
                self.last.pop(said, None)
            case Act("CALL", said):
                self.flush()
                try:
                    self.section(said, depth + 1)
                except ExitC:
                    raise Skip from None
            case Act("GOTO", said):
                self.flush()
                self.steps += 1
                raise Go(said)
            case Act("EXITC", _) if depth:
                self.flush()
                raise ExitC
            case Act(_, _):
                self.flush()
                raise Exit
            case Repeat(count, inside):
                for _ in range(count):
                    self.steps += 1
                    self.body(inside, name, depth)
                    if len(inside) > 1 and not inside[0]:
                        self.flush()
            case Choice(word, limit, inside, other):
                held = self.changed(word, inside) if limit is None else self.values[word] < limit
                if held:
                    if limit is None:
                        self.word(word)
                    self.body(inside, name, depth, limit is None)
                elif other is not None:
                    self.body(other, name, depth)

    def changed(self, word: str, inside: list[Line]) -> bool:
        direct = [part.said for line in inside for part in line if isinstance(part, Act) and part.kind == "word"]
        return any(self.last.get(each) != str(self.values[each]) for each in (word, *direct))

    def word(self, word: str) -> None:
        self.last[word] = str(self.values[word])
        self.out += self.last[word]


@settings(max_examples=250, deadline=None)
@given(templates)
def test_flow_is_as_the_plainest_reading_has_it(given_lines: tuple[list[Line], ...]) -> None:
    naive = Naive(dict(zip(NAMES, given_lines)))
    try:
        with suppress(Exit):
            naive.section("START", 0)
    except Endless:
        return
    text = "\n".join(f"@{name}\n{body_of(inside)}\n@" for name, inside in naive.sections.items())
    found = expanded(text, "FINI")
    assert [fault for fault in found.faults if fault.kind != "exitc-outside-call"] == []
    assert found.lines == naive.flat, text
