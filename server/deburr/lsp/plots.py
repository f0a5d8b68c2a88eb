"""Toolpaths for the editor's view: followed between messages, handed out in chunks, kept while nothing that they were made from changes."""

from __future__ import annotations

import asyncio
from collections.abc import Generator
from itertools import count
from typing import TYPE_CHECKING, NamedTuple

from deburr.lsp.idle import driven
from deburr.lsp.progress import Progress
from deburr.motion.follow import following
from deburr.motion.form import form_of
from deburr.motion.path import Recorder
from deburr.plot.columns import Scale, Toolpath, scale
from deburr.plot.extent import Reach, reaching
from deburr_grammar.text import split_lines

if TYPE_CHECKING:
    from deburr.lsp.previews import Made, Wanted
    from deburr.lsp.server import Server

_KEPT = 2
"""So many toolpaths are kept: as many views as people look at."""


class Plotted(NamedTuple):
    """A toolpath. ``stamp``: its number; chunks with the same one belong together."""

    stamp: int
    made: Made
    toolpath: Toolpath
    fine: Scale


class Plots:
    """The toolpaths of a session."""

    def __init__(self, server: Server) -> None:
        self._server = server
        self._kept: dict[Wanted, Plotted] = {}
        self._stamps = count(1)

    async def plotted(self, wanted: Wanted, token: int | str | None = None) -> Plotted | None:
        """The toolpath of a program; None if it is none. An edit meanwhile makes the work start again with what is there then."""
        previews = self._server.previews
        kept = self._kept.get(wanted)
        if kept is not None and previews.holds(wanted, kept.made):
            return kept
        self._kept.pop(wanted, None)
        while (made := await previews.made(wanted, token)) is not None:
            found = await self._followed(wanted, made, token)
            if found is not None:
                self._kept[wanted] = found
                while len(self._kept) > _KEPT:
                    del self._kept[next(iter(self._kept))]
                return found
        return None

    async def _followed(self, wanted: Wanted, made: Made, token: int | str | None) -> Plotted | None:
        """One toolpath; None if it was overtaken by an edit."""
        server, name = self._server, made.views[0].file.rpartition("/")[2]
        with Progress(server.protocol, server.client, f"Following {name}", token) as progress:
            work = _following(name, made, wanted.simulate)
            while server.previews.holds(wanted, made):
                try:
                    moves = driven(work)
                except StopIteration as done:
                    toolpath: Toolpath = done.value
                    return Plotted(next(self._stamps), made, toolpath, scale(toolpath))
                progress.say(f"{moves:,} lines followed")
                await asyncio.sleep(0)
        return None


def _following(name: str, made: Made, simulate: bool) -> Generator[int, None, Toolpath]:
    """A flat program's path and how far it goes, in slices."""
    expanded = made.expanded
    lines = split_lines(expanded.text)[: len(expanded.source_map)] if expanded.text else []
    recorder, followed, first = Recorder(), 0, made.views[0]
    for _ in following(lines, recorder, form_of(first.ruleset, first.host, simulate)):
        followed += 1
        yield followed
    path, reach = recorder.path(), Reach()
    for reach in reaching(path):  # noqa: B007 - the last one holds for all
        yield followed
    return Toolpath(name, path, expanded.source_map, lines, reach)
