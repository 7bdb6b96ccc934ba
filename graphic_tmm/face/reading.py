"""The first verb: a scene, wherever it stands."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from graphic_tmm.errors import Fault, SceneError
from graphic_tmm.language.said import said
from graphic_tmm.paper.lettering.letters import missing
from graphic_tmm.scene.packaged import packaged, scene_path
from graphic_tmm.scene.read import judged, understood
from graphic_tmm.scene.read import read as read_file
from graphic_tmm.scene.records import Scene
from graphic_tmm.scene.vary import document_of

Source = Scene | str | os.PathLike[str] | bytes | Mapping[str, Any] | None
"""What a scene may be read from."""
TEXT = "scene"
"""The name of a scene that no file holds."""


def read(source: Source = None, *, language: str | None = None) -> Scene:
    """Read a scene: by its name, from a file, from TOML text, from tables.

    Parameters
    ----------
    source : str, path, bytes, mapping or Scene, optional
        The name of a scene that comes with the package (`scenes` lists them), a file or a folder that holds a
        ``scene.toml``; TOML, as a text of more than one line or as bytes; tables as `tomllib` gives them, in
        which numbers of numpy and tuples may stand. Left out, the scene that the commands draw by default.
    language : str, optional
        "en" or "ru" for all that is drawn and said of it; left out, the scene's own.

    Returns
    -------
    Scene
        In SI units; angles in degrees.

    Raises
    ------
    SceneError
        With every fault, each with its key, its line if there is one, and the remedy.

    Examples
    --------
    >>> import graphic_tmm as tmm
    >>> tmm.read("crank-rocker", language="en").mechanism.drive.link
    1
    """
    scene = _read(source)
    return scene if language in (None, scene.language) else scene.with_(language=language)


def _read(source: Source) -> Scene:
    if isinstance(source, Scene):
        return source
    if isinstance(source, Mapping):
        return understood(document_of(source, TEXT), TEXT)
    if isinstance(source, str) and "\n" in source:
        source = source.encode("utf-8", "surrogatepass")
    if isinstance(source, bytes):
        return judged(source, Path(TEXT))
    if source is None or isinstance(source, (str, os.PathLike)):
        return read_file(scene_path(source if source is None else os.fspath(source)))
    says = said(
        "a scene is read from a name, a path, a text or tables, not from this ({kind})",
        kind=type(source).__name__,
    )
    raise SceneError(TEXT, (Fault("", 0, says),))


def refuse_unlettered(scene: Scene) -> None:
    """Refuse a scene with letters that cannot be written on a sheet.

    Raises
    ------
    SceneError
        With every such letter, at its key.
    """
    if scene.doc:
        understood(scene.doc, scene.source, missing=missing)


def scenes() -> tuple[str, ...]:
    """Return the names of the scenes that come with the package, in order.

    Examples
    --------
    >>> import graphic_tmm as tmm
    >>> "windrower" in tmm.scenes()
    True
    """
    return tuple(path.name for path in packaged())
