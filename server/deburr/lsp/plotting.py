"""The answer of `deburr.plot`: a toolpath's chunk, with all that is said once beside the first."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pygls.exceptions import JsonRpcInvalidParams

from deburr.lsp.previews import wanted_by
from deburr.lsp.report import Json, diagnostics
from deburr.plot.columns import chunk, header

if TYPE_CHECKING:
    from deburr.lsp.plots import Plotted
    from deburr.lsp.server import Server


async def plot(server: Server, said: Json, token: int | str | None) -> Json | None:
    """The arguments are those of `deburr.expand`, `chunk` (0 if it is left out), and the `stamp` of the chunks that it belongs to.

    `segments` is null if the program has errors, or if it has become another one since that stamp: then ask from the first on.
    """
    number, stamp = _count(said, "chunk"), _count(said, "stamp")
    wanted = wanted_by({name: value for name, value in said.items() if name not in ("chunk", "stamp")})
    found = await server.plots.plotted(wanted, token)
    if found is None:
        return None
    another = bool(stamp) and stamp != found.stamp
    if number >= found.toolpath.chunks and not another:
        raise JsonRpcInvalidParams(f"`chunk` is {number}, and there are {found.toolpath.chunks}")
    nothing = another or not found.toolpath.flat
    answer = {
        "uri": said["uri"],
        "stamp": found.stamp,
        "chunk": number,
        "chunks": found.toolpath.chunks,
        "segments": None if nothing else chunk(found.toolpath, found.fine, number),
    }
    return answer if number else answer | _once(server, found)


def _once(server: Server, found: Plotted) -> Json:
    expanded = found.made.expanded
    files = expanded.source_map.files
    sources = [{"name": file.rpartition("/")[2], "uri": server.session.uri(file)} for file in files]
    return {
        "header": header(found.toolpath, found.fine, sources),
        "findings": diagnostics(expanded.findings, server.session),
        "truncated": expanded.truncated,
    }


def _count(said: Json, name: str) -> int:
    value = said.get(name, 0)
    if not isinstance(value, int) or isinstance(value, bool) or value < 0:
        raise JsonRpcInvalidParams(f"`{name}` cannot be {value!r}")
    return value
