"""How large the constructions may be drawn; their μ_l, by crank and rod in one line."""

from __future__ import annotations

from collections.abc import Container, Iterator

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Mark
from graphic_tmm.board.scales import Scale
from graphic_tmm.chapters.klein.record import KLEIN_PLAN
from graphic_tmm.chapters.klein.task import KLEIN, VIEWS
from graphic_tmm.fitting.choice import usual_room
from graphic_tmm.fitting.scales import ScaleFactor, ScaleFactors, Sized, scale_of
from graphic_tmm.fitting.sizes import Size, Sizing
from graphic_tmm.language.said import said
from graphic_tmm.project import Project

ROOM = 200.0
"""Room for crank and rod in one line, mm on an A1, on other formats in proportion."""

SIZES = Sizing(
    sizes=(Size(KLEIN, ROOM, in_mm=True, low=0.6, high=1.5, least=0.3),),
    depends={KLEIN: lambda scene, role: (KLEIN,)},
)


_WHY = said("Crank and rod in one line take {room}.", room=usual_room(ROOM))


def _factors(sized: Sized) -> Iterator[ScaleFactor]:
    """Yield μ_l of the constructions."""
    made = KLEIN_PLAN.on(sized)
    most, room = made.of.crank + made.of.length, sized.sizes[KLEIN]
    for figure in made.figures.values():
        yield ScaleFactor(figure.scales[0], "l_{max}", most, room, lengths=True, why=_WHY)


def _named(project: Project, reading: Reading, given: Container[Mark]) -> dict[str, Scale]:
    """Return μ of velocities and of accelerations, which follow from μ_l and ω."""
    made, found = KLEIN_PLAN.of(project), dict[str, Scale]()
    for view, figure in made.figures.items() if made is not None else ():
        found |= {f"{view} {mu.name}": scale_of(mu, reading) for mu in figure.scales[1:]}
    return found


def _keys(project: Project) -> dict[str, str]:
    signs = {f"{view} μ_{sign}": f"mu_{sign}_{view}" for view in VIEWS for sign in "va"}
    return {**{view: f"mu_l_{view}" for view in VIEWS}, **signs}


SCALES = ScaleFactors(factors=_factors, named=_named, keys=_keys)
