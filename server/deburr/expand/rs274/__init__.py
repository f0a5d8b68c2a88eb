"""The interpreter of RS274: `run`."""

from deburr.expand.rs274.run import run, worth_running

__all__ = ["run", "worth_running"]
