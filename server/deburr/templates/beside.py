"""The files that a template is configured with: its toolpath and its machine file, each read once for each text. Never opens a file itself."""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING, Any, NamedTuple

from deburr.host import NoFiles

if TYPE_CHECKING:
    from collections.abc import Mapping

    from deburr.formats import Fault
    from deburr.formats.events import Events
    from deburr.formats.machine import Machine
    from deburr.host import Host


class Beside(NamedTuple):
    """A configured file: its path, "" if none is configured, and its text, None if it cannot be read."""

    path: str
    text: str | None


def beside(settings: Mapping[str, Any], host: Host, key: str) -> Beside:
    """The file that a setting names. Text that stands for itself has no files around it."""
    path = settings.get(key) or ""
    if not path or isinstance(host, NoFiles):
        return Beside("", None)
    return Beside(path, host.read(path))


def toolpath_faults(file: Beside) -> tuple[Fault, ...]:
    """What is wrong with a toolpath, whatever the template is."""
    if file.text is None:
        return ()
    return events_in(file).faults if is_events(file) else _toolpath_faults(file.text)


def is_events(file: Beside) -> bool:
    """Whether a toolpath is a list of events; any other file is CL text."""
    return file.path.lower().endswith(".jsonl")


def events_in(file: Beside) -> Events:
    """The events of a toolpath."""
    return _events(file.text or "")


def machine_in(file: Beside) -> Machine:
    """What a machine file says; nothing where there is none."""
    return _machine(file.text or "")


@lru_cache(maxsize=4)
def _toolpath_faults(text: str) -> tuple[Fault, ...]:
    from deburr.formats.cl import read

    return read(text).faults


@lru_cache(maxsize=4)
def _events(text: str) -> Events:
    from deburr.formats.events import read

    return read(text)


@lru_cache(maxsize=4)
def _machine(text: str) -> Machine:
    from deburr.formats.machine import read

    return read(text)
