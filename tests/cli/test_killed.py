"""Whatever deburr writes, `kill -9` leaves the old file or the new one, at any time; and what else it leaves is nobody's."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from pathlib import Path
from typing import NamedTuple

import pytest

from deburr.cli.files import targets
from deburr.cli.replacing import replacing
from deburr.configfile import Configs
from support.code import ROOT

PART = ".deburr-part"
HOURS = 30 * 3_600
PLAIN = "G21  G90 G17\ng0x1\nm2\n"
MOVES = "G21 G90 G17\nF100\nG0 X0 Y0 Z5\nG1 X10 Z-1\nG1 Y20\nM2\n"
NESTED = "G21 G90 G17\nG1 X1 F100 (a (b) c)\nM2\n"
ROUGH = "(P)\ng0 x1\n!HA=1;;HB=2!\nM30\n"
REPORTS = {"1.json": "[]", "2.json": ""}


class Kind(NamedTuple):
    """A sort of file that is written: the command, what lies in the folder, and the file."""

    name: str
    command: str
    files: dict[str, str]
    written: str


KINDS = [
    Kind("report", "check --no-cache --exit-zero --output-format json=r.json a.ngc", {"a.ngc": NESTED, "r.json": "old"}, "r.json"),
    Kind("report, new", "check --no-cache --exit-zero --output-file r a.ngc", {"a.ngc": NESTED}, "r"),
    Kind("fixed program", "check --no-cache --exit-zero --fix a.z32", {"a.z32": ROUGH}, "a.z32"),
    Kind("baseline", "check --no-cache --baseline b.json --update-baseline a.ngc", {"a.ngc": NESTED, "b.json": '{"findings": {}}'}, "b.json"),
    Kind("merged report", "merge 1.json 2.json --output-format sarif=r", {**REPORTS, "r": "old"}, "r"),
    Kind("laid out program", "format a.ngc", {"a.ngc": PLAIN}, "a.ngc"),
    Kind("flat program", "expand a.ngc -o flat.txt", {"a.ngc": MOVES, "flat.txt": "old"}, "flat.txt"),
    Kind("source map", "expand a.ngc -o flat.txt --source-map m.json", {"a.ngc": MOVES, "flat.txt": "G21", "m.json": "{}"}, "m.json"),
    Kind("SVG", "plot a.ngc -o a.svg", {"a.ngc": MOVES, "a.svg": "old"}, "a.svg"),
    Kind("PNG", "plot a.ngc -o a.png", {"a.ngc": MOVES}, "a.png"),
    Kind("page", "plot a.ngc -o a.html", {"a.ngc": MOVES, "a.html": "old"}, "a.html"),
    Kind("configuration", "init", {"a.ngc": MOVES}, "deburr.toml"),
    Kind("cache", "check --exit-zero .", {"a.ngc": NESTED, "b.ngc": MOVES}, ".deburr_cache/CACHEDIR.TAG"),
]  # fmt: skip


@pytest.mark.skipif(not hasattr(os, "fork"), reason="processes are forked here so that many can be killed")
@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.name)
def test_the_old_file_or_the_new_one_is_left(kind: Kind, tmp_path: Path) -> None:
    start, place = tmp_path / "start", tmp_path / "left"
    start.mkdir()
    place.mkdir()
    for name, text in kind.files.items():
        (start / name).write_text(text)
    names = dying(tmp_path, place, *kind.command.split())
    whole = contents(place / "whole")
    assert whole[kind.written] != contents(start).get(kind.written), "nothing was written"
    assert len([name for name in names if name.startswith("step")]) >= 4
    for name in names:
        intact(contents(place / name), contents(start), whole)
        taken_for_programs(place / name)
    if kind.name != "configuration":
        later(place)
        dying(tmp_path, place, "again", *kind.command.split())
        assert {name: litter(place / name) for name in names if litter(place / name)} == {}
        for name in names:
            assert contents(place / name)[kind.written] == whole[kind.written]


def dying(folder: Path, place: Path, *arguments: str) -> list[str]:
    """What the runs say that they have left."""
    environment = {**os.environ, "PYTHONPATH": str(ROOT / "tests")}
    command = [sys.executable, "-m", "support.dying", str(place), *arguments]
    done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return sorted(path.name for path in place.iterdir())


def contents(folder: Path) -> dict[str, bytes]:
    """All files below a folder."""
    return {
        path.relative_to(folder).as_posix(): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()
    }


def intact(left: dict[str, bytes], old: dict[str, bytes], new: dict[str, bytes]) -> None:
    """Each file is as it was or as it was to be; what has no place among them is a part."""
    for name, data in left.items():
        if not name.endswith(PART):
            assert data in (old.get(name), new.get(name)), name
    assert old.keys() <= left.keys()


def litter(folder: Path) -> list[str]:
    return [name for name in contents(folder) if name.endswith(PART)]


def taken_for_programs(folder: Path) -> None:
    """Not even where all files of a folder are said to be programs."""
    configuration = folder.parent / "deburr.toml"
    configuration.write_text('[files]\n"**" = "rs274"\n')
    found = targets([str(folder)], Configs(only=str(configuration)))
    assert [each.file for each in found if each.file.endswith(PART)] == []
    configuration.unlink()


def later(place: Path) -> None:
    """Days pass."""
    then = time.time() - HOURS
    for path in place.rglob("*"):
        os.utime(path, (then, then))


def test_two_that_write_one_file_at_once_do_not_mix(tmp_path: Path) -> None:
    path = tmp_path / "a"
    with replacing(str(path)) as one:
        one.write(b"one" * 5_000)
        with replacing(str(path)) as two:
            two.write(b"two")
        assert path.read_bytes() == b"two"
    assert path.read_bytes() == b"one" * 5_000
    assert list(tmp_path.iterdir()) == [path]


def test_what_others_have_left_is_taken_away_when_it_is_old(tmp_path: Path) -> None:
    path = tmp_path / "a"
    left = [tmp_path / f".a.{number}{PART}" for number in range(4)]
    for each in left:
        each.write_text("half")
    with replacing(str(path)) as out:
        out.write(b"1")
    assert sorted(tmp_path.iterdir()) == [*left, path], "somebody may still be writing"
    later(tmp_path)
    with replacing(str(path)) as out:
        out.write(b"2")
    assert list(tmp_path.iterdir()) == [path]
    assert path.read_bytes() == b"2"


def test_a_new_file_does_not_take_the_place_of_one_that_came_meanwhile(tmp_path: Path) -> None:
    path = tmp_path / "a"
    with pytest.raises(FileExistsError), replacing(str(path), new=True) as out:
        out.write(b"ours")
        path.write_bytes(b"theirs")
    assert path.read_bytes() == b"theirs"
    assert list(tmp_path.iterdir()) == [path]


def test_a_name_may_be_as_long_as_the_disk_takes(tmp_path: Path) -> None:
    path = tmp_path / ("é" * 127)
    with replacing(str(path)) as out:
        out.write(b"1")
    assert path.read_bytes() == b"1"
