"""Programs with one fault of values each, as a practitioner makes it: the proof alone finds it, where no run comes to it; mended, they are clean."""

from dataclasses import replace
from pathlib import Path

import pytest

from deburr import source
from deburr.check import check
from deburr.finding import Finding, Severity
from deburr.ran import ran
from deburr.ruleset import RuleSet
from deburr_grammar.dialects import NAMES as DIALECTS
from deburr_grammar.dialects import by_name
from support.faults import Faulty, faults
from support.pages import Example, MemoryHost

FOLDER = Path(__file__).parent / "faults"
NAMES = sorted(path.stem for path in FOLDER.glob("*.txt"))
FAULTS = [
    pytest.param(name, fault, id=f"{name}-{fault.name.replace(' ', '-')}")
    for name in NAMES
    for fault in faults(name, FOLDER)
]


def found(example: Example, dialect: str, runs: bool = False) -> list[Finding]:
    """What a check says without a run, or with one."""
    language = by_name(dialect)
    program = source.read(example.program.encode())
    assert isinstance(program, source.Source)
    ruleset = RuleSet(language, example.settings)
    findings = check(program, language, ruleset, "", MemoryHost(example.files), ran if runs else None)
    return [finding for finding in findings if finding.severity > Severity.INFO]


@pytest.mark.parametrize(("dialect", "fault"), FAULTS)
def test_the_fault_alone_is_proven(dialect: str, fault: Faulty) -> None:
    findings = found(fault.example, dialect)
    places = [(f.rule, f.place.line, f.place.col, f.place.end_col) for f in findings]
    assert places == [(f"{dialect}.{fault.rule}", *place) for place in fault.example.places], findings
    for word in fault.says:
        assert word in findings[0].message, findings[0].message


@pytest.mark.parametrize("fault", [pytest.param(each, id=each.name) for each in faults("metagcode", FOLDER)])
def test_a_run_that_lacks_values_hides_nothing(fault: Faulty) -> None:
    """The variables of these templates have no values, so that a run ends at the first of them, in silence."""
    findings = found(fault.example, "metagcode", runs=True)
    assert [(f.rule, f.place.line) for f in findings] == [(f"metagcode.{fault.rule}", fault.example.places[0][0])]


@pytest.mark.parametrize(("dialect", "fault"), FAULTS)
def test_the_mended_program_is_clean(dialect: str, fault: Faulty) -> None:
    assert found(replace(fault.example, program=fault.mended), dialect, runs=True) == []


@pytest.mark.parametrize("dialect", DIALECTS)
def test_there_are_enough(dialect: str) -> None:
    names = [fault.name for fault in faults(dialect, FOLDER)]
    assert len(set(names)) == len(names) >= 12


def test_sixty_are_caught() -> None:
    """Each of them is proven above, at its place and in words that help: none is missed."""
    assert len(FAULTS) >= 60
