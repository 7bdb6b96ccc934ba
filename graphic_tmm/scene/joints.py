"""``[joints]``: links by the places of their joints in one position; from them what a scene says of links.

Before sections are checked, a link whose points are a list of letters gets what it would have said itself: own
axes, points, guides, offsets of its slides, its side. Lengths are rounded, and what is nearly on a line is put
on it: a hand that draws means that.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import replace
from typing import Any

from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import Said, said
from graphic_tmm.mechanism.driven import driven_pairs
from graphic_tmm.mechanism.guides import turn
from graphic_tmm.mechanism.records import Link, Mechanism, Side
from graphic_tmm.mechanism.sketch import built, lying
from graphic_tmm.scene import references
from graphic_tmm.scene import values as v
from graphic_tmm.scene.build import mechanism_of
from graphic_tmm.scene.checks import contradictions
from graphic_tmm.scene.declare import Flaw, Names, Path, build
from graphic_tmm.scene.document import Document, as_table, raw_links
from graphic_tmm.scene.given_speeds import at_one_speed
from graphic_tmm.scene.guides import direction
from graphic_tmm.scene.link_tables import link_table, near_table, slides_of
from graphic_tmm.scene.mechanism import Frame, Joints
from graphic_tmm.scene.quantities import si
from graphic_tmm.scene.sections import Parts, lengths_of, understand
from graphic_tmm.scene.tables import understood

JOINTS = "joints"
"""The section, and the word for the zero position that is drawn in it."""
UNSURE = 0.05
"""A group that stands so near to where both its assemblies meet is drawn again: a hand tells no side there."""


def unseen_side(group: str) -> Said:
    """Return what is said of a group whose side a drawing does not show."""
    return said(
        "group {name} is drawn so near to where both its assemblies meet that nobody sees its side: "
        "draw it with the crank turned on a little, or write the side",
        name=group,
    )


def expanded(doc: Document) -> tuple[Document, list[Flaw]]:
    """Return a document whose links say their own axes, and what is wrong with places of joints."""
    raw = doc.get(JOINTS)
    drawn = [path for path, link in raw_links(doc) if isinstance(link.get("points"), list)]
    if raw is None and not drawn:
        return doc, []
    names, found = lengths_of(doc), list[Flaw]()
    told = understood(Joints, raw if raw is not None else {}, (JOINTS,), names, found)
    if told is None:
        return doc, found
    places = _places(doc, told.others, names)
    found += _letters(doc, places, told.others)
    if any(one.fault for one in found):
        return doc, found
    lies = _as_it_lies(doc, places)
    parts, wrong = understand(at_one_speed(lies))
    wrong += [*references.name_faults(lies, lambda text: ""), *contradictions(parts)]
    if any(one.fault for one in wrong) or parts.frame is None or parts.drive is None:
        return lies, found
    own, doubts = _in_own_axes(doc, lies, parts, build(Joints, told), places)
    return own, [*found, *doubts]


def _places(doc: Document, joints: Mapping[str, complex], names: Names) -> dict[str, complex]:
    """Return the places of letters, m: of the frame's points and of joints."""
    frame = understood(Frame, doc.get("frame", {}), ("frame",), names, [])
    fixed = build(Frame, frame).points if frame is not None else {}
    return {**joints, **fixed}


def _letters(
    doc: Document, places: Mapping[str, complex], joints: Mapping[str, complex]
) -> Iterator[Flaw]:
    """Yield letters of links that have no place, and places of letters that stand on no link."""
    there = set[str]()
    for path, link in raw_links(doc):
        points = link.get("points")
        there |= (
            {x for x in points if isinstance(x, str)} if isinstance(points, (list, dict)) else set()
        )
        for k, letter in enumerate(points if isinstance(points, list) else []):
            if not isinstance(letter, str):
                says = said('a list of letters is wanted, ["A", "B"], or a table with their places')
                yield Flaw((*path, "points", k), says)
            elif letter not in places:
                says = said(
                    '"{letter}" has no place: write it in [joints] or [frame]', letter=letter[:20]
                )
                yield Flaw((*path, "points", k), says)
        if "weld" in link:
            says = said("an arm is told in its own axes, and so is its body: leave [joints] out")
            yield Flaw((*path, "weld"), says)
    for letter in joints:
        if letter not in there:
            yield Flaw((JOINTS, letter), said("no link has this joint; leave it out"), fault=False)


def _as_it_lies(doc: Document, places: Mapping[str, complex]) -> Document:
    """Return a document whose links by joints are told in the axes of the frame."""

    def link(one: Any) -> Any:
        if not isinstance(one, dict) or not isinstance(one.get("points"), list):
            return one
        guides = {
            name: {**guide, "through": _pair(places[guide["through"]])}
            if isinstance(guide, dict) and str(guide.get("through")) in places
            else guide
            for name, guide in as_table(one.get("guides")).items()
        }
        points = {letter: _pair(places[letter]) for letter in one["points"]}
        slides = [_unflipped(slide) for slide in slides_of(one)]
        held = ({"guides": guides} if guides else {}) | ({"slides": slides} if slides else {})
        return {**_unflipped(one), "points": points, **held}

    drive = as_table(doc.get("drive"))
    still = {"drive": {**drive, "zero": 0}} if drive.get("zero") == JOINTS else {}
    rest = {key: told for key, told in doc.items() if key != JOINTS}
    links = doc.get("link")
    return {**rest, **still} | ({"link": list(map(link, links))} if isinstance(links, list) else {})


def _unflipped(told: Any) -> Any:
    """Return a table without the angles at which a side changes that it does not tell."""
    if not isinstance(told, dict) or "side" in told:
        return told
    return {key: value for key, value in told.items() if key != "flips_at"}


