"""What a sheet shows of a cam: diagrams, the region of centres, profiles, pressure angle, results."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import accumulate

from graphic_tmm.board.record import Mark
from graphic_tmm.board.scales import Scale
from graphic_tmm.chapters.cam.centre import Centre, Convexity
from graphic_tmm.chapters.cam.drum import Drum
from graphic_tmm.chapters.cam.flat_rocker import FaceLever
from graphic_tmm.chapters.cam.ink import ProfileNames, draw_profile_ink
from graphic_tmm.chapters.cam.ink_centre import CentreNames, draw_centre_ink, draw_rocker_ink
from graphic_tmm.chapters.cam.ink_drum import (
    draw_development_ink,
    draw_drum_radius_ink,
    draw_drum_scheme_ink,
)
from graphic_tmm.chapters.cam.ink_flat import draw_convexity_ink
from graphic_tmm.chapters.cam.ink_flat_rocker import draw_face_ink
from graphic_tmm.chapters.cam.ink_rules import DIAGRAM_RULES
from graphic_tmm.chapters.cam.ink_scheme import SchemeNames, draw_scheme_ink, position_of
from graphic_tmm.chapters.cam.ink_spring import SpringNames, draw_spring_ink
from graphic_tmm.chapters.cam.plan import CAM_PLAN, Cam
from graphic_tmm.chapters.cam.record import BESIDE
from graphic_tmm.chapters.cam.rocker import Lever
from graphic_tmm.chapters.cam.table import PLAN, cam_columns, cam_marks
from graphic_tmm.chapters.cam.task import CamTask
from graphic_tmm.chapters.cam.turn import CURVATURE
from graphic_tmm.drawn import Drawn, results_of, single
from graphic_tmm.fitting.subjects import subject, with_caption
from graphic_tmm.fitting.views import Views
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import fixed, number
from graphic_tmm.language.units import unit
from graphic_tmm.paper.axes import on_axis
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.formats import heights
from graphic_tmm.paper.graph import Level, Names, Span, draw_graph
from graphic_tmm.paper.views import mu_text, pole_figures, stacked
from graphic_tmm.readers.result_table import result_table, results
from graphic_tmm.readers.task_sheet import given_views
from graphic_tmm.scene.captions import captions

LIMITED = ("cam pressure",)
RADII = "cam radii"
"""What the diagram of curvature is called of a flat face: it shows the radius."""


def cam_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the views of a cam."""
    made, language, names = CAM_PLAN.on(drawn), drawn.scene.language, drawn.names
    rows = cam_columns(drawn)
    motion, *limits = _diagrams(drawn, made, names, lettered)
    return [
        motion,
        _profile(drawn, made, names, lettered),
        _centre(drawn, made, names, lettered),
        *limits,
        result_table(PLAN, rows, names, language, upright=True, heights=heights(drawn.scene, PLAN)),
        _results(drawn),
    ]


def scheme_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the mechanism's scheme in one position."""
    made, language = CAM_PLAN.on(drawn), drawn.scene.language
    told = SchemeNames(_steepest(drawn, made), f"{_radius(made)} = {_mm(drawn, made.r0)}")
    on = subject(drawn, captions(language)["cam scheme"], PLAN)
    draw = draw_drum_scheme_ink if made.order.developed else draw_scheme_ink
    if made.order.slides:
        told = told._replace(omega="s_{c}")
    view = draw(on, made, told)
    return [with_caption(view, on, lettered, _lengths(drawn, made))]


def _steepest(drawn: Drawn, made: Cam) -> str:
    """Return the largest pressure angle of the positions of the rise."""
    if not isinstance(made.centre, Centre):
        return ""
    angle = drawn.reading.figure(made.centre.pressure)[0, position_of(drawn.reading, made)]
    return f"α = {fixed(abs(float(angle)), 1, drawn.scene.language)}°"


