"""RS274 programs run in tests: their expansion, and the value of an expression."""

from collections.abc import Mapping

from deburr.expand import Budget, Expansion, Inputs, Program, expand
from deburr.expand.job import EXACT
from deburr.ruleset import RuleSet
from deburr_grammar.dialects import by_name
from deburr_grammar.document import Document
from support.pages import MemoryHost

DIALECT = by_name("rs274")
RULES = RuleSet(DIALECT)
MAIN = "main.ngc"


def expansion(
    text: str,
    files: Mapping[str, str] | None = None,
    inputs: Inputs | None = None,
    budget: Budget | None = None,
    rules: RuleSet = RULES,
) -> Expansion:
    """The expansion of a program with files beside it."""
    host = MemoryHost({MAIN: text, **(files or {})})
    return expand([Program(MAIN, Document.parse(text, DIALECT))], rules, host, inputs, budget)


def flat(text: str, files: Mapping[str, str] | None = None, inputs: Inputs | None = None) -> list[str]:
    """The lines of an expansion."""
    return expansion(text, files, inputs).lines


def value(said: str) -> float:
    """What an expression comes to."""
    line, _ = flat(f"#1=0\nG0 X[#1+{said}]\nM2\n", {}, Inputs(decimals=EXACT))
    return float(line.removeprefix("G0 X"))
