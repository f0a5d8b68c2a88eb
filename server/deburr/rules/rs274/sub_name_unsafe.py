"""Name of a called file that a shell would change.

LinuxCNC expands the name of a called file as a shell does: `o<$(date)> call` runs the command
`date`. A name with quotes, brackets, `$`, `&`, `|`, `;` or a backslash runs something, changes or
is not found at all; such a file is never looked for here. `*`, `?` and `[` stand for other signs,
so that another file may be taken; they give a warning.

Source: spec/rs274.md §8, spec/oracle.md §1

Bad:

    o<$(date)> call
     ^^^^^^^^^
    o<a'b> call
     ^^^^^
    o<a|b> call
     ^^^^^

Bad (whole):

    o<pocket*> call
     ^^^^^^^^^
    M2
    -- pocket*.ngc --
    o<pocket*> sub
    o<pocket*> endsub

Good:

    o<pocket-2_a.b> call
    o<in&out> sub
    o<in&out> endsub
    o<in&out> call
    -- pocket-2_a.b.ngc --
    o<pocket-2_a.b> sub
    o<pocket-2_a.b> endsub
"""

from collections.abc import Iterator, Sequence
from functools import partial

from deburr.analysis import Analysis
from deburr.rule import Report, Severity, Whole, parted, rule
from deburr.rules.rs274._files import How, World, ready_world, world_of
from deburr.rules.rs274._folders import BREAKS, MATCHES
from deburr.rules.rs274._held import Call
from deburr_grammar.text import Span


@rule(Severity.ERROR, Whole(ready_world))
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report the name. One that is defined above the call is not looked for in files."""
    world = world_of(analysis)
    yield from parted(world.main.calls, partial(_of_calls, world))


def _of_calls(world: World, calls: Sequence[Call]) -> Iterator[Report]:
    for call in calls:
        if call.path is None or call.fanuc:
            continue
        label = Span(call.span.start + 1, call.span.end)
        target = world.target(world.path, world.main, call)
        said = world.main.document.line(call.line)[label.start : label.end]
        name = (
            Span(label.start + said.index("<"), label.start + said.rindex(">") + 1)
            if "<" in said and ">" in said
            else label
        )
        signs = sorted(set(call.path) & (BREAKS | MATCHES))
        if target.how is How.UNSAFE:
            message = f"a shell would change the name `{call.path}`: the control expands {_listed(signs)} and may run a command; use letters, digits, `-` and `_`"
            yield Report(name, message, call.line)
        elif signs and target.how not in (How.SUB, How.UNSEEN):
            message = f"{_listed(signs)} in the name `{call.path}` stands for other signs too, and the control may take another file; use letters, digits, `-` and `_`"
            yield Report(name, message, call.line, severity=Severity.WARNING)


def _listed(signs: list[str]) -> str:
    return ", ".join("a backtick" if sign == "`" else f"`{sign}`" for sign in signs)
