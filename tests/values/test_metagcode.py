"""MetaGCODE: what is proven of variables at each directive, and that it holds in runs (spec/metagcode.md §5)."""

import pytest

from deburr.finding import Severity
from deburr.steps import done
from deburr.values import proving, value_at
from deburr.values.metagcode import lines
from deburr.values.words import said as in_words
from deburr_grammar.dialects.metagcode.forms import Condition, condition
from deburr_grammar.tree import Node
from support.values import MAIN, analysed

NAMES = ("a", "b", "c", "d")
NUMBERS = ("0", "1", "2", "-1", "-3", "0.5", "5", "10", ".3", "-0.0", "7.25", "5.00", "1e3", "Steel", "Brass", "")
LITERALS = ("0", "1", "2", "-1", "5", "10", "0.3", "-2.5", "Steel", "Brass")
OPERATORS = ("greaterthan", "lessthan", "equalto", "notequalto")

SILENT = {
    "a variable of which nothing is known": "#LOOP1 |z| |s| c\nG1 Z-|z|\n#ENDLOOP1\n",
    "behind the condition": "#IF1 |z| lessthan 0 n\nG0 Z5\n#ENDIF1\nG1 Z-|z|\n",
    "the bound itself": "#IF1 |z| lessthan 5 n\n#IF2 |z| equalto 5 n\n#ENDIF2\n#ENDIF1\n",
    "a text that is a number in another spelling": "#IF1 |z| equalto 5.0 a\n#IF2 |z| greaterthan |y| n\nG0\n#ENDIF2\n#ENDIF1\n",
    "a text that may still be another one": "#IF1 |m| notequalto Steel a\n#IF2 |m| equalto Brass a\nG0\n#ENDIF2\n#ENDIF1\n",
    "a text behind another one": "#IF1 |m| greaterthan Brass a\n#IF2 |m| equalto Steel a\nG0\n#ENDIF2\n#ENDIF1\n",
    "a text in another case": "#IF1 |m| greaterthan Steel a\n#IF2 |m| equalto steel a\nG0\n#ENDIF2\n#ENDIF1\n",
    "behind the condition on a text": "#IF1 |m| equalto Steel a\nG0\n#ENDIF1\n#IF2 |m| equalto Brass a\nG0\n#ENDIF2\n",
    "two variables, one of which is counted now": "#IF1 |z| lessthan |y| n\n#LOOP1 |y| 2 c\n#IF2 |z| lessthan |y| n\nG1 Z|y|\n#ENDIF2\n#ENDLOOP1\n#ENDIF1\n",
    "two variables, of which one was counted": "#LOOP1 |y| 2 c\n#IF1 |z| lessthan |y| n\nG1 Z|y|\n#ENDIF1\n#ENDLOOP1\n#IF2 |z| lessthan |y| n\nG0\n#ENDIF2\n",
    "two variables as numbers and then as texts": "#IF1 |z| lessthan |y| n\n#IF2 |z| lessthan |y| a\nG0\n#ENDIF2\n#ENDIF1\n",
    "a switch that stands in the line": "#IF1 1 equalto 0 n\nM0\n#ENDIF1\n#IF2 1 equalto 1 n\nM1\n#ENDIF2\n",
    "a bound beyond a bound": "#IF1 |z| greaterthan 5 n\n#IF2 |z| greaterthan 10 n\nG0\n#ENDIF2\n#ENDIF1\n",
    "behind a loop over it": "#IF1 |z| greaterthan 9 n\n#LOOP1 |z| 2 c\nG1 Z|z|\n#ENDLOOP1\n#IF2 |z| lessthan 11 n\nG0\n#ENDIF2\n#ENDIF1\n",
    "in a loop over it": "#IF1 |z| greaterthan 9 n\n#LOOP1 |z| 2 c\n#IF2 |z| lessthan 5 n\nG1 Z|z|\n#ENDIF2\n#ENDLOOP1\n#ENDIF1\n",
    "a sign in a comment": "#IF1 |z| lessthan 0 n\n(down to -|z|)\n#ENDIF1\n",
    "a snippet that nobody has": "#IF1 |z| equalto 0 n\n#FILE gone.txt\n#LOOP1 |d| |z| c\nG1 Z|d|\n#ENDLOOP1\n#ENDIF1\n",
}  # fmt: skip


