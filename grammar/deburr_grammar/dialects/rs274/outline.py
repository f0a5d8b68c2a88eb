"""Where an RS274 program ends and how its O-words hang together (spec/rs274.md §1.1, §6)."""

import re
from collections.abc import Callable, Hashable, Iterator
from typing import NamedTuple

from deburr_grammar.codes import code_number
from deburr_grammar.dialects.rs274.commands import meant
from deburr_grammar.dialect import Bracket, Reading, Role, Step
from deburr_grammar.line import LineNode
from deburr_grammar.text import Span
from deburr_grammar.tree import Node, Token

PROGRAM = Reading("program", "line")
AFTER_END = Reading("after-end", None)
READINGS = (PROGRAM, AFTER_END)


class State(NamedTuple):
    """``ended`` by M2 or M30 outside all blocks (subs that follow are still found by calls) or, for good, by a second `%` (``closed``).

    ``sub``: inside a subprogram. ``numbered``: behind the end, in a program that M98 calls: from
    its bare `O100` to its M99. ``dos``: labels of the `do` loops that are open, because
    only they tell whether a `while` ends one or starts a loop of its own.
    """

    percent: bool = False
    ended: bool = False
    closed: bool = False
    sub: bool = False
    numbered: bool = False
    dos: frozenset[str] = frozenset()

    @property
    def live(self) -> bool:
        """Whether lines are read here."""
        return not self.closed and (not self.ended or self.sub or self.numbered)


_COMMANDS = {
    "SUB": (Role.REGION, "sub"),
    "ENDSUB": (Role.END_REGION, "sub"),
    "IF": (Role.OPEN, "if"),
    "ELSEIF": (Role.MIDDLE, "if"),
    "ELSE": (Role.MIDDLE, "if"),
    "ENDIF": (Role.CLOSE, "if"),
    "WHILE": (Role.OPEN, "while"),
    "ENDWHILE": (Role.CLOSE, "while"),
    "DO": (Role.OPEN, "do"),
    "REPEAT": (Role.OPEN, "repeat"),
    "ENDREPEAT": (Role.CLOSE, "repeat"),
    "BREAK": (Role.MIDDLE, "loop"),
    "CONTINUE": (Role.MIDDLE, "loop"),
    "RETURN": (Role.MIDDLE, "sub"),
}
_MEANT = {kind.lower(): command for kind, command in _COMMANDS.items()}
_BLANKS = re.compile(r"[ \t]+")


class RS274Outline:
    """The fold over O-words, program ends and percent lines."""

    # Possessive throughout: a line of blanks must not be gone through once for each of them.
    needs_depth = r"(?i:m[ \t]*+0*+[ \t]*+(?:2|3[ \t]*+0|9[ \t]*+9)[ \t]*+(?:\.[0 \t]*+)?+(?![0-9.]))"
    marks = rf"(?i:^[ \t]*+/?+[ \t]*+(?:n[ \t0.]*+)?+o)|^[ \t]*+%|{needs_depth}"

    def facts(self, text: str) -> frozenset[str]:
        """Nothing of the whole is needed."""
        return frozenset()

    def start(self, facts: frozenset[str]) -> Hashable:
        """Before the program."""
        return State()

    def reading(self, state: State) -> Reading:
        """A line is read until the program has ended, and in subprograms behind that end."""
        return PROGRAM if state.live else AFTER_END

    def step(self, state: State, depth: int, facts: frozenset[str], read: Callable[[Reading], LineNode]) -> Step:
        """What an O-word, a program end or a percent line does."""
        if state.closed:
            return Step(AFTER_END, (), state)
        line = read(PROGRAM)
        if "PERCENT" in line.kinds:
            # Text beside a `%` is a fault of its own; what the sign was meant for is clear all the same.
            framed = state._replace(percent=state.percent or state.live, closed=state.percent)
            return Step(self.reading(state), (), framed)
        bracket = _bracket(line, state)
        if bracket is not None:
            # Behind the end only subprograms are found, so only their first line is more than text.
            if not state.live and bracket.role is not Role.REGION:
                return Step(AFTER_END, (), state)
            return Step(PROGRAM, (bracket,), _behind(state, bracket))
        if state.ended and not state.sub and _is_number_alone(line):
            return Step(PROGRAM, (), state._replace(numbered=True))
        reading = self.reading(state)
        if state.sub or depth or not state.live:
            return Step(reading, (), state)
        return Step(reading, (), _ended(line, state))


def _is_number_alone(line: LineNode) -> bool:
    """Whether a line is the bare O-word with which a program starts that M98 calls."""
    return "o_line" in line.kinds and not line.problems


def _ended(line: LineNode, state: State) -> State:
    """The state behind a line outside all blocks: M2 and M30 end the program, M99 one that M98 called. With `/` the operator decides."""
    if "DELETE" in line.kinds:
        return state
    found = {code for code, _ in codes(line)}
    if found & {"M2", "M30"}:
        return state._replace(ended=True, numbered=False)
    return state._replace(numbered=False) if "M99" in found else state


def _behind(state: State, bracket: Bracket) -> State:
    if bracket.kind == "sub" and bracket.role is not Role.MIDDLE:
        return state._replace(sub=bracket.role is Role.REGION, dos=frozenset())
    if bracket.kind == "do" and bracket.label is not None:
        opened = bracket.role is Role.OPEN
        return state._replace(dos=state.dos | {bracket.label} if opened else state.dos - {bracket.label})
    return state


def _bracket(line: LineNode, state: State) -> Bracket | None:
    # Of a faulty line the parts that were read stand directly in the tree: it still opens or closes its block.
    o_line = next(line.find("o_line"), line.tree)
    letter, label, command = o_line.find("O"), o_line.node("label"), _command(line, o_line)
    if command is None or letter is None or label is None:
        return None
    word, word_meant, end = command
    role, kind = _MEANT[word_meant]
    name = label_of(line.text, label)
    if word_meant == "while" and name in state.dos:
        role, kind = Role.CLOSE, "do"
    return Bracket(role, kind, word, name, Span(letter.start, end))


def _command(line: LineNode, o_line: Node) -> tuple[str, str, int] | None:
    """The command as it is said, the one that it means, and where it ends. A misspelled one opens or closes what the right one would."""
    for problem in line.problems:
        if problem.kind == "o-unknown":
            word = line.text[problem.start : problem.end]
            return (word, meant(word), problem.end) if meant(word) in _MEANT else None
    for part in o_line.children:
        if isinstance(part, Token) and part.kind in _COMMANDS:
            return part.kind.lower(), part.kind.lower(), part.end
    return None


def label_of(text: str, label: Node) -> str | None:
    """An O-word's label as the interpreter compares it; None for one that only the run knows (`o[#1+2]`)."""
    only = label.children[0]
    if len(label.children) == 1 and isinstance(only, Token):
        said = _BLANKS.sub("", text[only.start : only.end]).strip("<>").lower()
        return said.partition(".")[0].lstrip("0") or "0" if re.fullmatch(r"[0-9]+\.?0*", said) else said
    return None


def codes(line: LineNode) -> Iterator[tuple[str, Node]]:
    """The G and M codes of a line in their canonical spelling, with their words; only literal ones."""
    for word in line.find("word"):
        letter, value = word.children[0], word.children[1]
        if line.text[letter.start].upper() in "GM" and isinstance(value, Token):
            yield code_number(line.text[word.start : word.end]), word
