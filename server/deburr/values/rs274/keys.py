"""RS274's parameters as keys: which a line sets, which routines share, which only the control sets (spec/rs274.md §4). Calculates nothing."""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from typing import TYPE_CHECKING, Union

from deburr.values.domain import ANY, Value, joined
from deburr.values.graph import Env
from deburr.values.rs274.expressions import ARGUMENTS

if TYPE_CHECKING:
    from deburr.values.rs274.expressions import Expressions
    from deburr_grammar.tree import Node as Part

ANYTHING = " "
"""What stands among the parameters that a line sets for all that there are. No name has a blank in it."""


def is_shared(key: Hashable) -> bool:
    """Whether a parameter is the same in a subprogram and in its caller."""
    return key.startswith("_") if isinstance(key, str) else isinstance(key, int) and key > ARGUMENTS


Put = tuple[Union[tuple[Hashable, ...], None], Value]
"""Parameters of which one is set, and to what; None: who knows which."""


def put(env: Env, puts: Sequence[Put]) -> Env:
    """The values behind a line that sets some."""
    if not puts:
        return env
    found = dict(env)
    for keys, value in puts:
        if keys is None:
            found = {key: old for key, old in found.items() if isinstance(key, str)}
        elif len(keys) == 1:
            found[keys[0]] = value
            if value == ANY:
                del found[keys[0]]
        else:
            found.update({key: joined(found[key], value) for key in keys if key in found})
    return found


def set_by(expressions: Expressions, param: Part) -> Hashable:
    """The parameter that a setting sets, if the line alone tells; None: who knows which."""
    name = expressions.name(param)
    if name is not None:
        return name
    return expressions.literal(param)


def shared(keys: set[Hashable]) -> frozenset[Hashable] | None:
    """Those that other routines can set and read; None: who knows which."""
    return None if None in keys else frozenset(key for key in keys if is_shared(key))
