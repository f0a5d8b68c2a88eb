"""What is known of the thing under the pointer."""

import re

from lsprotocol import types

from deburr.ide.hover import hover
from deburr.lsp.convert import line_of
from deburr.lsp.server import Server, feature


@feature(types.TEXT_DOCUMENT_HOVER)
def on_hover(server: Server, params: types.HoverParams) -> types.Hover | None:
    """What is known of the thing under the pointer."""
    spot = server.spot(params)
    found = None if spot is None else hover(*spot)
    if spot is None or found is None:
        return None
    text, kind = found.text, types.MarkupKind.Markdown
    if not server.client.markdown:
        text, kind = re.sub(r"\*\*|`", "", text), types.MarkupKind.PlainText
    place = server.units.range(line_of(spot.view.document), spot.pos.line, found.span)
    return types.Hover(types.MarkupContent(kind, text), place)
