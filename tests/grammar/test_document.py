"""The document's public face by hand-worked values: positions, seams, growth and shrinking of the tree, partners far apart."""

from __future__ import annotations

import pytest

from deburr_grammar import Document, Edit, Pos
from deburr_grammar.chunk import FANOUT, Branch, Chunk, chunk_at, grown
from deburr_grammar.dialect import Bracket, Role
from deburr_grammar.dialects import by_name
from deburr_grammar.document import Piece
from deburr_grammar.outline import _step
from support import naive
from support.equality import TALLY, answers

DIALECT = by_name("rs274")


def parsed(text: str, size: int = 3) -> Document:
    return Document.parse(text, DIALECT, size)


def check_edit(text: str, edit: Edit, wanted: str, size: int = 3) -> Document:
    """The edit gives the wanted text, asked before or not, and all answers are those of a fresh document."""
    for asked in (False, True):
        document = parsed(text, size)
        if asked:
            answers(document)
        changed = document.edit(edit)
        assert changed.text == wanted
        assert answers(changed) == answers(parsed(wanted, size))
        assert document.text == text
    return changed


def test_an_empty_document_has_one_empty_line() -> None:
    document = parsed("")
    assert (document.text, document.line_count, document.line(0)) == ("", 1, "")
    assert document.node(0).problems == ()
    assert (list(document.problems()), list(document.brackets()), document.faults) == ([], [], ())
    assert document.balance == (0, 0, False)
    assert document.state(TALLY, 0) == 0
    assert check_edit("", Edit(Pos(0, 0), Pos(0, 0), "G0 X1\n"), "G0 X1\n").line_count == 2
    assert check_edit("G0 X1\n", Edit(Pos(0, 0), Pos(9, 9), ""), "").line_count == 1


def test_the_last_line_is_there_even_if_empty() -> None:
    document = parsed("G0\nX1\r\n")
    assert document.line_count == 3
    assert [document.line(number) for number in range(3)] == ["G0", "X1", ""]
    assert document.node(2).text == ""
    assert [node.text for node in document.nodes()] == ["G0", "X1", ""]


@pytest.mark.parametrize(
    ("start", "end", "wanted"),
    [
        (Pos(0, 99), Pos(0, 99), "ab-\ncd"),
        (Pos(1, 99), Pos(1, 99), "ab\ncd-"),
        (Pos(99, 0), Pos(99, 5), "ab\ncd-"),
        (Pos(0, 1), Pos(99, 0), "a-"),
        (Pos(1, 1), Pos(0, 1), "a-d"),
        (Pos(0, 2), Pos(1, 0), "ab-cd"),
    ],
)
def test_positions_past_an_end_mean_the_end(start: Pos, end: Pos, wanted: str) -> None:
    for size in (1, 3, 300):
        check_edit("ab\ncd", Edit(start, end, "-"), wanted, size)


def test_positions_that_exist() -> None:
    document = parsed("ab\r\nc")
    assert document.offset(Pos(0, 9)) == Pos(0, 2)
    assert document.offset(Pos(1, 1)) == Pos(1, 1)
    assert document.offset(Pos(5, 0)) == Pos(1, 1)


@pytest.mark.parametrize(
    ("text", "edit", "wanted", "lines"),
    [
        ("aaa\rb\n", Edit(Pos(1, 0), Pos(1, 1), ""), "aaa\r\n", 2),
        ("aaa\r\nb", Edit(Pos(0, 3), Pos(0, 3), "\r"), "aaa\r\r\nb", 3),
        ("aaa\r\nb", Edit(Pos(0, 3), Pos(1, 0), ""), "aaab", 1),
        ("aaa\nb", Edit(Pos(0, 3), Pos(0, 3), "\r"), "aaa\r\nb", 2),
        ("aaa\rb", Edit(Pos(1, 0), Pos(1, 0), "\n"), "aaa\r\nb", 2),
        ("aaa\r\rb", Edit(Pos(1, 0), Pos(1, 0), "\n"), "aaa\r\n\rb", 3),
        ("aaa\r", Edit(Pos(1, 0), Pos(1, 0), "\n"), "aaa\r\n", 2),
        ("aaa\rbbb\n\n", Edit(Pos(1, 0), Pos(2, 0), ""), "aaa\r\n", 2),
    ],
)
def test_carriage_return_and_newline_meet_and_part(text: str, edit: Edit, wanted: str, lines: int) -> None:
    for size in (1, 3, 4, 300):
        assert check_edit(text, edit, wanted, size).line_count == lines


