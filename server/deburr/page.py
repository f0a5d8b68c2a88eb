"""A rule's manual page, which is its docstring: read into parts, and spelled for a dialect. Never runs an example.

Pages of common rules must hold in every dialect, so they may write `{(}` and `{)}` for the
signs around a comment, `{dialect}` for the dialect's name, and `{x*9}` for nine times `x`.
Caret lines below such a line are moved with it.
"""

import re
from collections.abc import Callable
from dataclasses import dataclass

from deburr.rule import Rule
from deburr_grammar.dialect import Dialect

CARETS = re.compile(r"[ ]*\^+(?:[ ]+\^+)*[ ]*")
_PLACEHOLDER = re.compile(r"\{(?:\(|\)|dialect|[^{}\s]\*[0-9]+)\}")
_COMMA = re.compile(r",(?![^{}]*\})")
_BLOCK = re.compile(r"^(Bad|Good)(?: \(([^)]*)\))?:\n\n?((?:(?:    .*)?\n)+)", re.M)


@dataclass(frozen=True, slots=True)
class Block:
    """An example: whether it is good, what stands in the brackets behind `Bad`, and its lines with their carets."""

    good: bool
    options: tuple[str, ...]
    lines: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Page:
    """The parts of a page: the summary, why it matters, the source in the reference, the examples."""

    summary: str
    why: str
    source: str
    blocks: tuple[Block, ...]


def page_of(rule: Rule, dialect: Dialect, *, short: bool = True) -> Page:
    """The page of a rule in a dialect's spelling; ``short``: repetitions are hinted at, as people want it."""
    text = spelled(rule.page, dialect, short).strip() + "\n"
    blocks = tuple(_block(match) for match in _BLOCK.finditer(text))
    head = text.partition("\nBad")[0].partition("\nGood")[0]
    summary, _, rest = head.partition("\n")
    source = re.search(r"^Source: (.+)$", rest, re.M)
    why = re.sub(r"^Source: .+$", "", rest, flags=re.M).strip()
    return Page(summary, why, source[1] if source else "", blocks)


def markdown(rule: Rule, dialect: Dialect) -> str:
    """A rule's page in Markdown."""
    page = page_of(rule, dialect)
    source = [f"Source: {page.source}"] if page.source else []
    head = [f"# {rule.name} ({kind(rule)})", page.summary, page.why, *source, *mending(rule)]
    return "\n\n".join([*head, *(_fenced(block) for block in page.blocks)])


def mending(rule: Rule) -> list[str]:
    """What is said of a rule that can mend faults."""
    return [] if rule.fix is None else ["Fix: there is one for at least some of its findings."]


def kind(rule: Rule) -> str:
    """A rule's severity, and whether it speaks unless asked to."""
    return rule.severity.word if rule.default else f"{rule.severity.word}, off by default"


def title(block: Block) -> str:
    """The heading of an example."""
    return ("Good" if block.good else "Bad") + (f" ({', '.join(block.options)})" if block.options else "")


def spelled(text: str, dialect: Dialect, short: bool) -> str:
    """A page with its placeholders written out."""
    lines = text.split("\n")
    for at, line in enumerate(lines):
        if _PLACEHOLDER.search(line):
            lines[at], moved = _written(line, dialect, short)
            if at + 1 < len(lines) and CARETS.fullmatch(lines[at + 1]):
                lines[at + 1] = _carets(lines[at + 1], moved)
    return "\n".join(lines)


def _block(match: re.Match[str]) -> Block:
    options = tuple(option.strip() for option in _COMMA.split(match[2] or "") if option.strip())
    return Block(match[1] == "Good", options, tuple(line[4:] for line in match[3].rstrip("\n").split("\n")))


def _fenced(block: Block) -> str:
    return "\n".join([f"{title(block)}:", "", "```", *block.lines, "```"])


def _written(line: str, dialect: Dialect, short: bool) -> tuple[str, Callable[[int], int]]:
    """The line written out, and where its columns have gone: each placeholder's ends go to the ends of what it stands for."""
    ends = [(0, 0)]
    out = ""
    done = 0
    for match in _PLACEHOLDER.finditer(line):
        out += line[done : match.start()]
        ends.append((match.start(), len(out)))
        out += _meaning(match[0], dialect, short)
        done = match.end()
        ends.append((done, len(out)))
    return (out + line[done:]).rstrip(), lambda col: max((at, to + col - at) for at, to in ends if at <= col)[1]


def _meaning(placeholder: str, dialect: Dialect, short: bool) -> str:
    opens, closes = dialect.comments[0]
    inner = placeholder[1:-1]
    if "*" in inner:
        return f"{inner[0] * 3}...{inner[0] * 3}" if short else inner[0] * int(inner[2:])
    return {"(": opens, ")": closes, "dialect": dialect.name}[inner]


def _carets(line: str, moved: Callable[[int], int]) -> str:
    out = ""
    for run in re.finditer(r"\^+", line):
        start, end = moved(run.start()), moved(run.end())
        out += " " * (start - len(out)) + "^" * (end - start)
    return out
