"""The section of a cam in a note: law of motion, region of centres, limits, profile; what follows."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property, partial

from graphic_tmm.board.operations.formulas import to_board, total
from graphic_tmm.chapters.cam import formulas as f
from graphic_tmm.chapters.cam import (
    formulas_drum,
    formulas_plate,
    formulas_spring,
    words_drum,
    words_plate,
    words_spring,
)
from graphic_tmm.chapters.cam import note_words as words
from graphic_tmm.chapters.cam.centre import VIEW as CENTRE
from graphic_tmm.chapters.cam.centre import Centre, Path
from graphic_tmm.chapters.cam.diagrams import VIEWS
from graphic_tmm.chapters.cam.drum import Drum
from graphic_tmm.chapters.cam.findings import cam_findings
from graphic_tmm.chapters.cam.ink_scheme import NAME as SCHEME
from graphic_tmm.chapters.cam.laws import formulas as law
from graphic_tmm.chapters.cam.plan import Cam
from graphic_tmm.chapters.cam.profile import VIEW as PROFILE
from graphic_tmm.chapters.cam.record import BESIDE
from graphic_tmm.chapters.cam.record import VIEW as CALCULATED
from graphic_tmm.chapters.cam.spring import INERTIA
from graphic_tmm.chapters.cam.spring import VIEW as SPRING
from graphic_tmm.chapters.cam.task_motion import BY_TABLE
from graphic_tmm.chapters.cam.turn import CONTACT, CURVATURE
from graphic_tmm.chapters.cam.views import cam_views, scheme_views
from graphic_tmm.language.numbers import number
from graphic_tmm.note.document import Block, Display, Formula, Number, Paragraph, Runs, Symbol
from graphic_tmm.note.figures import readable
from graphic_tmm.note.page import Page
from graphic_tmm.note.section_chapter import Noted
from graphic_tmm.note.steps import marks_of
from graphic_tmm.paper.drawing import Drawing

RADII = (
    law.sine_radius, law.sine_radius_V, law.sine_radius_A, law.cosine_radius, law.cosine_radius_V,
    law.cosine_radius_A, law.parabola_V, law.parabola_A, law.shared_A,
    law.polynomial_S, law.polynomial_V, law.polynomial_A, law.chord_V, law.chord_A,
)  # fmt: skip
"""What a law is drawn by."""


LETTERS = {"B0": Symbol("B_{0}"), "O1": Symbol("O_{1}"), "O2": Symbol("O_{2}")}
"""Letters of the drawing that sentences name."""


class CamPage(Page[Cam]):
    """A cam, worked a quarter of the rise behind its beginning: all of its motion is there."""

    letters = LETTERS
    by_results = (words.RADIUS, words_drum.RADIUS, words_plate.RADIUS)

    @cached_property
    def at(self) -> int:
        """The position (index) a quarter of the rise behind its beginning."""
        rise = self.recorded.diagrams.turn.rise
        return rise.first + max(1, round(rise.parts / 4))

    def views(self) -> list[Drawing]:
        """Return the scheme, the diagrams, the profile."""
        draws = (partial(draw, lettered=True) for draw in (scheme_views, cam_views))
        return readable(self.drawn, *draws)

    def concludes(self) -> Iterator[Runs]:
        """Yield what the limits of the cam come to; those that are passed are warnings."""
        yield from super().concludes()
        order = self.recorded.order
        if "pressure_return" in self.results:
            back = "pressure" if order.pressure_return is None else "pressure_return"
            limits = {"allowed": self.ordered("pressure", "°"), "behind": self.ordered(back, "°")}
            yield self.sentence(words.PRESSURE_KEPT, limits)
        if not cam_findings(self.drawn.reading, self.recorded):
            kept = words.ALL if self.recorded.roller is not None else words.EDGE
            kept = words_drum.ALL if order.developed else kept
            kept = words_plate.KEPT if order.slides else kept
            yield self.sentence(words.FLAT if self.recorded.pressure is None else kept)

    def blocks(self) -> Iterator[Block]:
        """Yield what is told of a cam, in the order in which it is drawn."""
        yield from self.leads(self.figures(SCHEME))
        yield self.head(words.LAW)
        yield from self._law()
        yield from self._centres()
        yield from self._limits()
        yield from self._profile()
        yield from self._spring()
        yield from self._checks()
        for name in list(self.pictures):
            yield from self.leads(self.figures(name))
        yield from self.tabled()

    # ------------------------------------------------------------ parts

    def _law(self) -> Iterator[Block]:
        order, diagrams = self.recorded.order, self.recorded.diagrams
        if order.rocks:
            yield self.says(words.ROCKS)
        said = words_plate if order.slides else words
        yield self.says(said.BASE)
        steps = (formulas_plate.scale_of_travel, f.scale_of_stroke, to_board, f.angle_of_part)
        yield from self.formulas(VIEWS["S"], *steps)
        yield self.says(said.RADIANS)
        yield from self.formulas(VIEWS["S"], f.radians_of)
        yield from self.formulas(CALCULATED, f.radians_of)
        phases = diagrams.turn.phases
        laws = [phase.law for phase in phases]
        names = (one.name if one.split == 0.5 else "unequal shares" for one in laws)
        for name in dict.fromkeys(names):
            yield self.says(words.LAWS[name])
        if any(one.law.name == BY_TABLE and one.law != one.motion.law for one in phases):
            yield self.says(words.SPLINE)
        for integral in diagrams.integrals:
            for which in ("A", "V", "S"):
                at = integral.phase.first + max(1, integral.phase.parts // 4)
                yield from self.view(integral.views[which], at=at)
        for one in (diagrams.S, diagrams.V, diagrams.A):
            yield from self.formulas(one.axes.view, *RADII)
        yield from self.leads(self.figures("cam-diagrams"))
        lengths = {segment: self.cell(segment, mm=True) for segment in ("S", "dS", "ddS")}
        travel, speed, rate = map(self.cell, lengths)
        angle = self._angle()
        yield self.says(said.READ, lengths, angle=angle, travel=travel, speed=speed, rate=rate)

    def _centres(self) -> Iterator[Block]:
        centre = self.recorded.centre
        if not (isinstance(centre, Centre) and isinstance(self.recorded.path, Path)):
            yield from self.view(centre.view, self.figures(centre.view))
            return
        yield self.head(words.CENTRES)
        yield from self.leads(self.figures(CENTRE))
        if centre.mu == self.recorded.diagrams.S.chart.mu:
            yield self.says(words.AS_STROKE)
            yield Display(
                (Formula((Symbol("μ_l"), self.letter(centre.mu), self.number(centre.mu))),)
            )
        yield self.steps(words.ROLLER)
        yield self.says(words.LEAST)
        yield from self.worked_out(centre.least)
        if centre.apex_radius is not None:
            yield self.says(words.APEX)
            yield from self.worked_out(centre.apex_radius)
        yield self.says(words.CHOSEN, r0=centre.r0)
        yield from self.worked_out(centre.radius)
        yield self.says(words.ANGLE, angle=self.cell("pressure"))

    def _limits(self) -> Iterator[Block]:
        made = self.recorded
        yield self.head(words.LIMITS)
        if made.pressure is not None:
            yield self.says((words_plate if made.order.slides else words).EXTREMES)
            for one in made.pressure.extremes:
                yield from self.worked_out(one.angle, one.value)
        if isinstance(made.path, Drum):
            yield self.says((words_plate if made.order.slides else words_drum).CURVATURE)
            of = made.centre.view
            yield from self.formulas(of, formulas_drum.turning_of_tangent, first=True)
            yield from self.formulas(CURVATURE, f.curvature_of_profile, first=True)
        elif isinstance(made.centre, Centre):
            yield self.says(words.CURVATURE)
            yield from self.formulas(CENTRE, f.turning_of_normal, first=True)
            yield from self.formulas(CURVATURE, f.curvature_of_profile, first=True)
            yield self._parts(made.centre)
        elif made.path is None:
            yield from self.formulas(CENTRE, f.flat_radius)
        yield self.says(words.SHARPEST)
        for one in made.curvature.extremes:
            yield from self.worked_out(one.angle, one.value)
        if made.contact is not None:
            yield self.says(words.FACE)
            for one in made.contact.extremes:
                yield from self.worked_out(one.angle, one.value)
            yield from self.formulas(CONTACT, f.face_length)
        yield from self.leads(self.figures("cam-limits"))

    def _parts(self, centre: Centre) -> Paragraph:
        """Say what the letters of the turning of the normal stand for."""
        step = self.drawn.construction.step(centre.turning[0])
        assert step is not None
        letters = {name: self.letter(mark) for name, mark in marks_of(step).items()}
        swings = self.recorded.order.rocks
        return self.says((words.PARTS, words.SWUNG if swings else words.CARRIED), letters)

    def _profile(self) -> Iterator[Block]:
        roller = self.recorded.roller
        if roller is None or not isinstance(self.recorded.path, Path):
            of = self.recorded.profile.view
            yield from self.view(of, self.figures(of))
            return
        yield self.head(words.PROFILE)
        yield self.says(words.ALLOWED)
        limits = (roller.by_r0, roller.by_curvature)
        yield from self.worked_out(*(one for one in limits if one is not None))
        yield self.says(words.TAKEN, radius=roller.radius)
        yield from self.formulas(PROFILE, to_board)
        yield self.steps(words.REVERSED)
        yield self.says(words.REACH, s0=self.letter(self.recorded.path.s0))
        yield from self.formulas(PROFILE, total)
        yield from self.leads(self.figures(PROFILE))

    def _spring(self) -> Iterator[Block]:
        spring, of = self.recorded.spring, self.recorded.order.spring
        if spring is None or of is None:
            return
        yield self.head(words_spring.SPRING)
        yield self.says(words_spring.INERTIA)
        yield from self.formulas(INERTIA, formulas_spring.follower_inertia, first=True)
        yield self.says(words_spring.SOUGHT if of.rate is None else words_spring.GIVEN)
        if of.rate is None:
            yield from self.worked_out(spring.preload, spring.rate)
        yield self.says(words_spring.CONTACT)
        yield from self.formulas(SPRING, formulas_spring.closing, first=True)
        for diagram in (spring.contact, spring.moment):
            for extreme in diagram.extremes:
                yield from self.worked_out(extreme.angle, extreme.value)
        yield from self.leads(self.figures("cam-spring", "cam-spring-line"))

    def _checks(self) -> Iterator[Block]:
        beside = BESIDE.on(self.drawn)
        yield self.head(words.CHECKS)
        yield self.says(words.LEFT)
        yield from self.worked_out(*beside.left.values())
        moving = [one for one in (beside.velocity, beside.acceleration) if one is not None]
        if moving:
            step = self.drawn.construction.step(moving[0])
            assert step is not None
            yield self.says(words.MOVING, speed=step.uses[0])
            yield from self.worked_out(*moving)

    def _angle(self) -> Number:
        """Return the angle of the cam in the position that is worked."""
        found = self.number(self.recorded.diagrams.angle)
        return found._replace(text=number(found.value, self.language))


NOTE = Noted(CamPage)
