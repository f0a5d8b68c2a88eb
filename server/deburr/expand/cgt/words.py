"""The words of a template while it runs: values, formats, tables, and what of them was output last (spec/cgt.md §4, §5.1, §5.2). Prints no line."""

from __future__ import annotations

from typing import TYPE_CHECKING

from deburr.expand.cgt.figures import Format, format_of
from deburr.expand.numbers import written
from deburr.templates.symbols import is_free, rows_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from deburr.templates.items import Row
    from deburr.templates.symbols import Word
    from deburr.templates.template import Template

LONGEST = 254
"""Characters that a text word holds (spec/cgt.md §8)."""
DEFAULTS = {"F_Decimal": "D4.4", "F_Integer": "T6.0", "F_BlockNumber": "T5.0", "F_Offset": "T2.0"}
"""The formats of a control without a machine file (spec/cgt.md §5.1)."""
_CLASSES = {"decimal": "F_Decimal", "integer": "F_Integer", "block": "F_BlockNumber", "offset": "F_Offset"}
_FIXED = {"ON": 1.0, "OFF": 0.0}


class Cell:
    """One word. Its value is None while nothing has set it; ``text`` is what it prints, None while that is to be made."""

    __slots__ = ("group", "is_text", "last", "name", "own", "section", "settable", "text", "type", "value")

    def __init__(self, word: Word, value: float | str | None, section: str, free_word: bool) -> None:
        self.name = word.name
        self.type = word.type
        self.is_text = word.is_text
        self.settable = word.settable
        self.value = value
        self.text: str | None = None
        self.last: str | None = None
        """The text that was output last; None: it counts as changed."""
        self.own: Format | None = None
        """The format of a `#FMT` on the word itself."""
        self.group = "" if free_word else _CLASSES.get(word.type, "")
        """The class whose format it has; none for texts, tables, and words that print as many digits as they have."""
        self.section = section
        """The section that computes it, or nothing."""

    def set(self, value: float | str) -> None:
        """Give it a value; a number in a text word is its text."""
        if value != self.value:
            self.value = value if isinstance(value, str) or not self.is_text else written(value)
            self.text = None


class Words:
    """All words of a run by name, each made when it is first asked for."""

    def __init__(self, template: Template) -> None:
        self._template = template
        self._symbols = template.symbols
        self._cells: dict[str, Cell] = {}
        self._computed = {each.name for each in template.declarations if each.command.startswith("CALC")}
        said = {**DEFAULTS, **template.machine.formats}
        self.formats = {name: made for name in DEFAULTS if (made := format_of(said[name]) or format_of(DEFAULTS[name]))}
        self.block_step = template.machine.block_step
        self._tables: dict[str, Sequence[str] | None] = {}

    def __getitem__(self, name: str) -> Cell:
        cell = self._cells.get(name)
        return cell if cell is not None else self._made(name)

    def find(self, said: str) -> Cell | None:
        """The word that `#said` means; None if it means none."""
        word = self._symbols.find(said)
        return self[word.name] if word is not None else None

    def _made(self, name: str) -> Cell:
        word = self._symbols.find(name)
        assert word is not None
        mine, free_word = name in self._symbols.declared, is_free(name)
        value: float | str | None = _FIXED.get(name)
        if mine or free_word:
            value = "" if word.is_text else 0.0
        elif word.type == "block":
            value = float(self._template.machine.block_start)
        section = f"${name}" if name in self._computed else ""
        cell = self._cells[name] = Cell(word, value, section, free_word)
        return cell

    def rows(self, name: str) -> Sequence[str] | None:
        """The rows of a table: those of the section of that name, else of the machine file; None if there is no such table."""
        if name not in self._tables:
            section = self._template.by_name.get(name)
            mine = [_right_of_comma(row) for row in section.rows] if section is not None and section.is_table else None
            self._tables[name] = mine if mine is not None else self._template.machine.tables.get(name)
        return self._tables[name]

    def codes(self, cell: Cell) -> Sequence[str] | None:
        """The rows that a table word prints: a system word has some of its own."""
        rows = self.rows(cell.name)
        return rows if rows is not None else rows_of(cell.name) or None

    def printed(self, cell: Cell) -> Format | None:
        """The format of a number word; None: as many digits as it has."""
        return cell.own or self.formats.get(cell.group)

    def give(self, target: Cell | str, form: Format | None) -> Format | None:
        """Set the format of a word or a class (None: take a word's away); gives the one that it had."""
        if isinstance(target, Cell):
            before, target.own, target.text = target.own, form, None
            return before
        before = self.formats[target]
        if form is not None:
            self.formats[target] = form
        for cell in self._cells.values():
            if cell.group == target and cell.own is None:
                cell.text = None
        return before


def _right_of_comma(row: Row) -> str:
    comma = next(part for part in row.node.children if part.kind == "ROW_COMMA")
    return row.text[comma.end : row.node.end]
