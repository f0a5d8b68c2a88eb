"""What lines of RS274 name: parameters, O-words, codes, words, functions (spec/rs274.md §3 to §6)."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from deburr.symbols import Act, Mention, Offer, Sort, Symbol
from deburr.symbols.index import region
from deburr.symbols.rs274_calls import arguments, called, takes, written
from deburr_grammar.codes import code_number
from deburr_grammar.dialects.rs274.outline import label_of
from deburr_grammar.text import Span
from deburr_grammar.tree import Node, Token, walk

if TYPE_CHECKING:
    from deburr.host import Host
    from deburr.ruleset import RuleSet
    from deburr_grammar.codes import Entry
    from deburr_grammar.dialect import Bracket
    from deburr_grammar.document import Document
    from deburr_grammar.line import LineNode

_BLANKS = re.compile(r"[ \t]+")
_PARTIAL = re.compile(r"#?<[^<>]*$|#[0-9]*$|[Oo]<[^<>]*$|[A-Za-z_]+[0-9.]*$|[Oo][0-9]*$")
__all__ = ["called", "takes", "written"]
SHARED = "shared by all subprograms"
SET = "only a run tells"
UNSET = "set nowhere here"
NAMING = frozenset(("param", "o_line", "O", "NAME_USED", "NUMBER_USED"))
_LISTED = 3
_SUFFIX = ".ngc"
_ARGUMENTS = 30
"""Parameters up to this number are a subprogram's own."""
_SUBS = {"SUB": Act.DEFINE, "ENDSUB": Act.SAY, "RETURN": Act.SAY, "CALL": Act.CALL}
_BLOCKS = ("IF", "ELSEIF", "ELSE", "ENDIF", "WHILE", "ENDWHILE", "DO", "REPEAT", "ENDREPEAT", "BREAK", "CONTINUE")
_OPENERS = ("IF", "WHILE", "DO", "REPEAT")


def names(document: Document) -> None:
    """A line says it all."""


def mentions(line: LineNode, names: object) -> Iterator[Mention]:
    """Parameters, the label and command of an O-word, codes and other words, functions."""
    yield from _o_word(line)
    for part in walk(line.tree):
        if isinstance(part, Token):
            yield from _token(line.text, part)
        elif part.kind == "param":
            yield from _param(line.text, part, Act.READ)
        elif part.kind == "word":
            yield from _word(line.text, part)


def file(symbol: Symbol, file: str, ruleset: RuleSet, host: Host) -> str | None:
    """The file of a called subprogram that the program does not define itself: `name.ngc` beside it or in a configured folder."""
    if symbol.sort is not Sort.SUB:
        return None
    folders = [file.rpartition("/")[0], *ruleset.settings.get("subroutine-path", ())]
    wanted = f"{symbol.name}{_SUFFIX}"
    for folder in folders:
        found = next((name for name in host.names(folder) if name.lower() == wanted), None)
        if found is not None:
            return f"{folder.rstrip('/')}/{found}"
    return None


def partial(before: str) -> int:
    """A parameter with its `#`, an O-word with its `o`, or letters and digits."""
    match = _PARTIAL.search(before)
    return match.start() if match else len(before)


def offers(expected: frozenset[str], before: str, partial: str) -> Iterator[Offer | str]:
    """By the terminals that can stand there."""
    if before.rstrip(" \t").endswith("("):
        yield "comment"
        return
    if "HASH" in expected:
        yield Offer.VARIABLES
        yield "variable"
    if "CALL" in expected:
        yield "keyword"
    if "FUNCTION" in expected:
        yield "function"
    if "COMPARE" in expected:
        yield "operator"
    if "O" in expected:
        yield Offer.ENDS
        yield Offer.SUBS
        yield Offer.FILES
    if "LETTER" in expected:
        yield "code"
        yield "word"


def files(file: str, ruleset: RuleSet, host: Host, before: str) -> Iterator[str]:
    """The subprogram files beside a program and in the configured folders."""
    for folder in (file.rpartition("/")[0], *ruleset.settings.get("subroutine-path", ())):
        for name in host.names(folder):
            if name.lower().endswith(_SUFFIX) and f"{folder.rstrip('/')}/{name}" != file:
                yield f"o<{name[: -len(_SUFFIX)].lower()}>"


def resumed(before: str) -> str:
    """The start of a line says how it is read."""
    return before


def end(opener: Bracket) -> str:
    """`o1 endif`; a `do` ends with a condition."""
    label = written(Symbol(Sort.LABEL, opener.label)) if opener.label is not None else ""
    return "" if not label else f"{label} while [" if opener.kind == "do" else f"{label} end{opener.kind}"


def spelled(entry: Entry) -> str:
    """Functions with their bracket, parameters with their `#`, active comments with what parts their name from the rest."""
    if entry.first is not None:
        return ""
    if entry.table == "comment":
        return (
            str(entry.more["signature"])
            .strip("()")
            .replace(" text", " ")
            .replace("file", "")
            .replace(" statement", " ")
        )
    if entry.table == "function":
        return f"{entry.name}["
    return f"#<{entry.name}>" if entry.table == "variable" else entry.name


