"""Outcomes that are kept: under which name, until when, and as which plain values. Checks nothing."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from deburr import paths
from deburr.cli.build import build
from deburr.cli.fingerprint import digest
from deburr.cli.run import Outcome
from deburr.finding import Finding, Fix, Place, Related, Severity
from deburr.ran import Aside
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
        except (KeyError, TypeError, ValueError, IndexError):
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
    return Outcome(
        file,
        entry["dialect"],
        entry["reason"],
        tuple(map(_finding, entry["findings"])),
        fail_on,
        origin=entry["origin"],
        asides=tuple(Aside(*each) for each in entry["asides"]),
        keys=tuple(entry["keys"]),
        kept=True,
    )


def _finding(said: list[Any]) -> Finding:
    rule, severity, message, place, related, fix = said
    others = tuple(Related(Place(*at), text, entered) for at, text, entered in related)
    return Finding(rule, Severity(severity), message, Place(*place), others, None if fix is None else _fix(*fix))


def _fix(title: str, edits: Iterable[Any], safe: bool) -> Fix:
    return Fix(title, tuple(Edit(Pos(*start), Pos(*end), text) for start, end, text in edits), safe)
