"""`deburr plot`: a picture of the toolpath, or a page on which each move tells the line, call and pass that made it."""

import argparse
import sys
from collections.abc import Callable, Iterable
from enum import Enum
from importlib import resources
from tempfile import TemporaryFile
from typing import NamedTuple

from deburr import paths
from deburr.cli.arguments import Parser
from deburr.cli.common import add_config, add_dialect, complain, unable
from deburr.cli.expand import configuration, count, distinct
from deburr.cli.files import STDIN
from deburr.cli.flat import Flat, Opened, Terms, flat_of, opened_programs
from deburr.cli.inputs import add_inputs, add_reached_only, inputs_for, inputs_of, known
from deburr.cli.replacing import replacing
from deburr.config import ConfigError
from deburr.configfile import Configs
from deburr.expand import Budget
from deburr.suggest import suggestion
from deburr_grammar.text import split_lines


class Format(Enum):
    """What can be written, by the ends of files' names."""

    SVG = "svg"
    PNG = "png"
    HTML = "html"


_ENDS = {"svg": Format.SVG, "png": Format.PNG, "html": Format.HTML, "htm": Format.HTML}
_WIDER = 2
"""Pixels of a PNG for one of the SVG: most screens are that fine."""


class Picture(NamedTuple):
    """What is written, and what is to be said about it."""

    data: Iterable[bytes]
    said: str = ""


def parser() -> argparse.ArgumentParser:
    """The command's options."""
    found = Parser(
        prog="deburr plot",
        description="Draw the toolpath of a program: an SVG or PNG picture from four sides, or an HTML page to turn and click on.",
    )
    found.add_argument("files", nargs="+", metavar="FILE", help="a program, or - for standard input")
    found.add_argument("-o", "--output", metavar="FILE", help="where the picture goes: .svg, .png or .html (default: SVG on standard output)")  # fmt: skip
    found.add_argument("--output-format", choices=[each.value for each in Format], help="the format, where no name tells it")  # fmt: skip
    add_dialect(found)
    found.add_argument("--profile", metavar="P", help="whose manual decides, in dialects that have profiles")
    add_config(found)
    add_inputs(found)
    add_reached_only(found)
    found.add_argument("--partial", action="store_true", help="draw what was produced before a fault, too")
    limits = Budget()
    found.add_argument("--max-steps", type=count, default=limits.steps, metavar="N", help="executed lines; 0: no limit")
    found.add_argument("--max-blocks", type=count, default=limits.blocks, metavar="N", help="flat lines; 0: no limit")
    found.add_argument("-q", "--quiet", action="store_true", help="no warnings")
    return found


def run(arguments: argparse.Namespace) -> int:
    """Expand and draw."""
    try:
        form = _format(arguments.output, arguments.output_format)
        if form is Format.PNG:
            _painter()
        inputs = inputs_of(arguments)._replace(partial=arguments.partial, reached_only=arguments.reached_only)
        configs = Configs(configuration(arguments), arguments.config)
        programs = opened_programs(arguments.files, arguments.dialect, configs)
        known(arguments, programs[0].dialect)
        inputs = inputs_for(inputs, arguments.variables, programs[0].dialect)
        distinct(arguments, {"-o": _file(arguments.output)})
        budget = Budget(arguments.max_steps, arguments.max_blocks)
        with TemporaryFile() as lines:
            flat = flat_of(programs, Terms(inputs, budget, "\n", arguments.quiet, True, "drawn"), lines)
            if not flat.whole and not arguments.partial:
                return 1
            _write(_MAKE[form](flat), _file(arguments.output))
            return 0 if flat.whole else 1
    except ConfigError as error:
        return unable(error.messages)
    except OSError as error:
        return unable([f"{error.filename or 'the picture'}: {error.strerror}"])


def _file(output: str | None) -> str | None:
    """The file to write; none for standard output."""
    return None if output == STDIN else output


def _format(output: str | None, said: str | None) -> Format:
    """What the name of the output, or the option, asks for."""
    file = _file(output)
    end = paths.extension(file).removeprefix(".") if file else ""
    if said is not None:
        if _ENDS.get(end, Format(said)) is not Format(said):
            raise ConfigError(f"-o {output}: the name says {_ENDS[end].value}, --output-format {said}")
        return Format(said)
    if not file:
        return Format.SVG
    if end not in _ENDS:
        raise ConfigError(f"-o {output}: the name ends in none of .svg, .png and .html{suggestion(end, _ENDS)}; --output-format says it, too")  # fmt: skip
    return _ENDS[end]


def _write(picture: Picture, output: str | None) -> None:
    if output is None:
        for piece in picture.data:
            sys.stdout.buffer.write(piece)
        sys.stdout.buffer.flush()
    else:
        with replacing(output) as out:
            out.writelines(picture.data)
    if picture.said:
        complain(picture.said, "")


def _svg(flat: Flat) -> Picture:
    from deburr.plot.svg import picture, told

    text, drawn = picture(_name(flat), flat.path())
    return Picture([text.encode()], told(drawn) if drawn.tolerance else "")


def _png(flat: Flat) -> Picture:
    data, said = _svg(flat)
    return Picture([_painter()(b"".join(data).decode())], said)


def _painter() -> Callable[[str], bytes]:
    """What turns SVG into PNG; it is an extra, because it is compiled."""
    try:
        import resvg_py
    except ImportError:
        raise ConfigError("PNG needs resvg_py: pip install 'resvg-py>=0.5,<0.6'; -o FILE.svg and -o FILE.html need nothing") from None  # fmt: skip
    return lambda text: bytes(resvg_py.svg_to_bytes(svg_string=text, zoom=_WIDER))


def _html(flat: Flat) -> Picture:
    from deburr.plot.columns import Toolpath
    from deburr.plot.extent import reach
    from deburr.plot.page import page

    source_map = flat.source_map
    assert source_map is not None
    programs = {program.file: program for program in flat.programs}
    lines = flat.lines()
    path = flat.path()
    made = Toolpath(_name(flat), path, source_map, lines, reach(path))
    script = resources.files("deburr.plot").joinpath("viewer.js").read_text(encoding="utf-8")
    pieces = page(made, script, lambda file: _lines(programs, flat, file), lambda file: file.rpartition("/")[2])
    return Picture(piece.encode("utf-8", "replace") for piece in pieces)


def _lines(programs: dict[str, Opened], flat: Flat, file: str) -> list[str]:
    program = programs.get(file)
    return program.source.lines if program else split_lines(flat.programs[0].host.read(file) or "")


def _name(flat: Flat) -> str:
    """The names of the programs, without their folders."""
    return " + ".join(program.file.rpartition("/")[2] for program in flat.programs)


_MAKE = {Format.SVG: _svg, Format.PNG: _png, Format.HTML: _html}
