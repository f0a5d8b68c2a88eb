"""What an RS274 line does to modal state (spec/rs274.md §1.3, §5, §6). Looks at letters and at literal G and M numbers only."""

import re
from math import floor, isfinite

from deburr_grammar.codes import code_number
from deburr_grammar.dialect import Effect, Modality
from deburr_grammar.line import LineNode
from deburr_grammar.tree import Token

FED = "FED"
"""The group that tells whether a move has been made for which a feed rate must be known."""
LOST = "LOST"
"""The group that tells whether axis words have stood on a line without a G code."""
AXES = frozenset("XYZABCUVW@^")
_STAYS = frozenset("FST")
_ELSEWHERE = frozenset(("M70", "M72", "M73", "M98", "M99"))
"""Codes that run other text, or bring back a state that was kept."""
_FEED_CODES = "G1 G2 G3 G5 G5.1 G5.2 G38.2 G38.3 G38.4 G38.5 G73 G74 G81 G82 G83 G84 G85 G86 G87 G88 G89"
FEEDS = frozenset(_FEED_CODES.split())
"""Motions for which a feed rate must be known."""
_LONGEST = 40
_MOTIONS = FEEDS | frozenset(["G0", "G33", "G33.1", "G70", "G71", "G71.1", "G71.2", "G72", "G72.1", "G72.2", "G76"])
_CLEARS = {"G94": ("F", FED, LOST), "G95": ("F", FED, LOST), "G80": (LOST,), "G5.3": ("motion", LOST)}
"""Codes behind which something is as if never set: a feed mode forgets the feed rate, even the mode that is already in force."""


def effect(line: LineNode) -> Effect:
    """The codes of a line, and whether it calls or is called."""
    codes = tuple(_codes(line))
    labelled = "o_line" in line.kinds
    # What a code does that no table names (REMAP) is not known either.
    foreign = any(code and code[0] in "GM" and not _is_named(line, code) for code in codes)
    calls = foreign or "CALL" in line.kinds or not _ELSEWHERE.isdisjoint(codes) or "" in codes or bool(line.problems)
    # An O-word without a command is where `M98` goes to.
    target = labelled and not any(
        part.kind.isupper() and part.kind != "O" for node in line.find("o_line") for part in node.children
    )
    if "G80" in codes and not _MOTIONS.isdisjoint(codes):
        # Beside a motion code it is passed over.
        codes = tuple(code for code in codes if code != "G80")
    unsets = tuple(group for code in codes for group in _CLEARS.get(code, ()))
    return Effect(codes, arrives=target, leaves=calls, maybe="DELETE" in line.kinds, unsets=unsets)


MODALITY = Modality(effect, frozenset(("if",)))


def remapped(name: str, _: object) -> str:
    """What is wrong with a code that a machine is said to give a meaning of its own (nothing: "")."""
    if re.fullmatch(r"[Gg][0-9]{1,3}(\.[0-9])?|[Mm][0-9]{1,4}", name.strip()):
        return ""
    return f"`{name}` is no G or M code, such as `M428` or `G88.6`"


def code_of(text: str) -> str:
    """A literal G or M word as the interpreter rounds it: `g01` and `G1.00001` are `G1`; what it does not take is spelled as it stands."""
    said = "".join(text.split()).upper()
    parts = 10 if said[0] == "G" else 1
    if len(said) > _LONGEST:
        return code_number(said)
    value = float(said[1:]) * parts
    whole, over = floor(value), value - floor(value)
    if (0.001 if parts == 10 else 1e-4) < over <= (0.999 if parts == 10 else 0.9999):
        return code_number(said)
    whole += over > 0.5
    fraction = f".{whole % parts}" if whole % parts else ""
    return f"{said[0]}{whole // parts}{fraction}"


def _is_named(line: LineNode, code: str) -> bool:
    table = line.dialect.codes
    number = float(code[1:])
    return table.entry("code", code) is not None or (isfinite(number) and table.family("code", int(number)) is not None)


def _codes(line: LineNode) -> list[str]:
    """The codes and the letters that stay in force; "" for a code that only the run knows."""
    found, letters = [], set()
    for word in line.find("word"):
        letter, value = line.text[word.start].upper(), word.children[-1]
        letters.add(letter)
        if letter in "GM":
            found.append(code_of(line.text[word.start : word.end]) if isinstance(value, Token) else "")
        elif letter in _STAYS:
            found.append(letter)
    if not FEEDS.isdisjoint(found):
        found.append(FED)
    if "G" not in letters and not AXES.isdisjoint(letters):
        found.append(LOST)
    return found