@pytest.mark.parametrize("name", SILENT)
def test_nothing_is_said_of_what_is_not_proven(name: str) -> None:
    assert [each for each in proving(analysed(SILENT[name], "metagcode")) if each is not None] == []


ALWAYS = "condition-constant", "always holds"
NEVER = "if-contradiction", "contradicts"
ITSELF = "condition-constant", "itself"
DECIDED = {
    "a text that is another one": ("|m| equalto Steel a", "|m| equalto Brass a", *NEVER),
    "a text that is that one": ("|m| equalto Steel a", "|m| equalto Steel a", *ALWAYS),
    "a text that is not that one": ("|m| notequalto Steel a", "|m| equalto Steel a", *NEVER),
    "a text that is no other one": ("|m| equalto Steel a", "|m| notequalto Brass a", *ALWAYS),
    "a text behind the one before it": ("|m| greaterthan Steel a", "|m| equalto Brass a", *NEVER),
    "a text before the one behind it": ("|m| lessthan Brass a", "|m| lessthan Steel a", *ALWAYS),
    "a text with the sides exchanged": ("Steel equalto |m| a", "Brass equalto |m| a", *NEVER),
    "a text that is a number in another spelling": ("|z| equalto 5.0 a", "|z| equalto 5 n", *ALWAYS),
    "a bound within a bound": ("|z| greaterthan 5 n", "|z| greaterthan 3 n", *ALWAYS),
    "two variables turned round": ("|z| lessthan |y| n", "|y| lessthan |z| n", *NEVER),
    "two variables once more": ("|z| lessthan |y| n", "|y| greaterthan |z| n", *ALWAYS),
    "two variables that differ": ("|z| lessthan |y| n", "|y| equalto |z| n", *NEVER),
    "two texts that are the same": ("|z| equalto |y| a", "|y| notequalto |z| a", *NEVER),
    "a variable and itself": ("|z| greaterthan 5 n", "|y| lessthan |y| n", *ITSELF),
    "a text and itself": ("|z| greaterthan 5 n", "|y| notequalto |y| a", *ITSELF),
}
"""A condition, one inside of it, the rule that speaks of that, and how."""


@pytest.mark.parametrize("name", DECIDED)
def test_a_condition_that_others_decide_is_found(name: str) -> None:
    outer, inner, rule, how = DECIDED[name]
    text = f"#IF1 {outer}\n#IF2 {inner}\nG0 X1\n#ENDIF2\n#ENDIF1\n"
    (found,) = (each for each in proving(analysed(text, "metagcode")) if each is not None)
    assert (found.rule, found.place.line) == (f"metagcode.{rule}", 1)
    assert how in found.message
    assert found.severity is (Severity.INFO if how == ALWAYS[1] else Severity.WARNING)


@pytest.mark.parametrize(
    ("outer", "inner", "why"),
    [
        ("|m| equalto Steel a", "|m| equalto Brass a", "`|m|` is `Steel`"),
        ("|m| notequalto Steel a", "|m| equalto Steel a", "`|m|` is not `Steel`"),
        ("|m| greaterthan Steel a", "|m| lessthan Brass a", "`|m|` is greater than `Steel`"),
        ("|m| lessthan Brass a", "|m| greaterthan Steel a", "`|m|` is less than `Brass`"),
        ("|a| lessthan |b| n", "|a| equalto |b| n", "`|a|` is less than `|b|`"),
    ],
)
def test_the_chain_tells_texts_and_orders(outer: str, inner: str, why: str) -> None:
    text = f"#IF1 {outer}\n#IF2 {inner}\nG0 X1\n#ENDIF2\n#ENDIF1\n"
    (found,) = (each for each in proving(analysed(text, "metagcode")) if each is not None)
    assert (0, f"from here on {why}") in [(each.place.line, each.message) for each in found.related]


