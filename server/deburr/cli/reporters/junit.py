"""JUnit XML: a suite for each program, in it a case for each finding, or one that passes.

What makes the check fail is a failure; other findings are cases that pass and say their message. Source: the form that Jenkins and GitLab read.
"""

import re
from collections import defaultdict
from typing import TYPE_CHECKING, TextIO

from deburr.cli.forge import inside, top
from deburr.cli.result import Found, Result
from deburr.cli.run import Outcome
from deburr.cli.style import Style, plain

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element

TEXT = False
_ILLEGAL = re.compile("[\0-\x08\x0b\x0c\x0e-\x1f\ud800-\udfff\ufffe\uffff]")
"""What an XML document cannot hold (XML 1.0, 2.2)."""


def report(result: Result, out: TextIO, style: Style) -> None:
    """Write the findings by file."""
    from xml.etree.ElementTree import Element, indent, tostring

    folder = top()
    found: dict[str, list[Found]] = defaultdict(list)
    for each in result.found:
        found[each.finding.place.file].append(each)
    outcomes = {outcome.file: outcome for outcome in result.outcomes if outcome.dialect or outcome.failure}
    suites = Element("testsuites", name="deburr")
    for file in sorted({*found, *outcomes}):
        suites.append(_suite(file, folder, found.get(file, []), outcomes.get(file)))
    for count in ("tests", "failures", "errors"):
        suites.set(count, str(sum(int(suite.get(count, 0)) for suite in suites)))
    indent(suites)
    out.write(f"<?xml version='1.0' encoding='utf-8'?>\n{tostring(suites, encoding='unicode')}\n")


def _suite(file: str, folder: str, found: list[Found], outcome: Outcome | None) -> "Element":
    from xml.etree.ElementTree import Element, SubElement

    name, failure = inside(file, folder), outcome.failure if outcome else ""
    counts = {"failures": sum(each.fails for each in found), "errors": int(bool(failure))}
    suite = Element("testsuite", name=_legal(name))
    for each in found:
        suite.append(_case(each, name, folder))
    if failure:
        case = SubElement(suite, "testcase", name="check", classname=_legal(name))
        SubElement(case, "error", type="unreadable", message=_legal(failure))
    elif not found:
        SubElement(suite, "testcase", name="check", classname=_legal(name))
    for count, value in {"tests": len(suite), **counts}.items():
        suite.set(count, str(value))
    return suite


def _case(found: Found, file: str, folder: str) -> "Element":
    from xml.etree.ElementTree import Element, SubElement

    finding, place = found.finding, found.finding.place
    case = Element("testcase", name=f"{finding.rule} at {place.line + 1}:{place.col + 1}", classname=_legal(file))
    case.set("file", _legal(file))
    case.set("line", str(place.line + 1))
    said = [f"{file}:{place.line + 1}:{place.col + 1}: {finding.severity.word}: {finding.message}"]
    said += [f"{inside(each.place.file, folder)}:{each.place.line + 1}: {each.message}" for each in finding.related]
    text = _legal("\n".join(map(plain, said)))
    if found.fails:
        SubElement(case, "failure", type=finding.rule, message=_legal(finding.message)).text = text
    else:
        SubElement(case, "system-out").text = text
    return case


def _legal(text: str) -> str:
    return _ILLEGAL.sub("\ufffd", text)
