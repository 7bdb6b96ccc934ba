"""The scenes that come with the package, and the names of scenes, by where they are read."""

from __future__ import annotations

from pathlib import Path

from graphic_tmm.errors import Fault, SceneError
from graphic_tmm.files import STANDARD_INPUT, Kind
from graphic_tmm.language.said import joined, said
from graphic_tmm.scene.misfits import near

FILE = "scene.toml"
SCENE = Kind(
    said("a scene"), said("name a scene file, or a folder with a {file}", file=FILE), 256_000
)


def scene_name(source: str) -> str:
    """Return the name that a scene's sheets bear: that of its folder, or of its file."""
    if source == str(STANDARD_INPUT):
        return "scene"
    path = Path(source).resolve()
    return path.parent.name if path.name == FILE else path.stem


DEFAULT = "windrower"
"""The scene that is drawn when none is named."""


def packaged() -> list[Path]:
    """Return the folders of the scenes that come with the package, by name."""
    package = Path(__file__).parents[1]
    homes = [package / "scenes", package.parent / "sheets"]
    found = {path.parent.name: path.parent for home in homes for path in home.glob(f"*/{FILE}")}
    return [found[name] for name in sorted(found)]


def scene_path(name: str | None) -> Path:
    """Return the folder or file of a scene: a path, or the name of a scene that comes with the package.

    Raises
    ------
    SceneError
        If there is neither.
    """
    if name == str(STANDARD_INPUT):
        return STANDARD_INPUT
    wanted = DEFAULT if name is None else name
    if name is not None and Path(name).exists():
        return Path(name)
    found = {path.name: path for path in packaged()}
    if wanted in found:
        return found[wanted]
    meant = near(wanted, found, 0.8)
    says = said("there is no such file; {remedy}", remedy=SCENE.remedy)
    if meant:
        says = said('there is no such file, did you mean the scene "{meant}"?', meant=meant)
    listed = said('"graphic-tmm scenes" lists those that come with it')
    raise SceneError(wanted, (Fault("", 0, joined("; ", (says, listed))),))