def _diagrams(drawn: Drawn, made: Cam, names: Sequence[str], lettered: bool) -> list[Drawing]:
    """Return the diagrams of motion one below the other, those of pressure angle and curvature beside them."""
    language, log, reading = drawn.scene.language, drawn.construction, drawn.reading
    words = captions(language)
    charts = {chart.view: chart for chart in made.charts}
    motion = [one.axes.view for one in (made.diagrams.S, made.diagrams.V, made.diagrams.A)]
    first: list[Drawing] = []
    second: list[Drawing] = []
    third: list[Drawing] = []
    for view in dict.fromkeys(f.view for f in log.figures if f.kind == "axes"):
        called = RADII if view == CURVATURE and made.pressure is None else view
        if made.order.rocks and f"rocker {view}" in words:
            called = f"rocker {view}"
        symbol = words.get(f"symbol {called}", words["symbol cam"])
        on = subject(drawn, _title(called, language), PLAN)
        of = charts[view].unit if view in charts else ""
        told = Names(
            names,
            on_axis(symbol, unit(of, language)),
            on_axis("s_{c}", unit("mm", language)) if made.order.slides else on_axis("φ", "°"),
            lengths=pole_figures(log, reading, view, language),
            levels=_limits(drawn, made) if view in LIMITED else (),
            spans=_phases(drawn, made) if view == "cam S" else (),
            at=() if view == "cam S" else _bounds(drawn, made),
            closes=not made.order.slides,
        )
        graph = draw_graph(on, view, reading.positions, told, DIAGRAM_RULES)
        shown = with_caption(graph, on, lettered, _scale(drawn, made, view))
        forces = made.spring is not None and view in {one.view for one in made.spring.charts}
        stack = third if forces else second
        (first if view in motion else stack).append(shown)
    stacks = {"cam-diagrams": first, "cam-limits": second, "cam-spring": third}
    if made.spring is not None:
        # a lead of one's own may make it far wider than what it would stand below
        apart = made.order.spring is not None and made.order.spring.lead is not None
        stacks.setdefault("cam-spring-line" if apart else "cam-spring", []).append(
            _spring(drawn, made, names, lettered)
        )
    return [stacked(name, views) for name, views in stacks.items() if views]


def _spring(drawn: Drawn, made: Cam, names: Sequence[str], lettered: bool) -> Drawing:
    """Return the line of the spring over the inertia force."""
    spring, language = made.spring, drawn.scene.language
    assert spring is not None
    size, motion = spring.preload.unit, made.diagrams.stroke.unit
    letter = made.order.letters["S"]

    def has(name: str, mark: Mark) -> str:
        return f"{name} = {number(drawn.value(mark), language, 3)} {unit(mark.unit, language)}"

    scale = Scale(f"μ_{letter}", drawn.value(made.diagrams.S.chart.mu), f"{motion}/mm")
    told = SpringNames(
        names,
        on_axis(letter, unit(motion, language)),
        on_axis("F", unit(size, language)),
        "F_{0}",
        "F_{h}",
    )
    on = subject(drawn, captions(language)["cam spring"], PLAN)
    force = Scale("μ_{F}", drawn.value(spring.chart.mu), f"{size}/mm")
    scales = ", ".join(mu_text(one, language) for one in (force, scale))
    lines = (scales, f"{has('F_{0}', spring.preload)}, {has('c', spring.rate)}")
    known = (spring.preload, spring.rate)
    return with_caption(draw_spring_ink(on, made, told), on, lettered, *lines, known=known)


def _limits(drawn: Drawn, made: Cam) -> list[Level]:
    """Return the limits of the pressure angle, for the rise and for the return."""
    if made.pressure is None:
        return []
    order, language = made.order, drawn.scene.language
    scale, back = drawn.value(made.pressure.chart.mu), order.pressure_return or order.pressure
    return [
        Level(sign * angle / scale, f"{minus}[α] = {minus}{number(angle, language)}°")
        for sign, minus, angle in ((1, "", order.pressure), (-1, "−", back))
        if sign in {phase.sign for phase in made.diagrams.turn.phases}
    ]


def _phases(drawn: Drawn, made: Cam) -> list[Span]:
    """Return the phases of the turn with their angles."""
    order, whole = made.order, drawn.value(made.diagrams.base.length)
    found, at, letter = [], 0.0, "s" if order.slides else "φ"
    for k, angle in enumerate((stage.angle for stage in order.stages), 1):
        ends = (at * whole / order.whole, (at + angle) * whole / order.whole)
        if angle > 0.0:
            found.append(Span(*ends, f"{letter}_{{{k}}} = {_place(drawn, order, angle)}"))
        at += angle
    return found


def _place(drawn: Drawn, order: CamTask, at: float) -> str:
    """Return a place of the cam: degrees, or m, in mm."""
    language = drawn.scene.language
    if order.slides:
        return f"{number(1000.0 * at, language)} {unit('mm', language)}"
    return f"{number(at, language)}°"


def _bounds(drawn: Drawn, made: Cam) -> list[tuple[float, str]]:
    """Return where phases end on the base, mm, and the angles of the turn there."""
    order, whole = made.order, drawn.value(made.diagrams.base.length)
    phases = (stage.angle for stage in order.stages)
    angles = dict.fromkeys(round(angle, 9) for angle in accumulate(phases))
    return [(at * whole / order.whole, _place(drawn, order, at)) for at in angles]


def _title(view: str, language: str) -> str:
    words = captions(language)
    return words.get(view, words["cam integration"])


