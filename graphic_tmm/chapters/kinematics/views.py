"""What a sheet shows of the plans: positions, velocities, accelerations, their equations and tables."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from graphic_tmm.chapters.kinematics.along import with_guides
from graphic_tmm.chapters.kinematics.dead_places import dead_places
from graphic_tmm.chapters.kinematics.far_points import far_positions, refuse_far
from graphic_tmm.chapters.kinematics.ink_by_drive import draw_sums_ink
from graphic_tmm.chapters.kinematics.ink_links import LinksInk
from graphic_tmm.chapters.kinematics.ink_plans import Place, draw_equations, draw_plan
from graphic_tmm.chapters.kinematics.ink_positions import (
    PositionsFigure,
    draw_position_ink,
    draw_positions_ink,
)
from graphic_tmm.chapters.kinematics.ink_special_point import draw_special_points
from graphic_tmm.chapters.kinematics.other_places import group_places, other_places
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN, KinematicPlans
from graphic_tmm.chapters.kinematics.scales import outlying, reaches
from graphic_tmm.chapters.kinematics.special_choices import special_choices
from graphic_tmm.chapters.kinematics.table import UNITS, measured_vectors, plan_columns, rate_marks
from graphic_tmm.chapters.kinematics.task import (
    ACCELERATIONS,
    ASKED,
    BY_DRIVE,
    GIVEN,
    PLANS,
    POSITIONS,
    SPECIAL_POINTS,
    VELOCITIES,
)
from graphic_tmm.chapters.kinematics.words import ALONE, EACH_ALONE
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.subjects import subject, with_caption
from graphic_tmm.fitting.views import Views
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.paper.drawing import Drawing, Stand, Stroke
from graphic_tmm.paper.formats import Heights, heights
from graphic_tmm.paper.labels import TOGETHER, finished
from graphic_tmm.paper.lettering.letters import escape
from graphic_tmm.paper.seen import Subject
from graphic_tmm.paper.views import in_rows, mu_text, noted
from graphic_tmm.readers.columns import Readings
from graphic_tmm.readers.equations import equations
from graphic_tmm.readers.result_table import result_table
from graphic_tmm.readers.task_sheet import given_table
from graphic_tmm.scene.captions import captions

EQUATIONS = {
    VELOCITIES: said("Equations of velocities"),
    ACCELERATIONS: said("Equations of accelerations"),
}
"""What the vector equations of a plan are called."""
BEHIND = said(
    "link {number}: its mass centre {centre} lies behind the pin {pin} of its rod, away from the piston; if it "
    'is on the rod, write angle = "180 deg" in its slides'
)


def position_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the plan of positions."""
    made, words = KINEMATICS_PLAN.on(drawn), captions(drawn.scene.language)
    shown = PositionsFigure(
        drawn.names,
        drawn.main,
        (*drawn.undrawn, *made.repeated),
        made.led,
        made.extremes,
        made.ends is None,
        _together(drawn, made),
    )
    on = subject(drawn, words["positions"], POSITIONS)
    view = draw_positions_ink(on, reaches(drawn), shown, made.pairs, made.positions)._replace(
        stand=Stand(kind="lead")
    )
    view, told = with_guides(drawn, view)
    return [with_caption(view, on, lettered, mu_text(drawn.scales[POSITIONS], on.language), *told)]


def _together(drawn: Drawn, made: KinematicPlans) -> list[str]:
    """Return what positions are called at the crank: those of later turns with that of the first."""
    size, names = made.in_turn, drawn.names
    whole = range(made.count)
    return [
        ", ".join(names[i] for i in whole if i % size == k) if k < size else name
        for k, name in enumerate(names)
    ]


