"""What lines of Z32 name: parameters, block numbers, sections, called programs and files, codes, functions (spec/z32.md §3 to §6)."""

from __future__ import annotations

import re
from collections.abc import Container, Iterator
from typing import TYPE_CHECKING

from deburr.includes import z32 as stores
from deburr.symbols import Act, Meant, Mention, Offer, Sort, Symbol, Takes
from deburr_grammar.codes import code_number
from deburr_grammar.text import Span
from deburr_grammar.tree import Node, Token, walk

if TYPE_CHECKING:
    from deburr.host import Host
    from deburr.ruleset import RuleSet
    from deburr_grammar.codes import Entry
    from deburr_grammar.dialect import Bracket
    from deburr_grammar.document import Document
    from deburr_grammar.line import LineNode

_SEQUENCE = re.compile(r"(?i)(?:(?<=go[nps])|(?<=-n))[0-9]*$")
_INDEX = re.compile(r"(?i)pa[lr]\[[0-9]*$")
_CALLED = re.compile(r"(?i):[ \t]*l254[ \t]*-[ \t]*([^!;]*)$")
_TEMPORARY = re.compile(r"(?i)gos[ \t]*[0-9]*$")
_FIELDS = re.compile(r"([ \t]*/?[ \t]*(?:[Nn][ \t]*[0-9.,]+[ \t]*)?)!.*[;!][ \t]*")
_PARTIAL = re.compile(r"[A-Za-z]+[0-9]*$|[0-9]+$")
SHARED = "shared with called programs"
SET = "only a run tells"
UNSET = "set nowhere here"
NAMING = frozenset(
    (
        "nword",
        "jump",
        "range_end",
        "call",
        "SECTION",
        "PATH",
        "vector",
        "assign",
        "angle",
        "ALIAS_NAME",
        "OTHER",
        "NAME",
    )
)
_ALIASES = ("AA", "AB", "AC")
_FAR = 20_000
_FIELD_WORDS = ("IF", "EB", "CP", "PC", "GON", "GOP", "GOS", "L254")
_KEYWORDS = {"IF", "EB", "CP", "PC", "GON", "GOP", "GOS"}
_PARAMETERS = ("NAME", "OTHER", "ALIAS_NAME")


class Temporary(Symbol):
    """The number of a temporary program, behind GOS. It equals that of any other program: without folders both are sections of the file."""

    __slots__ = ()


def names(document: Document) -> None:
    """A line says it all."""


def mentions(line: LineNode, names: object) -> Iterator[Mention]:
    """Parameters, numbers of blocks, sections and programs, files, codes, functions, keywords."""
    # A parameter that stands first in a word or an assignment is set by it.
    targets = {part.start for part in walk(line.tree) if part.kind in ("word", "assign")}
    for part in walk(line.tree):
        if isinstance(part, Token):
            yield from _token(line.text, part, targets)
            continue
        yield from _numbers(line.text, part)
        if part.kind in ("g_word", "axis_alias"):
            yield from _code(line.text, part)
        elif part.kind == "vector":
            yield from _vector(line.text, part, targets)
        elif part.kind == "word" and part.children[0].kind == "M_END":
            yield from _code(line.text, part)


def file(symbol: Symbol, file: str, ruleset: RuleSet, host: Host) -> str | None:
    """The file of an L254 call below the configured folder, or of a program's number in that of the programs."""
    if symbol.sort is Sort.FILE and ruleset.settings["file-root"]:
        found = stores.found_files(host, stores.beside(file, str(ruleset.settings["file-root"])), symbol.name)
    elif symbol.sort is Sort.SECTION and symbol.name.isdigit() and ruleset.settings["cmos-dir"]:
        store = str(ruleset.settings["cmos-dir"])
        folder = stores.beside(file, stores.temporary(store) if isinstance(symbol, Temporary) else store)
        found = stores.own_files(host, folder, int(symbol.name))
    else:
        return None
    return found[0] if len(found) == 1 else None


def partial(before: str) -> int:
    """Letters and the digits behind them, or digits."""
    if path := _CALLED.search(before):
        return path.start(1)
    match = _SEQUENCE.search(before) or _INDEX.search(before) or _PARTIAL.search(before)
    return match.start() if match else len(before)


