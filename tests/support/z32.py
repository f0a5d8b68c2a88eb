"""Z32 programs that are run in memory."""

from collections.abc import Mapping

from deburr.analysis import Analysis
from deburr.expand import Budget, Expansion, Inputs, Program, expand
from deburr.ran import ran
from deburr.ruleset import RuleSet
from deburr_grammar.dialects import by_name
from deburr_grammar.document import Document
from support.pages import MemoryHost

DIALECT = by_name("z32")
RULES = RuleSet(DIALECT)
MAIN = "main.z32"


def expanded(
    program: str,
    files: Mapping[str, str] | None = None,
    inputs: Inputs | None = None,
    budget: Budget | None = None,
    settings: Mapping[str, object] | None = None,
) -> Expansion:
    """A program with the files beside it."""
    rules = RuleSet(DIALECT, settings) if settings else RULES
    return expand([Program(MAIN, Document.parse(program, DIALECT))], rules, MemoryHost(files or {}), inputs, budget)


def flat(program: str, files: Mapping[str, str] | None = None, **inputs: object) -> list[str]:
    """The lines of an expansion that meets nothing."""
    expansion = expanded(program, files, Inputs(**inputs))  # type: ignore[arg-type]  # handed on as they are
    assert not expansion.faults, expansion.faults
    return expansion.lines


def checked(
    program: str, files: Mapping[str, str] | None = None, inputs: Inputs | None = None, **settings: object
) -> list[str]:
    """What `check` says with a run: rules, files but for the program's own, lines from 1, and columns: `limit 3 4-7`."""
    ruleset = RuleSet(DIALECT, {name.replace("_", "-"): value for name, value in settings.items()})
    analysis = Analysis(
        Document.parse(program, DIALECT), ruleset, MAIN, MemoryHost(files or {}), run=lambda each: ran(each, inputs)
    )
    return [
        f"{each.rule.removeprefix('z32.')} {_place(each.place.file)}{each.place.line + 1} {each.place.col}-{each.place.end_col}"
        for each in analysis.findings()
    ]


def met(
    program: str, files: Mapping[str, str] | None = None, inputs: Inputs | None = None, **settings: object
) -> list[str]:
    """What `expand` meets, in the same form."""
    given = {name.replace("_", "-"): value for name, value in settings.items()}
    return [
        f"{each.kind} {_place(each.file)}{each.line + 1} {each.span.start}-{each.span.end}"
        for each in expanded(program, files, inputs, Budget(200_000, 0), given).faults
    ]


def _place(file: str) -> str:
    return "" if file == MAIN else f"{file}:"
