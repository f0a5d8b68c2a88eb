"""What a run of a program is given from outside. Knows no language."""

from collections.abc import Mapping
from typing import NamedTuple


class Ways(NamedTuple):
    """How whoever asks for a run gives it what it lacks, as parts of messages. ``{}`` stands for NAME=VALUE; those of the command line, if nothing is said."""

    define: str = "-D {}"
    misgiven: str = "-D {}"
    """Before what is wrong with a value."""
    switch: str = "--block-delete on or off"
    input: str = "--input FILE"
    steps: str = "--max-steps"
    blocks: str = "--max-blocks"


EDITOR = Ways(
    "`{}` in the command's `define`",
    "`define`: {}",
    "`on` or `off` in the command's `blockDelete`",
    "the command's `input`",
    "the command's `maxSteps`",
    "the command's `maxBlocks`",
)
"""What editors have: the arguments of the server's `deburr.expand`."""


class Inputs(NamedTuple):
    """What the operator and the machine would give.

    ``define``: values by the language's own names. ``typed``: which of these names somebody wrote one by one, and may have
    mistyped. ``block_delete``: the operator's switch; None: not known.
    ``simulate``: values that only a machine has are answered as the stand-alone interpreter does.
    ``decimals``: at most so many in computed values; None: as the dialect has it. ``partial``: what was
    produced before a fault is wanted. ``reached_only``: what is wrong with a text stops the run only where it comes to it.
    ``ways``: how messages call all that.
    """

    define: Mapping[str, str] = {}
    block_delete: bool | None = None
    simulate: bool = False
    keep_n: bool = False
    decimals: int | None = None
    partial: bool = False
    reached_only: bool = False
    ways: Ways = Ways()
    typed: tuple[str, ...] = ()
