"""The template of an analysis, built once, and the files that it is configured with."""

from __future__ import annotations

from typing import TYPE_CHECKING

from deburr.templates.beside import Beside, beside, machine_in
from deburr.templates.template import Template

if TYPE_CHECKING:
    from deburr.analysis import Analysis


def template_of(analysis: Analysis) -> Template:
    """The template of an analysis, built when it is first asked for."""
    found: Template | None = analysis.memo.get(Template)
    if found is None:
        machine = machine_in(configured(analysis, "machine"))
        found = analysis.memo[Template] = Template(analysis.document, machine, analysis.inputs.define)
    return found


def configured(analysis: Analysis, key: str) -> Beside:
    """The file that a setting names."""
    return beside(analysis.settings, analysis.host, key)
