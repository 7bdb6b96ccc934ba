"""The scene of a mechanism that lies somewhere: new, or that which was there with what has changed."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from pathlib import Path as File

from graphic_tmm.errors import DrawnRemedy, Fault, SceneError
from graphic_tmm.mechanism.records import Link, Mechanism
from graphic_tmm.mechanism.sketch import built
from graphic_tmm.scene.document import Document, toml
from graphic_tmm.scene.given_speeds import at_one_speed
from graphic_tmm.scene.joints import UNSURE, unseen_side
from graphic_tmm.scene.link_tables import tables_of
from graphic_tmm.scene.mechanism import Joints
from graphic_tmm.scene.moved import rewritten
from graphic_tmm.scene.read import understood
from graphic_tmm.scene.records import Scene
from graphic_tmm.serve.scheme.drives import drive_tables, first_table, starts_of, zero_of
from graphic_tmm.serve.scheme.paralleled import paralleled, with_named_sides
from graphic_tmm.serve.scheme.sketches import Sketch, with_centres
from graphic_tmm.serve.scheme.standing import NEAR, Standing, breadth_of

STEP, SMALL = 1e-3, 1e-4
"""Lengths are multiples of the first, m; of a mechanism smaller than `TINY` of the second."""
TINY = 0.05
SPAN = 0.15
"""A drive that slides goes so far to both sides of where it was drawn, of the size, until told else."""
DEAD = 1e-6
"""Of a parallelogram the side is known up to its dead places: it is one, and was not drawn so by chance."""
UNMOVED = 1e-6
"""A point of a link that is off by no more than this share of the size was not moved."""
BARE = ("task", "lengths", "frame", "joints", "link", "mesh", "drive")
"""The sections that say where everything lies."""


def scene_text(
    text: str, doc: Document, sketch: Sketch, stands: Standing, file: File, *, scaled: bool = False
) -> str:
    """Return the text of a scene whose mechanism lies so: new where there was none.

    ``scaled``: all of it has another size.
    """
    lies, (driven, *_), at = stands.lies, stands.driven, stands.at
    assert lies is not None
    size, turns = breadth_of(lies), driven.pair.kind == "R"
    hand = Joints(to=STEP if size > TINY else SMALL, near=NEAR * size)
    scene = positions_scene(doc) if "link" in doc else None
    before = scene.mechanism if scene is not None else None
    lies, hand, parallel = paralleled(lies, driven, before, hand)
    found = built(lies, at[0] if turns else 0.0, before)
    if before is not None and _moved(found.mechanism, before):
        doc = _without_near(doc)
        bare = tuple(replace(one, near=None) for one in lies.links)
        found = built(replace(lies, links=bare), at[0] if turns else 0.0, before)
    mechanism = found.mechanism
    for name, doubt in found.doubt.items():
        least = DEAD if parallel.keys() & {*map(int, name.split("-"))} else UNSURE
        if doubt < least:
            mechanism = _sided(mechanism, before, name, file)
    link = lies.drive.link
    way = {} if turns else _way(first_table(doc, link), at[0], size)
    starts = starts_of(lies.drives, at, zero_of(scene, link, way), before)
    drive = drive_tables(doc, [one.link for one in lies.drives], way, starts)
    tables = {**tables_of(mechanism, hand, with_centres(doc, sketch), lies), "drive": drive}
    if "lengths" in doc:
        tables["lengths"] = doc["lengths"]
    tables = with_named_sides(tables, link, parallel, before)
    return rewritten(text or _head(doc), tables, everywhere=scaled)


def _moved(mechanism: Mechanism, before: Mechanism) -> bool:
    """Tell whether lengths changed by which a plate may lie near another place than a scene says."""
    known = {one.number: one.points for one in (before.frame, *before.links)}
    least = UNMOVED * breadth_of(before)
    return any(one.near is not None for one in before.links) and any(
        abs(z - known[link.number][letter]) > least
        for link in (mechanism.frame, *mechanism.links)
        for letter, z in link.points.items()
        if letter in known.get(link.number, ())
    )


def _without_near(doc: Document) -> Document:
    """Return a scene that does not say near which place its plates lie."""
    links = [
        {key: value for key, value in one.items() if key not in ("near", "near_at")}
        for one in doc["link"]
    ]
    return {**doc, "link": links}


def nearest_place(places: Sequence[DrawnRemedy], drawn: Sequence[complex]) -> Mapping[str, str]:
    """Return what is written to have that of several places whose pins are nearest to letters as drawn, m."""

    def away(place: DrawnRemedy) -> float:
        return sum(min(abs(z - one) for one in drawn) for line in place.lines for z in line)

    return dict(min(places, key=away).values)


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
    fixed, (first, *_) = stands.lies.frame.points, stands.driven
    letter = first.pair.name if first.pair.kind == "R" else next(iter(fixed), "")
    return -fixed[letter] if letter in fixed else 0j


def _head(doc: Document) -> str:
    """Return the text that a new scene begins with."""
    return "".join(f"{key} = {toml(value)}\n" for key, value in doc.items())


def _way(first: Document, at: float, size: float) -> Mapping[str, str]:
    """Return the row of a drive that slides: what was written, else about where it was drawn."""
    if "from" in first or isinstance(first.get("positions"), list):
        return {}
    span = SPAN * size
    low, high = (round((at + by) / STEP) for by in (-span, span))
    return {"from": f"{low} mm", "to": f"{high} mm"}


def positions_scene(doc: Document) -> Scene:
    """Return a scene with nothing in it but what says where everything lies."""
    return understood(placing_part(doc), "scheme")


def placing_part(doc: Document, others: Collection[str] = ()) -> Document:
    """Return what a scene says of where everything lies, and its sections of some names."""
    known = (*BARE, *others)
    kept = {k: one for k, one in doc.items() if k in known or not isinstance(one, (dict, list))}
    return at_one_speed(kept)
