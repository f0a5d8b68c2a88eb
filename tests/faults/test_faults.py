"""Programs with one fault: it alone is found, at its place, in words that tell how to mend it; and the mended program is clean."""

from dataclasses import replace

import pytest

from deburr_grammar.dialects import NAMES, by_name
from support.faults import FOLDER, Faulty, faults
from support.pages import checked

FAULTS = [
    pytest.param(name, fault, id=f"{name}-{fault.name.replace(' ', '-')}")
    for name in NAMES
    if (FOLDER / f"{name}.txt").exists()
    for fault in faults(name)
]


@pytest.mark.parametrize(("dialect", "fault"), FAULTS)
def test_the_fault_alone_is_found(dialect: str, fault: Faulty) -> None:
    findings = checked(fault.example, by_name(dialect))
    found = [(f.rule, f.place.line, f.place.col, f.place.end_col) for f in findings]
    assert found == [(f"{dialect}.{fault.rule}", *place) for place in fault.example.places], findings
    for word in fault.says:
        assert word in findings[0].message, findings[0].message


@pytest.mark.parametrize(("dialect", "fault"), FAULTS)
def test_the_mended_program_is_clean(dialect: str, fault: Faulty) -> None:
    assert checked(replace(fault.example, program=fault.mended), by_name(dialect)) == []


@pytest.mark.parametrize("dialect", NAMES)
def test_names_tell_faults_apart(dialect: str) -> None:
    if (FOLDER / f"{dialect}.txt").exists():
        names = [fault.name for fault in faults(dialect)]
        assert len(names) == len(set(names))
