"""The server: one loop that owns all programs. Messages come from a thread that only reads; everything else happens between them."""

from __future__ import annotations

import asyncio
import logging
import sys
import traceback
from collections.abc import Callable
from functools import cached_property, partial
from importlib import import_module
from inspect import iscoroutinefunction
from pkgutil import iter_modules
from threading import Thread
from time import monotonic
from typing import TYPE_CHECKING, Any, NamedTuple

from lsprotocol import types
from pygls.exceptions import JsonRpcException
from pygls.lsp.server import LanguageServer
from pygls.protocol import default_converter

from deburr import __version__
from deburr.lsp import features
from deburr.lsp.alive import watch
from deburr.lsp.checks import Checks
from deburr.lsp.garbage import Garbage
from deburr.lsp.idle import Idle
from deburr.lsp.previews import Previews
from deburr.lsp.protocol import Protocol
from deburr.lsp.publish import Publisher
from deburr.lsp.session import Open, Session
from deburr_grammar.text import Pos

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from deburr.ide.view import Spot as Place
    from deburr.ide.view import View
    from deburr.lsp.client import Client
    from deburr.lsp.convert import Units
    from deburr.lsp.plots import Plots
    from deburr.lsp.report import Json
    from deburr.lsp.start import Met
    from deburr.lsp.stream import Frames, Stream
    from deburr_grammar.text import Edit, Span

SWITCH = 0.0001
"""Seconds after which the reading thread may break in: a message must not wait for the work that is being done. The thread waits for messages nearly always, and then nothing is switched."""
_FEATURE = "deburr_method"
ERROR, INFO, DEBUG = 1, 3, 4
"""Levels of the client's log."""
_LONGEST = 1_000
"""Characters of parameters in a trace."""

_log = logging.getLogger("deburr")


class Spot(NamedTuple):
    """Where a request points."""

    view: View
    pos: Pos


class Server(LanguageServer):
    """A server for one client."""

    protocol: Protocol

    def __init__(self, client: Client, stream: Stream, loop: asyncio.AbstractEventLoop) -> None:
        super().__init__("deburr", __version__, protocol_cls=Protocol, converter_factory=default_converter)
        self.client = client
        self.stream = stream
        self.loop = loop
        self.over: asyncio.Future[int] = loop.create_future()
        self.protocol.set_writer(stream)
        self.garbage = Garbage(loop)
        self.idle = Idle(loop, self.failed)
        self.idle.worked = self.garbage.worked
        self.idle.called = lambda: self.come != self._taken
        self.come = self._taken = 0
        """Messages that have come, which the reading thread counts, and those of them that were taken up."""
        self.session = Session(client, self.complain)
        self.publisher = Publisher(self.protocol, self.session)
        self.checks = Checks(self.session, self.idle, self._said, self.failed)
        self.publisher.checks = self.checks
        self.checks.done = self.garbage.checked
        self.checks.depended = self.publisher.refresh
        self.previews = Previews(self)
        self.checks.changed = self.previews.changed
        self.protocol.trace = trace_of(client.trace)
        self.coloured: dict[str, list[int]] = {}
        """Colours that were sent, by the names that they were sent with."""
        for method, function in found_features():
            self.feature(method)(_safe(self, function))

    def take(self, body: bytes) -> None:
        """Take one message that was counted when it came."""
        self._taken += 1
        self.receive(body)

    @cached_property
    def plots(self) -> Plots:
        """The toolpaths; most sessions have none, and loading what follows them takes as long as a hundred hovers."""
        from deburr.lsp.plots import Plots

        return Plots(self)

    def receive(self, body: bytes) -> None:
        """Take one message; whatever goes wrong with it, the next one is taken as well."""
        self.garbage.heard()
        try:
            self.protocol.receive(body)
        except BrokenPipeError:
            self.end(1)
        except Exception as error:
            self.failed(error)

    def end(self, code: int) -> None:
        """Leave the loop."""
        if not self.over.done():
            self.over.set_result(code)

    def ended(self) -> None:
        """The client has gone."""
        self.end(0 if self.protocol._shutdown else 1)

    @property
    def units(self) -> Units:
        """The units of the client's columns."""
        return self.session.units

    def json_range(self, view: View, line: int, span: Span) -> Json:
        """A stretch of a line for the client, where hundreds are sent and objects would cost too much."""
        text = view.document.line(line)
        ends = [{"line": line, "character": self.units.col_to_units(text, col)} for col in span]
        return {"start": ends[0], "end": ends[1]}

    def location(self, spot: Place) -> types.Location:
        """A place in a file for the client."""
        lines = self.session.lines(spot.file)
        return types.Location(self.session.uri(spot.file), self.units.range(lines, spot.line, spot.span))

    def workspace_edit(self, edits: Mapping[str, Sequence[Edit]]) -> types.WorkspaceEdit:
        """Edits of files for the client, for the versions that it has."""
        changes: dict[str, Sequence[types.TextEdit]] = {}
        versioned: list[types.TextDocumentEdit] = []
        for file, each in edits.items():
            uri, lines, program = self.session.uri(file), self.session.lines(file), self.session.open_files.get(file)
            changes[uri] = [self.units.text_edit(lines, edit) for edit in each]
            document = types.OptionalVersionedTextDocumentIdentifier(uri, program.version if program else None)
            versioned.append(types.TextDocumentEdit(document, list(changes[uri])))
        if self.client.changes_versioned:
            return types.WorkspaceEdit(document_changes=versioned)
        return types.WorkspaceEdit(changes=changes)

    def spot(self, params: Any) -> Spot | None:
        """The program and the place that a request means; None if it is no program."""
        view = self.view(params.text_document.uri)
        return None if view is None else Spot(view, self.session.units.pos(view.document, params.position))

    def view(self, uri: str) -> View | None:
        """The program of a URI, open or not."""
        program = self.program(uri)
        if program is not None:
            return program.view
        from deburr.lsp.convert import uri_to_file

        return self.session.view(uri_to_file(uri))

    def program(self, uri: str) -> Open | None:
        """The open text of a URI."""
        return self.session.open.get(uri)

    def complain(self, message: str) -> None:
        """Tell the user what must be mended outside of programs."""
        self.protocol.send({"method": "window/showMessage", "params": {"type": 1, "message": f"deburr: {message}"}})

    def log(self, message: str, level: int = INFO) -> None:
        """Say something in the client's log."""
        self.protocol.send({"method": "window/logMessage", "params": {"type": level, "message": message}})

    def traced(self, method: str, seconds: float, params: Any) -> None:
        """Say what was done, to clients that want to know."""
        if self.protocol.trace is types.TraceValue.Off:
            return
        said: dict[str, Any] = {"message": f"{method} took {seconds * 1000:.1f} ms"}
        if self.protocol.trace is types.TraceValue.Verbose:
            said["verbose"] = str(params)[:_LONGEST]
        self.protocol.send({"method": types.LOG_TRACE, "params": said})

    def failed(self, error: Exception) -> None:
        """Something is wrong with deburr itself: say so in the log and go on."""
        said = "".join(traceback.format_exception(error))
        _log.error("%s", said)
        self.log(said, ERROR)

    def report_server_error(self, error: Exception, source: Any) -> None:
        """What pygls could not do is logged."""
        if not isinstance(error, JsonRpcException) or "Cancelled" not in type(error).__name__:
            _log.error("%s", error)

    def _said(self, file: str) -> None:
        self.publisher.changed(file)


