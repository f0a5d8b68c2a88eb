"""What is indented as it is typed."""

import pytest

from deburr.formatting.style import Style
from deburr.ide.formatting import formatting, typed
from deburr.lsp.capabilities import capabilities
from deburr.lsp.client import Client
from deburr_grammar.dialect import Role
from deburr_grammar.dialects import NAMES, by_name
from deburr_grammar.document import Document
from support.alphabets import alphabet
from support.views import at_cursor

FOUR = Style("    ")


def check(name: str, text: str, char: str, expected: str) -> None:
    """Type a character that stands before the cursor already."""
    view, pos = at_cursor(name, text)
    edits = typed(view, FOUR, pos, char)
    assert view.document.edit(*reversed(edits)).text == expected


@pytest.mark.parametrize(
    ("name", "text", "expected"),
    [
        # Behind an opener the next line is deeper, also while nothing closes the block.
        ("rs274", "o1 if [1]\n<|>", "o1 if [1]\n    "),
        ("rs274", "o1 if [1]\n  <|>\no1 endif\n", "o1 if [1]\n    \no1 endif\n"),
        ("rs274", "o1 if [1]\no2 do\nG0X1\n<|>", "o1 if [1]\no2 do\n        G0X1\n        "),
        ("rs274", "o1 if [1]\n   o1 endif\n   <|>", "o1 if [1]\no1 endif\n"),
        ("rs274", "o<s> sub\n<|>G0 X1\no<s> endsub\n", "o<s> sub\n    G0 X1\no<s> endsub\n"),
        # A line that was left blank is emptied.
        ("rs274", "o1 if [1]\n    \n<|>", "o1 if [1]\n\n    "),
        # Only directives are indented; other lines are printed as they are.
        ("metagcode", "#LOOP1 |Z| 1 c\n<|>", "#LOOP1 |Z| 1 c\n"),
        ("metagcode", "#LOOP1 |Z| 1 c\n#FILE a\n<|>", "#LOOP1 |Z| 1 c\n    #FILE a\n"),
        ("cgt", "@LINE\n#IF(#V1=1)<\n<|>", "@LINE\n#IF(#V1=1)<\n"),
        ("z32", "!IF HA>1;\n  <|>", "!IF HA>1;\n  "),
        # Lines with faults, lines that nobody reads, lines that are to be left.
        ("rs274", "o1 if [1]\nG0 X1 &\n<|>", "o1 if [1]\nG0 X1 &\n    "),
        ("rs274", "M2\no1 if\n<|>", "M2\no1 if\n"),
        ("rs274", "o1 if [1]\n(deburr: format off)\nG0\n<|>", "o1 if [1]\n(deburr: format off)\nG0\n"),
        ("rs274", "<|>", ""),
    ],
)
def test_behind_a_line_end(name: str, text: str, expected: str) -> None:
    check(name, text, "\n", expected)


@pytest.mark.parametrize(
    ("name", "text", "expected"),
    [
        ("rs274", "o1 if [1]\n    o1 endif<|>", "o1 if [1]\no1 endif"),
        ("rs274", "o1 if [1]\n    o1 else<|>\n", "o1 if [1]\no1 else\n"),
        ("rs274", "o<s> sub\n    o<s> endsub<|>", "o<s> sub\no<s> endsub"),
        ("metagcode", "#LOOP1 |Z| 1 c\n    #ENDLOOP<|>", "#LOOP1 |Z| 1 c\n#ENDLOOP"),
        # Not where the cursor stands elsewhere, nor behind any other letter.
        ("rs274", "o1 if [1]\n    o1 endif (f<|>)", "o1 if [1]\n    o1 endif (f)"),
        ("rs274", "o1 if [1]\nG0 F<|>", "o1 if [1]\nG0 F"),
    ],
)
def test_behind_the_word_that_ends_or_parts_a_block(name: str, text: str, expected: str) -> None:
    check(name, text, "f", expected)


@pytest.mark.parametrize("name", NAMES)
def test_each_word_that_ends_a_block_ends_in_a_letter_on_which_the_client_asks(name: str) -> None:
    provider = capabilities(Client())["documentOnTypeFormattingProvider"]
    letters = set(provider["moreTriggerCharacter"])
    document = Document.parse("\n".join(alphabet(by_name(name)).lines), by_name(name))
    parted = by_name(name).layout.parted
    words = {
        bracket.word
        for _, bracket in document.brackets()
        if bracket.role in (Role.CLOSE, Role.END_REGION) or (bracket.role is Role.MIDDLE and bracket.kind in parted)
    }
    assert {
        word for word in words if word[-1].isalpha() and not {word[-1].lower(), word[-1].upper()} <= letters
    } == set()


def test_stretches_that_overlap_are_laid_out_once() -> None:
    view, _ = at_cursor("rs274", "g0x1\n" * 9 + "<|>")
    found = [edit.start.line for edits in formatting(view, FOUR, [(4, 6), (1, 2), (5, 7), (2, 2)]) for edit in edits]
    assert found == [1, 2, 4, 5, 6, 7]
