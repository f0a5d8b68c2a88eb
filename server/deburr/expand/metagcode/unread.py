"""Names that were given a value for a run and to which none of its texts refers. Silent where what a text refers to is not certain."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from deburr.suggest import suggestion
from deburr_grammar.dialects.metagcode.forms import names

if TYPE_CHECKING:
    from deburr.expand.job import Job
    from deburr.expand.metagcode.gather import Place
    from deburr.fault import Fault
    from deburr_grammar.document import Document


def unread_names(job: Job, reached: Sequence[Place], on_lines: Sequence[Fault]) -> Iterator[str]:
    """What there is to say of values that were given by name. ``reached``: all files; ``on_lines``: what is wrong with the form of their lines."""
    given = [name.strip(" \t") for name in job.inputs.typed]
    # A directive that does not exist may be a misspelt `#FILE`, whose text nobody has seen.
    if not given or any(fault.kind == "unknown-directive" for fault in on_lines):
        return
    documents = {each.file: each.source.text.document for each in reached}
    faulty = [documents[fault.file].line(fault.line) for fault in on_lines]
    known = {name for document in documents.values() for name in _referred(document)}
    for name in given:
        if name not in known and not any(map(_word(name).search, faulty)):
            yield f"-D {name}: the program never reads `|{name}|`{suggestion(name, known)}"


def _referred(document: Document) -> Iterator[str]:
    for chunk in document.chunks():
        for line in chunk.lines if "|" in chunk.text else ():
            yield from (name for _, name in names(line))


def _word(name: str) -> re.Pattern[str]:
    """Finds a name where it may be meant as one, as in a line that lacks a bar."""
    return re.compile(rf"(?<!\w){re.escape(name)}(?!\w)")
