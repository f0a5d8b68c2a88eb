"""Rule pages as tests: the `Bad:` and `Good:` blocks of a rule's docstring with what they must give."""

import re
import tomllib
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from deburr import source
from deburr.analysis import Analysis
from deburr.check import check
from deburr.expand import Program, expand
from deburr.finding import Finding
from deburr.page import CARETS, page_of
from deburr.ran import ran, worded
from deburr.rule import Rule
from deburr.ruleset import RuleSet
from deburr_grammar.dialect import Dialect
from deburr_grammar.document import Document

_MACHINE = "machine."
_FILE = re.compile(r"^-- (.+) --$")
BYTES = str.maketrans({"␀": "\0", "␚": "\x1a", "␍": "\r", "⚑": "\ufeff"})
"""Pictures of what cannot be seen."""


@dataclass(frozen=True)
class Example:
    """One block: the program in its frame, the files beside it, settings, and where the rule must speak; ``elsewhere``: in which of the files."""

    good: bool
    program: str
    files: Mapping[str, str]
    settings: Mapping[str, object]
    places: tuple[tuple[int, int, int], ...]
    elsewhere: tuple[tuple[str, int, int, int], ...] = ()
    machine: Mapping[str, object] = field(default_factory=dict)


def examples(rule: Rule, dialect: Dialect) -> Iterator[Example]:
    """All blocks of a rule's page.

    `Bad (whole):` is a program of its own, without the dialect's frame; `Bad (profile=smithy):`
    sets a setting, `Bad (machine.z-safe=2):` one of the machine; a value with `|` is a list. A line `-- NAME --` starts another file.
    In a whole program `{}` is the frame with nothing in it; `␀`, `␚` and `␍` stand for the bytes that they are pictures of, `⚑` for a byte order mark.
    """
    for block in page_of(rule, dialect, short=False).blocks:
        frame = "{}" if "whole" in block.options else dialect.frame
        bare = dialect.frame.replace("{}\n", "").replace("{}", "").removesuffix("\n")
        lines = [line.replace("{}", bare) for line in block.lines]
        said = dict(option.split("=", 1) for option in block.options if "=" in option)
        machine = {name.removeprefix(_MACHINE): said.pop(name) for name in list(said) if name.startswith(_MACHINE)}
        described = tomllib.loads("\n".join(f"{name} = {value}" for name, value in machine.items()))
        yield _example(block.good, lines, frame, {name: _value(value) for name, value in said.items()}, described)


def _value(said: str) -> object:
    return said.split("|") if "|" in said else said


def _example(
    good: bool, lines: Sequence[str], frame: str, settings: Mapping[str, object], machine: Mapping[str, object]
) -> Example:
    files: dict[str, list[str]] = {"": []}
    places: list[tuple[int, int, int]] = []
    elsewhere: list[tuple[str, int, int, int]] = []
    current, row = "", 0
    first = frame[: frame.index("{}")].count("\n")
    for line in lines:
        if named := _FILE.match(line):
            current = named[1]
            files[current] = []
        elif CARETS.fullmatch(line):
            spans = [run.span() for run in re.finditer(r"\^+", line)]
            elsewhere += [(current, row, *span) for span in spans if current]
            places += [(first + row, *span) for span in spans if not current]
        else:
            row = len(files[current])
            files[current] += line.split("\n")
    program = frame.replace("{}", "\n".join(files.pop(""))).translate(BYTES)
    texts = {name: "\n".join(text) + "\n" for name, text in files.items()}
    return Example(good, program, texts, settings, tuple(places), tuple(elsewhere), machine)


class MemoryHost:
    """Files that exist only in a test."""

    def __init__(self, files: Mapping[str, str]) -> None:
        self._files = dict(files)

    def read(self, path: str) -> str | None:
        return self._files.get(path)

    def names(self, folder: str) -> Sequence[str]:
        inside = "" if folder in ("", ".") else folder.rstrip("/") + "/"
        return sorted({path[len(inside) :].split("/")[0] for path in self._files if path.startswith(inside)})


def checked(
    example: Example, dialect: Dialect, selected: Callable[[Rule], bool] = lambda rule: rule.default
) -> list[Finding]:
    """What all default rules of the dialect, or those that are selected, say of an example."""
    program = source.read(example.program.encode())
    assert isinstance(program, source.Source)
    ruleset = RuleSet(dialect, example.settings, selected, machine=example.machine)
    return check(program, dialect, ruleset, "", MemoryHost(example.files), ran)


def refused(
    example: Example, dialect: Dialect, selected: Callable[[Rule], bool] = lambda rule: rule.default
) -> list[Finding]:
    """What an expansion says of an example: also what only an input that was not given could decide."""
    ruleset, host = RuleSet(dialect, example.settings, selected), MemoryHost(example.files)
    document = Document.parse(example.program, dialect)
    found = Analysis(document, ruleset, "", host).findings()
    expansion = expand([Program("", document)], ruleset, host)
    met = (worded(fault, ruleset, document.line(fault.line)) for fault in expansion.faults)
    return sorted([*found, *met], key=lambda finding: finding.order)
