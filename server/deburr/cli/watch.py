"""`deburr check --watch`: the same check again whenever a file changes."""

import argparse
import sys
from collections.abc import Callable, Iterator

from deburr import paths
from deburr.cli.cache import FOLDER
from deburr.cli.common import complain, unable
from deburr.cli.streams import gone
from deburr.config import ConfigError

_PAUSE = 200
"""Milliseconds for which the watcher sleeps at most."""


def watched(arguments: argparse.Namespace, check: Callable[[argparse.Namespace], int]) -> int:
    """Check now and after each change, until the user interrupts. A configuration that cannot be used is said and waited for."""
    try:
        from watchfiles import DefaultFilter, watch
    except ImportError:
        return unable(["--watch needs the library watchfiles: pip install 'watchfiles>=1.0'"])
    own = tuple(_own(arguments))

    class Programs(DefaultFilter):
        """All files but those that a check writes itself."""

        ignore_dirs = (*DefaultFilter.ignore_dirs, FOLDER)

        def __call__(self, change: object, path: str) -> bool:
            return paths.absolute(path) not in own and super().__call__(change, path)  # type: ignore[arg-type]

    folders = sorted({*map(_folder, arguments.paths or ["."])})
    changes = watch(*folders, watch_filter=Programs(), raise_interrupt=True, yield_on_timeout=True, rust_timeout=_PAUSE)
    # It watches from here on, so that nothing that changes during the first check is missed.
    next(changes)
    _once(arguments, check)
    complain(f"watching {', '.join(folders)}; Ctrl-C ends", "")
    for changed in changes:
        if gone(sys.stdout):
            break
        if changed:
            _once(arguments, check)
            complain("watching again", "")
    return 0


def _once(arguments: argparse.Namespace, check: Callable[[argparse.Namespace], int]) -> None:
    try:
        check(arguments)
    except ConfigError as error:
        unable(error.messages)
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
