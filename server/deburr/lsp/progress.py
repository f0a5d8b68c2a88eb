"""Work for which a person waits: its progress is shown, and it can be cancelled there. Short work shows nothing."""

from __future__ import annotations

from itertools import count
from time import monotonic
from typing import TYPE_CHECKING

from lsprotocol import types
from pygls.exceptions import JsonRpcRequestCancelled

if TYPE_CHECKING:
    from deburr.lsp.client import Client
    from deburr.lsp.protocol import Protocol

DELAY = 0.5
"""Seconds after which work that nobody gave a token for is shown, if the client can."""
PACE = 0.1
"""Seconds between two reports."""
_numbers = count(1)


class Progress:
    """The progress of one piece of work. ``token`` is the client's; without one the server asks for it when the work takes long."""

    def __init__(self, protocol: Protocol, client: Client, title: str, token: int | str | None = None) -> None:
        self._shown = protocol.progress
        self._client = client
        self._title = title
        self._token = token
        self._asked = self._began = self._over = False
        self._started = monotonic()
        self._said = 0.0

    def __enter__(self) -> Progress:
        if self._token is not None:
            self._begin()
        return self

    def __exit__(self, *_: object) -> None:
        if self._began and self._token is not None:
            self._shown.end(self._token, types.WorkDoneProgressEnd())
            self._shown.tokens.pop(self._token, None)
        self._over = True

    def say(self, message: str, percentage: int | None = None) -> None:
        """How far the work is; JsonRpcRequestCancelled if it was cancelled."""
        if self._token is not None and (future := self._shown.tokens.get(self._token)) and future.cancelled():
            raise JsonRpcRequestCancelled
        now = monotonic()
        if self._began:
            if now - self._said >= PACE and self._token is not None:
                self._said = now
                report = types.WorkDoneProgressReport(message=message, percentage=percentage)
                self._shown.report(self._token, report)
        elif self._client.progress and not self._asked and now - self._started >= DELAY:
            self._asked = True
            token = f"deburr-work-{next(_numbers)}"
            self._shown.create(token, lambda *_: self._created(token))

    def _created(self, token: str) -> None:
        """The client has made a place for it; the work may be over by now."""
        if not self._over:
            self._token = token
            self._begin()

    def _begin(self) -> None:
        assert self._token is not None
        self._began = True
        self._shown.begin(self._token, types.WorkDoneProgressBegin(self._title, cancellable=True))