def offers(expected: frozenset[str], before: str, partial: str) -> Iterator[Offer | str]:
    """By the terminals that can stand there."""
    if re.search(r"(?i)gon[ \t]*$|-[ \t]*n[ \t]*$", before):
        yield Offer.LABELS
        return
    if re.search(r"(?i)go[ps][ \t]*$", before):
        yield Offer.SECTIONS
        yield Offer.FILES
        return
    if "PATH" in expected:
        yield Offer.FILES
    if "FUNCTION" in expected:
        yield "function"
    if "GON" in expected and "BANG" in expected:
        yield from (f"keyword/{each}" for each in _FIELD_WORDS)
    if "G" in expected and "!" not in before:
        yield "code"
    if "NAME" in expected:
        yield Offer.VARIABLES
        yield "variable"


def files(file: str, ruleset: RuleSet, host: Host, before: str) -> Iterator[str]:
    """The numbers of the programs in the memory, and the paths of the files below the configured folder."""
    folder, root = str(ruleset.settings["cmos-dir"]), str(ruleset.settings["file-root"])
    if _CALLED.search(before):
        yield from _paths(host, stores.beside(file, root), "") if root else ()
    elif folder:
        store = stores.temporary(folder) if _TEMPORARY.search(before) else folder
        yield from map(str, sorted(stores.programs(host, stores.beside(file, store))))


def _paths(host: Host, folder: str, prefix: str) -> Iterator[str]:
    for name in host.names(folder):
        if host.names(f"{folder}/{name}"):
            yield from _paths(host, f"{folder}/{name}", f"{prefix}{name}\\")
        else:
            yield f"{prefix}{name.rpartition('.')[0] or name}"


def called(before: str) -> None:
    """No call has arguments."""


def takes(document: Document, symbol: Symbol) -> Takes:
    """Nothing is handed over."""
    return Takes(written(symbol), (), "")


def resumed(before: str) -> str:
    """Only a `!` that is still to be written tells whether a `;` parts two fields; a new field follows on either."""
    match = _FIELDS.fullmatch(before)
    return f"{match[1]}!" if match else before


def end(opener: Bracket) -> str:
    """There are no blocks."""
    return ""


def spelled(entry: Entry) -> str:
    """Functions with their parenthesis, families with the bracket before their number."""
    if entry.first is not None:
        return f"{entry.more['prefix']}[" if entry.more.get("prefix") else ""
    if entry.name == "L254":
        return ":L254-"
    return f"{entry.name}(" if entry.table == "function" and entry.name != "PI" else entry.name


def valid(symbol: Symbol, name: str) -> str:
    """Block numbers and sections stay numbers; a parameter stays one of the language's own."""
    if symbol.sort in (Sort.LABEL, Sort.SECTION):
        return "" if re.fullmatch("[0-9]{1,9}", name) else f"`{name}` is no number"
    if symbol.sort is Sort.VARIABLE and re.fullmatch("H[A-Z]", symbol.name):
        return "" if re.fullmatch("[Hh][A-Za-z]", name) else f"`{name}` is no user parameter; write `HA` to `HZ`"
    return f"`{symbol.name}` is the machine's name"


def notes(document: Document, line: int, mention: Mention) -> Iterator[str]:
    """Of an alias the axis for which it stands, as the text above has it."""
    if mention.symbol.name not in _ALIASES:
        return
    found = _alias(document, line, mention.symbol.name)
    if found is None:
        yield "no G25 stands before it here"
    else:
        at, said, axis = found
        yield f"stands for `{axis}` behind `{said}` in line {at + 1}"


def meant(document: Document, line: int, mention: Mention) -> Meant | None:
    """Of an alias its axis, as the text above has it."""
    found = _alias(document, line, mention.symbol.name) if mention.symbol.name in _ALIASES else None
    return None if found is None else Meant(found[2], "alias")


def written(symbol: Symbol) -> str:
    """`N10`, `:5`, or the name."""
    prefix = {Sort.LABEL: "N", Sort.SECTION: ":"}.get(symbol.sort, "")
    return f"{prefix}{symbol.name}"


