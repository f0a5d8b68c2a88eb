"""Machine files: what is taken from them, what is refused and where."""

import pytest

from deburr.formats.machine import Machine, read

WHOLE = """\
arc-center = "absolute"
first-tool = "toolchg"
block-start = 5
block-step = 1
[formats]
F_Decimal = "D+3.4"
[tables]
MOV = ["G0", "G1"]
[words]
WPOS = "decimal"
"""


def test_all_that_it_can_say() -> None:
    assert read(WHOLE) == Machine(
        "absolute", "toolchg", 5, 1, {"F_Decimal": "D+3.4"}, {"MOV": ("G0", "G1")}, {"WPOS": "decimal"}
    )
    assert read("") == Machine()


@pytest.mark.parametrize(
    ("text", "line", "cols", "said"),
    [
        ("arc-centre = 1", 0, (0, 10), "did you mean `arc-center`?"),
        ('arc-center = "incremetal"', 0, (0, 10), "did you mean `incremental`?"),
        ("\nfirst-tool = 1", 1, (0, 10), '"start" or "toolchg"'),
        ("block-start = -1", 0, (0, 11), "from 0 on"),
        ("block-step = 0", 0, (0, 10), "from 1 on"),
        ("block-step = true", 0, (0, 10), "from 1 on"),
        ('[formats]\nF_Decimal = "D4"', 1, (0, 9), '"D4.4"'),
        ('[formats]\nF_Decimal = "d4.4"', 1, (0, 9), "did you mean `D4.4`?"),
        ('[formats]\n"F_Decimals" = "D4.4"', 1, (0, 12), "did you mean `F_Decimal`?"),
        ("[tables]\nMOV = 1", 1, (0, 3), "a list of texts"),
        ("[tables]\nMOV = [0, 1]", 1, (0, 3), "a list of texts"),
        ('[tables]\n"@gear" = ["M40"]', 1, (0, 7), "without `#` and `@`"),
        ('[words]\nWPOS = "decimla"', 1, (0, 4), "did you mean `decimal`?"),
        ('[words]\n"#WPOS" = "decimal"', 1, (0, 7), "without `#`"),
        ('[words]\nwpos = "decimal"', 1, (0, 4), "in capitals"),
        ("words = 1", 0, (0, 5), "must be a table"),
        ('[word]\nWPOS = "decimal"', 0, (1, 5), "did you mean `words`?"),
        ("[words\n", 0, (5, 6), "no TOML"),
        ("a = ", 0, (2, 3), "no TOML"),
    ],
)
def test_faults(text: str, line: int, cols: tuple[int, int], said: str) -> None:
    (fault,) = read(text).faults
    assert said in fault.message
    assert (fault.line, fault.span) == (line, cols)


def test_what_is_wrong_counts_as_not_said() -> None:
    machine = read('block-step = 0\n[words]\nA = "text"\nB = "txt"\n[tables]\nMOV = 3\n')
    assert (machine.block_step, dict(machine.words), dict(machine.tables)) == (10, {"A": "text"}, {})
    assert (machine.lost, machine.doubtful) == (False, {"B", "MOV"})
    assert read("[words").lost and read("words = 1").lost and read("[word]").lost and not read("word = 1").lost
