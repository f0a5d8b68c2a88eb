"""Words in an advanced line.

No movement can be programmed between `!` and `!`. `X=10` only stores the value; a move is a
block of its own.

Source: spec/z32.md §6.2

Bad:

    !G0 X1!
     ^^^^^
    !X10!
     ^^^
    !IF HA>1; Y<HA>; EB! HA=2!
              ^^^^^

Good:

    !X=10!
    G0 X<X>
"""

from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule, whole
from deburr.rules.z32._fields import groups, trailing_block
from deburr.rules.z32._words import instruction_for
from deburr_grammar.tree import Node

_LETTERS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"


@rule(Severity.ERROR, Nodes(("advanced",)))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the words."""
    trailing = trailing_block(node)
    for field in (field for group in groups(node) for field in group):
        if field.kind == "movement" and field is not trailing:
            said = line.said(field)
            letters = said[: len(said) - len(said.lstrip(_LETTERS))]
            way_out = instruction_for(letters) or _stored(line, field)
            yield Report(whole(field), f"`{said}` cannot stand in an advanced line, which moves nothing; {way_out}")


def _stored(line: Line, field: Node) -> str:
    """How the value of a single word is stored."""
    word = field.children[0]
    if (
        len(field.children) > 1
        or not isinstance(word, Node)
        or word.kind != "word"
        or line.said(word.children[0]).upper() in ("M", "T")
    ):
        return "words need a block of their own"
    value = line.said(word.children[1])
    said = value[1:-1] if value.startswith("<") else value
    return f"`{line.said(word.children[0])}={said}` stores the value, a block of its own moves"