def test_what_two_variables_are_to_each_other_holds_again_behind_a_loop() -> None:
    text = "#IF1 |a| lessthan |b| n\n#LOOP1 |b| 2 c\nG1 Z|b|\n#ENDLOOP1\n#IF2 |a| greaterthan |b| n\nG0\n#ENDIF2\n#ENDIF1\n"
    (found,) = (each for each in proving(analysed(text, "metagcode")) if each is not None)
    assert (found.rule, found.place.line) == ("metagcode.if-contradiction", 4)


def test_the_longest_of_several_counters_is_too_long() -> None:
    text = "#IF1 |x| greaterthan 10000 n\n#LOOP1 |y| 5 c |x| 0.01 c\nG1 X|x| Y|y|\n#ENDLOOP1\n#ENDIF1\n"
    (found,) = (each for each in proving(analysed(text, "metagcode")) if each is not None)
    assert (found.rule, found.place.line, found.place.col) == ("metagcode.limit", 1, 15)


SNIPPET = {"Snippets/cut.txt": "#LOOP1 |d| |s| c\nG1 Z|d|\n#ENDLOOP1\n"}
INCLUDED = "#IF1 |s| equalto 0 n\n#FILE cut.txt\n#ENDIF1\n"


def test_a_fault_in_a_snippet_is_found_from_the_text_that_puts_it_in() -> None:
    found = [each for each in proving(analysed(INCLUDED, "metagcode", SNIPPET)) if each is not None]
    assert [(each.rule, *each.place) for each in found] == [
        ("metagcode.loop-step-zero", "Snippets/cut.txt", 0, 11, 0, 14)
    ]
    assert [(each.place.file, each.place.line) for each in found[0].related] == [(MAIN, 0)]


def test_a_snippet_that_is_right_at_one_place_is_not_wrong() -> None:
    both = f"{INCLUDED}#FILE cut.txt\n"
    assert [each for each in proving(analysed(both, "metagcode", SNIPPET)) if each is not None] == []


def test_a_snippet_may_ask_what_its_text_has_decided() -> None:
    files = {"Snippets/guard.txt": "#IF1 |d| lessthan 5 n\nG1\n#ENDIF1\n"}
    program = "#IF1 |d| greaterthan 10 n\n#FILE guard.txt\n#ENDIF1\n"
    assert [each for each in proving(analysed(program, "metagcode", files)) if each is not None] == []


@pytest.mark.parametrize(
    ("row", "said"),
    [(0, None), (1, None), (2, "at least 5"), (3, "at least 5"), (4, "at least 5"), (5, None), (8, None)],
)
def test_lines_between_those_that_ask_hold_what_comes_to_them(row: int, said: str | None) -> None:
    files = {"Snippets/open.txt": "#IF1 |d| greaterthan 5 n\n"}
    text = "G1 X|d|\n#FILE open.txt\nG1 X|d|\nG1 X-|d|\n#ENDIF1\nG1 X|d|\n#IF2 |e| equalto 1 n\n#ENDIF2\nG1 X|d|\n"
    found = value_at(analysed(text, "metagcode", files), row, "|d|", False)
    assert (None if found is None else in_words(found)) == said


def test_what_a_condition_compares_is_asked_once_a_shape(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[str] = []

    def asking(part: Node) -> Condition:
        asked.append(part.kind)
        return condition(part)

    monkeypatch.setattr(lines, "condition", asking)
    text = "".join(f"#IF{n} |a{n}| equalto {n} {n % 2 and 'numeric' or 'alpha'}\nG1\n#ENDIF{n}\n" for n in range(200))
    taken = done(lines.taken(analysed(text, "metagcode")))
    openers = [line for line in taken.lines if line.node.text.startswith("#IF")]
    assert [line.compares_texts for line in openers] == [True, False] * 100
    assert len(asked) < 20
