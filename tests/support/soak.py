"""Hours of work in an editor, in short: fifty programs opened, typed in, asked about in every way, saved and closed, over and over."""

from __future__ import annotations

import re
import shutil
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from random import Random
from typing import Any

from deburr.detect import SHARED, known_extensions
from deburr.lsp.capabilities import COMMANDS
from deburr.lsp.server import found_features
from support.client import Client, Json, Refused

EXAMPLES = Path(__file__).parents[2] / "examples"
FILES = 50
OPEN = 8
"""So many programs are open at a time."""
_COPIES = 5
_BLOCKS = 500
"""Flat lines after which an expansion is cut: how long they get is not the question here."""
MAY_REFUSE = {-32800: "cancelled", -32802: "changed meanwhile", -32803: "cannot be done"}
"""Errors that are answers: LSP's RequestCancelled, ServerCancelled, RequestFailed."""
_NUMBER_OR_NAME = re.compile(r"[0-9]+|[a-z_]{4,}")
FOLLOW = {
    "completionItem/resolve": "textDocument/completion",
    "codeLens/resolve": "textDocument/codeLens",
    "codeAction/resolve": "textDocument/codeAction",
    "callHierarchy/incomingCalls": "textDocument/prepareCallHierarchy",
    "callHierarchy/outgoingCalls": "textDocument/prepareCallHierarchy",
}
"""Methods about something that another method gave."""


