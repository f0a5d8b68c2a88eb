"""Words beside M70 to M73 through LinuxCNC's interpreter: which act before, which behind, and which are forgotten where M72 brings a mode back."""

import pytest

from support.flat import Case, verdict
from support.motion import difference as moved_otherwise

pytestmark = pytest.mark.oracle
_STATE = (
    "(PRINT,%f #<_motion_mode> #5420 #5421 #<_absolute> f#<_feed> #<_rpm> #<_metric> #<_mist> #<_flood> #<_feed_override>"
    " #<_plane> #<_spindle_css_mode> #<_current_tool> #<_feed_hold> #<_adaptive_feed> #<_coord_system>)\n"
)
_REST = f"{_STATE}G90\nG0 X1\n{_STATE}M2\n"
_CHANGES = ("(none)", "F5", "G91", "G20", "M52", "M53 P0", "G93", "M3")
_WORDS = ("X1", "G1 X1 F77", "S33", "M62 P1", "T1 M6", "M3", "M7", "G4 P3", "G91 X1", "G93 G1 X1 F3", "M2", "M30 F7")
_SAVED = ("X1", "F77", "G91", "M3", "T1 M6", "G20", "G53 G0 X1")


def saved(change: str, words: str) -> str:
    """Modes are brought back with words beside the code, from the place of the flat program that has them."""
    return f"F100 S100\nG0 X5\nM70\n{change}\n{_STATE}M72 {words}\n{_REST}"


def elsewhere(change: str, words: str) -> str:
    """A call has saved others by then."""
    sub = "o1 sub\nM70 Y7\nM3\nG0 Y3\no1 endsub\n"
    return f"F100 S100\nG0 X5\nM70\n{sub}{change}\no1 call\nM72 {words}\n{_REST}"


def kept(code: str, words: str) -> str:
    """Words beside a code that saves modes, which come back later."""
    return f"F100 S100\nG0 X5\nM70\n{code} {words}\n{_STATE}M70\nG91 F8\nG0 X1\nM72\n{_STATE}G0 X2\nM2\n"


def called(change: str, words: str) -> str:
    """The end of a call brings them back."""
    return f"F100 S100\nG0 X5\no1 sub\nM73 {words}\n{_STATE}{change}\nG0 X1\no1 endsub\no1 call\n{_REST}"


def holds(program: str) -> None:
    case = Case("words beside", program)
    assert verdict(case) == "", program
    if case.original.status == 0:
        assert moved_otherwise(case) == "", program


@pytest.mark.parametrize("change", _CHANGES)
def test_words_beside_m72(change: str) -> None:
    for words in _WORDS:
        holds(saved(change, words))


@pytest.mark.parametrize("change", ["(none)", "F5", "G91", "G20"])
def test_words_where_others_were_saved_by_then(change: str) -> None:
    for words in _WORDS:
        holds(elsewhere(change, words))


@pytest.mark.parametrize("words", _SAVED)
def test_words_beside_m70_m71_and_m73(words: str) -> None:
    holds(kept("M70", words))
    holds(kept("M71", words))
    holds(called("G91", words))
    holds(called("F8", words))


@pytest.mark.parametrize(
    "program",
    [
        f"F100\nM52\nM70\nM52 P0\nM72 X1\n{_REST}",
        f"F100\nM70\nM52\n{_STATE}M7\nM72 X1\n{_REST}",
        f"F100\nM70\nG93\nF5\nM72\n{_STATE}F6\n{_REST}",
        f"F100\nM70\nG93\nG1 X7 F5\nM72\n{_REST}",
        f"G93 F100\nM70\nG94 F9\nM72\n{_STATE}G1 X8 F3\nM2\n",
        "G91\nM70\nM71 G53 G0 X1\nM2\n",
        "G91\nM70 G53 G0 X1\nM2\n",
        "F100\nM70\nF5\nM72 M2\n",
        "F100\nM70\nM72 M2\n",
    ],
)
def test_what_comes_back(program: str) -> None:
    holds(program)
