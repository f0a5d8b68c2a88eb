"""Toolpath that cannot be read.

The file that `input` in `[cgt]` names is the toolpath that the template is expanded with: APT/CL
text, or a `.jsonl` file with one event a line. A move that cannot be read would be left out, and the
tool would go straight to the next one.

Source: spec/cgt.md §6, §11, *CL to events*

Bad (input=sample.cl):

    -- sample.cl --
    LOADTL/1
    SPINDL/RPM,1500,CW
                    ^^
    GOTO/10,20
    ^^^^^^^^^^
    GOTO/10,20,-2,
                 ^
    GOTO/1O,20,-2
         ^^
    CIRCLE/10,30,-2, $
           0,0.5,-1,10
           ^^^^^^^^
    FINI

Bad (input=events.jsonl):

    -- events.jsonl --
    {"section": "TOOLCHG", "set": {"TOOL": 1, "NTOOL": 1}}
    {"section": "LINE", "set": {"MOV": 1, "XPOS": 3.0}
                                                     ^
    {"section": "LIEN", "set": {"MOV": 1}}
                ^^^^^^
    {"section": "LINE", "set": {"XPSO": 4}, "note": 1}
                                            ^^^^^^
    {"section": "LINE", "set": {"XPSO": 4, "YPOS": "two"}}
                                ^^^^^^
                                                   ^^^^^

Bad (input=missing.cl, whole):

    @START
    ^^^^^^
    G90 G21
    @
    @END
    M30
    @

Good (input=sample.cl):

    -- sample.cl --
    $$ two moves
    LOADTL / 1, ADJUST, 1
    SPINDL / RPM, 1500.0, CLW
    RAPID
    GOTO / 0.0, 0.0, 5.0
    fedrat / 250, MMPM
    GOTO / 0.0, 0.0, $
      -2.0
    FINI

Good (input=events.jsonl):

    -- events.jsonl --
    {"section": "TOOLCHG", "set": {"TOOL": 1, "NTOOL": 1}}

    {"section": "LINE", "set": {"MOV": 1, "XPOS": 3.0, "YPOS": 0, "ZPOS": -2}}
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.cgt._sections import similar_section, unreadable
from deburr.rules.cgt._template import configured, ready, template_of
from deburr.templates.beside import events_in, is_events, toolpath_faults
from deburr.templates.template import Template
from deburr_grammar.dialects.cgt.outline import SECTIONS

if TYPE_CHECKING:
    from collections.abc import Iterator

    from deburr.analysis import Analysis
    from deburr.formats.events import Event, Given


@rule(Severity.ERROR, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report]:
    """Report what cannot be read, in the toolpath itself."""
    template = template_of(analysis)
    yield from unreadable(analysis, template, "input")
    file = configured(analysis, "input")
    for fault in toolpath_faults(file):
        if not fault.ignored:
            yield Report(fault.span, fault.message, fault.line, (), file.path)
    for event in events_in(file).events if is_events(file) else ():
        yield from (each._replace(line=event.line, file=file.path) for each in _of_event(event, template))


def _of_event(event: Event, template: Template) -> Iterator[Report]:
    """What an event says that the template cannot know."""
    sections = {section.name for section in template.sections if not section.is_table} | SECTIONS
    if event.section and event.section not in sections:
        hint = similar_section(event.section, sections)
        yield Report(event.span, f"there is no section `@{event.section}` to run{hint}")
    for given in event.values:
        yield from _of_word(given, template)


def _of_word(given: Given, template: Template) -> Iterator[Report]:
    name = given.name.removeprefix("#")
    word = template.symbols.find(name)
    if word is None or word.name != given.name:
        hint = f"; did you mean `{word.name}`?" if word else template.symbols.similar(name).replace("`#", "`")
        yield Report(given.span, f"there is no word `{given.name}` to set{hint}")
    elif not word.settable and word.type != "text":
        yield Report(given.span, f"`{given.name}` cannot be set; its value is fixed or computed")
    elif isinstance(given.value, str) and not word.is_text:
        yield Report(given.value_span, f"`{given.name}` holds a number; write it without quotes")
