"""CGT: what its reference says of every run, as properties (spec/cgt.md §5, §6, §11)."""

import re
from decimal import ROUND_HALF_UP, Decimal
from itertools import pairwise

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from deburr_grammar.text import split_lines
from support.cgt import expanded, flat, once, runs

coordinates = st.decimals(-999, 999, places=4).map(float)
near = st.sampled_from((0.0, 1.0, 1.00001, 1.00004, 1.00006, 2.0, -1.0, -0.00001, 0.00004, 0.00005))
TYPES = "DFTLPZE"
plain = st.text(st.sampled_from("GXYZ0123456789 .,-+()[]%=#*:;\t"), max_size=12).filter(
    lambda line: not re.search("#[A-Za-z]", line)
)


@given(st.lists(plain, max_size=8))
def test_a_template_of_text_outputs_its_lines_that_are_not_empty(lines: list[str]) -> None:
    assert once("\n".join(lines)) == [line for line in lines if line]


@given(st.lists(st.tuples(plain, st.booleans()), max_size=8))
def test_comments_output_nothing(lines: list[tuple[str, bool]]) -> None:
    texts = [f"{line}{'//c' if said else ''}" for line, said in lines]
    # Blanks before a comment are its own where nothing else stands on the line.
    assert once("\n".join(texts)) == [line for line, said in lines if (line.strip(" \t") if said else line)]


@given(st.lists(near, min_size=1, max_size=12))
def test_a_bracket_prints_if_and_only_if_its_text_changed(values: list[float]) -> None:
    texts = [printed(value, "D", 4, 4) for value in values]
    wanted = [texts[:1], *([new] if new != old else [] for old, new in pairwise(texts))]
    assert runs("<#XPOS>", [{"XPOS": value} for value in values]) == wanted


@given(
    st.lists(st.tuples(near, near, near), min_size=1, max_size=8),
    st.lists(st.sampled_from(("", "#OR", "#AND")), min_size=2, max_size=2),
)
def test_tests_are_joined_from_left_to_right(values: list[tuple[float, float, float]], signs: list[str]) -> None:
    said = f"<#XPOS{signs[0]}#YPOS{signs[1]}#ZPOS>"
    last: tuple[str, ...] | None = None
    wanted = []
    for each in values:
        texts = tuple(printed(value, "D", 4, 4) for value in each)
        x, y, z = (last is None or old != new for old, new in zip(last or texts, texts))
        both = [sign == "#AND" for sign in (signs[0], signs[1] or signs[0])]
        result = x and y if both[0] else x or y
        result = result and z if both[1] else result or z
        last = texts if result else last
        wanted.append(["".join(texts)] if result else [])
    assert runs(said, [dict(zip(("XPOS", "YPOS", "ZPOS"), each)) for each in values]) == wanted


@given(st.lists(st.sampled_from(("set", "#RESET(#XPOS)", "#UPDATE(#XPOS)", "(#XPOS)")), max_size=12))
@example(["set", "#UPDATE(#XPOS)", "#RESET(#XPOS)"])
def test_reset_marks_a_word_changed_and_update_marks_it_output(actions: list[str]) -> None:
    """`#IFCHG` asks without changing anything."""
    lines, changed, value, wanted = [], True, 1, []
    for action in actions:
        if action == "set":
            value += 1
            changed = True
        else:
            changed = action == "#RESET(#XPOS)"
        lines += [f"#EVAL(#XPOS={value})" if action == "set" else action, "#IFCHG(#XPOS)<Y>#ELSE<N>"]
        wanted += [f"({value}.0)"] if action == "(#XPOS)" else []
        wanted.append("Y" if changed else "N")
    assert once("\n".join(["#EVAL(#XPOS=1)", *lines])) == wanted


@given(st.sampled_from(TYPES), st.integers(1, 5), st.integers(0, 5), st.decimals(-99999, 99999, places=6))
@example("T", 4, 0, Decimal("0.5"))
@example("D", 3, 0, Decimal("-0.4"))
def test_formats_print_the_rounded_number(type: str, before: int, behind: int, value: Decimal) -> None:
    number = float(value)
    found = expanded(
        f"@START\n#FMT(#XPOS,{type}{before}.{behind})\n#XPOS\n@",
        events=[{"set": {"XPOS": number}}, {"section": "START"}],
    )
    nearest = rounded(number, behind)
    if abs(nearest) >= 10**before:
        assert [fault.kind for fault in found.faults] == ["format-overflow"] and not found.lines
        return
    (text,) = found.lines
    assert text == printed(number, type, before, behind)
    assert ("-" in text) == (nearest < 0)
    if type in "DPZE":
        assert Decimal(text) == nearest
    elif type != "L":
        assert Decimal(text).scaleb(-behind) == nearest


