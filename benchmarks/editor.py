"""What an editor waits for, over standard input and output: deburr's server and a stock one of pygls, on the same texts."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from random import Random
from statistics import median
from tempfile import TemporaryDirectory
from time import clock_gettime, perf_counter, sleep
from typing import Any, NamedTuple

from tests.support.client import PUSHED, Client, edit

from benchmarks.ours import SEED, read

OURS, STOCK, UNPROVEN = "deburr", "benchmarks.stock", "benchmarks.unproven"
"""The modules of the servers."""
ASKED = ("hover", "completion", "definition")
PAUSE = 0.05
"""Seconds between keystrokes: someone types, so the check of the whole program has begun again at the next one."""
_REST = 0.2
"""A server that does nearly nothing for so many seconds has nothing to do."""
_ENDLESS = "G21 G90\n#1=0\no1 while [#1 LT 100000000]\n#1=[#1+1]\no1 endwhile\nG0 X1\nM2\n"
_ROOT = Path(__file__).parents[1]
_NAME = re.compile(r"#<(\w+)>|o<(\w+)>|#([0-9]+)|([A-Z])[-0-9]")


class Taken(NamedTuple):
    """What something takes: seconds of the server's processor, and seconds until the client has the answer."""

    spent: float
    waited: float


class Times(NamedTuple):
    """Opening, medians of keystrokes and of requests, and the server's bytes in memory."""

    opened: Taken
    typed: Taken
    asked: dict[str, Taken]
    resident: int


class Start(NamedTuple):
    """From the start of a process to two of its answers; whether all answers came in the order of the requests."""

    initialized: Taken
    hover: Taken
    in_order: bool


class Clock:
    """Measures a server from now on; one that was just started, from its very beginning."""

    def __init__(self, client: Client, *, new: bool = False) -> None:
        # The clock of another process, as clock_getcpuclockid(3) makes it; only Linux is sure to have it.
        self._clock = (~client.process.pid << 3) | 2 if sys.platform == "linux" else None
        self._spent = 0.0 if new and self._clock else self._now()
        self._begun = perf_counter()

    def taken(self) -> Taken:
        """What was taken since."""
        return Taken(self._now() - self._spent, perf_counter() - self._begun)

    def _now(self) -> float:
        return perf_counter() if self._clock is None else clock_gettime(self._clock)


def middle(taken: Iterable[Taken]) -> Taken:
    """The median of each."""
    spent, waited = zip(*taken)
    return Taken(median(spent), median(waited))


@contextmanager
def server(module: str, **more: str) -> Iterator[Client]:
    """A server that has just been started, in an empty folder."""
    with TemporaryDirectory() as folder:
        client = Client(Path(folder), module=module, PYTHONPATH=str(_ROOT), **more)
        try:
            yield client
        finally:
            client.kill()


def times(module: str, path: str, places: int, *, requests: bool = True) -> Times:
    """What a server takes with one program open, at random places of it."""
    text = read(path)
    lines = text.split("\n")
    with server(module) as client:
        client.patience = 900.0
        client.start(PUSHED)
        client.open("first.ngc", "M2\n", "rs274")
        client.request("textDocument/hover", _at(f"{client.folder.as_uri()}/first.ngc", 0, 0))
        clock = Clock(client)
        uri = client.open("program.ngc", text, "rs274")
        client.pushed(uri)
        opened = clock.taken()
        if module != STOCK:
            # What comes first is what the program says as it stands; its values and its run follow.
            client.request("textDocument/diagnostic", {"textDocument": {"uri": uri}})
            _rested(client)
        random = Random(SEED)
        asked = {method: _asked(client, uri, lines, method, random, places) for method in ASKED} if requests else {}
        typed = [_typed(client, uri, lines, random) for _ in range(places)]
        return Times(opened, middle(typed), asked, resident(client.process.pid))


