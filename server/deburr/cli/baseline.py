"""A file of the findings that were there before, so that an old archive can start clean: only what is new is reported.

Each stands under its program, named from the baseline's own folder, with its fingerprint and its rule.
"""

import argparse
from collections.abc import Iterator
from typing import Any, NamedTuple

from deburr import paths
from deburr.cli.common import complain
from deburr.cli.forge import inside
from deburr.cli.result import Result
from deburr.config import ConfigError

VERSION = 1
Entries = dict[str, dict[str, str]]
"""The rules of findings by program and fingerprint."""


class Baseline(NamedTuple):
    """A baseline file and what it holds."""

    path: str
    entries: Entries = {}

    def known(self) -> frozenset[tuple[str, str]]:
        """Its findings by file and fingerprint."""
        folder = paths.parent(self.path)
        return frozenset((paths.absolute(file, folder), mark) for file, marks in self.entries.items() for mark in marks)

    def renewed(self, result: Result, *, whole: bool = False) -> "Baseline":
        """With what was found now. Programs that were not looked at keep what they had, if they are still there; ``whole``: all were."""
        folder = paths.parent(self.path)
        looked = {outcome.file for outcome in result.outcomes if not outcome.failure}
        looked |= {each.finding.place.file for each in result.everything}
        entries: Entries = {}
        for file, marks in self.entries.items() if not whole else ():
            path = paths.absolute(file, folder)
            if path not in looked and paths.exists(path):
                entries[file] = marks
        for each in result.everything:
            name = inside(each.finding.place.file, folder)
            entries.setdefault(name, {})[each.fingerprint] = each.finding.rule
        return Baseline(self.path, entries)

    def save(self) -> None:
        """Write it, whole or not at all; OSError if that cannot be done."""
        from json import dumps

        from deburr.cli.replacing import replacing

        found = {"version": VERSION, "findings": {file: dict(sorted(marks.items())) for file, marks in self._sorted()}}
        with replacing(self.path) as out:
            out.write((dumps(found, indent=1, ensure_ascii=False) + "\n").encode("utf-8", "surrogatepass"))

    def __len__(self) -> int:
        return sum(map(len, self.entries.values()))

    def _sorted(self) -> Iterator[tuple[str, dict[str, str]]]:
        return iter(sorted(self.entries.items()))


def compared(result: Result, arguments: argparse.Namespace, *, whole: bool = False) -> Result:
    """The result without what the file of `--baseline` holds, which is written anew if `--update-baseline` is given."""
    old = load(arguments.baseline, new=arguments.update_baseline)
    now = old.renewed(result, whole=whole)
    if arguments.update_baseline:
        try:
            now.save()
        except OSError as error:
            raise ConfigError(f"{arguments.baseline}: {error.strerror}") from None
        if not arguments.quiet:
            gone, new = len(old.known() - now.known()), len(now.known() - old.known())
            complain(f"{arguments.baseline}: {len(now)} findings known; {new} new, {gone} dropped", "")
        old = now
    elif arguments.verbose and (gone := len(old.known() - now.known())):
        complain(f"{arguments.baseline}: {gone} of its findings are no more; --update-baseline drops them", "")
    return Result(result.outcomes, old.known(), result.origin, result.shard)


def load(path: str, *, new: bool = False) -> Baseline:
    """The baseline in a file; ConfigError if it is none. ``new``: one that is not there is empty."""
    from json import loads

    place = paths.absolute(path)
    try:
        found: Any = loads(paths.data(place))
    except FileNotFoundError:
        if new:
            return Baseline(place)
        raise ConfigError(f"{path}: no such file; --update-baseline writes it") from None
    except OSError as error:
        raise ConfigError(f"{path}: {error.strerror}") from None
    except (ValueError, RecursionError):
        raise ConfigError(f"{path}: {_NONE}") from None
    if isinstance(found, dict) and found.get("version", VERSION) != VERSION:
        raise ConfigError(f"{path}: written by another version of deburr; write it anew with --update-baseline")
    entries = found.get("findings") if isinstance(found, dict) else None
    if not isinstance(entries, dict) or not all(map(_is_program, entries.values())):
        raise ConfigError(f"{path}: {_NONE}")
    return Baseline(place, entries)


_NONE = "no baseline; take it away, and --update-baseline writes a new one"


def _is_program(said: object) -> bool:
    return isinstance(said, dict) and all(isinstance(rule, str) for rule in said.values())
