"""Folding by hand-worked values, on a dialect of its own that is made for this page."""

import gc
from weakref import ref

import pytest

from deburr_grammar.codes import code_number
from deburr_grammar.dialects import NAMES, by_name
from deburr_grammar.line import DEEPEST, LONGEST, LineNode, Shapes, shapes_of
from deburr_grammar.shape import Columns, Folding
from deburr_grammar.tree import walk

PLAIN = Folding()
KEEP = Folding(protect=r"[GM][0-9]+|L254", inert=r"(\(!(?:[^()\n]*)\)?)|\((?<=(\())[^()\n]*(\))|;(?<=(;))[^\n]*")


@pytest.mark.parametrize(
    ("folding", "text", "shape"),
    [
        (PLAIN, "", ""),
        (PLAIN, "X10 Y2.55", "X0 Y0.0"),
        (PLAIN, "1234567890", "0"),
        (PLAIN, "0", "0"),
        (PLAIN, "00\n000\n0000\n0" + "0" * 97, "0\n0\n0\n0"),
        (PLAIN, "X1é22", "X0é0"),
        (PLAIN, "X٣²", "X٣²"),
        (PLAIN, "(a 12)", "(a 0)"),
        (KEEP, "G10 X10 M3", "G10 X0 M3"),
        (KEEP, "L2540 L25 L254", "L2540 L0 L254"),
        (KEEP, "G1 (drill 12) X10 ; note 5", "G1 () X0 ;"),
        (KEEP, "(a (b 1) c 2)", "(a () c 0)"),
        (KEEP, "(! 12 ; G5 3) X4", "(! 0 ; G5 0) X0"),
        (KEEP, "(!12 ; 3", "(!0 ; 0"),
        (KEEP, "G1\x002\x00 (3)", "G1\x000\x00 ()"),
        (KEEP, "G1 (12\n34) X5", "G1 (0\n0) X0"),
    ],
)
def test_shapes(folding: Folding, text: str, shape: str) -> None:
    assert folding.fold(text) == shape


@pytest.mark.parametrize(
    ("folding", "line", "columns"),
    [
        (PLAIN, "X1", [0, 1, 2]),
        (PLAIN, "X123Y", [0, 1, 4, 5]),
        (PLAIN, "12.34", [0, 2, 3, 5]),
        (KEEP, "G10X10", [0, 1, 2, 3, 4, 6]),
        (KEEP, "(abc)X12", [0, 4, 5, 6, 8]),
        (KEEP, "()X", [0, 1, 2, 3]),
        (KEEP, ";abc", [0, 4]),
        (KEEP, "(!12;3)4", [0, 1, 2, 4, 5, 6, 7, 8]),
    ],
)
def test_columns(folding: Folding, line: str, columns: list[int]) -> None:
    found = folding.columns(line)
    assert [found(col) for col in range(len(folding.fold(line)) + 1)] == columns


def test_columns_behind_ends_have_grown() -> None:
    columns = Columns([0, 2, 5], [0, 3, 4])
    assert [columns(col) for col in range(7)] == [0, 1, 5, 6, 7, 9, 10]


def test_equal_shapes_are_one_object_however_full_the_table_gets(monkeypatch: pytest.MonkeyPatch) -> None:
    shapes = Shapes(by_name(NAMES[0]))
    one, two = shapes.read("X1\nX22")
    assert one is two
    monkeypatch.setattr(Shapes, "LIMIT", 2)
    many = shapes.read("A\nB\nC\nX3\nA")
    assert len(shapes) <= 2
    assert many[3] is one
    assert many[4] is many[0]


def test_shapes_go_that_only_the_table_held(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Shapes, "LIMIT", 4)
    shapes = Shapes(by_name(NAMES[0]))
    held = shapes.read("A")[0]
    seen = [ref(shapes.read("B" * count)[0]) for count in range(1, 100)]
    gc.collect()
    assert sum(shape() is not None for shape in seen) <= 2 * Shapes.LIMIT + 1
    assert shapes.read("A")[0] is held


@pytest.mark.parametrize("name", NAMES)
def test_a_line_beyond_all_measure_is_not_read(name: str) -> None:
    dialect = by_name(name)
    reading = next(reading for reading in dialect.readings if reading.start)

    def node(text: str) -> LineNode:
        return LineNode(text, reading, shapes_of(dialect)[dialect.folding.fold(text)])

    for text, kind in (("X" * (LONGEST + 1), "line-too-long"), ("[" * (DEEPEST + 1), "line-too-deep")):
        line = node(text)
        assert [(problem.kind, problem.start, problem.end) for problem in line.problems] == [(kind, 0, len(text))]
        assert list(walk(line.tree))[1:] == []
        assert line.kinds == frozenset()
    assert "line-too-long" not in {problem.kind for problem in node("X" * LONGEST).problems}


def test_a_tree_that_nests_too_deep_is_not_given() -> None:
    """Sums and signs nest without a bracket; whoever walks a tree by recursion must not fall."""
    dialect = by_name("rs274")
    reading = dialect.readings[0]
    for text in (
        "#1=[" + "1+" * 3000 + "1]",
        "X" + "-" * 2000 + "1",
        "#" * 900 + "1",
        "#1=" + "[-SIN" * 150 + "[1]" + "]" * 150,
        "#1=[" + "1+" * 3000,
    ):
        node = LineNode(text, reading, shapes_of(dialect)[dialect.folding.fold(text)])
        assert [(problem.kind, problem.start, problem.end) for problem in node.problems] == [
            ("line-too-deep", 0, len(text))
        ]
    for text in ("#1=[" + "1+" * 120 + "1]", "X" + "-" * 250 + "1", "#1=" + "[" * 120 + "1" + "]" * 120):
        node = LineNode(text, reading, shapes_of(dialect)[dialect.folding.fold(text)])
        assert node.problems == ()
        assert node.tree.end == len(text)


@pytest.mark.parametrize(
    ("said", "number"),
    [
        ("g01", "G1"),
        ("G 38.20", "G38.2"),
        ("M0", "M0"),
        ("m00", "M0"),
        ("G", "G0"),
        ("G5.", "G5"),
        ("G" + "0" * 5000 + "1", "G1"),
        ("M" + "9" * 5000, "M" + "9" * 5000),
        ("#1", "#1"),
    ],
)
def test_codes_have_one_spelling(said: str, number: str) -> None:
    assert code_number(said) == number
