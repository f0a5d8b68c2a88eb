"""Which rules are on: names and prefixes that select and ignore, in layers. Never loads a rule."""

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from deburr.catalogue import rule_names
from deburr.rule import Rule, covers
from deburr.suggest import suggestion
from deburr_grammar.dialects import NAMES

ALL = "ALL"


class Selection(NamedTuple):
    """One layer: a configuration file or the command line. ``select`` None: what the layers below say stands."""

    select: tuple[str, ...] | None = None
    extend: tuple[str, ...] = ()
    ignore: tuple[str, ...] = ()

    def verdict(self, rule: Rule) -> bool | None:
        """What the layer says of a rule: the longest name that covers it decides, and ignoring wins a tie."""
        chosen = max((len(name) for name in (*(self.select or ()), *self.extend) if means(name, rule.name)), default=0)
        ignored = max((len(name) for name in self.ignore if means(name, rule.name)), default=0)
        if chosen or ignored:
            return chosen > ignored
        return None if self.select is None else False


def selected(rule: Rule, layers: Sequence[Selection], ignored: Iterable[str] = ()) -> bool:
    """Whether a rule is on after all layers, the last one on top; what is ``ignored`` for a file is off whatever they say."""
    on = rule.default
    for layer in layers:
        verdict = layer.verdict(rule)
        on = on if verdict is None else verdict
    return on and not any(means(name, rule.name) for name in ignored)


def means(name: str, rule: str) -> bool:
    """Whether a name, a prefix or `ALL` means a rule."""
    return name == ALL or covers(name, rule)


def unknown(name: str, *, whole: bool = False) -> str:
    """What is wrong with a name that should mean rules, or nothing. ``whole``: it must be one rule's full name."""
    if name == ALL and not whole:
        return ""
    if not name:
        return "an empty text names no rule"
    dialect, *words = name.rstrip(".-").split(".")
    if name.endswith((".", "-")) and not unknown(".".join((dialect, *words)), whole=whole):
        return f"`{name}` is no rule; did you mean `{'.'.join((dialect, *words))}`?"
    if dialect not in NAMES:
        return f"`{name}` is no rule{_meant(name)}"
    names = rule_names(dialect)
    if name in names or (not whole and any(covers(name, each) for each in names)):
        return ""
    if any(covers(name, each) for each in names):
        return f"`{name}` means several rules, and one is wanted{suggestion(name, names)}"
    return f"`{name}` is no rule{suggestion(name, names)}"


def _meant(name: str) -> str:
    """What a name without a dialect may have meant."""
    names = [each for dialect in NAMES for each in rule_names(dialect)]
    short = [f"`{each}`" for each in names if each.partition(".")[2] == name]
    return f"; did you mean {' or '.join(short)}?" if short else suggestion(name, (*NAMES, *names))
