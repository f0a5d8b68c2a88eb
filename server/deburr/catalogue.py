"""All rules of a dialect, known without being loaded: `_index.py` beside them says what a rule set asks of each. Never runs a rule.

`python -m deburr.dev.generate` writes the indexes, a test proves them fresh. A program holds what
concerns some of the rules; the files of all others are never read.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import cache, cached_property
from importlib import import_module
from pkgutil import iter_modules
from typing import Any, NamedTuple, get_args

from deburr.finding import Severity
from deburr.rule import Modal, Nodes, Report, Rule, Structure, Trigger, Whole
from deburr_grammar.dialects import NAMES
from deburr_grammar.structure import Fault

COMMON = "deburr.rules.common"
_BY_NAME: dict[str, Any] = {each.__name__: each for each in get_args(Trigger)}


class Row(NamedTuple):
    """A rule in an index: all that decides whether it is asked, in plain values. ``met``, and ``where`` or ``ready``: whether it has them."""

    file: str
    severity: int
    default: bool
    input: bool
    met: bool
    trigger: str
    said: dict[str, Any]
    where: bool


def rules_of(dialect: str) -> tuple[Rule, ...]:
    """All rules of a dialect, by name: those of its folder, and the common ones under the dialect's name where it has none of that name."""
    common = [replace(rule, name=f"{dialect}.{rule.short}") for rule in _found(COMMON)]
    rules = {rule.name: rule for rule in (*common, *_found(f"deburr.rules.{dialect}"))}
    return tuple(rules[name] for name in sorted(rules))


def rule_names(dialect: str) -> tuple[str, ...]:
    """The names of all rules of a dialect in order, read off the files."""
    files = {*_files(COMMON), *_files(f"deburr.rules.{dialect}")}
    return tuple(sorted(f"{dialect}.{file.replace('_', '-')}" for file in files))


@cache
def known_rules(dialect: str) -> frozenset[str]:
    """The same to ask about many of them; none of what is no dialect."""
    return frozenset(rule_names(dialect) if dialect in NAMES else ())


def loaded(package: str) -> Iterator[Rule]:
    """The rules of a folder, each from its file."""
    return (_rule_in(f"{package}.{file}") for file in _files(package))


def row(rule: Rule) -> Row:
    """A rule as its index has it."""
    said = rule.trigger._asdict()
    where = any(said.pop(each, None) is not None for each in ("where", "ready"))
    if isinstance(rule.trigger, Structure):
        said["faults"] = tuple(fault.name for fault in rule.trigger.faults)
    file, met = rule.module.rpartition(".")[2], rule.met is not None
    return Row(file, int(rule.severity), rule.default, rule.input, met, type(rule.trigger).__name__, said, where)


class _Later:
    """A rule that is loaded when it is first asked."""

    def __init__(self, module: str) -> None:
        self._module = module

    @cached_property
    def _rule(self) -> Rule:
        return _rule_in(self._module)

    @cached_property
    def _ready(self) -> Callable[..., Iterator[None]]:
        trigger = self._rule.trigger
        assert isinstance(trigger, Whole) and trigger.ready is not None
        return trigger.ready

    @cached_property
    def _where(self) -> Callable[..., bool]:
        trigger = self._rule.trigger
        assert isinstance(trigger, Nodes | Modal) and trigger.where is not None
        return trigger.where

    def check(self, *asked: Any) -> Iterator[Report]:
        """What it says."""
        return self._rule.check(*asked)

    def met(self, *asked: Any) -> Iterator[Report]:
        """What it says of what a run met."""
        assert self._rule.met is not None
        return self._rule.met(*asked)

    def ready(self, *asked: Any) -> Iterator[None]:
        """Derives what it stands on."""
        return self._ready(*asked)

    def where(self, *asked: Any) -> bool:
        """Whether it may say something."""
        return self._where(*asked)


def _found(package: str) -> Iterator[Rule]:
    files = tuple(_files(package))
    rows = [Row(*each) for each in import_module(f"{package}._index").ROWS] if _has_index(package) else []
    if tuple(each.file for each in rows) == files:
        return (_known(package, each) for each in rows)
    # A rule is there of which the index does not know: slower, never wrong.
    return loaded(package)


def _known(package: str, row: Row) -> Rule:
    module = f"{package}.{row.file}"
    later = _Later(module)
    said = dict(row.said)
    if "faults" in said:
        said["faults"] = tuple(Fault[name] for name in said["faults"])
    if row.where:
        said |= {"ready": later.ready} if row.trigger == Whole.__name__ else {"where": later.where}
    name = f"{package.rpartition('.')[2]}.{row.file.replace('_', '-')}"
    trigger, met = _BY_NAME[row.trigger](**said), later.met if row.met else None
    return Rule(name, Severity(row.severity), trigger, later.check, module, row.default, met, row.input)


def _rule_in(module: str) -> Rule:
    values = vars(import_module(module)).values()
    return next(value for value in values if isinstance(value, Rule) and value.module == module)


def _files(package: str) -> Iterator[str]:
    return (name for name in _names(package) if not name.startswith("_"))


def _has_index(package: str) -> bool:
    return "_index" in _names(package)


def _names(package: str) -> list[str]:
    try:
        folder = import_module(package)
    except ModuleNotFoundError:
        return []
    return [module.name for module in iter_modules(folder.__path__)]
