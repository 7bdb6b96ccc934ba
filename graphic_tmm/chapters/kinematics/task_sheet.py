"""What a task asks of the plans of a mechanism, a sentence each."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from graphic_tmm.chapters.kinematics.closings import with_plates
from graphic_tmm.chapters.kinematics.drives import driven
from graphic_tmm.chapters.kinematics.given import (
    coordinates,
    given,
    stated,
    stroke,
    wanted_accelerations,
)
from graphic_tmm.chapters.kinematics.scheme import posed, scheme
from graphic_tmm.chapters.kinematics.task import (
    ACCELERATIONS,
    ASKED,
    POSITIONS,
    SPECIAL_POINTS,
    VELOCITIES,
    Rows,
)
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import number
from graphic_tmm.language.said import said
from graphic_tmm.language.symbols import plain, symbol
from graphic_tmm.language.units import unit
from graphic_tmm.mechanism.records import Extreme
from graphic_tmm.mechanism.structure import dissect
from graphic_tmm.paper.lettering.markup import markup
from graphic_tmm.readers.narration import remark
from graphic_tmm.readers.task_sheet import LONG, Given, Listed, TaskSheet, by_positions
from graphic_tmm.scene.records import Scene


def positions(scene: Scene, language: str) -> Iterator[str]:
    """Ask for the plan of positions, and for the paths of points."""
    _ = speaking(language)
    yield _row(scene, language)
    yield from _extra(scene, language)
    yield from _laid(scene, language)
    if scene.trajectories:
        yield _(_PATHS, n=len(scene.trajectories), listed=", ".join(scene.trajectories))
    asked = ASKED.of(scene)
    if asked is not None:
        yield from _rows(asked, language)


def _row(scene: Scene, language: str) -> str:
    """Ask for the positions of the row: of a whole turn, of a stroke, at places."""
    _, row = speaking(language), scene.row
    if not row.open:
        return _(_PLAN, n=row.count, first=str(row.first))
    told = _equal(stroke(scene), language)
    return _(_PLACES if row.places else _STROKE, n=row.count, stroke=told, first=str(row.first))


def _equal(given: Given, language: str) -> str:
    """Return what is given as an equation: l = 600…850 mm."""
    letter, figures, of = given
    return f"{plain(letter)} = {figures}{'' if of == '°' else ' '}{unit(of, language)}"


def _extra(scene: Scene, language: str) -> Iterator[str]:
    """Ask for the positions outside the row: extreme ones, at angles, at lengths."""
    _, zero = speaking(language), scene.row.zero
    extremes = [one for one in scene.row.extra if isinstance(one, Extreme)]
    places = [one for one in scene.row.extra if not isinstance(one, Extreme)]
    other = zero.opposite if isinstance(zero, Extreme) else None
    if other in extremes:
        yield _(_OTHER)
    for one in extremes:
        if one != other:
            yield _(_EXTREME, extreme=remark(f"{one.point}: {one.at}", language))
    if not places:
        return
    drawn = coordinates(scene, places)
    if drawn.unit == "°":
        listed = ", ".join(f"{one:g}°" for one in places)
        yield _(_ANGLES, n=len(places), listed=listed)
    else:
        yield _(_LENGTHS_APART, n=len(places), listed=_equal(drawn, language))


def _laid(scene: Scene, language: str) -> Iterator[str]:
    """Say which of its places a plate keeps: how its line stands where the mechanism is shown."""
    mechanism = scene.mechanism
    if mechanism is None or not any(one.plates for one in dissect(mechanism).groups):
        return
    pose = posed(scene)
    at = pose.project.coordinates[0]
    for closing in with_plates(pose.plans.positions.closings, "task"):
        if at is not None:
            _, (plate,) = closing.branch.near(np.array([at]))
            yield speaking(language)(
                _PLACE,
                link=closing.plate,
                line=closing.line,
                at=_equal(coordinates(scene, [at]), language).replace(" ", "\u00a0"),
                angle=f"{round(float(plate)) % 360}°",
            )


def special_points(scene: Scene, language: str) -> Iterator[str]:
    """Ask for the special points of plates, in as many positions as a sheet shows."""
    _ = speaking(language)
    if scene.mechanism is None:
        return
    for one in dissect(scene.mechanism).groups:
        if one.plates:
            yield _(_SPECIAL, name=one.name)


def _rows(asked: Rows, language: str) -> Iterator[str]:
    """Ask for further rows, a sentence a kind."""
    _ = speaking(language)
    pins = (
        f"{k} ({number(1000 * r, language)} {unit('mm', language)})" for k, r in asked.pins.items()
    )
    for says, listed in (
        (_LENGTHS, asked.lengths),
        (_OF_LINKS, asked.angles),
        (_RELATIVE, asked.relative),
        (_CURVED, asked.paths),
        (_PINS, tuple(pins)),
    ):
        if listed:
            yield _(says, listed=", ".join(listed))


def velocities(scene: Scene, language: str) -> Iterator[str]:
    """Ask for the plans of velocities."""
    _ = speaking(language)
    if scene.at_rest:
        yield _(_POSSIBLE)
    elif scene.common_pole:
        yield _(_TURNED_COMMON if scene.turned else _COMMON)
    else:
        yield _(_TURNED if scene.turned else _VELOCITIES)


def accelerations(scene: Scene, language: str) -> Iterator[str]:
    """Ask for the plans of accelerations."""
    if scene.row.accelerations:
        yield wanted_accelerations(scene, language) or speaking(language)(_ALL)


def equations(scene: Scene, language: str) -> Iterator[str]:
    """Ask for the equations of the plans."""
    if scene.row.accelerations:
        yield speaking(language)(_BOTH_EQUATIONS)


def acceleration_equations(scene: Scene, language: str) -> Iterator[str]:
    """Ask for those of accelerations."""
    if scene.row.accelerations:
        yield speaking(language)(_ACCELERATION_EQUATIONS)


def acceleration_table(scene: Scene, language: str) -> Iterator[str]:
    """Ask for the table of accelerations."""
    if scene.row.accelerations:
        yield speaking(language)(_ACCELERATION_TABLE)


def both_tables(scene: Scene, language: str) -> Iterator[str]:
    """Ask for both tables."""
    if scene.row.accelerations:
        yield speaking(language)(_BOTH_TABLES)


def speeds_listed(scene: Scene, language: str) -> Iterator[Listed]:
    """Yield speeds that change from position to position, where the given data has no room for all."""
    if scene.mechanism is None:
        return
    pair, *_ = driven(scene.mechanism, dissect(scene.mechanism))
    rows = [
        (f"{markup(symbol(letter, language))}, {unit(of, language)}", row)
        for letter, row, of in pair.speeds_given()
        if len(row) > LONG
    ]
    if rows:
        yield from by_positions("speeds", speaking(language)(_SPEEDS), rows, scene, language)


_SPEEDS = said("Speed and acceleration of the driving link by positions")
_LENGTHS = said("In every position these lengths are read off: {listed}.")
_OF_LINKS = said("In every position the angles of these lines with the x axis are found: {listed}.")
_RELATIVE = said(
    "Whole relative accelerations are read off, of the first point to the second: {listed}."
)
_CURVED = said(
    "Normal and tangential accelerations and radii of curvature of the paths are found of points: {listed}."
)
_PINS = said("The rubbing speeds of these pins (radius) are found: {listed}.")
_PLAN = said(
    "The plan of positions is drawn for {n} position of the crank; the first one bears the number {first}.",
    "The plan of positions is drawn for {n} equally spaced positions of the crank; the first one "
    "bears the number {first}.",
)
_STROKE = said(
    "The plan of positions is drawn for {n} position, {stroke}; it bears the number {first}.",
    "The plan of positions is drawn for {n} positions in equal steps, {stroke}; the first one "
    "bears the number {first}.",
)
_PLACES = said(
    "The plan of positions is drawn for {n} position at {stroke}; it bears the number {first}.",
    "The plan of positions is drawn for {n} positions at {stroke}; the first one bears the number "
    "{first}.",
)
_PLACE = said(
    "Of the places of link {link} the one is drawn that the scheme shows: at {at} its line {line} stands at "
    "{angle} to the x axis; from position to position it goes on without a leap."
)
_SPECIAL = said("Assur's special point of group {name} is found; velocities are drawn by it.")
_OTHER = said("The other extreme position is drawn as well.")
_ANGLES = said(
    "The position at the crank's angle {listed} is drawn as well.",
    "The positions at the crank's angles {listed} are drawn as well.",
)
_LENGTHS_APART = said(
    "The position at {listed} is drawn as well.",
    "The positions at {listed} are drawn as well.",
)
_EXTREME = said("Besides, the {extreme} is drawn.")
_PATHS = said("The path of point {listed} is drawn.", "The paths of points {listed} are drawn.")
_POSSIBLE = said("Plans of possible velocities are drawn for all positions.")
_VELOCITIES = said("Velocity plans are drawn for all positions.")
_TURNED = said("Velocity plans, turned by 90°, are drawn for all positions.")
_COMMON = said("Velocity plans of all positions are drawn from one pole.")
_TURNED_COMMON = said("Velocity plans of all positions, turned by 90°, are drawn from one pole.")
_ALL = said("Acceleration plans are drawn for all positions.")
_ACCELERATION_EQUATIONS = said("The vector equations of accelerations are written down.")
_BOTH_EQUATIONS = said("The vector equations of velocities and accelerations are written down.")
_ACCELERATION_TABLE = said(
    "Accelerations of points and angular accelerations of links are set in a table."
)
_BOTH_TABLES = said(
    "Velocities and accelerations of points, angular velocities and angular accelerations of "
    "links are set in a table."
)


TASK_SHEET = TaskSheet(
    given=given,
    stated=stated,
    listed=speeds_listed,
    scheme=scheme,
    wanted={
        POSITIONS: positions,
        SPECIAL_POINTS: special_points,
        VELOCITIES: velocities,
        ACCELERATIONS: accelerations,
        "equations": equations,
        "acceleration equations": acceleration_equations,
        "acceleration table": acceleration_table,
        "results": both_tables,
    },
)
