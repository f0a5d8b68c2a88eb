"""Where an RS274 program ends and how its O-words hang together (spec/rs274.md §1.1, §6)."""

import re
from collections.abc import Callable, Hashable, Iterator, Set
from typing import NamedTuple

from deburr_grammar.codes import code_number
from deburr_grammar.dialect import Bracket, Reading, Role, Step
from deburr_grammar.dialects.rs274.commands import meant
from deburr_grammar.line import LineNode
from deburr_grammar.problem import Problem
from deburr_grammar.text import Span
from deburr_grammar.tree import Node, Token, walk

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
_BLANKS = re.compile(r"[ \t]+")
_ABORTS = re.compile(r"\([ \t]*abort[ \t]*,", re.I)
_INTEGER = re.compile(r"([-+]*)<?([0-9]+)(?:\.0*)?>?")


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
    if ends(found):
        return state._replace(ended=True, numbered=False)
    return state._replace(numbered=False) if "M99" in found else state


def ends(found: Set[str]) -> bool:
    """Whether a line with these codes certainly ends the program. Where `M72` brings a mode back, the control forgets the end beside it."""
    return not found.isdisjoint(("M2", "M30")) and "M72" not in found


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
    misspelt = next((problem for problem in line.problems if problem.kind == "o-unknown"), None)
    if misspelt is not None:
        return _misspelt(line.text, o_line, misspelt, state)
    command = next((part for part in o_line.children if isinstance(part, Token) and part.kind in _COMMANDS), None)
    label, letter = o_line.node("label"), o_line.find("O")
    if command is None or label is None or letter is None:
        return None
    name = label_of(line.text, label)
    return Bracket(*_does(command.kind, name, state), command.kind.lower(), name, Span(letter.start, command.end))


def _misspelt(text: str, tree: Node, problem: Problem, state: State) -> Bracket | None:
    """A command that does not exist opens or closes what the one would that was likely meant; it keeps its own spelling."""
    word = text[problem.start : problem.end]
    command = meant(word).upper()
    letter = tree.find("O")
    if command not in _COMMANDS or letter is None:
        return None
    # What was read last may not have been taken for a label yet.
    parts = tuple(part for part in tree.children if letter.end <= part.start and part.end <= problem.start)
    label = tree.node("label") or Node("label", letter.end, problem.start, parts)
    name = label_of(text, label)
    return Bracket(*_does(command, name, state), word, name, Span(letter.start, problem.end))


def _does(command: str, name: str | None, state: State) -> tuple[Role, str]:
    return (Role.CLOSE, "do") if command == "WHILE" and name in state.dos else _COMMANDS[command]


def label_of(text: str, label: Node) -> str | None:
    """An O-word's label as the interpreter compares it; None for one that only the run knows (`o[#1+2]`)."""
    only = label.children[0]
    said = _BLANKS.sub("", text[label.start : label.end])
    if number := _INTEGER.fullmatch(said):
        digits = number[2].lstrip("0") or "0"
        return f"-{digits}" if number[1].count("-") % 2 and digits != "0" else digits
    return said.strip("<>").lower() if len(label.children) == 1 and isinstance(only, Token) else None


def aborts(text: str) -> bool:
    """Whether a comment of a line may stop the program."""
    return _ABORTS.search(text) is not None


def computes_code(text: str, tree: Node) -> bool:
    """Whether only a run knows an M code of a line."""
    words = (part for part in walk(tree) if isinstance(part, Node) and part.kind == "word")
    return any(text[word.start] in "Mm" and isinstance(word.children[-1], Node) for word in words)


def codes(line: LineNode) -> Iterator[tuple[str, Node]]:
    """The G and M codes of a line in their canonical spelling, with their words; only literal ones."""
    for word in line.find("word"):
        letter, value = word.children[0], word.children[1]
        if line.text[letter.start].upper() in "GM" and isinstance(value, Token):
            yield code_number(line.text[word.start : word.end]), word
