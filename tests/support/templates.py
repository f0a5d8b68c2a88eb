"""Random CGT templates and toolpaths: all that decides what words hold, seeded. Never runs one."""

from collections.abc import Iterator
from random import Random
from typing import Any

NUMBERS = ("0", "1", "2", "3", "-1", "0.5", "10", "2.5", "100", "0.1", "-3", "5")
SYSTEM = ("FEED", "XPOS", "SPEED", "TOOL", "DOFF", "COOLNT", "ZST")
MINE = ("V1", "V2", "V3", "n", "d")
TEXTS = ("S1", "S2", "kind")
TABLES = ("gear", "COOLNT")
LITERALS = ("G00", "M03", "ABC", "12", "3.5", "A B")
ONE = ("ABS", "CEIL", "FLOOR", "INT", "SGN", "SQR", "SIN", "COS", "TAN", "ASIN", "ACOS", "ATAN", "DMS")
TWO = ("MAX", "MIN", "MOD", "RND")
RELATIONS = ("=", "<>", ">", ">=", "<", "<=")
RUN = ("LINE", "RAP", "TOOLCHG", "FXD1", "user")


def template(rng: Random) -> str:
    """A template of which every line can be read."""
    return "\n".join(_Writer(rng).lines()) + "\n"


def events(rng: Random) -> list[dict[str, Any]]:
    """A toolpath that sets the generator's words, and runs sections in any order."""
    found = []
    for _ in range(rng.randint(2, 9)):
        names = rng.sample(SYSTEM, rng.randint(0, 4))
        event: dict[str, Any] = {
            "set": {name: rng.choice((0, 1, 2, 3, -1, 0.5, 10, 250, 1e-3)) for name in names if name not in TABLES}
        }
        if rng.random() < 0.3:
            event["set"]["COOLNT"] = rng.choice((0, 1, 2))
        if rng.random() < 0.9:
            event["section"] = rng.choice(RUN)
        found.append(event)
    first = {name: 1 for name in SYSTEM if rng.random() < 0.9}
    return [{"set": first}, *found]


