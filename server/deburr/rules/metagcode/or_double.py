"""Two conditions for the same lines, one after the other.

That is how an "or" is written. But if both conditions hold, the lines are generated twice: a hole
is drilled twice, a tool is called twice. Conditions that exclude each other are not reported.

Source: spec/metagcode.md §5.3, §6

Bad:

    #IF1 |A| equalto 1 n
    M8
    #ENDIF1
    #IF1 |B| equalto 1 n
    ^^^^
    M8
    #ENDIF1

Good:

    #IF1 |Mat| equalto Steel a
    S800
    #ENDIF1
    #IF1 |Mat| equalto Iron a
    S800
    #ENDIF1
    #IF1 |Dia| lessthan 5 n
    M8
    #ENDIF1
    #IF1 |Dia| greaterthan 5.0 n
    M8
    #ENDIF1
    #IF1 |B| equalto 1 n
    M9
    #ENDIF1
"""

from collections.abc import Iterator, Sequence
from decimal import Decimal

from deburr.analysis import Analysis
from deburr.rule import Report, Severity, Whole, parted, rule
from deburr.rules.metagcode._gathered import Foreign, gathered, ready
from deburr.rules.metagcode._matching import Pair
from deburr_grammar.dialects.metagcode.forms import condition, is_numeric, name, number
from deburr_grammar.document import Document

_Test = tuple[str, bool, str, str | Decimal]
"""The name that is tested, whether as a number, the operator, the value."""


@rule(Severity.INFO, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report the second opener."""
    blocks, document = gathered(analysis), analysis.document
    ifs: dict[int, Pair] = {}

    def take(pairs: Sequence[Pair]) -> None:
        for pair in pairs:
            opener, closer = pair.opener.bracket, pair.closer.bracket
            if opener.kind == "if" and Foreign not in (type(opener), type(closer)):
                ifs[pair.opener.line] = pair

    def of(pairs: Sequence[Pair]) -> Iterator[Report]:
        for first in pairs:
            second = ifs.get(_next_line(document, first.closer.line))
            if second is not None and _alike(document, first, second) and not _exclusive(document, first, second):
                message = "the block before has the same lines; if both conditions hold, they are generated twice"
                yield Report(second.opener.bracket.span, message, second.opener.line, (blocks.note(first.opener),))

    yield from parted(blocks.pairs, take)
    yield from parted(ifs.values(), of)


def _next_line(document: Document, line: int) -> int:
    """The next line that is not blank; the number of lines if there is none."""
    later = range(line + 1, document.line_count)
    return next((each for each in later if document.line(each).strip()), document.line_count)


def _alike(document: Document, one: Pair, two: Pair) -> bool:
    """Whether two blocks hold the same lines, at least one of them not blank."""
    if one.closer.line - one.opener.line != two.closer.line - two.opener.line:
        return False
    lines = range(1, one.closer.line - one.opener.line)
    pairs = ((document.line(one.opener.line + at).strip(), document.line(two.opener.line + at).strip()) for at in lines)
    said = False
    for left, right in pairs:
        if left != right:
            return False
        said = said or left != ""
    return said


def _exclusive(document: Document, one: Pair, two: Pair) -> bool:
    """Whether the conditions are tests of one variable that never hold together."""
    left, right = _test(document, one.opener.line), _test(document, two.opener.line)
    if left is None or right is None or left[:2] != right[:2]:
        return False
    return _apart(left, right) or _apart(right, left)


def _apart(one: _Test, two: _Test) -> bool:
    first, second = one[3], two[3]
    if isinstance(first, str) or isinstance(second, str):
        same, less, more = first == second, str(first) < str(second), str(first) > str(second)
    else:
        same, less, more = first == second, first < second, first > second
    return {
        ("equalto", "equalto"): not same,
        ("equalto", "notequalto"): same,
        ("equalto", "greaterthan"): same or less,
        ("equalto", "lessthan"): same or more,
        ("lessthan", "greaterthan"): same or less,
    }.get((one[2], two[2]), False)


def _test(document: Document, line: int) -> _Test | None:
    """A condition that compares a variable with a value in the program."""
    node = document.node(line)
    form = next(node.find("condition"), None)
    if form is None:
        return None
    items = condition(form)
    left, operator, right, type_ = (node.text[item.start : item.end] for item in items)
    kinds = (items.left.kind, items.operator.kind, items.right.kind, items.type.kind)
    value = number(right) if is_numeric(type_) else right
    if kinds != ("VARIABLE", "OPERATOR", "LITERAL", "TYPE") or value is None:
        return None
    return name(left), is_numeric(type_), operator.lower(), value
