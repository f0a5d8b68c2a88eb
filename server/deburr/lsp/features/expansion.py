"""Flat programs: by command, and as the text of virtual documents."""

from __future__ import annotations

import asyncio
from typing import Any
from urllib.parse import unquote, urlsplit

from lsprotocol import types
from pygls.exceptions import JsonRpcInvalidParams

from deburr.expand import Budget, Inputs
from deburr.ide.expansion import Expanded, expanding
from deburr.lsp.capabilities import COMMANDS, EXPANDED, PAGES
from deburr.lsp.convert import uri_to_file
from deburr.lsp.report import Json, diagnostics
from deburr.lsp.server import Server, feature
from deburr.page import markdown
from deburr.rule import rules_of
from deburr_grammar.dialects import NAMES, by_name


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
    return await _expanded(server, said)


@feature(types.WORKSPACE_TEXT_DOCUMENT_CONTENT)
async def on_content(server: Server, params: types.TextDocumentContentParams) -> types.TextDocumentContentResult:
    """The flat program of a source, or the page of a rule."""
    parts = urlsplit(params.uri)
    if parts.scheme == PAGES:
        return types.TextDocumentContentResult(_page(unquote(parts.path).strip("/").removesuffix(".md")))
    found = await run(server, source_of(params.uri), Inputs(), Budget())
    return types.TextDocumentContentResult(found.text if found is not None else "")


def source_of(uri: str) -> str:
    """The URI of the program whose flat form a URI means: `deburr-expanded:` before it, its own colon left out for files."""
    rest = uri.removeprefix(f"{EXPANDED}:")
    return f"file://{rest}" if rest.startswith("/") else rest


async def run(server: Server, uri: str, inputs: Inputs, budget: Budget) -> Expanded | None:
    """Expand a program between messages. An edit makes it start again with what is there then."""
    while (view := server.view(uri)) is not None:
        work = expanding(view, inputs, budget)
        while server.view(uri) is view:
            try:
                next(work)
            except StopIteration as done:
                found: Expanded = done.value
                return found
            await asyncio.sleep(0)
    return None


async def _expanded(server: Server, said: Json) -> Json | None:
    most = said.get("maxBlocks")
    budget = Budget(blocks=most) if isinstance(most, int) and most >= 0 else Budget()
    found = await run(server, said["uri"], _inputs(said), budget)
    if found is None:
        return None
    return {
        "uri": said["uri"],
        "text": found.text,
        "sourceMap": found.source_map.document("", server.session.uri),
        "findings": diagnostics(found.findings, server.session),
        "truncated": found.truncated,
    }


def _inputs(said: Json) -> Inputs:
    """The values that a command is given."""
    define = said.get("define")
    if not isinstance(define, dict):
        return Inputs()
    return Inputs(define={str(name).strip(): str(value).strip() for name, value in define.items()})


async def _looked_up(server: Server, said: Json) -> Json:
    """From a line of a source to its flat lines, or from a flat line to its origin with the calls and passes above it."""
    try:
        line = int(said["position"]["line"])
    except (KeyError, TypeError, ValueError):
        raise JsonRpcInvalidParams("`deburr.sourceMap` needs a `position`") from None
    flat = said["uri"].startswith(f"{EXPANDED}:")
    found = await run(server, source_of(said["uri"]) if flat else said["uri"], _inputs(said), Budget())
    if found is None:
        return {"uri": said["uri"], "ranges": []}
    if not flat:
        rows = found.source_map.lines_of(uri_to_file(said["uri"]), line)
        return {"uri": expanded_uri(said["uri"]), "ranges": [_row(row, []) for row in rows]}
    if not 0 <= line < len(found.source_map):
        return {"uri": source_of(said["uri"]), "ranges": []}
    origin = found.source_map.origin(line)
    frames = [{"uri": server.session.uri(each.file), **each._asdict()} for each in found.source_map.stack(line)]
    return {"uri": server.session.uri(origin.file), "ranges": [_row(origin.row, frames)]}


def _row(row: int, frames: list[Json]) -> Json:
    start = {"line": row, "character": 0}
    return {"range": {"start": start, "end": start}, "frames": frames}


def expanded_uri(uri: str) -> str:
    """The URI of a program's flat form."""
    return f"{EXPANDED}:{uri.removeprefix('file://')}"


def _explained(server: Server, uri: str) -> Json:
    """Which language a text is taken for, and why."""
    program = server.program(uri)
    view = server.view(uri)
    reason = program.reason if program is not None else ""
    return {"uri": uri, "dialect": view.dialect.name if view else None, "reason": reason, "file": uri_to_file(uri)}


def _page(name: str) -> str:
    """The manual page of a rule."""
    dialect = name.partition(".")[0]
    rules = rules_of(dialect) if dialect in NAMES else ()
    return next((markdown(rule, by_name(dialect)) for rule in rules if rule.name == name), "")
