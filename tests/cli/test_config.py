"""Configuration: which file, what may stand in it, what it does; `deburr config` and `deburr init`."""

import re
import tomllib
from pathlib import Path

import pytest

from deburr.config import ConfigError, RuleSets
from deburr.configfile import Configs, read
from deburr.formats.toml import line_of
from deburr_grammar.dialects import by_name

FAULTY = "G21 G90 G17\nG0 X[1/0]\nF100\nM2\n"
ZERO = "rs274.divide-by-zero"


def count(shell, *arguments):
    ran = shell.run("check", "--output-format", "concise", "-q", *arguments)
    assert ran.code in (0, 1), ran.err
    return len(ran.out.splitlines())


@pytest.mark.parametrize(
    ("text", "place", "message"),
    [
        ("x = ]", ":1:5", "Invalid value"),
        ("x = [", "", "Invalid value (at end of document)"),
        ("[check]\nignor = []", ":2", "unknown key `ignor` in [check]; did you mean `ignore`?"),
        ("chekc = 1", ":1", "unknown key `chekc`; did you mean `check`?"),
        ("[rs247]", ":1", "unknown key `rs247`; did you mean `rs274`?"),
        ("[rs274]\n\nprofil = 'smithy'", ":3", "unknown key `profil` in [rs274]; did you mean `profile`?"),
        (
            "[rs274]\nprofile = 'smity'",
            ":2",
            '`profile` must be "linuxcnc" or "smithy", not "smity"; did you mean `smithy`?',
        ),
        ("[rs274]\ncompare = 1e-4", ":2", '`compare` must be "1e-4" or "1e-6", not 0.0001'),
        ("[rs274]\naxes = 3", ":2", "`axes` must be a text, not a number"),
        ("[rs274]\nsubroutine-path = 'subs'", ":2", "`subroutine-path` must be a list of texts, not a text"),
        (
            "[rs274]\nsubroutine-path = [1]",
            ":2",
            "`subroutine-path` must be a list of texts, not a list with something else in it",
        ),
        ("[rs274]\nparameters = true", ":2", "`parameters` must be a text, not true or false"),
        ("rs274 = 3", ":1", "`rs274` must be a table, not a number"),
        ("check = []", ":1", "`check` must be a table, not a list"),
        ("check.run = 1", ":1", "`run` must be true or false, not 1"),
        ("[check]\nfail-on = 'fatal'", ":2", '`fail-on` must be "error", "warning" or "info", not "fatal"'),
        ("[check]\nselect = 'rs274'", ":2", "`select` must be a list of texts, not a text"),
        ("[check]\nselect = ['rs274.zero']", ":2", "`rs274.zero` is no rule"),
        (
            "[check]\nignore = ['ALL', 'comment-nested']",
            ":2",
            "`comment-nested` is no rule; did you mean `rs274.comment-nested`",
        ),
        ("[check.severity]\n'rs274' = 'info'", ":2", "`rs274` means several rules, and one is wanted"),
        (
            f"[check.severity]\n'{ZERO}' = 'fatal'",
            ":2",
            f'`{ZERO}` must be "error", "warning", "info" or "off", not "fatal"',
        ),
        ("[check.per-file-ignores]\n'a/**' = 'rs274'", ":2", "`a/**` must be a list of rules, not a text"),
        ("[check.per-file-ignores]\n'a/**' = ['rs27']", ":2", "`rs27` is no rule; did you mean `rs274`?"),
        ("[files]\n'*.x' = 'rs27'", ":2", '"rs27" is no dialect; did you mean `rs274`?'),
        ("[machine]\nlimits = { Q = [0, 1] }", ":2", "`Q` in `limits` is no axis; these can be: XYZABCUVW"),
        ("[machine.limits]\nX = [1, 0]", ":2", "`X` in `limits` must be the least and the greatest place, as [0, 300]"),
        ("[machine.limits]\nX = 300", ":2", "`X` in `limits` must be the least and the greatest place, as [0, 300]"),
        ("[machine]\nz-safe = 'x'", ":2", '`z-safe` must be a number, not "x"'),
        ("[machine]\nrapid = { X = 0 }", ":2", "`X` in `rapid` must be a number above 0"),
        ("[machine]\nlimit = {}", ":2", "unknown key `limit` in [machine]; did you mean `limits`?"),
        ("[rs274]\naxes = 'XQ'", ":2", "`axes` names `Q`, which is no axis; these can be: XYZABCUVW"),
        ("[rs274]\naxes = 'XYx'", ":2", "`axes` names `X` twice"),
        ("[z32]\naxes = 'XYZAE'", ":2", "`axes` names `E`, which is no axis; these can be: ABCDHPQUVWXYZ"),
        ("[z32]\naxes = 'ZZ'", ":2", "`axes` names `Z` twice"),
        (
            "[z32]\npal = { 300 = 5, 12 = 1 }",
            ":2",
            "`12` in `pal` is no index of the machine's parameters, PAL[256] to PAL[512]",
        ),
        ("[z32.pal]\n255 = 1", ":2", "`255` in `pal` is no index of the machine's parameters, PAL[256] to PAL[512]"),
        ("[z32.pal]\n256 = 1\n513 = 1", ":3", "`513` in `pal` is no index of the machine's parameters"),
        ("[z32.pal]\n'0300' = 1", ":2", "`0300` in `pal` is no index of the machine's parameters"),
        ("[z32.pal]\n'PAL[300]' = 1", ":2", "`PAL[300]` in `pal` is no index of the machine's parameters"),
        ("[z32.pal]\n300 = 5\n301 = '5'", ":3", "`301` in `pal` must be an integer, the only values that PAL holds"),
        ("[z32.pal]\n301 = 2.5", ":2", "`301` in `pal` must be an integer, the only values that PAL holds"),
        ("[z32.pal]\n301 = inf", ":2", "`301` in `pal` must be an integer, the only values that PAL holds"),
        ("[z32.pal]\n301 = true", ":2", "`301` in `pal` must be an integer, the only values that PAL holds"),
        ("[z32]\npal = 5", ":2", "`pal` must be a table, not a number"),
        ("[check]\nselect = ['']", ":2", "an empty text names no rule"),
        ("extend = 'deburr.toml'", ":1", "`extend` goes round in a circle"),
        ("extend = 3", ":1", "`extend` must be a text, not a number"),
    ],
)
def test_errors(shell, text, place, message):
    shell.write("deburr.toml", text)
    shell.write("a.ngc", FAULTY)
    ran = shell.run("check")
    assert (ran.code, ran.out) == (2, "")
    assert ran.err.startswith(f"deburr: error: {(shell.folder / 'deburr.toml').as_posix()}{place}: {message}"), ran.err
    assert shell.run("explain-dialect", "a.ngc").code == 2
    assert shell.run("config", "a.ngc").code == 2