def test_chunks_split_when_they_grow_and_join_when_they_shrink() -> None:
    document = parsed("G1 X1\n", 20)
    answers(document)
    document = document.edit(Edit(Pos(1, 0), Pos(1, 0), "G1 X1\n" * 50))
    sizes = [len(chunk.text) for chunk in document.chunks()]
    assert sum(sizes) == 51 * 6
    assert all(20 <= size <= 2 * 20 for size in sizes[:-1])
    answers(document)
    document = document.edit(Edit(Pos(0, 0), Pos(50, 0), ""))
    assert document.text == "G1 X1\n"
    assert len(list(document.chunks())) <= 2


def test_what_an_edit_does_not_touch_is_shared() -> None:
    document = parsed("G1 X1\n" * 1000, 60)
    before = list(document.chunks())
    after = list(document.edit(Edit(Pos(500, 3), Pos(500, 4), "Y")).chunks())
    assert len(before) == len(after)
    assert sum(one is not two for one, two in zip(before, after)) == 1


def depth(root: Branch) -> int:
    """The height of a tree; all leaves must stand at the same."""
    heights = {depth(child) if isinstance(child, Branch) else 0 for child in root.children}
    assert len(heights) == 1
    assert 1 <= len(root.children) <= FANOUT
    return heights.pop() + 1


