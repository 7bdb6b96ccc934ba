"""What a file says against itself, and is refused; what comes to nothing, and is only remarked."""

from __future__ import annotations

import cmath
import math
from collections.abc import Collection, Iterator, Mapping, Sequence
from itertools import chain
from pkgutil import resolve_name
from typing import Any

from graphic_tmm.board.bounds import TaskError
from graphic_tmm.language.said import joined, said
from graphic_tmm.mechanism.masses import free_points
from graphic_tmm.mechanism.records import shared
from graphic_tmm.scene import guides, mechanism, registry
from graphic_tmm.scene.chapter import chapters, places
from graphic_tmm.scene.coordinates import OTHER_EXTREME
from graphic_tmm.scene.declare import Flaw, Path, Said, Section, build
from graphic_tmm.scene.document import as_table
from graphic_tmm.scene.drive_checks import end_faults, motion_faults
from graphic_tmm.scene.mechanism import Drive, Extreme, FurtherDrive, Link, Slide
from graphic_tmm.scene.meshes import mesh_faults
from graphic_tmm.scene.passive import passive_faults
from graphic_tmm.scene.records import Scene
from graphic_tmm.scene.registry import called, of_section, sections
from graphic_tmm.scene.sections import Parts, pairing
from graphic_tmm.scene.units import SI
from graphic_tmm.scene.weld import weld_faults


def contradictions(parts: Parts) -> Iterator[Flaw]:
    """Every contradiction in the sections that could be understood."""
    if parts.frame is not None:
        yield from _places(("frame",), parts.frame.points)
    bodies = [body.points for body in (parts.frame, *parts.links) if body is not None]
    pins = shared(bodies)
    for path, link in pairing(parts.links, "link"):
        centres = centres_of(link, pins)
        yield from _places((*path, "points"), link.points, set(centres) - pins)
        if any(section.weighs for section, _ in parts.chapter_sections):
            yield from _masses(path, link, centres)
        yield from _rod(path, link)
        yield from _flips(path, link)
        for at, slide in slides_of(path, link):
            yield from _flips(at, slide)
            yield from _sense(at, slide, parts)
    yield from weld_faults(parts)
    yield from passive_faults(parts)
    yield from mesh_faults(parts)
    plans, scales = parts.said["plans"], parts.said["scales"]
    if parts.drive is not None:
        yield from _row(parts.drive, [*parts.names.moving])
        several = isinstance(parts.doc.get("drive"), list)
        drives: list[Drive | FurtherDrive] = [parts.drive, *parts.further_drives]
        for k, drive in enumerate(drives):
            yield from motion_faults(("drive", k) if several else ("drive",), drive, parts)
        if plans is not None and plans.main is not None:
            yield from _position(parts.drive, ("plans", "main"), plans.main)
    if scales is not None:
        yield from _scales(scales)
    yield from _units(parts)
    for section, told in parts.chapter_sections:
        faults = list(section.check(told, parts))
        yield from faults or _refused(section, told)
    yield from _placed(parts)


def _units(parts: Parts) -> Iterator[Flaw]:
    """Sections whose sizes are told in mm, in a scene of feet and pounds."""
    for section, _ in parts.chapter_sections:
        if section.metric and parts.head is not None and parts.head.units != SI:
            says = said(
                'the sizes of [{section}] are told in mm; write units = "{si}", or give it a scene of its own',
                section=section.name,
                si=SI,
            )
            yield Flaw(("units",), says)


def _refused(section: Section, told: Any) -> Iterator[Flaw]:
    """Yield what the plan of a part refuses of its task, before anything is drawn."""
    if not section.refuse:
        return
    try:
        resolve_name(section.refuse)(build(section.record, told))
    except TaskError as error:
        yield Flaw(error.key, error.says)


def _placed(parts: Parts) -> Iterator[Flaw]:
    """A sheet that places what the scene does not ask for."""
    asked = [(place, one) for one in registry.sections() for place in of_section(one)]
    sheets = parts.doc.get("sheet")
    for i, sheet in enumerate(sheets if isinstance(sheets, list) else []):
        places = as_table(sheet).get("place")
        for place, section in asked:
            if isinstance(places, list) and place in places and section.name not in parts.doc:
                says = said(
                    '"{place}": nothing says what it is; write a section [{section}] with {begin}',
                    place=place,
                    section=section.name,
                    begin=section.begin,
                )
                yield Flaw(("sheet", i, "place"), says)


