"""MetaGCODE: what its reference says of every run, as properties (spec/metagcode.md §5)."""

import re
from decimal import ROUND_HALF_UP, Context, Decimal
from fractions import Fraction
from math import ceil

import pytest
from hypothesis import given
from hypothesis import strategies as st

from deburr.analysis import Analysis
from deburr.expand import Budget
from deburr.fault import Fault
from deburr.finding import Severity
from deburr_grammar.document import Document
from deburr_grammar.text import split_lines
from support.metagcode import DIALECT, RULES, expanded, flat
from support.pages import MemoryHost


def values(total: Decimal, step: Decimal, kind: str, decimals: int = 4) -> list[str]:
    """What a loop prints."""
    text = f"#LOOP1 |v| {step:f} {kind}\n|v|\n#ENDLOOP1"
    return flat(text, define={"v": f"{total:f}"}, decimals=decimals)


def rounded(value: Fraction, decimals: int) -> Fraction:
    """The nearest number with so many decimals, halves away from 0."""
    scaled = abs(value) * 10**decimals
    nearest = Fraction(int(scaled + Fraction(1, 2)), 10**decimals)
    return nearest if value >= 0 else -nearest


totals = st.decimals(-50, 50, places=4)
steps = st.decimals(-60, 60, places=3).filter(lambda step: abs(step) >= Decimal("0.5"))
places = st.integers(0, 6)
plain_lines = st.lists(
    st.text(st.characters(blacklist_characters="|\r\n", blacklist_categories=("Cs",)), max_size=12).filter(
        lambda line: not re.match(r"[ \t]*#[A-Za-z]", line)
    ),
    max_size=8,
)
ENDINGS = ("\n", "\r\n", "\r")


@given(plain_lines, st.sampled_from(ENDINGS), st.booleans())
def test_a_text_without_meta_constructs_is_itself(lines: list[str], ending: str, ended: bool) -> None:
    text = ending.join(lines) + (ending if ended else "")
    wanted = split_lines(text)
    assert flat(text) == (wanted if wanted[-1] else wanted[:-1])


@given(totals, steps, st.sampled_from("cr"), places)
def test_passes_are_the_quotient_of_magnitudes_raised_to_the_next_integer(
    total: Decimal, step: Decimal, kind: str, decimals: int
) -> None:
    assert len(values(total, step, kind, decimals)) == ceil(abs(Fraction(total)) / abs(Fraction(step)))


@given(totals, steps, places)
def test_cumulative_values_are_equal_parts_of_the_total(total: Decimal, step: Decimal, decimals: int) -> None:
    printed = values(total, step, "c", decimals)
    count = len(printed)
    exact = [Fraction(total) * number / count for number in range(1, count + 1)]
    assert [Fraction(text) for text in printed] == [rounded(value, decimals) for value in exact]


@given(totals, steps, places)
def test_relative_values_add_up_to_the_printed_total(total: Decimal, step: Decimal, decimals: int) -> None:
    relative, cumulative = values(total, step, "r", decimals), values(total, step, "c", decimals)
    sums = [sum(map(Fraction, relative[: number + 1])) for number in range(len(relative))]
    assert sums == [Fraction(text) for text in cumulative]
    unit = Fraction(1, 10**decimals)
    assert all(abs(Fraction(text)) <= abs(Fraction(step)) + unit for text in relative)


@given(st.decimals(-(10**12), 10**12, places=7), steps, st.sampled_from("cr"), places)
def test_printed_values_are_plain_decimal_numbers(total: Decimal, step: Decimal, kind: str, decimals: int) -> None:
    step *= max(1, ceil(abs(total)))
    for text in values(total, step, kind, decimals):
        assert re.fullmatch(rf"-?(?:0|[1-9][0-9]*)(?:\.[0-9]{{0,{max(decimals - 1, 0)}}}[1-9])?", text)
        assert text != "-0"


