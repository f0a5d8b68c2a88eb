"""MetaGCODE programs that are checked and run in memory."""

from collections.abc import Iterator, Mapping
from random import Random
from typing import Any

from deburr.analysis import Analysis
from deburr.expand import Budget, Expansion, Inputs, Program, expand
from deburr.finding import Finding
from deburr.host import Host
from deburr.ruleset import RuleSet
from deburr_grammar.dialects import by_name
from deburr_grammar.document import Document
from support.pages import MemoryHost

DIALECT = by_name("metagcode")
RULES = RuleSet(DIALECT)
NAMES = ("a", "b", "c", "d")
LITERALS = ("0", "1", "2", "-1", "5", "10", "0.3", "-2.5", "Steel", "Brass")
OPERATORS = ("greaterthan", "lessthan", "equalto", "notequalto")


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
    expansion = expanded(*programs, **more)  # type: ignore[arg-type]  # handed on as they are
    assert not [fault for fault in expansion.faults if fault.kind not in ("loop-zero", "alpha-number", "alpha-case")]
    return expansion.lines


def found(
    program: str,
    files: Mapping[str, str] | None = None,
    file: str = "main.mgc",
    host: Host | None = None,
    **settings: str,
) -> list[Finding]:
    """All findings. Files are named relative to the folder of snippets."""
    host = host or MemoryHost({f"Snippets/{name}": text for name, text in (files or {}).items()})
    rules = RuleSet(DIALECT, settings) if settings else RULES
    return Analysis(Document.parse(program, DIALECT), rules, file, host).findings()


def said(program: str, files: Mapping[str, str] | None = None, **more: Any) -> list[str]:
    """The rules that speak and their lines, counted from 1: `block-unclosed 3`."""
    return [f"{each.rule.removeprefix('metagcode.')} {each.place.line + 1}" for each in found(program, files, **more)]


def program(rng: Random) -> str:
    """A program of conditions and loops in each other."""
    return "\n".join(_block(rng, 3)) + "\n"


def _block(rng: Random, depth: int) -> Iterator[str]:
    for _ in range(rng.randint(1, 3)):
        label = rng.randint(1, 99)
        sort = rng.random() if depth else 1.0
        if sort < 0.6:
            sides = [f"|{rng.choice(NAMES)}|", rng.choice((*LITERALS, f"|{rng.choice(NAMES)}|"))]
            rng.shuffle(sides)
            yield f"#IF{label} {sides[0]} {rng.choice(OPERATORS)} {sides[1]} {rng.choice('nna')}"
            yield from _block(rng, depth - 1)
            yield f"#ENDIF{label}"
        elif sort < 0.8:
            total, step = rng.choice(NAMES), rng.choice(("1", "2.5", f"|{rng.choice(NAMES)}|"))
            yield f"#LOOP{label} |{total}| {step} {rng.choice('cr')}"
            yield from _block(rng, depth - 1)
            yield f"#ENDLOOP{label}"
        else:
            yield f"G1 X{rng.choice(('', '-', '+'))}|{rng.choice(NAMES)}|"
