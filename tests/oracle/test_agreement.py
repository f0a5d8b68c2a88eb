"""deburr and LinuxCNC's interpreter say the same of nearly every program, and the published table says how nearly."""

from pathlib import Path

import pytest
from benchmarks.agreement import LEAST, refused_share, report, run_share
from benchmarks.compare import Compared, Verdict, compared
from benchmarks.interpreter import Program, answer

from support.agreement import EXCLUDED, cases
from support.faults import faults

PAGE = Path(__file__).parents[2] / "docs" / "agreement.md"
MOST_EXCLUDED = 10

pytestmark = pytest.mark.oracle


@pytest.fixture(scope="module")
def results() -> list[Compared]:
    return compared(cases(), EXCLUDED)


def told(results: list[Compared], *verdicts: Verdict) -> list[str]:
    return [
        f"{result.case.kind} {result.case.name}: {result.said.message}; {result.findings}"
        for result in results
        if result.verdict in verdicts
    ]


def test_all_programs_are_compared(results: list[Compared]) -> None:
    assert sum(result.case.kind == "fact" for result in results) == 458
    assert sum(result.case.kind == "fault" for result in results) >= 200


@pytest.mark.parametrize("kinds", [("fact",), ("fault", "mended"), ("fact", "fault", "mended")])
def test_what_is_refused_is_found_there(results: list[Compared], kinds: tuple[str, ...]) -> None:
    of_kind = [result for result in results if result.case.kind in kinds]
    assert refused_share(of_kind) >= LEAST, told(of_kind, Verdict.ELSEWHERE, Verdict.SILENT)


@pytest.mark.parametrize("kinds", [("fact",), ("fault", "mended"), ("fact", "fault", "mended")])
def test_what_runs_has_no_error(results: list[Compared], kinds: tuple[str, ...]) -> None:
    of_kind = [result for result in results if result.case.kind in kinds]
    assert run_share(of_kind) >= LEAST, told(of_kind, Verdict.FALSE)


def test_few_programs_are_left_out_and_each_differs(results: list[Compared]) -> None:
    assert len(EXCLUDED) <= MOST_EXCLUDED
    names = [result.case.name for result in results if result.verdict is Verdict.EXCLUDED]
    assert sorted(names) == sorted(EXCLUDED)
    agreeing = [result.case.name for result in results if result.excluded and result.agrees]
    assert agreeing == []


def test_each_fault_is_refused_and_mended(results: list[Compared]) -> None:
    assert [each.case.name for each in results if each.case.kind == "fault" and each.said.ran] == []
    assert [each.case.name for each in results if each.case.kind == "mended" and not each.said.ran] == []


def test_faults_that_run_do() -> None:
    for fault in faults("rs274"):
        if fault.runs:
            program = Program("p.ngc", fault.example.program, tuple(fault.example.files.items()))
            assert answer(program).ran, fault.name


def test_the_published_page_is_fresh(results: list[Compared]) -> None:
    assert PAGE.read_text(encoding="utf-8") == report(results), (
        "python -m benchmarks.agreement --write docs/agreement.md"
    )
