"""What an editor does to LinuxCNC's own programs leaves what the interpreter makes of them as it is, and done again does nothing more."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import pytest

from deburr.analysis import Analysis
from deburr.fix import applied
from deburr.host import Host
from deburr.ide.fixes import quick_fixes
from deburr.ide.refactor import Cannot
from deburr.ide.refactorings import rebuilt
from deburr.ide.view import View
from deburr.symbols import Act
from deburr.symbols.index import on_line
from deburr_grammar.document import Document
from deburr_grammar.text import Pos
from support.flat import DIALECT, RULES, Case, ran
from support.oracle import SAMPLES
from support.pages import MemoryHost
from support.samples import sample

pytestmark = pytest.mark.oracle
STEPS = ("fix-all", "allow", "renumber-lines", "renumber-blocks", "inline", "extract")
LEAST = {"fix-all": 3, "allow": 40, "renumber-lines": 4, "renumber-blocks": 50, "inline": 5, "extract": 50}
"""So many programs each step changes at least: fewer, and it refuses what it need not."""
TRIED = 3


@dataclass(frozen=True)
class Alone:
    """The programs of one folder, as they were written."""

    host: Host

    def view(self, file: str, like: View) -> View | None:
        text = self.host.read(file)
        return None if text is None else View(file, Document.parse(text, DIALECT), RULES, self.host, self)

    def views(self, like: View) -> Iterator[View]:
        yield like


def view_of(case: Case, text: str) -> View:
    host = MemoryHost({**case.all_files, case.main: text})
    return View(case.main, Document.parse(text, DIALECT), RULES, host, Alone(host))


def step(name: str, view: View) -> str:
    """A program behind a step; the same where it is refused."""
    try:
        if name == "allow":
            return allowed(view)
        if name == "inline":
            return inlined(view)
        if name == "extract":
            return extracted(view)
        return applied(view.document, rebuilt(view, name, Pos(0, 0), Pos(0, 0)).edits).text
    except Cannot:
        return view.document.text


def allowed(view: View) -> str:
    """With comments that allow all that is found, one line after the other from the last one up."""
    document, seen = view.document, set[int]()
    for finding in reversed(Analysis(document, RULES, view.file, view.host).findings()):
        if finding.place.line not in seen:
            fixes = quick_fixes(replace(view, document=document), [finding])
            edits = next((each.edits for each in fixes if each.title.startswith("Allow")), ())
            document = applied(document, edits)
            seen.add(finding.place.line)
    return document.text


def inlined(view: View) -> str:
    """With the first constant that can be inlined in the place of its name."""
    document = view.document
    found = [(each, line) for line in range(document.line_count) for each in on_line(document, line)]
    sets = [
        (str(each.symbol), line, each.span.start) for each, line in found if each.act is Act.SET and each.symbol.name
    ]
    return first_that_holds(view, "inline", [(line, line, col) for _, line, col in sorted(sets)])


def extracted(view: View) -> str:
    """With three lines as a subprogram, of the middle or else of some other place."""
    count = view.document.line_count
    starts = [count * part // 7 for part in (3, 5, 2)]
    return first_that_holds(view, "extract", [(start, min(start + 3, count - 1), 0) for start in starts])


def first_that_holds(view: View, name: str, places: Sequence[tuple[int, int, int]]) -> str:
    for first, last, col in places[:TRIED]:
        try:
            found = rebuilt(view, name, Pos(first, col), Pos(last, col))
        except Cannot:
            continue
        return applied(view.document, found.edits).text
    return view.document.text


def chained(case: Case, changed: Counter[str]) -> str:
    """A program behind all steps; each of those that make a program another one once does so only once."""
    text = case.text
    for name in STEPS:
        made = step(name, view_of(case, text))
        changed[name] += made != text
        if name not in ("inline", "extract"):
            assert step(name, view_of(case, made)) == made, (case.name, name)
        text = made
    return text


def guilty(case: Case) -> str:
    """The first step behind which a program does something else."""
    text = case.text
    for name in STEPS:
        text = step(name, view_of(case, text))
        now = ran({**case.all_files, case.main: text}, case.main)
        if (now.status, now.calls) != (case.original.status, case.original.calls):
            return f"{case.name}: {name}: {now.message} {now.echo}"
    return f"{case.name}: only now and then"


def test_every_action_leaves_what_the_samples_do_as_it_is(capsys: pytest.CaptureFixture[str]) -> None:
    programs = [sample(path) for path in sorted(SAMPLES.rglob("*.ngc"))]
    assert len(programs) == 185
    changed: Counter[str] = Counter()
    texts = {case.name: chained(case, changed) for case in programs}
    differ, compared = [], 0
    for case in (each for each in programs if each.original.status == 0):
        now = ran({**case.all_files, case.main: texts[case.name]}, case.main)
        compared += texts[case.name] != case.text
        if (now.status, now.calls) != (0, case.original.calls):
            differ.append(guilty(case))
    with capsys.disabled():
        print(f"\nactions: {compared} programs that run do the same; changed by {dict(changed)}")
    assert differ == []
    assert {name: changed[name] for name in STEPS if changed[name] < LEAST[name]} == {}
