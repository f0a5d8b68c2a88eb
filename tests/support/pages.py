"""Rule pages as tests: the `Bad:` and `Good:` blocks of a rule's docstring with what they must give."""

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from deburr.analysis import Analysis
from deburr.finding import Finding
from deburr.rule import Rule
from deburr.ruleset import RuleSet
from deburr_grammar.dialect import Dialect
from deburr_grammar.document import Document

_BLOCK = re.compile(r"^(Bad|Good)(?: \((?P<options>[^)]*)\))?:\n\n?((?:(?:    .*)?\n)+)", re.M)
_CARETS = re.compile(r"[ ]*\^+(?:[ ]+\^+)*[ ]*")
_FILE = re.compile(r"^-- (.+) --$")


@dataclass(frozen=True)
class Example:
    """One block: the program in its frame, the files beside it, settings, and where the rule must speak."""

    good: bool
    program: str
    files: Mapping[str, str]
    settings: Mapping[str, object]
    places: tuple[tuple[int, int, int], ...]


def examples(rule: Rule, dialect: Dialect) -> Iterator[Example]:
    """All blocks of a rule's page.

    `Bad (whole):` is a program of its own, without the dialect's frame; `Bad (profile=smithy):`
    sets a setting; a value with `|` is a list. A line `-- NAME --` starts another file.
    """
    for match in _BLOCK.finditer(rule.page + "\n"):
        options = [option.strip() for option in (match["options"] or "").split(",") if option.strip()]
        lines = [line[4:] for line in match[3].rstrip("\n").split("\n")]
        frame = "{}" if "whole" in options else dialect.frame
        settings = dict(option.split("=", 1) for option in options if "=" in option)
        yield _example(match[1] == "Good", lines, frame, {name: _value(said) for name, said in settings.items()})


def _value(said: str) -> object:
    return said.split("|") if "|" in said else said


def _example(good: bool, lines: Sequence[str], frame: str, settings: Mapping[str, object]) -> Example:
    files: dict[str, list[str]] = {"": []}
    places: list[tuple[int, int, int]] = []
    current = ""
    first = frame[: frame.index("{}")].count("\n")
    for line in lines:
        if named := _FILE.match(line):
            current = named[1]
            files[current] = []
        elif _CARETS.fullmatch(line):
            assert not current, "carets mark the program itself, not another file"
            row = first + len(files[""]) - 1
            places += [(row, run.start(), run.end()) for run in re.finditer(r"\^+", line)]
        else:
            files[current].append(line)
    program = frame.replace("{}", "\n".join(files.pop("")))
    return Example(good, program, {name: "\n".join(text) + "\n" for name, text in files.items()}, settings, tuple(places))


class MemoryHost:
    """Files that exist only in a test."""

    def __init__(self, files: Mapping[str, str]) -> None:
        self._files = dict(files)

    def read(self, path: str) -> str | None:
        return self._files.get(path)

    def names(self, folder: str) -> Sequence[str]:
        inside = "" if folder in ("", ".") else folder.rstrip("/") + "/"
        return sorted({path[len(inside) :].split("/")[0] for path in self._files if path.startswith(inside)})


def checked(example: Example, dialect: Dialect) -> list[Finding]:
    """What all default rules of the dialect, and the named rule, say of an example."""
    ruleset = RuleSet(dialect, example.settings)
    return Analysis(Document.parse(example.program, dialect), ruleset, "", MemoryHost(example.files)).findings()
