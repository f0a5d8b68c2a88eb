"""One program of each dialect with a fault, and what a user does with it in an editor; the answers are worked out by hand."""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[2]


@dataclass(frozen=True)
class Task:
    """``main``: the file that is opened, the first of ``files``. Texts say where the cursor is put: before the first of them.

    ``error``: row:column and words of the message; ``mended``: the line after the first ``action`` at ``fault``;
    ``hover``: where, and words of the answer; ``definition``: where, and the file:row it leads to; ``rename``: where, the new
    name, and the files after it; ``flat``: the expansion after it, with ``define``; ``from_to``: in the source, and the row of the flat
    program (not the first) that it leads to; ``back``: a row of the flat program, and the file:row that it leads to.
    """

    dialect: str
    files: Mapping[str, str]
    error: tuple[str, str]
    fault: str
    action: str
    mended: str
    hover: tuple[str, tuple[str, ...]]
    definition: tuple[str, str]
    rename: tuple[str, str, Mapping[str, list[str]]]
    flat: list[str]
    from_to: tuple[str, int]
    back: tuple[int, str]
    define: str = ""

    @property
    def main(self) -> str:
        """The name of the program."""
        return next(iter(self.files))


TASKS = (
    Task(
        "rs274",
        {
            "main.ngc": "G21 G90 G17\n#<_depth>=2\no<drill> cal [5]\nM2\n",
            "drill.ngc": "o<drill> sub\nG0 X#1\nG0 Z[0-#<_depth>]\no<drill> endsub\n",
        },
        error=("3:10", "`cal` is no O-word command; did you mean `call`?"),
        fault="cal",
        action="Change to `call`",
        mended="o<drill> call [5]",
        hover=("<_depth", ("#<_depth>", "2")),
        definition=("drill", "drill.ngc:1"),
        rename=(
            "_depth",
            "_deep",
            {
                "main.ngc": ["G21 G90 G17", "#<_deep>=2", "o<drill> call [5]", "M2"],
                "drill.ngc": ["o<drill> sub", "G0 X#1", "G0 Z[0-#<_deep>]", "o<drill> endsub"],
            },
        ),
        flat=["G21 G90 G17", "G0 X5", "G0 Z-2", "M2"],
        from_to=("M2", 4),
        back=(3, "drill.ngc:3"),
    ),
    Task(
        "metagcode",
        {
            "main.mgc": "#LOOP1 |Depth| 5 c\nG1 Z-|Depth|\n#ENDLOOP1\n#IFF2 |Side| EqualTo 1 n\n#FILE part\n#ENDIF2\nM30\n",
            "Snippets/part": "G0 X|Side|\n",
        },
        error=("4:1", "did you mean `#IF2`?"),
        fault="#IFF2",
        action="Change to `#IF2`",
        mended="#IF2 |Side| EqualTo 1 n",
        hover=("Depth", ("Depth",)),
        definition=("part", "part:1"),
        rename=(
            "Side",
            "Hand",
            {
                "main.mgc": [
                    "#LOOP1 |Depth| 5 c",
                    "G1 Z-|Depth|",
                    "#ENDLOOP1",
                    "#IF2 |Hand| EqualTo 1 n",
                    "#FILE part",
                    "#ENDIF2",
                    "M30",
                ],
                "part": ["G0 X|Hand|"],
            },
        ),
        flat=["G1 Z-5", "G1 Z-10", "G1 Z-15", "G0 X1", "M30"],
        from_to=("M30", 5),
        back=(4, "part:1"),
        define="Depth=15 Hand=1",
    ),
    Task(
        "cgt",
        {
            "main.cgt": "@DECLARE\n#DEC #depth\n@\n@START\nG90 G21 G17\n#EVAL(#depth=SQRR(4))\n#CALL(PART)\n@\n@PART\nZ#depth\n@\n@END\nM30\n@\n",
            "part.cl": "",
            "deburr.toml": '[cgt]\ninput = "part.cl"\n',
        },
        error=("6:14", "there is no function `SQRR`; did you mean `SQR`?"),
        fault="SQRR",
        action="Change to `SQR`",
        mended="#EVAL(#depth=SQR(4))",
        hover=("depth", ("#depth",)),
        definition=("PART", "main.cgt:9"),
        rename=(
            "depth",
            "deep",
            {
                "main.cgt": [
                    "@DECLARE",
                    "#DEC #deep",
                    "@",
                    "@START",
                    "G90 G21 G17",
                    "#EVAL(#deep=SQR(4))",
                    "#CALL(PART)",
                    "@",
                    "@PART",
                    "Z#deep",
                    "@",
                    "@END",
                    "M30",
                    "@",
                ]
            },
        ),
        flat=["G90 G21 G17", "Z2.0", "M30"],
        from_to=("M30", 3),
        back=(2, "main.cgt:10"),
    ),
    Task(
        "z32",
        {
            "main.z32": "(PART)\nHA 30 ;pitch\n!HB=SNN(90); HA=HA+HB!\n!GOP2!\nM30\n",
            "cmos/2": "G0 X<HA>\nG26\n",
            "deburr.toml": '[z32]\ncmos-dir = "cmos"\n',
        },
        error=("3:5", "did you mean `SN`?"),
        fault="SNN",
        action="Change to `SN`",
        mended="!HB=SN(90); HA=HA+HB!",
        hover=("HA+", ("HA",)),
        definition=("2!", "2:1"),
        rename=(
            "HA",
            "HC",
            {
                "main.z32": ["(PART)", "HC 30 ;pitch", "!HB=SN(90); HC=HC+HB!", "!GOP2!", "M30"],
                "2": ["G0 X<HC>", "G26"],
            },
        ),
        flat=["(PART)", "G0 X31", "M30"],
        from_to=("M30", 3),
        back=(2, "2:1"),
    ),
)