@given(st.lists(st.tuples(totals, steps), min_size=2, max_size=4))
def test_of_several_variables_the_one_with_most_passes_decides(pairs: list[tuple[Decimal, Decimal]]) -> None:
    header = " ".join(f"|v{at}| {step:f} c" for at, (_, step) in enumerate(pairs))
    define = {f"v{at}": f"{total:f}" for at, (total, _) in enumerate(pairs)}
    lines = flat(f"#LOOP1 {header}\n{'/'.join(f'|{name}|' for name in define)}\n#ENDLOOP1", define=define)
    assert len(lines) == max(ceil(abs(Fraction(total)) / abs(Fraction(step))) for total, step in pairs)
    if lines:
        assert [Fraction(text) for text in lines[-1].split("/")] == [rounded(Fraction(total), 4) for total, _ in pairs]


BODIES = (
    "G1 X|v|",
    "#IF1 |v| greaterthan 2.5 n\nG1 F|v|\n#ENDIF1",
    "#LOOP2 |w| |v| c\nW|w| V|v|\n#ENDLOOP2",
    "#LOOP2 |v| 1 r\n(|v|)\n#ENDLOOP2\n|v|",
    "#IF1 |v| equalto 5 a\nM1\n#ENDIF1",
    "#FILE s.txt",
)


@given(
    st.decimals("0.5", 20, places=2), st.decimals("0.5", 9, places=1), st.sampled_from("cr"), st.sampled_from(BODIES)
)
def test_a_loop_is_its_body_once_for_each_printed_value(total: Decimal, step: Decimal, kind: str, body: str) -> None:
    files = {"s.txt": "S|v|\nG0"}
    looped = f"#LOOP1 |v| {step} {kind}\n{body}\n#ENDLOOP1\n(of |v|)"
    each = [
        line for value in values(total, step, kind) for line in flat(body, files=files, define={"v": value, "w": "7"})
    ]
    # Behind the loop its variable is what it was.
    assert flat(looped, files=files, define={"v": f"{total}", "w": "7"}) == [*each, f"(of {total})"]


@given(totals, totals, st.sampled_from(("greaterthan", "lessthan", "equalto", "notequalto")), st.sampled_from("nN"))
def test_numbers_are_compared_exactly(left: Decimal, right: Decimal, operator: str, kind: str) -> None:
    holds = {
        "greaterthan": Fraction(left) > Fraction(right),
        "lessthan": Fraction(left) < Fraction(right),
        "equalto": Fraction(left) == Fraction(right),
        "notequalto": Fraction(left) != Fraction(right),
    }[operator]
    text = f"#IF1 |a| {operator.upper()} {right:f} {kind}umeric\nM8\n#ENDIF1"
    assert flat(text, define={"a": f" {left:f}\t"}) == (["M8"] if holds else [])


@given(st.lists(st.booleans(), min_size=1, max_size=6))
def test_nested_conditions_are_and_and_conditions_in_a_row_are_or(holding: list[bool]) -> None:
    heads = [f"#IF{at} {'a' if holds else 'b'} equalto a alpha" for at, holds in enumerate(holding)]
    ends = [f"#ENDIF{at}" for at in range(len(holding))]
    nested = "\n".join([*heads, "M8", *ends[::-1]])
    row = "\n".join(f"{head}\nM8\n{end}" for head, end in zip(heads, ends, strict=True))
    assert flat(nested) == (["M8"] if all(holding) else [])
    assert flat(row) == ["M8"] * sum(holding)


PIECES = ("G0 X|v|", "", "#LOOP1 |v| 2 c", "#ENDLOOP1", "#IF1 |v| lessthan 3 n", "#ENDIF1", "M9 ")


@given(st.lists(st.sampled_from(PIECES), max_size=10), st.integers(0, 10), st.integers(0, 10), st.sampled_from(ENDINGS))
def test_where_a_text_is_cut_into_steps_and_snippets_changes_nothing(
    lines: list[str], one: int, two: int, ending: str
) -> None:
    first, last = sorted((min(one, len(lines)), min(two, len(lines))))
    whole = expanded("\n".join((*lines, "")), define={"v": "5"})
    joined = expanded(
        "".join(line + ending for line in (*lines[:first], "#FILE a.txt", *lines[last:])),
        files={"a.txt": "\ufeff" + ending.join((*lines[first:last], ""))},
        define={"v": "5"},
    )
    stepped = expanded(
        *("".join(line + ending for line in part) for part in (lines[:first], lines[first:])), define={"v": "5"}
    )
    assert whole.lines == joined.lines == stepped.lines
    kinds = [
        sorted(fault.kind for fault in each.faults if fault.kind != "block-crosses-file")
        for each in (whole, joined, stepped)
    ]
    assert kinds[0] == kinds[1] == kinds[2]


