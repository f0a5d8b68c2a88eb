"""Small files beside programs: values of variables, tools, stored parameters, machine files. What is wrong stands in the file."""

from __future__ import annotations

from collections.abc import Iterator

from deburr.formats import faults, machine, parameters, tools
from deburr.formats.variables import read_values
from deburr_grammar.text import split_lines
from fuzz.choices import Choices, joined
from support.places import check_span


def run(data: bytes) -> None:
    """Which of them, and the text."""
    choices = Choices(data)
    read = choices.pick((_values, _json, _tools, _parameters, _machine))
    text = choices.rest().decode("utf-8", "replace")
    read(text, split_lines(text))


def _values(text: str, lines: list[str], path: str = "a.vars") -> None:
    found = read_values(text, path)
    for value in found.known.values():
        check_span(value.line, value.span, lines)
    for defect in found.defects:
        check_span(defect.line, defect.span, lines)
        assert defect.why
    assert found.whole or found.defects


def _json(text: str, lines: list[str]) -> None:
    _values(text, lines, "a.json")


def _tools(text: str, lines: list[str]) -> None:
    found = tools.read(text)
    assert tuple(faults("tool-table", text)) == found.faults
    for fault in found.faults:
        check_span(fault.line, fault.span, lines)


def _parameters(text: str, lines: list[str]) -> None:
    found = parameters.read(text)
    assert all(1 <= number <= parameters.LAST for number in found.values)
    assert tuple(faults("parameters", text)) == found.faults
    for fault in found.faults:
        check_span(fault.line, fault.span, lines)


def _machine(text: str, lines: list[str]) -> None:
    for fault in machine.read(text).faults:
        check_span(fault.line, fault.span, lines)
        assert fault.message


def seeds() -> Iterator[bytes]:
    """One of each, right and wrong."""
    yield joined((0,), "# values\nDepth = -5\nMat=Steel\nMat=Alu\nno sign\n = 3\na|b=2\n")
    yield joined((1,), '{"Depth": -5.0, "Mat": "Steel", "a": {"b": [1]}, "n": null, "x|y": 1}')
    yield joined((1,), '{"a": 1, "a": 2,\n "b": NaN}')
    yield joined((2,), "T1 P1 Z25.4 D6.35 ;drill\nt2 p2 z-1\nT x\nP3 D1\n; only words\n")
    yield joined((3,), "5161 1.5\n5220 1.0\n0 1\n31\n1e3 2\n5601\t-3\n99 nan\n99 1e999\n")
    yield joined(
        (4,),
        'arc-center = "absolute"\nblock-step = 5\n[formats]\nF_Feed = "D4.4"\n[tables]\nMOV = ["G00"]\n[words]\nXPOS = "decimal"\n',
    )
    yield joined(
        (4,),
        '[tables]\nMOV = 3\n"9x" = ["a\\nb"]\n[formats]\nnope = 1\n[words]\nx = "y"\nblock-start = true\nq = [[1]]\n',
    )
