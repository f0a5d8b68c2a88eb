"""An RS274 program's routines: the main program, its subprograms and those of called files, programs that M98 calls; each with its flow, which is kept by what its lines say. Solves nothing."""

from __future__ import annotations

from collections import Counter
from collections.abc import Generator, Mapping, Sequence
from posixpath import basename, splitext
from typing import TYPE_CHECKING, NamedTuple, TypeVar

from deburr.values.graph import RETURN, STOP, Env, Graph, unset
from deburr.values.kept import Kept
from deburr.values.program import Routine
from deburr.values.rs274.files import File, Files
from deburr.values.rs274.flow import Builder
from deburr.values.rs274.lines import Several, Taken, taken
from deburr.values.rs274.made import Torn
from deburr_grammar.dialect import Role
from deburr_grammar.dialects.rs274.names import name_of

if TYPE_CHECKING:
    from deburr.analysis import Analysis

T = TypeVar("T")
MAIN = "main program"
"""The name of the main program. No label has a blank in it."""
_BY_NUMBER = " by number"
"""What is behind the label in the name of a program that M98 calls."""
_MOST = 500
"""So many subprograms of files; of a program that calls more nothing is said."""
_ACTING = frozenset(("word", "setting", "CALL"))
_graphs: Kept[Graph] = Kept()


class _Part(NamedTuple):
    """The lines of a routine with their rows, the label by which it is called, and the file in which it stands, if that is another one."""

    label: str
    rows: Sequence[int]
    lines: Sequence[Taken]
    file: str | None = None


def routines_of(analysis: Analysis) -> Generator[None, None, Mapping[str, Routine] | None]:
    """The routines by name, found in steps; None where the flow hangs on what nobody can see."""
    if analysis.document.faults:
        return None
    lines = yield from taken(analysis.document, analysis.settings["remap"])
    parts = _parts(lines) if lines is not None else None
    if parts is None:
        return None
    files = Files(analysis)
    numbered = _numbered(parts, files)
    _graphs.fit(sum(len(part.lines) for part in parts.values()))
    try:
        graphs: dict[str, Graph] = {}
        for name, part in parts.items():
            graphs[name] = yield from _graph(analysis, name, part.lines, numbered)
            yield
        called = frozenset().union(*(graph.callees for graph in graphs.values())) - parts.keys()
        elsewhere = yield from _of_files(analysis, files, set(called))
    except Torn:
        return None
    opened = yield from _opened(analysis, parts, graphs)
    times = Counter([*(part.label for part in parts.values()), *(part.label for part, _ in elsewhere)])
    found = {}
    for name, part in parts.items():
        # A file of that name would be called instead of the subprogram, so that no call is known to lead to it.
        is_hidden = name != MAIN and (times[part.label] > 1 or files.has(part.label))
        known = f"{name} " if is_hidden else name
        entry = _start(analysis, graphs[name]) if name == MAIN else opened.get(name)
        found[known] = Routine(known, part.rows, graphs[name], entry)
        yield
    for part, graph in elsewhere:
        # Of two subprograms of one name, or of one that also has another file, nobody knows which is called.
        is_hidden = times[part.label] > 1 or not _is_in_own_file(files, part)
        known = f"{part.label} of {part.file}" if is_hidden else part.label
        found[known] = Routine(known, part.rows, graph, None, [part.file or ""] * len(part.rows))
        yield
    return found


def _is_in_own_file(files: Files, part: _Part) -> bool:
    file = files.read(part.label)
    return file is None or file.path == part.file


def _parts(several: Several) -> dict[str, _Part] | None:
    """The lines of each routine. What stands behind a subprogram belongs to what stands before it."""
    lines = several.lines
    found: dict[str, list[slice]] = {MAIN: []}
    labels = {MAIN: ""}
    inside = outside = MAIN
    first = 0
    for at in [at for at, line in enumerate(lines) if line.parts_here]:
        line = lines[at]
        if line.bracket is not None and line.bracket.role is Role.END_REGION:
            found[inside].append(slice(first, at + 1))
            first, inside = at + 1, outside
            continue
        found[inside].append(slice(first, at))
        label = _label(line)
        first, inside = at, f"{label}{_BY_NUMBER}" if line.is_start else label or ""
        if label is None or inside in found or "DELETE" in line.node.kinds:
            return None
        labels[inside], found[inside] = label, []
        outside = inside if line.is_start else outside
    found[inside].append(slice(first, len(lines)))
    return {
        name: _Part(labels[name], _cut(several.rows, slices), _cut(lines, slices)) for name, slices in found.items()
    }


def _cut(items: Sequence[T], slices: Sequence[slice]) -> list[T]:
    return [item for each in slices for item in items[each]]


