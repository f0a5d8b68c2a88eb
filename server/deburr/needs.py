"""What a check of a program asked of other files, and whether a change can concern it. Never opens a file itself."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from deburr.host import Host


@dataclass
class Needs:
    """A host that remembers what was asked of it: the hash of each file's text (None: there was none) and the names in each folder."""

    host: Host
    texts: dict[str, int | None] = field(default_factory=dict)
    folders: dict[str, tuple[str, ...]] = field(default_factory=dict)

    def read(self, path: str) -> str | None:
        """The text of a file."""
        text = self.host.read(path)
        self.texts[path] = None if text is None else hash(text)
        return text

    def names(self, folder: str) -> Sequence[str]:
        """The names in a folder."""
        names = self.host.names(folder)
        self.folders[folder] = tuple(names)
        return names

    def stale(self) -> bool:
        """Whether anything that was asked for is another now."""
        paths = [*self.texts, *(f"{folder.rstrip('/')}/" for folder in self.folders)]
        return any(self.concerned(path, self.host) for path in paths)

    def concerned(self, path: str, host: Host) -> bool:
        """Whether a file that was written, made or taken away can make any difference."""
        if path in self.texts:
            text = host.read(path)
            if self.texts[path] != (None if text is None else hash(text)):
                return True
        folder = path.rpartition("/")[0]
        return any(
            tuple(host.names(each)) != names for each, names in self.folders.items() if each.rstrip("/") == folder
        )
