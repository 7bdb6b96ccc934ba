"""The table of a rotor: its masses and counterweights row by row; its results."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.rotors.plan import MOMENTS, ROTOR_PLAN, Held, Rotor
from graphic_tmm.chapters.rotors.task import ROTOR
from graphic_tmm.drawn import Drawn, Results, results_of
from graphic_tmm.language.catalogue import Tongues
from graphic_tmm.language.numbers import fixed, number
from graphic_tmm.language.said import said
from graphic_tmm.language.units import small, unit
from graphic_tmm.paper.blocks import breakable
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.formats import heights
from graphic_tmm.project import Project
from graphic_tmm.readers.columns import Tabled
from graphic_tmm.readers.protocol import Protocols
from graphic_tmm.scene.captions import captions

DEGREES = 1
"""Decimals of an angle, as a protractor shows them."""
WORDS = Tongues({"number": said("No.", context="heading"), "none": said("none")})


def rotor_results(drawn: Drawn) -> Results:
    """Return unbalance, angle, mass and radius of each counterweight, the reaction of each bearing."""
    return results_of(drawn, rotor_marks(drawn))


def rotor_marks(drawn: Drawn) -> dict[str, Mark]:
    """Return the marks that the results are, by their names."""
    rotor = ROTOR_PLAN.on(drawn)
    found: dict[str, Mark | None] = {}
    for one in (*rotor.weights, *rotor.reactions):
        values = {"D": one.size, "alpha": one.angle, "m": one.mass, "r": one.radius, "R": one.force}
        found |= {f"rotor_{letter}_{one.name}": mark for letter, mark in values.items()}
    return {name: mark for name, mark in found.items() if mark is not None}


def weight_table(drawn: Drawn) -> Drawing:
    """Return the table of all masses: m, r, m·r, with two planes z and m·r·z, the angle; the counterweights."""
    rotor, language = ROTOR_PLAN.on(drawn), drawn.scene.language
    words, high = WORDS[language], heights(drawn.scene, ROTOR)
    mm = unit(small(1.0, language)[1], language)
    heads = [words["number"], f"m, {unit('kg', language)}", f"r, {mm}"]
    heads += [f"D = m·r,\n{unit('kg·m', language)}", "α, °"]
    if rotor.order.dynamic:
        heads += [f"z, {mm}", f"M = m·r·z,\n{unit('kg·m²', language)}"]
    return breakable(
        "table-rotor",
        captions(language)["table rotor"],
        heads,
        [*_masses(drawn, rotor), *_weights(drawn, rotor)],
        again=captions(language)["continued"],
        size=high.number,
        title_size=high.title,
        align=["centre"] * len(heads),
    )


def _masses(drawn: Drawn, rotor: Rotor) -> Iterator[list[str]]:
    cells = _Cells(drawn)
    for row in rotor.rows:
        told = [row.number, cells.figure(row.mass), cells.length(row.radius)]
        told += [cells.figure(row.size), cells.angle(row.angle)]
        if rotor.order.dynamic:
            told += [cells.length(row.distance), cells.figure(row.moment)]
        yield told


def _weights(drawn: Drawn, rotor: Rotor) -> Iterator[list[str]]:
    cells, none = _Cells(drawn), WORDS[drawn.scene.language]["none"]
    for one in rotor.weights:
        if one.size is None:
            told = [one.name, none, *["—"] * 3]
        else:
            told = [one.name, cells.figure(one.mass), cells.length(one.radius)]
            told += [cells.figure(one.size), cells.angle(one.angle)]
        if rotor.order.dynamic:
            told += _moment(cells, rotor, one)
        yield told


def _moment(cells: _Cells, rotor: Rotor, one: Held) -> list[str]:
    """The distance of a counterweight from plane I, and its moment."""
    if one is rotor.weights[0]:
        return ["0", "0"]
    moments = rotor.polygons.get(MOMENTS)
    told = moments.size if moments is not None and one.size is not None else None
    return [cells.length(rotor.apart), cells.figure(told)]


class _Cells:
    """Marks as a table tells them."""

    def __init__(self, drawn: Drawn) -> None:
        self.drawn, self.language = drawn, drawn.scene.language

    def value(self, mark: Mark) -> float:
        return float(self.drawn.reading.figure(mark)[0, 0])

    def figure(self, mark: Mark | None) -> str:
        return "—" if mark is None else number(self.value(mark), self.language)

    def length(self, mark: Mark | None) -> str:
        if mark is None:
            return "—"
        return number(small(self.value(mark), self.language)[0], self.language)

    def angle(self, mark: Mark | None) -> str:
        return "—" if mark is None else fixed(self.value(mark), DEGREES, self.language)


def reaction_rows(drawn: Drawn) -> list[list[str]]:
    """Return the reactions of the bearings, a row each: symbol, figure with the angle, unit."""
    language, words = drawn.scene.language, captions(drawn.scene.language)
    cells, rows = _Cells(drawn), []
    for one in ROTOR_PLAN.on(drawn).reactions:
        if one.force is None or one.angle is None:
            rows.append([words[f"rotor_R_{one.name}"], "0", unit("N", language)])
            continue
        told = f"{cells.figure(one.force)} ∠ {cells.angle(one.angle)}°"
        rows.append([words[f"rotor_R_{one.name}"], told, unit("N", language)])
    return rows


def _protocol(project: Project) -> dict[str, tuple[str, ...]]:
    """The views of a protocol in the order in which the rotor is drawn, what is calculated first among them."""
    return {ROTOR: tuple(dict.fromkeys(step.it.view for step in project.construction.steps))}


TABLE = Tabled(results=rotor_results, marks=rotor_marks)
PROTOCOL = Protocols(views=_protocol)
