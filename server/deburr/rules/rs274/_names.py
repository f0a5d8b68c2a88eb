"""Which named parameters can have been set where they are read. Never speaks where another order of the run could have set one."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Generator, Iterable, Iterator
from dataclasses import dataclass, field
from functools import cached_property

from deburr.analysis import Analysis
from deburr.rules.rs274._files import World, ready_world, said, world_of
from deburr.rules.rs274._frame import is_part
from deburr.rules.rs274._guesses import Guesses
from deburr.rules.rs274._held import Role
from deburr.rules.rs274._program import Program, Sub, Use
from deburr.steps import done, kept, paced


@dataclass(eq=False)
class Scope:
    """The main program (``sub`` is None) or a subprogram, and the named parameters in it in the order of lines."""

    sub: Sub | None
    sets: list[Use] = field(default_factory=list)
    reads: list[Use] = field(default_factory=list)
    spared: set[str] = field(default_factory=set)
    """Names for which EXISTS asks, and names in lines that cannot be read: nothing is certain of them."""

    def take(self, use: Use) -> None:
        """Sort a parameter in."""
        if use.name is None:
            return
        if use.role is Role.SET:
            self.sets.append(use)
        elif use.role is Role.READ:
            self.reads.append(use)
        else:
            self.spared.add(use.name)


class Names:
    """The named parameters of a program."""

    def __init__(self, analysis: Analysis) -> None:
        self._analysis = analysis
        self._world: World = world_of(analysis)
        self._program: Program = self._world.main
        self.guesses = Guesses()
        self._scopes: dict[Sub | None, Scope] = {None: Scope(None)}
        self.undefined: list[Use] = []
        """The reads of names that nothing can have set before."""

    @classmethod
    def making(cls, analysis: Analysis) -> Generator[None, None, Names]:
        """The parameters of a program, sorted in steps."""
        yield from ready_world(analysis)
        names = cls(analysis)
        yield from names._sort()
        if names._program.sound:
            names.undefined = yield from names._all_undefined()
        return names

    def _sort(self) -> Iterator[None]:
        sub, end, scope = None, -1.0, self._scopes[None]
        for use in paced(self._program.uses):
            if use is None:
                yield
                continue
            if use.line > end or sub is None:
                sub = self._program.sub_at(use.line)
                end = use.line if sub is None else sub.end
                scope = self._scopes.setdefault(sub, Scope(sub))
            scope.take(use)

    def scope(self, use: Use) -> Scope:
        """The scope in which a parameter stands."""
        return self._scopes[self._program.sub_at(use.line)]

    @cached_property
    def all_sets(self) -> dict[str, list[Use]]:
        """All settings of named parameters in the program, in the order of lines."""
        found: dict[str, list[Use]] = {}
        for use in self._program.uses:
            if use.role is Role.SET and use.name is not None:
                found.setdefault(use.name, []).append(use)
        return found

    def sets(self, use: Use) -> list[Use]:
        """The settings of a name in the program that a read of it could see, in the order of lines."""
        if use.name is not None and use.name.startswith("_"):
            return self.all_sets.get(use.name, [])
        return self._by_name(self.scope(use)).get(use.name or "", [])

    def _all_undefined(self) -> Generator[None, None, list[Use]]:
        reads: list[Use] = []
        for use in paced(use for scope in self._scopes.values() for use in self._certain(scope)):
            if use is None:
                yield
            elif not self._may_be_set(use):
                reads.append(use)
        return sorted(reads, key=lambda use: (use.line, use.span))

    def _certain(self, scope: Scope) -> Iterable[Use]:
        """The reads of a scope of whose names all settings can be seen."""
        # Programs that M98 calls have names of their own, and pieces of programs those of the other pieces.
        local = scope.sub is not None or not (self._program.bare or self._is_part)
        for use in scope.reads:
            shared = bool(use.name) and (use.name or "").startswith("_")
            if use.name and (self._is_certain_shared(use.name) if shared else local and use.name not in scope.spared):
                yield use

    def _may_be_set(self, use: Use) -> bool:
        sets = self.sets(use)
        if not sets or sets[0].line < use.line:
            return bool(sets)
        if (use.name or "").startswith("_") and sets[-1].line > use.line:
            return True
        behind = bisect_right(sets, use.line, key=lambda each: each.line)
        return behind < len(sets) and sets[behind].line <= self._program.loop_end(use.line)

    def _is_certain_shared(self, name: str) -> bool:
        if not self._sees_all or self._analysis.dialect.codes.entry("variable", name.partition("[")[0]) is not None:
            return False
        return name not in self._elsewhere

    @cached_property
    def _sees_all(self) -> bool:
        """Whether all that can set shared names is known."""
        world = self._world
        return not (world.is_library or world.nested or self._is_part) and world.is_complete

    @cached_property
    def _is_part(self) -> bool:
        return is_part(self._analysis)

    @cached_property
    def _elsewhere(self) -> set[str]:
        """Shared names that called files set, and those of which nothing is certain in any file."""
        found = {name for scope in self._scopes.values() for name in scope.spared}
        for program in self._world.programs[1:]:
            found |= {use.name for use in program.uses if use.name and use.role is not Role.READ}
        return found

    def _by_name(self, scope: Scope) -> dict[str, list[Use]]:
        kept = self._kept.get(scope.sub)
        if kept is None:
            kept = self._kept[scope.sub] = {}
            for use in scope.sets:
                kept.setdefault(use.name or "", []).append(use)
        return kept

    @cached_property
    def _kept(self) -> dict[Sub | None, dict[str, list[Use]]]:
        return {}


def names_of(analysis: Analysis) -> Names:
    """The named parameters of the program that is checked."""
    return done(_making(analysis))


def ready_names(analysis: Analysis) -> Iterator[None]:
    """Sort the named parameters of the program, in steps."""
    yield from _making(analysis)


def _making(analysis: Analysis) -> Generator[None, None, Names]:
    return kept(analysis.memo, "rs274 names", lambda: Names.making(analysis))


def place(scope: Scope) -> str:
    """A scope as one speaks of it."""
    return "the main program" if scope.sub is None else f"`{said(scope.sub.label)} sub`"
