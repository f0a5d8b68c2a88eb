"""What an RS274 line does to modal state (spec/rs274.md §1.3, §5, §6). Looks at letters and at literal G and M numbers only."""

from deburr_grammar.codes import code_number
from deburr_grammar.dialect import Effect, Modality
from deburr_grammar.line import LineNode
from deburr_grammar.tree import Token

_STAYS = "FST"
_ELSEWHERE = frozenset(("M70", "M72", "M73", "M98", "M99"))
"""Codes that run other text, or bring back a state that was kept."""


def effect(line: LineNode) -> Effect:
    """The codes of a line, and whether it calls or is called."""
    codes = tuple(_codes(line))
    labelled = "o_line" in line.kinds
    calls = "CALL" in line.kinds or not _ELSEWHERE.isdisjoint(codes) or "" in codes or bool(line.problems)
    # An O-word without a command is where `M98` goes to.
    target = labelled and not any(
        part.kind.isupper() and part.kind != "O" for node in line.find("o_line") for part in node.children
    )
    return Effect(codes, arrives=target, leaves=calls, maybe="DELETE" in line.kinds)


MODALITY = Modality(effect, frozenset(("if",)))


def _codes(line: LineNode) -> list[str]:
    """The codes and the letters that stay in force; "" for a code that only the run knows."""
    found = []
    for word in line.find("word"):
        letter, value = line.text[word.start].upper(), word.children[-1]
        if letter in "GM":
            found.append(code_number(line.text[word.start : word.end]) if isinstance(value, Token) else "")
        elif letter in _STAYS:
            found.append(letter)
    return found
