"""Programs in the memory of the control, which here is a folder or the sections of a file, and the files of L254 (spec/z32.md §6.4)."""

import re
from collections.abc import Sequence
from collections.abc import Set as AbstractSet

from deburr.host import Host

_SECTION = re.compile(r"(?m)^[ \t]*/?[ \t]*:[ \t]*([0-9]+)(?![0-9]|[.,][0-9])")
_NUMBERED = re.compile(r"([0-9]+)(?:\.[^.]*)?")


def sections_in(text: str) -> AbstractSet[int]:
    """The numbers of the sections of a file."""
    return {int(number) for number in _SECTION.findall(text.replace("\r", "\n")) if len(number) <= 9}


def section_number(line: str) -> int | None:
    """The number of the section that a line starts; None if it starts none."""
    match = _SECTION.match(line)
    return int(match[1]) if match and len(match[1]) <= 9 else None


def programs(host: Host, folder: str) -> AbstractSet[int]:
    """The numbers of the programs in a folder: files named so, and sections of the files there."""
    found: set[int] = set()
    for name in host.names(folder):
        if match := _NUMBERED.fullmatch(name):
            found.add(int(match[1]))
        found |= sections_in(host.read(f"{folder}/{name}") or "")
    return found


def found_files(host: Host, folder: str, said: str) -> Sequence[str]:
    """The files that a path below a folder may mean, with any extension; the control does not tell upper from lower case."""
    *inner, last = parts(said) or [""]
    inside = (f"{each}/{name}" for each in _folders(host, folder, inner) for name in host.names(each))
    wanted = last.upper()
    return [path for path in inside if (name := path.rpartition("/")[2].upper()) == wanted or name.startswith(wanted + ".")]  # fmt: skip


def parts(said: str) -> list[str]:
    """The parts of a path; `\\` and `/` are the same."""
    return [part for part in said.replace("\\", "/").split("/") if part not in ("", ".")]


def nearest_file(host: Host, folder: str, said: str) -> str:
    """A file that may have been meant, as it would be written behind L254; empty if there is none alike."""
    from difflib import get_close_matches

    *inner, last = parts(said) or [""]
    known: dict[str, str] = {}
    for each in (*_folders(host, folder, inner), *_subfolders(host, folder), folder):
        for name in host.names(each):
            known.setdefault(name.rpartition(".")[0].upper() or name.upper(), f"{each}/{name}")
    found = get_close_matches(last.upper(), known, 1)
    path = known[found[0]][len(folder) + 1 :] if found else ""
    folders, _, name = path.rpartition("/")
    stem = name.rpartition(".")[0] or name
    return f"{folders}/{stem}".lstrip("/").replace("/", "\\")


def _folders(host: Host, folder: str, inner: Sequence[str]) -> list[str]:
    """The folders that the inner parts of a path may mean."""
    folders = [folder]
    for part in inner:
        folders = [f"{each}/{name}" for each in folders for name in host.names(each) if name.upper() == part.upper()]
    return folders


def _subfolders(host: Host, folder: str) -> list[str]:
    return [f"{folder}/{name}" for name in host.names(folder) if host.names(f"{folder}/{name}")]