def previewing(places: int) -> tuple[Taken, Taken]:
    """Medians of a keystroke in a small program: while nothing else is done, and while an endless loop in another one is expanded."""
    with server(OURS) as client:
        client.start(PUSHED)
        endless = client.open("endless.ngc", _ENDLESS, "rs274")
        lines = ["G21 G90 G17", *(f"G1 X{number} F100" for number in range(100)), "M2", ""]
        uri = client.open("program.ngc", "\n".join(lines), "rs274")
        client.pushed(uri)
        random = Random(SEED)
        alone = [_typed(client, uri, lines, random) for _ in range(places)]
        argument = {"uri": endless, "maxSteps": 0}
        number = client.ask("workspace/executeCommand", {"command": "deburr.expand", "arguments": [argument]})
        client.settle()
        beside = [_typed(client, uri, lines, random) for _ in range(places)]
        client.notify("$/cancelRequest", {"id": number})
        return middle(alone), middle(beside)


def _rested(client: Client) -> None:
    """Wait until a server has nothing more to do: what it does beside its answers would be counted with them."""
    while True:
        clock = Clock(client)
        sleep(_REST)
        if sys.platform != "linux" or clock.taken().spent < _REST / 10:
            return


def _typed(client: Client, uri: str, lines: Sequence[str], random: Random) -> Taken:
    """Seconds from a keystroke to the diagnostics of the text with it."""
    sleep(PAUSE)
    line = random.randrange(len(lines) - 1)
    col = next((col for col, char in enumerate(lines[line], 1) if char.isdigit()), 0)
    client.said.clear()
    clock = Clock(client)
    version = client.change(uri, edit(line, col, col, "7"))
    client.wait("textDocument/publishDiagnostics", lambda params: params.get("version") == version)
    return clock.taken()


def _asked(client: Client, uri: str, lines: Sequence[str], method: str, random: Random, places: int) -> Taken:
    taken = []
    for _ in range(places):
        where = _at(uri, *_place(lines, random))
        clock = Clock(client)
        client.request(f"textDocument/{method}", where)
        taken.append(clock.taken())
    return middle(taken)


def _at(uri: str, line: int, col: int) -> dict[str, Any]:
    return {"textDocument": {"uri": uri}, "position": {"line": line, "character": col}}


def _place(lines: Sequence[str], random: Random) -> tuple[int, int]:
    """Somewhere in a name or a word."""
    while True:
        line = random.randrange(len(lines) - 1)
        if found := list(_NAME.finditer(lines[line])):
            match = random.choice(found)
            return line, match.start(match.lastindex or 0)


def starts(times: int) -> tuple[Start, Start]:
    """The median starts of both servers, in turns so that a busy machine slows both alike; the first compiles and is not counted."""
    found: dict[str, list[Start]] = {OURS: [], STOCK: []}
    with TemporaryDirectory() as cache:
        for _ in range(times + 1):
            for module, taken in found.items():
                taken.append(_start(module, cache))
    ours, stock = (_middle(taken[1:]) for taken in found.values())
    return ours, stock


def _middle(taken: Sequence[Start]) -> Start:
    initialized, hovered, in_order = zip(*taken)
    return Start(middle(initialized), middle(hovered), all(in_order))


def _start(module: str, cache: str) -> Start:
    """All that an editor sends at its start is sent at once, as an impatient one would."""
    text = "#<depth>=2\nG1 X#<depth> F100\nM2\n"
    with server(module, PYTHONPYCACHEPREFIX=cache, PYTHONDONTWRITEBYTECODE="") as client:
        clock = Clock(client, new=True)
        number = client.ask("initialize", {"processId": None, "capabilities": PUSHED, "rootUri": None})
        client.notify("initialized", {})
        uri = client.open("program.ngc", text, "rs274")
        numbers = [client.ask(f"textDocument/{method}", _at(uri, 1, 6)) for method in ASKED]
        client.result(number)
        initialized = clock.taken()
        assert client.result(numbers[0]), "there is a name to hover over"
        hovered = clock.taken()
        for each in numbers[1:]:
            client.result(each)
        order = [each for each in client.answered if each in numbers]
    return Start(initialized, hovered, order == numbers)


def resident(process: int) -> int:
    """Bytes of a process that are in memory; 0 where that is not known (not Linux)."""
    status = Path(f"/proc/{process}/status")
    match = re.search(r"VmRSS:\s+(\d+) kB", status.read_text()) if status.exists() else None
    return int(match[1]) * 1024 if match else 0