def feature(method: str) -> Callable[[Callable[..., Any]], Callable[..., Any]]:
    """Make a function the handler of a method: it is called with the server and the parameters."""

    def made(function: Callable[..., Any]) -> Callable[..., Any]:
        setattr(function, _FEATURE, method)
        return function

    return made


def trace_of(said: str) -> types.TraceValue:
    """How much a client wants to be told of what is done; what is none of the levels counts as not said."""
    return next((each for each in types.TraceValue if each.value == said), types.TraceValue.Off)


def found_features() -> list[tuple[str, Callable[..., Any]]]:
    """All handlers, read off the files in `features`."""
    modules = [import_module(f"{features.__name__}.{each.name}") for each in iter_modules(features.__path__)]
    functions = [value for module in modules for value in vars(module).values() if callable(value)]
    return [(getattr(each, _FEATURE), each) for each in functions if hasattr(each, _FEATURE)]


def run(stream: Stream, frames: Frames, met: Met) -> int:
    """Serve a client whose `initialize` was answered; the exit code."""
    sys.setswitchinterval(SWITCH)
    logging.getLogger("pygls").setLevel(logging.CRITICAL)
    loop = asyncio.new_event_loop()
    asyncio.set_event_loop(loop)
    server = Server(met.client, stream, loop)
    for body in met.waiting:
        loop.call_soon(server.receive, body)
    Thread(target=_read, args=(stream, frames, server), daemon=True).start()
    if met.client.process is not None:
        watch(met.client.process, loop, partial(server.end, 1))
    code = loop.run_until_complete(server.over)
    stream.close()
    return code


def _read(stream: Stream, frames: Frames, server: Server) -> None:
    """Hand messages to the loop as they come in; runs in a thread of its own."""
    while data := stream.receive():
        for body in frames.feed(data):
            server.come += 1
            server.loop.call_soon_threadsafe(server.take, body)
    server.loop.call_soon_threadsafe(server.ended)


def _bare(error: JsonRpcException) -> JsonRpcException:
    """An answer without the frames that it came through: they hold the program, and the future that holds the answer is in one of them."""
    error.__context__ = error.__cause__ = None
    return error.with_traceback(None)


def _safe(server: Server, function: Callable[..., Any]) -> Callable[..., Any]:
    """The handler for pygls: one that goes wrong answers nothing, and the fault is logged."""
    method = getattr(function, _FEATURE)
    if iscoroutinefunction(function):

        async def later(params: Any) -> Any:
            started = monotonic()
            try:
                return await function(server, params)
            except JsonRpcException as error:
                raise _bare(error) from None
            except asyncio.CancelledError:
                raise
            except Exception as error:
                server.failed(error)
                return None
            finally:
                server.traced(method, monotonic() - started, params)

        return later

    def now(params: Any) -> Any:
        started = monotonic()
        try:
            return function(server, params)
        except JsonRpcException as error:
            raise _bare(error) from None
        except Exception as error:
            server.failed(error)
            return None
        finally:
            server.traced(method, monotonic() - started, params)

    return now
