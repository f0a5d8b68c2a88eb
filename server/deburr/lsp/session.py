"""The programs of a session: those that are open as the client's edits leave them, all others as they are on disk. Checks nothing."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from deburr.detect import detect
from deburr.host import Host, NoFiles
from deburr.ide.view import View
from deburr.lsp.convert import Units, file_to_uri, uri_to_file
from deburr.lsp.files import Files, Stamp, programs_in
from deburr.lsp.settings import Settings, paths_to
from deburr_grammar.dialects import NAMES, by_name
from deburr_grammar.document import Document

if TYPE_CHECKING:
    from deburr.lsp.client import Client
    from deburr_grammar.dialect import Dialect
    from deburr_grammar.text import Edit

_NEARBY = 500
"""So many files of a workspace are looked through for uses of a name."""
_KEPT = 256
_FEW = 1_000
"""So many lines may be read when a question is asked about them."""


@dataclass(eq=False)
class Open:
    """A text that is open in the editor. ``view`` is None while nobody knows its language; its text is kept all the same."""

    uri: str
    file: str
    language: str
    version: int
    document: Document
    view: View | None = None
    reason: str = ""
    """Why it is taken for a program of its language, or for none."""

    def lines(self, line: int) -> str:
        """A line's text; "" for one that is not there."""
        return self.document.line(line) if 0 <= line < self.document.line_count else ""


