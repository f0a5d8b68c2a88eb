"""Named parameter that is read before anything sets it.

The control stops with "Named parameter #<...> not defined". A name that does not start with `_`
is local: the main program and each subprogram have their own, anew at each call. One with `_` is
shared by all. Where the first setting of a name stands on the same line, before the place that
reads it, the control silently takes 0 there, not the value that is being set; that is a warning.

Nothing is said of a name for which EXISTS asks, of one that an earlier pass of a loop may have
set, or of a shared one that a caller or a file that cannot be seen may set. It is a warning where
the line can never be run, and in a file `name.ngc` with nothing but subprograms in `o<name> sub`,
of which a remapped code may set the local names.

Source: spec/rs274.md §4.2

Bad:

    G0 X#<nope>
        ^^^^^^^

Bad:

    #<depth>=-3
    G0 Z#<dept>
        ^^^^^^^
    G0 X#<_safe>
        ^^^^^^^^

Bad:

    #<a>=2 G0 X#<a>
               ^^^^
    G0 Y#<b>
        ^^^^
    #<b>=1

Bad:

    #<feed>=200
    o<cut> sub
      G1 X1 F#<feed>
             ^^^^^^^
    o<cut> endsub
    o<cut> call

Good:

    #<a>=2
    G0 X#<a>
    #<_feed_rate>=200
    o<cut> sub
      #<to>=#1
      G1 X#<to> F#<_feed_rate>
    o<cut> endsub
    o<cut> call [5]

Good:

    #1=0
    o1 while [#1 LT 3]
      o2 if [#1 GT 0]
        G0 X#<last>
      o2 endif
      #<last>=#1
      #1=[#1+1]
    o1 endwhile
    o3 if [EXISTS[#<_probe>]]
      G0 Z#<_probe>
    o3 endif
    G0 X#<_x>

Good:

    o<measure> call
    G0 X#<_width>
    -- measure.ngc --
    o<measure> sub
      #<_width>=12
    o<measure> endsub
"""

from collections.abc import Iterator, Sequence

from deburr.analysis import Analysis
from deburr.fixers import did_you_mean
from deburr.rule import Note, Report, Severity, Whole, rule
from deburr.rules.rs274._calls import IDLE
from deburr.rules.rs274._files import world_of
from deburr.rules.rs274._names import Names, Scope, names_of, place, ready_names
from deburr.rules.rs274._program import Use
from deburr.rules.rs274._values import given


@rule(Severity.ERROR, Whole(ready_names))
def check(analysis: Analysis) -> Iterator[Report]:
    """Report every read that nothing can have set before."""
    world = world_of(analysis)
    names = names_of(analysis)
    known = given(analysis)
    for use in names.undefined:
        if use.name in known and (use.name.startswith("_") or names.scope(use).sub is None):
            continue
        idle = world.is_idle(use.line) and not _in_label(analysis, use)
        remapped = world.is_library and not world.nested and names.scope(use).sub in (world.own, None)
        report = _report(analysis, names, use, Severity.WARNING if idle or remapped else None)
        yield report._replace(message=f"{report.message}{IDLE}") if idle else report


def _in_label(analysis: Analysis, use: Use) -> bool:
    """Whether a parameter is in an O-word's label, which is read even where the line is passed over."""
    labels = analysis.document.node(use.line).find("label")
    return any(label.start <= use.span.start < label.end for label in labels)


def _report(analysis: Analysis, names: Names, use: Use, severity: Severity | None) -> Report:
    assert use.name is not None
    said, scope = f"`#<{use.name}>`", names.scope(use)
    sets = names.sets(use)
    first = sets[0] if sets else None
    if first is not None and first.line == use.line and first.extent.start < use.span.start:
        message = f"{said} is set for the first time on this very line; it is still 0 here; set it on a line before"
        return Report(use.span, message, use.line, severity=Severity.WARNING)
    if first is not None:
        where = "later on this line" if first.line == use.line else f"further down, in line {first.line + 1}"
        note = Note(first.line, first.span, "is set here")
        return Report(
            use.span, f"{said} is only set {where}; the control stops here", use.line, (note,), severity=severity
        )
    message = f"{said} is not set {_where(use.name, scope)}; the control stops here{_way_out(analysis, names, use)}"
    notes = [Note(other.line, other.span, f"another `#<{use.name}>`") for other in _elsewhere(names, use)[:1]]
    return Report(use.span, message, use.line, tuple(notes), severity=severity)


def _where(name: str, scope: Scope) -> str:
    if name.startswith("_"):
        return "in the program or in a file that it calls"
    return f"in {place(scope)}"


def _elsewhere(names: Names, use: Use) -> Sequence[Use]:
    """The settings of a local name in other scopes."""
    name = use.name or "_"
    return () if name.startswith("_") else names.all_sets.get(name, ())


def _way_out(analysis: Analysis, names: Names, use: Use) -> str:
    scope = names.scope(use)
    if others := _elsewhere(names, use):
        where = place(names.scope(others[0]))
        return f"; that of {where} is not seen here: use `#<_{use.name}>`, or pass the value as an argument"

    def known() -> set[str]:
        shared = {name for name in names.all_sets if name.startswith("_")}
        table = {entry.name for entry in analysis.dialect.codes.table("variable") if entry.name.startswith("_")}
        return shared | table | {each.name for each in scope.sets if each.name}

    return names.guesses.near(use.name or "", scope.sub, known)


fix = did_you_mean
