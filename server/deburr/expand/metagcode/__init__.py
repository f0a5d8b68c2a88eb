"""The interpreter of MetaGCODE: `run`."""

from deburr.expand.metagcode.phases import run, worth_running

__all__ = ["CHECKS", "FOLLOWS", "run", "worth_running"]

FOLLOWS = ("decimals",)
CHECKS = True
"""Test steps hang together only when they are joined, so a run looks for all faults of form itself."""