def test_what_extends_a_file_that_is_not_there_is_named(shell):
    folder = shell.folder.as_posix()
    shell.write("a.ngc", FAULTY)
    shell.write("pyproject.toml", "[tool.deburr]\nextend = 'base.toml'\n")
    said = f"deburr: error: {folder}/pyproject.toml:2: `extend` names `{folder}/base.toml`: No such file or directory\n"
    assert shell.run("check") == (2, "", said)
    shell.write("base.toml", "[check]\nrun = true\n[files]\n")
    assert shell.run("check").code == 1
    shell.write("base.toml", "# further\nextend = '.'\n")
    said = f"deburr: error: {folder}/base.toml:2: `extend` names `{folder}`: Is a directory\n"
    assert shell.run("check") == (2, "", said)
    shell.write("base.toml", 'extend = "a\\u0000b"\n')
    ran = shell.run("check")
    assert ran.code == 2 and ran.err.startswith(f"deburr: error: {folder}/base.toml:1: `extend` names ")


def test_values_of_machine_parameters_reach_the_rules(tmp_path):
    path = tmp_path / "deburr.toml"
    path.write_text("[z32]\npal = { 256 = -1, 300 = 5.0, 512 = 0 }\n")
    file = (tmp_path / "a.z32").as_posix()
    settings = RuleSets().of(by_name("z32"), Configs().of(file), file).settings
    assert settings["pal"] == {"256": -1, "300": 5.0, "512": 0}


def test_all_errors_of_a_file_are_said(shell):
    shell.write("deburr.toml", "[check]\nignor = []\nfail-on = 1\n[rs274]\nprofile = 2\n")
    shell.write("a.ngc", FAULTY)
    assert [re.search(r"toml:([0-9]+):", line)[1] for line in shell.run("check").err.splitlines()] == ["2", "3", "5"]


