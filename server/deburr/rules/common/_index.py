"""What decides whether the rules beside it are asked (deburr/catalogue.py). Written by `python -m deburr.dev.generate`."""

from typing import Any

# fmt: off
ROWS: tuple[tuple[Any, ...], ...] = (
    ('allow_misspelt', 2, True, False, False, 'Noticed', {}, False),
    ('allow_unknown', 2, True, False, False, 'Noticed', {}, False),
    ('allow_unused', 2, True, False, False, 'Noticed', {}, False),
    ('cut_without_spindle', 2, True, False, False, 'Moved', {'needs': 'spindle', 'unless_said': True}, False),
    ('line_too_deep', 3, True, False, False, 'Syntax', {'kinds': (), 'only': None}, False),
    ('line_too_long', 3, True, False, False, 'Syntax', {'kinds': (), 'only': None}, False),
    ('nul_bytes', 1, True, False, False, 'Noticed', {}, False),
    ('outside_limits', 3, True, False, False, 'Moved', {'needs': 'limits', 'unless_said': None}, False),
    ('rapid_below_safe', 2, True, False, False, 'Moved', {'needs': 'z-safe', 'unless_said': None}, False),
)
