"""MetaGCODE, the templates of ConvCAM: G-code with `|variables|`, `#IF`, `#LOOP` and `#FILE` (`spec/metagcode.md`)."""

from deburr_grammar.dialect import Dialect, Evidence, Kind, Setting
from deburr_grammar.dialects.metagcode.outline import READINGS, MetaGCodeOutline
from deburr_grammar.dialects.metagcode.problems import WORDS, diagnose
from deburr_grammar.shape import Folding

DIALECT = Dialect(
    name="metagcode",
    title="MetaGCODE",
    package="deburr_grammar.dialects.metagcode",
    extensions=(".mgc",),
    readings=READINGS,
    # No comment is inert: on a directive line `(a b)` is two values, and elsewhere `(PART |No|)` is filled in.
    folding=Folding(),
    outline=MetaGCodeOutline(),
    diagnose=diagnose,
    words=WORDS,
    comments=(("(", ")"), (";", "")),
    frame="{}\n",
    evidence=(
        Evidence(
            r"(?aim)^[ \t]*#(?:end)?(?:if|loop)[0-9]+(?=[ \t\r]|$)", "a block directive such as `#IF1` or `#LOOP1`"
        ),
        Evidence(r"(?aim)^[ \t]*#file[ \t]+[^ \t\n|=]", "a snippet reference `#FILE name`"),
        Evidence(
            r"(?m)(?<![A-Za-z0-9_|<])[A-Za-z][-+]?\|[ \t]*[A-Za-z_][^|\n]*\|(?![A-Za-z0-9_])",
            "a word whose value is a variable, such as `X|name|`",
        ),
    ),
    settings=(
        Setting(
            "snippets-dir",
            Kind.PATH,
            "Snippets",
            "the folder of snippet files, beside the program unless it is an absolute path",
        ),
        Setting(
            "variables",
            Kind.PATH,
            "",
            "a file with the values of variables: name=value lines, or JSON",
            found=("*.vars",),
        ),
    ),
)
