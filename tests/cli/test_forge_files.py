"""What plugs deburr into other tools does what it says: each file's own commands are run, with one deburr installed as they install it."""

from __future__ import annotations

import json
import os
import re
import shlex
import shutil
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest
import yaml

from deburr import __version__
from support.code import ROOT

WHEEL = f"deburr-{__version__}-py3-none-any.whl"
FAULTY, CLEAN = "G21 G90 G17\nG0 X[1/0]\nF100\nM2\n", "G21 G90 G17\nF100\nM2\n"


def read(name: str) -> Any:
    return yaml.safe_load((ROOT / name).read_text(encoding="utf-8"))


def bash(script: str, folder: Path, environment: Mapping[str, str]) -> subprocess.CompletedProcess[str]:
    """A step as GitHub's runner runs it."""
    clean = {name: value for name, value in os.environ.items() if not name.startswith(("PYTHON", "VIRTUAL_ENV", "CI"))}
    return subprocess.run(
        ["bash", "--noprofile", "--norc", "-eo", "pipefail", "-c", script],
        cwd=folder,
        env={**clean, **environment},
        capture_output=True,
        text=True,
        check=False,
    )


class Action:
    """The steps of the action on a runner whose folder for all that passes is `temp`."""

    def __init__(self, temp: Path) -> None:
        self.temp = temp
        self.install, self.check = read("action.yml")["runs"]["steps"]

    def run(self, step: Mapping[str, Any], folder: Path, **inputs: str) -> subprocess.CompletedProcess[str]:
        known = read("action.yml")["inputs"]
        given = {f"${{{{ inputs.{name} }}}}": inputs.get(name, said["default"]) for name, said in known.items()}
        (self.temp / "output").write_text("")
        environment = {
            "RUNNER_TEMP": str(self.temp),
            "GITHUB_ACTION_PATH": str(ROOT),
            "GITHUB_WORKSPACE": str(folder),
            "GITHUB_OUTPUT": str(self.temp / "output"),
            "DEBURR_CACHE_DIR": str(self.temp / "kept"),
            **{name: given[value] for name, value in step.get("env", {}).items()},
        }
        return bash(step["run"], folder, environment)


@pytest.fixture(scope="module")
def action(tmp_path_factory: pytest.TempPathFactory) -> Action:
    found = Action(tmp_path_factory.mktemp("runner"))
    done = found.run(found.install, found.temp)
    assert done.returncode == 0, done.stderr
    return found


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "a part").mkdir()
    (tmp_path / "a part" / "a.ngc").write_text(FAULTY)
    (tmp_path / "b.ngc").write_text(CLEAN)
    return tmp_path


def test_the_action(action: Action, folder: Path) -> None:
    done = action.run(action.check, folder)
    assert done.returncode == 1
    assert done.stdout.startswith("::error title=deburr (rs274.divide-by-zero),file=a part/a.ngc,line=2,")
    said = (action.temp / "output").read_text().strip().removeprefix("sarif=")
    assert len(json.loads(Path(said).read_text())["runs"][0]["results"]) == 1


def test_the_action_takes_inputs_as_they_are(action: Action, folder: Path) -> None:
    assert action.run(action.check, folder, paths="b.ngc\n").returncode == 0
    done = action.run(action.check, folder, paths="a part\nb.ngc", arguments="--ignore\nrs274.divide-by-zero")
    assert (done.returncode, done.stdout) == (0, "")
    done = action.run(action.check, folder, paths="$(touch owned); touch owned\n--exit-zero")
    assert done.returncode == 2 and "no such file" in done.stderr and not (folder / "owned").exists()


def test_the_gitlab_job(action: Action, folder: Path) -> None:
    said = read("forges/gitlab.yml")
    job, variables = said["deburr"], said["variables"]
    path = f"{action.temp}/deburr/bin:{os.environ['PATH']}"
    environment = {**variables, "PATH": path, "DEBURR_SOURCE": str(ROOT), "CI_PROJECT_DIR": str(folder)}
    assert [bash(line, folder, environment).returncode for line in job["before_script"]] == [0]
    (done,) = [bash(line, folder, environment) for line in job["script"]]
    assert done.returncode == 1 and "error[rs274.divide-by-zero]" in done.stdout
    reports = job["artifacts"]["reports"]
    (issue,) = json.loads((folder / reports["codequality"]).read_text())
    assert issue["location"]["path"] == "a part/a.ngc"
    assert "<failure" in (folder / reports["junit"]).read_text()
    assert [(folder / path / ".gitignore").exists() for path in job["cache"]["paths"]] == [True]


def test_the_gitlab_job_says_what_it_wants(folder: Path) -> None:
    said = read("forges/gitlab.yml")
    (line,) = said["deburr"]["before_script"]
    done = bash(line, folder, {**said["variables"], "PATH": os.environ["PATH"]})
    assert done.returncode != 0 and "say in variables where pip gets deburr from" in done.stderr


def to_copy() -> list[Any]:
    """The workflows of the page on CI: that for GitHub and that for GitLab."""
    page = (ROOT / "docs/how-to/ci.md").read_text(encoding="utf-8")
    return [yaml.safe_load(text) for text in re.findall(r"(?ms)^```yaml\n(.*?)^```$", page)]


