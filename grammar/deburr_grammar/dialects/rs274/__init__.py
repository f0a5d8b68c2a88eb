"""RS274/NGC with parameters, expressions and O-words (SmithyCNC, EMC2, LinuxCNC): `spec/rs274.md`."""

from deburr_grammar.dialect import Dialect, Evidence, Kind, Setting, letters
from deburr_grammar.dialects.rs274.modality import MODALITY, remapped
from deburr_grammar.dialects.rs274.outline import READINGS, RS274Outline
from deburr_grammar.dialects.rs274.problems import WORDS, diagnose
from deburr_grammar.shape import Folding

_ACTIVE = r"(?i:[ \t]*(?:m[ \t]*s[ \t]*g|debug|print|log|logopen|logappend|logclose|probeopen|probeclose|abort|py|pyrun|pyreload)\b)"
_NAME = r"[#Oo][ \t]*<(?:[^<>();\n]|\([^<>()\n]*\))*+;[^<>\n]*>"
"""A name with a `;` in it, which starts no comment there."""

DIALECT = Dialect(
    name="rs274",
    title="RS274/NGC",
    package="deburr_grammar.dialects.rs274",
    extensions=(".ngc",),
    readings=READINGS,
    folding=Folding(
        # The numbers of G and M codes decide what a line is; rules are kept with its shape.
        codes="GgMm",
        # What an active or unclosed comment says is kept: a `;` in it starts no other comment.
        inert=rf"({_NAME}|\((?:(?={_ACTIVE})[^()\n]*\)?|[^()\n]*+(?!\))))|\((?<=(\())[^()\n]*(\))|;(?<=(;))[^\n]*",
        signs="(;",
    ),
    outline=RS274Outline(),
    diagnose=diagnose,
    words=WORDS,
    comments=(("(", ")"), (";", "")),
    modality=MODALITY,
    # spec/rs274.md §4.2: `#<_line>`; blanks mean nothing inside.
    line_number=r"#\s*<\s*_\s*l\s*i\s*n\s*e\s*>",
    frame="G21 G90 G17\n{}\nF100\nM2\n",
    evidence=(
        Evidence(
            r"(?im)^[ \t]*/?[ \t]*(?:n[0-9]+[ \t]*)?o[ \t]*(?:<[^<>\n]+>|[0-9]+)[ \t]*(?:sub|endsub|call|if|elseif|else|endif|while|endwhile|do|repeat|endrepeat|return)\b",
            "an O-word with a flow command",
        ),
        Evidence(r"#[ \t]*<[^<>\n]+>", "a named parameter `#<name>`"),
    ),
    settings=(
        Setting(
            "profile", Kind.CHOICE, "linuxcnc", "whose manual decides where the two differ", ("linuxcnc", "smithy")
        ),
        Setting("compare", Kind.CHOICE, "1e-4", "how near two values must be to be EQ", ("1e-4", "1e-6")),
        Setting(
            "subroutine-path",
            Kind.PATHS,
            (),
            "folders in which called subroutine files are looked for",
            found=("sub*/", "macros/", "nc_subroutines/"),
        ),
        Setting("parameters", Kind.PATH, "", "a .var file with stored parameters", found=("*.var",)),
        Setting(
            "axes",
            Kind.TEXT,
            "",
            "letters of the machine's axes; empty: XYZABCUVW, in the smithy profile XYZABC",
            each=letters("XYZABCUVW"),
        ),
        Setting("tool-table", Kind.PATH, "", "a tool table", found=("*.tbl",)),
        Setting(
            "remap",
            Kind.LIST,
            (),
            'G and M codes to which the machine gives a meaning of its own (REMAP in its INI file): `["M428", "G88.6"]`',
            each=remapped,
        ),
    ),
)