@given(coordinates, st.integers(0, 14))
def test_a_width_puts_blanks_in_front(value: float, width: int) -> None:
    lines = f"#FMT(#V1,D4.4)\n#V1\n#FMT(#V1,D4.4,{width})\n#V1"
    narrow, wide = once(lines, define={"V1": f"{value:.4f}"})
    assert wide == narrow.rjust(width)


@given(st.lists(st.integers(0, 6), min_size=1, max_size=3))
def test_repeats_multiply(counts: list[int]) -> None:
    body = "A#EVAL(#V1=#V1+1)"
    for count in counts:
        body = f"#REPEAT({count})<{body}>"
    passes = 1
    for count in counts:
        passes *= count
    assert once(f"{body}\n#V1") == [*(["A" * passes] if passes else []), str(passes)]


@given(
    st.integers(0, 30),
    st.sampled_from(("#REPEAT(#V1)<\n#V2\n#EVAL(#V2=#V2+1)\n>", "#REPEAT(#V1)\n<\n#V2\n#EVAL(#V2=#V2+1)\n>")),
)
def test_the_count_is_read_once_and_passes_are_frames(count: int, lines: str) -> None:
    found = expanded(f"@START\n{lines}\n@", events=[], define={"V1": str(count)})
    assert found.lines == [str(number) for number in range(count)]
    assert [next(found.source_map.stack(line)).number for line in range(count)] == list(range(1, count + 1))


@given(
    st.lists(
        st.tuples(
            st.integers(-3, 3),
            st.sampled_from(("=", "<>", ">", ">=", "<", "<=")),
            st.integers(-3, 3),
            st.sampled_from(("#AND", "#OR")),
        ),
        min_size=1,
        max_size=5,
    )
)
def test_if_joins_its_tests_from_left_to_right(tests: list[tuple[int, str, int, str]]) -> None:
    said, wanted = "", False
    holds = {"=": int.__eq__, "<>": int.__ne__, ">": int.__gt__, ">=": int.__ge__, "<": int.__lt__, "<=": int.__le__}
    for number, (a, sign, b, logic) in enumerate(tests):
        result = holds[sign](a, b)
        said += f",{logic} " if number else ""
        said += f"{a}{sign}{b}"
        wanted = result if not number else wanted and result if logic == "#AND" else wanted or result
    assert once(f"#IF({said})<yes>#ELSE<no>") == ["yes" if wanted else "no"]


lines_of_code = st.lists(
    st.sampled_from(("G1 X#V1", "<Y#V1>", "#EVAL(#V1=#V1+1)", "#IF(#V1>2)<Z>", "", "#REPEAT(2)<A>", " ")), max_size=6
)


@given(lines_of_code, lines_of_code, lines_of_code)
def test_a_call_runs_the_section_in_its_place(before: list[str], inside: list[str], behind: list[str]) -> None:
    written = "\n".join([*before, *inside, *behind])
    called = "\n".join([*before, "#CALL(a)", *behind])
    assert flat(f"@START\n{called}\n@\n@a\n" + "\n".join(inside), events=[]) == once(written)


@given(lines_of_code, st.integers(0, 500), st.integers(1, 20))
def test_block_numbers_only_stand_in_front(lines: list[str], start: int, step: int) -> None:
    text = "\n".join(lines)
    numbered = once(f"#ONBLK\n{text}", machine=f"block-start = {start}\nblock-step = {step}")
    unnumbered = once(text)
    assert numbered == [f"N{start + step * at} {line}" for at, line in enumerate(unnumbered)]


@given(st.lists(st.booleans(), min_size=1, max_size=10), st.integers(0, 9))
def test_a_block_number_is_the_same_before_and_behind_its_block(asks: list[bool], marked: int) -> None:
    """Lines that wait for a number keep their order."""
    lines = [
        f"{'GOTO #GETBLK(1)' if ask else 'A'}{'#SETBLK(1)' if at == marked % len(asks) else ''}"
        for at, ask in enumerate(asks)
    ]
    number = 10 * (marked % len(asks) + 1)
    wanted = [f"N{10 * at} {f'GOTO {number}' if ask else 'A'}" for at, ask in enumerate(asks, 1)]
    assert once("\n".join(["#ONBLK", *lines])) == wanted


points = st.lists(st.tuples(*[st.decimals(-99, 99, places=3)] * 3), min_size=1, max_size=10)
MOVES = "@START\n%\n@\n@RAP\nG0 #XST #YST #ZST #XPOS #YPOS #ZPOS\n@\n@LINE\nG1 #XST #YST #ZST #XPOS #YPOS #ZPOS\n@\n@END\nM30\n@"


