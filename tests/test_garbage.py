"""Whatever bytes a file holds: findings or a clear refusal, never an exception, and soon."""

from __future__ import annotations

import random
import time
from collections.abc import Iterator
from functools import cache
from itertools import cycle
from pathlib import Path

import pytest

from deburr.check import check
from deburr.ruleset import RuleSet
from deburr.source import NotAProgram, read
from deburr_grammar.dialect import Dialect
from deburr_grammar.dialects import NAMES, by_name
from support import naive
from support.alphabets import alphabet, pieces
from support.places import check_finding

EXAMPLES = Path(__file__).parents[1] / "examples"
LINUXCNC = Path("/usr/share/linuxcnc/ncfiles")
SECONDS = 2.0
RANDOM, TRUNCATED, SPLICED = 2_000, 200, 200


@cache
def ruleset(name: str) -> RuleSet:
    """All rules; what is loaded with the first program is no part of what one costs."""
    found = RuleSet(by_name(name), selected=lambda rule: True)
    for example in sorted((EXAMPLES / name).glob(f"*{by_name(name).extensions[0]}")):
        source = read(example.read_bytes())
        assert not isinstance(source, NotAProgram)
        check(source, by_name(name), found)
    return found


def check_bytes(name: str, data: bytes, seconds: float = SECONDS) -> None:
    """The whole path from bytes to findings, against the processor's clock: what else the machine does must not count."""
    rules = ruleset(name)
    started = time.process_time()
    source = read(data)
    if isinstance(source, NotAProgram):
        assert source.reason
        return
    findings = check(source, by_name(name), rules)
    took = time.process_time() - started
    assert took < seconds, f"{name}: {took:.1f} s for {len(data)} bytes: {data[:80]!r}"
    lines = source.lines
    for finding in findings:
        check_finding(finding, lines)


def random_files(count: int) -> Iterator[bytes]:
    """Bytes of all sorts: any at all, few different ones, text, and text with some bytes changed."""
    rng = random.Random(20)
    few = b"G0XYZ#<>[]()%;!@|=,. \n\r\x00\x1a\xff\xe9"
    for number in range(count):
        size = rng.choice((0, 1, 3, 40, 200, 200, 1000))
        match number % 4:
            case 0:
                yield rng.randbytes(size)
            case 1:
                yield bytes(rng.choices(few, k=size))
            case 2:
                yield bytes(rng.choices(range(9, 127), k=size))
            case _:
                yield rng.randbytes(size).replace(b"\0", b" ")


def random_programs(dialect: Dialect, count: int) -> Iterator[bytes]:
    rng = random.Random(21)
    stock = [piece.replace("\0", "") for piece in pieces(dialect)]
    for _ in range(count):
        yield "".join(rng.choices(stock, k=rng.choice((1, 5, 40)))).encode(
            rng.choice(("utf-8", "utf-8", "utf-16", "cp1252")), "replace"
        )


