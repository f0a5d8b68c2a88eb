"""Lines that are gone through at several places: put in by several others, or part of several routines. Judges nothing."""

from __future__ import annotations

from collections.abc import Hashable, Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING

from deburr.values.graph import Proof

if TYPE_CHECKING:
    from deburr.values.program import Program, Routine
    from deburr.values.solve import Solution


class Places:
    """Where else the lines of a program's routines are gone through."""

    def __init__(self, program: Program) -> None:
        self._program = program

    def agree(self, routine: Routine, node: int, proof: Proof) -> bool:
        """Whether the same goes wrong wherever a line is reached."""
        return all(
            other in (known := {**solution.remarks, **solution.proofs}) and known[other].kind == proof.kind
            for solution, other in self._others(routine, node)
        )

    def alone(self, routine: Routine, node: int) -> bool:
        """Whether a line is reached in this routine only."""
        return not routine.shared or len(self._others(routine, node)) < 2

    def _others(self, routine: Routine, node: int) -> Sequence[tuple[Solution, int]]:
        """All nodes that stand for the same part of the same line and can be reached."""
        if routine.files is None and not routine.shared:
            return ()
        return self._reached.get(_place(routine, node), ())

    @cached_property
    def _reached(self) -> Mapping[Hashable, list[tuple[Solution, int]]]:
        found: dict[Hashable, list[tuple[Solution, int]]] = {}
        for name, solved in self._program.solved.items():
            for node in solved.solution.before:
                found.setdefault(_place(self._program.routines[name], node), []).append((solved.solution, node))
        return found


def _place(routine: Routine, number: int) -> Hashable:
    node = routine.graph.nodes[number]
    return routine.files[node.line] if routine.files is not None else None, routine.rows[node.line], node.part
