"""Which rule a line breaks that the grammar cannot read (spec/metagcode.md §6). Looks only at what the parser knows."""

from deburr_grammar.problem import Problem, SyntaxFault

WORDS = {
    "VARIABLE": "a variable `|name|`",
    "LITERAL": "a value",
    "OPERATOR": "an operator",
    "TYPE": "a type",
    "NUMBER": "a number",
    "MODE": "a step type",
    "LABEL": "a label",
    "NAME": "a file name",
    "$END": "the end of the line",
}


def diagnose(fault: SyntaxFault) -> Problem:
    """A bar without a partner: all else is read, and judged by rules on what was read."""
    return Problem("unterminated-variable", fault.start, max(fault.end, len(fault.text.rstrip())))
