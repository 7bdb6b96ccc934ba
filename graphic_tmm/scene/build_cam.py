"""From the checked section of a cam to the record of what is asked for."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.cam.task import (
    CamOrder,
    FlatFollower,
    Follower,
    Law,
    RockerFollower,
    RollerFollower,
)
from graphic_tmm.scene.cam_tables import CamTable
from graphic_tmm.scene.faults import Found


def cam(table: CamTable) -> CamOrder:
    """Return what the section of a cam asks for."""
    moving = table.rise + table.upper_dwell + table.fall
    law = Law(table.law, table.law_points or ())
    back = Law(table.return_law or table.law, table.return_points or table.law_points or ())
    angle = 90.0 - table.transmission if table.transmission is not None else table.pressure
    return CamOrder(
        stroke=table.stroke[0],
        rise=table.rise,
        upper_dwell=table.upper_dwell,
        fall=table.fall,
        lower_dwell=table.lower_dwell if table.lower_dwell is not None else 360.0 - moving,
        rise_law=law if table.law == "diagram" else Law(table.law),
        return_law=back if back.name == "diagram" else Law(back.name),
        follower=_follower(table),
        turns=table.turns,
        pressure=30.0 if angle is None else angle,
        pressure_return=table.pressure_return,
        r0=table.r0,
        roller=table.roller,
        share_of_r0=table.share_of_r0,
        share_of_curvature=table.share_of_curvature,
        divisions=table.parts,
        base=table.base,
        height=table.height,
        mu_l=table.mu_l,
    )


def _follower(table: CamTable) -> Follower:
    if table.follower == "flat":
        return FlatFollower(table.least_curvature)
    if table.follower == "rocker":
        return RockerFollower(table.lever or 0.0, table.centres or 0.0, table.sense == "along")
    return RollerFollower(table.offset)


def check(table: CamTable) -> Iterator[Found]:
    """Every contradiction of the section."""
    rocks, unit = table.follower == "rocker", table.stroke[1]
    if rocks and unit == "m":
        yield Found(("cam", "stroke"), 'a rocker swings through an angle; write "20 deg"')
    if not rocks and unit == "rad":
        yield Found(
            ("cam", "stroke"), 'this follower moves along its guide; write a length, "28 mm"'
        )
    for name in ("lever", "centres"):
        if rocks and getattr(table, name) is None:
            yield Found(("cam", name), 'a rocker needs it; write, for example, "80 mm"')
        if not rocks and getattr(table, name) is not None:
            yield Found(("cam", name), f'the follower "{table.follower}" has none; leave it out')
    if table.pressure is not None and table.transmission is not None:
        yield Found(("cam", "transmission"), "pressure says the same; leave one of them out")
    for law, points in (("law", "law_points"), ("return_law", "return_points")):
        given = getattr(table, points) is not None
        if (
            getattr(table, law) == "diagram"
            and not given
            and not (points == "return_points" and table.law_points)
        ):
            yield Found(("cam", points), "the law diagram needs points, [[0, 0], [0.25, 1], ...]")
        if given and getattr(table, law) not in ("diagram", None):
            yield Found(("cam", points), f'only {law} = "diagram" takes points; leave them out')
