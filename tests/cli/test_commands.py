"""The commands as such: `deburr`, `deburr rule`, `python -m deburr`, and what a start must not load."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from deburr import __version__
from deburr.catalogue import rule_names, rules_of
from deburr.cli.main import COMMANDS
from deburr.dev.generate import SCHEMA, generated, schema
from deburr_grammar.dialects import NAMES

CLEAN = "G21 G90 G17\nG0 X1\nF100\nM2\n"
FAULTY = "G21 G90 G17\nG0 X[1/0]\nF100\nM2\n"
NEVER = {
    "rich", "click", "attr", "attrs", "cattrs", "pygls", "lsprotocol", "asyncio", "multiprocessing", "concurrent.futures",
    "difflib", "json", "pathspec", "tomllib", "unittest", "importlib.metadata", "importlib.resources", "email", "http",
    "socket", "subprocess", "xml", "sqlite3", "lark", "deburr.cli.rule", "deburr.cli.reporters.json", "deburr.dev",
}  # fmt: skip


def test_version_and_help(shell):
    assert shell.run("--version") == (0, f"deburr {__version__}\n", "")
    ran = shell.run("--help")
    assert ran.code == 0 and all(f"  {name}" in ran.out for name in COMMANDS)
    ran = shell.run()
    assert (ran.code, ran.out) == (2, "") and "commands:" in ran.err
    ran = shell.run("chek")
    assert ran == (2, "", "deburr: error: unknown command `chek`; did you mean `check`? (see `deburr --help`)\n")
    assert shell.run("--nonsense").code == 2


@pytest.mark.parametrize(
    ("command", "said"),
    [
        ("expand --decimals x p", "--decimals: `x` is neither a number from 0 to 15 nor `exact`"),
        ("expand --decimalz 3 p", "`--decimalz` is no option; did you mean `--decimals`?"),
        ("expand --eol=crl p", "--eol: `crl` is none of lf, crlf, source; did you mean `crlf`?"),
        ("expand", "FILE: missing"),
        ("expand p -D", "-D/--define: a value is missing"),
        ("check --fail-on fatal", "--fail-on: `fatal` is none of error, warning, info"),
        ("check -q -v", "-v/--verbose: not allowed with argument -q/--quiet"),
        ("check --select rs274.o-mismach", "--select: `rs274.o-mismach` is no rule; did you mean `rs274.o-mismatch`?"),
        ("server here", "`here`: one argument too many"),
    ],
)
def test_a_fault_of_options_is_said_in_a_line(shell, command, said):
    name = command.partition(" ")[0]
    line = f"deburr: error: {said} (see `deburr {name} --help`)\n"
    assert shell.run(*command.split()) == (2, "", line)


@pytest.mark.parametrize("command", COMMANDS)
def test_every_command_has_help(shell, command):
    ran = shell.run(command, "--help")
    assert ran.code == 0 and ran.out.startswith(f"usage: deburr {command}")


def test_the_help_says_that_there_is_no_run(shell):
    assert "static analysis only" in " ".join(shell.run("check", "--help").out.split())


def test_rule_page(shell):
    ran = shell.run("rule", "rs274.comment-nested")
    assert ran.code == 0
    assert ran.out.startswith("rs274.comment-nested (error)\n\nComment inside a comment.\n\n")
    assert "Source: spec/rs274.md" in ran.out
    assert "Bad:\n\n    G0 X1 (drill (first) hole)\n                 ^^^^^^^\n" in ran.out
    found = json.loads(shell.run("rule", "rs274.comment-nested", "--output-format", "json").out)
    assert (found["rule"], found["dialect"], found["severity"], found["default"]) == (
        "rs274.comment-nested",
        "rs274",
        "error",
        True,
    )
    assert found["examples"][0] == {
        "good": False,
        "options": [],
        "text": "G0 X1 (drill (first) hole)\n             ^^^^^^^",
    }
    page = shell.run("rule", "rs274.comment-nested", "--output-format", "markdown").out
    assert page.startswith("# rs274.comment-nested (error)\n\nComment inside a comment.\n\n")
    assert "Bad:\n\n```\nG0 X1 (drill (first) hole)\n             ^^^^^^^\n```" in page


def test_rule_list(shell):
    names = [line.split()[0] for line in shell.run("rule").out.splitlines()]
    assert sorted(names) == sorted(name for dialect in NAMES for name in rule_names(dialect))
    names = [line.split()[0] for line in shell.run("rule", "rs274.comment").out.splitlines()]
    assert names == ["rs274.comment-nested", "rs274.comment-unclosed"]
    assert len(json.loads(shell.run("rule", "rs274.comment", "--output-format", "json").out)) == 2
    assert shell.run("rule", "rs274.comment", "--output-format", "markdown").out.startswith("| rule |")


def test_rule_unknown(shell):
    ran = shell.run("rule", "rs274.comment-nestde")
    assert ran == (2, "", "deburr: error: `rs274.comment-nestde` is no rule; did you mean `rs274.comment-nested`?\n")
    assert "did you mean `rs274.comment-nested`" in shell.run("rule", "comment-nested").err
    assert shell.run("rule", "rs274.").err == "deburr: error: `rs274.` is no rule; did you mean `rs274`?\n"
    assert shell.run("rule", "rs274.o-").err == "deburr: error: `rs274.o-` is no rule; did you mean `rs274.o`?\n"
    assert shell.run("rule", "").err == "deburr: error: an empty text names no rule\n"


@pytest.mark.parametrize("name", NAMES)
def test_names_are_those_of_the_rules(name):
    assert rule_names(name) == tuple(rule.name for rule in rules_of(name))


def test_pages_of_common_rules_are_spelled_in_each_language(shell):
    for name in NAMES:
        page = shell.run("rule", f"{name}.allow-unknown").out
        assert f"deburr: allow {name}.line-too-lonk" in page and "{(}" not in page


def python(*arguments, folder, **more):
    environment = {**os.environ, "PYTHONDONTWRITEBYTECODE": "1"}
    return subprocess.run(
        [sys.executable, *arguments], cwd=folder, env=environment, capture_output=True, text=True, check=False, **more
    )


def test_as_a_module(shell):
    shell.write("a.ngc", FAULTY)
    ran = python("-m", "deburr", "check", "--output-format", "concise", folder=shell.folder)
    assert (ran.returncode, ran.stderr) == (1, "")
    assert ran.stdout.startswith("a.ngc:2:8: error rs274.divide-by-zero ")
    ran = python("-m", "deburr", "check", "-", "--dialect", "rs274", "-q", folder=shell.folder, input=CLEAN)
    assert (ran.returncode, ran.stdout, ran.stderr) == (0, "", "")


def test_what_check_does_not_load(shell):
    shell.write("a.ngc", FAULTY)
    code = "import sys; from deburr.cli.main import main; main(['check', 'a.ngc']); print(*sorted(sys.modules), file=sys.stderr)"
    loaded = set(python("-c", code, folder=shell.folder).stderr.split())
    assert "deburr.rules.rs274.divide_by_zero" in loaded
    assert not loaded & NEVER
    assert "deburr.values.graph" not in loaded, "a program without variables has no values to prove"
    assert not loaded & {f"deburr.rules.rs274.{each}" for each in ("comment_nested", "abort", "o_extra_text")}, (
        "the files of rules of which nothing is in the program stay unread"
    )
    assert not {
        name for name in loaded if name.startswith(("deburr.rules.z32", "deburr.rules.cgt", "deburr.rules.metagcode"))
    }


def test_the_schema_knows_every_table():
    properties = schema()["properties"]
    assert set(properties) == {"extend", "files", "check", "format", "editor", "machine", *NAMES}
    assert set(properties["check"]["properties"]) == {
        "select",
        "extend-select",
        "ignore",
        "fail-on",
        "run",
        "severity",
        "per-file-ignores",
    }
    assert properties["rs274"]["properties"]["profile"]["enum"] == ["linuxcnc", "smithy"]
    assert properties["rs274"]["properties"]["subroutine-path"]["items"] == {"type": "string"}


def test_every_rule_has_its_page_among_the_generated_ones():
    files = generated(Path(__file__).parents[2])
    assert json.loads(files[SCHEMA])["title"] == "deburr.toml"
    for dialect in NAMES:
        for name in rule_names(dialect):
            assert f"\n## {name} (" in files[f"docs/rules/{dialect}.md"]
            assert f"[`{name}`]({dialect}.md#{name.replace('.', '')}-" in files["docs/rules/README.md"]
