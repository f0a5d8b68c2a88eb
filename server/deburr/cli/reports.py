"""Reports of `deburr check` read back: findings, and which part of a check they are. Joins nothing."""

from collections.abc import Iterable, Iterator
from typing import Any, NamedTuple

from deburr import paths
from deburr.cli.result import Shard
from deburr.config import ConfigError
from deburr.finding import Finding, Fix, Place, Related, Severity
from deburr_grammar.text import Edit, Pos


class Part(NamedTuple):
    """What a report says of itself: which of several parts it is, and what could not be checked there."""

    shard: Shard
    failed: tuple[str, ...]


class Report(NamedTuple):
    """A report: its findings as objects, and what it says of itself if it is of a part."""

    name: str
    objects: list[Any]
    parts: list[Part]

    def findings(self) -> Iterator[tuple[Finding, str, str]]:
        """Each finding with its dialect and the fingerprint of its line; ConfigError if there is something else."""
        for said in self.objects:
            try:
                yield _finding(said), said["dialect"], said["fingerprint"].rpartition(":")[0]
            except (AttributeError, KeyError, TypeError, ValueError):
                raise ConfigError(_none(self.name)) from None


def read(name: str) -> Report:
    """The report in a file: a list, or an object a line; of a part an object around the list, or a last line."""
    try:
        found = list(_objects(paths.data(name).decode("utf-8-sig")))
        parts = [_part(each) for each in found if _closes(each)]
    except OSError as error:
        raise ConfigError(f"{name}: {error.strerror}") from None
    except (KeyError, TypeError, ValueError, RecursionError):
        raise ConfigError(_none(name)) from None
    return Report(name, [each for each in found if not _closes(each)], parts)


def _objects(text: str) -> Iterator[Any]:
    """All that a report holds; what it says of itself without its findings."""
    from json import loads

    try:
        whole = loads(text)
    except ValueError:
        whole = None
    if isinstance(whole, list):
        yield from whole
    elif isinstance(whole, dict) and _closes(whole) and "findings" in whole:
        yield from [*whole.pop("findings"), whole]
    else:
        yield from (loads(line) for line in text.split("\n") if line.strip())


def _closes(said: Any) -> bool:
    return isinstance(said, dict) and "shard" in said and "rule" not in said


def _part(said: Any) -> Part:
    number, of = said["shard"]["number"], said["shard"]["of"]
    if not (type(number) is type(of) is int and 1 <= number <= of):
        raise ValueError
    return Part(Shard(number, of), tuple(f"{each['filename']}: {each['message']}" for each in said["failed"]))


def _none(name: str) -> str:
    return f"{name}: no report of `deburr check --output-format json` or json-lines"


def _finding(said: Any) -> Finding:
    """A finding as a report has it; an error of a builtin kind if it has none."""
    related = tuple(
        Related(_place(each, each["filename"]), str(each["message"]), bool(each["entered"])) for each in said["related"]
    )
    fix, severity = said["fix"], Severity[said["severity"].upper()]
    return Finding(
        str(said["rule"]),
        severity,
        str(said["message"]),
        _place(said, said["filename"]),
        related,
        None if fix is None else Fix(str(fix["message"]), tuple(_edits(fix["edits"])), fix["applicability"] == "safe"),
    )


def _edits(said: Iterable[Any]) -> Iterator[Edit]:
    for each in said:
        _, line, col, end_line, end_col = _place(each, "")
        yield Edit(Pos(line, col), Pos(end_line, end_col), str(each["content"]))


def _place(said: Any, file: str) -> Place:
    start, end = said["location"], said["end_location"]
    numbers = (start["row"], start["column"], end["row"], end["column"])
    if not isinstance(file, str) or any(type(number) is not int or number < 1 for number in numbers):
        raise ValueError
    return Place(file, *(number - 1 for number in numbers))
