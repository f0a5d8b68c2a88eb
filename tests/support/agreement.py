"""The programs by which deburr and LinuxCNC's interpreter are compared, and those left out, each with its reason."""

import json
from collections.abc import Iterator, Mapping
from pathlib import Path

from benchmarks.compare import MACHINE, Case
from benchmarks.interpreter import Program

from support.faults import faults

FACTS = Path(__file__).parents[1] / "oracle" / "facts.json"
_SKIPPED = "the interpreter does not look at what it passes over; the text is checked all the same (spec/rs274.md §6)"
_UNCLOSED = "runs because the end happens not to be needed; a missing end is always an error (spec/rs274.md §6)"
_EMPTY = "an empty file is no program yet; nothing is said while it is begun"
EXCLUDED: Mapping[str, str] = {
    "assign: set inside skipped if": _SKIPPED,
    "flow: garbage in skipped": _SKIPPED,
    "sub: error in uncalled sub": _SKIPPED,
    "faults: call arguments in skipped": _SKIPPED,
    "flow: if without endif true": _UNCLOSED,
    "flow: while w/o endwhile true": _UNCLOSED,
    "flow: do without while": _UNCLOSED,
    "files: M2 before endsub": _UNCLOSED,
    "text: empty file": _EMPTY,
    "text: blank only": _EMPTY,
}
"""Programs on which the two differ on purpose."""


def cases() -> Iterator[Case]:
    """The facts about the interpreter, the programs with one fault that it refuses, and the same without the fault."""
    for group, name, text, *more in json.loads(FACTS.read_text(encoding="utf-8")):
        files = tuple(more[0].items()) if more else ()
        yield Case("fact", f"{group}: {name}", Program("main.ngc" if files else "p.ngc", text, files))
    for fault in faults("rs274"):
        if fault.example.settings.items() <= MACHINE.items():
            files = tuple(fault.example.files.items())
            if not fault.runs:
                yield Case("fault", fault.name, Program("p.ngc", fault.example.program, files), fault.rule)
            yield Case("mended", fault.name, Program("p.ngc", fault.mended, files), fault.rule)
