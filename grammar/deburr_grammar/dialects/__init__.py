"""The dialects that there are: each is a folder here and a line in this list."""

from importlib import import_module

from deburr_grammar.dialect import Dialect

NAMES = ("metagcode", "rs274", "cgt", "z32")
"""Ids of the dialects, which are also their folders and their language ids in editors."""


def by_name(name: str) -> Dialect:
    """The dialect of that id, loaded when it is first asked for."""
    if name not in NAMES:
        raise KeyError(name)
    dialect: Dialect = import_module(f"{__name__}.{name}").DIALECT
    return dialect
