"""How lines are laid out in each dialect, and what is left as it is: expected texts are worked out from the references."""

import re

import pytest

from deburr.formatting.style import Style
from deburr_grammar.dialects import NAMES, by_name
from support.formatting import PLAIN, laid_out

CANONICAL = Style("  ", canonical=True)


def check(name: str, old: str, new: str, style: Style = PLAIN) -> None:
    assert laid_out(old, name, style) == new
    assert laid_out(new, name, style) == new


@pytest.mark.parametrize(
    ("old", "new"),
    [
        # Words: a blank between them, none inside.
        ("g0x1y2.5 z -3\t f 100  ", "g0 x1 y2.5 z-3 f100"),
        ("N10G1X[#1]Y#2", "N10 G1 X[#1] Y#2"),
        ("/ N10G0", "/N10 G0"),
        ("#1=5", "#1 = 5"),
        ("#<a>  =  #2", "#<a>  =  #2"),
        # Expressions: operators that are words are set apart, signs as the author does, on both sides alike.
        ("#1 = [ #2+3 ]", "#1 = [#2+3]"),
        ("#1 = [#2 +3*4]", "#1 = [#2 + 3*4]"),
        ("#1 = [1+2 +3]", "#1 = [1 + 2 + 3]"),
        ("#1 = [1-  - 2]", "#1 = [1 - -2]"),
        ("#1 = [2* *3]", "#1 = [2* *3]"),
        ("#1 = [[#2GT3]AND[#4mod 5 EQ 0]]", "#1 = [[#2 GT 3] AND [#4 mod 5 EQ 0]]"),
        ("#1 = ATAN [1] /[2]", "#1 = ATAN[1] / [2]"),
        ("#1 = SIN [ 30 ]", "#1 = SIN[30]"),
        # O-words.
        ("o 100  call[1][2]", "o100 call [1] [2]"),
        ("o<my sub>call", "o<my sub> call"),
        # Comments keep their text and, if more than a blank parts them from the code, their column.
        ("G0X1(a  (b", "G0X1(a  (b"),
        ("g0x1( drill  it )  (MSG,a  b)  ", "g0 x1 ( drill  it ) (MSG,a  b)"),
        ("g0x1      (a)", "g0 x1     (a)"),
        ("g0x1  ;a  ", "g0 x1 ;a"),
        ("g0 x1\t(a)  ", "g0 x1\t(a)"),
        ("(PRINT,#<a>  #1)", "(PRINT,#<a>  #1)"),
        # Inside of numbers, names and words nothing is touched: such blanks have rules of their own.
        ("G 1 X1 2 #< a b >=1", "G1 X1 2 #< a b > = 1"),
        ("o1 e n d i f", "o1 e n d i f"),
        # Faulty lines stay as they are.
        ("G0X1 & Y2  ", "G0X1 & Y2  "),
        ("o1 foo  [1]", "o1 foo  [1]"),
        ("  \t", ""),
        ("", ""),
        ("G0X1 \f", "G0 X1 \f"),
    ],
)
def test_rs274_lines(old: str, new: str) -> None:
    check("rs274", old, new)


def test_rs274_blocks() -> None:
    old = """\
  %
o<part> sub
(drill)
      #1=2
o1 if [#1 EQ 2]
o2 while [#1 LT 5]
#1 = [#1+1]
o2 endwhile
o1 elseif [1]
o1 else
    o3 do
G0 X1
o3 while [0]
o1 endif
o4 repeat [2]

o<part> return
  o4 endrepeat
o<part> endsub
o<part> call
%
  behind  the  end
"""
    new = """\
%
o<part> sub
  (drill)
  #1 = 2
  o1 if [#1 EQ 2]
    o2 while [#1 LT 5]
      #1 = [#1+1]
    o2 endwhile
  o1 elseif [1]
  o1 else
    o3 do
      G0 X1
    o3 while [0]
  o1 endif
  o4 repeat [2]

    o<part> return
  o4 endrepeat
o<part> endsub
o<part> call
%
  behind  the  end
"""
    check("rs274", old, new)
    tabs = re.sub(r"(?m)^ +(?=[oG(#])", lambda match: "\t" * (len(match[0]) // 2), new)
    check("rs274", old, tabs, Style("\t"))


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("  #if1   |a| \t EqualTo  1 n  \n#ENDIF1", "#if1 |a| EqualTo 1 n\n#ENDIF1"),
        ("#LOOP1 | a  b |  2  c  |Z| 1 r", "#LOOP1 | a  b | 2 c |Z| 1 r"),
        ("#FILE   my  part.txt  ", "#FILE my  part.txt"),
        ("#IF1 |a|\n  #ENDIF1  ", "#IF1 |a|\n#ENDIF1"),
        # What would be something else with a blank before it, and what is faulty.
        ("#IF1  |a|equalto  1 n", "#IF1 |a|equalto 1 n"),
        ("#IF1  |a  equalto", "#IF1  |a  equalto"),
        ("#WHILE1  |a|", "#WHILE1  |a|"),
        # All other lines are printed with their blanks.
        ("  G1  X|a| (a  b)  ", "  G1  X|a| (a  b)  "),
        ("   ", "   "),
    ],
)
def test_metagcode_lines(old: str, new: str) -> None:
    check("metagcode", old, new)


