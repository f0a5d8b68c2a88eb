"""How rules speak of O-words."""

from deburr.rule import Note
from deburr_grammar.dialect import Bracket
from deburr_grammar.dialects.rs274.commands import COMMANDS
from deburr_grammar.structure import Placed


def said(bracket: Bracket) -> str:
    """The O-word as one writes it: `o101 endif`, `o<drill> sub`."""
    return f"`{label(bracket)} {bracket.word}`"


def label(bracket: Bracket) -> str:
    """The O and its label; a label that only the run knows is shown as `o[...]`."""
    if bracket.label is None:
        return "o[...]"
    return f"o{bracket.label}" if bracket.label.lstrip("-").isdigit() else f"o<{bracket.label}>"


def end(opener: Bracket) -> str:
    """The O-word that would close a block."""
    return f"`{label(opener)} {ENDS[opener.kind]}`"


def note(placed: Placed, what: str = "") -> Note:
    """A related place: an O-word and what it does there."""
    return Note(placed.line, placed.bracket.span, f"{said(placed.bracket)} {what}".strip())


def misspelt(bracket: Bracket) -> bool:
    """Whether the O-word is a guess: its command does not exist, which another rule says."""
    return bracket.word not in COMMANDS


ENDS = {"if": "endif", "while": "endwhile", "do": "while", "repeat": "endrepeat", "sub": "endsub"}
