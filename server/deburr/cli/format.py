"""`deburr format`: lay out files, folders or standard input."""

import argparse
import sys
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from deburr.cli.arguments import Parser
from deburr.cli.common import add_config, add_dialect, complain, unable
from deburr.cli.disk import Disk
from deburr.cli.files import STDIN, Target, targets
from deburr.cli.opening import Opener, Opening, Unopened
from deburr.cli.rewriting import difference, saved
from deburr.cli.style import style_for
from deburr.config import ConfigError, settings_of
from deburr.configfile import Configs
from deburr.formatting.program import applied, formatted
from deburr.formatting.style import style_of
from deburr.host import Host, NoFiles
from deburr_grammar.document import Document


class Done(NamedTuple):
    """What became of a file. ``changed``: it is not laid out as it should be, or was not; ``left``: why lines were left as they are."""

    file: str
    changed: bool = False
    left: tuple[str, ...] = ()
    skipped: bool = False
    failure: str = ""


def parser() -> argparse.ArgumentParser:
    """The command's options."""
    found = Parser(
        prog="deburr format",
        description="Lay out programs: blanks, indentation, the case of letters. What a program says is never changed.",
    )
    found.add_argument(
        "paths",
        nargs="*",
        metavar="PATH",
        help="files, folders (searched through, .gitignore respected) or - for standard input; a named pipe is refused, /dev/stdin and <(...) are read; default: this folder",
    )
    found.add_argument(
        "--check", action="store_true", help="write nothing; exit 1 and name the files that would change"
    )
    found.add_argument("--diff", action="store_true", help="write nothing; exit 1 and show what would change")
    add_dialect(found)
    add_config(found)
    found.add_argument("--stdin-filename", metavar="PATH", help="the name that standard input goes by")
    found.add_argument("-q", "--quiet", action="store_true", help="no summary, nothing about lines that were left")
    return found


def run(arguments: argparse.Namespace) -> int:
    """Lay out and say what was done."""
    try:
        configs = Configs(only=arguments.config)
        found = targets(arguments.paths or ([STDIN] if arguments.stdin_filename else ["."]), configs)
        formatter = Formatter(Opener(configs, arguments.dialect, arguments.stdin_filename), arguments)
        done = [formatter.done(target) for target in found]
    except ConfigError as error:
        return unable(error.messages)
    if not found:
        complain("no programs found under the given paths", "warning")
    tells = arguments.check or arguments.diff
    if not arguments.quiet and (said := _summary(done, tells)):
        # Where a text goes to standard output nothing else may.
        piped = any(target.file == STDIN for target in found) and not tells
        print(said, file=sys.stderr if arguments.diff or piped else sys.stdout)
    if any(each.failure for each in done):
        return 2
    return int(tells and any(each.changed for each in done))


class Formatter:
    """Lays out files one by one."""

    def __init__(self, opener: Opener, arguments: argparse.Namespace) -> None:
        self._opener = opener
        self._arguments = arguments
        self._disk = Disk()
        self._style = style_for(sys.stdout)

    def done(self, target: Target) -> Done:
        """A file, laid out and written, shown or named."""
        opening = self._opener.opened(target)
        if isinstance(opening, Unopened):
            done = Done(opening.file, skipped=not opening.failure, failure=opening.failure)
        else:
            done = self._laid_out(opening, target.file == STDIN)
        name = self._style.file(done.file)
        if done.failure:
            complain(f"{name}: {done.failure}")
        for why in () if self._arguments.quiet else done.left:
            complain(f"{name}: {why}", "warning")
        return done

    def _laid_out(self, opening: Opening, piped: bool) -> Done:
        dialect, text = opening.dialect, opening.source.text
        host: Host = self._disk if opening.name else NoFiles()
        given = dialect.given(settings_of(dialect, opening.config), host.read)
        document = Document.parse(text, dialect, given=given)
        new = applied(text, (edit for found in formatted(document, style_of(opening.config)) for edit in found))
        failure = self._given(opening, new, piped)
        return Done(opening.file, new != text, tuple(_left(document)), failure=failure)

    def _given(self, opening: Opening, new: str, piped: bool) -> str:
        """Put the new text where it is wanted; why that cannot be done."""
        source, name = opening.source, self._style.file(opening.file)
        if piped and not (self._arguments.diff or self._arguments.check):
            sys.stdout.buffer.write(source._replace(text=new).data)
        elif new == source.text:
            return ""
        elif self._arguments.diff:
            sys.stdout.writelines(difference(source.whole, source._replace(text=new).whole, name))
        elif self._arguments.check:
            print(f"Would reformat: {name}")
        else:
            return saved(opening.file, opening.source._replace(text=new))
        return ""


def _left(document: Document) -> Iterator[str]:
    """What of a program was left as it is, and why."""
    faulty = len({line for line, _ in document.problems()})
    if faulty:
        lines = "1 line is" if faulty == 1 else f"{faulty} lines are"
        yield f"{lines} left as written because of faults, which `deburr check` names"
    if document.faults:
        yield "indentation is left as written because blocks do not pair; `deburr check` says where"


def _summary(done: Sequence[Done], tells: bool) -> str:
    """The last line, as `ruff format` writes it: `1 file reformatted, 2 files left unchanged`."""
    read = [each for each in done if not each.failure and not each.skipped]
    counts = (
        (sum(each.changed for each in read), "would be reformatted" if tells else "reformatted"),
        (sum(not each.changed for each in read), "already formatted" if tells else "left unchanged"),
        (sum(each.skipped for each in done), "skipped: no dialect"),
        (sum(bool(each.failure) for each in done), "not formatted"),
    )
    return ", ".join(f"{count} file{'' if count == 1 else 's'} {what}" for count, what in counts if count)
