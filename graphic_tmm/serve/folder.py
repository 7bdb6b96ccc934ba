"""The scenes of a folder, by name. Nothing is read or written but what stands in it, by whatever links."""

from __future__ import annotations

import itertools
import os
import re
from collections.abc import Iterator, Mapping
from contextlib import suppress
from os.path import isfile
from pathlib import Path
from typing import NoReturn

from graphic_tmm.errors import Fault, SceneError
from graphic_tmm.files import Kind, call, read, write
from graphic_tmm.fitting.composition import COMPOSITION, composition_file
from graphic_tmm.fitting.composition import FILE as COMPOSED
from graphic_tmm.language.said import said
from graphic_tmm.scene.packaged import FILE, SCENE, packaged, scene_name, scene_path
from graphic_tmm.serve.limits import SCENES

LONGEST = 40
"""So many characters the name of a new scene has at the most."""
_OUTSIDE = said("this is a link that leads out of the folder; put the file itself there")


class Folder:
    """A folder and its scenes; ``only``: the one scene of it that is served; ``fixed``: none is written."""

    def __init__(self, root: Path, only: Path | None = None) -> None:
        self.root = root.resolve()
        self.only = only
        own = {path.resolve() for path in packaged()}
        self.fixed = self.root in own or self.root in {path.parent for path in own}

    def scenes(self) -> Mapping[str, Path]:
        """Return the files of the scenes by name, in order; whether they can be read shows when they are."""
        if self.only is not None:
            return {scene_name(str(self.only)): self.only}
        found: dict[str, Path] = {}
        for name, file in sorted(self._there()):
            found.setdefault(name, file)
            if len(found) == SCENES:
                break
        return found

    def _there(self) -> Iterator[tuple[str, Path]]:
        """Yield what looks like a scene: folders with a scene, then files of their own; and its name."""
        alone = self.root / FILE
        if isfile(alone):
            yield scene_name(str(alone)), alone
        for name in os.listdir(self.root):
            path = self.root / name
            if name.startswith("."):
                continue
            if isfile(path / FILE):
                yield name, path / FILE
            elif _alone(path) and isfile(path):
                yield path.stem, path

    def watched(self) -> frozenset[Path]:
        """Return the folders in which something may change; none beyond this one."""
        found = {self.root}
        for file in self.scenes().values():
            with suppress(SceneError):
                found.add(self._inside(file).parent)
        return frozenset(found)

    def read(self, file: Path) -> bytes:
        """Return what a scene's file holds.

        Raises
        ------
        SceneError
            If it cannot be read, or a link leads out of the folder.
        """
        return self._read(file, SCENE)

    def composition(self, file: Path) -> bytes | None:
        """Return what the composition beside a scene holds, None if there is none; raises as `read`."""
        there = composition_file(str(file))
        return self._read(there, COMPOSITION) if there.exists() else None

    def write(self, file: Path, data: bytes) -> None:
        """Write a scene's file anew, whole or not at all.

        Raises
        ------
        SceneError
            If a link leads out of the folder.
        SheetError
            If it cannot be written.
        """
        real = self._inside(file)
        with call():
            write(real.parent, {real.name: data}, remedy=said("check the rights of the folder"))

    def create(self, title: str, files: Mapping[str, bytes]) -> str:
        """Put a new scene into a folder of its own; return the name that is made of its title.

        Raises
        ------
        SheetError
            If it cannot be written.
        """
        # what a title says is never made a path: letters, figures, and lines between them
        plain = "-".join(re.findall(r"\w+", title.lower()))[:LONGEST] or "scheme"
        taken = {name.lower() for name in os.listdir(self.root)}
        name = next(
            one
            for k in itertools.count(1)
            if (one := f"{plain}-{k}" if k > 1 else plain) not in taken
        )
        with call():
            write(self.root / name, dict(files), remedy=said("check the rights of the folder"))
        return name

    def _read(self, file: Path, kind: Kind) -> bytes:
        real = self._inside(file)
        with call():
            return read(real, kind)

    def _inside(self, file: Path) -> Path:
        """Return where a file really is, links followed; refuse what is outside."""
        try:
            real = file.resolve()
        except (OSError, RuntimeError):  # links that lead to each other
            _refuse(file, _OUTSIDE)
        if not real.is_relative_to(self.root):
            _refuse(file, _OUTSIDE)
        return real


def folder_of(name: str | None) -> Folder:
    """Return what is to be served: a folder of scenes, or a scene alone by its path or name.

    Raises
    ------
    SceneError
        If there is no such scene, or standard input is meant.
    """
    path = scene_path(name)
    if not path.exists():
        _refuse(
            path,
            said("a file or a folder is wanted, that can change; {remedy}", remedy=SCENE.remedy),
        )
    if path.is_dir() and not (path / FILE).is_file():
        return Folder(path)
    file = (path / FILE if path.is_dir() else path).resolve()
    return Folder(file.parent, file)


def _alone(file: Path) -> bool:
    """Whether a file may be a scene that stands beside others: no composition, not the folder's own."""
    name = file.name
    return (
        file.suffix == ".toml"
        and name not in (FILE, COMPOSED)
        and not name.endswith(f".{COMPOSED}")
    )


def _refuse(file: Path, message: str) -> NoReturn:
    raise SceneError(str(file), (Fault("", 0, message),)) from None