def test_a_file_that_is_not_text(shell):
    shell.write("deburr.toml", b"a = '\xff'\n")
    shell.write("a.ngc", FAULTY)
    assert shell.run("check").err.endswith("not UTF-8, as TOML must be\n")


def test_the_nearest_file_wins(shell):
    off = f'ignore = ["{ZERO}"]\n'
    shell.write("a/b/x.ngc", FAULTY)
    shell.write("deburr.toml", f"[check]\n{off}")
    assert count(shell, "a/b/x.ngc") == 0
    shell.write("a/pyproject.toml", "[project]\nname = 'deburr'\n")
    assert count(shell, "a/b/x.ngc") == 0
    shell.write("a/pyproject.toml", "[tool.deburr]\n")
    assert count(shell, "a/b/x.ngc") == 1
    shell.write("a/pyproject.toml", f"[tool.deburr.check]\n{off}")
    assert count(shell, "a/b/x.ngc") == 0
    shell.write("a/deburr.toml", "")
    assert count(shell, "a/b/x.ngc") == 1
    assert count(shell, "a/b/x.ngc", "--config", "deburr.toml") == 0


def test_a_pyproject_of_others_is_passed_over(shell):
    shell.write("x.ngc", FAULTY)
    for text in ("deburr = [", "tool = 3\n# deburr", "[tool.other]\nname = 'deburr'"):
        shell.write("pyproject.toml", text)
        assert count(shell) == 1
    shell.write("pyproject.toml", "[tool]\ndeburr = 3\n")
    assert "`tool.deburr` must be a table" in shell.run("check").err


def test_extend(shell):
    shell.write("base.toml", f'extend = "deeper.toml"\n[check]\nignore = ["{ZERO}"]\nfail-on = "info"\n')
    shell.write("deeper.toml", '[rs274]\nprofile = "smithy"\nparameters = "p.var"\n')
    shell.write("sub/deburr.toml", 'extend = "../base.toml"\n[check]\nfail-on = "warning"\n')
    shell.write("sub/x.ngc", FAULTY)
    shell.write("p.var", "")
    assert count(shell) == 0
    config = read((shell.folder / "sub/deburr.toml").as_posix())
    assert config.values["check.fail-on"].value == "warning"
    assert config.values["rs274.profile"] == ("smithy", (shell.folder / "deeper.toml").as_posix())
    assert config.values["rs274.parameters"].value == (shell.folder / "p.var").as_posix()
    shell.write("sub/deburr.toml", f'extend = "../base.toml"\n[check]\nselect = ["{ZERO}"]\n')
    assert count(shell) == 1


@pytest.mark.parametrize(
    ("dialect", "setting", "program"),
    [
        ("metagcode", "snippets-dir", "G0 X1\n"),
        ("metagcode", "variables", "G0 X1\n"),
        ("rs274", "subroutine-path", "G0 X1\nM2\n"),
        ("rs274", "parameters", "G0 X1\nM2\n"),
        ("rs274", "tool-table", "G0 X1\nM2\n"),
        ("cgt", "input", "@START\nG90\n@\n@END\nM30\n@\n"),
        ("cgt", "machine", "@START\nG90\n@\n@END\nM30\n@\n"),
        ("z32", "cmos-dir", "G0 X1\nM30\n"),
        ("z32", "file-root", "G0 X1\nM30\n"),
    ],
)
def test_paths_that_do_not_exist_are_said_where_a_program_may_need_them(shell, dialect, setting, program):
    value = '["gone"]' if setting == "subroutine-path" else '"gone"'
    shell.write("deburr.toml", f"\n[{dialect}]\n{setting} = {value}\n")
    for name in ("a", "b"):
        shell.write(f"{name}{by_name(dialect).extensions[0]}", program)
    file = (shell.folder / "deburr.toml").as_posix()
    gone = (shell.folder / "gone").as_posix()
    said = f"deburr: error: {file}:3: `{setting}` names `{gone}`, which does not exist\n"
    assert shell.run("check") == (2, "", said)
    assert shell.run("check", "-j", "2") == (2, "", said)
    assert shell.run("expand", f"a{by_name(dialect).extensions[0]}") == (2, "", said)
    other = "x.ngc" if dialect != "rs274" else "x.z32"
    shell.write(other, "G0 X1\nM2\n")
    assert shell.run("check", other).code == 0
    shell.write("gone", "")
    assert "does not exist" not in shell.run("check").err


