"""Configuration of the editors that cannot be run here: that it can be read, and knows the files that deburr knows."""

from __future__ import annotations

import json
import re
import tomllib
from pathlib import Path
from xml.etree import ElementTree

import pytest

from deburr.detect import SHARED
from deburr_grammar.dialects import NAMES, by_name

FOLDER = Path(__file__).parents[2] / "editors"
OWN = {name: {each.removeprefix(".") for each in by_name(name).extensions} for name in NAMES}
NOT_RUN = ("helix", "kate", "sublime")


def check_known(known: dict[str, set[str]]) -> None:
    """The dialects by their own files, and one more for those whose extension says nothing."""
    assert {name: endings for name, endings in known.items() if name != "gcode"} == OWN
    assert known["gcode"] <= {each.removeprefix(".") for each in SHARED}


def test_helix() -> None:
    found = tomllib.loads((FOLDER / "helix/languages.toml").read_text(encoding="utf-8"))
    check_known({each["name"]: set(each["file-types"]) for each in found["language"]})
    assert all(each["language-servers"] == list(found["language-server"]) for each in found["language"])


def test_kate() -> None:
    modes = {}
    for path in (FOLDER / "kate/syntax").iterdir():
        language = ElementTree.parse(path).getroot()
        modes[language.attrib["name"]] = {each.removeprefix("*.") for each in language.attrib["extensions"].split(";")}
    servers = json.loads((FOLDER / "kate/settings.json").read_text(encoding="utf-8"))["servers"]
    known = {}
    for name, server in servers.items():
        (mode,) = [mode for mode in modes if re.search(server["highlightingModeRegex"], mode)]
        known[name] = modes[mode]
    check_known(known)


def test_sublime() -> None:
    known = {}
    for path in (FOLDER / "sublime").glob("*.sublime-syntax"):
        text = path.read_text(encoding="utf-8")
        scope, endings = re.search(r"(?m)^scope: source\.(\w+)$", text), re.search(r"file_extensions: \[(.*)\]", text)
        assert scope is not None and endings is not None
        known[scope[1]] = set(endings[1].split(", "))
    check_known(known)
    settings = json.loads((FOLDER / "sublime/LSP.sublime-settings").read_text(encoding="utf-8"))
    assert set(re.findall(r"source\.(\w+)", settings["clients"]["deburr"]["selector"])) == set(known)


@pytest.mark.parametrize("editor", sorted(path.name for path in FOLDER.iterdir()))
def test_what_could_not_be_run_is_said_to_be_untested(editor: str) -> None:
    text = (FOLDER / editor / "README.md").read_text(encoding="utf-8")
    assert ("**Untested**" in text) == (editor in NOT_RUN)
    for name in NAMES:
        assert all(f"`*{each}`" in text for each in by_name(name).extensions)