def test_the_workflow_to_copy(action: Action, folder: Path) -> None:
    workflow, _ = to_copy()
    steps = workflow["jobs"]["check"]["steps"]
    environment = {**workflow["env"], "PATH": f"{action.temp}/deburr/bin:{os.environ['PATH']}"}
    assert environment["DEBURR_SOURCE"].endswith(f"/{WHEEL}")
    environment |= {"DEBURR_SOURCE": str(ROOT), "GITHUB_WORKSPACE": str(folder)}
    install, check = [bash(step["run"], folder, environment) for step in steps if "run" in step]
    assert (install.returncode, check.returncode) == (0, 1), install.stderr
    assert check.stdout.startswith("::error title=deburr (rs274.divide-by-zero),file=a part/a.ngc,line=2,")
    # It comes behind a step that fails, where by default nothing more is run.
    (upload,) = [step for step in steps if "upload-sarif" in step.get("uses", "")]
    assert upload["if"] == "success() || failure()" and workflow["permissions"]["security-events"] == "write"
    assert len(json.loads((folder / upload["with"]["sarif_file"]).read_text())["runs"][0]["results"]) == 1
    assert [step["uses"].partition("@")[0] for step in steps if "uses" in step] == [
        "actions/checkout",
        "actions/setup-python",
        "github/codeql-action/upload-sarif",
    ]


def test_the_pipeline_to_copy_is_the_job_that_is_included() -> None:
    _, pipeline = to_copy()
    included = read("forges/gitlab.yml")
    assert pipeline["variables"]["DEBURR_SOURCE"].endswith(f"/{WHEEL}")
    job = included["deburr"]
    (line,) = job["before_script"]
    copied = {
        **job,
        "before_script": [re.sub(r":\?.*\}", "}", line).replace("${DEBURR_SOURCE}", "$DEBURR_SOURCE")],
        "script": [job["script"][0].replace("$DEBURR_PATHS", included["variables"]["DEBURR_PATHS"])],
    }
    assert pipeline["deburr"] == copied


def test_the_container(action: Action, folder: Path, tmp_path_factory: pytest.TempPathFactory) -> None:
    lines = (ROOT / "forges/Containerfile").read_text().splitlines()
    said = dict(line.split(" ", 1) for line in lines if line and not line.startswith("#"))
    assert said["COPY"] == ". /src"
    source = tmp_path_factory.mktemp("image") / "src"
    for name in ("grammar", "server"):
        ignored = shutil.ignore_patterns("__pycache__")
        shutil.copytree(ROOT / name, source / name, ignore=ignored)
    for name in ("pyproject.toml", "README.md", "LICENSE"):
        shutil.copy(ROOT / name, source)
    environment = {"PATH": f"{action.temp}/deburr/bin:{os.environ['PATH']}"}
    done = bash(said["RUN"].replace("/src", str(source)), folder, environment)
    assert (done.returncode, source.exists()) == (0, False), done.stderr
    name, _, value = said["ENV"].partition("=")
    environment[name] = value.replace("/tmp", str(source.parent))
    command = shlex.join([*json.loads(said["ENTRYPOINT"]), *json.loads(said["CMD"])])
    done = bash(command, folder, environment)
    assert done.returncode == 1 and "Found 1 error in 1 file (2 checked)" in done.stdout
    assert not (folder / ".deburr_cache").exists() and (source.parent / "deburr").exists()


def pre_commit(folder: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    path = f"{Path(sys.executable).parent}:{os.environ['PATH']}"
    environment = {
        **os.environ,
        "PATH": path,
        "PRE_COMMIT_HOME": str(folder / ".home"),
        "GIT_CONFIG_GLOBAL": "/dev/null",
    }
    command = [sys.executable, "-m", "pre_commit", *arguments]
    return subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, check=False)


def git(folder: Path, *arguments: str) -> None:
    subprocess.run(["git", *arguments], cwd=folder, check=True, capture_output=True)


def test_the_hooks_are_such(tmp_path: Path) -> None:
    done = pre_commit(tmp_path, "validate-manifest", str(ROOT / ".pre-commit-hooks.yaml"))
    assert done.returncode == 0, done.stdout + done.stderr


def test_the_hooks_hold_up_a_commit(folder: Path) -> None:
    hooks = [{**hook, "language": "system"} for hook in read(".pre-commit-hooks.yaml")]
    (folder / "rough.ngc").write_text("G21\no1 if [#<_x> GT 1]\nM3 S100   \no1 endif\nM2\n")
    (folder / "c.nc").write_text("G0 X1\nM30\n")
    (folder / ".pre-commit-config.yaml").write_text(yaml.safe_dump({"repos": [{"repo": "local", "hooks": hooks}]}))
    (folder / ".gitignore").write_text(".home\n.deburr_cache\n")
    git(folder, "init", "-q")
    git(folder, "add", "-A")
    done = pre_commit(folder, "run", "--all-files", "deburr-check")
    assert done.returncode == 1 and "error[rs274.divide-by-zero]" in done.stdout and "c.nc" not in done.stdout
    (folder / "a part" / "a.ngc").write_text(CLEAN)
    git(folder, "add", "-A")
    assert pre_commit(folder, "run", "--all-files", "deburr-check").returncode == 0
    done = pre_commit(folder, "run", "--all-files", "deburr-format")
    assert done.returncode == 1 and "files were modified by this hook" in done.stdout
    assert (folder / "rough.ngc").read_text() == "G21\no1 if [#<_x> GT 1]\n  M3 S100\no1 endif\nM2\n"
