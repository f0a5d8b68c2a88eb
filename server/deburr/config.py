"""What is configured for a file, in layers: files that extend each other, and the command line on top. Never reads a file."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, NamedTuple

from deburr.finding import Severity
from deburr.machine import MACHINE
from deburr.rule import Rule
from deburr.ruleset import RuleSet
from deburr.schema import CHECK, HINTS, LENSES
from deburr.selection import Selection, selected
from deburr.stateful import STEPS
from deburr_grammar.dialect import Dialect, Setting


class ConfigError(Exception):
    """A configuration that cannot be used; each message begins with its place."""

    def __init__(self, *messages: str) -> None:
        super().__init__(*messages)
        self.messages = messages

    def __str__(self) -> str:
        return "\n".join(self.messages)


class Value(NamedTuple):
    """A value and the file that it comes from."""

    value: Any
    origin: str


class Graded(NamedTuple):
    """A rule's severity, None to switch it off, and the file that says so."""

    severity: Severity | None
    origin: str


@dataclass(frozen=True)
class Glob:
    """A pattern of paths as in `.gitignore`, relative to a folder. A leading `!` means all files but those."""

    folder: str
    pattern: str
    origin: str

    def matches(self, file: str) -> bool:
        """Whether a file, given by its absolute path, is meant."""
        inside = file.startswith(self.folder.rstrip("/") + "/")
        found = inside and self._spec.match_file(file[len(self.folder.rstrip("/")) + 1 :])
        return bool(found) is not self.pattern.startswith("!")

    @cached_property
    def _spec(self) -> Any:
        from deburr.patterns import spec

        return spec([self.pattern.removeprefix("!")])


@dataclass(frozen=True, eq=False)
class Config:
    """All that is configured. Keys of ``values`` are like `check.fail-on`; what is not there has its default.

    ``layers`` are the selections of the files, lowest first, ``top`` that of the command line;
    ``origin`` is the file, "" if there is none.
    """

    values: Mapping[str, Value] = field(default_factory=dict)
    layers: tuple[Selection, ...] = ()
    top: tuple[Selection, ...] = ()
    files: tuple[tuple[Glob, str], ...] = ()
    ignores: tuple[tuple[Glob, tuple[str, ...]], ...] = ()
    severities: Mapping[str, Graded] = field(default_factory=dict)
    origin: str = ""

    def get(self, table: str, setting: Setting) -> Value:
        """A setting's value; its origin is "" for the default."""
        return self.values.get(f"{table}.{setting.name}", Value(setting.default, ""))

    @property
    def fail_on(self) -> Severity:
        """The least severity that counts as a failure."""
        setting = next(each for each in CHECK if each.name == "fail-on")
        return Severity[self.get("check", setting).value.upper()]

    @property
    def runs(self) -> bool:
        """Whether what a bounded run meets is reported, too."""
        setting = next(each for each in CHECK if each.name == "run")
        return bool(self.get("check", setting).value)

    def shows(self, table: str, kind: str) -> bool:
        """Whether an editor is to show hints or lenses of a kind."""
        setting = next(each for each in (*HINTS, *LENSES) if each.name == kind)
        return bool(self.get(f"editor.{table}", setting).value)

    def dialect_of(self, file: str) -> tuple[str, Glob] | None:
        """What `[files]` says of a file, with the pattern that says it: the first that matches."""
        return next(((name, glob) for glob, name in self.files if glob.matches(file)), None)

    def ignored(self, file: str) -> tuple[str, ...]:
        """What is off for a file whatever is selected."""
        return tuple(name for glob, names in self.ignores if glob.matches(file) for name in names)

    def over(self, below: "Config") -> "Config":
        """This configuration laid over another."""
        return Config(
            {**below.values, **self.values},
            (*below.layers, *self.layers),
            (*below.top, *self.top),
            (*self.files, *below.files),
            (*below.ignores, *self.ignores),
            {**below.severities, **self.severities},
            self.origin or below.origin,
        )


class RuleSets:
    """The rule sets that were made: one for all files of a dialect that are configured alike. ``steps``: as of `RuleSet`."""

    def __init__(self, steps: int = STEPS) -> None:
        self._steps = steps
        self._made: dict[tuple[str, int, tuple[str, ...]], tuple[Config, RuleSet]] = {}

    def of(self, dialect: Dialect, config: Config, file: str) -> RuleSet:
        """The rule set for a file."""
        ignored = config.ignored(file)
        key = (dialect.name, id(config), ignored)
        if key not in self._made:
            self._made[key] = (config, made(dialect, config, ignored, self._steps))
        return self._made[key][1]


def made(dialect: Dialect, config: Config, ignored: Sequence[str] = (), steps: int = STEPS) -> RuleSet:
    """The rule set that a configuration means."""
    graded = {name: severity for name, (severity, _) in config.severities.items()}
    off = Selection(ignore=tuple(name for name, severity in graded.items() if severity is None))
    layers = (*config.layers, off, *config.top)

    def on(rule: Rule) -> bool:
        return selected(rule, layers, ignored)

    severities = {name: severity for name, severity in graded.items() if severity is not None}
    return RuleSet(dialect, settings_of(dialect, config), on, severities, machine_of(config), steps)


def settings_of(dialect: Dialect, config: Config) -> dict[str, Any]:
    """The dialect's own settings."""
    return {setting.name: config.get(dialect.name, setting).value for setting in dialect.settings}


def machine_of(config: Config) -> dict[str, Any]:
    """What is said of the machine; empty: nothing is."""
    return {each.name: value.value for each in MACHINE if (value := config.values.get(f"machine.{each.name}"))}


def from_command_line(values: Mapping[str, Any], selection: Selection) -> Config:
    """A configuration as the command line gives it; keys are like `check.fail-on`."""
    return Config({key: Value(value, "the command line") for key, value in values.items()}, top=(selection,))
