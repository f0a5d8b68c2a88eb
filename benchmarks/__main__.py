"""`python -m benchmarks`: measure, print the report, and write it where asked."""

from __future__ import annotations

import argparse
import os
import platform
import re
import sys
from dataclasses import replace
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING

from benchmarks import editor, rows, vscode

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Sequence

TABLES = {
    "Opening, beside tree-sitter's full parse": rows.opening,
    "Throughput of `check`": rows.throughput,
    "Expanding, beside LinuxCNC's interpreter": rows.expanding,
    "Typing, beside tree-sitter's incremental parse": rows.typing,
    "In an editor, beside a stock server of pygls": rows.serving,
    "In VS Code": vscode.table,
    "Proven values": rows.proving,
    "Memory": rows.memory,
    "Starting": rows.starting,
    "What no one writes": rows.odd,
}
_HEAD = """# Performance

Figures of one run of `python -m benchmarks --write docs/performance.md`, measured side by side on one machine. Other
machines give other times; the ratios stay. Nothing in the tests asserts a time: they assert the work that is done.

- *CAM* is a generated program of {cam:,} lines: 97.5 % numbered moves, the rest comments, tool changes, O-words and
  expressions. *Macros* is a generated program of {macro:,} lines with thousands of different lines: subprograms of named parameters,
  expressions, branches, loops and probing, and the calls of all of them. Both are clean, and their seeds are fixed (`benchmarks/corpus.py`).
- *Opening* counts from the text to the answer, in a fresh process whose grammar tables and rules are loaded, best of {repeats}.
- *Typing* counts from the edit to the findings of the edited line, all faults of structure, the partners of the line's
  brackets and the modal state there; the median over {places} random places in parts of the file not edited before.
  tree-sitter makes a tree and none of the rest. Not in the table: a line that changes the state in which all lines below
  are read (`o9 do`, `o<a> sub`, `M2`, `%`) has the chunks below summed anew, once for each such state: some 0.2 to 0.4 s
  in the large program. And all faults are listed each time, so a program with a million of them is slow to type in.
- *Proven values* are those of generated programs of {values:,} lines and 40 routines (`benchmarks/macros.py`), in seconds of the processor,
  from a program that is read to what its variables hold; then after another number in one of its lines. The garbage collector is set as in
  the server. What they cost someone who types is measured in the large CAM program, beside the same server with the proofs turned off
  (`benchmarks/unproven.py`).
- *Memory* is by how much the resident set of a fresh process rises above where it stands with the text loaded
  (the kernel's high-water mark, reset before).
- *In an editor* is measured over standard input and output, at random places and with a pause of {pause:g} ms between keystrokes, in
  which the check of the whole program begins again. The times are those of the server's processor; in brackets stands how long the
  client waited, which a busy machine makes longer. The stock server (`benchmarks/stock.py`) has pygls' own document store and
  looks for unbalanced brackets in the whole text, no more.
- *In VS Code* is measured within the page of a real one, from a key to the frame that shows it, a key at a time. The other is the same
  text opened as plain text, for {lines:,} lines of CAM; for the toolpath, typing in the same window before it was asked for. The
  table alone: `python -m benchmarks.vscode`.
- `python -m benchmarks --quick` takes seconds and says little; `--only typing` measures one table.
"""
_QUICK = rows.Sizes(
    cam=5_000,
    macro=2_000,
    mixed=2_000,
    odd=60_000,
    places=20,
    tree_sitter_places=2,
    passes=2_000,
    flat=2_000,
    values=400,
    starts=3,
    stock_places=2,
    repeats=1,
    judged=False,
)


def main(arguments: Sequence[str] | None = None) -> int:
    """Measure what was asked for; 1 if a budget does not hold."""
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks", description="Measure deburr beside others, in one run."
    )
    parser.add_argument("--quick", action="store_true", help="small programs, few repetitions")
    parser.add_argument("--only", action="append", metavar="WORD", help="only tables whose title holds the word")
    parser.add_argument("--write", type=Path, metavar="FILE", help="write the report as Markdown")
    options = parser.parse_args(arguments)
    sizes = _QUICK if options.quick else rows.Sizes()
    with TemporaryDirectory() as folder:
        files = rows.Files.written(Path(folder), sizes)
        report = list(_report(files, sizes, options.only))
    if options.write:
        options.write.write_text("\n".join([_head(sizes), *(part for part, _ in report)]), encoding="utf-8")
    return 1 if any(row.holds is False for _, row in report if row) else 0


def _report(files: rows.Files, sizes: rows.Sizes, only: Sequence[str] | None) -> Iterator[tuple[str, rows.Row | None]]:
    for title, table in TABLES.items():
        if only and not any(word.lower() in title.lower() for word in only):
            continue
        head = f"\n## {title}\n\n| what | deburr | the other | ratio | budget | |\n|---|---|---|---|---|---|"
        yield _said(head), None
        for row in table(files, sizes):
            judged = row if sizes.judged else replace(row, holds=None)
            yield _said(_line(judged)), judged


def _said(text: str) -> str:
    print(text, flush=True)
    return text


def _line(row: rows.Row) -> str:
    holds = {True: "holds", False: "**broken**", None: ""}[row.holds]
    return f"| {row.what} | {row.ours} | {row.other} | {row.ratio} | {row.budget} | {holds} |"


def _head(sizes: rows.Sizes) -> str:
    return (
        _HEAD.format(
            cam=sizes.cam,
            macro=sizes.macro,
            repeats=sizes.repeats,
            places=sizes.places,
            pause=editor.PAUSE * 1_000,
            lines=vscode.LINES,
            values=sizes.values,
        )
        + "\n"
        + "\n".join(_machine())
    )


def _machine() -> Iterable[str]:
    cpu = Path("/proc/cpuinfo")
    model = re.search(r"(?m)^model name\s*:\s*(.+)", cpu.read_text()) if cpu.exists() else None
    yield f"Machine: {model[1] if model else platform.processor()}, {os.cpu_count()} cores, {platform.system()} {platform.machine()}, Python {platform.python_version()}"
    yield "Libraries: " + ", ".join(
        f"{name} {_version(name)}" for name in ("lark", "pygls", "tree-sitter", "tree-sitter-gcode")
    )


def _version(name: str) -> str:
    try:
        return version(name)
    except PackageNotFoundError:
        return "not installed"


if __name__ == "__main__":
    sys.exit(main())
