"""The interpreter of CGT templates: `run`."""

from deburr.expand.cgt.run import run, worth_running

__all__ = ["run", "worth_running"]
