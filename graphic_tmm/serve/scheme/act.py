"""A mechanism drawn by a hand: what it is, the scene that says so, and where the log puts it.

While something is missing a sketch comes back as it is, with the sentence that says what. Else it becomes a
scene: lengths on whole millimetres, what is nearly in line in line; a length that nothing has moved stays as it
is written. What comes back is that scene, drawn.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path as File
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.values import Complexes
from graphic_tmm.errors import Fault, SceneError, StructureError
from graphic_tmm.language.catalogue import Speech
from graphic_tmm.language.said import Said, said
from graphic_tmm.mechanism.driven import Driven
from graphic_tmm.mechanism.guides import turn
from graphic_tmm.mechanism.records import Link, Mechanism
from graphic_tmm.mechanism.sketch import built, lying
from graphic_tmm.mechanism.structure import count, dissect
from graphic_tmm.readers.any_angles.motion import Recorded, motion, recorded
from graphic_tmm.readers.any_angles.turn import Plan
from graphic_tmm.scene.document import Document, as_table, parsed, toml
from graphic_tmm.scene.link_tables import tables_of
from graphic_tmm.scene.mechanism import Joints
from graphic_tmm.scene.moved import rewritten
from graphic_tmm.scene.quantities import in_si
from graphic_tmm.scene.read import understood
from graphic_tmm.scene.renamed import exchanged, relettered
from graphic_tmm.scene.records import Scene
from graphic_tmm.serve.edit import Missing, edited, new_faults
from graphic_tmm.serve.form import form
from graphic_tmm.serve.scheme.fields import scheme_fields
from graphic_tmm.serve.scheme.sketches import (
    Sketch,
    is_length,
    is_sketch,
    lying_document,
    scaled,
    shifted,
    sketch_of,
)

STEP, SMALL = 1e-3, 1e-4
"""Lengths are multiples of the first, m; of a mechanism smaller than `TINY` of the second."""
TINY = 0.05
NEAR = 0.01
"""What lies nearer to a line was meant on it, of the mechanism's size: hands click 0.5 mm off on 150 (sd)."""
UNSURE = 0.05
"""As `scene.joints.UNSURE`: nobody sees a side there."""
SPAN = 0.15
"""A drive that slides goes so far to both sides of where it was drawn, of the size, until told else."""
MOST_PLACES = 720
"""So many places of a turn are told at the most."""
TURNS = 360.0
EIGHTH = 8
"""A scene is shown an eighth of its row on: its first position is often a dead place."""
PLANS: frozenset[Plan] = frozenset({"positions"})
BARE = ("task", "lengths", "frame", "joints", "link", "drive")
"""The sections that say where everything lies."""


class SchemeAct(NamedTuple):
    """What a browser asks: all in one act.

    ``sketch``: what was drawn, None where nothing was. ``letters``, ``numbers``: letters and links that are
    called otherwise now, by what they were. ``typed``: values by key, written as in the form; ``scale``: the
    first of them is the scale of all. ``at``: where the drive stands; ``turn``: so many places of a turn.
    """

    sketch: Sketch | None = None
    letters: Mapping[str, str] = {}
    numbers: Mapping[int, int] = {}
    typed: Mapping[str, str] = {}
    scale: bool = False
    at: float | None = None
    turn: int = 0


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
        return _coordinate(self.lies, self.driven)


def scheme(
    data: bytes, file: File, asked: SchemeAct, speech: Speech, missing: Missing = lambda text: ""
) -> dict[str, Any]:
    """Return a scheme after an act, as JSON takes it: the sketch, what it is, the scene of it.

    ``data``: the scene as it was, empty where there was none; ``file``: for messages.

    Raises
    ------
    SceneError
        If what was drawn or typed cannot stand so.
    """
    text, doc = parsed(_renamed(data, asked, file), file) if data else ("", _begun(speech))
    shift = 0j
    if asked.sketch is not None:
        sketch = _scaled(asked, text, file) if asked.scale else asked.sketch
        stands = _standing(sketch, doc)
        if stands.lies is None:
            return _answer(sketch, stands, speech)
        if not text:
            shift = _origin(stands)
            sketch = shifted(sketch, shift)
            stands = _standing(sketch, doc)
        text = _written(text, doc, stands, file)
        asked = asked._replace(at=stands.at)
    if asked.typed:
        text = edited(text.encode(), asked.typed, file).decode()
    found = _drawn(text, asked, file, speech)
    errors = new_faults(data, text.encode(), file, missing) if data else ()
    told = [speech(one.message) for one in errors]
    return found | {"errors": told, "shift": [shift.real, shift.imag]}


