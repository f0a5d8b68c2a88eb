"""A Z32 program's parts: the main program, its sections, the programs and files that are called, each with its flow, which is kept by what its lines say. Solves nothing."""

from __future__ import annotations

from collections.abc import Generator, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from deburr.arithmetic.z32 import constant
from deburr.includes import z32 as stores
from deburr.values.graph import Env, Graph, unset
from deburr.values.kept import Kept
from deburr.values.program import Routine
from deburr.values.z32.expressions import World
from deburr.values.z32.files import File, Files, Target, rows_with
from deburr.values.z32.flow import UNSEEN, Builder, Torn
from deburr.values.z32.lines import Marks, Taken, taken
from deburr_grammar.tree import Node as Part

if TYPE_CHECKING:
    from deburr.analysis import Analysis

MAIN = "main program"
"""The name of the main program. No file's program has it."""
_ACTIVE = frozenset(("word", "g_word", "axis_alias", "stray", "advanced", "mixed"))
_graphs: Kept[Graph] = Kept()


def routines_of(analysis: Analysis) -> Generator[None, None, Mapping[str, Routine] | None]:
    """The parts by name, found in steps; None where the flow hangs on what nobody can see."""
    files = Files(analysis)
    tracked: set[str] = set()
    for file in files.all():
        tracked |= file.marks.reads
        yield
    try:
        return (yield from _Split(analysis, files, frozenset(tracked)).routines())
    except Torn:
        return None


class _Split:
    """The parts of one program."""

    def __init__(self, analysis: Analysis, files: Files, tracked: frozenset[str]) -> None:
        self._analysis = analysis
        self._files = files
        self._world = World.of(tracked, _machine(analysis))
        self._lines: dict[str, list[Taken]] = {}
        self._starts: dict[str, list[int]] = {}
        self._waiting: list[tuple[str, Target]] = []
        self._named: dict[str, Target] = {}

    def routines(self) -> Generator[None, None, Mapping[str, Routine]]:
        """All of them, found in steps."""
        main = self._files.main
        lines = yield from self._of_file(main)
        alone = _is_main(self._analysis, main.marks)
        part = _main_part(lines, main.marks)
        _graphs.fit(len(lines))
        self._only_called = len(part) < len(lines)
        known = {MAIN: (yield from self._routine(MAIN, main, part, {}))}
        if not alone:
            for number in main.sections:
                self._name(Target(main.path, number))
        while self._waiting:
            name, target = self._waiting.pop()
            file = self._files.file(target.path)
            assert file is not None, "what is called was read"
            is_open = not alone and target.path == main.path
            part = yield from self._part(file, target.section)
            known[name] = yield from self._routine(name, file, part, {} if is_open else None)
            yield
        return known

    def _routine(
        self, name: str, file: File, lines: Sequence[Taken], entry: Env | None
    ) -> Generator[None, None, Routine]:
        graph = yield from self._graph(file, lines)
        start = None if entry is None else {**entry, **unset(graph.locals, True)}
        files = None if file is self._files.main else [file.path] * len(lines)
        return Routine(name, [line.row for line in lines], graph, start, files, True)

    def _graph(self, file: File, lines: Sequence[Taken]) -> Generator[None, None, Graph]:
        delete = self._analysis.inputs.block_delete
        # By what a line says, so that what is kept of it holds nothing of this program.
        called = {(line.node.text, call.start): self._called(file, line, call) for line in lines for call in line.calls}
        only_called = self._only_called and file is self._files.main
        key = (only_called, delete, self._world, tuple(called.values()), tuple([line.node.text for line in lines]))
        found = _graphs.get(key)
        if found is None:
            builder = Builder(lines, self._world, delete, called, only_called)
            graph = yield from builder.graph()
            found = _graphs.add(key, graph, len(lines))
        return found

    def _called(self, file: File, line: Taken, call: Part) -> str:
        """The name of the part that a call leads to."""
        target = self._files.target(file, line.node, call)
        return UNSEEN if target is None else self._name(target)

    def _name(self, target: Target) -> str:
        name = f"{target.path}:{'' if target.section is None else target.section}"
        if name not in self._named:
            self._named[name] = target
            self._waiting.append((name, target))
        return name

    def _part(self, file: File, section: int | None) -> Generator[None, None, Sequence[Taken]]:
        lines = yield from self._of_file(file)
        if section is None:
            return lines
        if file.path not in self._starts:
            self._starts[file.path] = [at for at, line in enumerate(lines) if line.titled]
        starts = self._starts[file.path]
        found = next(number for number, at in enumerate(starts) if lines[at].section == section)
        return lines[starts[found] : starts[found + 1] if found + 1 < len(starts) else None]

    def _of_file(self, file: File) -> Generator[None, None, list[Taken]]:
        if file.path not in self._lines:
            lines = yield from taken(file.document, self._world.tracked, file.marks)
            if lines is None:
                raise Torn
            self._lines[file.path] = lines
        return self._lines[file.path]


def _machine(analysis: Analysis) -> tuple[tuple[int, float], ...]:
    """The machine's values that are configured and not given otherwise for this run."""
    given = {said.replace(" ", "").upper() for said in analysis.inputs.define}
    known = {int(at): float(value) for at, value in analysis.settings["pal"].items() if f"PAL[{int(at)}]" not in given}
    return tuple(sorted(known.items()))


def _main_part(lines: list[Taken], marks: Marks) -> Sequence[Taken]:
    """The lines before the first section, if that is all that is run without a call; else the whole file."""
    first = next((at for at, line in enumerate(lines) if line.titled), None)
    if not first:
        return lines
    part = lines[:first]
    labels = {line.label for line in part}
    targets = [constant(line.node.text, each) for line in part for each in _targets(line)]
    stays = all(isinstance(target, float) and target in labels for target in targets)
    return part if stays and _ends(part[-1]) else lines


def _targets(line: Taken) -> Iterator[Part]:
    for jump in line.node.find("jump") if "jump" in line.node.kinds else ():
        end = jump.node("range_end")
        yield from (jump.children[1], *(end.children[1:] if end is not None else ()))  # type: ignore[misc]  # numbers are tokens


def _ends(line: Taken) -> bool:
    """Whether nothing goes on behind a line: M2, M30, or a jump on every run."""
    kinds = line.node.kinds
    if "DELETE" in kinds or line.node.problems:
        return False
    fields = next((list(each.nodes()) for each in line.node.find("advanced")), None)
    return (
        "M_END" in kinds if fields is None else bool(fields) and fields[0].kind == "jump" and "range_end" not in kinds
    )


def _is_main(analysis: Analysis, marks: Marks) -> bool:
    """Whether it is certain that the operator starts this program: its main part ends in M2 or M30, and not at a jump target."""
    document = analysis.document
    if stores.is_stored(analysis.file, analysis.settings):
        return False
    end = next(rows_with(document, "section"), document.line_count)
    rows = (row for row in range(end - 1, -1, -1) if not _ACTIVE.isdisjoint(document.node(row).kinds))
    last = next(rows, None)
    if last is None or "M_END" not in document.node(last).kinds:
        return False
    return "nword" not in document.node(last).kinds or not (marks.computed or marks.targets)
