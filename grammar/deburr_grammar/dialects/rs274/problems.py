"""Which rule a line breaks that the grammar cannot read (spec/rs274.md §8). Looks only at what the parser knows."""

import re

from deburr_grammar.dialects.rs274.commands import COMMANDS
from deburr_grammar.problem import Part, Problem, SyntaxFault

WORDS = {
    "NUMBER": "a number",
    "HASH": "a parameter `#`",
    "LSQB": "`[`",
    "SIGN": "`+` or `-`",
    "FUNCTION": "a function",
    "ATAN": "a function",
    "EXISTS": "a function",
    "RSQB": "`]`",
    "STAR": "an operator",
    "SLASH": "an operator",
    "POWER": "an operator",
    "MOD": "an operator",
    "COMPARE": "an operator",
    "LOGIC": "an operator",
    "EQUAL": "`=`",
    "NAME": "a name `<...>`",
    "LETTER": "a word",
    "SUB": "an O-word command",
    "COMMENT": "a comment",
    "SEMICOLON_COMMENT": "a comment",
    "O": "an O-word",
    "N": "a line number",
    "DELETE": "block delete `/`",
    "PERCENT": "`%`",
    "$END": "the end of the line",
}

_LETTERS = re.compile(r"[A-Za-z](?:[ \t]*[A-Za-z])*")
_NAME = re.compile(r"[A-Za-z]+")
_BLANK = " \t\f\v"
"""What the interpreter takes off the end of a line."""
_DIGITS = re.compile(r"[0-9. \t]*[0-9.]")


def diagnose(fault: SyntaxFault) -> Problem:
    """The rule that the fault breaks, at the place that its reader must look at."""
    found = _comment(fault) or _name(fault) or _line_number(fault) or _o_word(fault) or _function(fault)
    found = found or (_value(fault) if "NUMBER" in fault.expected else _behind_value(fault))
    kind, start, end = found
    return Problem(kind, start, end, () if kind in _OBVIOUS else _expected(fault))


_OBVIOUS = {
    "comment-nested",
    "comment-unclosed",
    "bad-character",
    "named-unterminated",
    "o-extra-text",
    "percent",
    "number-format",
}

_COMMANDS = frozenset(command.upper() for command in COMMANDS)

Place = tuple[str, int, int]


def _expected(fault: SyntaxFault) -> tuple[str, ...]:
    return tuple(dict.fromkeys(said for name, said in WORDS.items() if name in fault.expected))


def _comment(fault: SyntaxFault) -> Place | None:
    active = fault.inside("ACTIVE_OPEN")
    if active is not None:
        if fault.found == "$END":
            return "comment-unclosed", active.start, len(fault.text)
        return "comment-nested", fault.start, _closed(fault.text, fault.start)
    if fault.text[fault.start : fault.start + 1] != "(" or fault.found in ("COMMENT", "ACTIVE_OPEN"):
        return None
    inner = re.compile(r"[()]").search(fault.text, fault.start + 1)
    if inner is None:
        return "comment-unclosed", fault.start, len(fault.text)
    return "comment-nested", inner.start(), _closed(fault.text, inner.start())


def _name(fault: SyntaxFault) -> Place | None:
    before = fault.before
    if fault.text[fault.start : fault.start + 1] != "<" or before is None or before.kind not in ("HASH", "O"):
        return None
    return "named-unterminated", before.start, len(fault.text.rstrip(_BLANK))


def _line_number(fault: SyntaxFault) -> Place | None:
    before = fault.before
    if before is not None and before.kind == "N":
        return "line-number", before.start, max(before.end, min(fault.start + 1, len(fault.text)))
    return ("line-number", fault.start, fault.start + 1) if _letter(fault) == "n" and _between_words(fault) else None


def _o_word(fault: SyntaxFault) -> Place | None:
    if _letter(fault) == "o" and _between_words(fault):
        return "o-extra-text", fault.start, len(fault.text.rstrip(_BLANK))
    if fault.inside("O") is None or _group(fault) is not None:
        return None
    before = fault.before
    assert before is not None
    if before.kind in ("IF", "ELSEIF", "WHILE", "REPEAT"):
        return "o-condition", before.start, before.end
    if before.kind in ("O", "HASH", "SIGN"):
        return "value-missing", before.start, _run(fault, _NAME) if _letter(fault).isalpha() else before.end
    if "SUB" in fault.expected:
        return "o-unknown", fault.start, _run(fault, _LETTERS)
    if before.kind in _COMMANDS and before.end == fault.start and _letter(fault).isalpha():
        return "o-unknown", before.start, _run(fault, _NAME)
    return "o-extra-text", fault.start, len(fault.text.rstrip(_BLANK))


