"""What is measured of deburr: opening, typing, memory. Each function runs in a process of its own."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from random import Random
from statistics import median
from time import perf_counter

from benchmarks.measure import growth, seconds
from deburr.analysis import Analysis
from deburr.finding import Finding
from deburr.modal import modal_of
from deburr.ruleset import RuleSet
from deburr_grammar.dialects import by_name
from deburr_grammar.document import Document
from deburr_grammar.text import Edit, Pos

DIALECT = by_name("rs274")
MODAL = modal_of(DIALECT)
VISIBLE = 60
"""Lines that an editor shows."""
SEED = 1


@dataclass(frozen=True)
class Keystroke:
    """A thing that is typed: its name, the text, and whether it goes into a number instead of the line's start."""

    name: str
    text: str
    in_number: bool = False


KEYSTROKES = (
    Keystroke("a digit", "7", True),
    Keystroke("a newline", "\n"),
    Keystroke("an opener `o9999 if [1]`", "o9999 if [1]\n"),
)


def read(path: str) -> str:
    """A corpus as text."""
    return Path(path).read_bytes().decode("utf-8")


def ready() -> RuleSet:
    """All that is there before the first program is opened: grammar tables, rules."""
    DIALECT.grammar.parse("line", "G0 X1")
    ruleset = RuleSet(DIALECT)
    Analysis(Document.parse("G1 X1 F1\no1 if [#1]\no1 endif\nM2\n", DIALECT), ruleset).findings()
    return ruleset


def open_visible(path: str) -> float:
    """Seconds from the text to the findings of the part that is seen, in the middle of the file."""
    text, ruleset = read(path), ready()

    def work() -> None:
        analysis = Analysis(Document.parse(text, DIALECT), ruleset)
        for line in range(min(VISIBLE, analysis.document.line_count)):
            analysis.line_findings(line)

    return seconds(work)


def open_syntax(path: str) -> float:
    """Seconds from the text to all problems and faults of structure."""
    text, _ = read(path), ready()

    def work() -> None:
        document = Document.parse(text, DIALECT)
        list(document.problems())
        _ = document.faults

    return seconds(work)


def open_all(path: str) -> float:
    """Seconds from the text to the findings of all rules."""
    return everything(path)[0]


def everything(path: str) -> tuple[float, int]:
    """The same, and how many findings there are."""
    text, ruleset = read(path), ready()
    found: list[Finding] = []
    taken = seconds(lambda: found.extend(Analysis(Document.parse(text, DIALECT), ruleset).findings()))
    return taken, len(found)


def memory(path: str) -> int:
    """Bytes beyond the text for a program whose findings and modal state are known and kept."""
    text, ruleset = read(path), ready()

    def work() -> Document:
        document = Document.parse(text, DIALECT)
        warm(document, ruleset)
        return document

    return growth(work)


def keystrokes(path: str, places: int) -> dict[str, float]:
    """The median seconds of each keystroke over random places, none of which was edited before."""
    document, ruleset = Document.parse(read(path), DIALECT), ready()
    warm(document, ruleset)
    found = {}
    for stroke in KEYSTROKES:
        random = Random(SEED)
        taken = []
        for _ in range(places):
            edit = typed(document, random.randrange(max(document.line_count - 1, 1)), stroke)
            start = perf_counter()
            answer(document, edit, ruleset)
            taken.append(perf_counter() - start)
        found[stroke.name] = median(taken)
    return found


def typed(document: Document, line: int, stroke: Keystroke) -> Edit:
    """A keystroke as an edit of a line."""
    text = document.line(line)
    col = next((col for col, char in enumerate(text, 1) if char.isdigit()), 0) if stroke.in_number else 0
    return Edit(Pos(line, col), Pos(line, col), stroke.text)


def warm(document: Document, ruleset: RuleSet) -> None:
    """Know all that an open file's server knows."""
    Analysis(document, ruleset).findings()
    if MODAL is not None:
        document.state(MODAL, document.line_count - 1)


def answer(document: Document, edit: Edit, ruleset: RuleSet) -> Document:
    """What is asked after a keystroke: findings of the line, structure, the partners of its brackets, the modal state there."""
    edited = document.edit(edit)
    line = edit.start.line
    Analysis(edited, ruleset).line_findings(line)
    _ = edited.faults, edited.balance
    piece = edited.piece(line)
    for index, bracket in piece.outlined.brackets:
        if piece.line + index == line:
            edited.partner(line, bracket)
    if MODAL is not None:
        edited.state(MODAL, line)
    return edited
