"""Modal state: what is certain on every line, what is not, and that an edit leaves it as a fresh fold would."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from deburr.modal import Modal, modal_of
from deburr_grammar.dialects import by_name
from deburr_grammar.document import Document
from deburr_grammar.text import Edit, Pos

RS274 = by_name("rs274")


def modal() -> Modal:
    found = modal_of(RS274)
    assert found is not None
    return found


def check_code(program: str, group: str, expected: str | None) -> None:
    """What holds in a group before the last line of a program."""
    document = Document.parse(program, RS274, size=3)
    state = document.state(modal(), document.line_count - 1)
    assert state.code(group) == expected, program


@pytest.mark.parametrize(
    ("program", "group", "expected"),
    [
        ("", "motion", None),
        ("G1 X1\n", "motion", "G1"),
        ("g 01 x1\nG00\n", "motion", "G0"),
        ("N10 G21 G90 G1\n", "units", "G21"),
        ("G1 F100\n", "F", "F"),
        ("G1 X1\nG4 P1\n", "motion", "G1"),
        ("(G0)\nG1 ; G0\n", "motion", "G1"),
        ("G5.1 X1 I1 J1\n", "motion", None),
        ("G1\nG#1\n", "motion", None),
        ("G1\n/G0 X1\n", "motion", None),
        ("G1\n/G1 X1\n", "motion", "G1"),
        ("G1\n/G90\n", "motion", "G1"),
    ],
)
def test_lines(program: str, group: str, expected: str | None) -> None:
    check_code(program, group, expected)


@pytest.mark.parametrize(
    ("program", "expected"),
    [
        ("G1\no1 if [#1]\n", "G1"),
        ("G1\no1 if [#1]\nG0\no1 endif\n", None),
        ("G1\no1 if [#1]\nG1\no1 endif\n", "G1"),
        ("G1\no1 if [#1]\nG0\no1 else\n", "G1"),
        ("G1\no1 if [#1]\nG0\no1 else\nG0\no1 endif\n", None),
        ("G1\no1 if [#1]\nG90\no1 endif\n", "G1"),
        ("G1\no1 while [#1]\n", None),
        ("G1\no1 while [#1]\nG0\n", "G0"),
        ("G1\no1 while [#1]\nG90\no1 endwhile\n", "G1"),
        ("G1\no1 while [#1]\nG1\no1 endwhile\n", None),
        ("G1\no1 repeat [2]\no2 if [#1]\nG0\no2 endif\no1 endrepeat\n", None),
        ("G1\no1 do\no2 if [#1]\nG90\no2 endif\no1 while [#1]\n", "G1"),
        ("G1\no1 if [#1]\no9 call\no1 endif\n", None),
        ("G1\no1 endif\n", "G1"),
        ("G1\n" + "".join(f"o{n} if [#1]\n" for n in range(90)), None),
        ("G1\n" + "".join(f"o{n} if [#1]\n" for n in range(90)) + "G0\n", "G0"),
        (
            "G1\n"
            + "".join(f"o{n} if [#1]\n" for n in range(90))
            + "".join(f"o{n} endif\n" for n in range(89, -1, -1)),
            None,
        ),
    ],
)
def test_blocks(program: str, expected: str | None) -> None:
    check_code(program, "motion", expected)


@pytest.mark.parametrize(
    ("program", "expected"),
    [
        ("G1\no<a> sub\n", None),
        ("G1\no<a> sub\nG0\n", "G0"),
        ("G1\no<a> sub\nG0\no<a> endsub\n", "G1"),
        ("G1\no<a> sub\no1 if [#1]\no<a> endsub\n", "G1"),
        ("G1\no<a> call [1]\n", None),
        ("G1\nM98 P100\n", None),
        ("G1\nM72\n", None),
        ("G1\no100\n", None),
        ("G1\nM2\nG0\n", "G1"),
    ],
)
def test_routines(program: str, expected: str | None) -> None:
    check_code(program, "motion", expected)


def test_a_group_that_nothing_has_set_is_told_from_one_that_is_unknown() -> None:
    document = Document.parse("G90\no<a> call\nG21\n", RS274)
    assert document.state(modal(), 1).untouched("motion")
    assert not document.state(modal(), 1).untouched("distance")
    assert not document.state(modal(), 2).untouched("motion")


LINES = [
    "G0 X1",
    "G1 X1 F100",
    "G2 X1 R1",
    "G90",
    "G91",
    "o1 if [#1]",
    "o1 else",
    "o1 endif",
    "o2 while [#1]",
    "o2 endwhile",
]
LINES += ["o<a> sub", "o<a> endsub", "o<a> call", "/G0", "(G1)", "M2", "G#1"]
PROGRAMS = st.lists(st.sampled_from(LINES), max_size=20)


@given(PROGRAMS, st.lists(st.tuples(st.integers(0, 20), st.integers(0, 3), PROGRAMS), max_size=4))
def test_edited_and_fresh_agree(lines: list[str], edits: list[tuple[int, int, list[str]]]) -> None:
    document = Document.parse("\n".join(lines), RS274, size=12)
    for start, count, new in edits:
        # Asked before each edit, so that what is kept from then could do harm.
        document.state(modal(), document.line_count - 1)
        document = document.edit(Edit(Pos(start, 0), Pos(start + count, 0), "".join(line + "\n" for line in new)))
    fresh = Document.parse(document.text, RS274, size=12)
    for line in range(document.line_count):
        assert _values(document, modal(), line) == _values(fresh, Modal(RS274, RS274.modality), line)


def _values(document: Document, fold: Modal, line: int) -> list[str]:
    return [document.state(fold, line).modes[group] for group in ("motion", "distance", "F")]


class Counting(Modal):
    """Counts the lines that it folds."""

    lines = 0

    def plain(self, state, reading, shape):  # type: ignore[no-untyped-def]
        self.lines += 1
        return super().plain(state, reading, shape)


@pytest.mark.parametrize("text", ["5", "\n", "\no9 if [#1]\n"])
def test_an_edit_folds_its_chunk_again_and_no_other(text: str) -> None:
    fold = Counting(RS274, RS274.modality)  # type: ignore[arg-type]
    document = Document.parse("G1 X12 Y34\n" * 2_000, RS274, size=200)
    document.state(fold, document.line_count - 1)
    fold.lines = 0
    edited = document.edit(Edit(Pos(1_000, 4), Pos(1_000, 4), text))
    edited.state(fold, 1_001)
    assert fold.lines <= 60