def test_the_tree_grows_and_shrinks_with_thousands_of_chunks() -> None:
    line = "G1 X1\n"
    document = parsed("", 6)
    for count in (10, 1_000, 5_000, 3):
        document = document.edit(Edit(Pos(0, 0), Pos(0, 0), line * count))
    total = 6_013
    chunks = list(document.chunks())
    assert document.line_count == total + 1
    assert len(chunks) > 2_000
    assert depth(document._root) in (3, 4)
    assert document._root.chunks == len(chunks)
    for number in (0, 23, 24, 575, 576, 2_000, len(chunks) - 1):
        assert chunk_at(document._root, number) is chunks[number]
    while document.line_count > 1:
        document = document.edit(Edit(Pos(document.line_count // 3, 0), Pos(document.line_count // 3 + 200, 0), ""))
        if document.line_count < 200:
            document = document.edit(Edit(Pos(0, 0), Pos(60, 0), ""))
        depth(document._root)
        total = document.line_count
    assert document.text in ("", line)
    assert depth(document._root) == 1


def test_a_tree_over_one_chunk_and_over_many() -> None:
    table = next(iter(parsed("").chunks())).table
    for count in (1, FANOUT, FANOUT + 1, FANOUT * FANOUT + 1):
        root = grown([Chunk("X\n", table) for _ in range(count)])
        assert (root.chunks, root.eols, root.chars) == (count, count, 2 * count)
        assert depth(root) == 1 + (count > FANOUT) + (count > FANOUT * FANOUT)


def typed(document: Document) -> list[tuple[int, str, tuple[int, str] | None]]:
    """Openers and closers with their partners, as words."""
    found = []
    for line, bracket in document.brackets():
        if bracket.role in (Role.OPEN, Role.CLOSE):
            other = document.partner(line, bracket)
            found.append((line, bracket.word, other and (other[0], other[1].word)))
    return found


def test_partners_by_hand() -> None:
    text = "o1 if [1]\no2 while [1]\no2 endwhile\no1 endif\no3 endif\n"
    for size in (3, 20, 300):
        assert typed(parsed(text, size)) == [
            (0, "if", (3, "endif")),
            (1, "while", (2, "endwhile")),
            (2, "endwhile", (1, "while")),
            (3, "endif", (0, "if")),
            (4, "endif", None),
        ]


def test_no_partner_beyond_a_region() -> None:
    text = "o1 if [1]\no9 sub\no2 if [1]\no9 endsub\no2 endif\no1 endif\n"
    for size in (3, 25, 300):
        assert [other for _, _, other in typed(parsed(text, size))] == [None, None, None, None]


def test_the_block_around_a_place() -> None:
    text = "G0\no1 if [1]\nG1\no2 while [1]\nG2\no2 endwhile\nG3\no1 endif\nG4\no9 sub\nG5\no9 endsub\n"
    for size in (3, 20, 300):
        document = parsed(text, size)
        found = [document.around(line, 0) for line in range(document.line_count)]
        heads = [None if each is None else each[0] for each in found]
        # An opener is open behind its start, and a block is open up to the start of its closer.
        assert heads == [None, None, 1, 1, 3, 3, 1, 1, None, None, None, None, None]
        assert document.around(1, 99) == (1, next(each for line, each in document.brackets() if line == 1))


def test_partners_thousands_of_chunks_apart() -> None:
    inner = "o2 if [1]\no2 endif\nG1 X1\n" * 2_000
    document = parsed(f"o1 if [1]\n{inner}o1 endif\n", 30)
    assert len(list(document.chunks())) > 1_000
    brackets = list(document.brackets())
    first, last = brackets[0], brackets[-1]
    assert document.partner(*first) == last == (6_001, last[1])
    assert document.partner(*last) == first
    assert document.partner(*brackets[1]) == brackets[2]
    changed = document.edit(Edit(Pos(3_000, 0), Pos(3_000, 0), "o8 sub\n"))
    assert changed.partner(*first) is None
    assert changed.partner(last[0] + 1, last[1]) is None
    again = changed.edit(Edit(Pos(3_000, 0), Pos(3_001, 0), ""))
    assert again.partner(*first) == last


def test_partners_of_deep_nesting() -> None:
    count = 3_000
    opened = [f"o{number} if [1]\n" for number in range(count)]
    closed = [f"o{number} endif\n" for number in reversed(range(count))]
    document = parsed("".join(opened + closed), 40)
    brackets = list(document.brackets())
    for at in (0, 1, count // 2, count - 1):
        assert document.partner(*brackets[at]) == brackets[2 * count - 1 - at]
    assert document.faults == ()


def test_readings_follow_the_program() -> None:
    document = parsed("G0 X1\nM2\n???\no1 sub\n???\no1 endsub\n???\n")
    assert [node.reading.name for node in document.nodes()] == [
        "program",
        "program",
        "after-end",
        "program",
        "program",
        "program",
        "after-end",
        "after-end",
    ]
    assert [line for line, _ in document.problems()] == [4]
    changed = document.edit(Edit(Pos(1, 0), Pos(1, 2), "M3"))
    assert [line for line, _ in changed.problems()] == [2, 4, 6]


def test_problems_and_brackets_have_lines_of_the_whole() -> None:
    document = parsed("G0\n" * 100 + "o1 if [1]\nX&\n", 9)
    assert [line for line, _ in document.problems()] == [101]
    (line, bracket), *more = document.brackets()
    assert (line, bracket.word, more) == (100, "if", [])
    assert [(fault.at.line, fault.fault.name) for fault in document.faults] == [(100, "UNCLOSED")]
    assert document.balance == (0, 1, False)


def test_a_fold_stops_at_each_line() -> None:
    document = parsed("G0 X1\no1 if [1]\nX2\no1 endif\n")
    states = [document.state(TALLY, line) for line in range(5)]
    assert states[0] == TALLY.start
    wanted, state = [], TALLY.start
    for line in naive.outlined(document.text, DIALECT):
        wanted.append(state)
        node = document.node(len(wanted) - 1)
        state = (
            TALLY.marked(state, node, line.brackets)
            if node.shape.marked
            else TALLY.plain(state, line.reading, node.shape)
        )
    assert states == wanted


def test_lines_are_equal_by_dialect_reading_and_text() -> None:
    one, two, three = parsed("G0 X1\nG0 X1\nG0 X2").nodes()
    assert one == two
    assert hash(one) == hash(two)
    assert one != three
    assert one != "G0 X1"
    assert repr(one) == "LineNode('program', 'G0 X1')"


def test_a_line_finds_its_parts() -> None:
    node = parsed("N5 #1=[2+3] X[4]").node(0)
    assert [node.text[part.start : part.end] for part in node.find("group")] == ["[2+3]", "[4]"]
    assert [part.kind for part in node.find("sum", "word")] == ["sum", "word"]
    assert list(node.find("comparison")) == []
    assert node.tree.node("line_number") is not None
    assert node.tree.find("nothing") is None
    assert [part.kind for part in node.tree.nodes()] == ["line_number", "item", "item"]


def test_a_bracket_that_is_not_there_has_no_partner() -> None:
    (line, bracket), *_ = parsed("o1 if [1]\n").brackets()
    with pytest.raises(ValueError):
        parsed("G0\n").partner(line, Bracket(Role.OPEN, "if", "if", "1", bracket.span))


def test_one_answer_too_many_costs_no_other() -> None:
    document = parsed("G0 X1\n" * 100, 60)
    asked: list[int] = []

    def lines(piece: Piece) -> frozenset[int]:
        asked.append(piece.line)
        return frozenset((piece.lines,))

    for key in range(300):
        document.gathered(key, lines)
    asked.clear()
    for key in range(260, 300):
        document.gathered(key, lines)
    assert not asked
    assert max(len(chunk.memo) for chunk in document.chunks()) < 100


def test_an_edit_asks_the_outline_for_the_lines_that_it_touched() -> None:
    """One chunk holds 200 marked lines; all but the edited one do behind the edit what they did."""
    text = "".join(f"o{number} if [#1 GT {number}]\nG0 X1\no{number} endif\n" for number in range(100))
    document = Document.parse(text, by_name("rs274"))
    assert not document.faults
    for line, col, typed in ((150, 4, " "), (100, 0, "\n\n"), (0, 0, " "), (302, 0, "G0")):
        document = document.edit(Edit(Pos(line, col), Pos(line, col), typed))
        _step.cache_clear()
        assert not document.faults
        assert _step.cache_info().misses <= 1
    assert len(list(document.brackets())) == 200


@pytest.mark.parametrize(
    ("text", "line", "before", "after"),
    [
        ("{}\nG0 X1\no1 while [#1]\no2 if [1]\no2 endif\no1 endwhile\n", 0, "o1 do", "o1 repeat [2]"),
        ("o2 if [1]\n{}\nG0 X1\no1 while [#1]\no2 endif\n", 1, "o1 do", "o3 do\n\no1 do"),
        ("%\no1 sub\no1 endsub\n{}\no2 sub\no2 endsub\n", 3, "G0", "%"),
        ("o1 sub\no1 endsub\n{}\no2 if [1]\no2 endif\n", 2, "G0", "M2"),
    ],
)
@pytest.mark.parametrize("forth", [True, False])
def test_what_an_edit_makes_of_the_lines_behind_it(text: str, line: int, before: str, after: str, forth: bool) -> None:
    """The edited line decides what those behind it do, in the same chunk; and back again."""
    dialect, states = by_name("rs274"), (before, after) if forth else (after, before)
    document = Document.parse(text.format(states[0]), dialect)
    answers(document)
    for old, new in (states, states[::-1]):
        lines = old.split("\n")
        end = Pos(line + len(lines) - 1, len(lines[-1]))
        document = document.edit(Edit(Pos(line, 0), end, new))
        assert document.text == text.format(new)
        assert answers(document) == answers(Document.parse(text.format(new), dialect))
