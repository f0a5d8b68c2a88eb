"""Random RS274 programs: all of the language, seeded. Never runs one.

What the generator avoids, since the interpreter's answer there is a known fault of its own that
expansion does not imitate (spec/rs274.md §6, spec/oracle.md §4): `AVOIDED`.
"""

import re
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, field
from random import Random

from deburr_grammar.dialects import by_name
from support.expressions import NUMBERED, Expressions, Scope
from support.misuse import MISUSES, Misuse

AVOIDED = (
    "a `do` loop in a program that has a `break` (it ends the next `do` loop, too)",
    "`continue` in a `do` loop beside `repeat` or `break` (it repeats the next loop)",
    "a `return`, `break` or `continue` out of a `repeat`, and a `repeat` in a recursive sub (its counter is shared)",
    "a name read on the line that first sets it (it reads what happens to be there)",
    "`endsub` values of names while the definition is passed over",
    "a result that is no number as an argument or a returned value (it is only refused where it is read)",
    "`M98` with `L0` (it enters a call and never leaves it)",
    "two `#` in a row, or a lone one at the end, in a message (it is expanded again)",
)
FLOW = (
    "sub", "endsub", "call", "return", "if", "elseif", "else", "endif", "while", "endwhile", "do", "repeat",
    "endrepeat", "break", "continue", "M98", "M99",
)  # fmt: skip
MOTION = (
    "G0", "G1", "G2", "G3", "G38.2", "G38.3", "G73", "G81", "G82", "G83", "G85", "G10 L2", "G10 L20", "G52", "G92", "G91",
    "M70", "M72", "file",
)  # fmt: skip
"""Motion, offsets and saved modes, and subprograms in files of their own."""
WAYS = (
    "arc by steps",
    "arc of a radius",
    "other units, then an arc",
    "cycle, then an arc",
    "offset, then an arc",
    "computed M",
    "computed end",
)
"""What leads to a place that an arc or a probe behind it hangs on, and M codes that only a run knows."""
_OUTSIDE = ("_hal", "_ini", "_abs_", "_current_pocket", "_selected_pocket", "_remap_level", "_line")
"""Values that not even a simulated machine has, and the line, which is another one in a flat program."""
_LONGEST = 200
_FIRST = 5061
"""The first numbered parameter with a meaning of its own."""
_MODES = (
    "G20", "G21", "G90", "G91", "G17", "G18", "G19", "G54", "G55", "G56", "G59.3", "G61", "G61.1", "G64", "G64 P0.01", "G98", "G99",
    "G90.1", "G91.1", "G92.1", "G92.2", "G92.3", "G49", "G80", "M3 S500", "M4 S[100*2]", "M5", "M7", "M8", "M9", "M48", "M49",
    "M50 P0", "M51 P1", "M53 P0", "G94 F100", "G97 S200", "T1 M6", "T2 M6 G43", "G43 H1", "G43.1 Z0.5", "T3", "M61 Q2", "G7", "G8",
    "G96 D100 S50", "G28", "G30", "G28.1", "G90 G53 G0 X1", "G28 Z0", "G40", "M66 P1 L0", "M70", "M73",
)  # fmt: skip


def _predefined() -> tuple[str, ...]:
    """All parameters with a meaning of their own, as they are read."""
    found = []
    for entry in by_name("rs274").codes.table("variable"):
        if entry.name.startswith("_") and not entry.name.startswith(_OUTSIDE):
            found.append(f"#<{entry.name}>")
        elif entry.first is not None and entry.first == entry.last and entry.first >= _FIRST:
            found.append(f"#{entry.first}")
    return tuple(found)


PREDEFINED = _predefined()


@dataclass(frozen=True)
class Generated:
    """A program, its files, what it uses, and what was put into it that a run may stumble over."""

    text: str
    files: dict[str, str]
    used: Counter[str]
    misuse: str = ""


