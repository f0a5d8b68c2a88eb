"""Starts the bundled language server; run as `python -I serve.py`, so that nothing of the user's environment takes part."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent / "libs"))

from deburr.cli.main import main

sys.exit(main(["server"]))
