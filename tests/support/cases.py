"""Expansions as data: a program, its inputs, the flat program that it must give, and where each line of it comes from, in one file."""

import re
import tomllib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from deburr.expand import Budget, Expansion, Inputs, Program, expand
from deburr.ruleset import RuleSet
from deburr_grammar.dialects import by_name
from deburr_grammar.document import Document
from support.pages import MemoryHost

FOLDER = Path(__file__).parents[1] / "expand" / "cases"
_PART = re.compile(r"^-- (.+) --\n", re.M)
_OURS = ("settings", "inputs", "expect", "map", "faults")


@dataclass(frozen=True)
class Case:
    """One txtar file: a title, then parts.

    The first part that is none of ours is the program, `-- a.mgc b.mgc --` joins several, the others are files beside it.
    `settings`: the dialect's table in TOML. `inputs`: TOML with `define`, `block-delete`, `simulate`, `keep-n`,
    `decimals`, `steps`, `blocks`, `programs` (a list, if several are joined). `expect`: the flat program. `map`: for each flat line
    `1 <- main.ngc:7 <- main.ngc:3 (loop 2)`, rows 1-based, innermost first. `faults`: `rule file:row words of the message`, one a line.
    """

    name: str
    dialect: str
    files: Mapping[str, str]
    parts: Mapping[str, str]

    @property
    def expected(self) -> list[str]:
        """The flat program's lines."""
        return self.parts.get("expect", "").removesuffix("\n").split("\n") if self.parts.get("expect") else []


def cases(dialect: str) -> Iterator[Case]:
    """All cases of a dialect."""
    for path in sorted((FOLDER / dialect).glob("*.txtar")):
        found = _PART.split(path.read_text(encoding="utf-8"))[1:]
        parts = dict(zip(found[::2], found[1::2], strict=True))
        files = {name: text for name, text in parts.items() if name not in _OURS}
        yield Case(path.stem, dialect, files, {name: parts[name] for name in _OURS if name in parts})


def expanded(case: Case) -> Expansion:
    """What a case gives."""
    given = tomllib.loads(case.parts.get("inputs", ""))
    budget = Budget(given.pop("steps", 1_000_000), given.pop("blocks", 1_000_000))
    names = given.pop("programs", [next(iter(case.files))])
    inputs = Inputs(
        define=given.pop("define", {}),
        block_delete=given.pop("block-delete", None),
        simulate=given.pop("simulate", False),
        keep_n=given.pop("keep-n", False),
        decimals=given.pop("decimals", None),
        reached_only=given.pop("reached-only", False),
    )
    assert not given, f"unknown inputs {given}"
    dialect = by_name(case.dialect)
    host = MemoryHost(case.files)
    ruleset = RuleSet(dialect, tomllib.loads(case.parts.get("settings", "")))
    given_facts = dialect.given(ruleset.settings, host.read)
    programs = [Program(name, Document.parse(case.files[name], dialect, given=given_facts)) for name in names]
    return expand(programs, ruleset, host, inputs, budget)


def mapped(expansion: Expansion) -> list[str]:
    """The source map in the form of `map`."""
    found = []
    for line in range(len(expansion.lines)):
        origin = expansion.source_map.origin(line)
        steps = [f"{line + 1} <- {origin.file}:{origin.row + 1}"]
        frames = expansion.source_map.stack(line)
        steps += [f"{frame.file}:{frame.row + 1} ({frame.kind} {frame.number})" for frame in frames]
        found.append(" <- ".join(steps))
    return found