@dataclass
class Seen:
    """``resident``: bytes of the server's memory after each round; ``answers``: per method; ``wrong``: errors that are no answers."""

    resident: list[int] = field(default_factory=list)
    answers: Counter[str] = field(default_factory=Counter)
    edits: int = 0
    wrong: list[str] = field(default_factory=list)

    def growth(self, warm: int) -> float:
        """By which part memory grew from the end of round ``warm`` on; of the middle ones of some rounds, since one may be odd."""
        after = self.resident[warm:]
        some = max(len(after) // 4, 1)
        return _middle(after[-some:]) / _middle(after[:some]) - 1


def _middle(values: list[int]) -> int:
    return sorted(values)[len(values) // 2]


def programs(folder: Path) -> list[Path]:
    """Copies of the examples on disk: the programs among them."""
    for copy in range(_COPIES):
        shutil.copytree(EXAMPLES, folder / f"job{copy}")
    own = known_extensions() - {*SHARED}
    return sorted(path for path in folder.rglob("*") if path.suffix in own)[:FILES]


def requests() -> list[str]:
    """The methods that are asked: all that the server has."""
    told = re.compile(r".*/did[A-Z]|initialized$|exit$")
    return sorted(method for method, _ in found_features() if not told.match(method))


class Typist:
    """Works on programs. A round is the same work each time, for a given seed: what grows from one to the next is a leak.

    ``new``: where the numbers and names come from that make lines which nobody has typed before; what is kept of
    such lines has bounds, and shows that it has them only here. None: nothing is typed but what the programs hold.
    """

    def __init__(
        self, client: Client, folder: Path, pause: Callable[[], None] = lambda: None, new: Random | None = None
    ) -> None:
        self.seen = Seen()
        self._new = new
        self._client = client
        self._paths = programs(folder)
        self._methods = requests()
        self._pause = pause
        self._pending: list[tuple[str, int]] = []
        self._last: dict[str, Any] = {}

    def round(self, seed: int) -> None:
        """Every program once, some of them open at a time."""
        self._random = Random(seed)
        order = self._random.sample(self._paths, len(self._paths))
        for start in range(0, len(order), OPEN):
            texts = {
                self._client.open(str(path.relative_to(self._client.folder)), _text(path)): _text(path)
                for path in order[start : start + OPEN]
            }
            for uri, text in texts.items():
                self._visit(uri, text)
            for uri in texts:
                self._client.close(uri)
            self._collect()
        self._ask("workspace/symbol", query="a")
        self._ask("workspace/diagnostic", previousResultIds=[])
        self._collect()
        self.seen.resident.append(resident(self._client.process.pid))

    def _visit(self, uri: str, text: str) -> None:
        """Type some lines, take them away again, ask everything, save."""
        lines = text.split("\n")
        for _ in range(3):
            line = self._random.randrange(len(lines))
            for at in self._typed(uri, line, renewed(self._random.choice(lines), self._new)):
                self._askabout(uri, line, at)
            self._change(uri, (line, 0), (line + 1, 0), "")
        line = self._random.randrange(len(lines))
        for method in self._methods:
            self._ask_method(method, uri, line, self._random.randrange(len(lines[line]) + 1))
        self._client.notify("textDocument/didSave", {"textDocument": {"uri": uri}})
        self._collect()

    def _typed(self, uri: str, line: int, text: str) -> Iterator[int]:
        """A new line, typed in bursts; after each, the column of the cursor."""
        self._change(uri, (line, 0), (line, 0), "\n")
        at = 0
        while at < len(text):
            burst = text[at : at + self._random.randint(1, 6)]
            for char in burst:
                self._change(uri, (line, at), (line, at), char)
                at += 1
            yield at

    def _change(self, uri: str, start: tuple[int, int], end: tuple[int, int], text: str) -> None:
        ends = [{"line": line, "character": character} for line, character in (start, end)]
        self._client.change(uri, {"range": {"start": ends[0], "end": ends[1]}, "text": text})
        self.seen.edits += 1
        self._pause()

    def _askabout(self, uri: str, line: int, character: int) -> None:
        """What an editor asks while one types, and now and then takes back."""
        near = (
            "completion",
            "hover",
            "signatureHelp",
            "documentHighlight",
            "semanticTokens/range",
            "diagnostic",
            "inlayHint",
        )
        self._ask_method(f"textDocument/{self._random.choice(near)}", uri, line, character)
        if self._pending and self._random.random() < 0.05:
            self._client.notify("$/cancelRequest", {"id": self._pending[-1][1]})

    def _ask_method(self, method: str, uri: str, line: int, character: int) -> None:
        if method in FOLLOW:
            given = self._last.get(FOLLOW[method])
            items = given["items"] if isinstance(given, dict) else given
            if items:
                item = items[0]
                self._ask(method, **({"item": item} if method.startswith("callHierarchy") else item))
        elif method == "workspace/executeCommand":
            position = {"line": line, "character": 0}
            for command in COMMANDS:
                said = {"uri": uri, "position": position, "maxBlocks": _BLOCKS}
                self._ask(method, command=command, arguments=[said])
        elif method == "workspace/textDocumentContent":
            self._ask(method, uri="deburr-expanded:" + uri.removeprefix("file://"))
        elif not method.startswith("workspace/"):
            self._ask(method, **about(uri, line, character))

    def _ask(self, method: str, **params: Any) -> None:
        self._pending.append((method, self._client.ask(method, params)))
        if len(self._pending) > 20 or method in FOLLOW.values():
            self._collect()

    def _collect(self) -> None:
        """Wait for all that was asked; whatever is never answered ends the test in the client."""
        for method, number in self._pending:
            try:
                self._last[method] = self._client.result(number)
            except Refused as refused:
                if refused.code not in MAY_REFUSE:
                    self.seen.wrong.append(f"{method}: {refused.code} {refused}")
            self.seen.answers[method] += 1
        self._pending.clear()
        self._client.said.clear()


def renewed(text: str, new: Random | None) -> str:
    """A line with other numbers and names, and one more expression, so that neither it nor its shape was ever there."""
    if new is None:
        return text
    text = _NUMBER_OR_NAME.sub(lambda match: _another(match[0], new), text)
    return f"{text}{new.choice('+-*/')}{new.choice('XYZIJ')}{new.randrange(10**6)}" if new.random() < 0.5 else text


def _another(word: str, new: Random) -> str:
    if word.isdecimal():
        return str(new.randrange(10 ** len(word)))
    return "".join(new.choice("abcdefghij") if char.islower() else char for char in word)


def about(uri: str, line: int, character: int) -> Json:
    """Parameters that hold what any request about a document needs."""
    position = {"line": line, "character": character}
    whole = {"start": {"line": max(line - 20, 0), "character": 0}, "end": {"line": line + 20, "character": 0}}
    return {
        "textDocument": {"uri": uri},
        "position": position,
        "positions": [position],
        "range": whole,
        "ranges": [whole],
        "context": {"includeDeclaration": True, "diagnostics": [], "triggerKind": 1, "isRetrigger": False},
        "options": {"tabSize": 4, "insertSpaces": True},
        "ch": "\n",
        "newName": "renamed",
        "previousResultId": "0",
    }


def _text(path: Path) -> str:
    return path.read_bytes().decode("utf-8")


def resident(process: int) -> int:
    """Bytes of a process that are in memory."""
    match = re.search(r"VmRSS:\s+(\d+) kB", Path(f"/proc/{process}/status").read_text())
    assert match is not None, "there is no VmRSS"
    return int(match[1]) * 1024