def slides_of(path: Path, link: Link) -> list[tuple[Path, Slide]]:
    """Return the sliding pairs of a link, each with its path."""
    if isinstance(link.slides, Slide):
        return [((*path, "slides"), link.slides)]
    return [((*path, "slides", i), slide) for i, slide in enumerate(link.slides)]


def _places(
    path: Path, points: Mapping[str, complex], centres: Collection[str] = ()
) -> Iterator[Flaw]:
    """Two letters of one link at one place; a mass centre that is no pin may lie on another letter."""
    cells: dict[tuple[int, int], list[tuple[str, complex]]] = {}
    for letter, place in points.items():
        if letter in centres or not cmath.isfinite(place):
            continue
        x, y = (math.floor(size / mechanism.SAME_PLACE) for size in (place.real, place.imag))
        about = (cells.get((x + i, y + k), ()) for i in (-1, 0, 1) for k in (-1, 0, 1))
        for first, other in chain.from_iterable(about):
            if abs(place - other) < mechanism.SAME_PLACE:
                says = said(
                    "{first} and {letter} lie at the same place, so the length {first}{letter} is zero; "
                    "move one, or use one letter for both",
                    first=first,
                    letter=letter,
                )
                yield Flaw((*path, letter), says)
                break
        else:
            cells.setdefault((x, y), []).append((letter, place))


def centres_of(link: Link, pins: Collection[str]) -> tuple[str, ...]:
    """Return the mass centre of a link; where a mass has none, the points that may be meant: in no pair."""
    if link.centre is not None or not link.mass:
        return (link.centre,) if link.centre is not None else ()
    return free_points(link.points, pins)


def _masses(path: Path, link: Link, centres: tuple[str, ...]) -> Iterator[Flaw]:
    """A mass without its centre, where more than one point may be meant."""
    if link.centre is None and len(centres) > 1:
        says = said(
            "it is missing, and link {number} has a mass; no letter is a mass centre by itself: write "
            "{listed}",
            number=link.number,
            listed=joined(said(" or "), (f'centre = "{letter}"' for letter in centres)),
        )
        yield Flaw((*path, "centre"), says)


def _rod(path: Path, link: Link) -> Iterator[Flaw]:
    """A rod that has no mass, or a J of its own."""
    if link.rod is None:
        return
    if not link.mass:
        yield Flaw((*path, "rod"), said("the J of a rod is m·l²/12: give its mass, too"))
    if link.J is not None:
        yield Flaw((*path, "rod"), said("J is given, too: leave one of the two out"))


def _flips(path: Path, owner: Link | Slide) -> Iterator[Flaw]:
    if owner.flips_at and owner.side is None:
        yield Flaw((*path, "flips_at"), said('it needs a side to flip; write "side" as well'))


def _sense(path: Path, slide: Slide, parts: Parts) -> Iterator[Flaw]:
    """Whether the word for the side tells the two senses of the guide apart."""
    frame = parts.frame
    if slide.side is None or frame is None:
        return
    fixed = slide.on in ("frame", frame.number)
    owners = [link for link in parts.links if link is not None and link.number == slide.on]
    owner = frame if fixed else owners[0] if owners else None
    if owner is None:
        return
    try:
        line = guides.guide(slide.along, owner.points, owner.guides)
    except (KeyError, ValueError):
        return
    try:
        guides.sense(slide.side, line, fixed=fixed)
    except ValueError as error:
        yield Flaw((*path, "side"), error.args[0])


def _row(drive: Drive, moving: Sequence[str]) -> Iterator[Flaw]:
    """Positions named for acceleration plans, and extras, that the row does not have."""
    extreme = isinstance(drive.zero, Extreme)
    if OTHER_EXTREME in drive.extra and not extreme:
        says = said(
            'the other extreme of what? write zero = {{ point = "{point}", at = "left" }}',
            point=moving[-1] if moving else "D",
        )
        yield Flaw(("drive", "extra"), says)
    yield from end_faults(drive)
    if drive.accelerations == ("all",):
        return
    for i, name in enumerate(drive.accelerations):
        path: Path = ("drive", "accelerations", i)
        yield from _position(drive, path, name)
        if name in drive.accelerations[:i]:
            yield Flaw(path, said("position {name} is named twice; leave one out", name=name))