def _renamed(data: bytes, asked: SchemeAct, file: File) -> bytes:
    """Return what a scene's file holds with letters and numbers that are others now."""
    text, _ = parsed(data, file)
    for was, letter in asked.letters.items():
        text = relettered(text, was, letter)
    for number, now in asked.numbers.items():
        text = exchanged(text, number, now)
    return text.encode()


def drawing_of(told: Mapping[str, Any]) -> SchemeAct | None:
    """Return what a browser asks by JSON; None if that cannot be told."""
    sketch, typed, at, turn = (told.get(key) for key in ("sketch", "typed", "at", "turn"))
    names = [told.get("letters") or {}, typed or {}]
    numbers = told.get("numbers") or {}
    plain = all(
        isinstance(one, dict) and all(isinstance(x, str) for x in one.values()) for one in names
    )
    if not plain or (sketch is not None and not is_sketch(sketch)):
        return None
    if at is not None and not is_length(at):
        return None
    try:
        links = {int(was): int(now) for was, now in numbers.items()}
        count = min(int(turn) if turn is not None else 0, MOST_PLACES)
    except (AttributeError, TypeError, ValueError):
        return None
    return SchemeAct(
        sketch, names[0], links, names[1], told.get("scale") is True, at, max(count, 0)
    )


def _begun(speech: Speech) -> Document:
    """Return what a scene says before anything is drawn."""
    return {"title": speech(said("Mechanism")), "language": speech.language}


def _standing(sketch: Sketch, doc: Document) -> Standing:
    """Return what a sketch is."""
    if len(sketch["links"]) < 2:
        return Standing(says=said("Draw a link: drag from one of its pins to the other."))
    drive, number = sketch["drive"], sketch["links"][1]["number"]
    given = ("title", "language", "units", "task", "lengths", "link", "drive")
    lies = lying_document(sketch, {key: doc[key] for key in given if key in doc})
    lies["drive"] = _driven(doc, drive if drive is not None else number, {})
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
        return Standing(w, "", error.says if drive is not None else _lacks(w))
    return Standing(w, structure.formula, "", mechanism, structure.first)


def _lacks(w: int) -> Said:
    """Return what is said of a mechanism without a drive that cannot be driven by one."""
    if w > 1:
        return said(
            "W = {w}: a support, a slider or a further link is missing, or several drives", w=w
        )
    return said("W = {w}: nothing can move; a pair is too many", w=f"{w}".replace("-", "−"))


def _driven(doc: Document, link: int, way: Mapping[str, Any]) -> Any:
    """Return the drive of a scene, of the link that is driven now."""
    told = doc.get("drive", {"speed": 0})
    if isinstance(told, list):
        return [{**as_table(told[0]), "link": link, **way}, *told[1:]]
    return {"link": link, **{k: v for k, v in as_table(told).items() if k != "link"}, **way}


def _size(mechanism: Mechanism) -> float:
    places = [z for link in (mechanism.frame, *mechanism.drawn) for z in link.points.values()]
    return max(abs(z - places[0]) for z in places)


def _scaled(asked: SchemeAct, text: str, file: File) -> Sketch:
    """Return a sketch so large that the value typed is what it has: the first length is the scale of all."""
    assert asked.sketch is not None
    ((key, typed),) = asked.typed.items()
    now = {one.key: one.text for group in form(text.encode(), file) for one in group.fields}
    try:
        by = abs(in_si(typed, "length") / in_si(now[key], "length"))
    except (KeyError, ValueError, ZeroDivisionError):
        return asked.sketch
    if not 1e-6 < by < 1e6:
        return asked.sketch
    return scaled(asked.sketch, by)


