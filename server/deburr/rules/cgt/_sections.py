"""What rules on sections share."""

from collections.abc import Iterable
from difflib import get_close_matches

from deburr.analysis import Analysis
from deburr.rules.cgt._template import Template
from deburr_grammar.text import Span


def computed(template: Template) -> frozenset[str]:
    """The names of the sections that compute a declared word."""
    return frozenset(f"${each.name}" for each in template.declarations if each.command.startswith("CALC"))


def similar_section(name: str, names: Iterable[str]) -> str:
    """The end of a message: `; did you mean `LINE`?`, or nothing."""
    by_upper = {each.upper(): each for each in sorted(names)}
    found = get_close_matches(name.upper(), by_upper, 1, 0.7)
    return f"; did you mean `{by_upper[found[0]]}`?" if found else ""


def first_place(analysis: Analysis, template: Template) -> tuple[int, Span] | None:
    """Where to report what a template lacks: its first header, else its first line with text; None in an empty file."""
    if template.sections:
        return template.sections[0].line, template.sections[0].span
    for line in range(analysis.document.line_count):
        if said := analysis.document.line(line).strip():
            return line, Span(0, analysis.document.line(line).index(said) + len(said))
    return None
