"""The programs that are measured: generated with fixed seeds, clean, and of any size. Never reads a file."""

from __future__ import annotations

from itertools import chain, count, islice
from random import Random
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterator

SEED = 274
CAM_LINES = 1_000_000
MACRO_LINES = 100_000
MIXED_LINES = 100_000
TOOLS = 40
"""Numbers of tools that programs ask for: 1 to this."""


def cam(lines: int = CAM_LINES) -> str:
    """What a CAM system writes: 97.5 % numbered motion, the rest comments, tool changes, O-words and expressions."""
    return _text(_cam(Random(SEED)), _CAM_FRAME, lines)


def macro(lines: int = MACRO_LINES) -> str:
    """What a person writes: subprograms full of named parameters, expressions, branches, loops and probing, and behind them the program that calls them all."""
    head, foot = _MACRO_FRAME
    subs, calls, room = list[list[str]](), list[list[str]](), lines - len(head) - len(foot)
    for sub, call in _macro(Random(SEED)):
        room -= len(sub) + len(call)
        if room < 0:
            break
        subs.append(sub)
        calls.append(call)
    return _text(chain(subs, calls), _MACRO_FRAME, lines)


def mixed(lines: int = MIXED_LINES, share: float = 0.1) -> str:
    """A CAM program in which a share of the lines holds an expression that stands nowhere else."""
    random = Random(SEED)
    plain = _cam(Random(SEED))

    def body() -> Iterator[list[str]]:
        while True:
            yield [f"#{random.randint(1, 30)}={_unique(random)}"] if random.random() < share else next(plain)

    return _text(body(), _CAM_FRAME, lines)


def loop(passes: int) -> str:
    """Arithmetic and one motion, that many times."""
    return f"#1=0\no1 while [#1 LT {passes}]\n  #1=[#1+1]\n  G1 X[#1*0.001] F100\no1 endwhile\nM2\n"


