"""What a dialect's `editor.toml` says to editors, as TextMate grammars and language configurations. Knows no extension's manifest."""

import re
import tomllib
from collections.abc import Mapping
from importlib.resources import files
from typing import Any

from deburr_grammar.codes import CodeTable
from deburr_grammar.dialect import Dialect

_LETTER = re.compile(r"\\.|\[(?:\\.|[^\]\\])*\]|[A-Za-z]")
_PLACE = re.compile(r"\{([a-z]+)\}")


def editor_of(dialect: Dialect) -> dict[str, Any]:
    """The dialect's `editor.toml`, the names of its tables put in."""
    text = files(dialect.package).joinpath("editor.toml").read_text(encoding="utf-8")
    found: dict[str, Any] = _filled(tomllib.loads(text), dialect.codes)
    return found


def textmate(dialect: Dialect) -> dict[str, Any]:
    """The dialect's TextMate grammar."""
    name = dialect.name
    return {
        "name": dialect.title,
        "scopeName": f"source.{name}",
        "patterns": [_pattern(each, name) for each in editor_of(dialect)["colour"]],
    }


def configuration(dialect: Dialect) -> dict[str, Any]:
    """The dialect's language configuration: comments, pairs, folding, indentation."""
    said = editor_of(dialect)
    pairs = [*said.get("brackets", ()), *said.get("pairs", ())]
    comments = {"lineComment": said.get("line-comment"), "blockComment": said.get("block-comment")}
    found: dict[str, Any] = {
        "comments": {key: value for key, value in comments.items() if value},
        "brackets": said.get("brackets", []),
        "autoClosingPairs": [{"open": left, "close": right} for left, right in pairs],
        "surroundingPairs": pairs,
    }
    if folding := said.get("folding"):
        found["folding"] = {"markers": {end: _both_cases(folding[end]) for end in ("start", "end")}}
    if indent := said.get("indent"):
        found["indentationRules"] = {
            "increaseIndentPattern": _script(indent["increase"]),
            "decreaseIndentPattern": _script(indent["decrease"]),
        }
    return found


def _filled(value: Any, codes: CodeTable) -> Any:
    """The value with the names of tables in place of `{table}`; the longest first, so that none hides another."""
    if isinstance(value, str):
        return _PLACE.sub(lambda match: _names(codes, match[1]) or match[0], value)
    if isinstance(value, Mapping):
        return {key: _filled(each, codes) for key, each in value.items()}
    return [_filled(each, codes) for each in value] if isinstance(value, list) else value


def _names(codes: CodeTable, table: str) -> str:
    names = sorted((entry.name for entry in codes.table(table)), key=lambda name: (-len(name), name))
    return "|".join(re.escape(name) for name in names)


def _pattern(said: Mapping[str, Any], dialect: str) -> dict[str, Any]:
    found: dict[str, Any] = {"name": f"{said['scope']}.{dialect}"}
    found |= {key: said[key] for key in ("match", "begin", "end") if key in said}
    if captures := said.get("captures"):
        found["beginCaptures" if "begin" in said else "captures"] = _captures(captures, dialect)
    if inside := said.get("inside"):
        within: dict[str, Any] = {"match": inside}
        if scope := said.get("inside-scope"):
            within["name"] = f"{scope}.{dialect}"
        if captures := said.get("inside-captures"):
            within["captures"] = _captures(captures, dialect)
        found["patterns"] = [within]
    return found


def _captures(said: Mapping[str, str], dialect: str) -> dict[str, Any]:
    return {number: {"name": f"{scope}.{dialect}"} for number, scope in said.items()}


def _both_cases(pattern: str) -> str:
    """A pattern for JavaScript where no flag can be given: each letter in both cases."""
    if not pattern.startswith("(?i)"):
        return pattern
    return _LETTER.sub(
        lambda match: match[0] if len(match[0]) > 1 else f"[{match[0].upper()}{match[0].lower()}]",
        pattern.removeprefix("(?i)"),
    )


def _script(pattern: str) -> Any:
    """A pattern for JavaScript, which has no `(?i)` inside: letters without regard to case become a flag."""
    return {"pattern": pattern.removeprefix("(?i)"), "flags": "i"}
