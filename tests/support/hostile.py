"""Files that somebody made to harm whoever opens them; what deburr says to each (docs/security.md names them all)."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path

SECRET = "TOPSECRET"
"""Stands in files beside the folder that is checked; it must never be read out."""
TEMPLATE = "@LINE\nX#XPOS\n@\n@END\nM30\n@\n"


@dataclass(frozen=True)
class Hostile:
    """``files``: a folder's content; ``command``: what is run there; ``code`` and ``says``: its exit code and words of its answer.

    ``prepare`` adds what no text can: links, pipes. ``most``: mebibytes that it may take.
    """

    name: str
    files: Mapping[str, str | bytes]
    command: tuple[str, ...]
    code: int
    says: str
    prepare: Callable[[Path], None] = field(default=lambda folder: None)
    most: int = 200


def expands(file: str, *more: str) -> tuple[str, ...]:
    return ("expand", file, *more)


def checks(file: str, *more: str) -> tuple[str, ...]:
    return ("check", "--output-format", "concise", file, *more)


def snippet(target: str) -> Callable[[Path], None]:
    """A snippet that is a link."""

    def made(folder: Path) -> None:
        (folder / "Snippets").mkdir()
        (folder / "Snippets" / "a").symlink_to(target)

    return made


def pipe(name: str) -> Callable[[Path], None]:
    """A named pipe into which nobody writes."""

    def made(folder: Path) -> None:
        (folder / name).parent.mkdir(exist_ok=True)
        os.mkfifo(folder / name)

    return made


def folder_in_itself(folder: Path) -> None:
    (folder / "x").mkdir()
    (folder / "x" / "y").symlink_to("..")


def mgc(text: str) -> dict[str, str | bytes]:
    return {"p.mgc": f"{text}\nM30\n"}


def ngc(text: str) -> dict[str, str | bytes]:
    return {"p.ngc": f"{text}\nM2\n"}


def z32(text: str) -> dict[str, str | bytes]:
    return {"p.z32": f"{text}\nM30\n", "f/x": "G26\n", "deburr.toml": '[z32]\nfile-root = "f"\n'}


_MGC, _NGC, _Z32 = expands("p.mgc"), expands("p.ngc"), expands("p.z32")
_DEEP = 20_000

PATHS = (
    Hostile("snippet-parent", mgc("#FILE ../../secret"), _MGC, 1, "metagcode.file-outside"),
    Hostile("snippet-root", mgc("#FILE /etc/passwd"), _MGC, 1, "metagcode.file-outside"),
    Hostile("snippet-drive", mgc("#FILE C:\\Windows\\win.ini"), _MGC, 1, "metagcode.file-outside"),
    Hostile("snippet-unc", mgc("#FILE \\\\server\\share\\x"), _MGC, 1, "metagcode.file-outside"),
    Hostile("snippet-value", mgc("#FILE |a|"), (*_MGC, "-D", "a=../../secret"), 1, "metagcode.file-variable"),
    Hostile("file-call-parent", z32("!:L254-..\\..\\secret!"), _Z32, 1, "z32.file-outside"),
    Hostile("file-call-root", z32("!:L254-/etc/passwd!"), _Z32, 1, "z32.file-"),
    Hostile("file-call-unc", z32("!:L254-\\\\server\\share\\x!"), _Z32, 1, "z32.file-"),
    Hostile("sub-root", ngc("o</etc/passwd> call"), _NGC, 1, "rs274.sub-unknown"),
    Hostile("sub-parent", ngc("o<../secret> call"), _NGC, 1, "rs274.sub-file"),
    Hostile(
        "extend-secret", {**ngc("G0 X1"), "deburr.toml": 'extend = "../secret"\n'}, checks("p.ngc"), 2, "secret:1:"
    ),
)
DEVICES = (
    Hostile("device", {}, checks("/dev/zero"), 2, "a device that gives more than"),
    Hostile("device-full", ngc("G0 X1"), (*_NGC, "-o", "/dev/full"), 2, "No space left on device"),
    Hostile("snippet-device", mgc("#FILE a"), _MGC, 1, "no file that has an end", snippet("/dev/zero")),
    Hostile("snippet-noise", mgc("#FILE a"), _MGC, 1, "no file that has an end", snippet("/dev/urandom")),
    Hostile("snippet-pipe", mgc("#FILE a"), _MGC, 1, "no file that has an end", pipe("Snippets/a")),
    Hostile("pipe-in-folder", ngc("G0 X1"), checks("."), 0, "1 checked", pipe("x.ngc")),
    Hostile("folder-in-itself", ngc("G0 X1"), checks("."), 0, "1 checked", folder_in_itself),
)
BOMBS = (
    Hostile("repeat-bomb", ngc("o1 repeat [1000000000]\nG1 X1 F1\no1 endrepeat"), _NGC, 1, "rs274.limit"),
    Hostile("recursion", ngc("o1 sub\no1 call\no1 endsub\no1 call"), _NGC, 1, "rs274.sub-depth"),
    Hostile(
        "snippet-bomb",
        {
            **mgc("#FILE s0"),
            **{f"Snippets/s{n}": f"#FILE s{n + 1}\n" * 16 for n in range(18)},
            "Snippets/s18": "G1 X1\n",
        },
        _MGC,
        1,
        "metagcode.limit",
    ),
    Hostile("snippet-cycle", {**mgc("#FILE a"), "Snippets/a": "#FILE a\n"}, _MGC, 1, "metagcode.snippet-cycle"),
    Hostile(
        "passes", mgc("#LOOP1 |a| 0.0000000001 c\nG1 Z|a|\n#ENDLOOP1"), (*_MGC, "-D", "a=100000"), 1, "metagcode.limit"
    ),
    Hostile(
        "template-repeat",
        {"p.cgt": "@LINE\n#REPEAT(999999999)\nX#XPOS\n#REPEAT\n@\n@END\nM30\n@\n", "p.cl": "GOTO/1,2,3\nFINI\n"},
        expands("p.cgt", "--input", "p.cl"),
        1,
        "cgt.limit",
    ),
    Hostile("jump-to-itself", z32("N10\n!GON10!"), _Z32, 1, "z32.limit"),
    Hostile("power", ngc("#1=[10**100000000]\nG0 X#1"), _NGC, 1, "rs274.not-finite"),
)
TEXTS = (
    Hostile("deep-expression", ngc(f"#1={'[' * _DEEP}1{']' * _DEEP}"), checks("p.ngc"), 1, "rs274.line-too-long"),
    Hostile("deep-indirection", ngc(f"#1={'#' * _DEEP}1"), checks("p.ngc"), 1, "rs274.line-too-long"),
    Hostile(
        "deep-blocks",
        ngc("\n".join([*(f"o{n} if [1]" for n in range(2000)), *(f"o{n} endif" for n in range(1999, -1, -1))])),
        checks("p.ngc"),
        0,
        "All checks passed",
    ),
    Hostile(
        "deep-conditions",
        mgc(
            "\n".join([*(f"#IF{n} |a| EqualTo 1 n" for n in range(2000)), *(f"#ENDIF{n}" for n in range(1999, -1, -1))])
        ),
        (*_MGC, "-D", "a=1"),
        1,
        "metagcode.limit",
    ),
    Hostile(
        "deep-brackets",
        {"p.cgt": f"@LINE\n{'<' * _DEEP}X#XPOS{'>' * _DEEP}\n@\n@END\nM30\n@\n"},
        checks("p.cgt"),
        1,
        "cgt.line-too-long",
    ),
    Hostile("deep-parentheses", z32(f"!HA={'(' * _DEEP}1{')' * _DEEP}!"), checks("p.z32"), 1, "z32.line-too-long"),
    Hostile("giant-number", ngc(f"G0 X{'9' * 1_000_000}"), _NGC, 1, "rs274.line-too-long"),
    Hostile(
        "giant-value", mgc("#LOOP1 |a| 1 c\nG1 Z|a|\n#ENDLOOP1"), (*_MGC, "-D", "a=9e99999"), 1, "metagcode.not-numeric"
    ),
    Hostile("long-line", ngc("G0 " + "X1 " * 1_000_000), checks("p.ngc"), 1, "rs274.line-too-long"),
    Hostile("long-comment", ngc(f"(deburr: allow {'rs274.x,' * 20_000})"), checks("p.ngc"), 1, "rs274.line-too-long"),
    Hostile("modelines", {"p.nc": "deburr: " * 200_000}, checks("p.nc"), 2, "--dialect"),
    Hostile("closers", ngc("o1 endif\n" * 4_000), checks("p.ngc"), 1, "rs274.o-unopened"),
    Hostile(
        "machine-code", {"p.ngc": b"\x7fELF\x02\x01\x01" + bytes(range(256)) * 64}, checks("p.ngc"), 2, "no program"
    ),
    Hostile("terminal-codes", ngc("(\x1b[31mred\x1b]0;title\x07)\no1 cal"), ("check", "p.ngc"), 1, "rs274.o-unknown"),
    Hostile("terminal-codes-in-a-name", {"e\x1b[31m\nvil.ngc": "o1 cal\nM2\n"}, ("check", "."), 1, "rs274.o-unknown"),
)
BESIDE = (
    Hostile(
        "configuration-cycle", {**ngc("G0"), "deburr.toml": 'extend = "deburr.toml"\n'}, checks("p.ngc"), 2, "circle"
    ),
    Hostile(
        "configuration-deep",
        {**ngc("G0"), "deburr.toml": f"a = {'[' * _DEEP}{']' * _DEEP}\n"},
        checks("p.ngc"),
        2,
        "nested too deep",
    ),
    Hostile(
        "pattern-of-stars",
        {"sub/" + "a" * 200 + ".ngc": "G0 X1\nM2\n", ".gitignore": "*a" * 100 + "b\n"},
        checks("."),
        0,
        "1 checked",
    ),
    Hostile(
        "configured-stars",
        {"a" * 200 + ".ngc": "G0 X1\nM2\n", "deburr.toml": f'[files]\n"{"*a" * 100}b" = "z32"\n'},
        checks("."),
        0,
        "1 checked",
    ),
    Hostile(
        "pattern-of-nothing",
        {"a.ngc": "M2\n", "b.ngc": "M2 (a (b)\n", ".gitignore": "[z-a]\n\\\nb*\n"},
        checks("."),
        0,
        "1 checked",
    ),
    Hostile(
        "configured-nothing",
        {"a.ngc": "M2\n", "deburr.toml": '[files]\n"[z-a]" = "z32"\n'},
        checks("."),
        2,
        "is no pattern of paths",
    ),
    Hostile(
        "values-deep", {**mgc("G0 X|a|"), "v.json": '{"a":' * 100_000}, (*_MGC, "--variables", "v.json"), 1, "no JSON"
    ),
    Hostile(
        "events-deep",
        {"p.cgt": TEMPLATE, "p.jsonl": '{"section":' + "[" * 100_000 + "\n"},
        expands("p.cgt", "--input", "p.jsonl"),
        1,
        "cgt.cl-syntax",
    ),
    Hostile(
        "toolpath-long",
        {"p.cgt": TEMPLATE, "p.cl": f"GOTO/{'1,' * 100_000}\nFINI\n"},
        expands("p.cgt", "--input", "p.cl"),
        1,
        "cgt.cl-syntax",
    ),
)
ALL = (*PATHS, *DEVICES, *BOMBS, *TEXTS, *BESIDE)
