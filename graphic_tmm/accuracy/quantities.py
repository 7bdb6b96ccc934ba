"""The quantities whose error is measured, and the settings of a chapter that can be varied."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from typing import ClassVar, NamedTuple

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Construction, Mark, segment_name
from graphic_tmm.board.values import Length, Reals
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import Speech
from graphic_tmm.project import Project
from graphic_tmm.readers.columns import unit_of_value
from graphic_tmm.scene.chapter import MECHANISM, Answer, in_order
from graphic_tmm.scene.records import Scene


class Value(NamedTuple):
    """A mark, and what it is multiplied by to be the quantity: a scale factor's mark, or a number."""

    mark: Mark
    by: Mark | float = 1.0

    @property
    def marks(self) -> tuple[Mark, ...]:
        """The marks to be read."""
        return (self.mark, self.by) if isinstance(self.by, Mark) else (self.mark,)


@dataclass(frozen=True)
class Reference:
    """Another drawing, by an exact hand, that gives the true value of a quantity.

    ``scene``: the scene to draw instead, None if there is none; ``places``: the places of sheets recorded of
    it, None for all. ``count``: the positions of its row, 0 for as many as the quantity has. ``name``: of the
    quantity there, if it differs; ``by``: the factor that makes both the same.
    """

    scene: Callable[[Scene], Scene | None]
    count: int = 0
    places: frozenset[str] | None = None
    name: str = ""
    by: float = 1.0


class Quantity(NamedTuple):
    """A quantity as drawn, and its true value.

    ``values``: read position by position, ``row`` of them from the first; a single number if it is 0. ``due``:
    the true values, drawn on the same log by an exact hand; empty where another drawing gives them: the
    ``reference``. ``places``: places of sheets, one of which has to be ordered; none: it is always wanted.
    ``at``: the positions (indices) that alone are read, where sheets show no others.
    """

    name: str
    unit: str
    values: tuple[Value, ...]
    row: int = 0
    due: tuple[Value, ...] = ()
    reference: Reference | None = None
    places: tuple[str, ...] = ()
    at: tuple[int, ...] = ()

    def position(self, k: int) -> int:
        """Return the position (index) of the k-th value."""
        return self.at[k] if self.at else k

    @property
    def marks(self) -> tuple[Mark, ...]:
        """The marks to be read of a drawing."""
        return tuple(mark for value in self.values for mark in value.marks)

    @property
    def due_marks(self) -> tuple[Mark, ...]:
        """The marks of the true values."""
        return tuple(mark for value in self.due for mark in value.marks)

    def read(self, reading: Reading, trials: int, *, due: bool = False) -> Reals:
        """Return the quantity, (trial, value); ``due``: what it should be."""
        found = []
        for mark, by in self.due if due else self.values:
            value = reading[mark] * (reading[by] if isinstance(by, Mark) else by)
            wide = len(self.at) or self.row or 1
            if value.shape[1] > 1:
                value = value[:, list(self.at)] if self.at else value[:, :wide]
            found.append(np.broadcast_to(value, (trials, wide)))
        return np.concatenate(found, axis=1)


class Trial(NamedTuple):
    """A smaller construction that is tried at an angle until the reading changes its sign."""

    log: Construction
    angle: Mark
    reading: Mark


@dataclass(frozen=True)
class Axis:
    """A setting of a scene that can be varied, by name.

    ``scenes``: the scenes along it, each with its value as text; none if the scene does not call for it.
    ``bears``: the quantities that it affects. ``parts``: where the axis divides a drawing, the number of parts
    of the scene itself, 0 if it has none: it affects all quantities then. ``counted``: a number of parts with
    its noun. ``free``: a budget may choose it.
    """

    name: str
    scenes: Callable[[Scene], Iterable[tuple[str, Scene]]]
    bears: Callable[[Scene], tuple[str, ...]] = lambda scene: ()
    parts: Callable[[Scene], int] | None = None
    free: bool = False
    counted: str = ""


