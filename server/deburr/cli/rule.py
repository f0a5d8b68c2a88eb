"""`deburr rule`: the manual pages of rules."""

import argparse
from collections.abc import Iterator
from typing import Any

from deburr.catalogue import rule_names, rules_of
from deburr.cli.arguments import Parser
from deburr.cli.common import unable
from deburr.page import kind, markdown, mending, page_of, title
from deburr.rule import Rule, covers
from deburr.selection import unknown
from deburr_grammar.dialects import NAMES, by_name

FORMS = ("text", "json", "markdown")


def parser() -> argparse.ArgumentParser:
    """The command's options."""
    found = Parser(
        prog="deburr rule",
        description="Print what a rule means; without a name, or with the first words of one, list the rules.",
    )
    found.add_argument("name", nargs="?", metavar="NAME", help="a rule, rs274.divide-by-zero, or a prefix, rs274")
    found.add_argument("--output-format", choices=FORMS, default="text", help="default: text")
    return found


def run(arguments: argparse.Namespace) -> int:
    """Print a page or a list."""
    names = [name for dialect in NAMES for name in rule_names(dialect)]
    wanted = [name for name in names if arguments.name is None or covers(arguments.name, name)]
    if not wanted:
        return unable([unknown(arguments.name)])
    one = arguments.name in names
    rules = list(_rules({arguments.name} if one else set(wanted)))
    print(_page(*rules[0], arguments.output_format) if one else _list(rules, arguments.output_format))
    return 0


def _rules(names: set[str]) -> Iterator[tuple[Rule, str]]:
    for dialect in sorted({name.partition(".")[0] for name in names}):
        yield from ((rule, dialect) for rule in rules_of(dialect) if rule.name in names)


def _page(rule: Rule, dialect: str, form: str) -> str:
    if form == "json":
        return _dumped(_object(rule, dialect))
    if form == "markdown":
        return markdown(rule, by_name(dialect))
    page = page_of(rule, by_name(dialect))
    parts = [f"{rule.name} ({kind(rule)})", page.summary, page.why, f"Source: {page.source}", *mending(rule)]
    parts += [
        f"{title(block)}:\n\n" + "\n".join(f"    {line}".rstrip() for line in block.lines) for block in page.blocks
    ]
    return "\n\n".join(parts)


def _list(rules: list[tuple[Rule, str]], form: str) -> str:
    if form == "json":
        return _dumped([_object(rule, dialect) for rule, dialect in rules])
    if form == "markdown":
        rows = (f"| `{rule.name}` | {kind(rule)} | {rule.summary} |" for rule, _ in rules)
        return "\n".join(["| rule | severity | meaning |", "|---|---|---|", *rows])
    width = max(len(rule.name) for rule, _ in rules)
    return "\n".join(f"{rule.name:<{width}}  {rule.severity.word:<7}  {rule.summary}" for rule, _ in rules)


def _object(rule: Rule, dialect: str) -> dict[str, Any]:
    page = page_of(rule, by_name(dialect))
    return {
        "rule": rule.name,
        "dialect": dialect,
        "severity": rule.severity.word,
        "default": rule.default,
        "fix": rule.fix is not None,
        "summary": page.summary,
        "explanation": page.why,
        "source": page.source,
        "examples": [{"good": b.good, "options": list(b.options), "text": "\n".join(b.lines)} for b in page.blocks],
    }


def _dumped(found: Any) -> str:
    from json import dumps

    return dumps(found, indent=2, ensure_ascii=False)
