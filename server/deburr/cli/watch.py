"""`deburr check --watch`: the same check again whenever a file changes that it hangs on."""

import argparse
import os
import re
import sys
from collections.abc import Callable, Iterator, Sequence

from deburr import paths
from deburr.cli.cache import FOLDER
from deburr.cli.checkoptions import top
from deburr.cli.common import complain, unable
from deburr.cli.files import Target, meant
from deburr.cli.inputs import named_files
from deburr.cli.opening import Opener, Unopened
from deburr.cli.run import Outcome
from deburr.cli.streams import gone
from deburr.config import ConfigError
from deburr.configfile import Configs

_PAUSE = 200
"""Milliseconds for which the watcher sleeps at most."""

Check = Callable[[Callable[[Sequence[Outcome]], None]], int]
"""A check that tells of its outcomes."""


def watched(arguments: argparse.Namespace, check: Check) -> int:
    """Check now and after each change, until the user interrupts. A configuration that cannot be used is said and waited for."""
    try:
        from watchfiles import Change, DefaultFilter, watch
    except ImportError:
        return unable(["--watch needs the library watchfiles: pip install 'watchfiles>=1.0'"])
    concern = Concern(arguments)

    class Programs(DefaultFilter):
        """All files that a check hangs on, but those that it writes itself."""

        ignore_dirs = (*DefaultFilter.ignore_dirs, FOLDER)

        def __call__(self, change: Change, path: str) -> bool:
            return super().__call__(change, path) and concern.has(paths.absolute(path), change is Change.modified)

    folders = sorted({*map(_folder, arguments.paths or ["."])})
    changes = watch(*folders, watch_filter=Programs(), raise_interrupt=True, yield_on_timeout=True, rust_timeout=_PAUSE)
    # It watches from here on, so that nothing that changes during the first check is missed.
    next(changes)
    _once(check, concern)
    complain(f"watching {', '.join(folders)}; Ctrl-C ends", "")
    for changed in changes:
        if gone(sys.stdout):
            break
        if changed:
            _once(check, concern)
            complain("watching again", "")
    return 0


class Concern:
    """Which files a check hangs on, as the last one has told. Until one has told anything, all of them but its own."""

    def __init__(self, arguments: argparse.Namespace) -> None:
        self._arguments = arguments
        self._own = frozenset(_own(arguments))
        self._inputs = frozenset(map(_key, filter(None, (*named_files(arguments), arguments.config))))
        self._known: frozenset[str] | None = None
        self._extensions: frozenset[str] = frozenset()
        self._messages = ""
        self._faults: frozenset[str] = frozenset()
        self._last: frozenset[str] = frozenset()

    def forget(self) -> None:
        """A check begins: what it hangs on is not known before it has come through."""
        self._known = None
        self._faults = frozenset()

    def fail(self, faults: Sequence[str]) -> None:
        """A check could not come through: what the one before it hung on may come back, and what is said to be at fault may be mended."""
        self._known = self._last
        self._faults = frozenset(map(str.casefold, faults))

    def hear(self, outcomes: Sequence[Outcome]) -> None:
        """What a check hangs on: its programs and all that they asked for. A file that is no program is none of it."""
        programs = (outcome.file for outcome in outcomes if outcome.dialect is not None or outcome.failure)
        self._messages = "\n".join(finding.message for each in outcomes for finding in each.findings).casefold()
        self._known = frozenset(map(_key, (*programs, *(path for each in outcomes for path in each.asked))))
        self._last = self._known
        self._extensions = frozenset(paths.extension(each) for each in self._known if not each.endswith("/"))

    def has(self, path: str, modified: bool) -> bool:
        """Whether a change of a file or folder can make any difference. ``modified``: it was there and still is."""
        if path in self._own or path.endswith(paths.PART) or _is_written(path):
            return False
        key, name = _key(path), path.rpartition("/")[2]
        if self._known is None or key in self._known or key in self._inputs:
            return True
        if name == ".gitignore" or name.endswith(".toml") or self._is_at_fault(key):
            return True
        if paths.is_folder(path):
            return not modified
        return not modified and self._is_listed(key) or self._is_program(path)

    def _is_listed(self, key: str) -> bool:
        """Whether it can be missed where names were asked for, or was a folder with something in it that was asked for.

        The folder of a program is mostly listed, and anything may be put there: what counts is called like what was
        read, or is what a finding says is missing.
        """
        known, (folder, _, name) = self._known or (), key.rpartition("/")
        if f"{folder}/" in known and (paths.extension(key) in self._extensions or name in self._messages):
            return True
        return any(each.startswith(f"{key}/") for each in known)

    def _is_at_fault(self, key: str) -> bool:
        named = re.compile(rf"{re.escape(key)}(?![\w.-])")
        return any(map(named.search, self._faults))

    def _is_program(self, path: str) -> bool:
        arguments = self._arguments
        try:
            configs = Configs(top(arguments), arguments.config)
            if not meant(path, configs):
                return False
            found = Opener(configs, arguments.dialect).opened(Target(path, False))
        except ConfigError as error:
            # As long as the same is wrong with its configuration, no program can make any difference but one that has gone.
            return not paths.exists(path) or not self._faults.issuperset(map(str.casefold, error.messages))
        return not isinstance(found, Unopened) or bool(found.failure)


def _once(check: Check, concern: Concern) -> None:
    concern.forget()
    try:
        check(concern.hear)
    except ConfigError as error:
        unable(error.messages)
        concern.fail(error.messages)
    sys.stdout.flush()


def _folder(path: str) -> str:
    """The folder to watch for a path; ConfigError if there is none."""
    folder = path if paths.is_folder(path) else paths.parent(paths.absolute(path))
    if not paths.is_folder(folder):
        raise ConfigError(f"{path}: no such file or folder")
    return paths.absolute(folder)


def _own(arguments: argparse.Namespace) -> Iterator[str]:
    """The files that a check writes."""
    said = [arguments.output_file, arguments.baseline, *(each.file for each in arguments.output_format or ())]
    return (paths.absolute(each) for each in said if each)


def _is_written(path: str) -> bool:
    """Whether standard output or standard error goes into a file."""
    for stream in (sys.stdout, sys.stderr):
        try:
            if os.path.samestat(os.stat(path), os.fstat(stream.fileno())):  # noqa: PTH116  # pathlib knows no open stream
                return True
        except (OSError, ValueError):
            continue
    return False


def _key(path: str) -> str:
    """A path as it is compared: some disks do not tell large letters from small ones. A folder keeps the `/` at its end."""
    return paths.absolute(path).casefold() + ("/" if path.endswith("/") else "")
