"""Which files are meant: those that are named, and in folders those of known extensions that `.gitignore` leaves."""

import os
from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

from deburr import paths
from deburr.configfile import Configs
from deburr.detect import known_extensions

STDIN = "-"
_NEVER = frozenset((".git", ".hg", ".svn", ".jj", ".venv", "venv", "node_modules", "__pycache__", ".deburr_cache"))


class Target(NamedTuple):
    """A file to check: its absolute path or `-`, whether it was named itself, and why it cannot be read, if it cannot."""

    file: str
    named: bool
    failure: str = ""


def targets(given: Sequence[str], configs: Configs) -> list[Target]:
    """The files that paths mean, each once, in order of their names."""
    found: dict[str, Target] = {}
    for path in given:
        for target in _of(path, configs):
            if target.named or target.file not in found:
                found[target.file] = target
    return [found[file] for file in sorted(found)]


def _of(path: str, configs: Configs) -> Iterator[Target]:
    if path == STDIN:
        yield Target(STDIN, True)
    elif paths.is_folder(path):
        yield from _Walk(configs).folder(paths.absolute(path), ())
    elif paths.exists(path):
        yield Target(paths.absolute(path), True)
    else:
        yield Target(paths.absolute(path), True, "no such file or folder")


class _Ignoring(NamedTuple):
    """The patterns of one folder's `.gitignore`."""

    folder: str
    spec: Any


class _Walk:
    def __init__(self, configs: Configs) -> None:
        self._configs = configs

    def folder(self, folder: str, above: tuple[_Ignoring, ...]) -> Iterator[Target]:
        """The files in a folder and below it."""
        ignoring = (*(above or _repository(folder)), *_ignoring(folder))
        try:
            entries = sorted(os.scandir(folder), key=lambda entry: entry.name)
        except OSError as error:
            yield Target(folder, True, error.strerror or "cannot be read")
            return
        for entry in entries:
            path = paths.join(folder, entry.name)
            if entry.is_dir(follow_symlinks=False):
                if entry.name not in _NEVER and not _ignored(path, True, ignoring):
                    yield from self.folder(path, ignoring)
            elif entry.is_file() and meant(path, self._configs) and not _ignored(path, False, ignoring):
                yield Target(path, False)


def meant(path: str, configs: Configs) -> bool:
    """Whether a file that is found in a folder may be a program: by its extension, or by what is configured."""
    if path.endswith(paths.PART):
        return False
    return paths.extension(path) in known_extensions() or configs.of(path).dialect_of(path) is not None


def _repository(folder: str) -> tuple[_Ignoring, ...]:
    """The patterns from the top of the repository down to above a folder; none outside of one."""
    above = paths.above(folder)
    top = next((number for number, each in enumerate(above) if paths.exists(paths.join(each, ".git"))), 0)
    return tuple(ignoring for each in reversed(above[1 : top + 1]) for ignoring in _ignoring(each))


def _ignoring(folder: str) -> tuple[_Ignoring, ...]:
    path = paths.join(folder, ".gitignore")
    if not paths.is_file(path):
        return ()
    from deburr.patterns import spec

    try:
        lines = paths.data(path).decode("utf-8", "replace").splitlines()
        return (_Ignoring(folder, spec(lines)),)
    except (OSError, ValueError):
        return ()


def _ignored(path: str, is_folder: bool, ignoring: tuple[_Ignoring, ...]) -> bool:
    """Whether the nearest `.gitignore` that speaks of a path excludes it."""
    for each in reversed(ignoring):
        said = path[len(paths.join(each.folder, "")) :] + ("/" if is_folder else "")
        verdict = each.spec.check_file(said).include
        if verdict is not None:
            return bool(verdict)
    return False
