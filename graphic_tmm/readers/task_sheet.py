"""What a chapter says on the sheet of a task: what is given, what is shown, what is asked for."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from typing import ClassVar, NamedTuple

from graphic_tmm.paper.drawing import Drawing, Stroke, Wanted
from graphic_tmm.scene.chapter import Answer
from graphic_tmm.scene.records import Scene

SIZE = "size"
"""The unit of lengths that task sheets give in mm."""


class Given(NamedTuple):
    """What a scene gives, as the sheet of a task lists it: its symbol as marks bear it, its value and unit.

    Sizes of parts are in `SIZE`: as they are kept, told in mm or in inches.
    """

    symbol: str
    value: float | str
    unit: str = ""


class Listed(NamedTuple):
    """What a scene gives point by point, as a table: its title, its heads, its rows (mark-up)."""

    name: str
    title: str
    heads: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]


class Posed(NamedTuple):
    """A mechanism in one position, for what acts on it to be shown.

    ``spot``: a letter and the number of its link -> where it stands (complex, mm) and which way it goes (of
    length 1, 0 where it stands still); KeyError if there is no such point. ``size``: of letters, mm.
    """

    spot: Callable[[str, int], tuple[complex, complex]]
    size: float


class Acting(NamedTuple):
    """What is shown to act on a mechanism: ink, and its letters, which want a place."""

    strokes: tuple[Stroke, ...]
    wanted: tuple[Wanted, ...]


class Scheme(NamedTuple):
    """A mechanism as the sheet of a task shows it, to what scale, m/mm (0: none); what is told below it."""

    view: Drawing
    mu: float
    notes: tuple[str, ...] = ()


@dataclass(frozen=True)
class TaskSheet(Answer):
    """What a chapter says on the sheet of a task.

    ``given``: what a scene gives for it; ``stated``: what it says besides in words, a sentence each in a
    language; ``listed``: what it gives point by point, as tables in a language. ``scheme``: what is shown of
    it within a width and a height (complex, mm), without its solution; ``acting``: what is shown there to act
    on it. ``wanted``: by place, how it is asked for, sentences in a language.
    """

    stands: ClassVar[str] = "task_sheet.TASK_SHEET"
    given: Callable[[Scene], Iterable[Given]] = lambda scene: ()
    stated: Callable[[Scene, str], Iterable[str]] = lambda scene, language: ()
    listed: Callable[[Scene, str], Iterable[Listed]] = lambda scene, language: ()
    scheme: Callable[[Scene, complex], Scheme | None] = lambda scene, room: None
    acting: Callable[[Scene, Posed], Iterable[Acting]] = lambda scene, posed: ()
    wanted: Mapping[str, Callable[[Scene, str], Iterable[str]]] = field(default_factory=dict)
