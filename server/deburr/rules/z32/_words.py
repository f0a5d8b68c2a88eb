"""The instructions of advanced lines, and what other controls write for them (spec/z32.md §3, §6)."""

INSTRUCTIONS = ("IF", "EB", "CP", "PC", "GON", "GOP", "GOS")

_ELSEWHERE = {
    "GOTO": "a jump to a block is `GON` with its number",
    "GO": "a jump to a block is `GON` with its number",
    "JMP": "a jump to a block is `GON` with its number",
    "JUMP": "a jump to a block is `GON` with its number",
    "CALL": "a program is called by `GOP` with its number, a file by `:L254-`",
    "GOSUB": "a program is called by `GOP` with its number, a file by `:L254-`",
    "RET": "a subprogram goes back at `G26`, a block of its own",
    "RETURN": "a subprogram goes back at `G26`, a block of its own",
    "ELSE": "what stands behind the next `!` runs if the condition does not hold; `EB` before that `!` parts the two",
    "END": "`EB` ends the line, `G26` a subprogram, `M30` the program",
    "ENDIF": "an IF ends at the end of its line",
    "THEN": "the instruction stands behind the condition and a `;`",
    "WHILE": "a loop is an IF with a `GON` back to its first block",
    "FOR": "a loop is an IF with a `GON` back to its first block",
    "STOP": "`EB` ends the line, `M0` stops the program",
}


def instruction_for(word: str) -> str:
    """What stands here for a word of other controls; empty if it is none."""
    return _ELSEWHERE.get(word.upper(), "")