def test_metagcode_blocks() -> None:
    old = "#IF1 |a| EqualTo 1 n\n#LOOP2 |Z| 1 c\nG1 Z|Z|\n  #FILE x\n#ENDLOOP2\n  G0\n#ENDIF1\n"
    new = "#IF1 |a| EqualTo 1 n\n  #LOOP2 |Z| 1 c\nG1 Z|Z|\n    #FILE x\n  #ENDLOOP2\n  G0\n#ENDIF1\n"
    check("metagcode", old, new)
    check("metagcode", old, new.replace("    #", "\t\t#").replace("\n  #", "\n\t#"), Style("\t"))


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("#EVAL( #V1= 2+ 3*4 )", "#EVAL(#V1 = 2 + 3*4)"),
        ("#EVAL(#V1=MAX( 1 ,2,   3 ))", "#EVAL(#V1=MAX(1,2, 3))"),
        # The value of a text is printed as it is written.
        ("#EVAL( #S1=1-  2 )", "#EVAL(#S1=1-  2)"),
        ("#EVAL( #S1 =a  b )", "#EVAL(#S1 = a  b )"),
        ("#EVAL( #mine=1-  2 )", "#EVAL(#mine=1-  2)"),
        ("#RETNUM( 1-  2 )", "#RETNUM(1 - 2)"),
        ("#RETSTR( 1-  2 )", "#RETSTR(1-  2)"),
        ("#IF( #V1 >3 ,  #AND #V2 = 1 )< a  b >#ELSE< c >", "#IF(#V1 > 3, #AND #V2 = 1)< a  b >#ELSE< c >"),
        ("#IFSTR( #S1= G0  0 )<a>", "#IFSTR(#S1 = G0  0 )<a>"),
        ("#TABLE( t ,   1 )", "#TABLE(t, 1)"),
        ("#FMT( #XPOS ,D3.4 )", "#FMT(#XPOS,D3.4)"),
        ("#RESET( #XPOS,   #YPOS )", "#RESET(#XPOS, #YPOS)"),
        ("#REPEAT( #V1 )", "#REPEAT(#V1)"),
        # Outside of parentheses blanks are printed.
        ("  <  X#XPOS  >  Y1  ", "  <  X#XPOS  >  Y1  "),
        ("   ", "   "),
        ("  #EXIT  ", "  #EXIT  "),
        ("X1   // a  b  ", "X1   // a  b"),
        ("#EVAL( #V1  )  // a", "#EVAL( #V1  )  // a"),
    ],
)
def test_cgt_lines(old: str, new: str) -> None:
    frame = "free  text  \n@LINE{}\n{}\n@\nfree  text  \n"
    check("cgt", frame.format("  ", old), frame.format("", new))


def test_cgt_declarations_and_tables() -> None:
    old = "@DECLARE\n#INT   #a,  #b\n#TBL#t\n@t  // rows  \n 0 ,  a  \n@\n"
    new = "@DECLARE\n#INT #a, #b\n#TBL#t\n@t  // rows\n 0 ,  a  \n@\n"
    check("cgt", old, new)


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("!  IF  HA >10;HA=1 ;EB!HA= 0 !  ", "!IF HA > 10; HA=1; EB! HA = 0!"),
        ("!IF HA< =10;GON 10 - N20!", "!IF HA<=10; GON10- N20!"),
        ("N10   !HA=1!   ;  a  b  ", "N10 !HA=1!     ;  a  b"),
        ("! :L254-A  B\\C !", "!:L254-A  B\\C!"),
        ("!HA=PAL[ 1 ]*( HB+ 2 )!", "!HA=PAL[1]*(HB + 2)!"),
        ("  !HA=1!", "  !HA=1!"),
        # Of a block all is printed but values that are computed, and what stands behind `;`.
        ("  G0  X1 (a  b)  ", "  G0  X1 (a  b)  "),
        ("X< HA +1 >  Y  2", "X<HA + 1>  Y  2"),
        ("G0X1;  a  b  ", "G0X1 ;  a  b"),
        ("G0  X1    ;a", "G0  X1    ;a"),
        (":1  a  b  ", ":1  a  b"),
        ("ROOT=  $FCEPP( 'A  B' ,1 )  ", "ROOT = $FCEPP('A  B',1)"),
        ("!HA=(1!  ", "!HA=(1!  "),
        ("   ", ""),
    ],
)
def test_z32_lines(old: str, new: str) -> None:
    check("z32", old, new)


