"""Did you mean: the nearest of the names that there are. Loads difflib only when somebody erred."""

from collections.abc import Iterable


def suggestion(name: str, names: Iterable[str]) -> str:
    """The end of a message: `; did you mean `X`?`, or nothing."""
    from difflib import get_close_matches

    found = get_close_matches(name, list(names), 1, 0.7)
    return f"; did you mean `{found[0]}`?" if found else ""