def one_line(size: int) -> str:
    """A program on one line of that many characters."""
    return "G1 X1 " * (size // 6)


def unclosed(lines: int) -> str:
    """Nothing but openers of one label."""
    return "o1 if [1]\n" * lines


def table(size: int) -> str:
    """A table of words and numbers that was opened by mistake."""
    random = Random(SEED)
    rows = (",".join((_word(random), _word(random), str(random.random()), _word(random))) for _ in count())
    return _sized(rows, size)


def junk(size: int) -> str:
    """Bytes that are no text, decoded as Latin-1."""
    return Random(SEED).randbytes(size).decode("latin-1")


_CAM_FRAME = (
    [
        "%",
        "(PART 4711, ROUGHING AND FINISHING)",
        "o<peck> sub",
        "G0 X#1 Y#2",
        "G1 Z-#3 F200",
        "G0 Z5",
        "o<peck> endsub",
        "G21 G90 G17 G40 G49 G80 G94",
        "#1=0 #2=#5063 (WHERE THE PROBE TOUCHED THE STOCK)",
        "T1 M6",
        "S8000 M3",
        "G0 X0 Y0 Z5",
        "G1 F800",
    ],
    ["M5", "M9", "M2", "%"],
)


def _cam(random: Random) -> Iterator[list[str]]:
    """Operations of some hundred moves; about one line in forty is no motion."""
    numbers = count(10, 10)
    for label in count(100):
        for group in _operation(random, label):
            yield group
            for _ in range(random.randint(50, 136)):
                yield [f"N{next(numbers)} {_move(random)}"]


def _operation(random: Random, label: int) -> Iterator[list[str]]:
    tool = random.randint(1, TOOLS)
    yield [f"(OPERATION {label}: POCKET {random.randint(1, 99)})"]
    yield [f"T{tool} M6", f"S{random.randint(20, 180)}00 M3", f"G43 H{tool}", "G0 Z5.", "M8"]
    yield [f"#2=[#2+{random.randint(1, 9) / 10}]"]
    yield [f"o<peck> call [{_number(random)}] [{_number(random)}] [2.5]", "G0 Z5."]
    yield [
        f"o{label} if [#2 GT {random.randint(1, 9)}]",
        f"G1 Z-{random.randint(1, 9)}. F{random.randint(2, 18)}00",
        f"o{label} endif",
    ]


def _move(random: Random) -> str:
    kind = random.random()
    x, y, z = _number(random), _number(random), _number(random)
    if kind < 0.62:
        return f"G1 X{x} Y{y}"
    if kind < 0.78:
        return f"G1 X{x} Y{y} Z{z}"
    if kind < 0.88:
        return f"G0 X{x} Y{y}"
    if kind < 0.94:
        return f"G1 X{x} Y{y} Z{z} F{random.randint(2, 18)}00"
    return f"G1 Z{z}" if kind < 0.97 else f"G1 X{x} Z{z}"


def _number(random: Random) -> str:
    return f"{random.uniform(-250, 250):.4f}"


_MACRO_FRAME = (["(CYCLES OF A SHOP)", "G21 G90 G17 G94", "F100"], ["M2"])
_NOUNS = ["depth", "width", "feed", "angle", "radius", "step", "pitch", "stock", "margin", "pocket", "hole", "count"]
_SIDES = ["first", "last", "inner", "outer", "upper", "lower", "left", "right", "safe", "rough", "fine", "total"]
_CALLS = ["SIN", "COS", "TAN", "ABS", "FIX", "FUP", "ROUND", "SQRT"]


def _macro(random: Random) -> Iterator[tuple[list[str], list[str]]]:
    """Subprograms, each with what the program does to call it."""
    library = [_expression(random, 2) for _ in range(30)]
    for number in count(1):
        name = f"{random.choice(_SIDES)}_{random.choice(_NOUNS)}_{number}"
        names = [f"#<{noun}>" for noun in random.sample(_NOUNS, 4)]
        sub = [f"o<{name}> sub ({' '.join(name.split('_'))})", *_body(random, names, library), f"o<{name}> endsub", ""]
        values = " ".join(f"[{random.randint(1, 90)}]" for _ in names)
        yield sub, [f"G0 X{random.randint(0, 250)} Y{random.randint(0, 250)} Z50", f"o<{name}> call {values}"]


def _body(random: Random, names: list[str], library: list[str]) -> Iterator[str]:
    yield from (f"  {name} = #{at}" for at, name in enumerate(names, 1))
    labels = count(100)
    for _ in range(random.randint(3, 12)):
        yield from _statement(random, names, library, labels, "  ")


def _statement(
    random: Random, names: list[str], library: list[str], labels: Iterator[int], indent: str
) -> Iterator[str]:
    one, other = random.sample(names, 2)
    value = _filled(random.choice(library), one, other)
    kind = random.randint(0, 9) if len(indent) < 8 else random.randint(0, 5)
    inner = indent + "  "
    label = next(labels) if kind > 6 else 0
    if kind <= 2:
        # What is calculated in a loop from what it was before must stay within bounds.
        yield f"{indent}{one} = [{value} MOD {random.randint(2, 9)}00]" + (
            f" ({random.choice(_SIDES)} {random.choice(_NOUNS)})" if random.random() < 0.3 else ""
        )
    elif kind == 3:
        yield f"{indent}G1 X{value} Y[{other}*2] F[ABS[{one}]+100]"
    elif kind == 4:
        yield f"{indent}G0 X{one} Z[{other}+{random.randint(1, 20)}]"
    elif kind == 5:
        yield from (
            f"{indent}; {random.choice(_SIDES)} {random.choice(_NOUNS)}",
            f"{indent}(DEBUG, {one.strip('#<>')} is {one})",
        )
    elif kind == 6:
        yield from (
            f"{indent}G38.2 Z-{random.randint(5, 50)} F{random.randint(20, 200)}",
            f"{indent}{one} = [#5063+{other}]",
        )
    elif kind == 7:
        yield f"{indent}o{label} if [{one} GT {other}]"
        yield from _statement(random, names, library, labels, inner)
        yield from (f"{indent}o{label} else", f"{inner}{one} = 0", f"{indent}o{label} endif")
    elif kind == 8:
        # What it counts with is its own, so that it ends whatever stands in it.
        passes = f"#<pass_{label}>"
        yield from (f"{indent}{passes} = 0", f"{indent}o{label} while [{passes} LT {random.randint(2, 20)}]")
        yield from _statement(random, names, library, labels, inner)
        yield from (f"{inner}{passes} = [{passes}+1]", f"{indent}o{label} endwhile")
    else:
        yield f"{indent}o{label} repeat [{random.randint(2, 20)}]"
        yield from _statement(random, names, library, labels, inner)
        yield f"{indent}o{label} endrepeat"


def _expression(random: Random, depth: int) -> str:
    """An expression over `{0}` and `{1}` that has a value whatever they are."""
    if not depth or random.random() < 0.2:
        return random.choice(("{0}", "{1}", f"{random.randint(1, 99) / 10}"))
    left, right = _expression(random, depth - 1), _expression(random, depth - 1)
    if random.random() < 0.3:
        return f"{random.choice(_CALLS[:2] + _CALLS[3:7])}[{left}]"
    return f"[{left}{random.choice([' + ', ' - ', '*'])}{right}]"


def _filled(template: str, one: str, other: str) -> str:
    return template.replace("{0}", one).replace("{1}", other)


def _unique(random: Random) -> str:
    parts = [random.choice(("#1", "#2", f"{_number(random)}", f"SIN[#{random.randint(1, 9)}]")) for _ in range(9)]
    return "[" + "".join(part + random.choice("+-*") for part in parts) + "1]"


def _word(random: Random) -> str:
    return "".join(random.choices("abcdefghijklmnopqrstuvwxyz", k=random.randint(3, 9)))


def _text(body: Iterator[list[str]], frame: tuple[list[str], list[str]], lines: int) -> str:
    """The frame around as many groups as fit; a group (a block, a subprogram) is never cut, comments fill what is left."""
    head, foot = frame
    found = list(head)
    room = max(lines - len(foot), len(found))
    for group in islice(body, room):
        if len(found) + len(group) > room:
            break
        found += group
    found += ["(END)"] * (room - len(found)) + foot
    return "\n".join(found) + "\n"


def _sized(rows: Iterator[str], size: int) -> str:
    found, length = list[str](), 0
    while length < size:
        found.append(next(rows))
        length += len(found[-1]) + 1
    return "\n".join(found) + "\n"
