"""Machine file that cannot be used.

The file that `machine` in `[cgt]` names holds what differs from control to control: formats, the codes
that table words print, further words, how arcs and block numbers are written. A key that
is not known, or a value of another sort, would silently leave the default in force.

Source: spec/cgt.md §11, *Machine file*

Bad (machine=mill.toml):

    -- mill.toml --
    arc-centre = "incremental"
    ^^^^^^^^^^
    first-tool = "toolchange"
    ^^^^^^^^^^
    block-step = 0
    ^^^^^^^^^^
    [formats]
    F_Decimal = "D4"
    ^^^^^^^^^
    F_Integr = "T6.0"
    ^^^^^^^^
    F_Offset = "t2.0"
    ^^^^^^^^
    [tables]
    MOV = "G00 G01"
    ^^^
    COOLANT = ["M09", "M08"]
    ^^^^^^^
    SPEED = ["S1"]
    ^^^^^
    [words]
    WPOS = "decimla"
    ^^^^
    XPOS = "integer"
    ^^^^
    gear = "table"
    ^^^^

Bad (machine=mill.toml):

    -- mill.toml --
    arc-center = incremental
                 ^

Bad (machine=mill.toml, whole):

    @START
    ^^^^^^
    G90 G21
    @
    @END
    M30
    @

Good (machine=mill.toml):

    G1 #GEAR
    -- mill.toml --
    arc-center = "absolute"
    first-tool = "start"
    block-start = 1
    block-step = 1
    [formats]
    F_Decimal = "D4.3"
    F_Integer = "T5.0"
    [tables]
    MOV = ["G0", "G1", "G2", "G3"]
    GEAR = ["M40", "M41"]
    [words]
    GEAR = "table"
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.formats.machine import place
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.cgt._sections import unreadable
from deburr.rules.cgt._template import configured, ready, template_of
from deburr.suggest import suggestion
from deburr.templates.symbols import built_in, table_words
from deburr.templates.template import Template, target
from deburr_grammar.text import Span


@rule(Severity.ERROR, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the key, in the machine file itself."""
    template = template_of(analysis)
    yield from unreadable(analysis, template, "machine")
    file = configured(analysis, "machine")
    if file.text is None:
        return
    found = [(fault.line, fault.span, fault.message) for fault in template.machine.faults]
    found += _names(template, file.text)
    for line, span, message in sorted(found):
        yield Report(span, message, line, (), file.path)


def _names(template: Template, text: str) -> Iterator[tuple[int, Span, str]]:
    """Names that stand in the file for nothing: words that exist already, tables that no word prints."""
    machine = template.machine
    for name in machine.words:
        if (kind := built_in(name)) is not None:
            yield *place(text, ("words", name)), f"`{name}` exists already ({kind}); it cannot be another kind of word"
    tables = table_words() | {name for name, kind in machine.words.items() if kind == "table"}
    used = {target(item)[0] for item, _, _ in template.of("lookup")}
    used |= {each.name for each in template.declarations if each.command == "TBL"}
    for name in machine.tables.keys() - tables - used:
        hint = suggestion(name.upper(), tables - machine.tables.keys())
        kind = machine.words.get(name) or built_in(name)
        if kind:
            yield *place(text, ("tables", name)), f"`{name}` is no table word ({kind}), so it prints no rows"
        elif hint:
            yield *place(text, ("tables", name)), f"no word prints the rows of `{name}`{hint}"
