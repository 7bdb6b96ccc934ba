"""What the section of an indicator diagram, or of several, says against itself and the mechanism."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

from graphic_tmm.chapters.indicator.task import (
    INDICATOR,
    ONE_TURN,
    SIDES,
    TURN,
    IndicatorTask,
    Stroke,
    by_turns,
    together,
)
from graphic_tmm.language.said import said
from graphic_tmm.scene import values as v
from graphic_tmm.scene.declare import Flaw, Path, Said, Section, keys_of
from graphic_tmm.scene.document import as_table
from graphic_tmm.scene.tables import missing_key

if TYPE_CHECKING:
    from graphic_tmm.scene.sections import Parts


def check(asked: list[tuple[Path, Said]], parts: Parts) -> Iterator[Flaw]:
    """Every contradiction of the section, and of the cylinders among themselves."""
    points = [one.point for _, one in asked]
    for k, (path, one) in enumerate(asked):
        if one.point in points[:k]:
            says = said(
                "there is a cylinder of {point} already; name another piston", point=one.point
            )
            yield Flaw((*path, "point"), says)
        elif one.same_as is None:
            yield from _cylinder(path, one, parts)
        else:
            yield from _another(path, one, asked, parts)
        if one.strokes != asked[0][1].strokes and one.same_as is None:
            says = said(
                "cylinders of one crank have as many strokes; write strokes = {n}",
                n=asked[0][1].strokes,
            )
            yield Flaw((*path, "strokes"), says)
        yield from _phase(path, one, asked)


def _another(path: Path, one: Said, asked: list[tuple[Path, Said]], parts: Parts) -> Iterator[Flaw]:
    """A cylinder with the pressures of one that has none by the strokes, or with some of its own."""
    yield from parts.moves((*path, "point"), one.point)
    of = next((other for _, other in asked if other.point == one.same_as), None)
    if of is None or of is one or of.same_as is not None:
        says = said(
            'no cylinder of "{point}" has pressures of its own; name the piston of one that has',
            point=one.same_as[:20],
        )
        yield Flaw((*path, "same_as"), says)
    elif of.cover is not None or of.shaft is not None:
        says = said(
            "the pressures of {point} stand position by position, and this piston stands elsewhere in each; "
            "give them there by cover_points or cover_strokes",
            point=of.point,
        )
        yield Flaw((*path, "same_as"), says)
    for name in (*_PRESSURE_KEYS, "rod", "strokes", "clearance"):
        if name in _raw(path, parts):
            says = said("same_as gives it already; leave one of them out")
            yield Flaw((*path, name), says)


_PRESSURE_KEYS = tuple(f"{side}{how}" for side in SIDES for how in ("", "_points", "_strokes"))


def _raw(path: Path, parts: Parts) -> Mapping[str, object]:
    """Return the table of a cylinder as the file has it."""
    found: Any = parts.doc
    for part in path:
        found = found[part]
    return as_table(found)


def _phase(path: Path, one: Said, asked: list[tuple[Path, Said]]) -> Iterator[Flaw]:
    """A cycle that begins at no dead centre, or later than it is over; of pressures that have their places."""
    of = next((other for _, other in asked if other.point == one.same_as), one)
    if one.phase and (of.cover is not None or of.shaft is not None):
        says = said(
            "pressures that stand position by position have their places; leave the phase out"
        )
        yield Flaw((*path, "phase"), says)
    elif one.phase % TURN or not 0.0 <= one.phase < TURN * (of.strokes // 2):
        says = said(
            "a cycle begins at a dead centre of its own piston: write 0 deg, or 360 deg where it has four "
            "strokes"
        )
        yield Flaw((*path, "phase"), says)


def _cylinder(path: Path, asked: Said, parts: Parts) -> Iterator[Flaw]:
    """Every contradiction of a cylinder: pressures told twice or not at all, a rod without its side."""
    yield from parts.moves((*path, "point"), asked.point)
    if asked.bore is None:
        yield Flaw((*path, "bore"), missing_key("bore", keys_of(IndicatorTask)["bore"]))
    turns = asked.strokes // 2
    count = parts.drive.count * turns if parts.drive is not None else None
    yield from _cycle(path, asked, parts)
    for side in SIDES:
        told = [k for k in (side, f"{side}_points", f"{side}_strokes") if getattr(asked, k)]
        for other in told[1:]:
            says = said(
                "{key} gives the pressures of that side already; leave one of them out", key=told[0]
            )
            yield Flaw((*path, other), says)
        if side == "cover" and not told:
            says = said(
                'it is missing; write the pressures, ["300 kPa", ...], or cover_points, or cover_strokes'
            )
            yield Flaw((*path, "cover"), says)
        yield from _turns(path, asked, side)
        yield from _strokes(path, asked, side)
        given = getattr(asked, side)
        if given is not None and count is not None and len(given) != count:
            says = said(
                "{n} pressures for {count} positions; give one for each, from the first on",
                n=len(given),
                count=count,
            )
            yield Flaw((*path, side), says)
    others = asked.shaft or asked.shaft_points or asked.shaft_strokes
    if asked.rod is not None and not others:
        says = said("it matters on the side of the shaft only; write shaft as well")
        yield Flaw((*path, "rod"), says)
    if asked.rod is not None and asked.bore is not None and asked.rod >= asked.bore:
        says = said("the rod is as thick as the cylinder; make it thinner")
        yield Flaw((*path, "rod"), says)


def _cycle(path: Path, asked: Said, parts: Parts) -> Iterator[Flaw]:
    """A number of strokes that no cycle has, or that other sections cannot be drawn over."""
    if asked.strokes % 2:
        says = said("a working cycle has 2 strokes or 4; write one of these")
        yield Flaw((*path, "strokes"), says)
    for other in ONE_TURN:
        if asked.strokes == 4 and other in parts.doc:
            says = said(
                "four strokes take two turns, and the graphs of [{other}] go over one; give it a scene of "
                "its own",
                other=other,
            )
            yield Flaw((*path, "strokes"), says)


def _turns(path: Path, asked: Said, side: str) -> Iterator[Flaw]:
    """Points that do not go from the cover to the far end and back."""
    traced = getattr(asked, f"{side}_points")
    if traced is None:
        return
    for name in ("out_2", "back_2"):
        if (getattr(traced, name) is not None) != (asked.strokes == 4):
            says = (
                said("four strokes have it, too; write its points")
                if asked.strokes == 4
                else said("only a cycle of four strokes has it; write strokes = 4, or leave it out")
            )
            yield Flaw((*path, f"{side}_points", name), says)
    for name, way, points in traced.strokes():
        ends = (0.0, 1.0) if way == "out" else (1.0, 0.0)
        shares = [share for share, _ in points]
        ahead = v.follows(shares if way == "out" else [-share for share in shares])
        if (shares[0], shares[-1]) != ends or not ahead:
            says = said(
                "the shares of the stroke {way} go from {first:g} to {last:g}, one after the other; put them "
                "in order, two at a jump",
                way=way,
                first=ends[0],
                last=ends[1],
            )
            yield Flaw((*path, f"{side}_points", name), says)


def _strokes(path: Path, asked: Said, side: str) -> Iterator[Flaw]:
    """Polytropic parts that do not go from the cover to the far end and back."""
    strokes = getattr(asked, f"{side}_strokes")
    turns, before = by_turns(strokes, asked.strokes // 2), 0
    for parts in turns:
        yield from _of_turn(path, parts, side, before)
        before += len(parts)
    if strokes and asked.strokes == 4 and len(turns) != 2:
        says = said(
            "four strokes are wanted, one after the other: out, back, out and back again; there are {n}",
            n=2 * len(turns),
        )
        yield Flaw((*path, f"{side}_strokes"), says)
    if any(part.n > 0 for part in strokes) and not asked.clearance > 0:
        says = said(
            "gas that is expanded or compressed needs the clearance; write clearance = 0.08"
        )
        yield Flaw((*path, "clearance"), says)


def _of_turn(path: Path, parts: list[Stroke], side: str, before: int) -> Iterator[Flaw]:
    """The same of the parts of one turn; so many stand ``before`` them."""
    reached = {"out": 0.0, "back": 1.0}
    for i, part in enumerate(parts, before):
        if (part.to - reached[part.stroke]) * (1 if part.stroke == "out" else -1) <= 0:
            says = said(
                "the stroke {way} has come to {share:g} already; go on from there",
                way=part.stroke,
                share=reached[part.stroke],
            )
            yield Flaw((*path, f"{side}_strokes", i, "to"), says)
        reached[part.stroke] = part.to
    if parts and reached != {"out": 1.0, "back": 0.0}:
        says = said(
            "the parts of the stroke out have to end at 1, those of the stroke back at 0; add the last part"
        )
        yield Flaw((*path, f"{side}_strokes"), says)


def _idle(asked: Said, parts: Parts) -> Iterator[str]:
    effects, doc = parts.said["effects"], parts.doc
    gas = effects is not None and effects.gas and "forces" in doc
    if not (gas or any(name in doc for name in ("flywheel", "engine", "motion_law"))):
        yield said(
            "indicator: nothing asks for the gas; add [flywheel] or [engine], or gas = true in [effects] with "
            "[forces], or take [indicator] out"
        )


SECTIONS = (
    Section(
        INDICATOR, IndicatorTask, "the indicator diagram of a cylinder",
        together=together, alone=True, gives=True, check=check, idle=_idle,
    ),
)  # fmt: skip