def _numbers(text: str, node: Node) -> Iterator[Mention]:
    """Block numbers where they stand and where they are jumped to, numbers of called programs."""
    acts = {"nword": Act.DEFINE, "jump": Act.CALL, "range_end": Act.CALL, "call": Act.CALL}
    if node.kind not in acts:
        return
    number = next((each for each in node.children if each.kind == "NUMBER"), None)
    sort = Sort.SECTION if node.kind == "call" else Sort.LABEL
    if number is None:
        whole = Span(node.start, node.end)
        yield Mention(Symbol(sort, ""), acts[node.kind], whole, whole)
        return
    inner = Span(number.start, number.end)
    span = Span(node.start, number.end) if node.kind == "nword" else inner
    is_temporary = node.children[0].kind == "GOS"
    named = (Temporary if is_temporary else Symbol)(sort, _canonical(text[inner.start : inner.end]))
    yield Mention(named, acts[node.kind], span, inner)


def _canonical(number: str) -> str:
    whole, _, fraction = number.replace(",", ".").partition(".")
    fraction = fraction.rstrip("0")
    return (whole.lstrip("0") or "0") + (f".{fraction}" if fraction else "")


def _token(text: str, token: Token, targets: Container[int]) -> Iterator[Mention]:
    span = Span(token.start, token.end)
    said = text[token.start : token.end]
    if token.kind in _PARAMETERS:
        symbol = Symbol(Sort.VARIABLE, said.upper(), table="variable")
        act = Act.SET if token.start in targets else Act.READ
        # An address with a number is a move; a parameter of two letters is one wherever it stands.
        yield Mention(symbol, act, span, span, passing=act is Act.SET and len(said) == 1 and not _assigned(text, token))
    elif token.kind in ("FUNCTION", "PI"):
        yield Mention(Symbol(Sort.FUNCTION, said.upper(), table="function"), Act.SAY, span, span)
    elif token.kind in _KEYWORDS:
        yield Mention(Symbol(Sort.KEYWORD, said.upper(), table="keyword"), Act.SAY, span, span)
    elif token.kind == "SECTION":
        number = said.lstrip(": \t")
        inner = Span(token.end - len(number), token.end)
        yield Mention(Symbol(Sort.SECTION, _canonical(number)), Act.DEFINE, span, inner)
    elif token.kind == "FILE":
        yield Mention(Symbol(Sort.KEYWORD, "L254", table="keyword"), Act.SAY, span, span)
    elif token.kind == "PATH":
        yield Mention(Symbol(Sort.FILE, said), Act.CALL, span, span)


def _alias(document: Document, line: int, name: str) -> tuple[int, str, str] | None:
    """The G25 above a line that names the axis of an alias: its line, how it is written, and the axis."""
    for at in range(line - 1, max(-1, line - _FAR), -1):
        node = document.node(at)
        for alias in node.find("axis_alias"):
            said = node.text[alias.start : alias.end]
            axes = re.sub(r"[^A-Za-z]", "", said)[1:].upper()
            if len(axes) == len(_ALIASES):
                return at, said, axes[_ALIASES.index(name)]
    return None


def _assigned(text: str, token: Token) -> bool:
    return text[token.end :].lstrip(" \t").startswith("=")


def _code(text: str, node: Node) -> Iterator[Mention]:
    said = code_number(re.sub(r"[^A-Za-z0-9. ].*", "", text[node.start : node.end]))
    name = "G25" if node.kind == "axis_alias" else said
    span = Span(node.start, node.end)
    yield Mention(Symbol(Sort.CODE, name, table="code"), Act.SAY, span, span)


def _vector(text: str, node: Node, targets: Container[int]) -> Iterator[Mention]:
    index = node.children[2] if len(node.children) > 2 else None
    act = Act.SET if node.start in targets else Act.READ
    kind = text[node.start : node.start + 3].upper()
    if index is None or index.kind != "NUMBER":
        # Which one it is only the run knows.
        span = Span(node.start, node.start + 3)
        yield Mention(Symbol(Sort.VARIABLE, "", table=kind), act, span, span)
        return
    name = f"{kind}[{_canonical(text[index.start : index.end])}]"
    inner = Span(index.start, index.end)
    yield Mention(Symbol(Sort.VARIABLE, name, table="variable"), act, Span(node.start, node.end), inner)
