"""The rows of the report: what is compared with what, and the budget. Never measures anything itself."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from benchmarks import corpus, editor, ours, proofs, running, theirs
from benchmarks.macros import LANGUAGES
from benchmarks.measure import isolated, processes

MB = 1_000_000


@dataclass(frozen=True)
class Sizes:
    """How large the corpora are, in lines or bytes, and how often things are repeated."""

    cam: int = corpus.CAM_LINES
    macro: int = corpus.MACRO_LINES
    mixed: int = corpus.MIXED_LINES
    odd: int = 30_000_000
    places: int = 200
    tree_sitter_places: int = 3
    passes: int = 1_000_000
    flat: int = 100_000
    values: int = 2_000
    starts: int = 11
    stock_places: int = 5
    repeats: int = 3
    judged: bool = True
    """Whether the sizes are those for which the budgets are meant."""


@dataclass(frozen=True)
class Row:
    """One line of the report. ``holds`` is None where there is no budget."""

    what: str
    ours: str
    other: str = ""
    ratio: str = ""
    budget: str = ""
    holds: bool | None = None


@dataclass(frozen=True)
class Files:
    """The corpora on disk."""

    cam: str
    small: str
    small_macro: str
    macro: str
    mixed: str
    hand: str
    loop: str
    flat: str
    odd: dict[str, str]

    @classmethod
    def written(cls, folder: Path, sizes: Sizes) -> Files:
        """All corpora as files of a folder."""
        lines, size = max(sizes.odd // 30, 10), max(sizes.odd // 6, 100)
        odd = {
            f"one line of {sizes.odd / MB:g} MB": corpus.one_line(sizes.odd),
            f"{lines:,} lines of `o1 if [1]`": corpus.unclosed(lines),
            f"a table of {size / MB:g} MB": corpus.table(size),
            f"{size / MB:g} MB of random bytes": corpus.junk(size),
        }
        return cls(
            _file(folder, "cam.ngc", corpus.cam(sizes.cam)),
            _file(folder, "small.ngc", corpus.cam(min(sizes.cam, 1_000))),
            _file(folder, "small-macro.ngc", corpus.macro(min(sizes.macro, 1_000))),
            _file(folder, "macro.ngc", corpus.macro(sizes.macro)),
            _file(folder, "mixed.ngc", corpus.mixed(sizes.mixed)),
            _file(folder, "hand.ngc", corpus.cam(40)),
            _file(folder, "loop.ngc", corpus.loop(sizes.passes)),
            _file(folder, "flat.ngc", corpus.cam(sizes.flat)),
            {what: _file(folder, f"odd{number}.ngc", text) for number, (what, text) in enumerate(odd.items())},
        )


def _file(folder: Path, name: str, text: str) -> str:
    path = folder / name
    path.write_bytes(text.encode("utf-8"))
    return str(path)


def opening(files: Files, sizes: Sizes) -> Iterator[Row]:
    """From the text to findings, beside a full parse."""
    for name, path, budgets in (("CAM", files.cam, (0.5, 3.0, 7.0)), ("macros", files.macro, (None, None, None))):
        parse = isolated(theirs.full, path)
        works = (ours.open_visible, ours.open_syntax, ours.open_all)
        for work, what, budget in zip(
            works, ("findings of the visible part", "all problems and structure", "findings of all rules"), budgets
        ):
            taken = min(isolated(work, path) for _ in range(sizes.repeats))
            said = f"≤ {budget:g} s" if budget else ""
            yield Row(
                f"open {name}: {what}",
                _time(taken),
                _time(parse),
                _ratio(parse, taken),
                said,
                taken <= budget if budget else None,
            )


def throughput(files: Files, sizes: Sizes) -> Iterator[Row]:
    """Megabytes a second over the CAM program, beside the interpreter."""
    size = Path(files.cam).stat().st_size / MB
    run = min(isolated(theirs.interpreter, files.cam) or 0 for _ in range(sizes.repeats))
    for work, what, least, times in (
        (ours.open_syntax, "syntax and structure", 20.0, 0.0),
        (ours.open_all, "all rules", 5.0, 2.0),
    ):
        taken = min(isolated(work, files.cam) for _ in range(sizes.repeats))
        speed = size / taken
        other, ratio = (f"{size / run:.1f} MB/s (`rs274 -g`)", _ratio(run, taken)) if run else ("", "")
        budget = f"≥ {least:g} MB/s" + (f", ≥ {times:g} ×" if times else "")
        holds = speed >= least and (not run or run >= times * taken)
        yield Row(f"check, {what}", f"{speed:.1f} MB/s", other, ratio, budget, holds)


def typing(files: Files, sizes: Sizes) -> Iterator[Row]:
    """A keystroke in the large CAM program, beside a small one and beside an incremental parse."""
    large, small = (
        isolated(ours.keystrokes, files.cam, sizes.places),
        isolated(ours.keystrokes, files.small, sizes.places),
    )
    parse = isolated(theirs.keystrokes, files.cam, sizes.tree_sitter_places)
    for name, taken in large.items():
        yield Row(
            f"{name}, {sizes.cam:,} lines",
            _time(taken),
            _time(parse[name]),
            _ratio(parse[name], taken),
            "≤ 1 ms",
            taken <= 0.001,
        )
        yield Row(
            f"{name}, against {min(sizes.cam, 1_000):,} lines",
            _time(taken),
            _time(small[name]),
            f"{taken / small[name]:.2f} ×",
            "≤ 2 ×",
            taken <= 2 * small[name],
        )


def serving(files: Files, sizes: Sizes) -> Iterator[Row]:
    """What an editor waits for, beside a stock server of pygls on the same texts."""
    yield from _started(sizes)
    yield _previewed(sizes)
    programs = (
        (f"{sizes.cam:,} lines", files.cam, files.small),
        (f"macros, {sizes.macro:,} lines", files.macro, files.small_macro),
    )
    for name, path, few in programs:
        small = editor.times(editor.OURS, few, sizes.places)
        found, stock = (
            editor.times(module, path, places)
            for module, places in ((editor.OURS, sizes.places), (editor.STOCK, sizes.stock_places))
        )
        typed = (found.typed.spent, stock.typed.spent)
        yield Row(
            f"{name}: keystroke to published diagnostics",
            _taken(found.typed),
            _taken(stock.typed),
            _ratio(typed[1], typed[0]),
            "≤ 5 ms, ≥ 50 ×",
            typed[0] <= 0.005 and typed[1] >= 50 * typed[0],
        )
        for method, taken in found.asked.items():
            other = small.asked[method]
            yield Row(
                f"{name}: {method}, against {min(sizes.cam, 1_000):,} such lines",
                _taken(taken),
                _taken(other),
                f"{taken.spent / other.spent:.2f} ×",
                "≤ 3 ms, ≤ 1.5 ×",
                taken.spent <= 0.003 and taken.spent <= 1.5 * other.spent,
            )
        yield Row(f"{name}: memory of the server", _size(found.resident), _size(stock.resident))


def _previewed(sizes: Sizes) -> Row:
    """A keystroke while an endless loop is previewed, beside one while nothing else is done."""
    alone, beside = editor.previewing(sizes.places)
    what = "keystroke while an endless loop is previewed, beside one alone"
    return Row(what, _taken(beside), _taken(alone), _ratio(alone.spent, beside.spent), "≤ 5 ms", beside.spent <= 0.005)


def _proven(files: Files, sizes: Sizes) -> Row:
    """A keystroke in the large program, beside one in a server that proves no values."""
    on, off = (
        min(editor.times(module, files.cam, sizes.places, requests=False).typed for _ in range(sizes.repeats))
        for module in (editor.OURS, editor.UNPROVEN)
    )
    ratio = on.spent / off.spent
    what = f"{sizes.cam:,} lines: keystroke, beside one without proven values"
    return Row(what, _taken(on), _taken(off), f"{ratio:.2f} ×", "≤ 1.1 ×", ratio <= 1.1)


def _started(sizes: Sizes) -> Iterator[Row]:
    found, stock = editor.starts(sizes.starts)
    for what, ours_, other, most in (
        ("start to the answer of `initialize`", found.initialized, stock.initialized, 0.2),
        ("start to the first hover", found.hover, stock.hover, 1.1),
    ):
        ratio = ours_.spent / other.spent
        yield Row(what, _taken(ours_), _taken(other), f"{ratio:.2f} ×", f"≤ {most:g} ×", ratio <= most)
    said = "in order" if found.in_order else "out of order"
    yield Row("requests sent before `initialize` was answered", said, "", "", "in order", found.in_order)


def memory(files: Files, _sizes: Sizes) -> Iterator[Row]:
    """Resident memory beyond the text, as multiples of it."""
    text = Path(files.cam).stat().st_size
    beyond, other = isolated(ours.memory, files.cam), isolated(theirs.memory, files.cam)
    yield Row(
        "CAM: peak beyond the text",
        _size(beyond),
        _size(other),
        f"{beyond / text:.1f} × the text, {other / text:.0f} × theirs",
        "≤ 3 ×",
        beyond <= 3 * text,
    )
    for name, path in (("macros", files.macro), ("10 % unique expressions", files.mixed)):
        beyond, text = isolated(ours.memory, path), Path(path).stat().st_size
        yield Row(f"{name} ({_size(text)}): peak beyond the text", _size(beyond), "", f"{beyond / text:.1f} × the text")


def expanding(files: Files, sizes: Sizes) -> Iterator[Row]:
    """Running programs to flat code, beside the interpreter that runs them to canonical commands."""
    for what, path, most in (
        (f"a loop of {sizes.passes:,} passes, arithmetic and a motion", files.loop, 3),
        (f"a flat program of {sizes.flat:,} lines", files.flat, 2),
    ):
        taken, run = isolated(running.expand, path), isolated(theirs.interpreter, path)
        ratio = _ratio(run, taken) if run else ""
        yield Row(
            what, _time(taken), _time(run) if run else "", ratio, f"≤ {most} ×", taken <= most * run if run else None
        )
    plain, mapped = (isolated(running.memory, files.loop, each) for each in (False, True))
    budget = 150 * MB
    yield Row(f"memory, {sizes.passes:,} flat lines to a file", _size(plain), "", "", "≤ 150 MB", plain <= budget)
    each = (mapped - plain) / sizes.passes
    yield Row("the same with a map", _size(mapped), "", f"{each:.0f} bytes a line", "≤ 40 bytes", each <= 40)


def proving(files: Files, sizes: Sizes) -> Iterator[Row]:
    """What variables can hold, the first time and after an edit; what that costs a keystroke."""
    for dialect in LANGUAGES:
        first, edited = isolated(proofs.proven, dialect, sizes.values)
        yield Row(f"{dialect}: values for the first time", _time(first), "", "", "≤ 150 ms", first <= 0.150)
        yield Row(f"{dialect}: values after an edit in a line", _time(edited), "", "", "≤ 10 ms", edited <= 0.010)
    yield _proven(files, sizes)


def odd(files: Files, sizes: Sizes) -> Iterator[Row]:
    """What no one writes: it must not hang, and a keystroke must stay one."""
    for name, path in {f"{sizes.mixed:,} lines, 10 % of them unique expressions": files.mixed, **files.odd}.items():
        taken, found = isolated(ours.everything, path)
        strokes = isolated(ours.keystrokes, path, max(sizes.places // 20, 1))
        yield Row(name, f"{_time(taken)}, {found:,} findings", f"keystroke {_time(max(strokes.values()))}")


def starting(files: Files, sizes: Sizes) -> Iterator[Row]:
    """Whole processes."""
    python = sys.executable
    commands = ([python, "-c", "pass"], [python, "-c", "import lark"], [python, "-m", "deburr", "check", files.hand])
    bare, lark, check = processes(commands, sizes.starts)
    yield Row(
        "`deburr check small.ngc` against `python -c pass`",
        _time(check),
        _time(bare),
        f"{check / bare:.1f} ×",
        "≤ 12 ×",
        check <= 12 * bare,
    )
    yield Row(
        "`deburr check small.ngc` against `python -c 'import lark'`",
        _time(check),
        _time(lark),
        f"{check / lark:.1f} ×",
        "≤ 2 ×",
        check <= 2 * lark,
    )


def _taken(taken: editor.Taken) -> str:
    return f"{_time(taken.spent)} ({_time(taken.waited)})"


def _time(taken: float) -> str:
    return (
        f"{taken:.2f} s"
        if taken >= 1
        else f"{taken * 1_000:.3g} ms"
        if taken >= 0.001
        else f"{taken * 1_000_000:.0f} µs"
    )


def _size(count: float) -> str:
    return f"{count / MB:.1f} MB"


def _ratio(other: float, taken: float) -> str:
    if taken > other:
        return f"{taken / other:.1f} × slower"
    return f"{other / taken:,.0f} × faster" if other >= 10 * taken else f"{other / taken:.1f} × faster"
