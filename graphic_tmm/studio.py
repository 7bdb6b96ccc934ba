"""From a scene to what is drawn of it, a few verbs in a row: record, choose scales, execute; compose, write."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence, Set
from contextlib import suppress
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING

from graphic_tmm.board.hand import MOST, Hand
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.errors import TmmError, ViewError
from graphic_tmm.fitting.absent import in_doubt, without_absent
from graphic_tmm.fitting.auto import formatted
from graphic_tmm.fitting.composition import Composition, composition_file, text
from graphic_tmm.fitting.given import drawn_as, larger
from graphic_tmm.fitting.remedies import refusal, refuse_tiny
from graphic_tmm.project import own_boards
from graphic_tmm.scene.chapter import chapters
from graphic_tmm.scene.packaged import scene_name
from graphic_tmm.scene.records import Scene

if TYPE_CHECKING:
    from graphic_tmm.fitting.compose import Composed
    from graphic_tmm.paper.drawing import Sheet

FORMATS = ("svg", "pdf", "png", "dxf")
"""What sheets can be written as."""
Whole = Mapping[str, Callable[[DrawnScene, Sequence["Sheet"]], str | bytes]]
"""Formats in which a file holds a whole scene."""


def make(
    scene: Scene,
    *,
    exact: bool = False,
    wanted: Set[str] | None = None,
    given: Composition | None = None,
) -> DrawnScene:
    """Draw a scene: its mechanism, if it has one, and its parts.

    Everything that it calls for is drawn, or only the ``wanted`` places of sheets; whether the rest can be
    drawn is tested all the same. ``given``: a composition that fixes all sizes.

    A chapter without a result is left out (`absent`).

    Raises
    ------
    SceneError
        If it has neither, or nothing that it asks for has a result.
    SheetError
        If a scale factor that it fixes draws a plan too small to measure.
    """
    try:
        made = _make(scene, exact, wanted, given)
    except TmmError:
        if (other := without_absent(scene)) is None:
            raise
    else:
        other = without_absent(scene) if in_doubt(made.boards) else None
        if other is None:
            return made
    return make(other, exact=exact, wanted=wanted, given=given)


def _make(
    scene: Scene, exact: bool, wanted: Set[str] | None, given: Composition | None
) -> DrawnScene:
    from graphic_tmm.fitting.fit import fitted_boards, turned

    scene = formatted(scene, given)
    mechanism = draws_mechanism(scene, own_boards(scene))
    if given is not None and given.sizes:
        boards = drawn_as(scene, given.sizes, exact=exact, wanted=wanted, mechanism=mechanism)
    else:
        scene = turned(scene, mechanism=mechanism)
        boards = fitted_boards(scene, exact=exact, wanted=wanted, mechanism=mechanism)
    if mechanism:
        refuse_tiny(scene, boards[0])
    return DrawnScene(scene, boards)


def draws_mechanism(scene: Scene, parts: Sequence[object]) -> bool:
    """Whether a mechanism is drawn, or has to be: a scene of parts alone, or of lettering, has none."""
    plain = {place.name for one in chapters("") for place in one.places}
    return scene.mechanism is not None or not (parts or scene.shown_places <= plain)


def blocks(made: DrawnScene, hand: Hand) -> Iterator[DrawnScene]:
    """Yield the drawings that a hand makes, all trials of a block at once: so much is held at a time."""
    for first in range(0, hand.trials, MOST):
        some = hand._replace(first=hand.first + first, trials=min(MOST, hand.trials - first))
        yield DrawnScene(made.scene, tuple(one.drawn_by(some) for one in made.boards))


def drawings(made: DrawnScene, hand: Hand) -> Iterator[DrawnScene]:
    """Yield the drawings that a hand makes, one a trial."""
    for block in blocks(made, hand):
        for k in range(block.trials):
            yield DrawnScene(made.scene, tuple(one.trial(k) for one in block.boards))


def sheets(scene: Scene) -> tuple[DrawnScene, tuple[Sheet, ...]]:
    """Draw a scene onto its sheets; further sheets follow if those ordered do not hold it."""
    made, found = composed_sheets(scene)
    return made, found.sheets


def composed_sheets(
    scene: Scene, given: Composition | None = None, *, near: bool = False
) -> tuple[DrawnScene, Composed]:
    """Draw a scene onto its sheets, composed anew or as ``given``; its warnings say what became of that.

    A composition of another scene may be given: it is used as far as it fits; if nothing fits, its sizes are
    dropped, too. ``near``: it belongs to a similar scene and is only the start: plans are as large as there, or
    a little larger while that takes no more sheets, and no warning mentions it.

    Raises
    ------
    SheetError
        If a view fits no sheet: the key that makes it so large, and a remedy.
    """
    from graphic_tmm.fitting.compose import composed

    if near and given is not None:
        return _begun_with(scene, given) or composed_sheets(scene)
    made = make(scene, wanted=scene.shown_places, given=given)
    try:
        found = composed(made.scene, made.boards, given)
    except ViewError as error:
        raise refusal(made.scene, error) from error
    told = replace(made.scene, remarks=(*made.scene.remarks, *found.remarks))
    if not found.sheets and given is not None:
        return composed_sheets(replace(scene, remarks=told.remarks))
    return made._replace(scene=told), found


def _begun_with(scene: Scene, given: Composition) -> tuple[DrawnScene, Composed] | None:
    """Draw a scene onto as many sheets as one like it, plans about as large; None if that fails."""
    from graphic_tmm.fitting.compose import composed

    scene = formatted(scene, given)
    mechanism = draws_mechanism(scene, own_boards(scene))
    for sizes in (larger(scene, given.sizes, mechanism=mechanism), given.sizes):
        if sizes is None:
            continue
        with suppress(ViewError):
            made = make(scene, wanted=scene.shown_places, given=given._replace(sizes=sizes))
            found = composed(made.scene, made.boards, given, near=True)
            if len(found.sheets) == len(given.sheets):
                told = replace(made.scene, remarks=(*made.scene.remarks, *found.remarks))
                return made._replace(scene=told), found
    return None


def composed_as_large(scene: Scene, given: Composition) -> tuple[DrawnScene, Composed]:
    """Draw a scene as large as a composition has it, its views where that has them if they fit there.

    Raises
    ------
    SheetError
        As `composed_sheets`, in whose sizes it is drawn if a view fits no sheet so large.
    """
    from graphic_tmm.fitting.compose import composed

    made = make(scene, wanted=scene.shown_places, given=given)
    with suppress(ViewError):
        return made, composed(made.scene, made.boards, given, near=True)
    return composed_sheets(scene)


def sheet_files(
    scene: Scene,
    formats: Sequence[str] = ("svg",),
    *,
    strokes: bool = False,
    given: Composition | None = None,
    composition: bool = False,
    whole: Whole | None = None,
) -> tuple[DrawnScene, dict[str, str | bytes]]:
    """Draw a scene; return its files by name, see `files_of`. ``given``: a composition to draw it by."""
    made, found = composed_sheets(scene, given)
    files = files_of(made, found, formats, strokes=strokes, composition=composition, whole=whole)
    return made, files


def files_of(
    made: DrawnScene,
    found: Composed,
    formats: Sequence[str],
    *,
    strokes: bool = False,
    composition: bool = False,
    whole: Whole | None = None,
) -> dict[str, str | bytes]:
    """Return the sheets of a scene as files by name: a file for each sheet, but one PDF for all of them.

    ``strokes``: the letters of a DXF as strokes, not as text. ``composition``: theirs is a file, too.
    ``whole``: further formats in which a file holds the whole scene.
    """
    from graphic_tmm.paper.write.dxf import dxf
    from graphic_tmm.paper.write.export import pdf, png
    from graphic_tmm.paper.write.svg import svg

    lettered = partial(dxf, stroked=strokes)
    one: dict[str, Callable[[Sheet], str | bytes]] = {"svg": svg, "png": png, "dxf": lettered}
    drawn, stem = found.sheets, scene_name(made.scene.source)
    names = [stem if len(drawn) == 1 else f"{stem}-{k + 1}" for k in range(len(drawn))]
    files: dict[str, str | bytes] = {}
    for form in formats:
        if form == "pdf":
            files[f"{stem}.pdf"] = pdf(drawn)
        elif form in (whole or {}):
            files[f"{stem}.{form}"] = (whole or {})[form](made, drawn)
        else:
            for name, sheet in zip(names, drawn, strict=True):
                files[f"{name}.{form}"] = one[form](sheet)
    if composition:
        files[composition_file(made.scene.source).name] = text(found.composition, found.scales)
    return files
