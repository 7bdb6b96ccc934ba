"""Parts that are drawn on a board of their own: a cam, a pair of gears, a planetary train.

Their logs have positions of their own (angles of the cam, steps of a rolling flank, satellites), so each is a
construction and a reading by itself; a scene may have them beside a mechanism or without one.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Set
from dataclasses import dataclass, replace
from typing import NamedTuple

from graphic_tmm.board.doubt import Doubts
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import Reading, execute
from graphic_tmm.board.findings import Finding, examine
from graphic_tmm.board.hand import EXACT, Hand
from graphic_tmm.board.record import Construction, Mark
from graphic_tmm.board.scales import Scale, standard_length
from graphic_tmm.board.values import Angle
from graphic_tmm.chapters.cam.findings import cam_findings
from graphic_tmm.chapters.cam.plan import Cam, draw_cam
from graphic_tmm.chapters.cam.table import cam_marks, cam_names
from graphic_tmm.chapters.gears.plan import Gear, draw_gear, gear_scales
from graphic_tmm.chapters.gears.results import gear_results
from graphic_tmm.chapters.planetary.plan import Planetary, draw_overall, draw_planetary
from graphic_tmm.errors import StructureError
from graphic_tmm.scaling import free_scales
from graphic_tmm.scene.places import FREE_PLACES, alone
from graphic_tmm.scene.records import Scene
from graphic_tmm.work import hand_of

Results = dict[str, tuple[float, str]]


@dataclass(frozen=True)
class Part:
    """A part as drawn: its kind (a place of sheets), its marks, its log, what was given, its numbers."""

    kind: str
    scene: Scene
    made: Cam | Gear | Planetary
    construction: Construction
    given: Mapping[Mark, object]
    reading: Reading
    hand: Hand
    extra: Mapping[str, Mark]

    def results(self) -> Results:
        """Return the results by name: value and unit."""
        found: Results = {}
        if isinstance(self.made, Gear):
            found = gear_results(self.made, self.reading)
        marks = dict(self.extra)
        if isinstance(self.made, Cam):
            marks = {**cam_marks(self.made), **marks}
        if isinstance(self.made, Planetary):
            marks = {**self.made.results, **marks}
        more = {k: (float(self.reading.figure(m).ravel()[0]), _unit(m)) for k, m in marks.items()}
        return found | more

    @property
    def names(self) -> tuple[str, ...]:
        """The numbers of its positions, as on the sheet."""
        if isinstance(self.made, Cam):
            return tuple(cam_names(self.made))
        return tuple(str(k + 1) for k in range(self.reading.positions))

    def drawn_by(self, hand: Hand) -> Part:
        """Return the same drawing by another hand."""
        reading = execute(self.construction, self.given, hand=hand)
        return replace(self, reading=replace(reading, doubts=self.reading.doubts), hand=hand)

    def trial(self, k: int) -> Part:
        """Return one of the drawings of a hand that drew several times."""
        return replace(self, reading=self.reading.trial(k))

    def scales(self) -> dict[str, Scale]:
        """Return the scale factors of the views, by view."""
        found = {}
        for view in self.construction.views:
            if view.scale is not None:
                value = float(self.reading[view.scale].ravel()[0])
                found[view.name] = Scale(view.scale.name, value, view.scale.unit)
        return found

    def limits(self, language: str) -> tuple[str, ...]:
        """Return, as sentences, the limits that a part passes."""
        if not isinstance(self.made, Cam):
            return ()
        return tuple(f.says(language) for f in cam_findings(self.reading, self.made))

    def findings(self) -> tuple[Finding, ...]:
        """Return what could not be drawn."""
        wanted = [step.it for step in self.construction.steps if not step.op.across]
        return examine(self.construction, self.given, wanted, hand=self.hand)


def _unit(mark: Mark) -> str:
    return "°" if mark.kind is Angle else mark.unit


def draw_parts(
    scene: Scene, *, exact: bool = False, wanted: Set[str] | None = None
) -> tuple[Part, ...]:
    """Draw the parts that the scene calls for; of those that are not ``wanted`` only tell if they can be made.

    Raises
    ------
    StructureError
        If a part cannot be made; the message names the scene.
    """
    hand = EXACT if exact else hand_of(scene)
    wanted = scene.called if wanted is None else wanted
    found = []
    try:
        for kind in alone():
            if kind in scene.called:
                recorded = _RECORD[kind](scene)
                found += [_part(kind, scene, recorded, hand)] if kind in wanted else []
    except StructureError as error:
        raise scene.located(error) from error
    return tuple(found)


def resized(part: Part, sizes: Mapping[str, float]) -> Part:
    """Return a part, drawn in the usual size, with its sizes at a share of that.

    ``sizes``: of what `free_sizes` tells. Scale factors of lengths stay standard ones.
    """
    scene, share = part.scene, sizes.get(part.kind, 1.0)
    if isinstance(part.made, Cam):
        assert scene.tasks.get("cam") is not None
        order = replace(
            scene.tasks["cam"], base=scene.tasks["cam"].base * sizes.get("cam graphs", 1.0)
        )
        if share < 1.0:
            mu = float(part.reading[part.made.profile.mu][0, 0])
            order = replace(order, mu_l=standard_length(mu / share, 1.0))
        return _part("cam", scene, _cam(scene.asking(cam=order)), part.hand)
    if isinstance(part.made, Gear) and share < 1.0:
        assert scene.tasks.get("gears") is not None
        mu = float(part.reading[part.made.line.mu][0, 0])
        order_ = replace(scene.tasks["gears"], mu=standard_length(mu / share, 1.0))
        return _part("gears", scene, _gears(scene.asking(gears=order_)), part.hand)
    if isinstance(part.made, Planetary) and share < 1.0:
        return _part("planetary", scene, _planetary(scene, share), part.hand)
    return part


def free_sizes(scene: Scene, kind: str) -> tuple[str, ...]:
    """Return the sizes of a part that its scene leaves free."""
    keys = {
        "cam": {"cam": "cam.mu_l", "cam graphs": "cam.base"},
        "gears": {"gears": "gears.mu_l"},
        "planetary": {"planetary": "planetary.mu_l"},
    }
    return tuple(name for name, key in keys[kind].items() if key not in scene.told)


def draws_mechanism(scene: Scene, parts: tuple[Part, ...]) -> bool:
    """Whether a mechanism is drawn, or has to be: a scene of parts alone, or of lettering, has none."""
    return scene.mechanism is not None or not (parts or scene.shown <= set(FREE_PLACES))


class _Recorded(NamedTuple):
    """A part as recorded: its marks, its board, further marks of results, how its scales are chosen."""

    made: Cam | Gear | Planetary
    draft: Draft
    extra: Mapping[str, Mark]
    scales: Callable[[], Mapping[Mark, object]]


def _gears(scene: Scene) -> _Recorded:
    assert scene.tasks.get("gears") is not None
    draft = Draft()
    made = draw_gear(draft, scene.tasks["gears"])
    return _Recorded(made, draft, {}, lambda: gear_scales(draft, made))


def _planetary(scene: Scene, size: float = 1.0) -> _Recorded:
    assert scene.tasks.get("planetary") is not None
    draft = Draft()
    made = draw_planetary(draft, scene.tasks["planetary"], size)
    extra = {}
    if made.order.behind:
        extra["overall_ratio"] = draw_overall(draft, made, *made.order.behind)
    return _Recorded(made, draft, extra, dict)


def _cam(scene: Scene) -> _Recorded:
    assert scene.tasks.get("cam") is not None
    draft = Draft()
    made = draw_cam(draft, scene.tasks["cam"])
    return _Recorded(
        made, draft, {}, lambda: free_scales(made.charts, draft.board.construction(), draft.given)
    )


def _part(kind: str, scene: Scene, recorded: _Recorded, hand: Hand) -> Part:
    made, draft, extra, scales = recorded
    log, given = draft.board.construction(), {**draft.given, **scales()}
    reading = execute(log, given, hand=hand).doubted(Doubts(log.steps, given))
    return Part(kind, scene, made, log, given, reading, hand, extra)


_RECORD: Mapping[str, Callable[[Scene], _Recorded]] = {
    "cam": _cam,
    "gears": _gears,
    "planetary": _planetary,
}
