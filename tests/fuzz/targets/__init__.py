"""What is fuzzed: a module each, with `run`, which fails on bytes that deburr cannot deal with, and `seeds`, bytes to begin with."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from importlib import import_module
from pkgutil import iter_modules
from typing import NamedTuple


class Target(NamedTuple):
    """A target by its name."""

    name: str
    run: Callable[[bytes], None]
    seeds: Callable[[], Iterator[bytes]]


def names() -> list[str]:
    """The names of all targets."""
    return sorted(module.name for module in iter_modules(__path__))


def target(name: str) -> Target:
    """A target, loaded; one that is none of ours by the name of its module."""
    module = import_module(name if "." in name else f"{__name__}.{name}")
    return Target(name, module.run, module.seeds)
