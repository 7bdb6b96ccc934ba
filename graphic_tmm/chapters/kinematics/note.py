"""The section of kinematics in a note: extreme positions, plans with their figures, tables of all positions."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.kinematics import views
from graphic_tmm.chapters.kinematics.plan import KinematicPlans
from graphic_tmm.chapters.kinematics.task import (
    ACCELERATIONS,
    BY_DRIVE,
    EXTREMES,
    POSITIONS,
    VELOCITIES,
)
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.said import said
from graphic_tmm.note.document import Block, Picture
from graphic_tmm.note.figures import picture, readable
from graphic_tmm.note.page import COLUMNS, Page
from graphic_tmm.note.section_chapter import Noted
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.formats import heights
from graphic_tmm.paper.lettering.letters import escape
from graphic_tmm.paper.views import captioned, mu_text
from graphic_tmm.readers.protocol import title_of
from graphic_tmm.scene.captions import captions

SIZES = said(
    "The tables give lengths, and velocities and accelerations of points, without signs, which stand in the "
    "calculations; those of turning have theirs: plus is counter-clockwise."
)


class KinematicPage(Page[KinematicPlans]):
    """Each plan is drawn in one position, the tables hold all."""

    tables = (COLUMNS,)

    def views(self) -> list[Drawing]:
        """Return the plan of positions."""
        return readable(self.drawn, lambda held: views.position_views(held, True))

    def blocks(self) -> Iterator[Block]:
        """Yield what is told: extreme positions, plans, columns."""
        yield from self.view(EXTREMES)
        yield from self.view(POSITIONS, self.figures(*self.pictures))
        yield from self.view(VELOCITIES, self._plan(VELOCITIES))
        for one in self.recorded.apart:
            yield from self.view(one.mu.view, self._plan(one.mu.view))
        if self.recorded.summed:
            yield from self.view(BY_DRIVE, self._sums())
        yield from self.view(ACCELERATIONS, self._plan(ACCELERATIONS))
        if self.columns:
            yield self.says(SIZES)
        yield from self.tabled()

    def _plan(self, plan: str) -> tuple[Picture, ...]:
        """Return a plan in one position; velocity plans from a common pole all together."""
        drawn, language = self.drawn, self.language
        row = drawn.row(plan)
        if drawn.of(plan) is None or plan not in drawn.scales or not row:
            return ()
        if plan == VELOCITIES and drawn.scene.common_pole and len(row) > 1:
            found = readable(drawn, lambda held: views.velocity_views(held, True))
            return tuple(picture(one, language) for one in found)
        place = self.at if self.at in row else row[0]
        title = f"{title_of(drawn.project, plan, language)}, {captions(language)['position']}"
        title = f"{title} {drawn.names[place]}"
        mu, name = mu_text(drawn.scales[plan], language), f"{plan}-{drawn.names[place]}"

        def draw(held: Drawn) -> list[Drawing]:
            view = views.plan_at(held, plan, place, name, title, ())
            return [captioned(view, escape(title), mu, heights=heights(held.scene, plan))]

        return tuple(picture(view, language) for view in readable(drawn, draw))

    def _sums(self) -> tuple[Picture, ...]:
        """Return the velocities that are added up in one position."""
        mu = mu_text(self.drawn.scales[VELOCITIES], self.language)

        def draw(held: Drawn) -> list[Drawing]:
            return [
                captioned(one, escape(one.title), mu, heights=heights(held.scene, BY_DRIVE))
                for one in views.sums(held, (self.at,), True)
            ]

        return tuple(picture(view, self.language) for view in readable(self.drawn, draw))


NOTE = Noted(KinematicPage)
