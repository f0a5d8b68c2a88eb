"""Did you mean, for programs with thousands of unknown names too. Never compares one name twice."""

from collections.abc import Callable, Hashable, Iterable

from deburr.suggest import suggestion

MOST = 40
"""Unknown names that are compared with all known ones; whoever has more of them has another fault."""


class Guesses:
    """The ends of messages that were made, under the unknown names and the place of which the known names are."""

    def __init__(self) -> None:
        self._made: dict[tuple[str, Hashable], str] = {}

    def near(self, name: str, where: Hashable, known: Callable[[], Iterable[str]]) -> str:
        """The nearest of the known names; they are only gathered where it is not known yet."""
        key = (name, where)
        if key not in self._made and len(self._made) < MOST:
            self._made[key] = suggestion(name, sorted(set(known()) - {name}))
        return self._made.get(key, "")