@pytest.mark.parametrize("name", NAMES)
def test_random_bytes(name: str) -> None:
    share = RANDOM // len(NAMES)
    for data in random_files(share // 2):
        check_bytes(name, data)
    for data in random_programs(by_name(name), share - share // 2):
        check_bytes(name, data)


@cache
def programs(name: str) -> tuple[bytes, ...]:
    """Real programs: the dialect's examples, LinuxCNC's where they are installed, and the test lines as one program."""
    found = [path.read_bytes() for path in sorted((EXAMPLES / name).rglob("*")) if path.is_file()]
    if ".ngc" in by_name(name).extensions and LINUXCNC.is_dir():
        found += [path.read_bytes() for path in sorted(LINUXCNC.rglob("*.ngc")) if path.stat().st_size < 20_000]
    return (*found, by_name(name).frame.replace("{}", "\n".join(alphabet(by_name(name)).lines)).encode())


@pytest.mark.parametrize("name", NAMES)
def test_truncated_programs(name: str) -> None:
    rng = random.Random(22)
    stock = cycle(rng.sample(programs(name), len(programs(name))))
    for _ in range(TRUNCATED // len(NAMES)):
        data = next(stock)
        check_bytes(name, data[: rng.randrange(len(data) + 1)])
        check_bytes(name, data[rng.randrange(len(data) + 1) :])


@pytest.mark.parametrize("name", NAMES)
def test_spliced_programs(name: str) -> None:
    """Pieces of two programs, of two dialects as often as not, joined anywhere."""
    rng = random.Random(23)
    others = [program for each in NAMES for program in programs(each)[-3:]]
    for _ in range(SPLICED // len(NAMES)):
        one, two = rng.choice(programs(name)), rng.choice((*programs(name), *others))
        a, b = sorted(rng.randrange(len(one) + 1) for _ in range(2))
        c, d = sorted(rng.randrange(len(two) + 1) for _ in range(2))
        check_bytes(name, one[:a] + two[c:d] + one[b:])


MILLION = 1_000_000
AWKWARD = {
    "nothing": b"",
    "only NUL": b"\0" * 10_000,
    "only carriage returns": b"\r" * 50_000,
    "only newlines": b"\n" * 50_000,
    "newline before carriage return": b"\n\r" * 20_000,
    "only form feeds": b"\f" * 50_000,
    "only ^Z": b"\x1a" * 1000,
    "a byte order mark alone": b"\xef\xbb\xbf",
    "UTF-16": "G0 X1\n".encode("utf-16"),
    "half a UTF-8 sign": b"G0 X1 (\xe2\x82",
    "one line of digits": b"G1 X" + b"1" * MILLION,
    "one line of blanks": b" " * MILLION,
    "one line of tabs and a letter": b"\t" * MILLION + b"M",
    "one line of words": b"G1 X1 " * (MILLION // 6),
    "one line of letters": b"x" * MILLION,
    "one comment": b"(" + b"a1 " * (MILLION // 3) + b")",
    "one line of comments": b"(a1)" * (MILLION // 4),
    "one line of comments that are never closed": b"( " * (MILLION // 2),
    "one line of comments to the end": b"; " * (MILLION // 2),
    "one line of hashes": b"#" * MILLION,
    "one line of bars": b"|a" * (MILLION // 2),
    "one line of bangs": b"!HA=1" * (MILLION // 5),
    "one line of angles": b"<X#XPOS>" * (MILLION // 8),
    "one line of words with a hash": b"#XPOS" * (MILLION // 5),
    "blanks behind a letter": b"M" + b" " * 19_000,
    "blanks behind a hash": b"#" + b" " * 19_000 + b"1",
    "many blanks behind many letters": (b"M" + b" " * 100) * 190,
    "a line just short enough": b"G1 X1 " * 3_300,
    "a sum just short enough": b"#1=[" + b"1+" * 9_000 + b"1]",
    "a sum in an angle": b"HA<" + b"1+" * 9_000 + b"1>",
    "a sum in EVAL": b"@LINE\n#EVAL(#V1=" + b"1+" * 9_000 + b"1)",
    "a sum in a field": b"!HA=" + b"1+" * 9_000 + b"1!",
    "signs without end": b"G0 X" + b"-" * 15_000 + b"1",
    "hashes before a number": b"G0 X" + b"#" * 15_000 + b"1",
    "brackets": b"[" * 10_000,
    "brackets in one expression": b"#1=" + b"[" * 5_000 + b"1" + b"]" * 5_000,
    "brackets that just pass": b"#1=" + b"[" * 190 + b"1" + b"]" * 190,
    "functions that just pass": b"#1=" + b"-SIN[" * 60 + b"1" + b"]" * 60,
    "parentheses that just pass": b"HA<" + b"SN(" * 150 + b"1" + b")" * 150 + b">",
    "parentheses in EVAL": b"@LINE\n#EVAL(#V1=" + b"ABS(" * 150 + b"1" + b")" * 150 + b")",
    "angles that just pass": b"X" + b"<PAR[" * 60 + b"1" + b"]>" * 60,
    "signs that just pass": b"#1=[" + b"-" * 240 + b"1]",
    "a sum that just passes": b"#1=[" + b"1+" * 240 + b"1]",
    "a sum in EVAL that just passes": b"@LINE\n#EVAL(#V1=" + b"1+" * 200 + b"1)",
    "a sum in an angle that just passes": b"X<" + b"1+" * 200 + b"1>",
    "a power that just passes": b"#1=[" + b"9**" * 80 + b"9]\n@LINE\n#EVAL(#V1=" + b"9^" * 100 + b"9)",
    "parentheses": b"(" * 10_000,
    "angles": b"@LINE\n" + b"<" * 10_000,
    "angles over lines": b"@LINE\n" + b"<\n" * 10_000,
    "angles closed over lines": b"@LINE\n" + b"<X#XPOS\n" * 5_000 + b">\n" * 5_000,
    "blocks without end": b"".join(b"o%d if [1]\n" % number for number in range(6_000)),
    "blocks of one label": b"o1 while [1]\n" * 6_000,
    "ends without blocks": b"o1 endif\n" * 4_000,
    "blocks of another kind": b"o1 if [1]\n" * 3_000 + b"o1 endwhile\n" * 3_000,
    "blocks that cross": b"o1 if [1]\no2 if [1]\no1 endif\no2 endif\n" * 1_500,
    "blocks in blocks": b"o1 do\n" * 3_000 + b"o1 while [1]\n" * 3_000,
    "subs in subs": b"o1 sub\n" * 6_000,
    "loops in loops": b"#LOOP1 |z| 2 c\n" * 3_000 + b"#ENDLOOP1\n" * 3_000,
    "conditions in conditions": b"".join(b"#IF%d |a| equalto 1 n\n" % number for number in range(5_000))
    + b"#ENDIF7\n" * 5_000,
    "headers": b"@LINE\n" * 5_000,
    "sections of all names": b"".join(b"@s%d\n#CALL(s%d)\n" % (number, number + 1) for number in range(5_000)),
    "targets": b"%\n" + b"".join(b"N%d\n!GON%d!\n" % (number, number + 1) for number in range(5_000)),
    "targets of one number": b"%\n" + b"N1\n!GON1!\n" * 5_000,
    "percent signs": b"%\n" * 10_000,
    "faulty lines": b"&?\n" * 5_000,
    "long numbers": b"".join(
        prefix + b"9" * 5_000 + b"\n"
        for prefix in (
            b"G",
            b"M",
            b"N",
            b"o",
            b"#",
            b"X",
            b"X.",
            b"F1.",
            b":",
            b"PAL[",
            b"!GON",
            b"!GOP",
            b"#IF",
            b"#ENDIF",
            b"#V",
            b"G25",
            b"o<a> call [",
            b"#1=[",
            b"G0 X[1/",
        )
    ),
    "long numbers in whole lines": b"".join(
        line.replace(b"9", b"9" * 400) + b"\n"
        for line in (
            b"o9 if [1]",
            b"o9 endif",
            b"#9=9",
            b"o9.0 if [9 MOD 9]",
            b"#1=[9**9]",
            b"#1=EXP[9]",
            b"#1=[1/9]",
            b"#1=SQRT[-9]",
            b"N9 X<9*9>",
            b"PAL[9]1",
            b"PAR[9]9",
            b"!IF 9>9; GON9!",
            b"X<RQ(9)>",
            b"!HA=9/9!",
            b"#EVAL(#V9=9^9)",
            b"#TABLE(a,9)",
            b"#REPEAT(9)<a>",
            b"#FMT(#V1, D9.9)",
            b"#LOOP9 |a| 9 c",
            b"#ENDLOOP9",
            b"#IF9 9 equalto 9 n",
            b"#ENDIF9",
            b"G9 M9 T9 S9 F9 P9",
            b"G9.9",
            b"G4 P9",
            b"G2 X9 I9 F9",
        )
    ),
    "tiny numbers": b"#1=[1/0."
    + b"0" * 400
    + b"1]\nX<1/0."
    + b"0" * 400
    + b"1>\n@LINE\n#EVAL(#V1=1/0."
    + b"0" * 400
    + b"1)",
    "comments that allow": b"(deburr: allow a.b, c)\n" * 5_000,
}


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("what", sorted(AWKWARD))
def test_awkward_files(what: str, name: str) -> None:
    check_bytes(name, AWKWARD[what])


@pytest.mark.parametrize("name", NAMES)
def test_each_line_repeated_and_joined(name: str) -> None:
    """Every typical line a thousand times over, and a hundred times on one line."""
    for line in alphabet(by_name(name)).lines[::3]:
        check_bytes(name, (line + "\n").encode() * 300)
        check_bytes(name, line.encode() * 60)


def test_the_check_would_notice() -> None:
    """The clock runs, and a finding outside its file is one."""
    with pytest.raises(AssertionError, match="bytes"):
        check_bytes(NAMES[0], b"G0 X1\n", seconds=0)
    source = read(b"(a (b) c)\n")
    assert not isinstance(source, NotAProgram)
    finding = check(source, by_name("rs274"), ruleset("rs274"))[0]
    check_finding(finding, naive.lines_of(source.text))
    with pytest.raises(AssertionError):
        check_finding(finding, ["(a"])
