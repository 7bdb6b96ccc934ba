"""How the sheets of a class are composed: those of each variant begin with the composition of the scene.

Whoever speaks of the sheets of a variant, a key or a check, has its composition from here: they speak of the
same sheets, and nobody searches for sizes thirty times.
"""

from __future__ import annotations

from graphic_tmm.classroom.variants.variant import Base
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.errors import TmmError
from graphic_tmm.files import read
from graphic_tmm.fitting.compose import Composed
from graphic_tmm.fitting.composition import (
    COMPOSITION,
    Composition,
    composition_file,
    known_composition,
    read_composition,
    text,
)
from graphic_tmm.fitting.given import all_fixed
from graphic_tmm.project import own_boards
from graphic_tmm.scene.read import judged
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import composed_as_large, composed_sheets, draws_mechanism


def nearby_composition(source: str) -> str:
    """Return the composition that stands beside a scene, as its file holds it; "" if there is none.

    Raises
    ------
    SceneError
        If what stands there is no composition.
    """
    file = composition_file(source)
    return "" if read_composition(file) is None else read(file, COMPOSITION).decode("utf-8")


def kept_composition(text: str, source: str) -> Composition | None:
    """Return a composition that was kept as its file beside a scene holds it; None of ""."""
    return known_composition(text.encode("utf-8"), composition_file(source)) if text else None


def start_of(of: Base) -> str:
    """Return the composition that variants begin with, as its file holds it.

    That which stands beside the scene, or as it is composed now; "" if the scene cannot be drawn itself: its
    variants may be better.

    Raises
    ------
    SceneError
        If what stands beside the scene is no composition.
    """
    if there := nearby_composition(str(of.file)):
        return there
    try:
        found = composed_sheets(judged(of.text.encode("utf-8"), of.file))[1]
    except TmmError:
        return ""
    return text(found.composition, found.scales)


def begun(scene: Scene, start: str, own: str = "") -> tuple[DrawnScene, Composed]:
    """Draw the scene of a variant onto its sheets; ``start``: see `start_of`, "" to compose it by itself.

    ``own``: the language of its text, if it may be drawn in another: how large its plans are does not hang on
    that, or a task in one language would be judged wrongly in another.

    Raises
    ------
    TmmError
        If it cannot be drawn, or a view fits no sheet.
    """
    given = kept_composition(start, scene.source)
    if scene.spoken_in(own) is scene:
        return composed_sheets(scene, given, near=True)
    _, found = composed_sheets(scene.spoken_in(own), given, near=True)
    return composed_as_large(scene, found.composition)


def drawn_by(scene: Scene, start: str) -> Composition | None:
    """Return a composition by which a variant's figures are those of its sheets, wherever its views stand.

    ``scene``: in the language of its text. ``start``, errors: as for `begun`. Where the scene fixes every scale
    factor no sheet is composed for it.
    """
    if start and all_fixed(scene, mechanism=draws_mechanism(scene, own_boards(scene))):
        return kept_composition(start, scene.source)
    return begun(scene, start)[1].composition
