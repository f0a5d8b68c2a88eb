"""Lines at which a run stops: one each for everything that the control refuses only when it comes there. Knows no program around them."""

from collections.abc import Callable
from random import Random
from typing import NamedTuple


class Misuse(NamedTuple):
    """A reason for which a program is refused; ``lines`` makes some that give it, from values that only a run knows."""

    name: str
    lines: Callable[[Random], list[str]]


def _in_value(*said: str) -> Callable[[Random], list[str]]:
    """A setting, a word or a condition with one of these values; #50 is 0."""

    def lines(rng: Random) -> list[str]:
        value = rng.choice(said)
        forms = ([f"#31={value}"], [f"G0 X{value}"], [f"o95 if [{value} GT 1]", "o95 endif"], [f"#31=[1+{value}*2]"])
        return ["#50=0", *rng.choice(forms)]

    return lines


def _lines(*said: str) -> Callable[[Random], list[str]]:
    return lambda rng: ["#50=0 #52=97", *rng.choice(said).split("\n")]


_CLEAR = "G8 G17 G90 G91.1 G94 F60"
"""Modes in which an arc is judged."""
MISUSES = (
    Misuse("divide-by-zero", _in_value("[1/#50]", "[#31/[#50*3]]", "[5/[#50-#50]]")),
    Misuse("square root", _in_value("SQRT[#50-1]", "SQRT[-4+#50]")),
    Misuse("logarithm", _in_value("LN[#50]", "LN[#50-3]")),
    Misuse("arc function", _in_value("ACOS[#50+1.5]", "ASIN[#50-2]", "ASIN[1.0000001+#50]")),
    Misuse("power of a negative number", _in_value("[[#50-8] ** 0.5]", "[[-1-#50] ** [1/3]]")),
    Misuse("not finite", _in_value("EXP[#50+1000]", "[3 MOD #50]", "[#50 ** -1]", "[[#50+10] ** 400]")),
    Misuse("no integer", _in_value("#[#50+1.5]", "#[31.01+#50]", "##[#50+0.4]")),
    Misuse("out of range", _in_value("#[#50]", "#[#50-3]", "#[#50+5602]", "#[9999+#50]")),
    Misuse("read only", _lines("#[5420+#50]=1", "#[5400+#50]=3", "#[5428+#50]=2")),
    Misuse("setting out of range", _lines("#[#50]=1", "#[#50-1]=2", "#[5700+#50]=3", "#[#50+0.5]=3")),
    Misuse(
        "undefined name",
        _lines("o96 if [#50]\n#<late>=1\no96 endif\nG0 X#<late>", "o96 if [#50]\n#<_late>=1\no96 endif\n#31=#<_late>"),
    ),
    Misuse("unknown sub", _lines("o[#50+999] call [1]", "o#[#50+31] call")),
    Misuse("label", _lines("o[#50+1.5] call", "o[#50+2.25] if [1]\no3 endif")),
    Misuse("abort", _lines("(ABORT,stopped at #50)", "o96 if [#50 EQ 0]\n(abort, it is %d#50)\no96 endif")),
    Misuse("too deep", _lines("o97 sub\no98 if [#1 LT 50]\no97 call [#1+1]\no98 endif\no97 endsub\no97 call [#50]")),
    Misuse("restored unsaved", _lines("o97 sub\nM72\no97 endsub\no97 call")),
    Misuse("known sub", _lines("o[#50+97] call\no97 sub\no97 endsub", "o#[#50+52] call [1]\no97 sub\no97 endsub")),
    Misuse(
        "arc",
        _lines(
            f"{_CLEAR}\nG0 X1 Y2\nG91 G1 X[#50+3]\nG90 G2 X9 R1",
            f"{_CLEAR}\nG0 X1 Y2\nG91 G2 X4 R[#50+1.5]",
            f"{_CLEAR}\nG91 G3 X4 Y1 I[#50+2] J0",
            f"{_CLEAR}\nG99 G81 X[5+#50] Y0 Z-1 R3\nG80\nG2 X9 I1",
            f"{_CLEAR}\nG21 G0 X2.54 Y[#50]\nG20\nG2 X1.1 R[#50+0.4]",
            f"{_CLEAR}\nG92 X[#50+5] Y0\nG3 X9 R1.9",
            f"{_CLEAR}\nG10 L20 P0 X[#50+5] Y0\nG3 X9 R1.9",
        ),
    ),
    Misuse("probe in place", _lines(f"{_CLEAR}\nG0 X[#50+1]\nG38.2 X1", f"{_CLEAR}\nG91 G38.4 X[#50] Y0")),
    Misuse("sub by number", _lines("M98 P[#50+97]\no97 sub\no97 endsub", "o97 sub\no97 endsub\nM98 P97")),
    Misuse("passed value", _lines("o97 sub\no97 endsub [1/#50]")),
)
