"""How RS274 compares the names of parameters (spec/rs274.md §4.2)."""


def name_of(said: str) -> str:
    """A parameter's name from `<Name>` or `#<Name>`, and its number from `#5`: lower case, without blanks."""
    return "".join(said.split()).removeprefix("#").strip("<>").lower()
