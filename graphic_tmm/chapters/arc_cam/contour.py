"""The contour of a cam given by arcs: base circle, nose and flanks with their centres and where they touch."""

from __future__ import annotations

from typing import NamedTuple

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import to_board
from graphic_tmm.board.operations.instruments import (
    cross,
    join,
    lay_off,
    parallel,
    ray,
    square,
    strike,
    touch,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number, Point, Side
from graphic_tmm.chapters.arc_cam import formulas as f
from graphic_tmm.chapters.arc_cam import words as why
from graphic_tmm.chapters.arc_cam.task import ArcTask, Flank

VIEW = "arc cam profile"


class Arc(NamedTuple):
    """An arc of the contour, and what the roller's centre (a flat face: the contact) goes along on it.

    ``name``: of `geometry.ARCS`; ``centre`` K (Point), None of a straight one. ``radius`` of the contour there
    and ``reach``, the roller's centre's distance from K (Length; None for 0). ``way``: the arc or the line that
    the roller's centre goes along. ``hollow``: K lies outside the cam.
    """

    name: str
    centre: Mark | None
    radius: Mark | None
    reach: Mark | None
    way: Mark | None
    hollow: bool = False


class End(NamedTuple):
    """Where the follower goes over between base circle and flank: the normal outward, the roller's centre."""

    normal: Mark
    point: Mark


class _Drawn(NamedTuple):
    """A flank, where it touches base and nose, where the follower goes over onto it from the base."""

    arc: Arc
    low: Mark
    high: Mark
    end: End


class Contour(NamedTuple):
    """The contour as drawn: μ_l, the centre O, the nose's centre C, the arcs by name.

    ``touches``: where base and nose touch the flanks: base–rise, rise–nose, nose–return, return–base (Point).
    ``ends``: where the follower begins to rise, and where it comes to rest.
    """

    mu: Mark
    origin: Mark
    nose: Mark
    arcs: dict[str, Arc]
    touches: tuple[Mark, Mark, Mark, Mark]
    ends: tuple[End, End]


class _Sizes(NamedTuple):
    base: Mark
    nose: Mark | None
    roller: Mark | None


def draw_contour(
    draft: Draft, order: ArcTask, mu: float, sense: int, begin: float = 0.0
) -> Contour:
    """Draw the contour; ``sense``: 1 if the cam turns counter-clockwise, −1 clockwise.

    ``begin``: by how much the cam turns from where the follower stands opposite the nose until it begins to
    rise (degrees): it is drawn so that it is upright then.
    """
    draft.open(VIEW)
    scale = draft.mu_l = draft.take(Number, "μ_l", mu, "m/mm")
    draft.lay_out(None, scale)
    origin = draft.take(Point, "O", 0j)
    way = draft.direction(-90.0 + sense * begin)
    down = draft.draw(ray, "(OC)", origin, way, why=why.NOSE)
    letters = ("e_C", "R") if order.eccentric else ("d", "r_2")
    nose = draft.draw(lay_off, "C", down, _length(draft, letters[0], order.distance), why=why.NOSE)
    sizes = _Sizes(
        _length(draft, "r_1", order.base),
        _length(draft, letters[1], order.nose) if order.nose else None,
        _length(draft, "l_f" if order.rocks and order.flat else "r", order.roller)
        if order.roller
        else None,
    )
    arcs = {"base": _circle(draft, "base", origin, sizes.base, sizes.roller)}
    if order.eccentric:
        arcs["nose"] = _circle(draft, "nose", nose, sizes.nose, sizes.roller)
        up = draft.draw(parallel, "(n)", origin, down, sense=-1, why=why.OPPOSITE)
        touch = draft.draw(lay_off, "T", up, sizes.base, why=why.OPPOSITE)
        reach = arcs["base"].reach
        assert reach is not None
        lowest = End(up, draft.draw(lay_off, "b", up, reach) if sizes.roller else touch)
        draft.figure("contour", "", touch)
        return Contour(scale, origin, nose, arcs, (touch,) * 4, (lowest, lowest))
    rise = _flank(draft, "rise", order.rise, (origin, nose), sizes, -sense)
    like = order.fall == order.rise
    fall = _flank(draft, "return", order.fall, (origin, nose), sizes, sense, 3 if like else 4)
    arcs["rise"] = rise.arc
    arcs["nose"] = _circle(draft, "nose", nose, sizes.nose, sizes.roller)
    arcs["return"] = fall.arc
    touches = (rise.low, rise.high, fall.high, fall.low)
    draft.figure("contour", "", *touches)
    return Contour(scale, origin, nose, arcs, touches, (rise.end, fall.end))


def _length(draft: Draft, letter: str, metres: float) -> Mark:
    """Take a length (m) and calculate it on the board."""
    real = draft.take(Number, f"l_{{{letter}}}", metres, "m")
    return draft.draw(to_board, letter, real)


def _reach(
    draft: Draft, radius: Mark | None, roller: Mark | None, hollow: bool = False
) -> Mark | None:
    """Return how far the roller's centre stands from the centre of an arc."""
    if radius is None or roller is None:
        return radius or roller
    op, sign = (f.inside, "−") if hollow else (f.outside, "+")
    return draft.draw(op, f"{radius.name}{sign}{roller.name}", radius, roller)


def _circle(draft: Draft, name: str, centre: Mark, radius: Mark | None, roller: Mark | None) -> Arc:
    """Draw a circle of the contour, and the one that the roller's centre goes along."""
    reach = _reach(draft, radius, roller)
    if radius is not None:
        own = draft.draw(strike, f"({radius.name})", centre, radius)
    way = own if radius is not None and roller is None else None
    if reach is not None and way is None:
        way = draft.draw(strike, f"({reach.name})", centre, reach, why=why.REPLACED)
    return Arc(name, centre, radius, reach, way)


def _flank(
    draft: Draft,
    name: str,
    flank: Flank,
    centres: tuple[Mark, Mark],
    sizes: _Sizes,
    side: int,
    number: int = 3,
) -> _Drawn:
    """Draw a flank; return it and where it touches base and nose. ``side``: 1 for that on the left."""
    if flank.radius is None:
        return _straight(draft, name, centres, sizes, side)
    op, sign = (f.outside, "+") if flank.hollow else (f.inside, "−")
    letter = f"r_{number}"
    radius = draft.draw(to_board, letter, draft.constant(f"l_{{{letter}}}", flank.radius, "m"))
    arcs = []
    for centre, own in zip(centres, (sizes.base, sizes.nose), strict=True):
        far = radius if own is None else draft.draw(op, f"{letter}{sign}{own.name}", radius, own)
        arcs.append(draft.draw(strike, f"({centre.name}; {far.name})", centre, far, why=why.FLANK))
    where = draft.take(Side, "±", float(side * (-1 if flank.hollow else 1)))
    middle = draft.draw(cross, f"F_{1 if name == 'rise' else 2}", *arcs, where, why=why.FLANK)
    spots, lines = [], []
    index = ("1", "2") if name == "rise" else ("4", "3")
    for centre, which in zip(centres, index, strict=True):
        line = draft.draw(join, f"({middle.name}{centre.name})", middle, centre, why=why.TOUCH)
        spots.append(draft.draw(lay_off, f"T_{which}", line, radius, why=why.TOUCH))
        lines.append(line)
    reach = _reach(draft, radius, sizes.roller, flank.hollow)
    assert reach is not None
    way = draft.draw(strike, f"({middle.name}; {reach.name})", middle, reach, why=why.REPLACED)
    normal, point = lines[0], spots[0]
    if flank.hollow:
        normal = draft.draw(parallel, f"(n_{index[0]})", centres[0], normal, sense=-1)
    if sizes.roller is not None:
        point = draft.draw(lay_off, f"b_{index[0]}", lines[0], reach, why=why.FIRST)
    arc = Arc(name, middle, radius, reach, way, flank.hollow)
    return _Drawn(arc, spots[0], spots[1], End(normal, point))


def _straight(
    draft: Draft, name: str, centres: tuple[Mark, Mark], sizes: _Sizes, side: int
) -> _Drawn:
    """Draw a straight flank: the tangent to both circles."""
    origin, nose = centres
    less = sizes.base
    if sizes.nose is not None:
        less = draft.draw(f.inside, "r_1−r_2", sizes.base, sizes.nose, why=why.TANGENT)
    circle = draft.draw(strike, f"({less.name})", origin, less, why=why.TANGENT)
    where = draft.take(Side, "±", float(side))
    index = ("1", "2") if name == "rise" else ("4", "3")
    contact = draft.draw(touch, f"t_{index[0]}", nose, circle, where, why=why.TANGENT)
    normal = draft.draw(join, f"(O{contact.name})", origin, contact, why=why.TANGENT)
    low = draft.draw(lay_off, f"T_{index[0]}", normal, sizes.base, why=why.TOUCH)
    high = nose
    if sizes.nose is not None:
        other = draft.draw(parallel, f"(CT_{index[1]})", nose, normal, why=why.TANGENT)
        high = draft.draw(lay_off, f"T_{index[1]}", other, sizes.nose, why=why.TOUCH)
    spot = low
    if sizes.roller is not None:
        far = draft.draw(f.outside, f"r_1+{sizes.roller.name}", sizes.base, sizes.roller)
        spot = draft.draw(lay_off, f"b_{index[0]}", normal, far, why=why.ON_STRAIGHT)
    way = draft.draw(square, f"(b_{index[0]})", spot, normal, sense=1, why=why.ON_STRAIGHT)
    return _Drawn(Arc(name, None, None, None, way), low, high, End(normal, spot))
