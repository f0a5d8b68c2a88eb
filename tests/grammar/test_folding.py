"""One parse serves all lines of a shape: trees and problems rebuilt from a shape are those that Lark gives for the line itself."""

import random
import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from deburr_grammar.dialect import Dialect
from deburr_grammar.dialects import NAMES, by_name
from deburr_grammar.line import LineNode, shapes_of
from deburr_grammar.shape import Folding
from deburr_grammar.tree import Node, tokens, walk
from support import naive
from support.alphabets import alphabet, pieces
from support.strategies import steady, texts

EXAMPLES = Path(__file__).parents[2] / "examples"
LINUXCNC = Path("/usr/share/linuxcnc/ncfiles")


def check_lines(dialect: Dialect, lines: set[str]) -> None:
    """Every line under every reading: tree and problems as in a direct parse, spans sound."""
    for line in lines:
        shape = shapes_of(dialect)[dialect.folding.fold(line)]
        for reading in dialect.readings:
            node = LineNode(line, reading, shape)
            tree, problems = naive.read_directly(dialect, reading.start, line)
            assert node.tree == tree, line
            assert node.problems == problems, line
            check_spans(node)


def check_spans(node: LineNode) -> None:
    """Parts stand in order inside their whole, no token and no problem is empty, and a clean tree leaves out blanks alone."""
    at, size = 0, len(node.text)
    for part in walk(node.tree):
        assert 0 <= part.start <= part.end <= size, node
        if isinstance(part, Node) and part.children:
            assert (part.start, part.end) == (part.children[0].start, part.children[-1].end)
    gaps = []
    for token in tokens(node.tree):
        assert token.start < token.end, node
        assert at <= token.start, node
        gaps.append(node.text[at : token.start])
        at = token.end
    assert all(0 <= problem.start < problem.end <= max(size, 1) for problem in node.problems), (node, node.problems)
    if node.reading.start is not None and not node.problems:
        # At the end of a line a control may strip more than blanks.
        left_out = "".join([*gaps, node.text[at:].rstrip(" \t\f\v")])
        assert not left_out.strip(node.dialect.blanks), node


@pytest.mark.parametrize("name", NAMES)
def test_typical_lines_are_read_as_lark_reads_them(name: str) -> None:
    dialect = by_name(name)
    own = alphabet(dialect)
    check_lines(
        dialect,
        {*own.lines, *own.signs, *(line + sign for line in own.lines for sign in own.signs[:6])} - _ends(own.signs),
    )


@pytest.mark.parametrize("name", NAMES)
def test_random_lines_are_read_as_lark_reads_them(name: str) -> None:
    dialect = by_name(name)

    @steady(200)
    @given(texts(dialect, 12))
    def read(text: str) -> None:
        check_lines(dialect, set(naive.lines_of(text)))

    read()


@pytest.mark.parametrize("name", NAMES)
def test_lines_with_signs_exchanged_are_read_as_lark_reads_them(name: str) -> None:
    """Real lines, one character swapped for another: faults in all places."""
    dialect, rng = by_name(name), random.Random(7)
    own = alphabet(dialect)
    stock = "".join(own.lines) + "".join(own.signs)
    for line in own.lines:
        for _ in range(8):
            at = rng.randrange(len(line) + 1)
            check_lines(dialect, {naive.lines_of(line[:at] + rng.choice(stock) + line[at + rng.randrange(2) :])[0]})


@pytest.mark.parametrize("name", NAMES)
def test_example_programs_are_read_as_lark_reads_them(name: str) -> None:
    for path in sorted((EXAMPLES / name).rglob("*")):
        if path.is_file():
            check_lines(by_name(name), set(naive.lines_of(path.read_text(encoding="utf-8", errors="replace"))))


@pytest.mark.oracle
@pytest.mark.skipif(not LINUXCNC.is_dir(), reason="LinuxCNC's sample programs are not installed")
def test_linuxcnc_programs_are_read_as_lark_reads_them() -> None:
    lines = {
        line for path in sorted(LINUXCNC.rglob("*.ngc")) for line in naive.lines_of(path.read_text(encoding="latin-1"))
    }
    shapes: dict[str, list[str]] = {}
    dialect = by_name("rs274")
    for line in sorted(lines):
        shapes.setdefault(dialect.folding.fold(line), []).append(line)
    check_lines(dialect, {line for same in shapes.values() for line in (min(same, key=len), max(same, key=len))})
    assert len(shapes) > 2_000


