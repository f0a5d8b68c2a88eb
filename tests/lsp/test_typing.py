"""What a keystroke in a large program costs beside the program's own lines: counted in what is done again, not in seconds."""

from __future__ import annotations

import sys
from collections.abc import Hashable, Iterator
from types import FrameType
from typing import Any

import pytest

from deburr.analysis import Analysis
from deburr.finding import Finding
from deburr.lsp.report import _Report
from deburr.ruleset import RuleSet
from deburr.steps import let_go
from deburr.symbols import Mention, Sort, Symbol, index
from deburr.symbols.index import at, first_symbols, led_to, locals_of, mentions_of
from deburr_grammar.chunk import Branch, Chunk
from deburr_grammar.dialects import by_name
from deburr_grammar.document import Document, Piece
from deburr_grammar.outline import Before, Outliner
from deburr_grammar.text import Edit, Pos
from support.inside import Inside
from support.large import large

URI = "file:///a.ngc"
FAULTY = 300
PUSHES: dict[str, Any] = {}


def typed(inside: Inside, line: int, text: str) -> None:
    place = {"line": line, "character": 0}
    change = {"range": {"start": place, "end": place}, "text": text}
    inside.notify("textDocument/didChange", {"textDocument": {"uri": URI, "version": 2}, "contentChanges": [change]})


def last(inside: Inside) -> list[Any]:
    found: list[Any] = [each for each in inside.said if each.get("method") == "textDocument/publishDiagnostics"]
    said: list[Any] = found[-1]["params"]["diagnostics"]
    return said


