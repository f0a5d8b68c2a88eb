"""Fuzzing that is led by coverage: `python -m tests.fuzz TARGET`. What was found once lies in `kept` and is tried in every test run."""
