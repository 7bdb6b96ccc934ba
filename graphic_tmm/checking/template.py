"""A file of readings to be filled in: a row for all that can be measured of a scene."""

from __future__ import annotations

from graphic_tmm.checking.cells import points, position_names
from graphic_tmm.checking.readings.writing import result_columns, template
from graphic_tmm.readers.table import scene_columns, scene_results
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import make


def template_of(scene: Scene) -> str:
    """Return the CSV file of all that can be measured of a scene, to be filled in."""
    made = make(scene, exact=True)
    names = position_names(made)
    rows = [*scene_columns(made), *result_columns(scene_results(made))]
    letters = dict.fromkeys((plan, letter) for plan, letter, _ in points(made))
    return template(rows, names, tuple(letters), language=scene.language)
