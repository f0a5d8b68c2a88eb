"""Toolpaths that a template is given: CL text and events. What is wrong stands in the file, and what is right can be used."""

from __future__ import annotations

import math
from collections.abc import Iterator

from deburr.formats import cl, events
from deburr_grammar.text import split_lines
from fuzz.choices import Choices, joined
from support.code import ROOT
from support.places import check_span

_EVENT = '{"section": "LINE", "set": {"XPOS": 1.5, "NAME": "a"}}'
_ODD = ('{"section": 1}', '{"set": {"X": [1]}}', "[]", "{", '{"set": {"X": NaN}}', '{"section": "A", "more": null}')


def run(data: bytes) -> None:
    """Which of the two, and the text."""
    choices = Choices(data)
    is_cl, text = choices.byte() % 2 == 0, choices.rest().decode("utf-8", "replace")
    lines = split_lines(text)
    if is_cl:
        _cl(text, lines)
        return
    found = events.read(text)
    for fault in found.faults:
        check_span(fault.line, fault.span, lines)
        assert fault.message
    for event in found.events:
        check_span(event.line, event.span, lines)
        for given in event.values:
            check_span(event.line, given.value_span, lines)
            assert isinstance(given.value, str) or math.isfinite(given.value)


def _cl(text: str, lines: list[str]) -> None:
    found = cl.read(text)
    for fault in found.faults:
        check_span(fault.line, fault.span, lines)
        assert fault.message
    for statement in found.statements:
        check_span(statement.line, statement.span, lines)
        assert all(map(math.isfinite, statement.numbers)), statement


def seeds() -> Iterator[bytes]:
    """The example, a toolpath of all statements, and events."""
    yield joined((0,), (ROOT / "examples" / "cgt" / "mill.cl").read_bytes()[:1_500])
    yield joined(
        (0,), "PARTNO/A $$ b\nUNITS/MM\nLOADTL/1,ADJUST,1\nSPINDL/RPM,800,CLW\nCOOLNT/ON\nCUTCOM/LEFT,1\nFROM/0,0,9\n"
    )
    yield joined(
        (0,),
        "RAPID\nGOTO/1,2,3\nFEDRAT/100,MMPM\nCIRCLE/0,0,0,0,0,1,5\nGOTO/ 1 , $\n 2,3,0,0,1\nCYCLE/DRILL,5\nDELAY/1\nFINI\n",
    )
    yield joined((1,), "\n".join([_EVENT, *_ODD, "", _EVENT]))
