"""Read a scene file: every fault at once, each with its key, its line and the remedy."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path

from graphic_tmm.errors import Fault, SceneError, first_of
from graphic_tmm.scene import build, checks, joints, references
from graphic_tmm.scene.bare import grouped
from graphic_tmm.scene.checks import remarks
from graphic_tmm.scene.declare import Flaw
from graphic_tmm.scene.document import Document, document, parsed
from graphic_tmm.scene.given_speeds import with_speeds
from graphic_tmm.scene.lines import fault, key_of, line_of, locate
from graphic_tmm.scene.packaged import FILE, SCENE, scene_name
from graphic_tmm.scene.quantities import measuring
from graphic_tmm.scene.records import Scene
from graphic_tmm.scene.sections import measures, understand
from graphic_tmm.scene.vary import changed, lines_by_key

TOLD = 50
"""So many faults of a file are told; a person mends these first."""


def read(path: Path | str, *, missing: Callable[[str], str] = lambda text: "") -> Scene:
    """Read the scene of a file, or of a folder that holds a ``scene.toml``.

    Parameters
    ----------
    path : Path or str
        The file or the folder.
    missing : callable
        text -> those of its characters that cannot be lettered; none by default.

    Returns
    -------
    Scene
        In SI units; angles in degrees.

    Raises
    ------
    SceneError
        With every fault of the file.
    """
    place = Path(path)
    file = place / FILE if place.is_dir() else place
    return _scene(file, *document(file, SCENE), missing)


def judged(data: bytes, file: Path, *, missing: Callable[[str], str] = lambda text: "") -> Scene:
    """Return the scene that a file would hold with these bytes; parameters and errors as `read`."""
    return _scene(file, *parsed(data, file), missing)


def otherwise(scene: Scene, values: Mapping[str, object]) -> Scene:
    """Return a scene that says something else at some of its keys: see `Scene.with_`."""
    source = scene_name(scene.source)
    return understood(changed(scene.doc, values, source), source)


def understood(
    doc: Document, source: str, *, missing: Callable[[str], str] = lambda text: ""
) -> Scene:
    """Return the scene of tables that no file holds; errors as `read`, without lines."""
    return _scene(Path(source), None, doc, missing)


def _scene(file: Path, text: str | None, doc: Document, missing: Callable[[str], str]) -> Scene:
    with measuring(measures(doc)):
        own, told = joints.expanded(doc)
        if not any(one.fault for one in told):
            own, wrong = with_speeds(own, lambda other: _scene(file, text, other, missing))
            told += wrong
        if any(one.fault for one in told):
            # what else were told would come of links that nobody can place
            raise SceneError(str(file), _in_order(text or "", doc, told))
        parts, found = understand(own)
        found.extend(told)
        faults = [one for one in found if one.fault]
        faults.extend(references.name_faults(own, missing))
        faults.extend(checks.contradictions(parts))
        if faults:
            raise SceneError(str(file), _in_order(text or "", doc, faults))
        made = build.scene(parts, str(file))
        lines = None if text is None else locate(text)
        asides = grouped((key_of(doc, one.path), one.message) for one in found)
        told_of = (*asides, *remarks(parts))
    return replace(made, remarks=told_of, told=lines_by_key(doc, lines), doc=doc)


def _in_order(text: str, doc: Document, found: list[Flaw]) -> tuple[Fault, ...]:
    """Return the faults in the order of the file; of very many the first."""
    lines = locate(text)
    first = sorted(found, key=lambda item: line_of(lines, item.path))[:TOLD]
    faults = {fault(doc, lines, item) for item in first}
    ordered = sorted(faults, key=lambda fault: (fault.line, fault.key, fault.message))
    return first_of(ordered, len(ordered), len(ordered) + len(found) - len(first))
