"""Which rule a line breaks that the grammar cannot read (spec/z32.md §8). Looks only at what the parser knows."""

import re

from deburr_grammar.problem import Part, Problem, SyntaxFault

WORDS = {
    "NUMBER": "a number",
    "NAME": "an address",
    "G": "a G code",
    "N": "a block number",
    "LANGLE": "`<`",
    "RANGLE": "`>`",
    "LPAR": "`(`",
    "RPAR": "`)`",
    "LSQB": "`[`",
    "RSQB": "`]`",
    "SIGN": "`+` or `-`",
    "FUNCTION": "a function",
    "STAR": "an operator",
    "SLASH": "an operator",
    "EQ": "`=`",
    "IF": "an instruction",
    "GON": "an instruction",
    "GOP": "an instruction",
    "GOS": "an instruction",
    "EB": "an instruction",
    "FILE": "an instruction",
    "TO": "`-N`",
    "PATH": "a file",
    "SEMI": "`;`",
    "BANG": "`!`",
    "END": "`!`",
    "STRING": "a text `'...'`",
    "COMMENT": "a comment",
    "TAIL": "`;`",
    "$END": "the end of the line",
}

_LETTERS = re.compile(r"[A-Za-z_$]+")
_ALIKE = re.compile(r"[A-Za-z_$]+|[0-9.,]+|\([^()]*\)?|;.*")
_GROUP = re.compile(r"\([^()]*\)")
_RELATION = re.compile(r"(?:[<>=]|&[lg]t)+")
_SECTION = re.compile(r":(?:[ \t]*[0-9.,]+|[^ \t;(!]*)")
_FIELD_END = re.compile(r"[ \t]*(?:[;!]|$)")
_NAMES = ("NAME", "OTHER", "ALIAS_NAME", "RESERVED", "VECTOR")
_ADDRESSES = (*_NAMES, "other", "alias_name", "reserved", "vector", "N", "G", "G26", "M_END")
_CLOSERS = {
    "LANGLE": ("RANGLE", re.compile(r">|&gt")),
    "LPAR": ("RPAR", re.compile(r"\)")),
    "LSQB": ("RSQB", re.compile(r"\]")),
}
_UNCLOSED = {"LANGLE": "angle-unclosed", "LPAR": "paren-unclosed", "LSQB": "expression-syntax"}
_BEFORE_OPERAND = ("IF", "SIGN", "STAR", "SLASH", "EQ", "LANGLE", "RANGLE", "LPAR", "LSQB", "FUNCTION")
_TELLING = ("expression-syntax", "word-syntax", "field-unknown", "if-syntax")

Place = tuple[str, int, int]


def diagnose(fault: SyntaxFault) -> Problem:
    """The rule that the fault breaks, at the place that its reader must look at."""
    kind, start, end = _comment(fault) or _function(fault) or _expression(fault) or _relation(fault) or _plain(fault)
    start = min(start, max(len(fault.text) - 1, 0))
    words = (WORDS[name] for name in WORDS if name in fault.expected)
    return Problem(
        kind, start, min(max(end, start + 1), len(fault.text)), tuple(dict.fromkeys(words)) if kind in _TELLING else ()
    )


def _comment(fault: SyntaxFault) -> Place | None:
    if _char(fault) != "(" or "COMMENT" not in fault.expected:
        return None
    inner = re.compile(r"[()]").search(fault.text, fault.start + 1)
    if inner is None:
        return "comment-unclosed", fault.start, len(fault.text.rstrip())
    return "comment-nested", inner.start(), fault.text.find(")", inner.start()) + 1 or len(fault.text)


def _function(fault: SyntaxFault) -> Place | None:
    """A name before `(` that is no function, or a function without its `(`."""
    before = fault.before
    if before is None or before.kind not in ("FUNCTION", *_NAMES):
        return None
    end = _letters(fault.text, before.start)
    called = fault.text[end:].lstrip(" \t").startswith("(")
    if before.kind == "FUNCTION":
        unknown = called and end > before.end
        return ("function-unknown", before.start, end) if unknown else ("function-paren", before.start, before.end)
    known = before.kind in ("NAME", "VECTOR") and end == before.end
    return ("function-unknown", before.start, end) if called and not known and _computes(fault) else None


def _expression(fault: SyntaxFault) -> Place | None:
    """A fault inside `<...>`, an index, a condition or behind `=`."""
    if not _computes(fault):
        return None
    operand, opener, condition, before = "PI" in fault.expected, _opener(fault), fault.inside("IF"), fault.before
    if before is not None and before.kind == "VECTOR":
        return "expression-syntax", before.start, before.end
    if opener is not None and _never_closed(fault, opener) and (not operand or _ends(fault) or _char(fault) == ">"):
        return _UNCLOSED[opener.kind], opener.start, max(_trimmed(fault), opener.end)
    if condition is not None and (
        (opener is None and (not operand or _compares(fault))) or (not operand and _relates(fault))
    ):
        return _condition(fault, condition)
    if not operand and _relates(fault):
        return "relational-outside-if", fault.start, _relation_end(fault)
    if _ends(fault) and before is not None:
        return "expression-syntax", before.start, before.end
    return "expression-syntax", fault.start, _run(fault.text, fault.start)


