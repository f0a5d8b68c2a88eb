"""O-word commands, and which of them somebody meant who wrote another word (spec/rs274.md §6)."""

COMMANDS = (
    "sub",
    "endsub",
    "return",
    "call",
    "if",
    "elseif",
    "else",
    "endif",
    "while",
    "endwhile",
    "do",
    "repeat",
    "endrepeat",
    "break",
    "continue",
)
_ELSEWHERE = {
    "gosub": "call",
    "proc": "sub",
    "procedure": "sub",
    "function": "sub",
    "endproc": "endsub",
    "wend": "endwhile",
    "elif": "elseif",
    "elsif": "elseif",
    "fi": "endif",
    "until": "while",
    "for": "repeat",
    "loop": "repeat",
    "endfor": "endrepeat",
    "endloop": "endrepeat",
    "next": "endrepeat",
    "end": "endwhile",
    "exit": "break",
}
"""What other languages call the same, or nearly."""
_NEAR = 0.7


def meant(word: str) -> str:
    """The command that is meant by a word that is none; "" where nobody can tell.

    Another language's word comes first, then a command with letters behind it
    (`callsub`), then the nearest.
    """
    plain = "".join(word.split()).lower()
    begun = [command for command in COMMANDS if len(command) > 1 and plain.startswith(command)]
    if plain in _ELSEWHERE or begun:
        return _ELSEWHERE.get(plain) or max(begun, key=len)
    # Loaded only when somebody erred.
    from difflib import get_close_matches

    return next(iter(get_close_matches(plain, COMMANDS, 1, _NEAR)), "")
