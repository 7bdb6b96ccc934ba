"""A check from a photograph: points that are seen in it are judged; what is not seen is asked for."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from graphic_tmm.board.hand import HANDS
from graphic_tmm.checking.cells import points
from graphic_tmm.checking.check import check
from graphic_tmm.checking.judging.scatter import Limits
from graphic_tmm.checking.own_sheet.clicked import (
    ClickedPlan,
    ClickedScale,
    turn_notes,
)
from graphic_tmm.checking.own_sheet.plans import read_clicked
from graphic_tmm.checking.own_sheet.proposals import proposals
from graphic_tmm.checking.pencil.darkness import Flat
from graphic_tmm.checking.pencil.expected import Name, views
from graphic_tmm.checking.pencil.points import SEEN, UNSEEN
from graphic_tmm.checking.pencil.reading import (
    PhotoPoints,
    Point,
    Pole,
    questions,
    read_plans,
    readings,
)
from graphic_tmm.checking.photo.camera import Shot
from graphic_tmm.checking.pictures import Laid
from graphic_tmm.checking.readings.writing import write_readings
from graphic_tmm.checking.records import Judged, PlanSight, Report, Sight, Taken
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.errors import SheetError
from graphic_tmm.files import write
from graphic_tmm.fitting.composition import Composition
from graphic_tmm.language.said import said
from graphic_tmm.paper.drawing import Drawing, Sheet, Stroke, Wanted, circle, line
from graphic_tmm.paper.labels import leaders, place
from graphic_tmm.paper.lettering.letters import escape
from graphic_tmm.paper.ruled import Box
from graphic_tmm.scene.captions import view_name
from graphic_tmm.scene.records import Scene

CROSS, RING = 1.6, 1.6
"""Half of the cross at a point that was seen, the radius of the ring about one that is not sure, mm."""
LETTERS = 2.5
"""The size of the letters beside them, mm."""


class Photographed(NamedTuple):
    """What a photograph gave: the points of its plans, the readings of those that were seen.

    ``scales``: those of the student, where plans were clicked; ``sight``: how much was seen; ``plans``: as they
    were drawn due at clicked poles.
    """

    found: PhotoPoints
    taken: tuple[Taken, ...]
    scales: tuple[ClickedScale, ...] = ()
    sight: Sight | None = None
    plans: tuple[Drawing, ...] = ()


def poles_of(given: Iterable[str]) -> dict[Pole, complex]:
    """Return the poles that somebody clicked, px of the photograph, by plan and position.

    Raises
    ------
    SheetError
        If one is not written as ``velocities:3=1200,840``.
    """
    found: dict[Pole, complex] = {}
    for text in given:
        name, _, place = text.rpartition("=")
        plan, _, position = name.partition(":")
        try:
            x, y = (float(part) for part in place.split(","))
        except ValueError:
            x = y = float("nan")
        if not (plan and position and abs(x) + abs(y) < float("inf")):
            raise SheetError(
                said(
                    "--pole: write plan, position and where its pole is in the photograph, "
                    '"velocities:3=1200,840"'
                )
            )
        found[plan, position] = complex(x, y)
    return found


def photographed(
    shown: Laid, clicked: Mapping[Pole, complex], hand: str, plans: Sequence[ClickedPlan] = ()
) -> Photographed | None:
    """Return what a flattened photograph shows of the plans of its sheet; None if there are none on it.

    ``clicked``: poles in the photograph, px; ``hand``: of whose size errors may be; ``plans``: where the
    student has drawn his, px.

    Raises
    ------
    SheetError
        If a pole is clicked of a plan that this sheet does not have, or not on the sheet.
    """
    own = dict.fromkeys((one.plan, one.position) for one in plans)
    due = [] if shown.own_paper else views(shown.made, shown.sheet, HANDS[hand])
    due = [view for view in due if own.keys().isdisjoint(view.poles)]
    poles = {pole for view in due for pole in view.poles}
    for plan, position in clicked:
        if (plan, position) not in poles:
            raise SheetError(
                said(
                    "--pole: there is no plan {plan}, position {position} on sheet {number}",
                    plan=plan,
                    position=position,
                    number=shown.number,
                )
            )
    if not due and not plans:
        return None
    shot, flat = _shot(shown), _flat(shown)
    places = {pole: _on_sheet(shot, flat.area, "--pole", pole, at) for pole, at in clicked.items()}
    found = read_plans(flat, due, places)
    asked = (*poles, *own)
    if not plans:
        return _whole(shown.made, found, asked)
    there = [_clicked(shown.made, shot, flat.area, one) for one in plans]
    read = read_clicked(shown.made, flat, there, HANDS[hand])
    both = PhotoPoints((*found.points, *read.found.points), (*found.missing, *read.found.missing))
    return _whole(read.made, both, asked)._replace(scales=read.scales, plans=read.plans)


def _shot(shown: Laid) -> Shot:
    photo = shown.flat
    return Shot(photo.image, photo.homography, photo.lens, photo.curl)


def _flat(shown: Laid) -> Flat:
    photo = shown.flat
    return Flat(
        photo.image, photo.area, photo.image.shape[1] / (photo.area.right - photo.area.left)
    )


class ProposedPlans(NamedTuple):
    """Plans that a photograph seems to show, in its dots, to be confirmed; a drawing of where they stand."""

    plans: tuple[ClickedPlan, ...]
    drawing: Drawing


def proposed(shown: Laid, hand: str, language: str) -> ProposedPlans:
    """Return which plans a flattened photograph seems to show, wherever they stand; nothing is judged by it."""
    shot = _shot(shown)
    there = [one.plan for one in proposals(shown.made, _flat(shown), HANDS[hand])]
    strokes: list[Stroke] = []
    wanted: list[Wanted] = []
    seen = []
    for one in there:
        assert one.first is not None
        told = f"{view_name(one.plan, language)}, {one.position}"
        arms = [(one.pole - CROSS * way, one.pole + CROSS * way) for way in (1 + 1j, 1 - 1j)]
        ends = (*arms, (one.pole, one.first))
        strokes += [line("main", a, b)._replace(title=told) for a, b in ends]
        wanted.append(Wanted(escape(told), one.pole, LETTERS, CROSS, 1 - 1j))
        pole, first = (complex(shot.to_picture(z)) for z in (one.pole, one.first))
        seen.append(one._replace(pole=pole, first=first))
    labels = place(wanted, strokes, [])
    ink = (*strokes, *leaders(wanted, labels))
    return ProposedPlans(tuple(seen), Drawing("proposed", said("Plans proposed"), ink, labels))


def _whole(made: DrawnScene, found: PhotoPoints, asked: Iterable[Pole]) -> Photographed:
    return Photographed(found, readings(found.points), sight=sight_of(found, points(made), asked))


ALIKE = 2.5
"""A point that is not sure is no other than it is due if it seems to be no farther off, mm."""


def sight_of(found: PhotoPoints, due: Mapping[Name, complex], asked: Iterable[Pole]) -> Sight:
    """Return how much was seen of the plans that were asked for; ``due``: their points, mm from the pole.

    A plan is seen if half of its points are, and the others seem to be where they are due.
    """
    wanted = dict.fromkeys(asked)
    by: dict[Pole, list[Point]] = {}
    for one in found.points:
        plan, _, position = one.name
        by.setdefault((plan, position), []).append(one)
    unseen: dict[str, list[str]] = {plan: [] for plan, _ in wanted}
    partly: dict[str, list[str]] = {plan: [] for plan, _ in wanted}
    for plan, position in wanted:
        own = by.get((plan, position), [])
        sure = [one for one in own if one.how == SEEN]
        rest = (
            one.how == SEEN or (one.how != UNSEEN and abs(one.spot - due[one.name]) < ALIKE)
            for one in own
        )
        if 2 * len(sure) < len(own) or not own or not all(rest):
            (partly if sure else unseen)[plan].append(position)
    counts = Counter(plan for plan, _ in wanted)
    known = sum((plan, position) in wanted for plan, _, position in due)
    seen = sum(one.how == SEEN for one in found.points)
    return Sight(
        seen,
        known,
        tuple(
            PlanSight(plan, counts[plan], tuple(unseen[plan]), tuple(partly[plan]))
            for plan in unseen
        ),
    )


def _clicked(made: DrawnScene, shot: Shot, sheet: Box, one: ClickedPlan) -> ClickedPlan:
    """Return a clicked plan where it stands on the sheet, mm."""
    pole = one.plan, one.position
    if not any((plan, position) == pole for plan, _, position in points(made)):
        raise SheetError(
            said(
                "--plan: there is no plan {plan}, position {position}; plans of positions, velocities and "
                "accelerations can be clicked",
                plan=one.plan,
                position=one.position,
            )
        )
    at, first = (
        None if z is None else _on_sheet(shot, sheet, "--plan", pole, z)
        for z in (one.pole, one.first)
    )
    assert at is not None
    return one._replace(pole=at, first=first)


def _on_sheet(shot: Shot, sheet: Box, option: str, pole: Pole, at: complex) -> complex:
    """Return where on the sheet somebody clicked, mm; raises SheetError if that is beside it."""
    off = at - shot.lens.middle
    half = shot.lens.middle + complex(0.5, 0.5)
    if abs(off.real) <= half.real and abs(off.imag) <= half.imag:
        place = complex(shot.sheet(at))
        if sheet.left <= place.real <= sheet.right and sheet.bottom <= place.imag <= sheet.top:
            return place
    plan, position = pole
    raise SheetError(
        said(
            "{option} {plan}:{position}: {x:g},{y:g} is not on the sheet in the photograph: give x and y "
            "in its dots",
            option=option,
            plan=plan,
            position=position,
            x=at.real,
            y=at.imag,
        )
    )


def judged(
    scene: Scene,
    seen: Photographed,
    *,
    hand: str,
    trials: int,
    limits: Limits,
    given: Composition | None = None,
    stated: tuple[Sequence[str], Sequence[str]] = ((), ()),
    source: str,
) -> Report:
    """Return the report on what a photograph shows; its notes ask for what it does not.

    ``stated``: the scale factors in which plans were drawn, and how they were turned, as for `check`.
    Clicked plans are in the student's own, as he turned them: nothing else is sought for them.
    """
    own = seen.scales
    scales = [*(f"{one.plan}={one.mu if one.another else 'scene'}" for one in own), *stated[0]]
    turns = [*(f"{one.plan}=0" for one in own), *stated[1]]
    report = check(
        scene,
        seen.taken,
        hand=hand,
        points="own sheet" if own else "photo",
        trials=trials,
        limits=limits,
        given=given,
        scales=scales,
        turns=turns,
        source=source,
    )
    asked = questions(seen.found, scene.language)
    notes = (*turn_notes(own, scene.language), *report.notes, *asked)
    return report._replace(notes=notes, sight=seen.sight)


def write_seen(file: str, seen: Photographed, language: str) -> tuple[Path, ...]:
    """Write the points that were seen as a file of readings, to be corrected by hand and checked."""
    path = Path(file)
    text = write_readings(seen.taken, language=language)
    return write(
        path.parent, {path.name: text}, remedy=said("name another file with --readings-out")
    )


def points_drawing(seen: Photographed, report: Report, sheet: Sheet) -> Drawing:
    """Return a cross at each point that was seen, with its letter and error, a ring at one that is not sure.

    Letters keep off each other and off those of the ``sheet``.
    """
    strokes: list[Stroke] = []
    wanted: list[Wanted] = []
    for one, told in _lettered(seen, report):
        if one.how == SEEN:
            arms = (1 + 1j, 1 - 1j)
            drawn = [line("thin", one.at - CROSS * way, one.at + CROSS * way) for way in arms]
        else:
            drawn = [circle("thin", one.at, RING)]
        strokes += [stroke._replace(title=told) for stroke in drawn]
        wanted.append(Wanted(escape(told), one.at, LETTERS, CROSS, 1 - 1j))
    labels = place(wanted, strokes, [one for view in sheet.drawings for one in view.labels])
    ink = (*strokes, *leaders(wanted, labels))
    return Drawing("photographed", said("Points seen"), ink, labels)


def marked(shown: Laid, seen: Photographed, report: Report) -> tuple[dict[str, Any], ...]:
    """Return where in the photograph, px, points were seen, as JSON takes it; how each is told and judged."""
    by = {one.taken.key: one.verdict for one in report.readings}
    shot = _shot(shown)
    found = []
    for one, told in _lettered(seen, report):
        at = complex(shot.to_picture(one.at))
        verdict = by.get(one.name, "") if one.how == SEEN else ""
        found.append(
            {"x": round(at.real, 1), "y": round(at.imag, 1), "text": told, "verdict": verdict}
        )
    return tuple(found)


def _lettered(seen: Photographed, report: Report) -> Iterator[tuple[Point, str]]:
    """Yield points that were seen with letter and error, and those that are not sure, with a question mark."""
    by = {one.taken.key: one for one in report.readings}
    for one in seen.found.points:
        letter = one.name[1]
        if one.how == SEEN:
            error = _error(by.get(one.name))
            yield one, f"{letter}: {error}" if error else letter
        elif one.how != UNSEEN:
            yield one, f"{letter}?"


def _error(one: Judged | None) -> str:
    """Return the error that a step made itself, or the deviation, as it is written beside a point."""
    if one is None:
        return ""
    return f"{abs(one.deviation if one.own is None else one.own):.1f}"
