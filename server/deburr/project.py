"""The programs of a session and what each depends on: after a change only those are checked again that it can concern. Never opens a file itself."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, NamedTuple

from deburr.check import check

if TYPE_CHECKING:
    from deburr.finding import Finding
    from deburr.host import Host
    from deburr.ruleset import RuleSet
    from deburr.source import Source
    from deburr_grammar.dialect import Dialect


class Program(NamedTuple):
    """A program as it is to be checked: its text, its dialect, and the rule set that its configuration gives."""

    source: Source
    dialect: Dialect
    ruleset: RuleSet


@dataclass
class Needs:
    """A host that remembers what was asked of it: the hash of each file's text (None: there was none) and the names in each folder."""

    host: Host
    texts: dict[str, int | None] = field(default_factory=dict)
    folders: dict[str, tuple[str, ...]] = field(default_factory=dict)

    def read(self, path: str) -> str | None:
        """The text of a file."""
        text = self.host.read(path)
        self.texts[path] = None if text is None else hash(text)
        return text

    def names(self, folder: str) -> Sequence[str]:
        """The names in a folder."""
        names = self.host.names(folder)
        self.folders[folder] = tuple(names)
        return names

    def concerned(self, path: str, host: Host) -> bool:
        """Whether a file that was written, made or taken away can make any difference."""
        if path in self.texts:
            text = host.read(path)
            if self.texts[path] != (None if text is None else hash(text)):
                return True
        folder = path.rpartition("/")[0]
        return any(
            tuple(host.names(each)) != names for each, names in self.folders.items() if each.rstrip("/") == folder
        )


class Project:
    """Programs under their paths. ``host`` gives the present state of all files, open ones as they are in the editor."""

    def __init__(self, host: Host) -> None:
        self._host = host
        self._programs: dict[str, Program] = {}
        self._kept: dict[str, tuple[tuple[Finding, ...], Needs]] = {}

    def put(self, file: str, program: Program) -> None:
        """A program that is new, or changed in its text, its dialect or its configuration. One that is as it was stays known."""
        if self._programs.get(file) != program:
            self._programs[file] = program
            self._kept.pop(file, None)

    def remove(self, file: str) -> None:
        """A program that is of no interest any more."""
        self._programs.pop(file, None)
        self._kept.pop(file, None)

    def findings(self, file: str) -> tuple[Finding, ...]:
        """All findings of a program, as if it were checked now."""
        kept = self._kept.get(file)
        if kept is None:
            needs = Needs(self._host)
            source, dialect, ruleset = self._programs[file]
            kept = self._kept[file] = tuple(check(source, dialect, ruleset, file, needs)), needs
        return kept[0]

    def changed(self, paths: Iterable[str]) -> tuple[str, ...]:
        """The programs whose findings may be others now that these files were written, made or taken away."""
        changed = tuple(paths)
        concerned = tuple(
            file
            for file, (_, needs) in self._kept.items()
            if any(needs.concerned(path, self._host) for path in changed)
        )
        for file in concerned:
            del self._kept[file]
        return concerned