@dataclass
class _Plan:
    """What a program may hold, chosen once so that it stays off the faults of the interpreter."""

    do: bool
    leaves: bool
    """`break` and `continue`."""
    subs: list[tuple[str, int, bool]] = field(default_factory=list)
    """Label, arguments, and whether it returns a value."""
    numbered: list[int] = field(default_factory=list)


def generated(seed: int) -> Generated:
    """The program of a seed."""
    return _Writer(Random(seed)).program()


class _Writer:
    def __init__(self, rng: Random) -> None:
        self._rng = rng
        self._used: Counter[str] = Counter()
        self._values = Expressions(rng, self._used, list(PREDEFINED), 0.02 if rng.random() < 0.2 else 0.0)
        leaves = rng.random() < 0.5
        self._plan = _Plan(do=not leaves, leaves=leaves)
        self._label = 100
        self._lines: list[str] = []
        self._files: dict[str, str] = {}
        self._misuse: Misuse | None = rng.choice(MISUSES) if rng.random() < 0.33 else None

    def program(self) -> Generated:
        """Subprograms, the main part, and programs behind its end."""
        rng, main = self._rng, Scope(names=["a", "_g", "_long name"])
        behind = rng.random() < 0.3
        subs = self._subs(behind)
        numbered = [self._numbered(number) for number in range(rng.randint(0, 1))]
        head = ["G21 G90 G17 F100", *(f"#<{name}>={rng.randint(-5, 9)}" for name in main.names)]
        statements = [self._statement(main, 3) for _ in range(rng.randint(3, 6))]
        if self._misuse is not None:
            statements.insert(rng.randint(0, len(statements)), self._misuse.lines(rng))
        body = [line for statement in statements for line in statement]
        inside = [line for sub in subs for line in sub]
        end = rng.choice(("M2", "M30"))
        if not numbered and not behind and rng.random() < 0.2:
            self._use("computed end")
            end = f"M[{end[1:]}+#50*0]"
        lines = [*head, *([] if behind else inside), *body, "(PRINT,end)", end]
        lines += [*(inside if behind else []), *(line for one in numbered for line in one)]
        lines = [f"/{line}" if self._rng.random() < 0.01 else line for line in lines]
        lines = ["%", *lines, "%"] if self._rng.random() < 0.1 and not self._files else lines
        text = "\n".join(self._spelled(at, line) for at, line in enumerate(lines, 1)) + "\n"
        return Generated(text, self._files, self._used, self._misuse.name if self._misuse is not None else "")

    def _subs(self, behind: bool) -> list[list[str]]:
        """Behind the end of the program a sub finds no other one that stands above it."""
        found: list[list[str]] = []
        known: list[tuple[str, int, bool]] = []
        for number in range(self._rng.choice((0, 0, 1, 1, 2))):
            found.append(self._sub(number))
            known += self._plan.subs if behind else []
            self._plan.subs = [] if behind else self._plan.subs
        self._plan.subs += known
        return found + ([self._recursive()] if self._rng.random() < 0.2 else [])

    def _sub(self, number: int) -> list[str]:
        rng, label = self._rng, self._rng.choice((f"<sub{number}>", f"{number + 1}"))
        count, given = rng.randint(0, 4), rng.random() < 0.5
        scope = Scope(names=["b", "_g"], in_sub=True)
        self._use("sub", "endsub")
        body = ["#<b>=[#1+#2]", *self._block(scope, rng.randint(1, 3), 2)]
        if rng.random() < 0.5:
            self._use("return", "if", "endif")
            value = f" [[{self._values.inner(scope, 1)}]]" if given and rng.random() < 0.5 else ""
            value = "" if "<" in value else value
            body += [f"o90 if {self._values.truth(scope)}", f"o{label} return{value}", "o90 endif", self._print(scope)]
        end = f"o{label} endsub" + (f" [#1+{rng.randint(1, 9)}]" if given else "")
        lines = [f"o{label} sub", *body, end]
        self._plan.subs.append((label, count, given))
        if "<" in label and rng.random() < 0.4:
            self._use("file")
            self._files[f"sub{number}.ngc"] = "\n".join(lines) + "\n"
            return []
        return lines

    def _recursive(self) -> list[str]:
        self._use("sub", "if", "call", "endif", "endsub")
        self._plan.subs.append(("<deep>", -1, True))
        deeper = ["o91 if [#1 GT 0]", "o<deep> call [#1-1]", "o91 endif"]
        return ["o<deep> sub", self._print(Scope(in_sub=True)), *deeper, "G0 X#1", "o<deep> endsub [#1*2]"]

    def _numbered(self, number: int) -> list[str]:
        self._use("M99")
        self._plan.numbered.append(700 + number)
        return [
            f"o{700 + number}",
            "#35=[#35+1]",
            self._print(Scope(in_sub=True)),
            f"G0 X[#35 MOD {number + 5}]",
            "M99",
        ]

    def _block(self, scope: Scope, count: int, depth: int) -> list[str]:
        return [line for _ in range(count) for line in self._statement(scope, depth)]

    def _statement(self, scope: Scope, depth: int) -> list[str]:
        """A statement whose lines the control can read: it takes 252 characters."""
        while True:
            found = self._tried(scope, depth)
            if all(len(line) < _LONGEST for line in found):
                return found

    def _tried(self, scope: Scope, depth: int) -> list[str]:
        simple: list[Callable[[Scope], list[str]]] = [*[self._setting] * 6, *[self._move] * 5, *[self._mode] * 4]
        simple += (
            [lambda scope: [self._print(scope)]] * 3
            + [self._call] * 3
            + [self._offset, self._cycle, self._arc, self._saved, self._probe, self._way, self._coded]
        )
        nested = [self._if, self._if, self._while, self._do if self._plan.do else self._while, self._repeat]
        if depth and self._rng.random() < 0.3:
            return self._rng.choice(nested)(scope, depth - 1)
        return self._rng.choice(simple)(scope)

    def _setting(self, scope: Scope) -> list[str]:
        rng = self._rng
        targets = [f"#{rng.choice(NUMBERED)}", f"#<{rng.choice(scope.names)}>" if scope.names else "#31"]
        targets += [f"#[{rng.choice((1, 31))}+{rng.randint(0, 3)}]", "#[FIX[ABS[#1] MOD 5]+31]"]
        found = [f"{rng.choice(targets)}={self._values.value(scope)}" for _ in range(rng.choice((1, 1, 1, 2, 3)))]
        word = f" G0 X{self._values.small(scope)}" if rng.random() < 0.1 else ""
        return [" ".join(found) + word] if sum(map(len, found)) < 150 else found[:1]

    def _move(self, scope: Scope) -> list[str]:
        rng = self._rng
        axes = rng.sample("XYZABC", rng.randint(1, 3))
        words = [axis + (rng.choice(("1", "-2.5", "0")) if rng.random() < 0.3 else self._word(scope)) for axis in axes]
        found = f"G0 {' '.join(words)}" if rng.random() < 0.5 else f"G94 G1 {' '.join(words)} F{rng.randint(1, 900)}"
        return self._moving(found)

    def _word(self, scope: Scope) -> str:
        return self._rng.choice(("", "-")) + self._values.small(scope)

    def _mode(self, scope: Scope) -> list[str]:
        code = self._rng.choice(_MODES)
        return self._moving(*([code, "G94 F80"] if code.startswith(("G96", "G7")) else [code]))

    def _offset(self, scope: Scope) -> list[str]:
        rng = self._rng
        axes = " ".join(axis + self._word(scope) for axis in rng.sample("XYZA", 2))
        code = rng.choice(("G92", f"G10 L2 P{rng.randint(0, 9)}", f"G10 L20 P{rng.randint(0, 9)}", "G52"))
        return self._moving(f"{code} {axes}")

    def _cycle(self, scope: Scope) -> list[str]:
        rng = self._rng
        code = rng.choice(("G81", "G82 P0.5", "G83 Q2", "G85", "G73 Q1"))
        repeats = rng.choice(("", " L2"))
        return self._moving(
            "G17", f"G94 {code} X{self._word(scope)} Y2 Z-5 R{rng.randint(1, 9)}{repeats} F50", "X3 Y-1", "G80"
        )

    def _probe(self, scope: Scope) -> list[str]:
        way = self._rng.choice(("X5", "Z-5", "Y-3 Z2"))
        return self._moving(f"G91 G94 {self._rng.choice(('G38.2', 'G38.3'))} {way} F50", "G90", self._print(scope))

    def _arc(self, scope: Scope) -> list[str]:
        plane, one, two = self._rng.choice((("G17", "I", "J"), ("G18", "I", "K"), ("G19", "J", "K")))
        return self._moving(
            f"G94 {plane} G91.1 {self._rng.choice(('G2', 'G3'))} {one}[1+{self._values.small(scope, 9)}] {two}2 F60"
        )

    def _way(self, scope: Scope) -> list[str]:
        """An arc that is right if its start is where the lines before it lead."""
        rng, code, size = self._rng, self._rng.choice(("G2", "G3")), self._values.small(scope, 4)
        x, radius = rng.randint(-3, 5), rng.randint(1, 3)
        ahead = rng.choice((f"R{radius}", f"I{radius} J0"))
        ways = {
            "arc by steps": ["G91", f"{code} X{2 * radius} Y0 {ahead}", f"{code} X[{size}] R[{size}+1]", "G90"],
            "arc of a radius": ["G91", f"G1 X{x} Y[{size}]", f"{code} Y{2 * radius} R{radius}", "G90"],
            "other units, then an arc": [
                "G21",
                f"G0 X{2.54 * x:.2f} Y0",
                "G20",
                f"{code} X{0.1 * x + 2 * radius:.1f} {ahead}",
                "G21",
            ],
            "cycle, then an arc": ["G99", f"G81 X{x} Y[{size}] Z-1 R2", "G80", f"{code} X{x + 2 * radius} {ahead}"],
            "offset, then an arc": [
                f"{rng.choice(('G92', 'G10 L20 P0'))} X{x} Y1",
                f"{code} X{x + 2 * radius} {ahead}",
            ],
        }
        name = rng.choice(tuple(ways))
        self._use(name)
        return self._moving("G8 G17 G90 G91.1 G94 F60", *ways[name])

    def _coded(self, scope: Scope) -> list[str]:
        """M codes that are calculated."""
        self._use("computed M")
        code = self._rng.choice(("3] S500", "5]", "7]", "8]", "9]", "48]", "49]", "70]", "73]"))
        return [f"M[[{self._values.small(scope)}]*0+{code}", self._print(scope)]

    def _saved(self, scope: Scope) -> list[str]:
        return self._moving("M70", self._rng.choice(_MODES[:18]), self._print(scope), "M72")

    def _moving(self, *lines: str) -> list[str]:
        """Lines, with the codes counted that they hold."""
        for line in lines:
            self._use(*(code for code in MOTION if re.search(rf"{re.escape(code)}(?![0-9.])", line)))
        return list(lines)

    def _print(self, scope: Scope) -> str:
        rng = self._rng
        found = [rng.choice(("", "%d ", "%f ", "%.3f "))]
        for _ in range(rng.randint(3, 7)):
            name = rng.choice(PREDEFINED) if rng.random() < 0.8 else f"#{rng.choice(NUMBERED)}"
            self._used[name] += name in PREDEFINED
            found.append(name)
        names = [f"#<{name}>" for name in scope.names[:1]]
        return f"({rng.choice(('PRINT', 'DEBUG', 'print'))},{' '.join([*found, *names])} . )"

    def _call(self, scope: Scope) -> list[str]:
        rng, plan = self._rng, self._plan
        if plan.numbered and not scope.in_sub and rng.random() < 0.4:
            self._use("M98")
            return [f"M98 P{rng.choice(plan.numbered)}{rng.choice(('', ' L1', ' L2'))}"]
        if not plan.subs:
            return [self._print(scope)]
        label, count, given = rng.choice(plan.subs)
        if scope.in_sub and label == "<deep>":
            return [self._print(scope)]
        self._use("call")
        if count < 0:
            arguments = f" [{rng.randint(0, 6)}]"
        else:
            arguments = "".join(f" [[{self._values.inner(scope, 1)}]]" for _ in range(count))
        said = f"[{label}+0]" if label.isdigit() and rng.random() < 0.3 else label
        return [f"o{said} call{arguments}", "G0 X[#<_value> MOD 50]" if given else "(PRINT,%d #<_value_returned> .)"]

    def _if(self, scope: Scope, depth: int) -> list[str]:
        label = self._next()
        self._use("if", "endif")
        found = [f"o{label} if {self._values.truth(scope)}", *self._block(scope, 2, depth)]
        for _ in range(self._rng.choice((0, 0, 1, 2))):
            self._use("elseif")
            found += [f"o{label} elseif {self._values.truth(scope)}", *self._block(scope, 1, depth)]
        if self._rng.random() < 0.5:
            self._use("else")
            found += [f"o{label} else", *self._block(scope, 1, depth)]
        return [*found, f"o{label} endif"]

    def _while(self, scope: Scope, depth: int) -> list[str]:
        label, rng = self._next(), self._rng
        counter = f"n{label}"
        self._use("while", "endwhile")
        body = [f"#<{counter}>=[#<{counter}>+1]", *self._inside(scope, counter, 2, depth)]
        if self._plan.leaves and rng.random() < 0.7:
            word = rng.choice(("break", "continue"))
            self._use(word, "if", "endif")
            inner = self._next()
            body += [
                f"o{inner} if {self._values.truth(scope)}",
                f"o{label} {word}",
                f"o{inner} endif",
                self._print(scope),
            ]
        head = f"o{label} while [#<{counter}> LT {rng.randint(0, 4)}]"
        return [f"#<{counter}>=0", head, *body, f"o{label} endwhile"]

    def _do(self, scope: Scope, depth: int) -> list[str]:
        label = self._next()
        counter = f"n{label}"
        self._use("do", "while")
        body = [f"#<{counter}>=[#<{counter}>+1]", *self._inside(scope, counter, 2, depth)]
        return [f"#<{counter}>=0", f"o{label} do", *body, f"o{label} while [#<{counter}> LT {self._rng.randint(0, 3)}]"]

    def _repeat(self, scope: Scope, depth: int) -> list[str]:
        label = self._next()
        self._use("repeat", "endrepeat")
        count = self._rng.choice(("0", "1", "2", "3", "2.5", "1.5", f"{self._values.small(scope, 3)}"))
        leaves, self._plan.leaves = self._plan.leaves, False
        body = self._block(scope, 2, depth)
        self._plan.leaves = leaves
        return [f"o{label} repeat [{count}]", *body, f"o{label} endrepeat"]

    def _inside(self, scope: Scope, counter: str, count: int, depth: int) -> list[str]:
        scope.counters.append(counter)
        found = self._block(scope, count, depth)
        scope.counters.pop()
        return found

    def _next(self) -> int:
        self._label += 1
        return self._label

    def _use(self, *words: str) -> None:
        self._used.update(words)

    def _spelled(self, row: int, line: str) -> str:
        """The line with its number in it, and sometimes in other letters and with other blanks."""
        rng = self._rng
        if line == "%":
            return line
        if line[0] == "/":
            return f"/N{row} {line[1:]}"
        if "(" not in line:
            line = line.lower() if rng.random() < 0.15 else line
            line = line.replace(" ", "  ") if rng.random() < 0.1 else line
            if rng.random() < 0.5:
                return f"{line} ;{row}"
        return f"N{row} {line}"