def _written(text: str, doc: Document, stands: Standing, file: File) -> str:
    """Return the text of a scene whose mechanism lies so: new where there was none."""
    lies, driven, at = stands.lies, stands.driven, stands.at
    assert lies is not None
    assert driven is not None
    assert at is not None
    size = _size(lies)
    before = _bare(doc).mechanism if text else None
    found = built(lies, at if driven.pair.kind == "R" else 0.0, before)
    mechanism = found.mechanism
    for name, doubt in found.doubt.items():
        if doubt < UNSURE:
            mechanism = _sided(mechanism, before, name, file)
    hand = Joints(to=STEP if size > TINY else SMALL, near=NEAR * size)
    way = {} if driven.pair.kind == "R" else _way(doc, at, size)
    drive = _driven(doc, lies.drive.link, way)
    tables = {**tables_of(mechanism, hand, doc, lies), "drive": drive}
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
        says = said(
            "group {name} is drawn so near to where both its assemblies meet that nobody sees its side: "
            "draw it with the crank turned on a little",
            name=group,
        )
        raise SceneError(str(file), (Fault("", 0, says),))

    def sided(link: Link) -> Link:
        if link.number not in numbers:
            return link
        was = known[link.number]
        sides = {(one.on, one.guide.name): one.side for one in was.slides}
        slides = (replace(one, side=sides.get((one.on, one.guide.name))) for one in link.slides)
        return replace(link, side=was.side, slides=tuple(slides))

    return replace(mechanism, links=tuple(map(sided, mechanism.links)))


def _origin(stands: Standing) -> complex:
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


def _coordinate(lies: Mechanism, driven: Driven) -> float:
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


def _bare(doc: Document) -> Scene:
    """Return a scene with nothing in it but what says where everything lies."""
    kept = {
        key: one for key, one in doc.items() if key in BARE or not isinstance(one, (dict, list))
    }
    return understood(kept, "scheme")


def _drawn(text: str, asked: SchemeAct, file: File, speech: Speech) -> dict[str, Any]:
    """Return a scene as it is drawn."""
    data = text.encode()
    _, doc = parsed(data, file)
    scene = _bare(doc)
    assert scene.mechanism is not None
    of = recorded(scene, PLANS, exact=True)
    at = asked.at
    if at is None:
        row = [one for one in of.sheet.project.coordinates if one is not None]
        at = float(row[len(row) // EIGHTH])
    places = _places(scene, [at])
    here = {letter: complex(z[0]) for letter, z in places.items()}
    if not all(map(cmath.isfinite, here.values())):
        says = said("with these lengths it cannot be assembled here: nothing was changed")
        raise SceneError(str(file), (Fault("", 0, says),))
    structure = dissect(scene.mechanism)
    stands = Standing(structure.mobility, structure.formula)
    sketch = sketch_of(lying(scene.mechanism, here), here)
    found = _answer(sketch, stands, speech) | {
        "text": text,
        "at": at,
        "sweep": _sweep(of, scene),
        "fields": scheme_fields(data, doc, file, speech),
    }
    if asked.turn:
        found["turn"] = _turn(scene, of, asked.turn)
    return found


def _places(scene: Scene, at: Sequence[float]) -> dict[str, Complexes]:
    """Return the places of all letters where the drive stands, m."""
    found = motion(scene, at, plans="positions", exact=True)
    fixed = scene.mechanism.frame.points if scene.mechanism is not None else {}
    still = {letter: np.full(len(at), z) for letter, z in fixed.items()}
    return {**{letter: row for (letter, _), row in found.places.items()}, **still}


def _sweep(of: Recorded, scene: Scene) -> dict[str, Any]:
    """Return what the drive goes through: a turn, or the row of the scene."""
    sweep = of.sweep
    reach = scene.row.reach if scene.row.open else None
    low, high = reach or (sweep.low, sweep.high)
    return {
        "letter": sweep.letter,
        "unit": sweep.unit,
        "low": low,
        "high": high,
        "closed": sweep.closed and not reach,
    }


def _turn(scene: Scene, of: Recorded, count: int) -> dict[str, Any]:
    """Return the places of a turn, or of the whole way."""
    sweep = _sweep(of, scene)
    low, high = sweep["low"], sweep["high"]
    row = [low + (high - low) * k / count for k in range(count + 1)]
    places = {
        letter: [[z.real, z.imag] if cmath.isfinite(z) else None for z in map(complex, along)]
        for letter, along in _places(scene, row).items()
    }
    return {"at": row, "places": places}


def _answer(sketch: Sketch, stands: Standing, speech: Speech) -> dict[str, Any]:
    """Return what is known of a sketch that is no scene yet."""
    return {
        "sketch": sketch,
        "mobility": stands.mobility,
        "formula": stands.formula,
        "says": speech(stands.says) if stands.says else "",
        "text": None,
        "at": None,
        "sweep": None,
        "fields": [],
        "errors": [],
        "turn": None,
        "shift": [0.0, 0.0],
    }
