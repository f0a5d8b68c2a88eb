"""Why a call finds no sub, in words. Never decides whether it does."""

from deburr.rules.rs274._files import How, Target, World, said
from deburr.rules.rs274._folders import EXTENSION
from deburr.rules.rs274._program import Call, Program

IDLE = " (as the program stands, this line never runs)"


def why(world: World, program: Program, call: Call, target: Target) -> str:
    """The reason, and the way out."""
    match target.how:
        case How.LACKS:
            return _lacks(call, target)
        case How.PERCENT:
            file = _file(target)
            return f"this program and `{file}` both start with `%`, and the control then finds no sub in the file; take the `%` out of `{file}`"
        case How.MISNAMED:
            found, wanted = world.folders.near(call.path or "")[0], f"{(call.path or '').rpartition('/')[2]}{EXTENSION}"
            return f"the file is `{found}`, but the control looks for `{wanted}`; rename the file"
        case How.PASSED:
            return _passed(world, program, call, target)
        case _:
            return _missing(world, call)


def _file(target: Target) -> str:
    return target.path.rpartition("/")[2]


def _lacks(call: Call, target: Target) -> str:
    wanted, file = said(call.label), _file(target)
    if call.fanuc:
        return f"`{file}` has no program `O{call.label}`, and the control looks for it nowhere else"
    labels = list(target.program.by_label) if target.program is not None else []
    has = (
        f"it defines {', '.join(f'`{said(label)}`' for label in labels[:3])}" if labels else "it defines no sub at all"
    )
    return f"`{file}` has no `{wanted} sub`, and the control stops at the file's end; {has}"


def _passed(world: World, program: Program, call: Call, target: Target) -> str:
    assert target.sub is not None
    sub, here = f"`{said(call.label)} sub`", program.sub_at(call.line)
    if target.sub.flow and program.passed_over(target.sub.start):
        return (
            f"{sub} stands in a block that is never run, so that the control does not know it; move it out of the block"
        )
    if program is world.main and world.own is None:
        return f"{sub} stands behind the program's end and above this call, and the control only looks for it further down; move it before the end of the program, or below this call"
    own = f"`{said(here.label)} sub`" if here is not None else "the sub that is called"
    return (
        f"{sub} stands above {own}, where the control does not find it when it comes from another file; move it below"
    )


def _missing(world: World, call: Call) -> str:
    wanted, file = said(call.label), f"{call.path}{EXTENSION}"
    if call.fanuc:
        return f"nothing is numbered `{wanted}` here, and there is no `{file}`; the control stops here"
    if (nearby := world.folders.nearby(call.label or "")) is not None:
        folder = nearby.rpartition("/")[0].rpartition("/")[2]
        return f"nothing defines `{wanted}`, and the program's folder has no `{file}`; there is one in `{folder}`, which the control finds only where its own path leads there (setting `subroutine-path`)"
    place = "no folder of `subroutine-path` has a" if world.folders.configured else "the program's folder has no"
    way_out = "" if world.folders.configured else " (setting `subroutine-path` names further folders)"
    who = ", unless the program that calls it defines one" if world.is_library else ""
    near = world.guesses.near(call.label or "", None, lambda: world.folders.labels() | set(world.main.by_label))
    return f"nothing defines `{wanted}`, and {place} `{file}`{way_out}; the control stops here{who}{near}"
