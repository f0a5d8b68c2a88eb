"""SmartCAM code generator templates: `spec/cgt.md`."""

from deburr_grammar.dialect import Dialect, Evidence, Kind, Setting
from deburr_grammar.dialects.cgt.machine import table_words
from deburr_grammar.dialects.cgt.outline import READINGS, CGTOutline
from deburr_grammar.dialects.cgt.problems import WORDS, diagnose
from deburr_grammar.shape import Folding

_FRAME = """\
@START
%
G90 G21 G17
@
@TOOLCHG
T#TOOL M06
@
@RAP
<#MOV>< X#XPOS>< Y#YPOS>< Z#ZPOS>
@
@ARC
<#MOV>< X#XPOS>< Y#YPOS> I#XCTR J#YCTR
@
@END
M30
%
@
@LINE
<#MOV>< X#XPOS>< Y#YPOS>< Z#ZPOS>< F#FEED>
{}
@
"""

DIALECT = Dialect(
    name="cgt",
    title="SmartCAM CGT",
    package="deburr_grammar.dialects.cgt",
    extensions=(".cgt",),
    readings=READINGS,
    folding=Folding(
        # Digits are part of names: words and sections of different names are different things.
        protect=r"(?m:^)@\$?[A-Za-z][A-Za-z0-9_]*|#[A-Za-z][A-Za-z0-9_]*",
        inert=r"//(?<=(//))[^\n]*",
        signs="/",
    ),
    outline=CGTOutline(),
    diagnose=diagnose,
    given=table_words,
    words=WORDS,
    comments=(("//", ""),),
    file_ends_region=True,
    frame=_FRAME,
    evidence=(
        Evidence(
            r"(?m)^@\$?[A-Za-z][A-Za-z0-9_]*[ \t]*(?://.*)?\r?\n(?:.*\n){0,200}?[^\n/]*#[A-Za-z][A-Za-z]",
            "a section header `@NAME` with `#` words behind it",
        ),
    ),
    settings=(
        Setting(
            "input",
            Kind.PATH,
            "",
            "the toolpath that `expand` and `check --run` use: .cl or .jsonl",
            found=("*.cl", "*.jsonl"),
        ),
        Setting("machine", Kind.PATH, "", "a machine file: formats, words, tables, arc style"),
    ),
)
