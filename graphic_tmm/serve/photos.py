"""A photograph that a browser sends: which plans may be clicked in it, what its check says, as by ``photo``."""

from __future__ import annotations

from pathlib import Path
from typing import Any, NamedTuple

from graphic_tmm.checking.cells import points
from graphic_tmm.checking.judging.scatter import Limits
from graphic_tmm.checking.own_sheet.clicked import first_letter, may_be_clicked, plans_of
from graphic_tmm.checking.photo.picture import Sent
from graphic_tmm.checking.photographed import judged, marked, photographed, proposed
from graphic_tmm.checking.pictures import Laid, laid
from graphic_tmm.checking.report.findings import headline
from graphic_tmm.checking.report.html import html_report
from graphic_tmm.errors import SheetError, printable
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.paper.formats import PAPERS
from graphic_tmm.paper.lettering.letters import missing
from graphic_tmm.scene.captions import view_name
from graphic_tmm.scene.read import judged as read_text
from graphic_tmm.serve.jobs import Task, composed, composition_of, refusing, scene_of

HAND, TRIALS = "student", 400
"""By whose drawings a photograph is judged, and by how many: as ``photo`` does where nothing else is said."""


class Clicked(NamedTuple):
    """A photograph, and what was clicked in it, as ``photo`` takes it.

    ``plans``: as after --plan; ``corners``, ``paper``, ``sheet``: as after these options.
    """

    name: str
    data: bytes
    plans: tuple[str, ...] = ()
    corners: str = ""
    paper: str = ""
    sheet: int = 1


class Checked(NamedTuple):
    """What a check says: the report as a page, its headline and what is to be known of the photograph.

    ``marks``: the points that were seen, where in the photograph, px, and how each is told.
    """

    page: bytes
    says: str
    warnings: tuple[str, ...]
    marks: tuple[dict[str, Any], ...]


@refusing
def clickable(task: Task) -> dict[str, Any]:
    """Return the plans of a scene that may be clicked, in order, as JSON takes them; its sheets, papers.

    Of each plan: as code calls it and people do, the letters of its pole and of the end of its first vector,
    its positions.
    """
    made, found = composed(task)
    work, language = made.mechanism, made.scene.language
    positions: dict[str, dict[str, None]] = {}
    for plan, _, position in points(made):
        positions.setdefault(plan, {})[position] = None
    plans = []
    for plan in positions:
        view = None if work is None else work.construction.view(plan)
        if view is not None and view.pole is not None and may_be_clicked(made, plan):
            plans.append(
                {
                    "plan": plan,
                    "name": view_name(plan, language),
                    "pole": view.pole.letter,
                    "first": first_letter(made, plan),
                    "positions": list(positions[plan]),
                }
            )
    formats = [one.format.partition(" ")[0] for one in found.sheets]
    return {"plans": plans, "sheets": formats, "papers": list(PAPERS)}


@refusing
def plans_proposed(task: Task, clicked: Clicked) -> list[dict[str, Any]]:
    """Return the plans that a photograph seems to show, as JSON takes them: pole and first vector, px."""
    shown = _laid(task, clicked)
    return [
        {
            "plan": one.plan,
            "position": one.position,
            "pole": _dots(one.pole),
            "first": None if one.first is None else _dots(one.first),
        }
        for one in proposed(shown, HAND, scene_of(task).language).plans
    ]


def _dots(at: complex) -> tuple[float, float]:
    return round(at.real, 1), round(at.imag, 1)


@refusing
def photo_checked(task: Task, clicked: Clicked) -> Checked:
    """Return what the check of a photograph says.

    Raises
    ------
    TmmError
        Whatever ``photo`` would end with, also if nothing is to be looked for.
    """
    scene, given = scene_of(task), composition_of(task)
    plans = plans_of(clicked.plans)
    shown = _laid(task, clicked)
    seen = photographed(shown, {}, HAND, plans)
    if seen is None:
        raise SheetError(
            said("no plan of this sheet is due in the photograph, and none is clicked")
        )
    report = judged(
        scene,
        seen,
        hand=HAND,
        trials=TRIALS,
        limits=Limits(),
        given=given,
        source=printable(clicked.name),
    )
    speech = speaking(scene.language)
    warnings = tuple(printable(speech(one)) for one in shown.flat.warnings)
    page = html_report(report).encode()
    return Checked(page, headline(report), warnings, marked(shown, seen, report))


def _laid(task: Task, clicked: Clicked) -> Laid:
    """Return a flattened photograph; the form on the sheet is the scene's, whatever language is told."""
    drawn = read_text(task.data, Path(task.file), missing=missing)
    sent = Sent(printable(clicked.name), clicked.data)
    given = composition_of(task)
    return laid(drawn, sent, clicked.corners, clicked.sheet, given, clicked.paper)
