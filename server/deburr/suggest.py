"""Did you mean: the nearest of the names that there are. Loads difflib only when somebody erred."""

from collections.abc import Iterable


def suggestion(name: str, names: Iterable[str]) -> str:
    """The end of a message: `; did you mean `X`?`, or nothing. The only name that differs in case alone is nearest."""
    from difflib import get_close_matches

    there = list(names)
    alike = [each for each in there if each.casefold() == name.casefold()]
    found = alike if len(alike) == 1 else get_close_matches(name, there, 1, 0.7)
    return f"; did you mean `{found[0]}`?" if found else ""