def _pair(place: complex) -> list[str]:
    return [f"{si(axis, 'length')!r} m" for axis in (place.real, place.imag)]


def _in_own_axes(
    doc: Document, lies: Document, parts: Parts, hand: Joints, places: Mapping[str, complex]
) -> tuple[Document, list[Flaw]]:
    """Return a document whose links by joints are told in their own axes, with offsets and sides."""
    raw = {link["number"]: (path, link) for path, link in raw_links(doc)}
    listed = {n for n, (_, link) in raw.items() if isinstance(link.get("points"), list)}
    mechanism = mechanism_of(parts)
    assert mechanism is not None
    try:
        drawn = _straight(_flipping(lying(mechanism, places, listed), raw), hand.near)
        found = built(drawn)
        if degrees := _turned(found.mechanism, places):
            found = built(drawn, degrees)
    except StructureError:
        # what is wrong with its structure is told where it is drawn
        return lies, []
    except ValueError as error:
        says = said(
            "nobody sees how links {numbers} lie: give each two letters with places, or one and a guide",
            numbers=str(error),
        )
        return lies, [Flaw((JOINTS,), says)]
    flaws = [
        Flaw(
            (JOINTS,),
            unseen_side(name),
        )
        for name, doubt in found.doubt.items()
        if doubt < UNSURE and not _side_told(name, raw)
    ]
    own = {link.number: link for link in (*found.mechanism.links, *found.mechanism.passive)}
    links = [
        near_table(own[one["number"]], one, mechanism.drive)
        | _written(one, own[one["number"]], hand, mechanism.frame.number, listed)
        if isinstance(one, dict)
        else one
        for one in doc["link"]
    ]
    drive = as_table(doc.get("drive"))
    zero = (
        {"drive": {**drive, "zero": f"{degrees or 0.0:.12g} deg"}}
        if drive.get("zero") == JOINTS
        else {}
    )
    rest = {key: told for key, told in doc.items() if key != JOINTS}
    return {**rest, **zero, "link": links}, flaws


def _flipping(mechanism: Mechanism, raw: Mapping[int, tuple[Path, Any]]) -> Mechanism:
    """Return a mechanism whose links have the angles at which sides change that nobody has told."""

    def side(told: Mapping[str, Any], known: Side | None) -> Side | None:
        if known is not None or "flips_at" not in told:
            return known
        flips = v.ANGLES.understood(told["flips_at"], (), {}, [])
        return Side(1, flips_at=flips) if isinstance(flips, tuple) else None

    def link(one: Link) -> Link:
        told = raw[one.number][1]
        slides = tuple(
            replace(own, side=side(table, own.side))
            for own, table in zip(one.slides, slides_of(told), strict=True)
        )
        return replace(one, side=side(told, one.side), slides=slides)

    return replace(mechanism, links=tuple(map(link, mechanism.links)))


def _straight(drawn: Mechanism, near: float) -> Mechanism:
    """Return a mechanism that lies with its driven rods in line with both pins, where they nearly are."""
    bodies = drawn.by_number
    for drive in drawn.drives:
        rod = bodies.get(drive.link)
        if not drive.slides or rod is None or len(rod.slides) != 1:
            continue
        guide, cylinder = rod.slides[0].guide, bodies[rod.slides[0].on]
        pins = [_joint(one, drawn) for one in (cylinder, rod)]
        if cylinder is drawn.frame or None in pins:
            continue
        start, end = (pin for pin in pins if pin is not None)
        way = turn(guide.angle)
        if max(abs(((z - guide.through) / way).imag) for z in (start, end)) < near:
            forward = ((end - start) / way).real > 0.0
            line = replace(
                guide, through=start, angle=direction(*((start, end) if forward else (end, start)))
            )
            guides = tuple(line if one.name == guide.name else one for one in cylinder.guides)
            bodies = {
                **bodies,
                rod.number: replace(rod, slides=(replace(rod.slides[0], guide=line),)),
                cylinder.number: replace(cylinder, guides=guides),
            }
    return replace(drawn, links=tuple(bodies[one.number] for one in drawn.links))


def _joint(link: Link, drawn: Mechanism) -> complex | None:
    """Return the place of the first letter of a link that stands on another, too."""
    others = {k for one in drawn.by_number.values() if one is not link for k in one.points}
    return next((z for letter, z in link.points.items() if letter in others), None)


def _side_told(group: str, raw: Mapping[int, tuple[Path, Any]]) -> bool:
    """Whether a link of a group says its side itself."""
    links = [raw[int(number)][1] for number in group.split("-")]
    slides = [one for link in links for one in slides_of(link)]
    return any("side" in one for one in (*links, *slides))


def _turned(mechanism: Mechanism, places: Mapping[str, complex]) -> float | None:
    """Return the angle of a crank that drives first, degrees; None of what slides."""
    first = driven_pairs(mechanism)[0]
    if first.pair.kind == "P":
        return None
    return direction(places[first.pair.name], places[first.pin])


def _written(
    told: Mapping[str, Any], link: Link, hand: Joints, frame: int, listed: Collection[int]
) -> Any:
    """Return the table of a link as it stands in its own axes; of one that says these, its sides alone."""
    own, held = link_table(link, hand, frame, told), link.number in listed
    known = ("offset", "angle") if held else ()
    slides = [
        {k: x for k, x in one.items() if held or k == "side"}
        | {k: x for k, x in said.items() if k not in known or k not in one}
        for said, one in zip(slides_of(told), slides_of(own), strict=True)
    ]
    found = {"side": own["side"]} if "side" in own else {}
    found |= dict(told)
    if slides:
        found["slides"] = slides[0] if isinstance(told["slides"], dict) else slides
    return found | {k: own[k] for k in ("points", "guides") if held and k in own}