def special_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the special points of plates in the main position."""
    made, words = KINEMATICS_PLAN.on(drawn), captions(drawn.scene.language)
    plates = any(one.group.plates for one in made.positions.closings)
    if not plates or made.velocities is None:
        return []
    refuse_far(drawn, drawn.main)
    position = f"{words['position']} {drawn.names[drawn.main]}"
    title = f"{words[SPECIAL_POINTS]}, {position}"
    on = subject(drawn, title, SPECIAL_POINTS)
    view = draw_special_points(on, reaches(drawn), made.positions, drawn.main)
    return [with_caption(view, on, lettered, mu_text(drawn.scales[POSITIONS], on.language))]


def warned(drawn: Drawn, language: str) -> Iterator[str]:
    """Yield, as sentences, what outlies the plans, and mass centres of pistons that lie off their rods."""
    yield from outlying(drawn, language)
    yield from dead_places(drawn, language)
    yield from far_positions(drawn, language)
    ink, at = LinksInk(drawn.construction, drawn.reading, reaches(drawn)), drawn.main
    for figure in (one for one in ink.figures if one.kind == "piston"):
        pin, way = ink.foot(figure, at), ink.cylinder(figure, at).way
        for told in ink.of(figure.name, "centre"):
            mark = told.marks[0]
            if ((ink.at(mark, at) - pin) / way).real < -TOGETHER:
                yield speaking(language)(
                    BEHIND,
                    number=figure.name,
                    centre=mark.letter,
                    pin=figure.marks[0].letter,
                )


def given_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the table of what the scene gives."""
    return [given_table(drawn.scene, heights(drawn.scene, GIVEN))]


def velocity_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the plan of velocities of each position, or of all of them from a common pole."""
    _, words = speaking(drawn.scene.language), captions(drawn.scene.language)
    if drawn.scene.at_rest:
        one, several = words[f"{VELOCITIES} at rest"], _("Plans of possible velocities")
        return _plans(VELOCITIES, one, several, drawn, lettered)
    if drawn.scene.turned:
        return _plans(
            VELOCITIES, _("Turned velocity plan"), _("Turned velocity plans"), drawn, lettered
        )
    return _plans(VELOCITIES, words[VELOCITIES], _("Velocity plans"), drawn, lettered)


def acceleration_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the plans of accelerations, at the positions that have one."""
    _, words = speaking(drawn.scene.language), captions(drawn.scene.language)
    return _plans(ACCELERATIONS, words[ACCELERATIONS], _("Acceleration plans"), drawn, lettered)


