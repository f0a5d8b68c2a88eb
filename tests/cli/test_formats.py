"""What the reports look like, to the byte."""

import json
from hashlib import blake2b

from deburr.cli.reporters.full import report
from deburr.cli.result import Result
from deburr.cli.run import Outcome
from deburr.cli.style import Style
from deburr.finding import Finding, Place, Related, Severity

FILE = "/w/a.ngc"
TEXT = ["G21", "", "o1 if [1]", "\tG0 X[1/0] (\u4e2d)", "o1 else", "", "M2"]


def finding(message="no", line=3, start=5, end=8, related=()):
    return Finding("rs274.x-y", Severity.ERROR, message, Place(FILE, line, start, line, end), related)


def full(found, text=TEXT):
    class Out(list):
        write = list.append
        writelines = list.extend

    out = Out()
    texts = tuple(((FILE, number), line) for number, line in enumerate(text))
    report(Result((Outcome(FILE, "rs274", "", (found,), texts=texts),)), out, Style(False, "/w"))
    return "".join(out)


def test_full_shows_two_lines_around_but_no_blank_ones_at_the_edge():
    assert full(finding()) == (
        "error[rs274.x-y]: no\n"
        " --> a.ngc:4:6\n"
        "  |\n"
        "3 | o1 if [1]\n"
        "4 |     G0 X[1/0] (\u4e2d)\n"
        "  |         ^^^\n"
        "5 | o1 else\n"
        "  |\n\n"
    )


def test_full_shows_the_other_places():
    related = (Related(Place(FILE, 2, 0, 2, 5), "opened here"), Related(Place("/w/b.ngc", 11, 0, 11, 1), "and there"))
    assert full(finding(line=6, start=0, end=2, related=related)) == (
        "error[rs274.x-y]: no\n"
        "  --> a.ngc:7:1\n"
        "   |\n"
        " 5 | o1 else\n"
        " 6 |\n"
        " 7 | M2\n"
        "   | ^^\n"
        "   |\n"
        "  ::: a.ngc:3:1\n"
        "   |\n"
        " 3 | o1 if [1]\n"
        "   | ----- opened here\n"
        "   |\n"
        "  ::: b.ngc:12:1\n"
        "   |\n"
        "   |\n\n"
    )


def test_full_counts_cells_of_wide_characters():
    shown = full(finding(line=0, start=1, end=2), ["\u4e2d\u4e2dx"]).splitlines()
    assert shown[3:5] == ["1 | \u4e2d\u4e2dx", "  |   ^^"]


def test_full_marks_the_end_of_a_line_and_places_over_more_lines():
    assert "  |    ^\n" in full(finding(line=0, start=3, end=4), ["M30"])
    over = Finding("rs274.x-y", Severity.ERROR, "no", Place(FILE, 0, 1, 1, 1))
    assert full(over, ["M30", "M2"]).splitlines()[4] == "  |  ^^"


def test_full_cuts_endless_lines():
    shown = full(finding(line=0, start=500, end=503), ["x" * 1000]).splitlines()
    assert shown[3] == f"1 | ...{'x' * 160}..."
    assert shown[4] == f"  | {' ' * 43}^^^"


def test_full_never_obeys_the_program():
    shown = full(finding("`\x1b[2J`", line=0, start=0, end=1), ["\x1b[2J\u202e\x00"])
    assert "\x1b" not in shown and "\u202e" not in shown
    assert "\u241b[2J\ufffd\u2400" in shown


def test_concise(shell):
    shell.write("a.ngc", "G21 G90 G17\nG0 X1 (drill (first) hole)\nF100\nM2\n")
    assert shell.run("check", "--output-format", "concise").out == (
        "a.ngc:2:14: error rs274.comment-nested `(first)` stands inside a comment; the control refuses nested comments\n"
        "Found 1 error in 1 file (1 checked)\n"
    )


