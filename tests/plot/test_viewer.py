"""The viewer's script in the package is the one that its sources make, small, and can stand in a page."""

import hashlib
import json
import re
from importlib import resources
from pathlib import Path

EXTENSION = Path(__file__).parents[2] / "vscode-extension"
SCRIPT = resources.files("deburr.plot").joinpath("viewer.js").read_text(encoding="utf-8")


def test_it_is_made_from_the_sources_that_are_there():
    """As scripts/viewer.mjs sums them up. tests/editors makes it again, to the byte, where there is npm."""
    made = hashlib.sha256()
    for path in sorted((EXTENSION / "viewer").iterdir()):
        made.update(f"{path.name}\n".encode() + path.read_bytes())
    packages = json.loads((EXTENSION / "package-lock.json").read_text())["packages"]
    for name in ("three", "esbuild"):
        made.update(f"{name} {packages[f'node_modules/{name}']['integrity']}\n".encode())
    said = re.match(r"/\* Made by vscode-extension/scripts/viewer\.mjs from ([0-9a-f]{64})\.", SCRIPT)
    assert said is not None and said[1] == made.hexdigest(), (
        "run `npm ci && node scripts/viewer.mjs` in vscode-extension"
    )


def test_it_is_small():
    assert len(SCRIPT) < 800_000


def test_nothing_in_it_ends_the_element_that_it_stands_in():
    assert "</script" not in SCRIPT.lower() and "<!--" not in SCRIPT


def test_it_names_what_it_holds_and_under_which_licence():
    assert "three.js authors, MIT licence" in SCRIPT.split("\n", 1)[0]
