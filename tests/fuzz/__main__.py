"""`python -m tests.fuzz TARGET [--corpus FOLDER] [--seeds N] [OPTIONS]`: fuzz a target; the options are libFuzzer's, such as `-runs=10000`.

What makes it fail is written to the working folder, or to where `-artifact_prefix=` says, and ends it with another code than 0.
``--corpus``: what reaches new code is kept in a folder, and the next run begins with it. ``--seeds``: so many of the seeds are enough.
"""

from __future__ import annotations

import argparse
import logging
import sys
import time
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from fuzz.targets import Target

_HERE = Path(__file__).parent
SECONDS = 20.0
"""Of processor time for one input: five times what the slowest of them took under the fuzzer, whose counting makes all slower."""
_LONGEST = 2_048


def main(arguments: list[str]) -> None:
    """Load the target with its code counted, write its seeds, and fuzz."""
    import atheris

    parser = argparse.ArgumentParser(allow_abbrev=False)
    parser.add_argument("target")
    parser.add_argument("--corpus", type=Path)
    parser.add_argument("--seeds", type=int, default=0)
    said, options = parser.parse_known_args(arguments)
    # Requests that are refused are what is wanted, and thousands of them are.
    logging.disable(logging.CRITICAL)
    with atheris.instrument_imports(include=["deburr", "deburr_grammar", "fuzz.planted"], enable_loader_override=False):
        from fuzz import stock
        from fuzz.targets import target

        found = target(said.target)
        with TemporaryDirectory(prefix="deburr-fuzz-") as folder:
            place = Path(folder)
            (place / "words").write_text("\n".join(stock.words()))
            corpus = said.corpus or place / "new"
            kept = _HERE / "kept" / said.target
            folders = [corpus, _seeds(found, said.seeds, place / "seeds"), *([kept] if kept.is_dir() else [])]
            corpus.mkdir(parents=True, exist_ok=True)
            settings = [f"-max_len={_LONGEST}", f"-dict={place / 'words'}", *options]
            atheris.Setup([said.target, *settings, *map(str, folders)], _timed(found.run))
            atheris.Fuzz()


def _seeds(target: Target, most: int, folder: Path) -> Path:
    """The seeds as files: all of them, or so many from all over."""
    folder.mkdir()
    found = list(target.seeds())
    for number, seed in enumerate(found[:: max(len(found) // most, 1) if most else 1]):
        (folder / f"{number:04}").write_bytes(seed)
    return folder


def _timed(run: Callable[[bytes], None]) -> Callable[[bytes], None]:
    """Fails for what takes too long, too."""

    def timed(data: bytes) -> None:
        started = time.process_time()
        run(data)
        took = time.process_time() - started
        assert took < SECONDS, f"{took:.1f} s for {len(data)} bytes"

    return timed


if __name__ == "__main__":
    sys.path.insert(0, str(_HERE.parent))
    main(sys.argv[1:])
