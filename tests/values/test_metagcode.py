"""MetaGCODE: what is proven of variables at each directive, and that it holds in runs (spec/metagcode.md §5)."""

from collections.abc import Iterator
from contextlib import contextmanager
from decimal import Decimal
from random import Random

import pytest

from deburr.expand import Budget, Inputs, Job, Program, drive
from deburr.expand.metagcode.build import Run
from deburr.expand.metagcode.lines import Directive
from deburr.values import proving
from deburr.values.domain import Value
from deburr_grammar.dialects.metagcode.forms import number
from support.values import MAIN, Known, analysed, known

NAMES = ("a", "b", "c", "d")
NUMBERS = ("0", "1", "2", "-1", "-3", "0.5", "5", "10", ".3", "-0.0", "7.25", "5.00", "1e3", "Steel", "")
LITERALS = ("0", "1", "2", "-1", "5", "10", "0.3", "-2.5", "Steel")
OPERATORS = ("greaterthan", "lessthan", "equalto", "notequalto")

SILENT = {
    "a variable of which nothing is known": "#LOOP1 |z| |s| c\nG1 Z-|z|\n#ENDLOOP1\n",
    "behind the condition": "#IF1 |z| lessthan 0 n\nG0 Z5\n#ENDIF1\nG1 Z-|z|\n",
    "the bound itself": "#IF1 |z| lessthan 5 n\n#IF2 |z| equalto 5 n\n#ENDIF2\n#ENDIF1\n",
    "a text that is a number in another spelling": "#IF1 |z| equalto 5.0 a\n#IF2 |z| equalto 5 n\nG0\n#ENDIF2\n#ENDIF1\n",
    "behind a loop over it": "#IF1 |z| greaterthan 9 n\n#LOOP1 |z| 2 c\nG1 Z|z|\n#ENDLOOP1\n#IF2 |z| lessthan 11 n\nG0\n#ENDIF2\n#ENDIF1\n",
    "in a loop over it": "#IF1 |z| greaterthan 9 n\n#LOOP1 |z| 2 c\n#IF2 |z| lessthan 5 n\nG1 Z|z|\n#ENDIF2\n#ENDLOOP1\n#ENDIF1\n",
    "a sign in a comment": "#IF1 |z| lessthan 0 n\n(down to -|z|)\n#ENDIF1\n",
    "a snippet that nobody has": "#IF1 |z| equalto 0 n\n#FILE gone.txt\n#LOOP1 |d| |z| c\nG1 Z|d|\n#ENDLOOP1\n#ENDIF1\n",
}  # fmt: skip


@pytest.mark.parametrize("name", SILENT)
def test_nothing_is_said_of_what_is_not_proven(name: str) -> None:
    assert [each for each in proving(analysed(SILENT[name], "metagcode")) if each is not None] == []


SNIPPET = {"Snippets/cut.txt": "#LOOP1 |d| |s| c\nG1 Z|d|\n#ENDLOOP1\n"}
INCLUDED = "#IF1 |s| equalto 0 n\n#FILE cut.txt\n#ENDIF1\n"


def test_a_fault_in_a_snippet_is_found_from_the_text_that_puts_it_in() -> None:
    found = [each for each in proving(analysed(INCLUDED, "metagcode", SNIPPET)) if each is not None]
    assert [(each.rule, *each.place) for each in found] == [
        ("metagcode.loop-step-zero", "Snippets/cut.txt", 0, 11, 0, 14)
    ]
    assert [(each.place.file, each.place.line) for each in found[0].related] == [(MAIN, 0)]


def test_a_snippet_that_is_right_at_one_place_is_not_wrong() -> None:
    both = f"{INCLUDED}#FILE cut.txt\n"
    assert [each for each in proving(analysed(both, "metagcode", SNIPPET)) if each is not None] == []


def test_a_snippet_may_ask_what_its_text_has_decided() -> None:
    files = {"Snippets/guard.txt": "#IF1 |d| lessthan 5 n\nG1\n#ENDIF1\n"}
    program = "#IF1 |d| greaterthan 10 n\n#FILE guard.txt\n#ENDIF1\n"
    assert [each for each in proving(analysed(program, "metagcode", files)) if each is not None] == []