def _function(fault: SyntaxFault) -> Place | None:
    before, atan = fault.before, fault.inside("ATAN")
    if before is None:
        return None
    if before.kind in ("FUNCTION", "ATAN", "EXISTS"):
        return "function-bracket", before.start, before.end
    unfinished = fault.expected == {"SLASH"} or before.kind == "SLASH" and fault.expected == {"LSQB"}
    if atan is not None and unfinished:
        return "atan-form", atan.start, before.end
    return None


def _value(fault: SyntaxFault) -> Place:
    """A value should have stood here."""
    group, before, char = _group(fault), fault.before, fault.text[fault.start : fault.start + 1]
    begun = before.start if before is not None else fault.start
    missing = "value-missing", begun, before.end if before is not None else fault.start
    if fault.found == "$END":
        return ("expression-unclosed", group.start, len(fault.text)) if group else missing
    if char.isascii() and char.isalpha():
        end = _run(fault, _NAME)
        called = fault.text[end:].lstrip().startswith("[")
        if not group and end == fault.start + 1 and not called:
            return missing
        # A letter that is taken for a word of its own, of what was meant as text.
        apart = called or before is None or before.kind != "LETTER" or before.end < fault.start
        return "function-unknown", fault.start if apart else begun, end
    if char == ".":
        return "number-format", fault.start, _run(fault, _DIGITS)
    if fault.found in ("COMMENT", "ACTIVE_OPEN"):
        return missing
    if group and char in "]*/=":
        return "expression-syntax", fault.start, fault.start + (2 if fault.text.startswith("**", fault.start) else 1)
    if char in "]*/=;":
        return missing
    return "bad-character", fault.start, fault.start + 1


def _behind_value(fault: SyntaxFault) -> Place:
    """Something stands where a value, a word or a setting had ended."""
    group, before, char = _group(fault), fault.before, fault.text[fault.start : fault.start + 1]
    if char == "." or before is not None and before.kind == "NUMBER" and fault.found == "NUMBER":
        if before is not None and before.kind == "NUMBER" and before.end == fault.start:
            return "number-format", before.start, _run(fault, _DIGITS)
        return "number-format" if char == "." else "bad-character", fault.start, _run(fault, _DIGITS)
    if group is not None:
        if fault.found == "$END":
            return "expression-unclosed", group.start, len(fault.text)
        return (
            "operator-unknown",
            fault.start,
            _closed(fault.text, fault.start) if char == "(" else _run(fault, _LETTERS),
        )
    if "EQUAL" in fault.expected:
        param = _last(fault, "param") or fault.inside("HASH")
        return "param-equal-missing", param.start if param else fault.start, fault.start
    if fault.inside("PERCENT") is not None or char == "%":
        return "percent", fault.start, len(fault.text.rstrip(_BLANK))
    if char == "/":
        after = fault.text[fault.end :].lstrip(" \t")[:1]
        deletes = before is None or before.kind == "DELETE" or after.isalpha() or after in ("", "#", "(", ";", "%")
        return "block-delete-position" if deletes else "operator-outside-brackets", fault.start, fault.start + 1
    if char in ("+", "-", "*") and before is not None:
        return (
            "operator-outside-brackets",
            fault.start,
            fault.start + (2 if fault.text.startswith("**", fault.start) else 1),
        )
    return "bad-character", fault.start, fault.start + 1


def _group(fault: SyntaxFault) -> Part | None:
    """The bracket of the innermost expression that is still open; one just closed may not have been reduced yet."""
    closed = 0
    for part in reversed(fault.stack):
        closed += part.kind == "RSQB"
        if part.kind == "LSQB":
            if not closed:
                return part
            closed -= 1
    return None


def _closed(text: str, start: int) -> int:
    """The end of a comment that starts there."""
    return text.find(")", start) + 1 or len(text)


def _between_words(fault: SyntaxFault) -> bool:
    return "LETTER" in fault.expected


def _letter(fault: SyntaxFault) -> str:
    return fault.text[fault.start : fault.start + 1].lower()


def _last(fault: SyntaxFault, kind: str) -> Part | None:
    return next((part for part in reversed(fault.stack) if part.kind == kind), None)


def _run(fault: SyntaxFault, pattern: re.Pattern[str]) -> int:
    match = pattern.match(fault.text, fault.start)
    return match.end() if match and match.end() > fault.start else min(fault.start + 1, len(fault.text))