@given(st.lists(st.sampled_from(PIECES), max_size=10), st.integers(0, 10))
def test_the_map_leads_each_line_to_the_line_that_made_it(lines: list[str], cut: int) -> None:
    files = {"a.txt": "\n".join((*lines[cut:], ""))}
    texts = {"0.mgc": [*lines[:cut], "#FILE a.txt"], "Snippets/a.txt": lines[cut:]}
    expansion = expanded("\n".join(texts["0.mgc"]), files=files, define={"v": "5"})
    for number, line in enumerate(expansion.lines):
        origin = expansion.source_map.origin(number)
        pattern = re.escape(texts[origin.file][origin.row]).replace(re.escape("|v|"), "[0-9.]+")
        assert re.fullmatch(pattern, line)
        for entry in expansion.source_map.stack(number):
            head = texts[entry.file][entry.row]
            assert head.startswith("#LOOP1" if entry.kind == "loop" else "#FILE") and entry.number >= (
                entry.kind == "loop"
            )


@given(st.text(st.characters(blacklist_characters="|\r\n", blacklist_categories=("Cs",))))
def test_values_are_filled_in_exactly_as_given(value: str) -> None:
    assert flat("(|a|) | a ||a|\n", define={"a": value}) == [f"({value}) {value}{value}"]


LONG = "9" * 6_000


@pytest.mark.parametrize("value", [LONG, f"-0.{LONG}", f"{LONG}.{LONG}"])
def test_numbers_of_any_length_are_exact(value: str) -> None:
    exact = Decimal(value)
    with_four = exact.quantize(Decimal("0.0001"), ROUND_HALF_UP, Context(prec=20_000))
    text = f"{with_four:f}".rstrip("0").rstrip(".") if "." in f"{with_four:f}" else f"{with_four:f}"
    assert flat(f"#LOOP1 |v| {LONG}0 c\n|v|\n#ENDLOOP1", define={"v": value}) == [text]
    fault = expanded("#LOOP1 |v| .001 c\n|v|\n#ENDLOOP1", define={"v": LONG}).faults[-1]
    assert fault.kind == "limit" and len(fault.message) < 300


GARBAGE = st.lists(
    st.sampled_from(
        [
            "#IF1 ",
            "#ENDIF1",
            "#LOOP1 ",
            "#ENDLOOP",
            "#LOOP2 |v| 2 c",
            "#ENDLOOP2",
            "#FILE ",
            "a.txt",
            "|v|",
            "|",
            "equalto",
            " n",
            " 1 ",
            "\n",
            "\r\n",
            "\f",
            "#X",
            "(",
            "😋",
            "0 ",
            "c ",
        ]
    ),
    max_size=25,
).map("".join)


@given(GARBAGE, GARBAGE, st.sampled_from(["0", "5", "x", "", "1e9", "1|2", "-3"]))
def test_faulty_programs_never_raise_and_name_rules_that_exist(program: str, snippet: str, value: str) -> None:
    expansion = expanded(program, files={"a.txt": snippet}, define={"v": value}, budget=Budget(5_000, 5_000))
    for fault in expansion.faults:
        assert isinstance(fault, Fault) and RULES.named(fault.kind) is not None, fault
        assert fault.span.start <= fault.span.end


OF_VALUES = {"limit", "loop-zero", "alpha-case", "alpha-number", "undefined-variable"}


@given(GARBAGE, GARBAGE)
def test_a_run_refuses_what_check_refuses_and_nothing_of_the_program_besides(program: str, snippet: str) -> None:
    host = MemoryHost({"Snippets/a.txt": snippet})
    document = Document.parse(program, DIALECT)
    findings = Analysis(document, RULES, "0.mgc", host).findings()
    refused = [finding for finding in findings if finding.severity is Severity.ERROR]
    faults = expanded(program, files={"a.txt": snippet}, define={"v": "5"}, budget=Budget(2_000, 2_000)).faults
    met = [fault for fault in faults if fault.kind not in OF_VALUES]
    assert met or not refused, refused
    assert refused or all(fault.file != "0.mgc" for fault in met), met