class _Writer:
    def __init__(self, rng: Random) -> None:
        self._rng = rng
        self._computing = False
        self._callable: list[str] = []

    def lines(self) -> Iterator[str]:
        """All sections; a section may call those that are written after it, so that none calls itself."""
        rng = self._rng
        yield from ("@DECLARE", "#INT #n", "#DEC #d", "#STR #kind", "#TBL #gear", "#CALCDEC #twice", "#CALCSTR #word")
        if rng.random() < 0.5:
            yield from self._block(1, 1)
        yield "@"
        sections = ["START", "LINE", *rng.sample(("TOOLCHG", "RAP", "user", "END"), 2), "a", "b"]
        if rng.random() < 0.3:
            sections.insert(rng.randint(0, 3), "CYCLCHG")
        for at, name in enumerate(sections):
            self._callable = [each for each in sections[at + 1 :] if each.islower()]
            yield from (f"@{name}", *self._block(rng.randint(1, 4), 2), "@")
        self._callable, self._computing = [], True
        yield from ("@$twice", *self._block(rng.randint(0, 2), 1), f"#RETNUM({self._value(1)})", "@")
        yield from ("@$word", *self._block(rng.randint(0, 1), 1), f"#RETSTR({self._text()})", "@")
        yield from ("@gear", "0,M41", "1,M42", "2,M43", "@", "@rows", "0,A", "1,B", "2,C", "3,D", "@")

    def _block(self, count: int, depth: int) -> list[str]:
        return [line for _ in range(count) for line in self._statement(depth)]

    def _statement(self, depth: int) -> list[str]:
        rng = self._rng
        sort = rng.random() if depth else rng.random() * 0.62
        if sort < 0.5:
            return ["".join(self._simple() for _ in range(rng.choice((1, 1, 1, 2, 3))))]
        if sort < 0.56:
            return [self._bracket(2)]
        if sort < 0.62:
            return [self._leaving()]
        if sort < 0.9:
            return self._if(depth - 1)
        return self._repeat(depth - 1)

    def _simple(self) -> str:
        rng = self._rng
        choices = [self._eval] * 12 + [self._output] * 4 + [self._mark, self._lookup, self._fmt, self._block_number]
        return rng.choice(choices)()

    def _eval(self) -> str:
        rng = self._rng
        if rng.random() < 0.2:
            return f"#EVAL(#{rng.choice(TEXTS)}={self._text()})"
        if rng.random() < 0.1:
            return f"#EVAL(#{rng.choice(TABLES)}={rng.choice(('0', '1', '2', '3', self._value(1)))})"
        name = rng.choice((*MINE, *MINE, *MINE, "FEED", "BLK"))
        if rng.random() < 0.4:
            return f"#EVAL(#{name}=#{name}{rng.choice('+-')}{rng.choice(NUMBERS[1:4])})"
        return f"#EVAL(#{name}={self._value(2)})"

    def _output(self) -> str:
        rng = self._rng
        return rng.choice(
            (f"X#{rng.choice(MINE)} ", "#gear ", "X#XPOS ", "F#FEED ", "#twice ", "#word ", "M08 ", "#S1 ")
        )

    def _mark(self) -> str:
        names = ",".join(f"#{name}" for name in self._rng.sample(("XPOS", "FEED", *MINE), 2))
        return f"#{self._rng.choice(('RESET', 'UPDATE'))}({names})"

    def _lookup(self) -> str:
        return f"#TABLE(rows,{self._rng.choice(('1', '#V1', '#n', '#COOLNT'))})"

    def _fmt(self) -> str:
        return self._rng.choice(("#FMT(#F_Decimal,D5.2)", "#FMT(#V1,T6.1)", "#FMT(#n,T6.0)"))

    def _block_number(self) -> str:
        return self._rng.choice((f"#SETBLK({self._value(1)})", "#ONBLK", "#EVMD(#x=1/#V1)"))

    def _leaving(self) -> str:
        rng = self._rng
        if self._callable and rng.random() < 0.7:
            return f"#{rng.choice(('CALL', 'CALL', 'CALL', 'GOTO'))}({rng.choice(self._callable)})"
        return rng.choice(("#EXIT", "#EXITC", f"<X#XPOS>#IF({self._test()})<#{rng.choice(('EXIT', 'EXITC'))}>"))

    def _bracket(self, depth: int) -> str:
        rng = self._rng
        words = rng.sample(("#XPOS", "#FEED", "#V1", "#V2", "#n", "#gear", "#twice"), rng.randint(1, 3))
        inside = rng.choice(("", "#OR", "#AND", "#EXC")).join(f"A{word}" for word in words)
        inner = self._bracket(depth - 1) if depth and rng.random() < 0.3 else self._eval() if rng.random() < 0.3 else ""
        other = f"#ELSE<{self._simple()}>" if rng.random() < 0.3 else ""
        return f"<{inside}{inner}>{other}"

    def _if(self, depth: int) -> list[str]:
        rng = self._rng
        sort = rng.random()
        if sort < 0.7:
            head = f"#IF({self._tests()})<"
        elif sort < 0.9:
            right = rng.choice((*LITERALS, "", f"#{rng.choice(TEXTS)}"))
            head = f"#IFSTR(#{rng.choice((*TEXTS, 'word'))}{rng.choice(('=', '<>'))}{right})<"
        else:
            head = f"#IFCHG(#{rng.choice(MINE)},#XPOS)<"
        if rng.random() < 0.5:
            return [f"{head}{self._simple()}>" + (f"#ELSE<{self._simple()}>" if rng.random() < 0.5 else "")]
        found = [head, *self._block(2, depth), ">"]
        if rng.random() < 0.5:
            found[-1:] = [">#ELSE<", *self._block(1, depth), ">"]
        return found

    def _repeat(self, depth: int) -> list[str]:
        rng = self._rng
        count = rng.choice(("0", "1", "2", "3", "#V1", "#n", "#V2"))
        if rng.random() < 0.4:
            return [f"#REPEAT({count})<{self._simple()}>"]
        return [f"#REPEAT({count})", "<", *self._block(2, depth), ">"]

    def _tests(self) -> str:
        found = self._test()
        for _ in range(self._rng.choice((0, 0, 0, 1, 2))):
            found += f",#{self._rng.choice(('AND', 'OR'))} {self._test()}"
        return found

    def _test(self) -> str:
        rng = self._rng
        left, right = f"#{rng.choice((*MINE, *MINE, 'FEED', 'gear', 'twice'))}", self._value(1)
        if rng.random() < 0.6:
            right = rng.choice(NUMBERS)
        sides = [left, right]
        if rng.random() < 0.2:
            sides.reverse()
        return f"{sides[0]}{rng.choice(RELATIONS)}{sides[1]}"

    def _value(self, depth: int) -> str:
        rng = self._rng
        sort = rng.random() if depth else rng.random() * 0.5
        if sort < 0.25:
            return rng.choice(NUMBERS)
        if sort < 0.5:
            words = (*MINE, *MINE, *SYSTEM, "gear", "ON", "OFF", "S1", *(() if self._computing else ("twice",)))
            return f"#{rng.choice(words)}"
        if sort < 0.75:
            return f"({self._value(depth - 1)}{rng.choice('+-*/^')}{self._value(depth - 1)})"
        if sort < 0.85:
            return f"{rng.choice(ONE)}({self._value(depth - 1)})"
        if sort < 0.95:
            return f"{rng.choice(TWO)}({self._value(depth - 1)},{self._value(depth - 1)})"
        return rng.choice(("PI", f"STRLEN(#{rng.choice(TEXTS)})", "-#V1"))

    def _text(self) -> str:
        rng = self._rng
        sort = rng.random()
        if sort < 0.6:
            return rng.choice(LITERALS)
        if sort < 0.8:
            return f"#{rng.choice((*TEXTS, 'V1'))}"
        return f"STRSUB(#{rng.choice(TEXTS)},{rng.choice(('1', '2', '0', '#V1'))},{rng.choice(('1', '2', '#n'))})"