def _position(drive: Drive, path: Path, name: str) -> Iterator[Flaw]:
    """A position named that the row does not have."""
    last = drive.first + drive.count - 1
    if not drive.first <= int(name.rstrip("*")) <= last:
        says = said(
            "there is no position {name}; the row goes from {first} to {last}",
            name=name,
            first=drive.first,
            last=last,
        )
        yield Flaw(path, says)
    elif name.endswith("*") and not drive.extra:
        says = said(
            'there is no position {name}; name it first, extra = ["other extreme"]', name=name
        )
        yield Flaw(path, says)


def _scales(scales: Said) -> Iterator[Flaw]:
    for factor, drawn in (("mu_l", "OA"), ("mu_v", "pa"), ("mu_a", "pi_a")):
        if getattr(scales, factor) is not None and getattr(scales, drawn) is not None:
            says = said(
                "{drawn} and {factor} both fix the same scale; leave one of them out",
                drawn=drawn,
                factor=factor,
            )
            yield Flaw(("scales", drawn), says)


GAINED = "accelerations"
"""The plans that [drive] calls for at the positions that it names."""


def remarks(parts: Parts) -> tuple[str, ...]:
    """Return, one line each, the sections that nothing reads, and the defaults that matter."""
    there = list(parts.chapter_sections)
    idle = [line for section, told in there for line in section.idle(told, parts)]
    centres = _centres(parts) if any(section.weighs for section, _ in there) else ()
    defaults = [line for section, told in there for line in section.defaults(told, parts)]
    return (*idle, *_unsaid(parts), *centres, *defaults)


def _unsaid(parts: Parts) -> Iterator[str]:
    """Tell of words for chapters that the scene does not call for."""
    note = parts.said["note"]
    asked = {section.name for section, _ in parts.chapter_sections}
    there = [one for one in chapters() if called(one, asked, mechanism=parts.drive is not None)]
    names = {one.name for one in there} | {name for one in there for name in one.builds_on}
    for name in note.remarks if note is not None else ():
        if name not in names:
            yield said(
                "note.remarks.{name}: the scene asks for nothing of this chapter, so the note has no "
                "section for it",
                name=name,
            )


def _centres(parts: Parts) -> Iterator[str]:
    pins = shared(body.points for body in (parts.frame, *parts.links) if body is not None)
    bare = [link for link in parts.links if link is not None and link.centre is None]
    lone = {link.number: found[0] for link in bare if len(found := centres_of(link, pins)) == 1}
    if lone:
        first, letter = next(iter(lone.items()))
        numbers, letters = ", ".join(map(str, lone)), ", ".join(lone.values())
        yield said(
            "centre: it is left out of link {numbers}, so the link's only point in no pair is taken for its "
            'mass centre: {letters}; write centre = "{letter}" in link {first}',
            numbers=numbers,
            letters=letters,
            letter=letter,
            first=first,
        )


def unplaced(scene: Scene) -> tuple[str, ...]:
    """Return, one line each, what the scene calls for and no sheet of it shows."""
    return tuple(_unplaced(scene))


def _unplaced(scene: Scene) -> Iterator[str]:
    there = [section for section in sections() if section.name in scene.tasks]
    seen = [section for section in there if scene.shown_places & set(of_section(section))]
    shown = {name for section in seen for name in section.shows(scene.tasks[section.name])}
    for section in there:
        if section in seen or section.name in shown or not of_section(section):
            continue
        yield said(
            "{section}: no sheet shows it (table does); add {listed} to the place of a [[sheet]]",
            section=section.name,
            listed=joined(said(" or "), (f'"{place}"' for place in of_section(section))),
        )
    there_too = {name: one for name, (_, one) in places().items()}
    gained = {name for name, one in there_too.items() if GAINED in (*one.shows, *one.beside)}
    if scene.mechanism is not None and not scene.mechanism.moves:
        if scene.row.accelerations:
            yield said(
                "drive.{plans}: it stands, and nothing has an acceleration; leave it out, or give the drive an "
                "acceleration",
                plans=GAINED,
            )
        return
    if scene.row.accelerations and not scene.shown_places & {GAINED, *gained}:
        yield said(
            'drive.{plans}: no sheet shows them (table does); add "{plans}" to the place of a [[sheet]]',
            plans=GAINED,
        )
    # other places show more than these plans
    only = {GAINED, *(name for name, one in there_too.items() if one.shows == (GAINED,))}
    if not scene.row.accelerations and (empty := sorted(scene.shown_places & only)):
        yield said(
            "{places}: nothing is there to be shown, for no position has a plan of accelerations; add "
            'accelerations = "all" to [drive], or the positions that are to have one',
            places=", ".join(empty),
        )
