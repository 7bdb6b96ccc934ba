"""The table of an engine's cylinders; what remains of their inertia, and what the sheet cannot show."""

from __future__ import annotations

from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.cylinders.plan import CYLINDERS_PLAN, SIGNS, Inertia
from graphic_tmm.chapters.cylinders.task import CYLINDERS
from graphic_tmm.chapters.cylinders.words import KINDS, ROMAN, view_of
from graphic_tmm.chapters.rotors.polygon import Polygon
from graphic_tmm.drawn import Drawn, Results, results_of
from graphic_tmm.language.catalogue import Tongues, speaking
from graphic_tmm.language.numbers import fixed, number
from graphic_tmm.language.said import said
from graphic_tmm.language.units import small, unit
from graphic_tmm.paper.blocks import breakable
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.formats import heights
from graphic_tmm.paper.ruled import ruled_table
from graphic_tmm.project import Project
from graphic_tmm.readers.columns import Tabled
from graphic_tmm.readers.protocol import Protocols
from graphic_tmm.scene.captions import captions

DEGREES = 1
"""Decimals of an angle, as a protractor shows them."""
WORDS = Tongues(
    {
        "number": said("No.", context="heading"),
        "most": said("greatest"),
        "least": said("least"),
        "turn": said("at the turn"),
    }
)


def cylinder_marks(drawn: Drawn) -> dict[str, Mark]:
    """Return the marks that the results are, by their names; of what remains in part."""
    found: dict[str, Mark | None] = {}
    for kind, rest in CYLINDERS_PLAN.on(drawn).rests.items():
        name = f"cylinders_{kind}"
        found |= {name: rest.size, f"{name}_least": rest.least, f"{name}_at": rest.at}
        if rest.size is None:  # nothing, as its polygon measures
            polygons = _polygons(CYLINDERS_PLAN.on(drawn), kind)
            found[name] = polygons[0].size if polygons else None
    return {name: mark for name, mark in found.items() if mark is not None}


def cylinder_results(drawn: Drawn) -> Results:
    """Return what remains of forces and moments of both orders, and when."""
    return results_of(drawn, cylinder_marks(drawn))


def unseen(drawn: Drawn, made: Inertia, kind: str) -> float:
    """Return the size below which the sheet shows nothing of a kind: half a division of the ruler, times μ."""
    ruler = drawn.hand.ruler or 0.0
    return sum(ruler / 2 * drawn.scales[one.view].value for one in _polygons(made, kind))


def _polygons(made: Inertia, kind: str) -> list[Polygon]:
    views = [view_of(kind, way) for way in SIGNS]
    return [made.polygons[view] for view in views if view in made.polygons]


def cylinder_table(drawn: Drawn) -> Drawing:
    """Return the cylinders row by row: crank, axis, place; angles of their vectors, moments."""
    made, language = CYLINDERS_PLAN.on(drawn), drawn.scene.language
    words, high = WORDS[language], heights(drawn.scene, CYLINDERS)
    mm, moment = unit(small(1.0, language)[1], language), unit("N·m", language)
    heads = [words["number"], "θ, °"]
    if made.order.banked:
        heads.append("ψ, °")
    names = list(made.rows[0].angles)
    heads += [f"α_{{{ROMAN[name[0]]}{SIGNS[name[1:]]}}}, °" for name in names]
    part = "/2" if made.order.banked else ""
    heads += [f"z, {mm}", *(f"M_{{{n}}}{part}, {moment}" for n in ROMAN.values())]
    rows = []
    for row in made.rows:
        told = [row.number, _direction(drawn, row.crank)]
        told += [_angle(drawn, row.axis)] if row.axis else []
        told += [_direction(drawn, mark) for mark in row.angles.values()]
        told.append(number(small(_value(drawn, row.place), language)[0], language))
        told += [number(_value(drawn, mark), language) for mark in row.moments.values()]
        rows.append(told)
    return breakable(
        "table-cylinders",
        captions(language)["table cylinders"],
        heads,
        rows,
        again=captions(language)["continued"],
        size=high.number,
        title_size=high.title,
        align=["centre"] * len(heads),
    )


def rest_table(drawn: Drawn) -> Drawing:
    """Return what remains: nothing as 0, with the size that the sheet cannot show."""
    made, language = CYLINDERS_PLAN.on(drawn), drawn.scene.language
    words, common = WORDS[language], captions(language)
    high = heights(drawn.scene, CYLINDERS)
    heads = [common["value"], common["unit"], words["most"]]
    heads += [words["least"]] * made.order.banked + [f"φ, °\n({words['turn']})"]
    rows = []
    for kind in KINDS:
        rest = made.rests[kind]
        cells = [common[f"cylinders_{kind}"], unit("N" if kind[0] == "F" else "N·m", language)]
        if rest.size is None:
            cells.append(nothing(drawn, made, kind, language))
        else:
            cells.append(number(_value(drawn, rest.size), language))
        if made.order.banked:
            cells.append("—" if rest.least is None else number(_value(drawn, rest.least), language))
        cells.append("—" if rest.at is None else _angle(drawn, rest.at))
        rows.append(cells)
    return ruled_table(
        "table-remains", common["cylinders remains"], heads, rows, size=high.number,
        title_size=high.title, align=["left", *["centre"] * (len(heads) - 1)],
    )  # fmt: skip


def nothing(drawn: Drawn, made: Inertia, kind: str, language: str) -> str:
    """Return 0 as a sheet tells it: to what size it is sure."""
    size = unseen(drawn, made, kind)
    if not size:
        return "0"
    _ = speaking(language)
    return _("0 (within {size})", size=number(size, language, 2))


def _value(drawn: Drawn, mark: Mark) -> float:
    return float(drawn.reading.figure(mark)[0, 0])


def _angle(drawn: Drawn, mark: Mark) -> str:
    return fixed(_value(drawn, mark), DEGREES, drawn.scene.language)


def _direction(drawn: Drawn, mark: Mark) -> str:
    """Return the angle of a vector within one turn, as rounded."""
    return fixed(round(_value(drawn, mark), DEGREES) % 360.0, DEGREES, drawn.scene.language)


def _protocol(project: Project) -> dict[str, tuple[str, ...]]:
    return {CYLINDERS: tuple(dict.fromkeys(step.it.view for step in project.construction.steps))}


TABLE = Tabled(results=cylinder_results, marks=cylinder_marks)
PROTOCOL = Protocols(views=_protocol)
