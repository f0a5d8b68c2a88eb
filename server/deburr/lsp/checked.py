"""What is known of one program: its findings by what decides them, and who waits for all of them. Checks nothing."""

from __future__ import annotations

import asyncio
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from deburr.finding import joined
from deburr.ide.held import Held
from deburr.ide.moved import Structure, structure_of
from deburr.steps import paced

if TYPE_CHECKING:
    from deburr.analysis import Analysis
    from deburr.finding import Finding, Place
    from deburr.lsp.files import Stamp
    from deburr.needs import Needs


@dataclass(eq=False)
class Checked:
    """What is known of a program. ``whole``: all of it was gone through in its present state.

    Its findings in the program itself are ``still`` (what it says as it stands), those of its ``blocks``, and ``ran`` (what its values and
    a run of it add, and what waits for these); ``elsewhere`` are those in other files.
    """

    still: Held = field(default_factory=Held)
    blocks: tuple[Finding, ...] = ()
    ran: Held = field(default_factory=Held)
    structure: Structure = field(default_factory=Structure)
    """What `blocks` hang on."""
    elsewhere: dict[str, tuple[Finding, ...]] = field(default_factory=dict)
    whole: bool = False
    needs: Needs | None = None
    stamp: Stamp | None = None
    waiting: list[asyncio.Future[None]] = field(default_factory=list)


def learning(
    known: Checked, analysis: Analysis, found: Iterable[Finding], ran: Held, later: frozenset[Finding] = frozenset()
) -> Iterator[None]:
    """Keep findings by what decides them, found out in steps. ``ran`` and, among all findings, ``later`` are those that a run added in the program."""
    blocks = {rule.name for rule in analysis.ruleset.on_structure}
    parts: tuple[list[Finding], list[Finding]] = [], []
    elsewhere: dict[str, list[Finding]] = {}
    for finding in paced(found):
        if finding is None:
            yield
        elif finding.place.file != analysis.file:
            elsewhere.setdefault(finding.place.file, []).append(finding)
        elif finding not in later:
            parts[finding.rule in blocks].append(finding)
    still = yield from Held.holding(parts[False])
    known.still, known.blocks, known.ran = still, tuple(parts[True]), ran
    known.structure = structure_of(analysis)
    known.elsewhere = {file: tuple(each) for file, each in elsewhere.items()}


def once(findings: Iterable[Finding]) -> list[Finding]:
    """Findings in order, each once, whoever finds it."""
    found: dict[tuple[Place, str, str], Finding] = {}
    for finding in findings:
        known = found.get(finding.order)
        found[finding.order] = finding if known is None else joined(known, finding)
    return sorted(found.values(), key=order)


def order(finding: Finding) -> tuple[Place, str, str]:
    """Findings are shown in this order."""
    return finding.order


def release(known: Checked | None, error: Exception | None) -> None:
    """Tell those who wait for a check that it is done, or that it never will be."""
    waiting = known.waiting if known is not None else []
    for future in waiting:
        if future.done():
            continue
        if error is None:
            future.set_result(None)
        else:
            future.set_exception(error)
    waiting.clear()
