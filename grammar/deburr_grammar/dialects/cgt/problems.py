"""Which rule a line breaks that the grammar cannot read (spec/cgt.md §7). Looks only at what the parser knows."""

import re

from deburr_grammar.problem import Part, Problem, SyntaxFault

WORDS = {
    "WORD": "a word `#NAME`",
    "NUMBER": "a number",
    "SECTION": "a section's name",
    "FORMAT": "a format such as `D3.4`",
    "NAME": "a function",
    "JOB": "a function",
    "PI": "a function",
    "CHARS": "text",
    "STRING": "text",
    "TAG": "a tag",
    "EQUAL": "`=`",
    "RELATION": "a comparison",
    "STRING_RELATION": "`=` or `<>`",
    "LOGIC": "`,#AND` or `,#OR`",
    "OPEN": "`(` directly behind",
    "LPAR": "`(`",
    "COMMA": "`,`",
    "RPAR": "`)`",
    "STAR": "an operator",
    "SLASH": "an operator",
    "POWER": "an operator",
    "BODY": "`<` directly behind",
}

_COMMANDS = frozenset(
    [
        "DECLARE",
        "EVAL",
        "MACRO",
        "CALL",
        "GOTO",
        "RESET",
        "UPDATE",
        "TABLE",
        "FMT",
        "GETBLK",
        "SETBLK",
        "RETNUM",
        "RETSTR",
        "IF",
        "IFSTR",
        "IFCHG",
        "REPEAT",
    ]
)
_KINDS = {"EVAL": "eval-syntax", "IF": "if-syntax", "IFSTR": "if-syntax", "IFCHG": "ifchg-argument"}
_RUN = re.compile(r"[#@$]?[A-Za-z0-9_.]+|<>|<=|>=|[^ \t]")


def diagnose(fault: SyntaxFault) -> Problem:
    """The rule that the fault breaks, at the place that its reader must look at."""
    command = next((part for part in reversed(fault.stack) if part.kind in _COMMANDS), None)
    if command is None:
        return _outside(fault)
    kind = _kind(command, fault)
    start, end = _place(command, fault)
    return Problem(kind, start, end, _expected(fault))


def _outside(fault: SyntaxFault) -> Problem:
    """A header or a table row: in a template line only commands can be faulty."""
    before = fault.before
    text = fault.text.partition("//")[0].rstrip(" \t")
    if before is not None and before.kind == "LABEL":
        return Problem("table-row", before.start, len(text), ("`,`",))
    behind = before.end if before else 0
    return Problem("section-name", len(text) - len(text[behind:].lstrip(" \t")), len(text))


def _kind(command: Part, fault: SyntaxFault) -> str:
    opened = any(part.kind == "OPEN" and part.start >= command.end for part in fault.tokens)
    if "BODY" in fault.expected:
        return "if-syntax"
    if opened and fault.found in ("$END", "COMMENT"):
        # Nothing closes the command: whatever it is, its parenthesis is what is missing.
        return "command-syntax"
    if not opened and command.kind == "IFCHG":
        return "if-syntax"
    return _KINDS.get(command.kind, "command-syntax")


def _place(command: Part, fault: SyntaxFault) -> tuple[int, int]:
    """The sign that does not fit; where something is missing, the command as far as it goes."""
    before = fault.before or command
    if fault.found in ("$END", "COMMENT") or "OPEN" in fault.expected or "BODY" in fault.expected:
        return command.start, before.end
    if fault.found == "RPAR" or fault.text[fault.start] == ")":
        return command.start, fault.start + 1
    match = _RUN.match(fault.text, fault.start)
    return fault.start, match.end() if match else fault.start + 1


def _expected(fault: SyntaxFault) -> tuple[str, ...]:
    return tuple(dict.fromkeys(said for name, said in WORDS.items() if name in fault.expected))
