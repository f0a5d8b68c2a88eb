"""The block numbers that may have been meant where there is none of a number."""

from collections.abc import Sequence

from deburr.analysis import Analysis
from deburr.expand.z32 import nearest
from deburr.rules.z32._program import all_labels


def meant(analysis: Analysis, target: float) -> str:
    """The end of a message on a block number that does not exist."""
    return nearest.meant(_numbers(analysis), target)


def _numbers(analysis: Analysis) -> Sequence[float]:
    """All block numbers in order."""
    if "z32 block numbers" not in analysis.memo:
        analysis.memo["z32 block numbers"] = sorted({number for number, _ in all_labels(analysis)})
    found: Sequence[float] = analysis.memo["z32 block numbers"]
    return found
