"""A mechanism drawn by a hand: what it is, the scene that says so, and where the log puts it.

While something is missing a sketch comes back as it is, with the sentence that says what. Else it becomes a
scene: lengths on whole millimetres, what is nearly in line in line; a length that nothing has moved stays as it
is written. What comes back is that scene, drawn.
"""

from __future__ import annotations

import cmath
from collections.abc import Mapping, Sequence
from pathlib import Path as File
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.values import Complexes
from graphic_tmm.errors import Fault, SceneError, StructureError
from graphic_tmm.language.catalogue import Speech
from graphic_tmm.language.said import Said, said
from graphic_tmm.mechanism.records import Mechanism
from graphic_tmm.mechanism.sketch import lying
from graphic_tmm.mechanism.structure import dissect
from graphic_tmm.readers.any_angles.motion import Recorded, motion, recorded
from graphic_tmm.readers.any_angles.turn import Plan
from graphic_tmm.scene.document import Document, parsed
from graphic_tmm.scene.quantities import in_si
from graphic_tmm.scene.records import Scene
from graphic_tmm.scene.renamed import exchanged
from graphic_tmm.serve.edit import Missing, edited, new_faults
from graphic_tmm.serve.form import form
from graphic_tmm.serve.plainly import fault_text, plainly
from graphic_tmm.serve.scheme.effects import FORCES, effects_on, weighs
from graphic_tmm.serve.scheme.fields import scheme_fields
from graphic_tmm.serve.scheme.loads import load_signs
from graphic_tmm.serve.scheme.own_values import with_own_values
from graphic_tmm.serve.scheme.sections import offered, with_section
from graphic_tmm.serve.scheme.sketches import (
    BLANK,
    Sketch,
    is_length,
    is_sketch,
    scaled,
    shifted,
    sketch_of,
)
from graphic_tmm.serve.scheme.standing import Standing, standing_of
from graphic_tmm.serve.scheme.units import with_unit
from graphic_tmm.serve.scheme.written import (
    nearest_place,
    origin_of,
    positions_scene,
    scene_text,
)

MOST_PLACES = 720
"""So many places of a turn are told at the most."""
EIGHTH = 8
"""A scene is shown an eighth of its row on: its first position is often a dead place."""
MOST_TIMES = 1e6
"""A first length that would make a mechanism of metres into one of micrometres is a slip of the unit."""
PLANS: frozenset[Plan] = frozenset({"positions"})


class SchemeAct(NamedTuple):
    """What a browser asks: all in one act.

    ``sketch``: what was drawn, None where nothing was. ``letters``, ``numbers``: letters and links that are
    called otherwise now, by what they were. ``typed``: values by key, written as in the form; ``scale``: the
    first of them is the scale of all; ``section``: they are those of one more section. ``at``: where the drive
    stands; ``turn``: so many places of a turn. ``own``: values that were changed in the page, as TOML.
    """

    sketch: Sketch | None = None
    letters: Mapping[str, str] = {}
    numbers: Mapping[int, int] = {}
    typed: Mapping[str, str] = {}
    scale: bool = False
    at: float | None = None
    turn: int = 0
    section: str = ""
    own: str = ""


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
    if asked.typed and not asked.section:
        asked = asked._replace(typed=_completed(asked.typed, text, doc, file))
    if asked.sketch is not None:
        sketch = _scaled(asked, text, file) if asked.scale else asked.sketch
        stands = standing_of(sketch, doc)
        if stands.lies is None:
            return _answer(sketch, stands, speech)
        if "link" not in doc:
            shift = origin_of(stands)
            sketch = shifted(sketch, shift)
            stands = standing_of(sketch, doc)
        text = scene_text(text, doc, sketch, stands, file, scaled=asked.scale)
        asked = asked._replace(at=stands.at[0])
    text = _with_values(text, doc, asked, file, speech)
    if not text or "link" not in parsed(text.encode(), file)[1]:
        return _answer(BLANK, standing_of(BLANK, doc), speech)
    try:
        found = _drawn(text, asked, file, speech)
    except StructureError as error:
        if asked.sketch is None or not error.pictures:
            raise
        drawn = [complex(*place) for place in sketch["places"].values()]
        text = edited(text.encode(), nearest_place(error.pictures, drawn), file).decode()
        found = _drawn(text, asked, file, speech)
    errors = new_faults(data, text.encode(), file, missing) if data else ()
    if (asked.section or asked.own) and errors:
        raise SceneError(str(file), errors)
    told = [fault_text(one, speech) for one in errors]
    return found | {"errors": told, "shift": [shift.real, shift.imag]}


def _with_values(text: str, doc: Document, asked: SchemeAct, file: File, speech: Speech) -> str:
    """Return a scene's text with what was typed: a section, values of its page, or values by key."""
    if asked.own:
        return with_own_values(text, asked.own, file)
    typed = asked.typed
    if asked.section:
        text = with_section(text, asked.section, typed, file, speech)
        typed = effects_on(doc) if asked.section == FORCES and weighs(doc) else {}
    return edited(text.encode(), typed, file).decode() if typed else text


