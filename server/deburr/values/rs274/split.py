"""An RS274 program's routines: the main program and its subprograms, each with its flow, which is kept by what its lines say. Solves nothing."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Hashable, Mapping, Sequence
from posixpath import basename, splitext
from typing import TYPE_CHECKING

from deburr.values.graph import Env, Graph, unset
from deburr.values.program import Routine
from deburr.values.rs274.commands import Torn
from deburr.values.rs274.flow import Builder
from deburr.values.rs274.lines import Taken, taken
from deburr_grammar.dialect import Role

if TYPE_CHECKING:
    from deburr.analysis import Analysis

MAIN = "main program"
"""The name of the main program. No label has a blank in it."""
_KEPT = 1_000
_graphs: OrderedDict[Hashable, Graph] = OrderedDict()


def routines_of(analysis: Analysis) -> Mapping[str, Routine] | None:
    """The routines by name; None where the flow hangs on what nobody can see."""
    if analysis.document.faults:
        return None
    lines = taken(analysis.document)
    parts = _parts(lines) if lines is not None else None
    if parts is None:
        return None
    try:
        graphs = {name: _graph(analysis, name, part) for name, part in parts.items()}
    except Torn:
        return None
    opened = _opened(analysis, parts, graphs)
    found = {}
    for name, part in parts.items():
        # A file of that name would be called instead of the subprogram, so that no call is known to lead to it.
        known = f"{name} " if name != MAIN and _has_file(analysis, name) else name
        graph = graphs[name]
        entry = _start(analysis, graph) if name == MAIN else opened.get(name)
        found[known] = Routine(known, [line.row for line in part], graph, entry)
    return found


def _parts(lines: Sequence[Taken]) -> dict[str, list[Taken]] | None:
    """The lines of each routine."""
    found: dict[str, list[Taken]] = {MAIN: []}
    inside = MAIN
    for line in lines:
        bracket = line.bracket
        if bracket is not None and bracket.role is Role.REGION:
            if bracket.label is None or bracket.label in found or "DELETE" in line.node.kinds:
                return None
            inside = bracket.label
            found[inside] = []
        found[inside].append(line)
        if bracket is not None and bracket.role is Role.END_REGION:
            inside = MAIN
    return found


def _graph(analysis: Analysis, name: str, lines: Sequence[Taken]) -> Graph:
    settings, delete = analysis.settings, analysis.inputs.block_delete
    how = (name == MAIN, settings["compare"], settings["profile"], delete)
    key = (how, tuple(line.node.text for line in lines))
    found = _graphs.get(key)
    if found is None:
        found = _graphs[key] = Builder(lines, name == MAIN, settings, delete).graph()
        while len(_graphs) > _KEPT:
            _graphs.popitem(last=False)
    _graphs.move_to_end(key)
    return found


def _opened(analysis: Analysis, parts: Mapping[str, Sequence[Taken]], graphs: Mapping[str, Graph]) -> dict[str, Env]:
    """What subprograms start with that other programs may call. A remapped code may set the local names of the one with the file's name."""
    stem = splitext(basename(analysis.file))[0].lower()
    library = len(parts) > 1 and not _has_main(analysis, parts)
    own = {stem} & parts.keys()
    names = parts.keys() - {MAIN} if library else own
    return {name: unset(graphs[name].locals, name not in own) for name in names}


def _has_main(analysis: Analysis, parts: Mapping[str, Sequence[Taken]]) -> bool:
    """Whether anything is done outside of subprograms, other than to end the program."""
    document = analysis.document
    inside = {row for name, part in parts.items() if name != MAIN for row in range(part[0].row, part[-1].row + 1)}
    ends = {line.row for line in parts[MAIN] if line.ends}
    for row in range(document.line_count):
        if (
            row not in inside
            and row not in ends
            and not document.node(row).kinds.isdisjoint(("word", "setting", "CALL"))
        ):
            return True
    return False


def _start(analysis: Analysis, graph: Graph) -> Env:
    """What the main program starts with: its own names have no value, but for those that the run is given."""
    given = {said.strip().removeprefix("#").strip("<>").lower() for said in analysis.inputs.define}
    return unset(graph.locals - given, True)


def _has_file(analysis: Analysis, label: str) -> bool:
    """Whether there may be a file of a subprogram's name."""
    folders = (analysis.file.rpartition("/")[0], *analysis.settings["subroutine-path"])
    return any(
        analysis.host.read(f"{folder.rstrip('/')}/{label}.ngc" if folder else f"{label}.ngc") is not None
        for folder in folders
    )