@pytest.mark.parametrize("name", NAMES)
def test_folding_many_lines_folds_each(name: str) -> None:
    dialect = by_name(name)

    @steady(120)
    @given(texts(dialect, 30))
    def fold(text: str) -> None:
        lines = naive.lines_of(text)
        assert dialect.folding.fold("\n".join(lines)).split("\n") == [dialect.folding.fold(line) for line in lines]

    fold()


def test_numbers_of_codes_are_kept_as_they_are_written() -> None:
    """Looked at one by one: behind the letter, with blanks between the digits and one point."""
    folding = Folding(codes="Gm")
    number = re.compile(r"([Gm][ \t]*[0-9][0-9 \t]*(?:\.[0-9 \t]*)?)|[0-9]+")

    @steady(400)
    @given(st.text("GmX012. \t\n\u00e9", max_size=30))
    def fold(text: str) -> None:
        assert folding.fold(text) == number.sub(lambda match: match[1] or "0", text)

    fold()
    assert folding.fold("N12 G17 X1.25 m 3 0 Y45 G38. 2 0G5") == "N0 G17 X0.0 m 3 0 Y0 G38. 2 0G5"
    assert folding.fold("N12 G2 1 X25") == "N0 G2 1 X0"


@pytest.mark.parametrize("name", NAMES)
def test_columns_lead_from_a_shape_to_the_same_signs(name: str) -> None:
    dialect = by_name(name)

    @steady(120)
    @given(texts(dialect, 12))
    def align(text: str) -> None:
        for line in naive.lines_of(text):
            check_columns(dialect, line)

    align()


def check_columns(dialect: Dialect, line: str) -> None:
    """A sign of a shape is the same sign in the line, or a zero that stands for digits; what is left out is folded text."""
    shape, columns = dialect.folding.fold(line), dialect.folding.columns(line)
    assert (columns(0), columns(len(shape))) == (0, len(line)) if shape else not line
    for col, sign in enumerate(shape):
        said = line[columns(col) : columns(col + 1)]
        if sign != "0":
            assert said.startswith(sign), (line, shape, col)
        assert said, (line, shape, col)
        if sign == "0" and len(said) > 1:
            digits = said.rstrip().lstrip("0123456789")
            assert not digits or not digits[0].isascii() or not digits[0].isdigit(), (line, shape, col)
    assert dialect.folding.fold(shape) == shape, line


@pytest.mark.parametrize("name", NAMES)
def test_equal_shapes_have_equal_terminals(name: str) -> None:
    """Digits of other values and lengths, where nothing protects them, never change what a line is."""
    dialect, rng = by_name(name), random.Random(11)
    for line in _lines(dialect, rng):
        shape = dialect.folding.fold(line)
        other = "".join(rng.choice(("4", "55", "000", "9" * 12)) if sign == "0" else sign for sign in shape)
        if dialect.folding.fold(other) != shape:
            continue
        for reading in dialect.readings:
            assert _kinds(dialect, reading.start, line) == _kinds(dialect, reading.start, other), (line, other)


def _kinds(dialect: Dialect, start: str | None, line: str) -> list[str]:
    tree, problems = naive.read_directly(dialect, start, line)
    return [part.kind for part in walk(tree)] + [problem.kind for problem in problems]


def _lines(dialect: Dialect, rng: random.Random) -> Iterator[str]:
    yield from alphabet(dialect).lines
    for _ in range(400):
        yield from naive.lines_of("".join(rng.choices(pieces(dialect), k=4)))


def _ends(signs: tuple[str, ...]) -> set[str]:
    return {sign for sign in signs if "\n" in sign or "\r" in sign}


@pytest.mark.parametrize("name", NAMES)
def test_letters_and_digits_that_are_not_ascii_are_none(name: str) -> None:
    """A kelvin sign matches `k` and a long s `s` where case is ignored, unless a grammar is told otherwise: only free text takes them."""
    dialect = by_name(name)
    lark = dialect.grammar.build()
    terminals = {each.name: re.compile(each.pattern.to_regexp(), lark.options.g_regex_flags) for each in lark.terminals}
    for line in alphabet(dialect).lines:
        for sign, plain in (("\u212a", "K"), ("\u017f", "S"), ("\u0130", "I"), ("\u0131", "I"), ("\u0663", "3")):
            wrong = line.upper().replace(plain, sign)
            for reading in dialect.readings:
                for token in tokens(naive.read_directly(dialect, reading.start, wrong)[0]):
                    said = wrong[token.start : token.end]
                    assert sign not in said or terminals[token.kind].fullmatch(said.replace(sign, "\u00e9")), (
                        wrong,
                        token,
                    )
