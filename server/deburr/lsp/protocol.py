"""Messages in and out, on pygls: proper errors for what cannot be answered, and no document store but ours."""

from __future__ import annotations

import json
import logging
from typing import TYPE_CHECKING, Any

from lsprotocol import types
from pygls.exceptions import JsonRpcException
from pygls.protocol import LanguageServerProtocol

from deburr.lsp.start import INVALID_REQUEST, PARSE_ERROR, error_for, parsed
from deburr.lsp.stream import framed

if TYPE_CHECKING:
    from collections.abc import Mapping

METHOD_NOT_FOUND = -32601
INVALID_PARAMS = -32602
_OURS = (types.TEXT_DOCUMENT_DID_OPEN, types.TEXT_DOCUMENT_DID_CHANGE, types.TEXT_DOCUMENT_DID_CLOSE)
_DROPPED = (
    types.INITIALIZE,
    types.WORKSPACE_DID_CHANGE_WORKSPACE_FOLDERS,
    types.NOTEBOOK_DOCUMENT_DID_OPEN,
    types.NOTEBOOK_DOCUMENT_DID_CHANGE,
    types.NOTEBOOK_DOCUMENT_DID_CLOSE,
    types.EXIT,
    types.WORKSPACE_EXECUTE_COMMAND,
)

_log = logging.getLogger("deburr")


class Protocol(LanguageServerProtocol):
    """What pygls does with a message once it is known to be one."""

    def __init__(self, *arguments: Any) -> None:
        super().__init__(*arguments)
        # pygls keeps documents of its own, which copies the whole text at each keystroke.
        for method in (*_OURS, *_DROPPED):
            self.fm.builtin_features.pop(method, None)

    def receive(self, body: bytes) -> None:
        """Take one message."""
        message = parsed(body)
        if message is None:
            self._refuse(None, PARSE_ERROR, "this is no JSON")
        elif not isinstance(message, dict) or message.get("jsonrpc") != "2.0":
            number = message.get("id") if isinstance(message, dict) else None
            self._refuse(number, INVALID_REQUEST, "this is no message of JSON-RPC 2.0")
        elif "method" not in message or self._wanted(message):
            self._take(message)

    def send(self, message: Mapping[str, Any]) -> None:
        """Send JSON that is a message already."""
        self.send_text(json.dumps({"jsonrpc": "2.0", **message}))

    def send_text(self, message: str) -> None:
        """Send a message that is written already."""
        assert self.writer is not None
        self.writer.write(framed(message.encode()))

    def _send_response(self, msg_id: Any, result: Any = None, error: Any = None) -> None:
        """A result that is JSON already is sent as it is: to go through hundreds of items once more would cost more than to find them."""
        if error is None and isinstance(result, dict):
            self.send({"id": msg_id, "result": result})
        else:
            super()._send_response(msg_id, result, error)

    def _wanted(self, message: Mapping[str, Any]) -> bool:
        """Whether a request or notification can be handed on; a request that cannot is refused."""
        method, is_request = message["method"], "id" in message
        if self._shutdown and method != types.EXIT:
            wrong = (INVALID_REQUEST, "the server was shut down")
        elif method == types.INITIALIZE:
            wrong = (INVALID_REQUEST, "the server is initialized already")
        elif (
            method not in self.fm.features and method not in self.fm.builtin_features and method != types.CANCEL_REQUEST
        ):
            wrong = (METHOD_NOT_FOUND, f"`{method}` is not known here")
        elif is_request and method != types.EXIT and _is_notification(method):
            wrong = (INVALID_REQUEST, f"`{method}` is a notification, which has no `id`")
        else:
            return True
        if is_request:
            self._refuse(message["id"], *wrong)
        return False

    def _take(self, message: dict[str, Any]) -> None:
        try:
            found = self.structure_message(message)
        except JsonRpcException as error:
            if "id" in message and "method" in message:
                self._refuse(
                    message["id"], INVALID_PARAMS, f"the parameters of `{message['method']}` are not as they must be"
                )
            else:
                _log.warning("a message could not be read: %s", error)
            return
        self.handle_message(found)

    def _refuse(self, number: Any, code: int, message: str) -> None:
        assert self.writer is not None
        self.writer.write(error_for(number, code, message))


def _is_notification(method: str) -> bool:
    """Whether nobody answers a method."""
    kinds = types.METHOD_TO_TYPES.get(method)
    return kinds is not None and kinds[1] is None
