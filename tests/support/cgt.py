"""CGT templates that are run in memory."""

import json
from collections.abc import Iterable, Mapping
from typing import Any

from deburr.expand import Budget, Expansion, Inputs, Program, expand
from deburr.ruleset import RuleSet
from deburr_grammar.dialects import by_name
from deburr_grammar.document import Document
from support.pages import MemoryHost

DIALECT = by_name("cgt")
Given = Mapping[str, object]


def expanded(
    template: str,
    toolpath: str = "",
    *,
    events: Iterable[Given] | None = None,
    machine: str = "",
    define: Mapping[str, str] | None = None,
    budget: Budget | None = None,
) -> Expansion:
    """A template with CL text, or with events."""
    name, text = "part.cl", toolpath
    if events is not None:
        name, text = "part.jsonl", "\n".join(map(json.dumps, events))
    host = MemoryHost({name: text, "mill.toml": machine})
    rules = RuleSet(DIALECT, {"input": name, "machine": "mill.toml"})
    document = Document.parse(template, DIALECT, given=DIALECT.given(rules.settings, host.read))
    return expand([Program("main.cgt", document)], rules, host, Inputs(define or {}), budget)


def flat(template: str, toolpath: str = "", **more: Any) -> list[str]:
    """The lines of a faultless expansion."""
    expansion = expanded(template, toolpath, **more)
    assert not expansion.faults, [(fault.kind, fault.message) for fault in expansion.faults]
    return expansion.lines


def once(lines: str, **more: Any) -> list[str]:
    """What the lines of one section output when it runs once."""
    return flat(f"@START\n{lines}\n@", events=[], **more)


def runs(lines: str, values: Iterable[Given], **more: Any) -> list[list[str]]:
    """What the lines of `@LINE` output at each run, under the words that are set before it."""
    given = [{"section": "LINE", "set": dict(each)} for each in values]
    marked = [part for each in given for part in (each, {"section": "mark"})]
    found: list[list[str]] = [[]]
    for line in flat(f"@LINE\n{lines}\n@\n@mark\n=====\n@", events=marked, **more):
        if line == "=====":
            found.append([])
        else:
            found[-1].append(line)
    return found[:-1]
