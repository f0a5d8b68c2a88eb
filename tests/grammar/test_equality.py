"""A document after edits is the document of its text: every answer, every dialect, any chunk size. And an edit reads only what it touched."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from deburr_grammar.dialects import NAMES, by_name
from deburr_grammar.document import Document
from deburr_grammar.text import Edit, Pos
from support import naive
from support.equality import Case, answers, check, check_reading
from support.strategies import SIZES, cases, steady, texts


@pytest.mark.parametrize("name", NAMES)
def test_edits_equal_a_fresh_parse(name: str) -> None:
    dialect = by_name(name)

    @steady(600)
    @given(cases(dialect))
    def compare(case: Case) -> None:
        check(dialect, case)

    compare()


@pytest.mark.parametrize("name", NAMES)
def test_an_edit_reads_the_lines_it_touched(name: str) -> None:
    dialect = by_name(name)

    @steady(200)
    @given(cases(dialect))
    def count(case: Case) -> None:
        check_reading(dialect, case)

    count()


@pytest.mark.parametrize("name", NAMES)
def test_the_size_of_chunks_changes_nothing(name: str) -> None:
    dialect = by_name(name)

    @steady(80)
    @given(texts(dialect, 40), st.sampled_from(SIZES))
    def compare(text: str, size: int) -> None:
        assert answers(Document.parse(text, dialect, size)) == answers(Document.parse(text, dialect))

    compare()


@pytest.mark.parametrize("name", NAMES)
def test_typing_a_program_sign_by_sign_equals_opening_it(name: str) -> None:
    dialect = by_name(name)

    @steady(20)
    @given(texts(dialect, 8))
    def type_it(text: str) -> None:
        typed = tuple(Edit(Pos(99, 99), Pos(99, 99), sign) for sign in text[:120])
        check(dialect, Case("", typed, 20, frozenset(range(0, 120, 7))))

    type_it()


@pytest.mark.parametrize("name", NAMES)
def test_an_edit_and_its_inverse_leave_every_answer(name: str) -> None:
    dialect = by_name(name)

    @steady(60)
    @given(cases(dialect))
    def undo(case: Case) -> None:
        document = Document.parse(case.text, dialect, case.size)
        before = answers(document)
        for edit in case.edits[:1]:
            changed = document.edit(edit)
            answers(changed)
            whole = Edit(Pos(0, 0), Pos(10_000, 0), case.text)
            assert answers(changed.edit(whole)) == before
        assert answers(document) == before

    undo()


@pytest.mark.parametrize("name", NAMES)
def test_all_edits_at_once_equal_one_after_the_other(name: str) -> None:
    dialect = by_name(name)

    @steady(40)
    @given(cases(dialect))
    def compare(case: Case) -> None:
        document = step = Document.parse(case.text, dialect, case.size)
        text = case.text
        for edit in case.edits:
            step, text = step.edit(edit), naive.edited(text, edit)
        assert document.edit(*case.edits).text == step.text == text

    compare()


@pytest.mark.parametrize("size", [1, 3])
@pytest.mark.parametrize("name", NAMES)
def test_every_seam_of_two_line_ends(name: str, size: int) -> None:
    """Each way to bring a carriage return and a newline together, or apart, across chunks."""
    dialect = by_name(name)
    for text in ("a\rb\nc", "a\r\nb", "\r\n\r\n", "a\r\r\n\nb", "\n\r\n\r", "a\r"):
        for line in range(4):
            for end in range(line, 4):
                for new in ("", "\n", "\r", "x"):
                    edit = Edit(Pos(line, 0), Pos(end, 1 if end == line else 0), new)
                    check(dialect, Case(text, (edit, edit._replace(text="\n")), size, frozenset({0, 1})))


def test_the_check_tells_documents_apart() -> None:
    """A check that compares nothing would pass everything."""
    dialect = by_name(NAMES[0])
    found = answers(Document.parse("o1 if [1]\nX1", dialect))
    other = answers(Document.parse("o1 if [1]\nX1 X", dialect))
    assert {name for name in found if found[name] == other[name]} < set(found)
    assert all(found["readings"]) and found["readings"][0]._replace(name="x") != found["readings"][0]
