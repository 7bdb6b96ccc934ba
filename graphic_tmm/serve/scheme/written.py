"""The scene of a mechanism that lies somewhere: new, or that which was there with what has changed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path as File

from graphic_tmm.errors import Fault, SceneError
from graphic_tmm.mechanism.records import Link, Mechanism
from graphic_tmm.mechanism.sketch import built
from graphic_tmm.scene.document import Document, as_table, toml
from graphic_tmm.scene.joints import UNSURE, unseen_side
from graphic_tmm.scene.link_tables import tables_of
from graphic_tmm.scene.mechanism import Joints
from graphic_tmm.scene.moved import rewritten
from graphic_tmm.scene.read import understood
from graphic_tmm.scene.records import Scene
from graphic_tmm.serve.scheme.sketches import Sketch, with_centres
from graphic_tmm.serve.scheme.standing import Standing, drive_table

STEP, SMALL = 1e-3, 1e-4
"""Lengths are multiples of the first, m; of a mechanism smaller than `TINY` of the second."""
TINY = 0.05
NEAR = 0.01
"""What lies nearer to a line was meant on it, of the mechanism's size: hands click 0.5 mm off on 150 (sd)."""
SPAN = 0.15
"""A drive that slides goes so far to both sides of where it was drawn, of the size, until told else."""
BARE = ("task", "lengths", "frame", "joints", "link", "drive")
"""The sections that say where everything lies."""


def scene_text(text: str, doc: Document, sketch: Sketch, stands: Standing, file: File) -> str:
    """Return the text of a scene whose mechanism lies so: new where there was none."""
    lies, driven, at = stands.lies, stands.driven, stands.at
    assert lies is not None
    assert driven is not None
    assert at is not None
    size = _size(lies)
    before = positions_scene(doc).mechanism if "link" in doc else None
    found = built(lies, at if driven.pair.kind == "R" else 0.0, before)
    mechanism = found.mechanism
    for name, doubt in found.doubt.items():
        if doubt < UNSURE:
            mechanism = _sided(mechanism, before, name, file)
    hand = Joints(to=STEP if size > TINY else SMALL, near=NEAR * size)
    way = {} if driven.pair.kind == "R" else _way(doc, at, size)
    drive = drive_table(doc, lies.drive.link, way)
    tables = {**tables_of(mechanism, hand, with_centres(doc, sketch), lies), "drive": drive}
    return rewritten(text or _head(doc), tables)


def _sided(mechanism: Mechanism, before: Mechanism | None, group: str, file: File) -> Mechanism:
    """Return a mechanism in which a group has the sides that it had before.

    Raises
    ------
    SceneError
        If it was not there.
    """
    known = {link.number: link for link in before.drawn} if before is not None else {}
    numbers = set(map(int, group.split("-")))
    if not numbers <= known.keys():
        raise SceneError(str(file), (Fault("", 0, unseen_side(group)),))

    def sided(link: Link) -> Link:
        if link.number not in numbers:
            return link
        was = known[link.number]
        sides = {(one.on, one.guide.name): one.side for one in was.slides}
        slides = (replace(one, side=sides.get((one.on, one.guide.name))) for one in link.slides)
        return replace(link, side=was.side, slides=tuple(slides))

    return replace(mechanism, links=tuple(map(sided, mechanism.links)))


def origin_of(stands: Standing) -> complex:
    """Return by how much a new mechanism is shifted, m: where it is driven, or first held, is the origin."""
    assert stands.lies is not None
    assert stands.driven is not None
    fixed = stands.lies.frame.points
    letter = stands.driven.pair.name if stands.driven.pair.kind == "R" else next(iter(fixed), "")
    return -fixed[letter] if letter in fixed else 0j


def _head(doc: Document) -> str:
    """Return the text that a new scene begins with."""
    return "".join(f"{key} = {toml(value)}\n" for key, value in doc.items())


def _way(doc: Document, at: float, size: float) -> Mapping[str, str]:
    """Return the row of a drive that slides: what was written, else about where it was drawn."""
    told = doc.get("drive")
    first = as_table(told[0] if isinstance(told, list) else told)
    if "from" in first or isinstance(first.get("positions"), list):
        return {}
    span = SPAN * size
    low, high = (round((at + by) / STEP) for by in (-span, span))
    return {"from": f"{low} mm", "to": f"{high} mm"}


def positions_scene(doc: Document) -> Scene:
    """Return a scene with nothing in it but what says where everything lies."""
    kept = {
        key: one for key, one in doc.items() if key in BARE or not isinstance(one, (dict, list))
    }
    return understood(kept, "scheme")


def _size(mechanism: Mechanism) -> float:
    places = [z for link in (mechanism.frame, *mechanism.drawn) for z in link.points.values()]
    return max(abs(z - places[0]) for z in places)