def _plans(plan: str, caption: str, several: str, drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the plans of a kind; ``caption``, ``several``: what one of them is called, and more of them."""
    _, words = speaking(drawn.scene.language), captions(drawn.scene.language)
    reading = drawn.of(plan)
    if reading is None or plan not in drawn.scales:
        return []
    of, stands = (plan, plan) if plan in PLANS else (VELOCITIES, BY_DRIVE)
    scale, size = drawn.scales[plan], heights(drawn.scene, stands)
    row = drawn.row(plan)
    left_out = {*drawn.undrawn, *KINEMATICS_PLAN.on(drawn).repeated}
    shown = [(k, drawn.names[p]) for k, p in enumerate(row) if p not in left_out]
    if plan == VELOCITIES and drawn.scene.common_pole and len(shown) > 1:
        orders = [(plan, f"{caption}, {_('all positions')}", [Place(*one) for one in shown])]
    else:
        orders = [
            (f"{plan}-{name}", f"{caption}, {words['position']} {name}", [Place(k)])
            for k, name in shown
        ]
    views = []
    for name, title, stood in orders:
        on = subject(drawn, title, stands, name=name)._replace(reading=reading)
        view = finished(draw_plan(on, plan, stood, scale.value, UNITS[of]), lettered)
        views.append(view._replace(position=row[stood[0].at] if len(stood) == 1 else None))
    mu = mu_text(scale, drawn.scene.language)
    told = [(escape(name), mu) for _, name in shown][: len(views)]
    return in_rows(views, plan, several, told, size, VELOCITIES if plan == ACCELERATIONS else "")


def by_drive_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the plans of velocities as each drive alone causes them, then the sums of points by positions."""
    made, language = KINEMATICS_PLAN.on(drawn), drawn.scene.language
    speech, found = speaking(language), list[Drawing]()
    if not made.summed:
        return found
    for one in made.by_drive:
        alone, several = (speech(words, link=str(one.link)) for words in (ALONE, EACH_ALONE))
        found += _plans(one.motion.mu.view, alone, several, drawn, lettered)
    left_out, title = {*drawn.undrawn, *made.repeated}, captions(language)[BY_DRIVE]
    places = [k for k in drawn.all if k not in left_out]
    mu, high = mu_text(drawn.scales[VELOCITIES], language), heights(drawn.scene, BY_DRIVE)
    told = [(escape(drawn.names[k]), mu) for k in places]
    return [*found, *in_rows(sums(drawn, places, lettered), BY_DRIVE, title, told, high)]


def sums(drawn: Drawn, places: Sequence[int], lettered: bool) -> list[Drawing]:
    """Return the sums of velocities in some positions."""
    words, summed, found = captions(drawn.scene.language), KINEMATICS_PLAN.on(drawn).summed, []
    for k in places:
        name, key = drawn.names[k], BY_DRIVE.replace(" ", "-")
        title = f"{words[BY_DRIVE]}, {words['position']} {name}"
        on = subject(drawn, title, BY_DRIVE, name=f"{key}-{name}")
        found.append(finished(draw_sums_ink(on, summed, k), lettered))
    return found


def equation_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the vector equations of the plans of velocities and accelerations."""
    return [*velocity_equations(drawn, lettered), *acceleration_equations(drawn, lettered)]


def velocity_equations(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the vector equations of the plan of velocities."""
    return _equations(VELOCITIES, drawn, "velocity equations")


def acceleration_equations(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the vector equations of the plan of accelerations."""
    return _equations(ACCELERATIONS, drawn, "acceleration equations")


def _equations(plan: str, drawn: Drawn, place: str) -> list[Drawing]:
    """Return the equations of a plan, lettered as on the sheets of their ``place`` or of both."""
    language, log = drawn.scene.language, drawn.construction
    told = list(equations(log, plan, turned=drawn.scene.turned))
    if not told:
        return []
    title, high = speaking(language)(EQUATIONS[plan]), heights(drawn.scene, place, "equations")
    return noted([draw_equations(log, plan, title, told, high, language)], plan)


def position_table(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the table of lengths and angles that are read off the plan of positions."""
    return _table(POSITIONS, drawn, "position table")


def velocity_table(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the table of velocities."""
    return _table(VELOCITIES, drawn, "velocity table")


def acceleration_table(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the table of accelerations."""
    return _table(ACCELERATIONS, drawn, "acceleration table")


def both_tables(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return both tables; before them that of positions, where rows of it are asked for."""
    asked = ASKED.of(drawn.scene)
    first = position_table(drawn, lettered) if asked and (asked.lengths or asked.angles) else []
    return [*first, *velocity_table(drawn, lettered), *acceleration_table(drawn, lettered)]


def _table(plan: str, drawn: Drawn, place: str) -> list[Drawing]:
    """Return the table of a plan, lettered as on the sheets of its ``place`` or of both."""
    rows = [one.without(KINEMATICS_PLAN.on(drawn).repeated) for one in plan_columns(drawn, plan)]
    if not rows or drawn.of(plan) is None:
        return []
    high = heights(drawn.scene, place, "results")
    language, rests = drawn.scene.language, drawn.scene.at_rest
    return [result_table(plan, rows, drawn.names, language, heights=high, at_rest=rests)]


def plan_at(
    drawn: Drawn, plan: str, place: int, name: str, title: str, upon: Sequence[Stroke]
) -> Drawing:
    """Return a plan in one position, whose letters keep off what is drawn ``upon`` it."""
    reading = drawn.of(plan)
    assert reading is not None
    on = Subject(drawn.construction, reading, title, name=name)
    if drawn.scene.letters is not None:
        on = on._replace(heights=Heights(*drawn.scene.letters))
    if plan == POSITIONS:
        return finished(draw_position_ink(on, reaches(drawn), place, upon))
    at = [Place(drawn.row(plan).index(place))]
    unit = UNITS.get(plan, UNITS[VELOCITIES])  # of one drive alone, too
    return finished(draw_plan(on, plan, at, drawn.scales[plan].value, unit, upon=upon))


SHOWN = Views(
    draw={
        GIVEN: given_views,
        POSITIONS: position_views,
        SPECIAL_POINTS: special_views,
        VELOCITIES: velocity_views,
        BY_DRIVE: by_drive_views,
        ACCELERATIONS: acceleration_views,
        "equations": equation_views,
        "velocity equations": velocity_equations,
        "acceleration equations": acceleration_equations,
        "position table": position_table,
        "velocity table": velocity_table,
        "acceleration table": acceleration_table,
        "results": both_tables,
    }
)


READINGS = Readings(
    pointed=PLANS,
    plan_at=plan_at,
    named_marks=rate_marks,
    vectors=measured_vectors,
    choices=special_choices,
    elsewhere=other_places,
    places=group_places,
)
