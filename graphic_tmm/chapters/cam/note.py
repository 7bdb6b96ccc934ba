"""The section of a cam in a note: law of motion, region of centres, limits, profile; what follows."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.board.operations.formulas import to_board, total
from graphic_tmm.chapters.cam import formulas as f
from graphic_tmm.chapters.cam import formulas as law
from graphic_tmm.chapters.cam import note_page as words
from graphic_tmm.chapters.cam.centre import VIEW as CENTRE
from graphic_tmm.chapters.cam.centre import Centre, Path
from graphic_tmm.chapters.cam.diagrams import VIEWS
from graphic_tmm.chapters.cam.findings import verdict
from graphic_tmm.chapters.cam.ink_scheme import NAME as SCHEME
from graphic_tmm.chapters.cam.note_page import CamPage
from graphic_tmm.chapters.cam.plan import CAM_PLAN
from graphic_tmm.chapters.cam.profile import VIEW as PROFILE
from graphic_tmm.chapters.cam.record import BESIDE
from graphic_tmm.chapters.cam.record import VIEW as CALCULATED
from graphic_tmm.chapters.cam.table import cam_columns, cam_marks
from graphic_tmm.chapters.cam.task import CAM
from graphic_tmm.chapters.cam.turn import CURVATURE, PRESSURE
from graphic_tmm.drawn import Drawn, results_of
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.note.bricks import asked_number, columns, filled, heading, result_number, results
from graphic_tmm.note.document import Block, Paragraph, Run, Runs, Text
from graphic_tmm.note.section_chapter import Noted
from graphic_tmm.scene.chapter import chapters

RADIUS = said("The least radius of the cam is {least}; taken is {taken}.")
PRESSURE_KEPT = said(
    "The pressure angle reaches {rise} on the rise and {back} on the return; allowed are {allowed} and "
    "{behind}."
)


def concludes(drawn: Drawn, language: str) -> Iterator[Runs]:
    """Yield what the limits of the cam come to; those that are passed are warnings."""
    made, _ = CAM_PLAN.of(drawn), speaking(language)
    if made is None:
        return
    results = results_of(drawn, cam_marks(made))

    def figure_run(name: str) -> Run:
        return result_number(drawn, results, name, language)

    yield filled(_(RADIUS), {"least": figure_run("r0_min"), "taken": figure_run("r0")})
    if "pressure_rise" in results:
        back = "pressure" if made.order.pressure_return is None else "pressure_return"
        limits = {
            "allowed": asked_number(drawn, "cam", "pressure", "°", language),
            "behind": asked_number(drawn, "cam", back, "°", language),
        }
        both = {"rise": figure_run("pressure_rise"), "back": figure_run("pressure_return")}
        yield filled(_(PRESSURE_KEPT), {**both, **limits})


RADII = (
    law.sine_radius, law.sine_radius_V, law.sine_radius_A, law.cosine_radius, law.cosine_radius_V,
    law.cosine_radius_A, law.parabola_V, law.parabola_A, law.polynomial_S, law.polynomial_V, law.polynomial_A,
)  # fmt: skip
"""What a law is drawn by."""


def note(drawn: Drawn, language: str) -> Iterator[Block]:
    """Yield the section of a cam."""
    made = CAM_PLAN.of(drawn)
    if made is not None:
        yield from _Page(drawn, made, language).blocks()


class _Page(CamPage):
    """What is told of a cam."""

    def blocks(self) -> Iterator[Block]:
        """Yield what is told of a cam, in the order in which it is drawn."""
        yield from self.drawn_as(SCHEME)
        yield heading(self.speech(words.LAW))
        yield from self._law()
        yield from self._centres()
        yield from self._limits()
        yield from self._profile()
        yield from self._checks()
        for name in list(self.figures):
            yield from self.drawn_as(name)
        yield from columns(self.drawn, cam_columns(self.drawn), self.language)
        yield from self._results()

    # ------------------------------------------------------------ parts

    def _law(self) -> Iterator[Block]:
        order, diagrams = self.made.order, self.made.diagrams
        yield self.says(words.BASE)
        yield from self.formulas(VIEWS["S"], f.scale_of_stroke, to_board, f.angle_of_part)
        yield self.says(words.RADIANS)
        yield from self.formulas(VIEWS["S"], f.radians_of)
        yield from self.formulas(CALCULATED, f.radians_of)
        for name in dict.fromkeys((order.rise_law.name, order.return_law.name)):
            yield self.says(words.LAWS[name])
        for integral in diagrams.integrals:
            for which in ("A", "V", "S"):
                at = integral.phase.first + max(1, integral.phase.parts // 4)
                yield from self.from_log(integral.views[which], at)
        for view in VIEWS.values():
            yield from self.formulas(view, *RADII)
        yield from self.drawn_as("cam-diagrams")
        yield self._read()

    def _read(self) -> Paragraph:
        """Return what the diagrams tell in the position that is worked."""
        put: dict[str, Run] = {"position": Text(self.position), "angle": self.angle()}
        for key, segment in (("S", "S"), ("dS", "dS"), ("ddS", "ddS")):
            put[key] = self.cell(segment, 0)
        for key, segment in (("travel", "S"), ("speed", "dS"), ("rate", "ddS")):
            put[key] = self.cell(segment, 1)
        return self.says(words.READ, put)

    def _centres(self) -> Iterator[Block]:
        made, centre = self.made, self.made.centre
        told = self.of(CENTRE)
        if not (isinstance(centre, Centre) and isinstance(made.path, Path)) or told is None:
            yield from self.from_log(CENTRE, self.at, self.taken(CENTRE))
            return
        yield heading(self.speech(words.CENTRES))
        yield from self.drawn_as(CENTRE)
        yield self.steps(words.ROLLER)
        yield self.says(words.LEAST)
        yield from self.worked_out(told, centre.least)
        if centre.apex_radius is not None:
            yield self.says(words.APEX)
            yield from self.worked_out(told, centre.apex_radius)
        yield self.says(words.CHOSEN, {"r0": told.number(centre.r0, unit=True)})
        yield from self.worked_out(told, centre.radius)
        put: dict[str, Run] = {
            "position": Text(self.position),
            "angle": told.number(centre.pressure),
        }
        yield self.says(words.ANGLE, put)

    def _limits(self) -> Iterator[Block]:
        made = self.made
        yield heading(self.speech(words.LIMITS))
        if made.pressure is not None and (told := self.of(PRESSURE)) is not None:
            yield self.says(words.EXTREMES)
            for one in made.pressure.extremes:
                yield from self.worked_out(told, one.angle, one.value)
        told = self.of(CURVATURE)
        if told is None:
            return
        where = {"position": Text(self.position)}
        if isinstance(made.centre, Centre):
            yield self.says(words.CURVATURE, {**where})
            yield from self.formulas(CENTRE, f.turning_of_normal, first=True)
            yield from self.formulas(CURVATURE, f.curvature_of_profile, first=True)
        else:
            yield from self.formulas(CENTRE, f.flat_radius)
        yield self.says(words.SHARPEST)
        for one in made.curvature.extremes:
            yield from self.worked_out(told, one.angle, one.value)
        yield from self.drawn_as("cam-limits")

    def _profile(self) -> Iterator[Block]:
        made, told = self.made, self.of(PROFILE)
        if made.roller is None or not isinstance(made.path, Path) or told is None:
            yield from self.from_log(PROFILE, self.at, self.taken(PROFILE))
            return
        yield heading(self.speech(words.PROFILE))
        yield self.says(words.ALLOWED)
        yield from self.worked_out(told, made.roller.by_r0, made.roller.by_curvature)
        yield self.says(words.TAKEN, {"radius": told.number(made.roller.radius, unit=True)})
        yield from self.formulas(PROFILE, to_board)
        yield self.steps(words.REVERSED)
        yield self.says(words.REACH, {"position": Text(self.position)})
        yield from self.formulas(PROFILE, total)
        yield from self.drawn_as(PROFILE)

    def _checks(self) -> Iterator[Block]:
        beside, told = BESIDE.on(self.drawn), self.of(CALCULATED)
        if told is None:
            return
        yield heading(self.speech(words.CHECKS))
        yield self.says(words.LEFT)
        yield from self.worked_out(told, *beside.left.values())
        moving = [one for one in (beside.velocity, beside.acceleration) if one is not None]
        if moving:
            step = told.log.step(moving[0])
            assert step is not None
            put: dict[str, Run] = {
                "speed": told.number(step.uses[0], unit=True),
                "position": Text(self.position),
            }
            yield self.says(words.MOVING, put)
            yield from self.worked_out(told, *moving)

    def _results(self) -> Iterator[Block]:
        own = next(one for one in chapters() if one.name == CAM)
        yield from results(self.drawn, own, self.language)


def _concludes(drawn: Drawn, language: str) -> Iterator[Runs]:
    yield from concludes(drawn, language)
    yield from verdict(drawn, language)


NOTE = Noted(section=note, concludes=_concludes)
