"""Who is told of findings: clients that cannot ask are sent them, the others are told when to ask again. Never sends the same list twice."""

from __future__ import annotations

from itertools import count
from typing import TYPE_CHECKING

from deburr.lsp.report import capped

if TYPE_CHECKING:
    from deburr.lsp.checks import Checks
    from deburr.lsp.protocol import Protocol
    from deburr.lsp.report import Json
    from deburr.lsp.session import Session


class Publisher:
    """Sends diagnostics."""

    checks: Checks

    def __init__(self, protocol: Protocol, session: Session) -> None:
        self._protocol = protocol
        self._session = session
        self._sent: dict[str, tuple[int | None, list[Json]]] = {}
        self._numbers = count(1)

    def changed(self, file: str) -> None:
        """The findings in a file are others now."""
        if self._session.client.pulls:
            return
        program = self._session.open_files.get(file)
        items = capped(self.checks.findings(file), self._session)
        version = program.version if program is not None else None
        if self._sent.get(file, (None, [])) == (version, items):
            return
        if program is None and not items:
            self._sent.pop(file, None)
        else:
            self._sent[file] = version, items
        params: Json = {"uri": self._session.uri(file), "diagnostics": items}
        if version is not None:
            params["version"] = version
        self._protocol.send({"method": "textDocument/publishDiagnostics", "params": params})

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
