"""What is due of a variant that nobody has handed in, as a piece of work."""

from __future__ import annotations

from graphic_tmm.classroom.batch.work import Done, Work
from graphic_tmm.classroom.marks.judging import ROWS, Task, scene_of, sizes_of
from graphic_tmm.classroom.marks.made import dues
from graphic_tmm.classroom.marks.row import Row, text
from graphic_tmm.errors import TmmError
from graphic_tmm.studio import make


def place(variant: str) -> str:
    """Return the name of the file of a variant's row."""
    return f"{ROWS}/variants/{variant}.json"


def work(variant: str, task: Task) -> Work:
    """Return the work of drawing a variant exactly."""
    return Work(f"variants/{variant}.json", f"{__name__}:due", (variant, task))


def due(given: tuple[str, Task]) -> Done:
    """Draw a variant exactly: a row that has nothing but what is due; that too if it cannot be drawn."""
    variant, task = given
    try:
        row = Row(dues=dues(make(scene_of(task), exact=True, given=sizes_of(task))))
    except TmmError:
        row = Row()
    return Done({place(variant): text(row)})