def test_severity(shell):
    shell.write("x.ngc", FAULTY)
    shell.write("deburr.toml", f'[check.severity]\n"{ZERO}" = "off"\n')
    assert count(shell) == 0
    assert count(shell, "--select", ZERO) == 1
    shell.write("child.toml", f'extend = "deburr.toml"\n[check.severity]\n"{ZERO}" = "info"\n')
    ran = shell.run("check", "--config", "child.toml", "--output-format", "concise")
    assert ran.code == 0 and f": info {ZERO} " in ran.out


def test_per_file_ignores(shell):
    for name in ("legacy/a.ngc", "legacy/deep/b.ngc", "new/c.ngc"):
        shell.write(name, FAULTY)
    shell.write("deburr.toml", f'[check.per-file-ignores]\n"legacy/**" = ["{ZERO}"]\n')
    assert count(shell) == 1 and count(shell, "legacy") == 0
    assert count(shell, "legacy", "--select", ZERO) == 0
    shell.write("deburr.toml", '[check.per-file-ignores]\n"!new/**" = ["rs274.divide"]\n"*.txt" = ["ALL"]\n')
    assert count(shell) == 1 and count(shell, "legacy") == 0


def test_files_name_a_dialect(shell):
    shell.write("posts/deep/a.post", FAULTY)
    shell.write("posts/b.txt", FAULTY)
    assert count(shell) == 0
    shell.write("deburr.toml", '[files]\n"posts/**/*.post" = "rs274"\n"posts/*.txt" = "rs274"\n')
    assert count(shell) == 2
    ran = shell.run("explain-dialect", "posts/b.txt")
    assert ran == (
        0,
        f"posts/b.txt: rs274 (`posts/*.txt` in [files] of {(shell.folder / 'deburr.toml').as_posix()})\n",
        "",
    )


def test_settings_reach_the_rules_and_paths_start_at_the_file(tmp_path):
    path = tmp_path / "deburr.toml"
    path.write_text(
        '[rs274]\nsubroutine-path = ["subs", "/abs"]\nparameters = "../p.var"\ntool-table = ""\ncompare = "1e-6"\n'
    )
    configs = Configs()
    file = (tmp_path / "sub/x.ngc").as_posix()
    settings = RuleSets().of(by_name("rs274"), configs.of(file), file).settings
    assert settings["subroutine-path"] == ((tmp_path / "subs").as_posix(), "/abs")
    assert settings["parameters"] == (tmp_path.parent / "p.var").as_posix()
    assert (settings["tool-table"], settings["compare"], settings["profile"]) == ("", "1e-6", "linuxcnc")


def test_rule_sets_are_shared_by_files_that_are_configured_alike(tmp_path):
    (tmp_path / "deburr.toml").write_text('[check.per-file-ignores]\n"a/**" = ["rs274"]\n')
    configs, rulesets = Configs(), RuleSets()
    a, b, c = (
        rulesets.of(by_name("rs274"), configs.of(file), file)
        for file in ((tmp_path / name).as_posix() for name in ("a/x.ngc", "b/x.ngc", "c/deep/x.ngc"))
    )
    assert b is c and a is not b and not a.rules


@pytest.mark.parametrize(
    ("text", "path", "line"),
    [
        ('a = 1\n[check]\n"x y" = 2\n[check.severity]\nq = 3', ("check", "severity", "q"), 5),
        ('a = 1\n[check]\n"x y" = 2\n', ("check", "x y"), 3),
        ("check.severity.q = 1", ("check", "severity", "q"), 1),
        ("[check]\nseverity = { q = 1 }", ("check", "severity", "q"), 2),
        ("[other]\nq = 1", ("check", "q"), None),
    ],
)
def test_line_of(text, path, line):
    assert line_of(text, path) == line


