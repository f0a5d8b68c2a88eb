"""A path as one page that needs nothing else: the viewer's script, the data that it shows, the sources. Never opens a file."""

from __future__ import annotations

import json
from html import escape
from typing import TYPE_CHECKING

from deburr.plot.columns import every_chunk, header, packed_text, scale

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

    from deburr.plot.columns import Toolpath

_POLICY = "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data:"
"""The browser is told to ask for nothing."""


def page(
    made: Toolpath, script: str, lines: Callable[[str], Sequence[str]], named: Callable[[str], str]
) -> Iterator[str]:
    """The page in pieces. ``lines``: those of a source by its path; ``named``: what the page calls it."""
    fine = scale(made)
    sources = [
        {"name": named(file), "text": packed_text("".join(f"{line}\n" for line in lines(file)))}
        for file in made.source_map.files
    ]
    yield (
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        f'<meta http-equiv="Content-Security-Policy" content="{_POLICY}">\n'
        f'<link rel="icon" href="data:,">\n<title>{escape(made.name)}</title>\n</head>\n<body>\n<div id="deburr"></div>\n'
    )
    yield _data("deburr-header", header(made, fine, sources))
    for number, chunk in enumerate(every_chunk(made, fine)):
        yield _data(f"deburr-chunk-{number}", chunk)
    yield f"<script>\n{script}</script>\n</body>\n</html>\n"


def _data(name: str, value: object) -> str:
    # A title may hold what would end the element.
    said = json.dumps(value, separators=(",", ":")).replace("<", "\\u003c")
    return f'<script type="application/json" id="{name}">{said}</script>\n'
