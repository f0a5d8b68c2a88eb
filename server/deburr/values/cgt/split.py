"""A template parted into routines: the generator and the sections, each with a graph that is kept by what it says (spec/cgt.md §1, §5.1). Solves nothing."""

from __future__ import annotations

from collections.abc import Generator, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING

from deburr.steps import FEW, paced
from deburr.templates.beside import beside, events_in, is_events, machine_in
from deburr.templates.items import Body, rows_of
from deburr.templates.items import Builder as Bodies
from deburr.values.cgt.commands import Commands
from deburr.values.cgt.flow import Builder, Section
from deburr.values.cgt.generator import NAME, Path, generator, path_of
from deburr.values.cgt.lines import Part, Unread, sections
from deburr.values.cgt.words import Vocabulary
from deburr.values.kept import LINES, Kept
from deburr.values.program import Routine
from deburr_grammar.text import Span

if TYPE_CHECKING:
    from deburr.analysis import Analysis
    from deburr.formats.machine import Machine
    from deburr.values.graph import Env

_VOCABULARIES = 8
_kept: Kept[tuple[Commands, Kept[Section]]] = Kept(_VOCABULARIES)
"""What commands do, and the graphs of sections, by what words mean."""


def routines_of(analysis: Analysis) -> Generator[None, None, Mapping[str, Routine] | None]:
    """The routines by their names, found in steps; None where the template cannot be read."""
    document = analysis.document
    if document.faults:
        return None
    try:
        parts = _first((yield from sections(document)))
        run = {name: part for name, part in parts.items() if part.reading != "table"}
        machine = machine_in(beside(analysis.settings, analysis.host, "machine"))
        commands, graphs = _graphs(_vocabulary(parts, run, machine, analysis.inputs.define))
        graphs.fit(sum(len(part.lines) for part in run.values()))
        built: dict[str, Section] = {}
        for name, part in run.items():
            built[name] = yield from _section(part, commands, graphs)
            yield
    except Unread:
        return None
    found = {
        name: Routine(name, [part.row + row for row in built[name].rows], built[name].graph, None)
        for name, part in run.items()
    }
    path = _path(analysis)
    entry = _start(commands.words, _targets(run.values(), commands.words) - path.sets)
    graph = generator(tuple(run), frozenset(entry), path)
    return {NAME: Routine(NAME, (-1,), graph, entry), **found}


def _graphs(words: Vocabulary) -> tuple[Commands, Kept[Section]]:
    """What commands do where words mean this, and where the graphs of sections are kept."""
    found = _kept.get(words)
    return _kept.add(words, (Commands(words), Kept(LINES // _VOCABULARIES)), 1) if found is None else found


def _first(parts: Sequence[Part]) -> dict[str, Part]:
    """Of several sections of one name the first is run."""
    found: dict[str, Part] = {}
    for part in parts:
        found.setdefault(part.name, part)
    return found


def _vocabulary(
    parts: Mapping[str, Part], run: Mapping[str, Part], machine: Machine, given: Mapping[str, str]
) -> Vocabulary:
    declared: dict[str, str] = {}
    for name, command in (each for part in run.values() for each in part.names.declares):
        declared.setdefault(name, command)
    tables = {name: len(rows) for name, rows in machine.tables.items()}
    tables |= {
        name: sum(1 for node in part.nodes for _ in rows_of(0, node))
        for name, part in parts.items()
        if part.reading == "table"
    }
    return Vocabulary(
        tuple(sorted(declared.items())),
        tuple(sorted(machine.words.items())),
        tuple(sorted((name.strip().removeprefix("#"), said) for name, said in given.items())),
        tuple(sorted(tables.items())),
        frozenset(run),
        _quiet(run),
    )


def _quiet(run: Mapping[str, Part]) -> frozenset[str]:
    """Sections that may be run where no line is output: `@DECLARE`, those that compute words, and all that they call."""
    waiting = [name for name in run if name == "DECLARE" or name.startswith("$")]
    found = set(waiting)
    while waiting:
        part = run.get(waiting.pop())
        called = set(part.names.calls) if part is not None else set()
        waiting += called - found
        found |= called
    return frozenset(found)


def _targets(parts: Iterable[Part], words: Vocabulary) -> frozenset[str]:
    """The words of the template that it sets itself. Others are given from outside, so that nothing is known of them."""
    said = {name for part in parts for name in part.names.sets}
    found = (words.find(name) for name in said)
    return frozenset(
        word.name for word in found if word is not None and words.is_mine(word.name) and not words.computes(word)
    )


def _start(words: Vocabulary, mine: frozenset[str]) -> Env:
    return {name: words.start(name) for name in sorted(mine)}


def _path(analysis: Analysis) -> Path:
    """What the configured toolpath does that CL text cannot do."""
    file = beside(analysis.settings, analysis.host, "input")
    return path_of(events_in(file).events) if file.text is not None and is_events(file) else Path()


def _section(part: Part, commands: Commands, kept: Kept[Section]) -> Generator[None, None, Section]:
    """A section's flow, kept by its lines."""
    quiet = part.name in commands.words.quiet
    key = (part.name, quiet, part.lines)
    found = kept.get(key)
    if found is None:
        body = Body("section")
        bodies = Bodies(body)
        for line in paced(zip(part.lines, part.nodes), FEW):
            if line is None:
                yield
            else:
                (row, _), node = line
                bodies.add(commands.items(row, node))
        found = yield from Builder(commands, dict(part.lines), quiet).section(body, Span(0, 1 + len(part.name)))
        kept.add(key, found, len(part.lines))
    return found
