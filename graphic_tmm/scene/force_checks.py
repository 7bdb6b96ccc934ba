"""What the sections of effects, loads, forces and friction say against themselves and the mechanism."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.bounds import INTERVALS
from graphic_tmm.scene import letters
from graphic_tmm.scene.faults import Found
from graphic_tmm.scene.force_tables import LoadTable
from graphic_tmm.scene.lines import Path
from graphic_tmm.scene.records import ENGINE_PLACES, FORCE_PLACES
from graphic_tmm.scene.references import Outline, no_link, outline
from graphic_tmm.scene.sections import Document, Parts, pairing, table

TOLD = ("force", "moment", "by_position", "by_angle", "of")


def check(doc: Document, parts: Parts) -> Iterator[Found]:
    """Every contradiction of the sections that ask for forces."""
    names = outline(doc)
    count = parts.drive.positions if parts.drive is not None else None
    for path, load in pairing(parts.loads, "load"):
        yield from _load(path, load, names, count)
    if parts.effects is not None and parts.effects.gas and "indicator" not in doc:
        says = "no pressures are given; write a section [indicator], or leave gas out"
        yield Found(("effects", "gas"), says)
    if parts.effects is not None and parts.effects.friction and "friction" not in doc:
        says = "no coefficients are given; write a section [friction] with f = 0.1"
        yield Found(("effects", "friction"), says)
    yield from _friction(parts, names)
    if parts.forces is not None:
        for number in parts.forces.single:
            if number not in names.bodies:
                yield from no_link(("forces", "single"), number, names)
    yield from _engine(doc, parts, names)
    yield from _placed(doc)


def _engine(doc: Document, parts: Parts, names: Outline) -> Iterator[Found]:
    if parts.engine is None:
        return
    if parts.engine.point not in names.moving:
        hint = letters.unknown(parts.engine.point, names.moving, "moving points")
        says = f'"{parts.engine.point[:20]}" is no moving point{hint}'
        yield Found(("engine", "point"), says)
    if "indicator" not in doc:
        says = "no pressures are given; write a section [indicator]"
        yield Found(("engine",), says)
    if parts.drive is not None and not INTERVALS.holds(parts.drive.positions):
        says = (
            f"diagrams need {INTERVALS.least} positions at least; write positions = 12 in [drive]"
        )
        yield Found(("engine",), says)


def _load(path: Path, load: LoadTable, names: Outline, count: int | None) -> Iterator[Found]:
    if load.link not in names.bodies:
        yield from no_link((*path, "link"), load.link, names)
        return
    if load.link == names.frame:
        yield Found((*path, "link"), f"link {load.link} is the frame; name a moving link")
    own = names.bodies[load.link].letters
    if load.point is not None and load.point not in own:
        hint = letters.unknown(load.point, own, f"letters of link {load.link}")
        yield Found((*path, "point"), f'"{load.point[:20]}" is no letter of link {load.link}{hint}')
    if load.of is not None and load.of not in names.moving:
        hint = letters.unknown(load.of, names.moving, "moving points")
        yield Found((*path, "of"), f'"{load.of[:20]}" is no moving point{hint}')
    yield from _size(path, load, count)


def _size(path: Path, load: LoadTable, count: int | None) -> Iterator[Found]:
    told = [key for key in TOLD if getattr(load, key) is not None]
    if not told:
        says = (
            'nothing says how large it is; write force = "190 N", moment, by_position or by_angle'
        )
        yield Found((*path, "force"), says)
    for other in told[1:]:
        says = f"{told[0]} gives the size already; leave one of them out"
        yield Found((*path, other), says)
    if load.force is not None and load.point is None:
        yield Found((*path, "point"), 'a force acts at a point; write point = "D"')
    if load.moment is not None and load.point is not None:
        yield Found((*path, "point"), "a moment acts on the whole link; leave the point out")
    if load.by_position is not None and count is not None and len(load.by_position) != count:
        says = f"{len(load.by_position)} sizes for {count} positions; give one for each"
        yield Found((*path, "by_position"), says)
    strokes = load.out is not None or load.back is not None
    if load.of is None and strokes:
        says = 'by the travel of which point? write of = "D"'
        yield Found((*path, "of"), says)
    if load.of is not None and not strokes:
        says = 'it says no size; write out = [[0, "0 N"], [1, "190 N"]], or back'
        yield Found((*path, "of"), says)


def _friction(parts: Parts, names: Outline) -> Iterator[Found]:
    made = parts.friction
    if made is None:
        return
    bodies = names.bodies.values()
    pins = [x for x in names.letters if sum(x in body.letters for body in bodies) > 1]
    guides = [slide.along for link in parts.links if link is not None for slide in link.pairs]
    for key, told, known in (
        ("pairs", made.pairs, [*pins, *guides]),
        ("radii", made.radii, pins),
    ):
        for name in told:
            if name not in known:
                hint = letters.unknown(name, known, "pairs" if key == "pairs" else "pins")
                yield Found(("friction", key, name), f'"{name[:20]}" is none{hint}')
    rubs = made.f > 0 and made.radius is None and not made.radii
    if rubs and not guides:
        says = 'friction in a pin needs its radius; write radius = "15 mm"'
        yield Found(("friction", "radius"), says)


def _placed(doc: Document) -> Iterator[Found]:
    """A sheet that places forces which the scene does not ask for."""
    sheets = doc.get("sheet")
    for i, sheet in enumerate(sheets if isinstance(sheets, list) else []):
        places = table(sheet).get("place")
        for place in (*FORCE_PLACES, *ENGINE_PLACES):
            section = "engine" if place in ENGINE_PLACES else "forces"
            what = 'point = "B"' if place in ENGINE_PLACES else "positions = [2]"
            if isinstance(places, list) and place in places and section not in doc:
                says = f"nothing says what it is; write a section [{section}] with {what}"
                yield Found(("sheet", i, "place"), f'"{place}": {says}')