def _condition(fault: SyntaxFault, condition: Part) -> Place:
    """A condition is one comparison, followed by `;` or `!`."""
    incomplete = "EQ" in fault.expected or "PI" in fault.expected
    if _relates(fault) and not ("PI" in fault.expected and fault.before == condition):
        return "if-syntax", fault.start, _relation_end(fault)
    if incomplete:
        return "if-syntax", condition.start, max(_trimmed(fault), condition.end)
    return "if-syntax", fault.start, _run(fault.text, fault.start)


def _relation(fault: SyntaxFault) -> Place | None:
    """A `>` behind the one that closed the expression: `HA<X>Y>`."""
    closed = [token for token in fault.tokens if token.kind == "RANGLE"]
    if not closed or not fault.text.startswith((">", "&gt"), fault.start):
        return None
    if len(fault.tokens) > 1 and fault.tokens[-2] == closed[-1]:
        return "relational-outside-if", closed[-1].start, closed[-1].end
    return "relational-outside-if", fault.start, _relation_end(fault)


def _plain(fault: SyntaxFault) -> Place:
    """Something that is no word, no instruction and no comment."""
    if fault.inside("BANG") is not None:
        started = [part for part in _field(fault) if part.kind not in ("BANG", "SEMI")]
        start = started[0].start if started else fault.start
        end = _FIELD_END.search(fault.text, max(fault.start, start))
        return "field-unknown", start, end.start() if end else len(fault.text)
    if section := _SECTION.match(fault.text, fault.start):
        return "word-syntax", fault.start, section.end()
    before = fault.before
    if "DOLLAR" in {token.kind for token in fault.tokens}:
        return "word-syntax", fault.tokens[0].start, len(fault.text.rstrip())
    address = fault.stack[-1] if fault.stack else None
    if address is not None and "NUMBER" in fault.expected and address.kind in _ADDRESSES:
        return "word-syntax", address.start, max(address.end, _letters(fault.text, address.start))
    if before is not None and (before.kind in _NAMES or (before.kind == "SIGN" and "NUMBER" in fault.expected)):
        return "word-syntax", before.start, max(before.end, _trimmed(fault))
    return "word-syntax", fault.start, _run(fault.text, fault.start)


def _field(fault: SyntaxFault) -> tuple[Part, ...]:
    """The tokens of the unfinished field, its separator first."""
    separators = [number for number, token in enumerate(fault.tokens) if token.kind in ("BANG", "SEMI")]
    return fault.tokens[separators[-1] :]


def _opener(fault: SyntaxFault) -> Part | None:
    """The innermost `<`, `(` or `[` that is still open. A `<` behind the left side of a condition compares."""
    opened: list[Part] = []
    before, condition = "", False
    for part in fault.stack:
        compares = condition and not opened and before not in _BEFORE_OPERAND
        if part.kind in _CLOSERS and not (part.kind == "LANGLE" and compares):
            opened.append(part)
        elif opened and part.kind == _CLOSERS[opened[-1].kind][0]:
            opened.pop()
        condition = condition or part.kind == "IF"
        before = part.kind
    return opened[-1] if opened else None


def _computes(fault: SyntaxFault) -> bool:
    """Whether the fault stands in an expression: in brackets, in a condition, behind `=`."""
    configures = fault.inside("DOLLAR") is not None
    return not configures and (_opener(fault) is not None or bool(fault.inside("IF") or fault.inside("EQ")))


def _never_closed(fault: SyntaxFault, opener: Part) -> bool:
    """Whether nothing that could close it stands at the fault or behind it, comments left out."""
    rest = fault.text[fault.start :].partition(";")[0]
    return _CLOSERS[opener.kind][1].search(_GROUP.sub("", rest) if opener.kind != "LPAR" else rest) is None


def _compares(fault: SyntaxFault) -> bool:
    """Whether a side of a comparison is missing."""
    return fault.before is not None and fault.before.kind in ("IF", "EQ", "LANGLE", "RANGLE")


def _ends(fault: SyntaxFault) -> bool:
    return _char(fault) in ("", ";", "!")


def _relates(fault: SyntaxFault) -> bool:
    return _RELATION.match(fault.text, fault.start) is not None


def _relation_end(fault: SyntaxFault) -> int:
    match = _RELATION.match(fault.text, fault.start)
    return match.end() if match else fault.start + 1


def _trimmed(fault: SyntaxFault) -> int:
    """Where the text before the fault ends."""
    return len(fault.text[: fault.start].rstrip(" \t"))


def _char(fault: SyntaxFault) -> str:
    return fault.text[fault.start : fault.start + 1]


def _letters(text: str, start: int) -> int:
    """The end of the letters that start there."""
    match = _LETTERS.match(text, start)
    return match.end() if match else start


def _run(text: str, start: int) -> int:
    """The end of the letters, the number or the comment that starts there, or of one character."""
    match = _ALIKE.match(text, start)
    return match.end() if match else start + 1
