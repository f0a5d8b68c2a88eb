"""The interpreter of Z32: `run`."""

from deburr.expand.z32.run import run, worth_running

FOLLOWS = ("block_delete", "keep_n", "decimals")
CHECKS = True
ONLY_WHAT_RUNS = True
"""Of lines that never run only the form is judged (spec/z32.md §11)."""
__all__ = ["CHECKS", "FOLLOWS", "ONLY_WHAT_RUNS", "run", "worth_running"]
