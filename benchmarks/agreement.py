"""`python -m benchmarks.agreement`: how far deburr and LinuxCNC's interpreter agree, as a page. Never judges a program itself."""

from __future__ import annotations

import argparse
import re
import subprocess
import sys
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path

from benchmarks.compare import AT_END, Case, Compared, Verdict, compared

LEAST = 0.99
"""The share of programs on which the two must agree, of those refused and of those run."""
_KINDS = {
    "fact": "facts about the interpreter",
    "fault": "programs with one fault",
    "mended": "the same, mended",
}
_HEAD = """# Agreement with LinuxCNC's interpreter

Made by `python -m benchmarks.agreement --write docs/agreement.md`, which runs each program through the interpreter
(`rs274`, linuxcnc-uspace {version}) and through deburr. A test makes it again and fails if this page is another.

- A program that the interpreter refuses is **agreed** if deburr has an error on the line at which it stops, or one that
  points to that line; **elsewhere** if all errors are on other lines; **silent** if there is none.
- A program that it runs is **clean** if deburr has no error, **false** if it has one.
- At the end of a file no line is named. These errors tell why the file was read to its end:
{at_end}
- A program that is refused for what only a run can tell, and of which deburr says nothing there, counts for neither.

## Programs

| | refused | agreed | elsewhere | silent | | run | clean | false | | needs a run | left out |
|---|---|---|---|---|---|---|---|---|---|---|---|
"""


def share(results: Iterable[Compared], good: Verdict, *bad: Verdict) -> float:
    """Which part of the programs of these verdicts is good; 1 if there are none."""
    counts = Counter(result.verdict for result in results)
    return counts[good] / (sum(counts[verdict] for verdict in (good, *bad)) or 1)


def refused_share(results: Iterable[Compared]) -> float:
    """Of what is refused for a reason that the text tells, the part that deburr finds there."""
    return share(results, Verdict.AGREED, Verdict.ELSEWHERE, Verdict.SILENT)


def run_share(results: Iterable[Compared]) -> float:
    """Of what runs, the part in which deburr finds no error."""
    return share(results, Verdict.CLEAN, Verdict.FALSE)


def report(results: Sequence[Compared]) -> str:
    """The page."""
    at_end = "\n".join(f"  - `{said}`: {', '.join(f'`{rule}`' for rule in rules)}" for said, rules in AT_END.items())
    parts = [_HEAD.format(version=version(), at_end=at_end).rstrip("\n")]
    parts += [
        _total(title, [result for result in results if result.case.kind == kind]) for kind, title in _KINDS.items()
    ]
    parts += [_total("**all**", results), ""]
    parts += _shares(results)
    parts += [
        "",
        "## Rules",
        "",
        "| rule | agreed | elsewhere | silent | false |",
        "|---|---|---|---|---|",
        *_rules(results),
    ]
    parts += ["", "## Where they differ", "", *_differences(results)]
    parts += ["", "## What needs a run", "", "| why | programs |", "|---|---|", *_reasons(results)]
    parts += ["", "## Left out", "", "| program | why |", "|---|---|", *_excluded(results)]
    return "\n".join(parts) + "\n"


def version() -> str:
    """The release of the interpreter's package."""
    query = ["dpkg-query", "-W", "-f", "${Version}", "linuxcnc-uspace"]
    return subprocess.run(query, capture_output=True, text=True, check=True).stdout


def _total(title: str, results: Sequence[Compared]) -> str:
    count = Counter(result.verdict for result in results)
    refused = [count[verdict] for verdict in (Verdict.AGREED, Verdict.ELSEWHERE, Verdict.SILENT)]
    run = [count[verdict] for verdict in (Verdict.CLEAN, Verdict.FALSE)]
    cells = [title, sum(refused), *refused, "", sum(run), *run, "", count[Verdict.RUN], count[Verdict.EXCLUDED]]
    return _row(*cells)


def _shares(results: Sequence[Compared]) -> Iterator[str]:
    yield f"Agreed of those refused: {refused_share(results):.1%}. Clean of those run: {run_share(results):.1%}."


def _rules(results: Sequence[Compared]) -> Iterator[str]:
    known = _rule_by_message(results)
    counts = Counter((rule, result.verdict) for result in results for rule in _told_by(result, known))
    for rule in sorted({rule for rule, _ in counts}):
        columns = (Verdict.AGREED, Verdict.ELSEWHERE, Verdict.SILENT, Verdict.FALSE)
        yield _row(f"`{rule}`", *(counts[rule, verdict] for verdict in columns))


def _told_by(result: Compared, known: Mapping[str, str]) -> Sequence[str]:
    """The rules that a program counts for: those that spoke, else the one that should have."""
    verdict, rules = result.judged
    if verdict is Verdict.AGREED:
        return [result.case.rule] if result.case.rule in rules else rules[:1]
    if verdict is Verdict.FALSE:
        return rules
    if verdict in (Verdict.ELSEWHERE, Verdict.SILENT):
        return [result.case.rule or known.get(_kind(result), _kind(result))]
    return ()


def _rule_by_message(results: Iterable[Compared]) -> dict[str, str]:
    """Which rule says most often what the interpreter says with a message."""
    counts = Counter((_kind(result), result.judged[1][0]) for result in results if result.verdict is Verdict.AGREED)
    return {message: rule for (message, rule), _ in reversed(counts.most_common())}


def _kind(result: Compared) -> str:
    """The message without what belongs to the program."""
    return re.sub(r":.*|'[^']*'|#<[^>]*>|[0-9]+", "", result.said.message).strip()


def _differences(results: Iterable[Compared]) -> Iterator[str]:
    differing = [each for each in results if each.verdict in (Verdict.ELSEWHERE, Verdict.SILENT, Verdict.FALSE)]
    yield from ("| program | the interpreter | deburr |", "|---|---|---|") if differing else ("Nowhere.",)
    for result in differing:
        found = "; ".join(f"line {one.place.line + 1}: `{one.rule}`" for one in result.findings)
        yield _row(_name(result.case), _cell(result.said.message) or "runs it", found or "no error")


def _reasons(results: Iterable[Compared]) -> Iterator[str]:
    counts = Counter(result.reason for result in results if result.verdict is Verdict.RUN)
    for reason, count in sorted(counts.items(), key=str):
        yield _row(reason, count)


def _excluded(results: Iterable[Compared]) -> Iterator[str]:
    for result in results:
        if result.verdict is Verdict.EXCLUDED:
            yield _row(_name(result.case), result.excluded)


def _name(case: Case) -> str:
    return _cell(f"{case.name}, mended" if case.kind == "mended" else case.name)


def _cell(text: str) -> str:
    return text.replace("|", "\\|").replace("<", "&lt;")


def _row(*cells: object) -> str:
    return f"| {' | '.join(map(str, cells))} |"


def main(arguments: Sequence[str] | None = None) -> int:
    """Compare, print the page, and write it where asked; 1 if the two agree too seldom."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.agreement", description="Compare deburr with rs274.")
    parser.add_argument("--write", type=Path, metavar="FILE", help="write the page as Markdown")
    options = parser.parse_args(arguments)
    # The programs are the tests' data.
    sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))
    from support.agreement import EXCLUDED, cases

    results = compared(cases(), EXCLUDED)
    page = report(results)
    if options.write:
        options.write.write_text(page, encoding="utf-8")
    print(page)
    return 0 if min(refused_share(results), run_share(results)) >= LEAST else 1


if __name__ == "__main__":
    sys.exit(main())
