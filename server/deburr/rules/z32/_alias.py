"""The letters of a G25 word (spec/z32.md §6.5)."""

from deburr.rule import Line
from deburr_grammar.tree import Node

ORDERS = ("XYZ", "YZX", "ZXY")
"""The three that the reference shows."""


def letters(line: Line, alias: Node) -> str:
    """What stands behind `G25`, in upper case."""
    return line.said(alias).upper().rpartition("5")[2]


def axes(line: Line, alias: Node) -> str:
    """The three different letters that a G25 names; empty if it does not."""
    named = letters(line, alias)
    return named if len(named) == 3 and named.isalpha() and len(set(named)) == 3 else ""
