"""Slips of the hand in an RS274 program: each kind changes a text at one place, as people do who type or paste. Never judges what comes of it."""

import re
from collections.abc import Callable
from random import Random

Slip = Callable[[str, Random], str | None]
"""The text with the slip at a random place; None if it has no place for it."""


def _at(pattern: str, new: str | Callable[[re.Match[str]], str]) -> Slip:
    found = re.compile(pattern, re.M | re.I)

    def slip(text: str, random: Random) -> str | None:
        places = list(found.finditer(text))
        if not places:
            return None
        place = random.choice(places)
        said = place.expand(new) if isinstance(new, str) else new(place)
        return text[: place.start()] + said + text[place.end() :]

    return slip


_SIGNS = {"GT": ">", "LT": "<", "EQ": "==", "NE": "!=", "GE": ">=", "LE": "<="}
_CODE = r"^(?=[^(;\n]*[a-z#])"
_WORD = r"(?<![\w#<.])([A-Z])([-+]?\d+(?:\.\d*)?|[-+]?\.\d+)(?![\w.])"
_ENDS = r"endif|endwhile|endsub|endrepeat"

SLIPS: dict[str, Slip] = {
    "closing bracket lost": _at(r"\]", ""),
    "opening bracket lost": _at(r"\[", ""),
    "bracket doubled": _at(r"[\[\]]", r"\g<0>\g<0>"),
    "round for square bracket": _at(r"\[([^\[\]\n]*)\]", r"(\1)"),
    "end of a comment lost": _at(r"\)", ""),
    "start of a comment lost": _at(r"\(", ""),
    "letter O for 0": _at(r"(?<=[\d.A-Z])0(?=[\d. \n])", "O"),
    "letter l for 1": _at(r"(?<=[\d.A-Z])1(?=[\d. \n])", "l"),
    "word doubled": _at(_WORD, r"\g<0> \g<0>"),
    "letter of a word doubled": _at(_WORD, r"\1\g<0>"),
    "letter of a word lost": _at(_WORD, r"\2"),
    "number of a word lost": _at(_WORD, r"\1"),
    "end of a block lost": _at(rf"^.*\bo\S*\s*(?:{_ENDS}).*\n", ""),
    "start of a block lost": _at(r"^.*\bo\S*\s*(?:if|while|do|sub|repeat)\b.*\n", ""),
    "end of the program lost": _at(r"^.*\bM(?:2|02|30)\b.*\n", ""),
    "end of the tape lost": _at(r"^%.*\n", ""),
    "line in capitals": _at(rf"{_CODE}.+$", lambda place: place[0].upper()),
    "line in small letters": _at(rf"{_CODE}.+$", lambda place: place[0].lower()),
    "comma for point": _at(r"(?<=\d)\.(?=\d)", ","),
    "point doubled": _at(r"(?<=\d)\.(?=\d)", ".."),
    "blank in a number": _at(r"(?<=\d)\.(?=\d)", ". "),
    "sign doubled": _at(r"-(?=[\d.])", "--"),
    "typographic minus": _at(r"-(?=[\d.])", "–"),
    "hash of a parameter lost": _at(r"#(?=<|\d)", ""),
    "hash doubled": _at(r"#(?=<|\d)", "##"),
    "end of a name lost": _at(r"(#<[^>\n]*)>", r"\1"),
    "keyword misspelt": _at(rf"\b({_ENDS}|while|else|call)\b", lambda place: place[0][:-2] + place[0][-1] + place[0][-2]),
    "keyword split": _at(rf"\bend(?={_ENDS.replace('end', '')})", "end "),
    "label changed": _at(r"^(\s*o)(\d+)", r"\g<1>9\2"),
    "0 for letter o": _at(r"^(\s*)o(?=\d)", r"\g<1>0"),
    "sign for an operator": _at(r"\b(GT|LT|EQ|NE|GE|LE)\b", lambda place: _SIGNS[place[0].upper()]),
    "equals doubled": _at(r"(?<=>)\s*=|(?<=\d)\s*=", r"\g<0>="),
    "line doubled": _at(rf"{_CODE}.*\n", r"\g<0>\g<0>"),
    "line end lost": _at(r"(?<=[^\n])\n", ""),
    "blank that is none": _at(r"(?<=\S) (?=\S)", "\u00a0"),
    "inner brackets lost": _at(r"(?<=[\[ ])\[([^\[\]\n]*)\](?=[^\n]*\])", r"\1"),
    "wrong operator": _at(r"\b(GT|LT|EQ|NE|GE|LE)\b", "AND"),
    "star doubled": _at(r"(?<!\*)\*(?!\*)", "**"),
    "label of a return mistyped": _at(r"^(\s*o)(?:<[^>\n]*>|\d+)(\s*return)", r"\1<elsewhere>\2"),
    "allowance left behind": _at(rf"{_CODE}.*$", r"(deburr: allow rs274.divide-by-zero)\n\g<0>"),
    "letters swapped": _at(r"([a-z])([a-z])", r"\2\1"),
}  # fmt: skip
"""The kinds, by what has happened."""
