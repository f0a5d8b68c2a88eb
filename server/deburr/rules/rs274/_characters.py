"""Characters that look like others, or like nothing: what they are, and what should be typed instead."""

import unicodedata

_ALIKE = dict(zip("АВЕКМНОРСТУХΑΒΕΖΗΙΚΜΝΟΡΤΥΧ×÷∗∕", "ABEKMHOPCTYXABEZHIKMNOPTYX*/*/"))
"""Cyrillic and Greek capitals and signs of arithmetic, with what an ASCII keyboard has for them."""

_MEANING = "+-*/.#=[]<>();%@^$"
"""The signs that programs are made of (spec/rs274.md §1)."""


def foreign(char: str) -> str:
    """What a message says of a character that no program has outside comments; "" of one from an ASCII keyboard."""
    if char.isascii() and char.isprintable():
        return ""
    number, name = f"U+{ord(char):04X}", unicodedata.name(char, "").lower()
    if unicodedata.category(char) == "Zs":
        return f"a {name} ({number}) is no blank to the control; type a plain one"
    if not char.isprintable():
        return f"{name or 'a control character'} ({number}) stands here unseen; delete it"
    said, meant = f"`{char}` ({number}, {name})", alike(char)
    return f"{said} is not `{meant}` to the control; type `{meant}`" if meant else f"{said} has no meaning here"


def alike(char: str) -> str:
    """The ASCII character that a character looks like; "" if there is none."""
    if char == "\N{MINUS SIGN}" or unicodedata.category(char) == "Pd":
        return "-"
    plain = unicodedata.normalize("NFKC", char)
    if len(plain) == 1 and plain.isascii() and (plain.isalnum() or plain in _MEANING):
        return plain
    upper = _ALIKE.get(char.upper(), "")
    return upper if char.upper() == char else upper.lower()
