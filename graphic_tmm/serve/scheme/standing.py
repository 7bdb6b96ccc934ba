"""What a sketch is: links and pairs, W, its formula of structure, what is missing, where it is driven."""

from __future__ import annotations

import cmath
import math
from typing import NamedTuple

from graphic_tmm.errors import SceneError, StructureError
from graphic_tmm.language.said import Said, joined, said
from graphic_tmm.mechanism.driven import Driven
from graphic_tmm.mechanism.guides import turn
from graphic_tmm.mechanism.parallel import parallel_cranks
from graphic_tmm.mechanism.records import Mechanism
from graphic_tmm.mechanism.sketch import built
from graphic_tmm.mechanism.structure import count, dissect
from graphic_tmm.scene.document import Document
from graphic_tmm.scene.given_speeds import at_one_speed
from graphic_tmm.scene.read import understood
from graphic_tmm.serve.scheme.drives import drive_tables
from graphic_tmm.serve.scheme.sketches import Sketch, lying_document
from graphic_tmm.serve.scheme.words import SCHEME_WORDS

TURNS = 360.0
FREE = 3
"""What a link can do that nothing holds: it goes two ways, and turns."""
NEAR = 0.01
"""What lies nearer to a line was meant on it, of the mechanism's size: hands click 0.5 mm off on 150 (sd)."""
PARALLEL = 0.025
"""So near to being a parallelogram is one: its sides are four clicks, of which 99.9 % are nearer."""


class Standing(NamedTuple):
    """What a sketch is: W, its formula, what is missing; if nothing is, how it lies, and where it is driven."""

    mobility: int | None = None
    formula: str = ""
    says: Said | str = ""
    lies: Mechanism | None = None
    driven: tuple[Driven, ...] = ()

    @property
    def at(self) -> tuple[float, ...]:
        """Where its drives stand: degrees, or m."""
        lies = self.lies
        return () if lies is None else tuple(coordinate_of(lies, one) for one in self.driven)


def standing_of(sketch: Sketch, doc: Document) -> Standing:
    """Return what a sketch is."""
    if len(sketch["links"]) < 2:
        return Standing(says=SCHEME_WORDS["scheme begin"])
    drives = sketch["drives"]
    given = ("title", "language", "units", "task", "lengths", "link", "mesh", "drive")
    lies = lying_document(sketch, {key: doc[key] for key in given if key in doc})
    undriven = {"link": sketch["links"][1]["number"], "speed": 0}
    lies["drive"] = drive_tables(doc, drives) if drives else undriven
    try:
        mechanism = understood(at_one_speed(lies), "scheme").mechanism
    except SceneError as error:
        return Standing(says=error.faults[0].message)
    assert mechanism is not None
    w = count(mechanism).mobility
    if not drives and w == 1:
        return Standing(w, "", said("W = 1: say which link is driven."))
    try:
        structure = dissect(built(mechanism).mechanism)
    except StructureError as error:
        return Standing(w, "", joined("; ", filter(None, _lacks(sketch, mechanism, w, error))))
    return Standing(w, structure.formula, "", mechanism, structure.driven)


def _lacks(
    sketch: Sketch, mechanism: Mechanism, w: int, error: StructureError
) -> tuple[Said | str, ...]:
    """Return what is said of a sketch that is no mechanism yet, and what might be done."""
    drives = len(sketch["drives"])
    loose = _loose(sketch) if w > max(drives, 1) else ""
    if drives > w > 0:
        return (
            said(
                "W = {w}, but {count} links are driven: click one of them with the tool that drives no more",
                w=w,
                count=drives,
            ),
        )
    if not drives and w == FREE and len(mechanism.links) == 1:
        return (
            said(
                "W = {w}: hold one of its pins by a support, and draw the next link from the other",
                w=w,
            ),
        )
    if not drives:
        return _undriven(w, loose), _doubled(mechanism) if w < 1 else loose
    if w < drives:
        return error.says, _doubled(mechanism)
    further = said("or another link is driven, too: click it with the tool")
    return error.says, loose, further if w > drives else ""


def _undriven(w: int, loose: Said | str) -> Said:
    """Return what is said of a mechanism without a drive that cannot be driven by one."""
    if w > 1 and not loose:
        return said("W = {w}: say which links are driven, {w} of them.", w=w)
    if w > 1:
        return said(
            "W = {w}: a support, a slider or a further link is missing, or several drives", w=w
        )
    return said("W = {w}: nothing can move; a pair is too many", w=f"{w}".replace("-", "−"))


def _loose(sketch: Sketch) -> Said | str:
    """Return what is said of pins by which nothing is joined."""
    letters = [letter for link in sketch["links"] for letter in link["points"]]
    centres = {link.get("centre") for link in sketch["links"]}
    loose = [one for one in sketch["places"] if letters.count(one) == 1 and one not in centres]
    return said("joined with nothing: {letters}", letters=", ".join(loose)) if loose else ""


def _doubled(mechanism: Mechanism) -> Said | str:
    """Return what is said of a third crank that goes parallel with two others; it repeats what they hold."""
    near = PARALLEL * breadth_of(mechanism)
    for crank in mechanism.links:
        others = {one.number for one in parallel_cranks(mechanism, crank.number, near)}
        if len(others) > 1:
            driven = {one.link for one in mechanism.drives}
            return said(
                "links {listed} go parallel: the tool makes link {number} passive",
                listed=", ".join(map(str, sorted({crank.number, *others}))),
                number=max(others - driven),
            )
    return ""


def breadth_of(mechanism: Mechanism) -> float:
    """Return how far the letters of a mechanism that lies reach from its first, m."""
    places = [z for link in (mechanism.frame, *mechanism.drawn) for z in link.points.values()]
    return max(abs(z - places[0]) for z in places)


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
