"""Random RS274 expressions and the names that they may read. Knows no statement."""

from collections import Counter
from dataclasses import dataclass, field
from random import Random

ARITHMETIC = ("+", "-", "*", "/", "MOD", "**")
COMPARED = ("EQ", "NE", "GT", "GE", "LT", "LE")
LOGICAL = ("AND", "OR", "XOR")
FUNCTIONS = ("ABS", "ACOS", "ASIN", "ATAN", "COS", "EXISTS", "EXP", "FIX", "FUP", "LN", "ROUND", "SIN", "SQRT", "TAN")
_SAFE = {"+": "{} + {}", "-": "{} - {}", "*": "{} * {}", "/": "{} / [ABS[{}]+0.5]", "MOD": "{} MOD [ABS[{}]+0.25]"}
_TAMED = {
    "ACOS": "[[{}] MOD 1]",
    "ASIN": "[[{}] MOD 1]",
    "LN": "[ABS[{}]+0.125]",
    "SQRT": "[ABS[{}]]",
    "EXP": "[[{}] MOD 3]",
}
"""What keeps a value where a function takes it."""
NUMBERS = (
    "0",
    "1",
    "2",
    "3.5",
    "-4",
    ".25",
    "10.",
    "0.1",
    "7",
    "-0.75",
    "100",
    "12.125",
    "1.00005",
    "0.99995",
    "45",
    "90",
)
NUMBERED = (*range(1, 9), *range(31, 41), 100, 101, 102, 200, 4999)
"""Parameters that programs set as they like; others count."""


@dataclass
class Scope:
    """What a stretch of program may read: its own names, and how deep in calls it stands."""

    names: list[str] = field(default_factory=list)
    counters: list[str] = field(default_factory=list)
    in_sub: bool = False


class Expressions:
    """Expressions of one program. ``wild``: values may leave the range of a function."""

    def __init__(self, rng: Random, used: Counter[str], predefined: list[str], wild: float) -> None:
        self._rng = rng
        self._used = used
        self._predefined = predefined
        self._wild = wild

    def value(self, scope: Scope, depth: int = 3) -> str:
        """A value of any size, in brackets unless it is one word."""
        roll = self._rng.random()
        if depth == 0 or roll < 0.3:
            return self._leaf(scope)
        if roll < 0.75:
            return f"[{self.inner(scope, depth)}]"
        if roll < 0.8:
            return f"-{self.value(scope, depth - 1)}"
        return self._function(scope, depth)

    def small(self, scope: Scope, limit: int = 400) -> str:
        """A value from 0 up to a limit: what a word can bear."""
        return f"[[{self.inner(scope, 2)}] MOD {limit}]"

    def truth(self, scope: Scope) -> str:
        """A condition, with its brackets."""
        first = self._compared(scope)
        if self._rng.random() < 0.4:
            operator = self._pick(LOGICAL)
            return f"[[{first}] {operator} [{self._compared(scope)}]]"
        return f"[{first}]"

    def inner(self, scope: Scope, depth: int) -> str:
        """What stands between brackets."""
        found = self._chain(scope, depth)
        roll = self._rng.random()
        if roll < 0.1:
            return f"{found} {self._pick(COMPARED)} {self._chain(scope, depth - 1)}"
        if roll < 0.16:
            return f"{found} {self._pick(LOGICAL)} {self._chain(scope, depth - 1)}"
        return found

    def read(self, scope: Scope) -> str:
        """A parameter, by its number, its name or indirectly."""
        rng = self._rng
        roll = rng.random()
        if roll < 0.4 or not (scope.names or scope.counters):
            return f"#{rng.choice(NUMBERED)}"
        if roll < 0.75:
            return f"#<{rng.choice([*scope.names, *scope.counters])}>"
        if roll < 0.85:
            return f"#[{rng.choice((1, 31, 100))}+{rng.randint(0, 2)}]"
        if roll < 0.9:
            return f"#[31+FIX[ABS[{self._leaf(scope)}] MOD 6]]"
        name = rng.choice(self._predefined)
        self._used[name] += 1
        return name

    def _chain(self, scope: Scope, depth: int) -> str:
        found = self.value(scope, max(depth - 1, 0))
        for _ in range(self._rng.choice((0, 1, 1, 2))):
            operator = self._pick(ARITHMETIC)
            other = self.value(scope, max(depth - 1, 0))
            if operator == "**":
                wild = self._rng.random() < self._wild
                base = found if wild else f"[ABS[{found}] MOD 4]"
                found = f"{base} ** {other if wild else self._rng.choice((0, 1, 2, 3, 0.5, '[1+1]'))}"
            elif self._rng.random() < self._wild:
                found = f"{found} {operator} {other}"
            else:
                found = _SAFE[operator].format(found, other)
        return found

    def _compared(self, scope: Scope) -> str:
        if self._rng.random() < 0.1:
            return self._exists(scope)
        return f"{self._chain(scope, 1)} {self._pick(COMPARED)} {self._chain(scope, 1)}"

    def _exists(self, scope: Scope) -> str:
        self._used["EXISTS"] += 1
        name = self._rng.choice([*scope.names, "nowhere", "_nowhere", "_x"])
        return f"EXISTS[#<{name}>]"

    def _function(self, scope: Scope, depth: int) -> str:
        name = self._rng.choice(FUNCTIONS)
        if name == "EXISTS":
            return self._exists(scope)
        self._used[name] += 1
        inner = self.inner(scope, depth - 1)
        if name == "ATAN":
            return f"ATAN[{inner}]/[{self.inner(scope, depth - 1)}]"
        tamed = _TAMED.get(name) if self._rng.random() >= self._wild else None
        return f"{name}{tamed.format(inner)}" if tamed is not None else f"{name}[{inner}]"

    def _leaf(self, scope: Scope) -> str:
        return self._rng.choice(NUMBERS) if self._rng.random() < 0.5 else self.read(scope)

    def _pick(self, operators: tuple[str, ...]) -> str:
        operator = self._rng.choice(operators)
        self._used[operator] += 1
        return operator
