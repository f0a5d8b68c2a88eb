"""Flat programs for the editor: run between messages, kept while nothing that they were made from changes, asked for again when it does."""

from __future__ import annotations

import asyncio
import json
from collections.abc import Iterable, Mapping
from contextlib import closing
from dataclasses import replace
from itertools import count
from typing import TYPE_CHECKING, Any, NamedTuple
from urllib.parse import unquote

from pygls.exceptions import JsonRpcInvalidParams

from deburr.expand import Budget, Inputs
from deburr.expand.job import EXACT
from deburr.host import NoFiles
from deburr.ide.expansion import Expanded, expanding, instead
from deburr.inputs import EDITOR
from deburr.lsp.capabilities import EXPANDED
from deburr.lsp.convert import uri_to_file
from deburr.lsp.idle import driven
from deburr.lsp.progress import Progress
from deburr.needs import Needs

if TYPE_CHECKING:
    from deburr.ide.view import View
    from deburr.lsp.server import Server

_KEPT = 4
"""So many flat programs are kept."""
_LONGEST = 200_000
"""Lines of a flat program that is kept."""
_SERVED = 64
"""So many virtual documents are watched."""


class Wanted(NamedTuple):
    """What is to be expanded: programs, joined in order, and what their run is given; ``settings`` are laid over the configuration."""

    uris: tuple[str, ...]
    define: tuple[tuple[str, str], ...] = ()
    block_delete: bool | None = None
    simulate: bool = False
    keep_n: bool = False
    decimals: int | None = None
    reached_only: bool = False
    budget: Budget = Budget()
    settings: tuple[tuple[str, str], ...] = ()
    text: str | None = None
    """What stands in place of the first program's own text."""

    @property
    def inputs(self) -> Inputs:
        """What the run is given."""
        return Inputs(
            dict(self.define),
            self.block_delete,
            self.simulate,
            self.keep_n,
            self.decimals,
            reached_only=self.reached_only,
            ways=EDITOR,
        )


class Made(NamedTuple):
    """A flat program, the versions of the programs that it was made from, and all that was asked of other files for it."""

    views: tuple[View, ...]
    needs: Needs | None
    expanded: Expanded


class Previews:
    """The flat programs of a session."""

    def __init__(self, server: Server) -> None:
        self._server = server
        self._made: dict[Wanted, Made] = {}
        self._served: dict[str, tuple[Wanted, frozenset[str], Needs | None]] = {}
        self._numbers = count(1)
        self._instead: tuple[View, str, View] | None = None

    async def expanded(self, wanted: Wanted, token: int | str | None = None) -> Expanded | None:
        """Expand programs between messages; None if one is none."""
        made = await self.made(wanted, token)
        return made.expanded if made is not None else None

    async def made(self, wanted: Wanted, token: int | str | None = None) -> Made | None:
        """The same with what it was made from. An edit of a program makes the run start again with what is there then."""
        while (views := self._views(wanted)) is not None:
            kept = self._made.get(wanted)
            if kept is not None and self.holds(wanted, kept):
                return kept
            made = await self._run(wanted, views, token)
            if made is not None:
                self._keep(wanted, made)
                return made
        return None

    def holds(self, wanted: Wanted, made: Made) -> bool:
        """Whether a flat program is still what its programs come to."""
        return _same(made.views, self._views(wanted) or ()) and not (made.needs is not None and made.needs.stale())

    async def content(self, uri: str) -> str:
        """The text of a virtual document; from now on the client is told when it is another."""
        wanted = wanted_of(uri)
        found = await self.expanded(wanted)
        made = self._made.get(wanted)
        files = frozenset(uri_to_file(each) for each in wanted.uris)
        self._served.pop(uri, None)
        self._served[uri] = wanted, files, made.needs if made is not None else None
        while len(self._served) > _SERVED:
            del self._served[next(iter(self._served))]
        return found.text if found is not None else ""

    def changed(self, files: Iterable[str]) -> None:
        """These files are not as they were: what was made from them is asked for again."""
        host, files = self._server.session.files, set(files)
        for wanted, made in list(self._made.items()):
            if made.needs is not None and any(made.needs.concerned(file, host) for file in files):
                del self._made[wanted]
        for uri, (_, own, needs) in self._served.items():
            if own & files if needs is None else any(needs.concerned(file, host) for file in files):
                request = {"id": f"deburr-preview-{next(self._numbers)}", "params": {"uri": uri}}
                self._server.protocol.send({"method": "workspace/textDocumentContent/refresh", **request})

    def forget(self) -> None:
        """The configuration is another one."""
        self._made.clear()
        self.changed(file for _, own, _ in self._served.values() for file in own)

    def with_file(self, file: str) -> Wanted | None:
        """What was expanded last that a file had a part in, though it is not the program itself."""
        found = (wanted for wanted, made in self._made.items() if file in made.expanded.source_map.files)
        return next(reversed(list(found)), None)

    async def _run(self, wanted: Wanted, views: tuple[View, ...], token: int | str | None) -> Made | None:
        """One run; None if it was overtaken by an edit."""
        first = views[0]
        needs = None if isinstance(first.host, NoFiles) else Needs(first.host)
        seen = views
        if needs is not None:
            seen = tuple(replace(view, host=needs) for view in views)
            for view in views:
                needs.read(view.file)
        name = first.file.rpartition("/")[2]
        with (
            Progress(self._server.protocol, self._server.client, f"Expanding {name}", token) as progress,
            closing(expanding(seen[0], wanted.inputs, wanted.budget, seen[1:])) as work,
        ):
            while _same(self._views(wanted) or (), views):
                try:
                    steps = driven(work)
                except StopIteration as done:
                    return Made(views, needs, done.value)
                progress.say(f"{steps:,} blocks executed" if steps else "checking")
                await asyncio.sleep(0)
        return None

    def _views(self, wanted: Wanted) -> tuple[View, ...] | None:
        found = [self._server.view(uri) for uri in wanted.uris]
        views = tuple(view for view in found if view is not None)
        if len(views) < len(found) or len({view.dialect.name for view in views}) != 1:
            return None
        if wanted.text is not None:
            views = (self._with_text(views[0], wanted.text), *views[1:])
        if not wanted.settings:
            return views
        given = [self._server.session.given(view, wanted.settings) for view in views]
        if None in given:
            names = " and ".join(f"`{name}`" for name, _ in wanted.settings)
            raise JsonRpcInvalidParams(f"{names}: {views[0].dialect.title} programs have no such input")
        return tuple(view for view in given if view is not None)

    def _with_text(self, view: View, text: str) -> View:
        """The program with another text; the same as long as both are the same, because a run asks again and again."""
        kept = self._instead
        if kept is None or kept[0] is not view or kept[1] != text:
            kept = self._instead = view, text, instead(view, text)
        return kept[2]

    def _keep(self, wanted: Wanted, made: Made) -> None:
        self._made.pop(wanted, None)
        if len(made.expanded.source_map) <= _LONGEST:
            self._made[wanted] = made
        while len(self._made) > _KEPT:
            del self._made[next(iter(self._made))]


