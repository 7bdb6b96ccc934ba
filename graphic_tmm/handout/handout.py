"""The series of a scene as sheets and as files: an overview of all pictures, then picture by picture."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from graphic_tmm.drawn import DrawnScene
from graphic_tmm.errors import Fault, SceneError
from graphic_tmm.handout.chosen import chosen
from graphic_tmm.handout.ink import times
from graphic_tmm.handout.series import Picture, Series, series
from graphic_tmm.handout.sheets import (
    BETWEEN,
    CAPTION,
    TITLE,
    advance,
    framed,
    pages,
    paper,
    set_rows,
)
from graphic_tmm.handout.words import broken
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.paper.drawing import Drawing, Label, Sheet, shifted
from graphic_tmm.readers.protocol import plans as every_plan
from graphic_tmm.scene.captions import plans_named
from graphic_tmm.scene.packaged import scene_name
from graphic_tmm.scene.records import Scene

ACROSS = (3, 4, 5, 6)
"""Pictures beside one another: so few that one sheet holds all of them, else as many as can be."""
HIGH = 1.1
"""How high a picture is at most, of its width."""
GAP = 5.0
"""Between pictures beside one another, mm."""
NUMBER = 3.5
"""Height of their numbers, mm."""
ABOVE = 1.5
"""Clear between a number and its picture, mm."""


def overview(some: Sequence[Series], title: str, language: str) -> list[list[Drawing]]:
    """Return what stands on the sheets of the overview, a list a sheet, without their frames."""
    tried = (_overview(some, title, language, across) for across in ACROSS)
    return next((found for found in tried if len(found) == 1), None) or _overview(
        some, title, language, ACROSS[-1]
    )


def _overview(
    some: Sequence[Series], title: str, language: str, across: int
) -> list[list[Drawing]]:
    room = paper(language)
    told = list(broken(title, TITLE, room.right - room.head.real))
    head = Drawing("overview title", title, (), tuple(set_rows(told, room.head)))
    start = room.top - max(sum(map(advance, told)), ROOM) - BETWEEN
    wide = (room.right - room.left - GAP * (across - 1)) / across
    found: list[list[Drawing]] = []
    top = room.bottom
    for one in some:
        high = NUMBER + ABOVE + _factor(one, wide) * (one.box[3] - one.box[1])
        for k in range(0, len(one.pictures), across):
            heading = list(broken(one.title, CAPTION, room.right - room.left)) if k == 0 else []
            above = sum(map(advance, heading)) + (ABOVE if heading else 0.0)
            if top - above - high < room.bottom:
                found.append([head])
                top = start
            if heading:
                labels = tuple(set_rows(heading, complex(room.left, top)))
                found[-1].append(Drawing(f"{one.name} heading", one.title, (), labels))
            top -= above
            for n, picture in enumerate(one.pictures[k : k + across]):
                at = complex(room.left + n * (wide + GAP), top)
                found[-1].append(_small(one, picture, at, wide))
            top -= high + GAP
    return found


ROOM = 9.0
"""The head of a sheet is no lower, mm: the frame has something beside it."""


def _factor(one: Series, wide: float) -> float:
    """Return how many times smaller the pictures of a series stand here; ``wide``: their room, mm."""
    x0, y0, x1, y1 = one.box
    return min(1.0, wide / (x1 - x0), HIGH * wide / (y1 - y0))


def _small(one: Series, picture: Picture, at: complex, wide: float) -> Drawing:
    """Return a picture made small, without its letters: they could not be read."""
    factor = _factor(one, wide)
    x0, _, x1, y1 = (factor * edge for edge in one.box)
    by = at - 1j * (NUMBER + ABOVE) + (wide - (x1 - x0)) / 2 - complex(x0, y1)
    strokes = tuple(shifted(times(stroke, factor), by) for stroke in picture.ink)
    number = Label(str(picture.number), at - 1j * NUMBER, NUMBER)
    return Drawing(f"{one.name} small {picture.number}", one.title, strokes, (number,))


OVERVIEW = said("Overview of the pictures")


def all_series(made: DrawnScene, plans: Sequence[str], position: str | None) -> list[Series]:
    """Return the series of the views of plans.

    Raises
    ------
    SceneError
        If there is no such position, or nothing is drawn of the plans in it.
    """
    found = chosen(made, plans, position)
    if not found:
        names = [plan for plan in every_plan() if chosen(made, (plan,), position)]
        says = said(
            "nothing is drawn of {listed}, so there are no pictures: leave out --sheets, "
            "or choose from {known}",
            listed=plans_named(plans, made.scene.language),
            known=plans_named(names, made.scene.language) or said("none"),
        )
        raise SceneError(made.scene.source, (Fault("--plan", 0, says),))
    return [series(one.drawn, one.draw, one.place, one.untold) for one in found]


def handout(made: DrawnScene, plans: Sequence[str], position: str | None) -> list[Sheet]:
    """Return the sheets of the series of plans, an overview before them; see `all_series`."""
    return framed_series(made.scene, all_series(made, plans, position))


def framed_series(scene: Scene, found: Sequence[Series]) -> list[Sheet]:
    """Return series on sheets in their frames, an overview before them."""
    papers = [(one.title, drawings) for one in found for drawings in pages(one)]
    title = speaking(scene.language)(OVERVIEW)
    first = [(title, drawings) for drawings in overview(found, title, scene.language)]
    return framed(
        [*first, *papers],
        scene.title_block,
        scene.title,
        scene.language,
        check=scene.print_check,
    )


def handout_files(
    made: DrawnScene, plans: Sequence[str], position: str | None, formats: Sequence[str]
) -> dict[str, str | bytes]:
    """Return the files of the sheets by name: a file for each, but one PDF for all of them."""
    from graphic_tmm.paper.write.export import pdf, png
    from graphic_tmm.paper.write.svg import svg

    one: dict[str, Callable[[Sheet], str | bytes]] = {"svg": svg, "png": png}
    drawn = handout(made, plans, position)
    stem, digits = f"{scene_name(made.scene.source)}-steps", len(str(len(drawn)))
    files: dict[str, str | bytes] = {}
    for form in formats:
        if form == "pdf":
            files[f"{stem}.pdf"] = pdf(drawn)
        else:
            for k, sheet in enumerate(drawn, 1):
                files[f"{stem}-{k:0{digits}}.{form}"] = one[form](sheet)
    return files
