"""The tables of codes: complete against the references, and every entry says something."""

import pytest

from deburr_grammar.codes import code_number
from deburr_grammar.dialects import NAMES, by_name

LISTED = {
    "rs274": {
        "code": "G0 G1 G2 G3 G4 G5 G5.1 G5.2 G5.3 G7 G8 G10 G17 G17.1 G18 G18.1 G19 G19.1 G20 G21 G28 G28.1 G30 G30.1 G33 G33.1 "
        "G38.2 G38.3 G38.4 G38.5 G40 G41 G41.1 G42 G42.1 G43 G43.1 G43.2 G49 G52 G53 G54 G55 G56 G57 G58 G59 G59.1 G59.2 G59.3 "
        "G61 G61.1 G64 G73 G74 G76 G80 G81 G82 G83 G84 G85 G86 G87 G88 G89 G90 G90.1 G91 G91.1 G92 G92.1 G92.2 G92.3 G93 G94 G95 "
        "G96 G97 G98 G99 M0 M1 M2 M3 M4 M5 M6 M7 M8 M9 M19 M30 M48 M49 M50 M51 M52 M53 M60 M61 M62 M63 M64 M65 M66 M67 M68 M70 "
        "M71 M72 M73 M98 M99 M100-M199",
        "function": "ABS ACOS ASIN ATAN COS EXISTS EXP FIX FUP LN ROUND SIN SQRT TAN",
        "operator": "** * / MOD + - EQ NE GT GE LT LE AND OR XOR",
        "keyword": "sub endsub call return if elseif else endif while endwhile do repeat endrepeat break continue",
        "variable": "_x _y _z _feed _metric _motion_mode _line _value _value_returned _vmajor _vminor _task _current_tool",
    },
    "metagcode": {
        "keyword": "#FILE #IF #ENDIF #LOOP #ENDLOOP",
        "operator": "greaterthan lessthan equalto notequalto",
    },
    "cgt": {
        "word": "XPOS YPOS ZPOS XST YST ZST XCTR YCTR ZCTR ARAD FEED DWELL SPEED TOOL NTOOL UNITS ON OFF DOFF BLK MOV ABSI DCOMP "
        "COOLNT CYCLE SPNDL ADIR BDIR DATE SYSTIME FILE",
        "command": "IF IFSTR IFCHG REPEAT CALL GOTO EXIT EXITC RESET UPDATE TABLE EVAL FMT ELSE AND OR EXC DEC INT STR TBL CALCDEC "
        "CALCINT CALCSTR RETNUM RETSTR EVMD EVMI EVMS GETBLK SETBLK ONBLK",
        "function": "ABS CEIL FLOOR INT MAX MIN MOD PI RND SGN SQR DMS SIN COS TAN ASIN ACOS ATAN STRLEN STRSUB TOTEL TLEN JOS JOS_STR",
        "format": "D F T L P Z E",
        "format_class": "F_BlockNumber F_Decimal F_Integer F_Offset",
    },
    "z32": {
        "function": "SN CS TAN AT ABS INT NEI RQ PI",
        "keyword": "IF EB CP PC GON GOP GOS L254 G26 G25",
    },
}


@pytest.mark.parametrize(
    ("dialect", "table", "name"),
    [
        (dialect, table, name)
        for dialect, tables in LISTED.items()
        if dialect in NAMES
        for table, names in tables.items()
        for name in names.split()
    ],
)
def test_what_the_reference_lists_is_there(dialect: str, table: str, name: str) -> None:
    codes = by_name(dialect).codes
    assert codes.entry(table, name) or codes.entry(table, name.removeprefix("#"))


@pytest.mark.parametrize("dialect", NAMES)
def test_every_entry_has_a_title_and_a_text(dialect: str) -> None:
    assert [entry.name for entry in by_name(dialect).codes if not (entry.title and entry.text)] == []


def test_families_are_found_by_number() -> None:
    codes = by_name("rs274").codes
    one, other = codes.family("variable", 5420), codes.family("variable", 100)
    assert one is not None and one.more["access"] == "read"
    assert other is not None and other.more["access"] == "read-write"
    assert codes.family("variable", 5602) is None


@pytest.mark.parametrize(
    ("written", "name"), [("g01", "G1"), ("G 38.20", "G38.2"), ("m 0 6", "M6"), ("G1.0", "G1"), ("G59.3", "G59.3")]
)
def test_codes_have_one_spelling(written: str, name: str) -> None:
    assert code_number(written) == name
