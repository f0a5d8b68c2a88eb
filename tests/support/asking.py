"""The questions of a client's session, one for each row of the table of cells, and their answers as lines."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from lsprotocol import types
from lsprotocol.converters import get_converter

from support.cells import (
    Cell,
    Json,
    Names,
    action,
    call_item,
    colours,
    diagnostic,
    edit,
    location,
    place,
    symbol,
    workspace_edit,
)
from support.client import Client, Refused
from support.plots import unpacked

CAPABILITIES: Json = {
    "general": {"positionEncodings": ["utf-16"]},
    "textDocument": {
        "documentSymbol": {"hierarchicalDocumentSymbolSupport": True},
        "codeAction": {"resolveSupport": {"properties": ["edit"]}, "dataSupport": True},
        "diagnostic": {},
    },
    "workspace": {
        "textDocumentContent": {},
        "workspaceEdit": {"documentChanges": True, "resourceOperations": ["create"]},
        "workspaceFolders": True,
    },
    "experimental": {"commands": {"commands": ["deburr.showReferences"]}},
}
_CONVERTER = get_converter()
_OPTIONS = {"tabSize": 4, "insertSpaces": True}

Question = Callable[["Asking"], Iterator[str]]
QUESTIONS: dict[str, Question] = {}


class Asking:
    """A session with a document open in it, and a cursor."""

    def __init__(self, client: Client, offered: Json, cell: Cell, folder: Path, uri: str) -> None:
        self.client = client
        self.offered = offered
        self.cell = cell
        self.names = Names(folder)
        self.uri = uri
        start, end = cell.places
        self.start = start
        self.range = {"start": start, "end": end}

    def ask(self, method: str, **more: Any) -> Any:
        """The answer, which must be what the protocol says of the method."""
        answer = self.client.request(method, {**more, **self.cell.more})
        if method in types.METHOD_TO_TYPES:
            response = types.METHOD_TO_TYPES[method][1]
            assert response is not None
            _CONVERTER.structure({"jsonrpc": "2.0", "id": 1, "result": answer}, response)
        return answer

    def about(self, method: str, **more: Any) -> Any:
        """The answer to a question about the document."""
        return self.ask(f"textDocument/{method}", textDocument={"uri": self.uri}, **more)

    def at(self, method: str, **more: Any) -> Any:
        """The answer to a question about the cursor."""
        return self.about(method, position=self.start, **more)

    def command(self, name: str, **more: Any) -> Any:
        """The answer to a command about the document."""
        arguments = [{"uri": self.uri, **more, **self.cell.more}]
        return self.client.request("workspace/executeCommand", {"command": name, "arguments": arguments})


def answer(asking: Asking) -> str:
    """What is answered, as lines; a refusal in its words."""
    try:
        return "\n".join(QUESTIONS[asking.cell.row](asking))
    except Refused as why:
        return f"refused: {why}"


def is_nothing(said: str) -> bool:
    """Whether an answer is that there is none."""
    return not said or said.startswith("refused: ")


def question(row: str) -> Callable[[Question], Question]:
    """A row of the table. Its first word is the method."""

    def added(ask: Question) -> Question:
        assert row not in QUESTIONS
        QUESTIONS[row] = ask
        return ask

    return added


@question("textDocument/diagnostic")
def _diagnostics(asking: Asking) -> Iterator[str]:
    found = asking.about("diagnostic")
    yield from map(diagnostic, found["items"])
    again = asking.about("diagnostic", previousResultId=found["resultId"])
    assert again == {"kind": "unchanged", "resultId": found["resultId"]}


@question("workspace/diagnostic")
def _everywhere(asking: Asking) -> Iterator[str]:
    found = asking.ask("workspace/diagnostic", previousResultIds=[])["items"]
    for each in sorted(found, key=lambda each: str(each["uri"])):
        yield asking.names.of(each["uri"])
        yield from (f"  {diagnostic(one)}" for one in each["items"])
    known = [{"uri": each["uri"], "value": each["resultId"]} for each in found]
    again = asking.ask("workspace/diagnostic", previousResultIds=known)["items"]
    assert [each["kind"] for each in again] == ["unchanged"] * len(found)


@question("textDocument/hover")
def _hover(asking: Asking) -> Iterator[str]:
    found = asking.at("hover")
    if found is not None:
        yield place(found["range"])
        yield found["contents"]["value"]


@question("textDocument/hover behind a fault")
def _hover_behind(asking: Asking) -> Iterator[str]:
    assert asking.about("diagnostic")["items"]
    yield from _hover(asking)


@question("textDocument/completion")
def _completion(asking: Asking) -> Iterator[str]:
    found = asking.at("completion")
    assert found["isIncomplete"] is False
    yield from dict.fromkeys(place(each["textEdit"]["range"]) for each in found["items"])
    for each in found["items"]:
        assert each["label"] == each["textEdit"]["newText"]
        yield f"{each['label']} {each['kind']} {each.get('detail', '')}".rstrip()


@question("completionItem/resolve")
def _resolved(asking: Asking) -> Iterator[str]:
    first = asking.at("completion")["items"][0]
    found = asking.client.request("completionItem/resolve", first)
    yield f"{found['label']}: {found['detail']}"
    yield found["documentation"]["value"]


@question("textDocument/signatureHelp")
def _signature(asking: Asking) -> Iterator[str]:
    found = asking.at("signatureHelp")
    if found is not None:
        (one,) = found["signatures"]
        yield one["label"]
        start, end = one["parameters"][found["activeParameter"]]["label"]
        yield one["label"][start:end]


def _locations(row: str, **more: Any) -> None:
    @question(f"textDocument/{row}")
    def ask(asking: Asking) -> Iterator[str]:
        yield from (location(each, asking.names) for each in asking.at(row, **more))


_locations("definition")
_locations("declaration")
_locations("references", context={"includeDeclaration": True})


@question("textDocument/documentHighlight")
def _highlights(asking: Asking) -> Iterator[str]:
    kinds = ("", "text", "read", "write")
    yield from (f"{place(each['range'])} {kinds[each['kind']]}" for each in asking.at("documentHighlight"))


@question("textDocument/prepareRename")
def _prepared(asking: Asking) -> Iterator[str]:
    found = asking.at("prepareRename")
    yield f"{place(found['range'])} {found['placeholder']}"


@question("textDocument/rename")
def _renamed(asking: Asking) -> Iterator[str]:
    yield from workspace_edit(asking.at("rename"), asking.names)


@question("textDocument/rename that would change the meaning")
def _refused(asking: Asking) -> Iterator[str]:
    yield from workspace_edit(asking.at("rename"), asking.names)


@question("textDocument/documentSymbol")
def _symbols(asking: Asking) -> Iterator[str]:
    for each in asking.about("documentSymbol"):
        yield from symbol(each)


@question("workspace/symbol")
def _named(asking: Asking) -> Iterator[str]:
    for each in asking.ask("workspace/symbol"):
        yield f"{each['name']} {each['kind']} {location(each['location'], asking.names)}"


@question("textDocument/foldingRange")
def _folds(asking: Asking) -> Iterator[str]:
    yield from (f"{each['startLine']}-{each['endLine']} {each['kind']}" for each in asking.about("foldingRange"))


@question("textDocument/selectionRange")
def _selections(asking: Asking) -> Iterator[str]:
    (found,) = asking.about("selectionRange", positions=[asking.start])
    while found is not None:
        yield place(found["range"])
        found = found.get("parent")


def _layout(row: str, more: Callable[[Asking], Json]) -> None:
    @question(f"textDocument/{row}")
    def ask(asking: Asking) -> Iterator[str]:
        yield from map(edit, asking.about(row, options=_OPTIONS, **more(asking)))


_layout("formatting", lambda asking: {})
_layout("rangeFormatting", lambda asking: {"range": asking.range})
_layout("rangesFormatting", lambda asking: {"ranges": [asking.range]})
_layout("onTypeFormatting", lambda asking: {"position": asking.start})


def _actions(row: str, kind: str, *titles: str) -> None:
    """The actions of a kind whose titles begin in one of some ways; if none are named, all of that kind."""

    @question(f"textDocument/codeAction {row}")
    def ask(asking: Asking) -> Iterator[str]:
        found = asking.about("diagnostic")["items"]
        context = {"diagnostics": found, "only": [kind]}
        for each in asking.about("codeAction", range=asking.range, context=context):
            if each["title"].startswith(titles or ("",)):
                chosen = each if "edit" in each else asking.client.request("codeAction/resolve", each)
                yield from action(chosen, asking.names)


_actions("quickfix", "quickfix", "")
_actions("quickfix that creates a file", "quickfix", "Create")
_actions("quickfix that allows", "quickfix", "Allow")
_actions("refactor.rewrite of lines", "refactor.rewrite", "Renumber all lines")
_actions("refactor.rewrite of blocks", "refactor.rewrite", "Renumber all blocks")
_actions("refactor.extract", "refactor.extract")
_actions("refactor.inline", "refactor.inline")
_actions("source.fixAll.deburr", "source.fixAll.deburr")


@question("codeAction/resolve")
def _resolved_action(asking: Asking) -> Iterator[str]:
    context = {"diagnostics": [], "only": ["refactor"]}
    offer = asking.about("codeAction", range=asking.range, context=context)[0]
    assert "edit" not in offer
    yield from action(asking.client.request("codeAction/resolve", offer), asking.names)


@question("textDocument/semanticTokens/full")
def _colours(asking: Asking) -> Iterator[str]:
    yield from colours(asking.about("semanticTokens/full")["data"], _legend(asking))


@question("textDocument/semanticTokens/range")
def _coloured(asking: Asking) -> Iterator[str]:
    yield from colours(asking.about("semanticTokens/range", range=asking.range)["data"], _legend(asking))


@question("textDocument/semanticTokens/full/delta")
def _recoloured(asking: Asking) -> Iterator[str]:
    full = asking.about("semanticTokens/full")
    asking.client.change(asking.uri, {"range": asking.range, "text": ""})
    found = asking.about("semanticTokens/full/delta", previousResultId=full["resultId"])
    data = list(full["data"])
    for each in found["edits"]:
        data[each["start"] : each["start"] + each["deleteCount"]] = each["data"]
    yield from colours(data, _legend(asking))
    assert data == asking.about("semanticTokens/full")["data"]


def _legend(asking: Asking) -> Json:
    found: Json = asking.offered["semanticTokensProvider"]["legend"]
    return found


@question("textDocument/documentLink")
def _links(asking: Asking) -> Iterator[str]:
    yield from (f"{place(each['range'])} {asking.names.of(each['target'])}" for each in asking.about("documentLink"))


@question("textDocument/codeLens")
def _lenses(asking: Asking) -> Iterator[str]:
    for each in asking.about("codeLens"):
        yield f"{place(each['range'])} {each['command']['title'] if each.get('command') else '...'}"


@question("codeLens/resolve")
def _counted(asking: Asking) -> Iterator[str]:
    for each in asking.about("codeLens"):
        if not each.get("command"):
            command = asking.client.request("codeLens/resolve", each)["command"]
            yield f"{place(each['range'])} {command['title']}"
            for one in (command.get("arguments") or [(), (), ()])[2]:
                yield f"  {location(one, asking.names)}"


@question("textDocument/inlayHint")
def _hints(asking: Asking) -> Iterator[str]:
    every = {"start": {"line": 0, "character": 0}, "end": {"line": 99, "character": 0}}
    for each in asking.about("inlayHint", range=every):
        yield f"{each['position']['line']}:{each['position']['character']} {each['label']}"


@question("textDocument/linkedEditingRange")
def _linked(asking: Asking) -> Iterator[str]:
    found = asking.at("linkedEditingRange")
    yield from map(place, found["ranges"] if found is not None else ())


@question("textDocument/prepareCallHierarchy")
def _routines(asking: Asking) -> Iterator[str]:
    yield from (call_item(each, asking.names) for each in asking.at("prepareCallHierarchy"))


def _calls(row: str, end: str) -> None:
    @question(f"callHierarchy/{row}")
    def ask(asking: Asking) -> Iterator[str]:
        (item,) = asking.at("prepareCallHierarchy")
        for each in asking.ask(f"callHierarchy/{row}", item=item):
            places = " ".join(place(one) for one in each["fromRanges"])
            yield f"{call_item(each[end], asking.names)} at {places}"


_calls("incomingCalls", "from")
_calls("outgoingCalls", "to")


@question("workspace/executeCommand deburr.expand")
def _flat(asking: Asking) -> Iterator[str]:
    found = asking.command("deburr.expand")
    assert found["findings"] == [] and found["truncated"] is False
    yield found["text"].strip("\n")


@question("workspace/executeCommand deburr.sourceMap")
def _mapped(asking: Asking) -> Iterator[str]:
    there = asking.command("deburr.sourceMap", position=asking.start)
    for each in there["ranges"]:
        frames = " ".join(f"{frame['kind']} {frame['number']}" for frame in each["frames"])
        yield f"{asking.names.of(there['uri'])} {place(each['range'])} {frames}".rstrip()
        back = {"uri": there["uri"], "position": each["range"]["start"]}
        arguments = {"command": "deburr.sourceMap", "arguments": [back]}
        origin = asking.client.request("workspace/executeCommand", arguments)
        assert [one["range"]["start"]["line"] for one in origin["ranges"]] == [asking.start["line"]]


@question("workspace/executeCommand deburr.plot")
def _drawn(asking: Asking) -> Iterator[str]:
    found = asking.command("deburr.plot")
    header, columns = found["header"], found["segments"]["columns"] if found["segments"] is not None else {}
    yield f"{header['moves']} moves within {header['bounds']['all moves']}"
    for kind, line in zip(unpacked(columns["kind"]), unpacked(columns["line"]), strict=True) if columns else ():
        yield f"{header['kinds'][kind]} of line {line}"


@question("workspace/executeCommand deburr.explainDialect")
def _explained(asking: Asking) -> Iterator[str]:
    found = asking.command("deburr.explainDialect")
    yield f"{found['dialect']}, {found['title']}, because of {found['reason']}"


@question("workspace/textDocumentContent")
def _content(asking: Asking) -> Iterator[str]:
    uri = f"deburr-expanded:{asking.uri.removeprefix('file://')}"
    yield asking.ask("workspace/textDocumentContent", uri=uri)["text"].strip("\n")