def _renamed(data: bytes, asked: SchemeAct, file: File) -> bytes:
    """Return what a scene's file holds with letters and numbers that are others now."""
    text, _ = parsed(data, file)
    names: Mapping[Any, Any] = {**asked.letters, **asked.numbers}
    for was, now in names.items():
        text = exchanged(text, was, now)
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
    section, own = (
        one if isinstance(one, str) else "" for one in map(told.get, ("section", "own"))
    )
    return SchemeAct(
        sketch,
        names[0],
        links,
        names[1],
        told.get("scale") is True,
        at,
        max(count, 0),
        section,
        own,
    )


def _begun(speech: Speech) -> Document:
    """Return what a scene says before anything is drawn."""
    return {"title": speech(said("Mechanism")), "language": speech.language}


def _completed(typed: Mapping[str, str], text: str, doc: Document, file: File) -> Mapping[str, str]:
    """Return values as they were typed with what goes without saying.

    A bare number has the unit of its field; what weighs and has one point has its mass centre there. With the
    first mass weights and inertia act.
    """
    fields = {one.key: one for group in form(text.encode(), file) for one in group.fields}
    whole = dict(typed)
    for key, value in typed.items():
        if key not in fields:
            continue
        whole[key] = with_unit(value, fields[key], doc)
        match fields[key].path:
            case ("link", int(k), "mass") if value.strip():
                whole |= {} if weighs(doc) else effects_on(doc)
                points = list(doc["link"][k].get("points", ()))
                if len(points) == 1 and "centre" not in doc["link"][k]:
                    whole[key.removesuffix("mass") + "centre"] = points[0]
    return whole


def _scaled(asked: SchemeAct, text: str, file: File) -> Sketch:
    """Return a sketch so large that the value typed is what it has: the first length is the scale of all."""
    assert asked.sketch is not None
    ((key, typed),) = asked.typed.items()
    now = {one.key: one.text for group in form(text.encode(), file) for one in group.fields}
    try:
        by = abs(in_si(typed, "length") / in_si(now[key], "length"))
    except (KeyError, ValueError, ZeroDivisionError):
        return asked.sketch
    if not 1 / MOST_TIMES < by < MOST_TIMES:
        return asked.sketch
    return scaled(asked.sketch, by)


def _drawn(text: str, asked: SchemeAct, file: File, speech: Speech) -> dict[str, Any]:
    """Return a scene as it is drawn."""
    data = text.encode()
    _, doc = parsed(data, file)
    scene = positions_scene(doc)
    assert scene.mechanism is not None
    of = recorded(scene, PLANS, exact=True)
    at = asked.at if asked.at is not None else _begins(of, scene)
    places = _places(scene, [at])
    here = {letter: complex(z[0]) for letter, z in places.items()}
    if not all(map(cmath.isfinite, here.values())):
        says = said("with these lengths it cannot be assembled here: nothing was changed")
        raise SceneError(str(file), (Fault("", 0, says),))
    structure = dissect(scene.mechanism)
    stands = Standing(structure.mobility, structure.formula, _centres(scene.mechanism, doc))
    sketch = sketch_of(lying(scene.mechanism, here), here, doc)
    found = _answer(sketch, stands, speech) | {
        "text": text,
        "at": at,
        "sweep": _sweep(of, scene),
        "loads": load_signs(doc, scene, of.sweep, [at])[0],
        "fields": scheme_fields(data, doc, file, speech),
        "sections": offered(doc, speech),
    }
    if asked.turn:
        turn = _turn(scene, of, asked.turn)
        found["turn"] = turn | {"loads": load_signs(doc, scene, of.sweep, turn["at"])}
    return found


def _begins(of: Recorded, scene: Scene) -> float:
    """Return where the drive stands first: an eighth of its row on, or next where all is assembled.

    A mechanism that goes a short way only may have no position of its row there.
    """
    row = [float(one) for one in of.sheet.project.coordinates if one is not None]
    eighth = len(row) // EIGHTH
    row = row[eighth:] + row[:eighth] + _way(_sweep(of, scene), MOST_PLACES)
    there = np.isfinite([*_places(scene, row).values()]).all(axis=0)
    return row[int(there.argmax())]


def _centres(mechanism: Mechanism, doc: Document) -> Said | str:
    """Return what is said of a mass whose centre nobody has named."""
    named = {one["number"] for one in doc["link"] if "centre" in one}
    weighs = [one for one in mechanism.links if one.mass and one.number not in named]
    if not weighs:
        return ""
    link = min(weighs, key=lambda one: one.centre is not None)
    if link.centre is None:
        return said(
            "link {number} has a mass, but no mass centre: put it by the tool", number=link.number
        )
    return said(
        "link {number}: {letter} is taken as its mass centre; put it elsewhere by the tool",
        number=link.number,
        letter=link.centre,
    )


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


def _way(sweep: Mapping[str, Any], count: int) -> list[float]:
    low, high = sweep["low"], sweep["high"]
    return [low + (high - low) * k / count for k in range(count + 1)]


def _turn(scene: Scene, of: Recorded, count: int) -> dict[str, Any]:
    """Return the places of a turn, or of the whole way."""
    row = _way(_sweep(of, scene), count)
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
        "says": plainly(speech(stands.says), speech) if stands.says else "",
        "text": None,
        "at": None,
        "sweep": None,
        "loads": [],
        "fields": [],
        "sections": [],
        "errors": [],
        "turn": None,
        "shift": [0.0, 0.0],
    }
