"""The template of an analysis, read once, and the files that it is configured with."""

from __future__ import annotations

from typing import TYPE_CHECKING

from deburr.steps import done, kept
from deburr.templates.beside import Beside, beside, machine_in
from deburr.templates.template import Template, template_in

if TYPE_CHECKING:
    from collections.abc import Generator, Iterator

    from deburr.analysis import Analysis


def ready(analysis: Analysis) -> Iterator[None]:
    """Read the template, in steps: what rules that stand on it are to be ready with."""
    yield from _reading(analysis)


def template_of(analysis: Analysis) -> Template:
    """The template of an analysis, read when it is first asked for."""
    return done(_reading(analysis))


def _reading(analysis: Analysis) -> Generator[None, None, Template]:
    def make() -> Generator[None, None, Template]:
        machine = machine_in(configured(analysis, "machine"))
        return template_in(analysis.document, machine, analysis.inputs.define)

    return kept(analysis.memo, Template, make)


def configured(analysis: Analysis, key: str) -> Beside:
    """The file that a setting names."""
    return beside(analysis.settings, analysis.host, key)
