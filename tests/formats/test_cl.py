"""CL text as statements: what is read, what is refused and where."""

from pathlib import Path

import pytest

from deburr.formats.cl import plane, read

EXAMPLES = Path(__file__).parents[2] / "examples" / "cgt"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("GOTO/1,2,3", ("GOTO", (1.0, 2.0, 3.0), ())),
        ("goto / 1. , .5 , -3e-2 $$ back", ("GOTO", (1.0, 0.5, -0.03), ())),
        ("GOTO/1,2,3,0,0,1", ("GOTO", (1.0, 2.0, 3.0, 0.0, 0.0, 1.0), ())),
        ("GOTO/1,$\n2,$ $$ more\n3", ("GOTO", (1.0, 2.0, 3.0), ())),
        ("RAPID", ("RAPID", (), ())),
        ("SPINDL/RPM,1500.5,clw", ("SPINDL", (1500.5,), ("RPM", "CLW"))),
        ("SPINDL/OFF", ("SPINDL", (), ("OFF",))),
        ("LOADTL/12,ADJUST,3", ("LOADTL", (12.0,), ())),
        ("CUTCOM/RIGHT,7", ("CUTCOM", (7.0,), ("RIGHT",))),
        ("CUTCOM/RIGHT", ("CUTCOM", (), ("RIGHT",))),
        ("FEDRAT/80,MMPM", ("FEDRAT", (80.0,), ("MMPM",))),
        ("CYCLE/DEEP,DEPTH,20,STEP,2", ("CYCLE", (), ("DEEP",))),
        ("FROM/0,0,100", ("FROM", (0.0, 0.0, 100.0), ())),
    ],
)
def test_statements(text: str, expected: tuple[object, ...]) -> None:
    (statement,), faults = read(text)
    assert not faults
    assert (statement.word, statement.numbers, statement.choices) == expected


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("PARTNO SQUARE 12", "SQUARE 12"),
        ("PPRINT / FIRST SIDE", "FIRST SIDE"),
        ("TOOL  NAME/END MILL 10", "END MILL 10"),
    ],
)
def test_texts(text: str, said: str) -> None:
    (statement,), faults = read(text)
    assert (statement.text, faults) == (said, ())


@pytest.mark.parametrize(
    ("text", "line", "cols", "words"),
    [
        ("GOTO/1,2", 0, (0, 8), ("2 values", "GOTO/x,y,z")),
        ("GOTO/1,2,3,4", 0, (0, 12), ("4 values",)),
        ("GOTO/1,2,3,0,0,1,5", 0, (17, 18), ("too many",)),
        ("GOTO 1,2,3", 0, (0, 10), ("`/` is missing",)),
        ("GOTO/1,,3", 0, (7, 8), ("missing",)),
        ("GOTO/1,2,$\n", 0, (8, 9), ("missing",)),
        ("GOTO/1 2,3", 0, (5, 8), ("a comma is missing",)),
        ("GOTO/1,$\n 2,3O", 1, (3, 5), ("neither a number",)),
        ("GOTO/1,2,1e999", 0, (9, 14), ("a number",)),
        ("RAPID/1", 0, (6, 7), ("too many",)),
        ("LOADTL/1.5", 0, (7, 10), ("whole number",)),
        ("FEDRAT/MMPM,80", 0, (7, 11), ("FEDRAT/f,unit",)),
        ("FEDRAT/80,MMPN", 0, (10, 14), ("did you mean `MMP",)),
        ("SPINDL/RPM,80", 0, (0, 13), ("SPINDL/RPM,s,CLW",)),
        ("COOLNT/FLOD", 0, (7, 11), ("did you mean `FLOOD`?",)),
        ("CYCLE/REAM", 0, (6, 10), ("`BORE`",)),
        ("CIRCLE/0,0,0,0,0,1,0", 0, (19, 20), ("above 0",)),
        ("CIRCLE/0,0,0,0,0,0,5", 0, (13, 18), ("axis",)),
        ("CIRCLE/0,0,0,0,1,1,5", 0, (13, 18), ("axis",)),
        ("DELAY/-1", 0, (6, 8), ("from 0 on",)),
        ("UNITS/CM", 0, (6, 8), ("`UNITS/MM`",)),
        ("%", 0, (0, 1), ("no statement",)),
    ],
)
def test_faults(text: str, line: int, cols: tuple[int, int], words: tuple[str, ...]) -> None:
    statements, (fault,) = read(text)
    assert not statements
    assert (fault.line, fault.span, fault.ignored) == (line, cols, False)
    for word in words:
        assert word in fault.message


def test_what_is_ignored_is_said_once_a_word() -> None:
    statements, faults = read("PAINT/1\nGOT/1,2,3\nPAINT/2\nLOADTL/1,LENGTH,9\nLOADTL/2,LENGTH,8\nFINI\nmore")
    assert [statement.word for statement in statements] == ["LOADTL", "LOADTL", "FINI"]
    assert [(fault.line, fault.span.start, fault.ignored) for fault in faults] == [
        (0, 0, True),
        (1, 0, True),
        (3, 9, True),
    ]
    assert "also on 1 more line" in faults[0].message
    assert "did you mean `GOTO`?" in faults[1].message


@pytest.mark.parametrize(
    ("axis", "found"),
    [("0,0,1", (2, 1)), ("0,0,-1.0000", (2, -1)), ("0.00001,1,0", (1, 1)), ("-1,0,0", (0, -1))],
)
def test_planes(axis: str, found: tuple[int, int]) -> None:
    (statement,), _ = read(f"CIRCLE/0,0,0,{axis},5")
    assert plane(statement) == found


def test_the_example_is_clean() -> None:
    statements, faults = read((EXAMPLES / "mill.cl").read_text(encoding="utf-8"))
    assert faults == ()
    assert [statement.word for statement in statements].count("GOTO") == 14


@pytest.mark.parametrize(
    "text", ["", "\n\n", "$", "$$", "$\n$\n", "\f", "GOTO/$", "/", ",", "GOTO/" + ",1" * 2000, "１/2"]
)
def test_garbage_gives_values_with_columns(text: str) -> None:
    for fault in read(text).faults:
        assert fault.span.start < fault.span.end
