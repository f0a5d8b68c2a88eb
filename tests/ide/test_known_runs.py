"""What is known without a run is what every run finds: random programs are run, and each line that was reached is compared."""

from __future__ import annotations

import random
import re
from collections.abc import Callable, Iterator

import pytest

from deburr.expand import expand
from deburr.expand.job import Program
from deburr.ide.known import known
from deburr.symbols.index import at
from support.views import at_cursor

PROGRAMS = 150


class Writer:
    """Writes random programs in which two variables are set and read in straight lines, branches, loops and calls."""

    def __init__(self, seed: int) -> None:
        self._chance = random.Random(seed)
        self._labels = 0

    def rs274(self) -> str:
        sub = ["o<s> sub", *self._rs274(1), "o<s> endsub"]
        return "\n".join([*sub, "G21 G90 G17 F100", *self._rs274(0), "M2", ""])

    def z32(self) -> str:
        lines = ["(P)", "!HA=1; HB=2!"]
        for number in range(self._chance.randrange(6, 16)):
            target = self._chance.randrange(number + 1, number + 5)
            value, name = self._chance.randrange(9), self._chance.choice("AB")
            line = self._chance.choice([f"X<H{name}>", f"!H{name}={value}!", f"H{name}{value}", f"!IF H{name}>{value}; H{name}={value}!", f"!IF HA>{value}; GON{target}!", "!GOP5!", f"!PAL[HA]={value}!"])  # fmt: skip
            lines.append(
                line if line.startswith("!") and "GON" not in line else f"N{number} {line}" if "!" not in line else line
            )
        labels = [f"N{number}" for number in range(25) if not any(each.startswith(f"N{number} ") for each in lines)]
        return "\n".join([*lines, *labels, "X<HA> Y<HB>", "M30", ":5", "!HB=7!", "X<HB>", "G26", ""])

    def _rs274(self, depth: int) -> list[str]:
        found: list[str] = []
        for _ in range(self._chance.randrange(2, 6)):
            value, number = self._chance.randrange(9), self._chance.choice((1, 2, 31, 32))
            self._labels += 1
            inner = self._rs274(depth + 1) if depth < 3 else []
            label = f"o{self._labels}{depth}"
            found += self._chance.choice(
                [
                    [f"#{number}={value}"],
                    [f"#{number}={value}", f"G1 X#{number}"],
                    [f"#[{number}+0]={value}"],
                    [f"G1 X#{number}"],
                    [f"G1 X#{number}"],
                    [f"{label} if [#{number} GT {value}]", *inner, f"{label} else", f"#31={value}", f"{label} endif"],
                    [f"{label} repeat [2]", *inner, f"{label} endrepeat"],
                    ["o<s> call [3]"] if depth == 0 else [],
                ]
            )
        return found


WRITERS: dict[str, Callable[[Writer], str]] = {"rs274": Writer.rs274, "z32": Writer.z32}


@pytest.mark.parametrize("dialect", WRITERS)
def test_what_is_known_is_what_every_run_finds(dialect: str) -> None:
    compared = 0
    for seed in range(PROGRAMS):
        text = WRITERS[dialect](Writer(seed))
        compared += sum(1 for _ in checked(dialect, text))
    assert compared > PROGRAMS, "values are known, and lines with them are run"


def checked(dialect: str, text: str) -> Iterator[None]:
    """Every flat line whose source reads a variable of which the value is known."""
    view, _ = at_cursor(dialect, text + "<|>")
    run = expand([Program(view.file, view.document)], view.ruleset, view.host)
    for number, flat in enumerate(run.lines):
        row = run.source_map.origin(number).row
        source = view.document.line(row)
        for match in re.finditer(r"(?:X|Y)(?:#[0-9]+|<H[AB]>)", source):
            placed = at(view.document, row, match.start() + 3)
            assert placed is not None
            value = known(view, placed)
            said = re.search(rf"{match[0][0]}(-?[0-9.]+)", flat)
            if value is not None and said is not None:
                assert float(said[1]) == float(value.first), f"{row + 1}: {source}\n{text}"
                yield


def test_the_programs_are_of_many_forms() -> None:
    texts = [Writer(seed).rs274() for seed in range(PROGRAMS)]
    for form in ("repeat", "else", "call", "#[31+0]"):
        assert sum(form in text for text in texts) > PROGRAMS // 4, form