def wanted_by(said: Mapping[str, Any]) -> Wanted:
    """What the arguments of `deburr.expand` ask for; JsonRpcInvalidParams names what cannot be used."""
    known = {"uri", "with", "define", "input", "maxBlocks", "maxSteps", "blockDelete", "machineValues", "keepN", "decimals", "reachedOnly", "position", "program", "text"}  # fmt: skip
    if unknown := sorted(set(said) - known):
        raise JsonRpcInvalidParams(f"`{unknown[0]}` is no argument; there are {', '.join(sorted(known))}")
    limits = Budget()
    return Wanted(
        uris=(said["uri"], *_of(said, "with", list, [])),
        define=tuple((str(name).strip(), str(value).strip()) for name, value in _of(said, "define", dict, {}).items()),
        block_delete=_one_of(said, "blockDelete", {"on": True, "off": False}),
        simulate=_one_of(said, "machineValues", {"simulate": True, "refuse": False}) or False,
        keep_n=_of(said, "keepN", bool, False),
        decimals=EXACT if said.get("decimals") == "exact" else _of(said, "decimals", int, None),
        reached_only=_of(said, "reachedOnly", bool, False),
        budget=Budget(_of(said, "maxSteps", int, limits.steps), _of(said, "maxBlocks", int, limits.blocks)),
        settings=(("input", uri_to_file(_of(said, "input", str, ""))),) if said.get("input") else (),
        text=_of(said, "text", str, None),
    )


def wanted_of(uri: str) -> Wanted:
    """What the URI of a flat program asks for: `deburr-expanded:` and the source's own, for files without `file://`; as query, the other arguments in JSON."""
    rest, _, query = uri.removeprefix(f"{EXPANDED}:").partition("?")
    source = f"file://{rest}" if rest.startswith("/") else rest
    try:
        said = json.loads(unquote(query)) if query else {}
    except (ValueError, RecursionError):
        said = None
    if not isinstance(said, dict):
        raise JsonRpcInvalidParams(f"`{query}` is no JSON object with arguments")
    return wanted_by({**said, "uri": source})


def expanded_uri(uri: str) -> str:
    """The URI of a program's flat form."""
    return f"{EXPANDED}:{uri.removeprefix('file://')}"


def _of(said: Mapping[str, Any], key: str, kind: type, default: Any) -> Any:
    value = said.get(key)
    if value is None:
        return default
    good = isinstance(value, kind) and not (kind is int and isinstance(value, bool))
    if isinstance(value, int):
        good = good and value >= 0
    elif isinstance(value, list):
        good = good and all(isinstance(each, str) for each in value)
    if not good:
        raise JsonRpcInvalidParams(f"`{key}` cannot be {value!r}")
    return value


def _one_of(said: Mapping[str, Any], key: str, choices: Mapping[str, bool]) -> bool | None:
    value = said.get(key)
    if value is not None and (not isinstance(value, str) or value not in choices):
        raise JsonRpcInvalidParams(f"`{key}` is {' or '.join(f'`{each}`' for each in choices)}, not {value!r}")
    return None if value is None else choices[value]


def _same(one: tuple[View, ...], other: tuple[View, ...]) -> bool:
    """Whether these are the same versions of the same programs under the same rules."""
    pairs = zip(one, other)
    return len(one) == len(other) and all(a.document is b.document and a.ruleset is b.ruleset for a, b in pairs)
