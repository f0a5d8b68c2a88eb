"""Programs of many routines in each dialect, full of values: generated with fixed seeds, and of any size. Never reads a file."""

from __future__ import annotations

from collections.abc import Iterator
from random import Random
from typing import NamedTuple

PARTS = 40


class Language(NamedTuple):
    """How a dialect says things. In lines, `{p}` is the number of a routine, `{q}` that of an earlier one, `{n}` a number, `{l}` a label, `{a}` and `{b}` are variables."""

    first: str
    each: str
    last: str
    begin: str
    end: str
    calls: str
    variables: tuple[str, ...]
    statements: tuple[str, ...]
    main_first: bool


LANGUAGES = {
    "rs274": Language(
        "#<_clear>=5\n#31=1",
        "#32={p}\no<s{p}> call [{p}] [{n}.5] [{n}00]\nG0 X[#31+#<_last>]",
        "M2",
        "o<s{p}> sub\n#<depth>=#1\n#<width>=#2\n#<feed>=[#3+100]\n#<pos>=0",
        "#<_last>=[#<depth>+{p}]\no<s{p}> endsub",
        "o<s{q}> call [#<depth>] [{n}] [#<feed>]",
        ("#<depth>", "#<width>", "#<feed>", "#<pos>"),
        (
            "{a}=[{b}*{n}+1.5]",
            "G1 X[{a}+{n}] Y[{b}*2] F[#<feed>+{n}]",
            "o{l} if [{a} GT {n}]\n  {b}=[{a}-{n}]\no{l} else\n  {b}=[SIN[{a}]*{n}]\no{l} endif",
            "#5=0\no{l} while [#5 LT {n}]\n  #5=[#5+1]\n  G1 X[#5*{a}]\n  {b}=[{b}+#5/2]\no{l} endwhile",
            "o{l} repeat [{n}]\n  G1 X{a} Y[{b}+1]\n  {a}=[{a}+0.5]\no{l} endrepeat",
        ),
        False,
    ),
    "z32": Language(
        "(P)\n!HB=2; HC=3!",
        "HA{p}\n!GOP{p}!\nX<HA+HE>",
        "M30",
        ":{p}\n!HD=HA*{p}; HF={n}!",
        "!HE=HD+{p}!\nG26",
        "!GOP{q}!",
        ("HB", "HC", "HD", "HF", "PAR[3]"),
        (
            "!{a}={b}*{n}+1.5!",
            "G1 X<{a}+{n}> Y<{b}*2> F<{a}+{n}>",
            "!HG=0!\nN{l} X<HG*{a}>\n!{b}={b}+HG/2!\n!HG=HG+1; IF HG<{n}; GON{l}!",
            "!IF {a}>{n}; {b}={a}-{n}; EB! {b}=SN({a})*{n}!",
        ),
        True,
    ),
    "cgt": Language(
        "@DECLARE\n#DEC #depth,#width,#rate,#last\n@\n@LINE",
        "#CALL(s{p})",
        "@\n@START\n@\n@END\n@",
        "@s{p}\n#EVAL(#depth=#XPOS*{p})\n#EVAL(#V1={n})",
        "#EVAL(#last=#depth+{p})\n@",
        "#CALL(s{q})",
        ("#depth", "#width", "#rate", "#V1", "#V2"),
        (
            "#EVAL({a}={b}*{n}+1.5)",
            "G1 X#XPOS Y#YPOS F{a}",
            "#IF({a}>{n})<\n#EVAL({b}={a}-{n})\n>#ELSE<\n#EVAL({b}=SIN({a})*{n})\n>",
            "#EVAL(#V4=0)\n#REPEAT({n})<\nG1 X{a} Y#V4\n#EVAL(#V4=#V4+1)\n#EVAL({b}={b}+#V4/2)\n>",
            "<G0 X{a}>",
        ),
        True,
    ),
    "metagcode": Language(
        "", "", "", "(PART {p})", "(END)", "G1 X|Depth|",
        ("Depth", "Width", "Feed", "Pos", "Count"),
        (
            "G1 X|{a}| Y-|{b}| F{n}",
            "#IF{l} |{a}| greaterthan {n} numeric\nG1 X|{a}| Z-|{b}|\n#ENDIF{l}",
            "#LOOP{l} |{a}| {n} c\nG1 X|{a}| Y|{b}|\n#ENDLOOP{l}",
        ),
        True,
    ),
}  # fmt: skip


def macros(dialect: str, lines: int, seed: int = 1) -> str:
    """A main program that calls its routines, some of which call earlier ones; about so many lines."""
    said, random = LANGUAGES[dialect], Random(seed)
    main = [said.first, *(said.each.format(p=p, n=random.randint(1, 90)) for p in range(1, PARTS + 1)), said.last]
    size = (lines - "\n".join(main).count("\n")) // PARTS
    routines = ["\n".join(_routine(said, p, size, random)) for p in range(1, PARTS + 1)]
    text = "\n".join([*main, *routines] if said.main_first else [*routines, *main])
    return f"{text.strip()}\n"


def _routine(said: Language, part: int, size: int, random: Random) -> Iterator[str]:
    body = said.begin.format(p=part, n=random.randint(1, 90))
    label = 100
    while body.count("\n") < size - 6:
        label += 10
        a, b = random.sample(said.variables, 2)
        body += "\n" + random.choice(said.statements).format(a=a, b=b, n=random.randint(2, 90), l=label)
    yield body
    if part > 3 and random.random() < 0.6:
        yield said.calls.format(q=random.randint(1, part - 1), n=random.randint(1, 9))
    yield said.end.format(p=part)
