"""The section of kinematics in a note: extreme positions, plans with their figures, tables of all positions."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.kinematics import views
from graphic_tmm.chapters.kinematics.table import kinematic_columns
from graphic_tmm.chapters.kinematics.task import ACCELERATIONS, EXTREMES, POSITIONS, VELOCITIES
from graphic_tmm.drawn import Drawn
from graphic_tmm.note.bricks import columns, worked
from graphic_tmm.note.document import Block, Picture
from graphic_tmm.note.figures import in_hand, picture, readable
from graphic_tmm.note.plans import section_table
from graphic_tmm.note.protocol import Known
from graphic_tmm.note.section_chapter import Noted
from graphic_tmm.paper.formats import heights
from graphic_tmm.paper.lettering.letters import escape
from graphic_tmm.paper.views import captioned, mu_text
from graphic_tmm.readers.protocol import title_of
from graphic_tmm.scene.captions import captions


def note(drawn: Drawn, language: str) -> Iterator[Block]:
    """Yield the section of kinematics: each plan is drawn in one position, the tables hold all."""
    at = worked(drawn)
    known: Known = set()
    yield from section_table(drawn, EXTREMES, at, language, known=known)
    shown = _positions(drawn, language)
    yield from section_table(drawn, POSITIONS, at, language, shown, known=known)
    for view in (VELOCITIES, ACCELERATIONS):
        yield from section_table(
            drawn, view, at, language, _plan(drawn, view, at, language), known=known
        )
    yield from columns(drawn, kinematic_columns(drawn), language)


def _positions(drawn: Drawn, language: str) -> tuple[Picture, ...]:
    return tuple(picture(one, language) for one in readable(drawn, views.position_views))


def _plan(drawn: Drawn, view: str, at: int, language: str) -> tuple[Picture, ...]:
    """Return a plan in one position; velocity plans from a common pole all together."""
    row, held = drawn.row(view), in_hand(drawn)
    if drawn.of(view) is None or view not in drawn.scales or not row:
        return ()
    if view == VELOCITIES and drawn.scene.common_pole and len(row) > 1:
        return tuple(picture(one, language) for one in views.velocity_views(held, True))
    place = at if at in row else row[0]
    title = f"{title_of(drawn.project, view, language)}, {captions(language)['position']}"
    title = f"{title} {drawn.names[place]}"
    found = views.plan_at(held, view, place, f"{view}-{drawn.names[place]}", title, ())
    mu, high = mu_text(drawn.scales[view], language), heights(held.scene, view)
    return (picture(captioned(found, escape(title), mu, heights=high), language),)


NOTE = Noted(section=note)
