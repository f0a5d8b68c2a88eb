"""Who is told of findings: clients that cannot ask are sent them, the others are told when to ask again. Never sends the same list twice."""

from __future__ import annotations

import json
from itertools import count
from typing import TYPE_CHECKING

from deburr.lsp.report import MOST, Written

if TYPE_CHECKING:
    from deburr.lsp.checks import Checks
    from deburr.lsp.protocol import Protocol
    from deburr.lsp.session import Session

_NONE = "[]"


class Publisher:
    """Sends diagnostics."""

    checks: Checks

    def __init__(self, protocol: Protocol, session: Session) -> None:
        self._protocol = protocol
        self._session = session
        self._sent: dict[str, tuple[int | None, str]] = {}
        self._written: dict[str, Written] = {}
        self._numbers = count(1)

    def changed(self, file: str) -> None:
        """The findings in a file are others now."""
        if self._session.client.pulls:
            return
        program = self._session.open_files.get(file)
        items = self._written.setdefault(file, Written()).capped(*self.checks.first(file, MOST), self._session)
        version = program.version if program is not None else None
        if self._sent.get(file, (None, _NONE)) == (version, items):
            return
        if program is None and items == _NONE:
            self._sent.pop(file, None)
            self._written.pop(file, None)
        else:
            self._sent[file] = version, items
        number = "" if version is None else f', "version": {version}'
        params = f'{{"uri": {json.dumps(self._session.uri(file))}, "diagnostics": {items}{number}}}'
        self._protocol.send_text(
            f'{{"jsonrpc": "2.0", "method": "textDocument/publishDiagnostics", "params": {params}}}'
        )

    def refresh(self) -> None:
        """Programs were checked again because others changed."""
        client = self._session.client
        if client.pulls and client.refreshes:
            self._ask("workspace/diagnostic/refresh")
        if client.refreshes_lenses:
            self._ask("workspace/codeLens/refresh")
        if client.refreshes_hints:
            self._ask("workspace/inlayHint/refresh")

    def _ask(self, method: str) -> None:
        self._protocol.send({"id": f"deburr-{next(self._numbers)}", "method": method})