class Effect(NamedTuple):
    """Something that acts, or is taken into account, in a scene that could leave it out.

    ``name``: in English, the same where several chapters take it into account; ``without``: returns the scene
    that leaves it out; ``called``: whether the scene calls for it.
    """

    name: str
    without: Callable[[Scene], Scene]
    called: bool = True


@dataclass(frozen=True)
class Accuracy(Answer):
    """A chapter's part in the study of accuracy.

    ``quantities``: of its record (see `quantities` for boards without any); ``places``: places of sheets that
    call for one. ``compared``: names of quantities that are the same thing, each by another way. ``axes``: what
    can be varied. ``words``: names of quantities, axes and values, in English.

    ``kept``: given marks, other than scale factors, that stay as drawn. ``tried``: the trials of a refinement,
    by the mark that it leaves.

    ``effects``: what a scene could leave out; ``affected``: quantities that change with them, other than those
    studied. A word called "letter" and the name of a quantity says what its letter means. ``called``: the word
    of a name that scenes make up, "" where it is none of the chapter's.

    ``enlarged``: the scene drawn larger by a factor, every μ finer by it. ``poles``: the quantities that depend
    on its pole distances, none without a pole; ``farther``: the given marks with pole distances multiplied by a
    factor.
    """

    stands: ClassVar[str] = "accuracy.ACCURACY"
    quantities: Callable[[Project], Iterable[Quantity]] = lambda project: ()
    places: tuple[str, ...] = ()
    compared: tuple[str, ...] = ()
    axes: tuple[Axis, ...] = ()
    words: Mapping[str, str] = field(default_factory=dict)
    called: Callable[[str, Speech], str] = lambda name, speech: ""
    kept: Callable[[Project], Iterable[Mark]] = lambda project: ()
    tried: Callable[[Project], Mapping[Mark, Trial]] = lambda project: {}
    effects: Callable[[Scene], Iterable[Effect]] = lambda scene: ()
    affected: Callable[[Project], Iterable[Quantity]] = lambda project: ()
    enlarged: Callable[[Scene, Drawn, float], Scene] = lambda scene, drawn, times: scene
    poles: Callable[[Scene], tuple[str, ...]] = lambda scene: ()
    farther: Callable[[Project, float], Mapping[Mark, object]] = lambda project, times: {}


def quantities(project: Project) -> tuple[Quantity, ...]:
    """Return the quantities of a drawing, in the order in which they are constructed.

    By default those of a board of its own are lengths measured there (`measured`).
    """
    there = (chapter for chapter in in_order(project.board) if chapter.name in project.recorded)
    declared = tuple(one for chapter in there for one in Accuracy.of(chapter).quantities(project))
    return declared or (measured(project) if project.board != MECHANISM else ())


def with_affected(project: Project) -> tuple[Quantity, ...]:
    """Return the quantities of a drawing, and behind them the others that change with effects."""
    others = (one for chapter in project.chapters for one in Accuracy.of(chapter).affected(project))
    return (*quantities(project), *others)


def measured(project: Project) -> tuple[Quantity, ...]:
    """Return lengths measured on a board as quantities; their true values are the same, by an exact hand.

    A length that a step across positions leads to (a chord, a curve) is none: it depends on their number, and
    the exact hand on the same log has the error of the method, too.
    """
    log, row = project.construction, len(project.names)
    across = {step.it for step in log.steps if step.op.across}
    found: dict[str, Quantity] = {}
    for step in log.steps:
        across |= {step.it} if across & {*step.uses} else set()
        view = log.view(step.it.view)
        mu = None if view is None else view.scale
        if step.it.kind is Length and step.op.reads and mu is not None and step.it not in across:
            name, value = segment_name(step.it.letter), Value(step.it, mu)
            found.setdefault(name, Quantity(name, unit_of_value(mu), (value,), row, due=(value,)))
    return tuple(found.values())