def _label(line: Taken) -> str | None:
    from deburr_grammar.dialects.rs274.outline import label_of

    if line.bracket is not None:
        return line.bracket.label
    label = next(line.node.find("label"), None)
    return label_of(line.node.text, label) if label is not None else None


def _numbered(parts: Mapping[str, _Part], files: Files) -> frozenset[str]:
    """The programs that M98 finds in this file and nowhere else."""
    labels = {part.label for name, part in parts.items() if name.endswith(_BY_NUMBER) and part.label not in parts}
    return frozenset(label for label in labels if not files.has(label))


def _graph(
    analysis: Analysis, name: str, lines: Sequence[Taken], numbered: frozenset[str]
) -> Generator[None, None, Graph]:
    settings, delete = analysis.settings, analysis.inputs.block_delete
    end = STOP if name == MAIN or name.endswith(_BY_NUMBER) else RETURN
    entered = numbered & {line.enters for line in lines} if numbered else numbered
    key = (end, settings["compare"], settings["profile"], delete, entered, tuple([line.node.text for line in lines]))
    found = _graphs.get(key)
    if found is None:
        graph = yield from Builder(lines, end, settings, delete, entered).graph()
        found = _graphs.add(key, graph, len(lines))
    return found


def _opened(
    analysis: Analysis, parts: Mapping[str, _Part], graphs: Mapping[str, Graph]
) -> Generator[None, None, dict[str, Env]]:
    """What routines start with that others may call than those of this program.

    A remapped code may set the local names of the one with the file's name. To a program that M98 calls anything may
    lead, also the end of the lines above it; and M98 may call a subprogram with a number.
    """
    stem = splitext(basename(analysis.file))[0].lower()
    library = len(parts) > 1 and not (yield from _has_main(analysis, parts))
    own = {stem} & parts.keys()
    called = any(line.enters for part in parts.values() for line in part.lines)
    subs = {name for name in parts if name != MAIN and not name.endswith(_BY_NUMBER)}
    names = subs if library else own & subs
    names |= {name for name in subs if called and name.isdecimal()}
    return {
        **{name: unset(graphs[name].locals, name not in own) for name in names},
        **{name: unset(graphs[name].locals, False) for name in parts if name.endswith(_BY_NUMBER)},
    }


def _has_main(analysis: Analysis, parts: Mapping[str, _Part]) -> Generator[None, None, bool]:
    """Whether anything is done outside of subprograms, other than to end the program."""
    outside = [part for name, part in parts.items() if name == MAIN or name.endswith(_BY_NUMBER)]
    subs = [(part.rows[0], part.rows[-1]) for part in parts.values() if part not in outside]
    ends = {row for part in outside for row, line in zip(part.rows, part.lines) if line.ends}

    def is_main(row: int) -> bool:
        return row not in ends and not any(first <= row <= last for first, last in subs)

    # The lines that take part are at hand; mostly they tell.
    rows = (row for part in outside for row, line in zip(part.rows, part.lines) if _acts(line.node.kinds))
    if any(map(is_main, rows)):
        return True
    for piece in analysis.document.pieces():
        acting = piece.where(lambda reading, shape: _acts(shape.facts(reading).kinds))
        if any(is_main(piece.line + at) for at, _, _ in acting):
            return True
        yield
    return False


def _acts(kinds: frozenset[str]) -> bool:
    return not kinds.isdisjoint(_ACTING)


def _start(analysis: Analysis, graph: Graph) -> Env:
    """What the main program starts with: its own names have no value, but for those that the run is given."""
    given = set(map(name_of, analysis.inputs.define))
    return unset(graph.locals - given, True)


def _of_files(analysis: Analysis, files: Files, labels: set[str]) -> Generator[None, None, list[tuple[_Part, Graph]]]:
    """The subprograms of the files of some labels, and of those that they call in their turn. What cannot be followed is left out."""
    found: list[tuple[_Part, Graph]] = []
    waiting, seen = sorted(labels), set(labels)
    while waiting:
        file = files.read(waiting.pop())
        for part in (yield from _parts_of(analysis, file)) if file is not None else ():
            graph = yield from _graph(analysis, part.label, part.lines, frozenset())
            found.append((part, graph))
            waiting += sorted(graph.callees - seen)
            seen |= graph.callees
        if len(found) > _MOST:
            raise Torn
        yield
    return found


def _parts_of(analysis: Analysis, file: File) -> Generator[None, None, list[_Part]]:
    lines = None
    if not file.document.faults:
        lines = yield from taken(file.document, analysis.settings["remap"])
    parts = _parts(lines) if lines is not None else None
    if parts is None or any(name.endswith(_BY_NUMBER) for name in parts):
        return []
    subs = [part._replace(file=file.path) for name, part in parts.items() if name != MAIN]
    try:
        for part in subs:
            yield from _graph(analysis, part.label, part.lines, frozenset())
    except Torn:
        return []
    return subs
