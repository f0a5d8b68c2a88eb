"""One snapshot of a program and all that is derived from it. Runs no rule itself beyond asking the rule set; never opens a file."""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterable, Iterator, Mapping, Sequence
from typing import Any

from deburr.blocks import Scope, scoping
from deburr.finding import Finding, Place, Related, Severity
from deburr.host import Host, NoFiles
from deburr.inputs import Inputs
from deburr.rule import Note, Notice, Rule, Structure, Whole
from deburr.ruleset import RuleSet
from deburr.stateful import Said
from deburr.steps import done, kept, paced
from deburr.suppress import UNUSED, allowing, is_allowed, mentions
from deburr_grammar.dialect import Dialect
from deburr_grammar.document import Document, Piece
from deburr_grammar.structure import StructureFault
from deburr_grammar.text import with_newlines

_SCOPES = "scopes"
_FEW = 16
"""Shapes that are planned in one step."""
_LINES = 64
"""Lines of which rules are asked in one step."""


class Analysis:
    """A document, its rule set and the files around it.

    What is derived from it holds it in turn; in an editor, which looks for garbage seldom, ``with`` lets go of all that at the end.
    """

    def __init__(
        self,
        document: Document,
        ruleset: RuleSet,
        file: str = "",
        host: Host | None = None,
        notices: Sequence[Notice] = (),
        run: Callable[[Analysis], Iterable[Finding | None]] | None = None,
        inputs: Inputs | None = None,
        prove: Callable[[Analysis], Iterable[Finding | None]] | None = None,
    ) -> None:
        self.document = document
        self.ruleset = ruleset
        self.file = file
        self.host: Host = host or NoFiles()
        self.memo: dict[Any, Any] = {}
        """Room for what several rules derive from the program and its files, each under a key of its own."""
        self.notices = tuple(notices)
        """What was met before the text was there to be read."""
        self.inputs = inputs or Inputs()
        """What the operator and the machine would give, as far as it is known."""
        self._run = run
        self._prove = prove
        self._nested: list[Analysis] = []

    def __enter__(self) -> Analysis:
        return self

    def __exit__(self, *_: object) -> None:
        self.let_go()

    def let_go(self) -> None:
        """Let go of all that is derived."""
        for each in self._nested:
            each.let_go()
        self._nested.clear()
        self.memo.clear()

    def nested(self, document: Document, file: str) -> Analysis:
        """That of another file, under the same rules; it goes with this one."""
        found = Analysis(document, self.ruleset, file, self.host)
        self._nested.append(found)
        return found

    @property
    def dialect(self) -> Dialect:
        """The language of the program."""
        return self.document.dialect

    @property
    def settings(self) -> Mapping[str, Any]:
        """The dialect's settings."""
        return self.ruleset.settings

    @property
    def scopes(self) -> tuple[Scope, ...]:
        """The regions of the program with their blocks."""
        return done(self._scoping())

    def scoping(self) -> Iterator[None]:
        """Find the scopes, in steps: what rules that stand on them are to be ready with."""
        yield from self._scoping()

    def _scoping(self) -> Generator[None, None, tuple[Scope, ...]]:
        return kept(self.memo, _SCOPES, lambda: scoping(self.document.brackets()))

    def findings(self) -> list[Finding]:
        """All findings, in order."""
        return done(self.gathering())

    def gathering(
        self, early: Callable[[list[Finding]], Iterator[None]] | None = None
    ) -> Generator[None, None, list[Finding]]:
        """All findings, in order, as work that can be left at each of its steps.

        ``early`` is told what the program says as it stands, before its values are proven and it is run; that is work of the same sort.
        """
        found: list[Finding] = []
        for piece in self.document.pieces():
            yield from self._planning(piece)
            on_piece = yield from self._on_piece(piece)
            found += [self._finding(piece.line + local.line, local) for local in on_piece]
            yield
        yield from self._passed()
        for each in paced(self._modal()):
            if each is None:
                yield
            else:
                piece, said = each
                found.append(self._finding(piece.line + said.line, said))
        for fault in self.document.faults if self.ruleset.on_structure else ():
            found += self.fault_findings(fault)
        for rule in self.ruleset.on_whole:
            yield
            yield from self._whole(rule, found)
        found += self._noticed(self.notices)
        if early is not None and (self._prove is not None or self._run is not None):
            yield from early((yield from self._keeping(found, whole=False)))
        if self._prove is not None:
            yield from self._more(found, self._prove)
        if self._run is not None and all(finding.severity < Severity.ERROR for finding in found):
            # A program that is wrong as it stands is not run: what it would meet would be guesses.
            yield from self._more(found, self._run)
        return (yield from self._keeping(found))

    def _whole(self, rule: Rule, found: list[Finding]) -> Iterator[None]:
        """Add what a rule says of the whole program."""
        if isinstance(rule.trigger, Whole) and rule.trigger.ready is not None:
            yield from rule.trigger.ready(self)
        for report in rule.on_program(self):
            if report is None:
                yield
            else:
                found.append(self._finding(report.line, Said(0, rule, report)))

    def _more(self, found: list[Finding], ask: Callable[[Analysis], Iterable[Finding | None]]) -> Iterator[None]:
        """Add what else is found; nothing is said twice."""
        said = {(finding.rule, finding.place) for finding in found}
        for other in ask(self):
            if other is None:
                yield
            elif (other.rule, other.place) not in said:
                said.add((other.rule, other.place))
                found.append(other)

    def _keeping(self, found: list[Finding], *, whole: bool = True) -> Generator[None, None, list[Finding]]:
        """What no comment allows, in order. A comment speaks for the file that it stands in, and is of no use only if the ``whole`` has none for it."""
        elsewhere: list[Finding] = []
        here: list[Finding] = []
        for each in paced(found):
            if each is None:
                yield
            elif each.place.file == self.file:
                here.append(each)
            elif not self._is_allowed_there(each):
                elsewhere.append(each)
        kept = yield from allowing(self.document, here, self.ruleset)
        notices = kept.notices if whole else (each for each in kept.notices if each.kind != UNUSED)
        return sorted([*kept.findings, *elsewhere, *self._noticed(notices)], key=lambda finding: finding.order)

    def _is_allowed_there(self, finding: Finding) -> bool:
        """Whether a comment in another file, which this one reads or calls, allows what is found in it."""
        text = self.host.read(finding.place.file)
        # Files that no programs are, such as lists of values, have no such comments.
        if text is None or not mentions(text):
            return False
        document = Document.parse(text, self.dialect)
        return finding.place.line < document.line_count and is_allowed(document, finding)

    def line_findings(self, line: int) -> list[Finding]:
        """The findings that a line alone decides, but for those that a comment allows."""
        piece = self.document.piece(line)
        on_chunk: tuple[Said, ...] | None = piece.chunk.memo.get((self.ruleset, self.document.key(piece)))
        # The line is on its own quicker than its chunk would be, of which an edit leaves nothing known.
        on_line = self._on_line(piece, line - piece.line) if on_chunk is None else on_chunk
        found = [self._finding(line, local) for local in on_line if piece.line + local.line == line]
        if stateful := self.ruleset.stateful:
            found += [self._finding(line, said) for said in stateful.line_findings(self.document, line)]
        return [finding for finding in found if not is_allowed(self.document, finding)]

    def fault_findings(self, fault: StructureFault) -> list[Finding]:
        """What the rules say of a fault of structure, whether a comment allows it or not."""
        return [
            self._finding(report.line, Said(0, rule, report))
            for rule in self.ruleset.on_structure
            if isinstance(rule.trigger, Structure) and fault.fault in rule.trigger.faults
            for report in rule.check(fault)
        ]

    def _noticed(self, notices: Iterable[Notice]) -> Iterator[Finding]:
        for notice in notices:
            if rule := self.ruleset.on_notice.get(notice.kind):
                yield from (self._finding(report.line, Said(0, rule, report)) for report in rule.check(notice))

    def _passed(self) -> Iterator[None]:
        """Follow the modal state through the program; what the rules say on the way is kept."""
        if stateful := self.ruleset.stateful:
            for _ in stateful.states(self.document):
                yield

    def _modal(self) -> Iterator[tuple[Piece, Said]]:
        if stateful := self.ruleset.stateful:
            yield from stateful.findings(self.document)

    def _on_piece(self, piece: Piece) -> Generator[None, None, tuple[Said, ...]]:
        """What rules on lines say of a chunk: kept with the chunk."""
        key = (self.ruleset, self.document.key(piece))
        found: tuple[Said, ...] | None = piece.chunk.memo.get(key)
        if found is None:
            said: list[Said] = []
            for each in self._planned(piece):
                if each is None:
                    yield
                else:
                    said.append(each)
            found = piece.chunk.memo[key] = (*said, *self._texts(piece), *self._long(piece))
        return found

    def _planning(self, piece: Piece) -> Iterator[None]:
        """Have the rules on the lines of a chunk planned, which is most of what a chunk costs that was never looked at."""
        if (self.ruleset, self.document.key(piece)) not in piece.chunk.memo:
            for number, (reading, shape) in enumerate(piece.distinct(), 1):
                self.ruleset.plan(shape, reading)
                if not number % _FEW:
                    yield

    def _on_line(self, piece: Piece, index: int) -> Iterator[Said]:
        """What rules on lines say of one line."""
        node = self.document.node(piece.line + index)
        plan = self.ruleset.plan(node.shape, node.reading)
        if node.reading.start is not None:
            plan += tuple(rule for rule, searched in self.ruleset.on_text if searched.found(node.text))
            plan += tuple(rule for rule, limit in self.ruleset.on_length if len(node.text) > limit)
        said = self.ruleset.on_line(node, plan, piece.chunk.ending(index))
        return (Said(index, rule, report) for rule, report in said)

    def _planned(self, piece: Piece) -> Iterator[Said | None]:
        """What is said of lines that some rule asks for, with a None behind some of these."""
        plan = self.ruleset.plan
        for number, (index, _, _) in enumerate(piece.where(lambda reading, shape: plan(shape, reading)), 1):
            for rule, report in self.ruleset.said(piece, index):
                yield Said(index, rule, report)
            if not number % _LINES:
                yield None

    def _texts(self, piece: Piece) -> Iterator[Said]:
        text = with_newlines(piece.chunk.text)
        for rule, searched in self.ruleset.on_text:
            yield from self._of_rule(rule, piece, searched.lines(text))

    def _long(self, piece: Piece) -> Iterator[Said]:
        if not self.ruleset.on_length:
            return
        # With their endings: long enough is then looked at for what it is.
        lengths = piece.chunk.lengths
        longest = max(lengths)
        for rule, limit in self.ruleset.on_length:
            if longest > limit:
                long = (at for at, length in enumerate(lengths) if length > limit)
                yield from self._of_rule(rule, piece, (at for at in long if len(piece.chunk.line(at)) > limit))

    def _of_rule(self, rule: Rule, piece: Piece, lines: Iterable[int]) -> Iterator[Said]:
        for index in lines:
            node = piece.node(index)
            if node.reading.start is not None:
                for found, report in self.ruleset.on_line(node, (rule,), piece.chunk.ending(index)):
                    yield Said(index, found, report)

    def _finding(self, line: int, local: Said) -> Finding:
        rule, report = local.rule, local.report
        file = self.file if report.file is None else report.file
        place = Place(file, line, report.span.start, line, report.span.end)
        related = tuple(self._related(note) for note in report.related)
        return Finding(rule.name, self.ruleset.severity(rule, report.severity), report.message, place, related)

    def _related(self, note: Note) -> Related:
        file = self.file if note.file is None else note.file
        return Related(Place(file, note.line, note.span.start, note.line, note.span.end), note.message)
