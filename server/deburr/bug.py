"""Impossible states: raised in tests, logged where people work. Never used for a faulty program."""

import logging
import os


def bug(what: str) -> None:
    """Say that the code itself is wrong, and go on."""
    if "PYTEST_CURRENT_TEST" in os.environ:
        raise AssertionError(what)
    logging.getLogger("deburr").error("bug: %s", what)
