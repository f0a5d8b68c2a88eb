"""What a command takes, and what is said in one line of an option that it does not take. Runs nothing."""

import argparse
import re
from typing import Any, NoReturn

from deburr.suggest import suggestion

UNABLE = 2
"""The exit code of a command that cannot run."""
_UNKNOWN = "unrecognized arguments: "
_MISSING = "the following arguments are required: "
_CHOICE = re.compile(r"invalid choice: '?(.*?)'? \(choose from (.*)\)", re.S)


class Parser(argparse.ArgumentParser):
    """The arguments of a command. A fault in them is said with its place, the nearest name that there is, and where to read on."""

    def __init__(self, prog: str, description: str, **more: Any) -> None:
        super().__init__(prog=prog, description=description, allow_abbrev=False, **more)

    def error(self, message: str) -> NoReturn:
        """Say what is wrong and leave."""
        self.exit(UNABLE, f"deburr: error: {self._worded(message)} (see `{self.prog} --help`)\n")

    def _worded(self, message: str) -> str:
        """A message of argparse, shorter and with a way out."""
        if message.startswith(_UNKNOWN):
            return self._unknown(message.removeprefix(_UNKNOWN).split(" "))
        if message.startswith(_MISSING):
            return f"{message.removeprefix(_MISSING)}: missing"
        said = message.removeprefix("argument ").replace("expected one argument", "a value is missing")
        return _CHOICE.sub(_choice, said).replace("ignored explicit argument", "takes no value, and not")

    def _unknown(self, said: list[str]) -> str:
        name = next((each for each in said if each.startswith("-")), None)
        if name is None:
            return f"`{said[0]}`: one argument too many"
        option = name.partition("=")[0]
        return f"`{option}` is no option{suggestion(option, self._option_string_actions)}"


def _choice(match: re.Match[str]) -> str:
    names = [each.strip("'") for each in match[2].split(", ")]
    return f"`{match[1]}` is none of {', '.join(names)}{suggestion(match[1], names)}"
