"""The interpreter of Z32: `run`."""

from deburr.expand.z32.run import run, worth_running

FOLLOWS = ("block_delete", "keep_n", "decimals")
CHECKS = True
ONLY_WHAT_RUNS = True
"""Of lines that never run only the form is judged (spec/z32.md §11)."""
JOINS = True
"""Several programs run one after the other, each with parameters of its own."""
__all__ = ["CHECKS", "FOLLOWS", "JOINS", "ONLY_WHAT_RUNS", "run", "worth_running"]
