"""A file of readings to be filled in: a row for all that can be measured of a scene."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from graphic_tmm.checking.cells import points, position_names
from graphic_tmm.checking.readings.writing import asked, file_of, result_columns
from graphic_tmm.checking.records import Taken
from graphic_tmm.checking.template.letters import letters_sheet
from graphic_tmm.checking.template.short import short
from graphic_tmm.fitting.composition import Composition
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.readers.table import scene_columns, scene_results
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import make


def template_of(scene: Scene, name: str = "template.csv") -> str | bytes:
    """Return the file of all that can be measured of a scene, to be filled in.

    ``name``: of the file; a workbook for ``.xlsx``, else CSV.
    """
    return file_of(name, rows_of(scene), language=scene.language)


def short_of(
    scene: Scene,
    name: str = "template.csv",
    only: Sequence[str] = (),
    position: str = "",
    *,
    pictured: bool = True,
    given: Composition | None = None,
) -> dict[str, str | bytes]:
    """Return the file of the main segments of one position, or of what is marked, and a picture of the letters.

    ``only``, ``position``: as `short` has them; ``name``: as `template_of`; ``pictured``: whether there is
    a picture; ``given``: the composition of the sheets, as for `make`. Files by name; the picture has the name
    of the first.

    Raises
    ------
    SheetError
        If the scene does not have what is asked for.
    """
    from graphic_tmm.paper.write.svg import svg

    made = make(scene, exact=True, given=given)
    asked_for = short(made, only, position)
    told, picture = asked_for.told, letters_sheet(made, asked_for.places) if pictured else None
    beside = f"{Path(name).stem}.svg"
    if picture is not None:
        shows = said("The letters of the plans are shown in {file}.", file=beside)
        told = (*told, speaking(scene.language)(shows))
    files = {name: file_of(name, asked_for.rows, language=scene.language, told=told)}
    return files if picture is None else {**files, beside: svg(picture)}


def rows_of(scene: Scene) -> list[Taken]:
    """Return a row for all that can be measured of a scene, its figures empty."""
    made = make(scene, exact=True)
    columns = [*scene_columns(made), *result_columns(scene_results(made))]
    letters = dict.fromkeys((plan, letter) for plan, letter, _ in points(made))
    return asked(columns, position_names(made), tuple(letters))
