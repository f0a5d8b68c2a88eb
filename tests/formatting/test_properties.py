"""Whatever a text holds: laying it out changes no token, no structure, no flat program, no line that has a fault, and a second time nothing at all."""

import re
from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import partial
from random import Random
from unittest import mock

import pytest
from hypothesis import given
from hypothesis import strategies as st

from deburr.formatting.program import applied, formatted
from deburr_grammar.dialect import Dialect
from deburr_grammar.dialects import NAMES, by_name
from deburr_grammar.document import Document
from deburr_grammar.layout import Between, Gap, Layout
from deburr_grammar.text import split_lines
from deburr_grammar.tree import Token, tokens
from support.alphabets import alphabet
from support.cases import cases, expanded
from support.code import ROOT
from support.formatting import PLAIN, STYLES, laid_out, spoilt
from support.strategies import steady, texts

DATA = (".vars", ".json", ".jsonl", ".cl", ".toml", ".tbl", ".var")
"""Files beside a program that are none themselves."""
ENDLESS = re.compile("endless|limit|steps|blocks|too_many|calls_3")
"""Cases that run to a limit: their layout matters no more than that of others."""


def read(dialect: Dialect, text: str) -> list[tuple[object, ...]]:
    """What each line says, parsed by itself: no shape is asked."""
    document = Document.parse(text, dialect)
    brackets: dict[int, list[object]] = {}
    for line, bracket in document.brackets():
        brackets.setdefault(line, []).append((bracket.role, bracket.kind, bracket.word, bracket.label))
    found = list[tuple[object, ...]]()
    for line, node in enumerate(document.nodes()):
        said: object = node.text
        if node.reading.start is not None and not node.problems:
            parsed = dialect.grammar.parse(node.reading.start, node.text)
            said = [(token.kind, _text(token, node.text)) for token in tokens(parsed.tree)]
        found.append((node.reading.name, said, brackets.get(line, [])))
    return found


def _text(token: Token, text: str) -> str:
    """A token's text; blanks at the end of a line are nobody's."""
    said = text[token.start : token.end]
    return said if text[token.end :].strip(" \t") else said.rstrip(" \t")


@pytest.mark.parametrize("name", NAMES)
def test_nothing_is_said_otherwise(name: str) -> None:
    dialect = by_name(name)

    @steady(150)
    @given(texts(dialect))
    def check(text: str) -> None:
        new = laid_out(text, name)
        assert read(dialect, new) == read(dialect, text)
        assert laid_out(new, name) == new
        canonical = laid_out(text, name, STYLES[1])
        assert laid_out(canonical, name, STYLES[1]) == canonical
        assert [kinds for kinds, *_ in read(dialect, canonical)] == [kinds for kinds, *_ in read(dialect, text)]

    check()


@pytest.mark.parametrize("name", NAMES)
def test_some_lines_are_laid_out_as_all_of_them_are_and_no_others(name: str) -> None:
    @steady(60)
    @given(texts(by_name(name)), st.integers(0, 8), st.integers(0, 8))
    def check(text: str, first: int, more: int) -> None:
        old, whole, some = (
            split_lines(each)
            for each in (text, laid_out(text, name), laid_out(text, name, first=first, last=first + more))
        )
        stop = first + more + 1
        assert some == old[:first] + whole[first:stop] + old[stop:]

    check()


def squeezed(lines: list[str]) -> list[str]:
    """Flat lines without blanks outside comments, and in capital letters."""
    parts = (re.split(r"(\([^()]*\))", line) for line in lines)
    return [
        "".join(re.sub(r"[ \t]", "", part).upper() if at % 2 == 0 else part for at, part in enumerate(each))
        for each in parts
    ]


def programs(files: Mapping[str, str], change: Callable[[str], str]) -> dict[str, str]:
    """Files, those that are programs changed."""
    return {file: text if file.endswith(DATA) else change(text) for file, text in files.items()}


@pytest.mark.parametrize("name", NAMES)
def test_flat_programs_stay_the_same_to_the_byte(name: str) -> None:
    """The expansion cases, and each of them with its layout spoilt. RS274 has the blanks of a flat line from its source, and no control cares."""
    changed = flat = 0
    for case in cases(name):
        for number in range(1 if ENDLESS.search(case.name) else 3):
            spoil = partial(spoilt, Random(f"{case.name} {number}")) if number else str
            files = programs(case.files, spoil)
            new = programs(files, partial(laid_out, dialect=name, style=STYLES[number % 2]))
            before, after = (expanded(replace(case, files=each)) for each in (files, new))
            same = squeezed if name == "rs274" else list
            assert same(after.lines) == same(before.lines), (case.name, number)
            assert [(each.kind, each.line) for each in after.faults] == [
                (each.kind, each.line) for each in before.faults
            ]
            changed, flat = changed + (new != files), flat + len(before.lines)
    assert changed > 30
    assert flat > 100


@pytest.mark.parametrize("name", NAMES)
def test_examples_are_laid_out(name: str) -> None:
    found = [
        path for extension in by_name(name).extensions for path in (ROOT / "examples" / name).glob(f"*{extension}")
    ]
    assert len(found) > 1
    for path in found:
        text = path.read_text(encoding="utf-8")
        assert laid_out(text, name) == text, path.name


def reckless(rng: Random) -> Layout:
    """A layout that knows nothing of its language."""
    chosen: dict[tuple[str, str], Gap] = {}
    everything = frozenset(("line", "template", "header", "table", "text", "TEXT", "advanced", "word"))

    def gap(between: Between) -> Gap:
        return chosen.setdefault((between.left.kind, between.right.kind), rng.choice(list(Gap)))

    return Layout(gap, indented=everything, trimmed=everything, empties=True, inside=lambda state: rng.randint(0, 3))


@pytest.mark.parametrize("name", NAMES)
def test_a_wrong_layout_changes_no_token_either(name: str) -> None:
    """The proof, not the choices of a dialect, keeps programs what they are."""
    plain = by_name(name)
    changed = refused = 0
    for seed in range(40):
        rng = Random(seed)
        dialect = replace(plain)
        vars(dialect)["layout"] = reckless(rng)
        text = "\n".join(rng.choices(alphabet(plain).lines, k=40))
        document = Document.parse(text, dialect, 64)
        new = applied(text, [edit for found in formatted(document, PLAIN) for edit in found])
        assert read(plain, new) == read(plain, text)
        changed += new != text
        with mock.patch("deburr.formatting.program.says_the_same", lambda *_: True):
            unproven = applied(text, [edit for found in formatted(document, PLAIN) for edit in found])
        refused += read(plain, unproven) != read(plain, text)
    assert changed > 20
    assert refused
