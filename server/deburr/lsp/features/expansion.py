"""Flat programs: by command, as the text of virtual documents, and the way between them and their sources."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any
from urllib.parse import unquote

from lsprotocol import types
from pygls.exceptions import JsonRpcInvalidParams

from deburr.catalogue import rules_of
from deburr.config import settings_of
from deburr.detect import detect
from deburr.expand import interpreter
from deburr.lsp.capabilities import COMMANDS, EXPANDED, PAGES
from deburr.lsp.convert import uri_to_file
from deburr.lsp.previews import Wanted, expanded_uri, wanted_by, wanted_of
from deburr.lsp.report import Json, diagnostics
from deburr.lsp.server import Server, feature
from deburr.lsp.settings import paths_to
from deburr.page import markdown
from deburr_grammar.dialects import NAMES, by_name
from deburr_grammar.text import split_lines

if TYPE_CHECKING:
    from deburr.ide.expansion import Expanded
    from deburr_grammar.dialect import Dialect

_ARGUMENTS = {"block_delete": "blockDelete", "machine_values": "machineValues", "keep_n": "keepN"}
"""What an interpreter heeds, as an argument of `deburr.expand`."""


@feature(types.WORKSPACE_EXECUTE_COMMAND)
async def on_command(server: Server, params: types.ExecuteCommandParams) -> Any:
    """One of deburr's own commands."""
    said = params.arguments[0] if params.arguments else None
    if params.command not in COMMANDS or not isinstance(said, dict) or not isinstance(said.get("uri"), str):
        raise JsonRpcInvalidParams(f"`{params.command}` is no command, or is given no `uri`")
    if params.command == "deburr.explainDialect":
        return _explained(server, said["uri"])
    if params.command == "deburr.sourceMap":
        return await _looked_up(server, said)
    if params.command == "deburr.plot":
        from deburr.lsp.plotting import plot

        return await plot(server, said, params.work_done_token)
    return await _expanded(server, said, params.work_done_token)


@feature(types.WORKSPACE_TEXT_DOCUMENT_CONTENT)
async def on_content(server: Server, params: types.TextDocumentContentParams) -> types.TextDocumentContentResult:
    """The flat program of a source, or the page of a rule."""
    scheme, _, path = params.uri.partition(":")
    if scheme == PAGES:
        return types.TextDocumentContentResult(_page(unquote(path).strip("/").removesuffix(".md")))
    return types.TextDocumentContentResult(await server.previews.content(params.uri))


async def _expanded(server: Server, said: Json, token: int | str | None) -> Json | None:
    found = await server.previews.expanded(wanted_by(said), token)
    if found is None:
        return None
    return {
        "uri": said["uri"],
        "text": found.text,
        "sourceMap": found.source_map.document("", server.session.uri),
        "findings": diagnostics(found.findings, server.session),
        "truncated": found.truncated,
    }


async def _looked_up(server: Server, said: Json) -> Json:
    """From a line of a source to its flat lines, or from a flat line to its origin; each with the calls and passes above it.

    A source that is no program by itself, such as a snippet, is looked for in `program`, or in what was expanded last.
    """
    try:
        line = int(said["position"]["line"])
    except (KeyError, TypeError, ValueError):
        raise JsonRpcInvalidParams("`deburr.sourceMap` needs a `position`") from None
    uri: str = said["uri"]
    if uri.startswith(f"{EXPANDED}:"):
        given = wanted_of(uri)
        wanted = wanted_by({**said, "uri": given.uris[0]}) if said.get("define") else given
        found = await server.previews.expanded(wanted)
        return {"uri": wanted.uris[0], "ranges": []} if found is None else _origin(server, wanted.uris[0], found, line)
    wanted = _program_with(server, said)
    found = await server.previews.expanded(wanted)
    if found is None or not found.text:
        return {"uri": expanded_uri(wanted.uris[0]), "ranges": []}
    rows = found.source_map.lines_of(uri_to_file(uri), line)
    texts = split_lines(found.text) if rows else []
    ranges = [_ranged(server, row, texts[row], _frames(server, found, row)) for row in rows]
    return {"uri": expanded_uri(wanted.uris[0]), "ranges": ranges}


def _program_with(server: Server, said: Json) -> Wanted:
    """The program in which the lines of a source are looked for."""
    program = said.get("program")
    if program is not None:
        if not isinstance(program, str):
            raise JsonRpcInvalidParams("`program` is the URI of a program")
        return wanted_by({**said, "uri": program})
    own = wanted_by(said)
    return own if own.define else server.previews.with_file(uri_to_file(said["uri"])) or own


def _origin(server: Server, uri: str, found: Expanded, line: int) -> Json:
    """Where a flat line comes from."""
    if not 0 <= line < len(found.source_map):
        return {"uri": uri, "ranges": []}
    origin = found.source_map.origin(line)
    text = server.session.lines(origin.file)(origin.row)
    ranged = _ranged(server, origin.row, text, _frames(server, found, line))
    return {"uri": server.session.uri(origin.file), "ranges": [ranged]}


def _frames(server: Server, found: Expanded, line: int) -> list[Json]:
    """The calls and passes above a flat line, innermost first."""
    frames = []
    for each in found.source_map.stack(line):
        text = server.session.lines(each.file)(each.row)
        frames.append({"uri": server.session.uri(each.file), **each._asdict(), "range": _line(server, each.row, text)})
    return frames


def _ranged(server: Server, row: int, text: str, frames: list[Json]) -> Json:
    return {"range": _line(server, row, text), "frames": frames}


def _line(server: Server, row: int, text: str) -> Json:
    """All of a line."""
    end = server.units.col_to_units(text, len(text))
    return {"start": {"line": row, "character": 0}, "end": {"line": row, "character": end}}


def _explained(server: Server, uri: str) -> Json:
    """Which language a text is taken for, and why; of a file that is not open as it is on disk."""
    program, file = server.program(uri), uri_to_file(uri)
    if program is not None:
        dialect, reason = program.view.dialect.name if program.view is not None else None, program.reason
    else:
        text = server.session.files.read(file) if paths_to(file) else None
        if text is None:
            return {"uri": uri, "dialect": None, "reason": "there is no such file", "file": file}
        dialect, reason = detect(file, text, server.session.settings.hints(file, None))
    said = _of_language(server, by_name(dialect), file) if dialect else {}
    return {"uri": uri, "dialect": dialect, "reason": reason, "file": file, **said}


def _of_language(server: Server, dialect: Dialect, file: str) -> Json:
    """A language's title, the profile by which the file is read, and which arguments of `deburr.expand` it heeds besides `define`."""
    settings = settings_of(dialect, server.session.settings.of(file))
    heeded = [*getattr(interpreter(dialect.name), "FOLLOWS", ()), *(name for name in ("input",) if name in settings)]
    return {
        "title": dialect.title,
        "profile": settings.get("profile"),
        "takes": [_ARGUMENTS.get(name, name) for name in heeded],
    }


def _page(name: str) -> str:
    """The manual page of a rule."""
    dialect = name.partition(".")[0]
    rules = rules_of(dialect) if dialect in NAMES else ()
    return next((markdown(rule, by_name(dialect)) for rule in rules if rule.name == name), "")
