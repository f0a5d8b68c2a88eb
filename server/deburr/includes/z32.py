"""Where called programs lie: the memory of the control, which here is a folder, and the files of L254 (spec/z32.md §6.4). Runs nothing."""

import re
from collections.abc import Mapping, Sequence
from collections.abc import Set as AbstractSet
from posixpath import basename, dirname, join, normpath
from typing import Any

from deburr.host import Host
from deburr_grammar.dialects.z32.forms import parts, sections_in

_NUMBERED = re.compile(r"0*([0-9]+)(?:\.[^.]*)?")


def beside(file: str, path: str) -> str:
    """A configured path as the host knows it: relative ones start at the program's folder."""
    return normpath(join(dirname(file), path.replace("\\", "/")))


def temporary(folder: str) -> str:
    """The folder of the temporary programs, which GOS calls, beside that of GOP."""
    return f"{normpath(folder)}-temp"


def is_stored(file: str, settings: Mapping[str, Any]) -> bool:
    """Whether a program lies in a folder of those that others call."""
    home = basename(dirname(file))
    cmos, root = (normpath(str(settings[name])) for name in ("cmos-dir", "file-root"))
    return bool(home) and home in {basename(each) for each in (cmos, temporary(cmos), root)}


def own_files(host: Host, folder: str, number: int) -> Sequence[str]:
    """The files in a folder that are named after a program's number."""
    names = ((name, _NUMBERED.fullmatch(name)) for name in host.names(folder))
    return [f"{folder}/{name}" for name, match in names if match and match[1] == str(number)]


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
