"""The series of a scene as sheets and as files: an overview of all pictures, then picture by picture."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from graphic_tmm.drawn import DrawnScene
from graphic_tmm.errors import Fault, SceneError
from graphic_tmm.handout.chosen import chosen
from graphic_tmm.handout.contact import overview
from graphic_tmm.handout.series import Series, series
from graphic_tmm.handout.sheets import framed, pages
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.paper.drawing import Sheet
from graphic_tmm.readers.protocol import plans as every_plan
from graphic_tmm.scene.captions import plans_named
from graphic_tmm.scene.packaged import scene_name
from graphic_tmm.scene.records import Scene

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
