"""A window of VS Code that tests use one after the other: opening one costs more than all that most of them do in it."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from pathlib import Path

from playwright.sync_api import Browser

from support.vscode import Workbench, kept, new_page


class Room:
    """One window, with a folder in it for the files of each test. A window in which a test has failed is not used again."""

    def __init__(self, window: Browser, address: str, folder: Path) -> None:
        self._window = window
        self._address = address
        self._folder = folder
        self._opened: Workbench | None = None

    @contextlib.contextmanager
    def used(self, name: str) -> Iterator[Workbench]:
        """The window, with nothing open in it; how it looked at the end is kept under that name."""
        opened = self._opened or Workbench(new_page(self._window), self._address, self._folder)
        self._opened = None
        opened.files = self._folder / name
        opened.files.mkdir()
        try:
            yield opened
            assert opened.outside == []
        except BaseException:
            kept(opened.page, name)
            opened.page.close()
            raise
        kept(opened.page, name)
        opened.close_all()
        self._opened = opened

    def close(self) -> None:
        """End the window, if there is one."""
        if self._opened:
            self._opened.page.close()
