"""Random Z32 programs as people write them, and worse: counted loops, ranges, sections, called files, axes by alias, jumps anywhere."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from random import Random
from typing import NamedTuple

NAMES = ("HA", "HB", "HC", "HD", "QQ", "X", "Y", "F")
GIVEN = ("HE", "HF")
"""Parameters that only the run is given."""
SETTINGS = {"cmos-dir": "", "file-root": "files", "pal": {"300": 4, "301": 0}}
_NUMBERS = ("0", "1", "2", "3", "5", "10", "-1", "-4", "0.5", "2.5", "100", "255", "256", "512", "0.1")
_FUNCTIONS = ("SN", "CS", "TAN", "AT", "ABS", "INT", "NEI", "RQ")
_SHARING, _POOL = 300, 150
_RELATIONS = ("=", "<>", "<", ">", "<=", ">=")


class Generated(NamedTuple):
    """A program with the files that it calls, and its settings."""

    text: str
    files: dict[str, str]
    settings: dict[str, object]


def generated(seed: int) -> Generated:
    """The program of a seed. Those of neighbouring seeds share most of their lines, so that few have to be parsed."""
    return _Maker(Random(seed), *_pools(seed // _SHARING)).program()


@cache
def _pools(number: int) -> tuple[list[str], list[str]]:
    """Blocks, and the fields of advanced lines."""
    maker = _Maker(Random(f"pool {number}"), [], [])
    return [maker.new_block() for _ in range(_POOL)], [maker.new_fields() for _ in range(_POOL)]


def given(rng: Random) -> dict[str, str]:
    """Values for one run."""
    return {name: rng.choice(_NUMBERS) for name in GIVEN}


class _Maker:
    def __init__(self, rng: Random, blocks: list[str], fields: list[str]) -> None:
        self._rng = rng
        self._blocks = blocks
        self._several = fields
        self._ranges: list[tuple[int, int]] = []
        self._label = 10
        self._sections = rng.randint(0, 3)
        self._files = rng.randint(0, 1)
        self._cmos = rng.random() < 0.2

    def program(self) -> Generated:
        """All of it."""
        rng = self._rng
        lines = ["(P)", *(f"{name}{rng.choice(_NUMBERS)}" for name in NAMES if rng.random() < 0.9)]
        lines += [f"PAL[{at}]{rng.randint(0, 9)} PAR[{at}]{rng.choice(_NUMBERS)}" for at in range(rng.randint(0, 6))]
        lines += [f"G25{''.join(rng.sample('XYZ', 3))}"] if rng.random() < 0.5 else []
        lines += self._body(rng.randint(4, 12), 2)
        if rng.random() < 0.8:
            lines.append("M30")
        ranges = [line for _ in range(rng.randint(0, 2)) for line in self._range()]
        lines = [*lines[:-1], *ranges, *lines[-1:]] if rng.random() < 0.2 else lines + ranges
        sections = {number: self._section() for number in range(1, self._sections + 1)}
        files = {f"files/A{at}.z32": "\n".join(self._section()) + "\n" for at in range(1, self._files + 1)}
        settings: dict[str, object] = {**SETTINGS}
        if self._cmos:
            settings["cmos-dir"] = "cmos"
            files |= {f"cmos/{number}.z32": "\n".join(each) + "\n" for number, each in sections.items()}
        else:
            lines += [line for number, each in sections.items() for line in (f":{number}", *each)]
        return Generated("\n".join(lines) + "\n", files, settings)

    def _section(self) -> list[str]:
        lines = self._body(self._rng.randint(1, 5), 1)
        return [*lines, "G26"] if self._rng.random() < 0.95 else lines

    def _range(self) -> list[str]:
        """Lines that `GONn-Nm` runs, if a line of the body names them."""
        first, last = self._next(), self._next()
        self._ranges.append((first, last))
        end = self._rng.choice((f"N{last}", f"N{last}", f"N{last} HC<HC+1>", f"N{last} !IF HA>2; HB=1!"))
        return [f"N{first} {self._block()}", *self._body(self._rng.randint(0, 3), 1), end]

    def _next(self) -> int:
        self._label += 10
        return self._label

    def _body(self, count: int, depth: int) -> list[str]:
        return [line for _ in range(count) for line in self._statement(depth)]

    def _statement(self, depth: int) -> list[str]:
        rng = self._rng
        sort = rng.random()
        if sort < 0.15 and depth:
            return list(self._loop(depth))
        if sort < 0.25 and depth:
            return self._over(depth)
        if sort < 0.32:
            return self._ranged(depth)
        if sort < 0.40 and (self._sections or self._files):
            return [self._call()]
        line = f"!{self._fields()}!" if rng.random() < 0.5 else self._block()
        return [f"/{line}" if rng.random() < 0.04 else f"N{self._next()} {line}" if rng.random() < 0.1 else line]

    def _loop(self, depth: int) -> Iterator[str]:
        """A counter that goes from one number to another, in steps that may lead away."""
        rng, label = self._rng, self._next()
        name, step = rng.choice(("HA", "HB", "HC", "HD")), rng.choice(("1", "2", "0.5", "10", "-1", "-2"))
        up = not step.startswith("-") or rng.random() < 0.1
        bound = rng.choice(("3", "5", "20")) if up else rng.choice(("-3", "0", "-7.5"))
        yield f"!{name}={rng.choice(('0', '1', '-1'))}!"
        yield f"N{label} {self._block()}"
        yield from self._body(rng.randint(0, 3), depth - 1)
        relation = rng.choice(("<", "<=", "<>") if up else (">", ">=", ">"))
        yield f"!{name}={name}+{step}; IF {name}{relation}{bound}; GON{label}!".replace("+-", "-")

    def _over(self, depth: int) -> list[str]:
        """Some lines that an IF jumps over."""
        label = self._next()
        return [f"!IF {self._condition()}; GON{label}!", *self._body(2, depth - 1), f"N{label} {self._block()}"]

    def _ranged(self, depth: int) -> list[str]:
        rng = self._rng
        if self._ranges and rng.random() < 0.7:
            first, last = rng.choice(self._ranges)
            return [f"!GON{first}-N{last}!"]
        first, last, over = self._next(), self._next(), self._next()
        self._ranges.append((first, last))
        inner = [f"N{first} {self._block()}", *self._body(rng.randint(0, 2), max(0, depth - 1)), f"N{last}"]
        return [f"!GON{over}!", *inner, f"N{over}", f"!GON{first}-N{last}!"]

    def _call(self) -> str:
        rng = self._rng
        if self._files and (not self._sections or rng.random() < 0.4):
            return f"!:L254-A{self._files}!"
        number = rng.randint(1, self._sections)
        said = rng.choice((str(number), str(number), f"<{number - 1}+1>", "<HA>"))
        return f"!IF {self._condition()}; GOP{said}!" if rng.random() < 0.3 else f"!GOP{said}!"

    def _fields(self) -> str:
        return self._rng.choice(self._several)

    def _block(self) -> str:
        return self._rng.choice(self._blocks)

    def new_fields(self) -> str:
        """The fields of an advanced line."""
        rng = self._rng
        found = self._assignment()
        for _ in range(rng.randint(0, 3)):
            separator = rng.choice(";;!!")
            found += separator + self._field()
        return found if rng.random() < 0.5 else f"IF {self._condition()};{found}"

    def _field(self) -> str:
        rng = self._rng
        sort = rng.random()
        if sort < 0.35:
            return f"IF {self._condition()};{self._assignment()}"
        if sort < 0.45:
            return "EB"
        if sort < 0.5:
            return rng.choice(("HX=HA;HY=HB;CP", "HR=HA;HT=30;PC", "HX=0;HY=0;CP", "HR=2;HT=HE;PC"))
        if sort < 0.53:
            return f"GON{rng.randrange(20, 90, 10)}"
        if sort < 0.55:
            return f"GON<{rng.randrange(20, 90, 10)}+HA*10>"
        return self._assignment()

    def _assignment(self) -> str:
        return f"{self._target()}={self._expression(2)}"

    def new_block(self) -> str:
        """An ISO block."""
        rng = self._rng
        words = ["G1"] if rng.random() < 0.5 else []
        for _ in range(rng.randint(1, 3)):
            target = rng.choice((*NAMES, "X", "Y", "AA", "AB", self._target()))
            words.append(
                f"{target}<{self._expression(2)}>" if rng.random() < 0.6 else f"{target}{rng.choice(_NUMBERS)}"
            )
        return " ".join(words)

    def _target(self) -> str:
        rng = self._rng
        sort = rng.random()
        if sort < 0.7:
            return rng.choice(NAMES)
        if sort < 0.8:
            return rng.choice(("AA", "AB", "AC"))
        return f"{rng.choice(('PAL', 'PAR'))}[{rng.choice(('1', '2', '3', 'HA', 'HB+1', 'NEI(HC)', '254+HA'))}]"

    def _condition(self) -> str:
        rng = self._rng
        left = (
            rng.choice((*NAMES, *GIVEN, "PAL[1]", "PAR[2]", "PAL[300]")) if rng.random() < 0.8 else self._expression(1)
        )
        right = rng.choice(_NUMBERS) if rng.random() < 0.7 else self._expression(1)
        sides = [left, right]
        rng.shuffle(sides)
        return f"{sides[0]}{rng.choice(_RELATIONS)}{sides[1]}"

    def _expression(self, depth: int) -> str:
        rng = self._rng
        if not depth or rng.random() < 0.3:
            sort = rng.random()
            if sort < 0.4:
                return rng.choice(_NUMBERS[:6] + _NUMBERS[8:11])
            if sort < 0.8:
                return rng.choice((*NAMES, *GIVEN))
            return rng.choice(("PAL[1]", "PAL[2]", "PAR[1]", "PAR[3]", "PAL[HA]", "PAL[300]", "PI", "AA", "AB"))
        if rng.random() < 0.2:
            return f"{rng.choice(_FUNCTIONS)}({self._expression(depth - 1)})"
        sign = rng.choice("+-*+-*/")
        return f"({self._expression(depth - 1)}{sign}{self._expression(depth - 1)})"
