"""One JSON object a line, each a finding as in the JSON list; of a part of a check the last says which one."""

from collections.abc import Iterable
from json import dumps
from typing import TextIO

from deburr.cli.reporters.json import as_object, part_as_object, row_as_object
from deburr.cli.result import Result, Row
from deburr.cli.style import Style

TEXT = False
KEYED = True


def report(result: Result, out: TextIO, style: Style) -> None:
    """Write the findings."""
    out.writelines(f"{_line(as_object(each))}\n" for each in result.found)
    if (part := part_as_object(result)) is not None:
        out.write(f"{_line(part)}\n")


def statistics(rows: Iterable[Row], out: TextIO, style: Style) -> None:
    """Write how often each rule spoke."""
    out.writelines(f"{_line(row_as_object(row))}\n" for row in rows)


def _line(found: object) -> str:
    return dumps(found, ensure_ascii=False, separators=(",", ":"))
