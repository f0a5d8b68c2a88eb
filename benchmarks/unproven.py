"""deburr's server with the proofs of values turned off, to tell what they cost someone who types."""

from collections.abc import Iterator

from deburr import values
from deburr.analysis import Analysis
from deburr.cli.main import run
from deburr.finding import Finding


def nothing(_analysis: Analysis) -> Iterator[Finding | None]:
    """Proves nothing."""
    return iter(())


if __name__ == "__main__":
    values.proving = nothing
    run()
