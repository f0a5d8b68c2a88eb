"""The interpreter of RS274: `run`."""

from deburr.expand.rs274.files import unread_by_programs as unread
from deburr.expand.rs274.run import run, worth_running

FOLLOWS = ("block_delete", "machine_values", "keep_n", "decimals")
__all__ = ["FOLLOWS", "run", "unread", "worth_running"]
