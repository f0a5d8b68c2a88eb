"""The documentation site: it is built with warnings as errors, and every command on its pages is run in a copy of the tree."""

import json
import re
import shlex
import subprocess
import sys
from pathlib import Path

import pytest

from deburr.cli.main import COMMANDS
from deburr.dev.reference import reference
from deburr.schema import tables
from deburr_grammar.dialects import NAMES, by_name
from support.clone import Clone

ROOT = Path(__file__).parent.parent
DOCS = ROOT / "docs"
PAGES = sorted(
    path for folder in ("tutorial", "how-to", "reference", "explanation") for path in (DOCS / folder).glob("*.md")
)
BLOCK = re.compile(r"(?m)(<!-- not-run: [^>]+ -->\n)?^```sh\n(.*?)^```$", re.S)
CODE = re.compile(r"# exits with (\d)$")


def commands(page: Path) -> list[str]:
    found = (match[2] for match in BLOCK.finditer(page.read_text(encoding="utf-8")) if not match[1])
    return [line for text in found for line in text.strip().split("\n")]


@pytest.fixture(scope="module")
def clone(tmp_path_factory: pytest.TempPathFactory) -> Clone:
    return Clone(tmp_path_factory.mktemp("clone"))


@pytest.mark.parametrize("page", [path for path in PAGES if commands(path)], ids=lambda path: path.stem)
def test_commands_do_what_the_page_says(page: Path, clone: Clone) -> None:
    for command in commands(page):
        code = CODE.search(command)
        clone.run(command, int(code[1]) if code else 0)


def test_what_the_pages_say_of_the_examples(clone: Clone) -> None:
    run = clone.run
    assert run(".venv/bin/deburr check examples/rs274/scrap.ngc", 1).count("error[") == 5
    holes = run(".venv/bin/deburr expand examples/rs274/bolt_circle.ngc")
    assert len(re.findall(r"(?m)^\s*G81 ", holes)) == 8
    layers = {
        depth: run(
            f".venv/bin/deburr expand examples/metagcode/pocket.mgc --variables examples/metagcode/pocket.vars {depth}"
        ).count("(layer at")
        for depth in ("", "-D Depth=9")
    }
    # 5 mm in steps of 1.5 mm at most are four; 9 mm are six.
    assert layers == {"": 4, "-D Depth=9": 6}


def test_each_dialect_has_a_tutorial_and_every_page_is_in_the_navigation() -> None:
    assert {path.stem for path in (DOCS / "tutorial").iterdir()} == set(NAMES)
    navigation = (ROOT / "mkdocs.yml").read_text(encoding="utf-8")
    for path in [*DOCS.rglob("*.md")]:
        assert f": {path.relative_to(DOCS)}\n" in navigation, path


def test_the_reference_names_all_that_there_is() -> None:
    pages = reference()
    for path, known in tables().items():
        for setting in known if type(known) is tuple else ():
            assert f"## [{'.'.join(path)}]" in pages["reference/configuration.md"]
            assert f"| `{setting.name}` |" in pages["reference/configuration.md"]
    for name in COMMANDS:
        assert f"## deburr {name}\n" in pages["reference/command-line.md"]
    assert "<code>--shard K/N</code>" in pages["reference/command-line.md"]
    for name in NAMES:
        titles = {entry.title for entry in by_name(name).codes if not re.search(r"[<|]", entry.title)}
        assert [each for each in titles if " ".join(each.split()) not in pages[f"reference/{name}.md"]] == []


def test_the_site_is_built_without_a_warning(tmp_path: Path) -> None:
    build = (sys.executable, "-m", "mkdocs", "build", "--strict", "--site-dir", str(tmp_path))
    done = subprocess.run(build, cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr[-4000:]
    page = (tmp_path / "reference/configuration/index.html").read_text(encoding="utf-8")
    assert "extend-select" in page
    assert not re.search(r'<(?:script|link)[^>]+(?:src|href)="https?://(?!squidfunk)', page), "nothing is fetched"
    found = json.loads((tmp_path / "search/search_index.json").read_text(encoding="utf-8"))
    assert any("divide-by-zero" in each["location"] for each in found["docs"])


def test_commands_are_deburrs_own(clone: Clone) -> None:
    """A page that is read by strangers asks for nothing but deburr and what every system has."""
    first = {shlex.split(command)[0] for page in PAGES for command in commands(page)}
    assert first == {".venv/bin/deburr", ".venv/bin/python", "diff"}
