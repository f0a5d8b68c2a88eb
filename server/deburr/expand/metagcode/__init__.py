"""The interpreter of MetaGCODE: `run`."""

from deburr.expand.metagcode.phases import run, unread, worth_running

__all__ = ["CHECKS", "FOLLOWS", "JOINS", "run", "unread", "worth_running"]

FOLLOWS = ("decimals",)
CHECKS = True
"""Test steps hang together only when they are joined, so a run looks for all faults of form itself."""
JOINS = True
"""Several programs are test steps of one."""
