"""What work leaves behind goes at once, without a look for garbage: an editor that is never quiet for long never has one at what is old."""

from __future__ import annotations

import gc
from pathlib import Path
from typing import Any
from unittest.mock import Mock

import pytest

from deburr.lsp import garbage
from support.inside import Inside

EXAMPLES = Path(__file__).parents[2] / "examples"
PROGRAMS = {
    "rs274": "rs274/peck_drill.ngc",
    "metagcode": "metagcode/drill_cycle.mgc",
    "cgt": "cgt/mill.cgt",
    "z32": "z32/pocket.z32",
}
ROUNDS = 5
MOST = 100
"""Objects that only a look for garbage would find, for each round; a run of a short program has some thousands."""


def work(inside: Inside, uri: str, round_: int) -> None:
    """What somebody does with a program: type, look at what is found and at what it expands to, ask, be refused."""
    document: dict[str, Any] = {"uri": uri}
    start = {"line": 1, "character": 0}
    change = {"range": {"start": start, "end": start}, "text": f"x{round_} \n"}
    inside.notify(
        "textDocument/didChange", {"textDocument": document | {"version": round_ + 2}, "contentChanges": [change]}
    )
    inside.request("textDocument/diagnostic", {"textDocument": document})
    taken = {"range": {"start": start, "end": {"line": 2, "character": 0}}, "text": ""}
    inside.notify(
        "textDocument/didChange", {"textDocument": document | {"version": round_ + 100}, "contentChanges": [taken]}
    )
    inside.request("textDocument/diagnostic", {"textDocument": document})
    for method in ("hover", "completion", "definition"):
        inside.request(f"textDocument/{method}", {"textDocument": document, "position": start | {"line": 3}})
    inside.request("textDocument/codeLens", {"textDocument": document})
    inside.request("workspace/executeCommand", {"command": "deburr.expand", "arguments": [document]})
    assert inside.request("workspace/executeCommand", {"command": "deburr.expand", "arguments": [{"uri": 1}]})["code"]


@pytest.mark.parametrize("dialect", PROGRAMS)
def test_work_leaves_little_to_look_for(dialect: str, monkeypatch: pytest.MonkeyPatch) -> None:
    path = EXAMPLES / PROGRAMS[dialect]
    # Nothing is collected or set aside meanwhile.
    monkeypatch.setattr(garbage, "gc", Mock(get_count=gc.get_count))
    with Inside() as inside:
        inside.open(path.as_uri(), path.read_text(), dialect)
        # What is loaded and kept with the first of each is not counted.
        work(inside, path.as_uri(), 0)
        gc.unfreeze()
        gc.collect()
        gc.disable()
        try:
            for round_ in range(1, ROUNDS + 1):
                work(inside, path.as_uri(), round_)
            left = gc.collect()
        finally:
            gc.enable()
        assert left < ROUNDS * MOST
