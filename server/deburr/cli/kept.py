"""Outcomes that are kept: under which name, until when, and as which plain values. Checks nothing."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from deburr import paths
from deburr.catalogue import known_rules
from deburr.cli.build import build
from deburr.cli.fingerprint import digest
from deburr.cli.run import Outcome, asked
from deburr.finding import Finding, Fix, Place, Related, Severity
from deburr.ran import Aside
from deburr_grammar.dialects import NAMES
from deburr_grammar.text import Edit, Pos

if TYPE_CHECKING:
    from collections.abc import Iterable

    from deburr.cli.cache import Cache
    from deburr.cli.disk import Disk
    from deburr.cli.run import Options
    from deburr.config import Config
    from deburr.needs import Needs


class Keeper:
    """Keeps outcomes in a cache and finds them again as long as nothing that decided them is another."""

    def __init__(self, cache: Cache, disk: Disk, options: Options) -> None:
        self._cache = cache
        self._disk = disk
        values = "" if options.values is None else disk.digest(paths.absolute(options.values))
        said = (options.dialect, options.inputs._replace(define={}), sorted(options.inputs.define.items()), values)
        self._terms = digest(build(), repr(said))
        self._configs: dict[int, tuple[Config, str]] = {}

    def name(self, file: str, data: bytes, config: Config) -> str:
        """The name under which the outcome of a program stands: another for each difference in what is known before a check."""
        if id(config) not in self._configs:
            self._configs[id(config)] = (config, digest(repr(config)))
        return digest(self._terms, self._configs[id(config)][1], file, data)

    def find(self, name: str, file: str, fail_on: Severity) -> Outcome | None:
        """The outcome that was kept; None if there is none, or if a file or folder that it hangs on has changed."""
        entry = self._cache.get(name)
        try:
            return _outcome(entry, file, fail_on) if entry is not None and self._holds(entry) else None
        except (AttributeError, KeyError, TypeError, ValueError):
            return None

    def keep(self, name: str, outcome: Outcome, needs: Needs) -> None:
        """Keep an outcome with what it asked of other files."""
        if not outcome.failure and not outcome.misgiven:
            texts = {path: self._disk.digest(path) for path in needs.texts}
            folders = {folder: self._disk.listed(folder) for folder in needs.folders}
            self._cache.put(name, {**_entry(outcome), "texts": texts, "folders": folders})

    def _holds(self, entry: dict[str, Any]) -> bool:
        disk = self._disk
        return all(disk.digest(path) == said for path, said in entry["texts"].items()) and all(
            disk.listed(folder) == said for folder, said in entry["folders"].items()
        )


def _entry(outcome: Outcome) -> dict[str, Any]:
    """An outcome but for what the next check knows by itself: its file, what fails it, the lines that are shown."""
    return {
        "dialect": outcome.dialect,
        "reason": outcome.reason,
        "origin": outcome.origin,
        "asides": outcome.asides,
        "findings": outcome.findings,
        "keys": outcome.keys,
    }


def _outcome(entry: dict[str, Any], file: str, fail_on: Severity) -> Outcome:
    """The outcome in an entry; ValueError or its like if it is none that was put there."""
    dialect, findings = entry["dialect"], tuple(map(_finding, entry["findings"]))
    keys = tuple(_text(key) for key in entry["keys"])
    known = dialect in (None, *NAMES) and all(each.rule in known_rules(dialect) for each in findings)
    if not known or len(keys) not in (0, len(findings)):
        raise ValueError
    return Outcome(
        file,
        dialect,
        _text(entry["reason"]),
        findings,
        fail_on,
        origin=_text(entry["origin"]),
        asides=tuple(_aside(*each) for each in entry["asides"]),
        keys=keys,
        kept=True,
        asked=asked(map(_text, entry["texts"]), map(_text, entry["folders"])),
    )


def _finding(said: list[Any]) -> Finding:
    rule, severity, message, place, related, fix = said
    others = tuple(Related(_place(*at), _text(text), bool(entered)) for at, text, entered in related)
    made = None if fix is None else _fix(*fix)
    return Finding(_text(rule), Severity(severity), _text(message), _place(*place), others, made)


def _fix(title: str, edits: Iterable[Any], safe: bool) -> Fix:
    made = tuple(Edit(_pos(*start), _pos(*end), _text(text)) for start, end, text in edits)
    return Fix(_text(title), made, bool(safe))


def _place(file: str, line: int, col: int, end_line: int, end_col: int) -> Place:
    return Place(_text(file), *_pos(line, col), *_pos(end_line, end_col))


def _pos(line: int, col: int) -> Pos:
    return Pos(_number(line), _number(col))


def _aside(file: str, line: int, why: str, what: str) -> Aside:
    return Aside(_text(file), _number(line), _text(why), _text(what))


def _text(said: Any) -> str:
    if type(said) is not str:
        raise TypeError
    return said


def _number(said: Any) -> int:
    if type(said) is not int or said < 0:
        raise TypeError
    return said