def _scale(drawn: Drawn, made: Cam, view: str) -> str:
    """Return the scale of a diagram and that of its base, along which the turn is told in degrees."""
    language, scale = drawn.scene.language, drawn.scales.get(view)
    along = BESIDE.on(drawn).along
    base = mu_text(Scale(along.name, drawn.value(along), along.unit), language)
    if scale is None:
        return base
    if view == made.diagrams.V.axes.view:
        # of a quantity of its own, though it may be the same number as that of S
        scale = scale._replace(symbol=f"μ_{{{made.order.letters['V']}}}")
    return f"{mu_text(scale, language)}, {base}"


def _mm(drawn: Drawn, mark: Mark) -> str:
    language = drawn.scene.language
    return f"{fixed(1000.0 * drawn.value(mark), 1, language)} {unit('mm', language)}"


def _centre(drawn: Drawn, made: Cam, names: Sequence[str], lettered: bool) -> Drawing:
    language = drawn.scene.language
    limits = [made.order.pressure, made.order.pressure_return or made.order.pressure]
    metre, flat = unit("m", language), isinstance(made.centre, Convexity)
    radius = _radius(made)
    least = f"{radius}_{{min}}" if made.order.developed else "r_{0min}"
    rate = "L·dS/ds_{c}" if made.order.slides else "d^2S/dφ^2" if flat else "dS/dφ"
    told = CentreNames(
        names,
        f"S, {metre}",
        f"{rate}, {metre}",
        f"{least} = {_mm(drawn, made.least)}",
        f"{radius} = {_mm(drawn, made.r0)}",
        (f"{number(limits[0], language)}°", f"{number(limits[1], language)}°"),
        _offset(drawn, made),
    )
    draw = draw_rocker_ink if isinstance(made.path, Lever) else draw_centre_ink
    draw = draw_convexity_ink if flat else draw
    draw = draw_face_ink if isinstance(made.path, FaceLever) else draw
    draw = draw_drum_radius_ink if made.order.developed else draw
    on = subject(drawn, captions(language)[made.centre.view], PLAN)
    lines = (_lengths(drawn, made), f"{told.least}, {told.r0}")
    known = (made.least, made.r0)
    return with_caption(draw(on, made, told), on, lettered, *lines, known=known)


def _radius(made: Cam) -> str:
    return "L" if made.order.slides else "R" if made.order.developed else "r_{0}"


def _offset(drawn: Drawn, made: Cam) -> str:
    """Return the offset of the guide with its value."""
    offset = getattr(made.order.follower, "offset", 0.0)
    language = drawn.scene.language
    return f"e = {fixed(1000.0 * abs(offset), 1, language)} {unit('mm', language)}"


def _lengths(drawn: Drawn, made: Cam) -> str:
    language, mu = drawn.scene.language, made.profile.mu
    return f"μ_l = {number(drawn.value(mu), language)} {unit('m/mm', language)}"


def _profile(drawn: Drawn, made: Cam, names: Sequence[str], lettered: bool) -> Drawing:
    language = drawn.scene.language
    _, words = speaking(language), captions(language)
    r0, roller = f"{_radius(made)} = {_mm(drawn, made.r0)}", "r"
    if made.roller is not None:
        roller = f"r = {_mm(drawn, made.roller.radius)}"
    told = ProfileNames(
        names, r0, roller, _("theoretical"), _("working"), offset=_offset(drawn, made),
        pressure=_steepest(drawn, made),
    )  # fmt: skip
    if isinstance(made.path, Drum) and made.path.length is not None:
        length = math.tau * 1000.0 * drawn.value(made.r0)
        text = f"2πR = {fixed(length, 1, language)} {unit('mm', language)}"
        told = told._replace(length=r0 if made.order.slides else text)
    on = subject(drawn, words[made.profile.view], PLAN)
    draw = draw_development_ink if made.order.developed else draw_profile_ink
    view = draw(on, made, told)
    return with_caption(view, on, lettered, _lengths(drawn, made))


def _results(drawn: Drawn) -> Drawing:
    language = drawn.scene.language
    words, rows = captions(language), []
    for name, (value, of) in single(results_of(drawn, cam_marks(CAM_PLAN.on(drawn)))).items():
        in_mm = of == "m"
        figure = fixed(1000.0 * value, 2, language) if in_mm else fixed(value, 2, language)
        rows.append([words[name], figure, unit("mm" if in_mm else of, language)])
    return results("table-cam-results", words["cam"], rows, language, heights(drawn.scene, PLAN))


SHOWN = Views(draw={"cam": cam_views, "cam scheme": scheme_views, **given_views("cam")})
