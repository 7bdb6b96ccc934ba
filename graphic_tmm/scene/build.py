"""From the checked sections of a file to the records of a scene; the scene drawn by another hand."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace
from typing import Any

from graphic_tmm.language.units import tagged
from graphic_tmm.mechanism.records import (
    Drive,
    Extreme,
    Guide,
    Link,
    Mechanism,
    Mesh,
    Near,
    Row,
    Side,
    Slide,
    shared,
)
from graphic_tmm.scene import guides, registry
from graphic_tmm.scene import mechanism as m
from graphic_tmm.scene.checks import centres_of
from graphic_tmm.scene.declare import build
from graphic_tmm.scene.drawing import DIVISIONS
from graphic_tmm.scene.records import Scene, SheetOrder
from graphic_tmm.scene.sections import Parts
from graphic_tmm.scene.values import CLOCKWISE
from graphic_tmm.scene.weld import arms_of, one_body


def scene(parts: Parts, source: str) -> Scene:
    """Return the scene of sections in which no fault was found.

    Parameters
    ----------
    parts : Parts
        All of them understood.
    source : str
        The file they come from.
    """
    head, drive = parts.head, parts.drive
    block = parts.record("title_block")
    assert head is not None
    asked = {section.name for section, _ in parts.chapter_sections}
    usual = registry.usual(asked, mechanism=drive is not None)
    mechanism = mechanism_of(parts)
    sheets = parts.record("sheet") or [SheetOrder(place=())]
    formats = [sheet.format for sheet in sheets]
    row = _row(drive) if drive else Row()
    rest = registry.without(usual, [place for sheet in sheets for place in sheet.place])
    shown = registry.attended([sheet.place or rest for sheet in sheets], formats, asked)
    return Scene(
        source=source,
        title=head.title,
        language=tagged(head.language, head.units),
        mechanism=mechanism,
        row=row,
        tasks=_tasks(parts, mechanism, row),
        scales=parts.record("scales"),
        sheets=tuple(replace(one, place=own) for one, own in zip(sheets, shown, strict=True)),
        title_block={k: text for k, text in vars(block).items() if text and isinstance(text, str)},
        print_check=block.print_check,
        task=parts.record("task"),
        author=parts.record("note"),
        **vars(parts.record("plans")),
        **vars(parts.record("hand")),
    )


def _tasks(parts: Parts, mechanism: Mechanism | None, row: Row) -> dict[str, object]:
    """Return what the chapters are asked, by section."""
    built = _Built(parts, mechanism, row)
    return {
        section.name: built[section.name]
        for section, _ in parts.chapter_sections
        if not section.gives and (section.alone or mechanism is not None)
    }


@dataclass(frozen=True)
class _Built:
    """The records of sections, as far as they are there; each with what it has from others."""

    parts: Parts
    mechanism: Mechanism | None
    row: Row

    def __getitem__(self, name: str) -> Any:
        section, said = registry.named(name), self.parts.said.get(name)
        if section is None or said is None:
            return None
        if section.several:
            return tuple(build(section.record, one) for one in said)
        if section.together is not None:
            return section.together(tuple(build(section.record, one) for one in said))
        return build(section.record, said, **section.joined(self))


def mechanism_of(parts: Parts) -> Mechanism | None:
    """Return the mechanism of sections in which no fault was found; None if they have none."""
    links = one_body([link for link in parts.links if link is not None])
    return (
        _mechanism(parts, parts.frame, links, parts.drive) if parts.frame and parts.drive else None
    )


def _mechanism(parts: Parts, frame: m.Frame, links: list[m.Link], drive: m.Drive) -> Mechanism:
    bodies: dict[int, m.Frame | m.Link] = {link.number: link for link in links}
    bodies[frame.number] = frame
    fixed = Link(frame.number, dict(frame.points), _guides(frame.guides))
    pins = shared(body.points for body in bodies.values())
    written = [link for link in parts.links if link is not None]
    made = [
        replace(
            _link(link, bodies, frame.number),
            near=_near(link, drive),
            centre=_centre(link, pins),
            arms=arms_of(written, link.number),
        )
        for link in links
    ]
    return Mechanism(
        frame=fixed,
        links=tuple(one for one, link in zip(made, links, strict=True) if not link.passive),
        drive=_drive(drive, bodies, frame),
        further=tuple(_drive(one, bodies, frame) for one in parts.further_drives),
        passive=tuple(one for one, link in zip(made, links, strict=True) if link.passive),
        meshes=tuple(_mesh(one) for one in parts.meshes if one is not None),
    )


def _mesh(mesh: m.Mesh) -> Mesh:
    """Return two wheels in mesh as their mechanism has them."""
    (first, second), (centre, other), (size, against) = mesh.links, mesh.centres, mesh.sizes
    ends = (first, second), (centre, other), (float(size), float(against))
    return Mesh(*ends, bool(mesh.teeth), mesh.internal, mesh.phase, mesh.alpha, mesh.by)


def _drive(
    drive: m.Drive | m.FurtherDrive, bodies: Mapping[int, m.Frame | m.Link], frame: m.Frame
) -> Drive:
    """Return a drive as its mechanism has it."""
    link, start, sign = bodies.get(drive.link), 0.0, float(_sign(drive))
    slides = m.slides(drive, link if isinstance(link, m.Link) else None, frame)
    if isinstance(drive, m.FurtherDrive):
        start = drive.at
    elif (ends := _ends(drive)) and ends[-1] < ends[0]:
        sign = -1.0
    rack = drive.rack if isinstance(drive, m.Drive) and drive.rack is not None else 0.0
    rates, gains = (
        tuple(sign * one for one in m.as_row(row)) for row in (drive.speed, drive.acceleration)
    )
    return Drive(
        drive.link,
        max(rates, key=abs),
        max(gains, key=abs),
        slides and not rack,
        float(start),
        rack,
        rates if len(rates) > 1 else (),
        gains if len(gains) > 1 else (),
    )


def _ends(drive: m.Drive) -> tuple[float, ...]:
    """Return where an open row begins and ends, or all its places; nothing of a whole turn."""
    if drive.begin is not None and drive.end is not None:
        return drive.begin, drive.end
    return drive.positions if isinstance(drive.positions, tuple) else ()


def _centre(table: m.Link, pins: Collection[str]) -> str | None:
    """Return the mass centre that a link declares; of one that has a mass, else its only point in no pair."""
    found = centres_of(table, pins)
    return found[0] if len(found) == 1 else None


def _sign(drive: m.Drive | m.FurtherDrive) -> int:
    return -1 if drive.turns == CLOCKWISE else 1


def _near(table: m.Link, drive: m.Drive) -> Near | None:
    """Return which place of a plate is meant: where it says, else where the row begins if that is said."""
    if table.near is None:
        return None
    begins = (*_ends(drive), drive.zero if isinstance(drive.zero, float) else None)
    return Near(table.near, begins[0] if table.near_at is None else table.near_at)


def _guides(tables: Mapping[str, m.Guide]) -> tuple[Guide, ...]:
    return tuple(Guide(name, table.through, table.angle) for name, table in tables.items())


def _link(table: m.Link, bodies: dict[int, m.Frame | m.Link], frame: int) -> Link:
    side = Side(*table.side, flips_at=table.flips_at) if table.side else None
    return Link(
        number=table.number,
        points=dict(table.points),
        guides=_guides(table.guides),
        slides=tuple(_slide(slide, bodies, frame) for slide in table.pairs),
        name=table.name,
        mass=table.mass,
        inertia=_inertia(table),
        side=side,
        rod=table.rod,
    )


def _inertia(table: m.Link) -> float | None:
    """Return the moment of inertia of a link, kg·m²: as told, or that of a rod."""
    if table.rod is None or table.mass is None:
        return table.J
    return table.mass * table.rod**2 / 12.0


def _slide(table: m.Slide, bodies: dict[int, m.Frame | m.Link], frame: int) -> Slide:
    on = frame if isinstance(table.on, str) else table.on
    line = guides.guide(table.along, bodies[on].points, bodies[on].guides)
    side = None
    if table.side is not None:
        sign = guides.sense(table.side, line, fixed=on == frame)
        side = Side(sign, flips_at=table.flips_at)
    return Slide(on, line, table.offset, table.angle, side, table.cylinder or "")


def _row(drive: m.Drive) -> Row:
    ends = _ends(drive)
    zero = _extreme(drive.zero) if isinstance(drive.zero, m.Extreme) else drive.zero
    accelerations = drive.accelerations
    if accelerations == ("all",):
        numbers = range(drive.first, drive.first + drive.count)
        accelerations = tuple(str(number) for number in numbers)
    return Row(
        count=drive.count,
        first=drive.first,
        zero=zero,
        extra=tuple(_extra(one, zero) for one in drive.extra),
        accelerations=accelerations,
        ends=(ends[0], ends[1]) if ends and drive.begin is not None else None,
        places=drive.positions if isinstance(drive.positions, tuple) else (),
    )


def _extreme(table: m.Extreme) -> Extreme:
    return Extreme(table.point, table.at)


def _extra(written: float | str | m.Extreme, zero: float | Extreme) -> float | Extreme:
    if isinstance(written, m.Extreme):
        return _extreme(written)
    if isinstance(written, str):
        assert isinstance(zero, Extreme)
        return zero.opposite
    return written


def drawn_by(scene: Scene, hand: str | None, seed: int | None) -> Scene:
    """Return the scene drawn by another hand, with that hand's own ruler."""
    if hand is not None:
        scene = replace(scene, hand=hand, ruler=DIVISIONS[hand])
    return scene if seed is None else replace(scene, seed=seed)