def test_json(shell):
    path = shell.write("a.ngc", "G21 G90 G17\n(\U0001f600) G0 X1 (drill (first) hole)\nF100\nM2\n")
    # The rule and the text of the line, blanks apart.
    said = b"rs274.comment-nested\0(\xf0\x9f\x98\x80) G0 X1 (drill (first) hole)"
    key = blake2b(said, digest_size=16).hexdigest()
    expected = {
        "filename": path.as_posix(),
        "dialect": "rs274",
        "rule": "rs274.comment-nested",
        "severity": "error",
        "message": "`(first)` stands inside a comment; the control refuses nested comments",
        "location": {"row": 2, "column": 18},
        "end_location": {"row": 2, "column": 25},
        "url": None,
        "related": [],
        "fingerprint": f"{key}:1",
        "fix": {
            "message": "Change to `[first]`",
            "applicability": "unsafe",
            "edits": [
                {"location": {"row": 2, "column": 18}, "end_location": {"row": 2, "column": 25}, "content": "[first]"}
            ],
        },
    }
    ran = shell.run("check", "--output-format", "json")
    assert ran.out == json.dumps([expected], indent=2, ensure_ascii=False) + "\n"
    assert shell.run("check", "--output-format", "json-lines").out == json.dumps(expected, separators=(",", ":")) + "\n"
    shell.write("a.ngc", "M2\n")
    assert shell.run("check", "--output-format", "json").out == "[]\n"
    assert shell.run("check", "--output-format", "json-lines").out == ""


def test_json_names_related_places(shell):
    shell.write("a.ngc", "G21 G90 G17\no1 if [1]\no2 while [1]\no1 endif\no2 endwhile\nF100\nM2\n")
    found = json.loads(shell.run("check", "--output-format", "json").out)
    related = [each for each_finding in found for each in each_finding["related"]]
    assert related and all(
        set(each) == {"filename", "location", "end_location", "message", "entered"} for each in related
    )


def test_json_is_sorted_by_file_row_and_column(shell):
    for name in ("b.ngc", "a.ngc", "sub/a.ngc"):
        shell.write(name, "G21 G90 G17\nG0 X[1/0] Y[1/0]\nG0 X[1/0]\nF100\nM2\n")
    found = json.loads(shell.run("check", "sub", "b.ngc", "a.ngc", "--output-format", "json").out)
    places = [(each["filename"], each["location"]["row"], each["location"]["column"]) for each in found]
    assert len(places) == 9 and places == sorted(places)


def test_a_finding_that_nothing_mends_has_no_fix(shell):
    shell.write("a.ngc", "G21 G90 G17\nG0 X[1/0]\nF100\nM2\n")
    assert [each["fix"] for each in json.loads(shell.run("check", "--output-format", "json").out)] == [None]
    assert "fix:" not in shell.run("check").out


def test_padding_moves_a_fix_as_it_moves_its_finding(shell):
    shell.write("a.z32", b"\0\0\0g0 X1\nM30\n")
    found = json.loads(shell.run("check", "--output-format", "json").out)
    (lower,) = [each for each in found if each["rule"] == "z32.lower-case"]
    place = {name: lower[name] for name in ("location", "end_location")}
    assert place["location"] == {"row": 1, "column": 4}
    assert lower["fix"]["edits"] == [{**place, "content": "G"}]
    assert lower["fix"]["applicability"] == "safe"


def test_people_are_told_of_fixes(shell):
    shell.write("a.z32", "(P)\ng0 X1\nG0 X1 (oops\nM30\n")
    full, concise = shell.run("check").out, shell.run("check", "--output-format", "concise").out
    assert "  = fix: Write the line in upper case (safe)\n" in full
    assert "  = fix: Insert `)` (not sure to be what is meant)\n" in full
    assert [line.split()[2:4] for line in concise.splitlines()[:2]] == [
        ["z32.lower-case", "[*]"],
        ["z32.comment-unclosed", "the"],
    ]
