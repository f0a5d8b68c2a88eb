"""What a run meets: a fault with its place and the calls and loop passes above it. Never decides how severe it is; the rule of its name does."""

from __future__ import annotations

from collections.abc import Iterator
from enum import Enum
from typing import NamedTuple

from deburr_grammar.text import Span


class Entered(Enum):
    """How a run came to where it is."""

    CALL = "call"
    FILE = "file"
    LOOP = "loop"
    SECTION = "section"
    JUMP = "jump"


class Frame:
    """One call, file, loop pass, section or jump that a run is in: from which line it was entered (0-based), and its pass or count of arguments."""

    __slots__ = ("file", "id", "kind", "number", "parent", "row")

    def __init__(self, parent: Frame | None, file: str, row: int, kind: Entered, number: int) -> None:
        self.parent = parent
        self.file = file
        self.row = row
        self.kind = kind
        self.number = number
        self.id = -1
        """Its number in a source map; -1 while it is in none."""

    def outward(self) -> Iterator[Frame]:
        """This frame and those around it, innermost first."""
        frame: Frame | None = self
        while frame is not None:
            yield frame
            frame = frame.parent


class Fault(NamedTuple):
    """What stopped a run, or what it passed with a warning. ``kind`` is a rule's short name; ``message`` says it in the user's words."""

    kind: str
    file: str
    line: int
    span: Span
    message: str
    stack: Frame | None = None
    input: bool = False
    """Whether only something that was not given can decide at this place; of some rules that holds everywhere, `Rule.input`."""
    given: str = ""
    """The value that was given for the run, `NAME=VALUE`, if the fault lies in it: then no place in a program is wrong."""
    passed: bool = False
    """Whether the run never came to it, so that it is only warned of; see `Inputs.reached_only`."""


class Halt(Exception):
    """Inside an interpreter: the run ends with a fault. Never leaves `deburr.expand`."""

    def __init__(self, fault: Fault) -> None:
        super().__init__(fault.message)
        self.fault = fault
