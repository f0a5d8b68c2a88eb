"""Which files are meant: those that are named, and in folders those of known extensions that `.gitignore` leaves."""

import os
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from deburr.configfile import Configs
from deburr.detect import extension, known_extensions

STDIN = "-"
_NEVER = frozenset((".git", ".hg", ".svn", ".jj", ".venv", "venv", "node_modules", "__pycache__"))


class Target(NamedTuple):
    """A file to check: its absolute path or `-`, whether it was named itself, and why it cannot be read, if it cannot."""

    file: str
    named: bool
    failure: str = ""


def targets(paths: Sequence[str], configs: Configs) -> list[Target]:
    """The files that paths mean, each once, in order of their names."""
    found: dict[str, Target] = {}
    for path in paths:
        for target in _of(path, configs):
            if target.named or target.file not in found:
                found[target.file] = target
    return [found[file] for file in sorted(found)]


def absolute(path: str) -> str:
    """A path as files are written everywhere: absolute, with `/` between parts."""
    return Path(os.path.abspath(path)).as_posix()  # noqa: PTH100  `Path.resolve` would follow links.


def _of(path: str, configs: Configs) -> Iterator[Target]:
    if path == STDIN:
        yield Target(STDIN, True)
    elif Path(path).is_dir():
        yield from _Walk(configs).folder(Path(absolute(path)), ())
    elif Path(path).exists():
        yield Target(absolute(path), True)
    else:
        yield Target(absolute(path), True, "no such file or folder")


class _Ignoring(NamedTuple):
    """The patterns of one folder's `.gitignore`."""

    folder: Path
    spec: Any


class _Walk:
    def __init__(self, configs: Configs) -> None:
        self._configs = configs
        self._extensions = known_extensions()

    def folder(self, folder: Path, above: tuple[_Ignoring, ...]) -> Iterator[Target]:
        """The files in a folder and below it."""
        ignoring = (*(above or _repository(folder)), *_ignoring(folder))
        try:
            entries = sorted(os.scandir(folder), key=lambda entry: entry.name)
        except OSError as error:
            yield Target(folder.as_posix(), True, error.strerror or "cannot be read")
            return
        for entry in entries:
            path = folder / entry.name
            if entry.is_dir(follow_symlinks=False):
                if entry.name not in _NEVER and not _ignored(path, True, ignoring):
                    yield from self.folder(path, ignoring)
            elif entry.is_file() and self._known(path) and not _ignored(path, False, ignoring):
                yield Target(path.as_posix(), False)

    def _known(self, path: Path) -> bool:
        file = path.as_posix()
        if extension(file) in self._extensions:
            return True
        return self._configs.in_folder(path.parent).dialect_of(file) is not None


def _repository(folder: Path) -> tuple[_Ignoring, ...]:
    """The patterns from the top of the repository down to above a folder; none outside of one."""
    above = [folder, *folder.parents]
    top = next((number for number, each in enumerate(above) if (each / ".git").exists()), 0)
    return tuple(ignoring for each in reversed(above[1 : top + 1]) for ignoring in _ignoring(each))


def _ignoring(folder: Path) -> tuple[_Ignoring, ...]:
    path = folder / ".gitignore"
    if not path.is_file():
        return ()
    from pathspec import GitIgnoreSpec

    try:
        lines = path.read_text(encoding="utf-8", errors="replace").splitlines()
        return (_Ignoring(folder, GitIgnoreSpec.from_lines(lines)),)
    except (OSError, ValueError):
        return ()


def _ignored(path: Path, is_folder: bool, ignoring: tuple[_Ignoring, ...]) -> bool:
    """Whether the nearest `.gitignore` that speaks of a path excludes it."""
    for each in reversed(ignoring):
        said = path.relative_to(each.folder).as_posix() + ("/" if is_folder else "")
        verdict = each.spec.check_file(said).include
        if verdict is not None:
            return bool(verdict)
    return False
