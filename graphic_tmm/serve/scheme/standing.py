"""What a sketch is: links and pairs, W, its formula of structure, what is missing, where it is driven."""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping
from typing import Any, NamedTuple

from graphic_tmm.errors import SceneError, StructureError
from graphic_tmm.language.said import Said, joined, said
from graphic_tmm.mechanism.driven import Driven
from graphic_tmm.mechanism.guides import turn
from graphic_tmm.mechanism.records import Mechanism
from graphic_tmm.mechanism.sketch import built
from graphic_tmm.mechanism.structure import count, dissect
from graphic_tmm.scene.document import Document, as_table
from graphic_tmm.scene.read import understood
from graphic_tmm.serve.scheme.sketches import Sketch, lying_document
from graphic_tmm.serve.scheme.words import SCHEME_WORDS

TURNS = 360.0


class Standing(NamedTuple):
    """What a sketch is: W, its formula, what is missing; if nothing is, how it lies, and where it is driven."""

    mobility: int | None = None
    formula: str = ""
    says: Said | str = ""
    lies: Mechanism | None = None
    driven: Driven | None = None

    @property
    def at(self) -> float | None:
        """Where the drive stands: degrees, or m."""
        if self.lies is None or self.driven is None:
            return None
        return coordinate_of(self.lies, self.driven)


def standing_of(sketch: Sketch, doc: Document) -> Standing:
    """Return what a sketch is."""
    if len(sketch["links"]) < 2:
        return Standing(says=SCHEME_WORDS["scheme begin"])
    drive, number = sketch["drive"], sketch["links"][1]["number"]
    given = ("title", "language", "units", "task", "lengths", "link", "drive")
    lies = lying_document(sketch, {key: doc[key] for key in given if key in doc})
    lies["drive"] = drive_table(doc, drive if drive is not None else number, {})
    try:
        mechanism = understood(lies, "scheme").mechanism
    except SceneError as error:
        return Standing(says=error.faults[0].message)
    assert mechanism is not None
    counted = count(mechanism)
    w = counted.mobility
    if drive is None and w == 1:
        return Standing(w, "", said("W = 1: say which link is driven."))
    try:
        structure = dissect(built(mechanism).mechanism)
    except StructureError as error:
        says = error.says if drive is not None else _lacks(w)
        loose = _loose(sketch) if w > len(mechanism.drives) else ""
        return Standing(w, "", joined("; ", filter(None, (says, loose))))
    return Standing(w, structure.formula, "", mechanism, structure.first)


def _loose(sketch: Sketch) -> Said | str:
    """Return what is said of pins by which nothing is joined."""
    letters = [letter for link in sketch["links"] for letter in link["points"]]
    centres = {link.get("centre") for link in sketch["links"]}
    loose = [one for one in sketch["places"] if letters.count(one) == 1 and one not in centres]
    return said("joined with nothing: {letters}", letters=", ".join(loose)) if loose else ""


def _lacks(w: int) -> Said:
    """Return what is said of a mechanism without a drive that cannot be driven by one."""
    if w > 1:
        return said(
            "W = {w}: a support, a slider or a further link is missing, or several drives", w=w
        )
    return said("W = {w}: nothing can move; a pair is too many", w=f"{w}".replace("-", "−"))


def drive_table(doc: Document, link: int, way: Mapping[str, Any]) -> Any:
    """Return the drive of a scene, of the link that is driven now."""
    told = doc.get("drive", {"speed": 0})
    if isinstance(told, list):
        return [{**as_table(told[0]), "link": link, **way}, *told[1:]]
    return {"link": link, **{k: v for k, v in as_table(told).items() if k != "link"}, **way}


def coordinate_of(lies: Mechanism, driven: Driven) -> float:
    """Return where the drive stands: degrees, or m along its guide or out of its cylinder."""
    link = lies.by_number[driven.link]
    pin = link.points[driven.pin]
    if driven.pair.kind == "R":
        return math.degrees(cmath.phase(pin - link.points[driven.pair.name])) % TURNS
    guide = link.slides[0].guide
    if driven.telescopes:
        cylinder = lies.by_number[link.slides[0].on]
        others = [one for one in lies.by_number.values() if one is not cylinder]
        pivot = next(
            z for k, z in cylinder.points.items() if any(k in one.points for one in others)
        )
        return abs(pin - pivot)
    return ((pin - guide.through) * turn(guide.angle).conjugate()).real