@pytest.mark.parametrize(("text", "lines", "most"), [(" ", 0, 2), ("\n", 1, FAULTY - 200 + 2)])
def test_what_still_stands_where_it_stood_is_not_written_once_more(
    text: str, lines: int, most: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    written: list[Finding] = []
    plain = _Report.text

    def text_of(report: _Report, finding: Finding) -> str:
        written.append(finding)
        return plain(report, finding)

    monkeypatch.setattr(_Report, "text", text_of)
    with Inside(PUSHES) as inside:
        inside.open(URI, "G21 G90\n" + "G1 X1 (a (b)\n" * FAULTY + "M2\n", "rs274")
        inside.settle()
        before = [each["range"]["start"]["line"] for each in last(inside)]
        written.clear()
        typed(inside, 201, text)
        assert len(written) <= most
        expected = [line + (lines if line >= 201 else 0) for line in before]
        assert [each["range"]["start"]["line"] for each in last(inside)] == expected


def test_only_the_names_of_the_part_that_was_edited_are_looked_up_again() -> None:
    document, asked = Document.parse(large("rs274", 400), by_name("rs274")), list[Symbol]()

    def where(symbol: Symbol) -> str | None:
        asked.append(symbol)
        return symbol.name if symbol.name == "part7" else None

    assert led_to(document, "k", where, Sort.SUB) == {"part7"}
    assert len(asked) >= 400
    asked.clear()
    assert led_to(document, "k", where, Sort.SUB) == {"part7"}
    assert not asked
    middle = document.line_count // 2
    edited = document.edit(Edit(Pos(middle, 0), Pos(middle, 0), "(x)"))
    assert led_to(edited, "k", where, Sort.SUB) == {"part7"}
    assert 0 < len(asked) <= edited.piece(middle).lines


def test_a_local_name_is_looked_for_only_where_its_region_is(monkeypatch: pytest.MonkeyPatch) -> None:
    text = large("rs274", 400)
    document, parsed = Document.parse(text, by_name("rs274")), list[int]()
    plain = index._Index._mentions

    def mentions(own: index._Index, piece: Piece) -> Iterator[tuple[int, Mention]]:
        parsed.append(piece.chunk.eols)
        return plain(own, piece)

    monkeypatch.setattr(index._Index, "_mentions", mentions)
    head = text.split("\n").index("o<part200> sub")
    name = at(document, head + 1, 3)
    assert name is not None
    found = mentions_of(document, name.mention.symbol, name.region)
    assert [each.line for each in found] == [head + 1, head + 2, head + 3]
    assert 1 <= len(parsed) <= 2


def test_local_names_of_no_region_are_told_without_a_walk_through_the_program(monkeypatch: pytest.MonkeyPatch) -> None:
    """A program without subprograms is all in no region: what its parts name is summed up the tree, and an edit sums up one way anew."""
    document = Document.parse("#2 = 1\nG0 X#2\n" * 50_000, by_name("rs274"))
    name = at(document, 0, 1)
    assert name is not None and name.region is None
    assert locals_of(document, None) == {name.mention.symbol: 2}
    asked, plain = list[Hashable](), Outliner.key

    def key(own: Outliner, node: Branch | Chunk, before: Before) -> Hashable:
        asked.append(node)
        return plain(own, node, before)

    monkeypatch.setattr(Outliner, "key", key)
    edited = document.edit(Edit(Pos(40_000, 0), Pos(40_000, 0), "#3 = 2\n"))
    asked.clear()
    assert {each.name: several for each, several in locals_of(edited, None).items()} == {"2": 2, "3": 1}
    assert len(asked) < sum(1 for _ in document.pieces())


@pytest.fixture
def read(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """How many lines were read for their names, a stretch at a time."""
    found, plain = list[int](), index._Index._mentions

    def mentions(own: index._Index, piece: Piece) -> Iterator[tuple[int, Mention]]:
        found.append(piece.chunk.eols)
        return plain(own, piece)

    monkeypatch.setattr(index._Index, "_mentions", mentions)
    return found


def asked(inside: Inside, method: str, line: int, col: int) -> Any:
    place = {"line": line, "character": col}
    return inside.request(f"textDocument/{method}", {"textDocument": {"uri": URI}, "position": place})


def library(parts: int = 400) -> list[str]:
    """Subprograms that set a shared name as well, and a program that calls them and has names of its own."""
    subs = [
        f"o<part{part}> sub\n#<depth> = 5\n#1 = #<depth>\n#<_shared> = {part}\nG0 X#1 Z#<_shared>\no<part{part}> endsub"
        for part in range(parts)
    ]
    return "\n".join([*subs, "#<own> = 1", "G0 X#<own>", "o<part7> call", "M2", ""]).split("\n")


def test_before_a_program_has_been_read_a_question_reads_little_of_it(read: list[int]) -> None:
    lines = library(1_500)
    head = lines.index("o<part200> sub")
    with Inside(PUSHES) as inside:
        inside.open(URI, "\n".join(lines), "rs274")
        local = asked(inside, "hover", head + 2, 6)["contents"]["value"]
        assert "value here: **5** (line" in local and f"read in line {head + 3}" in local
        shared = asked(inside, "hover", head + 3, 4)["contents"]["value"]
        assert "is known when the program has been read" in shared
        offered = {each["label"] for each in asked(inside, "completion", head + 2, 6)["items"]}
        assert "#<depth>" in offered and "#<own>" not in offered
        asked(inside, "completion", len(lines) - 4, 5)
        assert 0 < sum(read) <= 4 * max(read) < len(lines) / 2


def test_when_a_program_has_been_read_no_question_reads_more_than_was_edited(read: list[int]) -> None:
    lines = library()
    own = lines.index("G0 X#<own>")
    with Inside(PUSHES) as inside:
        inside.open(URI, "\n".join(lines), "rs274")
        inside.settle()
        assert sum(read) == len(lines) - 1
        read.clear()
        for line, col in ((2, 6), (3, 4), (own, 7)):
            for method in ("hover", "completion", "definition"):
                asked(inside, method, line, col)
        assert read == []
        said = asked(inside, "hover", 3, 4)["contents"]["value"]
        assert "set in line 4, line 10, line 16 and over 1" in said or "set in line 4, line 10, line 16 and " in said
        names = {each["label"] for each in asked(inside, "completion", own, 7)["items"]}
        assert {"#<own>", "#<_shared>"} <= names and "#<depth>" not in names
        typed(inside, own, " ")
        asked(inside, "completion", own, 8)
        assert len(read) == 1


def test_of_many_names_those_are_looked_for_that_begin_as_is_written(monkeypatch: pytest.MonkeyPatch) -> None:
    text = "".join(
        f"o<{sort}_{part}> sub\nG0 X1 (a comment)\no<{sort}_{part}> endsub\n" for sort in "abc" for part in range(300)
    )
    document, looked = Document.parse(text, by_name("rs274"), 500), list[int]()
    first = [each.name for each in first_symbols(document, Sort.SUB, "o<b_29", 250)]
    assert first == ["b_29", *(f"b_29{digit}" for digit in range(10))]
    plain = index._Index._spelled

    def spelled(own: index._Index, piece: Piece, *more: Any) -> Any:
        looked.append(piece.line)
        return plain(own, piece, *more)

    monkeypatch.setattr(index._Index, "_spelled", spelled)
    assert [each.name for each in first_symbols(document, Sort.SUB, "c_111", 250)] == ["c_111"]
    assert 0 < len(looked) <= 8 < len(list(document.chunks())) / 8


class _Thing:
    alive = 0

    def __init__(self, held: object) -> None:
        self.held = held
        _Thing.alive += 1

    def __del__(self) -> None:
        _Thing.alive -= 1


def test_what_is_known_is_let_go_in_steps_and_what_others_have_stays() -> None:
    shared = _Thing([_Thing(None)])
    found: list[Any] = [{at: [_Thing((at,))] for at in range(5_000)}, shared]
    steps = let_go(found)
    before, most = _Thing.alive, 0
    for _ in steps:
        most, before = max(most, before - _Thing.alive), _Thing.alive
    assert 0 < most <= 256
    assert _Thing.alive == 2
    assert isinstance(shared.held, list)


@pytest.mark.parametrize("dialect", ["rs274", "cgt"])
def test_rules_on_the_whole_program_do_as_much_more_as_it_is_longer(dialect: str) -> None:
    few, many = (work(dialect, parts) for parts in (100, 400))
    assert many <= 6 * few


def work(dialect: str, parts: int) -> int:
    """How many functions a check calls."""
    count = 0

    def called(frame: FrameType, event: str, argument: object) -> None:
        nonlocal count
        count += event == "call"

    ruleset = RuleSet(by_name(dialect))
    Analysis(Document.parse(large(dialect, 2), by_name(dialect)), ruleset, "a").findings()
    analysis = Analysis(Document.parse(large(dialect, parts), by_name(dialect)), ruleset, "a")
    sys.setprofile(called)
    try:
        analysis.findings()
    finally:
        sys.setprofile(None)
    return count
