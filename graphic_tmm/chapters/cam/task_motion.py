"""What is asked of the follower's motion: the law of a phase and how far it goes; several lifts in one turn."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import accumulate, chain
from pkgutil import resolve_name
from typing import Any

from graphic_tmm.board.bounds import POSITIVE, Bound, TaskError
from graphic_tmm.chapters.cam.kinds import PLATE, TABLES
from graphic_tmm.language.said import said
from graphic_tmm.scene import quantities
from graphic_tmm.scene import values as v
from graphic_tmm.scene.declare import Flaw, Key, Kind, Names, Path, Said, combined_key, key
from graphic_tmm.scene.misfits import fault_in_list, stands
from graphic_tmm.scene.tables import missing_key

TURN, SAME = 360.0, 1e-6
"""A turn, degrees; angles (degrees), and strokes by a share of themselves, that differ by less are the same."""
SHARED, EVEN_SHARES = "constant acceleration", (1.0, 1.0)
"""The law whose shares of speeding up and of slowing down may be told; these, if they are not."""
UNSAID = (0.0, 0.0)
"""Shares of a phase that has none of its own: those of the cam, if it has its law, else even ones."""
BY_DIAGRAM = "diagram"
"""The law that is given by points of its acceleration diagram."""
BY_TABLE = "table"
"""The law that is given by a table of displacements."""
BY_POINTS = (BY_DIAGRAM, BY_TABLE)
"""Laws whose diagrams go through points that are known at the positions only."""


RETURN, MIRRORED, AS_GIVEN = "return", "mirrored", "given"
"""The key that tells how the diagram of the return is meant: the rise run backwards, or by the sign of S″."""
USUAL = (
    *("rise", "upper_dwell", "fall", "lower_dwell"),
    *("return_law", "return_points", "return_table", RETURN),
)
"""Keys of a cam with one lift."""


def drawn_laws() -> dict[str, Any]:
    """Return the laws that have a file among ``laws``, by name: they stand above what is asked of a cam."""
    found: dict[str, Any] = resolve_name("graphic_tmm.chapters.cam.laws:laws")()
    return found


def names() -> tuple[str, ...]:
    """Return the laws of motion."""
    return (*drawn_laws(), BY_DIAGRAM)


def _words() -> dict[str, str]:
    """Return what a law may be called in a scene, and its name."""
    others = {word: law.name for law in drawn_laws().values() for word in law.also}
    return {name: name for name in names()} | others


@dataclass(frozen=True)
class Law:
    """How the follower moves over one phase: one of `names`.

    ``points`` of the law "diagram": (share of the phase, acceleration), in the order of time, joined by
    straight lines; the acceleration is positive while the follower speeds up, on the return too, in any unit,
    for its scale follows from the stroke. Points with one share make a jump, from the first to the last.
    ``points`` of the law "table": (share of the phase, share of the stroke) from the lower place;
    ``size``: how long (degrees, m) and how high (m, or rad) it is as written; ``digit``: one of the last
    digit of its figures, a share of the stroke; ``ends``: of one that was read off a spline its slopes there.
    ``shares``: of speeding up and of slowing down, in proportion, of a law of constant acceleration.
    """

    name: str
    points: tuple[tuple[float, float], ...] = ()
    shares: tuple[float, float] = EVEN_SHARES
    size: tuple[float, ...] = ()
    digit: float = field(default=0.0, compare=False)
    ends: tuple[float, float] | None = field(default=None, compare=False)

    @property
    def split(self) -> float:
        """The share of the phase after which the follower slows down."""
        return self.shares[0] / sum(self.shares)


def _stroke(value: object, names: Names | None = None) -> float:
    """Return a stroke in m, or in rad for a rocking follower."""
    if quantities.is_a(value, "angle"):
        return math.radians(quantities.parse(value, "angle"))
    return quantities.parse(value, "length")


def _points(value: object, names: Names) -> tuple[tuple[float, float], ...]:
    if not isinstance(value, list) or len(value) < 2:
        raise ValueError(
            stands(value, said("write points of the acceleration, [[0, 0], [0.25, 1], ...]"))
        )
    found = []
    for item in value:
        plain = isinstance(item, list) and len(item) == 2
        if not plain or not all(
            isinstance(x, (int, float)) and not isinstance(x, bool) for x in item
        ):
            raise ValueError(
                fault_in_list(item, said("a point is a share of the phase and a number, [0.25, 1]"))
            )
        found.append((float(item[0]), float(item[1])))
    return tuple(found)


def _table(value: object, names: Names) -> tuple[tuple[float, ...], ...]:
    """Return lines of a table: extent, displacement (m, or rad), one of the last digit of both.

    The extent: degrees of a cam that turns, m of one that slides.
    """
    if not isinstance(value, list) or not value:
        says = said('write lines of the table, [["0 deg", "0 mm"], ["10 deg", "0.8 mm"], ...]')
        raise ValueError(stands(value, says))
    found = []
    for item in value:
        if not isinstance(item, list) or len(item) != 2:
            says = said('a line is an angle and a displacement, ["10 deg", "0.8 mm"]')
            raise ValueError(fault_in_list(item, says))
        digits = [quantities.last_digit(one) for one in item]
        rows = ((_along(a), _stroke(high)) for a, high in (item, digits))
        found.append(tuple(chain.from_iterable(rows)))
    return tuple(found)


def _along(value: object) -> float:
    return quantities.parse(value, "length" if quantities.is_a(value, "length") else "angle")


def law_of(table: Sequence[tuple[float, ...]], *, own: bool = True) -> Law:
    """Return the law that a table gives, from its lower place: of a fall backwards.

    ``table``: lines of an extent, a displacement, and one of the last digit of both. ``own``: it is the phase's
    own; else another phase takes it as long, and as high, as that is itself.
    """
    lines = [(one[0] - table[0][0], *one[1:]) for one in table]
    if lines[0][1] > lines[-1][1]:
        lines = [(lines[-1][0] - one[0], *one[1:]) for one in reversed(lines)]
    long, high = lines[-1][:2]
    digit = min((one for line in lines for one in line[3:]), default=0.0) / (high or 1.0)
    even = [long * k / (len(lines) - 1 or 1) for k in range(len(lines))]
    if all(
        2.0 * abs(line[0] - due) <= sum(line[2:3]) for line, due in zip(lines, even, strict=True)
    ):
        # a third of 10° was written 3.33°
        lines = [(due, *line[1:]) for line, due in zip(lines, even, strict=True)]
    points = tuple(
        (round(angle / (long or 1.0), 12), height / (high or 1.0)) for angle, height, *_ in lines
    )
    return Law(BY_TABLE, points, size=(long, high) if own else (), digit=digit)


def _shares(value: object, names: Names) -> tuple[float, float]:
    plain = isinstance(value, list) and len(value) == 2
    if not plain or not all(POSITIVE.holds(one) for one in value):  # type: ignore[attr-defined]
        says = said("write the shares of speeding up and of slowing down, [2, 1]")
        raise ValueError(stands(value, says))
    return float(value[0]), float(value[1])  # type: ignore[index]


SHARES = Kind(_shares, {"type": "array"})
STROKE = Kind(_stroke, v.SCALE, POSITIVE, "length, or angle")
POINTS = Kind(_points, {"type": "array"})
TABLE = Kind(_table, {"type": "array"})


def _extent(bound: Bound) -> Kind:
    """Return the kind of a phase: its angle (degrees), or its length on a cam that slides (m)."""
    angle, long = v.number(bound, "angle"), v.number(replace(bound, most=math.inf), "length")

    def read(value: object, names: Names) -> Any:
        return (long if quantities.is_a(value, "length") else angle).read(value, names)

    return replace(angle, read=read, unit="length, or angle")


MOVING, DWELL = _extent(Bound(0, 360, above=True, below=True)), _extent(Bound(0, 360, below=True))
LAW = v.choice_of(_words)
"""Values of the keys of a cam."""


NO_LINES = said('the law table needs its lines, [["0 deg", "0 mm"], ["10 deg", "0.8 mm"], ...]')
EXAMPLE = [["0 deg", "0 mm"], ["10 deg", "0.8 mm"]]


def _own_law(said: Said) -> Law | None:
    name = said.law or (BY_DIAGRAM if said.law_points else SHARED if said.shares else None)
    if said.law_table:
        return replace(law_of(said.law_table), name=name or BY_TABLE)
    return None if name is None else Law(name, said.law_points or (), said.shares or UNSAID)


@dataclass(frozen=True)
class Stage:
    """A phase of a cam with several lifts in a turn: a rise, a dwell or a fall (angles in degrees).

    ``stroke``: how far the follower rises or falls (m, or rad for a rocker), and the ``law`` by which: those of
    the cam where they are left out.
    """

    rise: float | None = key(MOVING, "the angle over which the follower rises", "60 deg", None)
    dwell: float | None = key(MOVING, "or over which it rests", "30 deg", None)
    fall: float | None = key(MOVING, "or over which it falls", "90 deg", None)
    stroke: float | None = key(
        STROKE, "how far it rises or falls, if not by the stroke of the cam", "15 mm", None
    )
    law: Law | None = combined_key(
        _own_law,
        None,
        law=key(LAW, "the law of motion, if it is not that of the cam", "cosine", None),
        law_points=key(POINTS, "points of its acceleration diagram", [[0, 0], [0.25, 1]], None),
        shares=key(SHARES, "shares of its constant acceleration", [2, 1], None),
        law_table=key(
            TABLE,
            "or its table: angle in the phase, displacement above its lower place",
            EXAMPLE,
            None,
        ),
    )

    @property
    def angle(self) -> float:
        """How long it is, degrees."""
        return (self.rise or 0.0) + (self.dwell or 0.0) + (self.fall or 0.0)

    @property
    def sign(self) -> int:
        """1 of a rise, 0 of a dwell, −1 of a fall."""
        return 1 if self.rise is not None else -1 if self.fall is not None else 0

    @property
    def lift(self) -> float:
        """How much higher the follower stands behind it."""
        return self.sign * (self.stroke or 0.0)


def levels(phases: Sequence[Stage]) -> list[float]:
    """Return how high the follower stands above its lowest place before each phase, and behind the last.

    Places that a turn may be open by, see `refuse_phases`, are one.
    """
    found, near = list[float](), SAME * sum(abs(one.lift) for one in phases)
    for high in accumulate((one.lift for one in phases), initial=0.0):
        found.append(next((one for one in found if abs(one - high) <= near), high))
    return [round(high - min(found), 12) for high in found]


WRONG_WAY = {
    1: said("the table of a rise goes up, from 0 to the stroke: write its lines the other way round"),
    -1: said("the table of a return goes down, from the stroke to 0: write its lines the other way round"),
}  # fmt: skip


def stroke_faults(
    cam: Said, told: Mapping[str, Any], rocks: bool, keys: Mapping[str, Key]
) -> Iterator[Flaw]:
    """Yield what is wrong with the keys of the phases, and with strokes of the other kind of follower, or way.

    ``told``: the section as it is written; ``keys`` of it.
    """
    for name in USUAL if cam.phase else ("stroke", "rise", "fall"):
        if cam.phase and name in told:
            says = said("the phases of [[cam.phase]] tell it: leave it out")
            yield Flaw(("cam", name), says)
        elif not cam.phase and name not in told and (name != "fall" or cam.form != PLATE):
            yield Flaw(("cam", name), missing_key(name, keys[name]))
    sections: dict[Path, Any] = {("cam",): told}
    sections |= {("cam", "phase", k): one for k, one in enumerate(told.get("phase", ()))}
    for path, one in sections.items():
        rows = {name: [high for _, high in one[name]] for name in TABLES if name in one}
        rows |= {"stroke": [one["stroke"]]} if "stroke" in one else {}
        for name, highs in rows.items():
            way = -1 if name == "return_table" or ("fall" in one and path != ("cam",)) else 1
            # a table may say 0 without its unit
            if any(rocks != quantities.is_a(high, "angle") for high in highs if high != 0):
                wants = (
                    said('a rocker swings through an angle; write "20 deg"')
                    if rocks
                    else said('this follower moves along its guide; write a length, "28 mm"')
                )
                yield Flaw((*path, name), wants)
            elif way * _stroke(highs[0]) > way * _stroke(highs[-1]):
                yield Flaw((*path, name), WRONG_WAY[way])


def refuse_phases(phases: Sequence[Stage], *, rocks: bool, slides: bool = False) -> None:
    """Refuse phases that are none, do not make a turn, or do not come back to where they began.

    Raises
    ------
    TaskError
        Which says what to change.
    """
    for k, one in enumerate(phases, 1):
        told = [name for name in ("rise", "dwell", "fall") if getattr(one, name) is not None]
        for wrong, says in (
            (len(told) != 1 or one.angle <= 0.0,
             said("phase {k} is one of rise, dwell, fall: write one of them", k=k)),
            (one.sign == 0 and (one.stroke is not None or one.law is not None),
             said("in phase {k} the follower rests: leave its stroke and its law out", k=k)),
            (one.sign != 0 and not (one.stroke or 0.0) > 0.0,
             said('phase {k} needs a stroke greater than 0: write, for example, stroke = "20 mm"', k=k)),
        ):  # fmt: skip
            if wrong:
                raise TaskError("cam", "phase", says)
    turn, rises, falls = (
        sum(one.angle for one in phases),
        *(sum(one.stroke or 0.0 for one in phases if one.sign == sign) for sign in (1, -1)),
    )
    if not slides and abs(turn - TURN) > SAME:
        says = said(
            "the phases make {sum:g}°, not 360°: {way} them by {rest:g}°",
            sum=turn, way=said("lengthen") if turn < TURN else said("shorten"), rest=abs(TURN - turn),
        )  # fmt: skip
        raise TaskError("cam", "phase", says)
    if not rises + (0.0 if slides else falls):
        raise TaskError("cam", "phase", said("the follower rises nowhere: write a phase with rise"))
    if not slides and abs(rises - falls) > SAME * max(rises, falls):
        says = said(
            "over a turn the follower rises by {rises} and falls by {falls}: it has to come back to where "
            "it began, so change a stroke by {rest}",
            rises=size_of(rises, rocks), falls=size_of(falls, rocks), rest=size_of(abs(rises - falls), rocks),
        )  # fmt: skip
        raise TaskError("cam", "phase", says)


def size_of(stroke: float, rocks: bool) -> str:
    """Return a stroke with its unit."""
    if rocks:
        return f"{math.degrees(stroke):g}°"
    return said("{length:g} mm", length=1000.0 * stroke)


def law_faults(cam: Said) -> Iterator[Flaw]:
    """Yield a law without its points or table, and what belongs to another law.

    ``cam``: what a scene says of it.
    """
    yield from _tables(cam)
    for law, points in (("law", "law_points"), ("return_law", "return_points")):
        given, name = getattr(cam, points) is not None, getattr(cam, law)
        others = points == "return_points" and cam.law_points
        if name == BY_DIAGRAM and not given and not others:
            says = said("the law diagram needs points, [[0, 0], [0.25, 1], ...]")
            yield Flaw(("cam", points), says)
        if given and name not in (BY_DIAGRAM, None):
            says = said('only {law} = "diagram" takes points; leave them out', law=law)
            yield Flaw(("cam", points), says)
    for law, shares in (("law", "shares"), ("return_law", "return_shares")):
        if getattr(cam, shares) is not None and (getattr(cam, law) or cam.law) != SHARED:
            says = said('only {law} = "constant acceleration" has shares; leave them out', law=law)
            yield Flaw(("cam", shares), says)
    way = getattr(cam, RETURN)
    if way is None:
        return
    if BY_DIAGRAM not in (cam.return_law or cam.law, cam.law):
        yield Flaw(("cam", RETURN), said("the other laws are the same both ways; leave it out"))
    elif way == AS_GIVEN and cam.return_points is None:
        yield Flaw(("cam", RETURN), said("the return needs points of its own: write return_points"))
    elif way == MIRRORED and (cam.return_points is not None or cam.return_law is not None):
        says = said("the return is the rise run backwards: leave its own law and points out")
        yield Flaw(("cam", RETURN), says)


def _tables(cam: Said) -> Iterator[Flaw]:
    """The law table without its lines, and tables of another law."""
    for law, table in (("law", "law_table"), ("return_law", "return_table")):
        own, name = getattr(cam, table), getattr(cam, law) or cam.law
        if name == BY_TABLE and own is None and cam.law_table is None and not cam.phase:
            yield Flaw(("cam", table), NO_LINES)
        if own is not None and name != BY_TABLE:
            says = said('only {law} = "table" takes a table; leave it out', law=law)
            yield Flaw(("cam", table), says)
