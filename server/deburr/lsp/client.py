"""What a client says of itself in `initialize`: read from its JSON as it comes. Imports nothing, because the answer must not wait for imports."""

from collections.abc import Mapping
from typing import Any, NamedTuple

ENCODINGS = ("utf-8", "utf-16", "utf-32")


class Client(NamedTuple):
    """What matters of a client. ``encoding``: the units in which both sides count columns."""

    encoding: str = "utf-16"
    folders: tuple[str, ...] = ()
    """The URIs of its folders."""
    process: int | None = None
    """Its process, without which the server is not to live."""
    options: Any = None
    """Its `initializationOptions`."""
    pulls: bool = False
    """Whether it asks for diagnostics; otherwise they are pushed."""
    refreshes: bool = False
    """Whether it can be told to ask for diagnostics again."""
    related_documents: bool = False
    configures: bool = False
    """Whether it answers `workspace/configuration`."""
    watches: bool = False
    """Whether it watches files when asked to."""
    tells_settings: bool = False
    """Whether it tells of changed settings when asked to."""
    hierarchy: bool = False
    """Whether document symbols may be a tree."""
    markdown: bool = True
    changes_versioned: bool = False
    """Whether edits of several documents may name versions."""
    creates: bool = False
    """Whether edits may make files."""
    resolves_actions: bool = False
    """Whether it asks for the edit of an action when it is chosen."""
    content: bool = False
    """Whether it asks for the text of virtual documents."""
    progress: bool = False
    """Whether it shows progress that the server begins."""
    refreshes_lenses: bool = False
    refreshes_hints: bool = False
    commands: tuple[str, ...] = ()
    """The commands of its own that it runs for the server."""
    trace: str = "off"


def client_of(params: Any) -> Client:
    """The client that sent these parameters; whatever is not as it should be counts as not said."""
    said = _Said(params)
    text, space = ("capabilities", "textDocument"), ("capabilities", "workspace")
    return Client(
        encoding=_encoding(said.get("capabilities", "general", "positionEncodings")),
        folders=_folders(said),
        process=process if isinstance(process := said.get("processId"), int) else None,
        options=said.get("initializationOptions"),
        pulls=isinstance(said.get(*text, "diagnostic"), Mapping),
        refreshes=said.flag(*space, "diagnostics", "refreshSupport"),
        related_documents=said.flag(*text, "diagnostic", "relatedDocumentSupport"),
        configures=said.flag(*space, "configuration"),
        watches=said.flag(*space, "didChangeWatchedFiles", "dynamicRegistration"),
        tells_settings=said.flag(*space, "didChangeConfiguration", "dynamicRegistration"),
        hierarchy=said.flag(*text, "documentSymbol", "hierarchicalDocumentSymbolSupport"),
        markdown=_markdown(said.get(*text, "hover", "contentFormat")),
        changes_versioned=said.flag(*space, "workspaceEdit", "documentChanges"),
        creates=said.flag(*space, "workspaceEdit", "documentChanges")
        and said.lists(*space, "workspaceEdit", "resourceOperations", item="create"),
        resolves_actions=said.lists(*text, "codeAction", "resolveSupport", "properties", item="edit"),
        content=isinstance(said.get(*space, "textDocumentContent"), Mapping),
        progress=said.flag("capabilities", "window", "workDoneProgress"),
        refreshes_lenses=said.flag(*space, "codeLens", "refreshSupport"),
        refreshes_hints=said.flag(*space, "inlayHint", "refreshSupport"),
        commands=_texts(said.get("capabilities", "experimental", "commands", "commands")),
        trace=trace if isinstance(trace := said.get("trace"), str) else "off",
    )


class _Said:
    """JSON in which nothing need be as it should."""

    def __init__(self, params: Any) -> None:
        self._params = params

    def get(self, *path: str) -> Any:
        """What stands under a path; None if nothing does."""
        found = self._params
        for name in path:
            found = found.get(name) if isinstance(found, Mapping) else None
        return found

    def flag(self, *path: str) -> bool:
        """Whether a path says yes."""
        return self.get(*path) is True

    def lists(self, *path: str, item: str) -> bool:
        """Whether a list under a path holds an item."""
        found = self.get(*path)
        return isinstance(found, list) and item in found


def _encoding(offered: Any) -> str:
    """The first that the client offers and the server knows; UTF-16 is what all must know."""
    known = [each for each in offered if each in ENCODINGS] if isinstance(offered, list) else []
    return known[0] if known else "utf-16"


def _folders(said: _Said) -> tuple[str, ...]:
    given = said.get("workspaceFolders")
    uris = [each.get("uri") for each in given if isinstance(each, Mapping)] if isinstance(given, list) else []
    found = tuple(uri for uri in uris if isinstance(uri, str))
    root = said.get("rootUri")
    return found or ((root,) if isinstance(root, str) else ())


def _texts(found: Any) -> tuple[str, ...]:
    return tuple(each for each in found if isinstance(each, str)) if isinstance(found, list) else ()


def _markdown(formats: Any) -> bool:
    return not isinstance(formats, list) or "markdown" in formats