def test_z32_titles_are_free_text() -> None:
    check("z32", "!HA= 1!  \n %  \n!HA= 1!\n", "!HA= 1!  \n %\n!HA = 1!\n")


@pytest.mark.parametrize(
    ("name", "old", "new"),
    [
        ("rs274", "N1 g0 x#<Ab> (g0)\nO1 IF [#1 gt sin[2]]\nO1 ENDIF ;g0", "N1 G0 X#<Ab> (g0)\no1 if [#1 GT SIN[2]]\no1 endif ;g0"),
        ("metagcode", "#loop1 |z| 2 c\ng1 x|z|\n#endloop1", "#LOOP1 |z| 2 c\ng1 x|z|\n#ENDLOOP1"),
        ("cgt", "@LINE\n#eval(#V1=abs(2))x#XPOS#exit\n@", "@LINE\n#EVAL(#V1=abs(2))x#XPOS#EXIT\n@"),
        ("z32", "!if ha>sn(2); gon10!\nx<ha> hb1 (ha)", "!IF HA>SN(2); GON10!\nx<HA> hb1 (ha)"),
    ],
)  # fmt: skip
def test_letters_as_the_manual_writes_them(name: str, old: str, new: str) -> None:
    check(name, old, new, CANONICAL)
    check(name, old, old)


def test_no_line_becomes_longer_than_the_control_reads() -> None:
    words = "".join(f"X[{number}]" for number in range(9))
    for comment in (252 - 7 - len(words) - 8, 252 - 7 - len(words)):
        line = f"{words}({'x' * comment}é)"
        size = len(line.encode()) + 9
        new = laid_out(line, "rs274")
        assert (new != line) is (size <= 251), size
    long = f"G0  X1  ({'x' * 300})"
    assert laid_out(long, "rs274") == long.replace("G0  X1  (", "G0 X1   (")


def test_indentation_is_left_where_blocks_do_not_pair() -> None:
    check("rs274", "   o1 if[1]\nG0X1\n\t o2 endif\n  G0X2\n", "   o1 if [1]\nG0 X1\n\t o2 endif\n  G0 X2\n")


@pytest.mark.parametrize("name", NAMES)
def test_comments_keep_lines_as_they_are(name: str) -> None:
    line, new = {
        "rs274": ("g0x1", "g0 x1"),
        "metagcode": ("#FILE   a", "#FILE a"),
        "cgt": ("#EVAL(#V1 =1)", "#EVAL(#V1 = 1)"),
        "z32": ("!HA= 1!", "!HA = 1!"),
    }[name]
    opens, ends = by_name(name).comments[0]
    head = "@LINE\n" if name == "cgt" else ""
    off, on, other = (f"{opens} deburr: format {word}{ends}" for word in ("off", "on", "often"))
    text = f"{head}{line}\n{off}\n{line}\n{off}\n{other}\n{line}\n{on}\n{line}\n{on}\n{line}\n{off}\n{line}"
    kept = f"{head}{new}\n{off}\n{line}\n{off}\n{other}\n{line}\n{on}\n{new}\n{on}\n{new}\n{off}\n{line}"
    check(name, text, kept)


def test_blanks_that_part_two_line_ends_stay() -> None:
    check("rs274", "G0\r  \nG1\r\n  \nG1\n  \r  \r\n", "G0\r  \nG1\r\n\nG1\n\r\r\n")
    # Also where the two stand in chunks of their own.
    check("rs274", f"({'x' * 60})\r  \nG1", f"({'x' * 60})\r  \nG1")


def test_of_lines_far_apart_only_those_of_the_range_are_touched() -> None:
    text = "g0x1\n" * 1_000
    assert laid_out(text, "rs274", first=500, last=501) == "g0x1\n" * 500 + "g0 x1\n" * 2 + "g0x1\n" * 498
