"""Programs put in the place of others: written whole, in their own encoding, or shown as a change."""

from collections.abc import Iterator

from deburr.source import Source


def saved(file: str, source: Source) -> str:
    """Put a program in the place of its file; why that cannot be done, or nothing."""
    from deburr.cli.replacing import replacing

    try:
        with replacing(file) as out:
            out.write(source.data)
    except OSError as error:
        return f"cannot be written: {error.strerror}"
    return ""


def difference(old: str, new: str, name: str) -> Iterator[str]:
    """A change as a unified diff, which `patch` understands."""
    from difflib import unified_diff

    for line in unified_diff(_lines(old), _lines(new), name, name):
        yield line if line.endswith("\n") else f"{line}\n\\ No newline at end of file\n"


def _lines(text: str) -> list[str]:
    """Lines as `patch` counts them."""
    *whole, tail = text.split("\n")
    return [*(f"{line}\n" for line in whole), *([tail] if tail else [])]
