"""How text is shown to people: colours, file names, characters that a terminal must not obey."""

import os
from typing import NamedTuple, TextIO

from deburr.finding import Severity
from deburr.paths import working_folder

_CODES = {"bold": "1", Severity.ERROR: "1;31", Severity.WARNING: "1;33", Severity.INFO: "1;36", "frame": "1;34"}
_BIDI = "\u202a\u202b\u202c\u202d\u202e\u2066\u2067\u2068\u2069\u200e\u200f\u061c"


class Style(NamedTuple):
    """Whether colours are used, and the folder below which file names are shown short."""

    colour: bool = False
    folder: str = ""

    def paint(self, text: str, how: "str | Severity") -> str:
        """The text in bold, in the colour of frames or of a severity."""
        return f"\x1b[{_CODES[how]}m{text}\x1b[0m" if self.colour else text

    def file(self, file: str) -> str:
        """A file's name: relative to the working folder if it is below it."""
        return plain(file.removeprefix(f"{self.folder}/") if self.folder else file)


def style_for(out: TextIO) -> Style:
    """The style for a stream: colours on a terminal, unless NO_COLOR forbids or FORCE_COLOR demands them."""
    return Style(_wants_colour(out), working_folder().rstrip("/"))


def plain(text: str) -> str:
    """Text for a terminal: what would steer it or turn the direction of reading is shown as a picture."""
    if text.isascii() and text.isprintable():
        return text
    return "".join(map(picture, text))


def picture(char: str) -> str:
    """A character as it may be shown."""
    if char < " ":
        return chr(0x2400 + ord(char))
    if "\x7f" <= char < "\xa0" or char in _BIDI or char in "\u2028\u2029":
        return "␡" if char == "\x7f" else "�"
    return char


def _wants_colour(out: TextIO) -> bool:
    if os.environ.get("NO_COLOR"):
        return False
    if os.environ.get("FORCE_COLOR"):
        return True
    return out.isatty() and os.environ.get("TERM") != "dumb"
