"""The choices of layout that a configuration or an editor makes."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from deburr.schema import FORMAT

if TYPE_CHECKING:
    from deburr.config import Config


class Style(NamedTuple):
    """``indent``: the blanks of one level. ``canonical``: letters as the dialect's manual writes them."""

    indent: str = "  "
    canonical: bool = False


def style_of(config: Config, editor: str | None = None) -> Style:
    """The style that is configured. ``editor``: an editor's own idea of a level, which holds where no configuration says one."""
    found = {setting.name: config.get("format", setting) for setting in FORMAT}
    width, style = found["indent"], found["indent-style"]
    indent = "\t" if style.value == "tab" else " " * width.value
    configured = width.origin or style.origin
    return Style(indent if editor is None or configured else editor, found["case"].value == "canonical")
