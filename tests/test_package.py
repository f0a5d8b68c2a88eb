"""What `python -m build` makes: an sdist with all that its tests need, and a wheel that runs alone and tells its types."""

import subprocess
import sys
import tarfile
from pathlib import Path
from zipfile import ZipFile

import pytest

from support.clone import tracked

ROOT = Path(__file__).parent.parent
PROGRAM = """from deburr_grammar import Document
from deburr_grammar.dialects import by_name
lines: {} = Document.parse("G0 X1", by_name("rs274")).line_count
"""


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Both archives. The wheel is built from the sdist, so that holds all that a build needs."""
    folder = tmp_path_factory.mktemp("dist")
    run(ROOT, sys.executable, "-m", "build", "--no-isolation", "--outdir", str(folder), str(ROOT))
    assert sorted(path.suffix for path in folder.iterdir()) == [".gz", ".whl"]
    return folder


@pytest.fixture(scope="module")
def python(built: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """An environment with the wheel and what it asks for, and nothing else."""
    folder = tmp_path_factory.mktemp("alone")
    run(folder, sys.executable, "-m", "venv", ".venv")
    found = folder / ".venv/bin/python"
    run(folder, str(found), "-m", "pip", "install", "-q", str(next(built.glob("*.whl"))))
    return found


def test_the_sdist_holds_what_its_tests_need(built: Path, tmp_path: Path) -> None:
    with tarfile.open(next(built.glob("*.tar.gz"))) as archive:
        archive.extractall(tmp_path, filter="data")
    (folder,) = tmp_path.iterdir()
    missing = [name for name in tracked(ROOT) if not (folder / name).is_file()]
    assert missing == []
    said = run(
        folder, sys.executable, "-m", "pytest", "tests/rules/test_pages.py", "-k", "nul-bytes", "-p", "no:cacheprovider"
    )
    assert " passed" in said


def test_the_wheel_holds_the_packages_and_their_data(built: Path) -> None:
    with ZipFile(next(built.glob("*.whl"))) as wheel:
        held = set(wheel.namelist())
    inside = [
        name.partition("/")[2]
        for name in tracked(ROOT)
        if name.startswith(("grammar/deburr_grammar/", "server/deburr/"))
    ]
    assert [name for name in inside if name not in held] == []
    assert {"deburr/py.typed", "deburr_grammar/py.typed"} <= held
    assert {name.partition("/")[0] for name in held} == {"deburr", "deburr_grammar", "deburr-0.1.0.dist-info"}


def test_the_wheel_runs_alone(python: Path, tmp_path: Path) -> None:
    deburr = str(python.parent / "deburr")
    (tmp_path / "a.ngc").write_text("o<a> sub\nG1 X[1+]\nM2\n", encoding="utf-8")
    (tmp_path / "b.ngc").write_text("#1=2\nG21 G90 G0 X[#1*3]\nM2\n", encoding="utf-8")
    assert "rs274." in run(tmp_path, deburr, "check", "a.ngc", code=1)
    assert run(tmp_path, deburr, "expand", "b.ngc") == "G21 G90 G0 X6\nM2\n"
    where = run(
        tmp_path, str(python), "-c", "import deburr, deburr_grammar; print(deburr.__file__, deburr_grammar.__file__)"
    )
    assert where.count(str(python.parents[1])) == 2


def test_types_are_shipped(python: Path, tmp_path: Path) -> None:
    """A checker that sees only the installed package finds a wrong type, and no fault in a right one."""
    for name, kind in (("right", "int"), ("wrong", "str")):
        (tmp_path / f"{name}.py").write_text(PROGRAM.format(kind), encoding="utf-8")
    mypy = (
        sys.executable,
        "-m",
        "mypy",
        "--strict",
        "--config-file=",
        "--cache-dir=.cache",
        f"--python-executable={python}",
    )
    assert "Success" in run(tmp_path, *mypy, "right.py")
    assert 'variable has type "str"' in run(tmp_path, *mypy, "wrong.py", code=1)


def run(folder: Path, *command: str, code: int = 0) -> str:
    """What a command printed, which ends with that code."""
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == code, f"{command}\n{done.stdout[-3000:]}\n{done.stderr[-3000:]}"
    return done.stdout
