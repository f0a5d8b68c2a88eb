"""The limits of the language, each the last legal value (spec/metagcode.md §5.1, §7, §10)."""

DEEPEST = 20
"""Depth of a snippet; the program itself is at 0."""
LARGEST = 1 << 20
"""Bytes that a snippet may have."""
LINES = 1_000_000
"""Lines that a text may have with all its snippets put in."""
NESTED = 200
"""How deep blocks may be nested in that text."""
PASSES = 100_000
"""Passes that one loop may make."""
ALL_PASSES = 1_000_000
"""Passes that all loops together may make."""
