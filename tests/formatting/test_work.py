"""What laying out costs: a plan for each shape, and of a long program only the lines that are asked for."""

from typing import Any
from unittest import mock

import pytest

import deburr.formatting.plan
import deburr.formatting.program
from deburr.formatting.line import written
from deburr.ide.formatting import typed
from deburr.ide.view import View
from deburr.ruleset import RuleSet
from deburr_grammar.chunk import Chunk
from deburr_grammar.dialects import by_name
from deburr_grammar.document import Document
from deburr_grammar.text import Edit, Pos
from support.formatting import PLAIN, laid_out
from support.views import Files

DIALECT = by_name("rs274")


def test_a_shape_is_planned_once() -> None:
    lines = "".join(f"g7x{number}y2.{number} z[#{number}+1] q17\n" for number in range(500))
    with mock.patch.object(deburr.formatting.plan, "_made", wraps=deburr.formatting.plan._made) as made:
        assert laid_out(lines, "rs274").startswith("g7 x0 y2.0 z[#0+1] q17\n")
    # The lines have one shape; the other is that of the empty one at the end.
    assert made.call_count <= 2


def view_of(text: str) -> View:
    files = Files("rs274", {})
    return View("/job/a.ngc", Document.parse(text, DIALECT), RuleSet(DIALECT), files, files)


def looked_at(lines: int) -> tuple[list[Edit], int, int]:
    """What typing a line end in the middle of a block of so many lines gives; the lines written, the texts of chunks taken apart."""
    body = "G0 X1\n" * lines
    view = view_of(f"o1 if [1]\n{body}G0 X2\n\n{body}o1 endif\n")
    assert not view.document.faults
    taken = []
    lines_of = Chunk.lines.fget
    assert lines_of is not None

    def counted(chunk: Chunk) -> Any:
        taken.append(chunk)
        return lines_of(chunk)

    with (
        mock.patch.object(Chunk, "lines", property(counted)),
        mock.patch("deburr.ide.formatting.written", wraps=written) as wrote,
    ):
        found = typed(view, PLAIN, Pos(lines + 2, 0), "\n")
    return found, wrote.call_count, len(taken)


@pytest.mark.parametrize("lines", [10, 20_000])
def test_typing_looks_at_the_lines_around(lines: int) -> None:
    found, wrote, taken = looked_at(lines)
    above, here = Pos(lines + 1, 0), Pos(lines + 2, 0)
    assert found == [Edit(above, above, "  "), Edit(here, here, "  ")]
    assert wrote == 1
    assert taken <= 2
