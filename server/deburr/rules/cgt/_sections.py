"""What rules on sections share."""

from collections.abc import Iterable, Iterator

from deburr.analysis import Analysis
from deburr.rule import Report
from deburr.rules.cgt._template import configured
from deburr.templates.items import Section
from deburr.templates.symbols import nearest
from deburr.templates.template import Template, target
from deburr_grammar.dialects.cgt.outline import SECTIONS
from deburr_grammar.text import Span


def computed(template: Template) -> frozenset[str]:
    """The names of the sections that compute a declared word."""
    return frozenset(f"${each.name}" for each in template.declarations if each.command.startswith("CALC"))


def similar_section(name: str, names: Iterable[str]) -> str:
    """The end of a message: `; did you mean `LINE`?`, or nothing."""
    found = nearest(name, names)
    return f"; did you mean `{found}`?" if found else ""


def missing(template: Template) -> Iterator[tuple[str, int, Span, str]]:
    """The sections that something wants to run and that do not exist: name, place, and the word that such a section would compute or ""."""
    names = {section.name for section in template.sections}
    for call, _ in template.calls():
        name, span = target(call)
        if name not in names:
            yield name, call.line, span, ""
    for each in template.declarations:
        if each.command.startswith("CALC") and each.inside and f"${each.name}" not in names:
            yield f"${each.name}", each.line, each.span, each.name


def misspelt(template: Template) -> frozenset[str]:
    """The sections that are offered in place of a missing section or table: the fault is reported there."""
    names = {section.name for section in template.sections}
    wanted = {name for name, *_ in missing(template)}
    wanted |= {target(item)[0] for item, _, _ in template.of("lookup")} - names
    wanted |= {each.name for each in template.declarations if each.command == "TBL"} - names
    return frozenset(found for name in wanted if (found := nearest(name, names)))


def misspelt_declare(template: Template) -> list[Section]:
    """The sections that hold declarations and whose name is nearly `DECLARE`."""
    holding = {id(section): section for _, section, _ in template.of("declaration")}
    found = [each for each in holding.values() if each.name != "DECLARE" and each.name not in SECTIONS]
    return [section for section in found if nearest(section.name, SECTIONS) == "DECLARE"]


def first_place(analysis: Analysis, template: Template) -> tuple[int, Span] | None:
    """Where to report what a template lacks: its first header, else its first line with text; None in an empty file."""
    if template.sections:
        return template.sections[0].line, template.sections[0].span
    for line in range(analysis.document.line_count):
        if said := analysis.document.line(line).strip():
            return line, Span(0, analysis.document.line(line).index(said) + len(said))
    return None


def unreadable(analysis: Analysis, template: Template, key: str) -> Iterator[Report]:
    """Say that a configured file is not there, at the head of the template: it has no place of its own."""
    file, at = configured(analysis, key), first_place(analysis, template)
    if file.path and file.text is None and at is not None:
        line, span = at
        message = f"`{file.path}` cannot be read; `{key}` in `[{analysis.dialect.name}]` of the configuration names it"
        yield Report(span, message, line)
