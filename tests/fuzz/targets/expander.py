"""The interpreters: any program that `check` lets through ends within its budget, faults are values, and the map tells all lines."""

from __future__ import annotations

import json
import tomllib
from collections.abc import Iterator, Mapping
from typing import Any

from deburr.analysis import Analysis
from deburr.config import ConfigError, made
from deburr.configfile import given
from deburr.expand import Budget, Expansion, Program, expand
from deburr.finding import Severity
from deburr.inputs import Inputs
from deburr.ran import before_a_run, line_of, worded
from deburr.ruleset import RuleSet
from deburr_grammar.dialect import Dialect
from deburr_grammar.dialects import NAMES, by_name
from deburr_grammar.document import Document
from fuzz.choices import Choices, joined
from fuzz.stock import numbered, programs, shown
from support.cases import cases
from support.pages import MemoryHost

_FOLDER = "/job"
_MAIN = "main"
_STEPS, _LINES = 3_000, 600
_DEFINED = {"a": "1", "#100": "2.5", "HA": "3", "Depth": "-7", "V1": "0"}


def run(data: bytes) -> None:
    """A dialect, switches, settings as TOML, the program, and files beside it, each behind its name."""
    choices = Choices(data)
    dialect, switches = by_name(choices.pick(NAMES)), choices.byte()
    rules = _ruleset(dialect, choices.text())
    files = {f"{_FOLDER}/{_MAIN}": choices.text()}
    while choices and len(files) < 5:
        files[f"{_FOLDER}/{choices.text()}"] = choices.text()
    if rules is not None:
        _expanded(dialect, rules, files, _inputs(switches))


def _ruleset(dialect: Dialect, settings: str) -> RuleSet | None:
    """The rules under some settings; None if these are refused."""
    try:
        return made(dialect, given(tomllib.loads(settings), _FOLDER, "settings"))
    except (tomllib.TOMLDecodeError, ConfigError):
        return None


def _inputs(switches: int) -> Inputs:
    return Inputs(
        define=_DEFINED if switches & 1 else {},
        block_delete=(None, False, True, None)[switches >> 1 & 3],
        simulate=bool(switches & 8),
        keep_n=bool(switches & 16),
        decimals=(None, 3)[switches >> 5 & 1],
        partial=bool(switches & 64),
        reached_only=bool(switches & 128),
    )


def _expanded(dialect: Dialect, rules: RuleSet, files: Mapping[str, str], inputs: Inputs) -> None:
    name, host = next(iter(files)), MemoryHost(files)
    document = Document.parse(files[name], dialect, given=dialect.given(rules.settings, host.read))
    analysis = Analysis(document, rules, name, host, inputs=inputs)
    found = before_a_run(analysis.findings(), dialect, inputs)
    if any(finding.severity is Severity.ERROR for finding in found):
        return
    expansion = expand([Program(name, document)], rules, host, inputs, Budget(_STEPS, _LINES))
    assert len(expansion.lines) <= _LINES
    for fault in expansion.faults:
        assert worded(fault, rules, line_of(fault.file, fault.line, analysis)).message or fault.given
    _mapped(expansion, files)


def _mapped(expansion: Expansion, files: Mapping[str, str]) -> None:
    """The map tells each flat line from which line of which file it is, and back; as a document, too."""
    found = expansion.source_map
    assert len(found) == len(expansion.lines)
    for number, line in enumerate(expansion.lines):
        assert "\n" not in line and "\r" not in line
        origin = found.origin(number)
        assert origin.file in files and origin.row >= 0
        assert number in found.lines_of(origin.file, origin.row)
        assert all(entry.file in files and entry.row >= 0 for entry in found.stack(number))
    document = json.loads("".join(found.texts("flat")))
    assert document["mappings"].count(";") == max(len(found) - 1, 0)
    assert len(document["x_deburr_lines"]) == len(found)


def seeds() -> Iterator[bytes]:
    """Programs alone, rules' examples with their files, and the tests' expansions with theirs and their settings."""
    for number, dialect in numbered():
        for at, data in enumerate(programs(dialect)):
            yield joined((number, at % 128), "", data)
        for at, each in enumerate(shown(dialect)):
            if each.files or each.settings:
                beside = (part for name, text in each.files.items() for part in (name, text))
                yield joined((number, at % 128), _toml(dialect, each.settings), each.program, *beside)
        for case in cases(dialect.name):
            (_, program), *others = case.files.items()
            settings = _toml(dialect, tomllib.loads(case.parts.get("settings", "")))
            yield joined((number, 0), settings, program, *(part for other in others for part in other))


def _toml(dialect: Dialect, settings: Mapping[str, Any]) -> str:
    said = (f"{name} = {json.dumps(value)}\n" for name, value in settings.items())
    return f"[{dialect.name}]\n{''.join(said)}" if settings else ""
