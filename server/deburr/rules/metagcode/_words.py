"""The words of the language and what people write instead of them. Never looks at a program."""

from collections.abc import Iterable
from functools import lru_cache

from deburr.suggest import suggestion

KEYWORDS = ("#FILE", "#IF", "#ENDIF", "#LOOP", "#ENDLOOP")
OPERATORS = ("greaterthan", "lessthan", "equalto", "notequalto")
HINTED = 200
"""Where more names than that are not there, they are not misspelt: another file or folder is meant."""

_NO_ELSE = "there is no else, close the block and write a second `#IF` with the opposite operator"
_REPEAT = "repeat lines with `#LOOP`, which divides a variable into steps"
_INSERT = "a snippet is put in with `#FILE name`"
_END = "the ends are `#ENDIF` and `#ENDLOOP`, with the number of the block"
FOREIGN = {
    "#FILE": "`#FILE` takes no number and is followed by a blank and the name",
    **dict.fromkeys(("#ELSE", "#ELSEIF", "#ELSIF", "#ELIF"), _NO_ELSE),
    **dict.fromkeys(("#WHILE", "#FOR", "#REPEAT", "#DO", "#UNTIL"), _REPEAT),
    **dict.fromkeys(("#INCLUDE", "#INSERT", "#SNIPPET", "#CALL"), _INSERT),
    **dict.fromkeys(("#END", "#ENDWHILE", "#ENDFOR", "#NEXT", "#WEND", "#ENDELSE"), _END),
}
"""Directives of other languages, with what is written here."""

MEANT = {
    **dict.fromkeys(("=", "==", "eq", "is", "equals", "equal", "same"), "equalto"),
    **dict.fromkeys(("<>", "!=", "~=", "ne", "not", "notequal", "unequal"), "notequalto"),
    **dict.fromkeys((">", "gt", "greater", "more", "morethan", "above", "over"), "greaterthan"),
    **dict.fromkeys(("<", "lt", "less", "smaller", "smallerthan", "below", "under"), "lessthan"),
}
"""What is written for an operator, in small letters."""
OR_EQUAL = {
    **dict.fromkeys((">=", "=>", "ge", "gte", "atleast"), "greaterthan"),
    **dict.fromkeys(("<=", "=<", "le", "lte", "atmost"), "lessthan"),
}
"""What is written for an operator and `equalto` in one."""


def nearest(name: str, names: Iterable[str]) -> str:
    """The end of a message on a name that is not there: `; did you mean `X`?`, or nothing. One that differs in case only comes first."""
    names = list(names)
    alike = [each for each in names if each.casefold() == name.casefold()]
    return f"; did you mean `{alike[0]}`?" if len(alike) == 1 else suggestion(name, names)


@lru_cache(maxsize=256)
def keyword_meant(word: str) -> str | None:
    """The directive that a misspelt one in capital letters is nearest to; None if it is none of ours."""
    from difflib import get_close_matches

    found = get_close_matches(word, KEYWORDS, 1, 0.7) if word not in FOREIGN else []
    return found[0] if found else None
