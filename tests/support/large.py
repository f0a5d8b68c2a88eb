"""Programs of any length that use what their language has, the same part over and over under other names."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping


def large(dialect: str, parts: int) -> str:
    """A program of so many parts of some ten lines each."""
    return "\n".join(
        [*_FRAMES[dialect][0], *(line for at in range(parts) for line in _PARTS[dialect](at)), *_FRAMES[dialect][1], ""]
    )


def _rs274(at: int) -> Iterator[str]:
    yield f"o<part{at}> sub"
    yield f"#<depth{at}> = [#1 + {at}]"
    yield f"o1 if [#<depth{at}> GT {at % 7}]"
    yield f"G1 X#<depth{at}> Y[#2 * 2] F[#3 + 100]"
    yield "o1 else"
    yield "G0 Z5"
    yield "o1 endif"
    yield "o2 while [#1 LT 5]"
    yield "#1 = [#1 + 1]"
    yield "o2 endwhile"
    yield f"o<part{at}> endsub"
    yield f"o<part{at}> call [{at}] [2] [3]"


def _metagcode(at: int) -> Iterator[str]:
    yield f"(part {at})"
    yield f"#IF1 |z{at % 50}| lessthan {at} n"
    yield f"G1 Z|z{at % 50}| F|Feed|"
    yield f"#IF2 |kind| equalto k{at} a"
    yield "G0 Z5"
    yield "#ENDIF2"
    yield "#ENDIF1"
    yield f"#LOOP1 |Depth| |step{at % 50}| c"
    yield "G1 X1 Y|Depth|"
    yield "#ENDLOOP1"


def _cgt(at: int) -> Iterator[str]:
    yield f"// part {at}"
    yield f"#EVAL(#V{at % 9 + 1}={at}*2)"
    yield f"#IF(#V{at % 9 + 1}={at})<"
    yield f"G1 X#XPOS Y#YPOS ({at})"
    yield ">"
    yield "#ELSE<"
    yield "G0 Z#ZPOS"
    yield ">"
    yield "#REPEAT(2)<"
    yield "#EVAL(#V9=#V9+1)"
    yield ">"


def _z32(at: int) -> Iterator[str]:
    first = 10 * at + 1
    yield f"N{first} X{at % 90} Y5 F100"
    yield f"!HA={at}!"
    yield f"N{first + 1} X<HA>"
    yield f"!HA=HA+10; IF HA<{at + 5}; GON{first + 1}!"
    yield f"N{first + 2} G1 Z-{at % 9}"
    yield f"!IF HA=0; GON{first + 4}!"
    yield f"N{first + 3} X0"
    yield f"N{first + 4} G0 Z5"


_PARTS: Mapping[str, Callable[[int], Iterator[str]]] = {
    "rs274": _rs274,
    "metagcode": _metagcode,
    "cgt": _cgt,
    "z32": _z32,
}
_FRAMES: Mapping[str, tuple[list[str], list[str]]] = {
    "rs274": (["G21 G90 G17"], ["M2"]),
    "metagcode": (["%"], ["%"]),
    "cgt": (["@START", "%", "@LINE"], ["@END", "M30", "@"]),
    "z32": (["%"], ["M30"]),
}
