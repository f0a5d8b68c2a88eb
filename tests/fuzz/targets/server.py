"""The server: whatever is opened, typed, asked and taken back, all is answered, nothing fails inside, and its texts are the client's."""

from __future__ import annotations

import json
from collections.abc import Iterator
from functools import cache, partial

from deburr.lsp.capabilities import COMMANDS
from deburr_grammar.dialects import NAMES
from deburr_grammar.text import Edit, Pos
from fuzz.choices import Choices, joined
from fuzz.stock import numbered, programs
from support.inside import Inside, Json
from support.model import ENCODINGS, Model
from support.soak import FOLLOW, MAY_REFUSE, about, requests

_URIS = ("untitled:a", "untitled:b")
_ACTIONS = 24
"""So many things are done in a session."""
_BLOCKS = 200
_CANCELLED = -32800


@cache
def methods() -> list[str]:
    """What can be asked."""
    return requests()


def run(data: bytes) -> None:
    """The client's encoding and whether it asks for diagnostics, then what it does."""
    choices = Choices(data)
    encoding, pulls = choices.pick(list(ENCODINGS)), bool(choices.byte() & 1)
    offered: Json = {"general": {"positionEncodings": [encoding]}, "workspace": {"textDocumentContent": {}}}
    if pulls:
        offered["textDocument"] = {"diagnostic": {}}
    with Inside(offered) as inside:
        _Session(inside, encoding).lasts(choices)


class _Session:
    """A client that knows what its texts are and what it has asked."""

    def __init__(self, inside: Inside, encoding: str) -> None:
        self._inside = inside
        self._encoding = encoding
        self._texts: dict[str, Model] = {}
        self._asked: dict[int, str] = {}
        self._cancelled: set[int] = set()
        self._wrong: list[Json] = []
        self._version = 0
        inside.loop.set_exception_handler(lambda loop, context: self._wrong.append(context))

    def lasts(self, choices: Choices) -> None:
        """Do all that there is to do, and look at what has come of it."""
        actions = (
            self._open,
            self._change,
            self._change,
            self._ask,
            self._ask,
            self._replace,
            self._save,
            self._cancel,
        )
        for _ in range(_ACTIONS):
            if not choices:
                break
            number, uri = choices.byte(), choices.pick(_URIS)
            if number % 16 == 15:
                self._close(uri)
            elif number % 16 == 14:
                self._inside.settle()
            else:
                actions[number % len(actions)](uri, choices)
        self._inside.settle()
        self._look()

    def _open(self, uri: str, choices: Choices) -> None:
        if uri in self._texts:
            return
        language, text = choices.pick(NAMES), choices.text()
        self._texts[uri] = Model(text, self._encoding)
        self._inside.open(uri, text, language)

    def _change(self, uri: str, choices: Choices) -> None:
        line, col, lines, end = (choices.byte() for _ in range(4))
        edit = Edit(Pos(line, col), Pos(line + lines % 4, end), choices.text())
        if uri in self._texts:
            self._changed(uri, self._texts[uri].change(edit))

    def _replace(self, uri: str, choices: Choices) -> None:
        text = choices.text()
        if uri in self._texts:
            self._texts[uri].text = text
            self._changed(uri, {"text": text})

    def _changed(self, uri: str, change: Json) -> None:
        self._version += 1
        document = {"uri": uri, "version": self._version}
        self._inside.notify("textDocument/didChange", {"textDocument": document, "contentChanges": [change]})

    def _ask(self, uri: str, choices: Choices) -> None:
        """A question about a place, with what that hands on asked as well."""
        method, line, character = choices.pick(methods()), choices.byte(), choices.byte()
        if method == "workspace/executeCommand":
            said = {"uri": uri, "position": {"line": line, "character": character}, "maxBlocks": _BLOCKS}
            self._begin(method, {"command": choices.pick(COMMANDS), "arguments": [said]})
        elif method == "workspace/textDocumentContent":
            self._begin(method, {"uri": f"deburr-expanded:{uri}"})
        elif method in FOLLOW:
            self._follow(method, about(uri, line, character))
        elif method.startswith("workspace/"):
            self._begin(method, {"query": "a", "previousResultIds": []})
        else:
            self._begin(method, about(uri, line, character))

    def _follow(self, method: str, params: Json) -> None:
        given = self._inside.request(FOLLOW[method], params)
        items = given.get("items", []) if isinstance(given, dict) else given
        for item in (items or [])[:2]:
            self._begin(method, {"item": item} if method.startswith("callHierarchy") else item)

    def _begin(self, method: str, params: Json) -> None:
        self._asked[self._inside.begin(method, params)] = method

    def _save(self, uri: str, _: Choices) -> None:
        self._inside.notify("textDocument/didSave", {"textDocument": {"uri": uri}})

    def _cancel(self, _: str, choices: Choices) -> None:
        if self._asked:
            number = choices.pick(list(self._asked))
            self._cancelled.add(number)
            self._inside.notify("$/cancelRequest", {"id": number})

    def _close(self, uri: str) -> None:
        self._texts.pop(uri, None)
        self._inside.notify("textDocument/didClose", {"textDocument": {"uri": uri}})

    def _look(self) -> None:
        """Every question has one answer, which is no failure; texts are the client's; nothing went wrong in between."""
        answers: dict[int, Json] = {}
        for number, method in self._asked.items():
            found = self._inside.wait(partial(_answers, number))
            assert number not in answers, method
            answers[number] = found
            code = found.get("error", {}).get("code")
            assert code is None or code in MAY_REFUSE, (method, found)
            assert code != _CANCELLED or number in self._cancelled, (method, found)
        left = [said for said in self._inside.said if "id" in said and "method" not in said]
        assert not left, f"answered twice: {left}"
        session = self._inside.server.session
        assert {uri: program.document.text for uri, program in session.open.items()} == {
            uri: model.text for uri, model in self._texts.items()
        }
        assert not self._wrong, self._wrong
        json.dumps(self._inside.said)


def _answers(number: int, said: Json) -> bool:
    return said.get("id") == number and "method" not in said


def seeds() -> Iterator[bytes]:
    """Each method asked in a program, before and after a line was typed; and what else an editor does."""
    for number, dialect in numbered():
        stock = programs(dialect)
        for at in range(len(methods())):
            opened = bytes((0, 0, number)) + stock[at % len(stock)][:500]
            typed = bytes((1, 0, at % 7, 0, 0, 0)) + b"G1 X#1\n"
            asked = bytes((3, 0, at, at % 7, at % 9, at % 4, 6, 0, 7, 0, 0, 14, 0, 4, 0, at, 1, 3, 1, 15, 1))
            yield joined((at % 3, at), opened, typed, asked)