class Session:
    """All that a server knows of its client's programs."""

    def __init__(self, client: Client, complain: Callable[[str], None]) -> None:
        self.client = client
        self.units = Units(client.encoding)
        self.folders: list[str] = [uri_to_file(uri) for uri in client.folders]
        self.settings = Settings(complain)
        self.settings.lay_over(client.options, self.folders)
        self.open: dict[str, Open] = {}
        self.open_files: dict[str, Open] = {}
        self.files = Files(self._buffer, lambda: self.open_files)
        self._views: dict[tuple[str, str], tuple[Stamp | None, View]] = {}

    def opened(self, uri: str, language: str, version: int, text: str) -> Open:
        """A text was opened."""
        file = uri_to_file(uri)
        program = Open(uri, file, language, version, Document.parse(text, by_name(NAMES[0])))
        self.open[uri] = self.open_files[file] = program
        self.settle(program, text)
        return program

    def edited(self, program: Open, version: int, edits: Iterable[Edit]) -> None:
        """A text was edited."""
        document = program.document
        for edit in edits:
            document = document.edit(edit)
        program.version = version
        self.take(program, document)

    def take(self, program: Open, document: Document) -> None:
        """Give an open text its next version."""
        program.document = document
        if program.view is not None:
            old = program.view
            read = old.is_read and document.line_count - old.document.line_count <= _FEW
            program.view = View(old.file, document, old.ruleset, old.host, self, read)

    def closed(self, program: Open) -> None:
        """A text was closed: what is on disk counts again."""
        self.open.pop(program.uri, None)
        if self.open_files.get(program.file) is program:
            del self.open_files[program.file]

    def settle(self, program: Open, text: str | None = None) -> bool:
        """Find out the language and configuration of a text; whether anything is different now."""
        text = program.document.text if text is None else text
        answer = detect(
            program.file if paths_to(program.file) else "", text, self.settings.hints(program.file, program.language)
        )
        program.reason = answer.reason
        if answer.dialect is None:
            changed, program.view = program.view is not None, None
            return changed
        dialect = by_name(answer.dialect)
        ruleset, host = self.settings.ruleset(dialect, program.file), self._host(program.file)
        given = dialect.given(ruleset.settings, host.read)
        document = program.document.under(given)
        if document.dialect is not dialect:
            document = Document.parse(text, dialect, given=given)
        old = program.view
        if old is not None and old.ruleset is ruleset and old.document is document:
            return False
        read = document.line_count <= _FEW
        program.document, program.view = document, View(program.file, document, ruleset, host, self, read)
        return True

    def view(self, file: str, like: View | None = None) -> View | None:
        """A file as a program: of its own language, or of that of another one."""
        program = self.open_files.get(file)
        if program is not None and program.view is not None and (like is None or program.view.dialect is like.dialect):
            return program.view
        text = self.files.read(file) if paths_to(file) else None
        if text is None:
            return None
        if like is not None:
            return self._kept_view(file, like.dialect, text)
        answer = detect(file, text, self.settings.hints(file, None))
        return None if answer.dialect is None else self._kept_view(file, by_name(answer.dialect), text)

    def given(self, view: View, values: Iterable[tuple[str, Any]]) -> View | None:
        """A program under some settings that are laid over the configuration; None if its language has no such settings."""
        ruleset = self.settings.given(view.dialect, view.file, dict(values))
        if ruleset is None:
            return None
        document = view.document.under(view.dialect.given(ruleset.settings, view.host.read))
        return View(view.file, document, ruleset, view.host, self)

    def views(self, like: View) -> Iterator[View]:
        """The programs of one's language: itself, those that are open, and those in the folders."""
        yield like
        seen = {like.file}
        for program in list(self.open.values()):
            if program.view is not None and program.view.dialect is like.dialect and program.file not in seen:
                seen.add(program.file)
                yield program.view
        for number, file in enumerate(self.programs()):
            if number >= _NEARBY:
                return
            found = self.view(file) if file not in seen else None
            if found is not None and found.dialect is like.dialect:
                yield found

    def programs(self) -> Iterator[str]:
        """The files in the folders that may be programs."""
        seen: set[str] = set()
        for folder in self.folders:
            for file in programs_in(folder, self.settings.configs):
                if file not in seen:
                    seen.add(file)
                    yield file

    def uri(self, file: str) -> str:
        """The URI of a file as the client writes it."""
        program = self.open_files.get(file)
        return file_to_uri(file) if program is None else program.uri

    def lines(self, file: str) -> Callable[[int], str]:
        """The lines of any file, as far as there are such."""
        program = self.open_files.get(file)
        if program is not None:
            return program.lines
        found = self.view(file)
        lines: Sequence[str] = () if found is not None else _split(self.files.read(file) if paths_to(file) else None)
        document = None if found is None else found.document
        if document is not None:
            return lambda line: document.line(line) if 0 <= line < document.line_count else ""
        return lambda line: lines[line] if 0 <= line < len(lines) else ""

    def state(self, file: str) -> object:
        """What a file is now: equal as long as neither its text nor its URI is another."""
        program = self.open_files.get(file)
        return (program.uri, program.document) if program is not None else self.files.stamp(file)

    def reload(self) -> None:
        """Settings or files of configuration have changed."""
        self.settings.reload()
        self._views.clear()

    def _kept_view(self, file: str, dialect: Dialect, text: str) -> View:
        """A program that is not open as it is here; kept until it changes."""
        stamp = None if file in self.open_files else self.files.stamp(file)
        ruleset = self.settings.ruleset(dialect, file)
        kept = self._views.get((file, dialect.name))
        if kept is not None and stamp is not None and kept[0] == stamp and kept[1].ruleset is ruleset:
            return kept[1]
        host = self._host(file)
        document = Document.parse(text, dialect, given=dialect.given(ruleset.settings, host.read))
        if len(self._views) >= _KEPT:
            self._views.clear()
        found = View(file, document, ruleset, host, self)
        self._views[file, dialect.name] = stamp, found
        return found

    def _host(self, file: str) -> Host:
        return self.files if paths_to(file) else NoFiles()

    def _buffer(self, file: str) -> str | None:
        program = self.open_files.get(file)
        return None if program is None else program.document.text


def _split(text: str | None) -> Sequence[str]:
    from deburr_grammar.text import split_lines

    return () if text is None else split_lines(text)