def test_config_command(shell):
    shell.write(
        "deburr.toml",
        f'[check]\nignore = ["{ZERO}"]\n[rs274]\nprofile = "smithy"\n[check.severity]\n"rs274.percent" = "off"\n[files]\n"*.a" = "rs274"\n',
    )
    shell.write("a.ngc", FAULTY)
    origin = (shell.folder / "deburr.toml").as_posix()
    ran = shell.run("config", "a.ngc")
    found = ran.out.splitlines()
    assert ran.code == 0 and found[0] == f"# {origin}"
    for line in (
        f'ignore = ["{ZERO}"]  # {origin}',
        f'profile = "smithy"  # {origin}',
        'fail-on = "error"  # default',
        f'"rs274.percent" = "off"  # {origin}',
        f'"*.a" = "rs274"  # {origin}',
    ):
        assert line in found
    tomllib.loads(ran.out)
    assert shell.run("config", ".").out == ran.out
    assert shell.run("config", "nothing.ngc").code == 2


def test_config_command_prints_what_it_can_read_back(shell):
    shell.write(
        "deburr.toml",
        '[z32]\npal = { 300 = 5, 301 = -2 }\n[files]\n\'a"b\' = "rs274"\n[rs274]\nparameters = "a\\\\b"\n',
    )
    read_back = tomllib.loads(shell.run("config", ".").out)
    assert read_back["z32"]["pal"] == {"300": 5, "301": -2}
    assert read_back["files"] == {'a"b': "rs274"}
    assert Path(read_back["rs274"]["parameters"]).name.endswith("b")


def test_init(shell):
    ran = shell.run("init")
    assert ran == (0, "wrote deburr.toml\n", "")
    text = (shell.folder / "deburr.toml").read_text()
    assert set(tomllib.loads(text)) >= {"files", "check", "z32", "rs274"}
    shell.write("a.ngc", FAULTY)
    assert count(shell) == 1
    assert shell.run("init") == (2, "", "deburr: error: deburr.toml is there already; it is left as it is\n")
    assert (shell.folder / "deburr.toml").read_text() == text


def test_init_says_what_the_defaults_are(shell):
    shell.run("init")
    path = shell.folder / "deburr.toml"
    uncommented = [line[2:] if re.match(r"# [a-z-]+ = ", line) else line for line in path.read_text().splitlines()]
    path.write_text("\n".join(line for line in uncommented if not line.startswith(("select =", "extend ="))))
    config = read(path.as_posix())
    for dialect in ("rs274",):
        for setting in by_name(dialect).settings:
            assert config.get(dialect, setting).value in (
                setting.default,
                (shell.folder / str(setting.default)).as_posix(),
            )


def test_init_names_what_lies_in_the_folder(shell):
    shell.write("a.ngc", "G21\nM2\n")
    shell.write("b.nc", "#<depth>=1\nM2\n")
    shell.write("c.nc", "G0 X1\nM30\n")
    shell.write("machine/emc.var", "5161\t0.0\n")
    shell.write("machine/emc.tbl", "T1 P1 D1\n")
    shell.write("subroutines/x.ngc", "o<x> sub\no<x> endsub\nM2\n")
    shell.write("part.vars", "Depth=1\n")
    assert shell.run("init") == (0, "wrote deburr.toml (3 rs274 programs found)\n", "")
    path = shell.folder / "deburr.toml"
    text = path.read_text()
    found = [line[2:].split("  #")[0] for line in text.splitlines() if "found here;" in line]
    assert found == [
        'subroutine-path = ["subroutines"]',
        'parameters = "machine/emc.var"',
        'tool-table = "machine/emc.tbl"',
    ]
    assert '# .nc files here: 1 without a sign of their language, skipped, 1 with one\n# "**/*.nc" = "rs274"' in text
    assert set(tomllib.loads(text)) & {"rs274", "z32", "cgt", "metagcode"} == {"rs274"}
    assert "# No programs were found here for [" in text
    before = shell.run("check", "-v").out
    for line in found:
        text = text.replace(f"# {line}  #", f"{line}  #")
    path.write_text(text.replace('# "**/*.nc"', '"**/*.nc"'))
    config = read(path.as_posix())
    assert config.get("rs274", next(s for s in by_name("rs274").settings if s.name == "parameters")).value.endswith(
        "emc.var"
    )
    assert (before, shell.run("check").out) == (
        "All checks passed (3 checked, 1 skipped: no dialect)\n",
        "All checks passed (4 checked)\n",
    )


def test_config_errors_are_values_of_their_own():
    assert ConfigError("a", "b").messages == ("a", "b")
