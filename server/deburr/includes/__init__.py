"""How a program's words become files: a folder of files that are put in by name, and paths beside a program. Knows no language, opens no file."""

import posixpath
import re
from collections.abc import Sequence
from typing import NamedTuple

from deburr.host import Host, NoFiles

_DRIVE = re.compile(r"[A-Za-z]:")


class Found(NamedTuple):
    """The file of a name. ``exact``: it is spelled like that in its folder."""

    path: str
    text: str
    exact: bool

    def larger(self, size: int) -> bool:
        """Whether the file has more bytes than that."""
        return len(self.text) > size // 4 and len(self.text.encode("utf-8", "surrogatepass")) > size


def leaves(name: str) -> bool:
    """Whether a name points out of its folder: `..`, an absolute path, a drive letter."""
    return is_absolute(name.replace("\\", "/")) or ".." in map(str.strip, _split(name))


def is_absolute(path: str) -> bool:
    """Whether a path with `/` between its parts starts at a root or a drive."""
    return path[:1] == "/" or _DRIVE.match(path) is not None


def beside(file: str, said: str) -> str:
    """The path that a setting names, seen from the folder of a program; an absolute one is left as it is."""
    said = said.replace("\\", "/")
    return said if is_absolute(said) else posixpath.normpath(posixpath.join(posixpath.dirname(file), said))


class Folder:
    """The folder around which a program and the files that it names lie. Each file is asked for once."""

    def __init__(self, host: Host, file: str, setting: str) -> None:
        self._host = host
        self._file = file
        self._found: dict[tuple[str, ...], Found | None] = {}
        self._listed: dict[str, Sequence[str]] = {}
        self.silent = isinstance(host, NoFiles)
        """Whether nothing is known of any file, so that nothing can be missed."""
        self.inside = False
        """Whether the program itself lies in the folder."""
        self.root = self._find_root(setting.replace("\\", "/"))

    def find(self, name: str) -> Found | None:
        """The file of a name that does not leave the folder; None if there is none, or several that differ from it in case only."""
        key = tuple(part for part in _split(name) if part not in ("", "."))
        if key not in self._found:
            self._found[key] = self._look_up(key)
        return self._found[key]

    def near(self, name: str) -> Sequence[str]:
        """The names where a name is looked for."""
        *folders, _ = _split(name)
        return self._names(_joined(self.root, *folders))

    def _look_up(self, parts: tuple[str, ...]) -> Found | None:
        path, exact = self.root, True
        if self.silent or not parts or "\0" in "".join(parts):
            return None
        for part in parts:
            spelled = _spelled(part, self._names(path))
            if spelled is None:
                return None
            path, exact = _joined(path, spelled), exact and spelled == part
        text = self._host.read(path)
        return None if text is None else Found(path, text.removeprefix("\ufeff"), exact)

    def _names(self, folder: str) -> Sequence[str]:
        if folder not in self._listed:
            self._listed[folder] = self._host.names(folder)
        return self._listed[folder]

    def _find_root(self, setting: str) -> str:
        """The folder: that in which the program lies, if it is called so, or one beside the program."""
        if is_absolute(setting):
            root = setting.rstrip("/")
            self.inside = self._file.startswith(f"{root}/")
            return root
        folder = posixpath.dirname(self._file)
        wanted = _joined(folder, setting)
        parts, tail = folder.split("/"), [part for part in setting.split("/") if part not in ("", ".", "..")]
        for stop in range(len(parts), len(tail) - 1, -1) if tail else ():
            if parts[stop - len(tail) : stop] == tail and not self._names(wanted):
                self.inside = True
                return "/".join(parts[:stop])
        return wanted


def _split(name: str) -> list[str]:
    return name.replace("\\", "/").split("/")


def _joined(folder: str, *more: str) -> str:
    """A path below a folder, without `.`, and without `..` where it can be undone; the folder is left as it is written."""
    parts = [] if folder in ("", ".") else folder.rstrip("/").split("/")
    for part in "/".join(more).split("/"):
        if part == ".." and parts and parts[-1] not in ("", ".."):
            parts.pop()
        elif part not in ("", "."):
            parts.append(part)
    return "/".join(parts) or "."


def _spelled(name: str, present: Sequence[str]) -> str | None:
    """A name as it is spelled in a folder, its case disregarded only if that leaves no choice."""
    if name in present:
        return name
    alike = [each for each in present if each.casefold() == name.casefold()]
    return alike[0] if len(alike) == 1 else None
