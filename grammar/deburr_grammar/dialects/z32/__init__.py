"""D.Electron Z32 with parameters and advanced lines: `spec/z32.md`."""

import re
from typing import Any

from deburr_grammar.dialect import Dialect, Evidence, Kind, Setting, letters
from deburr_grammar.dialects.z32.outline import READINGS, Z32Outline
from deburr_grammar.dialects.z32.problems import WORDS, diagnose
from deburr_grammar.shape import Folding

_AXES = "ABCDHPQUVWXYZ"
"""The letters that a machine's axes can have (spec/z32.md §5)."""
_NAME = r"(?:[A-Za-z]{1,2}|PA[LR][ \t]*\[[^\]\n]*\])"
_FIELD = rf"(?:IF\b|EB\b|CP\b|PC\b|GO[NPS][ \t]*(?:[0-9.]|<|&lt)|:[ \t]*L254[ \t]*-|{_NAME}[ \t]*=)"


def _machine_value(index: str, value: Any) -> str:
    """What is wrong with a value of the setting `pal` (spec/z32.md §5): only the machine's own can be given, and PAL holds integers."""
    if not re.fullmatch("[1-9][0-9]{0,2}", index) or not 256 <= int(index) <= 512:
        return f"`{index}` in `pal` is no index of the machine's parameters, PAL[256] to PAL[512]"
    if isinstance(value, bool) or not isinstance(value, int | float) or value != value // 1:
        return f"`{index}` in `pal` must be an integer, the only values that PAL holds"
    return ""


DIALECT = Dialect(
    name="z32",
    title="D.Electron Z32",
    package="deburr_grammar.dialects.z32",
    extensions=(".z32",),
    readings=READINGS,
    folding=Folding(
        # The numbers of G and M codes decide what a word is (G25XYZ, G26, M30) and which codes contradict each other.
        protect=r"[GgMm][ \t]*[0-9]+(?:[.,][0-9]+)?|[Ll]254(?![0-9])",
        # A `(` opens a comment for sure at the start of a line and behind a number; elsewhere it may be a term of an
        # expression. A `;` ends the line for sure where neither `!` nor a parenthesis follows.
        inert=(
            r"(?m:^)([ \t]*\()[^()\n]*(\))"
            r"|(?<=[0-9.,)])(\()[^()\n]*(\))"
            r"|(?<=[0-9.,)][ \t])(\()[^()\n]*(\))"
            r"|(;)[^!()\n]*(?![^\n])"
        ),
        signs="(;",
    ),
    outline=Z32Outline(),
    diagnose=diagnose,
    words=WORDS,
    comments=(("(", ")"), (";", "")),
    # The first line of a program cannot be a jump target, so an example does not stand there.
    frame="(PROGRAM)\n{}\nM30\n",
    evidence=(
        Evidence(rf"(?m)^[ \t]*/?[ \t]*(?:N[0-9.]+[ \t]*)?![ \t]*{_FIELD}[^\n]*!", "an advanced line `!...!`"),
        Evidence(r"(?m)^[ \t]*(?:[A-Za-z_][A-Za-z0-9_]*[ \t]*=[ \t]*)?\$F(?:CE|EC)PP[ \t]*\(", "a `$FCEPP` line"),
    ),
    settings=(
        Setting(
            "cmos-dir",
            Kind.PATH,
            "",
            "folder with the programs that GOP calls; GOS looks in the same name with `-temp` behind it",
        ),
        Setting("file-root", Kind.PATH, "", "folder below which the files of L254 calls are found", found=("icamfs/",)),
        Setting("axes", Kind.TEXT, "XYZABC", "letters of the machine's axes", each=letters(_AXES)),
        Setting(
            "pal",
            Kind.TABLE,
            {},
            "values of PAL[256] to PAL[512], which only the machine writes: `{ 300 = 5 }`",
            each=_machine_value,
        ),
    ),
)
