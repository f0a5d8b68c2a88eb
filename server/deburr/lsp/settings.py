"""What is configured for files: `deburr.toml` as the nearest one says, the editor's settings laid over it. Knows no protocol."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from deburr import paths
from deburr.config import Config, ConfigError, RuleSets, from_command_line, made
from deburr.configfile import FILE, PROJECT, Configs, given
from deburr.detect import Answer, Hints
from deburr.selection import Selection

if TYPE_CHECKING:
    from deburr.ruleset import RuleSet
    from deburr_grammar.dialect import Dialect

SAID_BY = "the editor's settings"
HINTS = "inlay-hints"
LENSES = "code-lens"
_STEPS = 1_024
"""Steps of shapes under modal state that are kept with a rule set: someone who types comes with a new one at every key, and few are met again."""


class Settings:
    """The configuration of a session. ``complain`` is told what cannot be used; what cannot be used counts as not said."""

    def __init__(self, complain: Callable[[str], None]) -> None:
        self._complain = complain
        self._said: set[str] = set()
        self._top = Config()
        self.reload()

    def reload(self) -> None:
        """Read the configuration files anew."""
        self.configs = Configs(self._top)
        self._rulesets = RuleSets(_STEPS)
        self._bad: dict[str, Config] = {}
        self._given: dict[object, RuleSet] = {}
        self._said.clear()

    def lay_over(self, said: Any, folders: Sequence[str]) -> None:
        """Take an editor's settings; paths in them are seen from its first folder."""
        if isinstance(said, Mapping) and isinstance(said.get("deburr"), Mapping):
            said = said["deburr"]
        tables = {key: value for key, value in said.items() if value is not None} if isinstance(said, Mapping) else {}
        try:
            self._top = given(tables, folders[0] if folders else paths.working_folder(), SAID_BY)
        except ConfigError as error:
            self._top = Config()
            self.reload()
            self._once(error)
            return
        self.reload()

    def of(self, file: str) -> Config:
        """The configuration of a file; of one that has no path, that of the working folder."""
        folder = paths.parent(file) if paths_to(file) else paths.working_folder()
        if folder in self._bad:
            return self._bad[folder]
        try:
            return self.configs.in_folder(folder)
        except ConfigError as error:
            self._bad[folder] = self._top
            self._once(error)
            return self._top

    def hints(self, file: str, language: str | None) -> Hints:
        """What the editor and the configuration say of a file's dialect."""
        found = self.of(file).dialect_of(file) if paths_to(file) else None
        configured = (
            None if found is None else Answer(found[0], f"`{found[1].pattern}` in [files] of {found[1].origin}")
        )
        return Hints(None, language, configured)

    def ruleset(self, dialect: Dialect, file: str) -> RuleSet:
        """The rule set for a file."""
        config = self.of(file)
        try:
            self.configs.require(config, dialect)
        except ConfigError as error:
            self._once(error)
        return self._rulesets.of(dialect, config, file)

    def given(self, dialect: Dialect, file: str, values: Mapping[str, Any]) -> RuleSet | None:
        """The rule set for a file with some of the dialect's settings laid over the configuration; None if it has no such settings."""
        if not values.keys() <= {setting.name for setting in dialect.settings}:
            return None
        top = from_command_line({f"{dialect.name}.{name}": value for name, value in values.items()}, Selection())
        key = (dialect.name, file, tuple(values.items()))
        if key not in self._given:
            self._given[key] = made(dialect, top.over(self.of(file)), steps=_STEPS)
        return self._given[key]

    def _once(self, error: ConfigError) -> None:
        for message in error.messages:
            if message not in self._said:
                self._said.add(message)
                self._complain(message)


def paths_to(file: str) -> bool:
    """Whether a name is that of a file and not the URI of something else."""
    return paths.absolute(file) == file


def is_configuration(file: str) -> bool:
    """Whether a file configures others; any may, because one can extend another."""
    return file.rpartition("/")[2] in (FILE, PROJECT) or file.endswith(".toml")
