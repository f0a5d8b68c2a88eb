"""Lines with O-words as closures (spec/rs274.md §6): what stands on them, and who runs them. Looks at no other word."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from deburr.expand.rs274.calls import Calls
from deburr.expand.rs274.loops import Loops
from deburr.expand.rs274.parts import Parts
from deburr_grammar.tree import Token

if TYPE_CHECKING:
    from deburr.expand.rs274.compiling import Compiler
    from deburr.expand.rs274.run import Run
    from deburr.expand.rs274.unit import Op, Unit
    from deburr_grammar.line import LineNode


class Flow:
    """The flow of one run."""

    def __init__(self, run: Run, compiler: Compiler) -> None:
        self._run = run
        self._compiler = compiler
        self._state = run.state
        loops, self.calls = Loops(run.state), Calls(run, compiler)
        self._commands: dict[str, Callable[[Unit, int, Parts], Op]] = {
            "SUB": self.calls.sub,
            "ENDSUB": self.calls.back,
            "RETURN": self.calls.back,
            "CALL": self.calls.call,
            "IF": loops.branch,
            "ELSEIF": loops.other_branch,
            "ELSE": loops.other_branch,
            "ENDIF": loops.nothing,
            "WHILE": loops.test,
            "ENDWHILE": loops.end_of_while,
            "DO": loops.do,
            "REPEAT": loops.repeat,
            "ENDREPEAT": loops.end_of_repeat,
            "BREAK": loops.leave,
            "CONTINUE": loops.go_on,
        }

    def compiled(self, unit: Unit, row: int, node: LineNode) -> Op:
        """A line with an O-word; one without a command is only a place to go to."""
        o_line = next(node.find("o_line"))
        commands = (part for part in o_line.children if isinstance(part, Token) and part.kind in self._commands)
        command = next(commands, None)
        delete = self._run.job.inputs.block_delete if node.tree.find("DELETE") is not None else False
        if delete is None:
            raise self._compiler.undecided(unit, row, node)
        if delete is True or command is None:
            return lambda: row + 1
        parts = Parts(self._state, unit, row, node, o_line)
        op = self._commands[command.kind](unit, row, parts)
        return op if parts.literal is not None else lambda: self._labelled(parts, op)

    def _labelled(self, parts: Parts, op: Op) -> int:
        """A line whose label is calculated: that it can be is all that matters where blocks have been paired before."""
        parts.label()
        return op()
