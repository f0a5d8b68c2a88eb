"""The forms in which `deburr check` reports, one module each, found by name: `json_lines` is `--output-format json-lines`.

A reporter has `report(result, out, style)`; `statistics(rows, out, style)` if it can count;
`TEXT`, true if it is read by people and ends with the summary line; and `KEYED`, true if it names fingerprints.
"""

from importlib import import_module
from pkgutil import iter_modules
from typing import Any


def names() -> tuple[str, ...]:
    """The forms that there are."""
    return tuple(sorted(module.name.replace("_", "-") for module in iter_modules(__path__)))


def by_name(name: str) -> Any:
    """The reporter of that name."""
    return import_module(f"{__name__}.{name.replace('-', '_')}")