def valid(symbol: Symbol, name: str) -> str:
    """A number stays a number, a name a name; a global name stays global."""
    number = re.fullmatch("[0-9]+", name) is not None
    was_number = re.fullmatch("[0-9]+", symbol.name) is not None
    if number != was_number or not name.strip() or re.search(r"[<>()\[\]#\r\n;]", name):
        return f"`{name}` is no {'number' if was_number else 'name'}"
    if symbol.sort is Sort.VARIABLE and was_number and (int(name) <= _ARGUMENTS) != symbol.local:
        return "parameters up to 30 are a subprogram's own, those above are shared"
    if symbol.sort is Sort.VARIABLE and not number and name.lstrip().startswith("_") == symbol.local:
        return "a name with `_` in front is shared by all subprograms, one without is a subprogram's own"
    return ""


def notes(document: Document, line: int, mention: Mention) -> Iterator[str]:
    """Of a subprogram's parameter: what the calls in the program give it."""
    symbol, inside = mention.symbol, region(document, line) if mention.symbol.local else None
    if symbol.sort is not Sort.VARIABLE or not symbol.name.isdigit() or inside is None or inside[1] is None:
        return
    given = list(arguments(document, inside[1], int(symbol.name)))
    more = f" and {len(given) - _LISTED} more" if len(given) > _LISTED else ""
    if given:
        yield f"given by calls: {', '.join(given[:_LISTED])}{more}"


def meant(document: Document, line: int, mention: Mention) -> None:
    """Nothing stands for anything else."""


def _param(text: str, node: Node, act: Act) -> Iterator[Mention]:
    name = node.children[1] if len(node.children) > 1 else None
    if isinstance(name, Token):
        yield from _parameter(text, Span(node.start, node.end), name, act)
    elif name is not None:
        # Which parameter it is only the run knows: it may be any that has a number.
        span = Span(node.start, node.end)
        yield Mention(Symbol(Sort.VARIABLE, ""), _act(text, span, act), span, span)


def _parameter(text: str, span: Span, name: Token, act: Act) -> Iterator[Mention]:
    said = _BLANKS.sub("", text[name.start : name.end]).lower()
    if name.kind == "NUMBER":
        if not said.isdigit():
            return
        number = str(int(said))
        symbol = Symbol(Sort.VARIABLE, number, int(number) <= _ARGUMENTS, "variable")
        yield Mention(symbol, _act(text, span, act), span, Span(name.start, name.end))
    elif name.kind == "NAME":
        bare = said.strip("<>")
        symbol = Symbol(Sort.VARIABLE, bare, not bare.startswith("_"), "variable")
        yield Mention(symbol, _act(text, span, act), span, Span(name.start + 1, name.end - 1))


def _act(text: str, span: Span, act: Act) -> Act:
    """A parameter before `=` is set."""
    return Act.SET if text[span.end :].lstrip(" \t").startswith("=") else act


def _token(text: str, token: Token) -> Iterator[Mention]:
    span = Span(token.start, token.end)
    said = _BLANKS.sub("", text[token.start : token.end])
    if token.kind in ("NAME_USED", "NUMBER_USED"):
        inner = Token("NAME" if token.kind == "NAME_USED" else "NUMBER", token.start + 1, token.end)
        yield from _parameter(text, span, inner, Act.READ)
    elif token.kind in ("FUNCTION", "ATAN", "EXISTS"):
        yield Mention(Symbol(Sort.FUNCTION, said.upper(), table="function"), Act.SAY, span, span)
    elif token.kind in _SUBS or token.kind in _BLOCKS:
        yield Mention(Symbol(Sort.KEYWORD, said.lower(), table="keyword"), Act.SAY, span, span)


def _word(text: str, word: Node) -> Iterator[Mention]:
    letter = text[word.start].upper()
    span = Span(word.start, word.end)
    if letter in "GM" and isinstance(word.children[1], Token):
        symbol = Symbol(Sort.CODE, code_number(text[word.start : word.end]), table="code")
        yield Mention(symbol, Act.SAY, span, span)
    else:
        only = Span(word.start, word.start + 1)
        yield Mention(Symbol(Sort.WORD, letter, table="word"), Act.SAY, only, only, passing=True)


def _o_word(line: LineNode) -> Iterator[Mention]:
    if not {"O", "label"} <= line.kinds:
        return
    # Of a faulty line the parts that were read stand directly in the tree.
    o_line = next(line.find("o_line"), line.tree)
    command = next((part.kind for part in o_line.children if part.kind in _SUBS or part.kind in _BLOCKS), None)
    label, letter = o_line.node("label"), o_line.find("O")
    name = label_of(line.text, label) if label is not None and letter is not None else None
    if command is None or label is None or letter is None:
        return
    if name is None:
        whole = Span(label.start, label.end)
        yield Mention(Symbol(Sort.SUB if command in _SUBS else Sort.LABEL, ""), Act.SAY, whole, whole)
        return
    only = label.children[0]
    inner = Span(only.start + 1, only.end - 1) if only.kind == "NAME" else Span(only.start, only.end)
    span = Span(letter.start, label.end)
    if command in _SUBS:
        yield Mention(Symbol(Sort.SUB, name), _SUBS[command], span, inner)
    else:
        act = Act.DEFINE if command in _OPENERS else Act.SAY
        yield Mention(Symbol(Sort.LABEL, name, True), act, span, inner)
