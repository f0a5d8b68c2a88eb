"""What deburr reads of its own: baselines, kept results, reports to be merged. It is used or refused, whoever wrote it."""

from __future__ import annotations

import json
from collections.abc import Iterator
from functools import cache
from io import StringIO
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from deburr.cli import baseline, reporters
from deburr.cli.cache import Cache
from deburr.cli.disk import Disk
from deburr.cli.fingerprint import digest
from deburr.cli.kept import Keeper
from deburr.cli.merge import merged
from deburr.cli.reports import read
from deburr.cli.result import Result
from deburr.cli.run import Options
from deburr.cli.style import Style
from deburr.config import ConfigError
from deburr.finding import Severity
from deburr_grammar.dialects import by_name
from fuzz.choices import Choices, joined

_NAME = "0123456789abcdef"


@cache
def _folder() -> TemporaryDirectory[str]:
    return TemporaryDirectory(prefix="deburr-fuzz-")


def run(data: bytes) -> None:
    """Which of them, and its bytes."""
    choices = Choices(data)
    choices.pick((_baseline, _cache, _entry, _report))(choices)


def _file(name: str, data: bytes) -> str:
    path = Path(_folder().name) / name
    path.parent.mkdir(exist_ok=True)
    path.write_bytes(data)
    return str(path)


def _baseline(choices: Choices) -> None:
    path = _file("baseline.json", choices.rest())
    try:
        found = baseline.load(path)
    except ConfigError as error:
        assert all(message.startswith(path) for message in error.messages)
        return
    assert len(found) >= len(found.known())
    found.renewed(Result(()), whole=False).save()
    assert baseline.load(path).entries.keys() <= found.entries.keys()


def _cache(choices: Choices) -> None:
    """A kept result as it lies on the disk: what is not whole is none."""
    data = choices.rest()
    _file(f"{_NAME[:2]}/{_NAME[2:]}", data)
    found = Cache(_folder().name).get(_NAME)
    mark, _, body = data.partition(b"\n")
    assert found is None or mark.decode() == digest(_NAME, body)


def _entry(choices: Choices) -> None:
    """A kept result that is whole and says anything."""
    cache, data = Cache(_folder().name), choices.rest()
    _file(f"{_NAME[:2]}/{_NAME[2:]}", f"{digest(_NAME, data)}\n".encode() + data)
    outcome = Keeper(cache, Disk(), Options()).find(_NAME, "/a.ngc", Severity.ERROR)
    if outcome is not None:
        assert outcome.dialect is None or by_name(outcome.dialect)
        _reported(Result((outcome,)))


def _report(choices: Choices) -> None:
    """A report that is merged, and said again in each form."""
    path = _file("report.json", choices.rest())
    try:
        result = merged([read(path)], Severity.ERROR, True)
    except ConfigError as error:
        assert all(message.startswith(path) for message in error.messages)
        return
    _reported(result)


def _reported(result: Result) -> None:
    for name in reporters.names():
        out = StringIO()
        reporters.by_name(name).report(result, out, Style(False, "/"))
        out.getvalue().encode()


def _finding(**more: Any) -> dict[str, Any]:
    place = {"row": 1, "column": 3}
    found: dict[str, Any] = {
        "rule": "rs274.comment-nested",
        "severity": "error",
        "message": "nested",
        "filename": "/a.ngc",
        "dialect": "rs274",
        "fingerprint": "00:1",
        "location": place,
        "end_location": place,
        "related": [],
        "fix": None,
    }
    return {**found, **more}


def seeds() -> Iterator[bytes]:
    """One of each, right and wrong."""
    yield joined((0,), json.dumps({"version": 1, "findings": {"a.ngc": {"00:1": "rs274.limit"}}}))
    yield joined((0,), '{"version": 2}')
    yield joined((0,), '{"findings": {"a": {"b": 1}}}')
    body = b'{"dialect":"rs274"}'
    yield joined((1,), f"{digest(_NAME, body)}\n".encode() + body)
    entry = {
        "dialect": "rs274",
        "reason": "r",
        "origin": "",
        "asides": [["/a.ngc", 1, "why", "what"]],
        "texts": {},
        "folders": {},
    }
    said = ["rs274.comment-nested", 3, "m", ["/a.ngc", 0, 1, 0, 2], [[["/a.ngc", 0, 1, 0, 2], "r", False]], None]
    yield joined((2,), json.dumps({**entry, "findings": [said], "keys": ["00"]}))
    yield joined((2,), json.dumps({**entry, "findings": [], "keys": [], "asides": []}))
    related = {
        "filename": "/b.ngc",
        "message": "m",
        "entered": True,
        "location": {"row": 2, "column": 1},
        "end_location": {"row": 2, "column": 9},
    }
    edit = {"content": "x", "location": {"row": 1, "column": 1}, "end_location": {"row": 1, "column": 2}}
    fix = {"message": "m", "applicability": "safe", "edits": [edit]}
    yield joined((3,), json.dumps([_finding(related=[related], fix=fix)]))
    yield joined((3,), json.dumps(_finding()) + "\n" + json.dumps(_finding(severity="warning")) + "\n")
    yield joined((3,), json.dumps([_finding(location={"row": 0, "column": True})]))
    part = {"shard": {"number": 1, "of": 2}, "failed": [{"filename": "/a.ngc", "message": "m"}]}
    yield joined((3,), json.dumps({**part, "findings": [_finding()]}))
    yield joined((3,), json.dumps(_finding()) + "\n" + json.dumps(part))
