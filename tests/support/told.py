"""All that is said of generated programs, a line for each: what processes are compared by. `python -m support.told FIRST BEHIND`."""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from hashlib import sha256
from random import Random

from deburr.analysis import Analysis
from deburr.ran import ran
from deburr.ruleset import RuleSet
from deburr.values import values_of
from deburr.values.domain import Value
from deburr.values.program import Program
from deburr_grammar.dialects import by_name
from deburr_grammar.document import Document
from support import metagcode, planted, programs, templates, z32programs
from support.pages import MemoryHost

_MAIN = "main.ngc"


def told(seed: int) -> Iterator[tuple[str, str]]:
    """Of the programs of a seed, each by its language: their findings and values, in the order in which they are found."""
    for name, source in (("rs274", programs.generated(seed)), ("rs274 with mistakes", planted.planted(seed))):
        yield name, _of("rs274", source.text, source.files, {})
    found = z32programs.generated(seed)
    yield "z32", _of("z32", found.text, found.files, dict(found.settings))
    yield "metagcode", _of("metagcode", metagcode.program(Random(seed)), {}, {})
    toolpath = "\n".join(map(json.dumps, templates.events(Random(seed))))
    yield "cgt", _of("cgt", templates.template(Random(seed)), {"part.jsonl": toolpath}, {"input": "part.jsonl"})


def _of(dialect: str, text: str, files: dict[str, str], settings: dict[str, object]) -> str:
    language = by_name(dialect)
    analysis = Analysis(Document.parse(text, language), RuleSet(language, settings), _MAIN, MemoryHost(files))
    values = values_of(analysis)
    return repr(
        (analysis.findings(), ran(analysis), [] if values is None else [_values(values), _values(values.general)])
    )


def _values(program: Program) -> list[object]:
    return [
        (name, node, [(str(key), _value(value)) for key, value in env.items()], solved.solution.targets(node))
        for name, solved in program.solved.items()
        for node, env in solved.solution.before.items()
    ]


def _value(value: Value) -> object:
    # Texts are a set by nature: they are shown sorted.
    return value._replace(texts=frozenset()), sorted(value.texts)


if __name__ == "__main__":
    for number in range(*map(int, sys.argv[1:])):
        for sort, said in told(number):
            print(number, sort, sha256(said.encode()).hexdigest())
