"""Which deburr this is: another answer for every change of its code. Never imports what it looks at."""

import os
import sys
from collections.abc import Iterator
from importlib.util import find_spec

import deburr
from deburr import paths
from deburr.cli.fingerprint import digest

_MADE_OF = (".py", ".tables", ".toml", ".lark")


def build() -> str:
    """32 hexadecimal digits: of what the installer recorded of each file, or else of each file's size and time."""
    home = paths.parent(paths.parent(paths.absolute(deburr.__file__)))
    record = paths.join(home, f"deburr-{deburr.__version__}.dist-info/RECORD")
    python = f"{sys.version_info[0]}.{sys.version_info[1]}"
    if paths.is_file(record):
        return digest(python, paths.data(record).decode("utf-8", "replace"))
    return digest(python, *_files(home))


def _files(home: str) -> Iterator[str]:
    grammar = find_spec("deburr_grammar")
    folders = [paths.join(home, "deburr"), *(grammar.submodule_search_locations or () if grammar else ())]
    for top in folders:
        for folder, _, names in sorted(os.walk(top)):
            for name in sorted(names):
                if name.endswith(_MADE_OF):
                    found = os.stat(os.path.join(folder, name))  # noqa: PTH116, PTH118
                    yield f"{folder}/{name} {found.st_size} {found.st_mtime_ns}"
