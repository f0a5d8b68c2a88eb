"""MetaGCODE programs that are run in memory."""

from collections.abc import Mapping

from deburr.expand import Budget, Expansion, Inputs, Program, expand
from deburr.ruleset import RuleSet
from deburr_grammar.dialects import by_name
from deburr_grammar.document import Document
from support.pages import MemoryHost

DIALECT = by_name("metagcode")
RULES = RuleSet(DIALECT)


def expanded(
    *programs: str,
    files: Mapping[str, str] | None = None,
    define: Mapping[str, str] | None = None,
    decimals: int | None = None,
    budget: Budget | None = None,
) -> Expansion:
    """Programs joined in order. Files are named relative to the folder of snippets."""
    host = MemoryHost({f"Snippets/{name}": text for name, text in (files or {}).items()})
    given = [Program(f"{at}.mgc", Document.parse(text, DIALECT)) for at, text in enumerate(programs)]
    return expand(given, RULES, host, Inputs(define or {}, decimals=decimals), budget)


def flat(*programs: str, **more: object) -> list[str]:
    """The lines of a faultless expansion."""
    expansion = expanded(*programs, **more)  # type: ignore[arg-type]
    assert not [fault for fault in expansion.faults if fault.kind not in ("loop-zero", "alpha-number", "alpha-case")]
    return expansion.lines
