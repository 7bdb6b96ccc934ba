"""The settings of a scene that bear on accuracy, varied one at a time."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import NamedTuple

from graphic_tmm.accuracy.quantities import Accuracy, Axis
from graphic_tmm.board.hand import HANDS, Hand
from graphic_tmm.drawn import DrawnScene, hand_of
from graphic_tmm.language.said import said
from graphic_tmm.project import called_on
from graphic_tmm.readers.position_count import at_count
from graphic_tmm.scene.chapter import MECHANISM, chapters
from graphic_tmm.scene.records import Scene

OWN = "scene"
"""The hand that a scene names, with the ruler that it names."""
EACH_SLIP = ("prick", "compass", "swing", "reading", "digits")
"""The five slips of a hand."""
GRID = ("exact", "cad", "careful", "student")
"""The named hands, from the most exact on."""


@dataclass(frozen=True)
class Setting:
    """How a scene is drawn.

    ``hand``: what the hand is called, ``who`` with ruler, seed and number of drawings; ``enlarged``: how many
    times larger than the scene asks for; ``pole``: how many times farther the poles of its graphs.
    """

    scene: Scene
    hand: str
    who: Hand
    enlarged: float = 1.0
    pole: float = 1.0

    def by(self, name: str, who: Hand) -> Setting:
        """Return the same, drawn by another hand."""
        return replace(self, hand=name, who=who)


def hand_named(name: str, scene: Scene, trials: int) -> Hand:
    """Return a hand by its name, with the scene's seed; the exact one reads without a ruler.

    A hand that leaves nothing to chance draws once.
    """
    hand = hand_of(scene) if name == OWN else HANDS[name]
    return hand._replace(seed=scene.seed, trials=trials if hand.slips else 1)


def enlarge(scene: Scene, made: DrawnScene, times: float) -> Scene:
    """Return a scene drawn larger than ``made`` by a factor: every μ finer by it."""
    for drawn in made.boards:
        for chapter in chapters(drawn.board):
            scene = Accuracy.of(chapter).enlarged(scene, drawn, times)
    return scene


COUNTS = (4, 6, 8, 10, 12, 14, 16, 18, 24, 36, 48)
"""Numbers of positions that every hand draws."""
LONG = (96, 192, 384, 768)
"""Numbers of positions for the exact hand alone."""
RULERS = (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0)
"""Divisions of the ruler, mm."""
SIZES = (0.5, 1.0, 2.0, 4.0)
"""How many times as large the drawing is; 2: every μ twice as fine, and four times the paper."""
POLES = (0.5, 1.0, 2.0)
"""How many times as large the pole distances are: halved and doubled shows which way it goes."""
TRIALS = (10, 30, 100, 300, 1000)
"""Numbers of drawings, up to ten times the wanted number."""


class Varied(NamedTuple):
    """A setting on an axis: the axis, the value there as text, ``only``: the quantities that it bears upon."""

    axis: str
    value: str
    setting: Setting
    only: tuple[str, ...] | None = None


def _rows(scene: Scene) -> Iterator[tuple[str, Scene]]:
    """Yield the scene with other numbers of positions, as far as these have what it names."""
    if scene.mechanism is not None and called_on(scene, MECHANISM):
        for n in sorted({*COUNTS, *LONG, scene.row.count}):
            found = at_count(scene, n)
            if found is not None:
                yield str(n), found


POSITIONS = Axis(
    "positions",
    _rows,
    parts=lambda scene: scene.row.count,
    counted=said("{n} position", "{n} positions"),
)
"""The row of positions, which is that of all chapters on the mechanism's board."""


def dividing() -> dict[str, Axis]:
    """Return the axes along which a drawing is divided finer, by name."""
    told = (axis for one in chapters() for axis in Accuracy.of(one).axes if axis.parts is not None)
    return {axis.name: axis for axis in (POSITIONS, *told)}


def own_parts(scene: Scene, axis: str) -> int:
    """Return into how many parts a scene itself divides its drawing."""
    parts = dividing()[axis].parts
    return (parts(scene) if parts is not None else 0) or scene.row.count


def grid(own: Setting, trials: int) -> Iterator[Varied]:
    """Yield the number of positions (of whatever a drawing is divided into) by hands."""
    hands = [(name, hand_named(name, own.scene, trials)) for name in GRID]
    if (own.hand, own.who) not in hands:
        hands.append((own.hand, own.who))
    for axis, divided in rows(own.scene):
        for value, scene in divided:
            exact_only = is_long(axis, value)
            for name, who in hands[:1] if exact_only else hands:
                yield Varied(axis, value, replace(own, scene=scene).by(name, who))


def rows(scene: Scene) -> Iterator[tuple[str, list[tuple[str, Scene]]]]:
    """Yield the axes along which a drawing is divided finer, and the scenes on them."""
    for name, axis in dividing().items():
        if divided := list(axis.scenes(scene)):
            yield name, divided


def is_long(axis: str, value: str) -> bool:
    """Whether a row has too many positions for any but the exact hand."""
    return axis == POSITIONS.name and int(value) in LONG


def singly(own: Setting, trials: int) -> Iterator[Varied]:
    """Yield the settings that differ from the scene's own in one thing."""
    for axis in (_slips, _rulers, _sizes):
        yield from axis(own, trials)
    yield from _declared(own)
    student = HANDS["student"]._replace(seed=own.scene.seed)
    for n in (n for n in TRIALS if n <= 10 * trials):
        yield Varied("trials", str(n), own.by("student", student._replace(trials=n)))


def _slips(own: Setting, trials: int) -> Iterator[Varied]:
    student = HANDS["student"]
    for name in EACH_SLIP:
        alone: dict[str, object] = {name: getattr(student, name)}
        who = Hand(seed=own.scene.seed)._replace(**alone)  # type: ignore[arg-type]
        who = who._replace(trials=trials if who.slips else 1)
        yield Varied("slip", name, own.by(f"student, {name}", who))


def _rulers(own: Setting, trials: int) -> Iterator[Varied]:
    for division in RULERS:
        who = own.who._replace(ruler=division)
        yield Varied("ruler", f"{division:g}", own.by(own.hand, who))


def _sizes(own: Setting, trials: int) -> Iterator[Varied]:
    for times in SIZES:
        yield Varied("size", f"{times:g}", replace(own, enlarged=times))


def _declared(own: Setting) -> Iterator[Varied]:
    """Yield the quantities of chapters, each with its poles; all poles move together."""
    moved = False
    for chapter in chapters():
        for axis in Accuracy.of(chapter).axes:
            if axis.parts is None:
                bears = axis.bears(own.scene)
                for value, scene in axis.scenes(own.scene):
                    yield Varied(axis.name, value, replace(own, scene=scene), bears)
        if Accuracy.of(chapter).poles(own.scene) and not moved:
            moved = True
            yield from _poles(own)


def _poles(own: Setting) -> Iterator[Varied]:
    only = tuple(name for one in chapters() for name in Accuracy.of(one).poles(own.scene))
    for times in POLES:
        yield Varied("pole", f"{times:g}", replace(own, pole=times), only)


def own_setting(scene: Scene, hand: str | None, trials: int) -> Setting:
    """Return a scene's own setting, drawn by its own hand or by another that is named.

    A scene's hand that has the ruler of its name is called by that name.
    """
    who = hand_named(hand or OWN, scene, trials)
    alike = (name for name in GRID if hand_named(name, scene, trials) == who)
    return Setting(scene, hand or next(alike, OWN), who)
