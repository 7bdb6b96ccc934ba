"""What a chapter tells of its accuracy: its quantities, what can be varied, what follows for scenes."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from typing import ClassVar, NamedTuple

from graphic_tmm.accuracy.quantity import Quantity
from graphic_tmm.board.record import Construction, Mark
from graphic_tmm.drawn import Drawn
from graphic_tmm.project import Project
from graphic_tmm.scene.chapter import Answer
from graphic_tmm.scene.records import Scene


class Trial(NamedTuple):
    """A smaller construction that is tried at an angle until the reading changes its sign."""

    log: Construction
    angle: Mark
    reading: Mark


@dataclass(frozen=True)
class Axis:
    """What of a scene can be varied, by a name.

    ``scenes``: the scenes along it, each with its value as text; none if the scene does not call for it.
    ``bears``: the quantities that it bears upon. ``parts``: where the axis divides a drawing finer, into how
    many parts a scene itself does, 0 if it does not: it bears upon all then. ``counted``: so many parts, with
    their noun. ``free``: it may be chosen so that an error is kept within.
    """

    name: str
    scenes: Callable[[Scene], Iterable[tuple[str, Scene]]]
    bears: tuple[str, ...] = ()
    parts: Callable[[Scene], int] | None = None
    free: bool = False
    counted: str = ""


@dataclass(frozen=True)
class Accuracy(Answer):
    """What a chapter tells of its accuracy; what it leaves out it has nothing to say to.

    ``quantities``: of what was recorded; ``places``: those of sheets that call for one. ``axes``: what can be
    varied.

    ``words``: what quantities, axes and values are called, in English, by their names.

    ``kept``: given marks, besides scale factors, that stay as they were drawn. ``tried``: what a refinement
    tries, by the mark that it leaves.

    ``enlarged``: the scene drawn so many times larger than it was, every μ so much finer. ``poles``: the
    quantities on which the distance of its poles bears, none if a scene has no pole; ``farther``: what is
    given when poles stand so many times farther; ``moved``: the scene with its poles so, None if no scene
    says it.
    """

    stands: ClassVar[str] = "accuracy.ACCURACY"
    quantities: Callable[[Project], Iterable[Quantity]] = lambda project: ()
    places: tuple[str, ...] = ()
    axes: tuple[Axis, ...] = ()
    words: Mapping[str, str] = field(default_factory=dict)
    kept: Callable[[Project], Iterable[Mark]] = lambda project: ()
    tried: Callable[[Project], Mapping[Mark, Trial]] = lambda project: {}
    enlarged: Callable[[Scene, Drawn, float], Scene] = lambda scene, drawn, times: scene
    poles: Callable[[Scene], tuple[str, ...]] = lambda scene: ()
    farther: Callable[[Project, float], Mapping[Mark, object]] = lambda project, times: {}
    moved: Callable[[Scene, Drawn, float], Scene] | None = None