@pytest.mark.parametrize("first", range(0, 1_500, 250))
def test_runs_see_what_is_proven(first: int) -> None:
    """Each value that a run sees at a directive lies in the range of its line, and no line is passed of which a fault is proven."""
    seen = sum(_watched(seed) for seed in range(first, first + 250))
    assert seen > 250


def test_a_wrong_range_would_be_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    """The proof that runs are looked at: with `lessthan` taken for its opposite, many differ."""
    from deburr.values.metagcode import conditions

    monkeypatch.setitem(conditions._MIRRORED, "lessthan", "lessthan")
    monkeypatch.setattr(conditions, "above", conditions.below)
    with pytest.raises(AssertionError, match="seed"):
        for seed in range(90_000, 90_400):
            _watched(seed)


def _program(rng: Random) -> str:
    return "\n".join(_block(rng, 3)) + "\n"


def _block(rng: Random, depth: int) -> Iterator[str]:
    for _ in range(rng.randint(1, 3)):
        label = rng.randint(1, 99)
        sort = rng.random() if depth else 1.0
        if sort < 0.6:
            sides = [f"|{rng.choice(NAMES)}|", rng.choice((*LITERALS, f"|{rng.choice(NAMES)}|"))]
            rng.shuffle(sides)
            yield f"#IF{label} {sides[0]} {rng.choice(OPERATORS)} {sides[1]} {rng.choice('nna')}"
            yield from _block(rng, depth - 1)
            yield f"#ENDIF{label}"
        elif sort < 0.8:
            total, step = rng.choice(NAMES), rng.choice(("1", "2.5", f"|{rng.choice(NAMES)}|"))
            yield f"#LOOP{label} |{total}| {step} {rng.choice('cr')}"
            yield from _block(rng, depth - 1)
            yield f"#ENDLOOP{label}"
        else:
            yield f"G1 X{rng.choice(('', '-', '+'))}|{rng.choice(NAMES)}|"


def _watched(seed: int) -> int:
    rng = Random(seed)
    analysis = analysed(_program(rng), "metagcode")
    found = known(analysis)
    if found is None:
        return 0
    watch, seen = _Watch(found), 0
    with watch.watching():
        for _ in range(3):
            define = {each: rng.choice(NUMBERS) for each in NAMES}
            programs = (Program(MAIN, analysis.document),)
            job = Job(programs, analysis.ruleset, analysis.host, watch, Inputs(define), Budget(2_000, 0))
            for _ in drive(job):
                pass
            assert watch.wrong == [], f"seed {seed} with {define}"
            seen += watch.seen
    return seen


class _Watch:
    """Looks at the variables before each directive that is followed."""

    def __init__(self, found: Known) -> None:
        self._known = found
        self.wrong: list[tuple[object, ...]] = []
        self.seen = 0

    def line(self, text: str) -> None:
        """Nobody wants the lines."""

    @contextmanager
    def watching(self) -> Iterator[None]:
        """Have each directive looked at."""
        followed = Run._directive

        def following(run: Run, at: int, step: Directive) -> int:
            if step.bracket.word.startswith("#END"):
                return followed(run, at, step)
            self._look(step.row, run._values)
            behind = followed(run, at, step)
            if step.row in self._known.stopping:
                self.wrong.append((step.row, "is passed"))
            return behind

        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(Run, "_directive", following)
            yield

    def _look(self, row: int, values: dict[str, str]) -> None:
        env = self._known.before.get(row)
        if env is None:
            self.wrong.append((row, "is reached"))
        for key, value in (env or {}).items():
            if isinstance(key, str):
                self.seen += 1
                got = number(values[key].strip(" \t"))
                if not (value.wild if got is None else _holds(value, got)):
                    self.wrong.append((row, key, value, values[key]))


def _holds(value: Value, got: Decimal) -> bool:
    if value.empty or not value.low <= got <= value.high:
        return False
    return not (value.holed and got == 0) and (not value.step or value.has(float(got)))
