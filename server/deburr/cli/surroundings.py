"""What lies in a folder: programs by language, files whose language nothing tells, and files that settings may name. Writes nothing."""

import os
from collections import Counter
from fnmatch import fnmatch
from itertools import islice
from typing import NamedTuple

from deburr import paths
from deburr.cli.files import targets
from deburr.cli.opening import Opener, Opening
from deburr.configfile import Configs
from deburr_grammar.dialects import NAMES, by_name

MOST = 5_000
"""Programs that are looked at; the languages of an archive show long before."""
_DEEP = 3
"""Folders below each other in which the files of settings are looked for."""


class Surroundings(NamedTuple):
    """What lies in a folder.

    ``languages``: how many programs each has. ``shown``: of an ending that many languages share, how many programs are in
    which. ``silent``: how many files of it tell nothing. ``beside``: by dialect and setting, what it may name.
    """

    languages: Counter[str]
    shown: dict[str, Counter[str]]
    silent: Counter[str]
    beside: dict[tuple[str, str], list[str]]


def surroundings(folder: str) -> Surroundings:
    """Look through a folder, as a check would."""
    configs = Configs()
    opener = Opener(configs, None)
    languages, silent = Counter[str](), Counter[str]()
    shown: dict[str, Counter[str]] = {}
    for target in islice(targets([folder], configs), MOST):
        opening, ending = opener.opened(target), paths.extension(target.file)
        if isinstance(opening, Opening):
            languages[opening.dialect.name] += 1
            if ending not in opening.dialect.extensions:
                shown.setdefault(ending, Counter())[opening.dialect.name] += 1
        elif not opening.failure:
            silent[ending] += 1
    return Surroundings(languages, shown, silent, _beside(folder, languages))


def _beside(folder: str, languages: Counter[str]) -> dict[tuple[str, str], list[str]]:
    wanted = [(name, setting) for name in NAMES if name in languages for setting in by_name(name).settings]
    found: dict[tuple[str, str], list[str]] = {}
    for path in _names(folder) if wanted else ():
        last = path[path.rstrip("/").rfind("/") + 1 :].lower()
        for dialect, setting in wanted:
            if any(fnmatch(last, pattern) and last.endswith("/") == pattern.endswith("/") for pattern in setting.found):
                found.setdefault((dialect, setting.name), []).append(path.rstrip("/"))
    return found


def _names(folder: str) -> list[str]:
    """The files and folders below a folder, seen from it; folders with a slash behind."""
    found: list[str] = []
    top = paths.absolute(folder)
    for place, folders, files in os.walk(top):
        folders[:] = sorted(name for name in folders if not name.startswith(".") and name != "node_modules")
        inside = place.replace(os.sep, "/").removeprefix(top).strip("/")
        head = f"{inside}/" if inside else ""
        found += [f"{head}{name}/" for name in folders]
        found += [f"{head}{name}" for name in sorted(files)]
        if inside.count("/") + bool(inside) >= _DEEP:
            folders.clear()
    return found
