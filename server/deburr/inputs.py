"""What a run of a program is given from outside. Knows no language."""

from collections.abc import Mapping
from typing import NamedTuple


class Inputs(NamedTuple):
    """What the operator and the machine would give.

    ``define``: values by the language's own names. ``block_delete``: the operator's switch; None: not known.
    ``simulate``: values that only a machine has are answered as the stand-alone interpreter does.
    ``decimals``: at most so many in computed values; None: as the dialect has it. ``partial``: what was
    produced before a fault is wanted. ``reached_only``: what is wrong with a text stops the run only where it comes to it.
    """

    define: Mapping[str, str] = {}
    block_delete: bool | None = None
    simulate: bool = False
    keep_n: bool = False
    decimals: int | None = None
    partial: bool = False
    reached_only: bool = False