def written(task: Task, folder: Path) -> Path:
    """The files of a task on disk; the path of its program."""
    for name, text in task.files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return folder / task.main


def steps(task: Task) -> dict[str, Any]:
    """What an editor's driver is to do."""
    return {
        "fault": task.fault,
        "hover": task.hover[0],
        "definition": task.definition[0],
        "rename": task.rename[:2],
        "expand": {"from": task.from_to[0], "to": task.from_to[1], "line": task.back[0], "define": task.define},
    }


def check_seen(task: Task, found: Mapping[str, Any]) -> None:
    """What was seen in an editor is what there is to be seen."""
    (error,) = found["errors"]
    assert error.startswith(task.error[0] + " ") and task.error[1] in error
    assert found["mended"] == task.mended
    assert all(word in found["hover"] for word in task.hover[1]), found["hover"]
    assert found["definition"] == task.definition[1]
    assert found["renamed"] == task.rename[2]
    assert found["flat"] == task.flat
    assert found["source"] == task.back[1]


def environment(home: Path) -> dict[str, str]:
    """A user's environment with nothing in it but the `deburr` of these tests; an editor's files go to ``home``."""
    found = {name: value for name, value in os.environ.items() if not name.startswith(("XDG_", "NVIM", "VIM", "EMACS"))}
    folders = {
        name: str(home / name.lower())
        for name in ("XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_STATE_HOME", "XDG_CACHE_HOME")
    }
    path = os.pathsep.join([str(Path(sys.executable).parent), found.get("PATH", "")])
    return {**found, **folders, "HOME": str(home), "PATH": path, "TERM": "dumb", "PYTHONDONTWRITEBYTECODE": "1"}


def shown(editor: str, language: str, word: str) -> str:
    """The configuration that an editor's README prints: its block of that language with that word in it."""
    text = (ROOT / "editors" / editor / "README.md").read_text(encoding="utf-8")
    (found,) = [block for block in re.findall(rf"```{language}\n(.*?)```", text, re.S) if word in block]
    return str(found).replace("~/deburr", str(ROOT))