@given(points, st.lists(st.booleans(), min_size=10, max_size=10))
def test_each_point_starts_where_the_last_one_ended(found: list[tuple[Decimal, ...]], rapid: list[bool]) -> None:
    text = "".join(f"{'RAPID' if fast else 'PPRINT/X'}\nGOTO/{x},{y},{z}\n" for (x, y, z), fast in zip(found, rapid))
    lines = flat(MOVES, text)
    assert (lines[0], lines[-1]) == ("%", "M30")
    ends = [(Decimal(0),) * 3, *found]
    wanted = [(*start, *end) for start, end in pairwise(ends)]
    assert [tuple(map(Decimal, line.split()[1:])) for line in lines[1:-1]] == wanted
    assert [line[:2] for line in lines[1:-1]] == ["G0" if fast else "G1" for _, fast in zip(found, rapid)]


@given(points)
def test_events_and_statements_give_the_same(found: list[tuple[Decimal, ...]]) -> None:
    text = "".join(f"GOTO/{x},{y},{z}\n" for x, y, z in found)
    names = ("XPOS", "YPOS", "ZPOS")
    events = [{"section": "LINE", "set": {"MOV": 1, **dict(zip(names, map(float, point)))}} for point in found]
    template = "@LINE\n<#MOV>< X#XPOS>< Y#YPOS>< Z#ZPOS>\n@\n@END\nM30\n@"
    assert flat(template, text) == flat(template, events=events)


@given(points, st.data())
def test_how_statements_are_written_does_not_matter(found: list[tuple[Decimal, ...]], data: st.DataObject) -> None:
    blank = st.sampled_from(("", " ", "\t"))
    text = ""
    for point in found:
        word = data.draw(st.sampled_from(("GOTO", "goto", "Goto")))
        x, y, z = (f"{data.draw(blank)}{value}{data.draw(blank)}" for value in point)
        breaks = data.draw(st.sampled_from(("", "$\n", " $$ said\n")))
        text += f"{word}{data.draw(blank)}/{x},{y},{'$' + chr(10) if breaks == '$' + chr(10) else ''}{z}{' $$ said' if 'said' in breaks else ''}\n"
    assert flat(MOVES, text) == flat(MOVES, "".join(f"GOTO/{x},{y},{z}\n" for x, y, z in found))


@given(points)
def test_the_map_is_total_and_follows_the_toolpath(found: list[tuple[Decimal, ...]]) -> None:
    expansion = expanded(MOVES, "".join(f"GOTO/{x},{y},{z}\n" for x, y, z in found))
    stacks = [list(expansion.source_map.stack(line)) for line in range(len(expansion.lines))]
    assert all(stack[-1].file == "part.cl" and stack[-1].kind == "section" for stack in stacks)
    assert [stack[-1].row for stack in stacks[1:]] == [*range(len(found)), max(len(found) - 1, 0)]
    assert all(expansion.source_map.origin(line).file == "main.cgt" for line in range(len(expansion.lines)))


@pytest.mark.parametrize("ending", ["\n", "\r\n", "\r"])
def test_line_ends_do_not_matter(ending: str) -> None:
    text = MOVES.replace("\n", ending)
    assert len(split_lines(text)) == len(split_lines(MOVES))
    assert flat(text, f"GOTO/1,2,3{ending}FINI") == flat(MOVES, "GOTO/1,2,3\nFINI")


def rounded(value: float, behind: int) -> Decimal:
    """The shortest text of a number, rounded half away from 0."""
    return Decimal(repr(value)).quantize(Decimal(1).scaleb(-behind), ROUND_HALF_UP)


def printed(value: float, type: str, before: int, behind: int) -> str:
    """What a format without sign prints, from the words of its definition (spec/cgt.md §5.1)."""
    nearest = rounded(value, behind)
    whole, _, fraction = f"{abs(nearest):f}".partition(".")
    sign = "-" if nearest < 0 else ""
    filled, bare = whole.zfill(before), whole.lstrip("0")
    short = fraction.rstrip("0")
    match type:
        case "D":
            return f"{sign}{whole}.{short or ('0' if behind else '')}"
        case "F":
            return f"{sign}{filled}{fraction}"
        case "T":
            return sign + ((bare + fraction).lstrip("0") or "0")
        case "L":
            return sign + ((filled + fraction).rstrip("0") or "0")
        case "P":
            return f"{sign}{bare if behind or bare else '0'}.{fraction}"
        case "Z":
            return f"{sign}{bare}.{short}" if nearest else "0"
        case _:
            return f"{sign}{filled}.{fraction}"
