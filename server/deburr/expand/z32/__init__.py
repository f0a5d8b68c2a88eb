"""The interpreter of Z32: `run`."""

from deburr.expand.z32.run import run, worth_running

__all__ = ["run", "worth_running"]
