"""What a run is given on the command line: values, files, switches. Shared by the commands that run programs."""

import argparse
from collections.abc import Iterator, Mapping, Sequence

from deburr import paths, source
from deburr.config import ConfigError
from deburr.inputs import Inputs
from deburr_grammar.dialect import Dialect
from deburr_grammar.dialects import NAMES, by_name

_FILES = {
    "--variables": "variables",
    "--input": "input",
    "--parameters": "parameters",
    "--tool-table": "tool-table",
}
"""Options that name a file of a dialect's setting."""
_VALUES = "variables"


def add_inputs(found: argparse.ArgumentParser) -> None:
    """What the operator and the machine would give."""
    found.add_argument("-D", "--define", action="append", default=[], metavar="NAME=VALUE", help="a value by its name")
    found.add_argument("--variables", metavar="FILE", help="values: name=value lines, or JSON")
    found.add_argument("--input", metavar="FILE", help="cgt: CL text (.cl) or events (.jsonl)")
    found.add_argument("--parameters", metavar="FILE", help="rs274: stored parameters (.var)")
    found.add_argument("--tool-table", metavar="FILE", help="rs274: the tool table")
    found.add_argument("--block-delete", choices=("on", "off"), help="the operator's switch for lines with `/`")
    found.add_argument(
        "--machine-values",
        choices=("refuse", "simulate"),
        default="refuse",
        help="values that only a machine has: refuse them, or answer as the stand-alone interpreter does",
    )


def add_reached_only(found: argparse.ArgumentParser) -> None:
    """What may stop an expansion."""
    found.add_argument(
        "--reached-only",
        action="store_true",
        help="only what the run reaches stops it: faults in text that is passed over are warnings",
    )


def inputs_of(arguments: argparse.Namespace) -> Inputs:
    """What the operator and the machine would give."""
    define = defines(arguments.define)
    return Inputs(
        define=define,
        typed=tuple(define),
        block_delete=None if arguments.block_delete is None else arguments.block_delete == "on",
        simulate=arguments.machine_values == "simulate",
    )


def inputs_for(inputs: Inputs, values: str | None, dialect: Dialect) -> Inputs:
    """The inputs of a dialect's programs: in one that has no setting for a file of values, `--variables` gives them as `-D` does, which wins."""
    if values is None or any(setting.name == _VALUES for setting in dialect.settings):
        return inputs
    return inputs._replace(define={**_values_in(values), **inputs.define})


def _values_in(file: str) -> Mapping[str, str]:
    from deburr.formats.variables import read_values

    try:
        read = read_values(source.text(paths.data(file)), file)
    except OSError as error:
        raise ConfigError(f"{file}: {error.strerror}") from None
    if read.defects:
        raise ConfigError(*(f"{file}:{each.line + 1}:{each.span.start + 1}: {each.why}" for each in read.defects))
    return {name: value.text for name, value in read.known.items()}


def defines(said: Sequence[str]) -> dict[str, str]:
    """`-D NAME=VALUE` as names and values."""
    found = {}
    for each in said:
        name, sign, value = each.partition("=")
        if not sign or not name.strip():
            raise ConfigError(f"-D {each}: write NAME=VALUE")
        found[name.strip()] = value.strip()
    return found


def named_files(arguments: argparse.Namespace) -> list[str]:
    """The files that the command line names as inputs."""
    said = (getattr(arguments, name.replace("-", "_")) for name in _FILES.values())
    return [path for path in said if path is not None]


def settings(arguments: argparse.Namespace) -> Iterator[tuple[str, str]]:
    """The files that the command line names, for each dialect that has such a setting."""
    for option, name in _FILES.items():
        path = getattr(arguments, name.replace("-", "_"))
        if path is None:
            continue
        if not paths.exists(path) or paths.is_folder(path):
            raise ConfigError(f"{option}: {path}: no such file")
        for dialect in NAMES:
            if any(setting.name == name for setting in by_name(dialect).settings):
                yield f"{dialect}.{name}", paths.absolute(path)


_RUNS = {"block_delete": None, "machine_values": "refuse", "keep_n": False, "decimals": None}
"""Options that only some interpreters follow, with what stands there if they are not given."""


def known(arguments: argparse.Namespace, dialect: Dialect) -> None:
    """Say which option means nothing to the dialect, instead of passing over it."""
    from deburr.expand import interpreter

    followed = getattr(interpreter(dialect.name), "FOLLOWS", ())
    for name, default in _RUNS.items():
        if getattr(arguments, name, default) != default and name not in followed:
            raise ConfigError(f"--{name.replace('_', '-')}: means nothing to {dialect.name} programs")
    names = {setting.name for setting in dialect.settings}
    for option, name in _FILES.items():
        if getattr(arguments, name.replace("-", "_")) is not None and name not in (*names, _VALUES):
            raise ConfigError(f"{option}: {dialect.name} programs have no such input")
