"""The shared incremental parser of four languages in which G-code is programmed.

Text goes in, lines with trees, problems and block structure come out, and an edit
costs what it touched. Never imports deburr, pygls or lsprotocol; never opens a
program file; never raises for a faulty program.
"""

from deburr_grammar.dialect import Dialect
from deburr_grammar.document import Document
from deburr_grammar.line import LineNode
from deburr_grammar.problem import Problem
from deburr_grammar.text import Edit, Pos, Span

__all__ = ["Dialect", "Document", "Edit", "LineNode", "Pos", "Problem", "Span"]
