"""Programs laid out in tests, and programs whose layout is spoilt."""

from random import Random

from deburr.formatting.program import applied, formatted
from deburr.formatting.style import Style
from deburr_grammar.dialects import by_name
from deburr_grammar.document import Document

PLAIN = Style()
CANONICAL = Style("\t", canonical=True)
STYLES = (PLAIN, CANONICAL)


def laid_out(text: str, dialect: str, style: Style = PLAIN, first: int = 0, last: int | None = None) -> str:
    """A text after the edits of its lines from one to another."""
    document = Document.parse(text, by_name(dialect), 64)
    return applied(text, (edit for found in formatted(document, style, first, last) for edit in found))


def spoilt(rng: Random, text: str) -> str:
    """A text with blanks taken out, doubled and put in anywhere, and letters in the other case."""
    rate, found = rng.choice((0.01, 0.05, 0.2)), list[str]()
    for char in text:
        chance = rng.random()
        if char in " \t":
            found.append("" if chance < 0.2 else "  " if chance < 0.3 else char)
        else:
            blanks = rng.choice((" ", "  ", "\t")) if chance < rate else ""
            found.append(blanks + (char.swapcase() if rng.random() < 0.02 else char))
    return "".join(found)
