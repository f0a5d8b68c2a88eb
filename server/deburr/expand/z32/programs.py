"""The programs that calls lead to: sections of the calling file, programs in a folder, files of L254 (spec/z32.md §6.4, §11). Enters none."""

from __future__ import annotations

from typing import TYPE_CHECKING

from deburr.expand.z32.unit import Program, Unit
from deburr.includes.z32 import beside, found_files, nearest_file, own_files
from deburr_grammar.document import Document

if TYPE_CHECKING:
    from collections.abc import Sequence

    from deburr.expand.z32.state import Place, State


class Programs:
    """The programs of one run; each file is read when it is first needed."""

    def __init__(self, state: State) -> None:
        self._state = state
        self._job = state.job
        self._host = state.job.host
        self._main = state.main.file
        self._units: dict[str, Unit | None] = {state.main.file: state.main}
        self._numbered: dict[tuple[str, int], Sequence[Program]] = {}
        self._files: dict[str, Sequence[str]] = {}

    def numbered(self, number: int, temporary: bool, place: Place) -> Program:
        """Program n: a file of that name or a section of one in the folder of the setting `cmos-dir`; without it, a section of the file that calls."""
        folder = str(self._job.settings["cmos-dir"])
        if folder and temporary:
            folder += "-temp"
        store = beside(self._main, folder) if folder else place.file
        key = (store, number)
        if key not in self._numbered:
            self._numbered[key] = self._stored(store, number) if folder else self._section(store, number)
        found = self._numbered[key]
        if len(found) == 1:
            return found[0]
        if found:
            files = ", ".join(f"`{each.unit.file}`" for each in found)
            message = f"{len(found)} programs have the number {number} ({files}); the control may run either"
            raise self._state.fault("program-missing", place, message)
        if folder:
            sure = bool(self._host.names(store))
            message = f"there is no program {number} in `{folder}`, so the control stops at this call"
        else:
            unit = self._units[store]
            sure = unit is not None and bool(unit.sections)
            message = f"there is no program {number} in this file (setting `cmos-dir` names a folder), so the control stops at this call"
        raise self._state.fault("program-missing", place, message, not sure)

    def file(self, said: str, place: Place) -> Program:
        """The file that a path below the file root means."""
        inner = self._inner(said, place)
        root = str(self._job.settings["file-root"]) or self._state.root
        folder = beside(self._main, root) if root else ""
        path = "/".join(inner)
        if path not in self._files:
            self._files[path] = self._exact(found_files(self._host, folder, path), inner) if root else ()
        found = self._files[path]
        unit = self._unit(found[0]) if len(found) == 1 else None
        if unit is not None:
            return unit.whole
        if len(found) > 1:
            message = f"{len(found)} files may be `{said}`: {', '.join(f'`{each}`' for each in found)}"
            raise self._state.fault("file-missing", place, message)
        if not root:
            message = f"where `{said}` lies is not known: the setting `file-root` names the folder below which it is looked for"
            raise self._state.fault("file-missing", place, message, True)
        near = nearest_file(self._host, folder, path)
        hint = f"; did you mean `{near}`?" if near else ""
        message = f"there is no file `{said}` below `{root}`; the control stops at this call{hint}"
        raise self._state.fault("file-missing", place, message, not self._host.names(folder))

    def _inner(self, said: str, place: Place) -> Sequence[str]:
        """The parts of a path without `..`."""
        inner: list[str] = []
        for part in said.replace("\\", "/").split("/"):
            if part == ".." and not inner:
                message = f"`{said}` leads out of the file root; the control finds no file there"
                raise self._state.fault("file-outside", place, message)
            if part == "..":
                inner.pop()
            elif part not in ("", "."):
                inner.append(part)
        return inner

    def _exact(self, paths: Sequence[str], inner: Sequence[str]) -> Sequence[str]:
        """Of several files the one that is named without an extension of its own, if there is one."""
        same = [path for path in paths if inner and path.rpartition("/")[2].upper() == inner[-1].upper()]
        return same if len(same) == 1 else paths

    def _stored(self, folder: str, number: int) -> Sequence[Program]:
        own = own_files(self._host, folder, number)
        if own:
            return [unit.whole for path in own if (unit := self._unit(path)) is not None]
        paths = [f"{folder}/{name}" for name in self._host.names(folder)]
        return [program for path in paths for program in self._section(path, number)]

    def _section(self, path: str, number: int) -> Sequence[Program]:
        unit = self._unit(path)
        return unit.section(number) if unit is not None else ()

    def _unit(self, path: str) -> Unit | None:
        if path not in self._units:
            text = self._host.read(path)
            dialect = self._job.ruleset.dialect
            document = Document.parse(text.removeprefix("\ufeff"), dialect) if text is not None else None
            unit = self._units[path] = Unit(path, document) if document is not None else None
            if unit is not None:
                self._job.parts += (unit, unit.code)
        return self._units[path]
